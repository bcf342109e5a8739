/* {COUNT} LEDs ({CHIP}) at their places, and what lights them, written by luminaire: do not edit.
 * {TAKES}
 * {STEPS} */
#ifndef {GUARD}_LEDS_H
#define {GUARD}_LEDS_H

#include <luminaire_display.h>

#include "{NAME}_lights.h"

#define {GUARD}_COUNT UINT32_C({COUNT})
#define {GUARD}_BYTES UINT32_C({BYTES}) /* of an LED */

static const int32_t {NAME}_places[{GUARD}_COUNT][3] LUMINAIRE_TABLE = {
{PLACES}};
{FACING}
/* Milliamperes of the supply, of a channel at full duty and of a dark LED; the chip; the share of light that is left
 * out, in steps of 2^-16. */
static const luminaire_strip {NAME}_strip = { {STRIP} };

{TURNING}/* Writes the bytes of an LED in a frame that luminaire_strip_begin has begun. number counts the frames: what eight bits
 * cannot show, later frames do. */
static inline void {NAME}_next(
    uint8_t *bytes, luminaire_frame *frame, const {NAME}_scene *scene, uint32_t led, uint32_t number
) {
    int32_t place[3];
{WAY}    int i;
{CARRIES}
    for (i = 0; i < 3; ++i) { place[i] = (int32_t)LUMINAIRE_READ_32(&{NAME}_places[led][i]); }
{READ}    luminaire_strip_next(bytes, carries, frame, &{NAME}_strip, {LIT});
}

#endif
