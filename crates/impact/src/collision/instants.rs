//! The instants at which a history is given.

use carom_special::RangeError;
use nalgebra::Vector3;

use crate::outcome::HistoryPoint;

/// The instants at which the history of a collision is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Instants<'a> {
    /// So many, at least two, equally spaced from first contact to separation.
    Count(usize),
    /// These times since first contact, ascending. Before it and after separation the bodies move on without a force.
    At(&'a [f64]),
}

impl From<usize> for Instants<'_> {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl<'a> From<&'a [f64]> for Instants<'a> {
    fn from(times: &'a [f64]) -> Self {
        Self::At(times)
    }
}

impl Instants<'_> {
    /// Checks the number of instants, and that times are finite and ascend.
    ///
    /// # Errors
    /// [`RangeError`] otherwise.
    pub fn check(self) -> Result<(), RangeError> {
        let times = match self {
            Self::Count(count) => {
                return RangeError::check("points", count as f64, count >= 2, ">= 2").map(|_| ());
            }
            Self::At(times) => times,
        };
        times.iter().try_for_each(|time| RangeError::finite("time", *time).map(|_| ()))?;
        let back = times.windows(2).find(|pair| pair[1] < pair[0]);
        back.map_or(Ok(()), |pair| {
            Err(RangeError::new("time", pair[1], "not before the time ahead of it"))
        })
    }

    /// The instants within a contact of this duration, in these units of time. After given times comes separation.
    pub(crate) fn within(self, duration: f64, unit: f64) -> Vec<f64> {
        match self {
            Self::Count(count) => {
                let step = duration / (count - 1) as f64;
                (0..count - 1).map(|i| step * i as f64).chain([duration]).collect()
            }
            Self::At(times) => {
                let within = times.iter().map(|time| (time / unit).clamp(0.0, duration));
                within.chain([duration]).collect()
            }
        }
    }

    /// The history at these instants, from that [`Instants::within`] the contact.
    pub(crate) fn finish(self, mut points: Vec<HistoryPoint>) -> Vec<HistoryPoint> {
        let Self::At(times) = self else { return points };
        let duration = points.pop().map_or(0.0, |last| last.time);
        for (point, time) in points.iter_mut().zip(times) {
            if *time <= 0.0 || *time >= duration {
                point.shift += point.velocity * (*time - point.time);
                point.force = Vector3::zeros();
                point.semi_axes = [0.0; 2];
                point.stick_radius = point.stick_radius.map(|_| 0.0);
            }
            point.time = *time;
        }
        points
    }
}
