/* Calls the functions of C with all values, for an analysis by Frama-C's Eva: `cargo xtask prove`.
 *
 * An array ends where its memory ends, so that an access past the count is an alarm. Assertions are those of the
 * analysis, which has to prove them. */
#include <__fc_builtin.h>

#include "lights.h"
#include "luminaire_display.h"

#define FEW 4
#define MANY 200 /* of which a row skips blocks */
#define ANY(object) Frama_C_make_unknown((char *)&(object), sizeof(object))
#define OR_NULL(pointer) (choice ? (pointer) : 0)

/* Each read is any value. */
static volatile uint32_t word;
static volatile int32_t number;
static volatile int16_t scalar;
static volatile int choice;

static luminaire_spot spots[FEW];
static luminaire_vertex vertices[MANY];
static luminaire_rgb lights[MANY];
static uint16_t texels[FEW];
static int8_t bytes[3 * MANY];
static luminaire_row row;
static luminaire_cone cone;
static luminaire_directional sun;
static int32_t point[3];
static int16_t normal[3];

static luminaire_rgb rgb(void) {
    luminaire_rgb light;
    ANY(light);
    return light;
}

static void any(void) {
    ANY(spots);
    ANY(vertices);
    ANY(lights);
    ANY(bytes);
    ANY(row);
    ANY(cone);
    ANY(sun);
    ANY(point);
    ANY(normal);
}

static luminaire_spot *any_spot(void) {
    any();
    return OR_NULL(&spots[0]);
}

static void light(void) {
    luminaire_spot_irradiance(any_spot(), OR_NULL(point), OR_NULL(normal));
    luminaire_spot_light(any_spot(), OR_NULL(point), OR_NULL(normal));
    luminaire_spot_falloff(any_spot(), OR_NULL(point));
    luminaire_spot_irradiance_facing(any_spot(), OR_NULL(point));
    luminaire_spot_can_reach(any_spot(), OR_NULL(point), number);
    luminaire_directional_irradiance(OR_NULL(&sun), OR_NULL(normal));
    luminaire_directional_irradiance_facing(OR_NULL(&sun));
    luminaire_directional_light(OR_NULL(&sun), OR_NULL(normal));
    luminaire_ambient(OR_NULL(normal), number);
}

static void change(void) {
    luminaire_spot_restore(any_spot());
    luminaire_spot_move(any_spot(), OR_NULL(point));
    luminaire_spot_aim(any_spot(), OR_NULL(point));
    luminaire_spot_aim_along(any_spot(), OR_NULL(point));
    luminaire_spot_tint(any_spot(), OR_NULL(normal));
    luminaire_spot_dim(any_spot(), scalar);
    luminaire_spot_zoom(any_spot(), OR_NULL(&spots[1]), scalar);
    luminaire_spot_zoom(&spots[0], &spots[0], scalar);
    luminaire_directional_aim_along(OR_NULL(&sun), OR_NULL(point));
    luminaire_directional_tint(OR_NULL(&sun), OR_NULL(normal));
    luminaire_directional_dim(OR_NULL(&sun), scalar);
    any();
    luminaire_normal_from_bytes(OR_NULL(normal), OR_NULL(bytes));
}

static void set_up(void) {
    luminaire_refusal(choice);
    luminaire_cone_from_field(OR_NULL(&cone), choice, word);
    luminaire_cone_from_beam(OR_NULL(&cone), choice, word);
    luminaire_cone_from_inner_and_outer(OR_NULL(&cone), choice, word, word);
    luminaire_cone_from_beam_and_field(OR_NULL(&cone), word, word);
    luminaire_spot_set_up(any_spot(), OR_NULL(&cone), OR_NULL(point), OR_NULL(point), number);
    luminaire_directional_set_up(OR_NULL(&sun), OR_NULL(point), number);
}

static void arrays(uint32_t count) {
    luminaire_rgb *sums = lights + MANY - count;
    luminaire_vertex *some = vertices + MANY - count;
    int8_t *normals = bytes + 3 * (MANY - count);
    luminaire_spot_add(OR_NULL(sums + count - 1), any_spot(), OR_NULL(some + count - 1));
    luminaire_normal_from_unit_bytes(OR_NULL(normal), OR_NULL(bytes));
    luminaire_normals_from_opengl(OR_NULL(normals), (const uint8_t *)normals, count);
    luminaire_normals_from_directx(OR_NULL(normals), (const uint8_t *)normals, count);
    luminaire_vertices_add(OR_NULL(sums), OR_NULL(spots + FEW - count % 5), count % 5, OR_NULL(some), count);
    luminaire_row_add(OR_NULL(sums), OR_NULL(&row), any_spot(), count);
    luminaire_row_add_facing(OR_NULL(sums), OR_NULL(&row), any_spot(), OR_NULL(normals), count);
    any();
    luminaire_row_add_by(sums, &row, &spots[0], luminaire_spot_irradiance, count);
}

static void rows(void) {
    uint32_t count;
    for (count = 0; count <= FEW; ++count) { arrays(count); }
    arrays(MANY);
    luminaire_vertices_add(lights, 0, word, vertices, word);
    luminaire_vertices_add(lights, spots, word, 0, word);
    luminaire_vertices_add(0, spots, word, vertices, word);
    luminaire_row_add(0, OR_NULL(&row), any_spot(), word);
    luminaire_row_add_facing(0, OR_NULL(&row), any_spot(), bytes, word);
}

static void pixels(void) {
    uint8_t two[2];
    luminaire_rgb_plus(rgb(), rgb());
    luminaire_rgb_filtered(rgb(), OR_NULL(normal));
    luminaire_encode_srgb(word);
    luminaire_encode_srgb_dithered(word, word, word);
    luminaire_srgb(rgb());
    luminaire_srgb_dithered(rgb(), word, word);
    luminaire_rgb565(rgb());
    luminaire_rgb565_dithered(rgb(), word, word);
    luminaire_high_first(OR_NULL(two), (uint16_t)word);
    luminaire_low_first(OR_NULL(two), (uint16_t)word);
    luminaire_decode_srgb((uint8_t)word);
    luminaire_row_texture(OR_NULL(lights), OR_NULL(texels), FEW);
}

/* A pixel has any three widths up to 8, to which others are clipped. */
static void formats(void) {
    luminaire_rgb light = rgb();
    uint32_t red = luminaire_channel_width(word, 4 * (word & 7)), green, blue;
    /*@ assert red <= 8; */
    for (red = 0; red < 9; ++red) {
        for (green = 0; green < 9; ++green) {
            for (blue = 0; blue < 9; ++blue) {
                luminaire_pixel(word << 12 | red << 8 | green << 4 | blue, light);
                luminaire_pixel_dithered(word << 12 | red << 8 | green << 4 | blue, light, word, word);
            }
        }
    }
}

/* A packer keeps what is asserted, and the call after any other begins with it. */
static void packing(void) {
    uint8_t out[FEW];
    uint32_t left, width;
    luminaire_packer packer = luminaire_packer_into(0, word);
    luminaire_pack(0, word, choice, word);
    luminaire_pack_end(0, choice);
    luminaire_pack(&packer, word, choice, word);
    luminaire_pack_end(&packer, choice);
    for (left = 0; left <= FEW; ++left) {
        for (width = 0; width < (left ? 8 : 1); ++width) {
            packer = luminaire_packer_into(out + FEW - left, left);
            packer.width = width;
            packer.held = word;
            luminaire_pack(&packer, word, choice, word);
            /*@ assert packer.next == &out[0] + (FEW - packer.left); */
            /*@ assert packer.width < 8 && (packer.width == 0 || packer.left > 0); */
            packer = luminaire_packer_into(out + FEW - left, left);
            packer.width = width;
            packer.held = word;
            luminaire_pack_end(&packer, choice);
            /*@ assert packer.next == &out[0] + (FEW - packer.left) && packer.width == 0; */
        }
    }
}

static const uint8_t cells[4096] LUMINAIRE_TABLE = { 0 };

static void outputs(void) {
    luminaire_palette palette;
    luminaire_strip strip;
    luminaire_frame frame;
    uint16_t carries[4 * FEW];
    uint8_t out[8 * FEW];
    uint32_t count;
    int family;
    ANY(strip);
    ANY(frame);
    ANY(carries);
    palette.cells = OR_NULL(cells);
    palette.spacing = (uint8_t)word;
    luminaire_palette_nearest(OR_NULL(&palette), rgb());
    luminaire_palette_dithered(OR_NULL(&palette), rgb(), word, word);
    luminaire_duty(word, word);
    luminaire_duty_dithered(word, word, word);
    luminaire_gamma22(word);
    luminaire_gamma22_dithered(word, word, word);
    luminaire_gamma28(word);
    luminaire_gamma28_dithered(word, word, word);
    luminaire_phase(word);
    luminaire_next_duty(OR_NULL(carries), word, word);
    luminaire_next_dimmed(OR_NULL(carries), word, word, word);
    luminaire_strip_write(0, 0, OR_NULL(&strip), 0, word);
    for (family = 0; family <= LUMINAIRE_LED_HD108; family += 4) {
        const uint32_t bytes = luminaire_led_bytes(family), words = luminaire_led_carries(family);
        strip.order = family + (int)(word & 3);
        luminaire_led_start(OR_NULL(carries), strip.order, word);
        luminaire_strip_begin(OR_NULL(&frame), OR_NULL(&strip), word);
        luminaire_strip_next(
            out + 8 * FEW - bytes, carries + 4 * FEW - words, OR_NULL(&frame), OR_NULL(&strip), rgb());
        for (count = 0; count <= FEW; ++count) {
            luminaire_strip_write(out + 8 * FEW - bytes * count, carries + 4 * FEW - words * count, &strip,
                lights + MANY - count, count);
        }
    }
}

int main(void) {
    pixels();
    formats();
    packing();
    any();
    lights_at(point, normal);
    outputs();
    light();
    change();
    set_up();
    rows();
    return 0;
}
