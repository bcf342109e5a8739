/* {COUNT} LEDs ({CHIP}) at their places, lit by {WHAT}.
 * {TAKES}
 * The light comes from the library luminaire, and goes to the strip by the library Adafruit NeoPixel. */
#include <Adafruit_NeoPixel.h>

#include "leds.h"

const int PIN = 6; // the data pin of the strip
{PERIOD}Adafruit_NeoPixel pixels({GUARD}_COUNT, PIN, {WIRE} + NEO_KHZ800);
{NAME}_scene scene = {NAME}_start;
luminaire_frame frame;

void setup() { pixels.begin(); }

void loop() {
    static uint32_t number = 0;
{MOVE}    luminaire_strip_begin(&frame, &{NAME}_strip, {GUARD}_COUNT);
    // The bytes in their order on the wire.
    uint8_t *bytes = pixels.getPixels();
    for (uint32_t led = 0; bytes && led < {GUARD}_COUNT; ++led) {
        {NAME}_next(bytes + {GUARD}_BYTES * led, &frame, &scene, led, number);
    }
    pixels.show();
    ++number;
}
