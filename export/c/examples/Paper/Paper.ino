/* A wall under a spotlight in black and white, on electronic paper that GxEPD2 drives. It is drawn again each
 * minute, with the light a little farther along the wall.
 */
#include <GxEPD2_BW.h>
#include <luminaire_display.h>

const int32_t METRE = 65536;   // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536; // and so have degrees

// A panel of 296 x 128, on the pins of SPI and these: chip select, data or command, reset, busy.
GxEPD2_BW<GxEPD2_290_T94_V2, GxEPD2_290_T94_V2::HEIGHT> display(GxEPD2_290_T94_V2(5, 17, 16, 4));
luminaire_spot spot;

void setup() {
    display.init();
    display.setRotation(1);
    luminaire_cone cone;
    const int32_t position[3] = { METRE, METRE / 2, METRE }, forward[3] = { 0, 0, -METRE };
    luminaire_cone_from_beam_and_field(&cone, 25 * DEGREE, 45 * DEGREE);
    luminaire_spot_set_up(&spot, &cone, position, forward, METRE);
}

void loop() {
    static int frame = 0;
    const int32_t along = (METRE / 4) * (frame + 1); // of a wall of two metres
    const int32_t position[3] = { along, METRE / 2, METRE };
    luminaire_spot_move(&spot, position);
    frame = (frame + 1) % 7;

    const int16_t normal[3] = { 0, 0, 16384 }; // the wall faces us
    const int32_t step = 2 * METRE / display.width();
    display.setFullWindow();
    display.firstPage();
    do {
        // A processor with little memory draws the picture in parts, each of which the library keeps.
        for (int y = 0; y < display.height(); ++y) {
            for (int x = 0; x < display.width(); ++x) {
                const int32_t point[3] = { x * step, METRE - y * step, 0 };
                const luminaire_rgb light = luminaire_spot_light(&spot, point, normal);
                const bool isWhite = luminaire_pixel_dithered(LUMINAIRE_GRAY1, light, x, y);
                display.drawPixel(x, y, isWhite ? GxEPD_WHITE : GxEPD_BLACK);
            }
        }
    } while (display.nextPage());
    display.hibernate();
    delay(60000);
}
