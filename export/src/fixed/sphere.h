static inline int luminaire_NAME_IsOutside(const luminaire_spot *spot, const luminaire_way *way, uint32_t squared) {
    (void)spot;
    (void)way;
    (void)squared;
    return 0;
}

/* A point at the light itself has no direction, and no light. */
static inline uint32_t luminaire_NAME_CoarseEmitted(const luminaire_spot *spot, const luminaire_coarse_ray *ray) {
    (void)spot;
    return ray->reciprocal ? LUMINAIRE_FULL_SCALE : 0;
}

static inline uint32_t luminaire_NAME_FineEmitted(const luminaire_spot *spot, const luminaire_fine_ray *ray) {
    (void)spot;
    return ray->estimate ? LUMINAIRE_FINE_ONE : 0;
}

static inline uint32_t luminaire_NAME_CoarseShare(
    const luminaire_spot *spot, const luminaire_coarse_ray *ray, uint32_t cosine
) {
    (void)spot;
    (void)ray;
    return luminaire_coarse_scalar(cosine);
}

static inline uint32_t luminaire_NAME_FineShare(
    const luminaire_spot *spot, const luminaire_fine_ray *ray, uint32_t cosine
) {
    (void)spot;
    (void)ray;
    return luminaire_fine_scalar(cosine);
}
