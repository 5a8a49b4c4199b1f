//! The normal motion of an elastic impact (section 9.1), exact and in closed form.
//!
//! Units: compression by its maximum zeta_max, time by zeta_max/zeta_dot_A, velocity by zeta_dot_A.
//! Then `zeta'' = -(5/4) zeta^(3/2)` and `zeta' = w = ±sqrt(1 - zeta^(5/2))`. The velocity `w`
//! decreases from 1 to -1 and is the independent variable of all uncoupled impacts.

use carom_special::RangeError;

/// Duration of an impact in units of zeta_max / zeta_dot_A: T_N of (9.8),
/// (4 sqrt(pi)/5) Gamma(2/5) / Gamma(9/10).
pub const DURATION: f64 = 2.943_275_184_324_704_7;

/// Compression zeta/zeta_max at the velocity `w` in [-1, 1]: (1 - w^2)^(2/5), (9.2).
///
/// ```
/// assert_eq!(carom_impact::normal::compression(0.0), 1.0);
/// assert_eq!(carom_impact::normal::compression(-1.0), 0.0);
/// ```
#[must_use]
pub fn compression(w: f64) -> f64 {
    let radius = radius(w);
    radius * radius
}

/// Contact radius over its maximum at the velocity `w`: the root of the compression.
pub(crate) fn radius(w: f64) -> f64 {
    let s = ((1.0 - w) * (1.0 + w)).max(0.0);
    if s > 0.5 { fifth_root_near_one(s) } else { fifth_root(s) }
}

// x^(1/5) for x in [1/2, 1]: a polynomial within 2e-6, then one step of Halley's method.
fn fifth_root_near_one(x: f64) -> f64 {
    const C: [f64; 6] = [
        0.9440865773,
        0.06293942682,
        -0.00837515125,
        0.001673729924,
        -0.0004351296935,
        0.000111278727,
    ];
    let t = 4.0 * x - 3.0;
    let t2 = t * t;
    let y = (C[0] + C[1] * t) + t2 * ((C[2] + C[3] * t) + t2 * (C[4] + C[5] * t));
    let squared = y * y;
    let power = squared * squared * y;
    y + y * ((x - power) / (3.0 * power + 2.0 * x))
}

// x^(1/5) for x in [0, 1]: an estimate from the exponent bits, then Halley's method, which triples
// the digits: 6 %, 3e-4, 6e-11, exact. Cheaper than `pow`, and the same on every machine.
pub(crate) fn fifth_root(x: f64) -> f64 {
    if x < f64::MIN_POSITIVE {
        return if x == 0.0 { 0.0 } else { libm::pow(x, 0.2) };
    }
    const BIAS: u64 = 0x3ff0_0000_0000_0000 / 5 * 4 - 0x0000_6000_0000_0000;
    let mut y = f64::from_bits(x.to_bits() / 5 + BIAS);
    for _ in 0..3 {
        let squared = y * y;
        let power = squared * squared * y;
        y *= (2.0 * power + 3.0 * x) / (3.0 * power + 2.0 * x);
    }
    y
}

/// Time since first contact at the velocity `w` in [-1, 1], in units of zeta_max/zeta_dot_A.
///
/// (9.8) after a quadratic transformation: t = zeta F(4/5, 1; 7/5; (1 - w)/2) for w >= 0, and
/// its mirror image in restitution, (9.10).
///
/// ```
/// use carom_impact::normal::{DURATION, time};
/// assert!((time(0.0) - DURATION / 2.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn time(w: f64) -> f64 {
    if w < 0.0 {
        return DURATION - time(-w);
    }
    compression_time(compression(w), 0.5 * (1.0 - w))
}

/// Time to reach compression `zeta` with the velocity still inward; `z = (1 - w)/2`.
fn compression_time(zeta: f64, z: f64) -> f64 {
    // F(4/5, 1; 7/5; z) for z in [0, 1/2]: ratio of terms tends to z.
    let (mut term, mut sum, mut k) = (1.0, 1.0, 0.0);
    while term > 1e-17 * sum {
        term *= (0.8 + k) / (1.4 + k) * z;
        sum += term;
        k += 1.0;
    }
    zeta * sum
}

/// Velocity `w` and compression at the time `t`, any real number; outside [0, T_N] the bodies are
/// separated.
///
/// Returned as [`NormalState`]; the inverse of [`time`], accurate to a few roundings.
///
/// ```
/// use carom_impact::normal::{DURATION, state_at};
/// let peak = state_at(DURATION / 2.0);
/// assert!((peak.compression - 1.0).abs() < 1e-15 && peak.velocity.abs() < 1e-15);
/// ```
#[must_use]
pub fn state_at(t: f64) -> NormalState {
    if t <= 0.0 {
        return NormalState { velocity: 1.0, compression: 0.0 };
    }
    if t >= DURATION {
        return NormalState { velocity: -1.0, compression: 0.0 };
    }
    let mirrored = t > 0.5 * DURATION;
    let early = if mirrored { DURATION - t } else { t };
    let half = inward_state(early);
    NormalState { velocity: if mirrored { -half.velocity } else { half.velocity }, ..half }
}

// Newton's method on time(zeta) soon after first contact, on time(w) near maximum compression.
fn inward_state(t: f64) -> NormalState {
    if t < 0.9 {
        let mut zeta = t.min(0.8);
        for _ in 0..12 {
            let s = zeta * zeta * zeta.sqrt();
            let w = (1.0 - s).sqrt();
            let step = (compression_time(zeta, 0.5 * s / (1.0 + w)) - t) * w; // d t / d zeta = 1/w
            zeta -= step;
            if step.abs() <= 1e-16 * zeta {
                break;
            }
        }
        let s = zeta * zeta * zeta.sqrt();
        return NormalState { velocity: (1.0 - s).sqrt(), compression: zeta };
    }
    let mut w = 0.5 * DURATION - t;
    for _ in 0..12 {
        let zeta = compression(w);
        let step = (time(w) - t) * 1.25 * zeta * zeta.sqrt(); // d w / d t = -(5/4) zeta^(3/2)
        w += step;
        if step.abs() <= 1e-17 {
            break;
        }
    }
    NormalState { velocity: w, compression: compression(w) }
}

/// Normalised velocity and compression at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalState {
    /// zeta_dot / zeta_dot_A, from 1 to -1.
    pub velocity: f64,
    /// zeta / zeta_max, from 0 to 1 and back.
    pub compression: f64,
}

/// A normal impact with dimensions: maximum compression, duration, maximum force.
///
/// ```
/// use carom_impact::normal::NormalImpact;
/// // D_zz = 1/m1 + 1/m2 and c_z of (5.25), approach velocity zeta_dot_A.
/// let impact = NormalImpact::new(0.5, 3.0e9, 2.0)?;
/// assert!(impact.duration() > 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalImpact {
    mobility: f64,
    stiffness: f64,
    velocity: f64,
    maximal_approach: f64,
}

impl NormalImpact {
    /// From the normal mobility D_zz (1/mass), the stiffness c_z of (5.25) and zeta_dot_A > 0.
    ///
    /// # Errors
    /// [`RangeError`] unless all three are finite and positive.
    pub fn new(mobility: f64, stiffness: f64, velocity: f64) -> Result<Self, RangeError> {
        RangeError::positive("normal mobility", mobility)?;
        RangeError::positive("normal stiffness", stiffness)?;
        RangeError::positive("normal velocity", velocity)?;
        // (9.50): zeta_max^(5/2) = 15 v^2 / (8 D_zz c_z)
        let maximal_approach =
            libm::pow(15.0 / (8.0 * mobility * stiffness), 0.4) * libm::pow(velocity, 0.8);
        RangeError::positive("maximal approach", maximal_approach)?;
        Ok(Self { mobility, stiffness, velocity, maximal_approach })
    }

    /// The maximum compression zeta_max (9.3), (9.50).
    #[must_use]
    pub fn maximal_approach(&self) -> f64 {
        self.maximal_approach
    }

    /// The unit of time zeta_max / zeta_dot_A of (9.4).
    #[must_use]
    pub fn time_unit(&self) -> f64 {
        self.maximal_approach / self.velocity
    }

    /// The duration T = T_N zeta_max / zeta_dot_A, (9.51) to (9.55) for steel spheres.
    #[must_use]
    pub fn duration(&self) -> f64 {
        DURATION * self.time_unit()
    }

    /// The maximum normal force (2/3) c_z zeta_max^(3/2).
    #[must_use]
    pub fn maximal_force(&self) -> f64 {
        let zeta = self.maximal_approach;
        2.0 / 3.0 * self.stiffness * zeta * zeta.sqrt()
    }

    /// The kinetic energy of approach, `zeta_dot_A^2/(2 D_zz)`.
    #[must_use]
    pub fn energy(&self) -> f64 {
        0.5 * self.velocity * self.velocity / self.mobility
    }

    /// The impulse of the normal force, `2 zeta_dot_A/D_zz`.
    #[must_use]
    pub fn impulse(&self) -> f64 {
        2.0 * self.velocity / self.mobility
    }

    /// The share of the kinetic energy of approach that this pulse radiates into a half-space of this density
    /// and [`radiation_coefficient`](crate::closed_form::radiation_coefficient), kg/m^3 and (m^2/N)^(3/2). For a
    /// solid sphere on its own material it is (3.2).
    ///
    /// ```
    /// use std::f64::consts::PI;
    /// use carom_halfspace::{Material, MaterialPair};
    /// use carom_impact::closed_form::{radiation_coefficient, wave_loss};
    /// use carom_impact::normal::NormalImpact;
    /// // A ball of glass, radius 1 m, on glass at 1 m/s: c_z = E*.
    /// let (young, poisson, density) = (70e9_f64, 0.22, 2500.0);
    /// let stiffness = young / (1.0 - poisson * poisson);
    /// let impact = NormalImpact::new(3.0 / (4.0 * PI * density), stiffness, 1.0)?;
    /// let glass = radiation_coefficient(Material::from_young(young, poisson)?)?;
    /// let share = wave_loss(poisson, 1.0, (young / density).sqrt())?;
    /// assert!((impact.wave_share(glass, density) / share - 1.0).abs() < 1e-12);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn wave_share(&self, radiation: f64, density: f64) -> f64 {
        let force = self.maximal_force();
        radiation * density.sqrt() * force * force / (self.time_unit() * self.energy())
    }

    /// The normal mobility D_zz.
    #[must_use]
    pub fn mobility(&self) -> f64 {
        self.mobility
    }

    /// The approach velocity zeta_dot_A.
    #[must_use]
    pub fn velocity(&self) -> f64 {
        self.velocity
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_special::gamma::gamma;

    #[test]
    fn duration_is_the_gamma_quotient() {
        // (9.8): T/2 = 2 sqrt(pi) Gamma(2/5) / (5 Gamma(9/10))
        let half = 2.0 * std::f64::consts::PI.sqrt() * gamma(0.4) / (5.0 * gamma(0.9));
        assert!((2.0 * half - DURATION).abs() < 2e-15);
    }

    #[test]
    fn fifth_root_is_exact_to_two_roundings() {
        for i in 0..20_000 {
            let x = libm::exp(-f64::from(i) * 0.03);
            let root = fifth_root(x);
            assert!((root.powi(5) - x).abs() <= 16.0 * f64::EPSILON * x, "{x}");
        }
        assert_eq!((fifth_root(0.0), fifth_root(1.0)), (0.0, 1.0));
        for i in 0..=5000 {
            let x = 0.5 + 1e-4 * f64::from(i);
            let root = fifth_root_near_one(x);
            assert!((root.powi(5) - x).abs() <= 16.0 * f64::EPSILON * x, "{x}");
        }
        assert_eq!(fifth_root_near_one(1.0), 1.0);
    }

    #[test]
    fn state_inverts_time() {
        for i in 0..=2000 {
            let t = DURATION * i as f64 / 2000.0;
            let state = state_at(t);
            let s = state.compression.powf(2.5);
            // From the compression: w alone does not resolve times near first contact.
            let z = 0.5 * s / (1.0 + state.velocity.abs());
            let early = compression_time(state.compression, z);
            let time = if state.velocity < 0.0 { DURATION - early } else { early };
            assert!((time - t).abs() < 4e-15, "{t}");
            assert!((s + state.velocity * state.velocity - 1.0).abs() < 2e-15);
        }
    }

    #[test]
    fn early_times_keep_relative_accuracy() {
        // t = zeta (1 + (2/7) (1/2) zeta^2.5 + ...) for small zeta.
        for t in [1e-300, 1e-100, 1e-12] {
            assert!((state_at(t).compression - t).abs() <= 1e-15 * t);
        }
    }

    #[test]
    fn energy_balance_fixes_the_maximum() {
        let impact = NormalImpact::new(3.7, 2.0e5, 1.3).unwrap();
        let kinetic = 0.5 * 1.3 * 1.3 / 3.7;
        let elastic = 4.0 / 15.0 * 2.0e5 * impact.maximal_approach().powf(2.5);
        assert!((kinetic - elastic).abs() < 1e-14 * kinetic);
    }
}
