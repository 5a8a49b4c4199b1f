//! The points of one grid on which pressures or displacements are needed.

use super::super::pool;
use super::super::threads::Threads;
use super::stencil::{GATHERED, INTERPOLATED, NODES, REACH};
use super::sums::Sums;

/// Places beside the grid that are stored: a row more than stencils reach, whose rows are longer than they reach. It is
/// even, so that places and their numbers are odd together.
pub(super) const PAD: usize = 12;
const _: () = assert!(PAD > REACH && PAD > 2 * NODES && PAD.is_multiple_of(2));

/// So many points are a share of work.
const SHARE: usize = 512;

/// The places of a grid, with a margin on all sides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// The first place of the grid along x and y, even.
    pub(super) first: [i32; 2],
    /// The numbers of places without the margin.
    pub(super) counts: [usize; 2],
    /// Whether the grid repeats itself.
    pub(super) periodic: bool,
}

impl Frame {
    /// The grid of all nodes from which places of this one are interpolated.
    pub(super) fn coarser(&self) -> Self {
        if self.periodic {
            return Self { counts: self.counts.map(|count| count / 2), ..*self };
        }
        let reach = NODES as i32;
        let first = self.first.map(|first| (first - reach).div_euclid(4) * 2);
        let axis = |axis: usize| {
            let last = self.first[axis] + self.counts[axis] as i32 - 1 + reach;
            (last.div_euclid(2) + 1 - first[axis]) as usize
        };
        Self { first, counts: [axis(0), axis(1)], periodic: false }
    }

    pub(super) const fn stride(&self) -> usize {
        self.counts[0] + 2 * PAD
    }

    pub(super) const fn stored(&self) -> usize {
        self.stride() * (self.counts[1] + 2 * PAD)
    }

    /// Where a place of the grid is stored.
    pub(super) const fn at(&self, column: usize, row: usize) -> usize {
        (row + PAD) * self.stride() + column + PAD
    }

    /// The numbers of a stored place along x and y.
    fn place(&self, at: usize) -> [i32; 2] {
        let (at, stride) = (at as u32, self.stride() as u32);
        [at % stride, at / stride].map(|number| number as i32)
    }

    /// The kind of a stored place: 1 if its number along x is odd, and 2 if that along y is.
    fn kind(&self, at: usize) -> usize {
        let [column, row] = self.place(at);
        (column % 2 + 2 * (row % 2)) as usize
    }

    /// Where the node of a stored place with even numbers is stored on the coarser grid, as the offset of columns and
    /// rows from half of its numbers.
    fn shift(&self, coarser: &Self) -> [i32; 2] {
        let pad = PAD as i32;
        [0, 1].map(|axis| (self.first[axis] - pad) / 2 - coarser.first[axis] + pad)
    }

    /// Repeats the values at the ends of a periodic grid in its margin.
    pub(super) fn repeat<T: Copy>(&self, values: &mut [T]) {
        if !self.periodic {
            return;
        }
        let ([nx, ny], stride) = (self.counts, self.stride());
        for row in values.chunks_exact_mut(stride) {
            row.copy_within(nx..nx + PAD, 0);
            row.copy_within(PAD..2 * PAD, nx + PAD);
        }
        values.copy_within(ny * stride..(ny + PAD) * stride, 0);
        values.copy_within(PAD * stride..2 * PAD * stride, (ny + PAD) * stride);
    }
}

/// The points of a grid, in the order in which they are stored.
#[derive(Debug)]
pub(super) struct Level {
    pub(super) frame: Frame,
    pub(super) points: Vec<u32>,
}

impl Level {
    /// All nodes from which the points are interpolated.
    pub(super) fn coarser(&self) -> Self {
        let frame = self.frame.coarser();
        let mut wanted = vec![false; frame.stored()];
        self.each_node(&frame, |node| wanted[node] = true);
        if frame.periodic {
            fold(&frame, &mut wanted);
        }
        let places = wanted.iter().enumerate().filter(|(_, wanted)| **wanted);
        Self { frame, points: places.map(|(at, _)| at as u32).collect() }
    }

    /// Calls with the place of each node of each point.
    fn each_node(&self, coarser: &Frame, mut call: impl FnMut(usize)) {
        let nodes = Nodes::new(&self.frame, coarser);
        for at in &self.points {
            nodes.each(*at as usize, &mut call);
        }
    }

    /// Pressures on the coarser grid with the same influence far away.
    pub(super) fn gather(&self, fine: &Frame, pressures: &[f32], gathered: &mut [f32]) {
        let [over, down] = fine.shift(&self.frame);
        let place = |at: usize| {
            let [column, row] = self.frame.place(at);
            let centre =
                (2 * (row - down)) as usize * fine.stride() + (2 * (column - over)) as usize;
            (&GATHERED, centre - NODES * (fine.stride() + 1))
        };
        gathered.fill(0.0);
        Sums { points: &self.points, values: pressures, stride: fine.stride() }
            .add(place, gathered);
    }

    /// Values of the points: interpolated from the coarser grid, and a product with the stencil of their kind.
    pub(super) fn values<const R: usize, const W: usize>(
        &self,
        (stencils, pressures): (&[[[f32; W]; R]; 4], &[f32]),
        (coarser, of_nodes): (&Frame, &[f32]),
        threads: Threads,
        found: &mut [f32],
    ) {
        let nodes = Nodes::new(&self.frame, coarser);
        shares(threads, found, |(share, found)| {
            let points = &self.points[share * SHARE..];
            found.fill(0.0);
            self.add_near(points, |at| &stencils[self.frame.kind(at)], pressures, found);
            let interpolated = Sums { points, values: of_nodes, stride: coarser.stride() };
            interpolated.add(|at| (&INTERPOLATED[self.frame.kind(at)], nodes.first(at)), found);
        });
    }

    /// A product with one stencil for all points.
    pub(super) fn product<const R: usize, const W: usize>(
        &self,
        stencil: &[[f32; W]; R],
        values: &[f32],
        threads: Threads,
        found: &mut [f32],
    ) {
        shares(threads, found, |(share, found)| {
            found.fill(0.0);
            self.add_near(&self.points[share * SHARE..], |_| stencil, values, found);
        });
    }

    /// Adds sums over stencils that are centred at the points.
    fn add_near<'s, const R: usize, const W: usize>(
        &self,
        points: &[u32],
        stencil: impl Fn(usize) -> &'s [[f32; W]; R],
        values: &[f32],
        found: &mut [f32],
    ) {
        let stride = self.frame.stride();
        let place = |at: usize| (stencil(at), at - R / 2 * (stride + 1));
        Sums { points, values, stride }.add(place, found);
    }

    /// Puts the values of the points into the array.
    pub(super) fn scatter(&self, values: &[f32], array: &mut [f32]) {
        for (at, value) in self.points.iter().zip(values) {
            array[*at as usize] = *value;
        }
        self.frame.repeat(array);
    }

    /// Makes the array zero again.
    pub(super) fn clear(&self, array: &mut [f32]) {
        for at in &self.points {
            array[*at as usize] = 0.0;
        }
        self.frame.repeat(array);
    }
}

/// Calls for the shares of the points.
fn shares(threads: Threads, found: &mut [f32], work: impl Fn((usize, &mut [f32])) + Sync + Send) {
    match threads {
        Threads::One => found.chunks_mut(SHARE).enumerate().for_each(work),
        Threads::Pool => pool::each_row(found, SHARE, work),
    }
}

/// The nodes of stored places.
struct Nodes<'a> {
    frame: &'a Frame,
    coarse: usize,
    shift: [i32; 2],
}

impl<'a> Nodes<'a> {
    fn new(frame: &'a Frame, coarser: &Frame) -> Self {
        Self { frame, coarse: coarser.stride(), shift: frame.shift(coarser) }
    }

    /// The first of the nodes about a place.
    fn first(&self, at: usize) -> usize {
        let [column, row] = self.frame.place(at);
        let [x, y] = [column, row].map(|place| (place - NODES as i32).div_euclid(2));
        (y + self.shift[1]) as usize * self.coarse + (x + self.shift[0]) as usize
    }

    /// Calls with each node that has a weight.
    fn each(&self, at: usize, mut call: impl FnMut(usize)) {
        let first = self.first(at);
        for (y, row) in INTERPOLATED[self.frame.kind(at)].iter().enumerate() {
            for (x, _) in row.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
                call(first + y * self.coarse + x);
            }
        }
    }
}

/// Moves what is wanted in the margin of a periodic grid to the places that it repeats.
fn fold(frame: &Frame, wanted: &mut [bool]) {
    let ([nx, ny], stride) = (frame.counts, frame.stride());
    for at in 0..wanted.len() {
        let inside = |place: usize, count: usize| (place + count - PAD) % count + PAD;
        let to = inside(at / stride, ny) * stride + inside(at % stride, nx);
        if to != at && wanted[at] {
            (wanted[at], wanted[to]) = (false, true);
        }
    }
}
