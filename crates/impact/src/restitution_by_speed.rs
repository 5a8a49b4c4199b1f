//! A normal restitution that was measured at several speeds.

use std::sync::Arc;

use carom_special::RangeError;

/// Coefficients of normal restitution e at speeds of approach along the normal: straight between them, and constant below the
/// first and above the last one. From 0 to 1 each, so that no impact gains energy.
///
/// ```
/// use carom_impact::{LossCause, NormalRestitution, RestitutionBySpeed};
/// let measured = RestitutionBySpeed::new(&[0.5, 1.0, 3.0], &[0.9, 0.8, 0.7])?;
/// assert_eq!([0.1, 0.5, 1.0, 9.0].map(|speed| measured.at(speed)), [0.9, 0.9, 0.8, 0.7]);
/// assert!((measured.at(2.0) - 0.75).abs() < 1e-15);
/// let loss = NormalRestitution::by_speed(LossCause::Viscous, measured)?;
/// assert_eq!(loss.at(1.0)?, NormalRestitution::new(0.8)?);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RestitutionBySpeed(Arc<[[f64; 2]]>);

impl RestitutionBySpeed {
    /// Restitutions at these speeds, m/s.
    ///
    /// # Errors
    /// [`RangeError`] of `speed` unless they grow, from 0 on, and there are two or more; of `restitution` unless there are as
    /// many, each from 0 to 1.
    pub fn new(speeds: &[f64], restitutions: &[f64]) -> Result<Self, RangeError> {
        let [count, others] = [speeds.len(), restitutions.len()];
        RangeError::check("speed", count as f64, count >= 2, "a list of two numbers or more")?;
        RangeError::check(
            "numbers of restitution",
            others as f64,
            others == count,
            "as many as of `speed`",
        )?;
        let mut before = None;
        for &speed in speeds {
            RangeError::non_negative("speed", speed)?;
            let grows = before.is_none_or(|before| before < speed);
            RangeError::check("speed", speed, grows, "above the speed before it")?;
            before = Some(speed);
        }
        for &e in restitutions {
            let holds = (0.0..=1.0).contains(&e);
            RangeError::check("restitution", e, holds, "from 0 to 1")?;
        }
        let rows = speeds.iter().zip(restitutions).map(|(&speed, &e)| [speed, e]);
        Ok(Self(rows.collect()))
    }

    /// The restitution at a speed of approach.
    #[must_use]
    pub fn at(&self, speed: f64) -> f64 {
        let after = self.0.partition_point(|[at, _]| *at < speed);
        let row = |i: usize| self.0.get(i).copied();
        match (after.checked_sub(1).and_then(row), row(after)) {
            (Some([from, low]), Some([to, high])) => {
                let part = (speed - from) / (to - from);
                (1.0 - part) * low + part * high
            }
            (Some([_, e]), None) | (None, Some([_, e])) => e,
            (None, None) => 1.0,
        }
    }

    /// The restitutions.
    pub(crate) fn restitutions(&self) -> impl Iterator<Item = f64> {
        self.0.iter().map(|[_, e]| *e)
    }
}
