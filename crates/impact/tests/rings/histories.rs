use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::rings::{RingLaw, Tolerance};
use carom_solver::NumericalLaw;
use std::time::Instant;

fn hertz(g: [f64; 2], nu: [f64; 2]) -> Hertz {
    let body = |i: usize| Material::from_shear(g[i], nu[i]).unwrap();
    let pair = MaterialPair::new(body(0), body(1)).unwrap();
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap()
}

struct Random(u64);
impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
    fn sym(&mut self) -> f64 {
        2.0 * self.next() - 1.0
    }
}

fn path(random: &mut Random, f: f64, twist: f64, steps: usize) -> Vec<Shift> {
    let mut at = [0.0; 4];
    let mut out = Vec::new();
    for _ in 0..5 {
        let size = 1.2 * f;
        let to = [0.2 + 0.8 * random.next(), size * random.sym(), size * random.sym(), twist * size * random.sym()];
        for k in 1..=steps / 5 {
            let p = k as f64 * 5.0 / steps as f64;
            let v: [f64; 4] = std::array::from_fn(|i| at[i] + p * (to[i] - at[i]));
            out.push(Shift { zeta: v[0], xi: v[1], eta: v[2], omega: v[3] });
        }
        at = to;
    }
    out
}

fn follow<const N: usize>(hertz: &Hertz, f: f64, tol: f64, sub: usize, path: &[Shift], sign: f64) -> (Vec<ContactLoad>, f64) {
    let gamma = sign * hertz.materials().gamma();
    let mut law = RingLaw::<N, 8>::with_coupling(hertz, Friction::new(f).unwrap(), Tolerance::new(tol).unwrap(), gamma).unwrap();
    let begin = Instant::now();
    let mut from = Shift::default();
    let mut loads = Vec::new();
    for to in path {
        for k in 1..=sub {
            let p = k as f64 / sub as f64;
            let mix = |a: f64, b: f64| a + p * (b - a);
            law.advance(Shift { zeta: mix(from.zeta, to.zeta), xi: mix(from.xi, to.xi), eta: mix(from.eta, to.eta), omega: mix(from.omega, to.omega) }).unwrap();
        }
        from = *to;
        loads.push(law.load());
    }
    (loads, begin.elapsed().as_secs_f64() * 1e6 / (path.len() * sub) as f64)
}

#[derive(Default, Clone)]
struct Error { sum: f64, worst: f64, sum_m: f64, worst_m: f64, n: f64, t: f64 }
impl Error {
    fn add(&mut self, f: f64, path: &[Shift], got: &(Vec<ContactLoad>, f64), want: &[ContactLoad]) {
        for ((at, a), b) in path.iter().zip(&got.0).zip(want) {
            if at.zeta < 0.1 { continue; }
            let limit = f * b.f_z;
            let e = (a.f_x - b.f_x).hypot(a.f_y - b.f_y) / limit;
            let m = (a.m_z - b.m_z).abs() / (limit * at.zeta.sqrt());
            self.sum += e; self.worst = self.worst.max(e);
            self.sum_m += m; self.worst_m = self.worst_m.max(m);
            self.n += 1.0;
        }
        self.t = if self.t == 0.0 { got.1 } else { self.t.min(got.1) };
    }
    fn show(&self, name: &str) {
        println!("{name}: F {:.4}/{:.3} M {:.4}/{:.3} {:.2} us", self.sum / self.n, self.worst, self.sum_m / self.n, self.worst_m, self.t);
    }
}

#[test]
fn histories_against_the_grid() {
    let cells: usize = std::env::var("CELLS").ok().and_then(|c| c.parse().ok()).unwrap_or(24);
    let paths: u64 = std::env::var("PATHS").ok().and_then(|c| c.parse().ok()).unwrap_or(2);
    let sub = 4;
    for (name, g, nu, f) in [
        ("alike", [1.0, 1.0], [0.3, 0.3], 0.3),
        ("unlike", [1.0, 1.0], [0.0, 0.5], 0.3),
        ("unlike2", [1.0, 0.3], [0.3, 0.2], 0.15),
    ] {
        for twist in [0.0, 1.0] {
            let hertz = hertz(g, nu);
            let mut errors = vec![Error::default(); 8];
            let begin = Instant::now();
            for seed in 0..paths {
                let path = path(&mut Random(seed * 77 + 3), f, twist, 100);
                let mut grid = NumericalLaw::new(hertz, Friction::new(f).unwrap(), 1.0, cells).unwrap().within(1e-6).unwrap();
                let mut from = Shift::default();
                let mut want = Vec::new();
                for to in &path {
                    for k in 1..=sub {
                        let p = k as f64 / sub as f64;
                        let mix = |a: f64, b: f64| a + p * (b - a);
                        grid.advance(Shift { zeta: mix(from.zeta, to.zeta), xi: mix(from.xi, to.xi), eta: mix(from.eta, to.eta), omega: mix(from.omega, to.omega) }).unwrap();
                    }
                    from = *to;
                    want.push(grid.load());
                }
                errors[0].add(f, &path, &follow::<6>(&hertz, f, 1e-2, 1, &path, 1.0), &want);
                errors[1].add(f, &path, &follow::<6>(&hertz, f, 1e-2, 8, &path, 1.0), &want);
                errors[2].add(f, &path, &follow::<6>(&hertz, f, 5e-3, 8, &path, 1.0), &want);
                errors[3].add(f, &path, &follow::<6>(&hertz, f, 3e-3, 8, &path, 1.0), &want);
                errors[4].add(f, &path, &follow::<6>(&hertz, f, 1e-3, 8, &path, 1.0), &want);
                errors[5].add(f, &path, &follow::<6>(&hertz, f, 1e-5, 8, &path, 1.0), &want);
                errors[6].add(f, &path, &follow::<8>(&hertz, f, 1e-5, 8, &path, 1.0), &want);
                errors[7].add(f, &path, &follow::<6>(&hertz, f, 3e-3, 1, &path, 1.0), &want);
            }
            println!("{name} twist {twist} gamma {:.3} kappa {:.3} in {:?}", hertz.materials().gamma(), hertz.materials().kappa(), begin.elapsed());
            for (error, name) in errors.iter().zip(["6x8 1e-2 1","6x8 1e-2 8","6x8 5e-3 8","6x8 3e-3 8","6x8 1e-3 8","6x8 1e-5 8","8x8 1e-5 8","6x8 3e-3 1"]) {
                error.show(name);
            }
        }
    }
}
