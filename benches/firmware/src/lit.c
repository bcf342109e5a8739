/* A lit point in C and floats, as one writes it for a processor without a floating point unit: the soft
 * spotlight of the price list with Lambert's cosine and the inverse square, the root by three steps of
 * Newton's method. Prints what the firmware prints, and each result. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* 256 points and normals, which the measuring program writes. */
static const float inputs[][6] = {
#include "lit-inputs.h"
};

#define COUNT (sizeof inputs / sizeof *inputs)

#ifdef __arm__
#define MARK(marker) __asm volatile(marker ::: "memory")
#else
#define MARK(marker)
#endif

static uint32_t bits(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float inverse_sqrt(float x) {
    const uint32_t seed = 0x5f375a86 - (bits(x) >> 1);
    const float half = 0.5f * x;
    float y;
    memcpy(&y, &seed, sizeof y);
    for (int step = 0; step < 3; step++) {
        y *= 1.5f - half * y * y;
    }
    return y;
}

static float lit(const float *point, const float *normal) {
    const float x = 1.5f - point[0], y = 4.0f - point[1], z = -0.75f - point[2];
    const float facing = x * normal[0] + y * normal[1] + z * normal[2];
    if (!(facing > 0.0f)) {
        return 0.0f;
    }
    const float reciprocal = inverse_sqrt(x * x + y * y + z * z);
    const float cosine = (0.8f * y - 0.36f * x - 0.48f * z) * reciprocal;
    /* The cosine of the outer half angle, and the reciprocal of its versine times the intensity's root. */
    const float t = (cosine - 0.92842135f) * (13.970648f * 4.0f);
    const float attenuated = t * reciprocal;
    return t > 0.0f ? attenuated * attenuated * (facing * reciprocal) : 0.0f;
}

int main(void) {
    uint32_t sum = 0;
    MARK("mov r10, r10");
    for (unsigned i = 0; i < COUNT; i++) {
        sum = sum * 3 ^ bits(*(const volatile float *)inputs[i]);
    }
    MARK("mov r11, r11");
    printf("empty.c %08lx bits\n", (unsigned long)sum);
    sum = 0;
    MARK("mov r10, r10");
    for (unsigned i = 0; i < COUNT; i++) {
        sum = sum * 3 ^ bits(lit(inputs[i], inputs[i] + 3));
    }
    MARK("mov r11, r11");
    printf("lit.c %08lx bits\n", (unsigned long)sum);
    for (unsigned i = 0; i < COUNT; i++) {
        printf("%u %.6f light\n", i, (double)lit(inputs[i], inputs[i] + 3));
    }
    return 0;
}
