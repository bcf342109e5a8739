/* A moving head on a wall, on a colour display that LovyanGFX drives. While a row goes to the display, the next
 * one is lit. Nothing here is a float.
 */
#define LGFX_AUTODETECT // the library finds the board; boards that it does not know have a class of their own
#include <LovyanGFX.hpp>
#include <luminaire_display.h>

const int32_t METRE = 65536;   // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536; // and so have degrees
const int MOST = 480;          // the columns that there is room for

LGFX lcd;
luminaire_spot narrow, wide; // the ends of the zoom

void setup() {
    lcd.init();
    // Both edges are hard, of the field angles 12 and 30 degrees. A metre and a half in front of the wall.
    const int32_t position[3] = { 0, 0, METRE * 3 / 2 }, forward[3] = { 0, 0, -METRE };
    const int16_t color[3] = { 16384, 9000, 4000 }; // linear red, green and blue: 16384 is 1
    luminaire_cone cone;
    luminaire_cone_from_field(&cone, 1, 12 * DEGREE);
    luminaire_spot_set_up(&narrow, &cone, position, forward, 2 * METRE);
    luminaire_cone_from_field(&cone, 1, 30 * DEGREE);
    luminaire_spot_set_up(&wide, &cone, position, forward, 2 * METRE);
    luminaire_spot_tint(&narrow, color);
}

void loop() {
    static int frame = 0;
    const int32_t along = frame < 32 ? frame : 64 - frame;
    const int32_t way[3] = { (along - 16) * (METRE / 64), 0, -METRE };
    luminaire_spot spot = narrow;
    luminaire_spot_zoom(&spot, &wide, along * 512); // of 16384
    luminaire_spot_aim_along(&spot, way);
    frame = (frame + 1) % 64;

    static luminaire_rgb lights[MOST];
    static uint16_t pixels[2][MOST]; // the row that is sent, and the next one
    const int width = lcd.width() < MOST ? lcd.width() : MOST, height = lcd.height();
    const int32_t step = METRE / width;
    lcd.startWrite();
    for (int y = 0; y < height; ++y) {
        const luminaire_row row = { { -METRE / 2, (height / 2 - y) * step, 0 }, { step, 0, 0 }, { 0, 0, 16384 } };
        for (int x = 0; x < width; ++x) { lights[x] = luminaire_rgb(); }
        luminaire_row_add(lights, &row, &spot, width);
        uint16_t *next = pixels[y & 1];
        for (int x = 0; x < width; ++x) { next[x] = luminaire_rgb565_dithered(lights[x], x, y); }
        lcd.pushImageDMA(0, y, width, 1, (const lgfx::rgb565_t *)next);
    }
    lcd.endWrite();
}
