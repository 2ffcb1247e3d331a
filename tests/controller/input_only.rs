use brunovsky::{controller::InputOnly, plant::IntegratorChain, prelude::*};

use super::support::flc;

#[test]
fn what_the_caller_refuses_is_not_taken() {
    let mut hidden = InputOnly(flc(IntegratorChain::<f64, 2>::new(), 3.0));
    let refusal = Error::Missing { name: "consent" };
    let seen = Measurement::new([0.0, 0.0]);
    let mut asked = None;
    let refused = hidden.update_if(&seen, &Reference::setpoint(1.0), 0.01, &mut |u| {
        asked = Some(*u);
        Err(refusal)
    });
    assert_eq!(refused, Err(refusal));
    assert_eq!(asked, Some(SVector::from([9.0])));
}
