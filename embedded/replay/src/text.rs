use crate::{Real, SIZE};

/// Gives `line` the bits of the numbers in hexadecimal, separated by spaces, with a line feed; of as many numbers as a line holds.
///
/// By hand: the formatting of the standard library would be the largest part of a firmware, and can panic.
pub fn hexadecimal(numbers: &[Real], mut line: impl FnMut(&[u8])) {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    const WIDTH: usize = 2 * SIZE + 1;
    let mut text = [b' '; 8 * WIDTH];
    let mut length = 0;
    for (number, place) in numbers.iter().zip(text.chunks_exact_mut(WIDTH)) {
        let bits = number.to_bits();
        for (digit, place) in place.iter_mut().take(2 * SIZE).enumerate() {
            let shift = 4 * (2 * SIZE - 1 - digit);
            *place = DIGITS[(bits >> shift) as usize & 15];
        }
        length += WIDTH;
    }
    if let Some(text) = text.get_mut(..length) {
        if let Some(end) = text.last_mut() {
            *end = b'\n';
        }
        line(text);
    }
}
