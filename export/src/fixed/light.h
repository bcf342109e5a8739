/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_NAME_FineIrradiance(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3]
) {
    luminaire_offset offset = luminaire_offset_between(spot->position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    uint32_t share = luminaire_NAME_FineShare(spot, &ray, luminaire_fine_cosine(&ray, normal));
    return luminaire_NAME_FineAttenuated(spot, &ray, share);
}

/* Returns the irradiance of the light as it is, moved or not. */
static inline uint32_t luminaire_NAME_Irradiance(
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
    if (luminaire_NAME_IsOutside(spot, &way, squared)) { return 0; }
    coarse = luminaire_coarse_ray_of(&way, squared);
    share = luminaire_NAME_CoarseShare(spot, &coarse, luminaire_coarse_cosine(&coarse, facing));
    light = luminaire_NAME_CoarseAttenuated(spot, &coarse, share);
    if (!luminaire_is_near(&way, squared, spot->fine_below)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (spot->fine_below != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(WINDOWED, light)) { return light; }
    return luminaire_NAME_FineIrradiance(spot, point, normal);
}

/* Returns the irradiance of a surface that faces the light as it is, moved or not. */
static inline uint32_t luminaire_NAME_IrradianceFacing(const luminaire_spot *spot, const int32_t point[3]) {
    luminaire_way way = luminaire_way_between(spot->position, point);
    uint32_t squared = luminaire_squared(&way);
    luminaire_coarse_ray coarse;
    if (luminaire_NAME_IsOutside(spot, &way, squared)) { return 0; }
    if (luminaire_is_near(&way, squared, spot->fine_below)) {
        luminaire_offset offset = luminaire_offset_between(spot->position, point);
        luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
        return luminaire_NAME_FineAttenuated(spot, &ray, luminaire_NAME_FineEmitted(spot, &ray));
    }
    coarse = luminaire_coarse_ray_of(&way, squared);
    return luminaire_NAME_CoarseAttenuated(spot, &coarse, luminaire_NAME_CoarseEmitted(spot, &coarse));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t NAME_irradiance(const int32_t point[3], const int16_t normal[3]) {
    return luminaire_NAME_Irradiance(&luminaire_NAME_Light, point, normal);
}
