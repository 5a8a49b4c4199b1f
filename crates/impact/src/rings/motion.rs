//! Integrates shift, approach and twist through a contact, by leapfrog steps of equal length.

use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use nalgebra::Vector3;

use crate::coupled::Sample;

/// A contact that lasts longer than this many times a free impact is an error.
const PATIENCE: usize = 64;

/// Rates of approach, shift and twist: zeta, xi, eta, omega.
pub(super) type Rates = [f64; 4];

/// Initial rates and mobility in contact axes: rates change by minus mobility times load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    /// D_zz, D_xx = D_yy, and the rotational mobility of the twist.
    pub(super) mobility: [f64; 3],
    pub(super) before: Rates,
    /// Duration of the free impact.
    pub(super) duration: f64,
}

/// Rates and extremes at the end of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Passage {
    pub(super) after: Rates,
    pub(super) duration: f64,
    pub(super) maximal_approach: f64,
    pub(super) maximal_force: f64,
    pub(super) compressions: u32,
    /// Half of what the tangential rates after it change if the axes turn by half the distance of two angles; 0
    /// where symmetry fixes the axes.
    pub(super) by_direction: f64,
}

/// One instant of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Instant {
    pub(super) time: f64,
    /// zeta, xi, eta, omega since first contact.
    pub(super) shift: Rates,
    pub(super) rates: Rates,
    pub(super) load: ContactLoad,
}

/// Direction of the tangential motion: cosine and sine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Turned([f64; 2]);

impl Turned {
    fn turn(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Self([cosine, sine]) = self;
        [cosine * x - sine * y, sine * x + cosine * y]
    }

    /// The direction at this angle from it.
    pub(super) fn ahead_by(self, angle: f64) -> Self {
        let (sine, cosine) = libm::sincos(angle);
        Self(self.turn([cosine, sine]))
    }

    /// Rates in axes along this direction.
    fn rates_in(self, [speed, x, y, omega]: Rates) -> Rates {
        let Self([cosine, sine]) = self;
        let [x, y] = Self([cosine, -sine]).turn([x, y]);
        [speed, x, y, omega]
    }

    /// Rates of a motion along x, rotated to this direction.
    pub(super) fn rates_back(self, [speed, x, y, omega]: Rates) -> Rates {
        let [x, y] = self.turn([x, y]);
        [speed, x, y, omega]
    }

    /// An instant of a motion along x, rotated to this direction.
    pub(super) fn back(self, sample: Sample) -> Sample {
        let turned = |v: Vector3<f64>| {
            let [x, y] = self.turn([v.x, v.y]);
            Vector3::new(x, y, v.z)
        };
        let Sample { shift, velocity, force, .. } = sample;
        let [shift, velocity, force] = [shift, velocity, force].map(turned);
        Sample { shift, velocity, force, ..sample }
    }
}

impl Motion {
    /// The direction of the tangential velocity before.
    pub(super) fn direction(&self) -> Turned {
        let [_, x, y, _] = self.before;
        let size = libm::hypot(x, y);
        Turned(if size > 0.0 { [x / size, y / size] } else { [1.0, 0.0] })
    }

    /// The same motion in axes along this direction.
    pub(super) fn along(&self, direction: Turned) -> Self {
        Self { before: direction.rates_in(self.before), ..*self }
    }

    /// The same motion along x.
    pub(super) fn along_x(&self) -> Self {
        let [speed, x, y, omega] = self.before;
        Self { before: [speed, libm::hypot(x, y), 0.0, omega], ..*self }
    }

    /// The normal motion alone.
    pub(super) fn straight(&self) -> Self {
        Self { before: [self.before[0], 0.0, 0.0, 0.0], ..*self }
    }

    /// Integrates with a law from first contact to separation; `observe` is called at first contact, after each step and
    /// at separation. None if the bodies do not separate.
    pub(super) fn follow<L: ContactLaw>(
        &self,
        mut law: L,
        steps: usize,
        mut observe: impl FnMut(Instant, &L),
    ) -> Result<Option<Passage>, L::Error> {
        let h = self.duration / steps as f64;
        let (mut at, mut rates) = ([0.0; 4], self.before);
        let mut load = ContactLoad::default();
        let mut passage = Passage { compressions: 1, ..Passage::default() };
        observe(Instant { time: 0.0, shift: at, rates, load }, &law);
        for step in 0..PATIENCE * steps {
            // Rates at the middle of the step.
            let middle = self.pushed(&rates, &load, 0.5 * h);
            let next: Rates = std::array::from_fn(|i| at[i] + h * middle[i]);
            let ahead = self.pushed(&middle, &load, 0.5 * h);
            let depth = law.depth(as_shift(&next), as_shift(&ahead));
            if depth <= 0.0 {
                // The force decreases with the power 3/2 of the remaining time: its mean is 2/5.
                let pressed = law.depth(as_shift(&at), as_shift(&rates));
                let part = (pressed / (pressed - depth)).clamp(0.0, 1.0);
                passage.after = self.pushed(&rates, &load, 0.4 * part * h);
                passage.duration = (step as f64 + part) * h;
                let mut shift: Rates = std::array::from_fn(|i| at[i] + part * (next[i] - at[i]));
                // An elastic contact ends where its approach does, a viscous one before.
                if depth == next[0] {
                    shift[0] = 0.0;
                }
                let load = ContactLoad::default();
                observe(
                    Instant { time: passage.duration, shift, rates: passage.after, load },
                    &law,
                );
                return Ok(Some(passage));
            }
            load = law.advance_at(as_shift(&next), as_shift(&ahead), h)?;
            let old = rates[0];
            (at, rates) = (next, self.pushed(&middle, &load, 0.5 * h));
            observe(Instant { time: (step + 1) as f64 * h, shift: at, rates, load }, &law);
            passage.compressions += u32::from(old <= 0.0 && rates[0] > 0.0);
            passage.maximal_approach = passage.maximal_approach.max(next[0]);
            passage.maximal_force = passage.maximal_force.max(load.f_z);
        }
        Ok(None)
    }

    /// Rates after a load has acted for this time.
    fn pushed(&self, rates: &Rates, load: &ContactLoad, time: f64) -> Rates {
        let [along, across, about] = self.mobility;
        let pushes = [along * load.f_z, across * load.f_x, across * load.f_y, about * load.m_z];
        std::array::from_fn(|i| rates[i] - time * pushes[i])
    }
}

fn as_shift([zeta, xi, eta, omega]: &Rates) -> Shift {
    Shift { zeta: *zeta, xi: *xi, eta: *eta, omega: *omega }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal::DURATION;
    use carom_laws::friction::Friction;
    use carom_laws::shift_law::ShiftLaw;
    use carom_laws::stiffness::ContactStiffness;

    /// Hertz's impact has a known end; steps need not divide its duration.
    #[test]
    fn an_impact_ends_where_hertzs_does_within_a_step() {
        let stiffness = ContactStiffness::new(4.0, 4.0, 4.0).unwrap();
        let law = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::new(0.0).unwrap());
        for told in [1.0, 1.2345, 1.51, 1.7] {
            // D_zz at which the greatest approach is 1.
            let motion = Motion {
                mobility: [15.0 / 32.0, 1.0, 1.0],
                before: [1.0, 0.3, -0.2, 0.1],
                duration: told * DURATION,
            };
            let passage = motion.follow(law.clone(), 128, |_, _| ()).unwrap().unwrap();
            assert!((passage.duration / DURATION - 1.0).abs() < 2e-4, "{told}: {passage:?}");
            assert!((passage.after[0] + 1.0).abs() < 1e-4, "{told}: {passage:?}");
            assert_eq!(passage.after[1..], motion.before[1..]);
            assert_eq!(passage.compressions, 1);
            let off =
                (passage.maximal_approach - 1.0).hypot(passage.maximal_force / (8.0 / 3.0) - 1.0);
            assert!(off < 1e-3, "{told}: {passage:?}");
        }
    }
}
