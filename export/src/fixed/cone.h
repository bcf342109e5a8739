static inline int luminaire_NAME_IsOutside(const luminaire_spot *spot, const luminaire_way *way, uint32_t squared) {
    return luminaire_is_outside(way, squared, spot->axis, spot->outside);
}

static inline uint32_t luminaire_NAME_CoarseEmitted(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    return luminaire_NAME_CoarseCurve(luminaire_coarse_rise(ray, spot->axis, &spot->ramp));
}

static inline uint32_t luminaire_NAME_FineEmitted(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    return luminaire_NAME_FineCurve(luminaire_fine_rise(ray, spot->axis, &spot->ramp));
}

static inline uint32_t luminaire_NAME_CoarseShare(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t cosine
) {
    return luminaire_coarse_of(cosine, luminaire_NAME_CoarseEmitted(spot, ray));
}

static inline uint32_t luminaire_NAME_FineShare(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t cosine
) {
    return luminaire_fine_of(cosine, luminaire_NAME_FineEmitted(spot, ray));
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t NAME_falloff(const int32_t point[3]) {
    const luminaire_spot *spot = &luminaire_NAME_Light;
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return (int16_t)luminaire_rounded(luminaire_NAME_FineEmitted(spot, &ray));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
        return (int16_t)luminaire_NAME_CoarseEmitted(spot, &ray);
    }
}
