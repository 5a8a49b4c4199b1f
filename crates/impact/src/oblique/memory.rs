//! What the contact remembers: for each depth z the velocity, time and traction when the ring
//! that touches at z was last free of additional stress (the "old" state of section 8.4).

use super::adhesion::Segment;
use crate::normal::compression;

/// The stored state of the ring at one depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Old {
    /// Tangential velocity of the stored path there, in the unit of u.
    pub(super) velocity: f64,
    /// Normal velocity of the stored path there: d(shift)/d(depth) = velocity / speed.
    pub(super) speed: f64,
    /// Stored traction Phi of the contact within that depth.
    pub(super) traction: f64,
}

/// How a stretch of depths was laid down.
#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// In complete adhesion while the contact grew.
    Adhesion(Box<Segment>),
    /// In slip: slope `sign`.
    Slip(Frozen),
}

/// The stresses that slip of one sign left behind, frozen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frozen {
    pub(super) sign: f64,
    /// The sign over `scale`: the path's velocity in the unit of u.
    velocity: f64,
    /// Traction at the lower end and low^(3/2).
    traction: f64,
    base: f64,
}

/// A stretch of depths `low..high` of the memory.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) shape: Shape,
}

impl Stretch {
    pub(super) fn adhesion(segment: Segment) -> Self {
        let (low, high) = (compression(segment.high), compression(segment.low));
        Self { low, high, shape: Shape::Adhesion(Box::new(segment)) }
    }

    /// Slip of this sign over `low..high`, with the traction at `low`; `scale` is the unit of u
    /// in units of zeta_dot_A.
    pub(super) fn slip(low: f64, high: f64, sign: f64, traction: f64, scale: f64) -> Self {
        let base = low * low.sqrt();
        let frozen = Frozen { sign, velocity: sign / scale, traction, base };
        Self { low, high, shape: Shape::Slip(frozen) }
    }

    /// The stored state at depth `z`, whose square root is `radius`.
    #[inline]
    pub(super) fn at(&self, z: f64, radius: f64, chi: f64) -> Old {
        let z_three_halves = z * radius;
        match &self.shape {
            Shape::Adhesion(segment) => {
                let speed = (1.0 - z * z_three_halves).max(0.0).sqrt();
                let state = segment.at(speed);
                let traction = z_three_halves * state.gradient / chi;
                Old { velocity: state.velocity, speed, traction }
            }
            Shape::Slip(frozen) => {
                let rise = z_three_halves - frozen.base;
                let traction = frozen.traction + frozen.velocity * rise;
                Old { velocity: frozen.velocity, speed: 1.0, traction }
            }
        }
    }
}
