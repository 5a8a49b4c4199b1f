//! One law along a path, and what must hold at each step.

mod stored;

use carom_fuzz::Bytes;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLoad, Dissipative, Shift};
pub(crate) use stored::Stored;

/// More steps than this are another path.
const STEPS: usize = 40;
/// What rounding adds to the greatest force.
const ROUNDING: f64 = 1e-9;

/// The greatest loads.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) friction: Friction,
    pub(crate) c_z: f64,
    /// The least and the greatest normal force, over that of Hertz.
    pub(crate) normal: [f64; 2],
    /// Of the torque over that of the force, at unit approach.
    pub(crate) arm: f64,
}

impl Limits {
    pub(crate) fn of(friction: Friction, c_z: f64) -> Self {
        // The torque of these laws is none, or has no limit of its own.
        Self { friction, c_z, normal: [1.0; 2], arm: f64::INFINITY }
    }

    fn check(self, shift: Shift, load: ContactLoad) {
        let ContactLoad { f_x, f_y, f_z, m_z } = load;
        assert!([f_x, f_y, f_z, m_z].iter().all(|part| !part.is_nan()), "{load:?} at {shift:?}");
        let zeta = shift.zeta.max(0.0);
        let normal = 2.0 / 3.0 * self.c_z * zeta * zeta.sqrt();
        // The smallest numbers have fewer digits.
        let least = self.normal[0] * normal * (1.0 - ROUNDING) - 1e-300;
        let most = self.normal[1] * normal * (1.0 + ROUNDING) + 1e-300;
        assert!(f_z >= least && (f_z <= most || most.is_nan()), "{load:?} at {shift:?}");
        let Some(f) = self.friction.coefficient() else { return };
        let limit = f * f_z * (1.0 + ROUNDING) + 1e-300;
        assert!(f_x.hypot(f_y) <= limit, "{load:?} at {shift:?}: more than {limit}");
        if self.arm.is_finite() {
            let limit = limit * self.arm * zeta.sqrt() + 1e-300;
            assert!(m_z.abs() <= limit, "{load:?} at {shift:?}: more than {limit}");
        }
    }
}

pub(crate) fn follow<L: Dissipative + Stored>(mut law: L, bytes: &mut Bytes<'_>, limits: Limits) {
    // A path that slips in a part of the contact at unit approach.
    let scale = limits.friction.coefficient().unwrap_or(1.0).clamp(1e-3, 1e3);
    for _ in 0..STEPS {
        if bytes.is_empty() {
            break;
        }
        let to = next(law.shift(), scale, bytes);
        step(&mut law, to, limits);
    }
    law.check_stored();
}

/// The next shift: most often one part changes, or each.
fn next(from: Shift, scale: f64, bytes: &mut Bytes<'_>) -> Shift {
    let mut to = from;
    match bytes.pick(8) {
        0 => to.zeta = bytes.number(1.0),
        1 => to.xi = bytes.number(scale),
        2 => to.eta = bytes.number(scale),
        3 => to.omega = bytes.number(scale),
        4 => to.zeta = 0.0,
        _ => {
            to.zeta = from.zeta + bytes.number(0.25);
            to.xi = from.xi + bytes.number(0.25 * scale);
            to.eta = from.eta + bytes.number(0.25 * scale);
        }
    }
    to
}

fn step<L: Dissipative + Stored>(law: &mut L, to: Shift, limits: Limits) {
    let heat = law.dissipation(to);
    assert!(!heat.is_nan(), "heat {heat} on the way to {to:?}");
    let before = law.clone();
    match law.advance(to) {
        Ok(load) => {
            limits.check(to, load);
            limits.check(to, law.load());
            let stored = law.stored_energy();
            assert!(stored >= 0.0, "stored {stored} at {to:?}");
        }
        Err(error) => {
            assert!(law.is_same(&before), "{error} changes the state");
            assert!(!error.to_string().is_empty());
        }
    }
}
