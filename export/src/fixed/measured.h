static inline int luminaire_NAME_IsOutside(const luminaire_spot *spot, const luminaire_way *way, uint32_t squared) {
    return luminaire_is_outside(way, squared, spot->axis, spot->outside);
}

static inline uint32_t luminaire_NAME_CoarseEmitted(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    return luminaire_coarse_distributed(ray, luminaire_measured_of(spot), &luminaire_NAME_Distribution);
}

static inline uint32_t luminaire_NAME_FineEmitted(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    return luminaire_fine_distributed(ray, luminaire_measured_of(spot), &luminaire_NAME_Distribution);
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
