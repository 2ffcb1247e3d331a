use brunovsky::{
    Scalar,
    fuzzy::{Grid, Inputs},
};

use crate::support::{digit, real};

in_both_precisions! {
    the_last_input_runs_fastest,
    sums_and_products_agree_with_index_arithmetic,
    what_is_added_stays,
    a_missing_row_counts_as_ones,
    weights_below_the_square_of_epsilon_are_left_out,
    a_filled_grid_holds_the_same_value_for_every_rule,
    values_written_are_read_back_in_the_same_order,
}

/// `rate` times the product of the rows, for every rule.
fn outer<T: Scalar, const I: usize, const K: usize>(
    rows: &[[T; K]],
    rate: T,
) -> <Inputs<I> as Grid>::Cube<T, K>
where
    Inputs<I>: Grid,
{
    let mut cube = Inputs::<I>::filled(T::zero());
    Inputs::<I>::add_outer(&mut cube, rows, T::one(), rate);
    cube
}

/// Row i holds the powers 2^(k·Kᴵ⁻¹⁻ⁱ), so the product for the rule (k₁, …, k_I) is 2^r with r its own number: exact, and
/// different for every rule.
fn last_fastest<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let rows: [[T; K]; I] = core::array::from_fn(|i| {
        core::array::from_fn(|k| real(2.0_f64.powi((k * K.pow((I - 1 - i) as u32)) as i32)))
    });
    let cube = outer::<T, I, K>(&rows, T::one());
    let values = Inputs::<I>::values(&cube);
    assert_eq!(values.len(), K.pow(I as u32));
    for (r, value) in values.iter().enumerate() {
        assert_eq!(*value, real(2.0_f64.powi(r as i32)));
    }
}

/// 64 rules are the most that 2^r allows in `f32`.
fn the_last_input_runs_fastest<T: Scalar>() {
    last_fastest::<T, 1, 7>();
    last_fastest::<T, 2, 5>();
    last_fastest::<T, 3, 4>();
    last_fastest::<T, 4, 2>();
    last_fastest::<T, 5, 2>();
    last_fastest::<T, 6, 2>();
}

/// Small integers, whose products are exact as long as they stay below 2²⁴.
fn integers<T: Scalar, const I: usize, const K: usize>() -> [[T; K]; I] {
    core::array::from_fn(|i| core::array::from_fn(|k| real((2 + k + i % 2) as f64)))
}

fn index_arithmetic<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let rows = integers::<T, I, K>();
    let cube = outer::<T, I, K>(&rows, real(-0.5));
    let numbers = numbered::<T, I, K>();
    let mut sum = T::zero();
    for (rule, value) in Inputs::<I>::values(&cube).iter().enumerate() {
        let product = (0..I).fold(T::one(), |product, i| product * rows[i][digit::<I, K>(rule, i)]);
        assert_eq!(*value, product * real(-0.5));
        sum += product * real(rule as f64);
    }
    // Sums of integers, exact in f64.
    let contracted = Inputs::<I>::contracted(&numbers, &rows);
    let most = T::one().max(sum) * T::default_epsilon() * real(64.0);
    assert!((contracted - sum).abs() <= most, "{contracted} is not {sum}");
}

/// Each rule's own number.
fn numbered<T: Scalar, const I: usize, const K: usize>() -> <Inputs<I> as Grid>::Cube<T, K>
where
    Inputs<I>: Grid,
{
    let mut cube = Inputs::<I>::filled::<T, K>(T::zero());
    for (rule, value) in Inputs::<I>::values_mut(&mut cube).iter_mut().enumerate() {
        *value = real(rule as f64);
    }
    cube
}

fn sums_and_products_agree_with_index_arithmetic<T: Scalar>() {
    for_every_shape!(index_arithmetic::<T>);
}

fn added<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let rows = integers::<T, I, K>();
    let (once, mut twice) = (outer::<T, I, K>(&rows, T::one()), numbered::<T, I, K>());
    Inputs::<I>::add_outer(&mut twice, &rows, T::one(), real(4.0));
    let pairs = Inputs::<I>::values(&once).iter().zip(Inputs::<I>::values(&twice));
    for (rule, (once, twice)) in pairs.enumerate() {
        assert_eq!(*twice, *once * real(4.0) + real(rule as f64));
    }
}

fn what_is_added_stays<T: Scalar>() {
    for_every_shape!(added::<T>);
}

fn weights_below_the_square_of_epsilon_are_left_out<T: Scalar>() {
    let epsilon = T::default_epsilon();
    let half = epsilon * real(0.5);
    let cube = outer::<T, 2, 2>(&[[T::one(), epsilon], [epsilon, half]], T::one());
    assert_eq!(cube, [[epsilon, half], [epsilon * epsilon, T::zero()]]);
}

fn missing<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let rows = integers::<T, I, K>();
    for given in 0..I {
        let mut filled_up = [[T::one(); K]; I];
        filled_up[..given].copy_from_slice(&rows[..given]);
        let rate = real::<T>(3.0);
        assert_eq!(outer::<T, I, K>(&rows[..given], rate), outer::<T, I, K>(&filled_up, rate));
        let numbers = numbered::<T, I, K>();
        let contracted = |rows: &[[T; K]]| Inputs::<I>::contracted(&numbers, rows);
        assert_eq!(contracted(&rows[..given]), contracted(&filled_up));
    }
}

fn a_missing_row_counts_as_ones<T: Scalar>() {
    for_every_shape!(missing::<T>);
}

fn filled<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let cube = Inputs::<I>::filled::<T, K>(real(0.1));
    assert_eq!(Inputs::<I>::values(&cube), vec![real::<T>(0.1); K.pow(I as u32)]);
}

fn a_filled_grid_holds_the_same_value_for_every_rule<T: Scalar>() {
    for_every_shape!(filled::<T>);
}

fn written<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let cube = numbered::<T, I, K>();
    let numbers: Vec<T> = (0..K.pow(I as u32)).map(|rule| real(rule as f64)).collect();
    assert_eq!(Inputs::<I>::values(&cube), numbers);
}

fn values_written_are_read_back_in_the_same_order<T: Scalar>() {
    for_every_shape!(written::<T>);
}
