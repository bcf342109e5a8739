/* A sprite with a normal map, lit by a spotlight that swings from left to right in front of it. The
 * frames have four levels of grey, dithered, as on a small OLED, and are printed as characters.
 */
#include <luminaire_display.h> // includes luminaire.h

#include "ball.h" // the normal map: red, green and blue of each pixel

const int32_t METRE = 65536;             // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536;           // and so have degrees
const int32_t PIXEL = METRE / BALL_SIZE; // the sprite is a metre wide

luminaire_spot spot;

void setup() {
    Serial.begin(115200);
    // A field angle of 60 degrees, with a soft edge. At 2 metres an intensity of 6 is 6 / (2 x 2)
    // of full scale. The brightest part of the ball is therefore white.
    const int32_t position[3] = { 0, 0, 2 * METRE }, ahead[3] = { 0, 0, -METRE };
    luminaire_cone cone;
    int refusal = luminaire_cone_from_field(&cone, 0, 60 * DEGREE);
    if (!refusal) { refusal = luminaire_spot_set_up(&spot, &cone, position, ahead, 6 * METRE); }
    Serial.println(refusal); // 0; luminaire.h has the codes of what it refuses
}

void loop() {
    // The light is at x = -2, -1, 0, 1 and 2 metres above the ball, and aims at its middle. y points
    // down, as the rows are printed.
    static int frame = 0;
    const int32_t position[3] = { (frame - 2) * METRE, -METRE, 2 * METRE };
    const int32_t middle[3] = { 0, 0, 0 };
    luminaire_spot_move(&spot, position);
    luminaire_spot_aim(&spot, middle);
    frame = (frame + 1) % 5;

    luminaire_row row = luminaire_row();
    row.first[0] = -METRE / 2;
    row.step[0] = PIXEL;
    for (int y = 0; y < BALL_SIZE; ++y) {
        // The map stays in flash, which an AVR reads by instructions of its own: copy a row to RAM.
        uint8_t map[3 * BALL_SIZE];
        int8_t normals[3 * BALL_SIZE];
        for (int i = 0; i < 3 * BALL_SIZE; ++i) {
            map[i] = LUMINAIRE_READ_8(&ball[y][i]);
        }
        // Its green points up, as in OpenGL; for a map of DirectX there is another function.
        luminaire_normals_from_opengl(normals, map, BALL_SIZE);
        luminaire_rgb lights[BALL_SIZE] = {}; // dark, until lights are added
        row.first[1] = y * PIXEL - METRE / 2;
        luminaire_row_add_facing(lights, &row, &spot, normals, BALL_SIZE);
        for (int x = 0; x < BALL_SIZE; ++x) {
            const char shade = " -+#"[luminaire_pixel_dithered(LUMINAIRE_GRAY2, lights[x], x, y)];
            Serial.print(shade); // twice, because characters are higher than wide
            Serial.print(shade);
        }
        Serial.println();
    }
}
