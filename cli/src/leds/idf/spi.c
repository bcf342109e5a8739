/* {COUNT} LEDs ({CHIP}) at their places, lit by {WHAT}.
 * {TAKES}
 * The driver of the SPI master sends the bytes. */
#include "driver/spi_master.h"
#include "esp_attr.h"
#include "esp_err.h"
#include "esp_timer.h"
#include "freertos/FreeRTOS.h"
#include "freertos/task.h"

#include "leds.h"

#define CLOCK_PIN 4
#define DATA_PIN 5
#define PART 2048 /* bytes of a transaction */
{PERIOD}
static DMA_ATTR uint8_t part[PART];
static uint32_t filled;
static spi_device_handle_t strip;

/* Sends what the part holds. The clock rests until the next part, which the strip does not notice. */
static void send(void) {
    spi_transaction_t transaction = { .length = 8 * filled, .tx_buffer = part };
    if (filled > 0) { ESP_ERROR_CHECK(spi_device_transmit(strip, &transaction)); }
    filled = 0;
}

static void put(uint8_t value) {
    part[filled++] = value;
    if (filled == PART) { send(); }
}

static void repeat(uint8_t value, uint32_t count) {
    while (count-- > 0) { put(value); }
}

void app_main(void) {
    static {NAME}_scene scene;
    static luminaire_frame frame;
    uint32_t number = 0;
    const spi_bus_config_t bus = {
        .mosi_io_num = DATA_PIN,
        .miso_io_num = -1,
        .sclk_io_num = CLOCK_PIN,
        .quadwp_io_num = -1,
        .quadhd_io_num = -1,
        .max_transfer_sz = PART,
    };
    const spi_device_interface_config_t device = {
        .mode = {MODE},
        .clock_speed_hz = 4000000,
        .spics_io_num = -1,
        .queue_size = 1,
    };
    ESP_ERROR_CHECK(spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO));
    ESP_ERROR_CHECK(spi_bus_add_device(SPI2_HOST, &device, &strip));
    scene = {NAME}_start;
    for (;; ++number) {
        uint32_t led, i;
{MOVE}        luminaire_strip_begin(&frame, &{NAME}_strip, {GUARD}_COUNT);
        repeat(0, {BEGIN});
        for (led = 0; led < {GUARD}_COUNT; ++led) {
            uint8_t bytes[{GUARD}_BYTES];
            {NAME}_next(bytes, &frame, &scene, led, number);
            for (i = 0; i < {GUARD}_BYTES; ++i) { put(bytes[i]); }
        }
        repeat({LAST}, {END});
        send();
        /* The idle task needs time, or the watchdog reports it. */
        vTaskDelay(1);
    }
}
