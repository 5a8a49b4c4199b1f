//! Inertias and volumes of all shapes against quadrature.

use approx::assert_relative_eq;
use carom_geometry::{Inertia, Surface};
use carom_special::quadrature::GaussLegendre;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

const MASS: f64 = 1.7;

fn rule() -> GaussLegendre {
    GaussLegendre::new(48).unwrap()
}

/// A measure and the integrals of a^2, b^2, c^2 over it.
#[derive(Debug, Clone, Copy, Default)]
struct Squares {
    measure: f64,
    squares: Vector3<f64>,
}

impl Squares {
    fn add(&mut self, weight: f64, mean: Vector3<f64>) {
        self.measure += weight;
        self.squares += weight * mean;
    }

    fn moments(&self) -> [f64; 3] {
        let mean = self.squares / self.measure;
        [mean.y + mean.z, mean.z + mean.x, mean.x + mean.y].map(|square| MASS * square)
    }
}

fn agree(inertia: Inertia, expected: &Squares) {
    assert_eq!(inertia.mass(), MASS);
    for (own, expected) in inertia.moments().into_iter().zip(expected.moments()) {
        assert_relative_eq!(own, expected, max_relative = 1e-13);
    }
}

/// A body of rotation about c, its rim given by an angle in stretches on which it is smooth:
/// distance from the axis and height, each with its derivative.
type Rim = Box<dyn Fn(f64) -> [f64; 4]>;

/// The solid inside the rim: discs of radius r across c, whose mean of a^2 is r^2/4.
fn solid_of_rotation(stretches: &[(f64, f64, Rim)]) -> Squares {
    let mut sum = Squares::default();
    for (from, to, rim) in stretches {
        for node in rule().on(*from, *to) {
            let [r, _, c, c_slope] = rim(node.position);
            let across = 0.25 * r * r;
            sum.add(node.weight * PI * r * r * c_slope, Vector3::new(across, across, c * c));
        }
    }
    sum
}

/// Its shell: hoops of radius r, whose mean of a^2 is r^2/2.
fn shell_of_rotation(stretches: &[(f64, f64, Rim)]) -> Squares {
    let mut sum = Squares::default();
    for (from, to, rim) in stretches {
        for node in rule().on(*from, *to) {
            let [r, r_slope, c, c_slope] = rim(node.position);
            let (arc, across) = (r_slope.hypot(c_slope), 0.5 * r * r);
            sum.add(node.weight * 2.0 * PI * r * arc, Vector3::new(across, across, c * c));
        }
    }
    sum
}

/// A quarter circle of radius `r` about (`rim`, `c`) from angle `from` to `to`.
fn arc(r: f64, rim: f64, c: f64, from: f64, to: f64) -> (f64, f64, Rim) {
    let at = move |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [rim + r * cos, -r * sin, c + r * sin, r * cos]
    };
    (from, to, Box::new(at))
}

fn line(from: [f64; 2], to: [f64; 2]) -> (f64, f64, Rim) {
    let (r, c) = (to[0] - from[0], to[1] - from[1]);
    (0.0, 1.0, Box::new(move |t: f64| [from[0] + r * t, r, from[1] + c * t, c]))
}

fn both(surface: &Surface, stretches: &[(f64, f64, Rim)]) {
    let solid = solid_of_rotation(stretches);
    agree(surface.solid(MASS).unwrap(), &solid);
    agree(surface.shell(MASS).unwrap(), &shell_of_rotation(stretches));
    assert_relative_eq!(surface.volume().unwrap(), solid.measure, max_relative = 1e-13);
}

#[test]
fn spheres_solid_and_hollow_are_what_quadrature_gives() {
    let radius = 0.37;
    let rim = [arc(radius, 0.0, 0.0, -FRAC_PI_2, FRAC_PI_2)];
    both(&Surface::sphere(radius).unwrap(), &rim);
    agree(Inertia::solid_sphere(MASS, radius).unwrap(), &solid_of_rotation(&rim));
    agree(Inertia::spherical_shell(MASS, radius).unwrap(), &shell_of_rotation(&rim));
}

#[test]
fn cylinders_and_capsules_are_what_quadrature_gives() {
    let (r, h) = (0.7, 1.5);
    let cylinder = [line([0.0, -h], [r, -h]), line([r, -h], [r, h]), line([r, h], [0.0, h])];
    both(&Surface::cylinder(r, 2.0 * h).unwrap(), &cylinder);
    let capsule =
        [arc(r, 0.0, -h, -FRAC_PI_2, 0.0), line([r, -h], [r, h]), arc(r, 0.0, h, 0.0, FRAC_PI_2)];
    both(&Surface::capsule(r, 2.0 * h).unwrap(), &capsule);
}

#[test]
fn tori_are_what_quadrature_gives() {
    // The inner half of the tube, run through downwards, takes its hole away.
    let (major, minor) = (2.0, 0.7);
    let tube = [
        arc(minor, major, 0.0, -FRAC_PI_2, FRAC_PI_2),
        arc(minor, major, 0.0, FRAC_PI_2, 3.0 * FRAC_PI_2),
    ];
    both(&Surface::torus(major, minor).unwrap(), &tube);
}

#[test]
fn ellipsoids_are_what_quadrature_gives() {
    let axes = [1.5, 1.0, 0.6];
    let egg = Surface::ellipsoid(axes).unwrap();
    // Points of shells similar to it are those of a sphere stretched: of the whole and of the
    // outermost, the homoeoid.
    let (mut whole, mut outermost) = (Squares::default(), Squares::default());
    let stretched = |p: Vector3<f64>| p.component_mul(&Vector3::from(axes)).map(|x| x * x);
    for z in rule().on(-1.0, 1.0) {
        let turns = 64;
        for i in 0..turns {
            let angle = 2.0 * PI * f64::from(i) / f64::from(turns);
            let rim = (1.0 - z.position * z.position).sqrt();
            let p = Vector3::new(rim * angle.cos(), rim * angle.sin(), z.position);
            let weight = z.weight * 2.0 * PI / f64::from(turns) * axes.iter().product::<f64>();
            outermost.add(weight, stretched(p));
            for s in rule().on(0.0, 1.0) {
                let square = s.position * s.position;
                whole.add(weight * s.weight * square, stretched(p) * square);
            }
        }
    }
    agree(egg.solid(MASS).unwrap(), &whole);
    agree(egg.shell(MASS).unwrap(), &outermost);
    assert_relative_eq!(egg.volume().unwrap(), whole.measure, max_relative = 1e-13);
}

#[test]
fn boxes_are_what_quadrature_gives() {
    let half = Vector3::new(0.8, 1.2, 0.5);
    let brick = Surface::cuboid([2.0 * half.x, 2.0 * half.y, 2.0 * half.z]).unwrap();
    let rule = GaussLegendre::new(3).unwrap();
    let (mut whole, mut faces) = (Squares::default(), Squares::default());
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        for x in rule.on(-half[i], half[i]) {
            for y in rule.on(-half[j], half[j]) {
                let mut p = Vector3::zeros();
                (p[i], p[j], p[k]) = (x.position, y.position, half[k]);
                // Two faces.
                faces.add(2.0 * x.weight * y.weight, p.component_mul(&p));
                for z in rule.on(-half[k], half[k]).filter(|_| k == 2) {
                    p[k] = z.position;
                    whole.add(x.weight * y.weight * z.weight, p.component_mul(&p));
                }
            }
        }
    }
    agree(brick.solid(MASS).unwrap(), &whole);
    agree(brick.shell(MASS).unwrap(), &faces);
    assert_relative_eq!(brick.volume().unwrap(), whole.measure, max_relative = 1e-13);
}

#[test]
fn each_moment_is_at_most_the_sum_of_the_others() {
    for large in 0..3 {
        let mut moments = [1.0; 3];
        moments[large] = 2.1;
        let error = Inertia::new(MASS, moments).unwrap_err();
        assert_eq!((error.field, error.value), ("moment of inertia", 2.1));
        moments[large] = 2.0;
        assert_eq!(Inertia::new(MASS, moments).unwrap().moments(), moments);
    }
}
