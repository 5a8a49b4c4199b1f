//! The torsional impact by another method: collocation at Chebyshev points with Picard iteration on analytic
//! pieces, instead of time steps. It shares the law, (5.36)-(5.42) and (10.25), with the library, but neither
//! its integration nor its search for the stick radius, and computes Lubkin's torque by quadrature of `dM/d
//! ln k' = -(4/pi) k'^3 E`.

use std::f64::consts::{FRAC_2_PI, PI};

use carom_impact::torsional::{TorsionalGroups, TorsionalImpact, limits};
use carom_special::AxisRatio;
use carom_special::elliptic::complete;
use carom_special::quadrature::GaussLegendre;

/// Normal velocity at which the argument changes from the contact radius.
const SWITCH: f64 = 0.7;

/// Impulse of the torque, twist and torque, all by the initial spin.
type State = [f64; 3];

fn chebyshev(from: f64, to: f64, degree: usize) -> Vec<f64> {
    let at = |k: usize| (PI * k as f64 / degree as f64).cos();
    (0..=degree).map(|k| 0.5 * (from + to) - 0.5 * (to - from) * at(k)).collect()
}

/// A polynomial by its values in Chebyshev points.
#[derive(Debug, Clone)]
struct Polynomial {
    from: f64,
    to: f64,
    coefficients: Vec<f64>,
}

impl Polynomial {
    fn through(values: &[f64], from: f64, to: f64) -> Self {
        let degree = values.len() - 1;
        let half = |k: usize| if k == 0 || k == degree { 0.5 } else { 1.0 };
        let coefficient = |j: usize| {
            let angle = |k: usize| PI * (j * (degree - k)) as f64 / degree as f64;
            let sum: f64 = (0..=degree).map(|k| half(k) * values[k] * angle(k).cos()).sum();
            2.0 * half(j) * sum / degree as f64
        };
        Self { from, to, coefficients: (0..=degree).map(coefficient).collect() }
    }

    fn at(&self, x: f64) -> f64 {
        let u = (2.0 * x - self.from - self.to) / (self.to - self.from);
        let (mut b, mut c) = (0.0, 0.0);
        for a in self.coefficients[1..].iter().rev() {
            (b, c) = (2.0 * u * b - c + a, b);
        }
        u * b - c + self.coefficients[0]
    }

    fn integral(&self) -> Self {
        let old = |j: usize| self.coefficients.get(j).copied().unwrap_or(0.0);
        let scale = 0.25 * (self.to - self.from);
        let mut new = vec![0.0; self.coefficients.len() + 1];
        for (j, value) in new.iter_mut().enumerate().skip(1) {
            let before = if j == 1 { 2.0 * old(0) } else { old(j - 1) };
            *value = scale * (before - old(j + 1)) / j as f64;
        }
        let start: f64 =
            new.iter().enumerate().map(|(j, a)| if j % 2 == 0 { *a } else { -a }).sum();
        new[0] -= start;
        Self { coefficients: new, ..self.clone() }
    }
}

/// The argument of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Clock {
    /// The contact radius, in compression.
    Growing,
    /// The normal velocity, falling.
    Velocity,
    /// The contact radius, in restitution.
    Receding,
}

fn velocity(radius: f64) -> f64 {
    (1.0 - radius.powi(5)).max(0.0).sqrt()
}

fn radius(w: f64) -> f64 {
    ((1.0 - w) * (1.0 + w)).powf(0.2)
}

impl Clock {
    /// Contact radius, normal velocity and dt by the argument, which always rises.
    fn read(self, x: f64) -> [f64; 3] {
        match self {
            Self::Growing => [x, velocity(x), 2.0 * x / velocity(x)],
            Self::Velocity => [radius(x), -x, 0.8 / radius(x).powi(3)],
            Self::Receding => [-x, -velocity(-x), -2.0 * x / velocity(-x)],
        }
    }

    fn argument(self, al: f64, w: f64) -> f64 {
        match self {
            Self::Growing => al,
            Self::Velocity => -w,
            Self::Receding => -al,
        }
    }
}

/// One analytic piece, solved.
struct Piece {
    clock: Clock,
    course: [Polynomial; 3],
    end: State,
}

impl Piece {
    /// `torque` of radius, velocity and twist; none while all sticks: `dM = al^3 dx`.
    fn solve(
        epsilon: f64,
        clock: Clock,
        [from, to]: [f64; 2],
        start: State,
        torque: Option<&dyn Fn(f64, f64, f64) -> f64>,
    ) -> Self {
        let places = chebyshev(from, to, 40);
        let clocks: Vec<[f64; 3]> = places.iter().map(|x| clock.read(*x)).collect();
        let integral = |rate: Vec<f64>, start: f64| -> Vec<f64> {
            let sum = Polynomial::through(&rate, from, to).integral();
            places.iter().map(|x| start + sum.at(*x)).collect()
        };
        let mut course = start.map(|value| vec![value; places.len()]);
        for _ in 0..40 {
            let spin: Vec<f64> = course[0].iter().map(|i| 1.0 - epsilon * i).collect();
            let with = |f: &dyn Fn(usize) -> f64| (0..places.len()).map(f).collect::<Vec<f64>>();
            let twist = integral(with(&|i| spin[i] * clocks[i][2]), start[1]);
            let moment = match torque {
                None => {
                    integral(with(&|i| clocks[i][0].powi(3) * spin[i] * clocks[i][2]), start[2])
                }
                Some(torque) => with(&|i| torque(clocks[i][0], clocks[i][1], twist[i])),
            };
            let impulse = integral(with(&|i| moment[i] * clocks[i][2]), start[0]);
            let change = impulse.iter().zip(&course[0]).map(|(a, b)| (a - b).abs());
            let change = change.fold(0.0, f64::max);
            course = [impulse, twist, moment];
            if change < 1e-15 {
                break;
            }
        }
        let end = course.each_ref().map(|values| values[places.len() - 1]);
        Self { clock, course: course.map(|values| Polynomial::through(&values, from, to)), end }
    }

    fn at(&self, al: f64, w: f64) -> State {
        self.course.each_ref().map(|part| part.at(self.clock.argument(al, w)))
    }
}

/// What adhesion stored in compression.
struct Stored {
    pieces: [Piece; 2],
    onset: [f64; 2],
}

impl Stored {
    fn new(epsilon: f64, omega: f64) -> Self {
        let growing = Piece::solve(epsilon, Clock::Growing, [0.0, radius(SWITCH)], [0.0; 3], None);
        let closing = Piece::solve(epsilon, Clock::Velocity, [-SWITCH, 0.0], growing.end, None);
        let mut stored = Self { pieces: [growing, closing], onset: [1.0, 0.0] };
        // 2 Omega al y = w: the left side grows, the right falls.
        let excess = |al: f64, w: f64| 2.0 * omega * al * (1.0 - epsilon * stored.at(al, w)[0]) - w;
        let early = excess(radius(SWITCH), SWITCH) > 0.0;
        let (mut low, mut high) = if early { (0.0, radius(SWITCH)) } else { (-SWITCH, 0.0) };
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            let [al, w, _] = if early { Clock::Growing } else { Clock::Velocity }.read(middle);
            *(if excess(al, w) > 0.0 { &mut high } else { &mut low }) = middle;
        }
        let [al, w, _] = if early { Clock::Growing } else { Clock::Velocity }.read(high);
        stored.onset = [al, w];
        stored
    }

    fn at(&self, al: f64, w: f64) -> State {
        self.pieces[usize::from(w < SWITCH)].at(al, w)
    }
}

/// Lubkin's torque M/(f F a) by the stick radius, by quadrature over halvings of it.
struct Ring {
    rule: GaussLegendre,
    halvings: Vec<f64>,
}

impl Ring {
    fn new() -> Self {
        let mut ring = Self { rule: GaussLegendre::new(20).unwrap(), halvings: vec![0.0] };
        for j in 0..60 {
            let outer = 0.5_f64.powi(j);
            let next = ring.halvings[j as usize] + ring.between(0.5 * outer, outer);
            ring.halvings.push(next);
        }
        ring
    }

    fn between(&self, low: f64, high: f64) -> f64 {
        let slope = |k: f64| k * k * complete::e(AxisRatio::new(k).unwrap());
        4.0 / PI * self.rule.integrate(low, high, slope)
    }

    fn torque(&self, stick: f64) -> f64 {
        let halving = (-stick.log2()).floor() as usize;
        match self.halvings.get(halving) {
            Some(sum) if halving < 60 => sum + self.between(stick, 0.5_f64.powi(halving as i32)),
            _ => 3.0 * PI / 16.0,
        }
    }
}

/// Impulse of the whole torque and the radius at which slip begins.
fn impact(epsilon: f64, omega: f64) -> [f64; 2] {
    let ring = Ring::new();
    let stored = Stored::new(epsilon, omega);
    let [onset, slipping_from] = stored.onset;
    let torque = |al: f64, w: f64, x: f64| {
        if al <= 0.0 {
            return 0.0;
        }
        // Omega (x - x_st(c)) - (2/pi) al (K - E), c = al exp(-depth): falls with the depth.
        let excess = |depth: f64| {
            let stick = (al * (-depth).exp()).min(onset);
            let then = (w * w - (1.0 - w * w) * (-5.0 * depth).exp_m1()).max(0.0).sqrt();
            let [_, twist, moment] = stored.at(stick, then.max(slipping_from));
            let modulus = -(-2.0 * depth).exp_m1();
            let axes = AxisRatio::new((-depth).exp()).unwrap();
            (omega * (x - twist) - FRAC_2_PI * al * modulus * complete::d(axes), moment)
        };
        let (mut low, mut high) = ((al / onset).max(1.0).ln(), 40.0);
        if excess(high).0 > 0.0 {
            return 3.0 * PI / 32.0 * al.powi(4) / omega;
        }
        for _ in 0..70 {
            let middle = 0.5 * (low + high);
            *(if excess(middle).0 > 0.0 { &mut low } else { &mut high }) = middle;
        }
        excess(low).1 + 0.5 * al.powi(4) * ring.torque((-low).exp()) / omega
    };
    let mut state = stored.at(onset, slipping_from);
    let mut follow = |clock: Clock, ends: &[f64]| {
        for piece in ends.windows(2) {
            state = Piece::solve(epsilon, clock, [piece[0], piece[1]], state, Some(&torque)).end;
        }
    };
    let rim = radius(SWITCH);
    let first = (-slipping_from).max(-SWITCH);
    if slipping_from > SWITCH {
        follow(Clock::Growing, &[onset, rim]);
    }
    // The ring runs through its course within the velocity at which it opened.
    let mut ends = vec![first, 0.5 * first, 0.0];
    let mut end = 0.5 * slipping_from.min(SWITCH);
    while end < 0.7 * SWITCH {
        ends.push(end);
        end *= 2.0;
    }
    ends.push(SWITCH);
    follow(Clock::Velocity, &ends);
    let parts = [1.0, 0.6, 0.35, 0.2, 0.1, 0.04, 0.0];
    follow(Clock::Receding, &parts.map(|part| -part * rim));
    [state[0], onset]
}

#[test]
fn spin_ratios_agree_with_collocation() {
    let mut worst: f64 = 0.0;
    for (epsilon, omega) in [
        (0.0625, 0.01),
        (0.0625, 0.1),
        (0.0625, 0.5),
        (0.0625, 1.0),
        (0.0625, 5.0),
        (0.01, 0.3),
        (0.5, 0.1),
        (0.5, 1.0),
    ] {
        let own = TorsionalImpact::new(TorsionalGroups::new(epsilon, omega).unwrap()).unwrap();
        let [impulse, onset] = impact(epsilon, omega);
        let off = own.spin_ratio() - (1.0 - epsilon * impulse);
        println!("{epsilon} {omega}: {off:.1e} {:.1e}", own.onset_radius() - onset);
        assert!(off.abs() <= own.error_estimate(), "{epsilon} {omega}: {off:e}");
        assert!((own.onset_radius() - onset).abs() < 2e-15, "{epsilon} {omega}");
        worst = worst.max(off.abs());
    }
    println!("worst {worst:e}");
}

#[test]
fn losses_of_a_constant_spin_agree_with_quadrature() {
    for omega in [0.01, 0.1, 0.3, 1.0] {
        let own = limits::first_order_loss(omega).unwrap();
        let off = own / impact(0.0, omega)[0] - 1.0;
        println!("{omega}: {own} {off:.1e}");
        assert!(off.abs() < 1e-12, "{omega}: {off:e}");
    }
}
