//! The controllers of both studies in WebAssembly: `play` reads the recordings and prints through the functions of its host.
#![no_std]

use replay::{Robot, Study, ThirdOrderLoop};

static THIRD_ORDER: &[u8] = include_bytes!(concat!(env!("RECORDINGS"), "/third_order"));
static ROBOT: &[u8] = include_bytes!(concat!(env!("RECORDINGS"), "/robot"));

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    fn print(text: *const u8, length: usize);
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    core::arch::wasm32::unreachable()
}

fn play<S: Study>(recording: &[u8]) -> bool {
    // SAFETY: the host reads `length` bytes before it returns.
    replay::play::<S>(recording, |text| unsafe { print(text.as_ptr(), text.len()) }).is_ok()
}

/// Plays both recordings; 0 if a controller failed.
#[unsafe(no_mangle)]
pub extern "C" fn both() -> u32 {
    u32::from(play::<ThirdOrderLoop>(THIRD_ORDER) && play::<Robot>(ROBOT))
}
