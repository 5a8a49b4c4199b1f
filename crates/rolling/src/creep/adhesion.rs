//! Tractions that make all elements adhere in steady rolling.
//!
//! Without slip the displacement of a particle changes, from one element to the next behind it, by
//! the rigid motion. So all displacements in a strip, and the one an element ahead of it, are known
//! but for a constant. The displacements due to the tractions are symmetric about both axes;
//! tractions of each symmetry are solved by themselves, each time for a quarter of the contact. The
//! constants follow from the displacement ahead, which has no element of its own.

use carom_dense::{Factors, Mat, norm, product};
use carom_special::RangeError;

use super::strips::{Gain, Strips};
use crate::RollingError;

/// A rigid motion of unit rate per distance rolled.
#[derive(Clone, Copy)]
pub(super) enum Motion {
    /// Longitudinal creepage.
    Along,
    /// Lateral creepage.
    Across,
    /// Spin.
    Spin,
}

impl Motion {
    /// Its velocity at a point, per distance rolled; also the lever of the force that works on it.
    const fn velocity(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Along => [1.0, 0.0],
            Self::Across => [0.0, 1.0],
            Self::Spin => [y, -x],
        }
    }

    /// The displacement of particles that adhere, but for a constant in each strip: minus the
    /// integral of the velocity along the strip. At most quadratic, it changes between elements by
    /// the velocity halfway between their centres.
    const fn displacement(self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Along => [-x, 0.0],
            Self::Across => [0.0, -x],
            Self::Spin => [-x * y, 0.5 * x * x],
        }
    }
}

/// Tractions along x and y on each element, strip by strip.
pub(super) type Tractions = Vec<[f64; 2]>;

/// Tractions of one symmetry: signs of t_x and t_y at the mirrored points.
#[derive(Clone, Copy)]
struct Symmetry {
    /// On the other side of the axis of rolling.
    across: [f64; 2],
    /// On the other half of the strip.
    along: [f64; 2],
}

const EVEN_ODD: [[f64; 2]; 2] = [[1.0, -1.0], [-1.0, 1.0]];

/// The tractions of one symmetry for each displacement.
struct Part {
    symmetry: Symmetry,
    /// Displacements at the centres of the quarter.
    matrix: Mat<f64>,
    /// Displacements ahead of each strip.
    ahead: Mat<f64>,
}

/// A contact whose elements all adhere.
pub(super) struct Adhesion {
    strips: Strips,
    /// Tractions with t_x even and t_y odd across the axis, and the other way round; of each those
    /// with t_x even and odd along the strips.
    parts: [[Part; 2]; 2],
}

impl Adhesion {
    /// Computes the influence of all elements.
    pub(super) fn new(strips: Strips) -> Result<Self, RangeError> {
        let part = |across: [f64; 2], along: [f64; 2]| {
            let size = strips.count() * strips.along();
            Part {
                symmetry: Symmetry { across, along },
                matrix: Mat::zeros(size, size),
                ahead: Mat::zeros(2 * strips.count(), size),
            }
        };
        let mut parts = EVEN_ODD.map(|across| EVEN_ODD.map(|along| part(across, along)));
        let ahead = (0..strips.count()).map(|strip| [strip, strips.along()]);
        let to: Vec<[usize; 2]> = strips.quarter().chain(ahead).collect();
        for from in strips.elements() {
            for to in &to {
                let gains = strips.gains(*to, from)?;
                for part in parts.iter_mut().flatten() {
                    part.add(&strips, gains, *to, from);
                }
            }
        }
        Ok(Self { strips, parts })
    }

    /// The tractions for longitudinal creepage.
    pub(super) fn along(&self) -> Result<Tractions, RollingError> {
        let [tractions] = self.tractions(&self.parts[0], [Motion::Along])?;
        Ok(tractions)
    }

    /// The tractions for lateral creepage and for spin.
    pub(super) fn across_and_spin(&self) -> Result<[Tractions; 2], RollingError> {
        self.tractions(&self.parts[1], [Motion::Across, Motion::Spin])
    }

    /// The tractions for motions of one side of the symmetry.
    fn tractions<const N: usize>(
        &self,
        parts: &[Part; 2],
        motions: [Motion; N],
    ) -> Result<[Tractions; N], RollingError> {
        let strips = &self.strips;
        let constants = 2 * strips.count();
        let solved = parts.each_ref().map(|part| part.solve(strips, &motions));
        // Columns: the motions, then a constant for each strip and component.
        let mut ahead = Mat::<f64>::zeros(constants, N + constants);
        for (part, tractions) in parts.iter().zip(&solved) {
            ahead += product(part.ahead.as_ref(), tractions.as_ref());
        }
        let system = Mat::from_fn(constants, constants, |row, column| {
            ahead[(row, N + column)] - f64::from(u8::from(row == column))
        });
        let right = Mat::from_fn(constants, N, |row, motion| {
            let point = strips.centre(row / 2, strips.along());
            motions[motion].displacement(point)[row % 2] - ahead[(row, motion)]
        });
        let found = Factors::new(&system).solve_columns(&right);
        let mut all = motions.map(|_| vec![[0.0; 2]; strips.count() * strips.along()]);
        let mut size = 0.0;
        for (part, columns) in parts.iter().zip(&solved) {
            let constant = product(columns.subcols(N, constants), found.as_ref());
            let values = columns.subcols(0, N) + constant;
            // A product leaves vector registers in a state that slows down the scalar code of the
            // next mesh threefold; a norm does not.
            size += norm(&values);
            for (motion, tractions) in all.iter_mut().enumerate() {
                for row in 0..values.nrows() {
                    part.spread(strips, row, values[(row, motion)], tractions);
                }
            }
        }
        let unknowns = 2 * strips.count() * strips.along();
        if size.is_finite() { Ok(all) } else { Err(RollingError::Singular { unknowns }) }
    }

    /// The load that works on a motion, of both sides of the axis.
    pub(super) fn load(&self, tractions: &Tractions, motion: Motion) -> f64 {
        let along = self.strips.along();
        let parts = tractions.iter().enumerate().map(|(i, [t_x, t_y])| {
            let (strip, element) = (i / along, i % along);
            let [x, y] = motion.velocity(self.strips.centre(strip, element));
            self.strips.area(strip) * (x * t_x + y * t_y)
        });
        2.0 * parts.sum::<f64>()
    }
}

impl Part {
    /// The unknown of a component of an element of a quarter: two for each, but one for an element
    /// in the middle of a strip, where the odd component vanishes.
    fn unknown(&self, strips: &Strips, [strip, element]: [usize; 2], of: usize) -> Option<usize> {
        let along = strips.along();
        let middle = 2 * element + 1 == along;
        let first = strip * along + 2 * element;
        let vanishes = middle && self.symmetry.along[of] < 0.0;
        (!vanishes).then_some(if middle { first } else { first + of })
    }

    /// Adds the displacement of one point due to one element.
    fn add(&mut self, strips: &Strips, gains: [Gain; 2], to: [usize; 2], from: [usize; 2]) {
        let Symmetry { across, along } = self.symmetry;
        let last = strips.along() - 1;
        let mirrored = from[1] > last - from[1];
        let source = [from[0], from[1].min(last - from[1])];
        for by in 0..2 {
            let Some(column) = self.unknown(strips, source, by) else { continue };
            let sign = if mirrored { along[by] } else { 1.0 };
            for (of, (own, image)) in gains[0].iter().zip(&gains[1]).enumerate() {
                let gain = sign * (own[by] + across[by] * image[by]);
                if to[1] > last {
                    self.ahead[(2 * to[0] + of, column)] += gain;
                } else if let Some(row) = self.unknown(strips, to, of) {
                    self.matrix[(row, column)] += gain;
                }
            }
        }
    }

    /// The tractions for the displacements of motions, and for a constant one of each component in
    /// each strip; of these displacements the part that has the symmetry.
    fn solve(&self, strips: &Strips, motions: &[Motion]) -> Mat<f64> {
        let along = strips.along();
        let columns = motions.len() + 2 * strips.count();
        let mut right = Mat::<f64>::zeros(self.matrix.nrows(), columns);
        for [strip, element] in strips.quarter() {
            let points = [element, along - 1 - element].map(|place| strips.centre(strip, place));
            for of in 0..2 {
                let Some(row) = self.unknown(strips, [strip, element], of) else { continue };
                let sign = self.symmetry.along[of];
                for (column, motion) in motions.iter().enumerate() {
                    let [own, image] = points.map(|point| motion.displacement(point)[of]);
                    right[(row, column)] = 0.5 * (own + sign * image);
                }
                if sign > 0.0 {
                    right[(row, motions.len() + 2 * strip + of)] = 1.0;
                }
            }
        }
        Factors::new(&self.matrix).solve_columns(&right)
    }

    /// Adds the traction of an unknown to the elements that have it.
    fn spread(&self, strips: &Strips, row: usize, value: f64, tractions: &mut Tractions) {
        let along = strips.along();
        let (strip, place) = (row / along, row % along);
        let element = place / 2;
        let image = along - 1 - element;
        let even = usize::from(self.symmetry.along[1] > 0.0);
        let of = if element == image { even } else { place % 2 };
        tractions[strip * along + element][of] += value;
        if element != image {
            tractions[strip * along + image][of] += self.symmetry.along[of] * value;
        }
    }
}
