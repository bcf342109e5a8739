/* Patches a light by a universe: reads the channels, the mount, the size of the universe and its bytes, and writes the words
 * of the light. */
#include <stdio.h>
#include <string.h>

#include "luminaire_dmx.h"

static uint32_t get(void) {
    uint32_t word = 0;
    return fread(&word, 4, 1, stdin) == 1 ? word : 0;
}

static void read_channel(luminaire_channel *channel) {
    const uint32_t slots = get(), from = get(), to = get();
    luminaire_channel_at(channel, (uint16_t)(slots & 0xffff), (uint16_t)(slots >> 16), (int32_t)from, (int32_t)to);
}

int main(void) {
    static const int32_t position[3] = { 65536, 262144, -131072 }, down[3] = { 0, -65536, 0 };
    static const int16_t color[3] = { 16384, 12000, 3000 };
    uint32_t cases = get(), words[22], i, k;
    luminaire_cone cone;
    luminaire_spot narrow, wide;
    luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 12 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&narrow, &cone, position, down, 16 * 65536);
    luminaire_spot_tint(&narrow, color);
    luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 50 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&wide, &cone, position, down, 16 * 65536);
    for (; cases > 0; --cases) {
        luminaire_patch patch = LUMINAIRE_PATCH;
        luminaire_spot spot;
        uint8_t universe[512];
        uint32_t count;
        read_channel(&patch.pan);
        read_channel(&patch.tilt);
        read_channel(&patch.zoom);
        read_channel(&patch.dimmer);
        for (i = 0; i < 3; ++i) { read_channel(&patch.color[i]); }
        read_channel(&patch.white);
        for (i = 0; i < 3; ++i) {
            for (k = 0; k < 3; ++k) { patch.mount[i][k] = (int32_t)get(); }
        }
        count = get();
        for (i = 0; i < count; ++i) { universe[i] = (uint8_t)get(); }
        luminaire_spot_patch(&spot, &narrow, &wide, &patch, universe, count);
        memcpy(words, &spot, sizeof words);
        if (sizeof spot != sizeof words || fwrite(words, 4, 22, stdout) != 22) { return 1; }
    }
    return 0;
}
