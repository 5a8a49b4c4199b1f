//! The course of an encounter: instants in the axes of the contact.

use carom_impact::coupled::{self, Stage};
use carom_impact::{Encounter, EncounterError};
use carom_plot::linspace;
use serde::Serialize;

/// One instant, in contact axes. Displacements and velocities are of body 2 against body 1.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Sample {
    pub(super) time: f64,
    pub(super) shift: [f64; 3],
    pub(super) velocity: [f64; 3],
    pub(super) force: [f64; 3],
    pub(super) semi_axes: [f64; 2],
    pub(super) stage: &'static str,
}

/// `count` instants equally spaced in time, straight between those that were computed; none
/// without an impact.
pub(super) fn samples(
    encounter: &Encounter,
    computed: &[coupled::Sample],
    count: usize,
) -> Result<Vec<Sample>, EncounterError> {
    let Some(last) = computed.last() else {
        return Ok(Vec::new());
    };
    let mut from = 0;
    linspace(0.0, last.time, count)
        .into_iter()
        .map(|time| {
            while from + 2 < computed.len() && computed[from + 1].time < time {
                from += 1;
            }
            between(encounter, &computed[from], &computed[(from + 1).min(computed.len() - 1)], time)
        })
        .collect()
}

fn between(
    encounter: &Encounter,
    one: &coupled::Sample,
    two: &coupled::Sample,
    time: f64,
) -> Result<Sample, EncounterError> {
    let length = two.time - one.time;
    let part = if length > 0.0 { ((time - one.time) / length).clamp(0.0, 1.0) } else { 0.0 };
    let shift = one.shift.lerp(&two.shift, part);
    let semi_axes = match shift.z > 0.0 {
        true => {
            let ellipse = encounter.hertz().ellipse(shift.z)?;
            [ellipse.semi_axis_a(), ellipse.semi_axis_b()]
        }
        false => [0.0; 2],
    };
    Ok(Sample {
        time,
        shift: shift.into(),
        velocity: one.velocity.lerp(&two.velocity, part).into(),
        force: one.force.lerp(&two.force, part).into(),
        semi_axes,
        stage: match if part > 0.0 { two.stage } else { one.stage } {
            Stage::Adhesion => "adhesion",
            Stage::Slip => "slip",
            Stage::Slide => "slide",
        },
    })
}

/// Heads of the rows of [`cells`].
pub(super) const HEADS: [&str; 13] = [
    "time",
    "xi",
    "eta",
    "zeta",
    "v_x",
    "v_y",
    "v_z",
    "F_x",
    "F_y",
    "F_z",
    "semi_axis_a",
    "semi_axis_b",
    "stage",
];

/// A row an instant.
pub(super) fn cells(samples: &[Sample], number: fn(f64) -> String) -> Vec<Vec<String>> {
    let row = |sample: &Sample| {
        let vectors = [sample.shift, sample.velocity, sample.force];
        let mut row = vec![number(sample.time)];
        row.extend(vectors.as_flattened().iter().map(|value| number(*value)));
        row.extend(sample.semi_axes.map(number));
        row.push(sample.stage.to_owned());
        row
    };
    samples.iter().map(row).collect()
}
