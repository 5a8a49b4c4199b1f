//! Options of an impact, in one struct that later versions may extend.

use carom_impact::coupled::TurningLaw;
use carom_impact::{
    AnalyticOrRings, Collision, CollisionSolver as _, ImpactFriction, LossCause, NormalRestitution,
    Outcome, RingImpact, TorsionMode,
};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::static_friction::StaticFriction;
use carom_special::RangeError;

use crate::error::{CaromStatus, Failure};
use crate::law::friction::of_option;
use crate::sized::SizedOptions;

/// Chooses the cheapest law that accounts for the coupling of dissimilar materials. For spheres and planes
/// that is CAROM_IMPACT_RINGS where coupling matters. For other shapes coupling is neglected, and
/// CAROM_WARNING_COUPLING reports it.
pub const CAROM_IMPACT_AUTO: u32 = 0;
/// The law `coulomb` for any materials: coupling is neglected.
pub const CAROM_IMPACT_COULOMB: u32 = 1;
/// The law `fixed-direction` for any materials: coupling is neglected.
pub const CAROM_IMPACT_FIXED_DIRECTION: u32 = 2;
/// The law `rings`, for spheres and planes only: it includes coupling and the spin about the normal.
pub const CAROM_IMPACT_RINGS: u32 = 3;

/// With CAROM_IMPACT_AUTO friction changes the spin about the normal where that matters; with other laws it
/// does not.
pub const CAROM_TORSION_AUTO: u32 = 0;
/// The spin about the normal is changed by a torsional impact that is computed as if there were no tangential
/// one.
pub const CAROM_TORSION_INCLUDED: u32 = 1;
/// The spin about the normal is not changed.
pub const CAROM_TORSION_LEFT_OUT: u32 = 2;

/// No energy is dissipated in the material of the bodies.
pub const CAROM_LOSS_NONE: u32 = 0;
/// The material is viscous: the normal velocity after the impact is `normal_restitution`, in [0, 1], times that before,
/// where normal and tangential motion are uncoupled.
pub const CAROM_LOSS_GIVEN: u32 = 1;
/// The energy that elastic waves carry away is lost, see CAROM_WARNING_WAVE_LOSS; `normal_restitution` is
/// ignored.
pub const CAROM_LOSS_BY_WAVES: u32 = 2;
/// The material is viscous with a relaxation time, `relaxation`: the normal restitution falls as the speed grows;
/// `normal_restitution` is ignored.
pub const CAROM_LOSS_VISCOELASTIC: u32 = 3;
/// The bodies yield: the elastic impulse times (1 + e)/2, e the `normal_restitution`, in [0, 1].
pub const CAROM_LOSS_YIELD: u32 = 4;
/// As CAROM_LOSS_GIVEN, of a material whose stress relaxes wholly (Maxwell). Like CAROM_LOSS_STANDARD_SOLID and
/// CAROM_LOSS_CONSTANT_TANGENT for like spheres and planes without spin about the normal, and from 0.1.
pub const CAROM_LOSS_MAXWELL: u32 = 5;
/// As CAROM_LOSS_GIVEN, of a standard solid whose stress relaxes fast to a tenth.
pub const CAROM_LOSS_STANDARD_SOLID: u32 = 6;
/// As CAROM_LOSS_GIVEN, of a material whose loss tangent is the same at any frequency.
pub const CAROM_LOSS_CONSTANT_TANGENT: u32 = 7;

/// Options of an impact. Zero in any field but `size` selects the default.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromCollideOptions {
    /// `sizeof(carom_collide_options)`. Later versions add fields at the end; a smaller `size` leaves these
    /// at zero.
    pub size: usize,
    /// The contact law, a CAROM_IMPACT constant.
    pub law: u32,
    /// The loss in the material, beyond the elastic theory, a CAROM_LOSS constant. With CAROM_LOSS_YIELD duration, force
    /// and approach are those of the elastic impact.
    pub loss: u32,
    /// The normal velocity after the impact over that before, for CAROM_LOSS_GIVEN, CAROM_LOSS_YIELD and the
    /// materials after it: 1 is elastic, 0 leaves the bodies together.
    pub normal_restitution: f64,
    /// Largest error of the contact velocity after the impact, over that before; 0 for the default. Rings that do
    /// not reach it set CAROM_WARNING_NOT_SETTLED.
    pub tolerance: f64,
    /// How friction acts on the spin about the normal, a CAROM_TORSION constant. CAROM_IMPACT_RINGS counts it unless
    /// it is left out.
    pub torsion: u32,
    /// The viscous relaxation time of both bodies together for CAROM_LOSS_VISCOELASTIC, s.
    pub relaxation: f64,
    /// The coefficient of static friction, above which all of a contact slides with `friction`; 0 if it is that
    /// of `friction`. Not with CAROM_IMPACT_RINGS or CAROM_TORSION_INCLUDED.
    pub static_friction: f64,
    /// Of friction that depends on the slip speed v at the first touch, f = a + b exp(-c v), a the argument
    /// `friction`: b; 0 for a constant coefficient. Not beside static friction.
    pub slip_friction_b: f64,
    /// Of friction by the slip speed: c, s/m.
    pub slip_friction_c: f64,
}

// SAFETY: it consists of numbers, the first of which is its size.
unsafe impl SizedOptions for CaromCollideOptions {}

impl CaromCollideOptions {
    /// The friction of the impact, from the coefficient in the call.
    pub(crate) fn friction(&self, coefficient: f64) -> Result<ImpactFriction, RangeError> {
        let (b, at_rest) = (self.slip_friction_b, self.static_friction);
        if b != 0.0 {
            RangeError::check(
                "static_friction",
                at_rest,
                at_rest == 0.0,
                "0 beside slip_friction_b",
            )?;
            let friction = SlipSpeedFriction::new(coefficient, b, self.slip_friction_c);
            return friction.map(Into::into).map_err(of_option);
        }
        let kinetic = Friction::new(coefficient)?;
        if at_rest == 0.0 {
            return Ok(kinetic.into());
        }
        let named = |error| RangeError { field: "static_friction", ..error };
        StaticFriction::new(Friction::new(at_rest).map_err(named)?, kinetic).map(Into::into)
    }

    /// Follows a collision from first contact to separation.
    pub(crate) fn solve(&self, collision: Collision) -> Result<Outcome, Failure> {
        let mut collision = collision.with_normal_restitution(self.left()?);
        if self.tolerance != 0.0 {
            collision = collision.within(self.tolerance)?;
        }
        match self.torsion {
            CAROM_TORSION_AUTO => {}
            CAROM_TORSION_INCLUDED => collision = collision.with_torsion(),
            CAROM_TORSION_LEFT_OUT => {
                collision = collision.with_torsion_mode(TorsionMode::LeftOut);
            }
            torsion => return Err(out_of_range("torsion", torsion, "a CAROM_TORSION, 0 to 2")),
        }
        Ok(match self.law {
            // There is no grid solver behind this interface: CAROM_WARNING_COUPLING reports what is neglected.
            CAROM_IMPACT_AUTO => AnalyticOrRings.solve(&collision)?,
            CAROM_IMPACT_COULOMB => collision.with_law(TurningLaw::Coulomb).solve()?,
            CAROM_IMPACT_FIXED_DIRECTION => {
                collision.with_law(TurningLaw::FixedDirection).solve()?
            }
            CAROM_IMPACT_RINGS => RingImpact::new(&collision).solve()?,
            law => return Err(out_of_range("law", law, "a CAROM_IMPACT, 0 to 3")),
        })
    }

    /// The coefficient of normal restitution that the options describe.
    fn left(&self) -> Result<NormalRestitution, Failure> {
        let cause = match self.loss {
            CAROM_LOSS_NONE => return Ok(NormalRestitution::ELASTIC),
            CAROM_LOSS_BY_WAVES => return Ok(NormalRestitution::by_waves()),
            CAROM_LOSS_VISCOELASTIC => {
                return Ok(NormalRestitution::viscoelastic(self.relaxation)?);
            }
            CAROM_LOSS_GIVEN => LossCause::Viscous,
            CAROM_LOSS_YIELD => LossCause::Yield,
            CAROM_LOSS_MAXWELL => LossCause::Maxwell,
            CAROM_LOSS_STANDARD_SOLID => LossCause::StandardSolid,
            CAROM_LOSS_CONSTANT_TANGENT => LossCause::ConstantLossTangent,
            loss => return Err(out_of_range("loss", loss, "a CAROM_LOSS, 0 to 7")),
        };
        NormalRestitution::by(cause, self.normal_restitution)
            .map_err(|error| RangeError { field: "normal_restitution", ..error }.into())
    }
}

fn out_of_range(field: &'static str, value: u32, allowed: &str) -> Failure {
    let text = format_args!("{field} = {value} is out of range: must be {allowed}");
    let failure = Failure::new(CaromStatus::OutOfRange, field, text);
    failure.with_value(f64::from(value))
}
