//! Whether a contact, or the largest contact of an impact, lies within the theory of elastic half-spaces, and
//! what a result leaves out: the limits, and the words for them in every front end.

use std::ffi::CStr;
use std::fmt::{self, Display, Formatter};

use carom_halfspace::{Material, MaterialPair};
use carom_table::{Column, Value, short};

use crate::coupling::coupling_bound;
use crate::friction::Friction;
use crate::hertz::{Hertz, HertzState};

/// A limit of the theory, or an effect that a result may leave out.
///
/// ```
/// use carom_laws::validity::Limit;
/// let words = Limit::LargeContact.words().to_str()?;
/// assert_eq!(words, "large contact: a/R exceeds 0.1, beyond Hertz's theory");
/// # Ok::<(), std::str::Utf8Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Limit {
    /// The law neglects the coupling of normal and tangential displacements by dissimilar materials.
    Coupling,
    /// The contact is not small against the bodies.
    LargeContact,
    /// The bodies approach too far to be half-spaces.
    LargeApproach,
    /// The greatest pressure is large against the elastic modulus: a contact of which no radius is known is as
    /// steep as one that is large.
    LargePressure,
    /// The weaker material begins to yield.
    Yields,
    /// Elastic waves carry away energy that the result keeps.
    Waves,
    /// Friction does not act on the spin about the normal.
    Spin,
    /// The spin about the normal does not act on the tangential motion.
    SpinOnShift,
    /// An impact has too few time steps.
    TimeStep,
}

impl Limit {
    /// All limits, in the order in which they are told.
    pub const ALL: [Self; 9] = [
        Self::Coupling,
        Self::LargeContact,
        Self::LargeApproach,
        Self::LargePressure,
        Self::Yields,
        Self::Waves,
        Self::Spin,
        Self::SpinOnShift,
        Self::TimeStep,
    ];

    /// What is told where the limit is exceeded, without its number.
    #[must_use]
    pub const fn words(self) -> &'static CStr {
        match self {
            Self::Coupling => {
                c"dissimilar materials: the coupling of normal and tangential displacements is neglected"
            }
            Self::LargeContact => c"large contact: a/R exceeds 0.1, beyond Hertz's theory",
            Self::LargeApproach => c"the approach exceeds a tenth of the radius, so that the bodies are no half-spaces",
            Self::LargePressure => {
                c"the greatest pressure exceeds .064 E*, as in a round contact of a/R = 0.1: the surfaces \
                  are too steep for half-spaces"
            }
            Self::Yields => {
                c"yields: the greatest pressure exceeds 1.6 times the yield stress, from which metals \
                  flow below the surface"
            }
            Self::Waves => {
                c"elastic waves would carry away more than 1 % of the normal energy"
            }
            Self::Spin => {
                c"torsion is not computed, which would take more than 1 % of the relative spin about the normal"
            }
            Self::SpinOnShift => {
                c"the spin about the normal uses up friction, which the law leaves out"
            }
            Self::TimeStep => {
                c"the time step is too long: an impact should last 20 steps at the least, 50 for accurate \
                  friction"
            }
        }
    }

    /// The ratio above which the limit is exceeded.
    #[must_use]
    pub const fn threshold(self) -> f64 {
        match self {
            Self::Coupling => Validity::NEGLIGIBLE_COUPLING,
            Self::LargeContact => Validity::LARGE_CONTACT,
            Self::LargeApproach => Validity::LARGE_APPROACH,
            Self::LargePressure => Validity::LARGE_PRESSURE,
            Self::Yields => 1.0,
            Self::Waves => Validity::NOTICEABLE_WAVE_SHARE,
            Self::Spin => Validity::NOTICEABLE_SPIN_SHARE,
            Self::SpinOnShift => Validity::NEGLIGIBLE_COUPLING,
            Self::TimeStep => Validity::LONG_STEP,
        }
    }
}

/// The words for waves that leave the theory.
const MANY_WAVES: &str = "elastic waves would carry away more than 10 % of the normal energy";

/// A limit that is exceeded, and by how much. As a text it is what all front ends tell.
///
/// ```
/// use carom_laws::validity::{Excess, Limit};
/// let excess = Excess { limit: Limit::LargeContact, value: 0.19 };
/// let told = "large contact: a/R exceeds 0.1, beyond Hertz's theory: it is 0.19";
/// assert_eq!(excess.to_string(), told);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Excess {
    /// The limit.
    pub limit: Limit,
    /// The ratio that exceeds it, as in [`Validity`].
    pub value: f64,
}

impl Display for Excess {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let words = match self.limit {
            Limit::Waves if self.value > Validity::LARGE_WAVE_SHARE => MANY_WAVES,
            limit => limit.words().to_str().map_err(|_| fmt::Error)?,
        };
        let percent = short_number(100.0 * self.value);
        let number = short_number(self.value);
        match self.limit {
            Limit::Coupling | Limit::SpinOnShift => {
                write!(f, "{words}: R_x of an impact changes by up to {number}")
            }
            Limit::LargeContact => write!(f, "{words}: it is {number}"),
            Limit::LargeApproach => write!(f, "{words}: it is {number} times the radius"),
            Limit::LargePressure => write!(f, "{words}: it is {number} E*"),
            Limit::Yields => write!(f, "{words}: it is {number} times that"),
            Limit::Waves => write!(f, "{words}: about {percent} %"),
            Limit::Spin => write!(f, "{words}: up to {percent} %"),
            Limit::TimeStep => {
                let steps = short_number(1.0 / self.value);
                write!(f, "{words}: the shortest lasts {steps}")
            }
        }
    }
}

/// How far a contact, or the largest contact of an impact, is from the limits of the theory, and how much a
/// result leaves out: ratios, 0 where a limit does not concern it. R is the smallest radius of curvature of the
/// bodies.
///
/// ```
/// use carom_laws::validity::Validity;
/// let good = Validity { semi_axis_over_radius: 0.03, ..Validity::default() };
/// let bad = Validity { approach_over_radius: 0.25, wave_share: 0.2, ..good };
/// assert!(!good.is_outside() && bad.is_outside());
/// assert_eq!(good.exceeded().count(), 0);
/// assert_eq!(bad.exceeded().count(), 2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Validity {
    /// a/R: the larger semi-axis of the contact over R.
    pub semi_axis_over_radius: f64,
    /// zeta/R: the approach over R.
    pub approach_over_radius: f64,
    /// The greatest pressure over E*, for contacts of which no radius is known.
    pub pressure_over_modulus: f64,
    /// The greatest pressure over that at which the weaker material begins to yield; 0 if no yield
    /// stress is known.
    pub pressure_over_yield: f64,
    /// The share of the normal energy that elastic waves would carry away, if the result leaves this
    /// loss out.
    pub wave_share: f64,
    /// A bound of the change of R_x by the coupling of dissimilar materials
    /// ([`coupling_bound`]), if the result leaves it out.
    pub coupling: f64,
    /// The share of the relative spin about the normal that friction would take at most, if the result leaves
    /// this out.
    pub spin_share: f64,
    /// A bound of the change of R_x by the spin about the normal, if the result leaves it out.
    pub spin_on_shift: f64,
    /// The time step over the duration of the shortest impact; 0 without time steps.
    pub step_over_duration: f64,
}

impl Validity {
    /// Largest a/R for which Hertz's theory holds.
    pub const LARGE_CONTACT: f64 = 0.1;
    /// Largest zeta/R for which the bodies count as half-spaces.
    pub const LARGE_APPROACH: f64 = 0.1;
    /// Largest p/E*: Hertz's round contact of a/R = [`Self::LARGE_CONTACT`] has `p_0/E* = (2/pi) a/R`.
    pub const LARGE_PRESSURE: f64 = Self::LARGE_CONTACT * std::f64::consts::FRAC_2_PI;
    /// Largest share of the energy that elastic waves may carry away, since the theory neglects them.
    pub const LARGE_WAVE_SHARE: f64 = 0.1;
    /// The share of the energy of elastic waves that is worth a word.
    pub const NOTICEABLE_WAVE_SHARE: f64 = 0.01;
    /// Largest change of R_x by coupling or by the spin about the normal, left out, that is not worth a word.
    pub const NEGLIGIBLE_COUPLING: f64 = 5e-3;
    /// The share of the spin about the normal, left out, that is worth a word.
    pub const NOTICEABLE_SPIN_SHARE: f64 = 0.01;
    /// Longest time step over the duration of an impact: 20 steps. By 50 steps the error of R_x is
    /// below 1e-3.
    pub const LONG_STEP: f64 = 1.0 / 20.0;
    /// Pressure over yield stress at which a circular contact begins to flow below its surface: by von
    /// Mises and for nu = 0.3 the equivalent stress is greatest on the axis, .62 of the greatest pressure
    /// at the depth .48 a, and 1/.62 = 1.6. A line contact bears 1.67 Y by Tresca, 1.79 Y by von Mises.
    pub const YIELDS_AT: f64 = 1.6;

    /// What [`Self::OVER_YIELD`] means.
    pub const OVER_YIELD_MEANS: &str =
        "peak_pressure over 1.6 times the yield stress, if that is known: from 1 on a body yields";

    /// [`Self::pressure_over_yield`] as a column; absent if no yield stress is known.
    pub const OVER_YIELD: Column<Self> =
        Column::new("pressure_over_yield", "", Self::OVER_YIELD_MEANS, |validity| {
            let over = validity.pressure_over_yield;
            (over > 0.0).then_some(over).map_or(Value::Absent, Value::Number)
        });

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
            ..Self::default()
        }
    }

    /// A Hertz contact under load between bodies of this smallest radius of curvature.
    #[must_use]
    pub fn of_hertz(hertz: &Hertz, state: &HertzState, radius: f64) -> Self {
        let yield_stress = hertz.materials().yield_stress();
        let semi_axis = state.ellipse.semi_axis_a().max(state.ellipse.semi_axis_b());
        Self::of_contact([semi_axis, state.approach, state.peak_pressure], yield_stress, radius)
    }

    /// The same for a law that neglects the coupling of these materials under this friction.
    #[must_use]
    pub fn without_coupling(self, materials: &MaterialPair, friction: Friction) -> Self {
        Self { coupling: coupling_bound(materials.gamma(), friction), ..self }
    }

    /// The worse of both in each ratio.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            semi_axis_over_radius: self.semi_axis_over_radius.max(other.semi_axis_over_radius),
            approach_over_radius: self.approach_over_radius.max(other.approach_over_radius),
            pressure_over_modulus: self.pressure_over_modulus.max(other.pressure_over_modulus),
            pressure_over_yield: self.pressure_over_yield.max(other.pressure_over_yield),
            wave_share: self.wave_share.max(other.wave_share),
            coupling: self.coupling.max(other.coupling),
            spin_share: self.spin_share.max(other.spin_share),
            spin_on_shift: self.spin_on_shift.max(other.spin_on_shift),
            step_over_duration: self.step_over_duration.max(other.step_over_duration),
        }
    }

    /// The ratio of a limit.
    #[must_use]
    pub const fn ratio(self, limit: Limit) -> f64 {
        match limit {
            Limit::Coupling => self.coupling,
            Limit::LargeContact => self.semi_axis_over_radius,
            Limit::LargeApproach => self.approach_over_radius,
            Limit::LargePressure => self.pressure_over_modulus,
            Limit::Yields => self.pressure_over_yield,
            Limit::Waves => self.wave_share,
            Limit::Spin => self.spin_share,
            Limit::SpinOnShift => self.spin_on_shift,
            Limit::TimeStep => self.step_over_duration,
        }
    }

    /// Whether a limit is exceeded, and by how much.
    #[must_use]
    pub fn excess(self, limit: Limit) -> Option<Excess> {
        let value = self.ratio(limit);
        (value > limit.threshold()).then_some(Excess { limit, value })
    }

    /// The limits that are exceeded.
    pub fn exceeded(self) -> impl Iterator<Item = Excess> {
        Limit::ALL.into_iter().filter_map(move |limit| self.excess(limit))
    }

    /// Whether all limits hold but those on what a result leaves out; waves count from a tenth of the energy.
    #[must_use]
    pub fn holds(self) -> bool {
        let kept = [Limit::LargeContact, Limit::LargePressure, Limit::Yields, Limit::TimeStep];
        !self.is_outside() && kept.into_iter().all(|limit| self.excess(limit).is_none())
    }

    /// Whether results are approximate at best, as [`Validity::reasons`] say.
    #[must_use]
    pub fn is_outside(self) -> bool {
        self.excess(Limit::LargeApproach).is_some() || self.wave_share > Self::LARGE_WAVE_SHARE
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
        let approach = self.excess(Limit::LargeApproach);
        let waves = self.excess(Limit::Waves).filter(|waves| waves.value > Self::LARGE_WAVE_SHARE);
        approach.into_iter().chain(waves).map(|excess| excess.to_string()).collect()
    }
}

/// What two bodies bear, for contacts of which only the greatest pressure is known, such as those on a grid.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::validity::{Limit, PressureLimits};
/// let rubber = Material::from_young(5e6, 0.5)?;
/// let limits = PressureLimits::of(&MaterialPair::new(rubber, Material::RIGID)?);
/// assert!(limits.validity(0.4e6).holds());
/// assert!(limits.validity(0.5e6).excess(Limit::LargePressure).is_some());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureLimits {
    yield_stress: f64,
    /// E*; infinite where the bodies are no half-spaces.
    modulus: f64,
}

impl PressureLimits {
    /// Those of two half-spaces.
    #[must_use]
    pub fn of(materials: &MaterialPair) -> Self {
        Self { yield_stress: materials.yield_stress(), modulus: materials.contact_modulus() }
    }

    /// Those of a half-space under a counter-body that is not known: as under a rigid one.
    #[must_use]
    pub fn of_body(material: &Material) -> Self {
        let modulus = 2.0 * material.shear_modulus() / (1.0 - material.poisson());
        Self { yield_stress: material.yield_stress(), modulus }
    }

    /// Those of other bodies than half-spaces: only yielding counts.
    #[must_use]
    pub fn without_half_spaces(self) -> Self {
        Self { modulus: f64::INFINITY, ..self }
    }

    /// How far a contact of this greatest pressure is from the limits of the theory.
    #[must_use]
    pub fn validity(self, pressure: f64) -> Validity {
        Validity {
            pressure_over_modulus: pressure / self.modulus,
            ..Validity::of_contact([0.0, 0.0, pressure], self.yield_stress, f64::INFINITY)
        }
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
        let limits = PressureLimits::of_body(&body.yielding_at(1e9).unwrap());
        let on_rigid = PressureLimits::of(&MaterialPair::new(body, Material::RIGID).unwrap());
        assert!((on_rigid.modulus / limits.modulus - 1.0).abs() < 1e-15);
        let yields = |pressure| limits.validity(pressure).excess(Limit::Yields).is_some();
        assert!(yields(1.01e9 / most) && !yields(0.98e9 / most));
        let other = PressureLimits::of_body(&body).without_half_spaces();
        assert_eq!(other.validity(1e12).exceeded().count(), 0);
    }

    #[test]
    fn each_ratio_has_the_scale_of_the_contact() {
        let body = Material::from_young(208e9, 0.3).unwrap().yielding_at(1e9).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let radius = 0.0125;
        let contact = |a: f64, b: f64| {
            let curvature = RelativeCurvature::from_coefficients(a, b).unwrap();
            let hertz = Hertz::new(curvature, pair).unwrap();
            let state = hertz.at_force(1000.0).unwrap();
            (Validity::of_hertz(&hertz, &state, radius), state)
        };
        // The contact is longer where the bodies are less curved.
        let (turned, state) = contact(40.0, 10.0);
        assert_eq!(turned.semi_axis_over_radius, state.ellipse.semi_axis_b() / radius);
        let (validity, state) = contact(10.0, 40.0);
        assert_eq!(validity.semi_axis_over_radius, state.ellipse.semi_axis_a() / radius);
        assert_eq!(validity.semi_axis_over_radius, turned.semi_axis_over_radius);
        assert_eq!(validity.approach_over_radius, state.approach / radius);
        let over = state.peak_pressure / 1.6e9;
        assert!((validity.pressure_over_yield / over - 1.0).abs() < 1e-15);
        // Of two contacts the worse one counts, ratio by ratio.
        let other = Validity::of_contact([0.2, 0.02, 1.0], f64::INFINITY, 1.0);
        let worst = validity.and(other);
        assert_eq!(worst.semi_axis_over_radius, 0.2);
        assert_eq!(worst.pressure_over_yield, validity.pressure_over_yield);
        assert!(worst.excess(Limit::LargeContact).is_some());
        assert_eq!(other.excess(Limit::LargeApproach), None);
        let deep = Validity::of_contact([0.0, 0.11, 1.0], f64::INFINITY, 1.0);
        let excess = Excess { limit: Limit::LargeApproach, value: 0.11 };
        assert_eq!(deep.exceeded().collect::<Vec<_>>(), [excess]);
    }

    /// A contact on a grid is told of at the pressure of Hertz's circle of the same materials at a/R = .1.
    #[test]
    fn the_pressure_of_a_large_round_contact_is_large() {
        let [soft, hard] =
            [(5e6, 0.49), (7e7, 0.3)].map(|(e, nu)| Material::from_young(e, nu).unwrap());
        let pair = MaterialPair::new(soft, hard).unwrap();
        let gap = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
        let hertz = Hertz::new(gap, pair).unwrap();
        let told = |a: f64| {
            let state = hertz.at_approach(a * a).unwrap();
            approx::assert_relative_eq!(state.ellipse.semi_axis_a(), a, max_relative = 1e-9);
            PressureLimits::of(&pair).validity(state.peak_pressure).excess(Limit::LargePressure)
        };
        assert!(told(0.0999).is_none() && told(0.1001).is_some());
    }

    /// Each ratio with its limit: nothing is told there, and its own words just above.
    #[test]
    fn each_limit_is_told_above_its_threshold_with_its_number() {
        let none = Validity::default();
        let of = |value: f64| {
            [
                Validity { coupling: 5e-3 * value, ..none },
                Validity { semi_axis_over_radius: 0.1 * value, ..none },
                Validity { approach_over_radius: 0.1 * value, ..none },
                Validity { pressure_over_modulus: Validity::LARGE_PRESSURE * value, ..none },
                Validity { pressure_over_yield: value, ..none },
                Validity { wave_share: 0.01 * value, ..none },
                Validity { spin_share: 0.01 * value, ..none },
                Validity { spin_on_shift: 5e-3 * value, ..none },
                Validity { step_over_duration: value / 20.0, ..none },
            ]
        };
        let numbers =
            ["0.01", "0.2", "0.2", "0.127 E*", "2 times", "2 %", "2 %", "0.01", "lasts 10"];
        for (i, limit) in Limit::ALL.into_iter().enumerate() {
            let [at, above] = [1.0, 2.0].map(|value| of(value)[i]);
            let sides = [1.0 - 1e-9, 1.0 + 1e-9].map(|value| of(value)[i].exceeded().count());
            assert_eq!(sides, [0, 1], "{limit:?}");
            assert_eq!(at.exceeded().count(), 0, "{limit:?}");
            let told: Vec<_> = above.exceeded().collect();
            assert_eq!(told.iter().map(|excess| excess.limit).collect::<Vec<_>>(), [limit]);
            let (text, words) = (told[0].to_string(), limit.words().to_str().unwrap());
            assert!(text.starts_with(words) && text.contains(numbers[i]), "{text}");
            // Of two results the worse one counts.
            assert_eq!([at.and(above), above.and(at)], [above; 2]);
        }
    }

    #[test]
    fn what_a_result_leaves_out_does_not_make_it_wrong() {
        let none = Validity::default();
        let left_out = Validity {
            coupling: 0.7,
            spin_share: 0.5,
            spin_on_shift: 0.5,
            wave_share: 0.09,
            ..none
        };
        assert!(left_out.holds() && !left_out.is_outside() && left_out.exceeded().count() == 4);
        let wrong = [
            Validity { semi_axis_over_radius: 0.11, ..none },
            Validity { approach_over_radius: 0.11, ..none },
            Validity { pressure_over_modulus: 0.07, ..none },
            Validity { pressure_over_yield: 1.1, ..none },
            Validity { wave_share: 0.11, ..none },
            Validity { step_over_duration: 0.06, ..none },
        ];
        assert!(wrong.iter().all(|validity| !validity.holds()));
        let outside: Vec<bool> = wrong.iter().map(|validity| validity.is_outside()).collect();
        assert_eq!(outside, [false, true, false, false, true, false]);
        // A body pressed deeper than its radius, or one that radiates more than all, is nonsense.
        let meaningless = |approach_over_radius: f64, wave_share: f64| {
            Validity { approach_over_radius, wave_share, ..none }.is_meaningless()
        };
        assert!(!meaningless(1.0, 1.0) && meaningless(1.01, 0.0) && meaningless(0.0, 1.01));
    }

    #[test]
    fn many_waves_are_told_with_the_limit_that_they_exceed() {
        let told = |wave_share| Validity { wave_share, ..Validity::default() }.reasons();
        assert_eq!(told(0.09), [""; 0]);
        let words =
            "elastic waves would carry away more than 10 % of the normal energy: about 93.9 %";
        assert_eq!(told(0.939), [words]);
    }

    /// Alumina on glass, of which the coupling is left out: gamma from the moduli, (15.2).
    #[test]
    fn neglected_coupling_has_its_bound() {
        let [one, two] = [(380e9, 0.23), (70e9, 0.22)]
            .map(|(young, poisson)| Material::from_young(young, poisson).unwrap());
        let softness = |young: f64, poisson: f64| {
            let shear = young / (2.0 * (1.0 + poisson));
            [(1.0 - 2.0 * poisson) / (4.0 * shear), (1.0 - poisson) / (2.0 * shear)]
        };
        let [[e_1, s_1], [e_2, s_2]] = [softness(380e9, 0.23), softness(70e9, 0.22)];
        let square = ((e_1 - e_2) / (s_1 + s_2)).powi(2);
        let over = square / (0.09 * 0.09);
        let expected = over / (4.0 + over) + square;
        let of = |pair: [Material; 2]| {
            let materials = MaterialPair::new(pair[0], pair[1]).unwrap();
            Validity::default().without_coupling(&materials, Friction::new(0.09).unwrap()).coupling
        };
        assert!((of([one, two]) / expected - 1.0).abs() < 1e-12, "{} {expected}", of([one, two]));
        assert_eq!([of([one; 2]), of([two; 2])], [0.0; 2]);
    }
}
