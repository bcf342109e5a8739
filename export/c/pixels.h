/* ---- pixels ----
 *
 * A light has three channels in steps of 2^-14 of full scale, which they may exceed; an output
 * clips it. A code is the nearest of sRGB, or with ordered dither one of the two around the light:
 * over cells of 8 x 8 pixels their mean is the light.
 *
 * The search for a code starts from a table of 256 bytes, by the upper eight bits of the light, and
 * goes up. On Cortex-M0 a pixel of RGB565 then takes 91 instructions, with dither 139, on average
 * over uniform light (measured, -Os); by bisection 213 and 236. Unused tables are not linked.
 */

/* Tables are constants. AVR keeps them in flash, which it reads by instructions of its own. */
#if defined(__AVR__)
#include <avr/pgmspace.h>
#define LUMINAIRE_TABLE(type, name, size) static const type name[size] PROGMEM
#define LUMINAIRE_READ8(address) pgm_read_byte(address)
#define LUMINAIRE_READ16(address) pgm_read_word(address)
#define LUMINAIRE_READ32(address) pgm_read_dword(address)
#else
#define LUMINAIRE_TABLE(type, name, size) static const type name[size]
#define LUMINAIRE_READ8(address) (*(address))
#define LUMINAIRE_READ16(address) (*(address))
#define LUMINAIRE_READ32(address) (*(address))
#endif

/* Converts a number, in C++ without a cast of C, of which compilers warn. */
#if defined(__cplusplus)
#define LUMINAIRE_CAST(type, value) static_cast<type>(value)
#else
#define LUMINAIRE_CAST(type, value) ((type)(value))
#endif

/* Light: linear red, green and blue in steps of 2^-14. */
typedef struct {
    uint32_t red, green, blue;
} luminaire_rgb;

/* TABLES */

/* ---- light ---- */

/* Returns the sum of two channels; saturates. */
static inline uint32_t luminaire_light_plus(uint32_t a, uint32_t b) {
    return a + b < a ? UINT32_C(0xffffffff) : a + b;
}

/* Returns a channel times a colour in steps of 2^-14, to nearest; saturates; 0 if negative. */
static inline uint32_t luminaire_light_filtered(uint32_t light, int16_t color) {
    uint32_t factor = color < 0 ? 0 : LUMINAIRE_CAST(uint32_t, color);
    uint32_t high = (light >> 16) * factor, low = ((light & 0xffff) * factor + (UINT32_C(1) << 13)) >> 14;
    return luminaire_light_plus(high >> 30 == 0 ? high << 2 : UINT32_C(0xffffffff), low);
}

/* Returns the sum of two lights; saturates. */
static inline luminaire_rgb luminaire_rgb_plus(luminaire_rgb a, luminaire_rgb b) {
    a.red = luminaire_light_plus(a.red, b.red);
    a.green = luminaire_light_plus(a.green, b.green);
    a.blue = luminaire_light_plus(a.blue, b.blue);
    return a;
}

/* Returns the light that a surface of a linear colour, in steps of 2^-14, reflects. */
static inline luminaire_rgb luminaire_rgb_filtered(luminaire_rgb light, const int16_t color[3]) {
    light.red = luminaire_light_filtered(light.red, color[0]);
    light.green = luminaire_light_filtered(light.green, color[1]);
    light.blue = luminaire_light_filtered(light.blue, color[2]);
    return light;
}

/* ---- codes ---- */

/* Returns the dither's threshold of the pixel at (x, y): an odd number of 128ths, 1 to 127. */
static inline uint32_t luminaire_threshold(uint32_t x, uint32_t y) {
    return LUMINAIRE_READ8(&luminaire_thresholds[(y & 7) << 3 | (x & 7)]);
}

/* Returns a channel clipped just below 1: the light there has the codes of 1. */
static inline uint32_t luminaire_clipped(uint32_t light) { return luminaire_min(light, (UINT32_C(1) << 14) - 1); }

/* Returns a code of 1 to 8 bits that no light with these upper eight bits is below. */
static inline uint32_t luminaire_start(uint32_t place, uint32_t bits) {
    uint32_t start = LUMINAIRE_READ8(&luminaire_starts[place]);
    return ((start << bits) - start) >> 8;
}

/* Returns the nearest code to a clipped channel, from a code up to it. */
static inline uint32_t luminaire_nearest(const uint16_t *nearest, uint32_t code, uint32_t light) {
    while (light >= LUMINAIRE_READ16(&nearest[code])) { ++code; }
    return code;
}

/* Returns the dithered code of a light below 1 in steps of 2^-24, from a code up to it. */
static inline uint32_t luminaire_dithered(
    const uint32_t *lights, uint32_t code, uint32_t light, uint32_t threshold
) {
    uint32_t here, next;
    while (light >= LUMINAIRE_READ32(&lights[code + 1])) { ++code; }
    here = LUMINAIRE_READ32(&lights[code]);
    next = LUMINAIRE_READ32(&lights[code + 1]);
    return code + ((light - here) << 7 > (next - here) * threshold);
}

/* Returns the nearest sRGB code of up to eight bits to a channel. */
static inline uint32_t luminaire_code(const uint16_t *nearest, uint32_t bits, uint32_t light) {
    light = luminaire_clipped(light);
    return luminaire_nearest(nearest, luminaire_start(light >> 6, bits), light);
}

/* Returns the dithered sRGB code of up to eight bits of a channel. */
static inline uint32_t luminaire_code_dithered(
    const uint32_t *lights, uint32_t bits, uint32_t light, uint32_t threshold
) {
    light = luminaire_clipped(light);
    return luminaire_dithered(lights, luminaire_start(light >> 6, bits), light << 10, threshold);
}

/* ---- pixels ---- */

/* Returns the sRGB code of a channel, from 0 to 255. */
static inline uint8_t luminaire_encode_srgb(uint32_t light) {
    return LUMINAIRE_CAST(uint8_t, luminaire_code(luminaire_nearest_8, 8, light));
}

/* Returns the sRGB code of a channel for the pixel at (x, y), with ordered dither. */
static inline uint8_t luminaire_encode_srgb_dithered(uint32_t light, uint32_t x, uint32_t y) {
    return LUMINAIRE_CAST(uint8_t, luminaire_code_dithered(luminaire_lights_8, 8, light, luminaire_threshold(x, y)));
}

/* Returns the three sRGB codes of a light as 0xRRGGBB. */
static inline uint32_t luminaire_srgb(luminaire_rgb light) {
    return luminaire_code(luminaire_nearest_8, 8, light.red) << 16
        | luminaire_code(luminaire_nearest_8, 8, light.green) << 8
        | luminaire_code(luminaire_nearest_8, 8, light.blue);
}

/* Returns the three sRGB codes of a light at (x, y) as 0xRRGGBB, with ordered dither. */
static inline uint32_t luminaire_srgb_dithered(luminaire_rgb light, uint32_t x, uint32_t y) {
    uint32_t threshold = luminaire_threshold(x, y);
    return luminaire_code_dithered(luminaire_lights_8, 8, light.red, threshold) << 16
        | luminaire_code_dithered(luminaire_lights_8, 8, light.green, threshold) << 8
        | luminaire_code_dithered(luminaire_lights_8, 8, light.blue, threshold);
}

/* Returns the nearest pixel of five bits of red above six of green and five of blue. */
static inline uint16_t luminaire_rgb565(luminaire_rgb light) {
    return LUMINAIRE_CAST(uint16_t, luminaire_code(luminaire_nearest_5, 5, light.red) << 11
        | luminaire_code(luminaire_nearest_6, 6, light.green) << 5
        | luminaire_code(luminaire_nearest_5, 5, light.blue));
}

/* Returns the pixel of RGB565 at (x, y), with ordered dither. */
static inline uint16_t luminaire_rgb565_dithered(luminaire_rgb light, uint32_t x, uint32_t y) {
    uint32_t threshold = luminaire_threshold(x, y);
    return LUMINAIRE_CAST(uint16_t, luminaire_code_dithered(luminaire_lights_5, 5, light.red, threshold) << 11
        | luminaire_code_dithered(luminaire_lights_6, 6, light.green, threshold) << 5
        | luminaire_code_dithered(luminaire_lights_5, 5, light.blue, threshold));
}

/* Writes a pixel of 16 bits with its upper byte first: the order of most displays on SPI. */
static inline void luminaire_high_first(uint16_t pixel, uint8_t bytes[2]) {
    bytes[0] = LUMINAIRE_CAST(uint8_t, pixel >> 8);
    bytes[1] = LUMINAIRE_CAST(uint8_t, pixel & 0xff);
}

/* Writes a pixel of 16 bits with its lower byte first. */
static inline void luminaire_low_first(uint16_t pixel, uint8_t bytes[2]) {
    bytes[0] = LUMINAIRE_CAST(uint8_t, pixel & 0xff);
    bytes[1] = LUMINAIRE_CAST(uint8_t, pixel >> 8);
}
