use brunovsky::{Scalar, channel::Delay};

use super::{all_arrived, at_f32_and_f64, num};

fn what_arrives_was_sent_some_calls_before<T: Scalar>() {
    let sent = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    let late = all_arrived(Delay::<T, 1, 3>::new(), &sent, 0.1);
    assert_eq!(late, [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0].map(num));
    let filled = Delay::<T, 1, 2>::new().starting_at([num::<T>(9.0)]).unwrap();
    assert_eq!(all_arrived(filled, &sent, 0.1), [9.0, 9.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(num));
    assert_eq!(all_arrived(Delay::<T, 1, 0>::new(), &sent, 0.1), sent.map(num));
}

at_f32_and_f64! {
    a_delay_shifts_the_signal => what_arrives_was_sent_some_calls_before,
}

/// Two delays are one of their sum.
#[test]
fn delays_add_up() {
    let sent: Vec<f64> = (0..40).map(f64::from).collect();
    let pair = (Delay::<f64, 1, 3>::new(), Delay::<f64, 1, 4>::new());
    let one = Delay::<f64, 1, 7>::default();
    assert_eq!(all_arrived(pair, &sent, 0.1), all_arrived(one, &sent, 0.1));
}
