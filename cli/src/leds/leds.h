/* {COUNT} LEDs ({CHIP}) at their places, and what lights them, written by luminaire: do not edit.
 * A place has steps of 2^-16, and the way that an LED faces has steps of 2^-14. Both stay in flash. */
#ifndef {GUARD}_LEDS_H
#define {GUARD}_LEDS_H

#include <luminaire_display.h>

#include "{NAME}_lights.h"

#define {GUARD}_COUNT UINT32_C({COUNT})
#define {GUARD}_BYTES UINT32_C({BYTES}) /* of an LED */

static const int32_t {NAME}_places[{GUARD}_COUNT][3] LUMINAIRE_TABLE = {
{PLACES}};
static const int16_t {NAME}_facing[{GUARD}_COUNT][3] LUMINAIRE_TABLE = {
{FACING}};

/* Milliamperes of the supply, of a channel at full duty and of a dark LED; the chip; the share of light that is left
 * out, in steps of 2^-16. */
static const luminaire_strip {NAME}_strip = { {STRIP} };

/* A quarter of a sine, in steps of 2^-14. */
static const int16_t {NAME}_quarter[18] LUMINAIRE_TABLE = { 0, 1606, 3196, 4756, 6270, 7723, 9102, 10394, 11585, 12665,
    13623, 14449, 15137, 15679, 16069, 16305, 16384, 16384 };

/* The sine of a turn, of which 65536 is a whole one. */
static inline int32_t {NAME}_sine(uint32_t turn) {
    const uint32_t part = turn & 16383, at = turn & 16384 ? 16384 - part : part;
    const int32_t before = (int16_t)LUMINAIRE_READ_16(&{NAME}_quarter[at >> 10]);
    const int32_t after = (int16_t)LUMINAIRE_READ_16(&{NAME}_quarter[(at >> 10) + 1]);
    const int32_t value = before + (after - before) * (int32_t)(at & 1023) / 1024;
    return turn & 32768 ? -value : value;
}

/* Turns x and z about the upright axis through the middle of the LEDs. */
static inline void {NAME}_turned(int32_t to[3], const int32_t from[3], const int32_t middle[2], uint32_t turn) {
    const int64_t x = (int64_t)from[0] - middle[0], z = (int64_t)from[2] - middle[1];
    const int32_t sine = {NAME}_sine(turn), cosine = {NAME}_sine(turn + 16384);
    to[0] = middle[0] + (int32_t)((x * cosine - z * sine) / 16384);
    to[1] = from[1];
    to[2] = middle[1] + (int32_t)((x * sine + z * cosine) / 16384);
}

/* Turns one light from where it starts. */
static inline void {NAME}_light_turned(luminaire_spot *light, const luminaire_spot *start, int aims, uint32_t turn) {
    static const int32_t middle[2] = { {MIDDLE} }, none[2] = { 0, 0 };
    int32_t to[3];
    {NAME}_turned(to, start->position, middle, turn);
    luminaire_spot_move(light, to);
    if (!aims) { return; }
    {NAME}_turned(to, start->axis, none, turn);
    luminaire_spot_aim_along(light, to);
}

/* Turns one light that is not round from where it starts. */
static inline void {NAME}_measured_turned(luminaire_measured *light, const luminaire_measured *start, uint32_t turn) {
    static const int32_t none[2] = { 0, 0 };
    int32_t axis[3], side[3];
    {NAME}_light_turned(&light->spot, &start->spot, 0, turn);
    {NAME}_turned(axis, start->spot.axis, none, turn);
    {NAME}_turned(side, start->side, none, turn);
    if (luminaire_unit(axis, luminaire_origin, axis) && luminaire_unit(side, luminaire_origin, side)) {
        luminaire_measured_set_frame(light, axis, side);
    }
}

/* Turns the lights about the LEDs, each in the other way than the one before. 65536 is a whole turn. */
static inline void {NAME}_turn({NAME}_scene *scene, uint32_t turn) {
    (void)scene;
    (void)turn;
{TURNS}}

/* Writes the bytes of an LED in a frame that luminaire_strip_begin has begun. number counts the frames: what eight bits
 * cannot show, later frames do. */
static inline void {NAME}_next(
    uint8_t *bytes, luminaire_frame *frame, const {NAME}_scene *scene, uint32_t led, uint32_t number
) {
    int32_t place[3];
    int16_t facing[3];
    int i;
{CARRIES}
    for (i = 0; i < 3; ++i) {
        place[i] = (int32_t)LUMINAIRE_READ_32(&{NAME}_places[led][i]);
        facing[i] = (int16_t)LUMINAIRE_READ_16(&{NAME}_facing[led][i]);
    }
    luminaire_strip_next(bytes, carries, frame, &{NAME}_strip, {NAME}_light(scene, place, facing));
}

#endif
