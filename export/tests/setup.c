/* Sets lights up: reads a way to do it, two angles, and the position, axis and intensity of a light, and writes the
 * code and the words of the light. */
#include <stdio.h>
#include <string.h>

#include "luminaire.h"

int main(void) {
    uint32_t in[10], out[23];
    while (fread(in, 4, 10, stdin) == 10) {
        luminaire_cone cone; /* a good one, of which nothing may be left after a refusal */
        luminaire_spot spot;
        int32_t position[3], axis[3];
        int code, is_hard = in[0] & 1 ? 1 : 0;
        luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 36 * LUMINAIRE_DEGREE);
        memcpy(position, &in[3], sizeof position);
        memcpy(axis, &in[6], sizeof axis);
        switch (in[0] >> 1) {
        case 0: code = luminaire_cone_from_field(&cone, is_hard, in[1]); break;
        case 1: code = luminaire_cone_from_beam(&cone, is_hard, in[1]); break;
        case 2: code = luminaire_cone_from_inner_and_outer(&cone, is_hard, in[1], in[2]); break;
        default: code = luminaire_cone_from_beam_and_field(&cone, in[1], in[2]); break;
        }
        if (code == LUMINAIRE_OK) {
            code = luminaire_spot_set_up(&spot, &cone, position, axis, (int32_t)in[9]);
        } else if (luminaire_spot_set_up(&spot, &cone, position, axis, (int32_t)in[9]) == LUMINAIRE_OK) {
            return 1; /* a cone that was refused */
        }
        out[0] = (uint32_t)code;
        memcpy(&out[1], &spot, sizeof spot);
        if (sizeof spot != 88 || !luminaire_refusal(code) || fwrite(out, 4, 23, stdout) != 23) { return 1; }
    }
    return 0;
}
