//! How an impact is computed: options in one struct that may grow.

use carom_impact::coupled::TurningLaw;
use carom_impact::{Collision, NeededLaw, NormalRestitution, Outcome, RingImpact, TorsionMode};
use carom_special::RangeError;

use crate::error::{CaromStatus, Failure};
use crate::pointers::read;

/// The law of an impact: the cheapest in which the coupling of dissimilar bodies counts. For spheres and planes it is
/// CAROM_IMPACT_RINGS where coupling matters; for other shapes coupling is neglected, and CAROM_WARNING_COUPLING
/// says so.
pub const CAROM_IMPACT_AUTO: u32 = 0;
/// `coulomb`, whichever the materials: coupling is neglected.
pub const CAROM_IMPACT_COULOMB: u32 = 1;
/// `fixed-direction`, whichever the materials: coupling is neglected.
pub const CAROM_IMPACT_FIXED_DIRECTION: u32 = 2;
/// `rings`, of spheres and planes: coupling and the spin about the normal count.
pub const CAROM_IMPACT_RINGS: u32 = 3;

/// With CAROM_IMPACT_AUTO friction acts on the spin about the normal where that matters; other laws leave it alone.
pub const CAROM_TORSION_AUTO: u32 = 0;
/// The spin is changed by a torsional impact of its own, as if there were no tangential impact.
pub const CAROM_TORSION_INCLUDED: u32 = 1;
/// The spin is left alone.
pub const CAROM_TORSION_LEFT_OUT: u32 = 2;

/// Nothing is lost in the bodies' material.
pub const CAROM_LOSS_NONE: u32 = 0;
/// `normal_restitution` of the elastic normal velocity is left, in [0, 1].
pub const CAROM_LOSS_GIVEN: u32 = 1;
/// What elastic waves carry away is lost, see CAROM_WARNING_WAVE_LOSS; `normal_restitution` says nothing.
pub const CAROM_LOSS_BY_WAVES: u32 = 2;

/// How an impact is computed. Zeros are what is usual in all but `size`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromCollideOptions {
    /// `sizeof(carom_collide_options)`: later versions add fields at the end, which are zero for a caller of this one.
    pub size: usize,
    /// A CAROM_IMPACT.
    pub law: u32,
    /// A CAROM_LOSS: what the bodies' material takes, beyond the elastic theory. Impulse and heat of friction shrink with
    /// the normal pulse; duration, force and approach are those of the elastic impact.
    pub loss: u32,
    /// The part of the elastic normal velocity that CAROM_LOSS_GIVEN leaves: 1 is elastic, at 0 the bodies do not part.
    pub normal_restitution: f64,
    /// To which the outcome is settled; 0 for the usual one.
    pub tolerance: f64,
    /// A CAROM_TORSION: what becomes of the spin about the normal where the law is not CAROM_IMPACT_RINGS.
    pub torsion: u32,
}

impl CaromCollideOptions {
    /// As many bytes as the caller has; null for what is usual.
    ///
    /// # Safety
    /// `options` is null, or as many bytes as its first field says may be read.
    pub(crate) unsafe fn of(options: *const Self) -> Result<Self, Failure> {
        let mut known = Self::default();
        if options.is_null() {
            return Ok(known);
        }
        // SAFETY: the caller's promise.
        let size = unsafe { *read(options.cast::<usize>(), "options")? };
        let (least, most) = (size_of::<usize>(), size_of::<Self>());
        if !(least..=most).contains(&size) {
            let text =
                format_args!("size = {size} is out of range: must be from {least} to {most}");
            return Err(Failure::new(CaromStatus::OutOfRange, "size", text));
        }
        let to = (&raw mut known).cast::<u8>();
        // SAFETY: so many bytes may be read, and there is room for them; any are a value.
        unsafe { options.cast::<u8>().copy_to_nonoverlapping(to, size) };
        Ok(known)
    }

    /// Follows a collision to separation.
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
            CAROM_IMPACT_AUTO => match collision.needed_law(Collision::NEGLIGIBLE_COUPLING) {
                NeededLaw::Analytic => collision.solve_with_coupling_bound()?,
                NeededLaw::Rings => self.rings(&collision)?,
                // No grid stands behind this border: CAROM_WARNING_COUPLING tells what is neglected.
                NeededLaw::Grid => collision.solve()?,
            },
            CAROM_IMPACT_COULOMB => collision.with_law(TurningLaw::Coulomb).solve()?,
            CAROM_IMPACT_FIXED_DIRECTION => {
                collision.with_law(TurningLaw::FixedDirection).solve()?
            }
            CAROM_IMPACT_RINGS => self.rings(&collision)?,
            law => return Err(out_of_range("law", law, "a CAROM_IMPACT, 0 to 3")),
        })
    }

    fn rings(&self, collision: &Collision) -> Result<Outcome, Failure> {
        let mut impact = RingImpact::new(collision);
        if self.tolerance != 0.0 {
            impact = impact.within(self.tolerance)?;
        }
        Ok(impact.solve()?)
    }

    /// What the material leaves of the normal velocity.
    fn left(&self) -> Result<NormalRestitution, Failure> {
        match self.loss {
            CAROM_LOSS_NONE => Ok(NormalRestitution::ELASTIC),
            CAROM_LOSS_GIVEN => NormalRestitution::new(self.normal_restitution)
                .map_err(|error| RangeError { field: "normal_restitution", ..error }.into()),
            CAROM_LOSS_BY_WAVES => Ok(NormalRestitution::by_waves()),
            loss => Err(out_of_range("loss", loss, "a CAROM_LOSS, 0 to 2")),
        }
    }
}

fn out_of_range(field: &'static str, value: u32, allowed: &str) -> Failure {
    let text = format_args!("{field} = {value} is out of range: must be {allowed}");
    let failure = Failure::new(CaromStatus::OutOfRange, field, text);
    Failure { value: f64::from(value), ..failure }
}
