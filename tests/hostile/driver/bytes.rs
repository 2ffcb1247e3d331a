//! Bytes as calls and numbers.

use brunovsky::Scalar;
use nalgebra::SVector;

/// A scalar of any bit pattern.
pub trait Float: Scalar {
    /// The number with these bits; an f32 takes the lower half.
    fn of_bits(bits: u64) -> Self;

    /// The same number as an f64, which tells every f32 from every other.
    fn wide(self) -> f64;

    /// The least normal number.
    const LEAST: Self;

    /// ±0, ±1, subnormal, least normal, greatest, infinite, NaN of both signs, quiet and signalling, with payload; neighbours of 1, and numbers
    /// whose squares or reciprocals leave the range.
    const NASTY: [Self; 24];
}

macro_rules! float {
    ($float:ident, $bits:ident, $payload:literal, $quiet:literal, $big:literal) => {
        impl Float for $float {
            fn of_bits(bits: u64) -> Self {
                $float::from_bits(bits as $bits)
            }

            fn wide(self) -> f64 {
                self.into()
            }

            const LEAST: Self = $float::MIN_POSITIVE;

            const NASTY: [Self; 24] = [
                0.0,
                -0.0,
                1.0,
                -1.0,
                $float::from_bits(1),
                -$float::from_bits(1),
                $float::MIN_POSITIVE,
                -$float::MIN_POSITIVE,
                $float::from_bits($float::MIN_POSITIVE.to_bits() - 1),
                $float::MAX,
                $float::MIN,
                $float::MAX / 2.0,
                $float::INFINITY,
                $float::NEG_INFINITY,
                $float::NAN,
                -$float::NAN,
                $float::from_bits($payload),
                $float::from_bits($quiet),
                1.0 + $float::EPSILON,
                1.0 - $float::EPSILON,
                $big,
                -$big,
                1.0 / $big,
                -1.0 / $big,
            ];
        }
    };
}

float!(f32, u32, 0x7f80_0001, 0xffc0_beef, 1e20);
float!(f64, u64, 0x7ff0_0000_0000_0001, 0xfff8_0000_dead_beef, 1e160);

/// The rest of the input. Where it has ended, bytes are 0.
#[derive(Debug, Clone, Copy)]
pub struct Bytes<'a> {
    rest: &'a [u8],
    /// Whether to attack at f32.
    pub single: bool,
    /// Whether to look at what `Debug` prints.
    pub deep: bool,
    /// Whether a number has been read that is not moderate: not one of [`moderate`](Self::moderate).
    pub wild: bool,
}

impl<'a> Bytes<'a> {
    pub fn new(data: &'a [u8]) -> Self {
        let (first, rest) = data.split_first().unwrap_or((&0, &[]));
        Self { rest, single: first & 1 == 1, deep: first & 14 == 2, wild: false }
    }

    /// Bytes that decode to moderate numbers, with every option taken.
    pub fn good() -> Bytes<'static> {
        const GOOD: [u8; 251] = {
            let mut tags = [0; 251];
            let mut i = 0;
            while i < tags.len() {
                // Odd numbers from 155 to 201: between 0.2 and 3.1.
                tags[i] = (155 + i * 14 % 48) as u8 | 1;
                i += 1;
            }
            tags
        };
        Bytes { rest: &GOOD, single: false, deep: false, wild: false }
    }

    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    pub fn byte(&mut self) -> u8 {
        let (first, rest) = self.rest.split_first().unwrap_or((&0, &[]));
        self.rest = rest;
        *first
    }

    pub fn odd(&mut self) -> bool {
        self.byte() & 1 == 1
    }

    pub fn word(&mut self) -> u64 {
        u64::from_le_bytes(core::array::from_fn(|_| self.byte()))
    }

    /// Any number: a nasty one, any bit pattern, a power of two, or a moderate one.
    pub fn number<T: Float>(&mut self) -> T {
        let tag = self.byte();
        let wild = match tag {
            0..24 => T::NASTY[usize::from(tag)],
            24..40 => T::of_bits(self.word()),
            40..48 => {
                let power = 2.0_f64.powi(i32::from(self.byte() as i8));
                nalgebra::convert(if tag & 1 == 1 { power } else { -power })
            }
            48.. => return Self::moderate(tag),
        };
        self.wild = true;
        wild
    }

    /// Between −6.5 and 6.5.
    fn moderate<T: Float>(tag: u8) -> T {
        nalgebra::convert((f64::from(tag) - 152.0) / 16.0)
    }

    /// Any number, but the moderate ones are positive: for what has to be.
    pub fn parameter<T: Float>(&mut self) -> T {
        let wild = core::mem::replace(&mut self.wild, false);
        let number = self.number::<T>();
        let moderate = !self.wild;
        self.wild |= wild;
        if moderate { number.abs() + nalgebra::convert(0.0625) } else { number }
    }

    pub fn vector<T: Float, const N: usize>(&mut self) -> SVector<T, N> {
        SVector::from_fn(|_, _| self.number())
    }

    pub fn numbers<T: Float, const N: usize>(&mut self) -> [T; N] {
        core::array::from_fn(|_| self.number())
    }

    pub fn parameters<T: Float, const N: usize>(&mut self) -> [T; N] {
        core::array::from_fn(|_| self.parameter())
    }
}
