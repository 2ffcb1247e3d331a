#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| brunovsky_fuzz::driver::learner::attack(data));
