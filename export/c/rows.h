/* ---- many points: functions that add light to an array. A null array is empty ---- */

/* A vertex of a mesh: a point, and a normal of unit length. */
typedef struct {
    int32_t point[3];
    int16_t normal[3];
} luminaire_vertex;

/* A row of pixels on a straight line of a flat surface. */
typedef struct {
    int32_t first[3];  /* the point of the first pixel */
    int32_t step[3];   /* what the point changes by from pixel to pixel */
    int16_t normal[3]; /* the surface's, of unit length */
} luminaire_row;

/* Returns a sum; saturates. */
static inline uint32_t luminaire_sum(uint32_t a, uint32_t b) { return a + b < a ? UINT32_C(0xffffffff) : a + b; }

/* Adds the light of a spotlight at a point with a unit normal. */
static inline void luminaire_spot_add(
    const luminaire_spot *spot, const int32_t point[3], const int16_t normal[3], luminaire_rgb *sum
) {
    luminaire_rgb light = luminaire_spot_light(spot, point, normal);
    sum->red = luminaire_sum(sum->red, light.red);
    sum->green = luminaire_sum(sum->green, light.green);
    sum->blue = luminaire_sum(sum->blue, light.blue);
}

/* Sets the normal along a vector of signed bytes of a length of about 127, as normal maps have it. */
static inline void luminaire_normal_from_unit_bytes(int16_t normal[3], const int8_t bytes[3]) {
    int32_t x = bytes[0], y = bytes[1], z = bytes[2], factor;
    uint32_t square = (uint32_t)(x * x + y * y + z * z);
    int i;
    /* A step of Newton's iteration: (3 - |n|^2) / 2 for n in units of 127, in steps of 2^-15. */
    factor = (int32_t)(((square < 48387 ? 48387 - square : 0) * UINT32_C(33548)) >> 15);
    for (i = 0; i < 3; ++i) { normal[i] = (int16_t)((bytes[i] * factor + 128) >> 8); }
}

/* Adds the light of all spotlights at each vertex. */
static inline void luminaire_vertices_add(
    const luminaire_spot *spots, uint32_t spot_count, const luminaire_vertex *vertices, luminaire_rgb *lights,
    uint32_t count
) {
    uint32_t spot, i;
    if (!spots || !vertices || !lights) { return; }
    for (i = 0; i < count; ++i) {
        for (spot = 0; spot < spot_count; ++spot) {
            luminaire_spot_add(&spots[spot], vertices[i].point, vertices[i].normal, &lights[i]);
        }
    }
}

static inline void luminaire_row_point(const luminaire_row *row, uint32_t index, int32_t point[3]) {
    int i;
    for (i = 0; i < 3; ++i) {
        point[i] = luminaire_plus(row->first[i], luminaire_times(row->step[i], (int32_t)index));
    }
}

/* Sets the centre and returns the radius of a sphere around the line between two points of a row. */
static inline int32_t luminaire_row_sphere(const luminaire_row *row, uint32_t from, uint32_t to, int32_t center[3]) {
    int32_t end[3];
    uint32_t sum = 0, largest = 0;
    int i;
    luminaire_row_point(row, from, center);
    luminaire_row_point(row, to, end);
    for (i = 0; i < 3; ++i) {
        int32_t a = center[i] >> 1, b = end[i] >> 1;
        uint32_t half = luminaire_magnitude(luminaire_minus(a, b)) >> 1;
        center[i] = luminaire_plus(a, b);
        sum += half;
        largest = luminaire_max(largest, half);
    }
    /* A vector is no longer than half the sum of its largest component and of all three. */
    return (int32_t)(luminaire_min(sum + largest, UINT32_C(0x7ffffff8)) + 7);
}

/* Returns how many of the first points, or of the last ones, a light certainly does not reach: it skips
 * blocks of 16 to 64 points by their bounding spheres. */
LUMINAIRE_RARE uint32_t luminaire_row_skipped(
    const luminaire_row *row, const luminaire_spot *spot, uint32_t first, uint32_t count, int is_backwards
) {
    uint32_t start = 0, size = 64, length = count - first;
    while (start < length) {
        uint32_t last = luminaire_min(length - 1 - start, size - 1) + start;
        int32_t center[3];
        int32_t radius = is_backwards
            ? luminaire_row_sphere(row, count - 1 - start, count - 1 - last, center)
            : luminaire_row_sphere(row, start, last, center);
        if (!luminaire_spot_can_reach(spot, center, radius)) {
            start = last + 1;
            if (size < 64 && !(start & (2 * size - 1))) { size *= 2; }
        } else if (size > 16) {
            size /= 2;
        } else {
            break;
        }
    }
    return start;
}

/* Adds the light of a spotlight to the pixels of a row, with the normals along three bytes each, or the row's. */
static inline void luminaire_row_add_any(
    const luminaire_row *row, const luminaire_spot *spot, const int8_t *normals, luminaire_rgb *lights, uint32_t count
) {
    uint32_t i, end;
    int32_t point[3];
    int16_t normal[3];
    int k;
    if (!row || !spot || !lights) { return; }
    i = luminaire_row_skipped(row, spot, 0, count, 0);
    end = count - luminaire_row_skipped(row, spot, i, count, 1);
    luminaire_row_point(row, i, point);
    for (k = 0; k < 3; ++k) { normal[k] = row->normal[k]; }
    for (; i < end; ++i) {
        if (normals) { luminaire_normal_from_unit_bytes(normal, &normals[3 * i]); }
        luminaire_spot_add(spot, point, normal, &lights[i]);
        for (k = 0; k < 3; ++k) { point[k] = luminaire_plus(point[k], row->step[k]); }
    }
}

/* Adds the light of a spotlight to each pixel of a row. */
static inline void luminaire_row_add(
    const luminaire_row *row, const luminaire_spot *spot, luminaire_rgb *lights, uint32_t count
) {
    luminaire_row_add_any(row, spot, 0, lights, count);
}

/* Adds the light of a spotlight to each pixel of a row whose normals are along three signed bytes each, of a
 * length of about 127: a sprite with a normal map. The row's normal is not read. */
static inline void luminaire_row_add_facing(
    const luminaire_row *row, const luminaire_spot *spot, const int8_t *normals, luminaire_rgb *lights, uint32_t count
) {
    if (normals) { luminaire_row_add_any(row, spot, normals, lights, count); }
}
