//! Coulomb's law in two directions against rings of sliders.

use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::{ScalarMemory, VectorMemory};

mod common;
use common::rings::Rings;
use common::turning::{Kind, Path, divided};
use common::{Random, next};

fn law(tolerance: f64) -> CoulombMemory<[f64; 2]> {
    CoulombMemory::new(Tolerance::new(tolerance).unwrap())
}

fn off(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[derive(Default, Clone, Copy)]
struct Errors {
    sum: f64,
    largest: f64,
    steps: f64,
    vertices: f64,
    most: usize,
}

impl Errors {
    fn add(&mut self, error: f64, vertices: usize) {
        self.sum += error;
        self.steps += 1.0;
        self.largest = self.largest.max(error);
        self.vertices += vertices as f64;
        self.most = self.most.max(vertices);
    }
}

/// Errors over the limit, in collisions over that at the peak.
fn compare(
    kind: Kind,
    path: &Path,
    parts: usize,
    rings: usize,
    tolerance: f64,
    errors: &mut Errors,
) {
    let (mut law, mut oracle) = (law(tolerance), Rings::new(rings, 1.3));
    let fine = divided(path, parts);
    for (i, &(zeta, x)) in fine.iter().enumerate() {
        let got = law.advance(zeta, x).unwrap();
        if i % parts == 0 {
            let want = oracle.advance(zeta, x);
            let limit = if kind == Kind::Collision { 1.0 } else { zeta.powf(1.5) };
            let error = if zeta > 0.0 { off(got, want) / limit } else { off(got, [0.0; 2]) };
            errors.add(error, law.stack().len_of());
        }
    }
}

trait Len {
    fn len_of(&self) -> usize;
}
impl<S: carom_laws::memory::VertexStack<[f64; 2]>> Len for S {
    fn len_of(&self) -> usize {
        self.len()
    }
}

#[test]
fn scan() {
    let env = |name: &str, or: f64| std::env::var(name).map_or(or, |v| v.parse().unwrap());
    let (paths, tolerance) = (env("PATHS", 100.0) as u64, env("TOL", 1e-2));
    let (parts, rings) = (env("PARTS", 1.0) as usize, env("RINGS", 600.0) as usize);
    for kind in Kind::ALL {
        let mut errors = Errors::default();
        let mut old = Errors::default();
        let mut worst = (0.0, 0);
        for seed in 0..paths {
            let path = kind.path(&mut Random(seed));
            let before = errors.largest;
            compare(kind, &path, parts, rings, tolerance, &mut errors);
            if errors.largest > before {
                worst = (errors.largest, seed);
            }
            if parts == 1 {
                let (mut law, mut oracle) = (VectorMemory::new(), Rings::new(rings, 1.3));
                for &(zeta, x) in &path {
                    let got = law.advance(zeta, x).unwrap();
                    let limit = if kind == Kind::Collision { 1.0 } else { zeta.abs().powf(1.5) };
                    old.add(off(got, oracle.advance(zeta, x)) / limit, 0);
                }
            }
        }
        println!(
            "{kind:?}: mean {:.1e} max {:.1e} (seed {}), vertices {:.1} / {}; old {:.1e} {:.1e}",
            errors.sum / errors.steps,
            errors.largest,
            worst.1,
            errors.vertices / errors.steps,
            errors.most,
            old.sum / old.steps,
            old.largest
        );
    }
}

#[test]
fn collinear_paths_are_those_of_the_scalar_law() {
    for parts in [1, 7, 64] {
        let mut worst = 0.0_f64;
        for seed in 0..2000 / parts as u64 {
            let mut random = Random(seed);
            let angle = random.between(0.0, 6.3);
            let (s, c) = angle.sin_cos();
            let mut law = law([1e-1, 1e-2, 1e-4][seed as usize % 3]);
            let mut scalar = ScalarMemory::new();
            let (mut zeta, mut x) = (0.0, [0.0; 2]);
            let mut farthest = 0.0_f64;
            let mut path = vec![(zeta, [0.0, 0.0])];
            for _ in 0..100 {
                (zeta, x) = next(&mut random, zeta, x);
                path.push((zeta, [x[0], 0.0]));
            }
            for (zeta, x) in divided(&path, parts) {
                let want = scalar.advance(zeta, x[0]).unwrap();
                let got = law.advance(zeta, [c * x[0], s * x[0]]).unwrap();
                farthest = if zeta > 0.0 { x[0].abs().max(farthest) } else { x[0].abs() };
                let scale = zeta.max(1e-3).sqrt() * zeta.max(farthest).max(1e-3);
                let error = off(got, [c * want, s * want]) / scale;
                assert!(error < 1e-12, "{error:e} at {zeta} {x:?}, seed {seed}, parts {parts}");
                worst = worst.max(error);
            }
        }
        println!("{parts} parts: {worst:e}");
    }
}

/// The work of the force by Simpson's rule over a step, each force from the same start.
fn work_by_force(start: &CoulombMemory<[f64; 2]>, to: (f64, [f64; 2]), parts: usize) -> f64 {
    let (zeta, x) = (start.zeta(), start.shift());
    let dx = [to.1[0] - x[0], to.1[1] - x[1]];
    let power = |i: usize| {
        let t = i as f64 / parts as f64;
        let mut law = start.clone();
        let force = if i == 0 {
            law.force()
        } else {
            law.advance(zeta + t * (to.0 - zeta), [x[0] + t * dx[0], x[1] + t * dx[1]]).unwrap()
        };
        force[0] * dx[0] + force[1] * dx[1]
    };
    let sum: f64 = (0..=parts)
        .map(|i| {
            let weight = [2.0, 4.0][i % 2];
            if i == 0 || i == parts { power(i) } else { weight * power(i) }
        })
        .sum();
    sum / (3.0 * parts as f64)
}

#[test]
fn work_is_that_of_the_force() {
    let mut worst = 0.0_f64;
    for kind in Kind::ALL {
        for seed in 0..4 {
            let path = kind.path(&mut Random(seed));
            let mut law = law(1e-5);
            for (i, &(zeta, x)) in path.iter().enumerate() {
                if i % 7 == 3 && zeta > 0.0 && law.zeta() > 0.0 {
                    let want = work_by_force(&law, (zeta, x), 400);
                    let got = law.work(zeta, x);
                    let length = off(x, law.shift()) + (zeta - law.zeta()).abs();
                    let scale = law.zeta().max(zeta).powf(1.5) * length;
                    let error = (got - want).abs() / scale.max(1e-9);
                    assert!(error < 1e-4, "{kind:?} {seed} {i}: {got:e} {want:e}, {error:e}");
                    worst = worst.max(error);
                }
                law.advance(zeta, x).unwrap();
            }
        }
    }
    println!("work: {worst:e}");
}
