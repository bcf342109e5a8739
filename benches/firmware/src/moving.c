/* Two coloured spotlights, set up from their field angles in degrees, that follow two points: pictures of 240 rows of
 * RGB565. Its size is that of a whole program, without what starts it. */
#include "luminaire.h"

uint16_t pixels[240];

static void draw(luminaire_spot spots[2], int32_t target) {
    static const int16_t toward[3] = { 0, 0, 1 << 14 };
    for (int i = 0; i < 2; ++i) {
        int32_t point[3] = { i ? -target : target, target >> 1, 0 };
        luminaire_spot_aim(&spots[i], point);
    }
    for (int32_t y = 0; y < 240; ++y) {
        for (int32_t x = 0; x < 240; ++x) {
            int32_t point[3] = { (x - 120) * 1024, (120 - y) * 1024, 0 };
            luminaire_rgb light = luminaire_spot_light(&spots[0], point, toward);
            pixels[x] = luminaire_rgb565(luminaire_rgb_plus(light, luminaire_spot_light(&spots[1], point, toward)));
        }
    }
}

int main(void) {
    static const int32_t places[2][3] = { { -(2 << 16), 0, 4 << 16 }, { 2 << 16, 0, 4 << 16 } }, into[3] = { 0, 0, -1 };
    static const int16_t colors[2][3] = { { 16384, 10000, 5000 }, { 5000, 9000, 16384 } };
    luminaire_spot spots[2];
    for (int i = 0; i < 2; ++i) {
        luminaire_cone cone;
        luminaire_cone_from_field(&cone, LUMINAIRE_SOFT, 36 * LUMINAIRE_DEGREE);
        luminaire_spot_set_up(&spots[i], &cone, places[i], into, INT32_C(16) << 16);
        luminaire_spot_tint(&spots[i], colors[i]);
    }
    for (int32_t target = 0;; target += 1 << 12) { draw(spots, target & 0x3ffff); }
}
