//! The state of the law as plain numbers, for storage.

use carom_special::RangeError;

use super::centre;
use super::contact::{Contact, Sums};
use super::matrices::Rings;
use super::memory::RingMemory;
use super::pair::{PEAK, Pair};
use super::symmetry::Symmetry;
use super::transform::Field;
use crate::bounds::LEAST_APPROACH;
use crate::stored::{Fields, Reader, Writer, any};

/// How many numbers a history needs, in words.
const ROOM: &str = "11 and 6 for each place of a ring";
/// Allowed deviation of stored tractions from those of the stored slip, and of tractions beyond their limits,
/// in units of the tolerance (at least `FINEST`). In 18 000 steps at each of four tolerances the largest were 6 and 17.
const OFF: f64 = 40.0;
const FINEST: f64 = 1e-4;
/// Rounding of tractions relative to the largest displacement over the approach. It counts where the scale of
/// tractions is small against it: for large friction.
const ROUND_OFF: f64 = 1e-9;
/// Allowed deviation of tractions in full adhesion, which have no scale of their own, relative to the largest.
const STUCK_OFF: f64 = OFF * FINEST;
/// gamma f up to which it has ended so in 9 000 drawn states, at .75; from 1 on it has not in some.
const SETTLED_LIFT: f64 = 0.9;
/// Slip and tractions of shifts within their limits are smaller.
const LARGEST_IN_FIELD: f64 = 1e250;

/// Number of values of a stored state with this many rings and angles: 299 for 6 x 8.
#[must_use]
pub const fn packed_numbers(rings: usize, angles: usize) -> usize {
    // Shift, length of the last step, normal force, centre and lag of slip; slip, tractions and slip of the last step.
    11 + 3 * 2 * rings * angles
}

impl<const N: usize, const M: usize> RingMemory<N, M> {
    /// Writes the history as [`packed_numbers`] numbers. All zeros stand for two bodies that just touch. The
    /// constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] for too few numbers; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let mut writer = Writer::new(numbers, packed_numbers(N, M), ROOM)?;
        let mut copy = *self;
        copy.stored(&mut writer)?;
        writer.rest().fill(0.0);
        Ok(())
    }

    /// Passes over what is stored.
    fn stored(&mut self, fields: &mut impl Fields) -> Result<(), RangeError> {
        let Contact { slip, tractions, length, centre, lag, .. } = &mut self.contact;
        fields.shift(&mut self.shift)?;
        fields.number("length", length, RangeError::non_negative)?;
        fields.number("normal force", &mut self.sums.normal, RangeError::finite)?;
        fields.numbers("centre", centre, any)?;
        lag.stored(fields)?;
        for field in [slip, &mut tractions.z, &mut tractions.y] {
            let numbers = field.as_flattened_mut().as_flattened_mut();
            fields.numbers("slip or traction", numbers, |field, number| {
                let holds = number.abs() <= LARGEST_IN_FIELD;
                RangeError::check(field, number, holds, "at most 1e250 in magnitude")
            })?;
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
        let mut read = Self::default();
        read.stored(&mut Reader::new(numbers, ROOM))?;
        let Self { mut contact, sums: Sums { normal, .. }, shift } = read;
        let (mut sums, zeta, [x, y]) = (Sums::default(), shift.zeta, contact.centre);
        match rings.pair {
            Some(pair) if zeta > LEAST_APPROACH => {
                let fits = centre::fits([x, y], zeta);
                RangeError::check("centre", x.hypot(y), fits, "at most half of the radius off")?;
                let square = centre::square([x, y], zeta);
                contact.radius = square.sqrt();
                pair.follow(&mut contact.tractions);
                contact.rim = contact.at_rim(pair, square);
                let u = displacements(pair, &contact);
                let stuck = pair.sticking_to(&u);
                let room = room(rings.tolerance).max(beyond_scale(pair, &stuck, &contact));
                check_tractions(pair, &contact, (&u, &stuck), room)?;
                sums = contact.sums(pair);
                check_sums(pair, &sums, normal, room)?;
                if pair.slips {
                    sums.normal = normal;
                }
            }
            Some(_) => {
                contact = Contact::default();
                sums = Sums::just_touching(zeta);
                let holds = (normal - sums.normal).abs() <= ROUND_OFF * sums.normal;
                RangeError::check("normal force", normal, holds, "that of the approach")?;
            }
            None => contact = Contact::default(),
        }
        *self = Self { contact, sums, shift };
        Ok(())
    }
}

/// The displacements by the tractions, over the square of the radius.
fn displacements<const N: usize, const M: usize, S: Symmetry<M>>(
    pair: &Pair<N, M, S>,
    contact: &Contact<N, M>,
) -> Field<N, M> {
    let square = contact.radius * contact.radius;
    let mut u: Field<N, M> = [[[0.0; N]; 2]; M];
    for (j, [radial, around]) in u.iter_mut().enumerate() {
        for (i, (radial, around)) in radial.iter_mut().zip(around).enumerate() {
            let stretch = contact.stretch(pair, j, i);
            (*radial, *around) = (stretch[0] / square, stretch[1] / square);
        }
    }
    u
}

/// How many times their usual scale tractions may be off, if they are coupled and friction is so much that the pressures
/// that they add decide on their limits: after a shift far beyond the approach the iteration may end before they settle.
/// They are then at most those that would stick, and those that it has left where it may never settle.
fn beyond_scale<const N: usize, const M: usize, S: Symmetry<M>>(
    pair: &Pair<N, M, S>,
    stuck: &Field<N, M>,
    contact: &Contact<N, M>,
) -> f64 {
    if !settles(pair) {
        return (largest(stuck) + largest(&contact.tractions.z)) / pair.scale;
    }
    let is_usual = pair.scale >= PEAK || !pair.slips || pair.lift == 0.0;
    let beyond = if is_usual { 0.0 } else { largest(stuck) / pair.scale };
    if beyond > 1.0 { beyond } else { 0.0 }
}

/// Whether friction, times coupling, lets the iteration for the tractions end with all of them within their limits.
fn settles<const N: usize, const M: usize, S: Symmetry<M>>(pair: &Pair<N, M, S>) -> bool {
    !pair.slips || pair.lift <= SETTLED_LIFT
}

/// Checks that the tractions are those of the slip and within the friction limit.
fn check_tractions<const N: usize, const M: usize, S: Symmetry<M>>(
    pair: &Pair<N, M, S>,
    contact: &Contact<N, M>,
    (u, stuck): (&Field<N, M>, &Field<N, M>),
    room: f64,
) -> Result<(), RangeError> {
    let tractions = &contact.tractions;
    let above = room * pair.scale;
    let apart = match pair.slips {
        true => above + ROUND_OFF * (largest(u) + pair.spread),
        false => STUCK_OFF * largest(&tractions.z),
    };
    for (j, (q, z)) in stuck.iter().zip(&tractions.z).enumerate() {
        for i in 0..N {
            let off = (q[0][i] - z[0][i]).hypot(q[1][i] - z[1][i]);
            RangeError::check("traction", off, off <= apart, "that of the slip")?;
            let (size, limit) = (z[0][i].hypot(z[1][i]), tractions.limit[j][i]);
            let holds = !pair.slips || size <= limit * (1.0 + ROUND_OFF) + above;
            RangeError::check("traction", size, holds, "within the friction limit")?;
        }
    }
    Ok(())
}

/// Checks the stored normal force, and that the tractions store a finite energy.
fn check_sums<const N: usize, const M: usize, S: Symmetry<M>>(
    pair: &Pair<N, M, S>,
    sums: &Sums,
    normal: f64,
    room: f64,
) -> Result<(), RangeError> {
    RangeError::finite("stored energy", sums.stored)?;
    // Without slip F_z limits no force.
    let least = match pair.slips && settles(pair) {
        true => sums.force[0].hypot(sums.force[1]) * (1.0 - 1e-9),
        false => 0.0,
    };
    let off = (normal - sums.normal).abs();
    let holds = normal >= least && off <= room * sums.normal;
    RangeError::check("normal force", normal, holds, "that of the tractions").map(|_| ())
}

/// The largest size of a component.
fn largest<const N: usize, const M: usize>(field: &Field<N, M>) -> f64 {
    field.as_flattened().as_flattened().iter().fold(0.0, |most, part| most.max(part.abs()))
}

fn room(tolerance: f64) -> f64 {
    OFF * tolerance.max(FINEST)
}
