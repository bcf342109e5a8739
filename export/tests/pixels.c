/* Evaluates all outputs of colours, strips and rows of pixels that it reads as words. */
#include "luminaire_display.h"
#include "palette.h"
#include <stddef.h>

/* The casts that the warnings of C++ allow. */
#if defined(__cplusplus)
#define CAST(type, value) static_cast<type>(value)
#else
#define CAST(type, value) ((type)(value))
#endif

#if __STDC_HOSTED__
#include <stdio.h>

static uint32_t get(void) {
    uint32_t word = 0;
    return fread(&word, 4, 1, stdin) == 1 ? word : 0;
}

static void put(uint32_t word) { fwrite(&word, 4, 1, stdout); }
#else
uint32_t get(void);
void put(uint32_t word);
#endif

/* Writes one word of the codes at all places of the dither. */
#define PUT_EACH(code) do { \
    uint32_t hash = 0, x, y; \
    for (y = 0; y < 8; ++y) { \
        for (x = UINT32_C(0xfffffff8); x != 0; ++x) { hash = hash * 31 + (code); } \
    } \
    put(hash); \
} while (0)

#define PUT_PIXEL(format) \
    put(luminaire_pixel(format, light)); \
    put(luminaire_pixel_dithered(format, light, place, place >> 3))

static void colors(void) {
    uint32_t count = get(), place, bits;
    for (place = 0; place < count; ++place) {
        luminaire_rgb light, sum;
        int16_t color[3];
        uint16_t texel;
        uint8_t bytes[2];
        light.red = get();
        light.green = get();
        light.blue = get();
        PUT_EACH(luminaire_srgb_dithered(light, x, y));
        PUT_EACH(luminaire_rgb565_dithered(light, x, y));
        PUT_EACH(luminaire_pixel_dithered(LUMINAIRE_RGB332, light, x, y));
        PUT_EACH(luminaire_pixel_dithered(LUMINAIRE_RGB444, light, x, y));
        PUT_EACH(luminaire_pixel_dithered(LUMINAIRE_GRAY1, light, x, y));
        PUT_EACH(luminaire_pixel_dithered(LUMINAIRE_GRAY2, light, x, y));
        PUT_EACH(luminaire_pixel_dithered(LUMINAIRE_GRAY4, light, x, y));
        PUT_EACH(luminaire_pixel_dithered(LUMINAIRE_GRAY8, light, x, y));
        PUT_EACH(luminaire_gamma22_dithered(light.red, x, y));
        PUT_EACH(luminaire_gamma28_dithered(light.red, x, y));
        PUT_EACH(luminaire_duty_dithered(light.red, x, y));
        PUT_PIXEL(LUMINAIRE_GRAY1);
        PUT_PIXEL(LUMINAIRE_GRAY2);
        PUT_PIXEL(LUMINAIRE_GRAY4);
        PUT_PIXEL(LUMINAIRE_GRAY8);
        PUT_PIXEL(LUMINAIRE_RGB332);
        PUT_PIXEL(LUMINAIRE_RGB444);
        PUT_PIXEL(LUMINAIRE_RGB555);
        PUT_PIXEL(LUMINAIRE_RGB565);
        PUT_PIXEL(LUMINAIRE_RGB666);
        PUT_PIXEL(LUMINAIRE_RGB888);
        put(luminaire_srgb(light));
        luminaire_high_first(bytes, luminaire_rgb565(light));
        put(bytes[0] * 256u + bytes[1]);
        luminaire_low_first(bytes, luminaire_rgb565(light));
        put(bytes[0] * 256u + bytes[1]);
        put(luminaire_encode_srgb(light.red));
        put(luminaire_encode_srgb_dithered(light.red, place, place >> 3));
        put(luminaire_gamma22(light.red));
        put(luminaire_gamma28(light.red));
        put(luminaire_palette_nearest(&palette, light));
        put(luminaire_palette_dithered(&palette, light, place, place >> 3));
        for (bits = 1; bits <= 16; ++bits) { put(luminaire_duty(light.red, bits)); }
        color[0] = CAST(int16_t, light.red & 0x7fff);
        color[1] = CAST(int16_t, 20000 - color[0]);
        color[2] = CAST(int16_t, -1 - color[0]);
        sum = luminaire_rgb_plus(light, luminaire_rgb_filtered(light, color));
        put(sum.red);
        put(sum.green);
        put(sum.blue);
        texel = CAST(uint16_t, place & 0xffff);
        put(CAST(uint32_t, luminaire_decode_srgb(CAST(uint8_t, texel & 0xff))));
        luminaire_row_texture(&light, &texel, 1);
        put(light.red);
        put(light.green);
        put(light.blue);
    }
}

static void temporal(void) {
    uint32_t bits, light;
    for (bits = 1; bits <= 16; ++bits) {
        uint16_t carry = luminaire_phase(bits);
        for (light = 0; light < 16400; ++light) { put(luminaire_next_duty(&carry, light, bits)); }
    }
}

#define MOST 64 /* LEDs and pixels */

static void strips(void) {
    uint32_t count = get(), i, frame;
    while (count-- > 0) {
        luminaire_strip strip;
        luminaire_frame stream = { 0, 0, 0 };
        luminaire_rgb lights[MOST];
        uint16_t carries[4 * MOST];
        uint8_t bytes[8 * MOST];
        uint32_t leds = get(), size, words;
        strip.order = CAST(int, get());
        size = luminaire_led_bytes(strip.order);
        words = luminaire_led_carries(strip.order);
        strip.most = get();
        strip.channel = CAST(uint16_t, get());
        strip.idle = CAST(uint16_t, get());
        strip.dimmed = get();
        for (i = 0; i < leds; ++i) {
            lights[i].red = get();
            lights[i].green = get();
            lights[i].blue = get();
        }
        for (i = 0; i < leds; ++i) { luminaire_led_start(carries + words * i, strip.order, i); }
        for (frame = 0; frame < 3; ++frame) {
            luminaire_strip_write(bytes, carries, &strip, lights, leds);
            for (i = 0; i < size * leds; ++i) { put(bytes[i]); }
        }
        for (frame = 0; frame < 3; ++frame) {
            luminaire_strip_begin(&stream, &strip, leds);
            for (i = 0; i < leds; ++i) {
                luminaire_strip_next(bytes + size * i, carries + words * i, &stream, &strip, lights[i]);
            }
            for (i = 0; i < size * leds; ++i) { put(bytes[i]); }
        }
        luminaire_strip_write(NULL, NULL, &strip, NULL, 0);
        luminaire_strip_begin(NULL, &strip, 1);
        luminaire_strip_next(NULL, NULL, NULL, &strip, lights[0]);
    }
}

static void rows(void) {
    uint32_t count = get(), i;
    while (count-- > 0) {
        uint8_t bytes[3 * MOST];
        uint32_t format = get(), order = get(), size = get(), pixels = get(), packed = 0;
        luminaire_packer packer = luminaire_packer_into(size > 0 ? bytes : NULL, size);
        for (i = 0; i < sizeof bytes; ++i) { bytes[i] = 0xaa; }
        for (i = 0; i < pixels; ++i) {
            uint32_t pixel = get();
            packed += luminaire_pack(&packer, format, CAST(int, order), pixel) != 0;
        }
        luminaire_pack_end(&packer, CAST(int, order));
        put(packed);
        for (i = 0; i < sizeof bytes; ++i) { put(bytes[i]); }
    }
}

int main(void) {
    colors();
    temporal();
    strips();
    rows();
    return 0;
}
