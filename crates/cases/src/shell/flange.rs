//! A flange under forces around it.

use crate::case::FlangeCase;
use carom_shells::flange::{
    Flange, FlangeError, FlangeSolution, RingDisplacement, RingForce, RingLoads,
};
use carom_table::Column;
use std::f64::consts::TAU;

/// A flange under its forces.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedFlange {
    /// The flange.
    pub flange: Flange,
    /// The forces.
    pub forces: Vec<RingForce>,
    /// Its displacements and loads.
    pub solution: FlangeSolution,
    /// Greatest values and energies.
    pub summary: FlangeSummary,
    /// Displacements and loads around, with a place for each force.
    pub places: Vec<RingPlace>,
}

/// A place of the ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingPlace {
    /// Angle in degrees, from 0 to below 360.
    pub angle: f64,
    /// Displacement of the section.
    pub displacement: RingDisplacement,
    /// Loads on the section.
    pub loads: RingLoads,
}

impl RingPlace {
    /// The columns of a place.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("angle", "deg", "around the ring", |place| place.angle.into()),
        Column::new("radial", "m", "displacement w outward", |place| {
            place.displacement.radial.into()
        }),
        Column::new("tangential", "m", "displacement v along the ring", |place| {
            place.displacement.tangential.into()
        }),
        Column::new("axial", "m", "displacement u along the tube", |place| {
            place.displacement.axial.into()
        }),
        Column::new(
            "rotation",
            "rad",
            "beta of the section, dw/dx of a wall fixed to it",
            |place| place.displacement.rotation.into(),
        ),
        Column::new("stretching", "N", "hoop force N, tension is positive", |place| {
            place.loads.stretching.into()
        }),
        Column::new("in_plane", "N m", "bending moment M in the plane of the ring", |place| {
            place.loads.in_plane.into()
        }),
        Column::new("out_of_plane", "N m", "bending moment M_o out of the plane", |place| {
            place.loads.out_of_plane.into()
        }),
        Column::new("torsion", "N m", "torque T along the ring", |place| {
            place.loads.torsion.into()
        }),
    ];
}

/// Greatest absolute values at the places around, and what tells of the accuracy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlangeSummary {
    stored_energy: f64,
    greatest: RingPlace,
    /// The harmonic with most of the tube's energy and the mean of n^2 t/R.
    shallowness: Option<(usize, f64)>,
    truncation: f64,
}

impl FlangeSummary {
    /// The columns.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("stored_energy", "J", "in ring and tube", |of| of.stored_energy.into()),
        Column::new("maximal_radial", "m", "greatest displacement outward or inward", |of| {
            of.greatest.displacement.radial.into()
        }),
        Column::new("maximal_axial", "m", "greatest displacement along the tube", |of| {
            of.greatest.displacement.axial.into()
        }),
        Column::new("maximal_rotation", "rad", "greatest rotation of a section", |of| {
            of.greatest.displacement.rotation.into()
        }),
        Column::new("maximal_in_plane", "N m", "greatest bending moment in the plane", |of| {
            of.greatest.loads.in_plane.into()
        }),
        Column::new("maximal_out_of_plane", "N m", "greatest bending moment out of it", |of| {
            of.greatest.loads.out_of_plane.into()
        }),
        Column::new("maximal_torsion", "N m", "greatest torque", |of| {
            of.greatest.loads.torsion.into()
        }),
        Column::count("harmonic", "", "harmonic n with most of the energy of the tube", |of| {
            of.shallowness.map(|(harmonic, _)| harmonic as u64).into()
        }),
        Column::new("shallowness", "", "mean of n^2 t/R, weighted by energy in the tube", |of| {
            of.shallowness.map(|(_, mean)| mean).into()
        }),
        Column::new("truncation", "", "last coefficients over the greatest", |of| {
            of.truncation.into()
        }),
    ];
}

/// Mean of n^2 t/R above which the half-momentless theory is off by more than about a percent.
const SHALLOW: f64 = 0.15;
/// Share of the last coefficients above which the harmonics are too few.
const TRUNCATED: f64 = 1e-3;

impl SolvedFlange {
    pub(super) fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        let is_whole = self.flange.tube().is_none_or(|tube| tube.is_whole_shell());
        if let (Some((_, mean)), false) = (self.summary.shallowness, is_whole)
            && mean > SHALLOW
        {
            warnings.push(format!(
                "the half-momentless theory of the tube needs n^2 t/R far below 1, and its mean is \
                 {mean:.2} here: displacements are several percent off; `flange.tube.theory` = \
                 \"koiter-sanders\" is the whole shell"
            ));
        }
        let truncation = self.summary.truncation;
        if truncation > TRUNCATED {
            warnings.push(format!(
                "the last harmonics still have {truncation:.1e} of the greatest one: \
                 `flange.harmonics` should be larger"
            ));
        }
        warnings
    }
}

pub(super) fn solved(case: &FlangeCase) -> Result<SolvedFlange, FlangeError> {
    let solution = case.flange.solve(&case.forces, case.harmonics)?;
    let places: Vec<_> = angles(case).into_iter().map(|angle| place(&solution, angle)).collect();
    let summary = FlangeSummary {
        stored_energy: 0.5 * solution.twice_energy(),
        greatest: greatest(&places),
        shallowness: solution.shallowness().map(|of| (of.harmonic, of.mean)),
        truncation: solution.truncation(),
    };
    let (flange, forces) = (case.flange.clone(), case.forces.clone());
    Ok(SolvedFlange { flange, forces, solution, summary, places })
}

fn place(solution: &FlangeSolution, angle: f64) -> RingPlace {
    RingPlace {
        angle: angle.to_degrees(),
        displacement: solution.displacement(angle),
        loads: solution.loads(angle),
    }
}

/// Equidistant angles and those of the forces, in radians, in order.
fn angles(case: &FlangeCase) -> Vec<f64> {
    let around = (0..case.places).map(|i| TAU * i as f64 / case.places as f64);
    let forces = case.forces.iter().map(|force| force.angle().rem_euclid(TAU));
    let mut all: Vec<f64> = around.chain(forces).filter(|angle| *angle < TAU).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|one, other| (*one - *other).abs() < 1e-9);
    all
}

/// Each value of the place where it is greatest in absolute value.
fn greatest(places: &[RingPlace]) -> RingPlace {
    let of =
        |value: fn(&RingPlace) -> f64| places.iter().map(value).map(f64::abs).fold(0.0, f64::max);
    RingPlace {
        angle: 0.0,
        displacement: RingDisplacement {
            radial: of(|at| at.displacement.radial),
            tangential: of(|at| at.displacement.tangential),
            axial: of(|at| at.displacement.axial),
            rotation: of(|at| at.displacement.rotation),
        },
        loads: RingLoads {
            stretching: of(|at| at.loads.stretching),
            in_plane: of(|at| at.loads.in_plane),
            out_of_plane: of(|at| at.loads.out_of_plane),
            torsion: of(|at| at.loads.torsion),
        },
    }
}
