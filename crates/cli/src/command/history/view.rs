//! The states of a history as records and rows.

use super::laws::Laws;
use super::twist::{self, Twist};
use crate::command::theory::Excess;
use crate::error::CliError;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::HertzState;
use carom_laws::memory::Regime;
use carom_plot::linspace;
use serde::{Serialize, Serializer};

/// The contact after a step. SI units; loads act on body 1.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Step {
    #[serde(serialize_with = "as_whole")]
    pub(super) step: f64,
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
    #[serde(flatten)]
    pub(super) twist: Option<Twist>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) tractions: Vec<Traction>,
    /// What lies outside the theory, if anything.
    pub(super) outside_theory: Vec<String>,
    /// The shift's load over that of complete sliding.
    #[serde(skip)]
    pub(super) share: f64,
}

/// The tangential traction on body 1 at a radius: 0 is the centre, 1 the edge of the ellipse.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Traction {
    pub(super) radius: f64,
    pub(super) t_x: f64,
    pub(super) t_y: f64,
    /// Around the normal, in the sense of M_z; along a circle only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) t_twist: Option<f64>,
    /// Friction times pressure.
    pub(super) limit: f64,
}

/// Steps are numbered from 1; only those drawn between them have a broken number.
fn as_whole<S: Serializer>(step: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_u64(*step as u64)
}

/// The present state of the laws, with the traction at `count` radii; `radius` is the smallest of
/// curvature.
pub(super) fn step(
    number: f64,
    laws: &Laws,
    friction: Friction,
    count: usize,
    radius: f64,
) -> Result<Step, CliError> {
    let (shift, load, law) = (laws.present(), laws.load(), laws.shift());
    let state = laws.contact();
    let [a, b] =
        state.map_or([0.0; 2], |state| [state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b()]);
    let stick = law.stick_depth().sqrt(); // (a*/a)^2 = zeta*/zeta
    let limit = friction.get() * load.f_z;
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
        stored_energy: laws.stored_energy(),
        dissipated: laws.dissipated(),
        twist: laws.torsion().map(|law| twist::twist(law, state.as_ref(), friction)),
        tractions: tractions(laws, friction, state.as_ref(), count)?,
        outside_theory: Excess::of_contact(shift.zeta, radius).reasons(),
        share: if limit > 0.0 { libm::hypot(load.f_x, load.f_y) / limit } else { 0.0 },
    })
}

/// The traction at `count` radii, in units of the greatest friction f sigma_z0 before.
fn tractions(
    laws: &Laws,
    friction: Friction,
    state: Option<&HertzState>,
    count: usize,
) -> Result<Vec<Traction>, CliError> {
    if count == 0 {
        return Ok(Vec::new());
    }
    let greatest = state.map_or(0.0, |state| friction.get() * state.peak_pressure);
    let is_circle = state.is_none_or(|state| is_circle(&state.ellipse));
    let history = laws.torsion().and_then(|law| law.history()).filter(|_| is_circle);
    let traction = |radius: f64| {
        let unit =
            laws.shift().memory().map_or([0.0; 2], |memory| memory.traction(radius * radius));
        let [t_x, t_y] = unit.map(|part| greatest * part);
        let t_twist = history
            .map(|history| Ok::<f64, CliError>(greatest * twist::traction(history, radius)?))
            .transpose()?;
        let limit = greatest * ((1.0 - radius) * (1.0 + radius)).sqrt();
        Ok(Traction { radius, t_x, t_y, t_twist, limit })
    };
    linspace(0.0, 1.0, count).into_iter().map(traction).collect()
}

/// Whether the axes are equal up to round-off.
pub(super) fn is_circle(ellipse: &ContactEllipse) -> bool {
    (ellipse.axis_ratio().get() - 1.0).abs() < 1e-12
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
pub(super) fn heads(history: &[Step]) -> Vec<&'static str> {
    let mut heads = vec![
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
    if history.iter().any(|step| step.twist.is_some()) {
        heads.extend(["omega", "M_z", "twist_regime"]);
        heads.extend(["twist_stick_semi_axis_a", "twist_stick_semi_axis_b"]);
    }
    heads
}

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
        if let Some(twist) = &step.twist {
            row.extend([twist.omega, twist.m_z].map(number));
            row.push(twist.twist_regime.to_owned());
            row.extend([twist.twist_stick_semi_axis_a, twist.twist_stick_semi_axis_b].map(number));
        }
        row
    };
    history.iter().map(row).collect()
}

/// Heads of the rows of [`traction_cells`].
pub(super) const TRACTION_HEADS: [&str; 6] = ["step", "radius", "t_x", "t_y", "t_twist", "limit"];

/// A row a step and radius.
pub(super) fn traction_cells(history: &[Step], number: fn(f64) -> String) -> Vec<Vec<String>> {
    let rows = history.iter().flat_map(|step| {
        step.tractions.iter().map(move |traction| {
            let numbers = [traction.radius, traction.t_x, traction.t_y].map(number);
            let twist = traction.t_twist.map_or_else(|| "-".to_owned(), number);
            let row = std::iter::once(step.step.to_string()).chain(numbers);
            row.chain([twist, number(traction.limit)]).collect()
        })
    });
    rows.collect()
}
