//! An impact of bodies of any smooth shape.

use super::samples::{self, Sample};
use super::view::{self, Kind, Record};
use super::{Arguments, plot, table};
use crate::case::{CaseError, EncounterCase};
use crate::command::theory::caution;
use crate::destination::Destination;
use crate::error::CliError;
use crate::output::{self, Answer, Format, check_finite, csv, json, short};
use carom_impact::coupled::VectorLaw;
use carom_impact::{EncounterError, NumericalImpact, NumericalImpactError, Outcome};
use serde::Serialize;

/// An encounter and what came of it. SI units.
#[derive(Debug, Clone, Serialize)]
struct EncounterRecord {
    contact: ContactRecord,
    #[serde(flatten)]
    impact: Record,
    #[serde(skip_serializing_if = "Option::is_none")]
    samples: Option<Vec<Sample>>,
}

/// Where the bodies touch and how the impact was solved.
#[derive(Debug, Clone, Serialize)]
struct ContactRecord {
    point: [f64; 3],
    x_axis: [f64; 3],
    y_axis: [f64; 3],
    z_axis: [f64; 3],
    curvature_a: f64,
    curvature_b: f64,
    axis_ratio: f64,
    centre_1: [f64; 3],
    centre_2: [f64; 3],
    /// None without an impact.
    passage: Option<&'static str>,
    law: &'static str,
    compressions: Option<u32>,
    error_estimate: Option<f64>,
}

pub(super) fn run(
    arguments: &Arguments,
    plot: Option<Destination>,
    case: &EncounterCase,
) -> Result<Answer, CliError> {
    let at_fault = |source| blamed(arguments, case, source);
    let outcome = match case.contact.is_numerical {
        true => NumericalImpact::new(&case.encounter)
            .solve()
            .map_err(|source| on_grid(arguments, source))?,
        false => case.encounter.solve().map_err(at_fault)?,
    };
    let sampled = |count| {
        let computed = match case.contact.is_numerical {
            true => NumericalImpact::new(&case.encounter)
                .history()
                .map_err(|source| on_grid(arguments, source))?,
            false => case.encounter.history().map_err(at_fault)?,
        };
        samples::samples(&case.encounter, &computed, count).map_err(at_fault)
    };
    let course = |count| {
        let samples = sampled(count)?;
        let rows = samples::cells(&samples, |value| value.to_string());
        check_finite(&arguments.given.case, &samples::HEADS, &rows)?;
        Ok::<_, CliError>(samples)
    };
    let samples = match arguments.history {
        Some(count) => Some(sampled(count as usize)?),
        None => None,
    };
    let contact = contact(case, &outcome).map_err(at_fault)?;
    let impact = view::record(None, &case.before, &outcome);
    let mut warnings = impact.warnings.clone();
    let record = EncounterRecord { contact, impact, samples };
    check_finite(&arguments.given.case, &view::HEADS, &[view::cells(&record.impact)])?;
    let text = match arguments.given.format {
        Format::Json => json(&record)?,
        Format::Csv => comma_separated(&record)?,
        Format::Table => render(&record),
        Format::None => String::new(),
    };
    let mut picture = None;
    if let Some(to) = plot {
        match record.impact.outcome {
            Kind::NoImpact => warnings.push(super::NOTHING_TO_DRAW.to_owned()),
            Kind::Rebound => {
                picture = Some((to, plot::encounter(&course(plot::INSTANTS)?)));
            }
        }
    }
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution(&[record.impact.excess], "impacts"), arguments.given.format))
}

fn on_grid(arguments: &Arguments, source: NumericalImpactError) -> CliError {
    CliError::Numerical { path: arguments.given.case.clone(), source: Box::new(source) }
}

/// The case is to blame for torsion that cannot be given.
fn blamed(arguments: &Arguments, case: &EncounterCase, source: EncounterError) -> CliError {
    let path = arguments.given.case.clone();
    match (source, case.contact.torsion) {
        (EncounterError::NormalSpin(source), Some(line)) => {
            CliError::Case { path, source: CaseError::Torsion { line, source: Box::new(source) } }
        }
        (source, _) => CliError::Encounter { path, source: Box::new(source) },
    }
}

fn contact(case: &EncounterCase, outcome: &Outcome) -> Result<ContactRecord, EncounterError> {
    let encounter = &case.encounter;
    let (frame, curvature) = (encounter.frame(), encounter.hertz().curvature());
    let [one, two] = encounter.bodies();
    Ok(ContactRecord {
        point: encounter.point().into(),
        x_axis: frame.x().into(),
        y_axis: frame.y().into(),
        z_axis: frame.z().into(),
        curvature_a: curvature.a(),
        curvature_b: curvature.b(),
        axis_ratio: encounter.hertz().axis_ratio().get(),
        centre_1: one.centre().into(),
        centre_2: two.centre().into(),
        passage: encounter.impact()?.map(|impact| match case.contact.is_numerical {
            true => "numerical",
            false => impact.passage().name(),
        }),
        law: match (case.contact.is_numerical, case.contact.law) {
            (true, _) => "numerical",
            (false, VectorLaw::Coulomb) => "coulomb",
            (false, VectorLaw::FixedDirection) => "fixed-direction",
        },
        compressions: outcome.rebound().map(|rebound| rebound.compressions),
        error_estimate: outcome.rebound().map(|rebound| rebound.error_estimate),
    })
}

fn render(record: &EncounterRecord) -> String {
    let contact = &record.contact;
    let mut rows = vec![
        ("contact point", table::vector(contact.point), "m"),
        ("x axis, along a", table::vector(contact.x_axis), ""),
        ("y axis, along b", table::vector(contact.y_axis), ""),
        ("z axis, into body 1", table::vector(contact.z_axis), ""),
        ("centre of body 1", table::vector(contact.centre_1), "m"),
        ("centre of body 2", table::vector(contact.centre_2), "m"),
        ("curvature A", short(contact.curvature_a), "1/m"),
        ("curvature B", short(contact.curvature_b), "1/m"),
        ("axis ratio a/b", short(contact.axis_ratio), ""),
    ];
    if let (Some(passage), Some(compressions), Some(error)) =
        (contact.passage, contact.compressions, contact.error_estimate)
    {
        rows.extend([
            ("passage", passage.to_owned(), ""),
            ("law for turning directions", contact.law.to_owned(), ""),
            ("compressions", compressions.to_string(), ""),
            ("error estimate of the velocity", short(error), "of |v|"),
        ]);
    }
    let mut text = table::named(&rows) + &table::outcome(&record.impact);
    if let Some(samples) = &record.samples {
        text += &output::table(&samples::HEADS, &samples::cells(samples, short));
    }
    text
}

fn comma_separated(record: &EncounterRecord) -> Result<String, CliError> {
    if let Some(samples) = &record.samples {
        return csv(&samples::HEADS, &samples::cells(samples, |value| value.to_string()));
    }
    let contact = &record.contact;
    let mut heads: Vec<&str> = view::HEADS.to_vec();
    heads.extend(["passage", "law", "compressions", "error_estimate"]);
    heads.extend(["point_x", "point_y", "point_z", "normal_x", "normal_y", "normal_z"]);
    let mut cells = view::cells(&record.impact);
    cells.push(contact.passage.unwrap_or_default().to_owned());
    cells.push(contact.law.to_owned());
    cells.push(contact.compressions.map_or_else(String::new, |n| n.to_string()));
    cells.push(contact.error_estimate.map_or_else(String::new, |error| error.to_string()));
    cells.extend([contact.point, contact.z_axis].as_flattened().iter().map(f64::to_string));
    csv(&heads, &[cells])
}
