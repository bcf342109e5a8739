/* Runs a sketch for some frames, then prints how much of the memory between its variables and its stack was never used. */
#include <Arduino.h>
#include <avr/sleep.h>

extern char __heap_start;

int main() {
    char *const end = (char *)SP - 16; // beyond what this function itself needs
    for (char *at = &__heap_start; at < end; ++at) { *at = 0x5a; }
    init();
    setup();
    for (int frame = 0; frame < FRAMES; ++frame) { loop(); }
    char *used = &__heap_start;
    while (*used == 0x5a) { ++used; }
    Serial.println(used - &__heap_start);
    Serial.flush();
    // The emulator ends at a sleep without interrupts.
    cli();
    sleep_cpu();
}
