//! A row of independent viscous springs that is pressed and shifted: one step of its shift.
//!
//! Spring x touches when the approach reaches s = x^2, free of force, and bears `u + tau u'` per length, u' the rate of
//! the shift while it sticks; where that exceeds the margin `P - s` (times f kappa), P = a^2 or a^2 + tau zeta', it slips.
//! The force over f is (3/2) times the sum over the contact.

/// The row: places of the springs, growing, and their elongations over f kappa.
#[derive(Debug, Clone, Default)]
pub(super) struct Springs {
    place: Vec<f64>,
    elongation: Vec<f64>,
    /// The number of springs in contact.
    touching: usize,
}

/// What the normal motion is in the middle of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Press {
    /// The contact radius.
    pub(super) edge: f64,
    /// P: the margin at x is P - x^2.
    pub(super) depth: f64,
    /// The length of the step in time.
    pub(super) dt: f64,
    /// The relaxation time.
    pub(super) tau: f64,
    /// The force that a spring bears which has just touched, over the rate of the shift: tau, or 0 in rebound.
    pub(super) fresh: f64,
}

/// What a step gives in its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Middle {
    /// The rate of the shift.
    pub(super) rate: f64,
    /// The force over f.
    pub(super) force: f64,
    /// The heat of friction in the step.
    pub(super) heat: f64,
    /// The parts of the contact that stick, from 0 to 1.
    pub(super) sticks: f64,
}

/// Force and its derivative by the rate of the shift.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    force: f64,
    sticking: f64,
}

/// What a spring at one end of a cell would bear if it stuck, and the most that it can.
#[derive(Debug, Clone, Copy)]
struct End {
    place: f64,
    borne: f64,
    margin: f64,
}

impl End {
    /// -1, 0, 1: slips backwards, sticks, slips forwards.
    fn slips(&self) -> i8 {
        i8::from(self.borne > self.margin) - i8::from(self.borne < -self.margin)
    }
}

/// Rounds of Newton's method; it takes two or three.
const ROUNDS: usize = 60;
/// Relative accuracy of the rate.
const ENOUGH: f64 = 1e-13;

impl Springs {
    pub(super) fn with_capacity(count: usize) -> Self {
        let new = || Vec::with_capacity(count);
        Self { place: new(), elongation: new(), touching: 0 }
    }

    /// A spring at the edge touches, free of elongation.
    pub(super) fn touch(&mut self, edge: f64) {
        self.place.push(edge);
        self.elongation.push(0.0);
        self.touching = self.place.len();
    }

    /// Springs beyond the edge have left for good.
    pub(super) fn leave(&mut self, edge: f64) {
        while self.touching > 0 && self.place[self.touching - 1] >= edge {
            self.touching -= 1;
        }
    }

    /// A step of the shift whose rate is `rate` before, and decreases with the force times `chi`.
    pub(super) fn step(&mut self, press: &Press, chi: f64, rate: f64, guess: f64) -> Middle {
        let pull = 0.5 * press.dt * chi;
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut middle = guess;
        let mut sum = Sum::default();
        for _ in 0..ROUNDS {
            sum = self.sum(press, middle);
            let over = middle - rate + pull * sum.force;
            if over > 0.0 {
                high = high.min(middle);
            } else {
                low = low.max(middle);
            }
            let newton = middle - over / (1.0 + pull * sum.sticking);
            let next = match newton > low && newton < high {
                true => newton,
                false if low.is_finite() && high.is_finite() => 0.5 * (low + high),
                false => newton,
            };
            let moved = (next - middle).abs();
            middle = next;
            if moved <= ENOUGH * (middle.abs().max(rate.abs())) {
                break;
            }
        }
        let heat = press.dt * self.slip(press, middle);
        let sticks = match press.edge > 0.0 {
            true => sum.sticking / (1.5 * (0.5 * press.dt + press.tau) * press.edge),
            false => 1.0,
        };
        // By the motion itself, so that the impulse is exact.
        let force = if pull > 0.0 { (rate - middle) / pull } else { sum.force };
        Middle { rate: middle, force, heat, sticks }
    }

    fn end(&self, i: usize, press: &Press, rate: f64) -> End {
        let place = self.place[i];
        let borne = self.elongation[i] + (0.5 * press.dt + press.tau) * rate;
        End { place, borne, margin: press.depth - place * place }
    }

    // What springs at the edge would bear in rebound if they stuck: between the last one in contact and the one that left
    // before, which is moved on as if it stuck.
    fn edge(&self, press: &Press, rate: f64, last: &End) -> f64 {
        let Some(&place) = self.place.get(self.touching) else { return last.borne };
        let left = self.end(self.touching, press, rate);
        let part = (press.edge - last.place) / (place - last.place);
        last.borne + part * (left.borne - last.borne)
    }

    // The force as a function of the rate of the shift: it grows, and is linear as long as no spring begins or ceases to
    // slip. Within a cell the force of springs that stick is taken as linear; that of springs that slip is integrated.
    fn sum(&self, press: &Press, rate: f64) -> Sum {
        let Some(last) = self.touching.checked_sub(1) else { return Sum::default() };
        let mut sum = Sum::default();
        let mut one = self.end(0, press, rate);
        for i in 1..=last {
            let two = self.end(i, press, rate);
            cell(&mut sum, press.depth, &one, &two);
            one = two;
        }
        // To the edge: springs that touched during the step, or those that will leave next.
        let margin = press.depth - press.edge * press.edge;
        let borne =
            if press.fresh > 0.0 { press.fresh * rate } else { self.edge(press, rate, &one) };
        cell(&mut sum, press.depth, &one, &End { place: press.edge, borne, margin });
        let stiff = 0.5 * press.dt + press.tau;
        Sum { force: 1.5 * sum.force, sticking: 1.5 * stiff * sum.sticking }
    }

    // Moves the elongations through the step and returns the power of friction.
    fn slip(&mut self, press: &Press, rate: f64) -> f64 {
        let stiff = 0.5 * press.dt + press.tau;
        let (mut power, mut before) = (0.0, None);
        for i in 0..self.touching {
            let End { place, borne, margin } = self.end(i, press, rate);
            let margin = margin.max(0.0);
            let force = borne.clamp(-margin, margin);
            let own = if force == borne { rate } else { (force - self.elongation[i]) / stiff };
            self.elongation[i] += press.dt * own;
            let lost = force * (rate - own);
            if let Some((at, earlier)) = before {
                power += 0.5 * (place - at) * (lost + earlier);
            }
            before = Some((place, lost));
        }
        if let Some(left) = self.elongation.get_mut(self.touching) {
            *left += press.dt * rate;
        }
        if let Some((at, earlier)) = before {
            // Springs that touched during the step slip at the speed of the margin at most.
            let margin = press.depth - press.edge * press.edge;
            let force = (press.fresh * rate).clamp(-margin, margin);
            let own = if press.fresh > 0.0 { force / press.fresh } else { rate };
            power += 0.5 * (press.edge - at) * (force * (rate - own) + earlier);
        }
        1.5 * power
    }
}

/// The integral of the margin between two places.
fn margin_between(depth: f64, [one, two]: [f64; 2]) -> f64 {
    (two - one) * (depth - (one * one + one * two + two * two) / 3.0)
}

/// Adds a cell between two springs.
fn cell(sum: &mut Sum, depth: f64, one: &End, two: &End) {
    let (from, to) = (one.slips(), two.slips());
    let length = two.place - one.place;
    if from == to {
        if from == 0 {
            sum.force += 0.5 * length * (one.borne + two.borne);
            sum.sticking += length;
        } else {
            sum.force += f64::from(from) * margin_between(depth, [one.place, two.place]);
        }
        return;
    }
    if from != 0 && to != 0 {
        // From slip in one direction to slip in the other within a cell.
        sum.force += 0.5 * length * (f64::from(from) * one.margin + f64::from(to) * two.margin);
        return;
    }
    let sign = f64::from(from + to);
    let [over_one, over_two] = [one, two].map(|end| sign * end.borne - end.margin);
    let part = over_one / (over_one - over_two);
    let place = one.place + part * length;
    let borne = one.borne + part * (two.borne - one.borne);
    if from == 0 {
        sum.force += 0.5 * part * length * (one.borne + borne);
        sum.force += sign * margin_between(depth, [place, two.place]);
        sum.sticking += part * length;
    } else {
        sum.force += sign * margin_between(depth, [one.place, place]);
        sum.force += 0.5 * (1.0 - part) * length * (borne + two.borne);
        sum.sticking += (1.0 - part) * length;
    }
}
