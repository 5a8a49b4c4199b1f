//! A history of a twist in fixed room.

use carom_special::RangeError;

use super::pieces::PIECES_OF_A_STEP;
use super::{Pieces, TwistHistory, packed_numbers};
use crate::bounds::in_contact;
use crate::torsion::mesh;
use crate::torsion::segment::{Density, Segment};

/// Pieces of a history that are kept exactly, one or two for each reversal; beyond that those that matter least are
/// joined. Over random histories the error of the torque was then below 3e-4 of the sliding torque in the mean, and .02
/// at most.
const PIECES: usize = 12;
/// Number of joints of so many pieces.
const JOINTS: usize = PIECES - 2;

/// A history in fixed room, which may be kept as bytes; zeros stand for first contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub(in crate::torsion) struct StoredHistory {
    radius: f64,
    twist: f64,
    torque: f64,
    stick: f64,
    ring_steps: u32,
    level: u32,
    count: u32,
    /// Number of jumps that are known.
    known: u32,
    pieces: [Segment; PIECES],
    /// The jumps of the first joints, which most steps leave as they are.
    jumps: [f64; JOINTS],
}

impl StoredHistory {
    /// Number of numbers of [`StoredHistory::pack`].
    pub(in crate::torsion) const NUMBERS: usize = packed_numbers(PIECES);
    /// Bodies at first contact.
    pub(in crate::torsion) const NEW: Self = Self {
        radius: 0.0,
        twist: 0.0,
        torque: 0.0,
        stick: 0.0,
        ring_steps: 0,
        level: mesh::USUAL_LEVEL as u32,
        count: 0,
        known: 0,
        pieces: [Segment::new(0.0, Density::Stick(0.0), [0.0; 2], 0.0); PIECES],
        jumps: [0.0; JOINTS],
    };

    /// Checks bytes that may have been changed elsewhere, as far as a step needs it to end.
    #[inline]
    pub(in crate::torsion) fn check(&self) -> Result<(), RangeError> {
        let &Self { radius, twist, torque, stick, level, count, known, .. } = self;
        let sizes = (count as usize <= PIECES) & (known as usize <= JOINTS);
        let touches = radius > 0.0;
        let inside = (touches == (count > 0)) & (touches == (stick > 0.0)) & (stick <= radius);
        let holds = sizes & inside & (level as usize <= mesh::WIDEST_LEVEL) & torque.is_finite();
        RangeError::check("twist", torque, holds, "of a possible state")?;
        in_contact("twist", twist)?;
        in_contact("radius", radius).map(|_| ())
    }

    pub(in crate::torsion) fn history(&self) -> TwistHistory {
        let &Self { radius, twist, torque, stick, ring_steps, level, .. } = self;
        let kept = self.pieces.get(..self.count as usize).unwrap_or(&self.pieces);
        let (segments, level) = (Pieces::kept(kept), level as usize);
        TwistHistory { radius, twist, torque, stick, segments, ring_steps, level, unit: 1.0 }
    }

    /// Keeps this history, which was taken up from here, after a step; of too many pieces those that matter least are
    /// joined.
    pub(in crate::torsion) fn keep(&mut self, history: &mut TwistHistory) {
        self.known = self.known.min(history.segments.same().saturating_sub(2) as u32);
        if history.pieces() > PIECES {
            self.thin(history);
        }
        let &mut TwistHistory {
            radius, twist, torque, stick, ref segments, ring_steps, level, ..
        } = history;
        (self.radius, self.twist, self.torque, self.stick) = (radius, twist, torque, stick);
        (self.ring_steps, self.level) = (ring_steps, level as u32);
        let (same, count) = (segments.same(), segments.len());
        self.count = count as u32;
        self.pieces[same..count].copy_from_slice(&segments[same..]);
    }

    #[inline(never)]
    fn thin(&mut self, history: &mut TwistHistory) {
        let (mut near, mut far) = ([0.0; JOINTS + PIECES_OF_A_STEP], Vec::new());
        let joints = history.joints();
        let jumps = match near.get_mut(..joints) {
            Some(near) => near,
            None => {
                far.resize(joints, 0.0);
                &mut far
            }
        };
        let (known, others) = jumps.split_at_mut(self.known as usize);
        known.copy_from_slice(&self.jumps[..known.len()]);
        for (i, jump) in others.iter_mut().enumerate() {
            *jump = history.jump(known.len() + i);
        }
        history.thin(PIECES, jumps);
        self.jumps.copy_from_slice(&jumps[..JOINTS]);
        self.known = JOINTS as u32;
    }

    /// Writes the numbers of [`TwistHistory::pack`]; all are zero at first contact.
    pub(in crate::torsion) fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        if self.count == 0 {
            numbers.fill(0.0);
            return Ok(());
        }
        self.history().pack(numbers).map(|_| ())
    }
}
