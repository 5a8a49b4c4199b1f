//! What a law of particles is made of.

use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::RollingResistance;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::static_friction::StaticFriction;
use carom_special::RangeError;

use super::friction::{GrainFriction, of_option};
use crate::error::{CaromStatus, Failure};
use crate::sized::SizedOptions;

/// The constants of a rolling resistance: a spring and a dashpot side by side, in series with a slider.
///
/// With the relative radius R (1/R = 1/radius_1 + 1/radius_2) and the normal n from body 2 into body 1 the bodies
/// roll with the velocity v = R (spin_1 - spin_2) x n. Spring and dashpot exert the force F = - stiffness s -
/// damping ds/dt, up to friction times the normal force, beyond which they slip: ds/dt = v without slip. The force
/// acts on no body; the torque on body 1 is R n x F, that on body 2 the opposite. The step of s is that of the
/// implicit Euler method. Where the bodies part, the energy of the spring becomes heat.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromRolling {
    /// The spring: force over the displacement of rolling, N/m.
    pub stiffness: f64,
    /// The dashpot: force over the velocity of rolling, N s/m.
    pub damping: f64,
    /// The slider: the greatest force over the normal force; 0 for no resistance.
    pub friction: f64,
}

/// Options of a law of particles. Zero in any field but `size` selects the default.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromLawOptions {
    /// `sizeof(carom_law_options)`. Later versions add fields at the end; a smaller `size` leaves these at zero.
    pub size: usize,
    /// A CAROM_LAW constant; by default CAROM_LAW_COULOMB.
    pub law: u32,
    /// 1: friction resists the spin about the normal, by a law with memory that neglects the shift, and costs three to
    /// four times as much as a step without it. CAROM_LAW_RINGS always counts the spin. 0: it is left alone.
    pub torsion: u32,
    /// CAROM_LAW_COULOMB: error of the friction force over its limit, by default 1e-2. CAROM_LAW_RINGS: relative
    /// accuracy with which tractions satisfy the friction limit, by default 3e-3.
    pub tolerance: f64,
    /// The coefficient of static friction, finite and at least `friction`; 0 if it is that of `friction`. Until all of a
    /// contact slides, it sticks or slips in part with `static_friction`; then the force drops, and it slides with
    /// `friction`. Where a part of it sticks, static friction counts again. Not with CAROM_LAW_RINGS or `torsion`.
    pub static_friction: f64,
    /// Of friction that depends on the slip speed v of the first touch, f = a + b exp(-c v), a the argument `friction`:
    /// b; 0 for a constant coefficient. a, a + b and c must be finite and at least 0. A contact keeps its coefficient
    /// while it lasts. Not with static friction, CAROM_LAW_RINGS or `torsion`.
    pub slip_friction_b: f64,
    /// Of friction by the slip speed: c, s/m.
    pub slip_friction_c: f64,
    /// The viscous relaxation time A of the two bodies together, s. Every stress then has a viscous companion, A times
    /// its rate. The normal force is K (zeta^(3/2) + (3/2) A sqrt(zeta) zeta'), K = (2/3) c_z, while the approach zeta
    /// grows, and K (zeta + A zeta')^(3/2), or 0, while it falls; friction is damped alike.
    pub relaxation: f64,
    /// Grains part with `restitution` times the speed with which they met, at any speed: from 0.01 to 1, which means no
    /// damping, as 0. The force is alpha sqrt(m K) zeta^(1/4) dzeta/dt beside that of Hertz, K zeta^(3/2), m the reduced
    /// mass; the sum never pulls. Friction is damped as in a viscous material, and leaves the restitution as it is. With
    /// 50 steps in an impact the restitution is met to 2e-4. Not beside a relaxation time: both would count the same
    /// loss. Masses of grains are read then, and must be > 0; that of one of both bodies must be finite.
    pub restitution: f64,
    /// The resistance to rolling.
    pub rolling: CaromRolling,
}

// SAFETY: it consists of numbers, the first of which is its size.
unsafe impl SizedOptions for CaromLawOptions {}

impl CaromLawOptions {
    /// The friction, from the coefficient in the call.
    pub(super) fn friction(
        &self,
        coefficient: f64,
        by_rings: bool,
    ) -> Result<GrainFriction, Failure> {
        let (b, at_rest) = (self.slip_friction_b, self.static_friction);
        let kinetic = Friction::new(coefficient)?;
        let holds = coefficient != f64::INFINITY;
        RangeError::check("friction", coefficient, holds, "finite for a state that is stored")?;
        let twists = self.torsion != 0 && !by_rings;
        if b != 0.0 {
            let allowed = "0 beside slip_friction_b";
            RangeError::check("static_friction", at_rest, at_rest == 0.0, allowed)?;
            let allowed = "0 for law rings, and beside torsion";
            RangeError::check("slip_friction_b", b, !by_rings && !twists, allowed)?;
            let friction = SlipSpeedFriction::new(coefficient, b, self.slip_friction_c);
            return Ok(GrainFriction::BySlip(friction.map_err(of_option)?));
        }
        if at_rest == 0.0 {
            return Ok(GrainFriction::Constant(StaticFriction::new(kinetic, kinetic)?));
        }
        let named = |error| RangeError { field: "static_friction", ..error };
        let friction = StaticFriction::new(Friction::new(at_rest).map_err(named)?, kinetic)?;
        let allowed = "`friction` for law rings, and beside torsion";
        let holds = !friction.drops() || (!by_rings && !twists);
        RangeError::check("static_friction", at_rest, holds, allowed)?;
        Ok(GrainFriction::Constant(friction))
    }

    /// The damping of the restitution.
    pub(super) fn damping(&self) -> Result<HertzDamping, RangeError> {
        let restitution = if self.restitution == 0.0 { 1.0 } else { self.restitution };
        HertzDamping::of_restitution(restitution)?.beside_relaxation(self.relaxation)
    }

    pub(super) fn has_torsion(&self) -> Result<bool, Failure> {
        match self.torsion {
            0 => Ok(false),
            1 => Ok(true),
            torsion => {
                let text = format_args!("torsion = {torsion} is out of range: must be 0 or 1");
                let failure = Failure::new(CaromStatus::OutOfRange, "torsion", text);
                Err(failure.with_value(f64::from(torsion)))
            }
        }
    }

    pub(super) fn rolling(&self) -> Result<Option<RollingResistance>, RangeError> {
        let CaromRolling { stiffness, damping, friction } = self.rolling;
        let named = |error: RangeError| match error.field {
            "stiffness" => RangeError { field: "rolling.stiffness", ..error },
            "damping" => RangeError { field: "rolling.damping", ..error },
            _ => RangeError { field: "rolling.friction", ..error },
        };
        let made = RollingResistance::new(stiffness, damping, friction).map_err(named)?;
        Ok((friction > 0.0).then_some(made))
    }
}
