//! The contact law as the rest of carom sees it: rigid shifts in, loads out.

use carom_special::RangeError;

use crate::bounds::{LARGEST, in_contact};

/// The rigid shift of body 2 against body 1 in the contact frame (z into body 1).
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
    /// Checks that all components are finite and of size up to 1e60, so that no energy overflows.
    ///
    /// # Errors
    /// [`RangeError`] that names the first one that is not.
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

/// A law that turns a history of rigid shifts into loads; its energies are traits on top of it.
///
/// The state clones cheaply, so that a step can be tried and thrown away. A failed step leaves
/// the state as it was.
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

    /// Goes straight from the present shift to a new one and returns the load there.
    ///
    /// An approach that is not positive separates the bodies.
    ///
    /// # Errors
    /// The law's own; the state is then unchanged.
    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, Self::Error>;

    /// The present shift.
    fn shift(&self) -> Shift;

    /// The present load.
    fn load(&self) -> ContactLoad;
}

/// A contact law that an impact can follow; one with nothing to say beside its loads is
/// `impl ImpactLaw for MyLaw {}`.
pub trait ImpactLaw: ContactLaw {
    /// The rings it is made of, if it is: the work of a step is counted by them.
    fn rings(&self) -> Option<usize> {
        None
    }
}

/// A law that knows beforehand whether a step is possible, so that many contacts step together or
/// not at all.
pub trait Checked: ContactLaw {
    /// Whether [`ContactLaw::advance`] would go to this shift. Nothing moves.
    ///
    /// # Errors
    /// Those of `advance`.
    fn check(&self, to: Shift) -> Result<(), Self::Error>;
}

/// A law that knows its elastic energy, and the heat of a step before it is taken.
///
/// Heat costs more than force; [`crate::accounted::Accounted`] adds it up for those who ask.
pub trait Dissipative: ContactLaw {
    /// The elastic energy of the contact, compression included.
    fn stored_energy(&self) -> f64;

    /// The energy that the straight step to a new shift would turn into heat, or release at a
    /// receding edge. Nothing moves; a step that would fail gives zero.
    fn dissipation(&self, to: Shift) -> f64;
}

/// A law that keeps account of its energies: work is what is stored and what is dissipated.
pub trait Energies: ContactLaw {
    /// The elastic energy of the contact, compression included.
    fn stored_energy(&self) -> f64;

    /// The energy turned into heat, or released by a receding edge, since the beginning.
    fn dissipated(&self) -> f64;
}
