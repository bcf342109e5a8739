/* Calls of luminaire.h over inputs that a search writes, each between two markers of its own: call by call, input by
 * input. Prints a checksum of the results of each call. */
#include <stdio.h>

#include "luminaire_display.h"

#if defined(__arm__)
#define BEGIN __asm volatile("mov r10, r10" ::: "memory")
#define END __asm volatile("mov r11, r11" ::: "memory")
#elif defined(__riscv)
#define BEGIN __asm volatile("slti x0, x0, 0x7b1" ::: "memory")
#define END __asm volatile("slti x0, x0, 0x7b2" ::: "memory")
#else
#define BEGIN
#define END
#endif

/* A point and a normal, or the three channels of a light. */
typedef struct { int32_t point[3]; int16_t normal[3]; } input;

static const input inputs[][COUNT] = {
#include "worst-inputs.h"
};

static luminaire_spot spot;

static uint32_t folded(luminaire_rgb light) { return light.red ^ light.green << 8 ^ light.blue << 16; }

static luminaire_rgb light_of(const input *of) {
    luminaire_rgb light;
    light.red = (uint32_t)of->point[0];
    light.green = (uint32_t)of->point[1];
    light.blue = (uint32_t)of->point[2];
    return light;
}

static int call;

/* The result is stored between the markers, so that it is computed there. */
#define WORST(name, result) do { \
    uint32_t sum = 0; \
    for (int i = 0; i < COUNT; ++i) { \
        const input *of = &inputs[call][i]; \
        volatile uint32_t found; \
        BEGIN; \
        found = (uint32_t)(result); \
        END; \
        sum = sum * 3 ^ found; \
    } \
    call++; \
    printf("%s %08lx bits\n", name, (unsigned long)sum); \
} while (0)

int main(void) {
    static const int32_t above[3] = { 0, 4 << 16, 0 }, axis[3] = { 1, -8, 2 };
    static const int16_t warm[3] = { 16384, 12000, 8000 };
    luminaire_cone cone;
    luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 36 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&spot, &cone, above, axis, INT32_C(16) << 16);
    luminaire_spot_tint(&spot, warm);
    WORST("irradiance", luminaire_spot_irradiance(&spot, of->point, of->normal));
    WORST("light", folded(luminaire_spot_light(&spot, of->point, of->normal)));
    WORST("falloff", luminaire_spot_falloff(&spot, of->point));
    WORST("can-reach", luminaire_spot_can_reach(&spot, of->point, 1 << 14));
    WORST("rgb565", luminaire_rgb565(light_of(of)));
    WORST("rgb565-dithered", luminaire_rgb565_dithered(light_of(of), (uint32_t)of->normal[0], 3));
    WORST("srgb", luminaire_srgb(light_of(of)));
    WORST("gray4-dithered", luminaire_pixel_dithered(LUMINAIRE_GRAY4, light_of(of), (uint32_t)of->normal[0], 3));
    return 0;
}
