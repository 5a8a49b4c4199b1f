//! Impact of bodies with any relaxation of stress, as a row of springs stepped in time.
//!
//! Each spring bears `f(t) = int E(t - q) zeta'(q) dq` since it touched, and along the surface the same with the rate of
//! the shift, at most f times that. E is a sum of exponentials, so that a step of constant rates is exact in the springs:
//! each term falls by `exp(-dt/tau)`. A spring leaves for good where its force along the normal vanishes (Ting 1966).
//!
//! Units as in the module above, with K that of the modulus E(0) of Maxwell's material and of E(1) of the other.

use std::sync::{Mutex, PoisonError};

use carom_special::gamma::gamma;
use carom_special::roots::{self, Bracket};

use super::run::{Instant, Run};
use super::{Found, NormalRebound, Rheology};

/// Decay times on each side of the unit of time, in decades, and their distance.
const DECADES: f64 = 5.0;
const PER_DECADE: f64 = 2.0;
/// The duration of a free impact in this unit, which is cut into `steps`.
const DURATION: f64 = 3.2;
/// Springs in the unit of length over steps in the duration.
const SPRINGS_PER_STEP: f64 = 0.64;
/// No impact lasts longer than this many times a free one.
const PATIENCE: usize = 64;

/// A modulus over time: terms E exp(-s t).
#[derive(Debug, Clone)]
pub(super) struct Relaxation {
    terms: Vec<[f64; 2]>,
}

impl Relaxation {
    /// By the parameter of a material.
    pub(super) fn of(rheology: Rheology, parameter: f64) -> Self {
        match rheology {
            Rheology::ConstantLossTangent => Self::power(parameter),
            Rheology::StandardSolid { relaxed } => Self::solid(relaxed, parameter),
            Rheology::Maxwell | Rheology::KelvinVoigt => Self::maxwell(parameter),
        }
    }

    /// One that keeps its stress.
    fn elastic() -> Self {
        Self { terms: vec![[1.0, 0.0]] }
    }

    /// One that relaxes to 1, the share `relaxed` of its modulus, in this time.
    fn solid(relaxed: f64, time: f64) -> Self {
        Self { terms: vec![[1.0, 0.0], [1.0 / relaxed - 1.0, 1.0 / time]] }
    }

    /// One decay, with this time.
    fn maxwell(time: f64) -> Self {
        Self { terms: vec![[1.0, 1.0 / time]] }
    }

    /// t^(-alpha), whose loss tangent tan(alpha pi/2) does not depend on frequency:
    /// `t^(-alpha) = int s^(alpha - 1) exp(-s t) ds/Gamma(alpha)`, by sums over the logarithm of s.
    fn power(alpha: f64) -> Self {
        let step = std::f64::consts::LN_10 / PER_DECADE;
        let count = (2.0 * DECADES * PER_DECADE) as i32;
        let term = |i: i32| {
            let s = libm::exp(step * f64::from(i - count / 2));
            [libm::pow(s, alpha) * step / gamma(alpha), s]
        };
        // What decays slower than all these terms hardly decays at all in an impact.
        let rest = libm::pow(term(0)[1] * libm::exp(-0.5 * step), alpha) / gamma(1.0 + alpha);
        let mut terms: Vec<[f64; 2]> = (0..=count).map(term).collect();
        terms.push([rest, 0.0]);
        Self { terms }
    }

    /// The greatest modulus of a solid over what is left of it, from 10: its force rises the more steeply at the edge.
    fn stiffness(&self) -> f64 {
        match self.terms[..] {
            [[rest, 0.0], [more, _]] => (0.1 * (rest + more) / rest).max(1.0),
            _ => 1.0,
        }
    }

    /// What remains of each term after a time, and what a rate of 1 adds to it.
    fn step(&self, time: f64, out: &mut Vec<[f64; 2]>) {
        out.clear();
        out.extend(self.terms.iter().map(|&[modulus, s]| {
            let lost = -libm::expm1(-s * time);
            [1.0 - lost, if s * time > 1e-12 { modulus * lost / s } else { modulus * time }]
        }));
    }
}

/// The normal motion and the rate of the shift after it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ended {
    pub(super) run: Run,
    /// The speed of separation over that of approach.
    pub(super) restitution: f64,
    pub(super) duration: f64,
    pub(super) maximal_approach: f64,
    /// The greatest force, and the root of the approach at which an elastic contact has the pressure that is then in the
    /// middle.
    pub(super) strongest: [f64; 2],
}

impl From<Ended> for NormalRebound {
    fn from(ended: Ended) -> Self {
        Self::new([ended.duration, ended.maximal_approach], ended.strongest)
    }
}

/// Steps of the normal motion by which a parameter is searched; the error of e is below 2e-5 after extrapolation.
const SEARCH: usize = 200;
/// The least and the greatest parameters.
const TIMES: [f64; 2] = [0.2, 1e8];
const EXPONENTS: [f64; 2] = [1e-9, 0.9];
/// Those of a standard solid, and one that relaxes faster than where it loses most.
const TIMES_OF_SOLIDS: [f64; 2] = [1e-6, 1e3];
const SLOW: f64 = 1e-3;
/// To which the search takes the logarithm of a time, and an exponent.
const CLOSE: f64 = 1e-7;

/// Halvings of the interval in which a standard solid loses most.
const HALVINGS: usize = 24;

/// What was found last: the impacts of a sweep have one material, and the search takes longer than such an impact.
static LAST: Mutex<(Rheology, f64, Option<f64>)> =
    Mutex::new((Rheology::KelvinVoigt, f64::NAN, None));

/// The decay time, or the exponent of a constant loss tangent, with this restitution; None if every one loses less.
pub(super) fn parameter_of(rheology: Rheology, restitution: f64) -> Option<f64> {
    let last = || LAST.lock().unwrap_or_else(PoisonError::into_inner);
    let (of, at, found) = *last();
    if (of, at) == (rheology, restitution) {
        return found;
    }
    let found = searched(rheology, restitution);
    *last() = (rheology, restitution, found);
    found
}

fn searched(rheology: Rheology, restitution: f64) -> Option<f64> {
    let of = |at: f64| match rheology {
        Rheology::ConstantLossTangent => at,
        _ => libm::exp(at),
    };
    // Steps alone miss some of an elastic rebound, too: what is sought is less than that where little is lost.
    let missed = 1.0 - normal(&Relaxation::elastic()).restitution;
    let left = |at: f64| normal(&Relaxation::of(rheology, of(at))).restitution + missed;
    let [low, high] = match rheology {
        Rheology::ConstantLossTangent => EXPONENTS,
        Rheology::StandardSolid { .. } => {
            let [low, high] = TIMES_OF_SOLIDS.map(libm::log);
            [low, lowest(left, [libm::log(SLOW), high])]
        }
        Rheology::Maxwell | Rheology::KelvinVoigt => TIMES.map(libm::log),
    };
    let stiffest = if rheology == Rheology::Maxwell { high } else { low };
    if restitution >= left(stiffest) {
        return Some(of(stiffest));
    }
    let bracket = Bracket::new(low, high).ok()?;
    let root = roots::brent(|at| left(at) - restitution, bracket, CLOSE).ok()?;
    Some(of(root.position))
}

/// Where a function with one minimum is lowest, by thirds.
fn lowest(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..HALVINGS {
        let third = (high - low) / 3.0;
        if of(low + third) < of(high - third) { high -= third } else { low += third }
    }
    0.5 * (low + high)
}

/// The normal motion alone.
pub(super) fn normal(relaxation: &Relaxation) -> Ended {
    let [coarse, fine] =
        [SEARCH / 2, SEARCH].map(|steps| follow(relaxation, [0.0; 2], steps, |_| ()));
    let restitution = fine.restitution + (fine.restitution - coarse.restitution) / 3.0;
    Ended { restitution, ..fine }
}

/// Steps of the first run and of the finest.
const FIRST: usize = 50;
const MOST: usize = 800;
/// The estimated error over the last change of R_x, and over the square of the step where two runs agree by chance.
const SHARE: f64 = 0.6;
const USUAL: f64 = 7.0;

/// Runs with doubled steps, extrapolated, until the estimate of R_x meets the tolerance.
pub(super) fn refined(relaxation: &Relaxation, groups: [f64; 2], tolerance: f64) -> (Found, Ended) {
    let run = |steps| follow(relaxation, groups, steps, |_| ());
    let [_, psi] = groups;
    let mut steps = FIRST;
    let mut coarse = run(steps);
    loop {
        steps *= 2;
        let fine = run(steps);
        let change = (fine.run.rate - coarse.run.rate) / 3.0;
        let usual = USUAL * relaxation.stiffness() / (steps * steps) as f64;
        let found = Found {
            restitution: (-(fine.run.rate + change) / psi).clamp(-1.0, 1.0),
            heat: (fine.run.heat + (fine.run.heat - coarse.run.heat) / 3.0).max(0.0),
            error: (SHARE * change.abs() / psi).max(usual),
            steps,
        };
        if found.error <= tolerance || 2 * steps > MOST {
            return (found, fine);
        }
        coarse = fine;
    }
}

/// The springs: by terms, what each bears along the normal and along the surface.
struct Row {
    spacing: f64,
    normal: Vec<Vec<f64>>,
    along: Vec<Vec<f64>>,
    /// Sums over the terms.
    forces: Vec<[f64; 2]>,
    /// Those within the contact: what lies beyond has left.
    touching: usize,
    /// Working memory: the same sums in a step, and then the rates of the springs in place of the second.
    sums: [Vec<f64>; 2],
}

/// What a step does to the springs.
struct Push<'a> {
    /// By terms, as [`Relaxation::step`] gives them.
    decay: &'a [[f64; 2]],
    speed: f64,
    rate: f64,
    dt: f64,
}

/// Forces of the row.
#[derive(Default)]
struct Total {
    normal: f64,
    along: f64,
}

impl Row {
    fn new(terms: usize, spacing: f64) -> Self {
        let [normal, along] = [(); 2].map(|()| vec![Vec::new(); terms]);
        Self { spacing, normal, along, forces: Vec::new(), touching: 0, sums: Default::default() }
    }

    fn place(&self, spring: usize) -> f64 {
        spring as f64 * self.spacing
    }

    /// Adds the springs that touched in the last step, which ended at this approach.
    fn touch(&mut self, approach: f64, relaxation: &Relaxation, push: &Push<'_>) -> f64 {
        let mut power = 0.0;
        let mut since = Vec::with_capacity(self.normal.len());
        while self.touching == self.forces.len() {
            let place = self.place(self.forces.len());
            let depth = approach - place * place;
            if depth <= 0.0 {
                break;
            }
            relaxation.step(depth / push.speed, &mut since);
            let stiff: f64 = since.iter().map(|[_, gain]| gain).sum();
            let bound = stiff * push.speed;
            let force = (stiff * push.rate).clamp(-bound, bound);
            let own = force / stiff;
            let terms = self.normal.iter_mut().zip(&mut self.along);
            for ((normal, along), [_, gain]) in terms.zip(&since) {
                normal.push(gain * push.speed);
                along.push(gain * own);
            }
            self.forces.push([bound, force]);
            power += force * (push.rate - own) * self.spacing * depth / (push.speed * push.dt);
            self.touching += 1;
        }
        power
    }

    /// Moves the springs that touched before this step; returns the power of friction and the radius that sticks.
    fn push(&mut self, push: &Push<'_>) -> (f64, f64) {
        let stiff: f64 = push.decay.iter().map(|[_, gain]| gain).sum();
        let (mut power, mut sticks) = (0.0, 0.0);
        // The first one that has left tells where the edge is; others are not asked again.
        let count = self.forces.len().min(self.touching + 1);
        let [pressed, held] = &mut self.sums;
        for sums in [&mut *pressed, &mut *held] {
            sums.clear();
            sums.resize(count, 0.0);
        }
        let terms = self.normal.iter_mut().zip(&mut self.along).zip(push.decay);
        for ((normal, along), [kept, gain]) in terms {
            let springs = normal[..count].iter_mut().zip(&mut along[..count]);
            for ((h, q), (f, left)) in springs.zip(pressed.iter_mut().zip(held.iter_mut())) {
                *h = *h * kept + gain * push.speed;
                *q *= kept;
                *f += *h;
                *left += *q;
            }
        }
        for (i, (&f, held)) in pressed.iter().zip(held.iter_mut()).enumerate() {
            let bound = f.max(0.0);
            let (left, trial) = (*held, *held + stiff * push.rate);
            let force = trial.clamp(-bound, bound);
            let own = if force == trial { push.rate } else { (force - left) / stiff };
            *held = own;
            self.forces[i] = [f, force];
            if f > 0.0 && i < self.touching {
                let width = if i == 0 { 0.5 * self.spacing } else { self.spacing };
                power += force * (push.rate - own) * width;
                sticks += if force == trial { width } else { 0.0 };
            }
        }
        for (along, [_, gain]) in self.along.iter_mut().zip(push.decay) {
            along.iter_mut().zip(&*held).for_each(|(q, own)| *q += gain * own);
        }
        while self.touching > 0 && self.forces[self.touching - 1][0] <= 0.0 {
            self.touching -= 1;
        }
        (power, sticks)
    }

    /// The forces, linear between springs; `edge` is where the contact ends while it grows.
    fn total(&self, edge: Option<f64>) -> Total {
        let mut total = Total::default();
        let Some(last) = self.touching.checked_sub(1) else { return total };
        for (i, [f, g]) in self.forces[..self.touching].iter().enumerate() {
            let width = match (i == 0, i == last) {
                (true, true) => 0.0,
                (true, false) | (false, true) => 0.5 * self.spacing,
                (false, false) => self.spacing,
            };
            total.normal += width * f;
            total.along += width * g;
        }
        let [f, g] = self.forces[last];
        let beyond = self.beyond(last, edge);
        total.normal += 0.5 * beyond * f;
        total.along += 0.5 * beyond * g;
        total.normal *= 1.5;
        total.along *= 1.5;
        total
    }

    /// How far the contact reaches beyond its last spring.
    fn beyond(&self, last: usize, edge: Option<f64>) -> f64 {
        let [f, _] = self.forces[last];
        match (edge, self.forces.get(self.touching)) {
            (Some(edge), None) => edge - self.place(last),
            (_, Some([next, _])) => self.spacing * f / (f - next.min(0.0)),
            (None, None) => 0.0,
        }
    }

    /// The root of the approach at which an elastic contact has the same pressure in its middle, `-(1/2) int f'(x)/x dx` by
    /// Abel's transform.
    fn pressed(&self, edge: Option<f64>) -> f64 {
        let Some(last) = self.touching.checked_sub(1) else { return 0.0 };
        let between = |i: usize| {
            let fall = self.forces[i][0] - self.forces[i + 1][0];
            fall / (self.place(i) + 0.5 * self.spacing)
        };
        let ends = self.forces[last][0] / (self.place(last) + 0.5 * self.beyond(last, edge));
        0.5 * ((0..last).map(between).sum::<f64>() + ends)
    }
}

/// One impact with so many steps in the duration of a free one. `psi = 0` follows the normal motion alone.
pub(super) fn follow(
    relaxation: &Relaxation,
    [chi, psi]: [f64; 2],
    steps: usize,
    mut observe: impl FnMut(Instant),
) -> Ended {
    let dt = DURATION / steps as f64;
    let spacing = 1.0 / (SPRINGS_PER_STEP * steps as f64);
    let mut row = Row::new(relaxation.terms.len(), spacing);
    let mut decay = Vec::new();
    relaxation.step(dt, &mut decay);
    let (mut approach, mut shift, mut speed, mut rate) = (0.0, 0.0, 1.0, psi);
    let mut ended = Ended {
        run: Run { rate: psi, heat: 0.0 },
        restitution: 0.0,
        duration: 0.0,
        maximal_approach: 0.0,
        strongest: [0.0; 2],
    };
    for number in 1..=PATIENCE * steps {
        approach += dt * speed;
        shift += dt * rate;
        let push = Push { decay: &decay, speed, rate, dt };
        let (mut power, sticks) = row.push(&push);
        let grows = speed > 0.0;
        if grows {
            power += row.touch(approach, relaxation, &push);
        }
        let edge = grows.then(|| approach.sqrt());
        let total = row.total(edge);
        ended.run.heat += 1.5 * power * dt;
        ended.duration = number as f64 * dt;
        ended.maximal_approach = ended.maximal_approach.max(approach);
        if total.normal > ended.strongest[0] {
            ended.strongest = [total.normal, row.pressed(edge)];
        }
        let (half, drag) = (0.5 * dt * total.normal, 0.5 * dt * chi * total.along);
        observe(Instant {
            time: ended.duration,
            approach,
            speed: speed - half,
            normal_force: total.normal,
            shift,
            rate: rate - drag,
            force: total.along,
            sticks: if row.touching > 0 {
                (sticks / row.place(row.touching)).min(1.0)
            } else {
                0.0
            },
        });
        if !grows && total.normal <= 0.0 {
            break;
        }
        speed -= 2.0 * half;
        rate -= 2.0 * drag;
    }
    ended.run.rate = rate;
    ended.restitution = -speed;
    ended
}
