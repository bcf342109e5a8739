/* luminaire.h: lights in integers, for C99 and C++11. Everything is in this file.
 *
 * A luminaire_spot is set up from the angles of a data sheet, moved, aimed, zoomed, dimmed and tinted. It lights
 * points, rows of pixels and vertices; light becomes codes of sRGB and pixels of RGB565, and by luminaire_display.h
 * those of other displays and LEDs.
 *
 * | quantity | type | step | range |
 * |---|---|---|---|
 * | coordinate of a point or a light, vector to aim along | int32_t | 2^-16 | all; a light up to 24,319 |
 * | intensity: 1 is full scale at distance 1 | int32_t | 2^-16 | from 0; below, 0 |
 * | full angle | uint32_t | 2^-16 degrees | to 180 degrees |
 * | component of a normal of length 1, linear colour, part of 1 | int16_t | 2^-14 | to 2^14 |
 * | light | uint32_t | 2^-14 of full scale | may exceed it, and saturates |
 *
 * The code has no floats, no division, no heap and no state: calls may run side by side if none changes what another
 * uses. No call fails but a set-up, and all are defined for all values. The bits are those of luminaire's Fx16 in Rust;
 * a light whose words are from elsewhere, such as a file, has them after luminaire_spot_restore.
 * A null pointer is a dark light, nothing to change, or an array without elements. What a function writes stands before
 * what it reads.
 *
 * Each file that includes this one has functions of its own. Include it in one file of a small program.
 *
 * Two evaluations have functions of the same names. The coarse one is usual, in 32-bit products: a fraction has 15
 * fraction bits and a share of the intensity 14. The fine one is for steep cones and for points near bright lights:
 * fractions and shares have 31 fraction bits.
 *
 * Licence: MIT OR Apache-2.0, at your choice.
 */
#ifndef LUMINAIRE_H
#define LUMINAIRE_H

#include <stdint.h>

/* Casts of C are the only ones that both languages have. */
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

#if (-1 >> 1) != -1
#error "luminaire needs a compiler whose right shift of a negative number keeps the sign"
#endif

/* The tables stay in flash, also where flash is no memory. */
#if defined(__AVR__)
#include <avr/pgmspace.h>
#define LUMINAIRE_TABLE PROGMEM
#define LUMINAIRE_READ_8(address) pgm_read_byte(address)
#define LUMINAIRE_READ_16(address) pgm_read_word(address)
#define LUMINAIRE_READ_32(address) pgm_read_dword(address)
#else
#define LUMINAIRE_TABLE
#define LUMINAIRE_READ_8(address) (*(address))
#define LUMINAIRE_READ_16(address) (*(address))
#define LUMINAIRE_READ_32(address) (*(address))
#endif

/* 2^31 / sqrt(n) at multiples of 2^25, lowered to the middle between chord and curve. */
static const uint16_t luminaire_inverse_square_roots[129] LUMINAIRE_TABLE = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 65533, 64532,
    63576, 62662, 61785, 60945, 60138, 59362, 58615, 57896, 57202, 56533, 55887, 55263, 54659, 54075, 53508, 52960,
    52427, 51911, 51409, 50922, 50448, 49988, 49539, 49103, 48678, 48263, 47860, 47466, 47081, 46706, 46340, 45982,
    45632, 45291, 44956, 44629, 44309, 43996, 43690, 43390, 43095, 42807, 42525, 42247, 41976, 41709, 41448, 41191,
    40939, 40692, 40449, 40210, 39976, 39745, 39519, 39296, 39077, 38862, 38650, 38442, 38237, 38035, 37837, 37641,
    37448, 37259, 37072, 36888, 36707, 36528, 36352, 36179, 36008, 35839, 35673, 35509, 35347, 35187, 35030, 34874,
    34721, 34570, 34421, 34273, 34128, 33984, 33842, 33702, 33563, 33427, 33292, 33158, 33026, 32896, 32767
};

/* Some processors have no instruction for the upper half of a product: they compute it from four
 * products of 16-bit numbers, with the same result. The Xtensa of an ESP8266 is one of them; that of an
 * ESP32 has the instruction, and another way to call functions. */
#if !defined(LUMINAIRE_BY_PARTS) && \
    (defined(__ARM_ARCH_6M__) || defined(__AVR__) || defined(__XTENSA_CALL0_ABI__))
#define LUMINAIRE_BY_PARTS 1
#endif

/* Others have no instruction that counts leading zeros: they look them up. */
#if defined(__GNUC__) && __SIZEOF_INT__ == 4 && (!defined(LUMINAIRE_BY_PARTS) || defined(__XTENSA__))
#if !defined(__riscv) || defined(__riscv_zbb)
#define LUMINAIRE_COUNTS_ZEROS 1
#endif
#endif

/* A function that is seldom called. */
#if defined(__GNUC__) && !defined(__FRAMAC__)
#define LUMINAIRE_RARE __attribute__((cold, noinline, unused)) static
#else
#define LUMINAIRE_RARE static inline
#endif

/* A step of each lit point. A compiler for speed inlines it wherever a light is evaluated. */
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && defined(__GNUC__) && !defined(__FRAMAC__)
#define LUMINAIRE_HOT __attribute__((always_inline)) static inline
#else
#define LUMINAIRE_HOT static inline
#endif

/* A stage of the coarse evaluation. A compiler for size inlines it, too: alone, it would pass vectors by memory. That of
 * an AVR does not: it would take 1,900 bytes more for a light that moves. */
#if defined(__OPTIMIZE__) && defined(__GNUC__) && !defined(__AVR__) && !defined(__FRAMAC__)
#define LUMINAIRE_STAGE __attribute__((always_inline)) static inline
#else
#define LUMINAIRE_STAGE static inline
#endif

#define LUMINAIRE_FULL_SCALE (UINT32_C(1) << 14)    /* 1 as a coarse share */
#define LUMINAIRE_COARSE_ONE (UINT32_C(1) << 15)    /* 1 as a coarse fraction */
#define LUMINAIRE_FINE_ONE (UINT32_C(1) << 31)      /* 1 as a fine fraction and share */
#define LUMINAIRE_ALWAYS_FINE UINT32_C(0xffffffff)  /* of a light whose cone is too steep for coarse */

/* The factor mantissa / 2^shift. */
typedef struct {
    uint32_t mantissa;
    int32_t shift;
} luminaire_gain;

/* The map from a versine, scaled by 4^zoom, to the falloff's argument. */
typedef struct {
    uint32_t zoom, inner, width, shift, mantissa, one, fine, fine_shift, fine_mantissa;
} luminaire_ramp;

/* The vector from a light to a point, scaled to 17 bits, and its unscaled bit length. Its components are no array, so
 * that a compiler keeps them in registers. */
typedef struct {
    int32_t x, y, z;
    uint32_t bits;
} luminaire_way;

/* The direction to a point with 30 fraction bits, before its bias, and 2^30 over its length. */
typedef struct {
    int32_t x, y, z;
    uint32_t bits, squared, reciprocal;
} luminaire_coarse_ray;

/* The vector from a light to a point, scaled to 31 bits, and its unscaled bit length. */
typedef struct {
    int32_t way[3];
    uint32_t bits;
} luminaire_offset;

/* The direction to a point with 30 fraction bits, and the correction of the estimated length. */
typedef struct {
    int32_t direction[3];
    int32_t bits, excess;
    uint32_t squared, estimate;
} luminaire_fine_ray;

/* ---- integers: sums and products wrap ---- */

static inline int32_t luminaire_plus(int32_t a, int32_t b) { return (int32_t)((uint32_t)a + (uint32_t)b); }
static inline int32_t luminaire_minus(int32_t a, int32_t b) { return (int32_t)((uint32_t)a - (uint32_t)b); }
static inline int32_t luminaire_times(int32_t a, int32_t b) { return (int32_t)((uint32_t)a * (uint32_t)b); }
static inline int32_t luminaire_shl(int32_t a, uint32_t by) { return (int32_t)((uint32_t)a << by); }
static inline uint32_t luminaire_min(uint32_t a, uint32_t b) { return a < b ? a : b; }

/* Returns the magnitude of the smaller of a number and 0. */
static inline uint32_t luminaire_below_zero(int32_t a) { return UINT32_C(0) - (uint32_t)(a & (a >> 31)); }

/* Returns the magnitude. */
static inline uint32_t luminaire_magnitude(int32_t a) { return a < 0 ? UINT32_C(0) - (uint32_t)a : (uint32_t)a; }

#if !defined(LUMINAIRE_COUNTS_ZEROS)
/* floor(log2 n) for each n of seven bits; 0 for 0. */
static const uint8_t luminaire_log2[128] LUMINAIRE_TABLE = {
    0, 0, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5,
    5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6
};
#endif

/* Returns the bit length of n from 1 to 127. */
LUMINAIRE_HOT uint32_t luminaire_bit_length_of_seven(uint32_t n) {
#if defined(LUMINAIRE_COUNTS_ZEROS)
    return (32 - (uint32_t)__builtin_clz(n | 1)) & 7;
#else
    return LUMINAIRE_READ_8(&luminaire_log2[n & 127]) + UINT32_C(1);
#endif
}

/* Returns the bit length; 1 for 0. */
LUMINAIRE_HOT uint32_t luminaire_bit_length(uint32_t n) {
#if defined(LUMINAIRE_COUNTS_ZEROS)
    return 32 - (uint32_t)__builtin_clz(n | 1);
#else
    uint32_t length = 0;
    for (; n >> 7; n >>= 7) { length += 7; }
    return length + luminaire_bit_length_of_seven(n);
#endif
}

/* Returns a * b / 2^32, rounded down. */
LUMINAIRE_HOT uint32_t luminaire_high_half(uint32_t a, uint32_t b) {
#if defined(LUMINAIRE_BY_PARTS)
    uint32_t ah = a >> 16, al = a & 0xffff, bh = b >> 16, bl = b & 0xffff;
    uint32_t upper = ah * bl;
    uint32_t middle = al * bh + (upper & 0xffff) + ((al * bl) >> 16);
    return ah * bh + (upper >> 16) + (middle >> 16);
#else
    return (uint32_t)(((uint64_t)a * b) >> 32);
#endif
}

/* Returns a * b / 2^16 for b of 16 bits, rounded down. */
LUMINAIRE_HOT uint32_t luminaire_high_product(uint32_t a, uint32_t b) {
    return (a >> 16) * b + (((a & 0xffff) * b) >> 16);
}

/* Returns a * b / 2^16 for b of 16 bits, rounded down. */
LUMINAIRE_HOT int32_t luminaire_signed_high_product(int32_t a, uint32_t b) {
    uint32_t low = (((uint32_t)a & 0xffff) * b) >> 16;
    return luminaire_plus(luminaire_times(a >> 16, (int32_t)b), (int32_t)low);
}

/* Returns a * b / 2^32 for numbers of 30 bits and a sign, rounded down. */
LUMINAIRE_HOT int32_t luminaire_signed_high_half(int32_t a, int32_t b) {
#if defined(LUMINAIRE_BY_PARTS)
    int32_t ah = a >> 16, bh = b >> 16;
    uint32_t al = (uint32_t)a & 0xffff, bl = (uint32_t)b & 0xffff;
    int32_t middle = luminaire_plus(luminaire_times(ah, (int32_t)bl), luminaire_times((int32_t)al, bh));
    middle = luminaire_plus(middle, (int32_t)((al * bl) >> 16));
    return luminaire_plus(luminaire_times(ah, bh), middle >> 16);
#else
    return (int32_t)(((int64_t)a * b) >> 32);
#endif
}

/* Returns a^2 / 2^32 for a number of 31 bits and a sign, rounded down. */
LUMINAIRE_HOT uint32_t luminaire_high_square(int32_t a) {
#if defined(LUMINAIRE_BY_PARTS)
    int32_t high = a >> 16, low = (int32_t)((uint32_t)a & 0xffff);
    uint32_t low_squared = ((uint32_t)low * (uint32_t)low) >> 17;
    int32_t middle = luminaire_plus(luminaire_times(high, low), (int32_t)low_squared);
    return (uint32_t)luminaire_plus(luminaire_times(high, high), middle >> 15);
#else
    return (uint32_t)(((int64_t)a * a) >> 32);
#endif
}

/* Returns a number of at least the magnitude's bits, for the bit length of the largest component. */
LUMINAIRE_STAGE uint32_t luminaire_size(int32_t x, int32_t y, int32_t z) {
    return (uint32_t)(x ^ (x >> 31)) | (uint32_t)(y ^ (y >> 31)) | (uint32_t)(z ^ (z >> 31));
}

/* Returns 2^31 / sqrt(n) for n >= 2^30, by linear interpolation. */
LUMINAIRE_STAGE uint32_t luminaire_guess(uint32_t n) {
    uint32_t here = LUMINAIRE_READ_16(&luminaire_inverse_square_roots[n >> 25]);
    uint32_t next = LUMINAIRE_READ_16(&luminaire_inverse_square_roots[(n >> 25) + 1]);
    return here - (((here - next) * ((n << 7) >> 16)) >> 16);
}

/* Returns 2^30 / sqrt(n) for n >= 2^28; 0 for 0. */
LUMINAIRE_STAGE uint32_t luminaire_inverse_sqrt(uint32_t n) {
    return n >> 30 ? (luminaire_guess(n) + 1) >> 1 : luminaire_guess(n << 2);
}

/* ---- gains ---- */

/* Returns the light product / 2^shift, rounded to nearest; saturates. */
LUMINAIRE_HOT uint32_t luminaire_light_of(uint32_t product, int32_t shift) {
    uint32_t but_one = (uint32_t)shift - 1, up;
    if (but_one < 32) {
        uint32_t doubled = product >> but_one;
        return (doubled >> 1) + (doubled & 1);
    }
    if (shift > 0 || product == 0) { return 0; }
    up = UINT32_C(0) - (uint32_t)shift;
    return up <= 32 - luminaire_bit_length(product) ? product << up : UINT32_C(0xffffffff);
}

static inline luminaire_gain luminaire_gain_of(uint32_t mantissa, int32_t shift) {
    luminaire_gain gain;
    gain.mantissa = mantissa;
    gain.shift = shift < -4096 ? -4096 : shift > 4096 ? 4096 : shift;
    return gain;
}

/* Returns bits / 2^shift, rounded to a mantissa of 16 bits. */
static inline luminaire_gain luminaire_normalised(uint32_t bits, int32_t shift) {
    int32_t up;
    uint32_t mantissa, rounded, carry;
    if (bits == 0) { return luminaire_gain_of(0, 0); }
    up = 32 - (int32_t)luminaire_bit_length(bits);
    mantissa = bits << up;
    rounded = (mantissa >> 16) + ((mantissa >> 15) & 1);
    carry = rounded >> 16;
    return luminaire_gain_of(rounded << (16 - carry), luminaire_plus(shift, up - (int32_t)carry));
}

static inline luminaire_gain luminaire_gain_by(luminaire_gain a, luminaire_gain b) {
    int32_t shift = luminaire_minus(luminaire_plus(a.shift, b.shift), 32);
    return luminaire_normalised((a.mantissa >> 16) * (b.mantissa >> 16), shift);
}

/* Returns 2^31 / m for m of 16 bits, with a relative error of at most 5.6e-5. */
static inline int32_t luminaire_quick_inverse(uint32_t m) {
    int32_t inverse = (int32_t)(92521 - ((UINT32_C(61681) * m) >> 16));
    int step;
    for (step = 0; step < 2; ++step) {
        int32_t lack = (int32_t)(LUMINAIRE_FINE_ONE - (uint32_t)inverse * m);
        inverse = luminaire_plus(inverse, luminaire_times(inverse, lack >> 15) >> 16);
    }
    return inverse;
}

/* ---- offsets and rays ---- */

/* Returns the way from a light to a point. */
LUMINAIRE_STAGE luminaire_way luminaire_way_between(const int32_t light[3], const int32_t point[3]) {
    int32_t x = luminaire_minus(point[0], light[0]), y = luminaire_minus(point[1], light[1]);
    int32_t z = luminaire_minus(point[2], light[2]);
    uint32_t size = luminaire_size(x, y, z), above = size >> 17, down, up, is_halved = 0;
    luminaire_way way;
    /* A call for what is rare would cost the usual path 50 instructions on Cortex-M0. */
    if (above - 1 < 127) {
        down = luminaire_bit_length_of_seven(above);
    } else if (above) {
        /* Farther than 256 units. A difference that wraps still has more than 24 bits. Halved, it fits. */
        x = (point[0] >> 1) - (light[0] >> 1);
        y = (point[1] >> 1) - (light[1] >> 1);
        z = (point[2] >> 1) - (light[2] >> 1);
        down = (luminaire_bit_length(luminaire_size(x, y, z)) - 17) & 31;
        is_halved = 1;
    } else {
        up = (17 - luminaire_bit_length(size)) & 31;
        way.x = luminaire_shl(x, up);
        way.y = luminaire_shl(y, up);
        way.z = luminaire_shl(z, up);
        way.bits = (17 - up) & 31;
        return way;
    }
    way.x = x >> down;
    way.y = y >> down;
    way.z = z >> down;
    way.bits = down + 17 + is_halved;
    return way;
}

/* Returns the inner product of a vector and the way, of which each component is scaled to 15 bits. */
LUMINAIRE_STAGE int32_t luminaire_along(const luminaire_way *way, int32_t x, int32_t y, int32_t z) {
    int32_t sum = luminaire_plus(luminaire_times(x, way->x >> 2), luminaire_times(y, way->y >> 2));
    return luminaire_plus(sum, luminaire_times(z, way->z >> 2));
}

/* Returns the product of the way and a normal: negative if the surface faces the light. */
LUMINAIRE_STAGE int32_t luminaire_facing(const luminaire_way *way, const int16_t normal[3]) {
    return luminaire_along(way, normal[0], normal[1], normal[2]);
}

/* Returns the squared length of the way. */
LUMINAIRE_STAGE uint32_t luminaire_squared(const luminaire_way *way) {
    return (uint32_t)luminaire_along(way, way->x >> 2, way->y >> 2, way->z >> 2);
}

/* Returns whether a point is so close to the light that it needs the fine evaluation. */
LUMINAIRE_STAGE int luminaire_is_near(const luminaire_way *way, uint32_t squared, uint32_t fine_below) {
    uint32_t fewer = (fine_below >> 26) - way->bits, down = 2 * fewer + 4;
    if ((int32_t)fewer < 0) { return 0; }
    return (down < 32 ? squared >> down : 0) < (fine_below & ((UINT32_C(1) << 26) - 1));
}

/* Returns whether a point is certainly outside a cone. */
LUMINAIRE_STAGE int luminaire_is_outside(
    const luminaire_way *way, uint32_t squared, const int32_t axis[3], int32_t bound
) {
    int32_t along = luminaire_along(way, axis[0] >> 16, axis[1] >> 16, axis[2] >> 16) >> 14;
    if (bound <= 0) { return 0; }
    return along < 0 || (uint32_t)along * (uint32_t)along < (squared >> 14) * (uint32_t)bound;
}

LUMINAIRE_STAGE luminaire_coarse_ray luminaire_coarse_ray_of(const luminaire_way *way, uint32_t squared) {
    luminaire_coarse_ray ray;
    int32_t fourteen_bits;
    ray.bits = way->bits;
    ray.squared = squared;
    ray.reciprocal = luminaire_inverse_sqrt(squared);
    fourteen_bits = (int32_t)((ray.reciprocal + 2) >> 2);
    ray.x = luminaire_times(way->x, fourteen_bits);
    ray.y = luminaire_times(way->y, fourteen_bits);
    ray.z = luminaire_times(way->z, fourteen_bits);
    return ray;
}

/* Returns the offset from a light to a point. */
static inline luminaire_offset luminaire_offset_between(const int32_t light[3], const int32_t point[3]) {
    luminaire_offset offset;
    uint32_t size, bits, is_halved;
    int i;
    for (i = 0; i < 3; ++i) { offset.way[i] = luminaire_minus(point[i], light[i]); }
    size = luminaire_size(offset.way[0], offset.way[1], offset.way[2]);
    is_halved = size >> 24 != 0;
    if (is_halved) {
        for (i = 0; i < 3; ++i) { offset.way[i] = (point[i] >> 1) - (light[i] >> 1); }
        size = luminaire_size(offset.way[0], offset.way[1], offset.way[2]);
    }
    bits = luminaire_bit_length(size);
    for (i = 0; i < 3; ++i) { offset.way[i] = luminaire_shl(offset.way[i], ~bits & 31); } /* by 31 - bits */
    offset.bits = bits + is_halved;
    return offset;
}

/* Returns the squared length of a vector that is scaled up by 2^shift. */
static inline uint32_t luminaire_squared_length(const int32_t vector[3], uint32_t shift) {
    return luminaire_high_square(luminaire_shl(vector[0], shift))
        + luminaire_high_square(luminaire_shl(vector[1], shift))
        + luminaire_high_square(luminaire_shl(vector[2], shift));
}

static inline luminaire_fine_ray luminaire_fine_ray_of(const luminaire_offset *offset) {
    luminaire_fine_ray ray;
    uint32_t squared = 0;
    int32_t over, coarse;
    int i;
    for (i = 0; i < 3; ++i) {
        int32_t part = offset->way[i] >> 16;
        squared += (uint32_t)luminaire_times(part, part);
    }
    ray.bits = (int32_t)offset->bits;
    ray.estimate = luminaire_inverse_sqrt(squared);
    for (i = 0; i < 3; ++i) { ray.direction[i] = luminaire_signed_high_product(offset->way[i], ray.estimate); }
    ray.squared = luminaire_squared_length(offset->way, 0);
    /* The squared length of the direction is 1 + x, and 1 / sqrt(1 + x) = 1 - x / 2 + 3/8 x^2. */
    over = (int32_t)(luminaire_squared_length(ray.direction, 0) - (UINT32_C(1) << 28));
    coarse = over >> 4;
    ray.excess = luminaire_minus(over >> 3, luminaire_times(3, luminaire_times(coarse, coarse)) >> 25);
    for (i = 0; i < 3; ++i) {
        int32_t less = luminaire_signed_high_half(ray.direction[i], luminaire_shl(ray.excess, 16)) >> 10;
        ray.direction[i] = luminaire_minus(ray.direction[i], less);
    }
    return ray;
}

/* Returns the length of the offset, which is scaled to 31 bits. */
static inline uint32_t luminaire_fine_length(const luminaire_fine_ray *ray) {
    uint32_t less = (uint32_t)(luminaire_times((int32_t)ray->estimate, ray->excess) >> 11);
    return luminaire_high_half(ray->squared, (ray->estimate << 15) - less) << 3;
}

/* Returns the fine fraction product / 2^shift, at most 1. */
static inline uint32_t luminaire_capped(uint32_t product, int32_t shift) {
    uint32_t up = (uint32_t)-shift;
    if (shift >= 0) { return luminaire_min(shift < 32 ? product >> shift : 0, LUMINAIRE_FINE_ONE); }
    if (product == 0) { return 0; }
    if (up < 32 - luminaire_bit_length(product)) { return luminaire_min(product << up, LUMINAIRE_FINE_ONE); }
    return LUMINAIRE_FINE_ONE;
}

/* Returns Lambert's cosine as a fraction. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_cosine(const luminaire_coarse_ray *ray, int32_t facing) {
    return luminaire_min(((luminaire_below_zero(facing) >> 13) * ray->reciprocal) >> 16, LUMINAIRE_COARSE_ONE);
}

static inline uint32_t luminaire_fine_cosine(const luminaire_fine_ray *ray, const int16_t normal[3]) {
    int32_t along = 0;
    int i;
    for (i = 0; i < 3; ++i) {
        int32_t d = ray->direction[i], n = normal[i];
        along = luminaire_plus(along, luminaire_times(d >> 14, n));
        along = luminaire_plus(along, ((d & 0x3fff) * n) >> 14);
    }
    return luminaire_capped(luminaire_below_zero(along), -1);
}

/* ---- the ramp of a cone ---- */

/* Returns the versine of the angle between a ray and an axis, in the scale of a ramp. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_versine(
    const luminaire_coarse_ray *ray, const int32_t axis[3], uint32_t zoom
) {
    /* The bias of the direction replaces the bits that the way lost; half a step rounds the difference. */
    uint32_t drop = ~zoom & 15; /* 15 - zoom */
    int32_t bias = 6144 + (int32_t)(UINT32_C(1) << drop);
    int32_t x = luminaire_minus(luminaire_plus(ray->x, bias), axis[0]) >> (drop + 1);
    int32_t y = luminaire_minus(luminaire_plus(ray->y, bias), axis[1]) >> (drop + 1);
    int32_t z = luminaire_minus(luminaire_plus(ray->z, bias), axis[2]) >> (drop + 1);
    /* More than 15 bits and a sign are outside. */
    if ((((uint32_t)x + 32768) | ((uint32_t)y + 32768) | ((uint32_t)z + 32768)) >> 16) { return UINT32_C(0xffffffff); }
    return (uint32_t)luminaire_times(x, x) + (uint32_t)luminaire_times(y, y) + (uint32_t)luminaire_times(z, z);
}

/* Returns the falloff's argument along a ray. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_rise(
    const luminaire_coarse_ray *ray, const int32_t axis[3], const luminaire_ramp *ramp
) {
    uint32_t versine = luminaire_coarse_versine(ray, axis, ramp->zoom), past = versine - ramp->inner;
    if (past < ramp->width) { return (ramp->one - (past >> (ramp->shift & 31)) * ramp->mantissa) >> 16; }
    return versine < ramp->inner ? LUMINAIRE_COARSE_ONE : 0;
}

/* Returns the excess over the inner versine at which the intensity becomes zero. */
static inline uint32_t luminaire_width(const luminaire_ramp *ramp) { return ramp->fine ? ramp->fine : ramp->width; }

/* Returns 1 - t of a versine's excess, with 31 fraction bits. */
static inline uint32_t luminaire_fallen(const luminaire_ramp *ramp, uint32_t past) {
    uint32_t shift = ramp->fine_shift & 63;
    if (shift < 32) { return luminaire_high_half(past << ((32 - shift) & 31), ramp->fine_mantissa); }
    return luminaire_high_half(past, ramp->fine_mantissa) >> (shift - 32);
}

static inline uint32_t luminaire_fine_rise(
    const luminaire_fine_ray *ray, const int32_t axis[3], const luminaire_ramp *ramp
) {
    uint32_t versine = UINT32_C(0xffffffff), past, fallen, zoom = luminaire_min(ramp->zoom, 15);
    int32_t difference[3];
    int i;
    for (i = 0; i < 3; ++i) { difference[i] = luminaire_minus(ray->direction[i], axis[i]); }
    if (luminaire_size(difference[0], difference[1], difference[2]) >> (31 - zoom) == 0) {
        versine = luminaire_squared_length(difference, zoom);
    }
    past = versine - ramp->inner;
    if (past >= luminaire_width(ramp)) { return versine < ramp->inner ? LUMINAIRE_FINE_ONE : 0; }
    fallen = luminaire_fallen(ramp, past);
    return fallen < LUMINAIRE_FINE_ONE ? LUMINAIRE_FINE_ONE - fallen : 0;
}

/* ---- curves ---- */

/* Each function of the falloff's argument has a coarse and a fine version. */

static inline uint32_t luminaire_coarse_complement(uint32_t x) { return LUMINAIRE_COARSE_ONE - x; }
static inline uint32_t luminaire_fine_complement(uint32_t x) { return LUMINAIRE_FINE_ONE - x; }

static inline uint32_t luminaire_fine_product(uint32_t a, uint32_t b) { return luminaire_high_half(a, b) << 1; }

LUMINAIRE_HOT uint32_t luminaire_coarse_of(uint32_t x, uint32_t share) {
    return ((x * share + (UINT32_C(1) << 14)) >> 15) & (LUMINAIRE_COARSE_ONE - 1);
}

static inline uint32_t luminaire_fine_of(uint32_t x, uint32_t share) { return luminaire_fine_product(x, share); }

/* Rounds a product with 30 fraction bits to a share, at most 1. */
LUMINAIRE_HOT uint32_t luminaire_coarse_capped(uint32_t product) {
    return luminaire_min((product + (UINT32_C(1) << 15)) >> 16, LUMINAIRE_FULL_SCALE);
}

LUMINAIRE_HOT uint32_t luminaire_coarse_quadratic(uint32_t x, int32_t g) {
    int32_t product = luminaire_times((int32_t)luminaire_coarse_complement(x), g);
    int32_t lift = luminaire_plus(product, INT32_C(1) << 13) >> 14;
    /* 1 + lift, saturated. */
    uint32_t factor = LUMINAIRE_COARSE_ONE + (uint32_t)lift;
    if (lift < 0 && luminaire_magnitude(lift) > LUMINAIRE_COARSE_ONE) { factor = 0; }
    return luminaire_coarse_capped(x * factor);
}

/* Returns x (1 + (1 - x) slope) for a slope with 28 fraction bits. */
LUMINAIRE_HOT uint32_t luminaire_fine_lifted(uint32_t x, int32_t slope) {
    uint32_t bent = luminaire_fine_product(x, LUMINAIRE_FINE_ONE - x);
    uint32_t lift = luminaire_high_half(bent, luminaire_magnitude(slope));
    uint32_t lifted;
    lift = luminaire_min(lift, (UINT32_C(1) << 28) - 1) << 4;
    lifted = x + lift;
    if (slope < 0) { return x > lift ? luminaire_min(x - lift, LUMINAIRE_FINE_ONE) : 0; }
    return lifted < x ? LUMINAIRE_FINE_ONE : luminaire_min(lifted, LUMINAIRE_FINE_ONE);
}

LUMINAIRE_HOT uint32_t luminaire_coarse_cubic(uint32_t x, int32_t g, int32_t h) {
    int32_t bend = luminaire_plus(luminaire_times((int32_t)x, h), INT32_C(1) << 14) >> 15;
    return luminaire_coarse_quadratic(x, luminaire_plus(g, bend));
}

LUMINAIRE_HOT uint32_t luminaire_fine_cubic(uint32_t x, int32_t g, int32_t h) {
    int32_t slope = luminaire_shl(h, 14);
    int32_t bend = (int32_t)(luminaire_high_half(x, luminaire_magnitude(slope)) << 1);
    if (slope < 0) { bend = luminaire_minus(0, bend); }
    return luminaire_fine_lifted(x, luminaire_plus(luminaire_shl(g, 14), bend));
}

/* Rounds a fine share to a coarse one. */
static inline uint32_t luminaire_rounded(uint32_t share) { return (share + (UINT32_C(1) << 16)) >> 17; }

/* ---- attenuation ---- */

/* Returns a share of a gain by the inverse-square law. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_inverse_square(
    const luminaire_coarse_ray *ray, uint32_t share, luminaire_gain gain
) {
    uint32_t mantissa = ((gain.mantissa >> 16) * ((ray->reciprocal * ray->reciprocal) >> 16)) >> 14;
    return luminaire_light_of(share * mantissa, luminaire_plus(gain.shift, 2 * (int32_t)ray->bits - 48));
}

static inline uint32_t luminaire_fine_inverse_square(
    const luminaire_fine_ray *ray, uint32_t share, luminaire_gain gain
) {
    uint32_t nearly = luminaire_high_product(luminaire_high_product(gain.mantissa, ray->estimate), ray->estimate);
    int32_t square = luminaire_times(ray->excess, ray->excess);
    int32_t excess = luminaire_minus(luminaire_times(2, ray->excess), square >> 26);
    uint32_t here = nearly - (uint32_t)(luminaire_times((int32_t)(nearly >> 17), excess) >> 9);
    return luminaire_light_of(luminaire_high_half(share, here), luminaire_plus(gain.shift, 2 * ray->bits - 49));
}

/* Returns whether light is past full scale by more than the error of its share. */
static inline int luminaire_is_clipped(uint32_t share, uint32_t light) {
    return share > (UINT32_C(1) << 9) && light > (UINT32_C(9) << 11);
}

/* ---- light: linear red, green and blue in steps of 2^-14 of full scale, which they may exceed ---- */

typedef struct {
    uint32_t red, green, blue;
} luminaire_rgb;

/* Returns the sum of two channels; saturates. */
static inline uint32_t luminaire_light_plus(uint32_t a, uint32_t b) { return a + luminaire_min(b, ~a); }

/* Returns a channel times a colour in steps of 2^-14, to nearest; saturates; 0 if negative. */
LUMINAIRE_HOT uint32_t luminaire_light_filtered(uint32_t light, int16_t color) {
    uint32_t factor = color < 0 ? 0 : (uint32_t)color;
    uint32_t high = (light >> 16) * factor, low = ((light & 0xffff) * factor + (UINT32_C(1) << 13)) >> 14;
    return luminaire_light_plus(high >> 30 == 0 ? high << 2 : UINT32_C(0xffffffff), low);
}

/* Returns the sum of two lights; saturates. */
static inline luminaire_rgb luminaire_rgb_plus(luminaire_rgb a, luminaire_rgb b) {
    a.red = luminaire_light_plus(a.red, b.red);
    a.green = luminaire_light_plus(a.green, b.green);
    a.blue = luminaire_light_plus(a.blue, b.blue);
    return a;
}

/* Returns the light that a surface of a linear colour, in steps of 2^-14, reflects. */
static inline luminaire_rgb luminaire_rgb_filtered(luminaire_rgb light, const int16_t color[3]) {
    if (!color) { return light; }
    light.red = luminaire_light_filtered(light.red, color[0]);
    light.green = luminaire_light_filtered(light.green, color[1]);
    light.blue = luminaire_light_filtered(light.blue, color[2]);
    return light;
}

/* Adds an irradiance times a colour, in steps of 2^-14, to a sum; saturates. */
static inline void luminaire_add(luminaire_rgb *sum, uint32_t irradiance, const int16_t color[3]) {
    if (!irradiance) { return; }
    sum->red = luminaire_light_plus(sum->red, luminaire_light_filtered(irradiance, color[0]));
    sum->green = luminaire_light_plus(sum->green, luminaire_light_filtered(irradiance, color[1]));
    sum->blue = luminaire_light_plus(sum->blue, luminaire_light_filtered(irradiance, color[2]));
}

/* ---- spotlights that move: any words are defined, and a null light is dark ---- */

/* A spotlight with the inverse square of the distance. With all words zero it is dark. Its edge is a falloff of t, which
 * is 1 up to the inner angle and falls in proportion to the cosine to 0 at the outer one, and u = 1 - t. */
typedef struct {
    int32_t position[3];      /* steps of 2^-16 */
    int32_t axis[3];          /* of unit length, steps of 2^-30 */
    luminaire_ramp ramp;      /* the cone */
    int32_t g, h;             /* t (1 + u (g + h t)), steps of 2^-14: soft -2^14, 0; hard 2^14, 0 */
    luminaire_gain intensity; /* 1 is full scale on the axis at distance 1 */
    uint32_t fine_below;      /* the points that need the fine evaluation: within an encoded distance */
    int16_t color[3];         /* linear, from 0 to 2^14 */
    int16_t outside;          /* the squared cosine of half the outer angle, less a margin, steps of 2^-14 */
} luminaire_spot;

/* Returns a gain of any words as one with a mantissa of 32 bits and a shift within reach. */
LUMINAIRE_RARE luminaire_gain luminaire_restored(luminaire_gain gain) {
    uint32_t up = gain.mantissa ? 32 - luminaire_bit_length(gain.mantissa) : 0;
    gain = luminaire_gain_of(gain.mantissa << up, gain.shift);
    gain.shift += (int32_t)up;
    return gain;
}

/* Replaces words that no set-up makes, such as those of a damaged file, as Rust does. A light that was set up keeps its
 * words. Without this call any words are defined, too, but may give another light than in Rust. */
LUMINAIRE_RARE void luminaire_spot_restore(luminaire_spot *spot) {
    if (!spot) { return; }
    luminaire_ramp *ramp = &spot->ramp;
    uint32_t steps;
    if (ramp->fine) { ramp->width = 0; }
    ramp->zoom = luminaire_min(ramp->zoom, 15);
    ramp->shift &= 31;
    ramp->fine_shift &= 63;
    ramp->one = luminaire_min(ramp->one, LUMINAIRE_FINE_ONE + 65535);
    /* No versine gives a negative t. */
    steps = ramp->width ? (ramp->width - 1) >> ramp->shift : 0;
    if (luminaire_high_half(steps, ramp->mantissa) || steps * ramp->mantissa > ramp->one) { ramp->mantissa = 0; }
    spot->intensity = luminaire_restored(spot->intensity);
}

/* Returns the falloff along a ray. */
LUMINAIRE_STAGE uint32_t luminaire_spot_coarse_share(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    uint32_t t = luminaire_coarse_rise(ray, spot->axis, &spot->ramp);
    /* The soft edge is a square. */
    if (spot->g == -16384 && spot->h == 0) { return (t * t + (UINT32_C(1) << 15)) >> 16; }
    return luminaire_coarse_cubic(t, spot->g, spot->h);
}

static inline uint32_t luminaire_spot_fine_share(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    return luminaire_fine_cubic(luminaire_fine_rise(ray, spot->axis, &spot->ramp), spot->g, spot->h);
}

/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_spot_fine_irradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_offset offset = luminaire_offset_between(spot->position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    uint32_t share = luminaire_fine_of(luminaire_fine_cosine(&ray, normal), luminaire_spot_fine_share(spot, &ray));
    return luminaire_fine_inverse_square(&ray, share, spot->intensity);
}

/* Returns the irradiance at a point with a unit normal, before the colour. */
LUMINAIRE_HOT uint32_t luminaire_spot_irradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    if (!spot || !point || !normal) { return 0; }
    luminaire_way way = luminaire_way_between(spot->position, point);
    int32_t facing = luminaire_facing(&way, normal);
    if (facing >= 0) {
        /* The fine evaluation has more bits of the product with the normal. */
        if (facing >= 7 << 12 || !luminaire_is_near(&way, luminaire_squared(&way), spot->fine_below)) { return 0; }
    }
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_outside(&way, squared, spot->axis, spot->outside)) { return 0; }
    luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
    uint32_t cosine = luminaire_coarse_cosine(&ray, facing);
    uint32_t share = luminaire_coarse_of(cosine, luminaire_spot_coarse_share(spot, &ray));
    uint32_t light = luminaire_coarse_inverse_square(&ray, share, spot->intensity);
    if (!luminaire_is_near(&way, squared, spot->fine_below)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (spot->fine_below != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(share, light)) { return light; }
    return luminaire_spot_fine_irradiance(spot, point, normal);
}

/* Returns the irradiance of a surface that faces the light at a point, before the colour: what a small body without a
 * normal receives, such as an LED. */
static inline uint32_t luminaire_spot_irradiance_facing(const luminaire_spot *spot, const int32_t point[3]) {
    if (!spot || !point) { return 0; }
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_outside(&way, squared, spot->axis, spot->outside)) { return 0; }
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray fine = luminaire_fine_ray_of(&offset);
        return luminaire_fine_inverse_square(&fine, luminaire_spot_fine_share(spot, &fine), spot->intensity);
    }
    luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
    return luminaire_coarse_inverse_square(&ray, luminaire_spot_coarse_share(spot, &ray), spot->intensity);
}

/* Returns the light at a point with a unit normal: the irradiance times the colour. */
static inline luminaire_rgb luminaire_spot_light(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_rgb light = { 0, 0, 0 };
    uint32_t irradiance = luminaire_spot_irradiance(spot, point, normal);
    if (irradiance) {
        light.red = luminaire_light_filtered(irradiance, spot->color[0]);
        light.green = luminaire_light_filtered(irradiance, spot->color[1]);
        light.blue = luminaire_light_filtered(irradiance, spot->color[2]);
    }
    return light;
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t luminaire_spot_falloff(const luminaire_spot *spot, const int32_t point[3]) {
    if (!spot || !point) { return 0; }
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray fine = luminaire_fine_ray_of(&offset);
        return (int16_t)luminaire_rounded(luminaire_spot_fine_share(spot, &fine));
    }
    luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
    return (int16_t)luminaire_spot_coarse_share(spot, &ray);
}

/* ---- changes of a light ---- */

/* A quarter of a sine, in steps of 2^-14. */
static const uint16_t luminaire_quarter[18] LUMINAIRE_TABLE = {
    0, 1606, 3196, 4756, 6270, 7723, 9102, 10394, 11585, 12665, 13623, 14449, 15137, 15679, 16069, 16305, 16384, 16384
};

/* Returns the sine of a turn, of which 65536 is a whole one, within 21 steps of 2^-14: lines between 16 places of a
 * quarter. */
static inline int16_t luminaire_sine(uint32_t turn) {
    uint32_t part = turn & 16383, at = turn & 16384 ? 16384 - part : part;
    uint32_t before = LUMINAIRE_READ_16(&luminaire_quarter[at >> 10]);
    uint32_t after = LUMINAIRE_READ_16(&luminaire_quarter[(at >> 10) + 1]);
    int32_t value = (int32_t)(before + (((after - before) * (at & 1023)) >> 10));
    return (int16_t)(turn & 32768 ? -value : value);
}
static const int32_t luminaire_origin[3] = { 0, 0, 0 };

/* Sets the unit vector from a point to another one. Returns 0, and sets nothing, if they are the same. */
LUMINAIRE_RARE int luminaire_unit(int32_t unit[3], const int32_t from[3], const int32_t to[3]) {
    luminaire_offset offset = luminaire_offset_between(from, to);
    if (!(offset.way[0] | offset.way[1] | offset.way[2])) { return 0; }
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    for (int i = 0; i < 3; ++i) { unit[i] = ray.direction[i]; }
    return 1;
}

/* Moves the light; its axis stays. */
static inline void luminaire_spot_move(luminaire_spot *spot, const int32_t position[3]) {
    for (int i = 0; spot && position && i < 3; ++i) { spot->position[i] = position[i]; }
}

/* Aims the light at a point. Returns 0, and changes nothing, if the point is the light's position. */
static inline int luminaire_spot_aim(luminaire_spot *spot, const int32_t point[3]) {
    return spot && point && luminaire_unit(spot->axis, spot->position, point);
}

/* Aims the light along a vector of any length. Returns 0, and changes nothing, if it is zero. */
static inline int luminaire_spot_aim_along(luminaire_spot *spot, const int32_t way[3]) {
    return spot && way && luminaire_unit(spot->axis, luminaire_origin, way);
}

/* Gives the light a linear colour, in steps of 2^-14 from 0 to 2^14. */
static inline void luminaire_spot_tint(luminaire_spot *spot, const int16_t color[3]) {
    for (int i = 0; spot && color && i < 3; ++i) { spot->color[i] = color[i]; }
}

static inline void luminaire_gain_dim(luminaire_gain *intensity, int16_t part) {
    if (part >= 1 << 14) { return; }
    *intensity = luminaire_gain_by(*intensity, luminaire_normalised(part > 0 ? (uint32_t)part : 0, 14));
}

/* Multiplies the intensity by a part of 1, from 0 to 2^14. A light that fades keeps a copy of its full intensity. */
static inline void luminaire_spot_dim(luminaire_spot *spot, int16_t part) {
    if (spot) { luminaire_gain_dim(&spot->intensity, part); }
}

/* Sets the unit normal along a vector of signed bytes; zero along zero. */
static inline void luminaire_normal_from_bytes(int16_t normal[3], const int8_t bytes[3]) {
    int32_t way[3];
    if (!normal || !bytes) { return; }
    for (int i = 0; i < 3; ++i) { way[i] = luminaire_shl(bytes[i], 23); }
    luminaire_unit(way, luminaire_origin, way);
    for (int i = 0; i < 3; ++i) { normal[i] = (int16_t)(luminaire_plus(way[i], INT32_C(1) << 15) >> 16); }
}

/* Returns whether the light may reach points within a radius of a point, in steps of 2^-16. */
LUMINAIRE_RARE int luminaire_spot_can_reach(const luminaire_spot *spot, const int32_t center[3], int32_t radius) {
    if (!spot || !center) { return 0; }
    if (spot->outside <= 0 || spot->outside >= 16384 - 18) { return 1; }
    uint32_t sine = (uint32_t)(16384 - 18 - spot->outside); /* squared, of the half angle */
    /* The light reaches a sphere if its centre is in the cone moved back by the radius over the sine. */
    uint32_t shift = (15 - luminaire_bit_length(sine)) & 14, up = 1 + shift / 2;
    uint32_t size = radius > 0 ? (uint32_t)radius + 8 : 8;
    uint32_t product = luminaire_high_product(size, luminaire_inverse_sqrt(sine << (16 + shift))) + (size >> 13) + 1;
    if (product >> (29 - up)) { return 1; }
    int32_t tip[3], ends = 0, is_beyond = 0;
    for (int i = 0; i < 3; ++i) {
        int32_t from = spot->position[i];
        int32_t back = luminaire_shl(luminaire_signed_high_half(spot->axis[i], (int32_t)(product << up)), 2);
        tip[i] = luminaire_minus(from, back);
        ends |= from ^ luminaire_shl(from, 1);
        is_beyond |= ((from ^ back) & (from ^ tip[i])) < 0 || luminaire_magnitude(tip[i]) > UINT32_C(32639) << 16;
    }
    /* A light with a coordinate of 31 bits may get a tip of which offsets wrap. */
    if (ends < 0 && is_beyond) { return 1; }
    luminaire_way way = luminaire_way_between(tip, center);
    return !luminaire_is_outside(&way, luminaire_squared(&way), spot->axis, spot->outside);
}

/* ---- zoom: the cones between two cones, by the chords sqrt(v) of their versines v ---- */

#define LUMINAIRE_LARGEST_CHORD UINT32_C(3037000499) /* sqrt(2) with 31 fraction bits, of a versine of 2 */

/* Differences and sums that saturate, the latter but below 0. */
static inline uint32_t luminaire_less(uint32_t a, uint32_t b) { return a > b ? a - b : 0; }
static inline uint32_t luminaire_max(uint32_t a, uint32_t b) { return a > b ? a : b; }
static inline uint32_t luminaire_added(uint32_t a, int32_t b) {
    return b < 0 ? a + (uint32_t)b : luminaire_light_plus(a, (uint32_t)b);
}
static inline uint32_t luminaire_half(uint32_t a) { return (a >> 1) + (a & 1); } /* to the nearest */

/* Returns 2^16 sqrt(n), by a step of Newton's method. */
LUMINAIRE_RARE uint32_t luminaire_sqrt(uint32_t n) {
    uint32_t shift = (32 - luminaire_bit_length(n)) & 30, m = n << shift, seed = luminaire_guess(m);
    uint32_t root = luminaire_min(luminaire_high_product(m, seed), LUMINAIRE_FINE_ONE - 1) << 1;
    int32_t lack = (int32_t)(m - luminaire_high_half(root, root));
    return luminaire_added(root, luminaire_signed_high_product(lack, seed)) >> (shift / 2);
}

/* Returns 2^63 / m for m >= 2^31, rounded down; at most 2^32 - 1. */
LUMINAIRE_RARE uint32_t luminaire_inverse_of_32(uint32_t m) {
    uint32_t seed = (uint32_t)luminaire_quick_inverse(m >> 16);
    int32_t lack = (int32_t)(LUMINAIRE_FINE_ONE - luminaire_high_product(m, seed)), eighth = lack >> 3;
    lack = luminaire_shl(luminaire_plus(lack, luminaire_times(eighth, eighth) >> 25), 1);
    /* A step of Halley's method gives at most 3 too much, and with 3 less at most 6 too little. */
    uint32_t inverse = luminaire_less(luminaire_added(seed << 16, luminaire_signed_high_product(lack, seed)), 3);
    uint64_t rest = (UINT64_C(1) << 63) - ((uint64_t)luminaire_high_half(inverse, m) << 32 | inverse * m);
    for (int step = 0; step < 6 && rest >= m; ++step) {
        rest -= m;
        inverse = luminaire_light_plus(inverse, 1);
    }
    return inverse;
}

/* Returns the chord, with 31 fraction bits, of a versine with 29 + 2 zoom. */
static inline uint32_t luminaire_chord(uint32_t versine, uint32_t zoom) {
    uint32_t root = luminaire_sqrt(2 * luminaire_min(versine, UINT32_C(1) << 30));
    return luminaire_min(root, LUMINAIRE_LARGEST_CHORD) >> zoom;
}

/* Returns the versine of a chord, with 29 + 2 zoom fraction bits. */
static inline uint32_t luminaire_versine_of(uint32_t chord, uint32_t zoom) {
    return luminaire_half(luminaire_high_half(chord << zoom, chord << zoom));
}

/* Returns the largest zoom up to 15 or less with which the versine of a chord is at most 2. */
static inline uint32_t luminaire_chord_zoom(uint32_t chord, uint32_t most) {
    uint32_t zoom = luminaire_min(32 - luminaire_bit_length(chord), most);
    return chord << (zoom & 15) > LUMINAIRE_LARGEST_CHORD ? luminaire_less(zoom, 1) : zoom;
}

/* Sets the chords up to which a cone has full intensity, at which its edge ends, and from which on it is dark. */
LUMINAIRE_RARE void luminaire_set_chords(uint32_t chords[3], const luminaire_ramp *ramp) {
    uint32_t zoom = luminaire_min(ramp->zoom, 15), width = luminaire_width(ramp), shift = ramp->fine_shift & 63;
    uint32_t limit = luminaire_chord(luminaire_light_plus(ramp->inner, width), zoom);
    chords[0] = luminaire_min(luminaire_chord(ramp->inner, zoom), limit);
    chords[1] = chords[2] = limit;
    /* Without a cutoff, t is zero at the limit, but for roundings. */
    if (!width || luminaire_fallen(ramp, width) >= LUMINAIRE_FINE_ONE - 4) { return; }
    /* A ramp has the outer versine as a reciprocal. Here it gets 62 fraction bits. */
    uint64_t outer = luminaire_inverse_of_32(ramp->fine_mantissa | LUMINAIRE_FINE_ONE);
    outer = (shift > 32 ? outer << ((shift - 32) & 31) : outer >> ((32 - shift) & 63)) + ramp->inner;
    if (outer >> (30 + 2 * zoom)) { outer = UINT64_C(1) << (30 + 2 * zoom); }
    outer <<= 33 - 2 * zoom;
    uint32_t high = (uint32_t)(outer >> 32), even = high ? (luminaire_bit_length(high) + 1) & 62 : 0;
    uint32_t root = luminaire_sqrt((uint32_t)(outer >> even)) >> ((16 - even / 2) & 31);
    chords[1] = luminaire_max(luminaire_min(root, LUMINAIRE_LARGEST_CHORD), limit);
}

/* Sets the ramp of a cone with these chords. */
static inline void luminaire_set_ramp(luminaire_ramp *ramp, const uint32_t chords[3], int is_fine) {
    uint32_t zoom = luminaire_chord_zoom(chords[2], 15), wide = luminaire_chord_zoom(chords[1], zoom);
    uint32_t inner = luminaire_versine_of(chords[0], zoom), end = luminaire_versine_of(chords[2], zoom);
    /* A cutoff may be so narrow that the outer versine is out of range in the scale of the ramp. */
    uint32_t span = luminaire_less(luminaire_versine_of(chords[1], wide), luminaire_versine_of(chords[0], wide));
    uint32_t bits = luminaire_bit_length(span), width = luminaire_less(end, inner);
    ramp->fine_mantissa = luminaire_inverse_of_32(luminaire_max(span, 1) << ((32 - bits) & 31));
    ramp->fine_shift = bits + 2 * (zoom - wide);
    ramp->shift = luminaire_min(luminaire_less(ramp->fine_shift, 16), 31);
    ramp->mantissa = luminaire_half(ramp->fine_mantissa >> ((ramp->fine_shift - ramp->shift - 1) & 31));
    ramp->one = LUMINAIRE_FINE_ONE + LUMINAIRE_COARSE_ONE - (ramp->mantissa - (ramp->mantissa >> ramp->shift)) / 2;
    /* The last versine before the limit must not give a negative t. */
    ramp->one = luminaire_max(ramp->one, (luminaire_less(width, 1) >> ramp->shift) * ramp->mantissa);
    ramp->zoom = zoom;
    ramp->inner = luminaire_min(inner, end);
    ramp->width = is_fine ? 0 : width;
    ramp->fine = is_fine ? width : 0;
}

/* Gives the light the cone with these chords. */
static inline void luminaire_spot_set_cone(luminaire_spot *spot, const uint32_t chords[3], int is_fine) {
    uint32_t cosine = luminaire_less(UINT32_C(1) << 30, luminaire_high_half(chords[2], chords[2])) << 1;
    luminaire_set_ramp(&spot->ramp, chords, is_fine);
    spot->outside = (int16_t)((int32_t)(luminaire_high_half(cosine, cosine) >> 16) - 17);
}

/* Gives the light a cone between its own, part 0, and that of another light or the same, part 2^14. The edge stays. A
 * light that zooms keeps a copy of its own cone: the next call begins with the cone of this one. */
LUMINAIRE_RARE void luminaire_spot_zoom(luminaire_spot *spot, const luminaire_spot *other, int16_t part) {
    if (!spot || !other || part <= 0) { return; }
    spot->fine_below = luminaire_max(spot->fine_below, other->fine_below);
    if (part >= 1 << 14) {
        spot->ramp = other->ramp;
        spot->outside = other->outside;
        return;
    }
    uint32_t from[3], to[3], share = (uint32_t)part << 18;
    luminaire_set_chords(from, &spot->ramp);
    luminaire_set_chords(to, &other->ramp);
    for (int i = 0; i < 3; ++i) {
        uint32_t way = luminaire_high_half(to[i] < from[i] ? from[i] - to[i] : to[i] - from[i], share);
        from[i] = to[i] < from[i] ? from[i] - way : from[i] + way;
    }
    from[0] = luminaire_min(from[0], from[2]);
    from[1] = luminaire_max(from[1], from[2]);
    luminaire_spot_set_cone(spot, from, spot->ramp.fine || other->ramp.fine);
}

/* ---- many points: light is added to an array. A null array is empty ---- */

/* A vertex of a mesh: a point, and a normal of unit length. */
typedef struct {
    int32_t point[3];
    int16_t normal[3];
} luminaire_vertex;

/* A row of pixels on a straight line of a flat surface. */
typedef struct {
    int32_t first[3];  /* the point of the first pixel */
    int32_t step[3];   /* what the point changes by from pixel to pixel */
    int16_t normal[3]; /* the surface's, of unit length */
} luminaire_row;

/* Adds the light of a spotlight at a vertex; saturates. */
static inline void luminaire_spot_add(luminaire_rgb *sum, const luminaire_spot *spot, const luminaire_vertex *at) {
    if (!at || !sum) { return; }
    luminaire_rgb light = luminaire_spot_light(spot, at->point, at->normal);
    sum->red = luminaire_light_plus(sum->red, light.red);
    sum->green = luminaire_light_plus(sum->green, light.green);
    sum->blue = luminaire_light_plus(sum->blue, light.blue);
}

/* Adds the light of all spotlights at each vertex. */
static inline void luminaire_vertices_add(
    luminaire_rgb *lights, const luminaire_spot *spots, uint32_t spot_count,
    const luminaire_vertex *vertices, uint32_t count
) {
    for (uint32_t i = 0; spots && vertices && lights && i < count; ++i) {
        for (uint32_t k = 0; k < spot_count; ++k) { luminaire_spot_add(&lights[i], &spots[k], &vertices[i]); }
    }
}

/* Sets the normal along a vector of signed bytes of a length of about 127. */
static inline void luminaire_normal_from_unit_bytes(int16_t normal[3], const int8_t bytes[3]) {
    if (!normal || !bytes) { return; }
    int32_t x = bytes[0], y = bytes[1], z = bytes[2];
    /* A step of Newton's iteration: (3 - |n|^2) / 2 for n in units of 127, in steps of 2^-15. */
    uint32_t lack = luminaire_less(48387, (uint32_t)(x * x + y * y + z * z));
    int32_t factor = (int32_t)((lack * UINT32_C(33548)) >> 15);
    for (int i = 0; i < 3; ++i) { normal[i] = (int16_t)((bytes[i] * factor + 128) >> 8); }
}

/* Sets the signed bytes of a normal map in DirectX's convention, Y-: bright green where the surface faces down. */
static inline void luminaire_normals_from_directx(int8_t *normals, const uint8_t *map, uint32_t count) {
    for (uint32_t i = 0; normals && map && i < count; ++i) {
        const uint8_t *from = &map[3 * i];
        int32_t zero = from[0] | from[1] | from[2] ? 128 : 0;
        for (uint32_t k = 0; k < 3; ++k) { normals[3 * i + k] = (int8_t)(from[k] - zero); }
    }
}

/* Sets the signed bytes of a normal map in OpenGL's convention, Y+: bright green where the surface faces up. A map has
 * red, green and blue of each pixel, as an image. A normal is to the right, down, as rows of a screen, and to the viewer,
 * in units of 1/127: each a byte minus 128, and green negated. Black gives a zero normal, which gets no light. The
 * normals may replace the map. Where y points up, use the function for DirectX instead, and the other way round. */
static inline void luminaire_normals_from_opengl(int8_t *normals, const uint8_t *map, uint32_t count) {
    luminaire_normals_from_directx(normals, map, count);
    for (uint32_t i = 0; normals && map && i < count; ++i) {
        int8_t *green = &normals[3 * i + 1];
        *green = (int8_t)(*green > -128 ? -*green : 127);
    }
}

static inline void luminaire_row_point(int32_t point[3], const luminaire_row *row, uint32_t i) {
    for (int k = 0; k < 3; ++k) {
        point[k] = luminaire_plus(row->first[k], luminaire_times(row->step[k], (int32_t)i));
    }
}

/* Returns whether a light may reach points of a row, by a sphere around them. */
LUMINAIRE_RARE int luminaire_row_reached(const luminaire_row *row, const luminaire_spot *spot, uint32_t a, uint32_t b) {
    int32_t center[3], end[3];
    uint32_t sum = 0, largest = 0;
    luminaire_row_point(center, row, a);
    luminaire_row_point(end, row, b);
    for (int i = 0; i < 3; ++i) {
        int32_t from = center[i] >> 1, to = end[i] >> 1;
        uint32_t half = luminaire_magnitude(luminaire_minus(from, to)) >> 1;
        center[i] = luminaire_plus(from, to);
        sum += half;
        largest = luminaire_max(largest, half);
    }
    /* A vector is no longer than half the sum of its largest component and of all three. */
    return luminaire_spot_can_reach(spot, center, (int32_t)(luminaire_min(sum + largest, UINT32_C(0x7ffffff8)) + 7));
}

/* Returns how many of some points from one on, or backwards, a light does not reach: blocks of 16 to 64. */
LUMINAIRE_RARE uint32_t luminaire_row_skipped(
    const luminaire_row *row, const luminaire_spot *spot, uint32_t from, uint32_t count, int is_backwards
) {
    uint32_t start = 0, size = 64;
    while (start < count) {
        uint32_t last = luminaire_min(count - 1 - start, size - 1) + start;
        uint32_t a = is_backwards ? from - start : from + start, b = is_backwards ? from - last : from + last;
        if (!luminaire_row_reached(row, spot, a, b)) {
            start = last + 1;
            if (size < 64 && !(start & (2 * size - 1))) { size *= 2; }
        } else {
            if (size == 16) { break; }
            size /= 2;
        }
    }
    return start;
}

/* Adds the light of a spotlight to each pixel of a row, with its normal along three signed bytes of a length of
 * about 127: a sprite with a normal map, of which luminaire_normals_from_opengl makes them. Without bytes it is the
 * row's normal. */
static inline void luminaire_row_add_facing(
    luminaire_rgb *lights, const luminaire_row *row, const luminaire_spot *spot, const int8_t *normals, uint32_t count
) {
    if (!row || !spot || !lights) { return; }
    uint32_t i = luminaire_row_skipped(row, spot, 0, count, 0);
    uint32_t end = luminaire_min(count - luminaire_row_skipped(row, spot, count - 1, count - i, 1), count);
    luminaire_vertex at;
    luminaire_row_point(at.point, row, i);
    for (int k = 0; k < 3; ++k) { at.normal[k] = row->normal[k]; }
    for (; i < end; ++i) {
        if (normals) { luminaire_normal_from_unit_bytes(at.normal, &normals[3 * i]); }
        luminaire_spot_add(&lights[i], spot, &at);
        for (int k = 0; k < 3; ++k) { at.point[k] = luminaire_plus(at.point[k], row->step[k]); }
    }
}

/* Adds the light of a spotlight to each pixel of a row. */
static inline void luminaire_row_add(
    luminaire_rgb *lights, const luminaire_row *row, const luminaire_spot *spot, uint32_t count
) {
    luminaire_row_add_facing(lights, row, spot, 0, count);
}

/* ---- lights from the angles of a data sheet: full angles in steps of 2^-16 degrees ---- */

#define LUMINAIRE_ONE INT32_C(65536)     /* 1 as a coordinate or an intensity */
#define LUMINAIRE_DEGREE UINT32_C(65536) /* a degree as an angle */

/* The edge of a cone: of a lens that scatters, such as a Fresnel's, or of a profile. */
enum {
    LUMINAIRE_SOFT, /* 0 */
    LUMINAIRE_HARD  /* 1, as is all but 0 */
};

/* What a set-up returns. */
enum {
    LUMINAIRE_OK,        /* the light is set up */
    LUMINAIRE_ANGLE,     /* an angle of 0, or one so wide that light would leave the cone beyond 180 degrees */
    LUMINAIRE_ORDER,     /* an inner angle over the outer one, or a beam angle over the field angle */
    LUMINAIRE_RATIO,     /* a field angle too wide for its beam angle: the ratio of the versines is over 5.437 */
    LUMINAIRE_STEEPNESS, /* a cone that is too narrow for 16 bits, or an inner angle too close to the outer one */
    LUMINAIRE_AXIS,      /* an axis of length 0 */
    LUMINAIRE_NULL       /* a null pointer */
};

/* A cone. */
typedef struct {
    uint32_t inner, outer;     /* the chords sqrt(1 - cos) of half its inner and its outer angle, steps of 2^-31 */
    int32_t g, h;              /* its edge, as that of a spotlight */
    uint32_t steepness, slope; /* bounds of the derivatives, with respect to the angle and to t, steps of 2^-14 */
} luminaire_cone;

/* Returns what a code says, in English. The texts take 400 bytes of an AVR's RAM in a program that calls it. */
static inline const char *luminaire_refusal(int code) {
    switch (code) {
    case LUMINAIRE_OK: return "the light is set up";
    case LUMINAIRE_ANGLE: return "angle: expected more than 0, and a cone that ends within 180 degrees";
    case LUMINAIRE_ORDER: return "angles: expected inner at most outer, and beam at most field";
    case LUMINAIRE_RATIO: return "field angle: expected at most about 2.3 times the beam angle";
    case LUMINAIRE_STEEPNESS: return "cone: expected a wider cone or a smaller inner angle for 16 bits";
    case LUMINAIRE_AXIS: return "axis: expected a vector that is not zero";
    case LUMINAIRE_NULL: return "pointer: expected one that is not null";
    default: return "code: expected one that a set-up returned";
    }
}

/* Returns the chord of half an angle; 0 for an angle of 0 or over 180 degrees. The error is at most 6 units. */
LUMINAIRE_RARE uint32_t luminaire_chord_of(uint32_t angle) {
    static const uint32_t parts[4] = {
        UINT32_C(59652324), UINT32_C(102261127), UINT32_C(214748365), UINT32_C(715827883)
    };
    if (angle > UINT32_C(180) << 16) { return 0; }
    /* A quarter of the angle in radians, and its sine over it: 1 - x^2/6 (1 - x^2/20 (1 - x^2/42 (1 - x^2/72))). */
    uint32_t x = luminaire_high_half(angle << 8, UINT32_C(2398762259)), series = LUMINAIRE_FINE_ONE;
    uint32_t squared = luminaire_high_half(x, x) << 1;
    for (int i = 0; i < 4; ++i) {
        series = LUMINAIRE_FINE_ONE - luminaire_high_half(luminaire_high_half(squared, series) << 1, parts[i]);
    }
    return luminaire_high_half(luminaire_high_half(x << 1, series) << 1, LUMINAIRE_LARGEST_CHORD);
}

/* Makes a cone one of which no light is set up. */
static inline int luminaire_cone_refused(luminaire_cone *cone, int code) {
    cone->steepness = 0;
    return code;
}

/* Sets a cone up in which the chord of an angle is 2^31 / wider of the outer one. */
static inline int luminaire_cone_open(luminaire_cone *cone, int edge, uint32_t angle, uint32_t wider) {
    if (!cone) { return LUMINAIRE_NULL; }
    uint32_t half = luminaire_high_half(luminaire_chord_of(angle), wider);
    if (half == 0 || half > LUMINAIRE_FINE_ONE / 2) { return luminaire_cone_refused(cone, LUMINAIRE_ANGLE); }
    cone->inner = 0;
    cone->outer = half << 1;
    cone->g = edge ? 16384 : -16384;
    cone->h = 0;
    cone->steepness = edge ? 65544 : 25820;
    cone->slope = 32772;
    return LUMINAIRE_OK;
}

/* Sets a cone up with its field angle, at which 10 % of the intensity is left, and a soft or a hard edge. */
static inline int luminaire_cone_from_field(luminaire_cone *cone, int edge, uint32_t field) {
    return luminaire_cone_open(cone, edge, field, edge ? UINT32_C(2204800193) : UINT32_C(2597013068));
}

/* Sets a cone up with its beam angle, at which 50 % of the intensity is left, and a soft or a hard edge. */
static inline int luminaire_cone_from_beam(luminaire_cone *cone, int edge, uint32_t beam) {
    return luminaire_cone_open(cone, edge, beam, edge ? UINT32_C(2553802834) : UINT32_C(3968032378));
}

/* Sets a cone up with these chords and this edge. */
LUMINAIRE_RARE void luminaire_cone_of(luminaire_cone *cone, uint32_t inner, uint32_t outer, int32_t g, int32_t h) {
    luminaire_cone made = { inner, outer, g, h, 16384, 0 }; /* of a step */
    uint32_t up = 32 - luminaire_bit_length(outer), above = (luminaire_magnitude(h) >> 12) + 4, steepest = 0;
    /* The difference of the two versines, in units of the outer one. */
    uint32_t hotspot = luminaire_high_half(inner << up, luminaire_inverse_of_32(outer << up));
    uint32_t span = LUMINAIRE_FINE_ONE - (luminaire_high_half(hotspot, hotspot) << 1);
    int32_t from = 16384 + g;
    for (int32_t i = 1; i <= 64 && inner != outer; ++i) {
        /* The derivative of the edge between t = i - 1 and i 64ths: a parabola rises above the larger end by less. */
        int32_t to = 16384 + g + ((2 * (h - g) * i) >> 6) - ((3 * h * (i * i)) >> 12);
        int32_t larger = from > to ? from : to;
        uint32_t slope = (larger > 0 ? (uint32_t)larger : 0) + above;
        from = to;
        made.slope = luminaire_max(made.slope, slope);
        /* The root of the versine is largest at the part's beginning. */
        slope *= (luminaire_sqrt((LUMINAIRE_FINE_ONE - (span >> 6) * (uint32_t)(i - 1)) >> 1) >> 17) + 1;
        steepest = luminaire_max(steepest, slope >> 13);
    }
    if (inner != outer) {
        up = 32 - luminaire_bit_length(span);
        steepest = luminaire_high_half(steepest << up, luminaire_inverse_of_32(span << up)) + 1;
        made.steepness = span >> 21 ? steepest : 0;
    }
    *cone = made;
}

/* Sets a cone up with full intensity up to the inner angle, and no light from the outer angle on. */
static inline int luminaire_cone_from_inner_and_outer(
    luminaire_cone *cone, int edge, uint32_t inner, uint32_t outer
) {
    uint32_t chord = luminaire_chord_of(outer);
    if (!cone) { return LUMINAIRE_NULL; }
    if (inner > outer) { return luminaire_cone_refused(cone, LUMINAIRE_ORDER); }
    if (chord == 0) { return luminaire_cone_refused(cone, LUMINAIRE_ANGLE); }
    luminaire_cone_of(cone, luminaire_chord_of(inner), chord, edge ? 16384 : -16384, 0);
    return LUMINAIRE_OK;
}

/* Returns 1 - t where the edge with these weights has an intensity, in steps of 2^-31. */
LUMINAIRE_RARE uint32_t luminaire_edge_versine(int32_t g, int32_t h, uint32_t intensity) {
    uint32_t versine = 0;
    for (uint32_t bit = UINT32_C(1) << 30; bit; bit >>= 1) {
        if (luminaire_fine_cubic(LUMINAIRE_FINE_ONE - (versine | bit), g, h) > intensity) { versine |= bit; }
    }
    return versine;
}

#define LUMINAIRE_TENTH UINT32_C(214748365) /* in steps of 2^-31 */

/* Returns whether the ratio of the versines at a tenth and at half of the intensity is over far / near. */
static inline int luminaire_ratio_is_over(const uint32_t near_far[2], int32_t g, int32_t h) {
    return luminaire_high_half(luminaire_edge_versine(g, h, LUMINAIRE_TENTH), near_far[0])
        > luminaire_high_half(luminaire_edge_versine(g, h, LUMINAIRE_FINE_ONE / 2), near_far[1]);
}

/* Sets a cone up with its beam and its field angle. The intensity at each is within 0.0001 of that named. */
LUMINAIRE_RARE int luminaire_cone_from_beam_and_field(luminaire_cone *cone, uint32_t beam, uint32_t field) {
    uint32_t near = luminaire_chord_of(beam), far = luminaire_chord_of(field), up = luminaire_bit_length(far);
    if (!cone) { return LUMINAIRE_NULL; }
    if (beam > field) { return luminaire_cone_refused(cone, LUMINAIRE_ORDER); }
    if (near == 0 || far == 0) { return luminaire_cone_refused(cone, LUMINAIRE_ANGLE); }
    /* The two versines in the same unit, in which that of the field angle has 29 or 30 bits. */
    up = luminaire_less(31, up);
    uint32_t both[2] = { luminaire_high_half(near << up, near << up), luminaire_high_half(far << up, far << up) };
    if (both[1] <= luminaire_high_half(both[0] << 1, UINT32_C(2881151650))) {
        /* The hard edge with a hotspot. */
        uint32_t apart = both[1] - both[0], less = luminaire_high_half(apart, UINT32_C(3142897062)) << 2;
        uint32_t outer = luminaire_sqrt(both[1] + luminaire_high_half(apart, UINT32_C(912355056))) >> up;
        if (outer / 2 > LUMINAIRE_FINE_ONE / 2) { return luminaire_cone_refused(cone, LUMINAIRE_ANGLE); }
        luminaire_cone_of(cone, luminaire_sqrt(luminaire_less(both[0], less)) >> up, outer, 16384, 0);
        return LUMINAIRE_OK;
    }
    /* A quadratic between hard and soft, or a cubic with an edge slope of 1.34. */
    for (int is_cubic = both[1] > luminaire_high_half(both[0] << 2, UINT32_C(2506698000)); is_cubic < 2; ++is_cubic) {
        int32_t least = is_cubic ? -54149 : -16384, most = is_cubic ? 10813 : 16384, g = 5571;
        if (is_cubic && !luminaire_ratio_is_over(both, g, least)) { return luminaire_cone_refused(cone, LUMINAIRE_RATIO); }
        for (int step = 0; step < 16; ++step) {
            int32_t middle = (least + most) >> 1;
            int is_over = luminaire_ratio_is_over(both, is_cubic ? g : middle, is_cubic ? middle : 0);
            if (is_over) { least = middle; } else { most = middle; }
        }
        if (!is_cubic) { g = least; }
        int32_t h = is_cubic ? least : 0;
        uint32_t root = luminaire_sqrt(luminaire_edge_versine(g, h, LUMINAIRE_TENTH) << 1);
        uint32_t half = luminaire_high_half(far, luminaire_inverse_of_32(root | LUMINAIRE_FINE_ONE));
        if (half <= LUMINAIRE_FINE_ONE / 2) {
            luminaire_cone_of(cone, 0, half << 1, g, h);
            return LUMINAIRE_OK;
        }
    }
    return luminaire_cone_refused(cone, LUMINAIRE_ANGLE);
}

/* Returns an upper bound of the error of the coarse evaluation, in steps of 2^-24 of half a linear code. */
static inline uint32_t luminaire_coarse_error(const luminaire_cone *cone) {
    uint32_t zoom = luminaire_chord_zoom(cone->outer, 15), chord = cone->outer << zoom, is_long = chord >> 31;
    uint32_t inverse = luminaire_inverse_of_32(is_long ? chord : chord << 1) >> (15 + is_long);
    inverse = (inverse + 1) << 15;
    uint32_t direction = luminaire_high_half(cone->steepness << 8, ((UINT32_C(4629) << zoom) + 18073) << 8);
    uint32_t squared = luminaire_high_half(cone->slope << 14, UINT32_C(52144) << ((2 * zoom) & 31));
    squared = luminaire_high_half(luminaire_high_half(squared, inverse), inverse);
    return (luminaire_high_half(direction << 6, inverse) << 1)
        + (luminaire_high_half(cone->steepness << 8, UINT32_C(885588) << 8) << 2) + (squared >> 2)
        + (luminaire_high_half(cone->slope << 14, UINT32_C(352513) << 8) >> 4) + 705032 + 256;
}

/* Returns the encoded distance within which points need the fine evaluation. */
static inline uint32_t luminaire_fine_below_of(uint32_t error, uint32_t intensity) {
    if (error >> 24) { return LUMINAIRE_ALWAYS_FINE; }
    uint32_t factor = luminaire_max(luminaire_high_half(error, UINT32_C(2481735183)) + 1, 1045869);
    uint32_t up = 32 - luminaire_bit_length(intensity), product = luminaire_high_half(factor << 8, intensity << up);
    uint32_t length = luminaire_less(luminaire_bit_length(product) + 16, up), bits = (length + 1) >> 1;
    return intensity && length ? bits << 26 | product >> ((2 * bits + up - 42) & 31) : 0;
}

/* Sets a white spotlight up, with the inverse square of the distance: position and axis in steps of 2^-16, the axis
 * of any length, and an intensity on the axis in steps of 2^-16. If it is refused, it is dark. */
LUMINAIRE_RARE int luminaire_spot_set_up(
    luminaire_spot *spot, const luminaire_cone *cone, const int32_t position[3], const int32_t axis[3],
    int32_t intensity
) {
    static const luminaire_spot dark = {
        { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, 0, 0, { 0, 0 }, 0, { 0, 0, 0 }, 0
    };
    static const int16_t white[3] = { 16384, 16384, 16384 };
    if (!spot) { return LUMINAIRE_NULL; }
    *spot = dark;
    if (!cone || !position || !axis) { return LUMINAIRE_NULL; }
    /* The narrowest chord is 1.55e-5 * 510 / sqrt(2) times the steepness, which is 0 of an edge too steep to hold. */
    if (cone->steepness - 1 >= UINT32_C(1) << 22 || cone->outer < cone->steepness * 733) { return LUMINAIRE_STEEPNESS; }
    if (!luminaire_spot_aim_along(spot, axis)) { return LUMINAIRE_AXIS; }
    uint32_t chords[3] = { cone->inner, cone->outer, cone->outer }, error = luminaire_coarse_error(cone);
    luminaire_spot_set_cone(spot, chords, error >> 24 != 0);
    luminaire_spot_move(spot, position);
    luminaire_spot_tint(spot, white);
    spot->g = cone->g;
    spot->h = cone->h;
    spot->intensity.mantissa = intensity > 0 ? (uint32_t)intensity : 0;
    spot->intensity.shift = 16;
    spot->fine_below = luminaire_fine_below_of(error, spot->intensity.mantissa);
    spot->intensity = luminaire_restored(spot->intensity);
    return LUMINAIRE_OK;
}

/* ---- light from infinitely far away, and light from everywhere ---- */

/* A directional light, such as the sun: the same everywhere. With all words zero it is dark. Any words are defined. */
typedef struct {
    int32_t direction[3];     /* in which the light travels, of unit length, steps of 2^-30 */
    luminaire_gain intensity; /* 1 lights a surface that faces the light to full scale */
    int16_t color[3];         /* linear, from 0 to 2^14 */
} luminaire_directional;

/* Returns the irradiance at a unit normal, before the colour. */
static inline uint32_t luminaire_directional_irradiance(const luminaire_directional *light, const int16_t normal[3]) {
    int32_t cosine = INT32_C(1) << 13;
    if (!light || !normal) { return 0; }
    for (int i = 0; i < 3; ++i) {
        cosine = luminaire_minus(cosine, luminaire_times(((light->direction[i] >> 15) + 1) >> 1, normal[i]));
    }
    cosine >>= 14;
    if (cosine <= 0) { return 0; }
    uint32_t product = luminaire_min((uint32_t)cosine, LUMINAIRE_FULL_SCALE) * (light->intensity.mantissa >> 16);
    return luminaire_light_of(product, luminaire_minus(light->intensity.shift, 16));
}

/* Returns the irradiance of a surface that faces the light, before the colour. */
static inline uint32_t luminaire_directional_irradiance_facing(const luminaire_directional *light) {
    if (!light) { return 0; }
    uint32_t product = LUMINAIRE_FULL_SCALE * (light->intensity.mantissa >> 16);
    return luminaire_light_of(product, luminaire_minus(light->intensity.shift, 16));
}

/* Returns the light at a unit normal: the irradiance times the colour. */
static inline luminaire_rgb luminaire_directional_light(const luminaire_directional *light, const int16_t normal[3]) {
    uint32_t irradiance = luminaire_directional_irradiance(light, normal);
    luminaire_rgb white = { irradiance, irradiance, irradiance };
    return luminaire_rgb_filtered(white, light ? light->color : 0);
}

/* Turns the light along a vector of any length. Returns 0, and changes nothing, if it is zero. */
static inline int luminaire_directional_aim_along(luminaire_directional *light, const int32_t way[3]) {
    return light && way && luminaire_unit(light->direction, luminaire_origin, way);
}

/* Gives the light a linear colour, in steps of 2^-14 from 0 to 2^14. */
static inline void luminaire_directional_tint(luminaire_directional *light, const int16_t color[3]) {
    for (int i = 0; light && color && i < 3; ++i) { light->color[i] = color[i]; }
}

/* Multiplies the intensity by a part of 1, from 0 to 2^14. A light that fades keeps a copy of its full intensity. */
static inline void luminaire_directional_dim(luminaire_directional *light, int16_t part) {
    if (light) { luminaire_gain_dim(&light->intensity, part); }
}

/* Sets a white directional light up, along a vector of any length, with an intensity in steps of 2^-16. If it is
 * refused, it is dark. */
static inline int luminaire_directional_set_up(luminaire_directional *light, const int32_t way[3], int32_t intensity) {
    static const luminaire_directional dark = { { 0, 0, 0 }, { 0, 0 }, { 0, 0, 0 } };
    static const int16_t white[3] = { 16384, 16384, 16384 };
    if (!light) { return LUMINAIRE_NULL; }
    *light = dark;
    if (!way) { return LUMINAIRE_NULL; }
    if (!luminaire_directional_aim_along(light, way)) { return LUMINAIRE_AXIS; }
    luminaire_directional_tint(light, white);
    light->intensity.mantissa = intensity > 0 ? (uint32_t)intensity : 0;
    light->intensity.shift = 16;
    light->intensity = luminaire_restored(light->intensity);
    return LUMINAIRE_OK;
}

/* Returns ambient light, the same at every point and normal, which a program adds to the others: a linear colour in
 * steps of 2^-14 times an intensity in steps of 2^-16. */
static inline luminaire_rgb luminaire_ambient(const int16_t color[3], int32_t intensity) {
    uint32_t light = intensity > 0 ? ((uint32_t)intensity + 2) >> 2 : 0;
    luminaire_rgb white = { light, light, light };
    return luminaire_rgb_filtered(white, color);
}

/* ---- pixels ----
 *
 * A light has three channels in steps of 2^-14 of full scale, which they may exceed; an output
 * clips it. A code is the nearest of sRGB, or with ordered dither one of the two around the light:
 * over cells of 8 x 8 pixels their mean is the light.
 *
 * The search for a code starts from a table of 256 bytes, by the upper eight bits of the light, and
 * goes up. On Cortex-M0 a pixel of RGB565 then takes 91 instructions, with dither 139, on average
 * over uniform light (measured, -Os); by bisection 213 and 236. Unused tables are not linked.
 */

/* Bayer's matrix as thresholds in 128ths. */
static const uint8_t luminaire_thresholds[64] LUMINAIRE_TABLE = {
    1, 65, 17, 81, 5, 69, 21, 85, 97, 33, 113, 49, 101, 37, 117, 53, 25, 89, 9, 73, 29, 93, 13, 77, 121, 57, 105, 41,
    125, 61, 109, 45, 7, 71, 23, 87, 3, 67, 19, 83, 103, 39, 119, 55, 99, 35, 115, 51, 31, 95, 15, 79, 27, 91, 11, 75,
    127, 63, 111, 47, 123, 59, 107, 43
};

/* 256 times a code up to those of light with these upper bits, over any last code, rounded up. */
static const uint8_t luminaire_starts[256] LUMINAIRE_TABLE = {
    1, 13, 22, 28, 34, 39, 43, 47, 50, 53, 56, 59, 62, 64, 67, 69, 71, 73, 75, 78, 79, 81, 83, 85, 87, 89, 90, 92, 93,
    95, 97, 98, 100, 101, 102, 104, 105, 107, 108, 109, 111, 112, 113, 114, 115, 117, 118, 119, 120, 121, 123, 123,
    125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143, 144, 145, 146, 147,
    148, 149, 150, 150, 151, 152, 153, 154, 155, 156, 156, 157, 158, 159, 160, 161, 161, 162, 163, 164, 164, 165, 166,
    167, 168, 168, 169, 170, 171, 171, 172, 173, 174, 174, 175, 176, 176, 177, 178, 178, 179, 180, 181, 181, 182, 183,
    183, 184, 185, 185, 186, 187, 187, 188, 189, 189, 190, 190, 191, 192, 193, 193, 194, 194, 195, 196, 196, 197, 198,
    198, 199, 199, 200, 201, 201, 202, 202, 203, 204, 204, 205, 205, 206, 206, 207, 208, 208, 209, 209, 210, 211, 211,
    212, 212, 213, 213, 214, 214, 215, 216, 216, 217, 217, 218, 218, 219, 219, 220, 220, 221, 221, 222, 222, 223, 224,
    224, 225, 225, 226, 226, 227, 227, 228, 228, 229, 229, 230, 230, 231, 231, 232, 232, 233, 233, 234, 234, 235, 235,
    236, 236, 237, 237, 238, 238, 239, 239, 240, 240, 240, 241, 241, 242, 242, 243, 243, 244, 244, 245, 245, 246, 246,
    247, 247, 247, 248, 248, 249, 249, 250, 250, 251, 251, 252, 252, 252, 253, 253, 254, 254, 255, 255
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_5[32] LUMINAIRE_TABLE = {
    21, 63, 120, 199, 304, 435, 594, 782, 1002, 1253, 1539, 1859, 2215, 2607, 3038, 3507, 4017, 4567, 5158, 5792,
    6469, 7191, 7957, 8769, 9627, 10532, 11485, 12487, 13538, 14639, 15790, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_5[32] LUMINAIRE_TABLE = {
    0, 41889, 90103, 159878, 253898, 374113, 522276, 699989, 908731, 1149884, 1424746, 1734543, 2080442, 2463553,
    2884941, 3345627, 3846592, 4388786, 4973125, 5600496, 6271760, 6987753, 7749289, 8557159, 9412136, 10314974,
    11266409, 12267161, 13317934, 14419419, 15572292, 16777216
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_6[64] LUMINAIRE_TABLE = {
    11, 31, 51, 73, 101, 134, 173, 217, 268, 325, 388, 458, 535, 619, 710, 808, 914, 1028, 1150, 1279, 1417, 1563,
    1717, 1880, 2052, 2232, 2422, 2620, 2828, 3045, 3271, 3507, 3753, 4008, 4273, 4548, 4834, 5129, 5435, 5751, 6077,
    6414, 6762, 7120, 7489, 7870, 8261, 8663, 9077, 9502, 9938, 10385, 10845, 11316, 11798, 12293, 12799, 13317,
    13847, 14390, 14944, 15511, 16090, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_6[64] LUMINAIRE_TABLE = {
    0, 20612, 41224, 62497, 88261, 119344, 156022, 198550, 247169, 302105, 363573, 431778, 506917, 589176, 678737,
    775774, 880455, 992944, 1113399, 1241973, 1378815, 1524071, 1677882, 1840387, 2011721, 2192015, 2381399, 2579999,
    2787939, 3005340, 3232322, 3469002, 3715494, 3971912, 4238366, 4514966, 4801818, 5099030, 5406705, 5724946,
    6053854, 6393528, 6744068, 7105570, 7478130, 7861844, 8256803, 8663100, 9080827, 9510074, 9950929, 10403481,
    10867817, 11344022, 11832183, 12332382, 12844704, 13369231, 13906044, 14455225, 15016854, 15591010, 16177771,
    16777216
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_8[256] LUMINAIRE_TABLE = {
    3, 8, 13, 18, 23, 28, 33, 38, 43, 48, 53, 58, 64, 69, 76, 82, 89, 96, 103, 111, 119, 128, 136, 145, 155, 165, 175,
    185, 196, 207, 219, 231, 243, 256, 269, 283, 297, 311, 325, 340, 356, 372, 388, 405, 422, 439, 457, 475, 494, 513,
    533, 553, 573, 594, 616, 637, 660, 682, 705, 729, 753, 777, 802, 828, 853, 880, 907, 934, 961, 990, 1018, 1047,
    1077, 1107, 1138, 1169, 1200, 1233, 1265, 1298, 1332, 1366, 1400, 1435, 1471, 1507, 1544, 1581, 1618, 1656, 1695,
    1734, 1774, 1814, 1855, 1896, 1938, 1980, 2023, 2067, 2110, 2155, 2200, 2246, 2292, 2338, 2386, 2433, 2482, 2531,
    2580, 2630, 2681, 2732, 2783, 2836, 2888, 2942, 2996, 3050, 3105, 3161, 3217, 3274, 3332, 3390, 3448, 3507, 3567,
    3627, 3688, 3750, 3812, 3875, 3938, 4002, 4067, 4132, 4197, 4264, 4331, 4398, 4466, 4535, 4605, 4675, 4745, 4817,
    4888, 4961, 5034, 5108, 5182, 5257, 5333, 5409, 5486, 5563, 5642, 5720, 5800, 5880, 5961, 6042, 6124, 6207, 6290,
    6374, 6458, 6544, 6630, 6716, 6803, 6891, 6980, 7069, 7159, 7249, 7340, 7432, 7525, 7618, 7712, 7806, 7901, 7997,
    8094, 8191, 8289, 8387, 8487, 8587, 8687, 8788, 8890, 8993, 9096, 9200, 9305, 9411, 9517, 9624, 9731, 9839, 9948,
    10058, 10168, 10279, 10391, 10503, 10616, 10730, 10845, 10960, 11076, 11193, 11310, 11428, 11547, 11666, 11787,
    11908, 12029, 12152, 12275, 12399, 12523, 12649, 12775, 12901, 13029, 13157, 13286, 13416, 13546, 13678, 13809,
    13942, 14075, 14210, 14345, 14480, 14617, 14754, 14891, 15030, 15169, 15310, 15450, 15592, 15734, 15878, 16021,
    16166, 16312, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_8[256] LUMINAIRE_TABLE = {
    0, 5092, 10185, 15277, 20369, 25462, 30554, 35646, 40739, 45831, 50923, 56146, 61682, 67524, 73676, 80144, 86931,
    94043, 101483, 109255, 117364, 125813, 134607, 143749, 153244, 163095, 173306, 183880, 194821, 206133, 217819,
    229883, 242327, 255157, 268373, 281981, 295983, 310382, 325182, 340386, 355996, 372016, 388449, 405298, 422565,
    440255, 458369, 476910, 495881, 515286, 535127, 555406, 576126, 597291, 618902, 640963, 663476, 686443, 709868,
    733752, 758099, 782910, 808189, 833938, 860159, 886854, 914027, 941680, 969814, 998433, 1027538, 1057133, 1087218,
    1117798, 1148873, 1180447, 1212520, 1245097, 1278179, 1311767, 1345865, 1380475, 1415598, 1451237, 1487394,
    1524071, 1561270, 1598994, 1637244, 1676023, 1715332, 1755173, 1795550, 1836463, 1877915, 1919907, 1962442,
    2005522, 2049149, 2093324, 2138049, 2183328, 2229161, 2275550, 2322497, 2370005, 2418074, 2466708, 2515908,
    2565675, 2616012, 2666920, 2718402, 2770458, 2823092, 2876304, 2930097, 2984472, 3039432, 3094977, 3151110,
    3207832, 3265145, 3323052, 3381553, 3440650, 3500346, 3560641, 3621538, 3683038, 3745144, 3807855, 3871176,
    3935106, 3999648, 4064803, 4130573, 4196960, 4263965, 4331589, 4399836, 4468706, 4538200, 4608321, 4679069,
    4750448, 4822457, 4895099, 4968376, 5042288, 5116838, 5192027, 5267856, 5344328, 5421443, 5499204, 5577611,
    5656667, 5736372, 5816729, 5897738, 5979402, 6061722, 6144699, 6228335, 6312631, 6397589, 6483210, 6569496,
    6656448, 6744068, 6832357, 6921317, 7010948, 7101253, 7192233, 7283889, 7376223, 7469237, 7562930, 7657306,
    7752366, 7848110, 7944540, 8041658, 8139465, 8237963, 8337152, 8437035, 8537612, 8638885, 8740855, 8843524,
    8946893, 9050964, 9155737, 9261215, 9367397, 9474287, 9581885, 9690192, 9799210, 9908940, 10019383, 10130542,
    10242416, 10355008, 10468318, 10582349, 10697100, 10812575, 10928773, 11045697, 11163346, 11281724, 11400831,
    11520668, 11641236, 11762538, 11884573, 12007344, 12130852, 12255098, 12380082, 12505807, 12632274, 12759484,
    12887438, 13016137, 13145583, 13275776, 13406719, 13538412, 13670857, 13804054, 13938006, 14072712, 14208175,
    14344396, 14481375, 14619114, 14757615, 14896878, 15036905, 15177696, 15319253, 15461578, 15604671, 15748533,
    15893166, 16038571, 16184750, 16331702, 16479430, 16627934, 16777216
};

/* ---- codes ---- */

/* Returns the dither's threshold of the pixel at (x, y): an odd number of 128ths, 1 to 127. */
static inline uint32_t luminaire_threshold(uint32_t x, uint32_t y) {
    return LUMINAIRE_READ_8(&luminaire_thresholds[(y & 7) << 3 | (x & 7)]);
}

/* Returns a channel clipped just below 1: the light there has the codes of 1. */
static inline uint32_t luminaire_clipped(uint32_t light) { return luminaire_min(light, (UINT32_C(1) << 14) - 1); }

/* Returns a code of 1 to 8 bits that no light with these upper eight bits is below. */
static inline uint32_t luminaire_start(uint32_t place, uint32_t bits) {
    uint32_t start = LUMINAIRE_READ_8(&luminaire_starts[place]);
    return ((start << bits) - start) >> 8;
}

/* Returns the nearest code to a clipped channel, from a code up to it. */
static inline uint32_t luminaire_nearest(const uint16_t *nearest, uint32_t code, uint32_t light) {
    while (light >= LUMINAIRE_READ_16(&nearest[code])) { ++code; }
    return code;
}

/* Returns the dithered code of a light below 1 in steps of 2^-24, from a code up to it. */
static inline uint32_t luminaire_dithered(
    const uint32_t *lights, uint32_t code, uint32_t light, uint32_t threshold
) {
    uint32_t here, next;
    while (light >= LUMINAIRE_READ_32(&lights[code + 1])) { ++code; }
    here = LUMINAIRE_READ_32(&lights[code]);
    next = LUMINAIRE_READ_32(&lights[code + 1]);
    return code + ((light - here) << 7 > (next - here) * threshold);
}

/* Returns the nearest sRGB code of up to eight bits to a channel. */
static inline uint32_t luminaire_code(const uint16_t *nearest, uint32_t bits, uint32_t light) {
    light = luminaire_clipped(light);
    return luminaire_nearest(nearest, luminaire_start(light >> 6, bits), light);
}

/* Returns the dithered sRGB code of up to eight bits of a channel. */
static inline uint32_t luminaire_code_dithered(
    const uint32_t *lights, uint32_t bits, uint32_t light, uint32_t threshold
) {
    light = luminaire_clipped(light);
    return luminaire_dithered(lights, luminaire_start(light >> 6, bits), light << 10, threshold);
}

/* ---- pixels ---- */

/* Returns the sRGB code of a channel, from 0 to 255. */
static inline uint8_t luminaire_encode_srgb(uint32_t light) {
    return (uint8_t)luminaire_code(luminaire_nearest_8, 8, light);
}

/* Returns the sRGB code of a channel for the pixel at (x, y), with ordered dither. */
static inline uint8_t luminaire_encode_srgb_dithered(uint32_t light, uint32_t x, uint32_t y) {
    return (uint8_t)(luminaire_code_dithered(luminaire_lights_8, 8, light, luminaire_threshold(x, y)));
}

/* Returns the three sRGB codes of a light as 0xRRGGBB. */
static inline uint32_t luminaire_srgb(luminaire_rgb light) {
    return luminaire_code(luminaire_nearest_8, 8, light.red) << 16
        | luminaire_code(luminaire_nearest_8, 8, light.green) << 8
        | luminaire_code(luminaire_nearest_8, 8, light.blue);
}

/* Returns the three sRGB codes of a light at (x, y) as 0xRRGGBB, with ordered dither. */
static inline uint32_t luminaire_srgb_dithered(luminaire_rgb light, uint32_t x, uint32_t y) {
    uint32_t threshold = luminaire_threshold(x, y);
    return luminaire_code_dithered(luminaire_lights_8, 8, light.red, threshold) << 16
        | luminaire_code_dithered(luminaire_lights_8, 8, light.green, threshold) << 8
        | luminaire_code_dithered(luminaire_lights_8, 8, light.blue, threshold);
}

/* Returns the nearest pixel of five bits of red above six of green and five of blue. */
static inline uint16_t luminaire_rgb565(luminaire_rgb light) {
    return (uint16_t)(luminaire_code(luminaire_nearest_5, 5, light.red) << 11
        | luminaire_code(luminaire_nearest_6, 6, light.green) << 5
        | luminaire_code(luminaire_nearest_5, 5, light.blue));
}

/* Returns the pixel of RGB565 at (x, y), with ordered dither. */
static inline uint16_t luminaire_rgb565_dithered(luminaire_rgb light, uint32_t x, uint32_t y) {
    uint32_t threshold = luminaire_threshold(x, y);
    return (uint16_t)(luminaire_code_dithered(luminaire_lights_5, 5, light.red, threshold) << 11
        | luminaire_code_dithered(luminaire_lights_6, 6, light.green, threshold) << 5
        | luminaire_code_dithered(luminaire_lights_5, 5, light.blue, threshold));
}

/* Returns the linear value of an sRGB code in steps of 2^-14, to nearest: of a texture's channel. */
static inline int16_t luminaire_decode_srgb(uint8_t code) {
    return (int16_t)((LUMINAIRE_READ_32(&luminaire_lights_8[code]) + (1 << 9)) >> 10);
}

/* Returns the light that a surface reflects whose colour is a pixel of RGB565. */
static inline luminaire_rgb luminaire_rgb_textured(luminaire_rgb light, uint16_t texel) {
    /* The nearest codes of eight bits: 255/31 and 255/63 times as much. */
    uint32_t red = ((uint32_t)texel >> 11) * 527 + 23, green = ((uint32_t)texel >> 5 & 63) * 259 + 33;
    uint32_t blue = ((uint32_t)texel & 31) * 527 + 23;
    light.red = luminaire_light_filtered(light.red, luminaire_decode_srgb((uint8_t)(red >> 6)));
    light.green = luminaire_light_filtered(light.green, luminaire_decode_srgb((uint8_t)(green >> 6)));
    light.blue = luminaire_light_filtered(light.blue, luminaire_decode_srgb((uint8_t)(blue >> 6)));
    return light;
}

/* Multiplies the lights of a row of surfaces by their colours: pixels of RGB565 of a texture, one each. */
static inline void luminaire_row_texture(luminaire_rgb *lights, const uint16_t *texels, uint32_t count) {
    for (uint32_t i = 0; lights && texels && i < count; ++i) { lights[i] = luminaire_rgb_textured(lights[i], texels[i]); }
}

/* Writes a pixel of 16 bits with its upper byte first: the order of most displays on SPI. */
static inline void luminaire_high_first(uint8_t bytes[2], uint16_t pixel) {
    if (!bytes) { return; }
    bytes[0] = (uint8_t)(pixel >> 8);
    bytes[1] = (uint8_t)(pixel & 0xff);
}

/* Writes a pixel of 16 bits with its lower byte first. */
static inline void luminaire_low_first(uint8_t bytes[2], uint16_t pixel) {
    if (!bytes) { return; }
    bytes[0] = (uint8_t)(pixel & 0xff);
    bytes[1] = (uint8_t)(pixel >> 8);
}

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
