//! Plants that are in chain form as they stand: what differentiation finds is what they say themselves.

use brunovsky::{
    Scalar,
    plant::{
        Along, BoxSamples, Decouplable, Duffing, FeedbackLinearizable, Flow, Pendulum, SmoothPlant,
        ThirdOrder, VanDerPol,
    },
};
use nalgebra::SVector;

use crate::{at_f32_and_f64, support::num};

/// z = x, a and b are those of the plant, to the last bit: no entry of the jets behind them is anything but a copy or the drift itself.
fn assert_the_same<P, T: Scalar, const N: usize>(plant: P)
where
    P: FeedbackLinearizable<N, Scalar = T> + SmoothPlant<N, 1, Scalar = T> + Copy,
    Along: Flow<N>,
{
    let chain = plant.linearized::<N>([T::zero(); N]).unwrap();
    let corner = SVector::repeat(num::<T>(3.0));
    for x in BoxSamples::new(-corner, corner).unwrap().take(200) {
        let found = chain.linearization(&x).unwrap();
        assert_eq!(found.chains, [x]);
        assert_eq!((found.drift[0], found.matrix[0]), (plant.drift(&x), plant.input_gain(&x)));
        let degree = plant.relative_degree(x).unwrap();
        assert_eq!((degree.degrees, degree.zero_dynamics()), ([N], 0));
    }
}

fn the_chains_are_the_states<T: Scalar>() {
    assert_the_same(VanDerPol::new(num::<T>(1.7)).unwrap());
    assert_the_same(Duffing::new(num::<T>(0.2), num(-1.0), num(0.8)).unwrap());
    assert_the_same(Pendulum::new(num::<T>(1.3), num(0.7), num(0.2), num(9.81)).unwrap());
    assert_the_same(ThirdOrder::<T>::new());
}

at_f32_and_f64! {
    chains_drift_and_gain_are_those_of_the_plant => the_chains_are_the_states,
}
