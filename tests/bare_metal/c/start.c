/* Start-up, semihosting and a counter of instructions for the emulated board MPS2, in C; `src/machine.rs` says how it counts. */
#include <stdint.h>

extern uint32_t stack_top, data_begin, data_end, data_source, bss_begin, bss_end;
int main(void);
void tell(const char *text);
uint32_t instructions(void (*work)(void));

static volatile uint32_t wraps;

static void leave(uint32_t reason)
{
    register uint32_t operation __asm__("r0") = 0x18U;
    register uint32_t argument __asm__("r1") = reason;

    __asm__ volatile("bkpt 0xAB" : : "r"(operation), "r"(argument) : "memory");
    for (;;) {
    }
}

void tell(const char *text)
{
    register uint32_t operation __asm__("r0") = 4U;
    register const char *argument __asm__("r1") = text;

    __asm__ volatile("bkpt 0xAB" : "+r"(operation) : "r"(argument) : "memory");
}

static void reset(void)
{
    uint32_t *to;
    const uint32_t *from = &data_source;

    for (to = &data_begin; to < &data_end; to++) {
        *to = *from++;
    }
    for (to = &bss_begin; to < &bss_end; to++) {
        *to = 0U;
    }
    /* The coprocessor of numbers; then the timer. */
    *(volatile uint32_t *)0xE000ED88U |= 0xFU << 20;
    __asm__ volatile("dsb\nisb");
    *(volatile uint32_t *)0xE000E014U = 0xFFFFFFU;
    *(volatile uint32_t *)0xE000E018U = 0U;
    *(volatile uint32_t *)0xE000E010U = 7U;
    leave(main() == 0 ? 0x20026U : 0x20023U);
}

static void fault(void)
{
    leave(0x20023U);
}

static void tick(void)
{
    wraps++;
}

static uint64_t ticks(void (*work)(void))
{
    volatile uint32_t *const current = (volatile uint32_t *)0xE000E018U;
    uint32_t begin;
    uint32_t end;

    *current = 0U;
    wraps = 0U;
    begin = *current;
    work();
    end = *current;
    return (uint64_t)begin + ((uint64_t)wraps << 24) - end;
}

static void nothing(void)
{
}

/* An instruction takes 25.6 ticks of the timer where the emulator runs with -icount shift=10. */
uint32_t instructions(void (*work)(void))
{
    const uint64_t empty = ticks(nothing);

    return (uint32_t)(((ticks(work) - empty) * 10U + 128U) / 256U);
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &stack_top, reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, tick,
};
