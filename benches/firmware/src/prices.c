/* What the calls of luminaire.h cost: each over 256 inputs between two markers, after an empty loop over the same
 * inputs. Prints a name, the bits of the results and a unit for each, as the firmware does. */
#include <stdio.h>

#include "luminaire_display.h"

#define COUNT 256

#if defined(__arm__)
#define BEGIN __asm volatile("mov r10, r10" ::: "memory")
#define END __asm volatile("mov r11, r11" ::: "memory")
#elif defined(__riscv)
#define BEGIN __asm volatile("slti x0, x0, 0x7b1" ::: "memory")
#define END __asm volatile("slti x0, x0, 0x7b2" ::: "memory")
#elif defined(__XTENSA__) /* An underscore forbids the assembler to widen it. */
#define BEGIN __asm volatile("_mov.n a12, a12" ::: "memory")
#define END __asm volatile("_mov.n a13, a13" ::: "memory")
#else
#define BEGIN
#define END
#endif

#define PRICE(name, call) do { \
    uint32_t sum = 0; \
    BEGIN; \
    for (int i = 0; i < COUNT; ++i) { sum = sum * 3 ^ (uint32_t)(call); } \
    END; \
    printf("%s %08lx bits\n", name, (unsigned long)sum); \
} while (0)

static luminaire_vertex vertices[COUNT];
static luminaire_rgb lights[COUNT];
static luminaire_spot spot, wide, moved;
static luminaire_cone cone;

static uint32_t folded(luminaire_rgb light) { return light.red ^ light.green << 8 ^ light.blue << 16; }

static uint32_t set_up_from_field(int i) {
    static const int32_t down[3] = { 0, -1, 0 };
    luminaire_cone_from_field(&cone, i & 1, (UINT32_C(20) << 16) + (uint32_t)i);
    luminaire_spot_set_up(&moved, &cone, vertices[i].point, down, 1 << 16);
    return moved.fine_below;
}

static uint32_t both_angles(int i) {
    luminaire_cone_from_beam_and_field(&cone, UINT32_C(20) << 16, (uint32_t)(24 * COUNT + 16 * i) << 8);
    return cone.outer;
}

static uint32_t zoomed(int i) {
    moved = spot;
    luminaire_spot_zoom(&moved, &wide, (int16_t)(64 * i));
    return moved.ramp.width;
}

static uint32_t changed(int i) {
    luminaire_spot_move(&moved, vertices[COUNT - 1 - i].point);
    luminaire_spot_dim(&moved, (int16_t)(64 * i));
    return (uint32_t)luminaire_spot_aim(&moved, vertices[i].point) + moved.intensity.mantissa;
}

/* A row of 256 pixels, through the middle of the light or beside it. */
static uint32_t row(int32_t z) {
    luminaire_row row = { { -(2 << 16), 0, 0 }, { 1 << 10, 0, 0 }, { 0, 1 << 14, 0 } };
    row.first[2] = z;
    luminaire_row_add(lights, &row, &spot, COUNT);
    return lights[COUNT / 2].red;
}

#define POINT vertices[i].point, vertices[i].normal

int main(void) {
    static const int32_t above[3] = { 0, 4 << 16, 0 }, axis[3] = { 1, -8, 2 };
    static const int16_t warm[3] = { 16384, 12000, 8000 };
    static const int32_t far[3] = { 40 << 16, 0, 0 };
    luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 36 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&spot, &cone, above, axis, INT32_C(16) << 16);
    luminaire_spot_tint(&spot, warm);
    luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 60 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&wide, &cone, above, axis, INT32_C(16) << 16);
    moved = spot;
    for (int i = 0; i < COUNT; ++i) {
        /* Points inside the cone whose surface faces the light. */
        static const luminaire_vertex vertex = { { 32768, 0, 65536 }, { 1000, 16000, -3000 } };
        vertices[i] = vertex;
        vertices[i].point[0] += (i % 16 - 8) * 4000;
        vertices[i].point[2] += (i / 16 - 8) * 4000;
    }
    PRICE("empty", vertices[i].point[0] ^ vertices[i].normal[0]);
    PRICE("irradiance", luminaire_spot_irradiance(&spot, POINT));
    PRICE("light", folded(luminaire_spot_light(&spot, POINT)));
    PRICE("light-away", luminaire_spot_irradiance(&spot, far, vertices[i].normal));
    PRICE("falloff", luminaire_spot_falloff(&spot, vertices[i].point));
    PRICE("can-reach", luminaire_spot_can_reach(&spot, vertices[i].point, 1 << 14));
    PRICE("normal", (luminaire_normal_from_unit_bytes(vertices[i].normal, (const int8_t *)vertices[i].point), vertices[i].normal[1]));
    PRICE("changes", changed(i));
    PRICE("zoom", zoomed(i));
    PRICE("set-up", set_up_from_field(i));
    PRICE("both-angles", both_angles(i));
    /* One row in place of 256 calls. */
    PRICE("row", i ? 0 : row(1 << 16));
    PRICE("row-beside", i ? 0 : row(20 << 16));
    PRICE("rgb565", luminaire_rgb565(lights[i]));
    PRICE("rgb565-dithered", luminaire_rgb565_dithered(lights[i], (uint32_t)i, 3));
    PRICE("srgb", luminaire_srgb(lights[i]));
    PRICE("gray4-dithered", luminaire_pixel_dithered(LUMINAIRE_GRAY4, lights[i], (uint32_t)i, 3));
    return 0;
}
