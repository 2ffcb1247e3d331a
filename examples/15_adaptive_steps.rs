//! Steps that follow from a tolerance: what the tolerance buys, how an input that jumps is met, and what a stiff plant asks for.

use brunovsky::{integrators::Statistics, prelude::*};

/// x(40) of the reaction that is standard for stiff methods: Hairer, Wanner, "Solving Ordinary Differential Equations II", IV.10.
const ROBERTSON: [f64; 3] = [0.715827068719394, 9.185534764557338e-6, 0.2841637457458413];

/// ẍ = −x + u(t) with u = 1 from t = 1 on: x = cos t, and 1 − cos(t − 1) more from then on.
fn pushed(t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
    SVector::from([x[1], if t < 1.0 { -x[0] } else { 1.0 - x[0] }])
}

/// The rates of three substances, one of which is gone at once.
fn reaction(_t: f64, x: &SVector<f64, 3>) -> SVector<f64, 3> {
    let (slow, fast) = (0.04 * x[0], 1e4 * x[1] * x[2]);
    let gone = 3e7 * x[1] * x[1];
    SVector::from([fast - slow, slow - fast - gone, gone])
}

fn report(name: &str, rtol: f64, error: f64, spent: Statistics) {
    let Statistics { accepted, rejected, evaluations, .. } = spent;
    println!("{name:28} {rtol:7.0e} {error:10.1e} {accepted:8} {rejected:8} {evaluations:8}");
}

fn main() -> Result<(), Error> {
    println!("                                rtol      error    steps rejected  calls of f");
    let expected = 10.0_f64.cos() + 1.0 - 9.0_f64.cos();
    for rtol in [1e-4, 1e-7, 1e-10] {
        let method = Adaptive::new(DormandPrince, Tolerance::new(rtol, rtol)?);
        // Told of the jump, no step goes across it; otherwise steps are rejected until they are small enough there.
        for (name, jumps) in
            [("oscillator, jump declared", &[1.0][..]), ("oscillator, undeclared", &[])]
        {
            let mut solver = method.solve(pushed, 0.0, [1.0, 0.0])?.with_discontinuities(jumps)?;
            let error = solver.at(10.0)?[0] - expected;
            report(name, rtol, error.abs(), solver.statistics());
        }
    }
    let tolerance = Tolerance::per_component(1e-6, [1e-9, 1e-13, 1e-9])?;
    let start = [1.0, 0.0, 0.0];
    let off = |x: SVector<f64, 3>| (x - SVector::from(ROBERTSON)).amax();
    let mut explicit = Adaptive::new(DormandPrince, tolerance).solve(reaction, 0.0, start)?;
    let error = off(*explicit.advance(40.0)?);
    report("reaction, Dormand–Prince", 1e-6, error, explicit.statistics());
    let mut stiff = Adaptive::new(Rodas::new(), tolerance).solve(reaction, 0.0, start)?;
    let error = off(*stiff.advance(40.0)?);
    report("reaction, Rodas", 1e-6, error, stiff.statistics());

    // Only a method for stiff plants gets this far. Nothing is lost on the way: the sum of the substances is 1.
    println!("\n        t in s         x₁         x₂         x₃     1 − Σx");
    for t in [4e2, 4e4, 4e6, 4e8, 4e10] {
        let x = *stiff.advance(t)?;
        println!("{t:14.0e} {:10.3e} {:10.3e} {:10.3e} {:10.1e}", x[0], x[1], x[2], 1.0 - x.sum());
    }
    Ok(())
}
