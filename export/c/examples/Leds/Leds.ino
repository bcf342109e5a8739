/* A ring of 256 LEDs around a lampshade, lit by four spotlights that circle around it: an LED shows
 * the light that arrives where it is. When the supply would not suffice, all are dimmed alike. Each LED is
 * written by itself, so that an Uno has room for them. The bytes for a strip of WS2812 are printed: to
 * light one, send them by a library for WS2812.
 */
#include <luminaire_display.h> // includes luminaire.h

const int LEDS = 256, LAMPS = 4;
const int32_t METRE = 65536;   // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536; // and so have degrees

const int16_t COLORS[LAMPS][3] = { { 16384, 4000, 0 }, { 0, 16384, 3000 }, { 2000, 0, 16384 },
    { 16384, 0, 9000 } }; // linear red, green and blue: 16384 is 1
// The supply gives 2 A. A channel of an LED takes 12 mA when fully on, and a dark LED 1 mA. No light is
// left out: for a dim room, a large share that is left out keeps the hue, and small intensities do not.
const luminaire_strip STRIP = { 2000, 12, 1, LUMINAIRE_LED_GRB, 0 };

luminaire_spot spots[LAMPS];
luminaire_frame frame; // what the light of the last frame needed

// The sine of 256 places on the ring, in steps of 1/16384.
int16_t sine(int place) { return luminaire_sine((uint32_t)place * 256); }

void setup() {
    Serial.begin(115200);
    luminaire_cone cone;
    int refusal = luminaire_cone_from_field(&cone, 1, 50 * DEGREE); // a hard edge
    const int32_t start[3] = { METRE, 0, 0 }; // changed in each frame
    for (int lamp = 0; lamp < LAMPS && !refusal; ++lamp) {
        refusal = luminaire_spot_set_up(&spots[lamp], &cone, start, start, METRE / 2);
        luminaire_spot_tint(&spots[lamp], COLORS[lamp]);
    }
    Serial.println(refusal); // 0; luminaire.h has the codes of what it refuses
}

void loop() {
    static int number = 0;
    for (int lamp = 0; lamp < LAMPS; ++lamp) {
        // A metre from the middle, two lamps turn left and two right, at different speeds.
        const int place = lamp * 64 + 4 * (lamp & 1 ? -number : number) * (lamp + 1);
        const int32_t x = INT32_C(4) * sine(place + 64), z = INT32_C(4) * sine(place);
        const int32_t position[3] = { x, METRE / 4, z };
        luminaire_spot_move(&spots[lamp], position);
        const int32_t inwards[3] = { -x, -METRE / 4, -z };
        luminaire_spot_aim_along(&spots[lamp], inwards);
    }
    luminaire_strip_begin(&frame, &STRIP, LEDS);
    for (int led = 0; led < LEDS; ++led) {
        // An LED faces outwards, a quarter of a metre from the middle.
        const int16_t normal[3] = { sine(led + 64), 0, sine(led) };
        const int32_t point[3] = { normal[0], 0, normal[2] };
        luminaire_rgb light = luminaire_rgb();
        for (int lamp = 0; lamp < LAMPS; ++lamp) {
            light = luminaire_rgb_plus(light, luminaire_spot_light(&spots[lamp], point, normal));
        }
        uint8_t bytes[3];
        uint16_t carries[3]; // what eight bits cannot show, later frames do
        luminaire_led_start(carries, STRIP.order, led + number);
        luminaire_strip_next(bytes, carries, &frame, &STRIP, light);
        for (int digit = 0; digit < 6; ++digit) {
            Serial.print("0123456789abcdef"[bytes[digit / 2] >> (digit & 1 ? 0 : 4) & 15]);
        }
        if (led % 8 == 7) { Serial.println(); }
    }
    number = (number + 1) % 64;
}
