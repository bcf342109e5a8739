static inline int NAME_is_outside(const luminaire_offset *offset) {
    return luminaire_is_outside(offset, NAME_axis, NAME_outside);
}

static inline uint32_t NAME_coarse_share(const luminaire_coarse_ray *ray, uint32_t cosine) {
    return luminaire_coarse_of(cosine, NAME_coarse_curve(luminaire_coarse_rise(ray, NAME_axis, &NAME_ramp)));
}

static inline uint32_t NAME_fine_share(const luminaire_fine_ray *ray, uint32_t cosine) {
    return luminaire_fine_of(cosine, NAME_fine_curve(luminaire_fine_rise(ray, NAME_axis, &NAME_ramp)));
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t NAME_falloff(const int32_t point[3]) {
    luminaire_offset offset = luminaire_offset_between(NAME_position, point);
    if (luminaire_is_near(&offset, NAME_fine_below)) {
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return (int16_t)luminaire_rounded(NAME_fine_curve(luminaire_fine_rise(&ray, NAME_axis, &NAME_ramp)));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&offset);
        return (int16_t)NAME_coarse_curve(luminaire_coarse_rise(&ray, NAME_axis, &NAME_ramp));
    }
}
