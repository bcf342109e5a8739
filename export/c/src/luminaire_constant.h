/* luminaire_constant.h: what constant lights need beside luminaire.h, for C99 and C++11.
 *
 * The command luminaire export --to c-fx16 writes a light as constants and functions of its own, which include this
 * file: a spotlight or a point light of any falloff and attenuation of luminaire, with the bits of its format Fx16.
 * Units are those of luminaire.h. The code is defined for all points and normals.
 *
 * Licence: MIT OR Apache-2.0, at your choice.
 */
#ifndef LUMINAIRE_CONSTANT_H
#define LUMINAIRE_CONSTANT_H

#include "luminaire.h"

/* Casts of C are the only ones that both languages have. */
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

/* 1 / c with 31 fraction bits and log2 c with 32, for the middles of 64 parts of [1, 2). */
static const uint32_t luminaire_logarithms[64][2] LUMINAIRE_TABLE = {
    { UINT32_C(2130836488), UINT32_C(48220695) },
    { UINT32_C(2098304633), UINT32_C(143550699) },
    { UINT32_C(2066751180), UINT32_C(237436253) },
    { UINT32_C(2036132644), UINT32_C(329920477) },
    { UINT32_C(2006408080), UINT32_C(421044590) },
    { UINT32_C(1977538899), UINT32_C(510848017) },
    { UINT32_C(1949488702), UINT32_C(599368495) },
    { UINT32_C(1922223125), UINT32_C(686642163) },
    { UINT32_C(1895709703), UINT32_C(772703658) },
    { UINT32_C(1869917734), UINT32_C(857586191) },
    { UINT32_C(1844818167), UINT32_C(941321628) },
    { UINT32_C(1820383490), UINT32_C(1023940559) },
    { UINT32_C(1796587627), UINT32_C(1105472367) },
    { UINT32_C(1773405851), UINT32_C(1185945290) },
    { UINT32_C(1750814694), UINT32_C(1265386481) },
    { UINT32_C(1728791868), UINT32_C(1343822060) },
    { UINT32_C(1707316192), UINT32_C(1421277169) },
    { UINT32_C(1686367527), UINT32_C(1497776018) },
    { UINT32_C(1665926709), UINT32_C(1573341930) },
    { UINT32_C(1645975491), UINT32_C(1647997388) },
    { UINT32_C(1626496491), UINT32_C(1721764068) },
    { UINT32_C(1607473140), UINT32_C(1794662886) },
    { UINT32_C(1588889636), UINT32_C(1866714024) },
    { UINT32_C(1570730897), UINT32_C(1937936969) },
    { UINT32_C(1552982525), UINT32_C(2008350545) },
    { UINT32_C(1535630765), UINT32_C(2077972941) },
    { UINT32_C(1518662469), UINT32_C(2146821738) },
    { UINT32_C(1502065065), UINT32_C(2214913940) },
    { UINT32_C(1485826524), UINT32_C(2282265995) },
    { UINT32_C(1469935331), UINT32_C(2348893820) },
    { UINT32_C(1454380460), UINT32_C(2414812824) },
    { UINT32_C(1439151345), UINT32_C(2480037932) },
    { UINT32_C(1424237860), UINT32_C(2544583599) },
    { UINT32_C(1409630292), UINT32_C(2608463835) },
    { UINT32_C(1395319325), UINT32_C(2671692221) },
    { UINT32_C(1381296015), UINT32_C(2734281925) },
    { UINT32_C(1367551776), UINT32_C(2796245722) },
    { UINT32_C(1354078359), UINT32_C(2857596005) },
    { UINT32_C(1340867839), UINT32_C(2918344806) },
    { UINT32_C(1327912594), UINT32_C(2978503803) },
    { UINT32_C(1315205296), UINT32_C(3038084339) },
    { UINT32_C(1302738895), UINT32_C(3097097433) },
    { UINT32_C(1290506605), UINT32_C(3155553791) },
    { UINT32_C(1278501893), UINT32_C(3213463820) },
    { UINT32_C(1266718465), UINT32_C(3270837638) },
    { UINT32_C(1255150260), UINT32_C(3327685082) },
    { UINT32_C(1243791434), UINT32_C(3384015725) },
    { UINT32_C(1232636354), UINT32_C(3439838878) },
    { UINT32_C(1221679586), UINT32_C(3495163602) },
    { UINT32_C(1210915890), UINT32_C(3549998721) },
    { UINT32_C(1200340205), UINT32_C(3604352825) },
    { UINT32_C(1189947649), UINT32_C(3658234277) },
    { UINT32_C(1179733506), UINT32_C(3711651229) },
    { UINT32_C(1169693221), UINT32_C(3764611620) },
    { UINT32_C(1159822392), UINT32_C(3817123189) },
    { UINT32_C(1150116765), UINT32_C(3869193478) },
    { UINT32_C(1140572228), UINT32_C(3920829844) },
    { UINT32_C(1131184802), UINT32_C(3972039458) },
    { UINT32_C(1121950641), UINT32_C(4022829316) },
    { UINT32_C(1112866020), UINT32_C(4073206244) },
    { UINT32_C(1103927337), UINT32_C(4123176902) },
    { UINT32_C(1095131103), UINT32_C(4172747791) },
    { UINT32_C(1086473940), UINT32_C(4221925255) },
    { UINT32_C(1077952576), UINT32_C(4270715492) }
};

/* 2^-c with 32 fraction bits, for the middles of 64 parts of [0, 1). */
static const uint32_t luminaire_powers[64] LUMINAIRE_TABLE = {
    UINT32_C(4271771996), UINT32_C(4225756525), UINT32_C(4180236731), UINT32_C(4135207276), UINT32_C(4090662878),
    UINT32_C(4046598312), UINT32_C(4003008408), UINT32_C(3959888054), UINT32_C(3917232192), UINT32_C(3875035819),
    UINT32_C(3833293984), UINT32_C(3792001792), UINT32_C(3751154399), UINT32_C(3710747013), UINT32_C(3670774895),
    UINT32_C(3631233356), UINT32_C(3592117759), UINT32_C(3553423514), UINT32_C(3515146082), UINT32_C(3477280975),
    UINT32_C(3439823750), UINT32_C(3402770014), UINT32_C(3366115421), UINT32_C(3329855670), UINT32_C(3293986508),
    UINT32_C(3258503729), UINT32_C(3223403170), UINT32_C(3188680714), UINT32_C(3154332287), UINT32_C(3120353861),
    UINT32_C(3086741451), UINT32_C(3053491112), UINT32_C(3020598946), UINT32_C(2988061094), UINT32_C(2955873740),
    UINT32_C(2924033107), UINT32_C(2892535461), UINT32_C(2861377107), UINT32_C(2830554390), UINT32_C(2800063696),
    UINT32_C(2769901447), UINT32_C(2740064105), UINT32_C(2710548171), UINT32_C(2681350181), UINT32_C(2652466713),
    UINT32_C(2623894376), UINT32_C(2595629821), UINT32_C(2567669730), UINT32_C(2540010826), UINT32_C(2512649863),
    UINT32_C(2485583632), UINT32_C(2458808958), UINT32_C(2432322700), UINT32_C(2406121752), UINT32_C(2380203040),
    UINT32_C(2354563524), UINT32_C(2329200197), UINT32_C(2304110083), UINT32_C(2279290240), UINT32_C(2254737756),
    UINT32_C(2230449750), UINT32_C(2206423375), UINT32_C(2182655811), UINT32_C(2159144272)
};

/* A line of a table: its start in steps of 2^-16, the value there and the slope in steps of 2^-15. */
typedef struct {
    uint16_t place, value;
    int32_t slope;
} luminaire_knot;

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

/* Returns 2^31 / m for m of 16 bits, to the nearest. */
static inline uint32_t luminaire_inverse(uint32_t m) {
    int32_t inverse = luminaire_quick_inverse(m);
    int32_t lack = (int32_t)(LUMINAIRE_FINE_ONE - (uint32_t)inverse * m);
    return (uint32_t)luminaire_plus(
        inverse, luminaire_plus(luminaire_times(inverse, lack >> 4), INT32_C(1) << 26) >> 27);
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

static inline luminaire_gain luminaire_coarse_distance(const luminaire_coarse_ray *ray) {
    return luminaire_normalised(luminaire_high_product(ray->squared, ray->reciprocal), 45 - (int32_t)ray->bits);
}

static inline luminaire_gain luminaire_fine_distance(const luminaire_fine_ray *ray) {
    return luminaire_normalised(luminaire_fine_length(ray), 47 - ray->bits);
}

/* Returns the last knot at or before a place; the first if all are later. */
static inline luminaire_knot luminaire_knot_at(const luminaire_knot *knots, uint32_t count, uint32_t place) {
    uint32_t begin = 0, end = count;
    luminaire_knot knot;
    while (begin < end) {
        uint32_t middle = begin + ((end - begin) >> 1);
        if (LUMINAIRE_READ_16(&knots[middle].place) <= place) { begin = middle + 1; } else { end = middle; }
    }
    knots += begin > 0 ? begin - 1 : 0;
    knot.place = LUMINAIRE_READ_16(&knots->place);
    knot.value = LUMINAIRE_READ_16(&knots->value);
    knot.slope = (int32_t)LUMINAIRE_READ_32((const uint32_t *)&knots->slope);
    return knot;
}

/* Returns log2(significand / 2^31) with 32 fraction bits. */
static inline int64_t luminaire_logarithm(uint32_t significand) {
    uint32_t segment = (significand >> 25) & 63;
    uint64_t product = (uint64_t)significand * LUMINAIRE_READ_32(&luminaire_logarithms[segment][0]);
    int32_t z = (int32_t)((int64_t)(product - (UINT64_C(1) << 62)) >> 30);
    int64_t above = INT64_C(3098164009) - ((z * INT64_C(2065442673)) >> 32);
    above = INT64_C(6196328019) - ((z * above) >> 32);
    above = (int64_t)((uint64_t)z * (uint64_t)above);
    return (int64_t)LUMINAIRE_READ_32(&luminaire_logarithms[segment][1]) + (above >> 32);
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

static inline uint32_t luminaire_coarse_fine_product(uint32_t a, uint32_t b) {
    return (a * b + (UINT32_C(1) << 14)) >> 15;
}

static inline uint32_t luminaire_coarse_product(uint32_t a, uint32_t b) { return (a * b + (UINT32_C(1) << 15)) >> 16; }
static inline uint32_t luminaire_fine_fine_product(uint32_t a, uint32_t b) { return luminaire_fine_product(a, b); }
static inline uint32_t luminaire_coarse_scalar(uint32_t x) { return (x + 1) >> 1; }
static inline uint32_t luminaire_fine_scalar(uint32_t x) { return x; }

static inline uint32_t luminaire_coarse_rest(uint32_t share) { return LUMINAIRE_FULL_SCALE - share; }
static inline uint32_t luminaire_fine_rest(uint32_t share) { return LUMINAIRE_FINE_ONE - share; }
static inline uint32_t luminaire_coarse_step(uint32_t x) { return x > 0 ? LUMINAIRE_FULL_SCALE : 0; }
static inline uint32_t luminaire_fine_step(uint32_t x) { return x > 0 ? LUMINAIRE_FINE_ONE : 0; }

/* Returns the product of two coarse shares, at most 1. */
static inline uint32_t luminaire_coarse_times(uint32_t a, uint32_t b) {
    return luminaire_min((a * b + (UINT32_C(1) << 13)) >> 14, LUMINAIRE_FULL_SCALE);
}

static inline uint32_t luminaire_coarse_smooth(uint32_t x) {
    return luminaire_coarse_capped(luminaire_coarse_fine_product(x, x) * (3 * LUMINAIRE_COARSE_ONE - 2 * x));
}

static inline uint32_t luminaire_fine_smooth(uint32_t x) {
    uint32_t square = luminaire_fine_product(x, x);
    return luminaire_min(square + 2 * luminaire_fine_product(square, LUMINAIRE_FINE_ONE - x), LUMINAIRE_FINE_ONE);
}

static inline uint32_t luminaire_fine_quadratic(uint32_t x, int32_t g) {
    return luminaire_fine_lifted(x, luminaire_shl(g, 14));
}

/* Two soft falloffs: a share of 14 bits of a narrow one, which ends at 1 over a gain of the versine of the edge. */
static inline uint32_t luminaire_coarse_soft_pair(uint32_t x, int32_t share, uint32_t mantissa, int32_t shift) {
    uint32_t bits = (uint32_t)(shift - 16) & 15, part = (uint32_t)share;
    uint32_t fallen = (luminaire_coarse_complement(x) * (mantissa >> 16) + (UINT32_C(1) << bits) - 1) >> bits;
    uint32_t narrow = LUMINAIRE_COARSE_ONE - luminaire_min(fallen, LUMINAIRE_COARSE_ONE);
    uint32_t sum = luminaire_coarse_fine_product(narrow, narrow) * part;
    sum += luminaire_coarse_fine_product(x, x) * (LUMINAIRE_FULL_SCALE - part);
    return luminaire_coarse_capped(sum << 1);
}

static inline uint32_t luminaire_fine_soft_pair(uint32_t x, int32_t share, uint32_t mantissa, int32_t shift) {
    uint32_t bits = (uint32_t)(31 - shift) & 31, part = (uint32_t)share << 17;
    uint32_t scaled = luminaire_min(LUMINAIRE_FINE_ONE - x, UINT32_C(0xffffffff) >> bits) << bits;
    uint32_t fallen = luminaire_min(luminaire_high_half(scaled, mantissa), UINT32_C(1) << 30) << 1;
    uint32_t narrow = LUMINAIRE_FINE_ONE - fallen;
    return luminaire_fine_product(luminaire_fine_product(narrow, narrow), part)
        + luminaire_fine_product(luminaire_fine_product(x, x), LUMINAIRE_FINE_ONE - part);
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
    int32_t here = i < count ? LUMINAIRE_READ_16(&samples[i]) : 0;
    int32_t next = i + 1 < count ? LUMINAIRE_READ_16(&samples[i + 1]) : here;
    int32_t share = (int32_t)(place & (LUMINAIRE_COARSE_ONE - 1));
    int32_t value = luminaire_plus(luminaire_shl(here, 15), (next - here) * share);
    return luminaire_coarse_value(luminaire_plus(value, INT32_C(1) << 14) >> 15);
}

/* Returns a sample of 16 bits, shifted up by 15, as a fine share. */
static inline uint32_t luminaire_fine_value(uint32_t value) {
    return luminaire_min(value + ((value + (UINT32_C(1) << 15)) >> 16), LUMINAIRE_FINE_ONE);
}

static inline uint32_t luminaire_fine_sample(uint32_t x, const uint16_t *samples, uint32_t count) {
    uint32_t last = luminaire_min(count, 65536) - 1, place = LUMINAIRE_FINE_ONE - x;
    uint32_t i = luminaire_high_product(place, last) >> 15, share = (place * last) & (LUMINAIRE_FINE_ONE - 1);
    uint32_t here = i < count ? LUMINAIRE_READ_16(&samples[i]) : 0;
    uint32_t next = i + 1 < count ? LUMINAIRE_READ_16(&samples[i + 1]) : here;
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

/* Returns a share of a gain as light. */
static inline uint32_t luminaire_coarse_give(uint32_t share, luminaire_gain gain) {
    return luminaire_light_of(share * (gain.mantissa >> 16), gain.shift - 16);
}

static inline uint32_t luminaire_fine_give(uint32_t share, luminaire_gain gain) {
    return luminaire_light_of(luminaire_high_half(share, gain.mantissa), gain.shift - 15);
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
    return luminaire_capped(
        luminaire_high_half(luminaire_fine_length(ray), gain.mantissa), gain.shift - ray->bits - 16);
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

/* ---- lights that are not round: a table over all directions ---- */

/* A light of a luminaire_distribution. Its spot has what it shares with a spotlight: it is moved, dimmed and tinted by
 * luminaire_spot_move, _dim and _tint. Its cone is not used. */
typedef struct {
    luminaire_spot spot;
    int32_t side[3], front[3]; /* of unit length and orthogonal to the axis, steps of 2^-30 */
} luminaire_measured;

/* Samples on an octahedron that is unfolded to a square, row by row: 65,535 is full intensity. A half of a side has
 * 2^fineness cells. The square is whole, or of y >= 0 alone (one fold), or of x >= 0, too (two folds). */
typedef struct {
    const uint16_t *samples;
    uint32_t fineness, folds;
} luminaire_distribution;

/* A cell: how far a place is from its first corner, and the samples at its corners, row by row. */
typedef struct {
    uint32_t x, y;
    int32_t samples[2][2];
} luminaire_cell;

/* Returns the light of its first member. */
static inline const luminaire_measured *luminaire_measured_of(const luminaire_spot *spot) {
    return (const luminaire_measured *)(const void *)spot;
}

/* Returns the cell of a direction, from the magnitudes of its places along side and front, of which 1 is 2^bits. */
LUMINAIRE_STAGE luminaire_cell luminaire_cell_at(
    const luminaire_distribution *table, const int32_t along[3], uint32_t x, uint32_t y, uint32_t bits
) {
    uint32_t one = UINT32_C(1) << bits, half = UINT32_C(1) << table->fineness, shift = bits - table->fineness;
    uint32_t columns = (table->folds < 2 ? 2 * half : half) + 1, rows = (table->folds < 1 ? 2 * half : half) + 1;
    luminaire_cell cell;
    if (along[2] < 0) {
        uint32_t behind = one - y;
        y = one - x;
        x = behind;
    }
    if (table->folds < 2) { x = along[0] < 0 ? one - x : one + x; }
    if (table->folds < 1) { y = along[1] < 0 ? one - y : one + y; }
    uint32_t column = luminaire_min(x >> shift, columns - 2), row = luminaire_min(y >> shift, rows - 2);
    const uint16_t *first = table->samples + (row * columns + column);
    cell.x = x - (column << shift);
    cell.y = y - (row << shift);
    for (uint32_t i = 0; i < 4; ++i) {
        cell.samples[i >> 1][i & 1] = (int32_t)LUMINAIRE_READ_16(&first[(i >> 1) * columns + (i & 1)]);
    }
    return cell;
}

/* Returns 2^16 / s for s from 1 to sqrt(3) with 15 fraction bits: a quadratic and a step of Newton. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_inverse_sum(uint32_t sum) {
    uint32_t guess = 74694 - ((sum * (55677 - ((sum * 13585) >> 15))) >> 15);
    uint32_t rest = (27924 - ((sum * guess) << 1) + (UINT32_C(1) << 14)) >> 15;
    return (guess * rest + (UINT32_C(1) << 14)) >> 15;
}

/* Returns 2^31 / s for s with 28 fraction bits. */
static inline uint32_t luminaire_fine_inverse_sum(uint32_t sum) {
    uint32_t nearly = luminaire_coarse_inverse_sum((sum + (UINT32_C(1) << 12)) >> 13) << 15;
    int32_t lack = (int32_t)((UINT32_C(1) << 30) - luminaire_high_half(sum << 3, nearly));
    return nearly + (uint32_t)(luminaire_times((int32_t)(nearly >> 16), lack) >> 14);
}

/* Returns the component of a direction along an axis with 30 fraction bits. */
LUMINAIRE_STAGE int32_t luminaire_coarse_component(int32_t x, int32_t y, int32_t z, const int32_t axis[3]) {
    const int32_t half = INT32_C(1) << 14;
    int32_t sum = luminaire_times(x, luminaire_plus(axis[0], half) >> 15);
    sum = luminaire_plus(sum, luminaire_times(y, luminaire_plus(axis[1], half) >> 15));
    return luminaire_plus(sum, luminaire_times(z, luminaire_plus(axis[2], half) >> 15));
}

static inline int32_t luminaire_fine_component(const int32_t direction[3], const int32_t axis[3]) {
    int32_t sum = 1; /* The three products are rounded down by half a unit each in the mean. */
    for (int i = 0; i < 3; ++i) { sum = luminaire_plus(sum, luminaire_signed_high_half(direction[i], axis[i])); }
    return sum;
}

/* Returns a magnitude times an inverse sum, at most 1. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_place(uint32_t size, uint32_t inverse) {
    uint32_t rounded = (size + (UINT32_C(1) << 14)) >> 15;
    return luminaire_min((rounded * inverse + LUMINAIRE_COARSE_ONE) >> 16, LUMINAIRE_COARSE_ONE);
}

static inline uint32_t luminaire_fine_place(uint32_t size, uint32_t inverse) {
    return luminaire_min(luminaire_high_half(size << 3, inverse), UINT32_C(1) << 30);
}

/* Returns the value between two samples at a share of 2^bits. */
LUMINAIRE_STAGE int32_t luminaire_coarse_between(int32_t from, int32_t to, uint32_t share, uint32_t bits) {
    return from + (((to - from) * (int32_t)share + (INT32_C(1) << (bits - 1))) >> bits);
}

/* Returns the intensity of a distribution along a ray. */
LUMINAIRE_STAGE uint32_t luminaire_coarse_distributed(
    const luminaire_coarse_ray *ray, const luminaire_measured *light, const luminaire_distribution *table
) {
    /* The bias of the direction replaces the bits that the way lost; half a step rounds it. */
    const int32_t bias = 6144 + (INT32_C(1) << 14);
    int32_t x = luminaire_plus(ray->x, bias) >> 15, y = luminaire_plus(ray->y, bias) >> 15;
    int32_t z = luminaire_plus(ray->z, bias) >> 15;
    int32_t along[3];
    along[0] = luminaire_coarse_component(x, y, z, light->side);
    along[1] = luminaire_coarse_component(x, y, z, light->front);
    along[2] = luminaire_coarse_component(x, y, z, light->spot.axis);
    uint32_t a = luminaire_magnitude(along[0]), b = luminaire_magnitude(along[1]);
    uint32_t sum = (a + b + luminaire_magnitude(along[2]) + (UINT32_C(1) << 14)) >> 15;
    uint32_t inverse = luminaire_coarse_inverse_sum(sum), bits = 15 - table->fineness;
    luminaire_cell cell = luminaire_cell_at(
        table, along, luminaire_coarse_place(a, inverse), luminaire_coarse_place(b, inverse), 15);
    int32_t near = luminaire_coarse_between(cell.samples[0][0], cell.samples[0][1], cell.x, bits);
    int32_t far = luminaire_coarse_between(cell.samples[1][0], cell.samples[1][1], cell.x, bits);
    return luminaire_coarse_value(luminaire_coarse_between(near, far, cell.y, bits));
}

static inline uint32_t luminaire_fine_distributed(
    const luminaire_fine_ray *ray, const luminaire_measured *light, const luminaire_distribution *table
) {
    int32_t along[3];
    along[0] = luminaire_fine_component(ray->direction, light->side);
    along[1] = luminaire_fine_component(ray->direction, light->front);
    along[2] = luminaire_fine_component(ray->direction, light->spot.axis);
    uint32_t a = luminaire_magnitude(along[0]), b = luminaire_magnitude(along[1]), lines[2];
    uint32_t inverse = luminaire_fine_inverse_sum(a + b + luminaire_magnitude(along[2]));
    luminaire_cell cell =
        luminaire_cell_at(table, along, luminaire_fine_place(a, inverse), luminaire_fine_place(b, inverse), 30);
    uint32_t up = 1 + table->fineness;
    for (int i = 0; i < 2; ++i) {
        uint32_t from = (uint32_t)cell.samples[i][0], to = (uint32_t)cell.samples[i][1];
        uint32_t step = luminaire_high_product(cell.x << up, to < from ? from - to : to - from);
        lines[i] = to < from ? (from << 15) - step : (from << 15) + step;
    }
    uint32_t near = lines[0], far = lines[1];
    uint32_t step = luminaire_high_half(cell.y << up, (far < near ? near - far : far - near) << 1);
    return luminaire_fine_value(far < near ? near - step : near + step);
}

/* Sets a vector along the cross product of two unit vectors. */
static inline void luminaire_cross(int32_t cross[3], const int32_t a[3], const int32_t b[3]) {
    for (int i = 0; i < 3; ++i) {
        int j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        cross[i] = luminaire_minus(luminaire_signed_high_half(a[j], b[k]), luminaire_signed_high_half(a[k], b[j]));
    }
}

/* Sets the axis, and the side that is orthogonal to it and nearest to a vector. Returns 0, and changes nothing, if the two
 * have one direction. */
LUMINAIRE_RARE int luminaire_measured_set_frame(
    luminaire_measured *light, const int32_t axis[3], const int32_t side[3]
) {
    int32_t way[3], front[3], across[3];
    luminaire_cross(way, side, axis);
    if (!luminaire_unit(front, luminaire_origin, way)) { return 0; }
    luminaire_cross(way, axis, front);
    if (!luminaire_unit(across, luminaire_origin, way)) { return 0; }
    for (int i = 0; i < 3; ++i) {
        light->spot.axis[i] = axis[i];
        light->front[i] = front[i];
        light->side[i] = across[i];
    }
    return 1;
}

/* Aims the light at a point; its side turns as little as possible. Returns 0, and changes nothing, if the point is the
 * light's position or along the side. */
static inline int luminaire_measured_aim(luminaire_measured *light, const int32_t point[3]) {
    int32_t axis[3];
    if (!light || !point || !luminaire_unit(axis, light->spot.position, point)) { return 0; }
    return luminaire_measured_set_frame(light, axis, light->side);
}

/* Aims the light along a vector of any length. Returns 0, and changes nothing, if it is zero or along the side. */
static inline int luminaire_measured_aim_along(luminaire_measured *light, const int32_t way[3]) {
    int32_t axis[3];
    if (!light || !way || !luminaire_unit(axis, luminaire_origin, way)) { return 0; }
    return luminaire_measured_set_frame(light, axis, light->side);
}

/* Turns the light about its axis until its side is nearest to a vector of any length. Returns 0, and changes nothing, if
 * the vector is zero or along the axis. */
static inline int luminaire_measured_turn(luminaire_measured *light, const int32_t side[3]) {
    int32_t own[3];
    if (!light || !side || !luminaire_unit(own, luminaire_origin, side)) { return 0; }
    return luminaire_measured_set_frame(light, light->spot.axis, own);
}

/* ---- rows in the light of a falloff and an attenuation of its own ---- */

typedef uint32_t (*luminaire_lit)(const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]);

/* Adds the light of a light, by the function that evaluates it, to each pixel of a row. */
static inline void luminaire_row_add_by(
    luminaire_rgb *lights, const luminaire_row *row, const luminaire_spot *spot, luminaire_lit by, uint32_t count
) {
    uint32_t i = luminaire_row_skipped(row, spot, 0, count, 0);
    uint32_t end = luminaire_min(count - luminaire_row_skipped(row, spot, count - 1, count - i, 1), count);
    int32_t point[3];
    luminaire_row_point(point, row, i);
    for (; i < end; ++i) {
        luminaire_add(&lights[i], by(spot, point, row->normal), spot->color);
        for (int k = 0; k < 3; ++k) { point[k] = luminaire_plus(point[k], row->step[k]); }
    }
}

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
