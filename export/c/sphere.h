static inline int NAME_is_outside(const luminaire_offset *offset) {
    (void)offset;
    return 0;
}

static inline uint32_t NAME_coarse_share(const luminaire_coarse_ray *ray, uint32_t cosine) {
    (void)ray;
    return luminaire_coarse_scalar(cosine);
}

static inline uint32_t NAME_fine_share(const luminaire_fine_ray *ray, uint32_t cosine) {
    (void)ray;
    return luminaire_fine_scalar(cosine);
}
