//! The course of a collision at chosen instants.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::method::{Method, Symmetric};
use super::{Collision, CollisionError};
use crate::coupled::{Sample, Stage};
use crate::normal;
use crate::oblique::{ObliqueImpact, Regime};
use crate::outcome::HistoryPoint;

impl Collision {
    /// The impact at `count` instants equally spaced in time, touch and separation included, in
    /// contact axes; empty without an impact. Of spheres and planes each is exact; of other bodies
    /// it is straight between those that were computed.
    ///
    /// # Errors
    /// As [`Collision::solve`]; [`RangeError`] for fewer than two instants.
    pub fn history(&self, count: usize) -> Result<Vec<HistoryPoint>, CollisionError> {
        RangeError::check("history points", count as f64, count >= 2, ">= 2")?;
        match self.method()? {
            None => Ok(Vec::new()),
            Some(Method::Symmetric(symmetric)) => self.traced(&symmetric, count),
            Some(Method::Coupled(impact)) => {
                self.sampled(&impact.history(self.law)?, count, &impact.velocity())
            }
        }
    }

    fn traced(
        &self,
        symmetric: &Symmetric,
        count: usize,
    ) -> Result<Vec<HistoryPoint>, CollisionError> {
        // The normal motion by time: the velocity alone does not resolve the first instants.
        let times: Vec<f64> = instants(normal::DURATION, count).collect();
        let states: Vec<_> = times.iter().map(|time| normal::state_at(*time)).collect();
        let velocities: Vec<f64> = states.iter().map(|state| state.velocity).collect();
        let trace = ObliqueImpact::trace(symmetric.groups, &velocities)?;
        let Symmetric { slip, direction, normal, .. } = symmetric;
        let (unit, clock) = (normal.maximal_approach(), normal.time_unit());
        let (force, speed) = (normal.maximal_force(), normal.velocity());
        let stiffness = self.hertz.stiffness();
        let tangential = force * stiffness.c_x / stiffness.c_z * slip / speed;
        let along = |tangential: f64, normal: f64| {
            Vector3::new(direction.x * tangential, direction.y * tangential, normal)
        };
        let points = trace.iter().zip(&times).zip(&states);
        points
            .map(|((point, time), state)| {
                let zeta = state.compression;
                let pull = if *slip > 0.0 { tangential * point.force } else { 0.0 };
                Ok(HistoryPoint {
                    time: clock * time,
                    shift: along(slip * clock * point.shift, unit * zeta),
                    velocity: along(slip * point.velocity, speed * point.normal_velocity),
                    force: along(pull, force * zeta * zeta.sqrt()),
                    semi_axes: self.semi_axes(unit * zeta)?,
                    stick_radius: Some(self.semi_axes(unit * point.stick_depth.min(zeta))?[0]),
                    regime: point.regime,
                })
            })
            .collect()
    }

    /// `count` instants, straight between those that were computed.
    pub(crate) fn sampled(
        &self,
        computed: &[Sample],
        count: usize,
        initial: &Vector3<f64>,
    ) -> Result<Vec<HistoryPoint>, CollisionError> {
        RangeError::check("history points", count as f64, count >= 2, ">= 2")?;
        let Some(last) = computed.last() else {
            return Ok(Vec::new());
        };
        let mut from = 0;
        instants(last.time, count)
            .map(|time| {
                while from + 2 < computed.len() && computed[from + 1].time < time {
                    from += 1;
                }
                let to = (from + 1).min(computed.len() - 1);
                self.between(&computed[from], &computed[to], time, initial)
            })
            .collect()
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
        Ok(HistoryPoint {
            time,
            shift,
            velocity: one.velocity.lerp(&two.velocity, part),
            force,
            semi_axes: self.semi_axes(shift.z)?,
            stick_radius: None,
            regime: regime(if part > 0.0 { two.stage } else { one.stage }, &force, initial),
        })
    }

    fn semi_axes(&self, approach: f64) -> Result<[f64; 2], RangeError> {
        if approach <= 0.0 {
            return Ok([0.0; 2]);
        }
        let ellipse = self.hertz.ellipse(approach)?;
        Ok([ellipse.semi_axis_a(), ellipse.semi_axis_b()])
    }
}

fn instants(duration: f64, count: usize) -> impl Iterator<Item = f64> {
    let step = duration / (count - 1) as f64;
    (0..count - 1).map(move |i| step * i as f64).chain([duration])
}

/// The sign is that of the traction on body 1 along the initial slip.
fn regime(stage: Stage, force: &Vector3<f64>, initial: &Vector3<f64>) -> Regime {
    let forward = force.xy().dot(&initial.xy()) >= 0.0;
    match (stage, forward) {
        (Stage::Adhesion, _) => Regime::Adhesion,
        (Stage::Slip, true) => Regime::SlipForward,
        (Stage::Slip, false) => Regime::SlipBackward,
        (Stage::Slide, true) => Regime::SlideForward,
        (Stage::Slide, false) => Regime::SlideBackward,
    }
}
