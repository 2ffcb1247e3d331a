use super::{IntervalMembership, Shares};
use crate::{
    Error, Scalar,
    error::{at_most, finite, positive},
    fuzzy::grades::nearest_alone,
    scalar::epsilon,
};

/// An elliptic membership function of interval type 2: μ = (1 − |(e − c)/d|^a)^(1/a) within |e − c| < d, 0 outside, with a between a̲ and a̅.
///
/// The grade is certain at the centre, where it is 1, and at the ends of its support, where it is 0, and uncertain in between. a = 1 is a triangle, a = 2 an
/// ellipse; a̲ < 1 < a̅ in the literature, a̲ = a̅ is of type 1.
///
/// Outside of the supports of all memberships of an input, the nearest fires alone, so that the output goes on as it is at the end of its support; in
/// a gap between two it jumps in the middle. No quotient is 0/0.
///
/// # References
/// M. A. Khanesar, E. Kayacan, M. Teshnehlab, O. Kaynak, "Analysis of the noise reduction property of type-2 fuzzy logic systems using a novel type-2
/// membership function", IEEE Transactions on Systems, Man, and Cybernetics B 41(5), 2011.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elliptic<T> {
    centre: T,
    reach: T,
    exponents: [T; 2],
}

impl<T: Scalar> Elliptic<T> {
    /// A membership function with its centre c and its reach d > 0 to either side, in the units of e, and the exponents 0 < a̲ ≤ a̅ of the lower
    /// and the upper grade.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for the reach or an exponent, [`Error::NonFinite`] for the centre, [`Error::Above`] for an a̲
    /// above a̅.
    pub fn new(centre: T, reach: T, exponents: [T; 2]) -> Result<Self, Error> {
        finite("centre", centre)?;
        positive("reach", reach)?;
        let [lower, upper] = exponents;
        let upper = positive("upper exponent", upper)?;
        at_most("lower exponent", positive("lower exponent", lower)?, upper)?;
        Ok(Self { centre, reach, exponents })
    }

    /// The centre c.
    pub fn centre(&self) -> T {
        self.centre
    }

    /// The reach d.
    pub fn reach(&self) -> T {
        self.reach
    }

    /// The exponents a̲ and a̅.
    pub fn exponents(&self) -> [T; 2] {
        self.exponents
    }

    /// ln μ, −∞ where that is 0.
    fn logarithms(&self, e: T) -> [T; 2] {
        let z = ((e - self.centre) / self.reach).abs();
        // The logarithm of what is left of 1, and of nothing where that is no more.
        self.exponents.map(|a| (T::one() - z.min(T::one()).powf(a)).ln() / a)
    }
}

impl<T: Scalar> IntervalMembership<T> for Elliptic<T> {
    fn grades(&self, e: T) -> [T; 2] {
        self.logarithms(e).map(T::exp)
    }

    fn shares<const K: usize>(row: &[Self; K], e: T) -> Shares<T, K> {
        let logarithms = row.map(|membership| membership.logarithms(e));
        let support = |own: Self| [own.centre - own.reach, own.centre, own.centre + own.reach];
        let outside = nearest_alone(row.map(support), e);
        let lower = Relative::of(logarithms.map(|[lower, _]| lower));
        let upper = Relative::of(logarithms.map(|[_, upper]| upper));
        // Toward the end of its support the lower grade vanishes faster than the upper one, if it is not the same.
        let same = row.iter().zip(outside).all(|(own, share)| {
            let [lower, upper] = own.exponents;
            share.is_zero() || lower == upper
        });
        let ratio = match (&lower, &upper) {
            (Some(lower), Some(upper)) => (lower.peak - upper.peak).exp() * (lower.sum / upper.sum),
            (None, None) if same => T::one(),
            _ => T::zero(),
        };
        let shares = |found: Option<Relative<T, K>>| found.map_or(outside, |found| found.shares());
        Shares { lower: shares(lower), upper: shares(upper), ratio }
    }
}

/// Grades relative to the largest of them.
struct Relative<T, const K: usize> {
    /// The logarithm of the largest.
    peak: T,
    grades: [T; K],
    sum: T,
}

impl<T: Scalar, const K: usize> Relative<T, K> {
    /// From their logarithms; `None` if all are 0. A grade below ε is lost in the rounding of the sum.
    fn of(logarithms: [T; K]) -> Option<Self> {
        let peak = logarithms.into_iter().reduce(T::max).filter(T::is_finite)?;
        let grades = logarithms.map(|logarithm| {
            let grade = (logarithm - peak).exp();
            if grade < epsilon() { T::zero() } else { grade }
        });
        let sum = grades.iter().fold(T::zero(), |sum, grade| sum + *grade);
        Some(Self { peak, grades, sum })
    }

    fn shares(&self) -> [T; K] {
        self.grades.map(|grade| grade / self.sum)
    }
}

checked! {
    [T: Scalar] Elliptic<T>, [T] { centre: T, reach: T, exponents: [T; 2] } =>
    Self::new(centre, reach, exponents)
}
