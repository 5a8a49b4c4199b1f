//! The outcome of an impact as tables to read.

use super::view::{self, Course, MotionRecord, ReboundRecord, Record};
use crate::case::Input;
use crate::columns;
use crate::error::CliError;
use crate::output::{Format, short, table};
use carom_impact::HistoryPoint;

/// One impact in full, or a sweep with a line for each value.
pub(super) fn render(records: &[Record], sweep: Option<&Input>) -> Result<String, CliError> {
    match (records, sweep) {
        (records, Some(input)) => Ok(self::sweep(records, input)),
        (records, None) => records.iter().map(one).collect(),
    }
}

/// Where they touch, the motions, what came of the impact, its regimes and its course.
fn one(record: &Record) -> Result<String, CliError> {
    let mut text = contact(record) + &motions(record);
    match &record.rebound {
        None => text.push_str("no impact: the bodies do not approach each other\n"),
        Some(rebound) => {
            text.push_str(&quantities(rebound));
            text.push_str(&events(rebound));
        }
    }
    if let Some(Course(points)) = &record.history {
        text.push_str(&columns::rows(Format::Table, HistoryPoint::COLUMNS, points)?);
    }
    Ok(text)
}

fn contact(record: &Record) -> String {
    let contact = &record.contact;
    let mut rows = vec![
        ("contact point", vector(contact.point), "m"),
        ("x axis, along a", vector(contact.x_axis), ""),
        ("y axis, along b", vector(contact.y_axis), ""),
        ("z axis, into body 1", vector(contact.z_axis), ""),
        ("centre of body 1", vector(contact.centre_1), "m"),
        ("centre of body 2", vector(contact.centre_2), "m"),
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
    named(&rows)
}

fn motions(record: &Record) -> String {
    let row = |body: &str, when: &str, motion: &MotionRecord| {
        let numbers = motion.velocity.iter().chain(&motion.spin).map(|value| short(*value));
        [body.to_owned(), when.to_owned()].into_iter().chain(numbers).collect()
    };
    let (before, after) = (&record.before, &record.after);
    let rows = [
        row("body 1", "before", &before.body_1),
        row("body 1", "after", &after.body_1),
        row("body 2", "before", &before.body_2),
        row("body 2", "after", &after.body_2),
    ];
    let heads = ["", "", "v_x m/s", "v_y", "v_z", "spin_x rad/s", "spin_y", "spin_z"];
    table(&heads, &rows)
}

fn quantities(rebound: &ReboundRecord) -> String {
    let contact = [rebound.maximal_semi_axis_a, rebound.maximal_semi_axis_b].map(short);
    let (size, extent) = match contact {
        [a, b] if a == b => ("maximal contact radius", a),
        [a, b] => ("maximal semi-axes a, b of the contact", format!("{a}  {b}")),
    };
    let mut rows = vec![
        ("tangential restitution R_x", or_dash(rebound.restitution), ""),
        ("contact velocity before", vector(rebound.contact_velocity_before), "m/s"),
        ("contact velocity after", vector(rebound.contact_velocity_after), "m/s"),
        ("impulse on body 1", vector(rebound.impulse), "N s"),
        ("duration", short(rebound.duration), "s"),
        ("maximal normal force", short(rebound.maximal_force), "N"),
        ("maximal approach", short(rebound.maximal_approach), "m"),
        (size, extent, "m"),
        ("kinetic energy before", short(rebound.energy_before), "J"),
        ("kinetic energy after", short(rebound.energy_after), "J"),
        ("energy dissipated", short(rebound.energy_dissipated), "J"),
    ];
    if let Some(torsion) = &rebound.torsion {
        rows.extend([
            ("spin about the normal, after/before", short(torsion.spin_ratio), ""),
            ("impulse of the torque on body 1", short(torsion.torque_impulse), "N m s"),
            ("of the energy dissipated, by torsion", short(torsion.energy_dissipated), "J"),
        ]);
    }
    named(&rows)
}

fn or_dash(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), short)
}

/// A table of named quantities with their units.
fn named(rows: &[(&str, String, &str)]) -> String {
    let rows: Vec<Vec<String>> = rows
        .iter()
        .map(|(name, value, unit)| vec![(*name).to_owned(), value.clone(), (*unit).to_owned()])
        .collect();
    table(&["quantity", "value", "unit"], &rows)
}

/// Three components to read; what is round-off of the largest is zero.
fn vector(value: [f64; 3]) -> String {
    let largest = value.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
    value
        .map(|part| if part.abs() < 1e-15 * largest { "0".to_owned() } else { short(part) })
        .join("  ")
}

fn events(rebound: &ReboundRecord) -> String {
    let rows: Vec<Vec<String>> = rebound
        .events
        .iter()
        .map(|entry| {
            let part = 100.0 * entry.time / rebound.duration;
            let words = [entry.event, entry.regime].map(str::to_owned);
            [short(entry.time), format!("{part:.2}")].into_iter().chain(words).collect()
        })
        .collect();
    table(&["time s", "% of duration", "event", "regime from then on"], &rows)
}

fn sweep(records: &[Record], input: &Input) -> String {
    let rows: Vec<Vec<String>> = records
        .iter()
        .map(|record| {
            let body_1 = &record.after.body_1;
            let of = |value: fn(&ReboundRecord) -> f64| or_dash(record.rebound.as_ref().map(value));
            vec![
                or_dash(record.parameter.map(|parameter| parameter.value)),
                or_dash(record.restitution()),
                short(body_1.velocity[0]),
                short(body_1.velocity[2]),
                short(body_1.spin[1]),
                of(|rebound| rebound.maximal_force),
                of(|rebound| rebound.energy_dissipated),
                record
                    .rebound
                    .as_ref()
                    .map_or_else(|| "no impact".to_owned(), |r| r.regimes.join(" ")),
            ]
        })
        .collect();
    let first = match (view::name(input), input.unit) {
        ("angle", _) => "angle °".to_owned(),
        (name, unit) => format!("{name} {unit}").trim_end().to_owned(),
    };
    let heads = [
        first.as_str(),
        "R_x",
        "v_x m/s",
        "v_z m/s",
        "spin_y rad/s",
        "force N",
        "dissipated J",
        "regimes",
    ];
    table(&heads, &rows)
}
