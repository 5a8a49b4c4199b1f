//! What results exceed of the theory, as the command tells it.

use carom::impact::Outcome;
use carom::laws::hertz::HertzState;
use carom::laws::law::Shift;
use carom::laws::validity::{Limit, Validity};
use carom::prelude::{ContactLoad, RangeError};
use carom_cases::theory::{ValidityReport, readable};
use pyo3::prelude::*;

use crate::error::Fault;
use crate::hertz::{Given, Hertz};

/// The texts of warnings, and whether results leave the theory.
pub(crate) type Told = (Vec<String>, bool);

/// The warnings of many impacts: whether they lie outside the theory, then each kind once, in its worst form.
pub(crate) fn of_impacts(outcomes: &[Outcome]) -> Told {
    let mut report = ValidityReport::default();
    for (i, outcome) in outcomes.iter().enumerate() {
        match outcome.rebound() {
            Some(rebound) => report.add_impact(|_| format!("at entry {i}"), rebound),
            None => report.add(String::new, Validity::default()),
        }
    }
    reported(report, "impacts")
}

/// The warnings of one contact.
pub(crate) fn of_contact(validity: Validity) -> Told {
    let mut report = ValidityReport::default();
    report.add(String::new, validity);
    reported(report, "contacts")
}

/// The warnings of Hertz contacts under load.
pub(crate) fn of_loads(hertz: &Hertz, states: &[HertzState]) -> Told {
    // All ratios grow with the approach.
    let deepest = states.iter().max_by(|one, other| one.approach.total_cmp(&other.approach));
    let mut report = ValidityReport::default();
    if deepest.is_some_and(|state| hertz.validity(state).exceeded().next().is_some()) {
        for state in states {
            report.add(|| format!("at {} N", readable(state.force)), hertz.validity(state));
        }
    }
    reported(report, "loads")
}

/// Warns in Python, at the call of the user.
pub(crate) fn warn(py: Python<'_>, told: Told) -> PyResult<()> {
    if !told.0.is_empty() {
        py.import("carom._validity")?.call_method1("warn", (told,))?;
    }
    Ok(())
}

/// What contacts of constant radii exceed in the course of their steps: each limit is told once.
#[derive(Debug, Clone)]
pub(crate) struct Watch {
    /// None if stiffnesses alone are known, which have no limit.
    hertz: Option<Hertz>,
    /// What the law neglects, as in [`Validity`].
    coupling: f64,
    told: Vec<Limit>,
    /// The approach from which on there is something to tell.
    from: f64,
}

impl Watch {
    pub(crate) fn new(given: &Given, coupling: Option<f64>) -> Self {
        let hertz = match given {
            Given::Hertz(hertz) => Some(*hertz),
            Given::Stiffness(_) => None,
        };
        let coupling = coupling.unwrap_or(0.0);
        let mut watch = Self { hertz, coupling, told: Vec::new(), from: 0.0 };
        watch.from = watch.next();
        watch
    }

    /// Advances a law to this shift, and warns of what it exceeds. If that fails, nothing has happened.
    #[inline]
    pub(crate) fn advance<L: Clone>(
        &mut self,
        py: Python<'_>,
        law: &mut L,
        shift: Shift,
        advance: impl Fn(&mut L) -> Result<ContactLoad, RangeError>,
    ) -> PyResult<ContactLoad> {
        if shift.zeta <= self.from {
            return Ok(advance(law).map_err(Fault::from)?);
        }
        let mut next = law.clone();
        let load = advance(&mut next).map_err(Fault::from)?;
        self.see(py, &[shift.zeta], 1)?;
        *law = next;
        Ok(load)
    }

    /// Warns of what these approaches exceed, so many of each contact, unless it has been told. If the
    /// warning is raised as an error, it has not been told.
    pub(crate) fn see(&mut self, py: Python<'_>, approaches: &[f64], steps: usize) -> PyResult<()> {
        if !approaches.iter().any(|zeta| *zeta > self.from) {
            return Ok(());
        }
        let mut report = ValidityReport::default();
        for (i, path) in approaches.chunks(steps).enumerate() {
            let greatest = path.iter().copied().fold(0.0, f64::max);
            report.add(|| format!("at entry {i}"), self.validity(greatest));
        }
        let worst = report.validity();
        warn(py, reported(report, "contacts"))?;
        self.told.extend(worst.exceeded().map(|excess| excess.limit));
        self.from = self.next();
        Ok(())
    }

    /// What is not told yet, of a contact at this approach.
    fn validity(&self, zeta: f64) -> Validity {
        let state = self.hertz.and_then(|hertz| Some((hertz, hertz.0.at_approach(zeta).ok()?)));
        let Some((hertz, state)) = state.filter(|_| zeta > 0.0) else { return Validity::default() };
        let Validity { semi_axis_over_radius, approach_over_radius, pressure_over_yield, .. } =
            hertz.validity(&state);
        let new = |limit, ratio| if self.told.contains(&limit) { 0.0 } else { ratio };
        Validity {
            semi_axis_over_radius: new(Limit::LargeContact, semi_axis_over_radius),
            approach_over_radius: new(Limit::LargeApproach, approach_over_radius),
            pressure_over_yield: new(Limit::Yields, pressure_over_yield),
            coupling: new(Limit::Coupling, self.coupling),
            ..Validity::default()
        }
    }

    /// The least approach beyond a limit that is not told: semi-axis and pressure grow as its root, and coupling is
    /// the same at each.
    fn next(&self) -> f64 {
        let Some(hertz) = self.hertz else { return f64::INFINITY };
        let unit = hertz.smallest_radius();
        let of_unit = self.validity(unit);
        let at = |limit: Limit| {
            let part = limit.threshold() / of_unit.ratio(limit);
            match limit {
                Limit::Coupling if part < 1.0 => 0.0,
                Limit::LargeApproach => unit * part,
                Limit::LargeContact | Limit::Yields => unit * part * part,
                _ => f64::INFINITY,
            }
        };
        Limit::ALL.into_iter().map(at).fold(f64::INFINITY, f64::min)
    }
}

/// The warnings of many contacts.
pub(crate) fn reported(report: ValidityReport, what: &str) -> Told {
    let worst = report.validity();
    let (caution, warnings) = report.told(what);
    (caution.into_iter().chain(warnings).collect(), !worst.holds())
}
