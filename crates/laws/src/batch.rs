//! Many contacts at once.

use carom_halfspace::operator::Threads;
use carom_special::RangeError;
use rayon::prelude::*;

use crate::law::{Checked, ContactLoad, Shift};

/// Contacts that a thread takes at least.
const SHARE: usize = 256;

/// The laws of many contacts, advanced together, all or none.
///
/// On a stack of fixed capacity, which keeps a contact in one place, a
/// [`crate::shift_law::ShiftLaw`] draws turning slip to a tolerance of 1e-2 of the friction limit unless
/// told otherwise; [`crate::coulomb::CoulombMemory::error_estimate`] estimates the error.
///
/// ```
/// use carom_halfspace::operator::Threads;
/// use carom_laws::batch::Batch;
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLoad, Shift};
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// let law = ShiftLaw::<f64>::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
/// let mut batch = Batch::new(vec![law; 3], Threads::One);
/// let mut loads = [ContactLoad::default(); 3];
/// let shifts = [1.0, 1.0, -1.0].map(|zeta| Shift { zeta, ..Shift::default() });
/// batch.advance(&shifts, &mut loads)?;
/// assert!(loads[0].f_z > 0.0 && loads[2].f_z == 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Batch<L> {
    laws: Vec<L>,
    threads: Threads,
}

/// Why a batch step failed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BatchError {
    /// An array has not one entry for each contact.
    #[error("the array {array} has {length} entries for {contacts} contacts")]
    Length {
        /// The name of the array.
        array: &'static str,
        /// Its length.
        length: usize,
        /// The number of contacts.
        contacts: usize,
    },
    /// An entry is out of range.
    #[error("contact {contact}: {error}")]
    Range {
        /// The number of the contact, from 0.
        contact: usize,
        /// What is wrong.
        error: RangeError,
    },
}

impl<L: Checked<Error = RangeError> + Send + Sync> Batch<L> {
    /// Contacts, each with its own law; with [`Threads::Pool`] they step on all threads of the
    /// current rayon pool, to the same bits.
    #[must_use]
    pub const fn new(laws: Vec<L>, threads: Threads) -> Self {
        Self { laws, threads }
    }

    /// The single laws.
    #[must_use]
    pub fn laws(&self) -> &[L] {
        &self.laws
    }

    /// Advances every contact to its shift, and writes its load.
    ///
    /// # Errors
    /// [`BatchError`] for arrays of the wrong length, or the first contact that cannot go where it
    /// is told; nothing is then changed or written.
    pub fn advance(
        &mut self,
        shifts: &[Shift],
        loads: &mut [ContactLoad],
    ) -> Result<(), BatchError> {
        let contacts = self.laws.len();
        for (array, length) in [("shifts", shifts.len()), ("loads", loads.len())] {
            if length != contacts {
                return Err(BatchError::Length { array, length, contacts });
            }
        }
        let wrong = |(contact, (law, shift)): (usize, (&L, &Shift))| {
            law.check(*shift).err().map(|error| BatchError::Range { contact, error })
        };
        let step = |((law, shift), load): ((&mut L, &Shift), &mut ContactLoad)| {
            if let Ok(got) = law.advance(*shift) {
                *load = got; // always: it was checked
            }
        };
        match self.threads {
            Threads::One => {
                let mut pairs = self.laws.iter().zip(shifts).enumerate();
                pairs.find_map(wrong).map_or(Ok(()), Err)?;
                self.laws.iter_mut().zip(shifts).zip(loads).for_each(step);
            }
            Threads::Pool => {
                let pairs = self.laws.par_iter().zip(shifts).enumerate().with_min_len(SHARE);
                pairs.filter_map(wrong).find_first(|_| true).map_or(Ok(()), Err)?;
                let laws = self.laws.par_iter_mut().with_min_len(SHARE);
                laws.zip(shifts).zip(loads).for_each(step);
            }
        }
        Ok(())
    }
}
