//! The greatest approach and normal force of a run, between its instants.

use carom_impact::coupled::Sample;

#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Peak {
    pub(crate) approach: f64,
    pub(crate) force: f64,
}

impl Peak {
    /// Where the approach turns back, its rate is taken to be linear in time, and the force to follow the power
    /// 3/2 of the approach.
    pub(crate) fn of(samples: &[Sample]) -> Self {
        let seen = samples.iter().map(|at| Self { approach: at.shift.z, force: at.force.z });
        let turns = samples.windows(2).filter_map(|pair| Self::between(&pair[0], &pair[1]));
        seen.chain(turns).fold(Self::default(), |a, b| Self {
            approach: a.approach.max(b.approach),
            force: a.force.max(b.force),
        })
    }

    fn between(from: &Sample, to: &Sample) -> Option<Self> {
        let (before, after) = (from.velocity.z, to.velocity.z);
        if !(before > 0.0 && after <= 0.0) {
            return None;
        }
        let part = before / (before - after);
        let approach = from.shift.z + 0.5 * part * before * (to.time - from.time);
        let near = if from.shift.z > to.shift.z { from } else { to };
        if near.shift.z <= 0.0 {
            return None;
        }
        let growth = (approach / near.shift.z).max(1.0);
        Some(Self { approach, force: near.force.z * growth * growth.sqrt() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_impact::coupled::Stage;
    use nalgebra::Vector3;

    #[test]
    fn the_peak_of_a_parabola_is_met_between_two_instants() {
        // zeta = t (2 - t), F = zeta^(3/2): 1 at t = 1.
        let at = |time: f64| {
            let zeta = time * (2.0 - time);
            Sample {
                time,
                shift: Vector3::new(0.0, 0.0, zeta),
                velocity: Vector3::new(0.0, 0.0, 2.0 - 2.0 * time),
                force: Vector3::new(0.0, 0.0, zeta * zeta.sqrt()),
                stage: Stage::Adhesion,
            }
        };
        let peak = Peak::of(&[at(0.0), at(0.4), at(0.9), at(1.3), at(1.9)]);
        assert!((peak.approach - 1.0).abs() < 1e-14 && (peak.force - 1.0).abs() < 1e-14);
        // On the way up only: the last instant.
        assert_eq!(Peak::of(&[at(0.0), at(0.4)]).approach, at(0.4).shift.z);
    }
}
