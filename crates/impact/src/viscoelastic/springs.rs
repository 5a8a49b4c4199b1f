//! A row of independent viscous springs that is pressed and shifted: one step of its shift.
//!
//! Spring x touches when the approach reaches s = x^2, free of force, and bears `u + tau u'` per length, u' the rate of
//! the shift while it sticks; where that exceeds the margin `P - s` (times f kappa), P = a^2 or a^2 + tau zeta', it slips.
//! The force over f is (3/2) times the sum over the contact.

/// The row: places of the springs, growing, and their elongations over f kappa.
#[derive(Debug, Clone, Default)]
pub(super) struct Springs {
    springs: Vec<Spring>,
    /// The number of springs in contact.
    touching: usize,
}

/// A spring: its place, the square of it, and its elongation.
#[derive(Debug, Clone, Copy)]
struct Spring {
    place: f64,
    square: f64,
    elongation: f64,
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

impl Press {
    /// What a spring that sticks bears beyond its elongation, over the rate of the shift.
    fn stiff(&self) -> f64 {
        0.5 * self.dt + self.tau
    }
}

impl Spring {
    #[inline(always)]
    fn end(&self, depth: f64, add: f64) -> End {
        End { place: self.place, borne: self.elongation + add, margin: depth - self.square }
    }
}

impl End {
    fn sticks(&self) -> bool {
        self.borne.abs() <= self.margin
    }

    /// -1, 0, 1: slips backwards, sticks, slips forwards.
    fn slips(&self) -> i8 {
        i8::from(self.borne > self.margin) - i8::from(self.borne < -self.margin)
    }
}

/// Rounds of Newton's method; it takes two or three.
const ROUNDS: usize = 60;
/// Relative accuracy of the rate.
const ENOUGH: f64 = 1e-12;

impl Springs {
    pub(super) fn with_capacity(count: usize) -> Self {
        Self { springs: Vec::with_capacity(count), touching: 0 }
    }

    /// A spring at the edge touches, free of elongation.
    pub(super) fn touch(&mut self, edge: f64) {
        self.springs.push(Spring { place: edge, square: edge * edge, elongation: 0.0 });
        self.touching = self.springs.len();
    }

    /// Springs beyond the edge have left for good.
    pub(super) fn leave(&mut self, edge: f64) {
        let touching = &self.springs[..self.touching];
        self.touching -= touching.iter().rev().take_while(|spring| spring.place >= edge).count();
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
            if (newton - middle).abs() <= ENOUGH * middle.abs().max(rate.abs()) {
                middle = newton;
                break;
            }
            let is_between = newton > low && newton < high;
            let halves = low.is_finite() && high.is_finite() && !is_between;
            middle = if halves { 0.5 * (low + high) } else { newton };
        }
        let heat = press.dt * self.slip(press, middle);
        let sticks = match press.edge > 0.0 {
            true => sum.sticking / (1.5 * press.stiff() * press.edge),
            false => 1.0,
        };
        // By the motion itself, so that the impulse is exact.
        let force = if pull > 0.0 { (rate - middle) / pull } else { sum.force };
        Middle { rate: middle, force, heat, sticks }
    }

    // What springs at the edge would bear in rebound if they stuck: between the last one in contact and the one that left
    // before, which is moved on as if it stuck.
    fn edge(&self, press: &Press, rate: f64, last: &End) -> f64 {
        let Some(left) = self.springs.get(self.touching) else { return last.borne };
        let left = left.end(press.depth, press.stiff() * rate);
        let part = (press.edge - last.place) / (left.place - last.place);
        last.borne + part * (left.borne - last.borne)
    }

    // The force as a function of the rate of the shift: it grows, and is linear as long as no spring begins or ceases to
    // slip. Within a cell the force of springs that stick is taken as linear; that of springs that slip is integrated.
    fn sum(&self, press: &Press, rate: f64) -> Sum {
        let add = press.stiff() * rate;
        let Some((first, rest)) = self.springs[..self.touching].split_first() else {
            return Sum::default();
        };
        let mut sum = Sum::default();
        let mut one = first.end(press.depth, add);
        let mut one_sticks = one.sticks();
        // Cells that stick as a whole are summed apart, without their factor 1/2.
        let (mut doubled, mut sticking) = (0.0, 0.0);
        for spring in rest {
            let two = spring.end(press.depth, add);
            let two_sticks = two.sticks();
            if one_sticks & two_sticks {
                let length = two.place - one.place;
                doubled += length * (one.borne + two.borne);
                sticking += length;
            } else {
                cell(&mut sum, press.depth, &one, &two);
            }
            (one, one_sticks) = (two, two_sticks);
        }
        sum.force += 0.5 * doubled;
        sum.sticking += sticking;
        // To the edge: springs that touched during the step, or those that will leave next.
        let margin = press.depth - press.edge * press.edge;
        let borne =
            if press.fresh > 0.0 { press.fresh * rate } else { self.edge(press, rate, &one) };
        cell(&mut sum, press.depth, &one, &End { place: press.edge, borne, margin });
        Sum { force: 1.5 * sum.force, sticking: 1.5 * press.stiff() * sum.sticking }
    }

    // Moves the elongations through the step and returns the power of friction.
    fn slip(&mut self, press: &Press, rate: f64) -> f64 {
        let stiff = press.stiff();
        let (mut power, mut before) = (0.0, None);
        for spring in &mut self.springs[..self.touching] {
            let End { place, borne, margin } = spring.end(press.depth, stiff * rate);
            let margin = margin.max(0.0);
            let force = borne.clamp(-margin, margin);
            let own = if force == borne { rate } else { (force - spring.elongation) / stiff };
            spring.elongation += press.dt * own;
            let lost = force * (rate - own);
            if let Some((at, earlier)) = before {
                power += 0.5 * (place - at) * (lost + earlier);
            }
            before = Some((place, lost));
        }
        if let Some(left) = self.springs.get_mut(self.touching) {
            left.elongation += press.dt * rate;
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
