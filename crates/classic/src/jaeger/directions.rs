//! Directions of the stress in the slip area, and the random numbers of the slip algorithm.

/// Unit vectors of the stress in the slip area, and the random numbers that divide it into blocks.
#[derive(Debug, Clone)]
pub(super) struct Directions {
    units: Vec<[f64; 2]>,
    /// Elements that left the contact in this step while slipping.
    left_slipping: Vec<bool>,
    random: u64,
}

impl Directions {
    pub(super) fn new(cells: usize) -> Self {
        Self { units: vec![[1.0, 0.0]; cells], left_slipping: vec![false; cells], random: 1 }
    }

    /// From the stresses of the last step; the random numbers are the same in every step.
    pub(super) fn start(&mut self, direction: impl Fn(usize) -> [f64; 2]) {
        self.random = 1;
        self.left_slipping.fill(false);
        for (cell, unit) in self.units.iter_mut().enumerate() {
            *unit = direction(cell);
        }
    }

    pub(super) fn of(&self, cell: usize) -> [f64; 2] {
        self.units[cell]
    }

    pub(super) fn set(&mut self, cell: usize, unit: [f64; 2]) {
        self.units[cell] = unit;
    }

    /// Records that an element leaves the contact.
    pub(super) fn leave(&mut self, cell: usize, slips: bool) {
        self.left_slipping[cell] = slips;
    }

    pub(super) fn left_slipping(&self, cell: usize) -> bool {
        self.left_slipping[cell]
    }

    /// A number from 1 to `most` (Knuth's linear congruential generator).
    pub(super) fn one_of(&mut self, most: usize) -> usize {
        let next = self.random.wrapping_mul(6_364_136_223_846_793_005);
        self.random = next.wrapping_add(1_442_695_040_888_963_407);
        1 + ((self.random >> 33) % most as u64) as usize
    }
}
