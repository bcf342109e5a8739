/* Reads directional lights and places, and writes what the functions of luminaire.h return of each. */
#include "luminaire.h"

typedef struct {
    luminaire_directional light;
    int32_t way[3], intensity;
    int16_t normal[3], part;
} place;

void put(const void *words, uint32_t count);
void answer(const place *at);
int nothing(void);

static void put_light(const luminaire_directional *light) {
    const int32_t color[3] = { light->color[0], light->color[1], light->color[2] };
    put(light->direction, 3);
    put(&light->intensity, 2);
    put(color, 3);
}

void answer(const place *at) {
    luminaire_directional light = at->light;
    luminaire_rgb lit = luminaire_directional_light(&light, at->normal);
    uint32_t number = luminaire_directional_irradiance(&light, at->normal);
    put(&number, 1);
    put(&lit, 3);
    number = (uint32_t)luminaire_directional_aim_along(&light, at->way);
    luminaire_directional_tint(&light, at->normal);
    luminaire_directional_dim(&light, at->part);
    put(&number, 1);
    put_light(&light);
    number = (uint32_t)luminaire_directional_set_up(&light, at->way, at->intensity);
    put(&number, 1);
    put_light(&light);
    lit = luminaire_ambient(at->normal, at->intensity);
    put(&lit, 3);
}

/* Calls every function with null pointers. Returns 0 if they do nothing. */
int nothing(void) {
    const int32_t way[3] = { 0, 1, 0 };
    const int16_t normal[3] = { 0, 1, 0 };
    luminaire_directional light;
    luminaire_rgb lit = luminaire_directional_light(0, normal);
    luminaire_directional_tint(0, normal);
    luminaire_directional_dim(0, 1);
    return luminaire_directional_irradiance_facing(0) || luminaire_directional_irradiance(0, normal) || lit.red || luminaire_directional_aim_along(0, way)
        || luminaire_directional_set_up(0, way, 1) != LUMINAIRE_NULL
        || luminaire_directional_set_up(&light, 0, 1) != LUMINAIRE_NULL
        || luminaire_directional_irradiance(&light, normal) || luminaire_directional_irradiance(&light, 0)
        || luminaire_ambient(0, 4).green != 1;
}

#include <stdio.h>

void put(const void *words, uint32_t count) {
    if (fwrite(words, 4, count, stdout) != count) { fprintf(stderr, "no output\n"); }
}

int main(void) {
    uint32_t words[13];
    while (fread(words, 4, 13, stdin) == 13) {
        place at;
        int k;
        for (k = 0; k < 3; ++k) {
            at.light.direction[k] = (int32_t)words[k];
            at.light.color[k] = (int16_t)(words[5 + k / 2] >> (16 * (k & 1)));
            at.way[k] = (int32_t)words[7 + k];
            at.normal[k] = (int16_t)(words[11 + k / 2] >> (16 * (k & 1)));
        }
        at.light.intensity = luminaire_restored(luminaire_gain_of(words[3], (int32_t)words[4]));
        at.intensity = (int32_t)words[10];
        at.part = (int16_t)(words[12] >> 16);
        answer(&at);
    }
    return nothing();
}
