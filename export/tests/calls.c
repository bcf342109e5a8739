/* Calls the functions of luminaire.h and luminaire_display.h, and prints what they return. An emulated processor prints
 * what the host does, whose results the other tests compare with the kernel. */
#include <stdio.h>
#include <string.h>

#include "luminaire_display.h"

static uint32_t state = 1;

static int32_t random_bits(void) {
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    return (int32_t)(state >> 1) - (INT32_C(1) << 30);
}

static void somewhere(int32_t point[3]) {
    for (int i = 0; i < 3; ++i) { point[i] = random_bits() >> 12; }
}

static void put(uint32_t word, char end) { printf("%lu%c", (unsigned long)word, end); }

static void put_light(luminaire_rgb light) {
    put(light.red, ' ');
    put(light.green, ' ');
    put(light.blue, ' ');
}

int main(void) {
    static const int16_t up[3] = { 0, 1 << 14, 0 };
    static const int32_t down[3] = { 0, -1, 0 }, above[3] = { 0, INT32_C(3) << 16, 0 };
    static const int32_t nowhere[3] = { 0, 0, 0 };
    /* Full angles in degrees: one, and two that need a quadratic, a hotspot and a cubic. */
    static const uint8_t angles[5][2] = { { 24, 0 }, { 30, 0 }, { 22, 40 }, { 28, 30 }, { 12, 26 } };
    luminaire_cone cone = { 0, 0, 0, 0, 0, 0 };
    luminaire_spot spots[5], wide, moved;
    for (int i = 0; i < 5; ++i) {
        uint32_t beam = (uint32_t)angles[i][0] << 16, field = (uint32_t)angles[i][1] << 16;
        int code = field ? luminaire_cone_from_beam_and_field(&cone, beam, field)
            : i ? luminaire_cone_from_field(&cone, 1, beam) : luminaire_cone_from_beam(&cone, 0, beam);
        if (code || luminaire_spot_set_up(&spots[i], &cone, above, down, INT32_C(9) << 16)) { return 1; }
    }
    luminaire_cone_from_inner_and_outer(&cone, 0, UINT32_C(20) << 16, UINT32_C(70) << 16);
    if (luminaire_spot_set_up(&wide, &cone, above, down, INT32_C(9) << 16)) { return 1; }
    for (uint32_t degrees = 0; degrees < 200; degrees += 9) {
        int code = luminaire_cone_from_beam_and_field(&cone, degrees << 16, (3 * degrees / 2) << 16);
        printf("%s\n", luminaire_refusal(code ? code : luminaire_spot_set_up(&moved, &cone, above, down, 1)));
    }
    printf("%s\n", luminaire_refusal(luminaire_spot_set_up(&moved, &cone, above, nowhere, 1)));
    for (int i = 0; i < 1000; ++i) {
        int32_t point[3], target[3], place[3];
        int16_t color[3];
        int8_t bytes[3];
        luminaire_rgb light;
        somewhere(point);
        somewhere(target);
        somewhere(place);
        for (int k = 0; k < 3; ++k) {
            color[k] = (int16_t)(random_bits() & 0x3fff);
            bytes[k] = (int8_t)((random_bits() >> 8) % 127);
        }
        moved = spots[i % 5];
        luminaire_spot_zoom(&moved, &wide, (int16_t)(i << 4));
        luminaire_spot_move(&moved, place);
        if (!luminaire_spot_aim(&moved, target)) { return 1; }
        luminaire_spot_dim(&moved, (int16_t)((i * 7) & 0x3fff));
        luminaire_spot_tint(&moved, color);
        luminaire_normal_from_bytes(color, bytes);
        light = luminaire_spot_light(&moved, target, i % 2 ? color : up);
        light = luminaire_rgb_plus(light, luminaire_spot_light(&wide, point, up));
        put_light(luminaire_rgb_filtered(light, color));
        put(luminaire_spot_irradiance(&spots[i % 5], point, up), ' ');
        put((uint32_t)luminaire_spot_falloff(&moved, point), ' ');
        put((uint32_t)luminaire_spot_can_reach(&moved, point, INT32_C(1) << 14), ' ');
        put(luminaire_rgb565_dithered(light, (uint32_t)i, 3), ' ');
        put(luminaire_srgb(light), ' ');
        put(luminaire_pixel_dithered(LUMINAIRE_GRAY2, light, (uint32_t)i, 5), '\n');
    }
    if (luminaire_spot_aim_along(&moved, nowhere) || !luminaire_spot_aim_along(&moved, down)) { return 1; }
    {
        static luminaire_vertex vertices[64];
        static luminaire_rgb lights[64], row_lights[64];
        luminaire_row row = { { -(INT32_C(2) << 16), 0, 0 }, { INT32_C(1) << 12, 0, 0 }, { 0, 1 << 14, 0 } };
        luminaire_spot two[2];
        two[0] = spots[0];
        two[1] = moved;
        for (int i = 0; i < 64; ++i) {
            memcpy(vertices[i].point, row.first, sizeof row.first);
            vertices[i].point[0] += i * row.step[0];
            memcpy(vertices[i].normal, up, sizeof up);
        }
        luminaire_vertices_add(lights, two, 2, vertices, 64);
        luminaire_row_add(row_lights, &row, &two[0], 64);
        luminaire_row_add(row_lights, &row, &two[1], 64);
        for (int i = 0; i < 64; ++i) {
            if (memcmp(&lights[i], &row_lights[i], sizeof lights[i]) != 0) { return 1; }
            put_light(lights[i]);
            put(luminaire_rgb565(lights[i]), '\n');
        }
        /* Null pointers change nothing. */
        luminaire_vertices_add(lights, 0, 2, vertices, 64);
        luminaire_row_add(lights, &row, 0, 64);
        luminaire_row_add(lights, 0, &two[0], 64);
        luminaire_spot_zoom(0, &moved, 1);
        luminaire_spot_dim(0, 1);
        if (memcmp(lights, row_lights, sizeof lights) != 0 || luminaire_spot_irradiance(0, above, up) != 0) { return 1; }
    }
    return 0;
}
