//! How a wall moves: an oscillation, or a table of positions.

use carom_special::RangeError;
use nalgebra::Vector3;
use std::f64::consts::TAU;

use super::flight::{Flight, along};

/// The displacement of a wall from its place, as a function of time.
///
/// ```
/// use carom_impact::scene::WallMotion;
/// let shaker = WallMotion::oscillation([0.0, 0.0, 1e-3], 0.02, 0.0)?;
/// assert!((shaker.displacement(5e-3).z - 1e-3).abs() < 1e-18);
/// let lift = WallMotion::positions(&[[0.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.5]])?;
/// assert_eq!((lift.displacement(1.0).z, lift.velocity(1.0).z), (0.25, 0.25));
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct WallMotion(Course);

#[derive(Debug, Clone, PartialEq)]
enum Course {
    Oscillation {
        amplitude: Vector3<f64>,
        omega: f64,
        phase: f64,
    },
    /// Times and displacements; constant before the first and after the last, straight between them.
    Positions(Vec<(f64, Vector3<f64>)>),
}

/// The velocity up to a row of a table, from the row before it on.
fn velocity_before(places: &[(f64, Vector3<f64>)], next: usize) -> Vector3<f64> {
    match (next.checked_sub(1).map(|last| places[last]), places.get(next)) {
        (Some((from, place)), Some((to, end))) => (end - place) / (to - from),
        _ => Vector3::zeros(),
    }
}

/// A step in which a ball that touches without moving stays where it is within round-off, s.
const TOUCHING: f64 = 1e-9;
/// Steps to a meeting; each is at least half of the way that the greatest acceleration allows.
const MOST_STEPS: usize = 1_000_000;

impl WallMotion {
    /// The displacement `amplitude` sin(2 pi t/period + phase), with the phase in radians.
    ///
    /// # Errors
    /// [`RangeError`] unless all are finite and the period is positive.
    pub fn oscillation(amplitude: [f64; 3], period: f64, phase: f64) -> Result<Self, RangeError> {
        for value in amplitude {
            RangeError::finite("amplitude", value)?;
        }
        let omega = TAU / RangeError::positive("period", period)?;
        RangeError::check("period", period, omega.is_finite(), "not so short")?;
        let phase = RangeError::finite("phase", phase)?;
        Ok(Self(Course::Oscillation { amplitude: amplitude.into(), omega, phase }))
    }

    /// Displacements [t, x, y, z], straight between these times, constant before and after them.
    ///
    /// # Errors
    /// [`RangeError`] unless there are two or more, all finite, and the times increase.
    pub fn positions(rows: &[[f64; 4]]) -> Result<Self, RangeError> {
        RangeError::check("positions", rows.len() as f64, rows.len() >= 2, "at least 2 rows")?;
        for [time, place @ ..] in rows {
            RangeError::finite("positions", *time)?;
            for value in place {
                RangeError::finite("positions", *value)?;
            }
        }
        for two in rows.windows(2) {
            RangeError::check(
                "positions",
                two[1][0],
                two[1][0] > two[0][0],
                "later than the row before",
            )?;
        }
        let place = |[time, x, y, z]: &[f64; 4]| (*time, Vector3::new(*x, *y, *z));
        Ok(Self(Course::Positions(rows.iter().map(place).collect())))
    }

    /// The displacement at a time.
    #[must_use]
    pub fn displacement(&self, time: f64) -> Vector3<f64> {
        match &self.0 {
            Course::Oscillation { amplitude, omega, phase } => {
                amplitude * libm::sin(omega * time + phase)
            }
            Course::Positions(places) => {
                let next = places.partition_point(|(at, _)| *at <= time);
                match (next.checked_sub(1).map(|last| places[last]), places.get(next)) {
                    (Some((from, place)), Some((to, end))) => {
                        place + (time - from) / (to - from) * (end - place)
                    }
                    (Some((_, place)), None) => place,
                    (None, _) => places[0].1,
                }
            }
        }
    }

    /// The velocity at a time; at a time of the table that from then on.
    #[must_use]
    pub fn velocity(&self, time: f64) -> Vector3<f64> {
        match &self.0 {
            Course::Oscillation { amplitude, omega, phase } => {
                amplitude * (omega * libm::cos(omega * time + phase))
            }
            Course::Positions(places) => {
                velocity_before(places, places.partition_point(|(at, _)| *at <= time))
            }
        }
    }

    /// The period of an oscillation; 0 of a table.
    fn period(&self) -> f64 {
        match &self.0 {
            Course::Oscillation { omega, .. } => TAU / omega,
            Course::Positions(_) => 0.0,
        }
    }

    /// The acceleration at a time; that of a table is 0 between its times.
    pub(super) fn acceleration(&self, time: f64) -> Vector3<f64> {
        match &self.0 {
            Course::Oscillation { omega, .. } => -omega * omega * self.displacement(time),
            Course::Positions(_) => Vector3::zeros(),
        }
    }

    /// The time after `start`, up to `end`, at which a gap along `normal` to the wall closes for a ball in flight.
    pub(super) fn closing(
        &self,
        start: f64,
        flight: &Flight,
        gap: f64,
        normal: &Vector3<f64>,
        end: f64,
    ) -> Result<Option<f64>, RangeError> {
        match &self.0 {
            Course::Oscillation { amplitude, omega, .. } => {
                let reach = amplitude.dot(normal).abs();
                let most = along(&flight.gravity, normal).abs() + reach * omega * omega;
                // Nothing is met above the highest place of the wall.
                let above = gap - (reach - self.displacement(start).dot(normal));
                let from = match above > 0.0 {
                    true => match flight.closing(above, normal) {
                        Some(from) => from,
                        None => return Ok(None),
                    },
                    false => 0.0,
                };
                if most == 0.0 {
                    return Ok(flight.closing(gap, normal).filter(|time| *time <= end));
                }
                self.stepped(start, flight, gap, normal, [from, end, most])
            }
            Course::Positions(places) => {
                // Piece by piece of the table: a time after the start has lost some of the digits of a time of the table.
                let (mut from, mut place) = (0.0, self.displacement(start));
                let origin = flight.position - place;
                for next in places.partition_point(|(at, _)| *at <= start)..=places.len() {
                    let to = places.get(next).map_or(end, |(at, _)| end.min(at - start));
                    let relative = Flight {
                        position: flight.position_after(from),
                        velocity: flight.velocity_after(from) - velocity_before(places, next),
                        gravity: flight.gravity,
                    };
                    let now = gap + (relative.position - place - origin).dot(normal);
                    // Round-off of a gap that is about to open.
                    let now = if from > 0.0 { now.max(0.0) } else { now };
                    let closing = relative.closing(now, normal).filter(|time| from + time <= to);
                    if closing.is_some() || to >= end {
                        return Ok(closing.map(|time| from + time));
                    }
                    (from, place) = (to, places[next].1);
                }
                Ok(None)
            }
        }
    }

    /// The same by steps that cannot pass the first root, since the gap accelerates by at most `most`.
    fn stepped(
        &self,
        start: f64,
        flight: &Flight,
        gap: f64,
        normal: &Vector3<f64>,
        [from, end, most]: [f64; 3],
    ) -> Result<Option<f64>, RangeError> {
        let origin = self.displacement(start).dot(normal);
        let (v, g) = (along(&flight.velocity, normal), along(&flight.gravity, normal));
        let gap_at = |t: f64| {
            gap + t * (v + 0.5 * t * g) - (self.displacement(start + t).dot(normal) - origin)
        };
        let rate_at = |t: f64| v + t * g - self.velocity(start + t).dot(normal);
        let mut t = from;
        for _ in 0..MOST_STEPS {
            let (left, rate) = (gap_at(t).max(0.0), rate_at(t));
            if left == 0.0 && rate < 0.0 {
                return Ok(Some(t));
            }
            // The root of left + rate s - most s^2/2, without cancellation.
            let root = (rate * rate + 2.0 * most * left).sqrt();
            let step = match (rate > 0.0, root > 0.0) {
                (true, _) => (rate + root) / most,
                (false, true) => 2.0 * left / (root - rate),
                // It touches without moving: what follows shows where it goes.
                (false, false) => TOUCHING,
            };
            if t + step > end {
                return Ok(None);
            }
            if step <= f64::EPSILON * t {
                return Ok((rate < 0.0).then_some(t));
            }
            t += step;
        }
        let allowed =
            "such that the ball meets the oscillating wall within a million steps of the search";
        Err(RangeError::new("period", self.period(), allowed))
    }
}
