//! The emulated machine: SysTick as a counter of instructions, the stack painted, text by semihosting.
//!
//! The emulator runs with `-icount shift=10`: an instruction takes 1024 ns, and SysTick, at 25 MHz, 25.6 ticks of it. Its 24 bits last for
//! 655 000 instructions; more are counted by how often it wraps.

use crate::Meter;
use core::arch::asm;
use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// What unused stack holds.
const PAINT: u32 = 0xDEAD_BEEF;
/// Bytes that are painted: no step uses more.
const PAINTED: usize = 512 * 1024;

static WRAPS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    WRAPS.fetch_add(1, Ordering::Relaxed);
}

pub struct Machine {
    timer: SYST,
    /// Ticks of counting nothing.
    empty: u64,
}

impl Machine {
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0xFF_FFFF);
        timer.clear_current();
        timer.enable_counter();
        timer.enable_interrupt();
        let mut machine = Machine { timer, empty: 0 };
        machine.empty = machine.ticks(|| ());
        machine
    }

    fn ticks(&mut self, mut work: impl FnMut()) -> u64 {
        self.timer.clear_current();
        WRAPS.store(0, Ordering::Relaxed);
        let begin = SYST::get_current();
        work();
        let end = SYST::get_current();
        let wraps = WRAPS.load(Ordering::Relaxed);
        u64::from(begin) + (u64::from(wraps) << 24) - u64::from(end)
    }
}

impl Meter for Machine {
    fn instructions(&mut self, work: impl FnMut()) -> u32 {
        let ticks = self.ticks(work).saturating_sub(self.empty);
        // 25.6 ticks each, to the nearest.
        ((ticks * 10 + 128) / 256) as u32
    }

    #[inline(never)]
    fn stack(&mut self, mut work: impl FnMut()) -> u32 {
        let here = stack_pointer();
        paint(here);
        work();
        used(here)
    }

    fn tell(&mut self, text: &str) {
        tell(text);
    }
}

fn stack_pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register.
    unsafe { asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags)) };
    pointer
}

/// Paints what is below the caller's frame.
#[inline(never)]
fn paint(top: usize) {
    let mut at = stack_pointer().min(top) - 64;
    while at > top - PAINTED {
        // SAFETY: below the stack pointer, within the RAM that nothing else uses: there is no heap.
        unsafe { (at as *mut u32).write_volatile(PAINT) };
        at -= 4;
    }
}

#[inline(never)]
fn used(top: usize) -> u32 {
    let mut at = top - PAINTED + 4;
    // SAFETY: as in `paint`.
    while at < top && unsafe { (at as *const u32).read_volatile() } == PAINT {
        at += 4;
    }
    (top - at) as u32
}

/// Sends text to whoever runs the emulator.
pub fn tell(text: &str) {
    text.bytes().for_each(write);
}

/// SYS_WRITEC of Arm's semihosting.
fn write(byte: u8) {
    // SAFETY: the emulator reads one byte.
    unsafe { asm!("bkpt 0xAB", inout("r0") 3_usize => _, in("r1") &raw const byte) };
}

/// SYS_EXIT: ends the emulator, well or not.
pub fn exit(well: bool) -> ! {
    let reason: usize = if well { 0x20026 } else { 0x20023 };
    loop {
        // SAFETY: does not return.
        unsafe { asm!("bkpt 0xAB", inout("r0") 0x18_usize => _, in("r1") reason) };
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    exit(false)
}
