/* Outputs of linear light in C99 and C++11: bit-identical to the kernel's format Fx16.
 *
 * Light has steps of 2^-14 of full scale, which it may exceed; an output clips it. The outputs are
 * pixels of more formats than luminaire.h has, packed to bytes; palettes; pulse widths, also for
 * drivers that apply a gamma; temporal dither; and strips of LEDs within a limit of their current.
 * The code has no floats, no memory of its own, and no division except for the limit, three a
 * frame. It is defined for all inputs; pointers may be null where a count is 0.
 *
 * Licence: MIT OR Apache-2.0, at your choice.
 */
#ifndef LUMINAIRE_DISPLAY_H
#define LUMINAIRE_DISPLAY_H

#include "luminaire.h"

/* Formats of pixels: the bits of red, green and blue as three hexadecimal digits. Grey has green
 * bits only. Written as a constant, a format links its own tables and code only. */
#define LUMINAIRE_GRAY1 UINT32_C(0x010)
#define LUMINAIRE_GRAY2 UINT32_C(0x020)
#define LUMINAIRE_GRAY4 UINT32_C(0x040)
#define LUMINAIRE_GRAY8 UINT32_C(0x080)
#define LUMINAIRE_RGB332 UINT32_C(0x332)
#define LUMINAIRE_RGB444 UINT32_C(0x444)
#define LUMINAIRE_RGB555 UINT32_C(0x555)
#define LUMINAIRE_RGB565 UINT32_C(0x565)
#define LUMINAIRE_RGB666 UINT32_C(0x666)
#define LUMINAIRE_RGB888 UINT32_C(0x888)

/* A function that is part of each caller, so that a constant format selects its tables there. */
#if defined(__GNUC__)
#define LUMINAIRE_PART __attribute__((always_inline)) static inline
#else
#define LUMINAIRE_PART static inline
#endif

/* TABLES */

/* ---- pixels ---- */

/* Returns the bits of a channel, at most 8, from the place of its digit: 8 for red, 4 and 0. */
LUMINAIRE_PART uint32_t luminaire_width(uint32_t format, uint32_t digit) {
    return luminaire_min((format >> digit) & 15, 8);
}

/* Returns the table of the nearest codes; that of eight bits for a width without a table. */
LUMINAIRE_PART const uint16_t *luminaire_nearest_of(uint32_t bits) {
    return bits == 2 ? luminaire_nearest_2 : bits == 3 ? luminaire_nearest_3 : bits == 4 ? luminaire_nearest_4
        : bits == 5 ? luminaire_nearest_5 : bits == 6 ? luminaire_nearest_6 : luminaire_nearest_8;
}

/* Returns the table of the nearest codes of grey; that of eight bits for other widths. */
LUMINAIRE_PART const uint32_t *luminaire_grays_of(uint32_t bits) {
    return bits == 1 ? luminaire_grays_1 : bits == 2 ? luminaire_grays_2 : bits == 4 ? luminaire_grays_4
        : luminaire_grays_8;
}

/* Returns the table of the light of codes; that of eight bits for other widths. */
LUMINAIRE_PART const uint32_t *luminaire_lights_of(uint32_t bits) {
    return bits == 1 ? luminaire_lights_1 : bits == 2 ? luminaire_lights_2 : bits == 3 ? luminaire_lights_3
        : bits == 4 ? luminaire_lights_4 : bits == 5 ? luminaire_lights_5 : bits == 6 ? luminaire_lights_6
        : luminaire_lights_8;
}

/* Returns the pixel of three codes. */
LUMINAIRE_PART uint32_t luminaire_channels(uint32_t format, uint32_t red, uint32_t green, uint32_t blue) {
    uint32_t low = luminaire_width(format, 0);
    return red << (luminaire_width(format, 4) + low) | green << low | blue;
}

/* Returns the luminance (ITU-R BT.709) of a light clipped to 1, less than 1, in steps of 2^-30. */
static inline uint32_t luminaire_luminance(luminaire_rgb light) {
    const uint32_t one = UINT32_C(1) << 14;
    /* The weights sum to 2^16. */
    uint32_t sum = 13933 * luminaire_min(light.red, one) + 46871 * luminaire_min(light.green, one)
        + 4732 * luminaire_min(light.blue, one);
    return luminaire_min(sum, (UINT32_C(1) << 30) - 1);
}

/* Returns the nearest code of a luminance. */
static inline uint32_t luminaire_gray(const uint32_t *greys, uint32_t bits, uint32_t light) {
    uint32_t code = luminaire_start(light >> 22, bits);
    while (light >= LUMINAIRE_READ32(&greys[code])) { ++code; }
    return code;
}

/* Returns the nearest pixel to a light, red above green above blue. */
LUMINAIRE_PART uint32_t luminaire_pixel(uint32_t format, luminaire_rgb light) {
    uint32_t red = luminaire_width(format, 8), green = luminaire_width(format, 4), blue = luminaire_width(format, 0);
    if (red + blue == 0) { return luminaire_gray(luminaire_grays_of(green), green, luminaire_luminance(light)); }
    return luminaire_channels(format, luminaire_code(luminaire_nearest_of(red), red, light.red),
        luminaire_code(luminaire_nearest_of(green), green, light.green),
        luminaire_code(luminaire_nearest_of(blue), blue, light.blue));
}

/* Returns the pixel of a light at (x, y), with ordered dither. */
LUMINAIRE_PART uint32_t luminaire_pixel_dithered(uint32_t format, luminaire_rgb light, uint32_t x, uint32_t y) {
    uint32_t red = luminaire_width(format, 8), green = luminaire_width(format, 4), blue = luminaire_width(format, 0);
    uint32_t threshold = luminaire_threshold(x, y), grey;
    if (red + blue == 0) {
        grey = luminaire_luminance(light) >> 6;
        return luminaire_dithered(luminaire_lights_of(green), luminaire_start(grey >> 16, green), grey, threshold);
    }
    return luminaire_channels(format, luminaire_code_dithered(luminaire_lights_of(red), red, light.red, threshold),
        luminaire_code_dithered(luminaire_lights_of(green), green, light.green, threshold),
        luminaire_code_dithered(luminaire_lights_of(blue), blue, light.blue, threshold));
}

/* ---- packing ---- */

/* The order of packed pixels: most significant bit first, with the first pixel in the upper bits of
 * a byte, or least significant bit first. */
#define LUMINAIRE_MSB_FIRST 0
#define LUMINAIRE_LSB_FIRST 1

/* Packs pixels into bytes without gaps: where the next byte goes, the bytes left, and held bits. */
typedef struct {
    uint8_t *next;
    uint32_t left, held, width;
} luminaire_packer;

/* Returns a packer into bytes. */
static inline luminaire_packer luminaire_packer_into(uint8_t *bytes, uint32_t count) {
    luminaire_packer packer;
    packer.next = bytes;
    packer.left = count;
    packer.held = packer.width = 0;
    return packer;
}

/* Appends a pixel and returns 1; returns 0 and appends nothing if it does not fit as a whole. 15
 * bits take two bytes; 18 bits take three, with a channel in the upper bits of each. */
static inline int luminaire_pack(luminaire_packer *packer, uint32_t format, int order, uint32_t pixel) {
    uint32_t bits = luminaire_width(format, 8) + luminaire_width(format, 4) + luminaire_width(format, 0), size = bits;
    pixel &= (UINT32_C(1) << bits) - 1;
    if (bits == 15) { size = 16; }
    if (bits == 18) {
        size = 24;
        pixel = (pixel & 0x3f000) << 6 | (pixel & 0xfc0) << 4 | (pixel & 0x3f) << 2;
    }
    if ((packer->width + size + 7) >> 3 > packer->left) { return 0; }
    packer->held = order == LUMINAIRE_LSB_FIRST ? packer->held | pixel << packer->width : packer->held << size | pixel;
    for (packer->width += size; packer->width >= 8; --packer->left) {
        packer->width -= 8;
        if (order == LUMINAIRE_LSB_FIRST) {
            *packer->next++ = LUMINAIRE_CAST(uint8_t, packer->held & 0xff);
            packer->held >>= 8;
        } else {
            *packer->next++ = LUMINAIRE_CAST(uint8_t, packer->held >> packer->width & 0xff);
        }
    }
    return 1;
}

/* Ends a row: writes the byte that is not full. Its unused bits are 0. */
static inline void luminaire_pack_end(luminaire_packer *packer, int order) {
    uint32_t held = order == LUMINAIRE_LSB_FIRST ? packer->held : packer->held << (8 - packer->width);
    if (packer->width > 0) {
        *packer->next++ = LUMINAIRE_CAST(uint8_t, held & 0xff);
        --packer->left;
    }
    packer->held = packer->width = 0;
}

/* ---- palettes ---- */

/* A palette: the index of its colour for each of the 4,096 pixels of RGB444, in a LUMINAIRE_TABLE,
 * and the range of the dither in sRGB codes. The kernel computes both on the host. */
typedef struct {
    const uint8_t *cells;
    uint8_t spacing;
} luminaire_palette;

/* Returns the index of the palette's colour for a light. */
static inline uint8_t luminaire_palette_nearest(const luminaire_palette *palette, luminaire_rgb light) {
    return LUMINAIRE_CAST(uint8_t, LUMINAIRE_READ8(&palette->cells[luminaire_pixel(LUMINAIRE_RGB444, light)]));
}

/* Returns the code of four bits of a channel whose code of eight bits is moved by an offset. */
static inline uint32_t luminaire_moved(uint32_t light, int32_t offset) {
    int32_t code = luminaire_encode_srgb(light) + offset;
    uint32_t scaled = (code < 0 ? 0 : luminaire_min(LUMINAIRE_CAST(uint32_t, code), 255)) * 15 + 127;
    return (scaled + 1 + (scaled >> 8)) >> 8; /* scaled / 255 */
}

/* Returns the index of the palette's colour for a light at (x, y), with ordered dither. */
static inline uint8_t luminaire_palette_dithered(
    const luminaire_palette *palette, luminaire_rgb light, uint32_t x, uint32_t y
) {
    int32_t offset = (64 - LUMINAIRE_CAST(int32_t, luminaire_threshold(x, y))) * palette->spacing / 128;
    uint32_t cell = luminaire_moved(light.red, offset) << 8 | luminaire_moved(light.green, offset) << 4
        | luminaire_moved(light.blue, offset);
    return LUMINAIRE_CAST(uint8_t, LUMINAIRE_READ8(&palette->cells[cell]));
}

/* ---- pulse widths ---- */

/* Returns the duty of 1 to 16 bits nearest to a channel, ties up. */
static inline uint16_t luminaire_duty(uint32_t light, uint32_t bits) {
    light = luminaire_min(light, UINT32_C(1) << 14);
    return LUMINAIRE_CAST(uint16_t, ((light << luminaire_min(bits, 16)) - light + (UINT32_C(1) << 13)) >> 14);
}

/* Returns the duty of eight bits of a channel at (x, y), with ordered dither. */
static inline uint8_t luminaire_duty_dithered(uint32_t light, uint32_t x, uint32_t y) {
    uint32_t clipped = luminaire_min(light, UINT32_C(1) << 14), code = (clipped * 255) >> 14;
    uint32_t here = code * 65793 + (code >> 7), next = (code + 1) * 65793 + ((code + 1) >> 7);
    int up = ((clipped << 10) - here) << 7 > (next - here) * luminaire_threshold(x, y);
    return LUMINAIRE_CAST(uint8_t, code + LUMINAIRE_CAST(uint32_t, up));
}

/* Returns the nearest code of eight bits of a gamma. */
static inline uint8_t luminaire_gamma(const uint8_t *starts, const uint16_t *nearest, uint32_t light) {
    light = luminaire_clipped(light);
    return LUMINAIRE_CAST(uint8_t, luminaire_nearest(nearest, LUMINAIRE_READ8(&starts[light >> 6]), light));
}

/* Returns the dithered code of eight bits of a gamma. */
static inline uint8_t luminaire_gamma_dithered(
    const uint8_t *starts, const uint32_t *lights, uint32_t light, uint32_t threshold
) {
    light = luminaire_clipped(light);
    light = luminaire_dithered(lights, LUMINAIRE_READ8(&starts[light >> 6]), light << 10, threshold);
    return LUMINAIRE_CAST(uint8_t, light);
}

/* Returns the code for what applies a power of 2.2 to eight bits. */
static inline uint8_t luminaire_gamma22(uint32_t light) {
    return luminaire_gamma(luminaire_starts_22, luminaire_nearest_22, light);
}

/* Returns the code for a power of 2.2 at (x, y), with ordered dither. */
static inline uint8_t luminaire_gamma22_dithered(uint32_t light, uint32_t x, uint32_t y) {
    return luminaire_gamma_dithered(luminaire_starts_22, luminaire_lights_22, light, luminaire_threshold(x, y));
}

/* Returns the code for what applies a power of 2.8 to eight bits. */
static inline uint8_t luminaire_gamma28(uint32_t light) {
    return luminaire_gamma(luminaire_starts_28, luminaire_nearest_28, light);
}

/* Returns the code for a power of 2.8 at (x, y), with ordered dither. */
static inline uint8_t luminaire_gamma28_dithered(uint32_t light, uint32_t x, uint32_t y) {
    return luminaire_gamma_dithered(luminaire_starts_28, luminaire_lights_28, light, luminaire_threshold(x, y));
}

/* ---- temporal dither ---- */

/* Returns what the first duty of the LED of an index carries: neighbours do not flash together. */
static inline uint16_t luminaire_phase(uint32_t index) {
    return LUMINAIRE_CAST(uint16_t, (index * 40503) & 0xffff);
}

/* Returns the duty of the next frame for a channel times a factor in steps of 2^-16, at most 1. */
static inline uint16_t luminaire_next_dimmed(uint16_t *carry, uint32_t light, uint32_t bits, uint32_t factor) {
    uint32_t sum;
    light = luminaire_min(light, UINT32_C(1) << 14);
    light = ((light << luminaire_min(bits, 16)) - light) << 2;
    sum = luminaire_high_product(light, luminaire_min(factor, UINT32_C(1) << 16)) + *carry;
    *carry = LUMINAIRE_CAST(uint16_t, sum & 0xffff);
    return LUMINAIRE_CAST(uint16_t, sum >> 16);
}

/* Returns the duty of 1 to 16 bits of the next frame: the mean of all frames is the light. */
static inline uint16_t luminaire_next_duty(uint16_t *carry, uint32_t light, uint32_t bits) {
    return luminaire_next_dimmed(carry, light, bits, UINT32_C(1) << 16);
}

/* ---- strips of LEDs ---- */

/* The order of the bytes of an LED. */
#define LUMINAIRE_LED_GRB 0 /* WS2812, SK6812 */
#define LUMINAIRE_LED_RGB 1 /* WS2811, WS2815 of some makers */
#define LUMINAIRE_LED_BGR 2 /* APA102 after its byte of brightness */

/* A strip: the most current of all LEDs, that of a channel at full duty and that of a dark LED, in
 * milliamperes, and the order of the bytes. A channel of 0 mA stands for no limit. */
typedef struct {
    uint32_t most;
    uint16_t channel, idle;
    int order;
} luminaire_strip;

/* Returns the factor of all light that keeps the limit, in steps of 2^-16, at most 1. */
static inline uint32_t luminaire_strip_factor(
    const luminaire_strip *strip, const luminaire_rgb *lights, uint32_t count
) {
    const uint32_t one = UINT32_C(1) << 14, full = UINT32_C(1) << 16;
    uint64_t idle = LUMINAIRE_CAST(uint64_t, count) * strip->idle, needed = 0, available, dither;
    uint32_t i;
    if (strip->channel == 0) { return full; }
    /* The light that the current suffices for, less what the dither may add to each channel. */
    available = strip->most > idle ? ((strip->most - idle) << 14) / strip->channel : 0;
    dither = (LUMINAIRE_CAST(uint64_t, count) * (3 * one) + 254) / 255;
    available = available > dither ? available - dither : 0;
    for (i = 0; i < count; ++i) {
        needed += luminaire_min(lights[i].red, one) + luminaire_min(lights[i].green, one)
            + luminaire_min(lights[i].blue, one);
    }
    return needed <= available ? full : LUMINAIRE_CAST(uint32_t, (available << 16) / needed);
}

/* Writes three bytes for each LED, by temporal dither. carries has three words for each, at first
 * those of luminaire_phase. Light beyond the limit of the current is dimmed by one factor. */
static inline void luminaire_strip_write(
    const luminaire_strip *strip, const luminaire_rgb *lights, uint16_t *carries, uint8_t *bytes, uint32_t count
) {
    uint32_t factor = luminaire_strip_factor(strip, lights, count), i;
    uint32_t red = strip->order == LUMINAIRE_LED_RGB ? 0 : strip->order == LUMINAIRE_LED_BGR ? 2 : 1;
    uint32_t green = strip->order == LUMINAIRE_LED_RGB || strip->order == LUMINAIRE_LED_BGR ? 1 : 0;
    for (i = 0; i < count; ++i, carries += 3, bytes += 3) {
        bytes[red] = LUMINAIRE_CAST(uint8_t, luminaire_next_dimmed(carries, lights[i].red, 8, factor));
        bytes[green] = LUMINAIRE_CAST(uint8_t, luminaire_next_dimmed(carries + 1, lights[i].green, 8, factor));
        bytes[3 - red - green] = LUMINAIRE_CAST(uint8_t, luminaire_next_dimmed(carries + 2, lights[i].blue, 8, factor));
    }
}

#endif
