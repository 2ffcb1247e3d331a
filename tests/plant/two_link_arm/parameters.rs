//! Payload, a mass matrix near singularity, and parameters that are no arm.

use super::*;

/// A payload is the point mass that it would be as part of link 2, by Steiner's theorem.
fn carries_a_payload_as_part_of_its_second_link<T: Scalar>() {
    let [[m1, l1, c1, i1], [m, l, c, i]] = ARM.links;
    let mass = m + ARM.payload;
    let centre = (m * c + ARM.payload * l) / mass;
    let inertia = i + m * (c - centre).powi(2) + ARM.payload * (l - centre).powi(2);
    let links = [[m1, l1, c1, i1], [mass, l, centre, inertia]];
    let merged = Parameters { links, payload: 0.0, ..ARM }.arm::<T>();
    let x = SVector::from([0.4, 1.1, -2.0, 3.0].map(num::<T>));
    let tau = SVector::from([3.0, -1.0].map(num::<T>));
    let expected = merged.derivative(T::zero(), &x, &tau);
    assert_equal_to_rounding(&ARM.arm().derivative(T::zero(), &x, &tau), &expected, 100.0);
}

/// Point masses on massless rods, folded so that M is as close to singular as it gets: det M = m₁·c₁²·M₂₂ at q₂ = 0.
fn inverts_the_double_pendulum_where_it_is_straight<T: Scalar>() {
    let links = [[1e-3, 1.0, 1.0, 0.0], [1.0, 1.0, 1.0, 0.0]];
    let arm = Parameters { links, payload: 0.0, ..ARM }.arm::<T>();
    let b = arm.decoupling_matrix(&SVector::zeros());
    // M = m₁·(1 0; 0 0) + (4 2; 2 1), so M⁻¹ = (1 −2; −2 4)/m₁ + (0 0; 0 1).
    let expected = SMatrix::<f64, 2, 2>::new(1000.0, -2000.0, -2000.0, 4001.0).map(num::<T>);
    let tolerance = T::default_epsilon() * num(8.0);
    approx::assert_relative_eq!(b, expected, max_relative = tolerance);
}

at_f32_and_f64! {
    a_payload_is_part_of_the_second_link => carries_a_payload_as_part_of_its_second_link,
    the_inverse_keeps_its_digits_near_a_singular_mass_matrix => inverts_the_double_pendulum_where_it_is_straight,
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    type Place = fn(&mut Parameters) -> &mut f64;
    let positive: [(&str, Place); 4] = [
        ("mass of link 1", |p| &mut p.links[0][0]),
        ("length of link 1", |p| &mut p.links[0][1]),
        ("mass of link 2", |p| &mut p.links[1][0]),
        ("length of link 2", |p| &mut p.links[1][1]),
    ];
    let not_negative: [(&str, Place); 8] = [
        ("centre of link 1", |p| &mut p.links[0][2]),
        ("inertia of link 1", |p| &mut p.links[0][3]),
        ("centre of link 2", |p| &mut p.links[1][2]),
        ("inertia of link 2", |p| &mut p.links[1][3]),
        ("friction of joint 1", |p| &mut p.friction[0]),
        ("friction of joint 2", |p| &mut p.friction[1]),
        ("gravity", |p| &mut p.gravity),
        ("payload", |p| &mut p.payload),
    ];
    let made = |place: Place, value: f64| {
        let mut p = ARM;
        *place(&mut p) = value;
        let links =
            p.links.map(|[mass, length, centre, inertia]| Link { mass, length, centre, inertia });
        TwoLinkArm::new(links, p.friction, p.gravity)?.with_payload(p.payload)
    };
    for (name, place) in positive {
        for value in [0.0, -0.0, -1.0] {
            assert_eq!(made(place, value), Err(Error::NotPositive { name, value }));
        }
    }
    for (name, place) in not_negative {
        assert!(made(place, 0.0).is_ok());
        let value = -1e-300;
        assert_eq!(made(place, value), Err(Error::Negative { name, value }));
    }
    for (name, place) in positive.into_iter().chain(not_negative) {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = made(place, value).unwrap_err();
            assert!(matches!(error, Error::NonFinite { name: found, .. } if found == name));
        }
    }
}

#[test]
fn a_link_that_turns_without_inertia_about_its_joint_is_refused() {
    let good = Link { mass: 1.0, length: 1.0, centre: 0.5, inertia: 0.0 };
    let made = |links| TwoLinkArm::new(links, [0.0; 2], 9.81).unwrap_err();
    let name = "inertia of link 1 about its joint";
    let bad = Link { centre: 0.0, ..good };
    assert_eq!(made([bad, good]), Error::NotPositive { name, value: 0.0 });
    let name = "inertia of link 2 about its joint";
    assert_eq!(made([good, bad]), Error::NotPositive { name, value: 0.0 });
    let bad = Link { centre: 1e200, ..good };
    assert_eq!(made([good, bad]), Error::NonFinite { name, value: f64::INFINITY });
}
