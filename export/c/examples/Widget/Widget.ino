/* A lamp among the widgets of LVGL: a canvas whose light a slider dims. The display and the touch panel are set up as
 * LVGL's own example for Arduino does it.
 */
#include <lvgl.h>
#include <luminaire_display.h>

const int32_t METRE = 65536;   // coordinates have steps of 1/65536
const uint32_t DEGREE = 65536; // and so have degrees
const int SIZE = 96;           // of the canvas, in pixels

LV_DRAW_BUF_DEFINE_STATIC(buffer, SIZE, SIZE, LV_COLOR_FORMAT_RGB565);
lv_obj_t *canvas, *slider;
luminaire_spot full;

/* Draws the pool of the lamp, as bright as the slider says. */
void draw(lv_event_t *) {
    luminaire_spot spot = full;
    luminaire_spot_dim(&spot, (int16_t)lv_slider_get_value(slider));
    const int32_t step = METRE / SIZE;
    for (int y = 0; y < SIZE; ++y) {
        const luminaire_row row = { { -METRE / 2, 0, (y - SIZE / 2) * step }, { step, 0, 0 }, { 0, 16384, 0 } };
        luminaire_rgb lights[SIZE] = {};
        luminaire_row_add(lights, &row, &spot, SIZE);
        uint16_t *pixels = (uint16_t *)lv_draw_buf_goto_xy(&buffer, 0, y);
        for (int x = 0; x < SIZE; ++x) { pixels[x] = luminaire_rgb565_dithered(lights[x], x, y); }
    }
    lv_obj_invalidate(canvas);
}

void setup() {
    lv_init();
    LV_DRAW_BUF_INIT_STATIC(buffer);
    canvas = lv_canvas_create(lv_screen_active());
    lv_canvas_set_draw_buf(canvas, &buffer);
    lv_obj_align(canvas, LV_ALIGN_TOP_MID, 0, 8);
    slider = lv_slider_create(lv_screen_active());
    lv_obj_align(slider, LV_ALIGN_BOTTOM_MID, 0, -16);
    lv_slider_set_range(slider, 0, 16384); // 16384 is the whole light
    lv_slider_set_value(slider, 12000, LV_ANIM_OFF);
    lv_obj_add_event_cb(slider, draw, LV_EVENT_VALUE_CHANGED, NULL);

    const int32_t position[3] = { 0, METRE, METRE / 4 }, way[3] = { 0, -METRE, -METRE / 4 };
    const int16_t warm[3] = { 16384, 11000, 5000 }; // linear red, green and blue: 16384 is 1
    luminaire_cone cone;
    luminaire_cone_from_beam_and_field(&cone, 20 * DEGREE, 36 * DEGREE);
    luminaire_spot_set_up(&full, &cone, position, way, METRE);
    luminaire_spot_tint(&full, warm);
    draw(NULL);
}

void loop() {
    lv_timer_handler();
    delay(5);
}
