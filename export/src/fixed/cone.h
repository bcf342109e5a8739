static inline int luminaire_NAME_IsOutside(const luminaire_way *way, uint32_t squared) {
    return luminaire_is_outside(way, squared, luminaire_NAME_Axis, luminaire_NAME_Outside);
}

static inline uint32_t luminaire_NAME_CoarseShare(const luminaire_coarse_ray *ray, uint32_t cosine) {
    uint32_t rise = luminaire_coarse_rise(ray, luminaire_NAME_Axis, &luminaire_NAME_Ramp);
    return luminaire_coarse_of(cosine, luminaire_NAME_CoarseCurve(rise));
}

static inline uint32_t luminaire_NAME_FineShare(const luminaire_fine_ray *ray, uint32_t cosine) {
    uint32_t rise = luminaire_fine_rise(ray, luminaire_NAME_Axis, &luminaire_NAME_Ramp);
    return luminaire_fine_of(cosine, luminaire_NAME_FineCurve(rise));
}

/* Returns the falloff at a point, from 0 to 2^14. */
static inline int16_t NAME_falloff(const int32_t point[3]) {
    luminaire_way way = luminaire_way_between(luminaire_NAME_Position, point);
    uint32_t squared = luminaire_squared(&way);
    if (luminaire_is_near(&way, squared, luminaire_NAME_FineBelow)) {
        luminaire_offset offset = luminaire_offset_between(luminaire_NAME_Position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        uint32_t rise = luminaire_fine_rise(&ray, luminaire_NAME_Axis, &luminaire_NAME_Ramp);
        return (int16_t)luminaire_rounded(luminaire_NAME_FineCurve(rise));
    } else {
        luminaire_coarse_ray ray = luminaire_coarse_ray_of(&way, squared);
        uint32_t rise = luminaire_coarse_rise(&ray, luminaire_NAME_Axis, &luminaire_NAME_Ramp);
        return (int16_t)luminaire_NAME_CoarseCurve(rise);
    }
}
