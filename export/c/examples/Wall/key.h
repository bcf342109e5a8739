/* The light key, written by luminaire-export 0.1.0: do not edit.
 * A spotlight: falloff soft, full angles in degrees: beam 26.10, field 40.00, outer 48.49.
 * Lengths have the unit of the scene; light is linear, and 1 is full scale.
 * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14. */
#ifndef KEY_LIGHT_H
#define KEY_LIGHT_H 0x9e266488 /* a checksum of this text */

#include "luminaire_constant.h"

/* The position, in steps of 2^-16. */
static const int32_t luminaire_key_Position[3] = { INT32_C(163840), INT32_C(65536), INT32_C(196608) };
/* The linear colour, in steps of 2^-14. */
static const int16_t key_color[3] = { 16384, 16384, 16384 };
/* The intensity. */
static const luminaire_gain luminaire_key_Intensity = { UINT32_C(0x90000000), 28 };
/* The points that need the fine evaluation: within an encoded distance. */
static const uint32_t luminaire_key_FineBelow = UINT32_C(0x4518ad7e);
/* The axis, in steps of 2^-30. */
static const int32_t luminaire_key_Axis[3] = { INT32_C(0), INT32_C(0), INT32_C(-1073741824) };
/* The map from a versine to the falloff's argument. */
static const luminaire_ramp luminaire_key_Ramp = { UINT32_C(2), UINT32_C(0), UINT32_C(757615552), UINT32_C(14), UINT32_C(46441), UINT32_C(2147493197), UINT32_C(0), UINT32_C(30), UINT32_C(3043552898) };
/* The squared cosine of half the outer angle, less a margin. */
static const int32_t luminaire_key_Outside = 13605;

static inline uint32_t luminaire_key_CoarseCurve(uint32_t t) {
    return luminaire_coarse_product(t, t);
}

static inline uint32_t luminaire_key_FineCurve(uint32_t t) {
    return luminaire_fine_product(t, t);
}

static inline int luminaire_key_IsOutside(const luminaire_way *way, uint32_t squared) {
    return luminaire_is_outside(way, squared, luminaire_key_Axis, luminaire_key_Outside);
}

static inline uint32_t luminaire_key_CoarseShare(const luminaire_coarse_ray *ray, uint32_t cosine) {
    uint32_t rise = luminaire_coarse_rise(ray, luminaire_key_Axis, &luminaire_key_Ramp);
    return luminaire_coarse_of(cosine, luminaire_key_CoarseCurve(rise));
}

static inline uint32_t luminaire_key_FineShare(const luminaire_fine_ray *ray, uint32_t cosine) {
    uint32_t rise = luminaire_fine_rise(ray, luminaire_key_Axis, &luminaire_key_Ramp);
    return luminaire_fine_of(cosine, luminaire_key_FineCurve(rise));
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t key_falloff(const int32_t point[3]) {
    luminaire_way way = luminaire_way_between(luminaire_key_Position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_near(&way, squared, luminaire_key_FineBelow)) {
        luminaire_offset offset = luminaire_offset_between(luminaire_key_Position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        uint32_t rise = luminaire_fine_rise(&ray, luminaire_key_Axis, &luminaire_key_Ramp);
        return (int16_t)luminaire_rounded(luminaire_key_FineCurve(rise));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
        uint32_t rise = luminaire_coarse_rise(&ray, luminaire_key_Axis, &luminaire_key_Ramp);
        return (int16_t)luminaire_key_CoarseCurve(rise);
    }
}

static inline uint32_t luminaire_key_CoarseAttenuated(const luminaire_coarse_ray *ray, uint32_t share) {
    return luminaire_coarse_inverse_square(ray, share, luminaire_key_Intensity);
}

static inline uint32_t luminaire_key_FineAttenuated(const luminaire_fine_ray *ray, uint32_t share) {
    return luminaire_fine_inverse_square(ray, share, luminaire_key_Intensity);
}

/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_key_FineIrradiance(const int32_t point[3], const int16_t normal[3]) {
    luminaire_offset offset = luminaire_offset_between(luminaire_key_Position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    return luminaire_key_FineAttenuated(&ray, luminaire_key_FineShare(&ray, luminaire_fine_cosine(&ray, normal)));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t key_irradiance(const int32_t point[3], const int16_t normal[3]) {
    luminaire_way way = luminaire_way_between(luminaire_key_Position, point);
    int32_t facing = luminaire_facing(&way, normal);
    uint32_t squared, share, light;
    luminaire_coarse_ray coarse;
    if (facing >= 0) {
        /* The fine evaluation has more bits of the product with the normal. */
        if (facing >= 7 << 12) { return 0; }
        if (!luminaire_is_near(&way, luminaire_squared(&way), luminaire_key_FineBelow)) { return 0; }
    }
    squared = luminaire_squared(&way);
    if (luminaire_key_IsOutside(&way, squared)) { return 0; }
    coarse = luminaire_coarse_ray_of(&way, squared);
    share = luminaire_key_CoarseShare(&coarse, luminaire_coarse_cosine(&coarse, facing));
    light = luminaire_key_CoarseAttenuated(&coarse, share);
    if (!luminaire_is_near(&way, squared, luminaire_key_FineBelow)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (luminaire_key_FineBelow != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(share, light)) { return light; }
    return luminaire_key_FineIrradiance(point, normal);
}

/* Returns the light as one that moves. */
static inline luminaire_spot key_spot(void) {
    luminaire_spot spot = {
        { luminaire_key_Position[0], luminaire_key_Position[1], luminaire_key_Position[2] }, { luminaire_key_Axis[0], luminaire_key_Axis[1], luminaire_key_Axis[2] }, { UINT32_C(2), UINT32_C(0), UINT32_C(757615552), UINT32_C(14), UINT32_C(46441), UINT32_C(2147493197), UINT32_C(0), UINT32_C(30), UINT32_C(3043552898) },
        -16384, 0, { UINT32_C(0x90000000), 28 }, luminaire_key_FineBelow, { key_color[0], key_color[1], key_color[2] }, luminaire_key_Outside
    };
    return spot;
}

#elif KEY_LIGHT_H != 0x9e266488
#error "two lights have the name key: export one of them by another name"
#endif
