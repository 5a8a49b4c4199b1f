//! An oblique impact integrated in time, with a contact of independent springs: the same problem by another
//! method, independent of the laws and the solver that it checks.
//!
//! There is a spring at each distance x from the centre; it touches when the approach exceeds x^2/R. It
//! carries a normal force by its compression, and a tangential force up to f times the normal one; beyond
//! that it slides. Springs with the normal stiffness 2 E* and the tangential stiffness 8 G*, per unit of x on
//! one side, give Hertz's force and Mindlin's stiffness. By the method of dimensionality reduction (Popov and
//! Hess) they follow any path exactly.

/// A bed of springs with sliders.
pub(crate) struct SpringBed {
    spacing: f64,
    /// Stiffness of a unit of x along the normal and along the surface.
    stiffness: [f64; 2],
    friction: f64,
    springs: Vec<Spring>,
    approach: f64,
    shift: f64,
}

struct Spring {
    /// The approach at which the spring touches.
    depth: f64,
    /// The shift at which it has no tangential force.
    anchor: f64,
}

/// The load of the bed.
#[derive(Clone, Copy)]
pub(crate) struct Load {
    pub(crate) normal: f64,
    pub(crate) tangential: f64,
    /// Whether a spring slid.
    pub(crate) slides: bool,
}

impl SpringBed {
    /// `count` springs for approaches up to `deepest` on a sphere of radius `radius`; `stiffness`
    /// per unit of x on one side.
    pub(crate) fn new(
        count: usize,
        deepest: f64,
        radius: f64,
        stiffness: [f64; 2],
        friction: f64,
    ) -> Self {
        let spacing = (deepest * radius).sqrt() / count as f64;
        let spring = |i: usize| {
            let x = (i as f64 + 0.5) * spacing;
            Spring { depth: x * x / radius, anchor: 0.0 }
        };
        let springs = (0..count).map(spring).collect();
        Self { spacing, stiffness, friction, springs, approach: 0.0, shift: 0.0 }
    }

    /// The load after a step to this approach and shift.
    pub(crate) fn advance(&mut self, approach: f64, shift: f64) -> Load {
        let [normal, tangential] = self.stiffness;
        let grip = self.friction * normal / tangential;
        let (mut sums, mut slides) = ([0.0; 2], false);
        for spring in &mut self.springs {
            let pressed = approach - spring.depth;
            if pressed <= 0.0 {
                continue;
            }
            let before = self.approach - spring.depth;
            if before <= 0.0 {
                // A spring that touches within the step starts without tangential force.
                let part = -before / (pressed - before);
                spring.anchor = self.shift + part * (shift - self.shift);
            }
            let reach = grip * pressed;
            let claims_that_hold = spring.anchor.clamp(shift - reach, shift + reach);
            // A spring that touches within the step may be deflected by rounding.
            slides |= before > 0.0 && claims_that_hold != spring.anchor;
            spring.anchor = claims_that_hold;
            sums[0] += pressed;
            sums[1] += shift - spring.anchor;
        }
        (self.approach, self.shift) = (approach, shift);
        Load {
            normal: self.spacing * normal * sums[0],
            tangential: self.spacing * tangential * sums[1],
            slides,
        }
    }
}

const SPRINGS: usize = 400;
const STEPS: usize = 1600;

/// The result of an impact integrated in time, in the units of [`course`].
#[derive(Clone, Copy, Default)]
pub(crate) struct Stepped {
    /// R_x, to about 2e-6.
    pub(crate) restitution: f64,
    /// The tangential force shortly before separation.
    pub(crate) last_force: f64,
    /// The time at which the shift is largest.
    pub(crate) peak: f64,
    /// The smallest shift, and the shift at separation.
    pub(crate) least: f64,
    pub(crate) last: f64,
    /// The time at which the first spring slid.
    pub(crate) slips_at: f64,
}

/// R_x of the impact of groups chi and psi, to about 2e-6.
pub(crate) fn restitution(chi: f64, psi: f64) -> f64 {
    course(chi, psi).restitution
}

/// The impact of groups chi and psi.
///
/// Units: zeta_max, zeta_max/zeta'_A, and f c_z zeta_max/c_x for the shift; then
/// F_z = (2/3) zeta^(3/2), zeta'' = -(15/8) F_z and e'' = -(15/8) chi F_t.
pub(crate) fn course(chi: f64, psi: f64) -> Stepped {
    let mut bed = SpringBed::new(SPRINGS, 1.001, 1.0, [1.0; 2], 1.0);
    let dt = carom_impact::normal::DURATION / STEPS as f64;
    let (mut zeta, mut e) = (0.0, 0.0);
    let (mut w, mut u) = (1.0, psi);
    let mut found = Stepped::default();
    let (mut time, mut most) = (0.0, 0.0);
    // Leapfrog.
    loop {
        zeta += 0.5 * dt * w;
        e += 0.5 * dt * u;
        let load = bed.advance(zeta, e);
        if load.tangential != 0.0 {
            found.last_force = load.tangential;
        }
        w -= 1.875 * dt * load.normal;
        u -= 1.875 * chi * dt * load.tangential;
        zeta += 0.5 * dt * w;
        e += 0.5 * dt * u;
        time += dt;
        if load.slides && found.slips_at == 0.0 {
            found.slips_at = time;
        }
        if e > most {
            (most, found.peak) = (e, time);
        }
        found.least = e.min(found.least);
        if zeta <= 0.0 {
            return Stepped { restitution: -u / psi, last: e, ..found };
        }
    }
}

/// R_x of a tangential spring that slips as a whole: stiffness c_x sqrt(zeta) times its whole stretch, cut at f F_z.
/// The units are those of [`course`].
pub(crate) fn of_whole_spring(chi: f64, psi: f64) -> f64 {
    let dt = carom_impact::normal::DURATION / STEPS as f64;
    let (mut zeta, mut stretch, mut w, mut u) = (0.0, 0.0, 1.0, psi);
    loop {
        zeta += 0.5 * dt * w;
        stretch += 0.5 * dt * u;
        let depth = f64::max(zeta, 0.0);
        let force = 2.0 / 3.0 * depth * depth.sqrt();
        let limit = force / depth.sqrt().max(f64::MIN_POSITIVE);
        stretch = stretch.clamp(-limit, limit);
        w -= 1.875 * dt * force;
        u -= 1.875 * chi * dt * depth.sqrt() * stretch;
        zeta += 0.5 * dt * w;
        stretch += 0.5 * dt * u;
        if zeta <= 0.0 {
            return -u / psi;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::restitution;

    #[test]
    fn complete_sliding_follows_coulomb() {
        // R_x = -1 + 2 chi/psi.
        for (chi, psi) in [(3.5, 7.0), (2.5, 9.0), (0.5, 2.0)] {
            approx::assert_abs_diff_eq!(
                restitution(chi, psi),
                2.0 * chi / psi - 1.0,
                epsilon = 1e-6
            );
        }
    }
}
