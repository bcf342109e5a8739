/* Reads lights and places, and writes what the functions of luminaire.h return of each. */
#include <stdio.h>

#include "luminaire.h"

typedef struct {
    luminaire_spot spot, other;
    int32_t point[3], radius;
    int16_t normal[3], part;
} place;

static void put(const void *words, size_t count) {
    if (fwrite(words, 4, count, stdout) != count) { fprintf(stderr, "no output\n"); }
}

static void put_number(uint32_t number) { put(&number, 1); }

int main(void) {
    place at;
    while (fread(&at, sizeof at, 1, stdin) == 1) {
        luminaire_rgb light = luminaire_spot_light(&at.spot, at.point, at.normal);
        put_number(luminaire_spot_irradiance(&at.spot, at.point, at.normal));
        put(&light, 3);
        put_number((uint32_t)luminaire_spot_falloff(&at.spot, at.point));
    }
    return 0;
}
