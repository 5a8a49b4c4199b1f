//! Models of an oblique impact of a sphere, each as -(slip after)/(slip before) over kappa and lambda =
//! v_t/(f v_n).

use carom_impact::normal::DURATION;
use carom_impact::restitution::of_spheres;

use crate::{Failure, Series};

/// The exact elastic theory. A normal restitution below 1 reduces the friction impulse to (1 + e)/2 of the
/// elastic one; sticking impacts stay elastic.
pub(super) fn elastic(kappa: f64, lambda: f64, normal: f64) -> Result<f64, Failure> {
    Ok(of_spheres(kappa, 2.0 * lambda / (1.0 + normal))?)
}

/// Walton's two constants: complete sliding, or beta_0 where that would be less.
pub(super) fn constant(beta: f64, lambda: f64, normal: f64) -> f64 {
    (3.5 * (1.0 + normal) / lambda - 1.0).min(beta)
}

/// Law of the tangential spring of a particle code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Spring {
    /// Hertz's normal force; a spring as stiff as the contact is, cut at Coulomb's limit.
    Hertzian,
    /// Springs of constant stiffness, the tangential one 2/7 of the normal one, cut at Coulomb's
    /// limit.
    Linear,
}

/// A particle code's impact, elastic along the normal: no partial slip, stepped in time.
pub(super) fn spring(law: Spring, kappa: f64, lambda: f64) -> f64 {
    // In units of the normal motion; tangential motion and force are over f.
    let steps = 4000;
    let (half, stiffness) = match law {
        Spring::Hertzian => (0.5 * DURATION, 1.875 / kappa),
        Spring::Linear => (0.5 * std::f64::consts::PI, 2.0 / 7.0),
    };
    let h = 2.0 * half / f64::from(steps);
    let normal = |z: f64| match law {
        Spring::Hertzian => 1.25 * z * z.sqrt(),
        Spring::Linear => z,
    };
    let factor = |z: f64| if law == Spring::Hertzian { stiffness * z.sqrt() } else { stiffness };
    let (mut z, mut w) = (0.0_f64, 1.0);
    let (mut slip, mut stretch) = (lambda, 0.0_f64);
    for _ in 0..steps {
        // Leapfrog: places in the middle of a step.
        z = (z + 0.5 * h * w).max(0.0);
        stretch += 0.5 * h * slip;
        let (load, k) = (normal(z), factor(z));
        if k > 0.0 {
            stretch = stretch.clamp(-load / k, load / k);
        }
        w -= h * load;
        slip -= 3.5 * h * k * stretch;
        z = (z + 0.5 * h * w).max(0.0);
        stretch += 0.5 * h * slip;
    }
    -slip / lambda
}

/// A bar from low to high at each point: x, low, high.
pub(super) fn bars(points: impl IntoIterator<Item = [f64; 3]>) -> Vec<Series> {
    let bar = |[x, low, high]: [f64; 3]| Series::line("", [(x, low), (x, high)]).coloured(6);
    points.into_iter().map(bar).collect()
}

/// Root of the mean square.
pub(super) fn rms(deviations: &[f64]) -> f64 {
    let sum: f64 = deviations.iter().map(|d| d * d).sum();
    (sum / deviations.len() as f64).sqrt()
}
