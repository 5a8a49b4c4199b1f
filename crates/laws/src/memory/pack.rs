//! Stores the state of the law of chapter 7 as plain numbers.

use carom_special::RangeError;

use super::{Lateral, Memory, MemoryRegime, Vertex, VertexStack};
use crate::bounds::{LARGEST_ANCHOR, in_memory, stored_number};
use crate::profile::NormalProfile;

/// The version of the format; the first number is `1e4 version + 100 regime + vertices`. Version 1
/// is that of [`crate::coulomb`], 3 that of a contact without friction.
const VERSION: f64 = 2.0;
/// Number of values stored before the vertices.
pub(super) const HEAD: usize = 6;
const EACH: usize = 5;
/// The greatest number of vertices that the first number can represent.
pub(super) const MOST: usize = 99;

const REGIMES: [MemoryRegime; 7] = [
    MemoryRegime::Separated,
    MemoryRegime::Adhesion,
    MemoryRegime::Release,
    MemoryRegime::Slip,
    MemoryRegime::Reversal,
    MemoryRegime::Overlay,
    MemoryRegime::Sliding,
];

impl MemoryRegime {
    /// Number of regimes.
    pub(crate) const COUNT: u8 = REGIMES.len() as u8;

    /// Its position in the list of regimes, by which it is stored.
    pub(crate) fn number(self) -> u8 {
        REGIMES.iter().position(|regime| *regime == self).unwrap_or(0) as u8
    }

    /// The regime of a stored number, if it is valid.
    pub(crate) fn of_number(number: f64) -> Option<Self> {
        let holds = number >= 0.0 && number < REGIMES.len() as f64;
        holds.then(|| REGIMES[number as usize])
    }
}

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
        let room = numbers.len() as f64;
        let holds = numbers.len() >= HEAD + EACH * len && len <= MOST;
        RangeError::check("numbers", room, holds, ">= 6 + 5 per vertex, of which at most 99")?;
        let [x, y] = self.shift.components();
        let anchor = if len > 0 { self.stack.get(0).anchor } else { V::default() };
        let [w_x, w_y] = anchor.components();
        let mark = 1e4 * VERSION + 100.0 * f64::from(self.regime.number()) + len as f64;
        numbers[..HEAD].copy_from_slice(&[mark, self.zeta, x, y, w_x, w_y]);
        let (vertices, rest) = numbers[HEAD..].split_at_mut(EACH * len);
        for (i, numbers) in vertices.chunks_exact_mut(EACH).enumerate() {
            let vertex = self.stack.get(i);
            let depth = if vertex.is_slip() { -vertex.depth } else { vertex.depth };
            let [m_x, m_y] = vertex.slope.components();
            let [p_x, p_y] = vertex.force_slope.components();
            numbers.copy_from_slice(&[depth, m_x, m_y, p_x, p_y]);
        }
        rest.fill(0.0);
        Ok(())
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
        let format = (VERSION, EACH, "of version 2");
        let (regime, len) = check(numbers, format, self.stack.capacity(), LARGEST_ANCHOR)?;
        within_cone::<V, P>(numbers, len, &self.profile)?;
        self.regime = regime;
        self.zeta = numbers[1];
        self.shift = V::from_components([numbers[2], numbers[3]]);
        self.stack.truncate(0);
        self.force = V::default();
        for (vertex, top) in chain(numbers, len, &self.profile) {
            self.stack.push(vertex);
            self.force = vertex.force_at(top, &self.profile);
        }
        Ok(())
    }
}

/// The stored vertices from the lowest on, each with the depth of its upper end; anchors and forces
/// are summed up.
fn chain<V: Lateral, P: NormalProfile>(
    numbers: &[f64],
    len: usize,
    profile: &P,
) -> impl Iterator<Item = (Vertex<V>, f64)> {
    let mut anchor = V::from_components([numbers[4], numbers[5]]);
    let mut force = V::default();
    (0..len).map(move |i| {
        let vertex = vertex(&numbers[HEAD + EACH * i..], anchor, force);
        let above = numbers.get(HEAD + EACH * (i + 1)).filter(|_| i + 1 < len);
        let top = above.map_or(numbers[1], |depth| depth.abs());
        anchor = vertex.anchor_at(top);
        force = vertex.force_at(top, profile);
        (vertex, top)
    })
}

/// Relative tolerance of slopes and of their ends: rounding of slopes that were divided by the
/// width of thin annuli.
const SLOPE_TOLERANCE: f64 = 1e-9;
/// Largest slope of an annulus so thin that its slope is meaningless.
const LARGEST_SLOPE: f64 = 1e3;

/// Checks that all annuli are within the friction cone: anchors and forces with slopes at most 1,
/// and the anchor at the edge equal to the shift.
fn within_cone<V: Lateral, P: NormalProfile>(
    numbers: &[f64],
    len: usize,
    profile: &P,
) -> Result<(), RangeError> {
    if len == 0 {
        return Ok(());
    }
    let shift = V::from_components([numbers[2], numbers[3]]);
    let mut anchor = V::from_components([numbers[4], numbers[5]]);
    let size = numbers[1] + shift.length() + anchor.length();
    let vertices = &numbers[HEAD..HEAD + EACH * len];
    for (i, vertex) in vertices.chunks_exact(EACH).enumerate() {
        let depth = vertex[0].abs();
        let top = vertices.get(EACH * (i + 1)).map_or(numbers[1], |depth| depth.abs());
        let squares = [1, 3].map(|k| vertex[k] * vertex[k] + vertex[k + 1] * vertex[k + 1]);
        if !squares.iter().all(|square| *square <= 1.0 + SLOPE_TOLERANCE) {
            let limits = [size, profile.force(numbers[1])];
            check_steep(squares, [top - depth, profile.growth(depth, top - depth)], limits)?;
        }
        anchor = anchor.plus(V::from_components([vertex[1], vertex[2]]).times(top - depth));
    }
    let gap = anchor.minus(shift).length();
    RangeError::check(
        "anchor",
        gap,
        gap <= SLOPE_TOLERANCE * size,
        "equal to the shift at the edge",
    )?;
    Ok(())
}

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

/// The vertex that five numbers represent, above the given anchor and force.
fn vertex<V: Lateral>(numbers: &[f64], anchor: V, force: V) -> Vertex<V> {
    let slope = V::from_components([numbers[1], numbers[2]]);
    let curb = (1.0 - slope.dot(slope)).max(0.0);
    Vertex {
        depth: numbers[0].abs(),
        anchor,
        slope,
        force_slope: V::from_components([numbers[3], numbers[4]]),
        force,
        curb: if numbers[0].is_sign_negative() { 0.0 } else { curb },
    }
}

/// The regime and the number of vertices, if the numbers are a state of this version with this many
/// numbers per vertex, all but the place at most `most`.
pub(super) fn check(
    numbers: &[f64],
    (version, each, of_version): (f64, usize, &'static str),
    capacity: usize,
    most: f64,
) -> Result<(MemoryRegime, usize), RangeError> {
    let room = numbers.len() as f64;
    RangeError::check("numbers", room, numbers.len() >= HEAD, ">= 6")?;
    let mark = if numbers[0] == 0.0 { 1e4 * version } else { numbers[0] };
    let rest = mark - 1e4 * version;
    let (regime, len) = ((rest / 100.0).floor(), rest.rem_euclid(100.0));
    let known = MemoryRegime::of_number(regime).filter(|_| len == len.floor());
    let regime = known.ok_or(RangeError::new("mark", mark, of_version))?;
    let len = len as usize;
    let holds = len <= capacity && numbers.len() >= HEAD + each * len;
    RangeError::check(
        "vertices",
        len as f64,
        holds,
        "at most the number that the storage can hold",
    )?;
    let (place, rest) = numbers[1..HEAD + each * len].split_at(3);
    place.iter().try_for_each(|value| in_memory("numbers", *value).map(|_| ()))?;
    rest.iter().try_for_each(|value| stored_number(*value, most).map(|_| ()))?;
    let mut below = -1.0;
    for vertex in numbers[HEAD..].chunks_exact(each).take(len) {
        let depth = vertex[0].abs();
        // An annulus thinner than rounding begins where it ends.
        let rises = if below < 0.0 { depth == 0.0 } else { depth >= below && depth <= numbers[1] };
        RangeError::check("depth", depth, rises, "rising from 0 to the approach")?;
        below = depth;
    }
    RangeError::check("approach", numbers[1], (numbers[1] > 0.0) == (len > 0), "> 0 in contact")?;
    Ok((regime, len))
}
