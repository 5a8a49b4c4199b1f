//! Stores the state of the law of chapter 7 as plain numbers.

use carom_special::RangeError;

use super::stored::{Form, Head};
use super::{Lateral, Memory, Vertex, VertexStack};
use crate::bounds::in_stored_memory;
use crate::profile::NormalProfile;

/// Beside the head the lowest anchor; of each vertex the depth (negative if the segment above is a slip segment), its
/// slope and the slope of its force.
const FORM: Form<2> = Form { version: 2.0, range: in_stored_memory, is_thin: true };

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// Writes the state as numbers: a mark of version, regime and number of vertices, the approach,
    /// the shift, the lowest anchor, and for each vertex its depth (negative if the segment above
    /// is a slip segment), its slope and the slope of its force. The rest of the slice is set to
    /// zero. All zeros represent two separated bodies. Vertices need as many numbers as those of
    /// [`crate::coulomb::packed_numbers`].
    ///
    /// # Errors
    /// [`RangeError`] if the slice is too short for the vertices; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let len = self.stack.len();
        let anchor = if len > 0 { self.stack.get(0).anchor } else { V::default() };
        let own = anchor.components();
        let head = Head { regime: self.regime, zeta: self.zeta, shift: self.shift, own };
        let vertices = (0..len).map(|i| {
            let vertex = self.stack.get(i);
            let depth = if vertex.is_slip() { -vertex.depth } else { vertex.depth };
            (depth, [vertex.slope, vertex.force_slope])
        });
        FORM.write(numbers, head, vertices)
    }

    /// Restores a state from the numbers of [`Memory::pack`]. Anchors and forces are summed up
    /// again and may differ by rounding.
    ///
    /// # Errors
    /// [`RangeError`] for another version, too few numbers, more vertices than the storage can
    /// hold, depths that do not rise to the approach, slopes of anchors or forces above 1, an
    /// anchor at the edge that differs from the shift, or values out of range; the state is then
    /// unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let (head, vertices) = FORM.read(numbers, self.stack.capacity())?;
        let Head { regime, zeta, shift, own } = head;
        let mut read = Self { regime, zeta, shift, force: V::default(), ..self.clone() };
        read.stack.truncate(0);
        let mut anchor = V::from_components(own);
        let size = zeta + shift.length() + anchor.length();
        let vertices = Form::vertices::<V>(vertices);
        let tops = vertices.clone().skip(1).map(|(depth, _)| depth.abs()).chain([zeta]);
        for ((depth, [slope, force_slope]), top) in vertices.zip(tops) {
            let is_slip = depth.is_sign_negative();
            let (depth, force) = (depth.abs(), read.force);
            let squares = [slope, force_slope].map(|slope| slope.dot(slope));
            if !squares.iter().all(|square| *square <= 1.0 + SLOPE_TOLERANCE) {
                let limits = [size, self.profile.force(zeta)];
                let parts = [top - depth, self.profile.growth(depth, top - depth)];
                check_steep(squares, parts, limits)?;
            }
            let curb = if is_slip { 0.0 } else { (1.0 - squares[0]).max(0.0) };
            let vertex = Vertex { depth, anchor, slope, force_slope, force, curb };
            anchor = vertex.anchor_at(top);
            read.force = vertex.force_at(top, &self.profile);
            read.stack.push(vertex);
        }
        let gap = anchor.minus(shift).length();
        let holds = read.stack.is_empty() || gap <= SLOPE_TOLERANCE * size;
        RangeError::check("anchor", gap, holds, "equal to the shift at the edge")?;
        *self = read;
        Ok(())
    }
}

/// Relative tolerance of slopes and of their ends: rounding of slopes that were divided by the
/// width of thin annuli.
const SLOPE_TOLERANCE: f64 = 1e-9;
/// Largest slope of an annulus so thin that its slope is meaningless.
const LARGEST_SLOPE: f64 = 1e3;

/// Checks that an annulus with a slope above 1 exceeds it by rounding only, because it is thin.
#[cold]
fn check_steep(squares: [f64; 2], parts: [f64; 2], wholes: [f64; 2]) -> Result<(), RangeError> {
    for (k, field) in ["slope", "slope of the force"].into_iter().enumerate() {
        let slope = squares[k].sqrt();
        let by_round_off =
            slope * parts[k] <= parts[k] + SLOPE_TOLERANCE * wholes[k] && slope <= LARGEST_SLOPE;
        RangeError::check(field, slope, slope <= 1.0 + SLOPE_TOLERANCE || by_round_off, "<= 1")?;
    }
    Ok(())
}
