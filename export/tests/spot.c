/* Reads lights and places, and writes what the functions of luminaire.h return of each. */
#include <stdio.h>

#include "luminaire.h"

typedef struct {
    luminaire_spot spot, other;
    int32_t point[3], radius;
    int16_t normal[3], part;
    /* A row of as many pixels, and their normals or, of the first ones, also points. */
    luminaire_row row;
    int8_t bytes[4];
    uint32_t count;
} place;

#define MOST 200
static luminaire_rgb lights[MOST];
static luminaire_vertex vertices[MOST];
static int8_t normals[3 * MOST];

static void put(const void *words, size_t count) {
    if (fwrite(words, 4, count, stdout) != count) { fprintf(stderr, "no output\n"); }
}

static void put_number(uint32_t number) { put(&number, 1); }

static void put_spot(const luminaire_spot *spot) { put(spot, sizeof *spot / 4); }

/* Writes the lights of as many pixels, and starts with other ones. */
static void put_lights(uint32_t count) {
    uint32_t i;
    put(lights, 3 * count);
    for (i = 0; i < MOST; ++i) {
        lights[i].red = i;
        lights[i].green = 0;
        lights[i].blue = UINT32_C(0xffffff00);
    }
}

static void put_change(const place *at) {
    luminaire_spot spot = at->spot;
    put_number((uint32_t)luminaire_spot_aim(&spot, at->point));
    put_spot(&spot);
    luminaire_spot_move(&spot, at->point);
    luminaire_spot_tint(&spot, at->normal);
    put_spot(&spot);
    put_number((uint32_t)luminaire_spot_aim_along(&spot, at->row.step));
    luminaire_spot_dim(&spot, at->part);
    put_spot(&spot);
    luminaire_spot_zoom(&spot, &at->other, at->part);
    put_spot(&spot);
    luminaire_spot_zoom(&spot, &spot, at->part);
    put_spot(&spot);
}

static void put_many(const place *at) {
    const luminaire_spot *spots = &at->spot; /* and the other */
    uint32_t i;
    for (i = 0; i < 3 * at->count; ++i) { normals[i] = (int8_t)(at->bytes[i & 3] + (int32_t)i); }
    for (i = 0; i < at->count; ++i) {
        int k;
        for (k = 0; k < 3; ++k) {
            vertices[i].point[k] = luminaire_plus(at->point[k], luminaire_shl(at->row.step[k], i & 15));
            vertices[i].normal[k] = (int16_t)(at->normal[k] >> (i & 3));
        }
    }
    put_lights(0);
    luminaire_row_add(&at->row, spots, lights, at->count);
    put_lights(at->count);
    luminaire_row_add_facing(&at->row, spots, normals, lights, at->count);
    put_lights(at->count);
    luminaire_vertices_add(spots, 2, vertices, lights, at->count);
    put_lights(at->count);
}

/* Calls every function with null pointers. Returns 0 if they do nothing. */
static int nothing(void) {
    const int32_t point[3] = { 0, 0, 0 };
    const int16_t normal[3] = { 0, 0, 0 };
    luminaire_rgb light = luminaire_spot_light(NULL, point, normal);
    luminaire_spot_move(NULL, point);
    luminaire_spot_tint(NULL, normal);
    luminaire_spot_dim(NULL, 1);
    luminaire_spot_zoom(NULL, NULL, 1);
    luminaire_vertices_add(NULL, 1, vertices, lights, 1);
    luminaire_vertices_add(NULL, 1, NULL, NULL, 1);
    luminaire_row_add(NULL, NULL, NULL, 1);
    luminaire_row_add_facing(NULL, NULL, NULL, lights, 1);
    return luminaire_spot_irradiance(NULL, point, normal) || light.red || light.green || light.blue
        || luminaire_spot_falloff(NULL, point) || luminaire_spot_can_reach(NULL, point, 1)
        || luminaire_spot_aim(NULL, point) || luminaire_spot_aim_along(NULL, point);
}

int main(void) {
    place at;
    while (fread(&at, sizeof at, 1, stdin) == 1) {
        luminaire_rgb light = luminaire_spot_light(&at.spot, at.point, at.normal);
        int16_t normal[6];
        put_number(luminaire_spot_irradiance(&at.spot, at.point, at.normal));
        put(&light, 3);
        put_number((uint32_t)luminaire_spot_falloff(&at.spot, at.point));
        put_number((uint32_t)luminaire_spot_can_reach(&at.spot, at.point, at.radius));
        luminaire_normal_from_bytes(normal, at.bytes);
        luminaire_normal_from_unit_bytes(&normal[3], at.bytes);
        put(normal, 3);
        put_change(&at);
        put_many(&at);
    }
    return nothing();
}
