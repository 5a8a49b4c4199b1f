//! Whether a contact, or the largest contact of an impact, lies within the theory of elastic half-spaces.

use std::ffi::CStr;

use carom_table::short;

use crate::hertz::{Hertz, HertzState};

/// How far a contact, or the largest contact of an impact, is from the limits of the theory: four
/// ratios, 0 where a limit does not concern it. R is the smallest radius of curvature of the bodies.
///
/// ```
/// use carom_laws::validity::Validity;
/// let good = Validity { semi_axis_over_radius: 0.03, ..Validity::default() };
/// let bad = Validity { approach_over_radius: 0.25, wave_share: 0.2, ..good };
/// assert!(!good.is_outside() && bad.is_outside());
/// assert_eq!(bad.reasons().len(), 2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Validity {
    /// a/R: the larger semi-axis of the contact over R.
    pub semi_axis_over_radius: f64,
    /// zeta/R: the approach over R.
    pub approach_over_radius: f64,
    /// The greatest pressure over that at which the weaker material begins to yield; 0 if no yield
    /// stress is known.
    pub pressure_over_yield: f64,
    /// The share of the normal energy that elastic waves would carry away, if the result leaves this
    /// loss out.
    pub wave_share: f64,
}

impl Validity {
    /// Largest a/R for which Hertz's theory holds.
    pub const LARGE_CONTACT: f64 = 0.1;
    /// Largest zeta/R for which the bodies count as half-spaces.
    pub const LARGE_APPROACH: f64 = 0.1;
    /// Largest share of the energy that elastic waves may carry away, since the theory neglects them.
    pub const LARGE_WAVE_SHARE: f64 = 0.1;
    /// The share of the energy of elastic waves that is worth a word.
    pub const NOTICEABLE_WAVE_SHARE: f64 = 0.01;
    /// Pressure over yield stress at which a circular contact begins to flow below its surface: by von
    /// Mises and for nu = 0.3 the equivalent stress is greatest on the axis, .62 of the greatest pressure
    /// at the depth .48 a, and 1/.62 = 1.6. A line contact bears 1.67 Y by Tresca, 1.79 Y by von Mises.
    pub const YIELDS_AT: f64 = 1.6;
    /// What a contact that yields is told, without its number.
    pub const YIELDS: &CStr =
        c"yields: the greatest pressure exceeds 1.6 times the yield stress, from \
                                which metals flow below the surface";

    /// A contact of this larger semi-axis, approach and greatest pressure, between bodies of this smaller
    /// yield stress ([`carom_halfspace::MaterialPair::yield_stress`]; infinite if unknown) and smallest radius of curvature.
    #[must_use]
    pub fn of_contact(
        [semi_axis, approach, pressure]: [f64; 3],
        yield_stress: f64,
        radius: f64,
    ) -> Self {
        Self {
            semi_axis_over_radius: semi_axis / radius,
            approach_over_radius: approach / radius,
            pressure_over_yield: pressure / (Self::YIELDS_AT * yield_stress),
            wave_share: 0.0,
        }
    }

    /// A contact of which only the greatest pressure is known.
    #[must_use]
    pub fn of_pressure(pressure: f64, yield_stress: f64) -> Self {
        Self::of_contact([0.0, 0.0, pressure], yield_stress, f64::INFINITY)
    }

    /// A Hertz contact under load between bodies of this smallest radius of curvature.
    #[must_use]
    pub fn of_hertz(hertz: &Hertz, state: &HertzState, radius: f64) -> Self {
        let yield_stress = hertz.materials().yield_stress();
        let semi_axis = state.ellipse.semi_axis_a().max(state.ellipse.semi_axis_b());
        Self::of_contact([semi_axis, state.approach, state.peak_pressure], yield_stress, radius)
    }

    /// The worse of both in each ratio.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            semi_axis_over_radius: self.semi_axis_over_radius.max(other.semi_axis_over_radius),
            approach_over_radius: self.approach_over_radius.max(other.approach_over_radius),
            pressure_over_yield: self.pressure_over_yield.max(other.pressure_over_yield),
            wave_share: self.wave_share.max(other.wave_share),
        }
    }

    /// Whether a/R exceeds its limit.
    #[must_use]
    pub fn is_large_contact(self) -> bool {
        self.semi_axis_over_radius > Self::LARGE_CONTACT
    }

    /// Whether the approach exceeds its limit.
    #[must_use]
    pub fn is_large_approach(self) -> bool {
        self.approach_over_radius > Self::LARGE_APPROACH
    }

    /// Whether the weaker material begins to yield.
    #[must_use]
    pub fn yields(self) -> bool {
        self.pressure_over_yield > 1.0
    }

    /// Whether elastic waves are worth a word.
    #[must_use]
    pub fn has_waves(self) -> bool {
        self.wave_share > Self::NOTICEABLE_WAVE_SHARE
    }

    /// Whether all limits hold; waves count from a tenth of the energy.
    #[must_use]
    pub fn holds(self) -> bool {
        !(self.is_large_contact() || self.yields() || self.is_outside())
    }

    /// Whether results are approximate at best, as [`Validity::reasons`] say.
    #[must_use]
    pub fn is_outside(self) -> bool {
        self.is_large_approach() || self.wave_share > Self::LARGE_WAVE_SHARE
    }

    /// Whether results are meaningless: the approach exceeds the radius, or the waves the available
    /// energy.
    #[must_use]
    pub fn is_meaningless(self) -> bool {
        self.approach_over_radius > 1.0 || self.wave_share > 1.0
    }

    /// Why results are approximate at best: one text for each limit.
    #[must_use]
    pub fn reasons(self) -> Vec<String> {
        let approach = self.is_large_approach().then(|| {
            let share = short_number(self.approach_over_radius);
            format!("the approach is {share} times the radius, more than a tenth")
        });
        let waves = (self.wave_share > Self::LARGE_WAVE_SHARE).then(|| {
            let percent = short_number(100.0 * self.wave_share);
            format!("elastic waves would carry away {percent} % of the energy, more than 10 %")
        });
        approach.into_iter().chain(waves).collect()
    }
}

/// A number with three digits.
fn short_number(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
}
