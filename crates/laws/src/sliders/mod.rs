//! An incremental law in two directions: springs with sliders that slip in the direction of their
//! traction.
//!
//! If the direction of the shift changes, the law of chapter 7 keeps one direction of traction in a
//! whole slip annulus. Here each spring of the equivalent foundation slips by itself, parallel to
//! its own traction in the physical (xi, eta) plane. Neither is exact for such shifts (the true
//! traction is bounded at each point, not for each spring), but this law is more accurate: at the
//! ends of the three examples of section 7.7 the error of the law of chapter 7 is 0.038, 0.214 and
//! 0.084 (in units of f F_z), that of this law 0.001, 0.012 and 0.005, measured against an
//! axisymmetric half-space solution by annuli. On straight paths all agree. The cost is a slider
//! for each spring instead of a few vertices.

mod lines;
mod ring;
mod turning;

pub use lines::SlipLines;
pub use ring::sliding_direction;

use carom_special::RangeError;

use self::ring::SlipStep;
use crate::bounds::in_memory;
use crate::memory::Lateral;

/// Number of parts of a step for the integration of the heat.
const PARTS: usize = 64;
/// Directions of tractions are computed to this angle if the stiffnesses differ, radians.
const FINEST: f64 = 1e-8;

/// Springs with sliders, equally spaced in the contact radius up to a greatest approach.
///
/// Normalised as [`crate::memory::Memory`], `X = (c_x xi, c_y eta)/(f c_z)`; the ratio c_x/c_y
/// converts slip to the physical plane.
///
/// ```
/// use carom_laws::sliders::SliderLaw;
/// let mut law = SliderLaw::new(400, 1.0, 1.0)?;
/// law.advance(1.0, [0.0, 0.0])?;
/// let force = law.advance(1.0, [0.5, 0.0])?;
/// assert!((force[0] - (1.0 - 0.5_f64.powf(1.5))).abs() < 1e-6);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SliderLaw {
    /// c_x and c_y, divided by c_y.
    stiffness: [f64; 2],
    spacing: f64,
    zeta: f64,
    shift: [f64; 2],
    /// Depths at which the springs come into contact, and their anchors.
    springs: Vec<(f64, [f64; 2])>,
}

impl SliderLaw {
    /// A contact in its initial state with `count` springs, for approaches up to `deepest`. The
    /// stiffness along x is `stiffness_ratio` times that along y.
    ///
    /// # Errors
    /// [`RangeError`] unless there is at least one spring and the arguments are finite and
    /// positive.
    pub fn new(count: usize, deepest: f64, stiffness_ratio: f64) -> Result<Self, RangeError> {
        RangeError::check("count", count as f64, count > 0, "> 0")?;
        RangeError::positive("deepest", deepest)?;
        RangeError::positive("stiffness_ratio", stiffness_ratio)?;
        // Equal spacing in sqrt(s), where the springs are equally stiff.
        let spacing = deepest.sqrt() / count as f64;
        let springs = (0..count)
            .map(|i| {
                let root = (i as f64 + 0.5) * spacing;
                (root * root, [0.0; 2])
            })
            .collect();
        let stiffness = [stiffness_ratio, 1.0];
        Ok(Self { stiffness, spacing, zeta: 0.0, shift: [0.0; 2], springs })
    }

    /// The approach.
    #[must_use]
    pub const fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The normalised shift.
    #[must_use]
    pub const fn shift(&self) -> [f64; 2] {
        self.shift
    }

    /// The springs from the centre outwards: the approach at which each comes into contact, and its
    /// anchor, the shift at which it would carry no traction. Springs not yet in contact are at
    /// zero.
    ///
    /// ```
    /// use carom_laws::sliders::SliderLaw;
    /// let mut law = SliderLaw::new(100, 1.0, 1.0)?;
    /// law.advance(1.0, [0.0, 0.0])?;
    /// law.advance(1.0, [0.5, 0.0])?;
    /// // Beyond half the depth a spring carries its limit, the rest of the depth.
    /// let held = law.springs().all(|(depth, anchor)| {
    ///     (0.5 - anchor[0] - 0.5_f64.min(1.0 - depth)).abs() < 1e-15
    /// });
    /// assert!(held);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    pub fn springs(&self) -> impl ExactSizeIterator<Item = (f64, [f64; 2])> + '_ {
        self.springs.iter().copied()
    }

    /// The force Phi: `(3/2) int (X - W(t^2)) dt` over the springs in contact.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        self.springs.iter().fold([0.0; 2], |sum, (depth, anchor)| {
            let stretch = self.shift.minus(*anchor);
            sum.plus(stretch.times(1.5 * self.touching(*depth, self.zeta)))
        })
    }

    /// The elastic energy per direction, conjugate to Phi and X: `(3/4) int (X - W(t^2))^2 dt`.
    #[must_use]
    pub fn stored_energy(&self) -> [f64; 2] {
        self.springs.iter().fold([0.0; 2], |sum, (depth, anchor)| {
            let stretch = self.shift.minus(*anchor);
            sum.plus(stretch.by_component(stretch).times(0.75 * self.touching(*depth, self.zeta)))
        })
    }

    /// The heat per direction, conjugate to Phi and X, that a straight step to a new approach and
    /// shift would dissipate: traction times slip of every spring, `(3/2) int int (X - W) dW dt`,
    /// integrated over 64 parts of the step. The state does not change; a step that would fail
    /// gives zero.
    ///
    /// Springs that leave the contact slip until they carry no traction. The balance with the work
    /// of the force and the stored energy has an error of second order in the spacing of the
    /// springs and in the parts.
    ///
    /// ```
    /// use carom_laws::sliders::SliderLaw;
    /// let mut law = SliderLaw::new(400, 1.0, 1.0)?;
    /// law.advance(1.0, [2.0, 0.0])?;
    /// // In full sliding the force is 1, and all work becomes heat.
    /// let [heat, _] = law.dissipation(1.0, [2.5, 0.0]);
    /// assert!((heat - 0.5).abs() < 1e-5);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn dissipation(&self, zeta: f64, shift: [f64; 2]) -> [f64; 2] {
        if self.check(zeta, shift).is_err() {
            return [0.0; 2];
        }
        let (from, to) = (Point { zeta: self.zeta, shift: self.shift }, Point { zeta, shift });
        self.springs.iter().fold([0.0; 2], |sum, &(depth, anchor)| {
            if depth >= from.zeta.max(zeta) {
                return sum;
            }
            let crossing = from.towards(&to, (depth - from.zeta) / (zeta - from.zeta));
            let (start, anchor) =
                if depth >= from.zeta { (crossing, crossing.shift) } else { (from, anchor) };
            let end = if depth >= zeta { crossing } else { to };
            let width = self.touching(depth, from.zeta.max(zeta));
            sum.plus(self.heat(depth, anchor, start, end).times(1.5 * width))
        })
    }

    // Traction times slip of one spring.
    fn heat(&self, depth: f64, mut anchor: [f64; 2], start: Point, end: Point) -> [f64; 2] {
        let (mut heat, mut before) = ([0.0; 2], start);
        for part in 1..=PARTS {
            let at = start.towards(&end, part as f64 / PARTS as f64);
            let slipped = before.drag(&at, (depth, anchor), self.stiffness);
            let tractions = before.shift.minus(anchor).plus(at.shift.minus(slipped));
            heat = heat.plus(tractions.by_component(slipped.minus(anchor)).times(0.5));
            (anchor, before) = (slipped, at);
        }
        heat
    }

    // The part of a spring's interval of radii that is in contact: the outermost spring represents
    // it.
    fn touching(&self, depth: f64, zeta: f64) -> f64 {
        let inner = depth.sqrt() - 0.5 * self.spacing;
        let width = (zeta.max(0.0).sqrt() - inner).clamp(0.0, self.spacing);
        if depth < zeta { width } else { 0.0 }
    }

    fn check(&self, zeta: f64, shift: [f64; 2]) -> Result<(), RangeError> {
        in_memory("zeta", zeta)?;
        in_memory("shift", shift[0])?;
        in_memory("shift", shift[1])?;
        let deepest = self.springs.len() as f64 * self.spacing;
        let holds = zeta <= deepest * deepest * (1.0 + 1e-12);
        RangeError::check("zeta", zeta, holds, "at most the depth of the deepest spring")?;
        Ok(())
    }

    /// Advances on a straight path to a new approach and shift and returns the force.
    ///
    /// # Errors
    /// [`RangeError`] for a value that is NaN or above 1e100 in magnitude, and for an approach
    /// above that of the deepest spring; the state is then unchanged.
    pub fn advance(&mut self, zeta: f64, shift: [f64; 2]) -> Result<[f64; 2], RangeError> {
        self.check(zeta, shift)?;
        let from = Point { zeta: self.zeta, shift: self.shift };
        let to = Point { zeta, shift };
        for (depth, anchor) in &mut self.springs {
            if *depth >= zeta {
                continue;
            }
            let start = if *depth >= from.zeta {
                let touch = from.towards(&to, (*depth - from.zeta) / (zeta - from.zeta));
                *anchor = touch.shift;
                touch
            } else {
                from
            };
            *anchor = start.drag(&to, (*depth, *anchor), self.stiffness);
        }
        (self.zeta, self.shift) = (zeta, shift);
        Ok(self.force())
    }
}

#[derive(Debug, Clone, Copy)]
struct Point {
    zeta: f64,
    shift: [f64; 2],
}

impl Point {
    fn towards(&self, to: &Self, part: f64) -> Self {
        let shift = self.shift.plus(to.shift.minus(self.shift).times(part));
        Self { zeta: self.zeta + part * (to.zeta - self.zeta), shift }
    }

    /// The anchor of a spring after a straight step to another point.
    fn drag(&self, to: &Self, (depth, anchor): (f64, [f64; 2]), stiffness: [f64; 2]) -> [f64; 2] {
        let stretch = to.shift.minus(anchor);
        if stretch.length() <= to.zeta - depth {
            return anchor; // never slipped
        }
        let by = to.shift.minus(self.shift);
        let step =
            SlipStep { from: self.zeta, to: to.zeta, by, stiffness, accuracy: 0.0, finest: FINEST };
        to.shift.minus(step.drag(self.shift.minus(anchor), depth))
    }
}
