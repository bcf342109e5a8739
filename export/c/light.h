/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t NAME_near_irradiance(luminaire_offset offset, int32_t facing, const int16_t normal[3]) {
    luminaire_fine_ray ray;
    if (facing >= 7 << 12 || NAME_is_outside(&offset)) { return 0; }
    if (NAME_fine_below != LUMINAIRE_ALWAYS_FINE) {
        /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
        luminaire_coarse_ray coarse = luminaire_coarse_ray_of(&offset);
        uint32_t share = NAME_coarse_share(&coarse, luminaire_coarse_cosine(&coarse, facing));
        uint32_t light = NAME_coarse_attenuated(&coarse, share);
        if (luminaire_is_clipped(share, light)) { return light; }
    }
    ray = luminaire_fine_ray_of(&offset);
    return NAME_fine_attenuated(&ray, NAME_fine_share(&ray, luminaire_fine_cosine(&ray, normal)));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t NAME_irradiance(const int32_t point[3], const int16_t normal[3]) {
    luminaire_offset offset = luminaire_offset_between(NAME_position, point);
    int32_t facing = luminaire_facing(&offset, normal);
    luminaire_coarse_ray ray;
    if (luminaire_is_near(&offset, NAME_fine_below)) { return NAME_near_irradiance(offset, facing, normal); }
    if (facing >= 0 || NAME_is_outside(&offset)) { return 0; }
    ray = luminaire_coarse_ray_of(&offset);
    return NAME_coarse_attenuated(&ray, NAME_coarse_share(&ray, luminaire_coarse_cosine(&ray, facing)));
}
