/* A moving head: a spotlight set up from the angles of a data sheet, which follows a point on the
 * floor. Each frame is printed as characters on the serial port. Nothing here is a float.
 */
#include <luminaire.h>

const int COLUMNS = 40, ROWS = 12;
const int32_t METRE = 65536;   // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536; // and so have degrees

luminaire_spot spot;           // the light, 88 bytes
luminaire_row row;             // where a row of the picture is on the floor
luminaire_rgb lights[COLUMNS]; // the red, green and blue light on it

void setup() {
    Serial.begin(115200);
    // The data sheet says: a beam angle of 18 degrees, at which half the intensity is left, and a
    // field angle of 30 degrees, at which a tenth is left.
    luminaire_cone cone;
    int refusal = luminaire_cone_from_beam_and_field(&cone, 18 * DEGREE, 30 * DEGREE);
    // It hangs 4 metres over the middle of the floor (y is up) and shines down. Light falls with
    // the square of the distance, so an intensity of 4 x 4 is full scale on the floor below.
    const int32_t position[3] = { 2 * METRE, 4 * METRE, 2 * METRE }, down[3] = { 0, -METRE, 0 };
    if (!refusal) { refusal = luminaire_spot_set_up(&spot, &cone, position, down, 16 * METRE); }
    Serial.println(luminaire_refusal(refusal)); // what is wrong, or that nothing is

    const int16_t amber[3] = { 16384, 11000, 3000 }; // linear red, green and blue: 16384 is 1
    luminaire_spot_tint(&spot, amber);
    row.step[0] = METRE / 10; // from one column to the next
    row.normal[1] = 16384;    // the floor faces up, by a normal of length 1
}

void loop() {
    // Aim at a point that runs round a square on the floor, an eighth of a metre per frame.
    static int frame = 0;
    const int side = frame / 16, along = frame % 16;
    const int32_t forth = METRE + along * (METRE / 8), back = 4 * METRE - forth;
    const int32_t x = side == 0 ? forth : side == 1 ? 3 * METRE : side == 2 ? back : METRE;
    const int32_t z = side == 0 ? METRE : side == 1 ? forth : side == 2 ? 3 * METRE : back;
    const int32_t target[3] = { x, 0, z };
    luminaire_spot_aim(&spot, target);
    frame = (frame + 1) % 64;

    for (int line = 0; line < ROWS; ++line) {
        // Light is added, so that several lights can shine on a row. It begins dark.
        for (int column = 0; column < COLUMNS; ++column) { lights[column] = luminaire_rgb(); }
        row.first[2] = line * (METRE / 3);
        luminaire_row_add(lights, &row, &spot, COLUMNS);
        for (int column = 0; column < COLUMNS; ++column) {
            // From linear light to the code of a display, 0 to 255, and to a character.
            const uint8_t code = luminaire_encode_srgb(lights[column].red);
            Serial.print(" .:-=+*#%@"[code * 10 / 256]);
        }
        Serial.println();
    }
    Serial.println();
}
