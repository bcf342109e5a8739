/* A stage in the light of a scene, row by row on a colour display that TFT_eSPI drives. The setup file of
 * that library says which display it is, and on which pins.
 *
 * The scene is lights.json: two spotlights, a lantern and the light of the night. On a computer this command wrote
 * stage.h:
 *
 *     luminaire export --from lights.json --scene stage --to c-fx16 --output stage.h
 */
#include <TFT_eSPI.h>
#include <luminaire_display.h>

#include "stage.h"

const int32_t METRE = 65536; // coordinates have steps of 1/65536
const int MOST = 480;        // the columns that there is room for

TFT_eSPI tft;
stage_scene scene = stage_start; // a program changes its copy: scene.key is a light

void setup() {
    tft.init();
    tft.setRotation(1);
    tft.setSwapBytes(true); // the pixels are words of this processor
}

void loop() {
    // The key light follows a point that goes to and fro on the stage.
    static int frame = 0;
    const int32_t along = frame < 32 ? frame : 64 - frame;
    const int32_t target[3] = { (along - 16) * (METRE / 16), 0, 0 };
    luminaire_spot_aim(&scene.key, target);
    frame = (frame + 1) % 64;

    static luminaire_rgb lights[MOST];
    static uint16_t pixels[MOST];
    const int width = tft.width() < MOST ? tft.width() : MOST, height = tft.height();
    // The stage is 4 metres wide, and faces up. A row of the picture is a row of it.
    const int32_t step = 4 * METRE / width;
    tft.startWrite();
    for (int y = 0; y < height; ++y) {
        const luminaire_row row = { { -2 * METRE, 0, (y - height / 2) * step }, { step, 0, 0 }, { 0, 16384, 0 } };
        for (int x = 0; x < width; ++x) { lights[x] = luminaire_rgb(); }
        stage_row_add(lights, &row, &scene, width);
        for (int x = 0; x < width; ++x) { pixels[x] = luminaire_rgb565_dithered(lights[x], x, y); }
        tft.setAddrWindow(0, y, width, 1);
        tft.pushPixels(pixels, width);
    }
    tft.endWrite();
}
