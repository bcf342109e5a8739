/* Reads lights and places, and writes what the functions of luminaire.h return of each. */
#include "luminaire.h"

typedef struct {
    luminaire_spot spots[2];
    int32_t point[3], radius;
    int16_t normal[3], part;
    luminaire_row row;
    int8_t bytes[4];
    uint32_t count;
    uint32_t is_made; /* whether set-up made the words of the lights */
} place;

#define MOST 200
static int is_mute;
static luminaire_rgb lights[MOST];
static luminaire_vertex vertices[MOST];
static int8_t normals[3 * MOST];

void put(const void *words, uint32_t count);
void answer(const place *at);
int nothing(void);

static void put_all(const void *words, uint32_t count) {
    if (!is_mute) { put(words, count); }
}

static void put_number(uint32_t number) { put_all(&number, 1); }

static void put_spot(const luminaire_spot *spot) { put_all(spot, sizeof *spot / 4); }

/* Writes the lights of as many pixels, and starts with other ones. */
static void put_lights(uint32_t count) {
    uint32_t i;
    put_all(lights, 3 * count);
    for (i = 0; i < MOST; ++i) {
        lights[i].red = i;
        lights[i].green = 0;
        lights[i].blue = UINT32_C(0xffffff00);
    }
}

static void put_changes(const place *at) {
    luminaire_spot spot = at->spots[0];
    put_number((uint32_t)luminaire_spot_aim(&spot, at->point));
    put_spot(&spot);
    luminaire_spot_move(&spot, at->point);
    luminaire_spot_tint(&spot, at->normal);
    put_spot(&spot);
    put_number((uint32_t)luminaire_spot_aim_along(&spot, at->row.step));
    luminaire_spot_dim(&spot, at->part);
    put_spot(&spot);
    luminaire_spot_zoom(&spot, &at->spots[1], at->part);
    put_spot(&spot);
    luminaire_spot_zoom(&spot, &spot, at->part);
    put_spot(&spot);
}

static void put_many(const place *at) {
    uint32_t i, k;
    for (i = 0; i < 3 * at->count; ++i) { normals[i] = (int8_t)(at->bytes[i & 3] + (int32_t)i); }
    for (i = 0; i < at->count; ++i) {
        for (k = 0; k < 3; ++k) {
            vertices[i].point[k] = luminaire_plus(at->point[k], luminaire_shl(at->row.step[k], i & 15));
            vertices[i].normal[k] = (int16_t)(at->normal[k] >> (i & 3));
        }
    }
    put_lights(0);
    luminaire_row_add(lights, &at->row, at->spots, at->count);
    put_lights(at->count);
    luminaire_row_add_facing(lights, &at->row, at->spots, normals, at->count);
    put_lights(at->count);
    luminaire_vertices_add(lights, at->spots, 2, vertices, at->count);
    put_lights(at->count);
}

static void put_answer(const place *at) {
    luminaire_rgb light = luminaire_spot_light(at->spots, at->point, at->normal);
    const uint8_t map[6] = { (uint8_t)at->bytes[0], (uint8_t)at->bytes[1], (uint8_t)at->bytes[2] };
    int8_t signed_bytes[12];
    int16_t normal[6];
    put_number(luminaire_spot_irradiance(at->spots, at->point, at->normal));
    put_all(&light, 3);
    put_number((uint32_t)luminaire_spot_falloff(at->spots, at->point));
    put_number((uint32_t)luminaire_spot_can_reach(at->spots, at->point, at->radius));
    luminaire_normal_from_bytes(normal, at->bytes);
    luminaire_normal_from_unit_bytes(&normal[3], at->bytes);
    put_all(normal, 3);
    luminaire_normals_from_opengl(signed_bytes, map, 2);
    luminaire_normals_from_directx(&signed_bytes[6], map, 2);
    put_all(signed_bytes, 3);
    put_changes(at);
    put_many(at);
}

/* Calls the functions for lights of any words, with axes of any length. */
static void put_nothing(place at) {
    uint32_t i, k;
    for (i = 0; i < 2; ++i) {
        for (k = 0; k < 3; ++k) { at.spots[i].axis[k] = luminaire_shl(at.spots[i].axis[k], 1); }
    }
    is_mute = 1;
    put_answer(&at);
    is_mute = 0;
}

/* Writes the restored lights, and what they answer: those of set-up without being restored. */
void answer(const place *at) {
    place restored = *at;
    uint32_t i;
    for (i = 0; i < 2; ++i) {
        luminaire_spot_restore(&restored.spots[i]);
        put_spot(&restored.spots[i]);
    }
    if (!at->is_made) { put_nothing(*at); }
    put_answer(at->is_made ? at : &restored);
}

/* Calls every function with null pointers. Returns 0 if they do nothing. */
int nothing(void) {
    static luminaire_spot dark;
    const int32_t point[3] = { 0, 0, 0 };
    const int16_t normal[3] = { 0, 0, 0 };
    luminaire_rgb light = luminaire_spot_light(0, point, normal);
    luminaire_spot_restore(0);
    luminaire_spot_move(0, point);
    luminaire_spot_tint(0, normal);
    luminaire_spot_dim(0, 1);
    luminaire_spot_zoom(0, 0, 1);
    luminaire_vertices_add(lights, 0, 1, vertices, 1);
    luminaire_vertices_add(0, &dark, 1, 0, 1);
    luminaire_row_add(lights, 0, &dark, 1);
    luminaire_row_add_facing(0, 0, 0, 0, 1);
    luminaire_normals_from_opengl(0, 0, 1);
    luminaire_normals_from_directx(normals, 0, 1);
    return luminaire_spot_irradiance(0, point, normal) || light.red || light.green || light.blue
        || luminaire_spot_irradiance_facing(0, point) || luminaire_spot_irradiance_facing(&dark, 0)
        || luminaire_spot_falloff(0, point) || luminaire_spot_can_reach(0, point, 1)
        || luminaire_spot_aim(0, point) || luminaire_spot_aim_along(0, point);
}

#include <stdio.h>

void put(const void *words, uint32_t count) {
    if (fwrite(words, 4, count, stdout) != count) { fprintf(stderr, "no output\n"); }
}

int main(void) {
    static place at;
    while (fread(&at, sizeof at, 1, stdin) == 1) { answer(&at); }
    return nothing();
}
