#include <Arduino.h>
#include <avr/sleep.h>
#line 1 "/work/ce/export/c/examples/Wall/Wall.ino"
/* A wall under a spotlight that does not move, as characters on the serial port.
 *
 * The light is constant: all its numbers are in key.h, which this command wrote on a computer:
 *
 *     luminaire export --to c-fx16 --name key --field 40 --position 2.5,1,3 --axis 0,0,-1 --intensity 9
 *
 * A constant light takes the least flash and time. For one that moves, see the example Spot.
 */
#include <luminaire.h>

#include "key.h"

const int COLUMNS = 60, ROWS = 16;
const int32_t METRE = 65536; // coordinates have steps of 1/65536

void setup() {
    Serial.begin(115200);
    // The wall faces us: its normal, of length 1 in steps of 1/16384, points along z.
    const int16_t normal[3] = { 0, 0, 16384 };
    for (int row = 0; row < ROWS; ++row) {
        for (int column = 0; column < COLUMNS; ++column) {
            // 12 columns and 8 rows to the metre.
            const int32_t point[3] = { column * (METRE / 12), row * (METRE / 8), 0 };
            const uint32_t light = key_irradiance(point, normal); // 16384 is full scale, and more is possible
            const uint32_t level = (light * 9) >> 14;
            Serial.print(" .:-=+*#%@"[level < 9 ? level : 9]);
        }
        Serial.println();
    }
}

void loop() {
}
int main() { init(); setup(); for (int i = 0; i < 20; ++i) loop(); Serial.flush(); cli(); sleep_cpu(); }
