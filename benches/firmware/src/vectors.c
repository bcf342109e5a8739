/* The table at address 0 from which a Cortex-M starts a program of newlib. */
extern void _start(void);

/* The end of a RAM of 4 MB, and the entry. */
__attribute__((section(".vectors"), used)) void (*const vectors[])(void) = {
    (void (*)(void))0x20400000,
    _start,
};
