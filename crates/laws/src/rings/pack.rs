//! The state of the law as plain numbers, for storage.

use carom_special::RangeError;

use super::contact::Contact;
use super::matrices::Rings;
use super::memory::RingMemory;
use super::pair::Pair;
use super::symmetry::Symmetry;
use super::transform::Field;
use crate::bounds::in_contact;
use crate::law::Shift;

/// Number of values before the fields: shift, length of the last step, normal force.
const HEAD: usize = 6;
/// Number of stored fields: slip, tractions, slip of the last step.
const FIELDS: usize = 3;
/// Allowed deviation of stored tractions from those of the stored slip, and of tractions beyond their limits,
/// in units of the tolerance (at least `FINEST`). In 18 000 steps at each of four tolerances the largest were 6 and 17.
const OFF: f64 = 40.0;
const FINEST: f64 = 1e-4;

/// Number of values of a stored state with this many rings and angles: 294 for 6 x 8.
#[must_use]
pub const fn packed_numbers(rings: usize, angles: usize) -> usize {
    HEAD + FIELDS * 2 * rings * angles
}

impl<const N: usize, const M: usize> RingMemory<N, M> {
    /// Writes the history as [`packed_numbers`] numbers. All zeros stand for two bodies that just touch. The
    /// constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] for too few numbers; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        check_room::<N, M>(numbers.len())?;
        numbers.fill(0.0);
        let Shift { zeta, xi, eta, omega } = self.shift;
        let head = [zeta, xi, eta, omega, self.contact.length, self.sums.normal];
        numbers[..HEAD].copy_from_slice(&head);
        let Contact { slip, tractions, .. } = &self.contact;
        for (field, part) in
            [slip, &tractions.z, &tractions.y].into_iter().zip(parts::<N, M>(numbers))
        {
            part.copy_from_slice(field.as_flattened().as_flattened());
        }
        Ok(())
    }

    /// Restores what [`RingMemory::pack`] of a contact with the same constants wrote, to the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a state of such a contact; nothing is then changed.
    pub fn unpack<S: Symmetry<M>>(
        &mut self,
        rings: &Rings<'_, N, M, S>,
        numbers: &[f64],
    ) -> Result<(), RangeError> {
        check_room::<N, M>(numbers.len())?;
        let [zeta, xi, eta, omega, length, normal] = std::array::from_fn(|i| numbers[i]);
        let shift = Shift { zeta, xi, eta, omega };
        shift.check_finite()?;
        in_contact("length", RangeError::non_negative("length", length)?)?;
        for &number in &numbers[HEAD..packed_numbers(N, M)] {
            in_contact("slip or traction", number)?;
        }
        let mut contact = Contact::default();
        let mut fields = [[[[0.0; N]; 2]; M]; FIELDS];
        let each = 2 * N * M;
        for (field, part) in fields.iter_mut().zip(numbers[HEAD..].chunks_exact(each)) {
            field.as_flattened_mut().as_flattened_mut().copy_from_slice(part);
        }
        [contact.slip, contact.tractions.z, contact.tractions.y] = fields;
        let mut sums = super::contact::Sums::default();
        if let (Some(pair), true) = (rings.pair, zeta > 0.0) {
            (contact.radius, contact.length) = (zeta.sqrt(), length);
            pair.follow(&mut contact.tractions);
            contact.rim = contact.at_rim(pair, zeta);
            check_tractions(pair, &contact, rings.tolerance)?;
            sums = contact.sums(pair);
            let least = sums.force[0].hypot(sums.force[1]) * (1.0 - 1e-9);
            let off = (normal - sums.normal).abs();
            let holds =
                !pair.slips || (normal >= least && off <= room(rings.tolerance) * sums.normal);
            RangeError::check("normal force", normal, holds, "that of the tractions")?;
            sums.normal = normal;
        } else {
            contact = Contact::default();
        }
        *self = Self { contact, sums, shift };
        Ok(())
    }
}

/// Checks that the tractions are those of the slip and within the friction limit.
fn check_tractions<const N: usize, const M: usize, S: Symmetry<M>>(
    pair: &Pair<N, M, S>,
    contact: &Contact<N, M>,
    tolerance: f64,
) -> Result<(), RangeError> {
    let square = contact.radius * contact.radius;
    let mut u: Field<N, M> = [[[0.0; N]; 2]; M];
    for (j, [radial, around]) in u.iter_mut().enumerate() {
        for (i, (radial, around)) in radial.iter_mut().zip(around).enumerate() {
            let stretch = contact.stretch(pair, j, i);
            (*radial, *around) = (stretch[0] / square, stretch[1] / square);
        }
    }
    let stuck = pair.sticking_to(&u);
    let room = room(tolerance) * pair.scale;
    for (j, (q, z)) in stuck.iter().zip(&contact.tractions.z).enumerate() {
        for i in 0..N {
            let off = (q[0][i] - z[0][i]).hypot(q[1][i] - z[1][i]);
            let size = z[0][i].hypot(z[1][i]);
            let scale = if pair.slips { room } else { room * (1.0 + size) };
            RangeError::check("traction", off, off <= scale, "that of the slip")?;
            let limit = contact.tractions.limit[j][i] + room;
            let holds = !pair.slips || size <= limit;
            RangeError::check("traction", size, holds, "within the friction limit")?;
        }
    }
    Ok(())
}

fn room(tolerance: f64) -> f64 {
    OFF * tolerance.max(FINEST)
}

fn check_room<const N: usize, const M: usize>(room: usize) -> Result<(), RangeError> {
    let holds = room >= packed_numbers(N, M);
    RangeError::check("numbers", room as f64, holds, "6 and 6 for each place of a ring").map(|_| ())
}

fn parts<const N: usize, const M: usize>(numbers: &mut [f64]) -> impl Iterator<Item = &mut [f64]> {
    numbers[HEAD..].chunks_exact_mut(2 * N * M)
}
