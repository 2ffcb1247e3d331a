//! What the programs on the board share: output to the debugger, and a panic handler that does not exist.
#![no_std]

pub mod by_hand;
pub mod hostile;
pub mod measure;
pub mod stack;

use core::panic::PanicInfo;

use cortex_m_semihosting::{debug, hio};

/// The recorded sequences.
pub mod recordings {
    /// Of the third-order system.
    pub static THIRD_ORDER: &[u8] = include_bytes!(concat!(env!("RECORDINGS"), "/third_order"));
    /// Of the robot.
    pub static ROBOT: &[u8] = include_bytes!(concat!(env!("RECORDINGS"), "/robot"));
}

unsafe extern "C" {
    /// Defined nowhere: a program with a path to a panic does not link.
    fn a_path_to_a_panic_is_linked() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: there is nothing to be called.
    unsafe { a_path_to_a_panic_is_linked() }
}

/// Writes `text` to the console of the debugger.
pub fn print(text: &[u8]) {
    if let Ok(mut console) = hio::hstdout() {
        // Without a console there is nobody to tell.
        let _ = console.write_all(text);
    }
}

/// Writes `name` and numbers in decimal as one line.
pub fn print_row(name: &str, numbers: &[u32]) {
    print(name.as_bytes());
    for number in numbers {
        let mut digits = [b' '; 11];
        let mut rest = *number;
        for digit in digits.iter_mut().rev() {
            *digit = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        print(&digits);
    }
    print(b"\n");
}

/// Ends the emulation with exit code 1.
pub fn failed() -> ! {
    exit(Err(()))
}

/// Ends the emulation: exit code 0 for `Ok`, 1 for `Err`.
pub fn exit<E>(result: Result<(), E>) -> ! {
    debug::exit(match result {
        Ok(()) => debug::EXIT_SUCCESS,
        Err(_) => debug::EXIT_FAILURE,
    });
    loop {
        cortex_m::asm::wfi();
    }
}
