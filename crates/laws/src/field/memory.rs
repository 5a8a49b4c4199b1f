//! Displacements and stresses due to the tractions of a memory.

use carom_halfspace::{Material, MaterialPair, Point, Stress, Traction};
use carom_special::RangeError;

use super::interior::EllipsoidalLoad;
use super::{circular_shear, ellipsoidal_shear};
use crate::ellipse::ContactEllipse;
use crate::memory::{ScalarMemory, VectorMemory};

/// The surface displacement of a circular contact due to the tractions of a memory in one
/// direction, along x; for a pair, the relative displacement. The scale of the traction is `f
/// sigma_z0` of the present contact, and its radius is `radius`.
#[must_use]
pub fn memory_displacement(
    memory: &ScalarMemory,
    radius: f64,
    friction_peak: f64,
    materials: &MaterialPair,
    point: [f64; 2],
) -> [f64; 2] {
    let field = |component: usize| {
        memory.superpose(|z| {
            part(z / memory.zeta(), radius, friction_peak, materials, point)[component]
        })
    };
    if memory.is_touching() { [field(0), field(1)] } else { [0.0; 2] }
}

/// The displacement due to the traction of full sliding on the sub-contact of relative depth `q`.
fn part(
    q: f64,
    radius: f64,
    friction_peak: f64,
    materials: &MaterialPair,
    [x, y]: [f64; 2],
) -> [f64; 2] {
    if q <= 0.0 {
        return [0.0; 2];
    }
    let root = q.sqrt();
    circular_shear(radius * root, friction_peak * root, materials, x, y)
}

/// As [`memory_displacement`], in two directions and for an ellipse (either semi-axis may be the larger): the sum of
/// [`ellipsoidal_shear`] over the sub-contacts of the memory.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::ellipse::ContactEllipse;
/// use carom_laws::field::elliptic_memory_displacement;
/// use carom_laws::memory::VectorMemory;
/// let steel = Material::from_young(208e3, 0.3)?;
/// let pair = MaterialPair::new(steel, steel)?;
/// let ellipse = ContactEllipse::new(1.0, 2.0)?;
/// let mut memory = VectorMemory::new();
/// memory.advance(1.0, [0.0, 0.0])?;
/// memory.advance(1.0, [0.4, 0.1])?;
/// let at = |x, y| elliptic_memory_displacement(&memory, &ellipse, 100.0, &pair, [x, y]);
/// let (centre, stuck, far) = (at(0.0, 0.0)?, at(0.3, 0.2)?, at(9.0, 0.0)?);
/// assert!((centre[0] - stuck[0]).abs() < 1e-15); // the stick area moves as a whole
/// assert!(far[0] < 0.2 * centre[0]);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a point that is not finite.
pub fn elliptic_memory_displacement(
    memory: &VectorMemory,
    ellipse: &ContactEllipse,
    friction_peak: f64,
    materials: &MaterialPair,
    [x, y]: [f64; 2],
) -> Result<[f64; 2], RangeError> {
    RangeError::finite("x", x)?;
    RangeError::finite("y", y)?;
    if !memory.is_touching() {
        return Ok([0.0; 2]);
    }
    // A sub-contact whose axes underflow causes no displacement.
    let of = |ellipse: &ContactEllipse, z: f64, [x, y]: [f64; 2]| {
        let root = (z / memory.zeta()).sqrt();
        ellipse.scaled(root).map_or([0.0; 2], |part| {
            ellipsoidal_shear(&part, friction_peak * root, materials, x, y).unwrap_or([0.0; 2])
        })
    };
    let exchanged = ellipse.exchanged();
    let along = |i: usize| memory.superpose(|z| of(ellipse, z, [x, y])[i])[0];
    let across = |i: usize| memory.superpose(|z| of(&exchanged, z, [y, x])[i])[1];
    Ok([along(0) + across(1), along(1) + across(0)])
}

/// The stress in a body due to the tractions of a memory and Hertz's pressure. `pressure` is the
/// greatest pressure, `friction_peak` the traction limit there, f times the pressure. Zero for
/// separated bodies.
///
/// ```
/// use carom_halfspace::{Material, Point};
/// use carom_laws::ellipse::ContactEllipse;
/// use carom_laws::field::memory_stress;
/// use carom_laws::memory::VectorMemory;
/// let steel = Material::from_young(208e3, 0.3)?;
/// let mut memory = VectorMemory::new();
/// memory.advance(1.0, [0.0, 0.0])?;
/// memory.advance(1.0, [2.0, 0.0])?; // sliding
/// let centre = Point::on_surface(0.0, 0.0);
/// let ellipse = ContactEllipse::new(1.0, 2.0)?;
/// let stress = memory_stress(&memory, ellipse, steel, 800.0, 240.0, centre)?;
/// assert!((stress.zx + 240.0).abs() < 1e-12 && (stress.zz + 800.0).abs() < 1e-12);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a rigid body, a point outside the half-space, or an argument that is not
/// finite.
pub fn memory_stress(
    memory: &VectorMemory,
    ellipse: ContactEllipse,
    body: Material,
    pressure: f64,
    friction_peak: f64,
    at: Point,
) -> Result<Stress, RangeError> {
    RangeError::finite("friction_peak", friction_peak)?;
    let peak = Traction { normal: pressure, ..Traction::default() };
    let mut sum = EllipsoidalLoad::new(ellipse, body)?.stress(peak, at)?;
    if !memory.is_touching() {
        return Ok(Stress::default());
    }
    for direction in 0..2 {
        // A sub-contact whose axes underflow causes no stress.
        let of = |z: f64| {
            let root = (z / memory.zeta()).sqrt();
            let mut peak = [0.0; 2];
            peak[direction] = friction_peak * root;
            let peak = Traction { x: peak[0], y: peak[1], normal: 0.0 };
            let part = ellipse.scaled(root).and_then(|part| EllipsoidalLoad::new(part, body));
            part.and_then(|part| part.stress(peak, at)).unwrap_or_default()
        };
        let part =
            |component: fn(&Stress) -> f64| memory.superpose(|z| component(&of(z)))[direction];
        sum = sum
            + Stress {
                xx: part(|s| s.xx),
                yy: part(|s| s.yy),
                zz: part(|s| s.zz),
                xy: part(|s| s.xy),
                yz: part(|s| s.yz),
                zx: part(|s| s.zx),
            };
    }
    Ok(sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    fn pair(nu: f64) -> MaterialPair {
        MaterialPair::new(Material::from_shear(1.0, nu).unwrap(), Material::RIGID).unwrap()
    }

    #[test]
    fn the_stick_area_moves_rigidly_by_the_shift() {
        // nu = 0: Cattaneo's theory is exact. F_z, sigma_z0 and X of a unit circle, G = 1.
        let materials = pair(0.0);
        let mut memory = ScalarMemory::new();
        memory.advance(1.0, 0.0).unwrap();
        memory.advance(1.0, 0.7).unwrap();
        memory.advance(1.0, 0.2).unwrap();
        // u = pi sigma a/(4 G) times X in the stick area of slip depth X.
        let stick = memory.stick_radius();
        for rho in [0.0, 0.5 * stick, 0.99 * stick] {
            let kept = memory_displacement(&memory, 1.0, 1.0, &materials, [rho, 0.0]);
            let mut before = ScalarMemory::new();
            before.advance(1.0, 0.0).unwrap();
            before.advance(1.0, 0.7).unwrap();
            let was = memory_displacement(&before, 1.0, 1.0, &materials, [rho, 0.0]);
            assert_relative_eq!(kept[0] - was[0], -0.5 * PI / 4.0, max_relative = 1e-13);
        }
        let mut plane = VectorMemory::new();
        plane.advance(1.0, [0.0, 0.0]).unwrap();
        plane.advance(1.0, [0.0, 0.7]).unwrap();
        plane.advance(1.0, [0.0, 0.2]).unwrap();
        let line = memory_displacement(&memory, 1.0, 0.3, &pair(0.3), [0.4, 1.2]);
        let circle = ContactEllipse::circle(1.0).unwrap();
        let turned = elliptic_memory_displacement(&plane, &circle, 0.3, &pair(0.3), [-1.2, 0.4]);
        let turned = turned.unwrap();
        assert_relative_eq!(turned[1], line[0], max_relative = 1e-13);
        assert_relative_eq!(turned[0], -line[1], max_relative = 1e-13);
    }

    fn turned() -> VectorMemory {
        let mut memory = VectorMemory::new();
        for (zeta, shift) in
            [(1.0, [0.0, 0.0]), (1.0, [0.5, 0.2]), (1.2, [0.3, 0.4]), (1.1, [0.2, 0.1])]
        {
            memory.advance(zeta, shift).unwrap();
        }
        memory
    }

    #[test]
    fn on_an_ellipse_the_stick_area_moves_rigidly_too() {
        let ellipse = ContactEllipse::new(1.0, 2.5).unwrap();
        let memory = turned();
        // A further small shift: what it adds is uniform where all sticks.
        let mut next = memory.clone();
        next.advance(1.1, [0.15, 0.12]).unwrap();
        let added = |u: f64, v: f64| {
            let at = [u, 2.5 * v];
            let of = |m: &VectorMemory| {
                elliptic_memory_displacement(m, &ellipse, 0.7, &pair(0.3), at).unwrap()
            };
            let (after, before) = (of(&next), of(&memory));
            [after[0] - before[0], after[1] - before[1]]
        };
        let (centre, stick) = (added(0.0, 0.0), next.stick_radius());
        assert!(stick > 0.5 && centre[0] < 0.0 && centre[1] > 0.0);
        for (u, v) in [(0.9, 0.0), (0.0, -0.9), (0.5, 0.6)] {
            let got = added(u * stick, v * stick);
            assert!((got[0] - centre[0]).abs() < 1e-14 && (got[1] - centre[1]).abs() < 1e-14);
        }
        assert!((added(1.0, 0.0)[0] - centre[0]).abs() > 1e-3);
    }

    #[test]
    fn stresses_of_a_memory_carry_its_traction() {
        let ellipse = ContactEllipse::new(1.0, 0.4).unwrap();
        let (memory, body) = (turned(), Material::from_shear(1.0, 0.3).unwrap());
        for (u, v) in [(0.0_f64, 0.0_f64), (0.5, 0.4), (0.2, -0.9), (1.1, 0.0)] {
            let at = Point::on_surface(u, 0.4 * v);
            let got = memory_stress(&memory, ellipse, body, 2.0, 0.6, at).unwrap();
            let square = u * u + v * v;
            let traction = memory.superpose(|z| (z / memory.zeta() - square).max(0.0).sqrt());
            let pressure = (1.0 - square).max(0.0).sqrt();
            assert!((got.zx + 0.6 * traction[0]).abs() < 1e-14);
            assert!((got.yz + 0.6 * traction[1]).abs() < 1e-14);
            assert!((got.zz + 2.0 * pressure).abs() < 1e-14);
        }
        let apart = memory_stress(&VectorMemory::new(), ellipse, body, 0.0, 0.6, Point::default());
        assert_eq!(apart.unwrap(), Stress::default());
    }
}
