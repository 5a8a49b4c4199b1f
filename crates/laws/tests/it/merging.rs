//! The memory of chapter 7 with few vertices: quantities that merging preserves.

use carom_laws::memory::{AdhesionMemory, Fixed, Memory};

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

/// Shifted without slip right after touch: the anchors jump at a small depth. Later turns are slight. Where room
/// is short a slight turn goes, not the jump, however near it is to the vertex below.
#[test]
fn a_jump_of_the_anchors_is_kept_and_a_slight_turn_given_up() {
    let mut few = AdhesionMemory::<f64, Fixed<f64, 4>>::new();
    let edge = 0.02;
    for (zeta, shift) in
        [(edge, 0.0), (edge, 1.0), (1.0, 1.0), (1.5, 1.05), (2.0, 1.0), (2.5, 1.0), (3.0, 1.0)]
    {
        few.advance(zeta, shift).unwrap();
    }
    assert!(few.merges() > 0);
    // Below the first turn only the innermost rings are stretched, by the whole shift; the turn that was given
    // up changes little.
    let force = few.advance(0.5, 1.0).unwrap();
    let expected = 1.5 * f64::sqrt(edge);
    assert!((force - expected).abs() < 0.02 * expected, "{force} {expected}");
}
