/* A wall lit by a moving head that a lighting console controls, on an ESP32: DMX512 comes in by the library esp_dmx, and a
 * colour display is driven by LovyanGFX. The console has the fixture at address 1, with nine slots: pan and tilt of two
 * each, dimmer, zoom, red, green and blue. Nothing here is a float.
 */
#define LGFX_AUTODETECT // the library finds the board; boards that it does not know have a class of their own
#include <LovyanGFX.hpp>
#include <esp_dmx.h>
#include <luminaire_dmx.h>

const int32_t METRE = 65536;                        // coordinates have steps of 1/65536
const dmx_port_t PORT = 1;                          // a serial port of the chip
const int TRANSMIT = 17, RECEIVE = 16, ENABLE = 21; // the pins of the transceiver for RS-485
const uint16_t ADDRESS = 1;
const int MOST = 480; // the columns that there is room for

LGFX lcd;
luminaire_spot narrow, wide; // the ends of the zoom
luminaire_patch patch = LUMINAIRE_PATCH;

void setup() {
    lcd.init();
    dmx_config_t config = DMX_CONFIG_DEFAULT;
    dmx_personality_t personalities[] = { { 9, "Moving head" } };
    dmx_driver_install(PORT, &config, personalities, 1);
    dmx_set_pin(PORT, TRANSMIT, RECEIVE, ENABLE);

    // A metre and a half in front of the wall, with field angles of 10 to 45 degrees.
    const int32_t position[3] = { 0, 0, METRE * 3 / 2 }, down[3] = { 0, -METRE, 0 };
    luminaire_cone cone;
    luminaire_cone_from_field(&cone, LUMINAIRE_HARD, 10 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&narrow, &cone, position, down, 2 * METRE);
    luminaire_cone_from_field(&cone, LUMINAIRE_HARD, 45 * LUMINAIRE_DEGREE);
    luminaire_spot_set_up(&wide, &cone, position, down, 2 * METRE);

    luminaire_channel_at(&patch.pan, ADDRESS, ADDRESS + 1, LUMINAIRE_TURN_OF(-270), LUMINAIRE_TURN_OF(270));
    luminaire_channel_at(&patch.tilt, ADDRESS + 2, ADDRESS + 3, LUMINAIRE_TURN_OF(-135), LUMINAIRE_TURN_OF(135));
    luminaire_channel_at(&patch.dimmer, ADDRESS + 4, 0, 0, LUMINAIRE_TURN);
    luminaire_channel_at(&patch.zoom, ADDRESS + 5, 0, 0, LUMINAIRE_TURN);
    for (int i = 0; i < 3; ++i) { luminaire_channel_at(&patch.color[i], ADDRESS + 6 + i, 0, 0, LUMINAIRE_TURN); }
}

void loop() {
    static uint8_t bytes[DMX_PACKET_SIZE];
    dmx_packet_t packet;
    if (!dmx_receive(PORT, &packet, DMX_TIMEOUT_TICK) || packet.err || packet.sc != 0) { return; }
    const uint32_t size = dmx_read(PORT, bytes, packet.size);
    if (size == 0) { return; }
    luminaire_spot spot;
    luminaire_spot_patch(&spot, &narrow, &wide, &patch, bytes + 1, size - 1); // the first byte is the start code

    static luminaire_rgb lights[MOST];
    static uint16_t pixels[2][MOST]; // the row that is sent, and the next one
    const int width = lcd.width() < MOST ? lcd.width() : MOST, height = lcd.height();
    const int32_t step = 2 * METRE / width;
    lcd.startWrite();
    for (int y = 0; y < height; ++y) {
        const luminaire_row row = { { -METRE, (height / 2 - y) * step, 0 }, { step, 0, 0 }, { 0, 0, 16384 } };
        for (int x = 0; x < width; ++x) { lights[x] = luminaire_rgb(); }
        luminaire_row_add(lights, &row, &spot, width);
        uint16_t *next = pixels[y & 1];
        for (int x = 0; x < width; ++x) { next[x] = luminaire_rgb565_dithered(lights[x], x, y); }
        lcd.pushImageDMA(0, y, width, 1, (const lgfx::rgb565_t *)next);
    }
    lcd.endWrite();
}
