//! The states of a history as records and rows.

use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::ContactLaw as _;
use carom_laws::memory::Regime;
use carom_laws::shift_law::ShiftLaw;
use carom_plot::linspace;
use carom_special::RangeError;
use serde::Serialize;

/// The contact after a step. SI units; loads act on body 1.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Step {
    pub(super) step: usize,
    pub(super) zeta: f64,
    pub(super) xi: f64,
    pub(super) eta: f64,
    #[serde(rename = "F_x")]
    pub(super) f_x: f64,
    #[serde(rename = "F_y")]
    pub(super) f_y: f64,
    #[serde(rename = "F_z")]
    pub(super) f_z: f64,
    pub(super) regime: &'static str,
    pub(super) semi_axis_a: f64,
    pub(super) semi_axis_b: f64,
    pub(super) stick_semi_axis_a: f64,
    pub(super) stick_semi_axis_b: f64,
    pub(super) stored_energy: f64,
    pub(super) dissipated: f64,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) tractions: Vec<Traction>,
}

/// The tangential traction on body 1 at a radius: 0 is the centre, 1 the edge of the ellipse.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Traction {
    pub(super) radius: f64,
    pub(super) t_x: f64,
    pub(super) t_y: f64,
}

/// The present state of the law, with the traction at `count` radii.
pub(super) fn step(
    number: usize,
    hertz: &Hertz,
    law: &ShiftLaw<[f64; 2]>,
    friction: Friction,
    count: usize,
) -> Result<Step, RangeError> {
    let (shift, load) = (law.shift(), law.load());
    let [a, b, peak_pressure] = if shift.zeta > 0.0 {
        let state = hertz.at_approach(shift.zeta)?;
        [state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b(), state.peak_pressure]
    } else {
        [0.0; 3]
    };
    let stick = law.stick_depth().sqrt(); // (a*/a)^2 = zeta*/zeta
    Ok(Step {
        step: number,
        zeta: shift.zeta,
        xi: shift.xi,
        eta: shift.eta,
        f_x: load.f_x,
        f_y: load.f_y,
        f_z: load.f_z,
        regime: regime_name(law.regime()),
        semi_axis_a: a,
        semi_axis_b: b,
        stick_semi_axis_a: stick * a,
        stick_semi_axis_b: stick * b,
        stored_energy: law.stored_energy(),
        dissipated: law.dissipated(),
        tractions: tractions(law, friction.get() * peak_pressure, count),
    })
}

/// The traction at `count` radii; `limit` is the greatest friction f sigma_z0.
fn tractions(law: &ShiftLaw<[f64; 2]>, limit: f64, count: usize) -> Vec<Traction> {
    let traction = |radius: f64| {
        let unit = law.memory().map_or([0.0; 2], |memory| memory.traction(radius * radius));
        let [t_x, t_y] = unit.map(|part| limit * part);
        Traction { radius, t_x, t_y }
    };
    match count {
        0 => Vec::new(),
        _ => linspace(0.0, 1.0, count).into_iter().map(traction).collect(),
    }
}

const fn regime_name(regime: Regime) -> &'static str {
    match regime {
        Regime::Separated => "separated",
        Regime::Adhesion => "adhesion",
        Regime::Release => "release",
        Regime::Slip => "slip",
        Regime::Reversal => "reversal",
        Regime::Overlay => "overlay",
        Regime::Sliding => "sliding",
    }
}

/// Heads of the rows of [`cells`].
pub(super) const HEADS: [&str; 14] = [
    "step",
    "zeta",
    "xi",
    "eta",
    "F_x",
    "F_y",
    "F_z",
    "regime",
    "semi_axis_a",
    "semi_axis_b",
    "stick_semi_axis_a",
    "stick_semi_axis_b",
    "stored_energy",
    "dissipated",
];

/// A row a step.
pub(super) fn cells(history: &[Step], number: fn(f64) -> String) -> Vec<Vec<String>> {
    let row = |step: &Step| {
        let before = [step.zeta, step.xi, step.eta, step.f_x, step.f_y, step.f_z];
        let after = [
            step.semi_axis_a,
            step.semi_axis_b,
            step.stick_semi_axis_a,
            step.stick_semi_axis_b,
            step.stored_energy,
            step.dissipated,
        ];
        let mut row = vec![step.step.to_string()];
        row.extend(before.map(number));
        row.push(step.regime.to_owned());
        row.extend(after.map(number));
        row
    };
    history.iter().map(row).collect()
}

/// Heads of the rows of [`traction_cells`].
pub(super) const TRACTION_HEADS: [&str; 4] = ["step", "radius", "t_x", "t_y"];

/// A row a step and radius.
pub(super) fn traction_cells(history: &[Step], number: fn(f64) -> String) -> Vec<Vec<String>> {
    let rows = history.iter().flat_map(|step| {
        step.tractions.iter().map(move |traction| {
            let numbers = [traction.radius, traction.t_x, traction.t_y];
            std::iter::once(step.step.to_string()).chain(numbers.map(number)).collect()
        })
    });
    rows.collect()
}
