/* A ball on a floor, drawn by a scanline rasteriser that knows no lights: it interpolates the colours of
 * the vertices. All numbers are integers once the ball is made. Prints the picture as PPM. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "luminaire.h"

enum { WIDTH = 320, HEIGHT = 240, ONE = 1 << 16, COLUMNS = 192, ROWS = 136, SEGMENTS = 96, RINGS = 48 };
enum { MOST = (COLUMNS + 1) * (ROWS + 1) }; /* vertices of the larger mesh, the floor */

/* A vertex on the screen, in steps of 2^-16 pixels, with its linear light. */
typedef struct {
    int32_t x, y;
    luminaire_rgb light;
} corner;

static luminaire_vertex vertices[MOST];
static luminaire_rgb lights[MOST];
static uint32_t picture[HEIGHT][WIDTH];

/* a + (b - a) part / whole */
static int32_t mix(int32_t a, int32_t b, int64_t part, int64_t whole) {
    return a + (int32_t)((b - a) * part / whole);
}

static corner between(const corner *a, const corner *b, int64_t part, int64_t whole) {
    corner c;
    c.x = mix(a->x, b->x, part, whole);
    c.y = mix(a->y, b->y, part, whole);
    c.light.red = (uint32_t)mix((int32_t)a->light.red, (int32_t)b->light.red, part, whole);
    c.light.green = (uint32_t)mix((int32_t)a->light.green, (int32_t)b->light.green, part, whole);
    c.light.blue = (uint32_t)mix((int32_t)a->light.blue, (int32_t)b->light.blue, part, whole);
    return c;
}

/* The first pixel whose middle is not before a place, within 0 and `end`. */
static int first(int32_t place, int end) {
    int pixel = (int)(((int64_t)place + ONE / 2 - 1) >> 16);
    return pixel < 0 ? 0 : pixel > end ? end : pixel;
}

/* The point of an edge in the middle of a row of pixels. */
static corner in_row(const corner *a, const corner *b, int row) {
    return between(a, b, (int64_t)row * ONE + ONE / 2 - a->y, (int64_t)b->y - a->y);
}

static void triangle(const corner *a, const corner *b, const corner *c) {
    const corner *swapped;
    int row, column;
    int64_t turn = (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(b->y - a->y) * (c->x - a->x);
    if (turn >= 0) { return; } /* seen from behind */
    if (a->y > b->y) { swapped = a; a = b; b = swapped; }
    if (b->y > c->y) { swapped = b; b = c; c = swapped; }
    if (a->y > b->y) { swapped = a; a = b; b = swapped; }
    for (row = first(a->y, HEIGHT); row < first(c->y, HEIGHT); ++row) {
        corner left = in_row(a, c, row);
        corner right = row < first(b->y, HEIGHT) ? in_row(a, b, row) : in_row(b, c, row);
        if (left.x > right.x) { corner other = left; left = right; right = other; }
        for (column = first(left.x, WIDTH); column < first(right.x, WIDTH); ++column) {
            int64_t part = (int64_t)column * ONE + ONE / 2 - left.x;
            picture[row][column] = luminaire_srgb(between(&left, &right, part, (int64_t)right.x - left.x).light);
        }
    }
}

/* Where the camera at (0, 3, 4), which looks at the origin, sees a vertex. */
static corner project(int i) {
    const int32_t *p = vertices[i].point;
    int64_t up = 4 * (int64_t)(p[1] - 3 * ONE) - 3 * (int64_t)(p[2] - 4 * ONE); /* five times the length */
    int64_t depth = -3 * (int64_t)(p[1] - 3 * ONE) - 4 * (int64_t)(p[2] - 4 * ONE);
    corner c;
    c.x = (int32_t)(WIDTH / 2 * ONE + (int64_t)p[0] * 5 * HEIGHT * ONE / depth);
    c.y = (int32_t)(HEIGHT / 2 * ONE - up * HEIGHT * ONE / depth);
    c.light = lights[i];
    return c;
}

/* Lights and draws the vertices, a grid whose squares are two triangles each. */
static void draw(const luminaire_spot *spots, luminaire_rgb ambient, int columns, int rows) {
    int i, row, count = (columns + 1) * (rows + 1);
    /* glue */
    for (i = 0; i < count; ++i) { lights[i] = ambient; }
    luminaire_vertices_add(lights, spots, 2, vertices, (uint32_t)count);
    /* end of glue */
    for (row = 0; row < rows; ++row) {
        for (i = row * (columns + 1); i < row * (columns + 1) + columns; ++i) {
            corner a = project(i), b = project(i + columns + 1), c = project(i + 1);
            corner d = project(i + columns + 2);
            triangle(&a, &b, &c);
            triangle(&c, &b, &d);
        }
    }
}

static void set_floor(int column, int row) {
    luminaire_vertex vertex = { { 0, 0, 0 }, { 0, 1 << 14, 0 } };
    vertex.point[0] = column * (ONE / 8) - 12 * ONE;
    vertex.point[2] = row * (ONE / 8) - 14 * ONE;
    vertices[row * (COLUMNS + 1) + column] = vertex;
}

static void set_ball(int column, int row) {
    const double turn = 8 * atan(1);
    double longitude = turn * column / SEGMENTS, latitude = turn / 2 * row / RINGS;
    double x = sin(latitude) * sin(longitude), y = cos(latitude), z = sin(latitude) * cos(longitude);
    luminaire_vertex *vertex = &vertices[row * (SEGMENTS + 1) + column];
    vertex->point[0] = (int32_t)lrint(x * ONE);
    vertex->point[1] = (int32_t)lrint(y * ONE) + ONE;
    vertex->point[2] = (int32_t)lrint(z * ONE);
    vertex->normal[0] = (int16_t)lrint(x * (1 << 14));
    vertex->normal[1] = (int16_t)lrint(y * (1 << 14));
    vertex->normal[2] = (int16_t)lrint(z * (1 << 14));
}

int main(void) {
    /* In steps of 2^-16 metres, and colours in steps of 2^-14. */
    static const int32_t places[2][3] = { { -170394, 209715, 170394 }, { 183501, 170394, -39322 } };
    static const int32_t axes[2][3] = { { 144179, -190054, -144179 }, { -163840, -144179, 45875 } };
    static const int16_t colors[2][3] = { { 16384, 10650, 4915 }, { 4915, 9011, 16384 } };
    const luminaire_rgb ambient = { 229, 262, 328 }; /* 0.014, 0.016 and 0.02 of full scale */
    luminaire_cone cone;
    luminaire_spot spots[2];
    int i, row, column, code = luminaire_cone_from_field(&cone, 0, 46 << 16);
    for (i = 0; i < 2 && code == LUMINAIRE_OK; ++i) {
        code = luminaire_spot_set_up(&spots[i], &cone, places[i], axes[i], (i ? 14 : 20) * ONE);
        luminaire_spot_tint(&spots[i], colors[i]);
    }
    if (code != LUMINAIRE_OK) {
        fputs(luminaire_refusal(code), stderr);
        return 1;
    }
    for (row = 0; row <= ROWS; ++row) {
        for (column = 0; column <= COLUMNS; ++column) { set_floor(column, row); }
    }
    draw(spots, ambient, COLUMNS, ROWS);
    for (row = 0; row <= RINGS; ++row) {
        for (column = 0; column <= SEGMENTS; ++column) { set_ball(column, row); }
    }
    draw(spots, ambient, SEGMENTS, RINGS); /* behind nothing, so that there is no depth buffer */
    printf("P3 %d %d 255\n", WIDTH, HEIGHT);
    for (row = 0; row < HEIGHT; ++row) {
        for (column = 0; column < WIDTH; ++column) {
            unsigned pixel = (unsigned)picture[row][column];
            printf("%u %u %u\n", pixel >> 16, pixel >> 8 & 255, pixel & 255);
        }
    }
    return 0;
}
