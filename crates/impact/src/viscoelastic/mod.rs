//! Oblique impact of viscoelastic bodies whose normal and tangential motions are uncoupled.
//!
//! Materials of Kelvin and Voigt: each stress has a viscous companion, tau times the rate of the elastic one, in shear and
//! in compression alike. This is the limit of every material whose relaxation is fast compared to the impact. The contact
//! is then exactly a row of independent springs, viscous like the material, in compression and in rebound, as long as
//! contact and stick area are discs: Abel's transforms of pressure and traction are related to those of the displacements
//! place by place (Lee and Radok 1960, Ting 1966 for the normal, Jaeger and Ciavarella for the tangential direction;
//! W. Willert, S. Kusche, V. L. Popov, Facta Univ. Mech. Eng. 15, 2017). Coulomb's limit is f times the whole normal
//! pressure, its viscous part included. R_x then depends on chi, psi and the restitution e alone.
//!
//! - The normal motion is a set of polynomial equations (`pulse.rs`).
//! - The shift moves the springs by the implicit midpoint rule (`springs.rs`); the springs are those that touch in the steps
//!   of compression, so that no cell is cut there.
//! - Two runs, the second with twice as many steps, are extrapolated.

mod pulse;
mod relaxing;
mod run;
mod springs;

use carom_laws::viscous::Viscosity;
use carom_special::RangeError;

use crate::oblique::Groups;
use pulse::Pulse;
use relaxing::Relaxation;
pub(crate) use run::Instant;
use run::{Ends, Run};

/// The loss of a viscoelastic material in an impact.
///
/// ```
/// use carom_impact::viscoelastic::ViscousLoss;
/// let loss = ViscousLoss::of_restitution(0.5)?;
/// assert!((loss.relaxation() - 0.502513).abs() < 1e-6);
/// assert!((ViscousLoss::of_relaxation(0.502513)?.restitution() - 0.5).abs() < 1e-6);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscousLoss {
    rheology: Rheology,
    restitution: f64,
    /// The relaxation time, or alpha of a constant loss tangent.
    parameter: f64,
}

/// How stress relaxes in a material that loses energy, in shear and in compression alike.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Rheology {
    /// Kelvin and Voigt: each stress has a viscous companion, tau times the rate of the elastic one.
    #[default]
    KelvinVoigt,
    /// Maxwell: all stress relaxes, E(t) = E exp(-t/tau).
    Maxwell,
    /// A standard solid: stress relaxes to a share of it, E(t)/E_inf = 1 + (1/relaxed - 1) exp(-t/tau), on the side of short
    /// tau, where it is of Kelvin's and Voigt's kind.
    StandardSolid {
        /// E_inf/E_0, between 0 and 1.
        relaxed: f64,
    },
    /// A loss tangent that does not depend on frequency, tan(alpha pi/2): E(t) proportional to t^(-alpha). The restitution
    /// does not depend on speed then.
    ConstantLossTangent,
}

/// The least restitution with springs of its own; below, R_x is interpolated to the limit at e = 0.
const LEAST: f64 = 5e-3;
/// The least restitution of other materials than Kelvin's and Voigt's.
const LEAST_OF_OTHERS: f64 = 0.1;
/// The greatest relaxation time: e is then .005.
const GREATEST: f64 = 25.0;

impl ViscousLoss {
    /// An elastic material.
    pub const NONE: Self =
        Self { rheology: Rheology::KelvinVoigt, restitution: 1.0, parameter: 0.0 };

    /// The loss of bodies that rebound with this restitution if nothing couples normal and tangential motion.
    ///
    /// # Errors
    /// [`RangeError`] of `normal_restitution` unless it is from 0 to 1.
    pub fn of_restitution(restitution: f64) -> Result<Self, RangeError> {
        let holds = (0.0..=1.0).contains(&restitution);
        RangeError::check("normal_restitution", restitution, holds, "from 0 to 1")?;
        let parameter = pulse::relaxation_of(restitution.max(LEAST));
        Ok(Self { rheology: Rheology::KelvinVoigt, restitution, parameter })
    }

    /// The same of another material, for impacts in which nothing couples normal and tangential motion.
    ///
    /// ```
    /// use carom_impact::oblique::Groups;
    /// use carom_impact::viscoelastic::{Rheology, ViscoelasticImpact, ViscousLoss};
    /// // Solid spheres, kappa = 1.2, lambda = 2, e = .8: by springs of another program .2943 and .2469 (Kelvin-Voigt .2344).
    /// for (rheology, known) in [(Rheology::Maxwell, 0.2943), (Rheology::ConstantLossTangent, 0.2469)] {
    ///     let loss = ViscousLoss::of_restitution_in(rheology, 0.8)?;
    ///     let rebound = ViscoelasticImpact::new(Groups::of_spheres(1.2, 2.0)?, loss).solve(1e-3);
    ///     assert!((rebound.restitution - known).abs() < rebound.error_estimate);
    /// }
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] of `normal_restitution` unless it is from 0 to 1, from 0.1 but for Kelvin-Voigt.
    pub fn of_restitution_in(rheology: Rheology, restitution: f64) -> Result<Self, RangeError> {
        if rheology == Rheology::KelvinVoigt || restitution == 1.0 {
            return Self::of_restitution(restitution);
        }
        let holds = (LEAST_OF_OTHERS..1.0).contains(&restitution);
        RangeError::check("normal_restitution", restitution, holds, "from 0.1 to 1")?;
        if let Rheology::StandardSolid { relaxed } = rheology {
            let holds = relaxed > 0.0 && relaxed < 1.0;
            RangeError::check("relaxed", relaxed, holds, "between 0 and 1")?;
        }
        let most = RangeError::new(
            "normal_restitution",
            restitution,
            "above that of the largest loss of this standard solid",
        );
        let parameter = relaxing::parameter_of(rheology, restitution).ok_or(most)?;
        Ok(Self { rheology, restitution, parameter })
    }

    /// How the stress relaxes.
    #[must_use]
    pub const fn rheology(&self) -> Rheology {
        self.rheology
    }

    /// The restitution of the springs that this material has: that of the least ones below it.
    pub(crate) const fn of_springs(&self) -> f64 {
        self.restitution.max(LEAST)
    }

    /// The viscosity of a Kelvin-Voigt material, `unit` the time of the impact.
    ///
    /// # Errors
    /// [`RangeError`] for another one, which has no law of steps.
    pub(crate) fn viscosity(&self, unit: f64) -> Result<Viscosity, RangeError> {
        let holds = self.rheology == Rheology::KelvinVoigt;
        let allowed = "1, or with the loss \"viscous\" or \"yield\", where something couples normal and tangential motion";
        RangeError::check("normal_restitution", self.restitution, holds, allowed)?;
        Viscosity::new(unit * self.parameter)
    }

    /// The loss of bodies with this relaxation time over the time of the impact, (m/K)^(2/5) v^(-1/5); m is the reduced
    /// mass, 1/D_zz, K = (2/3) c_z, v the speed of approach.
    ///
    /// # Errors
    /// [`RangeError`] of `relaxation` unless it is from 0 to 25, where e is .005.
    pub fn of_relaxation(relaxation: f64) -> Result<Self, RangeError> {
        let holds = (0.0..=GREATEST).contains(&relaxation);
        let allowed = "from 0 to 25 times the time of the impact, (m/K)^(2/5) v^(-1/5)";
        RangeError::check("relaxation", relaxation, holds, allowed)?;
        let restitution = Pulse { tau: relaxation }.restitution();
        Ok(Self { rheology: Rheology::KelvinVoigt, restitution, parameter: relaxation })
    }

    /// The restitution e: the speed of separation over that of approach.
    #[must_use]
    pub const fn restitution(&self) -> f64 {
        self.restitution
    }

    /// The relaxation time over the time of the impact; of a constant loss tangent alpha.
    #[must_use]
    pub const fn relaxation(&self) -> f64 {
        self.parameter
    }
}

/// An impact of viscoelastic bodies.
///
/// ```
/// use carom_impact::oblique::Groups;
/// use carom_impact::viscoelastic::{ViscoelasticImpact, ViscousLoss};
/// // Solid spheres, kappa = 1.2, lambda = 2, e = .5.
/// let groups = Groups::of_spheres(1.2, 2.0)?;
/// let impact = ViscoelasticImpact::new(groups, ViscousLoss::of_restitution(0.5)?);
/// let rebound = impact.solve(1e-4);
/// assert!((rebound.restitution - 0.15564).abs() < rebound.error_estimate);
/// // Sliding throughout, every material gives the same: R_x = -1 + (7/2)(1 + e)/lambda.
/// let impact = ViscoelasticImpact::new(Groups::of_spheres(1.2, 6.0)?, ViscousLoss::of_restitution(0.5)?);
/// assert!((impact.solve(1e-4).restitution + 0.125).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticImpact {
    groups: Groups,
    loss: ViscousLoss,
}

/// What a viscoelastic impact gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscoelasticRebound {
    /// R_x: the tangential velocity after the impact over that before, reversed.
    pub restitution: f64,
    /// Estimated error of R_x; 0 where the contact slides throughout.
    pub error_estimate: f64,
    /// Heat of friction over f^2 kappa m v^2, kappa = c_z/c_x.
    pub friction_heat: f64,
    /// Duration over (m/K)^(2/5) v^(-1/5).
    pub duration: f64,
    /// Greatest approach over (m v^2/K)^(2/5).
    pub maximal_approach: f64,
    /// Greatest normal force over K times that length^(3/2).
    pub maximal_force: f64,
    /// Pressure in the middle at the greatest force, over that of this force on the largest contact; below 1, since a viscous
    /// contact bears its greatest force before it is largest.
    pub pressing: f64,
}

/// The numbers of steps of a half.
const FIRST: usize = 14;
const MOST: usize = 1792;
/// Below this psi the impact does not differ from one without tangential motion.
const SLOWEST: f64 = 1e-9;
/// The steps of a history of an impact that slides throughout.
const SHOWN: usize = 112;

/// What a loss makes of the normal motion alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NormalRebound {
    /// Over (m/K)^(2/5) v^(-1/5).
    pub(crate) duration: f64,
    /// Over (m v^2/K)^(2/5).
    pub(crate) maximal_approach: f64,
    /// Over K times that length^(3/2).
    pub(crate) maximal_force: f64,
    /// The pressure in the middle at the greatest force, over that of this force on the largest contact.
    pub(crate) pressing: f64,
}

impl NormalRebound {
    /// `pressed` is the root of the approach at which an elastic contact has the pressure at the greatest force.
    fn new([duration, maximal_approach]: [f64; 2], [maximal_force, pressed]: [f64; 2]) -> Self {
        let pressing = maximal_approach * pressed / maximal_force;
        Self { duration, maximal_approach, maximal_force, pressing }
    }
}

impl ViscousLoss {
    pub(crate) fn normal_rebound(&self) -> NormalRebound {
        match self.relaxing() {
            Some(relaxation) => relaxing::normal(&relaxation).into(),
            None => {
                let pulse = Pulse { tau: self.parameter };
                normal_rebound(&pulse, &pulse.ends())
            }
        }
    }

    /// The pressure in the middle at the greatest force, over that of this force on the largest contact.
    pub(crate) fn pressing(&self) -> f64 {
        self.normal_rebound().pressing
    }

    /// The relaxation of other materials than Kelvin's and Voigt's.
    fn relaxing(&self) -> Option<Relaxation> {
        match self.rheology {
            Rheology::KelvinVoigt => None,
            rheology => Some(Relaxation::of(rheology, self.parameter)),
        }
    }
}

fn normal_rebound(pulse: &Pulse, ends: &Ends) -> NormalRebound {
    let [(compression, turn), (_, last)] = ends;
    NormalRebound::new([last.time, turn.approach], pulse.greatest_force(*compression))
}

impl ViscoelasticImpact {
    /// An impact with these groups and this loss.
    #[must_use]
    pub const fn new(groups: Groups, loss: ViscousLoss) -> Self {
        Self { groups, loss }
    }

    /// psi, as far as a heat over it is asked for.
    pub(crate) fn psi(&self) -> f64 {
        self.moving()[1]
    }

    /// R_x where the contact slides throughout, which is the same for every material that loses this much.
    fn sliding(&self) -> Option<f64> {
        let (chi, psi, e) = (self.groups.chi(), self.groups.psi(), self.loss.restitution);
        (psi >= 1.0_f64.max(chi * (1.0 + e) - e)).then(|| chi * (1.0 + e) / psi - 1.0)
    }

    /// Solves the impact until the estimated error of R_x is below the tolerance, with at most 1792 steps in each half (800
    /// in all of other materials than Kelvin's and Voigt's).
    #[must_use]
    pub fn solve(&self, tolerance: f64) -> ViscoelasticRebound {
        let (found, normal) = match self.loss.relaxing() {
            Some(relaxation) => {
                let (found, normal) = relaxing::refined(&relaxation, self.moving(), tolerance);
                let found = self.sliding().map_or(found, |restitution| self.slid(restitution));
                (found, normal.into())
            }
            None => {
                let pulse = Pulse { tau: self.loss.parameter };
                let ends = pulse.ends();
                (self.by_springs(&pulse, &ends, tolerance), normal_rebound(&pulse, &ends))
            }
        };
        ViscoelasticRebound {
            restitution: found.restitution,
            error_estimate: found.error,
            friction_heat: found.heat,
            duration: normal.duration,
            maximal_approach: normal.maximal_approach,
            maximal_force: normal.maximal_force,
            pressing: normal.pressing,
        }
    }

    /// The instants of the run by which [`ViscoelasticImpact::solve`] meets the tolerance, and the psi to which they belong.
    pub(crate) fn instants(&self, tolerance: f64) -> (Vec<Instant>, f64) {
        let groups = self.moving();
        let mut instants = Vec::new();
        let mut observe = |instant| instants.push(instant);
        if let Some(relaxation) = self.loss.relaxing() {
            let steps = relaxing::refined(&relaxation, groups, tolerance).0.steps;
            relaxing::follow(&relaxation, groups, steps, &mut observe);
            return (instants, groups[1]);
        }
        let pulse = Pulse { tau: self.loss.parameter };
        let ends = pulse.ends();
        let steps = match self.sliding() {
            Some(_) => SHOWN,
            None => refined(&pulse, &ends, groups, tolerance).steps.max(SHOWN),
        };
        Run::of(&pulse, &ends, groups, steps, observe);
        (instants, groups[1])
    }

    fn by_springs(&self, pulse: &Pulse, ends: &Ends, tolerance: f64) -> Found {
        match self.sliding() {
            Some(restitution) => self.slid(restitution),
            None => self.toward_rest(refined(pulse, ends, self.moving(), tolerance)),
        }
    }

    fn moving(&self) -> [f64; 2] {
        [self.groups.chi(), self.groups.psi().clamp(SLOWEST, FASTEST)]
    }

    // The work of friction is that of its impulse at the mean of the rates before and after. The springs are bent by f kappa
    // times what they are pressed, so that the material takes as much of it as of the normal motion, times f^2 kappa.
    fn slid(&self, restitution: f64) -> Found {
        let (chi, psi, e) = (self.groups.chi(), self.groups.psi(), self.loss.restitution);
        let work = (1.0 + restitution) * (1.0 - restitution) * psi.min(FASTEST).powi(2) / chi;
        let heat = 0.5 * (work - (1.0 - e) * (1.0 + e)).max(0.0);
        Found { restitution, heat, error: 0.0, steps: 0 }
    }

    // Below the least restitution R_x goes to that of bodies that do not rebound, which rest if they do not slide.
    fn toward_rest(&self, found: Found) -> Found {
        let part = self.loss.restitution / LEAST;
        if part >= 1.0 {
            return found;
        }
        let rests = (self.groups.chi() / self.groups.psi() - 1.0).min(0.0);
        let restitution = rests + part * (found.restitution - rests);
        let error = found.error + (1.0 - part) * (found.restitution - rests).abs();
        Found { restitution, error, ..found }
    }
}

/// Above this psi, without friction, histories are those of this psi.
const FASTEST: f64 = 1e12;

/// The limit of runs with doubled numbers of steps.
struct Found {
    restitution: f64,
    heat: f64,
    error: f64,
    steps: usize,
}

/// The estimated error over the last change of R_x.
const SHARE: f64 = 0.6;
/// Where two runs agree by chance, the error is what it is elsewhere with as many steps: this over their square.
const USUAL: f64 = 0.7;

fn floor(steps: usize) -> f64 {
    USUAL / (steps * steps) as f64
}

fn refined(pulse: &Pulse, ends: &Ends, groups: [f64; 2], tolerance: f64) -> Found {
    let run = |steps| Run::of(pulse, ends, groups, steps, |_| ());
    let mut steps = FIRST;
    let mut coarse = run(steps);
    loop {
        steps *= 2;
        let fine = run(steps);
        let [_, psi] = groups;
        let change = (fine.rate - coarse.rate) / 3.0;
        let found = Found {
            restitution: (-(fine.rate + change) / psi).clamp(-1.0, 1.0),
            heat: (fine.heat + (fine.heat - coarse.heat) / 3.0).max(0.0),
            error: (SHARE * change.abs() / psi).max(floor(steps)),
            steps,
        };
        if found.error <= tolerance || 2 * steps > MOST {
            return found;
        }
        coarse = fine;
    }
}
