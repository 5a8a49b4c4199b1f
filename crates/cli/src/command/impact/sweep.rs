//! The picture of a sweep: what varies with the swept number.

use super::view::{Parameter, Record};
use crate::command::plot::{Course, MOST_MARKS, Value};
use crate::command::thinned::{MOST_DRAWN, Thinned};
use crate::output::Picture;
use carom_cases::case::Input;
use carom_impact::Rebound;
use carom_impact::coupled::ImpactMethod;
use carom_plot::Panel;
use carom_special::linspace;

/// Number of values of a drawn sweep: of impacts in microseconds, of those in milliseconds (by rings, by springs), and
/// of those on a grid (tenths of a second).
const VALUES: usize = 361;
const VALUES_IN_STEPS: usize = 121;
const VALUES_ON_A_GRID: usize = 46;
/// Number of quantities that are shown if nothing else is asked for.
const MAIN: usize = 3;
/// A velocity below this part of that of the impact is round-off.
const ROUND_OFF: f64 = 1e-12;
/// A quantity that varies by less than this part is constant.
const CONSTANT: f64 = 1e-9;

/// A drawn impact.
#[derive(Debug, Clone, Copy)]
struct Point {
    /// The swept number.
    at: f64,
    /// R_x; NaN where it has no value.
    r_x: f64,
    /// Normal velocity of the contact points afterwards over that before, reversed.
    restitution: f64,
    /// Velocity of body 1 afterwards.
    velocity: [f64; 3],
    /// Spin of body 1 afterwards.
    spin: [f64; 3],
    maximal_force: f64,
    duration: f64,
    dissipated: f64,
    lost: f64,
    /// Whether the contact points move tangentially before.
    is_oblique: bool,
}

/// The label of its axis, and the value.
type Quantity = (&'static str, Value<Point>);

const R_X: &str = "R_x";

/// What a sweep can show, the most important first.
const QUANTITIES: [Quantity; 12] = [
    (R_X, |point| point.r_x),
    ("v_x of body 1 afterwards / m/s", |point| point.velocity[0]),
    ("spin_y of body 1 afterwards / rad/s", |point| point.spin[1]),
    ("normal restitution", |point| point.restitution),
    ("v_z of body 1 afterwards / m/s", |point| point.velocity[2]),
    ("v_y of body 1 afterwards / m/s", |point| point.velocity[1]),
    ("spin_x of body 1 afterwards / rad/s", |point| point.spin[0]),
    ("spin_z of body 1 afterwards / rad/s", |point| point.spin[2]),
    ("energy lost in the material / J", |point| point.lost),
    ("energy dissipated by friction / J", |point| point.dissipated),
    ("greatest force / N", |point| point.maximal_force),
    ("duration / s", |point| point.duration),
];

/// These values, and this number of values from the smallest to the largest; none if these are equal.
fn between(values: &[f64], count: usize) -> Vec<f64> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if low >= high {
        return Vec::new();
    }
    let mut all = [values, &linspace(low, high, count)].concat();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// The picture of a sweep, collected impact by impact.
pub(super) struct Sweep {
    /// The finite values of the case; none if they are many and in order.
    values: Vec<f64>,
    /// Number of values at which the lines are computed.
    count: usize,
    /// Points of the lines.
    line: Thinned<Point>,
    /// Points of the case, only as many as are needed to decide whether they can be marked.
    given: Vec<Point>,
    /// Whether the lines use the points of the case only.
    is_dense: bool,
    is_any: bool,
}

impl Sweep {
    /// A picture over these values, before the first impact.
    pub(super) fn new(values: &[f64]) -> Self {
        let is_dense = values.len() > MOST_DRAWN / 2
            && (values.is_sorted() || values.iter().rev().is_sorted());
        let finite = values.iter().copied().filter(|value| value.is_finite());
        Self {
            values: if is_dense { Vec::new() } else { finite.collect() },
            count: VALUES,
            line: Thinned::new(QUANTITIES.map(|(_, of)| of)),
            given: Vec::new(),
            is_dense,
            is_any: false,
        }
    }

    /// Adds impacts of the case.
    pub(super) fn add(&mut self, records: &[Record]) {
        for rebound in records.iter().filter_map(Record::rebound) {
            self.is_any = true;
            self.count = self.count.min(values_of(rebound));
        }
        for point in records.iter().filter_map(point) {
            if self.given.len() <= MOST_MARKS {
                self.given.push(point);
            }
            if self.is_dense {
                self.line.push(point);
            }
        }
    }

    /// The values whose impacts are still needed for the lines: fewer where an impact of the case takes
    /// long.
    pub(super) fn between(&self) -> Vec<f64> {
        if self.is_any { between(&self.values, self.count) } else { Vec::new() }
    }

    /// Adds impacts at these values.
    pub(super) fn add_between(&mut self, records: &[Record]) {
        records.iter().filter_map(point).for_each(|point| self.line.push(point));
    }

    /// The quantities that vary over the swept number, and the others on request; None if there is no
    /// impact.
    pub(super) fn draw(self, input: &Input) -> Option<Picture> {
        if !self.is_any {
            return None;
        }
        let (line, given) = (self.line.records(), self.given);
        let name = Parameter::of(input, 0.0).name;
        // In a picture a low line begins a subscript.
        let field = name.replace('_', " ");
        let (label, what) = match (name, input.unit) {
            ("angle", _) => ("angle from the normal / °".to_owned(), "the angle of incidence"),
            (_, "") => (field.clone(), field.as_str()),
            (_, unit) => (format!("{field} / {unit}"), field.as_str()),
        };
        let marks = match (name, given.len() <= MOST_MARKS) {
            (_, false) => "",
            ("angle", true) => " (dots: the angles given)",
            (_, true) => " (dots: the values given)",
        };
        let all = [line.as_slice(), &given].concat();
        let there = QUANTITIES.iter().filter(|(_, of)| all.iter().any(|p| of(p).is_finite()));
        let (varying, others): (Vec<_>, Vec<_>) =
            there.map(|(axis, of)| (*axis, *of)).partition(|quantity| varies(&all, *quantity));
        let count = if varying.is_empty() { MAIN } else { varying.len().min(MAIN) };
        let panels: Vec<Panel> = varying
            .into_iter()
            .chain(others)
            .map(|quantity| over([&line, &given], &label, quantity))
            .collect();
        let (main, rest) = panels.split_at(count.min(panels.len()));
        Some(Picture::new(&format!("Sweep over {what}{marks}"), main).with(rest))
    }
}

/// A panel of one quantity over the swept number, where it has a value.
fn over([line, given]: [&[Point]; 2], label: &str, (axis, of): Quantity) -> Panel {
    let finite = |points: &[Point]| -> Vec<Point> {
        points.iter().copied().filter(|point| of(point).is_finite()).collect()
    };
    let (line, given) = (finite(line), finite(given));
    let course = Course { records: &line, marked: &given, label, at: |point| point.at };
    course.panel("", axis, &[("", of)])
}

/// Whether a quantity tells the impacts apart. R_x does not if they are all head-on: it is then a limit.
fn varies(points: &[Point], (axis, of): Quantity) -> bool {
    let values = || points.iter().map(of).filter(|value| value.is_finite());
    let (low, high) =
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let is_limit = axis == R_X && !points.iter().any(|p| p.is_oblique);
    high - low > CONSTANT * high.abs().max(low.abs()) && !is_limit
}

fn values_of(rebound: &Rebound) -> usize {
    match rebound.method {
        ImpactMethod::Numerical => VALUES_ON_A_GRID,
        ImpactMethod::Rings | ImpactMethod::Spatial { .. } => VALUES_IN_STEPS,
        _ if rebound.energy.lost > 0.0 => VALUES_IN_STEPS,
        _ => VALUES,
    }
}

/// The drawn impact of a record; none without an impact, or at infinity.
fn point(record: &Record) -> Option<Point> {
    let rebound = record.rebound()?;
    let collision = record.collision();
    let normal = collision.frame().z();
    let (before, after) = (rebound.contact_velocity_before, rebound.contact_velocity_after);
    let along = before.dot(&normal);
    let (speed, arm) = (before.norm(), collision.levers()[0].arm().norm());
    let without = |value: f64, round_off: f64| if value.abs() < round_off { 0.0 } else { value };
    let [_, [body_1, _]] = record.motions();
    Some(Point {
        at: Some(record.parameter?.value).filter(|value| value.is_finite())?,
        r_x: rebound.r_x.unwrap_or(f64::NAN),
        restitution: -after.dot(&normal) / along,
        velocity: <[f64; 3]>::from(body_1.velocity).map(|v| without(v, ROUND_OFF * speed)),
        spin: <[f64; 3]>::from(body_1.spin).map(|s| without(s, ROUND_OFF * speed / arm)),
        maximal_force: rebound.maximal_force,
        duration: rebound.duration,
        dissipated: without(rebound.energy.dissipated, ROUND_OFF * rebound.energy.before),
        lost: without(rebound.energy.lost, ROUND_OFF * rebound.energy.before),
        is_oblique: (before - along * normal).norm() > ROUND_OFF * speed,
    })
}
