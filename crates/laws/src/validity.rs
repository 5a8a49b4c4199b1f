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

#[cfg(test)]
mod tests {
    use carom_halfspace::{Material, MaterialPair, Point, Traction};

    use super::*;
    use crate::curvature::RelativeCurvature;
    use crate::ellipse::ContactEllipse;
    use crate::field::partial_slip_stress;

    /// Von Mises' stress on the axis below Hertz's circle, for nu = 0.3.
    #[test]
    fn a_circle_yields_where_the_stress_below_it_does() {
        let body = Material::from_young(208e9, 0.3).unwrap();
        let circle = ContactEllipse::new(1.0, 1.0).unwrap();
        let peak = Traction { x: 0.0, y: 0.0, normal: 1.0 };
        let at = |z: f64| {
            let point = Point { x: 0.0, y: 0.0, z };
            partial_slip_stress(circle, body, peak, 1.0, point).unwrap().von_mises()
        };
        let most = (1..200).map(|i| at(0.01 * f64::from(i))).fold(0.0, f64::max);
        assert!((Validity::YIELDS_AT * most - 1.0).abs() < 0.01, "{most}");
        let yields = |pressure| Validity::of_pressure(pressure, 1e9).yields();
        assert!(yields(1.01e9 / most) && !yields(0.98e9 / most));
        assert!(!Validity::of_pressure(1e12, f64::INFINITY).yields());
    }

    #[test]
    fn each_ratio_has_the_scale_of_the_contact() {
        let body = Material::from_young(208e9, 0.3).unwrap().yielding_at(1e9).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let curvature = RelativeCurvature::from_coefficients(10.0, 40.0).unwrap();
        let hertz = Hertz::new(curvature, pair).unwrap();
        let state = hertz.at_force(1000.0).unwrap();
        let radius = 0.0125;
        let validity = Validity::of_hertz(&hertz, &state, radius);
        let wide = state.ellipse.semi_axis_a().max(state.ellipse.semi_axis_b());
        assert_eq!(validity.semi_axis_over_radius, wide / radius);
        assert_eq!(validity.approach_over_radius, state.approach / radius);
        let over = state.peak_pressure / 1.6e9;
        assert!((validity.pressure_over_yield / over - 1.0).abs() < 1e-15);
        // Of two contacts the worse one counts, ratio by ratio.
        let other = Validity::of_contact([0.2, 0.02, 1.0], f64::INFINITY, 1.0);
        let worst = validity.and(other);
        assert_eq!(worst.semi_axis_over_radius, 0.2);
        assert_eq!(worst.pressure_over_yield, validity.pressure_over_yield);
        assert!(worst.is_large_contact() && !other.is_large_approach());
        assert!(Validity::of_contact([0.0, 0.11, 1.0], 1.0, 1.0).is_large_approach());
    }
}
