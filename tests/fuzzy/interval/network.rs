use approx::assert_abs_diff_eq;
use brunovsky::{
    Error, Scalar,
    fuzzy::{
        Elliptic, FuzzyNetwork, Grid, Inputs, IntervalMembership, IntervalNetwork, Network, Over,
        Strengths, TriangularNetwork, TypeReduction, UncertainGaussian,
    },
    nalgebra::SVector,
};
use proptest::{collection::vec, prelude::*};

use crate::support::{Case, case, cases, digit, real, ulps};

in_both_precisions! {
    both_reductions_agree_with_sums_over_all_rules,
    equal_widths_make_it_the_network_of_type_one,
    triangles_make_it_the_triangular_network,
    the_strengths_are_a_partition_of_unity_with_the_stated_norm_anywhere,
    the_output_lies_between_the_least_and_the_greatest_consequent,
    moving_the_consequents_moves_the_output_by_the_squared_norm,
    a_weight_or_an_uncertainty_out_of_range_is_refused,
}

/// Widths from σ to (1 + blur)·σ, and ellipses with the exponents 1/(1 + blur) and 1 + blur that reach past the inputs of the case.
fn networks<T: Scalar, const I: usize, const K: usize>(
    case: &Case<T, I, K>,
    blur: f64,
    reduction: TypeReduction<T>,
) -> (IntervalNetwork<UncertainGaussian<T>, T, I, K>, IntervalNetwork<Elliptic<T>, T, I, K>)
where
    Inputs<I>: Grid,
{
    let blurred = case.memberships.map(|row| {
        row.map(|own| {
            UncertainGaussian::new(own.centre(), [own.width(), own.width() * real(1.0 + blur)])
                .unwrap()
        })
    });
    let elliptic = case.memberships.map(|row| {
        row.map(|own| {
            let exponents = [1.0 / (1.0 + blur), 1.0 + blur].map(real);
            Elliptic::new(own.centre(), own.width() * real(6.0), exponents).unwrap()
        })
    });
    let mut gaussian = IntervalNetwork::new(blurred, reduction).unwrap();
    let mut elliptic = IntervalNetwork::new(elliptic, reduction).unwrap();
    gaussian.set_consequents(&case.consequents).unwrap();
    elliptic.set_consequents(&case.consequents).unwrap();
    assert_eq!(*gaussian.consequents(), case.consequents[..]);
    (gaussian, elliptic)
}

fn reductions<T: Scalar>(m: f64) -> [TypeReduction<T>; 2] {
    [TypeReduction::NieTan, TypeReduction::Bmm { m: real(m) }]
}

/// Σ over all rules, as the two papers write it.
fn transcribed<M: IntervalMembership<T>, T: Scalar, const I: usize, const K: usize>(
    memberships: &[[M; K]; I],
    consequents: &[T],
    e: &SVector<T, I>,
    reduction: TypeReduction<T>,
) -> T {
    let firing = |rule: usize| {
        (0..I).fold([T::one(); 2], |[low, high], i| {
            let [lower, upper] = memberships[i][digit::<I, K>(rule, i)].grades(e[i]);
            [low * lower, high * upper]
        })
    };
    let mean = |weight: &dyn Fn([T; 2]) -> T| {
        let (mut sum, mut weights) = (T::zero(), T::zero());
        for (rule, f) in consequents.iter().enumerate() {
            let w = weight(firing(rule));
            sum += w * *f;
            weights += w;
        }
        sum / weights
    };
    match reduction {
        TypeReduction::NieTan => mean(&|[lower, upper]| lower + upper),
        TypeReduction::Bmm { m } => {
            m * mean(&|[_, upper]| upper) + (T::one() - m) * mean(&|[lower, _]| lower)
        }
    }
}

fn transcription<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>(), blur in 0.0..1.0_f64, m in 0.0..=1.0_f64)| {
        for reduction in reductions(m) {
            let (gaussian, elliptic) = networks(&case, blur, reduction);
            let wanted = transcribed(&gaussian.memberships(), &case.consequents, &case.e, reduction);
            // Exponents of up to I·5²/2 = 75 and their rounding, as for type 1.
            assert_abs_diff_eq!(gaussian.evaluate(&case.e).unwrap(), wanted, epsilon = ulps(1000.0));
            let wanted = transcribed(&elliptic.memberships(), &case.consequents, &case.e, reduction);
            // 1 − |z|^a is as small as 0.08, and its logarithm is divided by a ≥ 1/2, for each input.
            assert_abs_diff_eq!(elliptic.evaluate(&case.e).unwrap(), wanted, epsilon = ulps(1000.0));
        }
    });
}

fn both_reductions_agree_with_sums_over_all_rules<T: Scalar>() {
    for_every_shape!(transcription::<T>);
}

fn of_type_one<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>(), m in 0.0..=1.0_f64, far in -60.0..60.0_f64)| {
        for e in [case.e, case.e.map(|e| e * real(far))] {
            let wanted = case.network().evaluate(&e).unwrap();
            for reduction in reductions(m) {
                let (own, _) = networks(&case, 0.0, reduction);
                let u_n = own.evaluate(&e).unwrap();
                match reduction {
                    // Halves of the same number, without rounding.
                    TypeReduction::NieTan => prop_assert_eq!(u_n, wanted),
                    TypeReduction::Bmm { .. } => assert_abs_diff_eq!(u_n, wanted, epsilon = ulps(4.0)),
                }
            }
        }
    });
}

fn equal_widths_make_it_the_network_of_type_one<T: Scalar>() {
    for_every_shape!(of_type_one::<T>);
}

fn triangles_make_it_the_triangular_network<T: Scalar>() {
    let values = [1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0].map(real::<T>);
    let mut triangular =
        TriangularNetwork::<T, 2, 3>::evenly_spaced([T::one(), real(4.0)]).unwrap();
    triangular.set_consequents(&values).unwrap();
    for reduction in reductions(0.3) {
        let ranges = [T::one(), real(4.0)];
        let mut own =
            IntervalNetwork::<_, T, 2, 3>::elliptic(ranges, [T::one(); 2], reduction).unwrap();
        own.set_consequents(&values).unwrap();
        proptest!(cases(256), |(e1 in -3.0..3.0_f64, e2 in -9.0..9.0_f64)| {
            let e = SVector::from([e1, e2].map(real::<T>));
            // Logarithms round to ε, and f takes that times 9.
            assert_abs_diff_eq!(own.evaluate(&e).unwrap(), triangular.evaluate(&e).unwrap(), epsilon = ulps(200.0));
        });
    }
}

fn is_a_partition<W: Over<T, I>, T: Scalar, const I: usize>(network: &W, e: &SVector<T, I>) {
    let firing = network.fire(e);
    let strengths = firing.strengths();
    assert!(strengths.iter().all(|w| *w >= T::zero() && *w <= T::one() + ulps(16.0)));
    let sums = strengths.iter().fold((T::zero(), T::zero()), |(a, b), w| (a + *w, b + *w * *w));
    let rounding = ulps::<T>((8 * I * strengths.len()) as f64);
    assert_abs_diff_eq!(sums.0, T::one(), epsilon = rounding);
    assert_abs_diff_eq!(firing.norm_squared(), sums.1, epsilon = rounding);
}

/// Near by and out to the end of the numbers, for one input and for all of them: the supports of the ellipses end at 13.
fn partition<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    let most = T::max_value().unwrap();
    proptest!(cases(12), |(case in case::<T, I, K>(), blur in 0.0..1.0_f64, m in 0.0..=1.0_f64, side in prop::bool::ANY)| {
        for reduction in reductions(m) {
            let (gaussian, elliptic) = networks(&case, blur, reduction);
            is_a_partition(&gaussian, &case.e);
            is_a_partition(&elliptic, &case.e);
            for far in [real(7.0), real(12.9), real(102.0), real(1e30), most] {
                let far = if side { far } else { -far };
                let mut one = case.e;
                one[I / 2] = far;
                for e in [one, SVector::repeat(far)] {
                    is_a_partition(&gaussian, &e);
                    is_a_partition(&elliptic, &e);
                }
            }
        }
    });
}

fn the_strengths_are_a_partition_of_unity_with_the_stated_norm_anywhere<T: Scalar>() {
    for_every_shape!(partition::<T>);
}

fn hull<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>(), blur in 0.0..1.0_f64, m in 0.0..=1.0_f64, e in vec(-50.0..50.0_f64, I))| {
        let e = SVector::from_fn(|i, _| real::<T>(e[i]));
        let least = case.consequents.iter().copied().reduce(T::min).unwrap();
        let greatest = case.consequents.iter().copied().reduce(T::max).unwrap();
        let rounding = ulps::<T>((4 * I * K) as f64);
        for reduction in reductions(m) {
            let (gaussian, elliptic) = networks(&case, blur, reduction);
            for u_n in [gaussian.evaluate(&e).unwrap(), elliptic.evaluate(&e).unwrap()] {
                prop_assert!(u_n >= least - rounding && u_n <= greatest + rounding);
            }
        }
    });
}

fn the_output_lies_between_the_least_and_the_greatest_consequent<T: Scalar>() {
    for_every_shape!(hull::<T>);
}

fn moved<T: Scalar, const I: usize, const K: usize>()
where
    Inputs<I>: Grid,
{
    proptest!(cases(24), |(case in case::<T, I, K>(), blur in 0.0..1.0_f64, rate in -8..8_i32)| {
        for reduction in reductions(0.3) {
            let (mut network, _) = networks(&case, blur, reduction);
            let (firing, rate) = (network.fire(&case.e), real::<T>(rate.into()));
            let (before, consequents) = (network.output(&firing), network.consequents());
            network.move_consequents(&firing, rate);
            let wanted = before + rate * firing.norm_squared();
            assert_abs_diff_eq!(network.output(&firing), wanted, epsilon = ulps((64 * I * K) as f64));
            let strengths = firing.strengths();
            for ((after, before), w) in network.consequents().iter().zip(consequents.iter()).zip(strengths.iter()) {
                assert_abs_diff_eq!(*after, *before + rate * *w, epsilon = ulps(32.0));
            }
            network.change_consequents(|f| f.fill(T::one()));
            assert_abs_diff_eq!(network.output(&firing), T::one(), epsilon = ulps((8 * I * K) as f64));
        }
    });
}

fn moving_the_consequents_moves_the_output_by_the_squared_norm<T: Scalar>() {
    for_every_shape!(moved::<T>);
}

fn a_weight_or_an_uncertainty_out_of_range_is_refused<T: Scalar>() {
    let attempt = |uncertainty: f64, m: f64| {
        let reduction = TypeReduction::Bmm { m: real(m) };
        IntervalNetwork::<_, T, 2, 3>::gaussian([T::one(); 2], real(uncertainty), reduction)
    };
    assert!(attempt(0.0, 0.0).is_ok() && attempt(0.9, 1.0).is_ok());
    assert_eq!(attempt(0.2, 1.5).unwrap_err(), Error::Above { name: "m", value: 1.5, limit: 1.0 });
    assert_eq!(attempt(0.2, -0.5).unwrap_err(), Error::Negative { name: "m", value: -0.5 });
    assert_eq!(
        attempt(1.0, 0.5).unwrap_err(),
        Error::NotBelow { name: "uncertainty", value: 1.0, limit: 1.0 }
    );
    assert_eq!(
        attempt(-0.5, 0.5).unwrap_err(),
        Error::Negative { name: "uncertainty", value: -0.5 }
    );
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(attempt(bad, 0.5), Err(Error::NonFinite { name: "uncertainty", .. })));
        assert!(matches!(attempt(0.2, bad), Err(Error::NonFinite { name: "m", .. })));
    }
    // What is certain is the network of type 1.
    let own = attempt(0.0, 0.5).unwrap().memberships();
    let certain = FuzzyNetwork::<T, 2, 3>::evenly_spaced([T::one(); 2]).unwrap().memberships();
    assert_eq!(own, certain.map(|row| row.map(UncertainGaussian::from)));
}
