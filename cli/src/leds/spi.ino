/* {COUNT} LEDs ({CHIP}) at their places, lit by {WHAT}.
 * {TAKES}
 * They are on the pins of SPI, clock and data. The light comes from the library luminaire. */
#include <SPI.h>

#include "leds.h"

{PERIOD}{NAME}_scene scene = {NAME}_start;
luminaire_frame frame;

void setup() { SPI.begin(); }

void repeat(uint8_t value, uint32_t count) {
    while (count-- > 0) { SPI.transfer(value); }
}

void loop() {
    static uint32_t number = 0;
{MOVE}    luminaire_strip_begin(&frame, &{NAME}_strip, {GUARD}_COUNT);
    SPI.beginTransaction(SPISettings(4000000, MSBFIRST, {MODE}));
    repeat(0, {BEGIN});
    for (uint32_t led = 0; led < {GUARD}_COUNT; ++led) {
        uint8_t bytes[{GUARD}_BYTES];
        {NAME}_next(bytes, &frame, &scene, led, number);
        for (uint32_t i = 0; i < {GUARD}_BYTES; ++i) { SPI.transfer(bytes[i]); }
    }
    repeat({LAST}, {END});
    SPI.endTransaction();
    ++number;
}
