//! The states of a history, and their columns.

use super::laws::{Laws, is_twisted};
use super::twist::{self, Twist};
use crate::Error;
use crate::case::HistoryCase;
use crate::theory::ValidityReport;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::HertzState;
use carom_laws::law::{ContactLoad, Shift};
use carom_laws::memory::MemoryRegime;
use carom_laws::static_friction::StaticFriction;
use carom_laws::validity::Validity;
use carom_special::linspace;
use carom_table::Column;

/// The contact after a step of a history. SI units; loads act on body 1.
#[derive(Debug, Clone)]
pub struct Step {
    /// The number of the step, from 1; fractional between two steps.
    pub step: f64,
    /// Shift and twist of body 2 against body 1.
    pub shift: Shift,
    /// Load on body 1.
    pub load: ContactLoad,
    /// Regime of the last step.
    pub regime: &'static str,
    /// Semi-axis of the contact ellipse along x.
    pub semi_axis_a: f64,
    /// Semi-axis of the contact ellipse along y.
    pub semi_axis_b: f64,
    /// Semi-axis of the stick area along x.
    pub stick_semi_axis_a: f64,
    /// Semi-axis of the stick area along y.
    pub stick_semi_axis_b: f64,
    /// The largest angle by which slip has turned within an annulus since that last stuck, radians.
    pub slip_turn: f64,
    /// Elastic energy of the contact.
    pub stored_energy: f64,
    /// Friction heat since the start.
    pub dissipated: f64,
    /// Quantities of the twist; none without one.
    pub twist: Option<Twist>,
    /// Tractions, if requested.
    pub tractions: Vec<Traction>,
    /// The tangential load over the largest, at which the contact slides.
    pub share: f64,
}

impl Step {
    /// How far the contact is from the limits of the theory.
    #[must_use]
    pub fn validity(&self, case: &HistoryCase) -> Validity {
        let contact = ContactEllipse::new(self.semi_axis_a, self.semi_axis_b);
        let pressure = contact.map_or(0.0, |contact| contact.peak_pressure(self.load.f_z));
        let largest = [self.semi_axis_a.max(self.semi_axis_b), self.shift.zeta, pressure];
        let materials = case.hertz.materials();
        Validity::of_contact(largest, materials.yield_stress(), case.smallest_radius)
            .without_coupling(&materials, case.friction.kinetic())
    }

    /// Adds what the contact exceeds.
    pub fn add_to(&self, report: &mut ValidityReport, case: &HistoryCase) {
        report.add(|| format!("at step {}", self.step), self.validity(case));
    }
}

/// The columns of every history.
pub const COLUMNS: &[Column<Step>] = &[
    // States drawn between the steps have fractional numbers.
    Column::count("step", "", "number of the step, from 1", |step| (step.step as u64).into()),
    Column::new("zeta", "m", "approach", |step| step.shift.zeta.into()),
    Column::new(
        "xi",
        "m",
        "shift of body 2 against body 1 along x, the larger relative curvature",
        |step| step.shift.xi.into(),
    ),
    Column::new("eta", "m", "the same along y", |step| step.shift.eta.into()),
    Column::new("F_x", "N", "force on body 1 along x", |step| step.load.f_x.into()),
    Column::new("F_y", "N", "the same along y", |step| step.load.f_y.into()),
    Column::new("F_z", "N", "normal force", |step| step.load.f_z.into()),
    Column::text("regime", "", "regime of the last step", |step| step.regime.into()),
    Column::new("semi_axis_a", "m", "semi-axis of the contact ellipse along x", |step| {
        step.semi_axis_a.into()
    }),
    Column::new("semi_axis_b", "m", "the same along y", |step| step.semi_axis_b.into()),
    Column::new("stick_semi_axis_a", "m", "semi-axis of the stick area along x", |step| {
        step.stick_semi_axis_a.into()
    }),
    Column::new("stick_semi_axis_b", "m", "the same along y", |step| step.stick_semi_axis_b.into()),
    Column::new(
        "slip_turn",
        "rad",
        "largest turn of the direction of slip within an annulus since it last stuck",
        |step| step.slip_turn.into(),
    ),
    Column::new("stored_energy", "J", "elastic energy of the contact", |step| {
        step.stored_energy.into()
    }),
    Column::new("dissipated", "J", "friction heat since the start", |step| step.dissipated.into()),
];

/// The additional columns of a history with a twist.
pub const TWIST_COLUMNS: &[Column<Step>] = &[
    Column::new("omega", "rad", "twist about the normal", |step| step.shift.omega.into()),
    Column::new("M_z", "N m", "torque on body 1", |step| step.load.m_z.into()),
    Column::text("twist_regime", "", "regime of the twist", |step| {
        step.twist.map(|twist| twist.regime).into()
    }),
    Column::new(
        "twist_stick_semi_axis_a",
        "m",
        "semi-axis of the stick area of the twist along x",
        |step| step.twist.map(|twist| twist.stick_semi_axis_a).into(),
    ),
    Column::new("twist_stick_semi_axis_b", "m", "the same along y", |step| {
        step.twist.map(|twist| twist.stick_semi_axis_b).into()
    }),
];

/// The columns of any history; those of the twist are empty without one.
#[must_use]
pub fn all_columns() -> Vec<Column<Step>> {
    [COLUMNS, TWIST_COLUMNS].concat()
}

/// The columns of a history of these shifts.
#[must_use]
pub fn columns(shifts: &[Shift]) -> Vec<Column<Step>> {
    match is_twisted(shifts) {
        true => all_columns(),
        false => COLUMNS.to_vec(),
    }
}

/// The tangential traction on body 1 at a radius: 0 is the centre, 1 the edge of the ellipse.
#[derive(Debug, Clone, Copy)]
pub struct Traction {
    /// The number of the step.
    pub step: f64,
    /// Fraction of the radius: 0 at the centre, 1 at the edge.
    pub radius: f64,
    /// Traction along x.
    pub t_x: f64,
    /// Traction along y.
    pub t_y: f64,
    /// Circumferential traction; for circular contacts only.
    pub t_twist: Option<f64>,
    /// Friction times pressure; static friction unless all slides.
    pub limit: f64,
}

/// Its columns; the first is the number of the step.
pub const TRACTION_COLUMNS: &[Column<Traction>] = &[
    Column::count("step", "", "number of the step, from 1", |traction| {
        (traction.step as u64).into()
    }),
    Column::new("radius", "", "from the centre (0) to the edge (1)", |traction| {
        traction.radius.into()
    }),
    Column::new("t_x", "Pa", "traction on body 1 along x", |traction| traction.t_x.into()),
    Column::new("t_y", "Pa", "the same along y", |traction| traction.t_y.into()),
    Column::new("t_twist", "Pa", "circumferential traction, in the sense of M_z", |traction| {
        traction.t_twist.into()
    }),
    Column::new(
        "limit",
        "Pa",
        "friction times pressure; static friction unless all slides",
        |traction| traction.limit.into(),
    ),
];

/// The present state of the laws, with the traction at `count` radii.
///
/// # Errors
/// [`ErrorKind::Quadrature`](crate::ErrorKind::Quadrature) if a traction cannot be integrated.
pub fn step(
    number: f64,
    laws: &Laws,
    friction: StaticFriction,
    count: usize,
) -> Result<Step, Error> {
    let (shift, load, law) = (laws.present(), laws.load(), laws.shift());
    let state = laws.contact();
    let [a, b] =
        state.map_or([0.0; 2], |state| [state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b()]);
    let stick = law.stick_depth().sqrt(); // (a*/a)^2 = zeta*/zeta
    let most = friction.threshold();
    let limit = most.get() * load.f_z;
    Ok(Step {
        step: number,
        shift,
        load,
        regime: regime_name(law.regime()),
        semi_axis_a: a,
        semi_axis_b: b,
        stick_semi_axis_a: stick * a,
        stick_semi_axis_b: stick * b,
        slip_turn: laws.slip_turn(),
        stored_energy: laws.stored_energy(),
        dissipated: laws.dissipated(),
        twist: laws.torsion().map(|law| twist::twist(law, state.as_ref(), most)),
        tractions: tractions(number, laws, friction, state.as_ref(), count)?,
        share: if limit > 0.0 { libm::hypot(load.f_x, load.f_y) / limit } else { 0.0 },
    })
}

/// The traction at `count` radii, relative to the largest friction limit f sigma_z0, before it is scaled.
fn tractions(
    step: f64,
    laws: &Laws,
    friction: StaticFriction,
    state: Option<&HertzState>,
    count: usize,
) -> Result<Vec<Traction>, Error> {
    if count == 0 {
        return Ok(Vec::new());
    }
    let greatest =
        |friction: Friction| state.map_or(0.0, |state| friction.get() * state.peak_pressure);
    let slides = laws.shift().regime() == MemoryRegime::Sliding;
    let most = greatest(if slides { friction.kinetic() } else { friction.threshold() });
    let greatest = greatest(friction.threshold());
    let is_circle = state.is_none_or(|state| is_circle(&state.ellipse));
    let history = laws.torsion().and_then(|law| law.history()).filter(|_| is_circle);
    let traction = |radius: f64| {
        let unit = laws.shift().traction(radius * radius).unwrap_or_default();
        let [t_x, t_y] = unit.map(|part| greatest * part);
        let t_twist = history
            .map(|history| Ok::<f64, Error>(greatest * twist::traction(history, radius)?))
            .transpose()?;
        let limit = most * ((1.0 - radius) * (1.0 + radius)).sqrt();
        Ok(Traction { step, radius, t_x, t_y, t_twist, limit })
    };
    linspace(0.0, 1.0, count).into_iter().map(traction).collect()
}

/// Whether the axes are equal up to round-off.
#[must_use]
pub fn is_circle(ellipse: &ContactEllipse) -> bool {
    (ellipse.axis_ratio().get() - 1.0).abs() < 1e-12
}

const fn regime_name(regime: MemoryRegime) -> &'static str {
    match regime {
        MemoryRegime::Separated => "separated",
        MemoryRegime::Adhesion => "adhesion",
        MemoryRegime::Release => "release",
        MemoryRegime::Slip => "slip",
        MemoryRegime::Reversal => "reversal",
        MemoryRegime::Overlay => "overlay",
        MemoryRegime::Sliding => "sliding",
    }
}
