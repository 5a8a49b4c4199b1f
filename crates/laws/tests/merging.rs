//! Chapter 7's memory on few vertices: what merging keeps.

use carom_laws::memory::{Fixed, Memory};

/// Pressed and shifted in turning directions without slip, then back on the same way: all forces
/// return, but for those inside the segments that became one.
#[test]
fn the_way_back_meets_the_forces_beside_a_merged_vertex() {
    let mut few = Memory::<[f64; 2], Fixed<[f64; 2], 4>>::new();
    let mut many = Memory::<[f64; 2]>::new();
    let mut way = vec![(0.0, [0.0; 2])];
    while few.merges() == 0 {
        let i = way.len() as f64;
        let [x, y] = way[way.len() - 1].1;
        let next = (i, [x + 0.3 * (0.7 * i).cos(), y + 0.3 * (0.7 * i).sin()]);
        way.push(next);
        let (a, b) = (few.advance(next.0, next.1).unwrap(), many.advance(next.0, next.1).unwrap());
        assert!((a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-13, "{a:?} {b:?}");
        assert!(way.len() < 20);
    }
    way.pop();
    let mut off = Vec::new();
    for (zeta, shift) in way.into_iter().rev().filter(|(zeta, _)| *zeta > 0.0) {
        let (a, b) = (few.advance(zeta, shift).unwrap(), many.advance(zeta, shift).unwrap());
        off.push((a[0] - b[0]).abs() + (a[1] - b[1]).abs());
    }
    let away = off.iter().filter(|off| **off > 1e-12).count();
    assert!(away <= 1, "{off:?}");
}
