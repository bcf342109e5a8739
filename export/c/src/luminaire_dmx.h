/* luminaire_dmx.h: DMX512 turns, zooms, dims and colours a light, for C99 and C++11, with the bits of luminaire's module dmx.
 *
 * A console sends a universe of up to 512 bytes, the slots, up to 44 times a second. A patch says which of them a fixture
 * reads: each channel is a quantity of one slot or of a coarse and a fine one, from its value at 0 to that at the largest
 * number. The code has no floats, no division and no memory of its own. It is defined for all values, for null pointers too.
 *
 * Licence: MIT OR Apache-2.0, at your choice.
 */
#ifndef LUMINAIRE_DMX_H
#define LUMINAIRE_DMX_H

#include "luminaire.h"

/* Casts of C are the only ones that both languages have. */
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

#define LUMINAIRE_TURN (INT32_C(1) << 24) /* a whole turn as the value of a channel, and so are full scale and all of a zoom */

/* An angle in whole degrees as the value of a channel. */
#define LUMINAIRE_TURN_OF(degrees) ((int32_t)((int64_t)(degrees) * LUMINAIRE_TURN / 360))

/* One quantity of a fixture. */
typedef struct {
    uint16_t coarse, fine; /* the slots, from 1; 0 for none: without a coarse one the value is always the first */
    int32_t from, to;      /* the values at 0 and at the largest number, steps of 2^-24 of a turn or of full scale */
} luminaire_channel;

/* The channels of a fixture. Without pan and tilt its light points down, -y. Pan turns about the vertical, counterclockwise as
 * seen from above; a tilt of a quarter turn then aims along -z. */
typedef struct {
    luminaire_channel pan, tilt;
    luminaire_channel zoom;     /* 0 is the narrowest cone, LUMINAIRE_TURN the widest */
    luminaire_channel dimmer;
    luminaire_channel color[3]; /* linear red, green and blue; a cyan filter is a red from LUMINAIRE_TURN to 0 */
    luminaire_channel white;    /* adds to each of the colours, up to full scale */
    int32_t mount[3][3];        /* the rows of the matrix that turns the fixture's directions, steps of 2^-30 */
} luminaire_patch;

/* A patch of a fixture that hangs, without a channel: its light is as it was set up, but points down. */
#define LUMINAIRE_PATCH { \
    { 0, 0, 0, 0 }, { 0, 0, 0, 0 }, { 0, 0, 0, 0 }, { 0, 0, LUMINAIRE_TURN, LUMINAIRE_TURN }, \
    { { 0, 0, LUMINAIRE_TURN, LUMINAIRE_TURN }, { 0, 0, LUMINAIRE_TURN, LUMINAIRE_TURN }, \
      { 0, 0, LUMINAIRE_TURN, LUMINAIRE_TURN } }, { 0, 0, 0, 0 }, \
    { { INT32_C(1) << 30, 0, 0 }, { 0, INT32_C(1) << 30, 0 }, { 0, 0, INT32_C(1) << 30 } } }

/* Sets the slots of a channel, from 1. fine is 0 for a channel of 8 bits. */
static inline void luminaire_channel_at(luminaire_channel *channel, uint16_t coarse, uint16_t fine, int32_t from, int32_t to) {
    if (!channel) { return; }
    channel->coarse = coarse;
    channel->fine = fine;
    channel->from = from;
    channel->to = to;
}

/* Returns the value that the slots of a universe give. A slot that the universe lacks counts as 0. */
static inline int32_t luminaire_channel_value(const luminaire_channel *channel, const uint8_t *universe, uint32_t count) {
    uint32_t coarse, fine;
    int64_t range;
    if (!channel) { return 0; }
    if (channel->coarse == 0) { return channel->from; }
    coarse = universe && channel->coarse <= count ? universe[channel->coarse - 1] : 0;
    fine = channel->fine == 0 ? coarse : universe && channel->fine <= count ? universe[channel->fine - 1] : 0;
    range = (int64_t)channel->to - channel->from;
    if (range > INT64_C(100) * LUMINAIRE_TURN) { range = INT64_C(100) * LUMINAIRE_TURN; }
    if (range < INT64_C(-100) * LUMINAIRE_TURN) { range = INT64_C(-100) * LUMINAIRE_TURN; }
    /* The number out of 65,535, as a fraction of 2^32. */
    return (int32_t)(uint32_t)(uint64_t)(
        channel->from + ((range * (int64_t)((coarse << 8 | fine) * UINT32_C(65537)) + (INT64_C(1) << 31)) >> 32));
}

/* Returns the sine of an angle in steps of 2^-24 turns, with 30 fraction bits, within 2 steps. */
static inline int32_t luminaire_fine_sine(int32_t turn) {
    static const uint32_t parts[5] = {
        UINT32_C(14739), UINT32_C(688288), UINT32_C(20107567), UINT32_C(342277127), UINT32_C(2774394665)
    };
    const uint32_t place = (uint32_t)turn & ((UINT32_C(1) << 22) - 1);
    const uint32_t x = (uint32_t)turn & (UINT32_C(1) << 22) ? (UINT32_C(1) << 22) - place : place;
    uint64_t square = (uint64_t)x * x >> 12, sum = 0;
    int32_t sine;
    int i;
    if (square > UINT32_MAX) { square = UINT32_MAX; }
    for (i = 0; i < 5; ++i) { sum = parts[i] - (square * sum >> 32); }
    sine = (int32_t)((x * (UINT32_C(1686629713) - (square * sum >> 34)) + (UINT32_C(1) << 21)) >> 22);
    return (uint32_t)turn & (UINT32_C(1) << 23) ? -sine : sine;
}

static inline uint32_t luminaire_channel_share(const luminaire_channel *channel, const uint8_t *universe, uint32_t count) {
    const int32_t value = luminaire_channel_value(channel, universe, count);
    return value < 0 ? 0 : luminaire_min((uint32_t)value, (uint32_t)LUMINAIRE_TURN);
}

/* A share of full scale in steps of 2^-14. */
static inline int16_t luminaire_share_scalar(uint32_t share) { return (int16_t)((share + 512) >> 10); }

static inline int32_t luminaire_unit_product(int32_t a, int32_t b) {
    return (int32_t)(((int64_t)a * b + (INT64_C(1) << 29)) >> 30);
}

/* Sets the direction of the beam, with 30 fraction bits. */
LUMINAIRE_RARE void luminaire_patch_axis(
    int32_t axis[3], const luminaire_patch *patch, const uint8_t *universe, uint32_t count
) {
    int32_t own[3], pan, tilt, across;
    int i, k;
    if (!axis || !patch) { return; }
    pan = luminaire_channel_value(&patch->pan, universe, count);
    tilt = luminaire_channel_value(&patch->tilt, universe, count);
    across = luminaire_fine_sine(tilt);
    own[0] = -luminaire_unit_product(across, luminaire_fine_sine(pan));
    own[1] = -luminaire_fine_sine(luminaire_plus(tilt, LUMINAIRE_TURN / 4));
    own[2] = -luminaire_unit_product(across, luminaire_fine_sine(luminaire_plus(pan, LUMINAIRE_TURN / 4)));
    for (i = 0; i < 3; ++i) {
        int64_t sum = INT64_C(1) << 29;
        for (k = 0; k < 3; ++k) { sum += (int64_t)patch->mount[i][k] * own[k]; }
        axis[i] = (int32_t)(uint32_t)(uint64_t)(sum >> 30);
    }
}

/* Makes the light of a fixture from those of its narrowest and its widest zoom: aimed, zoomed, dimmed and filtered by the
 * colours. The universe begins with slot 1, behind the start code. */
LUMINAIRE_RARE void luminaire_spot_patch(
    luminaire_spot *spot, const luminaire_spot *narrow, const luminaire_spot *wide, const luminaire_patch *patch,
    const uint8_t *universe, uint32_t count
) {
    int32_t axis[3];
    int16_t color[3];
    uint32_t white;
    int i;
    if (!spot || !narrow || !patch) { return; }
    *spot = *narrow;
    if (wide) { luminaire_spot_zoom(spot, wide, luminaire_share_scalar(luminaire_channel_share(&patch->zoom, universe, count))); }
    luminaire_spot_dim(spot, luminaire_share_scalar(luminaire_channel_share(&patch->dimmer, universe, count)));
    white = luminaire_channel_share(&patch->white, universe, count);
    for (i = 0; i < 3; ++i) {
        const uint32_t own = spot->color[i] < 0 ? 0 : luminaire_min((uint32_t)spot->color[i], UINT32_C(1) << 14) << 10;
        const uint32_t part = luminaire_channel_share(&patch->color[i], universe, count) + white;
        const uint64_t product = (uint64_t)own * luminaire_min(part, (uint32_t)LUMINAIRE_TURN) + (UINT32_C(1) << 23);
        color[i] = luminaire_share_scalar((uint32_t)(product >> 24));
    }
    luminaire_spot_tint(spot, color);
    luminaire_patch_axis(axis, patch, universe, count);
    luminaire_spot_aim_along(spot, axis);
}

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
