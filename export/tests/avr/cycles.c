/* Prints the cycles of the library's functions. */
#include <avr/io.h>
#include <stdio.h>

#include "key.h"
#include "luminaire_display.h"

#define POINTS 64

static luminaire_spot spot, other;
static int32_t points[POINTS][3];
static luminaire_rgb lights[POINTS];
static uint16_t carries[3 * POINTS];
static uint8_t bytes[3 * POINTS];
static volatile uint32_t sink;

/* Prints the cycles of code for each of COUNT values of i. A tick of the timer is SCALE cycles, 64 or 1,024. */
#define MEASURE(name, count, scale, code) do { \
    uint16_t i, ticks; \
    TCCR1A = 0; \
    TCCR1B = 0; \
    TCNT1 = 0; \
    TCCR1B = (scale) == 64 ? 3 : 5; \
    for (i = 0; i < (count); ++i) { code; } \
    ticks = TCNT1; \
    printf("%s: %lu\n", name, (unsigned long)ticks * (scale) / (count)); \
} while (0)

int program(void) {
    static const int32_t position[3] = { 0, 0, INT32_C(3) << 16 }, axis[3] = { 0, 0, -65536 };
    static const int32_t aside[3] = { INT32_C(3) << 16, 0, 0 };
    static const int16_t normal[3] = { 0, 0, 16384 };
    static const luminaire_strip strip = { 800, 12, 1, LUMINAIRE_LED_GRB, 0 };
    luminaire_cone cone;
    luminaire_row row = { { -20480, 0, 0 }, { 640, 0, 0 }, { 0, 0, 16384 } };
    int k;
    luminaire_cone_from_field(&cone, 0, UINT32_C(60) << 16);
    luminaire_spot_set_up(&other, &cone, position, axis, INT32_C(9) << 16);
    MEASURE("set up from a field angle", 8, 64, {
        luminaire_cone_from_field(&cone, 0, UINT32_C(40) << 16);
        luminaire_spot_set_up(&spot, &cone, position, axis, INT32_C(9) << 16);
    });
    MEASURE("set up from a beam and a field angle", 1, 1024, {
        luminaire_cone_from_beam_and_field(&cone, UINT32_C(18) << 16, UINT32_C(30) << 16);
        luminaire_spot_set_up(&spot, &cone, position, axis, INT32_C(9) << 16);
    });
    /* Points in the light, and one beside it. */
    for (k = 0; k < POINTS; ++k) {
        points[k][0] = row.first[0] + k * row.step[0];
        points[k][1] = (int32_t)(k & 7) << 10;
        if (!luminaire_spot_irradiance(&spot, points[k], normal)) { return 1; }
    }
    MEASURE("a point lit by a moving light", POINTS, 64, sink = luminaire_spot_irradiance(&spot, points[i], normal));
    for (k = 0; k < POINTS; ++k) { points[k][0] += INT32_C(5) << 15; }
    if (!key_irradiance(points[0], normal)) { return 1; }
    MEASURE("a point lit by a constant light", POINTS, 64, sink = key_irradiance(points[i], normal));
    MEASURE("a point outside a cone", POINTS, 64, sink = luminaire_spot_irradiance(&spot, aside, normal));
    MEASURE("a row of 64 lit pixels in colour, per pixel", POINTS, 1024, {
        if (i == 0) { luminaire_row_add(lights, &row, &spot, POINTS); }
    });
    MEASURE("an RGB565 pixel", POINTS, 64, sink = luminaire_rgb565(lights[i]));
    MEASURE("an RGB565 pixel with dither", POINTS, 64, sink = luminaire_rgb565_dithered(lights[i], i, 3));
    MEASURE("an LED of a strip with a limit", POINTS, 64, {
        if (i == 0) { luminaire_strip_write(bytes, carries, &strip, lights, POINTS); }
    });
    MEASURE("aim", 8, 64, luminaire_spot_aim(&spot, points[i]));
    MEASURE("zoom", 8, 64, luminaire_spot_zoom(&spot, &other, 1000));
    return 0;
}
