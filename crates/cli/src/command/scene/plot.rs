//! Walls, path and bounces as a picture, projected along the axis with the smallest motion.

use crate::command::plot::Value;
use crate::command::thinned::Thinned;
use crate::error::CliError;
use crate::output::Picture;
use carom_cases::case::SceneCase;
use carom_impact::scene::{Leg, Wall};
use carom_plot::{Axis, Marker, Panel, Series};
use std::f64::consts::TAU;

/// Number of instants drawn of each flight.
const INSTANTS: usize = 41;
/// Largest number of balls drawn; more would hide the path.
const MOST_BALLS: usize = 12;
/// The size of a number beside a bounce, as a part of the picture's width and height.
const NUMBER: [f64; 2] = [0.05, 0.055];
/// The palette's dark grey.
const DARK: usize = 6;
/// Width over height of the axes.
const ASPECT: f64 = 1.42;
const AXES: [&str; 3] = ["x / m", "y / m", "z / m"];

/// The two axes of the picture and its limits.
struct View {
    axes: [usize; 2],
    low: [f64; 2],
    high: [f64; 2],
}

impl View {
    /// The bounces that have their numbers, from 1: those far enough from the ones before.
    fn numbered(&self, places: &[(f64, f64)]) -> Vec<(usize, (f64, f64))> {
        let size = [0, 1].map(|axis| self.high[axis] - self.low[axis]);
        // Both axes have the same unit.
        let unit = size[0].max(size[1] * ASPECT);
        let room = [NUMBER[0] * unit, NUMBER[1] * unit / ASPECT];
        let mut numbered: Vec<(usize, (f64, f64))> = Vec::new();
        for (i, place) in places.iter().enumerate() {
            let is_clear = |(_, other): &(usize, (f64, f64))| {
                (place.0 - other.0).abs() > room[0] || (place.1 - other.1).abs() > room[1]
            };
            if numbered.iter().all(is_clear) {
                numbered.push((i + 1, *place));
            }
        }
        numbered
    }
}

/// The drawn parts of a path, collected leg by leg.
pub(super) struct Course<'a> {
    case: &'a SceneCase,
    centres: Thinned<[f64; 3]>,
    /// Centres of the balls that are drawn.
    balls: Vec<[f64; 3]>,
    contacts: Thinned<[f64; 3]>,
}

impl<'a> Course<'a> {
    /// The picture before the first leg.
    pub(super) fn new(case: &'a SceneCase) -> Self {
        let places: [Value<[f64; 3]>; 3] = [|place| place[0], |place| place[1], |place| place[2]];
        let balls = vec![case.ball.position().into()];
        Self { case, centres: Thinned::new(places), balls, contacts: Thinned::new(places) }
    }

    /// Adds a leg.
    pub(super) fn push(&mut self, leg: &Leg) -> Result<(), CliError> {
        for point in leg.points(INSTANTS)? {
            self.centres.push(point.position.into());
        }
        if let Some(bounce) = leg.bounce() {
            if self.balls.len() < MOST_BALLS {
                self.balls.push(bounce.position.into());
            }
            let contact = bounce.position - self.case.ball.radius() * bounce.normal;
            self.contacts.push(contact.into());
        }
        Ok(())
    }

    /// The picture.
    pub(super) fn draw(self) -> Picture {
        let Self { case, centres, balls, contacts } = self;
        let (centres, contacts) = (centres.records(), contacts.records());
        let radius = case.ball.radius();
        let view = view(if centres.is_empty() { &balls[..1] } else { &centres }, 1.5 * radius);
        let flat = |place: [f64; 3]| (place[view.axes[0]], place[view.axes[1]]);
        let axis = |i: usize| Axis::linear(AXES[view.axes[i]]).between(view.low[i], view.high[i]);
        let mut panel = Panel::new(axis(0), axis(1)).equal_aspect();
        for (index, (wall, name)) in case.scene.walls().iter().zip(&case.names).enumerate() {
            if let Some(points) = wall_line(wall, &view) {
                panel.add(Series::line(name, points).coloured(index + 2));
            }
        }
        for centre in balls {
            panel.add(Series::area("", circle(flat(centre), radius)).coloured(0));
        }
        panel.add(Series::line("centre of the ball", centres.into_iter().map(flat)).coloured(0));
        let places: Vec<_> = contacts.iter().map(|contact| flat(*contact)).collect();
        for (number, place) in view.numbered(&places) {
            panel.add(Series::note(number.to_string(), place).coloured(DARK));
        }
        if !contacts.is_empty() {
            let contacts = contacts.into_iter().map(flat);
            panel.add(Series::markers("bounces", Marker::Dot, contacts).coloured(1));
        }
        Picture::new("Path of the ball", [panel])
    }
}

/// The two axes with the largest extents of the path; x and z without motion.
fn view(centres: &[[f64; 3]], margin: f64) -> View {
    let bound = |axis: usize, pick: fn(f64, f64) -> f64| {
        centres.iter().map(|centre| centre[axis]).reduce(pick).unwrap_or(0.0)
    };
    let low = [0, 1, 2].map(|axis| bound(axis, f64::min) - margin);
    let high = [0, 1, 2].map(|axis| bound(axis, f64::max) + margin);
    let length = |axis: usize| high[axis] - low[axis];
    let hidden = [1, 0, 2].into_iter().reduce(|a, b| if length(b) < length(a) { b } else { a });
    let axes = match hidden {
        Some(0) => [1, 2],
        Some(2) => [0, 1],
        _ => [0, 2],
    };
    View { axes, low: axes.map(|axis| low[axis]), high: axes.map(|axis| high[axis]) }
}

/// A wall seen edge on as a line, a tilted rectangle as its outline; None for an infinite wall that covers
/// the picture.
fn wall_line(wall: &Wall, view: &View) -> Option<Vec<(f64, f64)>> {
    let [i, j] = view.axes;
    if let Some(corners) = wall.corners() {
        let outline = corners.iter().chain(&corners[..1]).map(|corner| (corner[i], corner[j]));
        return Some(outline.collect());
    }
    let (n, m) = (wall.normal()[i], wall.normal()[j]);
    let size = n.hypot(m);
    if size < 0.1 {
        return None;
    }
    // The intersection of the wall with the plane of the picture through the wall's point.
    let (n, m) = (n / size, m / size);
    let centre = [0, 1].map(|axis| 0.5 * (view.low[axis] + view.high[axis]));
    let reach = (view.high[0] - view.low[0]) + (view.high[1] - view.low[1]);
    let off = (centre[0] - wall.point()[i]) * n + (centre[1] - wall.point()[j]) * m;
    let foot = (centre[0] - off * n, centre[1] - off * m);
    let end = |s: f64| (foot.0 - s * reach * m, foot.1 + s * reach * n);
    Some(vec![end(-1.0), end(1.0)])
}

fn circle(centre: (f64, f64), radius: f64) -> Vec<(f64, f64)> {
    (0..48)
        .map(|i| {
            let angle = TAU * f64::from(i) / 48.0;
            (centre.0 + radius * libm::cos(angle), centre.1 + radius * libm::sin(angle))
        })
        .collect()
}
