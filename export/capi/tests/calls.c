/* Calls every function of the library, and prints what they return. The host's Rust prints the same. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "luminaire.h"

static uint32_t state = 1;

static int32_t random_bits(void) {
    state = state * 1664525u + 1013904223u;
    return (int32_t)(state >> 1) - (int32_t)(1u << 30);
}

static luminaire_point somewhere(void) {
    luminaire_point point;
    point.x = random_bits() >> 12;
    point.y = random_bits() >> 12;
    point.z = random_bits() >> 12;
    return point;
}

int main(void) {
    static const luminaire_normal up = { 0, 1 << 14, 0 };
    /* Beam angle, field angle and whether the edge is hard: one angle, and two that need a quadratic, a
     * hotspot and a cubic. */
    static const float sheets[5][3] = {
        { 24.0f, 0.0f, 1.0f }, { 24.0f, 0.0f, 0.0f }, { 22.0f, 40.0f, 0.0f }, { 28.0f, 30.0f, 1.0f }, { 12.0f, 26.0f, 0.0f }
    };
    luminaire_spot_description description;
    luminaire_spot spot, wide, changed, printed[5];
    char message[96];
    int i;
    memset(&description, 0, sizeof description);
    description.position[1] = 3.0f;
    description.axis[1] = -1.0f;
    description.field_degrees = 30.0f;
    description.intensity = 9.0f;
    description.color[0] = 1.0f;
    description.color[1] = 0.75f;
    description.color[2] = 0.5f;
    if (!luminaire_spot_set_up(&spot, &description, NULL, 0)) { return 1; }
    description.field_degrees = 70.0f;
    if (!luminaire_spot_set_up(&wide, &description, message, sizeof message)) { return 1; }
    description.field_degrees = 400.0f;
    if (luminaire_spot_set_up(&changed, &description, message, sizeof message)) { return 1; }
    printf("%s\n", message);
    if (luminaire_spot_set_up(&changed, &description, message, 12)) { return 1; }
    printf("%s\n", message);
    description.beam_degrees = 30.0f;
    description.field_degrees = 20.0f;
    if (luminaire_spot_set_up(&changed, &description, message, sizeof message)) { return 1; }
    printf("%s\n", message);
    description.beam_degrees = description.field_degrees = 0.0f;
    if (luminaire_spot_set_up(&changed, &description, message, sizeof message)) { return 1; }
    printf("%s\n", message);
    for (i = 0; i < 5; ++i) {
        description.beam_degrees = sheets[i][0];
        description.field_degrees = sheets[i][1];
        description.is_hard = sheets[i][2] > 0.0f;
        if (!luminaire_spot_set_up(&printed[i], &description, message, sizeof message)) { return 1; }
    }
    for (i = 0; i < 1000; ++i) {
        luminaire_point point = somewhere(), target = somewhere();
        luminaire_light light;
        changed = spot;
        luminaire_spot_zoom(&changed, &wide, (int16_t)(i << 4));
        luminaire_spot_move(&changed, somewhere());
        if (!luminaire_spot_aim(&changed, target)) { return 1; }
        luminaire_spot_dim(&changed, (int16_t)((i * 7) & 0x3fff));
        luminaire_spot_tint(&changed, 1 << 14, 1 << 13, (int16_t)(i * 5));
        light = luminaire_spot_light(&changed, target, up);
        light = luminaire_add(light, luminaire_spot_light(&wide, point, up));
        light = luminaire_reflect(light, 1 << 13, 1 << 14, 1 << 12);
        printf("%u %d %d %u %u %u %u %u %u\n", (unsigned)luminaire_spot_irradiance(&spot, point, up),
               luminaire_spot_falloff(&wide, point), luminaire_spot_can_reach(&spot, point, 1 << 14),
               (unsigned)light.red, (unsigned)light.green, (unsigned)light.blue, luminaire_rgb565(light),
               luminaire_rgb565_dithered(light, (uint32_t)i, 3), (unsigned)luminaire_srgb(light));
    }
    for (i = 0; i < 1000; ++i) {
        luminaire_point point = somewhere(), target = somewhere(), beside = target;
        luminaire_spot moved = printed[i % 5];
        point.x >>= 2;
        point.z >>= 2;
        beside.x += point.x >> 1;
        luminaire_spot_zoom(&moved, &wide, (int16_t)(i << 3));
        luminaire_spot_move(&moved, somewhere());
        if (!luminaire_spot_aim(&moved, target)) { return 1; }
        printf("%u %d %d %u\n", (unsigned)luminaire_spot_irradiance(&printed[i % 5], point, up),
               luminaire_spot_falloff(&printed[i % 5], point), luminaire_spot_falloff(&moved, beside),
               (unsigned)luminaire_spot_irradiance(&moved, beside, up));
    }
    if (luminaire_spot_aim_along(&changed, 0, 0, 0) || !luminaire_spot_aim_along(&changed, 1, -9, 0)) { return 1; }
    {
        luminaire_spot spots[2];
        luminaire_vertex vertices[64];
        luminaire_light lights[64], row_lights[64];
        uint16_t pixels[64];
        luminaire_row row;
        spots[0] = spot;
        spots[1] = changed;
        memset(&row, 0, sizeof row);
        row.first.x = -(2 << 16);
        row.step.x = 1 << 12;
        row.normal.y = 1 << 14;
        for (i = 0; i < 64; ++i) {
            vertices[i].point = row.first;
            vertices[i].point.x += i * row.step.x;
            vertices[i].normal = row.normal;
        }
        luminaire_vertices(spots, 2, vertices, lights, 64);
        memset(row_lights, 0, sizeof row_lights);
        luminaire_row_add(&row, &spots[0], row_lights, 64);
        luminaire_row_add(&row, &spots[1], row_lights, 64);
        memset(pixels, 0, sizeof pixels);
        luminaire_row_rgb565(row_lights, pixels, 64, 5, true);
        for (i = 0; i < 64; ++i) {
            if (memcmp(&lights[i], &row_lights[i], sizeof lights[i]) != 0) { return 1; }
            printf("%u %u\n", (unsigned)lights[i].green, pixels[i]);
        }
        luminaire_vertices(NULL, 0, NULL, NULL, 0);
        luminaire_row_add(NULL, NULL, row_lights, 64);
        luminaire_row_add(&row, NULL, row_lights, 64);
        if (memcmp(lights, row_lights, sizeof lights) != 0) { return 1; }
    }
    /* Null pointers, a light twice, and bools of any byte. */
    if (luminaire_spot_set_up(NULL, NULL, message, sizeof message) || luminaire_spot_irradiance(NULL, somewhere(), up) != 0
        || luminaire_spot_aim(NULL, somewhere())) { return 1; }
    luminaire_spot_dim(NULL, 1);
    luminaire_spot_zoom(NULL, &spot, 1);
    changed = printed[0] = wide;
    luminaire_spot_zoom(&changed, &changed, 1 << 13);
    luminaire_spot_zoom(&printed[0], &wide, 1 << 13);
    if (memcmp(&changed, &printed[0], sizeof changed) != 0) { return 1; }
    description.field_degrees = 30.0f;
    description.beam_degrees = 0.0f;
    for (i = 1; i < 256; ++i) {
        memset((char *)&description + offsetof(luminaire_spot_description, is_hard), i, 1);
        if (!luminaire_spot_set_up(&changed, &description, message, sizeof message)) { return 1; }
        if (i > 1 && memcmp(&changed, &spot, sizeof spot) != 0) { return 1; }
        spot = changed;
    }
    return 0;
}
