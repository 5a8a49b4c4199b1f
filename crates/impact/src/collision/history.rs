//! The history of a collision at given instants.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::{Collision, CollisionError, Instants};
use crate::coupled::{Log, Sample, Traced};
use crate::normal;
use crate::outcome::{HistoryPoint, LogEntry};

impl Collision {
    /// The impact at so many equally spaced instants from first contact to separation, or at given times, in contact
    /// axes; empty without an impact. Exact for spheres and planes; for other bodies interpolated linearly between
    /// computed steps.
    ///
    /// The axes of two balls turn with their line of centres ([`HistoryPoint::normal`]), unless they are kept
    /// ([`Collision::keeping_axes`]). The last velocity is then that of the motions after the impact, at the contact point of
    /// that instant, within the estimated error of the outcome.
    ///
    /// # Errors
    /// As [`Collision::solve`]; [`RangeError`] as [`Instants::check`].
    pub fn history<'a>(
        &self,
        instants: impl Into<Instants<'a>>,
    ) -> Result<Vec<HistoryPoint>, CollisionError> {
        let instants = instants.into();
        instants.check()?;
        let Some(impact) = self.impact()? else { return Ok(Vec::new()) };
        let direction = impact.exact_direction().filter(|_| !impact.loses());
        let Some(direction) = direction else {
            return self.sampled(&impact.history(self.law)?, instants, &impact.velocity());
        };
        let times = instants.within(normal::DURATION, self.pulse(impact.velocity().z)?.time_unit());
        let point = |Traced { sample, regime, stick_depth }: Traced| {
            let radius = || Ok::<_, RangeError>(self.semi_axes(stick_depth)?[0]);
            Ok(HistoryPoint {
                time: sample.time,
                shift: sample.shift,
                velocity: sample.velocity,
                force: sample.force,
                semi_axes: self.semi_axes(sample.shift.z)?,
                stick_radius: self.is_symmetric().then(radius).transpose()?,
                regime,
                normal: self.frame().z(),
            })
        };
        let points: Result<_, CollisionError> =
            impact.traced(&direction, &times)?.into_iter().map(point).collect();
        Ok(instants.finish(self.in_turning_axes(points?)?))
    }

    /// These instants of an impact that was computed elsewhere, interpolated linearly
    /// between its steps; `initial` is the velocity before, in contact axes.
    ///
    /// # Errors
    /// [`RangeError`] as [`Instants::check`], and for an approach that gives no contact ellipse.
    pub fn sampled<'a>(
        &self,
        computed: &[Sample],
        instants: impl Into<Instants<'a>>,
        initial: &Vector3<f64>,
    ) -> Result<Vec<HistoryPoint>, CollisionError> {
        let instants = instants.into();
        instants.check()?;
        let Some(last) = computed.last() else {
            return Ok(Vec::new());
        };
        let mut from = 0;
        let points: Result<_, CollisionError> = instants
            .within(last.time, 1.0)
            .into_iter()
            .map(|time| {
                while from + 2 < computed.len() && computed[from + 1].time < time {
                    from += 1;
                }
                let to = (from + 1).min(computed.len() - 1);
                self.between(&computed[from], &computed[to], time, initial)
            })
            .collect();
        Ok(instants.finish(self.in_turning_axes(points?)?))
    }

    /// The regimes of an impact that was computed elsewhere, each with the first step in which it occurs;
    /// `initial` is the velocity before, in contact axes.
    #[must_use]
    pub fn regimes(&self, computed: &[Sample], initial: &Vector3<f64>) -> Vec<LogEntry> {
        let mut log = Log::default();
        computed.iter().for_each(|sample| log.see(sample, initial));
        log.entries
    }

    fn between(
        &self,
        one: &Sample,
        two: &Sample,
        time: f64,
        initial: &Vector3<f64>,
    ) -> Result<HistoryPoint, CollisionError> {
        let length = two.time - one.time;
        let part = if length > 0.0 { ((time - one.time) / length).clamp(0.0, 1.0) } else { 0.0 };
        let shift = one.shift.lerp(&two.shift, part);
        let force = one.force.lerp(&two.force, part);
        let stage = if part > 0.0 { two.stage } else { one.stage };
        Ok(HistoryPoint {
            time,
            shift,
            velocity: one.velocity.lerp(&two.velocity, part),
            force,
            semi_axes: self.semi_axes(shift.z)?,
            stick_radius: None,
            regime: stage.regime(force.xy().dot(&initial.xy()) >= 0.0),
            normal: self.frame().z(),
        })
    }

    pub(super) fn semi_axes(&self, approach: f64) -> Result<[f64; 2], RangeError> {
        if approach <= 0.0 {
            return Ok([0.0; 2]);
        }
        let ellipse = self.hertz.ellipse(approach)?;
        Ok([ellipse.semi_axis_a(), ellipse.semi_axis_b()])
    }
}
