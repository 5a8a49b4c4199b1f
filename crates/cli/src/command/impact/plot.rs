//! The picture of the history of an impact, or of a sweep.

use super::view::{Parameter, Record};
use crate::command::plot::{Course, MOST_MARKS, Value};
use crate::command::thinned::{MOST_DRAWN, Thinned};
use crate::output::Picture;
use carom_cases::case::Input;
use carom_impact::HistoryPoint;
use carom_impact::coupled::ImpactMethod;
use carom_laws::friction::Friction;
use carom_plot::Series;
use carom_special::linspace;

/// The palette's grey.
const GREY: usize = 6;
/// Number of instants of a drawn history.
pub(super) const INSTANTS: usize = 401;
/// Number of values of a drawn sweep: of impacts in microseconds, of those by rings (milliseconds), and
/// of those on a grid (tenths of a second).
const VALUES: usize = 361;
const VALUES_BY_RINGS: usize = 121;
const VALUES_ON_A_GRID: usize = 46;

/// Normal force, friction with its limit and the contact against time; displacements and velocities
/// on request.
pub(super) fn course(history: &[HistoryPoint], friction: Friction) -> Picture {
    let course =
        Course { records: history, marked: &[], label: "time / s", at: |point| point.time };
    let mut areas: Vec<(&'static str, Value<HistoryPoint>)> =
        vec![("a, along x", |p| p.semi_axes[0]), ("b, along y", |p| p.semi_axes[1])];
    if history.iter().all(|point| point.stick_radius.is_some()) {
        areas = vec![
            ("contact", |p| p.semi_axes[0]),
            ("stick", |p| p.stick_radius.unwrap_or_default()),
        ];
    }
    let mut panels =
        vec![course.panel("normal force on body 1", "force / N", &[("", |p| p.force.z)])];
    if friction.get() > 0.0 {
        let mut panel = course.panel(
            "friction on body 1",
            "force / N",
            &[("F_x", |p| p.force.x), ("F_y", |p| p.force.y)],
        );
        for (name, f) in friction.coefficient().into_iter().flat_map(|f| [("± f F_z", f), ("", -f)])
        {
            let limit = history.iter().map(|point| (point.time, f * point.force.z));
            panel.add(Series::dotted(name, limit).coloured(GREY));
        }
        panels.push(panel);
    }
    panels.push(course.panel("contact", "radius, semi-axis / m", &areas));
    let rest = [
        course.panel(
            "displacements of body 2 against body 1",
            "displacement / m",
            &[("ξ", |p| p.shift.x), ("η", |p| p.shift.y), ("ζ", |p| p.shift.z)],
        ),
        course.panel(
            "velocities of body 2 against body 1",
            "velocity / m/s",
            &[("v_x", |p| p.velocity.x), ("v_y", |p| p.velocity.y), ("v_z", |p| p.velocity.z)],
        ),
    ];
    Picture::new("History of the impact", panels).with(rest)
}

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

/// A drawn impact: the swept number, R_x, velocity and spin of body 1.
type Point = [f64; 4];

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
        let drawn: [Value<Point>; 3] = [|point| point[1], |point| point[2], |point| point[3]];
        let finite = values.iter().copied().filter(|value| value.is_finite());
        Self {
            values: if is_dense { Vec::new() } else { finite.collect() },
            count: VALUES,
            line: Thinned::new(drawn),
            given: Vec::new(),
            is_dense,
            is_any: false,
        }
    }

    /// Adds impacts of the case.
    pub(super) fn add(&mut self, records: &[Record]) {
        for rebound in records.iter().filter_map(Record::rebound) {
            self.is_any = true;
            self.count = self.count.min(values_of(rebound.method));
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

    /// R_x, velocity and spin of body 1 over the swept number; None if there is no impact.
    pub(super) fn draw(self, input: &Input) -> Option<Picture> {
        if !self.is_any {
            return None;
        }
        let (line, given) = (self.line.records(), self.given);
        let name = Parameter::of(input, 0.0).name;
        let (label, what) = match (name, input.unit) {
            ("angle", _) => ("angle from the normal / °".to_owned(), "the angle of incidence"),
            (name, "") => (name.to_owned(), name),
            (name, unit) => (format!("{name} / {unit}"), name),
        };
        let course = Course { records: &line, marked: &given, label: &label, at: |point| point[0] };
        let panels = [
            course.panel("", "R_x", &[("", |point| point[1])]),
            course.panel("", "v_x of body 1 afterwards / m/s", &[("", |point| point[2])]),
            course.panel("", "spin_y of body 1 afterwards / rad/s", &[("", |point| point[3])]),
        ];
        let marks = match (name, given.len() <= MOST_MARKS) {
            (_, false) => "",
            ("angle", true) => " (dots: the angles given)",
            (_, true) => " (dots: the values given)",
        };
        Some(Picture::new(&format!("Sweep over {what}{marks}"), panels))
    }
}

const fn values_of(method: ImpactMethod) -> usize {
    match method {
        ImpactMethod::Numerical => VALUES_ON_A_GRID,
        ImpactMethod::Rings => VALUES_BY_RINGS,
        _ => VALUES,
    }
}

fn point(record: &Record) -> Option<Point> {
    let [_, [body_1, _]] = record.motions();
    let restitution = record.restitution()?;
    let value = Some(record.parameter?.value).filter(|value| value.is_finite())?;
    Some([value, restitution, body_1.velocity[0], body_1.spin[1]])
}
