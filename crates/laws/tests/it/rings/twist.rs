//! Twist about the normal: Lubkin's solution and its memory.

use super::common::{alike, law, shift};
use carom_drawn::{Congruential, Draw as _};
use carom_laws::friction::Friction;
use carom_laws::law::ContactLaw;
use carom_laws::torsion::law::TorsionLaw;

fn against_lubkin<const N: usize>() -> [f64; 2] {
    let hertz = alike(0.3);
    let friction = Friction::new(0.3).unwrap();
    let mut random = Congruential(7);
    let mut law = law::<N, 8>(&hertz, 0.3, 1e-3);
    let mut exact = TorsionLaw::new(&hertz, friction).unwrap();
    let [mut sum, mut worst] = [0.0, 0.0_f64];
    let mut from = 0.0;
    for leg in 0..=20 {
        let to = if leg == 0 { 0.0 } else { 0.8 * random.signed() };
        for k in 1..=20 {
            let at = shift([1.0, 0.0, 0.0, from + f64::from(k) / 20.0 * (to - from)]);
            let (got, want) = (law.advance(at).unwrap(), exact.advance(at).unwrap());
            let off = (got.m_z - want.m_z).abs() / (0.3 * want.f_z);
            (sum, worst) = (sum + off / 420.0, worst.max(off));
            assert!(got.f_x.hypot(got.f_y) < 1e-12, "a twist alone does not push");
        }
        from = to;
    }
    [sum, worst]
}

#[test]
fn twists_to_and_fro_keep_lubkins_memory() {
    // Over f F_z a.
    let [mean, worst] = against_lubkin::<6>();
    assert!(mean < 4.5e-3 && worst < 0.022, "{mean} {worst}");
    let [mean, worst] = against_lubkin::<8>();
    assert!(mean < 3.2e-3 && worst < 0.013, "{mean} {worst}");
    let [mean, worst] = against_lubkin::<16>();
    assert!(mean < 8e-4 && worst < 4e-3, "{mean} {worst}");
}

#[test]
fn pressed_while_twisted_without_slip_the_torque_is_two_fifths_of_that_after_pressing() {
    // The approach goes straight: int (16/3) G z^(3/2) dz = (2/5) of the end's.
    for (steps, within) in [(1, 1e-3), (10, 5e-3), (100, 4e-3)] {
        let mut law = law::<8, 8>(&alike(0.3), f64::INFINITY, 1e-4);
        for k in 1..=steps {
            let part = f64::from(k) / f64::from(steps);
            law.advance(shift([part, 0.0, 0.0, 1e-2 * part])).unwrap();
        }
        let off = law.load().m_z / (0.4 * 16.0 / 3.0 * 1e-2) - 1.0;
        assert!(off.abs() < within, "{steps} steps: {off}");
    }
}
