/* ---- spotlights that move: any words are defined, and a null spot is dark ---- */

/* Linear light, in steps of 2^-14 of full scale, which it may exceed. */
typedef struct {
    uint32_t red, green, blue;
} luminaire_rgb;

/* A spotlight with the inverse square of the distance. With all words zero it is dark. */
typedef struct {
    int32_t position[3];      /* steps of 2^-16 */
    int32_t axis[3];          /* of unit length, steps of 2^-30 */
    luminaire_ramp ramp;      /* the cone */
    int32_t g, h;             /* the edge t (1 + u (g + h t)), steps of 2^-14: soft -2^14, 0; hard 2^14, 0 */
    luminaire_gain intensity; /* 1 is full scale on the axis at distance 1 */
    uint32_t fine_below;      /* the points that need the fine evaluation: within an encoded distance */
    int16_t color[3];         /* linear, from 0 to 2^14 */
    int16_t outside;          /* the squared cosine of half the outer angle, less a margin, steps of 2^-14 */
} luminaire_spot;

/* Returns light times a channel of a colour; saturates. */
static inline uint32_t luminaire_filtered(uint32_t light, int16_t channel) {
    uint32_t color = channel > 0 ? (uint32_t)channel : 0, high = (light >> 16) * color;
    uint32_t low = ((light & 0xffff) * color + (UINT32_C(1) << 13)) >> 14;
    uint32_t sum = (high << 2) + low;
    return high >> 30 || sum < low ? UINT32_C(0xffffffff) : sum;
}

/* Returns the gain with a mantissa of 32 bits and a shift within reach. */
static inline luminaire_gain luminaire_sound_gain(luminaire_gain gain) {
    uint32_t up;
    if (gain.mantissa >> 31 && gain.shift >= -4096 && gain.shift <= 4096) { return gain; }
    up = gain.mantissa ? 32 - luminaire_bit_length(gain.mantissa) : 0;
    gain = luminaire_gain_of(gain.mantissa << up, gain.shift);
    gain.shift += (int32_t)up;
    return gain;
}

/* Returns the falloff's argument along a ray. Words that would give more than 1 are replaced. */
static inline uint32_t luminaire_spot_rise(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    const luminaire_ramp *ramp = &spot->ramp;
    uint32_t versine = luminaire_coarse_versine(ray, spot->axis, luminaire_zoom(ramp)), past = versine - ramp->inner;
    uint32_t width = ramp->fine ? 0 : ramp->width, shift = ramp->shift & 31, mantissa = ramp->mantissa, one, steps;
    if (past >= width) { return versine < ramp->inner ? LUMINAIRE_COARSE_ONE : 0; }
    one = luminaire_min(ramp->one, LUMINAIRE_FINE_ONE + 65535);
    steps = (width - 1) >> shift;
    if (steps * mantissa > one || ((steps | mantissa) >> 16 && luminaire_high_half(steps, mantissa))) { mantissa = 0; }
    return (one - (past >> shift) * mantissa) >> 16;
}

static inline uint32_t luminaire_spot_coarse_share(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    return luminaire_coarse_cubic(luminaire_spot_rise(spot, ray), spot->g, spot->h);
}

static inline uint32_t luminaire_spot_fine_share(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    return luminaire_fine_cubic(luminaire_fine_rise(ray, spot->axis, &spot->ramp), spot->g, spot->h);
}

static inline int luminaire_spot_is_outside(const luminaire_spot *spot, const luminaire_offset *offset) {
    return luminaire_is_outside(offset, spot->axis, spot->outside > 0 ? (uint32_t)spot->outside : 0);
}

/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_spot_near(
    const luminaire_spot *spot, const luminaire_offset *offset, int32_t facing, const int16_t normal[3]
) {
    luminaire_gain gain = luminaire_sound_gain(spot->intensity);
    luminaire_fine_ray ray;
    if (facing >= 7 << 12 || luminaire_spot_is_outside(spot, offset)) { return 0; }
    if (spot->fine_below != LUMINAIRE_ALWAYS_FINE) {
        /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
        luminaire_coarse_ray coarse = luminaire_coarse_ray_of(offset);
        uint32_t cosine = luminaire_coarse_cosine(&coarse, facing);
        uint32_t share = luminaire_coarse_of(cosine, luminaire_spot_coarse_share(spot, &coarse));
        uint32_t light = luminaire_coarse_inverse_square(&coarse, share, gain);
        if (luminaire_is_clipped(share, light)) { return light; }
    }
    ray = luminaire_fine_ray_of(offset);
    return luminaire_fine_inverse_square(
        &ray, luminaire_fine_of(luminaire_fine_cosine(&ray, normal), luminaire_spot_fine_share(spot, &ray)), gain);
}

/* Returns the irradiance at a point with a unit normal, before the colour. */
static inline uint32_t luminaire_spot_irradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_offset offset;
    luminaire_coarse_ray ray;
    int32_t facing;
    uint32_t share;
    if (!spot) { return 0; }
    offset = luminaire_offset_between(spot->position, point);
    facing = luminaire_facing(&offset, normal);
    if (luminaire_is_near(&offset, spot->fine_below)) { return luminaire_spot_near(spot, &offset, facing, normal); }
    if (facing >= 0 || luminaire_spot_is_outside(spot, &offset)) { return 0; }
    ray = luminaire_coarse_ray_of(&offset);
    share = luminaire_coarse_of(luminaire_coarse_cosine(&ray, facing), luminaire_spot_coarse_share(spot, &ray));
    return luminaire_coarse_inverse_square(&ray, share, luminaire_sound_gain(spot->intensity));
}

/* Returns the light at a point with a unit normal: the irradiance times the colour. */
static inline luminaire_rgb luminaire_spot_light(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_rgb light = { 0, 0, 0 };
    uint32_t irradiance = luminaire_spot_irradiance(spot, point, normal);
    if (irradiance) {
        light.red = luminaire_filtered(irradiance, spot->color[0]);
        light.green = luminaire_filtered(irradiance, spot->color[1]);
        light.blue = luminaire_filtered(irradiance, spot->color[2]);
    }
    return light;
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t luminaire_spot_falloff(const luminaire_spot *spot, const int32_t point[3]) {
    luminaire_offset offset;
    if (!spot) { return 0; }
    offset = luminaire_offset_between(spot->position, point);
    if (luminaire_is_near(&offset, spot->fine_below)) {
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return (int16_t)luminaire_rounded(luminaire_spot_fine_share(spot, &ray));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&offset);
        return (int16_t)luminaire_spot_coarse_share(spot, &ray);
    }
}

/* ---- changes: no part of the evaluation, so never inlined into it ---- */

/* Sets the unit vector from a point to another one. Returns 0, and sets nothing, if they are the same. */
LUMINAIRE_RARE int luminaire_unit(int32_t unit[3], const int32_t from[3], const int32_t to[3]) {
    luminaire_offset offset = luminaire_offset_between(from, to);
    luminaire_fine_ray ray;
    int i;
    if (!(offset.way[0] | offset.way[1] | offset.way[2])) { return 0; }
    ray = luminaire_fine_ray_of(&offset);
    for (i = 0; i < 3; ++i) { unit[i] = ray.direction[i]; }
    return 1;
}

/* Moves the light; its axis stays. */
static inline void luminaire_spot_move(luminaire_spot *spot, const int32_t position[3]) {
    int i;
    for (i = 0; spot && i < 3; ++i) { spot->position[i] = position[i]; }
}

/* Aims the light at a point. Returns 0, and changes nothing, if the point is the light's position. */
static inline int luminaire_spot_aim(luminaire_spot *spot, const int32_t point[3]) {
    return spot && luminaire_unit(spot->axis, spot->position, point);
}

/* Aims the light along a vector of any length. Returns 0, and changes nothing, if it is zero. */
static inline int luminaire_spot_aim_along(luminaire_spot *spot, const int32_t way[3]) {
    static const int32_t origin[3] = { 0, 0, 0 };
    return spot && luminaire_unit(spot->axis, origin, way);
}

/* Gives the light a linear colour, in steps of 2^-14 from 0 to 2^14. */
static inline void luminaire_spot_tint(luminaire_spot *spot, const int16_t color[3]) {
    int i;
    for (i = 0; spot && i < 3; ++i) { spot->color[i] = color[i]; }
}

/* Dims the light to a part of its intensity, from 0 to 2^14. */
static inline void luminaire_spot_dim(luminaire_spot *spot, int16_t part) {
    if (!spot || part >= 1 << 14) { return; }
    spot->intensity = luminaire_gain_by(
        luminaire_sound_gain(spot->intensity), luminaire_normalised(part > 0 ? (uint32_t)part : 0, 14));
}

/* Sets the unit normal along a vector of signed bytes; zero along zero. */
static inline void luminaire_normal_from_bytes(int16_t normal[3], const int8_t bytes[3]) {
    static const int32_t origin[3] = { 0, 0, 0 };
    int32_t way[3];
    int i, has_direction;
    for (i = 0; i < 3; ++i) { way[i] = luminaire_shl(bytes[i], 23); }
    has_direction = luminaire_unit(way, origin, way);
    for (i = 0; i < 3; ++i) {
        normal[i] = has_direction ? (int16_t)(luminaire_plus(way[i], INT32_C(1) << 15) >> 16) : (int16_t)0;
    }
}

/* Returns whether the light may reach points within a radius of a point, in steps of 2^-16. */
LUMINAIRE_RARE int luminaire_spot_can_reach(const luminaire_spot *spot, const int32_t center[3], int32_t radius) {
    /* The farthest light of which offsets do not wrap. */
    const uint32_t farthest = UINT32_C(32639) << 16;
    int32_t tip[3], ends = 0, squared_sine;
    uint32_t shift, reciprocal, product, size, up;
    luminaire_offset offset;
    int i;
    if (!spot) { return 0; }
    squared_sine = 16384 - 18 - spot->outside;
    if (spot->outside <= 0 || squared_sine <= 0) { return 1; }
    /* A sphere reaches the cone if its centre is in the cone whose tip is moved back along the axis, by the
     * radius over the sine of the half angle. */
    shift = (15 - luminaire_bit_length((uint32_t)squared_sine)) & 14;
    reciprocal = luminaire_inverse_sqrt((uint32_t)squared_sine << (16 + shift));
    size = radius > 0 ? (uint32_t)radius + 8 : 8;
    product = luminaire_high_product(size, reciprocal) + (size >> 13) + 1;
    up = 1 + shift / 2;
    if (product >> (29 - up)) { return 1; }
    for (i = 0; i < 3; ++i) { ends |= spot->position[i] ^ luminaire_shl(spot->position[i], 1); }
    for (i = 0; i < 3; ++i) {
        int32_t from = spot->position[i];
        int32_t back = luminaire_shl(luminaire_signed_high_half(spot->axis[i], (int32_t)(product << up)), 2);
        tip[i] = luminaire_minus(from, back);
        /* The moved tip can only be too far if the tip has a coordinate of 31 bits. */
        if (ends < 0 && ((from ^ back) & (from ^ tip[i])) < 0) { return 1; }
        if (ends < 0 && luminaire_magnitude(tip[i]) > farthest) { return 1; }
    }
    offset = luminaire_offset_between(tip, center);
    return !luminaire_spot_is_outside(spot, &offset);
}

/* ---- zoom: cones between two cones, by the chords sqrt(v) of their versines v ---- */

/* The chords with 31 fraction bits: up to which the intensity is full, where the edge would end, and from
 * which on the light is dark. */
typedef struct {
    uint32_t inner, outer, limit;
} luminaire_chords;

#define LUMINAIRE_LARGEST_CHORD UINT32_C(3037000499) /* sqrt(2), of a versine of 2 */

static inline uint32_t luminaire_less(uint32_t a, uint32_t b) { return a > b ? a - b : 0; }
static inline uint32_t luminaire_max(uint32_t a, uint32_t b) { return a > b ? a : b; }

/* Returns a sum; saturates. */
static inline uint32_t luminaire_increased(uint32_t a, int32_t b) {
    uint32_t sum = a + (uint32_t)b;
    if (b < 0) { return sum < a ? sum : 0; }
    return sum < a ? UINT32_C(0xffffffff) : sum;
}

/* Returns 2^16 sqrt(n). */
LUMINAIRE_RARE uint32_t luminaire_sqrt(uint32_t n) {
    uint32_t shift = (32 - luminaire_bit_length(n)) & 30, seed, root;
    n <<= shift;
    seed = luminaire_guess(n);
    root = luminaire_min(luminaire_high_product(n, seed), LUMINAIRE_FINE_ONE - 1) << 1;
    n -= luminaire_high_half(root, root);
    return luminaire_increased(root, luminaire_signed_high_product((int32_t)n, seed)) >> (shift / 2);
}

/* Returns 2^63 / m for m >= 2^31, rounded down; at most 2^32 - 1. */
LUMINAIRE_RARE uint32_t luminaire_inverse_of_32(uint32_t m) {
    uint32_t seed = (uint32_t)luminaire_quick_inverse(m >> 16), inverse, high, low;
    int32_t lack = (int32_t)(LUMINAIRE_FINE_ONE - luminaire_high_product(m, seed)), eighth = lack >> 3;
    uint64_t rest;
    int step;
    lack = luminaire_plus(lack, luminaire_times(eighth, eighth) >> 25);
    /* At most 3 too much, and then at most 6 too little. */
    inverse = luminaire_less(
        luminaire_increased(seed << 16, luminaire_signed_high_product(luminaire_shl(lack, 1), seed)), 3);
    high = luminaire_high_half(inverse, m);
    low = inverse * m;
    rest = (UINT64_C(1) << 63) - (((uint64_t)high << 32) | low);
    for (step = 0; step < 6; ++step) {
        if (rest >= m) {
            rest -= m;
            inverse = luminaire_increased(inverse, 1);
        }
    }
    return inverse;
}

/* Returns the chord of a versine with 29 + 2 zoom fraction bits. */
static inline uint32_t luminaire_chord(uint32_t versine, uint32_t zoom) {
    uint32_t root = luminaire_sqrt(2 * luminaire_min(versine, UINT32_C(1) << 30));
    return luminaire_min(root, LUMINAIRE_LARGEST_CHORD) >> (zoom & 15);
}

/* Returns the versine of a chord times 4^zoom, with 29 fraction bits, to the nearest. */
static inline uint32_t luminaire_versine_of(uint32_t chord, uint32_t zoom) {
    uint32_t doubled = luminaire_high_half(chord << (zoom & 15), chord << (zoom & 15));
    return (doubled >> 1) + (doubled & 1);
}

/* Returns the largest zoom up to a limit with which a chord's versine is at most 2. */
static inline uint32_t luminaire_chord_zoom(uint32_t chord, uint32_t most) {
    uint32_t zoom = luminaire_min(32 - luminaire_bit_length(chord), most) & 15;
    return chord << zoom > LUMINAIRE_LARGEST_CHORD ? luminaire_less(zoom, 1) : zoom;
}

/* Returns the chord where the edge ends, of which a ramp has the reciprocal. */
static inline uint32_t luminaire_outer_chord(const luminaire_ramp *ramp) {
    uint32_t shift = ramp->fine_shift & 63, zoom = luminaire_zoom(ramp), high, even;
    uint64_t outer = luminaire_inverse_of_32(ramp->fine_mantissa | LUMINAIRE_FINE_ONE);
    outer = ((shift > 32 ? outer << ((shift - 32) & 31) : outer >> ((32 - shift) & 63)) + ramp->inner);
    if (outer >> (30 + 2 * zoom)) { outer = UINT64_C(1) << (30 + 2 * zoom); }
    outer <<= 33 - 2 * zoom;
    high = (uint32_t)(outer >> 32);
    if (!high) { return luminaire_sqrt((uint32_t)outer) >> 16; }
    even = (luminaire_bit_length(high) + 1) & 62;
    return luminaire_min(luminaire_sqrt((uint32_t)(outer >> even)) >> (16 - even / 2), LUMINAIRE_LARGEST_CHORD);
}

LUMINAIRE_RARE luminaire_chords luminaire_chords_of(const luminaire_ramp *ramp) {
    uint32_t zoom = luminaire_zoom(ramp), width = luminaire_width(ramp), end = ramp->inner + width;
    luminaire_chords chords;
    chords.limit = luminaire_chord(end < width ? UINT32_C(0xffffffff) : end, zoom);
    chords.inner = luminaire_min(luminaire_chord(ramp->inner, zoom), chords.limit);
    chords.outer = chords.limit;
    /* Without a cutoff, t is zero at the limit, but for roundings. */
    if (width && luminaire_fallen(ramp, width) < LUMINAIRE_FINE_ONE - 4) {
        chords.outer = luminaire_max(luminaire_outer_chord(ramp), chords.limit);
    }
    return chords;
}

static inline uint32_t luminaire_between(uint32_t from, uint32_t to, uint32_t part) {
    return from <= to ? from + luminaire_high_half(to - from, part) : from - luminaire_high_half(from - to, part);
}

/* Returns the ramp of a cone with these chords. */
static inline luminaire_ramp luminaire_ramp_of(const luminaire_chords *chords) {
    luminaire_ramp ramp;
    uint32_t zoom = luminaire_chord_zoom(chords->limit, 15), wide = zoom, end, span, bits, mantissa;
    ramp.zoom = zoom;
    ramp.inner = luminaire_versine_of(chords->inner, zoom);
    end = luminaire_versine_of(chords->limit, zoom);
    if (chords->outer > chords->limit) {
        /* A cutoff may be so narrow that the outer versine is out of range in the scale of the ramp. */
        wide = luminaire_chord_zoom(chords->outer, zoom);
        span = luminaire_less(luminaire_versine_of(chords->outer, wide), luminaire_versine_of(chords->inner, wide));
    } else {
        span = luminaire_less(end, ramp.inner);
    }
    span = luminaire_max(span, 1);
    bits = luminaire_bit_length(span);
    ramp.fine_mantissa = luminaire_inverse_of_32(span << ((32 - bits) & 31));
    ramp.fine_shift = bits + 2 * (zoom - wide);
    ramp.shift = luminaire_min(luminaire_less(ramp.fine_shift, 16), 31);
    mantissa = ramp.fine_mantissa >> ((ramp.fine_shift - ramp.shift - 1) & 31);
    ramp.mantissa = (mantissa >> 1) + (mantissa & 1);
    ramp.width = luminaire_less(end, ramp.inner);
    ramp.one = LUMINAIRE_FINE_ONE + LUMINAIRE_COARSE_ONE - (ramp.mantissa - (ramp.mantissa >> ramp.shift)) / 2;
    /* The last versine before the limit must not give a negative t. */
    ramp.one = luminaire_max(ramp.one, (luminaire_less(ramp.width, 1) >> ramp.shift) * ramp.mantissa);
    ramp.inner = luminaire_min(ramp.inner, end);
    ramp.fine = 0;
    return ramp;
}

/* Gives the light a cone between its own, part 0, and that of another light, part 2^14. The rest of the
 * light stays. The lights may be the same. */
LUMINAIRE_RARE void luminaire_spot_zoom(luminaire_spot *spot, const luminaire_spot *other, int16_t part) {
    if (!spot || !other || part <= 0) { return; }
    spot->fine_below = luminaire_max(spot->fine_below, other->fine_below);
    if (part >= 1 << 14) {
        spot->ramp = other->ramp;
        spot->outside = other->outside;
    } else {
        luminaire_chords from = luminaire_chords_of(&spot->ramp), to = luminaire_chords_of(&other->ramp), chords;
        uint32_t share = (uint32_t)part << 18, cosine;
        int is_fine = spot->ramp.fine || other->ramp.fine;
        chords.limit = luminaire_between(from.limit, to.limit, share);
        chords.inner = luminaire_min(luminaire_between(from.inner, to.inner, share), chords.limit);
        chords.outer = chords.limit;
        if (from.limit < from.outer || to.limit < to.outer) {
            chords.outer = luminaire_max(luminaire_between(from.outer, to.outer, share), chords.limit);
        }
        spot->ramp = luminaire_ramp_of(&chords);
        if (is_fine) {
            spot->ramp.fine = spot->ramp.width;
            spot->ramp.width = 0;
        }
        cosine = luminaire_less(UINT32_C(1) << 30, luminaire_high_half(chords.limit, chords.limit)) << 1;
        spot->outside = (int16_t)((int32_t)(luminaire_high_half(cosine, cosine) >> 16) - 17);
    }
}
