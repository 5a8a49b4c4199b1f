//! The normal motion of Kelvin-Voigt bodies, in steps of equal length of a variable in which it is smooth.
//!
//! Units: m = K = v = 1, F = K zeta^(3/2) the elastic force; tau is the relaxation time in them. With dt = 2 a ds, a the
//! contact radius (a^2 = zeta in compression, zeta + tau zeta' in rebound), both halves are polynomial:
//!
//! - compression, F = a^3 + (3/2) tau a v: `a' = v`, `v' = -2 a F`, `zeta = a^2`;
//! - rebound, F = a^3: `a' = v - tau a^3`, `v' = -2 a^4`, `zeta' = 2 a v`.
//!
//! The second is exact: contact that is left stays free of pressure (Ting 1966; here by springs, see the module above).

/// Approach, contact radius, speed and time at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    pub(super) edge: f64,
    pub(super) speed: f64,
    pub(super) time: f64,
    pub(super) approach: f64,
}

impl State {
    const TOUCH: Self = Self { edge: 0.0, speed: 1.0, time: 0.0, approach: 0.0 };

    fn moved(self, rate: Self, by: f64) -> Self {
        Self {
            edge: self.edge + by * rate.edge,
            speed: self.speed + by * rate.speed,
            time: self.time + by * rate.time,
            approach: self.approach + by * rate.approach,
        }
    }
}

/// Which half of the impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Half {
    Compression,
    Rebound,
}

/// The normal motion of one relaxation time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pulse {
    /// The relaxation time.
    pub(super) tau: f64,
}

/// Steps by which the ends of the halves are searched, of length 1.3 over this. The error of e is below 2e-8.
const SEARCH: f64 = 64.0;
/// Rounds of Newton's method on the last step.
const ROUNDS: usize = 8;
/// No half lasts longer in any case: compression lasts about 1.2, rebound less.
const MOST_STEPS: usize = 1 << 16;

impl Pulse {
    /// The normal force.
    pub(super) fn force(&self, half: Half, at: &State) -> f64 {
        let cube = at.edge * at.edge * at.edge;
        match half {
            Half::Compression => cube + 1.5 * self.tau * at.edge * at.speed,
            Half::Rebound => cube,
        }
    }

    fn rate(&self, half: Half, at: &State) -> State {
        let edge = match half {
            Half::Compression => at.speed,
            Half::Rebound => at.speed - self.tau * at.edge * at.edge * at.edge,
        };
        let speed = -2.0 * at.edge * self.force(half, at);
        State { edge, speed, time: 2.0 * at.edge, approach: 2.0 * at.edge * at.speed }
    }

    /// One step of Runge and Kutta's classical method.
    pub(super) fn step(&self, half: Half, from: &State, length: f64) -> State {
        let rate = |at: State| self.rate(half, &at);
        let one = rate(*from);
        let two = rate(from.moved(one, 0.5 * length));
        let three = rate(from.moved(two, 0.5 * length));
        let four = rate(from.moved(three, length));
        let sixth = length / 6.0;
        let next = from.moved(one, sixth).moved(two, 2.0 * sixth);
        next.moved(three, 2.0 * sixth).moved(four, sixth)
    }

    /// The number that vanishes where a half ends, and falls before.
    fn left(half: Half, at: &State) -> f64 {
        match half {
            Half::Compression => at.speed,
            Half::Rebound => at.edge,
        }
    }

    /// The length of a half and the state at its end.
    fn end(&self, half: Half, start: &State) -> (f64, State) {
        let step = 1.3 / SEARCH;
        let mut from = *start;
        let mut whole = 0.0;
        for _ in 0..MOST_STEPS {
            let next = self.step(half, &from, step);
            if Self::left(half, &next) <= 0.0 {
                break;
            }
            from = next;
            whole += step;
        }
        let mut part = 0.0;
        let mut last = from;
        for _ in 0..ROUNDS {
            last = self.step(half, &from, part);
            let falls = Self::left(half, &self.rate(half, &last));
            part -= Self::left(half, &last) / falls;
        }
        (whole + part, last)
    }

    /// The lengths of compression and rebound, and the states at their ends.
    pub(super) fn ends(&self) -> [(f64, State); 2] {
        let (compression, most) = self.end(Half::Compression, &State::TOUCH);
        let turn = State { speed: 0.0, approach: most.edge * most.edge, ..most };
        let (rebound, last) = self.end(Half::Rebound, &turn);
        [(compression, turn), (rebound, last)]
    }

    /// The speed of separation over that of approach.
    pub(super) fn restitution(&self) -> f64 {
        let [_, (_, last)] = self.ends();
        -last.speed
    }

    /// The root of the approach at which an elastic contact has the same pressure in its middle, in compression: tau times
    /// the rate of Hertz's pressure joins it.
    fn pressed(&self, at: &State) -> f64 {
        let viscous = if self.tau > 0.0 { 0.5 * self.tau * at.speed / at.edge } else { 0.0 };
        at.edge + viscous
    }

    /// The greatest force, at a zero of its derivative in compression or at the turn, and the root of the approach at which
    /// an elastic contact has the pressure that is then in the middle.
    pub(super) fn greatest_force(&self, length: f64) -> [f64; 2] {
        let half = Half::Compression;
        let step = length / SEARCH;
        let mut at = State::TOUCH;
        let (mut forces, mut pressed) = ([0.0; 3], [0.0; 3]);
        let mut most = [0.0; 2];
        for _ in 0..=SEARCH as usize {
            forces = [forces[1], forces[2], self.force(half, &at)];
            pressed = [pressed[1], pressed[2], self.pressed(&at)];
            let [one, two, three] = forces;
            let is_peak = two >= one && two >= three && one - 2.0 * two + three < 0.0;
            let peak = if is_peak { peak(forces, pressed) } else { [three, pressed[2]] };
            if peak[0] > most[0] {
                most = peak;
            }
            at = self.step(half, &at, step);
        }
        most
    }
}

// The vertex of a parabola through three equidistant values, and other three values there.
fn peak([one, two, three]: [f64; 3], others: [f64; 3]) -> [f64; 2] {
    let (bend, slope) = (one - 2.0 * two + three, 0.5 * (three - one));
    let at = -slope / bend;
    let other = others[1]
        + at * 0.5 * (others[2] - others[0])
        + 0.5 * at * at * (others[0] - 2.0 * others[1] + others[2]);
    [two + 0.5 * slope * at, other]
}

/// The states at the beginning of contact.
pub(super) const TOUCH: State = State::TOUCH;

/// Relative accuracy to which the relaxation time of a restitution is found.
const ENOUGH: f64 = 1e-12;
/// Rounds of the secant method.
const SECANTS: usize = 40;

/// The relaxation time with which Kelvin-Voigt bodies rebound with this restitution, in (0, 1].
pub(super) fn relaxation_of(restitution: f64) -> f64 {
    let wanted = -libm::log(restitution);
    if wanted <= 0.0 {
        return 0.0;
    }
    // A fit within a few per cent from e = .01 to 1; the slope at e = 1 is that of the published series.
    let guess = wanted / 1.5 / 1.153_449 * (1.0 + wanted * (0.31 + 0.085 * wanted));
    let over = |tau: f64| libm::log(-libm::log(Pulse { tau }.restitution()) / wanted);
    let mut one = (libm::log(guess), over(guess));
    let next = one.0 - one.1;
    let mut two = (next, over(libm::exp(next)));
    for _ in 0..SECANTS {
        if two.1.abs() <= ENOUGH || two.1 == one.1 {
            break;
        }
        let next = two.0 - two.1 * (two.0 - one.0) / (two.1 - one.1);
        (one, two) = (two, (next, over(libm::exp(next))));
    }
    libm::exp(two.0)
}
