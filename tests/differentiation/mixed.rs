//! Parameters and plain numbers among numbers with derivatives.

use core::ops::{AddAssign, DivAssign, MulAssign, SubAssign};

use brunovsky::{
    Scalar,
    differentiation::{Dual, Jet, RunningError, Smooth},
};

use crate::{at_f32_and_f64, support::num};

/// A parameter at the right of an operator is the same as a number made of it.
fn parameters_act_as_numbers<T: Scalar, S: Smooth<T>>(x: S) -> [[S; 2]; 4] {
    let p = num::<T>(1.25);
    [
        [x + p, x + S::from(p)],
        [x - p, x - S::from(p)],
        [x * p, x * S::from(p)],
        [x / p, x / S::from(p)],
    ]
}

fn assignments_are_operations<S>(x: S, y: S, expected: [S; 4])
where
    S: Copy + PartialEq + core::fmt::Debug + AddAssign + SubAssign + MulAssign + DivAssign,
{
    let assigned = |operation: fn(&mut S, S)| {
        let mut x = x;
        operation(&mut x, y);
        x
    };
    assert_eq!(
        [S::add_assign, S::sub_assign, S::mul_assign, S::div_assign].map(assigned),
        expected
    );
}

fn on_every_number<T: Scalar>() {
    let entries = [0.5, -1.5, 0.75].map(num::<T>);
    let (jet, other) = (Jet::new(entries), Jet::new([2.0, 0.5, -1.0].map(num::<T>)));
    let dual = Dual { value: jet, slopes: [other] };
    let plain = parameters_act_as_numbers::<T, _>(entries[0]);
    for [mixed, pure] in plain {
        assert_eq!(mixed, pure);
    }
    for [mixed, pure] in parameters_act_as_numbers::<T, _>(jet) {
        let difference = mixed - pure;
        assert!(
            difference.derivatives().iter().all(|d| d.abs() <= T::default_epsilon() * num(2.0))
        );
    }
    for [mixed, pure] in parameters_act_as_numbers::<T, _>(dual) {
        let difference = mixed - pure;
        let all = [difference.value, difference.slopes[0]];
        let mut entries = all.iter().flat_map(|jet| jet.derivatives());
        assert!(entries.all(|d| d.abs() <= T::default_epsilon() * num(4.0)));
    }
    for [mixed, pure] in parameters_act_as_numbers::<T, _>(RunningError::from(entries[0])) {
        assert_eq!(mixed, pure);
    }
    assignments_are_operations(jet, other, [jet + other, jet - other, jet * other, jet / other]);
    let twin = Dual { value: other, slopes: [jet] };
    assignments_are_operations(dual, twin, [dual + twin, dual - twin, dual * twin, dual / twin]);
    let (x, y) = (RunningError::from(entries[0]), RunningError::from(entries[1]));
    assignments_are_operations(x, y, [x + y, x - y, x * y, x / y]);
}

at_f32_and_f64! {
    a_parameter_is_a_number_without_derivatives => on_every_number,
}
