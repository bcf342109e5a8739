/* {COUNT} LEDs ({CHIP}) at their places, lit by {WHAT}.
 * {TAKES}
 * The component espressif/led_strip sends the bytes by the remote control peripheral. */
#include "esp_err.h"
#include "esp_timer.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"
#include "led_strip.h"

#include "leds.h"

#define PIN 4 /* the data pin of the strip */
{PERIOD}
void app_main(void) {
    static {NAME}_scene scene;
    static luminaire_frame frame;
    uint32_t number = 0;
    led_strip_handle_t pixels = NULL;
    const led_strip_config_t strip = {
        .strip_gpio_num = PIN,
        .max_leds = {GUARD}_COUNT,
        .led_model = LED_MODEL_{MODEL},
        /* The bytes come in their order on the wire: nothing is left to sort. */
        .color_component_format = LED_STRIP_COLOR_COMPONENT_FMT_{COMPONENTS},
    };
    const led_strip_rmt_config_t rmt = { .resolution_hz = 10000000 };
    ESP_ERROR_CHECK(led_strip_new_rmt_device(&strip, &rmt, &pixels));
    scene = {NAME}_start;
    for (;; ++number) {
        uint32_t led;
{MOVE}        luminaire_strip_begin(&frame, &{NAME}_strip, {GUARD}_COUNT);
        for (led = 0; led < {GUARD}_COUNT; ++led) {
            uint8_t bytes[{GUARD}_BYTES];
            {NAME}_next(bytes, &frame, &scene, led, number);
            ESP_ERROR_CHECK({SET});
        }
        ESP_ERROR_CHECK(led_strip_refresh(pixels));
        /* The idle task needs time, or the watchdog reports it. */
        vTaskDelay(1);
    }
}
