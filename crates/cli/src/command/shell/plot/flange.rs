//! The picture of a flange.

use super::exaggeration;
use crate::command::plot::{Course, Value};
use crate::output::Picture;
use carom_cases::shell::{RingPlace, SolvedFlange};
use carom_plot::{Arrow, Axis, Marker, Panel, Point, Series};
use carom_shells::flange::RingForce;
use carom_special::linspace;
use std::f64::consts::TAU;

/// The ring at rest and under its forces, displacements around, and moments around.
pub(in super::super) fn draw(solved: &SolvedFlange) -> Picture {
    let around: Vec<RingPlace> = linspace(0.0, 360.0, 361)
        .into_iter()
        .map(|angle| RingPlace {
            angle,
            displacement: solved.solution.displacement(angle.to_radians()),
            loads: solved.solution.loads(angle.to_radians()),
        })
        .collect();
    let course =
        Course { records: &around, marked: &[], label: "angle / deg", at: |place| place.angle };
    let displacements: &[(&'static str, Value<RingPlace>)] = &[
        ("outward", |at| at.displacement.radial),
        ("along the ring", |at| at.displacement.tangential),
        ("along the tube", |at| at.displacement.axial),
    ];
    let moments: &[(&'static str, Value<RingPlace>)] = &[
        ("in the plane", |at| at.loads.in_plane),
        ("out of the plane", |at| at.loads.out_of_plane),
        ("torsion", |at| at.loads.torsion),
    ];
    let panels = [
        ring(solved, &around),
        course.panel("displacements", "displacement / m", displacements),
        course.panel("moments on a section", "moment / N m", moments),
    ];
    Picture::new("Flange", panels)
}

fn ring(solved: &SolvedFlange, around: &[RingPlace]) -> Panel {
    let radius = solved.flange.ring().radius();
    let size = |at: &RingPlace| libm::hypot(at.displacement.radial, at.displacement.tangential);
    let greatest = around.iter().map(size).fold(0.0, f64::max);
    let (factor, words) = exaggeration(greatest, radius);
    let place = |at: &RingPlace| {
        let (sin, cos) = (libm::sin(at.angle.to_radians()), libm::cos(at.angle.to_radians()));
        let (out, along) = (factor * at.displacement.radial, factor * at.displacement.tangential);
        ((radius + out) * cos - along * sin, (radius + out) * sin + along * cos)
    };
    let mut panel = Panel::new(Axis::linear("x / m"), Axis::linear("y / m"))
        .titled(format!("ring, seen along the tube{words}"))
        .equal_aspect();
    let circle = linspace(0.0, TAU, 181);
    let rest = circle.into_iter().map(|t| (radius * libm::cos(t), radius * libm::sin(t)));
    panel.add(Series::dashed("at rest", rest).coloured(1));
    panel.add(Series::line("under the forces", around.iter().map(place)).coloured(0));
    forces(solved, &mut panel);
    panel
}

/// Arrows for forces in the plane of the ring, crosses for those along the tube.
fn forces(solved: &SolvedFlange, panel: &mut Panel) {
    let radius = solved.flange.ring().radius();
    let in_plane = |force: &RingForce| libm::hypot(force.outward(), force.along_ring());
    let greatest = solved.forces.iter().map(in_plane).fold(0.0, f64::max);
    let direction = |angle: f64| (libm::cos(angle), libm::sin(angle));
    let arrows = solved.forces.iter().filter(|force| in_plane(force) > 0.0).map(|force| {
        let (cos, sin) = direction(force.angle());
        let length = 0.35 * radius / greatest;
        let (out, along) = (length * force.outward(), length * force.along_ring());
        let turned = (out * cos - along * sin, out * sin + along * cos);
        let tail = Point::new(radius * cos, radius * sin);
        Arrow { tail, head: Point::new(tail.x + turned.0, tail.y + turned.1) }
    });
    if greatest > 0.0 {
        panel.add(Series::arrows("forces", arrows).coloured(2));
    }
    let axial: Vec<_> = solved
        .forces
        .iter()
        .filter(|force| force.along_tube() != 0.0)
        .map(|force| {
            let (cos, sin) = direction(force.angle());
            (radius * cos, radius * sin)
        })
        .collect();
    if !axial.is_empty() {
        panel.add(Series::markers("forces along the tube", Marker::Cross, axial).coloured(2));
    }
}
