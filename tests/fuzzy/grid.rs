use brunovsky::{
    Scalar,
    fuzzy::{Grid, Inputs},
};

use crate::support::{digit, real};

in_both_precisions! {
    the_last_input_runs_fastest,
    the_outer_product_agrees_with_index_arithmetic,
    the_scale_multiplies_every_value,
    a_missing_row_counts_as_ones,
    a_filled_grid_holds_the_same_value_for_every_rule,
    values_written_are_read_back_in_the_same_order,
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
    let cube = Inputs::<I>::outer(&rows, T::one());
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
    let cube = Inputs::<I>::outer(&rows, real(-0.5));
    for (rule, value) in Inputs::<I>::values(&cube).iter().enumerate() {
        let product =
            (0..I).fold(real::<T>(-0.5), |product, i| product * rows[i][digit::<I, K>(rule, i)]);
        assert_eq!(*value, product);
    }
}

fn the_outer_product_agrees_with_index_arithmetic<T: Scalar>() {
    for_every_shape!(index_arithmetic::<T>);
}

fn scaled<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let rows = integers::<T, I, K>();
    let (one, four) = (Inputs::<I>::outer(&rows, T::one()), Inputs::<I>::outer(&rows, real(4.0)));
    for (one, four) in Inputs::<I>::values(&one).iter().zip(Inputs::<I>::values(&four)) {
        assert_eq!(*four, *one * real(4.0));
    }
}

fn the_scale_multiplies_every_value<T: Scalar>() {
    for_every_shape!(scaled::<T>);
}

fn missing<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let rows = integers::<T, I, K>();
    for given in 0..I {
        let mut filled_up = [[T::one(); K]; I];
        filled_up[..given].copy_from_slice(&rows[..given]);
        let scale = real::<T>(3.0);
        assert_eq!(
            Inputs::<I>::outer(&rows[..given], scale),
            Inputs::<I>::outer(&filled_up, scale)
        );
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
    let mut cube = Inputs::<I>::filled::<T, K>(T::zero());
    for (rule, value) in Inputs::<I>::values_mut(&mut cube).iter_mut().enumerate() {
        *value = real(rule as f64);
    }
    let numbers: Vec<T> = (0..K.pow(I as u32)).map(|rule| real(rule as f64)).collect();
    assert_eq!(Inputs::<I>::values(&cube), numbers);
}

fn values_written_are_read_back_in_the_same_order<T: Scalar>() {
    for_every_shape!(written::<T>);
}
