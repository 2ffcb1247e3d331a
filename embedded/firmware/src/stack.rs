//! How deep the stack gets: it is painted below, and what is no longer paint has been used.

use core::{arch::asm, ptr};

const PAINT: u32 = 0x5aa5_5aa5;
/// How many words are painted.
const WORDS: usize = 8192;

/// Runs `work` and returns the bytes of stack that it took.
#[inline(never)]
pub fn used(work: impl FnOnce()) -> u32 {
    let top = pointer();
    // SAFETY: the stack grows down into 4 MB of memory that nothing else uses; what is painted lies below the stack pointer.
    unsafe {
        for depth in 16..WORDS {
            ptr::write_volatile(top.sub(depth), PAINT);
        }
    }
    work();
    // SAFETY: as above.
    let deepest =
        (16..WORDS).rev().find(|depth| unsafe { ptr::read_volatile(top.sub(*depth)) } != PAINT);
    deepest.map_or(64, |depth| 4 * depth as u32)
}

#[inline(always)]
fn pointer() -> *mut u32 {
    let top: *mut u32;
    // SAFETY: reads the stack pointer.
    unsafe { asm!("mov {}, sp", out(reg) top, options(nomem, nostack, preserves_flags)) };
    top
}
