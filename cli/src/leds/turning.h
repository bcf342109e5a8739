/* Turns x and z about the upright axis through the middle of the LEDs. */
static inline void {NAME}_turned(int32_t to[3], const int32_t from[3], const int32_t middle[2], uint32_t turn) {
    const int64_t x = (int64_t)from[0] - middle[0], z = (int64_t)from[2] - middle[1];
    const int32_t sine = luminaire_sine(turn), cosine = luminaire_sine(turn + 16384);
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
{TURNS}}

