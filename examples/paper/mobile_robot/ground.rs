//! The ground that the robot slips on.

use brunovsky::plant::Traction;

/// Traction that varies over some 20 m to 40 m.
#[derive(Clone, Copy)]
pub struct Ground {
    /// The mean of μ, which varies by ±0.05.
    pub longitudinal: f64,
    /// The mean of κ, which varies by ±0.12.
    pub yaw: f64,
    /// How far ahead of the robot's centre it turns about, in m.
    pub side: f64,
    /// Where on this ground the path begins, in m.
    pub origin: [f64; 2],
}

/// The ground of the study: longitudinal slip of 10 ± 5 %, centre of rotation 0.1 m ahead. The mean yaw traction was lowered from 0.6 (a
/// yaw slip of 40 %) until feedback linearization alone showed the mean error of 0.12 m that the paper measured on its field, which the first
/// row of the printed table shows; CLELC had no part in it, and nothing was changed afterwards.
pub const GROUND: Ground = Ground { longitudinal: 0.9, yaw: 0.465, side: 0.1, origin: [0.0, 0.0] };

impl Ground {
    /// The traction at (x, y).
    pub fn traction(&self, x: f64, y: f64) -> Traction<f64> {
        let (x, y) = (x + self.origin[0], y + self.origin[1]);
        Traction {
            longitudinal: self.longitudinal + 0.05 * (0.31 * x).sin() * (0.23 * y + 1.0).cos(),
            yaw: self.yaw + 0.12 * (0.17 * x + 0.5).sin() * (0.27 * y).cos(),
            side: self.side,
        }
    }
}
