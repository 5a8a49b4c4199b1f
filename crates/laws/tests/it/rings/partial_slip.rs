//! Shift of alike bodies at constant approach: Cattaneo and Mindlin, and the memory of one direction.

use super::common::{alike, law, shift};
use carom_drawn::{Congruential, Draw as _};
use carom_laws::friction::Friction;
use carom_laws::law::ContactLaw;
use carom_laws::shift_law::ShiftLaw;

/// Mean and greatest error over f F_z of the first loading up to sliding; nu = 0, where the closed form is
/// exact.
fn first_loading<const N: usize>() -> [f64; 2] {
    let hertz = alike(0.0);
    let mut law = law::<N, 8>(&hertz, 0.3, 1e-4);
    let mut exact = ShiftLaw::<f64>::new(hertz.stiffness(), Friction::new(0.3).unwrap());
    let [mut mean, mut worst] = [0.0, 0.0_f64];
    for k in 0..=100 {
        let at = shift([1.0, 0.0036 * f64::from(k), 0.0, 0.0]);
        let (got, want) = (law.advance(at).unwrap(), exact.advance(at).unwrap());
        let off = (got.f_x - want.f_x).abs() / (0.3 * want.f_z);
        (mean, worst) = (mean + off / 101.0, worst.max(off));
        assert!((got.f_z / want.f_z - 1.0).abs() < 1e-14);
    }
    [mean, worst]
}

#[test]
fn first_loading_is_cattaneos() {
    let [mean, worst] = first_loading::<6>();
    assert!(mean < 2e-3 && worst < 8e-3, "{mean} {worst}");
    let [mean, worst] = first_loading::<8>();
    assert!(mean < 1e-3 && worst < 4.3e-3, "{mean} {worst}");
    let [mean, worst] = first_loading::<16>();
    assert!(mean < 3e-4 && worst < 1.3e-3, "{mean} {worst}");
}

/// Shifts to and fro: twice the error of a first loading, as the tractions are twice as large.
fn to_and_fro<const N: usize>(steps: usize) -> [f64; 2] {
    let hertz = alike(0.0);
    let mut random = Congruential(5);
    let [mut sum, mut worst, mut count] = [0.0, 0.0_f64, 0.0];
    for _ in 0..10 {
        let mut law = law::<N, 8>(&hertz, 0.3, 1e-3);
        let mut exact = ShiftLaw::<f64>::new(hertz.stiffness(), Friction::new(0.3).unwrap());
        let mut from = 0.0;
        for _ in 0..8 {
            let to = 0.4 * random.signed();
            for k in 0..=steps {
                let xi = from + k as f64 / steps as f64 * (to - from);
                let at = shift([1.0, xi, 0.0, 0.0]);
                let (got, want) = (law.advance(at).unwrap(), exact.advance(at).unwrap());
                let off = (got.f_x - want.f_x).abs() / (0.3 * want.f_z);
                (sum, worst, count) = (sum + off, worst.max(off), count + 1.0);
            }
            from = to;
        }
    }
    [sum / count, worst]
}

#[test]
fn shifts_to_and_fro_keep_the_memory_of_one_direction() {
    let [mean, worst] = to_and_fro::<6>(12);
    assert!(mean < 4e-3 && worst < 0.02, "{mean} {worst}");
    let [mean, worst] = to_and_fro::<8>(12);
    assert!(mean < 2.5e-3 && worst < 0.014, "{mean} {worst}");
    let [mean, worst] = to_and_fro::<16>(60);
    assert!(mean < 8e-4 && worst < 5e-3, "{mean} {worst}");
}

#[test]
fn sliding_carries_friction_times_pressure() {
    let mut law = law::<6, 8>(&alike(0.3), 0.3, 1e-3);
    law.advance(shift([1.0, 0.0, 0.0, 0.0])).unwrap();
    for size in [3.0, 1e3, 1e9, 1e30] {
        let load = law.advance(shift([1.0, 0.6 * size, -0.8 * size, 0.0])).unwrap();
        let force = load.f_x.hypot(load.f_y);
        assert!((force / (0.3 * load.f_z) - 1.0).abs() < 1e-3, "{size}: {force}");
        assert!((load.f_x / force - 0.6).abs() < 0.02, "{size}");
    }
}
