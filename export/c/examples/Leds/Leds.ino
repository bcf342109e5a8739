/* A ring of 64 LEDs around a lampshade, lit by four spotlights that circle around it: an LED shows
 * the light that arrives where it is. When the supply would not suffice, all are dimmed alike. The
 * bytes for a strip of WS2812 are printed: to light one, send them by a library for WS2812.
 */
#include <luminaire_display.h> // includes luminaire.h

const int LEDS = 64, LAMPS = 4;
const int32_t METRE = 65536;   // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536; // and so have degrees

// A quarter of a sine for the 64 places on the ring, in steps of 1/16384. It stays in flash.
const int16_t SINE[17] LUMINAIRE_TABLE = { 0, 1606, 3196, 4756, 6270, 7723, 9102, 10394, 11585,
    12665, 13623, 14449, 15137, 15679, 16069, 16305, 16384 };
const int16_t COLORS[LAMPS][3] = { { 16384, 4000, 0 }, { 0, 16384, 3000 }, { 2000, 0, 16384 },
    { 16384, 0, 9000 } }; // linear red, green and blue: 16384 is 1
// The supply gives 600 mA. A channel of an LED takes 12 mA when fully on, and a dark LED 1 mA.
const luminaire_strip STRIP = { 600, 12, 1, LUMINAIRE_LED_GRB };

luminaire_spot spot;        // one after the other, because all four have the same cone
luminaire_rgb lights[LEDS];
uint16_t carries[3 * LEDS]; // of each light what eight bits cannot show: later frames do

int16_t sine(int place) {
    const int falling = place & 16, rest = place & 15;
    const int16_t value = (int16_t)LUMINAIRE_READ_16(&SINE[falling ? 16 - rest : rest]);
    return place & 32 ? -value : value;
}

void setup() {
    Serial.begin(115200);
    luminaire_cone cone;
    int refusal = luminaire_cone_from_field(&cone, 1, 50 * DEGREE); // a hard edge
    const int32_t start[3] = { METRE, 0, 0 }; // changed in each frame
    if (!refusal) { refusal = luminaire_spot_set_up(&spot, &cone, start, start, METRE / 2); }
    Serial.println(refusal); // 0; luminaire.h has the codes of what it refuses
    for (int i = 0; i < 3 * LEDS; ++i) { carries[i] = luminaire_phase(i); }
}

void loop() {
    static int frame = 0;
    for (int led = 0; led < LEDS; ++led) { lights[led] = luminaire_rgb(); }
    for (int lamp = 0; lamp < LAMPS; ++lamp) {
        // A metre from the middle, two lamps turn left and two right, at different speeds.
        const int place = lamp * 16 + (lamp & 1 ? -frame : frame) * (lamp + 1);
        const int32_t x = INT32_C(4) * sine(place + 16), z = INT32_C(4) * sine(place);
        const int32_t position[3] = { x, METRE / 4, z };
        luminaire_spot_move(&spot, position);
        const int32_t inwards[3] = { -x, -METRE / 4, -z };
        luminaire_spot_aim_along(&spot, inwards);
        luminaire_spot_tint(&spot, COLORS[lamp]);
        for (int led = 0; led < LEDS; ++led) {
            // An LED faces outwards, a quarter of a metre from the middle.
            const int16_t normal[3] = { sine(led + 16), 0, sine(led) };
            const int32_t point[3] = { normal[0], 0, normal[2] };
            const luminaire_rgb more = luminaire_spot_light(&spot, point, normal);
            lights[led] = luminaire_rgb_plus(lights[led], more);
        }
    }
    // Where there is room for all bytes, luminaire_strip_write does this in one call.
    const uint32_t factor = luminaire_strip_factor(&STRIP, lights, LEDS);
    for (int i = 0; i < 3 * LEDS; ++i) {
        const luminaire_rgb light = lights[i / 3];
        const uint32_t channel = i % 3 == 0 ? light.green : i % 3 == 1 ? light.red : light.blue;
        const uint16_t byte = luminaire_next_dimmed(&carries[i], channel, 8, factor);
        for (int bits = 4; bits >= 0; bits -= 4) { Serial.print("0123456789abcdef"[byte >> bits & 15]); }
        if (i % 24 == 23) { Serial.println(); } // eight LEDs
    }
    frame = (frame + 1) % 64;
}
