/* The irradiance near the light or in a steep cone. Not inlined: it would slow the usual case. */
LUMINAIRE_RARE uint32_t luminaire_NAME_FineIrradiance(const int32_t point[3], const int16_t normal[3]) {
    luminaire_offset offset = luminaire_offset_between(luminaire_NAME_Position, point);
    luminaire_fine_ray ray = luminaire_fine_ray_of(&offset);
    return luminaire_NAME_FineAttenuated(&ray, luminaire_NAME_FineShare(&ray, luminaire_fine_cosine(&ray, normal)));
}

/* Returns the irradiance at a point with a unit normal, before the colour, in steps of 2^-14. */
static inline uint32_t NAME_irradiance(const int32_t point[3], const int16_t normal[3]) {
    luminaire_way way = luminaire_way_between(luminaire_NAME_Position, point);
    int32_t facing = luminaire_facing(&way, normal);
    uint32_t squared, share, light;
    luminaire_coarse_ray coarse;
    if (facing >= 0) {
        /* The fine evaluation has more bits of the product with the normal. */
        if (facing >= 7 << 12) { return 0; }
        if (!luminaire_is_near(&way, luminaire_squared(&way), luminaire_NAME_FineBelow)) { return 0; }
    }
    squared = luminaire_squared(&way);
    if (luminaire_NAME_IsOutside(&way, squared)) { return 0; }
    coarse = luminaire_coarse_ray_of(&way, squared);
    share = luminaire_NAME_CoarseShare(&coarse, luminaire_coarse_cosine(&coarse, facing));
    light = luminaire_NAME_CoarseAttenuated(&coarse, share);
    if (!luminaire_is_near(&way, squared, luminaire_NAME_FineBelow)) { return light; }
    /* Light that is clipped to full scale in any case keeps the coarse evaluation. */
    if (luminaire_NAME_FineBelow != LUMINAIRE_ALWAYS_FINE && luminaire_is_clipped(WINDOWED, light)) { return light; }
    return luminaire_NAME_FineIrradiance(point, normal);
}
