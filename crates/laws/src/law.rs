//! The interface of all contact laws: from rigid shifts to loads.
//!
//! A law is a value that contains its load history. [`ContactLaw::advance`] makes a step; [`ContactLaw::shift`]
//! and [`ContactLaw::load`] only read. A clone is cheap, so that a step can be tried on a copy and thrown away.
//! Heat and energies are traits of their own, [`Energies`] and [`Dissipative`], because they cost more than the
//! force: who needs a running sum of the heat wraps the law in [`Accounted`](crate::accounted::Accounted).

use carom_special::RangeError;

use crate::bounds::{LARGEST, in_contact};
use crate::slip_lag::SlipLag;

/// The rigid shift of body 2 relative to body 1 in the contact frame (z into body 1).
///
/// ```
/// use carom_laws::law::Shift;
/// let shift = Shift { zeta: 1e-6, xi: 2e-7, ..Shift::default() };
/// assert_eq!(shift.omega, 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shift {
    /// Approach along the normal, positive in contact.
    pub zeta: f64,
    /// Shift along x (5.19).
    pub xi: f64,
    /// Shift along y (5.19).
    pub eta: f64,
    /// Twist about the normal, radians: `u = xi + y Omega`, `v = eta - x Omega` (12.2).
    pub omega: f64,
}

impl Shift {
    /// Checks that all components are finite and at most 1e60 in magnitude, so that no energy
    /// overflows.
    ///
    /// # Errors
    /// [`RangeError`] that names the first component out of range.
    #[inline]
    pub fn check_finite(&self) -> Result<(), RangeError> {
        let size = |value: f64| value.abs() <= LARGEST;
        if size(self.zeta) & size(self.xi) & size(self.eta) & size(self.omega) {
            return Ok(());
        }
        self.name_the_wrong_one()
    }

    #[cold]
    fn name_the_wrong_one(&self) -> Result<(), RangeError> {
        in_contact("zeta", self.zeta)?;
        in_contact("xi", self.xi)?;
        in_contact("eta", self.eta)?;
        in_contact("omega", self.omega)?;
        Ok(())
    }
}

/// The load that body 2 exerts on body 1, work-conjugate to [`Shift`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactLoad {
    /// Tangential force along x.
    pub f_x: f64,
    /// Tangential force along y.
    pub f_y: f64,
    /// Normal force, positive in compression.
    pub f_z: f64,
    /// Torque about the normal, `int (y t_x - x t_y) dS`.
    pub m_z: f64,
}

/// A contact law: maps a history of rigid shifts to loads. Energies are given by further traits.
///
/// Clones are cheap, so that a step can be tried and discarded. A failed step leaves the state
/// unchanged.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// /// Steps that keep the load below a limit are kept, others are undone.
/// fn push<L: ContactLaw>(law: &mut L, to: Shift, limit: f64) -> Result<bool, L::Error> {
///     let mut trial = law.clone();
///     let load = trial.advance(to)?;
///     let fits = load.f_x.hypot(load.f_y) <= limit;
///     if fits {
///         *law = trial;
///     }
///     Ok(fits)
/// }
/// let stiffness = ContactStiffness::new(1.0, 1.0, 1.2)?;
/// let mut law = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::new(0.3)?);
/// assert!(push(&mut law, Shift { zeta: 1.0, ..Shift::default() }, 0.1)?);
/// assert!(!push(&mut law, Shift { zeta: 1.0, xi: 0.3, ..Shift::default() }, 0.1)?);
/// assert_eq!(law.load().f_x, 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
pub trait ContactLaw: Clone {
    /// Why a step failed.
    type Error: std::error::Error + Send + Sync + 'static;

    /// Advances on a straight path from the present shift to a new one and returns the load there.
    ///
    /// The bodies separate if the new approach is not positive.
    ///
    /// # Errors
    /// The error of the law; the state is then unchanged.
    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, Self::Error>;

    /// As [`ContactLaw::advance`], with the rates of the shift at the end of the step and its duration, on which the load
    /// of a viscous material depends.
    ///
    /// # Errors
    /// As [`ContactLaw::advance`].
    fn advance_at(
        &mut self,
        shift: Shift,
        _rates: Shift,
        _duration: f64,
    ) -> Result<ContactLoad, Self::Error> {
        self.advance(shift)
    }

    /// As [`ContactLaw::advance`] on the effective path of a viscous material, in which slip lags. A law that does not
    /// keep the slip of each place makes the step as any other.
    ///
    /// # Errors
    /// As [`ContactLaw::advance`].
    fn advance_lagging(&mut self, shift: Shift, _lag: SlipLag) -> Result<ContactLoad, Self::Error> {
        self.advance(shift)
    }

    /// Whether the law keeps the slip of each place.
    fn keeps_slip(&self) -> bool {
        false
    }

    /// The friction over its limit, 1 where all slides, of a law whose load may be above the limit. None if the load tells.
    fn used_friction(&self) -> Option<f64> {
        None
    }

    /// The depth to which the contact is pressed at this shift and these rates: the approach, or less where a viscous
    /// material lags. The bodies separate where it is no longer positive.
    fn depth(&self, shift: Shift, _rates: Shift) -> f64 {
        shift.zeta
    }

    /// The present shift.
    fn shift(&self) -> Shift;

    /// The present load.
    fn load(&self) -> ContactLoad;

    /// Whether the load jumps on a straight step from the present shift to a new one. An
    /// integration in time then ends a step at the jump.
    fn jumps(&self, _to: Shift) -> bool {
        false
    }

    /// Whether a contact that slides as a whole would slide on if the shift went on at these rates. None if it does not
    /// slide, or if the end of sliding does not change its friction. An integration in time ends a step where sliding
    /// ends.
    fn slides_on(&self, _rates: Shift) -> Option<bool> {
        None
    }
}

/// A contact law that can be used in an impact. A law without further information implements it as
/// `impl ImpactLaw for MyLaw {}`.
pub trait ImpactLaw: ContactLaw {
    /// The number of annuli of the law, if it has any, as a measure of the work of a step.
    fn rings(&self) -> Option<usize> {
        None
    }
}

/// A contact law that can check a step beforehand, so that several contacts advance together or not
/// at all.
pub trait Checked: ContactLaw {
    /// Checks whether [`ContactLaw::advance`] would accept this shift; the state does not change.
    ///
    /// # Errors
    /// The errors of `advance`.
    fn check(&self, to: Shift) -> Result<(), Self::Error>;
}

/// A contact law with an elastic energy, and with the heat of a step before it is made.
///
/// The heat takes longer to compute than the force; [`crate::accounted::Accounted`] sums it up
/// where it is needed.
pub trait Dissipative: ContactLaw {
    /// The elastic energy of the contact, including compression.
    fn stored_energy(&self) -> f64;

    /// The energy that a straight step to a new shift would dissipate by slip or release at a
    /// receding edge. The state does not change; a step that would fail gives zero.
    fn dissipation(&self, to: Shift) -> f64;

    /// The work of the law's force in a straight step less the increase of its stored energy: the
    /// dissipation, and what is lost where the law simplifies its memory, which may be negative. The
    /// state does not change; a step that would fail gives zero.
    ///
    /// Summed over steps it closes an account of energies; the dissipation alone is that of slip.
    fn loss(&self, to: Shift) -> f64 {
        self.dissipation(to)
    }
}

/// A contact law with an account of its energies: the work done equals stored plus dissipated
/// energy.
pub trait Energies: ContactLaw {
    /// The elastic energy of the contact, including compression.
    fn stored_energy(&self) -> f64;

    /// The energy dissipated by slip or released at a receding edge since the beginning.
    fn dissipated(&self) -> f64;
}

/// Derivatives of a load by the parameters of its law, for the same history of shifts: that by kappa = c_z/c_x at the same c_z
/// is `-c_x/kappa` times that by c_x, and c_x and c_z hold moduli and radii.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LoadSensitivity {
    /// By the coefficient of friction f.
    pub by_friction: ContactLoad,
    /// By c_x, the tangential stiffness along the shift.
    pub by_c_x: ContactLoad,
    /// By c_z, the normal stiffness.
    pub by_c_z: ContactLoad,
    /// Whether an annulus of the contact grew just on the limit between adhesion and slip: the derivatives are then of one side,
    /// that of adhesion.
    pub is_at_change: bool,
}

/// A contact law whose load has derivatives by its parameters; those by the shift are of each law itself. Laws for which no
/// theory gives them do not implement it: where the shift turns, the memory is followed to a tolerance, which cuts and joins
/// its parts by the path, and under static friction the force jumps at instants that depend on the parameters.
///
/// For these take differences, of one run beside the law: forces along the surface are `f c_z G` of the path
/// `c_x xi/(f c_z)`, `c_y eta/(f c_z)` over zeta, with and without static friction (at the same f_s/f_k). With the derivative D of
/// a force F by the logarithm of a factor of all shifts, those by the logarithms of f (f_s and f_k together) and of c_z are
/// F - D, that by the logarithm of c_x and c_y together is D. The factor must change the path by much more than the tolerance
/// of the law does.
pub trait Sensitive: ContactLaw {
    /// The derivatives of the present load.
    fn sensitivity(&self) -> LoadSensitivity;
}
