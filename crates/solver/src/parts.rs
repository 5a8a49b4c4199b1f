//! Work on the cells of fields in parts, on one thread or on several, to the same bits.
//!
//! Fields are halved until a part is small. Where they are halved depends on the number of cells
//! alone, and the results of two halves are joined in their order, so that sums do not depend on
//! the number of threads.

use std::ops::Range;

use carom_halfspace::operator::Threads;
use carom_special::interrupt;

use crate::awake::while_awake;

/// A part of at most this many cells is not halved.
const CELLS: usize = 8192;

/// Fields of the same number of cells that are split at the same cell.
pub(crate) trait Parts: Sized + Send {
    fn cells(&self) -> usize;

    /// The cells before `at`, and the others.
    fn split(self, at: usize) -> (Self, Self);
}

/// The numbers of cells.
impl Parts for Range<usize> {
    fn cells(&self) -> usize {
        self.len()
    }

    fn split(self, at: usize) -> (Self, Self) {
        let middle = self.start + at;
        (self.start..middle, middle..self.end)
    }
}

impl<T: Sync> Parts for &[T] {
    fn cells(&self) -> usize {
        self.len()
    }

    fn split(self, at: usize) -> (Self, Self) {
        self.split_at(at)
    }
}

impl<T: Send> Parts for &mut [T] {
    fn cells(&self) -> usize {
        self.len()
    }

    fn split(self, at: usize) -> (Self, Self) {
        self.split_at_mut(at)
    }
}

/// The two components of a field.
impl<P: Parts> Parts for [P; 2] {
    fn cells(&self) -> usize {
        self[0].cells()
    }

    fn split(self, at: usize) -> (Self, Self) {
        let [x, y] = self;
        let ((x, x_after), (y, y_after)) = (x.split(at), y.split(at));
        ([x, y], [x_after, y_after])
    }
}

impl<A: Parts, B: Parts> Parts for (A, B) {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn split(self, at: usize) -> (Self, Self) {
        let ((a, a_after), (b, b_after)) = (self.0.split(at), self.1.split(at));
        ((a, b), (a_after, b_after))
    }
}

impl<A: Parts, B: Parts, C: Parts> Parts for (A, B, C) {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn split(self, at: usize) -> (Self, Self) {
        let (((a, b), c), ((a_after, b_after), c_after)) = ((self.0, self.1), self.2).split(at);
        ((a, b, c), (a_after, b_after, c_after))
    }
}

impl<A: Parts, B: Parts, C: Parts, D: Parts> Parts for (A, B, C, D) {
    fn cells(&self) -> usize {
        self.0.cells()
    }

    fn split(self, at: usize) -> (Self, Self) {
        let (((a, b), (c, d)), ((a_after, b_after), (c_after, d_after))) =
            ((self.0, self.1), (self.2, self.3)).split(at);
        ((a, b, c, d), (a_after, b_after, c_after, d_after))
    }
}

/// Works on all parts, and joins their results.
pub(crate) fn fold<P: Parts, R: Send>(
    threads: Threads,
    parts: P,
    work: &(impl Fn(P) -> R + Sync),
    join: &(impl Fn(R, R) -> R + Sync),
) -> R {
    let cells = parts.cells();
    if cells <= CELLS {
        return work(parts);
    }
    let (before, after) = parts.split(cells / 2);
    let (before, after) = match threads {
        Threads::One => (fold(threads, before, work, join), fold(threads, after, work, join)),
        Threads::Pool => {
            rayon::join(|| fold(threads, before, work, join), || fold(threads, after, work, join))
        }
    };
    join(before, after)
}

/// Does all of a solution on so many cells within the pool, whose workers stay awake, so that none needs to be woken
/// for each part.
pub(crate) fn within<R: Send>(
    (threads, cells): (Threads, usize),
    work: impl FnOnce() -> R + Send,
) -> R {
    match threads {
        Threads::One => work(),
        Threads::Pool => {
            let ask = interrupt::asked();
            rayon::join(|| interrupt::under(ask, || while_awake(cells / CELLS, work)), || ()).0
        }
    }
}

/// Does two things, on two threads if there are several.
pub(crate) fn together<A: Send, B: Send>(
    threads: Threads,
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) {
    match threads {
        Threads::One => {
            one();
            other();
        }
        Threads::Pool => {
            rayon::join(one, other);
        }
    }
}

/// Works on all parts.
pub(crate) fn each<P: Parts>(threads: Threads, parts: P, work: &(impl Fn(P) + Sync)) {
    fold(threads, parts, work, &|(), ()| ());
}

/// The sum of the results of all parts.
pub(crate) fn sum<P: Parts>(threads: Threads, parts: P, work: &(impl Fn(P) -> f64 + Sync)) -> f64 {
    fold(threads, parts, work, &|before, after| before + after)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(count: usize) -> Vec<f64> {
        (0..count).map(|i| (1.3 * i as f64).sin()).collect()
    }

    #[test]
    fn sums_have_the_same_bits_on_one_thread_and_on_several() {
        for count in [0, 1, CELLS, CELLS + 1, 5 * CELLS + 17, 64 * CELLS] {
            let (a, b) = (values(count), values(count + 1));
            let product = |(a, b): (&[f64], &[f64])| a.iter().zip(b).map(|(a, b)| a * b).sum();
            let on = |threads| sum(threads, (&a[..], &b[1..]), &product);
            let one = on(Threads::One);
            for threads in [1, 2, 3, 5] {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                assert_eq!(pool.install(|| on(Threads::Pool)).to_bits(), one.to_bits());
            }
            let exact: f64 = a.iter().zip(&b[1..]).map(|(a, b)| a * b).sum();
            assert!((one - exact).abs() <= 1e-12 * count as f64, "{one} {exact}");
        }
    }

    #[test]
    fn every_cell_is_reached_once_with_its_neighbours_in_all_fields() {
        let count = 3 * CELLS + 5;
        let (given, mut x, mut y, mut calls) =
            (values(count), vec![0.0; count], vec![1.0; count], vec![0; count]);
        let fields = (&given[..], [&mut x[..], &mut y[..]], &mut calls[..]);
        each(Threads::Pool, fields, &|(given, [x, y], calls)| {
            for (((given, x), y), calls) in given.iter().zip(x).zip(y).zip(calls) {
                *x = 2.0 * given;
                *y += *x;
                *calls += 1;
            }
        });
        for (i, given) in given.iter().enumerate() {
            assert_eq!((x[i], y[i], calls[i]), (2.0 * given, 1.0 + 2.0 * given, 1));
        }
    }

    #[test]
    fn results_are_joined_in_order() {
        let cells: Vec<usize> = (0..4 * CELLS + 3).collect();
        let ends = |part: &[usize]| vec![[part[0], part[part.len() - 1]]];
        let join = |mut before: Vec<[usize; 2]>, after: Vec<[usize; 2]>| {
            before.extend(after);
            before
        };
        let all = fold(Threads::Pool, &cells[..], &ends, &join);
        assert!(all.windows(2).all(|pair| pair[0][1] + 1 == pair[1][0]));
        assert_eq!((all[0][0], all[all.len() - 1][1]), (0, 4 * CELLS + 2));
    }
}
