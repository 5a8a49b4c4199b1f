//! Force and torque of a contact that slides and spins as a whole (14.2)-(14.4).

use std::f64::consts::PI;
use std::sync::LazyLock;

use carom_special::RangeError;
use carom_special::quadrature::GaussLegendre;

use carom_laws::ellipse::ContactEllipse;

/// Points of the periodic rule for a pole inside a circle, and twice the number of Gauss nodes for
/// one outside; slender ellipses need more.
const BASE_POINTS: f64 = 32.0;
const POINTS_PER_RATIO: f64 = 14.0;
/// Available Gauss orders, for poles outside ellipses of increasing slenderness.
const ORDERS: [usize; 5] = [48, 96, 192, 384, 768];

static RULES: LazyLock<Vec<GaussLegendre>> =
    LazyLock::new(|| ORDERS.iter().filter_map(|&order| GaussLegendre::new(order).ok()).collect());

/// The friction of a contact that slides and spins, in units of f F_z.
///
/// Signs are those of [`carom_laws::law::Shift`]: relative velocity `u = xi + y Omega, v = eta - x
/// Omega` of body 2, load on body 1, `M_z = int (y t_x - x t_y) dS`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidSlip {
    /// F_x/(f F_z).
    pub force_x: f64,
    /// F_y/(f F_z).
    pub force_y: f64,
    /// M_z/(f F_z sqrt(a b)).
    pub torque: f64,
}

/// The load of complete sliding with the given velocity (xi, eta) and spin Omega.
///
/// The traction has the magnitude `f p_z` everywhere and the direction of the local relative
/// velocity. Without motion the load is zero.
///
/// ```
/// use carom_laws::ellipse::ContactEllipse;
/// use carom_classic::rigid_slip::rigid_slip;
/// let circle = ContactEllipse::circle(1.0)?;
/// let slide = rigid_slip(&circle, [3.0, 0.0], 0.0)?;
/// assert_eq!((slide.force_x, slide.torque), (1.0, 0.0));
/// let spin = rigid_slip(&circle, [0.0, 0.0], 2.0)?;
/// assert!((spin.torque - 3.0 * std::f64::consts::PI / 16.0).abs() < 1e-14);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a velocity or spin that is not finite.
pub fn rigid_slip(
    ellipse: &ContactEllipse,
    velocity: [f64; 2],
    spin: f64,
) -> Result<RigidSlip, RangeError> {
    RangeError::finite("velocity_x", velocity[0])?;
    RangeError::finite("velocity_y", velocity[1])?;
    RangeError::finite("spin", spin)?;
    let speed = libm::hypot(velocity[0], velocity[1]);
    let size = ellipse.semi_axis_a().max(ellipse.semi_axis_b());
    if spin == 0.0 || speed > 1e150 * (spin * size).abs() {
        let along = |v: f64| if speed == 0.0 { 0.0 } else { v / speed };
        let (force_x, force_y) = (along(velocity[0]), along(velocity[1]));
        return Ok(RigidSlip { force_x, force_y, torque: 0.0 });
    }
    // (14.2): zero velocity at x = eta/Omega, y = -xi/Omega.
    let about = about_pole(ellipse, velocity[1] / spin, -velocity[0] / spin);
    let sign = 1.0_f64.copysign(spin);
    Ok(RigidSlip {
        force_x: sign * about.force_x,
        force_y: sign * about.force_y,
        torque: sign * about.torque,
    })
}

/// The load for a positive spin about the pole (x, y) (14.3).
///
/// # Errors
/// [`RangeError`] for a pole that is not finite.
pub fn spin_about(ellipse: &ContactEllipse, x: f64, y: f64) -> Result<RigidSlip, RangeError> {
    RangeError::finite("pole_x", x)?;
    RangeError::finite("pole_y", y)?;
    Ok(about_pole(ellipse, x, y))
}

/// The pole of (14.4) at the distance `v sqrt(a b)` and angle alpha:
/// `x = -v sqrt(a b) sin(alpha)`, `y = v sqrt(a b) cos(alpha)`.
#[must_use]
pub fn pole_of(ellipse: &ContactEllipse, distance: f64, alpha: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(alpha);
    let size = (ellipse.semi_axis_a() * ellipse.semi_axis_b()).sqrt() * distance;
    [-size * s, size * c]
}

/// Polar integration about the pole in the disc of which the ellipse is an affine image: the
/// integrals along each chord are in closed form.
fn about_pole(ellipse: &ContactEllipse, x: f64, y: f64) -> RigidSlip {
    let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
    let (u, v) = (x / a, y / b);
    let square = u * u + v * v;
    let slender = (a / b).max(b / a);
    let chords = Chords { a, b };
    let mut sum = [0.0; 3];
    let mut add = |weight: f64, part: [f64; 3]| {
        for (sum, part) in sum.iter_mut().zip(part) {
            *sum += weight * part;
        }
    };
    if square < 1.0 {
        let n = (2.0 * (BASE_POINTS + POINTS_PER_RATIO * slender)).ceil();
        for i in 0..n as usize {
            let phi = PI * (i as f64 + 0.5) / n;
            let (s, c) = libm::sincos(phi);
            let (middle, distance) = (-(u * c + v * s), u * s - v * c);
            let half_square = (1.0 - distance * distance).max(0.0);
            add(PI / n, chords.part([c, s], middle, distance, half_square));
        }
    } else {
        let rho = square.sqrt();
        let (cu, su) = (-u / rho, -v / rho); // towards the centre
        let half = libm::asin((1.0 / rho).min(1.0));
        let order = BASE_POINTS + POINTS_PER_RATIO * slender;
        let rule = RULES.iter().find(|rule| rule.nodes().len() as f64 >= order);
        for node in rule.or(RULES.last()).into_iter().flat_map(|rule| rule.on(-half, half)) {
            let (sd, cd) = libm::sincos(node.position);
            let direction = [cu * cd - su * sd, su * cd + cu * sd];
            let distance = -rho * sd;
            let half_square = ((1.0 - distance) * (1.0 + distance)).max(0.0);
            add(node.weight, chords.part(direction, rho * cd, distance, half_square));
        }
    }
    let scale = 1.5 / PI;
    // (14.3) has the sense of -Omega in the forces.
    RigidSlip {
        force_x: -scale * sum[0],
        force_y: -scale * sum[1],
        torque: scale * sum[2] / (a * b).sqrt(),
    }
}

struct Chords {
    a: f64,
    b: f64,
}

impl Chords {
    /// The contribution of the chord with direction (cos, sin) to f_x, f_y and m_z. `middle` is the
    /// distance of its mid point from the pole, `distance` its distance from the centre.
    fn part(&self, direction: [f64; 2], middle: f64, distance: f64, half_square: f64) -> [f64; 3] {
        let Self { a, b } = *self;
        let [c, s] = direction;
        let length = libm::hypot(a * c, b * s);
        let first = PI / 2.0 * half_square * middle;
        let second = PI / 8.0 * half_square * half_square;
        [
            -b * s / length * first,
            a * c / length * first,
            (a - b) * (a + b) * s * c * distance * first / length + length * second,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn far_poles_are_pure_sliding_and_senses_agree() {
        let ellipse = ContactEllipse::new(1.0, 3.0).unwrap();
        let slide = rigid_slip(&ellipse, [0.3, -0.4], 1e-9).unwrap();
        assert_relative_eq!(slide.force_x, 0.6, max_relative = 1e-8);
        assert_relative_eq!(slide.force_y, -0.8, max_relative = 1e-8);
        assert!(slide.torque.abs() < 1e-8);
        let spin = rigid_slip(&ellipse, [0.0, 0.0], 1.0).unwrap();
        let back = rigid_slip(&ellipse, [0.0, 0.0], -1.0).unwrap();
        assert_eq!(spin.torque, -back.torque);
        let none = rigid_slip(&ellipse, [0.0, 0.0], 0.0).unwrap();
        assert_eq!(none, RigidSlip { force_x: 0.0, force_y: 0.0, torque: 0.0 });
    }

    #[test]
    fn load_is_the_integral_of_the_traction() {
        let ellipse = ContactEllipse::new(1.0, 2.0).unwrap();
        let (velocity, spin) = ([0.7, -0.5], 0.9);
        let n = 1200;
        let mut sum = [0.0; 3];
        for i in 0..n {
            for j in 0..n {
                let at = |i: i32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
                let (u, v) = (at(i), at(j));
                let rest = 1.0 - u * u - v * v;
                if rest <= 0.0 {
                    continue;
                }
                let (x, y) = (u, 2.0 * v);
                let slip = [velocity[0] + spin * y, velocity[1] - spin * x];
                let size = rest.sqrt() / libm::hypot(slip[0], slip[1]);
                sum[0] += size * slip[0];
                sum[1] += size * slip[1];
                sum[2] += size * (y * slip[0] - x * slip[1]);
            }
        }
        let scale = 1.5 / PI * 4.0 / f64::from(n * n);
        let load = rigid_slip(&ellipse, velocity, spin).unwrap();
        assert_relative_eq!(load.force_x, scale * sum[0], max_relative = 1e-4);
        assert_relative_eq!(load.force_y, scale * sum[1], max_relative = 1e-4);
        assert_relative_eq!(load.torque, scale * sum[2] / 2.0_f64.sqrt(), max_relative = 1e-4);
    }

    #[test]
    fn bad_arguments_are_named() {
        let circle = ContactEllipse::circle(1.0).unwrap();
        assert_eq!(rigid_slip(&circle, [0.0, f64::NAN], 1.0).unwrap_err().field, "velocity_y");
        assert_eq!(spin_about(&circle, f64::INFINITY, 0.0).unwrap_err().field, "pole_x");
    }
}
