//! The elements of an elliptic contact in strips along the direction of rolling.

use carom_halfspace::{MaterialPair, Offset, Rectangle, RectangleInfluence};
use carom_special::RangeError;

/// The strips on one side of the axis of rolling; those on the other follow by symmetry.
pub(super) struct Strips {
    strips: Vec<Strip>,
    /// Number of elements in each.
    along: usize,
    height: f64,
}

/// A strip: elements of one width between the edges of the ellipse.
struct Strip {
    y: f64,
    width: f64,
    influence: RectangleInfluence,
}

/// Tangential displacements due to tractions along x and y.
pub(super) type Gain = [[f64; 2]; 2];

impl Strips {
    /// The strips of an ellipse with these semi-axes.
    pub(super) fn new(
        [strips, along]: [usize; 2],
        [a, b]: [f64; 2],
        pair: MaterialPair,
    ) -> Result<Self, RangeError> {
        let height = 2.0 * b / strips as f64;
        let strip = |row: usize| -> Result<Strip, RangeError> {
            let y = (row as f64 + 0.5) * height;
            let width = 2.0 * a * (1.0 - (y / b) * (y / b)).sqrt() / along as f64;
            let influence = RectangleInfluence::new(pair, Rectangle::new(width, height)?);
            Ok(Strip { y, width, influence })
        };
        let strips: Result<Vec<Strip>, RangeError> = (0..strips / 2).map(strip).collect();
        Ok(Self { strips: strips?, along, height })
    }

    /// Number of strips.
    pub(super) fn count(&self) -> usize {
        self.strips.len()
    }

    /// Number of elements in each.
    pub(super) const fn along(&self) -> usize {
        self.along
    }

    /// All elements: strip and place in it.
    pub(super) fn elements(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        places(self.count(), self.along)
    }

    /// The elements on one half of each strip, those in the middle included.
    pub(super) fn quarter(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        places(self.count(), self.along.div_ceil(2))
    }

    /// The centre of an element of a strip; the element after the last one lies ahead of the
    /// contact.
    pub(super) fn centre(&self, strip: usize, element: usize) -> [f64; 2] {
        let Strip { y, width, .. } = self.strips[strip];
        // Exactly symmetric.
        [(element as f64 - 0.5 * (self.along as f64 - 1.0)) * width, y]
    }

    /// The area of each element of a strip.
    pub(super) fn area(&self, strip: usize) -> f64 {
        self.strips[strip].width * self.height
    }

    /// The displacement at the centre of an element of a strip due to another element, and due to
    /// its image on the other side of the axis.
    pub(super) fn gains(&self, to: [usize; 2], from: [usize; 2]) -> Result<[Gain; 2], RangeError> {
        let ([x, y], [source_x, source_y]) =
            (self.centre(to[0], to[1]), self.centre(from[0], from[1]));
        let gain = |source_y: f64| -> Result<Gain, RangeError> {
            let offset = Offset { x: source_x - x, y: source_y - y };
            let rows = self.strips[from[0]].influence.coefficients(offset)?.rows;
            Ok([0, 1].map(|of| [rows[of][0], rows[of][1]]))
        };
        Ok([gain(source_y)?, gain(-source_y)?])
    }
}

fn places(strips: usize, count: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..strips).flat_map(move |strip| (0..count).map(move |element| [strip, element]))
}
