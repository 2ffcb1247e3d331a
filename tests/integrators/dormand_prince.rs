//! The pair of Dormand and Prince against its order conditions in exact arithmetic and its amplification factor.

use brunovsky::integrators::{DormandPrince, Embedded, Integrator, Point};
use nalgebra::SVector;
use proptest::prelude::*;

use crate::trees::{Tree, trees};

/// A fraction in lowest terms.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fraction(i128, i128);

impl Fraction {
    fn new(numerator: i128, denominator: i128) -> Self {
        let (mut a, mut b) = (numerator.abs(), denominator.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let a = a.max(1) * denominator.signum();
        Self(numerator / a, denominator / a)
    }

    /// The fraction with a denominator of up to a million that rounds to `value`. There is at most one: two of them differ by 10⁻¹² or
    /// more. Its continued fraction finds it.
    fn of(value: f64) -> Self {
        let (mut last, mut this) = ((1_i128, 0_i128), (value.floor() as i128, 1_i128));
        let mut rest = value - value.floor();
        while this.0 as f64 / this.1 as f64 != value {
            let term = rest.recip().floor();
            rest = rest.recip() - term;
            let next = (term as i128 * this.0 + last.0, term as i128 * this.1 + last.1);
            (last, this) = (this, next);
            assert!(this.1 <= 1_000_000, "{value} is no such fraction");
        }
        Self::new(this.0, this.1)
    }

    fn plus(self, other: Self) -> Self {
        let numerator = self.0.checked_mul(other.1).zip(other.0.checked_mul(self.1));
        let (a, b) = numerator.expect("within range");
        Self::new(a + b, self.1.checked_mul(other.1).expect("within range"))
    }

    fn times(self, other: Self) -> Self {
        let crossed = (Self::new(self.0, other.1), Self::new(other.0, self.1));
        let product = |a: i128, b: i128| a.checked_mul(b).expect("within range");
        Self(product(crossed.0.0, crossed.1.0), product(crossed.0.1, crossed.1.1))
    }
}

/// aᵢⱼ, bᵢ, b̂ᵢ and cᵢ as the method uses them: with kᵢ = eᵢ, x = 0 and h = 1 the states that it shows to f are the rows of A.
struct Tableau {
    a: Vec<Vec<Fraction>>,
    b: Vec<Fraction>,
    estimate: Vec<Fraction>,
    c: Vec<Fraction>,
}

fn tableau() -> Tableau {
    let unit = |i: usize| SVector::<f64, 7>::from_fn(|j, _| if i == j { 1.0 } else { 0.0 });
    let fractions = |row: &SVector<f64, 7>| row.iter().copied().map(Fraction::of).collect();
    let (mut a, mut c) = (vec![vec![Fraction(0, 1); 7]], vec![Fraction(0, 1)]);
    let from = Point { t: 0.0, x: SVector::zeros(), rate: unit(0) };
    let observe = |t, x: &SVector<f64, 7>| {
        a.push(fractions(x));
        c.push(Fraction::of(t));
        unit(a.len() - 1)
    };
    let attempt = DormandPrince.attempt(observe, &from, &(), 1.0).unwrap();
    let error = attempt.error.map(|e| Fraction::of(-e));
    let b: Vec<_> = fractions(&attempt.x);
    let estimate = b.iter().zip(&error).map(|(b, e)| b.plus(*e)).collect();
    Tableau { a, b, estimate, c }
}

impl Tableau {
    /// Σⱼ wⱼ·Π over the children of their own sums: the elementary weight with `row` at the root.
    fn weight(&self, row: &[Fraction], tree: &Tree, trees: &[Tree]) -> Fraction {
        let sum = row.iter().enumerate().map(|(j, w)| {
            let children = tree.children.iter().filter(|_| w.0 != 0);
            let product = children.fold(Fraction(1, 1), |product, &child| {
                product.times(self.weight(&self.a[j], &trees[child], trees))
            });
            w.times(product)
        });
        sum.fold(Fraction(0, 1), Fraction::plus)
    }
}

#[test]
fn all_conditions_up_to_order_five_hold_exactly() {
    let (tableau, trees) = (tableau(), trees());
    let holds = |row: &[Fraction], tree: &Tree| {
        tableau.weight(row, tree, &trees) == Fraction(1, tree.density as i128)
    };
    let mut missed = [0, 0];
    for tree in &trees {
        match tree.order {
            1..=4 => assert!(holds(&tableau.b, tree) && holds(&tableau.estimate, tree)),
            5 => {
                assert!(holds(&tableau.b, tree));
                missed[0] += u32::from(!holds(&tableau.estimate, tree));
            }
            _ => missed[1] += u32::from(!holds(&tableau.b, tree)),
        }
    }
    assert!(missed[0] > 0 && missed[1] > 0, "the orders are 5 and 4, no more");
}

/// Σⱼ aᵢⱼ = cᵢ, so that time may be one of the states; and the last stage is at x⁺.
#[test]
fn rows_sum_to_their_nodes_and_the_last_one_is_the_result() {
    let Tableau { a, b, c, .. } = tableau();
    for (row, node) in a.iter().zip(&c) {
        assert_eq!(row.iter().copied().fold(Fraction(0, 1), Fraction::plus), *node);
    }
    assert_eq!(a[6], b);
    let nodes = [(0, 1), (1, 5), (3, 10), (4, 5), (8, 9), (1, 1), (1, 1)];
    assert_eq!(c, nodes.map(|(p, q)| Fraction(p, q)));
}

proptest! {
    /// On ẋ = p·x a step multiplies by the start of the exponential series up to z⁵/120, and z⁶/600 for z⁶/720, z = p·h
    /// (Hairer, Nørsett, Wanner II, IV.2).
    #[test]
    fn a_linear_step_is_the_series_of_the_exponential_up_to_fifth_order(p in -5.0..5.0_f64, h in 0.01..1.0_f64) {
        let z: f64 = p * h;
        let found = DormandPrince.step(|_, x| x * p, 0.0, &SVector::from([1.0]), h)[0];
        let denominators = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0, 600.0];
        let terms: Vec<f64> = denominators.iter().zip(0..).map(|(d, k)| z.powi(k) / d).collect();
        // Stages of up to 12·|z| each, with coefficients of both signs.
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        prop_assert!((found - terms.iter().sum::<f64>()).abs() <= 200.0 * f64::EPSILON * size);
    }
}
