//! The outcome of an impact as tables to read.

use super::view::{HISTORY_HEADS, Instant, MotionRecord, ReboundRecord, Record, history_cells};
use crate::output::{short, table};

/// One impact in full, or a sweep with a line for each angle.
pub(super) fn render(records: &[Record], is_sweep: bool) -> String {
    match records {
        [record] if !is_sweep => one(record),
        _ => sweep(records),
    }
}

/// The motions, what came of the impact, and its regimes.
pub(super) fn outcome(record: &Record) -> String {
    let mut text = motions(record);
    match &record.rebound {
        None => text.push_str("no impact: the bodies do not approach each other\n"),
        Some(rebound) => {
            text.push_str(&quantities(rebound));
            text.push_str(&events(rebound));
        }
    }
    text
}

fn one(record: &Record) -> String {
    let mut text = outcome(record);
    if let Some(history) = &record.history {
        text.push_str(&course(history));
    }
    text
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
pub(super) fn named(rows: &[(&str, String, &str)]) -> String {
    let rows: Vec<Vec<String>> = rows
        .iter()
        .map(|(name, value, unit)| vec![(*name).to_owned(), value.clone(), (*unit).to_owned()])
        .collect();
    table(&["quantity", "value", "unit"], &rows)
}

/// Three components to read; what is round-off of the largest is zero.
pub(super) fn vector(value: [f64; 3]) -> String {
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

fn course(history: &[Instant]) -> String {
    let rows: Vec<_> = history.iter().map(|instant| history_cells(instant, short)).collect();
    table(&HISTORY_HEADS, &rows)
}

fn sweep(records: &[Record]) -> String {
    let rows: Vec<Vec<String>> = records
        .iter()
        .map(|record| {
            let body_1 = &record.after.body_1;
            let of = |value: fn(&ReboundRecord) -> f64| or_dash(record.rebound.as_ref().map(value));
            vec![
                or_dash(record.angle),
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
    let heads = [
        "angle °",
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
