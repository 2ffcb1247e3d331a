use nalgebra::SVector;

use super::{Gaussian, Grid, Inputs, travel::Travel};
use crate::{
    Error, Scalar,
    error::{finite, finite_vector, positive},
    scalar::{constant, epsilon},
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
    travel: Option<Travel<T, I>>,
    memberships: [[Gaussian<T>; K]; I],
    consequents: <Inputs<I> as Grid>::Cube<T, K>,
}

/// How strongly each rule fires at one input: the normalized firing strengths w̃, which are not negative and sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Firing<T: Scalar, const I: usize, const K: usize>
where
    Inputs<I>: Grid,
{
    strengths: <Inputs<I> as Grid>::Cube<T, K>,
    norm_squared: T,
    /// Whether this is the firing of memberships at the input that they travel with.
    carried: bool,
}

impl<T: Scalar, const I: usize, const K: usize> Firing<T, I, K>
where
    Inputs<I>: Grid,
{
    /// The normalized firing strengths w̃ in the order of the rules.
    pub fn strengths(&self) -> &[T] {
        Inputs::<I>::values(&self.strengths)
    }

    /// w̃ᵀw̃, between K⁻ᴵ (all rules fire alike) and 1 (one rule fires alone).
    pub fn norm_squared(&self) -> T {
        self.norm_squared
    }
}

impl<T: Scalar, const I: usize, const K: usize> FuzzyNetwork<T, I, K>
where
    Inputs<I>: Grid,
{
    /// A network with the given memberships and all consequents zero, so that its output is zero until it has learned.
    pub fn new(memberships: [[Gaussian<T>; K]; I]) -> Self {
        const { assert!(K > 0, "a fuzzy network needs at least one membership an input") };
        Self { travel: None, memberships, consequents: Inputs::<I>::filled(T::zero()) }
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
        self.travel = None;
        self.memberships = memberships;
    }

    /// The consequents f_r, in the order of the rules.
    pub fn consequents(&self) -> &[T] {
        Inputs::<I>::values(&self.consequents)
    }

    /// Replaces the consequents f_r.
    ///
    /// # Errors
    /// [`Error::Length`] unless there are Kᴵ of them, [`Error::NonFinite`] for one that is not finite; the network is then
    /// as before.
    pub fn set_consequents(&mut self, consequents: &[T]) -> Result<(), Error> {
        let own = Inputs::<I>::values_mut(&mut self.consequents);
        if own.len() != consequents.len() {
            return Err(Error::Length {
                name: "consequents",
                expected: own.len(),
                found: consequents.len(),
            });
        }
        for consequent in consequents {
            finite("consequent", *consequent)?;
        }
        for (own, new) in own.iter_mut().zip(consequents) {
            *own = *new;
        }
        if let Some(travel) = &mut self.travel {
            travel.moved = T::zero();
        }
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
    /// For each input the grades are taken relative to the nearest membership: exp((M_near² − M_ik²)/2) is 1 for the nearest
    /// and at most 1 for the others, so the sums are never zero, at any distance from the centres. What is lost beside it in rounding is 0.
    pub fn fire(&self, e: &SVector<T, I>) -> Firing<T, I, K> {
        match self.travel {
            None => firing(&self.memberships, e),
            // At the input that they travel with, memberships fire as they did at the start.
            Some(travel) if travel.at == *e => {
                Firing { carried: true, ..firing(&self.memberships, &SVector::zeros()) }
            }
            Some(travel) => firing(&travel.flowed(&self.memberships), &(e - travel.at)),
        }
    }

    /// u_n = Σ w̃_r·f_r for the rules firing as `firing` says.
    pub fn output(&self, firing: &Firing<T, I, K>) -> T {
        let products = firing.strengths().iter().zip(self.consequents());
        products.fold(T::zero(), |sum, (w, f)| sum + *w * *f)
    }

    /// Adds `rate`·w̃ to the consequents, which changes the output at that firing by `rate`·w̃ᵀw̃. This is the formula and no
    /// more: a rate that is not finite spoils them.
    pub fn move_consequents(&mut self, firing: &Firing<T, I, K>, rate: T) {
        // All moves of a travel go along one w̃. Their sum is kept, and the consequents are taken back by the last and forth by the next:
        // those that started from zero are the sum times w̃ to the last bit, and no rounding of theirs ever adds up.
        let (back, forth) = match &mut self.travel {
            Some(travel) if firing.carried => {
                let back = travel.moved;
                travel.moved += rate;
                (back, travel.moved)
            }
            _ => (T::zero(), rate),
        };
        let consequents = Inputs::<I>::values_mut(&mut self.consequents);
        for (f, w) in consequents.iter_mut().zip(firing.strengths()) {
            *f = (*f - back * *w) + forth * *w;
        }
    }

    /// Carries the memberships along with an input that has moved to `e`. The first time there is no move to follow: they stay
    /// where they are, and M² is to stay between `floor` and `ceiling` from then on.
    pub(crate) fn carry(&mut self, e: &SVector<T, I>, floor: T, ceiling: T) {
        match &mut self.travel {
            Some(travel) => travel.at = *e,
            None => {
                self.shift(&-e);
                self.travel = Some(Travel::new(*e, &self.memberships, floor, ceiling));
            }
        }
    }

    /// Lets the memberships that are carried along flow by τ: M² ↦ M² + 2τ, d ↦ d·e^{−τ}.
    pub(crate) fn flow(&mut self, tau: T) {
        if let Some(travel) = &mut self.travel {
            travel.flow(tau);
        }
    }

    /// The same network, with memberships that stay where they are until a rule carries them along again.
    pub(crate) fn released(&self) -> Self {
        let mut free = *self;
        if let Some(travel) = free.travel.take() {
            free.memberships = travel.flowed(&free.memberships);
            free.shift(&travel.at);
        }
        free
    }

    fn shift(&mut self, by: &SVector<T, I>) {
        for (row, by) in self.memberships.iter_mut().zip(by.iter()) {
            *row = row.map(|membership| membership.shifted(*by));
        }
    }
}

/// How `memberships` fire at `e`: input by input, as the grid factorizes.
fn firing<T: Scalar, const I: usize, const K: usize>(
    memberships: &[[Gaussian<T>; K]; I],
    e: &SVector<T, I>,
) -> Firing<T, I, K>
where
    Inputs<I>: Grid,
{
    let mut grades = [[T::zero(); K]; I];
    let mut norm_squared = T::one();
    for ((grades, row), e) in grades.iter_mut().zip(memberships).zip(e.iter()) {
        *grades = normalized(row.map(|membership| membership.distance(*e).abs()));
        norm_squared *= sum_of_squares(grades);
    }
    let mut strengths = Inputs::<I>::outer(&grades, T::one());
    for strength in Inputs::<I>::values_mut(&mut strengths) {
        *strength = at_least(epsilon::<T>() * epsilon(), *strength);
    }
    Firing { strengths, norm_squared, carried: false }
}

/// exp(−Mₖ²/2)/Σ exp(−M²/2) for distances M ≥ 0.
///
/// The difference of squares is taken as a product, which keeps its accuracy far out. Equal distances give 1 before any
/// arithmetic, so that even distances which overflowed to infinity divide up evenly. A grade below ε is lost in the rounding of the sum.
fn normalized<T: Scalar, const K: usize>(distances: [T; K]) -> [T; K] {
    let nearest = distances.into_iter().reduce(T::min).unwrap_or(T::zero());
    let grades = distances.map(|m| {
        if m == nearest {
            T::one()
        } else {
            at_least(epsilon(), ((nearest - m) * (nearest + m) * constant(0.5)).exp())
        }
    });
    let sum = grades.iter().fold(T::zero(), |sum, grade| sum + *grade);
    grades.map(|grade| grade / sum)
}

/// `weight`, or 0 below `least`: what is lost in rounding anyway, and whose products would soon be subnormal, of which a step takes many times as
/// long.
fn at_least<T: Scalar>(least: T, weight: T) -> T {
    if weight < least { T::zero() } else { weight }
}

fn sum_of_squares<T: Scalar>(values: &[T]) -> T {
    values.iter().fold(T::zero(), |sum, v| sum + *v * *v)
}
