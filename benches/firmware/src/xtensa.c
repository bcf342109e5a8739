/* What a program of picolibc needs on a simulated Xtensa of an ESP8266: where the processor begins, an output, and the
 * functions of libgcc that the chip has in its ROM. */
#include <stdint.h>
#include <stdio.h>

/* The processor begins at 0x50000000. A jump reaches no more than 128 KiB, so the address of `begin` is computed:
 * xtensa.ld puts it at the start of the instructions' memory. The stack ends with the data's memory. */
__asm(".section .reset, \"ax\"\n"
      "reset: movi a0, 0x402\n"
      "slli a0, a0, 20\n"
      "jx a0\n"
      ".section .begin, \"ax\"\n"
      "begin: movi a1, 0x400\n"
      "slli a1, a1, 20\n"
      "addi a1, a1, -16\n"
      "call0 main\n"
      "call0 _exit\n"
      ".text\n");

/* Numbers of the simulator's calls. */
#define EXIT 1
#define WRITE 4

static void simulator(int number, int first, const void *second, int third) {
    register int a2 __asm("a2") = number;
    register int a3 __asm("a3") = first;
    register const void *a4 __asm("a4") = second;
    register int a5 __asm("a5") = third;
    __asm volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
}

void _exit(int code) {
    for (;;) { simulator(EXIT, code, 0, 0); }
}

static int put(char letter, FILE *file) {
    (void)file;
    simulator(WRITE, 1, &letter, 1);
    return letter;
}

static FILE console = FDEV_SETUP_STREAM(put, NULL, NULL, _FDEV_SETUP_WRITE);
FILE *const stdout = &console;

uint32_t __udivsi3(uint32_t dividend, uint32_t divisor) {
    uint32_t quotient = 0, rest = 0;
    for (int bit = 31; bit >= 0; --bit) {
        rest = rest << 1 | (dividend >> bit & 1);
        quotient <<= 1;
        if (rest >= divisor) {
            rest -= divisor;
            quotient |= 1;
        }
    }
    return quotient;
}

uint32_t __umodsi3(uint32_t dividend, uint32_t divisor) { return dividend - divisor * __udivsi3(dividend, divisor); }
