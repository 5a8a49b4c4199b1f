//! Two slip annuli of a receding contact, compared with an independent half-space solver: fixed
//! rings of equal width down to the centre, with small steps throughout.

use std::f64::consts::{FRAC_2_PI, PI};

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::torsion::history::{TwistHistory, sliding_limit};
use carom_laws::torsion::lubkin::Lubkin;

/// Tractions of rings in equal spacing, and the rotations that they cause.
pub(crate) struct Rings {
    edges: Vec<f64>,
    middles: Vec<f64>,
    traction: Vec<Vec<f64>>,
    compliance: Vec<Vec<f64>>,
}

fn dot(row: &[f64], values: &[f64]) -> f64 {
    row.iter().zip(values).map(|(a, b)| a * b).sum()
}

impl Rings {
    pub(crate) fn new(count: usize) -> Self {
        let edges: Vec<f64> = (0..=count).map(|i| i as f64 / count as f64).collect();
        let middles: Vec<f64> = edges.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let arc = |s: f64, rho: f64| (s / rho).max(1.0).acosh();
        // Rotation of rho by a unit density up to s.
        let turn = |s: f64, rho: f64| {
            let x = (s / rho).min(1.0);
            let root = (1.0 - x * x).max(0.0).sqrt();
            FRAC_2_PI * rho * (x * x.asin() + root + (root.powi(3) - 1.0) / 3.0)
                + (s - rho).max(0.0)
        };
        let table = |f: &dyn Fn(f64, f64) -> f64| -> Vec<Vec<f64>> {
            let row = |rho: &f64| edges.windows(2).map(|s| f(s[1], *rho) - f(s[0], *rho)).collect();
            middles.iter().map(row).collect()
        };
        let traction = table(&|s, rho| rho * arc(s, rho));
        let mut compliance = table(&turn);
        for row in &mut compliance {
            for j in 0..count {
                let known: f64 = (0..j).map(|k| row[k] * traction[k][j]).sum();
                row[j] = (row[j] - known) / traction[j][j];
            }
        }
        Self { edges, middles, traction, compliance }
    }

    /// The torque after a contact twisted to `twist` at unit radius receded to `radius` while it
    /// turned back by `rate` times the way of the edge.
    fn torque(&self, twist: f64, radius: f64, rate: f64, steps: u32) -> f64 {
        let n = self.middles.len();
        let start = Lubkin::at_twist(twist * 3.0 / 8.0).unwrap();
        let below = |s: f64| {
            let s = s.min(1.0);
            if s <= start.stick_radius() {
                return 0.0;
            }
            twist - 8.0 / 3.0 * Lubkin::at_stick_radius(s).unwrap().twist()
        };
        let density: Vec<f64> =
            self.edges.windows(2).map(|s| (below(s[1]) - below(s[0])) * n as f64).collect();
        let traction: Vec<f64> = self.traction.iter().map(|row| dot(row, &density)).collect();
        let mut state = RingState { slips: self.slips(&traction, twist), rings: self, traction };
        (1..=steps).fold(0.0, |_, step| {
            let lost = (1.0 - radius) * f64::from(step) / f64::from(steps);
            state.advance(1.0 - lost, twist - rate * lost)
        })
    }

    /// Two bodies at first contact.
    pub(crate) fn at_rest(&self) -> RingState<'_> {
        let none = vec![0.0; self.middles.len()];
        RingState { rings: self, traction: none.clone(), slips: none }
    }

    fn slips(&self, traction: &[f64], twist: f64) -> Vec<f64> {
        self.compliance.iter().map(|row| twist - dot(row, traction)).collect()
    }
}

/// The state of the rings.
pub(crate) struct RingState<'a> {
    rings: &'a Rings,
    traction: Vec<f64>,
    slips: Vec<f64>,
}

impl RingState<'_> {
    /// The torque after a step to a contact radius up to 1 and a twist, by Gauss-Seidel sweeps.
    pub(crate) fn advance(&mut self, radius: f64, twist: f64) -> f64 {
        let Rings { middles, compliance, .. } = self.rings;
        let limit = |rho: &f64| (radius * radius - rho * rho).max(0.0).sqrt();
        let limits: Vec<f64> = middles.iter().map(limit).collect();
        loop {
            let mut change = 0.0_f64;
            for i in 0..middles.len() {
                let rest = twist - dot(&compliance[i], &self.traction) - self.slips[i];
                let free = self.traction[i] + rest / compliance[i][i];
                let next = free.clamp(-limits[i], limits[i]);
                change = change.max((next - self.traction[i]).abs());
                self.traction[i] = next;
            }
            if change < 1e-9 {
                break;
            }
        }
        self.slips = self.rings.slips(&self.traction, twist);
        self.torque()
    }

    fn torque(&self) -> f64 {
        let Rings { edges, traction, .. } = self.rings;
        let n = self.traction.len();
        let mut density = vec![0.0; n];
        for i in (0..n).rev() {
            let known = dot(&traction[i][i + 1..], &density[i + 1..]);
            density[i] = (self.traction[i] - known) / traction[i][i];
        }
        let moment = |s: f64| 0.25 * s.powi(4);
        edges.windows(2).zip(&density).map(|(s, b)| b * (moment(s[1]) - moment(s[0]))).sum()
    }
}

fn run(mut history: TwistHistory, twist: f64, rate: f64, steps: u32) -> TwistHistory {
    history.advance(1.0, 0.0).unwrap();
    history.advance(1.0, twist).unwrap();
    for i in 1..=steps {
        let lost = 0.2 * f64::from(i) / f64::from(steps);
        history.advance(1.0 - lost, twist - rate * lost).unwrap();
    }
    history
}

const LIMIT: f64 = 3.0 * PI / 32.0 * 0.8 * 0.8 * 0.8 * 0.8;

#[test]
fn torque_of_two_rings_is_that_of_an_independent_solver() {
    let rings = Rings::new(200);
    let mut worst = [0.0_f64; 3];
    for (twist, rate) in [(0.6, 1.15), (0.6, 1.2), (0.6, 1.4), (0.3, 1.1), (1.2, 1.3), (1.2, 1.8)] {
        let want = rings.torque(twist, 0.8, rate, 40);
        for steps in [1, 7, 40] {
            for (width, worst) in [1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0].into_iter().zip(&mut worst)
            {
                let history = TwistHistory::with_ring_width(width).unwrap();
                let history = run(history, twist, rate, steps);
                let error = (history.torque() - want).abs() / LIMIT;
                assert!(history.ring_steps() > 0);
                *worst = worst.max(error);
            }
        }
    }
    // The solver's own error is the 1.6e-4 in which both narrower widths agree.
    assert!(worst[0] < 4e-4 && worst[1] < 2e-4 && worst[2] < 2e-4, "{worst:?}");
    let usual = run(TwistHistory::new(), 0.6, 1.2, 7);
    let asked = run(TwistHistory::with_ring_width(1.0 / 128.0).unwrap(), 0.6, 1.2, 7);
    assert_eq!(usual, asked);
    assert_eq!(TwistHistory::with_ring_width(1e-3).unwrap_err().field, "width");
}

/// Random ways to two rings, in one step, against two meshes of the solver, the difference of
/// which is taken for its error. `CAROM_RING_PATHS` takes more.
#[test]
fn random_ways_to_two_rings_agree_with_an_independent_solver() {
    let count = std::env::var("CAROM_RING_PATHS").map_or(16, |count| count.parse().unwrap());
    let (coarse, fine) = (Rings::new(100), Rings::new(200));
    let mut random = Splitmix(19);
    let mut worst = [0.0_f64; 2];
    for _ in 0..count {
        let twist = 10_f64.powf(random.between(-0.6, 0.5));
        let rate = random.between(1.0, 2.0);
        let end = f64::from(25 + random.below(22) as u32) / 50.0; // an edge of both meshes
        let limit = sliding_limit(end);
        let wants = [coarse.torque(twist, end, rate, 20), fine.torque(twist, end, rate, 40)];
        let error = (wants[1] - wants[0]).abs() / limit;
        let mut history = TwistHistory::new();
        for (radius, twist) in [(1.0, 0.0), (1.0, twist), (end, twist - rate * (1.0 - end))] {
            history.advance(radius, twist).unwrap();
        }
        let off = (history.torque() - wants[1]).abs() / limit;
        worst = [worst[0].max(off), worst[1].max(error)];
        // Beside its difference the solver's coarse rim is 7e-4 off.
        assert!(off < error + 7e-4, "{twist} {rate} {end}: {off:e}, the solver {error:e}");
    }
    println!("worst of {count}: {:e}, the solver {:e}", worst[0], worst[1]);
}

#[test]
fn two_rings_form_between_the_limits_of_the_rate() {
    // The stick radius is 0.46: below the threshold of 1.08 the ring keeps its sign, above 1/0.46
    // it sticks as a whole.
    for rate in [0.9, 1.02, 1.05, 1.09, 1.15, 1.3, 1.6, 2.2, 2.4, 3.0] {
        let [one, few, many] = [1, 4, 16].map(|steps| run(TwistHistory::new(), 0.6, rate, steps));
        let rings = one.ring_steps().max(many.ring_steps());
        assert_eq!(rings > 0, (1.08..1.7).contains(&rate), "rate {rate}: {rings} ring steps");
        assert!((one.torque() - many.torque()).abs() < 5e-4 * LIMIT, "rate {rate}");
        assert!((few.torque() - many.torque()).abs() < 5e-4 * LIMIT, "rate {rate}");
    }
}

#[test]
fn narrower_rings_converge_over_long_histories() {
    for (twist, depth) in [(0.7, 0.2), (0.3, 0.5), (1.5, 0.4)] {
        let mut laws = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0]
            .map(|width| TwistHistory::with_ring_width(width).unwrap());
        let mut worst = [0.0_f64; 2];
        for step in 0..500 {
            let t = 0.05 * f64::from(step);
            let radius = 1.0 + depth * (0.5 * (1.3 * t + 1.0).sin() + 0.5 * (0.71 * t).sin());
            let turn = twist * (0.6 * (0.9 * t).sin() + 0.4 * (2.3 * t + 1.0).sin());
            let [wide, narrow, finest] = laws
                .each_mut()
                .map(|law| law.advance(radius, turn).unwrap() / sliding_limit(radius));
            worst[0] = worst[0].max((wide - finest).abs());
            worst[1] = worst[1].max((narrow - finest).abs());
        }
        assert!(laws[0].ring_steps() > 2);
        // All steps of a law are counted, also those before the bodies parted.
        let mut parted = laws[0].clone();
        parted.advance(0.0, 0.0).unwrap();
        assert_eq!(parted.ring_steps(), laws[0].ring_steps());
        assert!(worst[0] < 3e-3 && worst[1] < 7e-4, "{twist} {depth}: {worst:?}");
        assert!(worst[1] < worst[0], "{twist} {depth}: {worst:?}");
    }
}
