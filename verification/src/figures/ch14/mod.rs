//! Chapter 14: numerical load histories.

mod creepage;
mod dissimilar;
mod ellipse;
mod euromech;
mod incompressible;
mod punches;
mod shift_and_twist;
mod sphere_loop;
mod sphere_stress;
mod torsion;
mod turning;

use crate::Axis;
use crate::catalogue::Entry;

/// The axis of the direction of a traction.
fn angle_axis() -> Axis {
    Axis::linear("angle of t in degrees").repeating(360.0)
}

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("14.1", "Forces and displacements of a load history of spheres")
        .by(sphere_loop::forces_by_step),
    Entry::figure("14.2", "Load-displacement curve of the history of fig. 14.1")
        .by(sphere_loop::loop_of_force),
    Entry::figure("14.3", "Stress angle and size for steps of the history of fig. 14.1")
        .by(sphere_stress::draw),
    Entry::figure("14.4", "Load-displacement curve, ν = 0.5").by(incompressible::loop_of_force),
    Entry::figure("14.5", "Stress angle and size, ν = 0.5").by(incompressible::stress),
    Entry::figure("14.6", "Displacement vectors of the load histories 1-2 to 1-7")
        .by(turning::legs),
    Entry::figure("14.7", "Load history 1-2: stress angle and size").by(turning::to_2),
    Entry::figure("14.8", "Load history 1-3: stress angle and size").by(turning::to_3),
    Entry::figure("14.9", "Load history 1-4: stress angle and size").by(turning::to_4),
    Entry::figure("14.10", "Load history 1-5: stress angle and size").by(turning::to_5),
    Entry::figure("14.11", "Load history 1-6: stress angle and size").by(turning::to_6),
    Entry::figure("14.12", "Load history 1-7: stress angle and size").by(turning::to_7),
    Entry::figure("14.13", "Load history 1-2 with ν = 0.5").by(turning::incompressible),
    Entry::figure("14.14", "Tangential stress on an ellipse, ν = 0.5").by(ellipse::draw),
    Entry::figure("14.15", "Stress angle, dissimilar materials").by(dissimilar::angle),
    Entry::figure("14.16", "Size of the tangential stress, dissimilar materials")
        .by(dissimilar::size),
    Entry::figure("14.17", "Load history Euromech").by(euromech::path),
    Entry::figure("14.18", "Size of the stick area in the Euromech history")
        .by(euromech::stick_area),
    Entry::figure("14.19", "Stress angle at steps 2, 3, 10 of the Euromech history")
        .by(euromech::pressing),
    Entry::figure("14.20", "Stress angle at steps 11, 15 of the Euromech history")
        .by(euromech::first_shift),
    Entry::figure("14.21", "Stress angle at step 25 of the Euromech history")
        .by(euromech::way_back),
    Entry::figure("14.22", "Torque against twist").by(torsion::torque),
    Entry::figure("14.23", "Contours of the stick area under torsion, a/b = 10")
        .by(torsion::contours),
    Entry::figure("14.24", "Varying torque, a/b = 1/10, ν = 0").by(torsion::varying),
    Entry::figure("14.25", "Shift along x with torsion, step 2").by(shift_and_twist::along_x_first),
    Entry::figure("14.26", "Shift along x with torsion, step 11").by(shift_and_twist::along_x_last),
    Entry::figure("14.27", "Stick contours of shift along x with torsion")
        .by(shift_and_twist::contours_along_x),
    Entry::figure("14.28", "Shift along y with torsion, steps 2 and 11")
        .by(shift_and_twist::along_y),
    Entry::figure("14.29", "Stick contours of shift along y with torsion")
        .by(shift_and_twist::contours_along_y),
    Entry::figure("14.30", "Force and moment for large creepage").by(creepage::draw),
    Entry::figure("14.31", "Normalised torque for torsion with shift").by(shift_and_twist::torques),
    Entry::figure("14.32", "Forces for torsion with shift").by(shift_and_twist::forces),
    Entry::figure("14.33", "Stick and slip under a square and a triangular punch")
        .by(punches::square_and_triangle),
    Entry::figure("14.34", "Stick and slip under a punch of four letters")
        .by(punches::four_letters),
    Entry::figure("14.35", "Stick and slip under a flat punch, dissimilar materials")
        .by(punches::maps),
    Entry::figure("14.36", "Displacement and stresses under a flat punch")
        .by(punches::displacement_and_stress),
    Entry::figure("14.37", "Tangential slip under a flat punch, step 5").by(punches::slip),
];
