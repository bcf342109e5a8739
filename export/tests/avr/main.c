/* Runs a program of C on an AVR without files: its input is in flash, and the UART prints what it returns, and the count
 * and the hash of the bytes that it writes. With PRINT, the UART prints these bytes too. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>
#include <stdio.h>

/* After the tables, which the library reads by addresses of 16 bits. */
__asm__(".section .text.input\ninput: .incbin \"input.bin\"\ninput_end: .balign 2\n.text");
extern const uint8_t input, input_end;

int program(void);

static uint32_t next, end, count, hash = UINT32_C(2166136261);

static void transmit(char byte) {
    loop_until_bit_is_set(UCSR0A, UDRE0);
    UDR0 = (uint8_t)byte;
}

static int get(FILE *stream) {
    (void)stream;
    if (next == end) { return _FDEV_EOF; }
    return pgm_read_byte_far(next++);
}

/* FNV-1a. */
static int put(char byte, FILE *stream) {
    (void)stream;
    hash = (hash ^ (uint8_t)byte) * UINT32_C(16777619);
    ++count;
#if defined(PRINT)
    if (byte == '\n') { transmit('\r'); }
    transmit(byte);
#endif
    return 0;
}

static void print(uint32_t word, char after) {
    int shift;
    for (shift = 28; shift >= 0; shift -= 4) { transmit("0123456789abcdef"[word >> shift & 15]); }
    transmit(after);
}

int main(void) {
    static FILE file = FDEV_SETUP_STREAM(put, get, _FDEV_SETUP_RW);
    int code;
    stdin = stdout = stderr = &file;
    UCSR0B = 1 << TXEN0;
    UBRR0 = 0;
    next = pgm_get_far_address(input);
    end = pgm_get_far_address(input_end);
    code = program();
    print((uint32_t)code, ' ');
    print(count, ' ');
    print(hash, '\r');
    transmit('\n');
    /* Until the last byte is sent. The emulator ends at a sleep without interrupts. */
    UCSR0A |= 1 << TXC0;
    loop_until_bit_is_set(UCSR0A, TXC0);
    cli();
    sleep_cpu();
    return 0;
}
