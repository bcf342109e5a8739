#include <Arduino.h>
#include <avr/sleep.h>
#line 1 "/work/ce/export/c/examples/Spot/Spot.ino"
/* A moving head: a spotlight set up from the angles of a data sheet, which follows a point on the floor.
 * Each frame is printed as characters on the serial port. No number here is a float: the board needs none.
 */
#include <luminaire.h>

const int COLUMNS = 40, ROWS = 12;
const int32_t METRE = 65536;           // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536;         // and so have degrees

luminaire_spot spot;                   // 88 bytes: the light
luminaire_rgb lights[COLUMNS];         // the light on a row of the picture, red, green and blue
luminaire_row row;                     // where the row is

void setup() {
    Serial.begin(115200);

    // The data sheet says: beam angle 18 degrees (half the intensity), field angle 30 degrees (a tenth of it).
    luminaire_cone cone;
    int refusal = luminaire_cone_from_beam_and_field(&cone, 18 * DEGREE, 30 * DEGREE);

    // It hangs 4 metres over the middle of the floor (y is up) and shines down. Light falls with the square of
    // the distance, so an intensity of 4 x 4 is full scale on the floor below.
    const int32_t position[3] = { 2 * METRE, 4 * METRE, 2 * METRE }, down[3] = { 0, -METRE, 0 };
    if (!refusal) { refusal = luminaire_spot_set_up(&spot, &cone, position, down, 16 * METRE); }
    Serial.println(luminaire_refusal(refusal)); // what is wrong with the angles, or that nothing is

    const int16_t amber[3] = { 16384, 11000, 3000 }; // linear red, green and blue, 16384 is 1
    luminaire_spot_tint(&spot, amber);

    row.step[0] = METRE / 10;          // from one column to the next
    row.normal[1] = 16384;             // the floor faces up: its normal has the length 1
}

void loop() {
    // A point that runs round a square on the floor, an eighth of a metre per frame.
    static int frame = 0;
    const int side = frame / 16 % 4, along = frame % 16;
    const int32_t forth = METRE + along * (METRE / 8), back = 3 * METRE - along * (METRE / 8);
    const int32_t x = side == 0 ? forth : side == 1 ? 3 * METRE : side == 2 ? back : METRE;
    const int32_t z = side == 0 ? METRE : side == 1 ? forth : side == 2 ? 3 * METRE : back;
    const int32_t target[3] = { x, 0, z };
    luminaire_spot_aim(&spot, target);
    ++frame;

    for (int line = 0; line < ROWS; ++line) {
        // Rows add light, so that several lights can shine on the same pixels. It begins with none.
        for (int column = 0; column < COLUMNS; ++column) { lights[column] = luminaire_rgb(); }
        row.first[2] = line * (METRE / 3);
        luminaire_row_add(&row, &spot, lights, COLUMNS);
        for (int column = 0; column < COLUMNS; ++column) {
            // From light, which is linear, to a brightness from 0 to 255 as the eye sees it, and to a character.
            const uint8_t brightness = luminaire_encode_srgb(lights[column].red);
            Serial.print(" .:-=+*#%@"[brightness * 10 / 256]);
        }
        Serial.println();
    }
    Serial.println();
}
int main() { init(); setup(); for (int i = 0; i < 20; ++i) loop(); Serial.flush(); cli(); sleep_cpu(); }
