/* Luminaire in C99 and C++11, in 16-bit integers: bit-identical to the kernel's format Fx16.
 *
 * A light that luminaire-export writes includes this file and calls its stages; a luminaire_spot
 * moves. A point has steps of 2^-16, a normal, a falloff, a part and a colour steps of 2^-14, and the
 * irradiance and light steps of 2^-14 of full scale, which they may exceed. The code has no floats,
 * no division and no memory of its own. The time per point is bounded, but for the binary search
 * among knots. It is defined for all inputs: those of a luminaire_spot, and a null one, included.
 *
 * Two evaluations have functions of the same names. The coarse one is usual, in 32-bit products: a
 * fraction has 15 fraction bits and a share of the intensity 14. The fine one is for steep cones and
 * for points near bright lights: fractions and shares have 31 fraction bits.
 *
 * Licence: MIT OR Apache-2.0, at your choice.
 */
#ifndef LUMINAIRE_H
#define LUMINAIRE_H

#include <stdint.h>

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

/* TABLES */

/* Some processors have no instruction for the upper half of a product: they compute it from four
 * products of 16-bit numbers, with the same result. */
#if !defined(LUMINAIRE_BY_PARTS) && (defined(__ARM_ARCH_6M__) || defined(__AVR__))
#define LUMINAIRE_BY_PARTS 1
#endif

/* Others have no instruction that counts leading zeros: they look them up. */
#if defined(__GNUC__) && __SIZEOF_INT__ == 4 && !defined(LUMINAIRE_BY_PARTS)
#if !defined(__riscv) || defined(__riscv_zbb)
#define LUMINAIRE_COUNTS_ZEROS 1
#endif
#endif

/* A function that is seldom called. */
#if defined(__GNUC__)
#define LUMINAIRE_RARE __attribute__((cold, noinline, unused)) static
#else
#define LUMINAIRE_RARE static inline
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

/* A line of a table: its start in steps of 2^-16, the value there and the slope in steps of 2^-15. */
typedef struct {
    uint16_t place, value;
    int32_t slope;
} luminaire_knot;

/* The vector from a light to a point: way >> shift has 17 bits. bits is its unscaled bit length. */
typedef struct {
    int32_t way[3];
    uint32_t shift, bits;
} luminaire_offset;

/* The direction to a point with 30 fraction bits, and 2^30 over its length. */
typedef struct {
    int32_t direction[3];
    uint32_t bits, squared, reciprocal;
} luminaire_coarse_ray;

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
static inline uint32_t luminaire_below_zero(int32_t a) { return a < 0 ? UINT32_C(0) - (uint32_t)a : 0; }

/* Returns the magnitude. */
static inline uint32_t luminaire_magnitude(int32_t a) { return a < 0 ? UINT32_C(0) - (uint32_t)a : (uint32_t)a; }

#if !defined(LUMINAIRE_COUNTS_ZEROS)
/* floor(log2 n) for each n of seven bits; 0 for 0. */
static const uint8_t luminaire_log2[128] LUMINAIRE_TABLE = {
    0, 0, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6
};
#endif

/* Returns the bit length of n from 1 to 127. */
static inline uint32_t luminaire_bit_length_of_seven(uint32_t n) {
#if defined(LUMINAIRE_COUNTS_ZEROS)
    return 32 - (uint32_t)__builtin_clz(n | 1);
#else
    return LUMINAIRE_READ_8(&luminaire_log2[n & 127]) + UINT32_C(1);
#endif
}

/* Returns the bit length; 1 for 0. */
static inline uint32_t luminaire_bit_length(uint32_t n) {
#if defined(LUMINAIRE_COUNTS_ZEROS)
    return 32 - (uint32_t)__builtin_clz(n | 1);
#else
    uint32_t length = 0;
    for (; n >> 7; n >>= 7) { length += 7; }
    return length + luminaire_bit_length_of_seven(n);
#endif
}

/* Returns a * b / 2^32, rounded down. */
static inline uint32_t luminaire_high_half(uint32_t a, uint32_t b) {
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
static inline uint32_t luminaire_high_product(uint32_t a, uint32_t b) {
    return (a >> 16) * b + (((a & 0xffff) * b) >> 16);
}

/* Returns a * b / 2^16 for b of 16 bits, rounded down. */
static inline int32_t luminaire_signed_high_product(int32_t a, uint32_t b) {
    uint32_t low = (((uint32_t)a & 0xffff) * b) >> 16;
    return luminaire_plus(luminaire_times(a >> 16, (int32_t)b), (int32_t)low);
}

/* Returns a * b / 2^32 for numbers of 30 bits and a sign, rounded down. */
static inline int32_t luminaire_signed_high_half(int32_t a, int32_t b) {
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
static inline uint32_t luminaire_high_square(int32_t a) {
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
static inline uint32_t luminaire_size(const int32_t way[3]) {
    return (uint32_t)(way[0] ^ (way[0] >> 31)) | (uint32_t)(way[1] ^ (way[1] >> 31))
        | (uint32_t)(way[2] ^ (way[2] >> 31));
}

/* Returns 2^31 / sqrt(n) for n >= 2^30, by linear interpolation. */
static inline uint32_t luminaire_guess(uint32_t n) {
    uint32_t here = LUMINAIRE_READ_16(&luminaire_inverse_square_roots[n >> 25]);
    uint32_t next = LUMINAIRE_READ_16(&luminaire_inverse_square_roots[(n >> 25) + 1]);
    return here - (((here - next) * ((n << 7) >> 16)) >> 16);
}

/* Returns 2^30 / sqrt(n) for n >= 2^28; 0 for 0. */
static inline uint32_t luminaire_inverse_sqrt(uint32_t n) {
    return n >> 30 ? (luminaire_guess(n) + 1) >> 1 : luminaire_guess(n << 2);
}

/* ---- gains ---- */

/* Returns the light product / 2^shift, rounded to nearest; saturates. */
static inline uint32_t luminaire_light_of(uint32_t product, int32_t shift) {
    uint32_t but_one = (uint32_t)shift - 1;
    if (but_one < 32) {
        uint32_t doubled = product >> but_one;
        return (doubled >> 1) + (doubled & 1);
    }
    if (shift > 0 || product == 0) { return 0; }
    if ((uint32_t)-shift <= 32 - luminaire_bit_length(product)) { return product << (uint32_t)-shift; }
    return UINT32_C(0xffffffff);
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
    return luminaire_gain_of(rounded << (16 - carry), shift + up - (int32_t)carry);
}

static inline luminaire_gain luminaire_gain_by(luminaire_gain a, luminaire_gain b) {
    return luminaire_normalised((a.mantissa >> 16) * (b.mantissa >> 16), a.shift - 16 + b.shift - 16);
}

static inline luminaire_gain luminaire_gain_plus(luminaire_gain a, luminaire_gain b) {
    luminaire_gain large, small;
    uint32_t apart, aligned;
    if (a.mantissa == 0) { return b; }
    if (b.mantissa == 0) { return a; }
    large = a.shift < b.shift ? a : b;
    small = a.shift < b.shift ? b : a;
    apart = (uint32_t)(small.shift - large.shift);
    aligned = apart < 32 ? ((small.mantissa >> 16) << 15) >> apart : 0;
    return luminaire_normalised(((large.mantissa >> 16) << 15) + aligned, large.shift - 16 + 15);
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

/* Returns 2^31 / m for m of 16 bits, to the nearest. */
static inline uint32_t luminaire_inverse(uint32_t m) {
    int32_t inverse = luminaire_quick_inverse(m);
    int32_t lack = (int32_t)(LUMINAIRE_FINE_ONE - (uint32_t)inverse * m);
    return (uint32_t)(inverse + (luminaire_plus(luminaire_times(inverse, lack >> 4), INT32_C(1) << 26) >> 27));
}

/* Returns the reciprocal of a gain; 1 if that is less. */
static inline luminaire_gain luminaire_inverse_capped(luminaire_gain gain) {
    int32_t scale = gain.shift - 16;
    if (gain.mantissa == 0 || scale >= 16) { return luminaire_gain_of(LUMINAIRE_FINE_ONE, 31); }
    return luminaire_normalised(luminaire_inverse(gain.mantissa >> 16), 31 - scale);
}

/* Returns a gain as a coarse share, at most 1. */
static inline uint32_t luminaire_gain_share(luminaire_gain gain) {
    int32_t scale = gain.shift - 16;
    if (gain.mantissa != 0 && scale < 16) { return LUMINAIRE_FULL_SCALE; }
    return luminaire_light_of(gain.mantissa >> 16, scale - 14);
}

/* ---- offsets and rays ---- */

static inline luminaire_offset luminaire_offset_of(const int32_t way[3], uint32_t shift, uint32_t bits) {
    luminaire_offset offset;
    offset.way[0] = way[0];
    offset.way[1] = way[1];
    offset.way[2] = way[2];
    offset.shift = shift & 15;
    offset.bits = bits;
    return offset;
}

/* Returns the offset from a light to a point. */
static inline luminaire_offset luminaire_offset_between(const int32_t light[3], const int32_t point[3]) {
    int32_t way[3];
    uint32_t size, bits;
    int i;
    for (i = 0; i < 3; ++i) { way[i] = luminaire_minus(point[i], light[i]); }
    size = luminaire_size(way);
    if (size >> 24) {
        /* A difference that wraps still has more than 24 bits. Halved, it fits. */
        for (i = 0; i < 3; ++i) { way[i] = (point[i] >> 1) - (light[i] >> 1); }
        bits = luminaire_bit_length(luminaire_size(way));
        return luminaire_offset_of(way, bits - 17, bits + 1);
    }
    if (size >> 17) {
        bits = luminaire_bit_length_of_seven(size >> 17);
        return luminaire_offset_of(way, bits, bits + 17);
    }
    bits = luminaire_bit_length(size);
    for (i = 0; i < 3; ++i) { way[i] = luminaire_shl(way[i], (31 - bits) & 31); }
    return luminaire_offset_of(way, 14, bits);
}

/* Returns a component of the offset, scaled until the largest has 15 bits. */
static inline int32_t luminaire_part(const luminaire_offset *offset, int i) {
    return offset->way[i] >> (offset->shift + 2);
}

/* Returns the squared length of the scaled offset. */
static inline uint32_t luminaire_squared(const luminaire_offset *offset) {
    uint32_t squared = 0;
    int i;
    for (i = 0; i < 3; ++i) {
        int32_t part = luminaire_part(offset, i);
        squared += (uint32_t)luminaire_times(part, part);
    }
    return squared;
}

/* Returns the product of the scaled offset and a normal: negative if the surface faces the light. */
static inline int32_t luminaire_facing(const luminaire_offset *offset, const int16_t normal[3]) {
    int32_t sum = 0;
    int i;
    for (i = 0; i < 3; ++i) { sum = luminaire_plus(sum, luminaire_times(normal[i], luminaire_part(offset, i))); }
    return sum;
}

/* Returns whether a point is so close to the light that it needs the fine evaluation. */
static inline int luminaire_is_near(const luminaire_offset *offset, uint32_t fine_below) {
    uint32_t fewer = (fine_below >> 26) - offset->bits, down = 2 * fewer + 4;
    if ((int32_t)fewer < 0) { return 0; }
    return (down < 32 ? luminaire_squared(offset) >> down : 0) < (fine_below & ((UINT32_C(1) << 26) - 1));
}

/* Returns whether a point is certainly outside a cone. */
static inline int luminaire_is_outside(const luminaire_offset *offset, const int32_t axis[3], uint32_t bound) {
    int32_t along = 0;
    int i;
    for (i = 0; i < 3; ++i) { along = luminaire_plus(along, luminaire_times(axis[i] >> 16, luminaire_part(offset, i))); }
    along = along >> 14 > 0 ? along >> 14 : 0;
    return (uint32_t)along * (uint32_t)along < (luminaire_squared(offset) >> 14) * bound;
}

static inline luminaire_coarse_ray luminaire_coarse_ray_of(const luminaire_offset *offset) {
    luminaire_coarse_ray ray;
    int i;
    ray.bits = offset->bits;
    ray.squared = luminaire_squared(offset);
    ray.reciprocal = luminaire_inverse_sqrt(ray.squared);
    for (i = 0; i < 3; ++i) {
        /* The bias replaces the bits that the offset lost. */
        int32_t part = luminaire_times(offset->way[i] >> offset->shift, (int32_t)((ray.reciprocal + 2) >> 2));
        ray.direction[i] = luminaire_plus(part, 6144);
    }
    return ray;
}

/* Returns the squared length of a vector that is scaled up by 2^shift. */
static inline uint32_t luminaire_squared_length(const int32_t vector[3], uint32_t shift) {
    return luminaire_high_square(luminaire_shl(vector[0], shift)) + luminaire_high_square(luminaire_shl(vector[1], shift))
        + luminaire_high_square(luminaire_shl(vector[2], shift));
}

static inline luminaire_fine_ray luminaire_fine_ray_of(const luminaire_offset *offset) {
    luminaire_fine_ray ray;
    int32_t whole[3], over, coarse;
    int i;
    ray.bits = (int32_t)offset->bits;
    ray.estimate = luminaire_inverse_sqrt(luminaire_squared(offset));
    for (i = 0; i < 3; ++i) {
        whole[i] = luminaire_shl(offset->way[i], (14 - offset->shift) & 31);
        ray.direction[i] = luminaire_signed_high_product(whole[i], ray.estimate);
    }
    ray.squared = luminaire_squared_length(whole, 0);
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

static inline luminaire_gain luminaire_coarse_distance(const luminaire_coarse_ray *ray) {
    return luminaire_normalised(luminaire_high_product(ray->squared, ray->reciprocal), 45 - (int32_t)ray->bits);
}

static inline luminaire_gain luminaire_fine_distance(const luminaire_fine_ray *ray) {
    return luminaire_normalised(luminaire_fine_length(ray), 47 - ray->bits);
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
static inline uint32_t luminaire_coarse_cosine(const luminaire_coarse_ray *ray, int32_t facing) {
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
static inline uint32_t luminaire_coarse_versine(const luminaire_coarse_ray *ray, const int32_t axis[3], uint32_t zoom) {
    uint32_t shift = 16 - zoom, versine = 0;
    int32_t difference[3];
    int i;
    for (i = 0; i < 3; ++i) {
        int32_t lowered = luminaire_minus(axis[i], (int32_t)(UINT32_C(1) << (shift - 1)));
        difference[i] = luminaire_minus(ray->direction[i], lowered) >> shift;
    }
    if (luminaire_size(difference) >> 15) { return UINT32_C(0xffffffff); }
    for (i = 0; i < 3; ++i) { versine += (uint32_t)luminaire_times(difference[i], difference[i]); }
    return versine;
}

/* Returns the falloff's argument along a ray. */
static inline uint32_t luminaire_coarse_rise(
    const luminaire_coarse_ray *ray, const int32_t axis[3], const luminaire_ramp *ramp
) {
    uint32_t versine = luminaire_coarse_versine(ray, axis, ramp->zoom), past = versine - ramp->inner;
    if (past < ramp->width) { return (ramp->one - (past >> ramp->shift) * ramp->mantissa) >> 16; }
    return versine < ramp->inner ? LUMINAIRE_COARSE_ONE : 0;
}

/* Returns the excess over the inner versine at which the intensity becomes zero. */
static inline uint32_t luminaire_width(const luminaire_ramp *ramp) { return ramp->fine ? ramp->fine : ramp->width; }

/* Returns the scale of a ramp's versines: the exponent of 4. */
static inline uint32_t luminaire_zoom(const luminaire_ramp *ramp) { return luminaire_min(ramp->zoom, 15); }

/* Returns 1 - t of a versine's excess, with 31 fraction bits. */
static inline uint32_t luminaire_fallen(const luminaire_ramp *ramp, uint32_t past) {
    uint32_t shift = ramp->fine_shift & 63;
    if (shift < 32) { return luminaire_high_half(past << ((32 - shift) & 31), ramp->fine_mantissa); }
    return luminaire_high_half(past, ramp->fine_mantissa) >> (shift - 32);
}

static inline uint32_t luminaire_fine_rise(
    const luminaire_fine_ray *ray, const int32_t axis[3], const luminaire_ramp *ramp
) {
    uint32_t versine = UINT32_C(0xffffffff), past, fallen, zoom = luminaire_zoom(ramp);
    int32_t difference[3];
    int i;
    for (i = 0; i < 3; ++i) { difference[i] = luminaire_minus(ray->direction[i], axis[i]); }
    if (luminaire_size(difference) >> (31 - zoom) == 0) { versine = luminaire_squared_length(difference, zoom); }
    past = versine - ramp->inner;
    if (past >= luminaire_width(ramp)) { return versine < ramp->inner ? LUMINAIRE_FINE_ONE : 0; }
    fallen = luminaire_fallen(ramp, past);
    return fallen < LUMINAIRE_FINE_ONE ? LUMINAIRE_FINE_ONE - fallen : 0;
}

/* ---- curves ---- */

/* Returns the last knot at or before a place; the first if all are later. */
static inline luminaire_knot luminaire_knot_at(const luminaire_knot *knots, uint32_t count, uint32_t place) {
    uint32_t begin = 0, end = count;
    while (begin < end) {
        uint32_t middle = begin + ((end - begin) >> 1);
        if (knots[middle].place <= place) { begin = middle + 1; } else { end = middle; }
    }
    return knots[begin > 0 ? begin - 1 : 0];
}

/* Returns log2(significand / 2^31) with 32 fraction bits. */
static inline int64_t luminaire_logarithm(uint32_t significand) {
    uint32_t segment = (significand >> 25) & 63;
    int64_t z = ((int64_t)((uint64_t)significand * LUMINAIRE_READ_32(&luminaire_logarithms[segment][0]) - (UINT64_C(1) << 62))) >> 30;
    int64_t above = INT64_C(3098164009) - ((z * INT64_C(2065442673)) >> 32);
    above = INT64_C(6196328019) - ((z * above) >> 32);
    return (int64_t)LUMINAIRE_READ_32(&luminaire_logarithms[segment][1]) + ((z * above) >> 32);
}

/* Returns -log2 x with 32 fraction bits, for x = significand / 2^31 / 2^octaves. */
static inline uint64_t luminaire_octaves_below_one(uint32_t significand, uint32_t octaves) {
    int64_t below;
    if (octaves == 0) { return 0; }
    below = (int64_t)((uint64_t)luminaire_min(octaves, 32) << 32) - luminaire_logarithm(significand);
    if (below < 0) { return 0; }
    return below < (INT64_C(32) << 32) ? (uint64_t)below : (UINT64_C(32) << 32) - 1;
}

/* Returns a sixth of a number under 2^14, rounded towards 0, without a division. */
static inline int32_t luminaire_sixth(int32_t n) {
    int32_t sixth = (int32_t)((luminaire_magnitude(n) * 43691) >> 18);
    return n < 0 ? -sixth : sixth;
}

/* Returns 2^-octaves with 31 fraction bits. */
static inline uint64_t luminaire_power_of_two(uint64_t octaves) {
    uint64_t whole = octaves >> 32;
    uint32_t part = (uint32_t)octaves;
    int64_t x, squared, lost, middle;
    if (octaves == 0) { return UINT64_C(1) << 31; }
    if (whole > 31) { return 0; }
    x = (((int64_t)(part & ((UINT32_C(1) << 26) - 1)) - (INT64_C(1) << 25)) * INT64_C(2977044472)) >> 32;
    squared = (x * x) >> 32;
    lost = x - (squared >> 1) + luminaire_sixth((int32_t)((squared * x) >> 32));
    middle = (int64_t)LUMINAIRE_READ_32(&luminaire_powers[part >> 26]);
    return (((uint64_t)(middle - ((middle * lost) >> 32)) >> whole) + 1) >> 1;
}

/* Returns a power of a number with 31 fraction bits. */
static inline uint32_t luminaire_real_power(
    uint32_t x, uint32_t mantissa, uint32_t shift, uint32_t least, uint32_t gain
) {
    uint32_t octaves = 32 - luminaire_bit_length(x);
    uint64_t power;
    if (x == 0) { return 0; }
    power = luminaire_power_of_two((luminaire_octaves_below_one(x << octaves, octaves) * mantissa) >> shift);
    power = power > least ? ((power - least) * gain) >> 27 : 0;
    return power < LUMINAIRE_FINE_ONE ? (uint32_t)power : LUMINAIRE_FINE_ONE;
}

/* Each function of the falloff's argument has a coarse and a fine version. */

static inline uint32_t luminaire_coarse_complement(uint32_t x) { return LUMINAIRE_COARSE_ONE - x; }
static inline uint32_t luminaire_fine_complement(uint32_t x) { return LUMINAIRE_FINE_ONE - x; }

static inline uint32_t luminaire_coarse_fine_product(uint32_t a, uint32_t b) {
    return (a * b + (UINT32_C(1) << 14)) >> 15;
}

static inline uint32_t luminaire_coarse_product(uint32_t a, uint32_t b) { return (a * b + (UINT32_C(1) << 15)) >> 16; }
static inline uint32_t luminaire_fine_product(uint32_t a, uint32_t b) { return luminaire_high_half(a, b) << 1; }
static inline uint32_t luminaire_fine_fine_product(uint32_t a, uint32_t b) { return luminaire_fine_product(a, b); }
static inline uint32_t luminaire_coarse_scalar(uint32_t x) { return (x + 1) >> 1; }
static inline uint32_t luminaire_fine_scalar(uint32_t x) { return x; }

static inline uint32_t luminaire_coarse_of(uint32_t x, uint32_t share) {
    return ((x * share + (UINT32_C(1) << 14)) >> 15) & (LUMINAIRE_COARSE_ONE - 1);
}

static inline uint32_t luminaire_fine_of(uint32_t x, uint32_t share) { return luminaire_fine_product(x, share); }
static inline uint32_t luminaire_coarse_rest(uint32_t share) { return LUMINAIRE_FULL_SCALE - share; }
static inline uint32_t luminaire_fine_rest(uint32_t share) { return LUMINAIRE_FINE_ONE - share; }
static inline uint32_t luminaire_coarse_step(uint32_t x) { return x > 0 ? LUMINAIRE_FULL_SCALE : 0; }
static inline uint32_t luminaire_fine_step(uint32_t x) { return x > 0 ? LUMINAIRE_FINE_ONE : 0; }

/* Returns the product of two coarse shares, at most 1. */
static inline uint32_t luminaire_coarse_times(uint32_t a, uint32_t b) {
    return luminaire_min((a * b + (UINT32_C(1) << 13)) >> 14, LUMINAIRE_FULL_SCALE);
}

/* Rounds a product with 30 fraction bits to a share, at most 1. */
static inline uint32_t luminaire_coarse_capped(uint32_t product) {
    return luminaire_min((product + (UINT32_C(1) << 15)) >> 16, LUMINAIRE_FULL_SCALE);
}

static inline uint32_t luminaire_coarse_smooth(uint32_t x) {
    return luminaire_coarse_capped(luminaire_coarse_fine_product(x, x) * (3 * LUMINAIRE_COARSE_ONE - 2 * x));
}

static inline uint32_t luminaire_fine_smooth(uint32_t x) {
    uint32_t square = luminaire_fine_product(x, x);
    return luminaire_min(square + 2 * luminaire_fine_product(square, LUMINAIRE_FINE_ONE - x), LUMINAIRE_FINE_ONE);
}

static inline uint32_t luminaire_coarse_quadratic(uint32_t x, int32_t g) {
    int32_t product = luminaire_times((int32_t)luminaire_coarse_complement(x), g);
    int32_t lift = luminaire_plus(product, INT32_C(1) << 13) >> 14;
    /* 1 + lift, saturated. */
    uint32_t factor = LUMINAIRE_COARSE_ONE + (uint32_t)lift;
    if (lift < 0 && luminaire_magnitude(lift) > LUMINAIRE_COARSE_ONE) { factor = 0; }
    return luminaire_coarse_capped(x * factor);
}

/* Returns x (1 + (1 - x) slope) for a slope with 28 fraction bits. */
static inline uint32_t luminaire_fine_lifted(uint32_t x, int32_t slope) {
    uint32_t lift = luminaire_high_half(luminaire_fine_product(x, LUMINAIRE_FINE_ONE - x), luminaire_magnitude(slope));
    uint32_t lifted;
    lift = luminaire_min(lift, (UINT32_C(1) << 28) - 1) << 4;
    lifted = x + lift;
    if (slope < 0) { return x > lift ? luminaire_min(x - lift, LUMINAIRE_FINE_ONE) : 0; }
    return lifted < x ? LUMINAIRE_FINE_ONE : luminaire_min(lifted, LUMINAIRE_FINE_ONE);
}

static inline uint32_t luminaire_fine_quadratic(uint32_t x, int32_t g) {
    return luminaire_fine_lifted(x, luminaire_shl(g, 14));
}

static inline uint32_t luminaire_coarse_cubic(uint32_t x, int32_t g, int32_t h) {
    int32_t bend = luminaire_plus(luminaire_times((int32_t)x, h), INT32_C(1) << 14) >> 15;
    return luminaire_coarse_quadratic(x, luminaire_plus(g, bend));
}

static inline uint32_t luminaire_fine_cubic(uint32_t x, int32_t g, int32_t h) {
    int32_t slope = luminaire_shl(h, 14);
    int32_t bend = (int32_t)(luminaire_high_half(x, luminaire_magnitude(slope)) << 1);
    if (slope < 0) { bend = luminaire_minus(0, bend); }
    return luminaire_fine_lifted(x, luminaire_plus(luminaire_shl(g, 14), bend));
}

static inline uint32_t luminaire_coarse_real_power(
    uint32_t x, uint32_t mantissa, uint32_t shift, uint32_t least, uint32_t gain
) {
    return (luminaire_real_power(x << 16, mantissa, shift, least, gain) + (UINT32_C(1) << 15)) >> 16;
}

static inline uint32_t luminaire_fine_real_power(
    uint32_t x, uint32_t mantissa, uint32_t shift, uint32_t least, uint32_t gain
) {
    return luminaire_real_power(x, mantissa, shift, least, gain);
}

/* Returns a sample of 16 bits as a coarse share. */
static inline uint32_t luminaire_coarse_value(int32_t value) {
    return (uint32_t)((value + (value >> 15) + 2) >> 2);
}

static inline uint32_t luminaire_coarse_sample(uint32_t x, const uint16_t *samples, uint32_t count) {
    uint32_t place = luminaire_coarse_complement(x) * (count - 1), i = place >> 15;
    int32_t here = i < count ? samples[i] : 0, next = i + 1 < count ? samples[i + 1] : here;
    int32_t share = (int32_t)(place & (LUMINAIRE_COARSE_ONE - 1));
    return luminaire_coarse_value((luminaire_shl(here, 15) + (next - here) * share + (INT32_C(1) << 14)) >> 15);
}

/* Returns a sample of 16 bits, shifted up by 15, as a fine share. */
static inline uint32_t luminaire_fine_value(uint32_t value) {
    return luminaire_min(value + ((value + (UINT32_C(1) << 15)) >> 16), LUMINAIRE_FINE_ONE);
}

static inline uint32_t luminaire_fine_sample(uint32_t x, const uint16_t *samples, uint32_t count) {
    uint32_t last = luminaire_min(count, 65536) - 1, place = LUMINAIRE_FINE_ONE - x;
    uint32_t i = luminaire_high_product(place, last) >> 15, share = (place * last) & (LUMINAIRE_FINE_ONE - 1);
    uint32_t here = i < count ? samples[i] : 0, next = i + 1 < count ? samples[i + 1] : here;
    uint32_t step = luminaire_high_product(share, next < here ? here - next : next - here);
    return luminaire_fine_value(next < here ? (here << 15) - step : (here << 15) + step);
}

static inline uint32_t luminaire_coarse_along(uint32_t x, const luminaire_knot *knots, uint32_t count) {
    uint32_t place = luminaire_coarse_complement(x) << 1;
    luminaire_knot knot = luminaire_knot_at(knots, count, place);
    int32_t beyond = (int32_t)(place - knot.place);
    int32_t rise = luminaire_plus(luminaire_times(knot.slope, beyond), INT32_C(1) << 14) >> 15;
    int32_t value = knot.value + rise;
    return luminaire_coarse_value(value < 0 ? 0 : value > INT32_C(65535) ? INT32_C(65535) : value);
}

static inline uint32_t luminaire_fine_along(uint32_t x, const luminaire_knot *knots, uint32_t count) {
    uint32_t place = LUMINAIRE_FINE_ONE - x;
    luminaire_knot knot = luminaire_knot_at(knots, count, place >> 15);
    uint32_t beyond = place - luminaire_min((uint32_t)knot.place << 15, place), slope = luminaire_magnitude(knot.slope);
    uint32_t rise = (luminaire_high_half(beyond, slope) << 17) | ((beyond * slope) >> 15);
    uint32_t value = (uint32_t)knot.value << 15, end = UINT32_C(65535) << 15;
    if (knot.slope < 0) { return luminaire_fine_value(value > rise ? luminaire_min(value - rise, end) : 0); }
    return luminaire_fine_value(value + rise < value ? end : luminaire_min(value + rise, end));
}

/* Rounds a fine share to a coarse one. */
static inline uint32_t luminaire_rounded(uint32_t share) { return (share + (UINT32_C(1) << 16)) >> 17; }

/* ---- attenuation ---- */

/* Returns a share of a gain as light. */
static inline uint32_t luminaire_coarse_give(uint32_t share, luminaire_gain gain) {
    return luminaire_light_of(share * (gain.mantissa >> 16), gain.shift - 16);
}

static inline uint32_t luminaire_fine_give(uint32_t share, luminaire_gain gain) {
    return luminaire_light_of(luminaire_high_half(share, gain.mantissa), gain.shift - 15);
}

/* Returns a share of a gain by the inverse-square law. */
static inline uint32_t luminaire_coarse_inverse_square(
    const luminaire_coarse_ray *ray, uint32_t share, luminaire_gain gain
) {
    uint32_t mantissa = ((gain.mantissa >> 16) * ((ray->reciprocal * ray->reciprocal) >> 16)) >> 14;
    return luminaire_light_of(share * mantissa, gain.shift - 16 + 2 * (int32_t)ray->bits - 32);
}

static inline uint32_t luminaire_fine_inverse_square(
    const luminaire_fine_ray *ray, uint32_t share, luminaire_gain gain
) {
    uint32_t nearly = luminaire_high_product(luminaire_high_product(gain.mantissa, ray->estimate), ray->estimate);
    int32_t excess = luminaire_minus(luminaire_times(2, ray->excess), luminaire_times(ray->excess, ray->excess) >> 26);
    uint32_t here = nearly - (uint32_t)(luminaire_times((int32_t)(nearly >> 17), excess) >> 9);
    return luminaire_light_of(luminaire_high_half(share, here), gain.shift + 2 * ray->bits - 49);
}

/* Returns the gain at a distance by one over a polynomial, at most 1 times the intensity. */
static inline luminaire_gain luminaire_polynomial(
    luminaire_gain distance, const luminaire_gain coefficients[3], luminaire_gain intensity
) {
    luminaire_gain divisor = luminaire_gain_plus(luminaire_gain_by(coefficients[2], distance), coefficients[1]);
    divisor = luminaire_gain_plus(luminaire_gain_by(divisor, distance), coefficients[0]);
    return luminaire_gain_by(luminaire_inverse_capped(divisor), intensity);
}

/* Returns the distance times a gain, at most 1. */
static inline uint32_t luminaire_coarse_near(const luminaire_coarse_ray *ray, luminaire_gain gain) {
    return luminaire_gain_share(luminaire_gain_by(luminaire_coarse_distance(ray), gain));
}

static inline uint32_t luminaire_fine_near(const luminaire_fine_ray *ray, luminaire_gain gain) {
    return luminaire_capped(luminaire_high_half(luminaire_fine_length(ray), gain.mantissa), gain.shift - ray->bits - 16);
}

/* Returns the squared distance times a gain, at most 1. */
static inline uint32_t luminaire_coarse_squared_near(const luminaire_coarse_ray *ray, luminaire_gain gain) {
    return luminaire_gain_share(
        luminaire_gain_by(luminaire_normalised(ray->squared, 62 - 2 * (int32_t)ray->bits), gain));
}

static inline uint32_t luminaire_fine_squared_near(const luminaire_fine_ray *ray, luminaire_gain gain) {
    return luminaire_capped(luminaire_high_half(ray->squared, gain.mantissa), gain.shift - 2 * ray->bits - 1);
}

static inline uint32_t luminaire_fine_times(uint32_t a, uint32_t b) { return luminaire_fine_product(a, b); }

/* Returns t^2 (3 - 2t) of a share t. */
static inline uint32_t luminaire_coarse_smoothed(uint32_t t) {
    uint32_t square = t * t, factor = 3 * LUMINAIRE_FULL_SCALE - 2 * t;
    uint32_t product = (square >> 14) * factor + (((square & 0x3fff) * factor) >> 14);
    return (product + (UINT32_C(1) << 13)) >> 14;
}

static inline uint32_t luminaire_fine_smoothed(uint32_t t) { return luminaire_fine_smooth(t); }

/* Returns the distance to the power -mantissa / 2^shift, at most 2^(most / 2^24). */
static inline luminaire_gain luminaire_decay(luminaire_gain distance, uint32_t mantissa, uint32_t shift, int32_t most) {
    int64_t limit = (int64_t)most * 256, power = limit;
    if (distance.mantissa != 0) {
        int64_t octaves = 31 - distance.shift;
        octaves = octaves < -64 ? -64 : octaves > 63 ? 63 : octaves;
        octaves *= INT64_C(4294967296);
        /* The logarithm of a power of two is exact. */
        if (distance.mantissa << 1 != 0) { octaves += luminaire_logarithm(distance.mantissa); }
        power = (-octaves * (int64_t)mantissa) >> shift;
        power = power < limit ? power : limit;
    }
    return luminaire_normalised(
        (uint32_t)luminaire_power_of_two((uint64_t)-power & UINT32_C(0xffffffff)), 31 + (int32_t)(-power >> 32));
}

/* Returns whether light is past full scale by more than the error of its share. */
static inline int luminaire_is_clipped(uint32_t share, uint32_t light) {
    return share > (UINT32_C(1) << 9) && light > (UINT32_C(9) << 11);
}

#endif
