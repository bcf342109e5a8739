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
