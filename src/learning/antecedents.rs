use crate::{
    Error, Scalar,
    error::{below, positive},
    fuzzy::{Network, Travelling},
    scalar::constant,
};

/// What becomes of the membership functions of a network `W` while it learns.
///
/// [`Flow`] is the paper's law (eq_c_ik, eq_sigma_ik). With d = e − c and M = d/σ it says Ṁ·M = ας for every membership, and has
/// the closed form, over a period with ς constant and τ = αςh,
///
/// d⁺ = d·e^{−τ}, M⁺² = M² + 2τ, c⁺ = e⁺ − d⁺, σ⁺ = |d⁺|/|M⁺|,
///
/// where e⁺ is the input that is actually measured next. (τ has the units of u_n and M² has none; as in the paper, τ is taken as the
/// number that it is in the units in use.) There is no step to choose and no division by (e − c)². All M² of one input move together, so
/// the normalized firing strengths do not change at all: *under this law the network is an integrator*, u_n(t) = u_n(0) + α∫ς dt, and its
/// memberships carry no information about e. It needs a network that is [`Travelling`].
///
/// [`Fixed`] leaves them in place. The consequents then store u_n as a function of e, which is remembered where the state
/// returns to; in exchange u_n also moves when e does. Under noise they also store what the noise of e says about that of s: a difference,
/// [`ModelAided`](super::ModelAided) included, has the noise of e_n in s as 1/h of itself, and within some (σ/noise)² samples the network
/// takes it for more gain on e_n, up to 1/h, in which it then stays: less error, a rougher u. The example `long_run` shows it.
///
/// # The singularity
/// For ς < 0 the law drives M² to zero in finite time and asks for an infinite σ̇ there: the input sits on a centre. For ς > 0, M²
/// grows without bound and d shrinks below rounding. The policy is to **stop at a floor and a ceiling** on M²: τ is cut, for all
/// memberships of an input alike, so that none passes them, and the flow goes on as soon as ς points away. The centres travel with
/// the input throughout, and the consequents learn throughout, so u̇_n = ας and the firing strengths are untouched by the stop.
/// The flow also stops before d leaves the range of the scalar; and the memberships of an input that starts within √floor widths
/// of a centre do not flow at all, they only travel.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what becomes of the memberships of `{W}`",
    label = "not a treatment of the antecedents of this network",
    note = "`Fixed` leaves them where they are, in every network; `Flow` needs one that is `Travelling`, with the same scalar"
)]
pub trait Antecedents<W: Network> {
    /// Moves the memberships with the input, which has become `e`.
    fn follow(&self, network: &mut W, e: &W::Input);

    /// Moves them by what is learned at that input: τ = αςh, in the units of u_n.
    fn flow(&self, network: &mut W, tau: W::Scalar);
}

/// Membership functions stay where they are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fixed;

impl<W: Network> Antecedents<W> for Fixed {
    fn follow(&self, _: &mut W, _: &W::Input) {}

    fn flow(&self, _: &mut W, _: W::Scalar) {}
}

/// Membership functions follow the paper's law between two bounds on M².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow<T> {
    floor: T,
    ceiling: T,
}

impl<T: Scalar> Flow<T> {
    /// The paper's law for M² from `floor` > 0 to `ceiling` > `floor`.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotBelow`] or [`Error::NonFinite`] for bounds that are not 0 < floor < ceiling.
    pub fn new(floor: T, ceiling: T) -> Result<Self, Error> {
        below("floor", positive("floor", floor)?, positive("ceiling", ceiling)?)?;
        Ok(Self { floor, ceiling })
    }
}

/// The paper's law between M = 0.1 and M = 10.
impl<T: Scalar> Default for Flow<T> {
    fn default() -> Self {
        Self { floor: constant(0.01), ceiling: constant(100.0) }
    }
}

impl<T: Scalar, W: Travelling<Scalar = T>> Antecedents<W> for Flow<T> {
    fn follow(&self, network: &mut W, e: &W::Input) {
        // ċ = ė + …: between samples the centres travel exactly as far as the input did.
        network.carry(e, self.floor, self.ceiling);
    }

    fn flow(&self, network: &mut W, tau: T) {
        network.flow(tau);
    }
}

checked! { [T: Scalar] Flow<T>, [T] { floor: T, ceiling: T } => Self::new(floor, ceiling) }
