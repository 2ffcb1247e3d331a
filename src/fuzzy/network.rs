use nalgebra::SVector;

use super::{
    Gaussian, Grid, Inputs, Network, Over, Rules, Strengths, Travelling, grades::Grades,
    travel::Travel,
};
use crate::{
    Error, Scalar,
    error::{finite, finite_vector, positive},
    scalar::constant,
};

/// A zeroth-order Takagi–Sugeno–Kang network with I inputs, K Gaussian memberships an input and Kᴵ rules:
/// u_n = Σ_r w̃_r(e)·f_r (eq_un).
///
/// Antecedents that travel with the input are stored relative to it, so that they keep their distance to it exactly, however far it
/// goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FuzzyNetwork<T: Scalar, const I: usize, const K: usize>
where
    Inputs<I>: Grid,
{
    /// How the memberships move, once a rule has carried them along with the input.
    pub(super) travel: Option<Travel<T, I, K>>,
    pub(super) memberships: [[Gaussian<T>; K]; I],
    /// Those at the start of the travel.
    pub(super) consequents: Rules<T, I, K>,
}

/// How strongly each rule fires at one input of a network: the normalized firing strengths w̃, which are not negative and sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Firing<T: Scalar, const I: usize, const K: usize> {
    pub(super) grades: Grades<T, I, K>,
    norm_squared: T,
    /// Whether this is the firing of memberships at the input that they travel with.
    carried: bool,
}

impl<T: Scalar, const I: usize, const K: usize> Firing<T, I, K>
where
    Inputs<I>: Grid,
{
    /// The normalized firing strengths w̃ in the order of the rules.
    pub fn strengths(&self) -> Rules<T, I, K> {
        let mut strengths = Rules::filled(T::zero());
        strengths.add(self.grades.rows(), T::one());
        strengths
    }

    /// w̃ᵀw̃, between K⁻ᴵ (all rules fire alike) and 1 (one rule fires alone).
    pub fn norm_squared(&self) -> T {
        self.norm_squared
    }

    pub(super) fn of(grades: Grades<T, I, K>) -> Self {
        Self { grades, norm_squared: grades.dot(&grades), carried: false }
    }
}

impl<T: Scalar, const I: usize, const K: usize> FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    /// A network with the given memberships and all consequents zero, so that its output is zero until it has learned.
    pub fn new(memberships: [[Gaussian<T>; K]; I]) -> Self {
        const { assert!(K > 0, "a fuzzy network needs at least one membership an input") };
        Self { travel: None, memberships, consequents: Rules::filled(T::zero()) }
    }

    /// K memberships evenly spaced over \[−rangeᵢ, rangeᵢ\] for each input, as wide as they are apart; one alone sits at 0
    /// with width rangeᵢ. Consequents are zero.
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NonFinite`] for a range that is not positive and finite, or whose spacing is not.
    pub fn evenly_spaced(ranges: [T; I]) -> Result<Self, Error> {
        let mut memberships = [[Gaussian::new(T::zero(), T::one())?; K]; I];
        for (row, range) in memberships.iter_mut().zip(ranges) {
            positive("range", range)?;
            let intervals = constant::<T>(K.saturating_sub(1).max(1) as f64);
            let width = if K > 1 { range / intervals * constant(2.0) } else { range };
            let spacing = positive("spacing of memberships", width)?;
            let half = constant::<T>(0.5 * K.saturating_sub(1) as f64);
            for (k, membership) in row.iter_mut().enumerate() {
                *membership = Gaussian::new(spacing * (constant::<T>(k as f64) - half), spacing)?;
            }
        }
        Ok(Self::new(memberships))
    }

    /// The membership functions, one row an input.
    pub fn memberships(&self) -> [[Gaussian<T>; K]; I] {
        self.released().memberships
    }

    /// Replaces the membership functions.
    pub fn set_memberships(&mut self, memberships: [[Gaussian<T>; K]; I]) {
        self.consequents = self.consequents();
        self.travel = None;
        self.memberships = memberships;
    }

    /// The consequents f_r, in the order of the rules.
    pub fn consequents(&self) -> Rules<T, I, K> {
        let mut consequents = self.consequents;
        if let Some(travel) = &self.travel {
            consequents.add(travel.grades.rows(), travel.moved);
        }
        consequents
    }

    /// Replaces the consequents f_r.
    ///
    /// # Errors
    /// [`Error::Length`] unless there are Kᴵ of them, [`Error::NonFinite`] for one that is not finite, or if the output at the input that
    /// the memberships travel with is not; the network is then as before.
    pub fn set_consequents(&mut self, consequents: &[T]) -> Result<(), Error> {
        let replaced = Rules::consequents(consequents)?;
        if let Some(travel) = &mut self.travel {
            travel.start = finite("u_n", replaced.mean(travel.grades.rows()))?;
            travel.moved = T::zero();
        }
        self.consequents = replaced;
        Ok(())
    }

    /// The network's output u_n at the input `e`.
    ///
    /// # Errors
    /// [`Error::NonFiniteEntry`] for an input that is not finite, [`Error::NonFinite`] for an output beyond the range of `T`.
    pub fn evaluate(&self, e: &SVector<T, I>) -> Result<T, Error> {
        finite_vector("e", e)?;
        finite("u_n", self.output(&self.fire(e)))
    }

    /// The normalized firing strengths at a finite input `e` (eq_wr, eq_wrwidetilde).
    ///
    /// They are the outer product of the normalized grades of each input, taken relative to the nearest membership: no 0/0, at any distance
    /// from the centres. What is lost beside the largest in rounding is 0. Memberships that travel with the input fire as they did at the
    /// start, which is remembered.
    pub fn fire(&self, e: &SVector<T, I>) -> Firing<T, I, K> {
        match &self.travel {
            None => Firing::of(Grades::at(&self.memberships, e)),
            Some(travel) if travel.at == *e => {
                Firing { grades: travel.grades, norm_squared: travel.norm_squared, carried: true }
            }
            Some(travel) => {
                Firing::of(Grades::at(&travel.flowed(&self.memberships), &(e - travel.at)))
            }
        }
    }

    /// u_n = Σ w̃_r·f_r for the rules of this network firing as `firing` says.
    pub fn output(&self, firing: &Firing<T, I, K>) -> T {
        match &self.travel {
            None => self.consequents.mean(firing.grades.rows()),
            Some(travel) if firing.carried => travel.output(),
            Some(travel) => {
                let learned = travel.moved * travel.grades.dot(&firing.grades);
                self.consequents.mean(firing.grades.rows()) + learned
            }
        }
    }

    /// Adds `rate`·w̃ to the consequents, which changes the output at that firing by `rate`·w̃ᵀw̃. This is the formula and no
    /// more: a rate that is not finite spoils them.
    pub fn move_consequents(&mut self, firing: &Firing<T, I, K>, rate: T) {
        match &mut self.travel {
            Some(travel) if firing.carried => travel.moved += rate,
            travel => {
                self.consequents.add(firing.grades.rows(), rate);
                if let Some(travel) = travel {
                    travel.start = self.consequents.mean(travel.grades.rows());
                }
            }
        }
    }

    fn shift(&mut self, by: &SVector<T, I>) {
        for (row, by) in self.memberships.iter_mut().zip(by.iter()) {
            *row = row.map(|membership| membership.shifted(*by));
        }
    }
}

impl<T: Scalar, const I: usize, const K: usize> Strengths<T> for Firing<T, I, K>
where
    Inputs<I>: Grid,
{
    type Rules = Rules<T, I, K>;

    fn strengths(&self) -> Rules<T, I, K> {
        self.strengths()
    }

    fn norm_squared(&self) -> T {
        self.norm_squared()
    }
}

impl<T: Scalar, const I: usize, const K: usize> Network for FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    type Scalar = T;
    type Input = SVector<T, I>;
    type Firing = Firing<T, I, K>;

    fn fire(&self, e: &SVector<T, I>) -> Firing<T, I, K> {
        self.fire(e)
    }

    fn output(&self, firing: &Firing<T, I, K>) -> T {
        self.output(firing)
    }

    fn move_consequents(&mut self, firing: &Firing<T, I, K>, rate: T) {
        self.move_consequents(firing, rate);
    }

    fn change_consequents(&mut self, change: impl FnOnce(&mut [T])) {
        self.consequents = self.consequents();
        change(&mut self.consequents);
        if let Some(travel) = &mut self.travel {
            travel.start = self.consequents.mean(travel.grades.rows());
            travel.moved = T::zero();
        }
    }

    fn released(self) -> Self {
        let mut free = Self { consequents: self.consequents(), ..self };
        if let Some(travel) = free.travel.take() {
            free.memberships = travel.flowed(&free.memberships);
            free.shift(&travel.at);
        }
        free
    }
}

impl<T: Scalar, const I: usize, const K: usize> Over<T, I> for FuzzyNetwork<T, I, K> where
    Inputs<I>: Grid
{
}

impl<T: Scalar, const I: usize, const K: usize> Travelling for FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    fn carry(&mut self, e: &SVector<T, I>, floor: T, ceiling: T) {
        match &mut self.travel {
            Some(travel) => travel.at = *e,
            None => {
                self.shift(&-e);
                let mut travel = Travel::new(*e, &self.memberships, floor, ceiling);
                let start = self.consequents.mean(travel.grades.rows());
                // A mean of finite numbers is finite, but its rounding may not be.
                travel.start = T::max_value().map_or(start, |most| start.max(-most).min(most));
                self.travel = Some(travel);
            }
        }
    }

    fn flow(&mut self, tau: T) {
        if let Some(travel) = &mut self.travel {
            travel.flow(tau);
        }
    }
}
