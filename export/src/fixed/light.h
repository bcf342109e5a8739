/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_NAME_NearIrradiance(
    luminaire_offset offset, int32_t facing, const int16_t normal[3]
) {
    luminaire_fine_ray ray;
    if (facing >= 7 << 12 || luminaire_NAME_IsOutside(&offset)) { return 0; }
    if (luminaire_NAME_FineBelow != LUMINAIRE_ALWAYS_FINE) {
        /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
        luminaire_coarse_ray coarse = luminaire_coarse_ray_of(&offset);
        uint32_t share = luminaire_NAME_CoarseShare(&coarse, luminaire_coarse_cosine(&coarse, facing));
        uint32_t light = luminaire_NAME_CoarseAttenuated(&coarse, share);
        if (luminaire_is_clipped(WINDOWED, light)) { return light; }
    }
    ray = luminaire_fine_ray_of(&offset);
    return luminaire_NAME_FineAttenuated(&ray, luminaire_NAME_FineShare(&ray, luminaire_fine_cosine(&ray, normal)));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t NAME_irradiance(const int32_t point[3], const int16_t normal[3]) {
    luminaire_offset offset = luminaire_offset_between(luminaire_NAME_Position, point);
    int32_t facing = luminaire_facing(&offset, normal);
    luminaire_coarse_ray ray;
    if (luminaire_is_near(&offset, luminaire_NAME_FineBelow)) {
        return luminaire_NAME_NearIrradiance(offset, facing, normal);
    }
    if (facing >= 0 || luminaire_NAME_IsOutside(&offset)) { return 0; }
    ray = luminaire_coarse_ray_of(&offset);
    return luminaire_NAME_CoarseAttenuated(&ray, luminaire_NAME_CoarseShare(&ray, luminaire_coarse_cosine(&ray, facing)));
}
