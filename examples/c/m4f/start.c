/* What a Cortex-M4F does before main: vectors, and the switch for its floating-point unit. */
#include <stdint.h>

extern char __stack[];
void _start(void); /* newlib's: clears .bss, opens the semihosting console, calls main and exit */

static void halt(void)
{
    for (;;)
        ;
}

void reset(void)
{
    /* CPACR: full access to coprocessors 10 and 11. */
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20;
    __asm__ volatile("dsb\n isb");
    _start();
}

/* What newlib calls around main for C++. */
void _init(void) {}
void _fini(void) {}

__attribute__((section(".vectors"), used)) static const struct {
    void *stack;
    void (*handlers[15])(void);
} vectors = {__stack, {reset, halt, halt, halt, halt, halt, 0, 0, 0, 0, halt, halt, 0, halt, halt}};
