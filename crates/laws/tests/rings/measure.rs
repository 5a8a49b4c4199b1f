use carom_halfspace::{Material, MaterialPair};
use carom_laws::coulomb::Tolerance as Fine;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::rings::{RingLaw, Tolerance};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::torsion::law::TorsionLaw;
use std::time::Instant;

pub fn hertz(g: [f64; 2], nu: [f64; 2]) -> Hertz {
    let pair = MaterialPair::new(
        Material::from_shear(g[0], nu[0]).unwrap(),
        Material::from_shear(g[1], nu[1]).unwrap(),
    )
    .unwrap();
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap()
}

pub struct Random(pub u64);
impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
    pub fn sym(&mut self) -> f64 {
        2.0 * self.next() - 1.0
    }
}

fn constant<const N: usize, const M: usize>(tol: f64, steps: usize) {
    let hertz = hertz([2.0, 2.0], [0.3, 0.3]);
    let f = Friction::new(0.3).unwrap();
    let mut random = Random(5);
    let (mut sum, mut worst, mut count, mut its) = (0.0, 0.0_f64, 0.0, 0);
    for _ in 0..20 {
        let mut law = RingLaw::<N, M>::new(&hertz, f, Tolerance::new(tol).unwrap()).unwrap();
        let mut exact = ShiftLaw::<[f64; 2]>::with_tolerance(hertz.stiffness(), f, Fine::new(1e-6).unwrap());
        let mut at = Shift { zeta: 1.0, ..Shift::default() };
        law.advance(at).unwrap();
        exact.advance(at).unwrap();
        for _ in 0..8 {
            let to = [0.6 * random.sym(), 0.6 * random.sym()];
            let from = [at.xi, at.eta];
            for k in 1..=steps {
                let p = k as f64 / steps as f64;
                at.xi = from[0] + p * (to[0] - from[0]);
                at.eta = from[1] + p * (to[1] - from[1]);
                let a = law.advance(at).unwrap();
                let b = exact.advance(at).unwrap();
                let e = (a.f_x - b.f_x).hypot(a.f_y - b.f_y) / (0.3 * b.f_z);
                sum += e;
                worst = worst.max(e);
                count += 1.0;
                its += law.iterations();
            }
        }
    }
    println!("constant {N}x{M} tol {tol} steps {steps}: mean {:.5} worst {:.5} its {:.2}", sum / count, worst, its as f64 / count);
}

#[test]
fn constant_approach() {
    constant::<6, 8>(1e-2, 12);
    constant::<6, 8>(1e-3, 12);
    constant::<8, 8>(1e-3, 12);
    constant::<8, 8>(1e-3, 100);
    constant::<8, 8>(1e-4, 100);
    constant::<8, 16>(1e-4, 100);
    constant::<16, 8>(1e-4, 100);
}

fn oblique<const N: usize>() {
    let hertz = hertz([2.0, 2.0], [0.0, 0.0]);
    for f in [f64::INFINITY, 1e6, 10.0] {
        let f = Friction::new(f).unwrap();
        let mut law = RingLaw::<N, 8>::new(&hertz, f, Tolerance::new(1e-5).unwrap()).unwrap();
        let load = law.advance(Shift { zeta: 1.0, xi: 0.9, ..Shift::default() }).unwrap();
        let want = 2.0 / 3.0 * hertz.stiffness().c_x * 0.9;
        println!("oblique {N} f {f:?}: {} its {}", load.f_x / want - 1.0, law.iterations());
    }
    // In slip: exact is the memory
    for (psi, f) in [(0.5, 1.0), (0.9, 1.0), (1.5, 1.0), (3.0, 1.0)] {
        let f = Friction::new(f).unwrap();
        let mut law = RingLaw::<N, 8>::new(&hertz, f, Tolerance::new(1e-4).unwrap()).unwrap();
        let mut exact = ShiftLaw::<[f64; 2]>::new(hertz.stiffness(), f);
        let at = Shift { zeta: 1.0, xi: psi, ..Shift::default() };
        let (a, b) = (law.advance(at).unwrap(), exact.advance(at).unwrap());
        println!("oblique {N} psi {psi}: {} {} its {}", a.f_x / a.f_z, b.f_x / b.f_z, law.iterations());
    }
}

#[test]
fn oblique_loading() {
    oblique::<4>();
    oblique::<6>();
    oblique::<8>();
    oblique::<12>();
    oblique::<16>();
}

fn twist<const N: usize>(tol: f64) {
    let hertz = hertz([2.0, 2.0], [0.3, 0.3]);
    let f = Friction::new(0.3).unwrap();
    let mut random = Random(7);
    let (mut sum, mut worst, mut count, mut force) = (0.0, 0.0_f64, 0.0, 0.0_f64);
    let mut law = RingLaw::<N, 8>::new(&hertz, f, Tolerance::new(tol).unwrap()).unwrap();
    let mut exact = TorsionLaw::new(&hertz, f).unwrap();
    let mut at = Shift { zeta: 1.0, ..Shift::default() };
    law.advance(at).unwrap();
    exact.advance(at).unwrap();
    for _ in 0..20 {
        let to = 0.8 * random.sym();
        let from = at.omega;
        for k in 1..=20 {
            at.omega = from + (to - from) * k as f64 / 20.0;
            let a = law.advance(at).unwrap();
            let b = exact.advance(at).unwrap();
            let e = (a.m_z - b.m_z).abs() / (0.3 * b.f_z);
            sum += e;
            worst = worst.max(e);
            count += 1.0;
            force = force.max(a.f_x.hypot(a.f_y));
        }
    }
    println!("twist {N} tol {tol}: mean {:.5} worst {:.5} force {force:e}", sum / count, worst);
}

#[test]
fn pure_twist() {
    twist::<6>(1e-2);
    twist::<6>(1e-3);
    twist::<8>(1e-3);
    twist::<16>(1e-4);
}

#[test]
fn time() {
    let hertz = hertz([2.0, 2.0], [0.0, 0.5]);
    println!("gamma {} kappa {}", hertz.materials().gamma(), hertz.materials().kappa());
    let f = Friction::new(0.3).unwrap();
    let begin = Instant::now();
    let law = RingLaw::<6, 8>::new(&hertz, f, Tolerance::new(1e-2).unwrap()).unwrap();
    println!("first pair {:?}", begin.elapsed());
    let begin = Instant::now();
    let _ = RingLaw::<6, 8>::new(&hertz, Friction::new(0.2).unwrap(), Tolerance::new(1e-2).unwrap()).unwrap();
    println!("second pair {:?} size {}", begin.elapsed(), size_of_val(&law));
    for steps in [100, 800] {
        let mut many = [0; 8];
        let mut best = f64::INFINITY;
        let (mut its, mut n) = (0, 0);
        for seed in 0..20 {
            let mut random = Random(seed);
            let mut path = Vec::new();
            let mut at = [0.0; 4];
            for _ in 0..10 {
                let to = [0.1 + random.next(), 0.5 * random.sym(), 0.5 * random.sym(), 0.5 * random.sym()];
                for k in 1..=steps / 10 {
                    let p = k as f64 * 10.0 / steps as f64;
                    let v: [f64; 4] = std::array::from_fn(|i| at[i] + p * (to[i] - at[i]));
                    path.push(Shift { zeta: v[0], xi: v[1], eta: v[2], omega: v[3] });
                }
                at = to;
            }
            let mut law = law.clone();
            let begin = Instant::now();
            for to in &path {
                law.advance(*to).unwrap();
            }
            best = best.min(begin.elapsed().as_secs_f64() / path.len() as f64);
            let mut law = RingLaw::<6, 8>::new(&hertz, f, Tolerance::new(1e-2).unwrap()).unwrap();
            for to in &path {
                law.advance(*to).unwrap();
                its += law.iterations();
                many[(law.iterations() as f64).log2() as usize % 8] += 1;
                if law.iterations() > 255 { many[7] += 1; }
                n += 1;
            }
        }
        println!("steps {steps}: {:.3} us, its {:.2} {many:?}", best * 1e6, its as f64 / n as f64);
    }
    let _ = ContactLoad::default();
}

#[test]
fn twist_curve() {
    for turns in [1, 20] {
        let hertz = hertz([2.0, 2.0], [0.3, 0.3]);
        let f = Friction::new(0.3).unwrap();
        let mut law = RingLaw::<8, 8>::new(&hertz, f, Tolerance::new(1e-4).unwrap()).unwrap();
        let mut exact = TorsionLaw::new(&hertz, f).unwrap();
        let mut at = Shift { zeta: 1.0, ..Shift::default() };
        law.advance(at).unwrap();
        exact.advance(at).unwrap();
        for k in (1..=30).chain((5..30).rev()) {
            for part in 1..=turns {
                let old = at.omega;
                at.omega = old + (f64::from(k) * 0.03 - old) * f64::from(part) / f64::from(turns);
                law.advance(at).unwrap();
                exact.advance(at).unwrap();
            }
            let (a, b) = (law.load(), exact.load());
            if turns == 1 || k % 2 == 0 {
                println!("{turns} {k} {:.5} {:.5} its {}", a.m_z / (0.3 * a.f_z), b.m_z / (0.3 * b.f_z), law.iterations());
            }
        }
    }
}

fn in_line<const N: usize, const M: usize>(tol: f64, steps: usize) {
    let hertz = hertz([2.0, 2.0], [0.0, 0.0]);
    let f = Friction::new(0.3).unwrap();
    let mut random = Random(5);
    let (mut sum, mut worst, mut count, mut its) = (0.0, 0.0_f64, 0.0, 0);
    for _ in 0..20 {
        let mut law = RingLaw::<N, M>::new(&hertz, f, Tolerance::new(tol).unwrap()).unwrap();
        let mut exact = ShiftLaw::<[f64; 2]>::with_tolerance(hertz.stiffness(), f, Fine::new(1e-6).unwrap());
        let mut at = Shift { zeta: 1.0, ..Shift::default() };
        law.advance(at).unwrap();
        exact.advance(at).unwrap();
        for _ in 0..8 {
            let (from, to) = (at.xi, 0.4 * random.sym());
            for k in 1..=steps {
                at.xi = from + k as f64 / steps as f64 * (to - from);
                let a = law.advance(at).unwrap();
                let b = exact.advance(at).unwrap();
                let e = (a.f_x - b.f_x).hypot(a.f_y - b.f_y) / (0.3 * b.f_z);
                sum += e;
                worst = worst.max(e);
                count += 1.0;
                its += law.iterations();
            }
        }
    }
    println!("in line {N}x{M} tol {tol} steps {steps}: mean {:.5} worst {:.5} its {:.2}", sum / count, worst, its as f64 / count);
}

#[test]
fn in_line_constant() {
    in_line::<6, 8>(1e-2, 12);
    in_line::<6, 8>(1e-3, 12);
    in_line::<8, 8>(1e-3, 12);
    in_line::<8, 8>(1e-3, 100);
    in_line::<8, 8>(1e-4, 100);
    in_line::<16, 8>(1e-4, 100);
}

#[test]
fn cattaneo() {
    let hertz = hertz([2.0, 2.0], [0.0, 0.0]);
    let f = Friction::new(0.3).unwrap();
    fn run<const N: usize>(hertz: &Hertz, f: Friction) {
        let mut law = RingLaw::<N, 8>::new(hertz, f, Tolerance::new(1e-5).unwrap()).unwrap();
        let mut exact = ShiftLaw::<f64>::new(hertz.stiffness(), f);
        let mut at = Shift { zeta: 1.0, ..Shift::default() };
        law.advance(at).unwrap();
        exact.advance(at).unwrap();
        let (mut sum, mut worst, mut where_) = (0.0, 0.0_f64, 0.0);
        for k in 1..=100 {
            at.xi = k as f64 * 0.0036;
            let (a, b) = (law.advance(at).unwrap(), exact.advance(at).unwrap());
            let e = (a.f_x - b.f_x) / (0.3 * b.f_z);
            sum += e.abs();
            if e.abs() > worst { worst = e.abs(); where_ = at.xi / 0.3; }
        }
        println!("cattaneo {N} mean {:.5} worst {worst:.5} at {where_:.3}", sum / 100.0);
    }
    run::<4>(&hertz, f);
    run::<6>(&hertz, f);
    run::<8>(&hertz, f);
    run::<12>(&hertz, f);
    run::<16>(&hertz, f);
}

#[test]
fn pressing() {
    // kappa 1.125: nu_combined = 0.2; gamma as asked.
    fn run<const N: usize>() {
        let hertz = hertz([2.0, 2.0], [0.2, 0.2]);
        println!("kappa {}", hertz.materials().kappa());
        for ratio in [0.5, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0] {
            for gamma in [0.01, 0.2] {
            for steps in [1, 50] {
                let f = Friction::new(gamma / ratio).unwrap();
                let mut law = RingLaw::<N, 8>::with_coupling(&hertz, f, Tolerance::new(1e-4).unwrap(), gamma).unwrap();
                for k in 1..=steps {
                    law.advance(Shift { zeta: k as f64 / steps as f64, ..Shift::default() }).unwrap();
                }
                let load = law.load();
                println!("press {N} G {ratio} gamma {gamma} steps {steps}: {:.3?} F_z {:.5} its {}", law.slipping(), load.f_z / hertz.force(1.0), law.iterations());
            }
            }
        }
    }
    run::<6>();
    run::<16>();
}

#[test]
fn energy() {
    use carom_laws::law::Dissipative;
    for (name, nu, twist, steps, constant) in [
        ("alike", [0.3, 0.3], 0.0, 100, true),
        ("alike", [0.3, 0.3], 0.0, 800, true),
        ("unlike", [0.0, 0.5], 1.0, 800, true),
        ("alike", [0.3, 0.3], 0.0, 100, false),
        ("alike", [0.3, 0.3], 0.0, 800, false),
        ("alike", [0.3, 0.3], 0.0, 6400, false),
        ("unlike", [0.0, 0.5], 0.0, 100, false),
        ("unlike", [0.0, 0.5], 0.0, 800, false),
        ("unlike", [0.0, 0.5], 0.0, 6400, false),
        ("unlike", [0.0, 0.5], 1.0, 800, false),
    ] {
        let hertz = hertz([2.0, 2.0], nu);
        let f = Friction::new(0.3).unwrap();
        for tol in [1e-2, 1e-4] {
        let mut random = Random(11);
        let mut law = RingLaw::<6, 8>::new(&hertz, f, Tolerance::new(tol).unwrap()).unwrap();
        let mut at = [0.0; 4];
        if constant { law.advance(Shift { zeta: 1.0, ..Shift::default() }).unwrap(); at[0] = 1.0; }
        let mut old = law.load();
        let (mut work, mut heat, mut trap, mut path) = (law.stored_energy(), 0.0, 0.0, 0.0);
        let (mut least, mut worst) = (0.0_f64, 0.0_f64);
        for _ in 0..10 {
            let to = [if constant { 1.0 } else { 0.2 + 0.8 * random.next() }, 0.4 * random.sym(), 0.4 * random.sym(), 0.4 * twist * random.sym()];
            let mut prev = at;
            for k in 1..=steps / 10 {
                let p = k as f64 * 10.0 / steps as f64;
                let v: [f64; 4] = std::array::from_fn(|i| at[i] + p * (to[i] - at[i]));
                let shift = Shift { zeta: v[0], xi: v[1], eta: v[2], omega: v[3] };
                let before = law.stored_energy();
                let h = law.dissipation(shift);
                let new = law.advance(shift).unwrap();
                let d: [f64; 4] = std::array::from_fn(|i| v[i] - prev[i]);
                // normal work of Hertz exact, the rest by trapezoid
                let hz = |z: f64| 2.0/3.0*hertz.stiffness().c_z * z.max(0.0).powf(1.5);
                let ez = |z: f64| 4.0/15.0*hertz.stiffness().c_z * z.max(0.0).powf(2.5);
                let w = ez(v[0]) - ez(prev[0]) + 0.5 * ((new.f_z - hz(v[0])) + (old.f_z - hz(prev[0]))) * d[0] + 0.5 * (new.f_x + old.f_x) * d[1] + 0.5 * (new.f_y + old.f_y) * d[2] + 0.5 * (new.m_z + old.m_z) * d[3];
                work += w;
                heat += h;
                trap += w - (law.stored_energy() - before);
                least = least.min(w - (law.stored_energy() - before));
                path += 0.3 * hertz.force(1.0) * d[1].hypot(d[2]);
                prev = v;
                old = new;
                let off: f64 = work - heat - law.stored_energy();
                worst = worst.max(off.abs());
            }
            at = to;
        }
        println!("energy {name} twist {twist} steps {steps} const {constant} tol {tol}: heat/path {:.4} by work {:.4} least {:.2e} worst off {:.4}", heat / path, trap / path, least / path, worst / path);
        }
    }
}
