/* The light key, written by luminaire-export 0.1.0: do not edit.
 * A spotlight: falloff soft, full angles in degrees: beam 19.43, field 29.73, outer 36.00.
 * Lengths have the unit of the scene; light is linear, and 1 is full scale.
 * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14. */
#ifndef KEY_LIGHT_H
#define KEY_LIGHT_H 0x61cf0136 /* a checksum of this text */

#include "luminaire_constant.h"

/* The linear colour, in steps of 2^-14. */
static const int16_t key_color[3] = { 16384, 9830, 3277 };
/* The light: its position and axis, the map from a versine to the falloff's argument, its edge if it is that of
 * a light that moves, its intensity, the encoded distance within which points need the fine evaluation, its colour,
 * and the squared cosine of half the outer angle, less a margin. */
static const luminaire_spot luminaire_key_Light = {
    { INT32_C(-98304), INT32_C(262144), INT32_C(65536) }, { INT32_C(367092704), INT32_C(-978913920), INT32_C(-244728480) },
    { UINT32_C(2), UINT32_C(0), UINT32_C(420421376), UINT32_C(13), UINT32_C(41844), UINT32_C(2147495497), UINT32_C(0), UINT32_C(29), UINT32_C(2742299917) },
    -16384, 0, { UINT32_C(0x80000000), 27 }, UINT32_C(0x4618268c), { 16384, 9830, 3277 }, 14803
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

#elif KEY_LIGHT_H != 0x61cf0136
#error "two lights have the name key: export one of them by another name"
#endif

/* The light back, written by luminaire-export 0.1.0: do not edit.
 * A spotlight: falloff soft, full angles in degrees: beam 26.91, field 41.24, outer 50.00.
 * Lengths have the unit of the scene; light is linear, and 1 is full scale.
 * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14. */
#ifndef BACK_LIGHT_H
#define BACK_LIGHT_H 0xc7356cbf /* a checksum of this text */

#include "luminaire_constant.h"

/* The linear colour, in steps of 2^-14. */
static const int16_t back_color[3] = { 1638, 5734, 16384 };
/* The light: its position and axis, the map from a versine to the falloff's argument, its edge if it is that of
 * a light that moves, its intensity, the encoded distance within which points need the fine evaluation, its colour,
 * and the squared cosine of half the outer angle, less a margin. */
static const luminaire_spot luminaire_back_Light = {
    { INT32_C(98304), INT32_C(196608), INT32_C(-131072) }, { INT32_C(-412435648), INT32_C(-824871296), INT32_C(549914176) },
    { UINT32_C(2), UINT32_C(0), UINT32_C(804810048), UINT32_C(14), UINT32_C(43718), UINT32_C(2147494558), UINT32_C(0), UINT32_C(30), UINT32_C(2865077312) },
    -16384, 0, { UINT32_C(0x90000000), 28 }, UINT32_C(0x4516dd48), { 1638, 5734, 16384 }, 13442
};

static inline uint32_t luminaire_back_CoarseCurve(uint32_t t) {
    return luminaire_coarse_product(t, t);
}

static inline uint32_t luminaire_back_FineCurve(uint32_t t) {
    return luminaire_fine_product(t, t);
}

static inline int luminaire_back_IsOutside(const luminaire_spot *spot, const luminaire_way *way, uint32_t squared) {
    return luminaire_is_outside(way, squared, spot->axis, spot->outside);
}

static inline uint32_t luminaire_back_CoarseEmitted(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    return luminaire_back_CoarseCurve(luminaire_coarse_rise(ray, spot->axis, &spot->ramp));
}

static inline uint32_t luminaire_back_FineEmitted(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    return luminaire_back_FineCurve(luminaire_fine_rise(ray, spot->axis, &spot->ramp));
}

static inline uint32_t luminaire_back_CoarseShare(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t cosine
) {
    return luminaire_coarse_of(cosine, luminaire_back_CoarseEmitted(spot, ray));
}

static inline uint32_t luminaire_back_FineShare(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t cosine
) {
    return luminaire_fine_of(cosine, luminaire_back_FineEmitted(spot, ray));
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t back_falloff(const int32_t point[3]) {
    const luminaire_spot *spot = &luminaire_back_Light;
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return (int16_t)luminaire_rounded(luminaire_back_FineEmitted(spot, &ray));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
        return (int16_t)luminaire_back_CoarseEmitted(spot, &ray);
    }
}

static inline uint32_t luminaire_back_CoarseAttenuated(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t share
) {
    return luminaire_coarse_inverse_square(ray, share, spot->intensity);
}

static inline uint32_t luminaire_back_FineAttenuated(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t share
) {
    return luminaire_fine_inverse_square(ray, share, spot->intensity);
}

/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_back_FineIrradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_offset offset = luminaire_offset_between(spot->position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    uint32_t share = luminaire_back_FineShare(spot, &ray, luminaire_fine_cosine(&ray, normal));
    return luminaire_back_FineAttenuated(spot, &ray, share);
}

/* Returns the irradiance of the light as it is, moved or not. */
static inline uint32_t luminaire_back_Irradiance(
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
    if (luminaire_back_IsOutside(spot, &way, squared)) { return 0; }
    coarse = luminaire_coarse_ray_of(&way, squared);
    share = luminaire_back_CoarseShare(spot, &coarse, luminaire_coarse_cosine(&coarse, facing));
    light = luminaire_back_CoarseAttenuated(spot, &coarse, share);
    if (!luminaire_is_near(&way, squared, spot->fine_below)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (spot->fine_below != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(share, light)) { return light; }
    return luminaire_back_FineIrradiance(spot, point, normal);
}

/* Returns the irradiance of a surface that faces the light as it is, moved or not. */
static inline uint32_t luminaire_back_IrradianceFacing(const luminaire_spot *spot, const int32_t point[3]) {
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    luminaire_coarse_ray coarse;
    if (luminaire_back_IsOutside(spot, &way, squared)) { return 0; }
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return luminaire_back_FineAttenuated(spot, &ray, luminaire_back_FineEmitted(spot, &ray));
    }
    coarse = luminaire_coarse_ray_of(&way, squared);
    return luminaire_back_CoarseAttenuated(spot, &coarse, luminaire_back_CoarseEmitted(spot, &coarse));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t back_irradiance(const int32_t point[3], const int16_t normal[3]) {
    return luminaire_back_Irradiance(&luminaire_back_Light, point, normal);
}

/* Returns the light as one that moves. */
static inline luminaire_spot back_spot(void) {
    return luminaire_back_Light;
}

#elif BACK_LIGHT_H != 0xc7356cbf
#error "two lights have the name back: export one of them by another name"
#endif

/* The light lantern, written by luminaire-export 0.1.0: do not edit.
 * Lengths have the unit of the scene; light is linear, and 1 is full scale.
 * A point has steps of 2^-16; a normal, the falloff and the irradiance have steps of 2^-14. */
#ifndef LANTERN_LIGHT_H
#define LANTERN_LIGHT_H 0x10d9028a /* a checksum of this text */

#include "luminaire_constant.h"

/* The linear colour, in steps of 2^-14. */
static const int16_t lantern_color[3] = { 16384, 1638, 819 };
/* The light: its position and axis, the map from a versine to the falloff's argument, its edge if it is that of
 * a light that moves, its intensity, the encoded distance within which points need the fine evaluation, its colour,
 * and the squared cosine of half the outer angle, less a margin. */
static const luminaire_spot luminaire_lantern_Light = {
    { INT32_C(49152), INT32_C(32768), INT32_C(-32768) }, { INT32_C(0), INT32_C(0), INT32_C(0) },
    { UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0) },
    0, 0, { UINT32_C(0xf5c28f00), 36 }, UINT32_C(0x33d47f34), { 16384, 1638, 819 }, 0
};

static inline int luminaire_lantern_IsOutside(const luminaire_spot *spot, const luminaire_way *way, uint32_t squared) {
    (void)spot;
    (void)way;
    (void)squared;
    return 0;
}

/* A point at the light itself has no direction, and no light. */
static inline uint32_t luminaire_lantern_CoarseEmitted(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    (void)spot;
    return ray->reciprocal ? LUMINAIRE_FULL_SCALE : 0;
}

static inline uint32_t luminaire_lantern_FineEmitted(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    (void)spot;
    return ray->estimate ? LUMINAIRE_FINE_ONE : 0;
}

static inline uint32_t luminaire_lantern_CoarseShare(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t cosine
) {
    (void)spot;
    (void)ray;
    return luminaire_coarse_scalar(cosine);
}

static inline uint32_t luminaire_lantern_FineShare(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t cosine
) {
    (void)spot;
    (void)ray;
    return luminaire_fine_scalar(cosine);
}

static inline uint32_t luminaire_lantern_CoarseAttenuated(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t share
) {
    return luminaire_coarse_inverse_square(ray, share, spot->intensity);
}

static inline uint32_t luminaire_lantern_FineAttenuated(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t share
) {
    return luminaire_fine_inverse_square(ray, share, spot->intensity);
}

/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_lantern_FineIrradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_offset offset = luminaire_offset_between(spot->position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    uint32_t share = luminaire_lantern_FineShare(spot, &ray, luminaire_fine_cosine(&ray, normal));
    return luminaire_lantern_FineAttenuated(spot, &ray, share);
}

/* Returns the irradiance of the light as it is, moved or not. */
static inline uint32_t luminaire_lantern_Irradiance(
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
    if (luminaire_lantern_IsOutside(spot, &way, squared)) { return 0; }
    coarse = luminaire_coarse_ray_of(&way, squared);
    share = luminaire_lantern_CoarseShare(spot, &coarse, luminaire_coarse_cosine(&coarse, facing));
    light = luminaire_lantern_CoarseAttenuated(spot, &coarse, share);
    if (!luminaire_is_near(&way, squared, spot->fine_below)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (spot->fine_below != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(share, light)) { return light; }
    return luminaire_lantern_FineIrradiance(spot, point, normal);
}

/* Returns the irradiance of a surface that faces the light as it is, moved or not. */
static inline uint32_t luminaire_lantern_IrradianceFacing(const luminaire_spot *spot, const int32_t point[3]) {
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    luminaire_coarse_ray coarse;
    if (luminaire_lantern_IsOutside(spot, &way, squared)) { return 0; }
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return luminaire_lantern_FineAttenuated(spot, &ray, luminaire_lantern_FineEmitted(spot, &ray));
    }
    coarse = luminaire_coarse_ray_of(&way, squared);
    return luminaire_lantern_CoarseAttenuated(spot, &coarse, luminaire_lantern_CoarseEmitted(spot, &coarse));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t lantern_irradiance(const int32_t point[3], const int16_t normal[3]) {
    return luminaire_lantern_Irradiance(&luminaire_lantern_Light, point, normal);
}

#elif LANTERN_LIGHT_H != 0x10d9028a
#error "two lights have the name lantern: export one of them by another name"
#endif

/* The lights of the scene stage together. */
#ifndef STAGE_SCENE_H
#define STAGE_SCENE_H 0xbe3e2a98 /* a checksum of this text */

#include "luminaire_constant.h"

/* The lights by their names. A luminaire_spot changes by luminaire_spot_move, _aim, _aim_along, _zoom, _dim and _tint, a
 * luminaire_directional by luminaire_directional_aim_along, _dim and _tint, and a luminaire_measured by
 * luminaire_measured_aim, _aim_along and _turn, and by luminaire_spot_move, _dim and _tint of its spot. stage_light and
 * stage_row_add know the falloff and the attenuation of each light; the functions of luminaire.h light by the inverse
 * square alone. */
typedef struct {
    luminaire_spot key;
    luminaire_spot back;
    luminaire_spot lantern;
    luminaire_rgb ambient; /* the same at every point and normal */
} stage_scene;

/* The lights as they were described, which a program copies to change them. */
static const stage_scene stage_start = {
    {
        { INT32_C(-98304), INT32_C(262144), INT32_C(65536) }, { INT32_C(367092704), INT32_C(-978913920), INT32_C(-244728480) },
        { UINT32_C(2), UINT32_C(0), UINT32_C(420421376), UINT32_C(13), UINT32_C(41844), UINT32_C(2147495497), UINT32_C(0), UINT32_C(29), UINT32_C(2742299917) },
        -16384, 0, { UINT32_C(0x80000000), 27 }, UINT32_C(0x4618268c), { 16384, 9830, 3277 }, 14803
    },
    {
        { INT32_C(98304), INT32_C(196608), INT32_C(-131072) }, { INT32_C(-412435648), INT32_C(-824871296), INT32_C(549914176) },
        { UINT32_C(2), UINT32_C(0), UINT32_C(804810048), UINT32_C(14), UINT32_C(43718), UINT32_C(2147494558), UINT32_C(0), UINT32_C(30), UINT32_C(2865077312) },
        -16384, 0, { UINT32_C(0x90000000), 28 }, UINT32_C(0x4516dd48), { 1638, 5734, 16384 }, 13442
    },
    {
        { INT32_C(49152), INT32_C(32768), INT32_C(-32768) }, { INT32_C(0), INT32_C(0), INT32_C(0) },
        { UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0), UINT32_C(0) },
        0, 0, { UINT32_C(0xf5c28f00), 36 }, UINT32_C(0x33d47f34), { 16384, 1638, 819 }, 0
    },
    { UINT32_C(164), UINT32_C(164), UINT32_C(164) }
};

/* Returns the light at a point with a unit normal: that of all lights, with their colours. */
static inline luminaire_rgb stage_light(const stage_scene *scene, const int32_t point[3], const int16_t normal[3]) {
    luminaire_rgb sum = { 0, 0, 0 };
    if (!scene || !point || !normal) { return sum; }
    sum = scene->ambient;
    luminaire_add(&sum, luminaire_lantern_Irradiance(&scene->lantern, point, normal), scene->lantern.color);
    const luminaire_spot *const spots[2] = { &scene->key, &scene->back };
    for (int k = 0; k < 2; ++k) {
        luminaire_add(&sum, luminaire_spot_irradiance(spots[k], point, normal), spots[k]->color);
    }
    return sum;
}

/* Returns the light at a point of a surface that faces each light: what a small body without a normal receives, such as
 * an LED. */
static inline luminaire_rgb stage_light_facing(const stage_scene *scene, const int32_t point[3]) {
    luminaire_rgb sum = { 0, 0, 0 };
    if (!scene || !point) { return sum; }
    sum = scene->ambient;
    luminaire_add(&sum, luminaire_lantern_IrradianceFacing(&scene->lantern, point), scene->lantern.color);
    const luminaire_spot *const spots[2] = { &scene->key, &scene->back };
    for (int k = 0; k < 2; ++k) {
        luminaire_add(&sum, luminaire_spot_irradiance_facing(spots[k], point), spots[k]->color);
    }
    return sum;
}

/* Adds the light of all lights to each pixel of a row. The part of the row that a light cannot reach costs little. */
static inline void stage_row_add(
    luminaire_rgb *lights, const luminaire_row *row, const stage_scene *scene, uint32_t count
) {
    if (!lights || !row || !scene) { return; }
    luminaire_rgb all = scene->ambient;
    for (uint32_t i = 0; i < count; ++i) { lights[i] = luminaire_rgb_plus(lights[i], all); }
    luminaire_row_add_by(lights, row, &scene->lantern, luminaire_lantern_Irradiance, count);
    const luminaire_spot *const spots[2] = { &scene->key, &scene->back };
    for (int k = 0; k < 2; ++k) {
        luminaire_row_add(lights, row, spots[k], count);
    }
}

#elif STAGE_SCENE_H != 0xbe3e2a98
#error "two scenes have the name stage: export one of them by another name"
#endif
