/* The light key, written by luminaire-export 0.1.0: do not edit.
 * A spotlight: falloff soft, full angles in degrees: beam 26.10, field 40.00, outer 48.49.
 * Lengths have the unit of the scene; light is linear, and 1 is full scale.
 * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14. */
#ifndef KEY_LIGHT_H
#define KEY_LIGHT_H 0x2842e283 /* a checksum of this text */

#include "luminaire_constant.h"

/* The linear colour, in steps of 2^-14. */
static const int16_t key_color[3] = { 16384, 16384, 16384 };
/* The light: its position and axis, the map from a versine to the falloff's argument, its edge if it is that of
 * a light that moves, its intensity, the encoded distance within which points need the fine evaluation, its colour,
 * and the squared cosine of half the outer angle, less a margin. */
static const luminaire_spot luminaire_key_Light = {
    { INT32_C(163840), INT32_C(65536), INT32_C(196608) }, { INT32_C(0), INT32_C(0), INT32_C(-1073741824) },
    { UINT32_C(2), UINT32_C(0), UINT32_C(757615552), UINT32_C(14), UINT32_C(46441), UINT32_C(2147493197), UINT32_C(0), UINT32_C(30), UINT32_C(3043552898) },
    -16384, 0, { UINT32_C(0x90000000), 28 }, UINT32_C(0x4518ad7e), { 16384, 16384, 16384 }, 13605
};

static inline uint32_t luminaire_key_CoarseCurve(uint32_t t) {
    return luminaire_coarse_product(t, t);
}

static inline uint32_t luminaire_key_FineCurve(uint32_t t) {
    return luminaire_fine_product(t, t);
}

static inline int luminaire_key_IsOutside(const luminaire_spot *spot, const luminaire_way *way, uint32_t squared) {
    return luminaire_is_outside(way, squared, spot->axis, spot->outside);
}

static inline uint32_t luminaire_key_CoarseEmitted(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    return luminaire_key_CoarseCurve(luminaire_coarse_rise(ray, spot->axis, &spot->ramp));
}

static inline uint32_t luminaire_key_FineEmitted(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    return luminaire_key_FineCurve(luminaire_fine_rise(ray, spot->axis, &spot->ramp));
}

static inline uint32_t luminaire_key_CoarseShare(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t cosine
) {
    return luminaire_coarse_of(cosine, luminaire_key_CoarseEmitted(spot, ray));
}

static inline uint32_t luminaire_key_FineShare(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t cosine
) {
    return luminaire_fine_of(cosine, luminaire_key_FineEmitted(spot, ray));
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t key_falloff(const int32_t point[3]) {
    const luminaire_spot *spot = &luminaire_key_Light;
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return (int16_t)luminaire_rounded(luminaire_key_FineEmitted(spot, &ray));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
        return (int16_t)luminaire_key_CoarseEmitted(spot, &ray);
    }
}

static inline uint32_t luminaire_key_CoarseAttenuated(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t share
) {
    return luminaire_coarse_inverse_square(ray, share, spot->intensity);
}

static inline uint32_t luminaire_key_FineAttenuated(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t share
) {
    return luminaire_fine_inverse_square(ray, share, spot->intensity);
}

/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_key_FineIrradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_offset offset = luminaire_offset_between(spot->position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    uint32_t share = luminaire_key_FineShare(spot, &ray, luminaire_fine_cosine(&ray, normal));
    return luminaire_key_FineAttenuated(spot, &ray, share);
}

/* Returns the irradiance of the light as it is, moved or not. */
static inline uint32_t luminaire_key_Irradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_way way = luminaire_way_between(spot->position, point);
    int32_t facing = luminaire_facing(&way, normal);
    uint32_t squared, share, light;
    luminaire_coarse_ray coarse;
    if (facing >= 0) {
        /* The fine evaluation has more bits of the product with the normal. */
        if (facing >= 7 << 12) { return 0; }
        if (!luminaire_is_near(&way, luminaire_squared(&way), spot->fine_below)) { return 0; }
    }
    squared = luminaire_squared(&way);
    if (luminaire_key_IsOutside(spot, &way, squared)) { return 0; }
    coarse = luminaire_coarse_ray_of(&way, squared);
    share = luminaire_key_CoarseShare(spot, &coarse, luminaire_coarse_cosine(&coarse, facing));
    light = luminaire_key_CoarseAttenuated(spot, &coarse, share);
    if (!luminaire_is_near(&way, squared, spot->fine_below)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (spot->fine_below != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(share, light)) { return light; }
    return luminaire_key_FineIrradiance(spot, point, normal);
}

/* Returns the irradiance of a surface that faces the light as it is, moved or not. */
static inline uint32_t luminaire_key_IrradianceFacing(const luminaire_spot *spot, const int32_t point[3]) {
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    luminaire_coarse_ray coarse;
    if (luminaire_key_IsOutside(spot, &way, squared)) { return 0; }
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return luminaire_key_FineAttenuated(spot, &ray, luminaire_key_FineEmitted(spot, &ray));
    }
    coarse = luminaire_coarse_ray_of(&way, squared);
    return luminaire_key_CoarseAttenuated(spot, &coarse, luminaire_key_CoarseEmitted(spot, &coarse));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t key_irradiance(const int32_t point[3], const int16_t normal[3]) {
    return luminaire_key_Irradiance(&luminaire_key_Light, point, normal);
}

/* Returns the light as one that moves. */
static inline luminaire_spot key_spot(void) {
    return luminaire_key_Light;
}

#elif KEY_LIGHT_H != 0x2842e283
#error "two lights have the name key: export one of them by another name"
#endif
