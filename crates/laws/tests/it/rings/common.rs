use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::Shift;
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};

/// A contact of radius 1 at unit approach.
pub(crate) fn hertz(moduli: [f64; 2], poisson: [f64; 2]) -> Hertz {
    let body = |i: usize| Material::from_shear(moduli[i], poisson[i]).unwrap();
    let pair = MaterialPair::new(body(0), body(1)).unwrap();
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap()
}

/// Two bodies alike.
pub(crate) fn alike(poisson: f64) -> Hertz {
    hertz([2.0, 2.0], [poisson, poisson])
}

/// kappa = 7/6, gamma = 1/3.
pub(crate) fn unlike() -> Hertz {
    hertz([2.0, 2.0], [0.0, 0.5])
}

pub(crate) fn law<const N: usize, const M: usize>(
    hertz: &Hertz,
    friction: f64,
    tolerance: f64,
) -> RingLaw<N, M> {
    let friction = Friction::new(friction).unwrap();
    RingLaw::new(hertz, friction, Tolerance::new(tolerance).unwrap()).unwrap()
}

/// A law of these groups, with c_z = 4 and a^2 = zeta.
pub(crate) fn law_of<const N: usize, const M: usize>(
    [kappa, gamma, friction]: [f64; 3],
    tolerance: f64,
) -> RingLaw<N, M> {
    let constants = RingConstants { c_z: 4.0, radius: 1.0, kappa, gamma };
    let friction = Friction::new(friction).unwrap();
    RingLaw::from_constants(constants, friction, Tolerance::new(tolerance).unwrap()).unwrap()
}

pub(crate) fn shift([zeta, xi, eta, omega]: [f64; 4]) -> Shift {
    Shift { zeta, xi, eta, omega }
}

/// A broken line of so many legs, each in so many steps: approach from 0.2 to 1, shifts and twist up to
/// the sizes given.
pub(crate) fn path(seed: u64, legs: usize, steps: usize, sizes: [f64; 2]) -> Vec<Shift> {
    let mut draw = Congruential(seed);
    let mut at = [0.0; 4];
    let mut path = Vec::with_capacity(legs * steps);
    for _ in 0..legs {
        let approach = 0.2 + 0.8 * draw.part();
        let [x, y, turn] = std::array::from_fn(|_| draw.signed());
        let to = [approach, sizes[0] * x, sizes[0] * y, sizes[1] * turn];
        for k in 1..=steps {
            let part = k as f64 / steps as f64;
            path.push(shift(std::array::from_fn(|i| at[i] + part * (to[i] - at[i]))));
        }
        at = to;
    }
    path
}
