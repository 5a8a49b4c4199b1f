//! Images of a problem that only rename bodies or axes, for tests of every floor: their answers must be the images of
//! one another. Symmetric bodies, square cells and paths along an axis hide what is swapped.

/// An image: the bodies exchanged, then the contact plane turned by a right angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Image {
    pub(crate) exchanges: bool,
    pub(crate) turns: bool,
}

impl Image {
    pub(crate) const ALL: [Self; 4] = [
        Self { exchanges: false, turns: false },
        Self { exchanges: false, turns: true },
        Self { exchanges: true, turns: false },
        Self { exchanges: true, turns: true },
    ];

    /// What belongs to body 1 and body 2.
    pub(crate) fn bodies<T>(self, [one, two]: [T; 2]) -> [T; 2] {
        if self.exchanges { [two, one] } else { [one, two] }
    }

    /// What belongs to the axes x and y without a sign: widths, counts, stiffnesses.
    #[allow(dead_code)] // not on every floor
    pub(crate) fn axes<T>(self, [x, y]: [T; 2]) -> [T; 2] {
        if self.turns { [y, x] } else { [x, y] }
    }

    /// A place in the contact plane. The normal points into body 1: exchanged bodies are seen from behind, turned by half
    /// a turn about x.
    #[allow(dead_code)]
    pub(crate) fn place(self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.turned(if self.exchanges { [x, -y] } else { [x, y] })
    }

    /// The place of which this is the image.
    #[allow(dead_code)]
    pub(crate) fn place_before(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y] = if self.turns { [y, -x] } else { [x, y] };
        if self.exchanges { [x, -y] } else { [x, y] }
    }

    /// A shift of body 2 against body 1, or a force on body 1: it is also that of the other body.
    #[allow(dead_code)]
    pub(crate) fn across(self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.turned(if self.exchanges { [-x, y] } else { [x, y] })
    }

    fn turned(self, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.turns { [-y, x] } else { [x, y] }
    }
}
