//! The impact as an animation: the bodies approach, touch in slow motion and separate.

use super::view::Record;
use crate::command::plot::Value;
use crate::output::Picture;
use carom_geometry::Placed;
use carom_impact::{Body, Collision, HistoryPoint, Motion};
use carom_plot::{Arrow, Axis, Limits, Marker, Panel, Point, Series};
use nalgebra::Vector3;

/// Duration of the animation in seconds, and number of frames before, during and after the contact.
const SECONDS: f64 = 8.0;
const BEFORE: usize = 16;
/// Number of instants of the contact that are shown.
pub(super) const INSTANTS: usize = 61;
const AFTER: usize = 23;
const FRAMES: usize = BEFORE + INSTANTS + AFTER;

/// Number of directions in which the outline of a body is searched.
const DIRECTIONS: usize = 120;
/// Number of steps of that search, from far outside to the centre.
const STEPS: usize = 90;

/// The bodies from the side, the contact from above, the forces, and friction over the normal force.
pub(super) fn movie(record: &Record, history: &[HistoryPoint]) -> Picture {
    let panels = [bodies(record), contact(history), forces(history), friction(history)];
    Picture::new("The impact, the contact in slow motion", panels)
}

/// One value for each frame, from one for each instant; before and after the contact the first and the last.
fn frames<T>(history: &[HistoryPoint], value: impl Fn(&HistoryPoint) -> T) -> Vec<T> {
    let last = history.len().saturating_sub(1);
    (0..FRAMES).map(|i| value(&history[i.saturating_sub(BEFORE).min(last)])).collect()
}

/// Number of frames before contact, as a negative number, or after separation.
fn flight(frame: usize) -> f64 {
    let (frame, parted) = (frame as f64, (BEFORE + INSTANTS - 1) as f64);
    (frame - BEFORE as f64).min(0.0) + (frame - parted).max(0.0)
}

/// The plane of the side view: the normal and the direction of the initial slip.
struct View {
    origin: Vector3<f64>,
    along: Vector3<f64>,
    up: Vector3<f64>,
}

impl View {
    fn of(collision: &Collision) -> Self {
        let frame = collision.frame();
        let slip = collision.velocity();
        let slip = Vector3::new(slip.x, slip.y, 0.0);
        // Body 1 comes from the left if possible.
        let along = if slip.norm() > 0.0 { -frame.to_space(&slip).normalize() } else { frame.x() };
        Self { origin: collision.point(), along, up: frame.z() }
    }

    fn flat(&self, vector: &Vector3<f64>) -> Point {
        Point::new(self.along.dot(vector), self.up.dot(vector))
    }

    /// Rotation in the plane, from `along` to `up`.
    fn turn(&self, motion: &Motion) -> f64 {
        self.along.cross(&self.up).dot(&motion.spin)
    }

    /// The projected centre of a body, and its outline relative to it.
    fn outline(&self, body: &Placed, reach: f64) -> (Point, Vec<Point>) {
        let across = self.along.cross(&self.up);
        let arm = body.centre() - self.origin;
        let middle = body.centre() - across * across.dot(&arm);
        let rim = if body.surface().is_plane() { None } else { self.rim(body, &middle) };
        match rim.map(|rim| with_hole(rim, self.hole(body, &middle))) {
            Some(rim) => {
                let centre = self.flat(&(middle - self.origin));
                let from = |at: &Point| Point::new(at.x - centre.x, at.y - centre.y);
                (centre, rim.iter().map(from).collect())
            }
            None => (Point::new(0.0, 0.0), self.near_contact(body, reach)),
        }
    }

    /// The outline in every direction from the centre; None if the body is infinite in some direction.
    fn rim(&self, body: &Placed, middle: &Vector3<f64>) -> Option<Vec<Point>> {
        let reach = 1.05 * (body.surface().size() + (middle - body.centre()).norm());
        let step = reach / STEPS as f64;
        let to = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / DIRECTIONS as f64).sin_cos();
            let direction = self.along * cos + self.up * sin;
            (0..=STEPS).find_map(|k| {
                let start = middle + direction * (reach - step * k as f64);
                let way = body.entry(&start, &-direction)?;
                let is_near = way.abs() <= step;
                is_near.then(|| self.flat(&(start - direction * way - self.origin)))
            })
        };
        (0..DIRECTIONS).map(to).collect()
    }

    /// The inner edge of a body that is hollow about its middle, like a torus seen along its axis, in
    /// every direction; None if there is no hole.
    fn hole(&self, body: &Placed, middle: &Vector3<f64>) -> Option<Vec<Point>> {
        let step = body.surface().size() / STEPS as f64;
        let to = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / DIRECTIONS as f64).sin_cos();
            let direction = self.along * cos + self.up * sin;
            (0..STEPS).find_map(|k| {
                let start = middle + direction * (step * k as f64);
                let way = body.entry(&start, &direction)?;
                // From inside the body the way goes back, and is negative.
                let is_near = way > 0.0 && way < 1.5 * step;
                is_near.then(|| self.flat(&(start + direction * way - self.origin)))
            })
        };
        (0..DIRECTIONS).map(to).collect()
    }

    /// The surface near the contact as a parabola, with the body behind it.
    fn near_contact(&self, body: &Placed, reach: f64) -> Vec<Point> {
        let local = body.local(&self.origin).ok();
        let outward = local.as_ref().map_or(self.up, |local| local.normal());
        let side = -self.up.dot(&outward).signum();
        let bend =
            local.map_or(0.0, |local| self.along.dot(&(local.shape_operator() * self.along)));
        let surface = carom_special::linspace(-reach, reach, 61).into_iter().map(|x| {
            let depth = (0.5 * bend * x * x).clamp(-reach, reach);
            Point::new(x, side * depth)
        });
        surface.chain([Point::new(reach, side * reach), Point::new(-reach, side * reach)]).collect()
    }
}

/// The outline of a body with a hole: around, in along a seam above the centre, and around the hole the
/// other way, so that the hole stays empty.
fn with_hole(rim: Vec<Point>, hole: Option<Vec<Point>>) -> Vec<Point> {
    let Some(hole) = hole else { return rim };
    let around = |points: &[Point]| -> Vec<Point> {
        (0..=DIRECTIONS).map(|i| points[(i + DIRECTIONS / 4) % DIRECTIONS]).collect()
    };
    let mut inner = around(&hole);
    inner.reverse();
    [around(&rim), inner].concat()
}

fn bodies(record: &Record) -> Panel {
    let collision = record.collision();
    let view = View::of(collision);
    let unit = unit(collision, &view);
    let [before, after] = record.motions();
    let fastest = [before, after].iter().flatten().map(|m| m.velocity.norm()).fold(0.0, f64::max);
    // The time scale outside the contact is such that the fastest centre moves 1.6 units.
    let pace = if fastest > 0.0 { 1.6 * unit / fastest / AFTER as f64 } else { 0.0 };
    let mut panel = Panel::new(
        Axis { limits: Some(Limits { low: -4.3 * unit, high: 4.3 * unit }), ..Axis::bare("") },
        Axis { limits: Some(Limits { low: -3.0 * unit, high: 3.0 * unit }), ..Axis::bare("") },
    )
    .titled("the bodies, seen along the surface")
    .equal_aspect();
    for (i, body) in collision.bodies().iter().enumerate() {
        let (centre, outline) = view.outline(body.placed(), 12.0 * unit);
        let turns = !body.placed().surface().is_plane();
        let place = |frame: usize| {
            let time = pace * flight(frame);
            let motion = if time < 0.0 { &before[i] } else { &after[i] };
            let way = view.flat(&motion.velocity);
            let angle = if turns { time * view.turn(motion) } else { 0.0 };
            (Point::new(centre.x + time * way.x, centre.y + time * way.y), angle)
        };
        let at = |frame: usize| -> Vec<Point> {
            let (centre, angle) = place(frame);
            outline.iter().map(|point| turned(centre, *point, angle)).collect()
        };
        let label = format!("body {}", i + 1);
        panel.add(Series::area(label, at(BEFORE)).coloured(i).moving(SECONDS, (0..FRAMES).map(at)));
        // The seam of a body with a hole shows how it turns.
        let is_whole = outline.len() == DIRECTIONS;
        if turns && is_whole && centre != Point::new(0.0, 0.0) {
            let spoke = |frame: usize| {
                let (centre, angle) = place(frame);
                let foot = Point::new(0.0, outline[DIRECTIONS / 4].y);
                vec![centre, turned(centre, foot, angle)]
            };
            let way = (0..FRAMES).map(spoke);
            panel.add(Series::line("", spoke(BEFORE)).coloured(i).moving(SECONDS, way));
        }
    }
    panel
}

/// Size of the smaller outline.
fn unit(collision: &Collision, view: &View) -> f64 {
    let reach = |body: &Body| {
        let size = body.placed().surface().size();
        let (_, outline) = (size > 0.0).then(|| view.outline(body.placed(), size))?;
        let reach = outline.iter().map(|at| at.x.hypot(at.y)).fold(0.0, f64::max);
        (reach > 0.0).then_some(reach)
    };
    collision.bodies().iter().filter_map(reach).min_by(f64::total_cmp).unwrap_or(1.0)
}

fn turned(centre: Point, point: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    Point::new(centre.x + cos * point.x - sin * point.y, centre.y + sin * point.x + cos * point.y)
}

fn contact(history: &[HistoryPoint]) -> Panel {
    let [a, b] = [0, 1].map(|i| greatest(history, |point| point.semi_axes[i]));
    let strongest = greatest(history, |point| point.force.xy().norm());
    let mut panel = Panel::new(Axis::linear("x / m"), Axis::linear("y / m"))
        .titled("the contact, seen along the normal; arrow: friction on body 1")
        .equal_aspect();
    let ellipse = |[a, b]: [f64; 2]| -> Vec<Point> {
        let angles = carom_special::linspace(0.0, std::f64::consts::TAU, 49);
        angles.into_iter().map(|angle| Point::new(a * angle.cos(), b * angle.sin())).collect()
    };
    panel.add(Series::dotted("largest contact", ellipse([a, b])).coloured(6));
    let largest = middle(history);
    let slips = frames(history, |point| ellipse(point.semi_axes));
    panel.add(
        Series::area("contact", ellipse(largest.semi_axes)).coloured(1).moving(SECONDS, slips),
    );
    if history.iter().all(|point| point.stick_radius.is_some()) {
        let stick = |point: &HistoryPoint| ellipse([point.stick_radius.unwrap_or_default(); 2]);
        let sticks = frames(history, stick);
        panel.add(Series::area("sticks", stick(largest)).coloured(2).moving(SECONDS, sticks));
    }
    if strongest > 0.0 {
        let size = a.min(b) / strongest;
        let head = |point: &HistoryPoint| Point::new(size * point.force.x, size * point.force.y);
        let tail = Point::new(0.0, 0.0);
        let arrow = Arrow { tail, head: head(largest) };
        let way = frames(history, |point| vec![tail, head(point)]);
        panel.add(Series::arrows("", [arrow]).coloured(0).moving(SECONDS, way));
    }
    notes(&mut panel, history, [a, b]);
    panel
}

/// The regime of each frame, written in the corner.
fn notes(panel: &mut Panel, history: &[HistoryPoint], [a, b]: [f64; 2]) {
    let names = frames(history, |point| point.regime.name());
    let mut all = names.clone();
    all.sort_unstable();
    all.dedup();
    let (seen, hidden) = (Point::new(-1.3 * a, 0.92 * b), Point::new(-99.0 * a, 0.0));
    for regime in all {
        let is_now =
            |frame: usize| names[frame] == regime && (BEFORE..BEFORE + INSTANTS).contains(&frame);
        let way = (0..FRAMES).map(|frame| vec![if is_now(frame) { seen } else { hidden }]);
        panel.add(Series::note(regime, Point::new(0.0, 0.0)).coloured(6).moving(SECONDS, way));
    }
}

fn forces(history: &[HistoryPoint]) -> Panel {
    let mut panel = Panel::new(Axis::linear("time / s"), Axis::linear("force on body 1 / N"))
        .titled("the forces");
    let parts: [(&str, Value<HistoryPoint>); 3] =
        [("F_x", |p| p.force.x), ("F_y", |p| p.force.y), ("F_z", |p| p.force.z)];
    for (colour, (name, force)) in parts.into_iter().enumerate() {
        let at = |point: &HistoryPoint| Point::new(point.time, force(point));
        panel.add(Series::line(name, history.iter().map(at)).coloured(colour));
        panel.add(dot(history, at).coloured(colour));
    }
    panel
}

fn friction(history: &[HistoryPoint]) -> Panel {
    let mut panel = Panel::new(Axis::linear("F_z / N"), Axis::linear("friction on body 1 / N"))
        .titled("friction against the normal force");
    let parts: [(&str, Value<HistoryPoint>); 2] = [("F_x", |p| p.force.x), ("F_y", |p| p.force.y)];
    for (colour, (name, force)) in parts.into_iter().enumerate() {
        let at = |point: &HistoryPoint| Point::new(point.force.z, force(point));
        panel.add(Series::line(name, history.iter().map(at)).coloured(colour));
        panel.add(dot(history, at).coloured(colour));
    }
    panel
}

/// A dot that follows the impact.
fn dot(history: &[HistoryPoint], at: impl Fn(&HistoryPoint) -> Point) -> Series {
    let way = frames(history, |point| vec![at(point)]);
    Series::markers("", Marker::Dot, [at(middle(history))]).moving(SECONDS, way)
}

/// The instant that a static picture shows.
fn middle(history: &[HistoryPoint]) -> &HistoryPoint {
    &history[history.len() / 3]
}

fn greatest(history: &[HistoryPoint], value: impl Fn(&HistoryPoint) -> f64) -> f64 {
    history.iter().map(value).fold(0.0, f64::max)
}
