//! Stores the state of a twist as plain numbers.

use carom_special::RangeError;

use super::TwistHistory;
use crate::bounds::in_contact;
use crate::stored::{Reader, Writer, any};
use crate::torsion::mesh;
use crate::torsion::segment::{Density, Segment, stuck_torque};
use crate::torsion::within::demand_inside;

/// The version of the format; the first number is `1e4 version + level of the rings`.
const VERSION: f64 = 5.0;
/// Number of values stored before the pieces.
const HEAD: usize = 7;
/// Least number of pieces that a stored state must have room for.
const FEWEST_PIECES: usize = 4;
/// Room for them, in words.
const ROOM: &str = ">= 31, room for four pieces";

/// Number of values of a stored twist with this many pieces of density, [`TwistHistory::pack`].
#[must_use]
pub const fn packed_numbers(pieces: usize) -> usize {
    HEAD + Segment::NUMBERS * pieces
}

impl TwistHistory {
    /// Number of pieces of density in the history: each reversal of the twist adds one or two,
    /// rings about a hundred.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.segments.len()
    }

    /// Writes the state as numbers: a mark of the version, the number of pieces, radius, twist,
    /// torque, stick radius, steps with rings, and six numbers per piece, [`packed_numbers`]. The
    /// rest of the slice is set to zero. All zeros represent two bodies at first contact.
    ///
    /// If there is not enough room for all pieces, those that matter least are joined. Their twist
    /// and the present torque are kept; a later torque may jump. The greatest of these jumps is
    /// returned, in the unit of the torque; zero if nothing was lost. When the state was stored
    /// after each step of random paths, the errors of the torque relative to the sliding torque
    /// were, mean and worst: 4 pieces .004, .3; 8 pieces 3e-4, .02; 16 pieces 4e-5, .004; 32 pieces
    /// 6e-6, 6e-4.
    ///
    /// ```
    /// use carom_laws::torsion::history::{TwistHistory, packed_numbers};
    /// let mut history = TwistHistory::new();
    /// history.advance(1.0, 0.0)?;
    /// history.advance(1.0, 0.6)?;
    /// let mut numbers = [0.0; packed_numbers(8)];
    /// assert_eq!(history.pack(&mut numbers)?, 0.0);
    /// let mut again = TwistHistory::new();
    /// again.unpack(&numbers)?;
    /// assert_eq!(again, history);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if there is room for fewer than four pieces; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<f64, RangeError> {
        Writer::new(numbers, packed_numbers(FEWEST_PIECES), ROOM)?;
        let capacity = (numbers.len() - HEAD) / Segment::NUMBERS;
        if self.segments.len() <= capacity {
            self.write(numbers)?;
            return Ok(0.0);
        }
        let mut thinned = self.clone();
        let mut jumps: Vec<f64> = (0..self.joints()).map(|i| self.jump(i)).collect();
        let jump = thinned.thin(capacity, &mut jumps);
        thinned.write(numbers)?;
        Ok(jump)
    }

    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let Self { radius, twist, torque, stick, segments, ring_steps, level, .. } = self;
        let mut writer = Writer::new(numbers, packed_numbers(segments.len()), ROOM)?;
        writer.write(&[1e4 * VERSION + *level as f64, segments.len() as f64]);
        writer.write(&[*radius, *twist, *torque, *stick, f64::from(*ring_steps)]);
        for mut segment in segments.iter().copied() {
            segment.stored(&mut writer)?;
        }
        writer.rest().fill(0.0);
        Ok(())
    }

    /// Restores a state from the numbers of [`TwistHistory::pack`], bit for bit.
    ///
    /// # Errors
    /// [`RangeError`] for another version, too few numbers, radii that do not increase, invalid
    /// signs, a torque above that of sliding, or values out of range; the state is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        *self = Self::read(numbers)?;
        Ok(())
    }

    /// The state of [`TwistHistory::unpack`].
    #[inline]
    pub(in crate::torsion) fn read(numbers: &[f64]) -> Result<Self, RangeError> {
        let mut reader = Reader::new(numbers, ">= 7");
        let head = reader.read("numbers", any)?;
        if head == [0.0; HEAD] {
            return Ok(Self::new());
        }
        let [mark, count, radius, twist, torque, stick, ring_steps] = head;
        let level = mark - 1e4 * VERSION;
        let known = (0.0..=mesh::WIDEST_LEVEL as f64).contains(&level) && level == level.floor();
        RangeError::check("mark", mark, known, "of version 5")?;
        let pieces = reader.rest().chunks_exact(Segment::NUMBERS);
        let fits = (0.0..=pieces.len() as f64).contains(&count) && count == count.floor();
        RangeError::check("pieces", count, fits, "at most the number that the storage can hold")?;
        in_contact("radius", radius)?;
        in_contact("twist", twist)?;
        RangeError::finite("torque", torque)?;
        RangeError::check("radius", radius, (radius > 0.0) == (count > 0.0), "> 0 in contact")?;
        let within = (0.0..=radius).contains(&stick) && (stick > 0.0) == (radius > 0.0);
        RangeError::check("stick radius", stick, within, "> 0 in contact, at most the radius")?;
        let counts = (0.0..=f64::from(u32::MAX)).contains(&ring_steps);
        RangeError::check("ring steps", ring_steps, counts, "a number of steps")?;
        let mut below = 0.0;
        let segments = pieces.take(count as usize).enumerate().map(|(i, numbers)| {
            let mut piece = Segment::default();
            piece.stored(&mut Reader::new(numbers, ">= 6"))?;
            let Segment { from, slid, value, .. } = piece;
            let rises = from >= below && from < radius && (i == 0) == (from == 0.0);
            RangeError::check("piece", from, rises, "rising from 0 to below the radius")?;
            RangeError::check("slip radius", slid, i > 0 || slid == 0.0, "0 at the centre")?;
            RangeError::non_negative("slip radius", slid)?;
            RangeError::check("sign", value, slid == 0.0 || value.abs() == 1.0, "1 or -1")?;
            below = from;
            Ok(piece)
        });
        let (segments, level) = (segments.collect::<Result<_, RangeError>>()?, level as usize);
        let ring_steps = ring_steps as u32;
        let read = Self { radius, twist, torque, stick, segments, ring_steps, level, unit: 1.0 };
        read.check_meaning()?;
        Ok(read)
    }

    /// Joins neighbouring pieces, those with the least effect first, until this many are left.
    /// Returns the greatest jump of the torque. `jumps` has the jump of each joint, and at the end that of each that is
    /// left.
    pub(super) fn thin(&mut self, pieces: usize, mut jumps: &mut [f64]) -> f64 {
        let mut worst: f64 = 0.0;
        while self.segments.len() > pieces.max(FEWEST_PIECES) {
            let each = jumps.iter().copied().enumerate();
            let Some((i, jump)) = each.min_by(|one, other| one.1.total_cmp(&other.1)) else {
                break;
            };
            self.segments.join(i, self.joined(i));
            worst = worst.max(jump);
            // Only joints with the new piece have changed.
            jumps.copy_within(i + 1.., i);
            let left = jumps.len() - 1;
            jumps = &mut jumps[..left];
            let (from, to) = (i.saturating_sub(1), i + 1);
            for (i, jump) in jumps.iter_mut().enumerate().take(to).skip(from) {
                *jump = self.jump(i);
            }
        }
        worst
    }

    /// The number of joints. The outermost piece may still be sliding.
    pub(super) fn joints(&self) -> usize {
        self.segments.len().saturating_sub(2)
    }

    /// The end of the piece above another one.
    fn end_above(&self, i: usize) -> f64 {
        self.segments.get(i + 2).map_or(self.radius, |next| next.from)
    }

    /// A piece and the one above it as one with the mean density and the same twist at both ends.
    fn joined(&self, i: usize) -> Segment {
        let end = self.end_above(i);
        let Joint { from, density, twist, torque, .. } = self.joint(i);
        let [lower, upper] = [&self.segments[i], &self.segments[i + 1]];
        let demand = lower.demand.max(upper.demand).max(demand_inside(end, density));
        Segment::new(from, Density::Stick(density), [twist, torque], demand)
    }

    /// The change of the torque inside the end of a joint.
    pub(super) fn jump(&self, i: usize) -> f64 {
        let jump = self.joint(i).jump.abs();
        if jump.is_nan() { f64::INFINITY } else { jump }
    }

    fn joint(&self, i: usize) -> Joint {
        let [lower, upper] = [&self.segments[i], &self.segments[i + 1]];
        let (from, end) = (lower.from, self.end_above(i));
        let (twist, torque) = lower.inside(from);
        let (outer_twist, outer_torque) = upper.inside(end);
        let density = (outer_twist - twist) / (end - from);
        let jump = torque + stuck_torque(density, from, end) - outer_torque;
        Joint { from, density, twist, torque, jump }
    }
}

/// Two pieces as one, without the contact radius that bounds its density.
struct Joint {
    from: f64,
    density: f64,
    /// Twist and torque inside `from`.
    twist: f64,
    torque: f64,
    /// The torque inside its end, less that of the pieces.
    jump: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joins the pieces with the least jump of all, which are looked for again each time.
    fn thinned_by_search(mut history: TwistHistory, pieces: usize) -> (TwistHistory, f64) {
        let mut worst: f64 = 0.0;
        while history.segments.len() > pieces {
            let joints = (0..history.segments.len() - 2).map(|i| (history.jump(i), i));
            let (jump, i) = joints.min_by(|a, b| a.0.total_cmp(&b.0)).expect("many pieces");
            history.segments.join(i, history.joined(i));
            worst = worst.max(jump);
        }
        (history, worst)
    }

    #[test]
    fn each_join_is_that_of_the_least_jump() {
        let mut history = TwistHistory::new();
        for (radius, twist) in [(1.0, 0.0), (1.0, 0.5), (1.0, 0.1)] {
            history.advance(radius, twist).expect("in range");
        }
        for i in 1..40 {
            let time = f64::from(i);
            let twist = 0.1 + 0.004 * time + 0.003 * (0.9 * time).sin();
            history.advance(1.0 + 0.01 * time, twist).expect("in range");
        }
        assert!(history.pieces() > 20, "{}", history.pieces());
        for pieces in 4..history.pieces() {
            let mut thinned = history.clone();
            let mut jumps: Vec<f64> = (0..history.joints()).map(|i| history.jump(i)).collect();
            let jump = thinned.thin(pieces, &mut jumps);
            let rise = |pair: &[Segment]| pair[0].demand <= pair[1].demand;
            assert!(thinned.segments.windows(2).all(rise), "demands rise outwards");
            assert_eq!((thinned, jump), thinned_by_search(history.clone(), pieces), "{pieces}");
        }
    }

    /// Torques grow with the fourth power of the radius.
    #[test]
    fn great_contacts_come_back() {
        for radius in [1e25, 1e59] {
            let mut history = TwistHistory::new();
            for (radius, twist) in
                [(radius, 0.0), (radius, 0.5), (0.9 * radius, 0.2), (radius, 0.3)]
            {
                history.advance(radius, twist * radius).expect("in range");
            }
            assert!(history.torque().abs() > 1e-3 * radius.powi(4));
            let mut numbers = vec![0.0; 400];
            history.pack(&mut numbers).expect("room");
            let mut read = TwistHistory::new();
            read.unpack(&numbers).expect("stored before");
            assert_eq!(read, history);
        }
    }
}
