//! A rough surface on a grid with unequal sides and cells: its waves and their amplitudes.

use std::f64::consts::TAU;

use carom_halfspace::Grid;
use carom_solver::SelfAffine;

/// Each wave of the grid between the two wavelengths has the amplitude q^-(1 + H) up to a common
/// factor, all others are zero; the squares add up to the required mean square.
#[test]
fn waves_of_an_oblong_grid_follow_their_length_alone() {
    let grid = Grid::new(18, 28, 0.5, 0.25).unwrap();
    let [side_x, side_y] = [9.0, 7.0];
    let surface = SelfAffine { hurst: 0.6, rms: 0.3, longest: 5.0, shortest: 1.4, seed: 5 };
    let heights = surface.heights(grid).unwrap();
    let (mut factors, mut power): (Vec<f64>, f64) = (Vec::new(), 0.0);
    for k in 0..=8 {
        for l in -13..=13 {
            if k == 0 && l <= 0 {
                continue;
            }
            let [q_x, q_y] = [f64::from(k) / side_x, f64::from(l) / side_y];
            let (mut sine, mut cosine) = (0.0, 0.0);
            for ((x, y), z) in grid.centres().zip(heights.values()) {
                let angle = TAU * (q_x * x + q_y * y);
                sine += z * angle.sin();
                cosine += z * angle.cos();
            }
            let amplitude = 2.0 * f64::hypot(sine, cosine) / grid.cells() as f64;
            let q = f64::hypot(q_x, q_y);
            if q * 5.0 < 1.0 - 1e-9 || q * 1.4 > 1.0 + 1e-9 {
                assert!(amplitude < 1e-14, "{k} {l}: {amplitude}");
            } else {
                factors.push(amplitude * q.powf(1.6));
                power += 0.5 * amplitude * amplitude;
            }
        }
    }
    assert!(factors.len() > 40, "{}", factors.len());
    for factor in &factors {
        assert!((factor / factors[0] - 1.0).abs() < 1e-11, "{factors:?}");
    }
    assert!((power.sqrt() / 0.3 - 1.0).abs() < 1e-12);
    let square: f64 = heights.values().iter().map(|z| z * z).sum();
    assert!(((square / grid.cells() as f64).sqrt() / 0.3 - 1.0).abs() < 1e-12);
}

/// The shortest wave is two of the longer sides of a cell, whichever axis that is.
#[test]
fn waves_shorter_than_two_cells_are_refused_along_either_axis() {
    for [dx, dy] in [[0.5, 0.25], [0.25, 0.5]] {
        let grid = Grid::new(24, 24, dx, dy).unwrap();
        let surface =
            |shortest: f64| SelfAffine { hurst: 0.6, rms: 0.3, longest: 5.0, shortest, seed: 5 };
        assert!(surface(1.0).heights(grid).is_ok());
        let error = surface(0.9).heights(grid).unwrap_err();
        assert!(error.field == "shortest" && error.value == 0.9, "{error}");
    }
}
