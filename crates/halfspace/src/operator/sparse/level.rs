//! The points of one grid on which pressures or displacements are needed.

use super::super::pool;
use super::super::threads::Threads;
use super::stencil::{EVEN, NODES, ODD, REACH, kind};

/// Places beside the grid that are stored; even, so that places and their numbers are odd together.
pub(super) const PAD: usize = 10;
const _: () = assert!(PAD > REACH && PAD >= 2 * NODES && PAD.is_multiple_of(2));

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
            nodes.each(*at as usize, |node, _| call(node));
        }
    }

    /// Pressures on the coarser grid with the same influence far away.
    pub(super) fn gather(&self, fine: &Frame, pressures: &[f32], gathered: &mut [f32]) {
        let stride = fine.stride();
        let [over, down] = fine.shift(&self.frame);
        for (at, gathered) in self.points.iter().zip(gathered) {
            let (row, column) =
                (*at as usize / self.frame.stride(), *at as usize % self.frame.stride());
            let centre =
                (2 * (row as i32 - down)) as usize * stride + (2 * (column as i32 - over)) as usize;
            let along = |start: usize| {
                let mut sum = pressures[start];
                for (x, weight) in ODD {
                    sum += weight * pressures[start.wrapping_add_signed(x as isize)];
                }
                sum
            };
            let mut sum = along(centre);
            for (y, weight) in ODD {
                sum += weight * along(centre.wrapping_add_signed(y as isize * stride as isize));
            }
            *gathered = sum;
        }
    }

    /// Values of the points: interpolated from the coarser grid, and a product with the stencil of their kind.
    pub(super) fn values<const R: usize, const W: usize>(
        &self,
        (stencils, pressures): (&[[[f32; W]; R]; 4], &[f32]),
        (coarser, of_nodes): (&Frame, &[f32]),
        threads: Threads,
        found: &mut [f32],
    ) {
        let (stride, nodes) = (self.frame.stride(), Nodes::new(&self.frame, coarser));
        let work = |(share, found): (usize, &mut [f32])| {
            for (at, found) in self.points[share * SHARE..].iter().zip(found) {
                let at = *at as usize;
                let mut sum =
                    near(&stencils[kind(at % stride, at / stride)], pressures, at, stride);
                nodes.each(at, |node, weight| sum += weight * of_nodes[node]);
                *found = sum;
            }
        };
        shares(threads, found, work);
    }

    /// A product with one stencil for all points.
    pub(super) fn product<const R: usize, const W: usize>(
        &self,
        stencil: &[[f32; W]; R],
        values: &[f32],
        threads: Threads,
        found: &mut [f32],
    ) {
        let stride = self.frame.stride();
        let work = |(share, found): (usize, &mut [f32])| {
            for (at, found) in self.points[share * SHARE..].iter().zip(found) {
                *found = near(stencil, values, *at as usize, stride);
            }
        };
        shares(threads, found, work);
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

/// The sum over a stencil about a place. By itself it is compiled to vector instructions; within the loop over points it
/// is not always.
#[inline(never)]
fn near<const R: usize, const W: usize>(
    stencil: &[[f32; W]; R],
    values: &[f32],
    at: usize,
    stride: usize,
) -> f32 {
    let mut sums = [0.0; W];
    let mut start = at - R / 2 * stride - R / 2;
    for row in stencil {
        let values = &values[start..start + W];
        for ((sum, factor), value) in sums.iter_mut().zip(row).zip(values) {
            *sum += factor * value;
        }
        start += stride;
    }
    sums.iter().sum()
}

/// The nodes of stored places.
struct Nodes {
    stride: usize,
    coarse: usize,
    shift: [i32; 2],
}

impl Nodes {
    fn new(frame: &Frame, coarser: &Frame) -> Self {
        Self { stride: frame.stride(), coarse: coarser.stride(), shift: frame.shift(coarser) }
    }

    #[inline]
    fn each(&self, at: usize, mut call: impl FnMut(usize, f32)) {
        let (column, row) = ((at % self.stride) as i32, (at / self.stride) as i32);
        let weights = |place: i32| if place % 2 == 0 { &EVEN[..] } else { &ODD[..] };
        for (y, of_y) in weights(row) {
            let start = ((row + y) / 2 + self.shift[1]) as usize * self.coarse;
            for (x, of_x) in weights(column) {
                call(start + ((column + x) / 2 + self.shift[0]) as usize, of_x * of_y);
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
