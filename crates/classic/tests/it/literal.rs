//! The formulas of the thesis compared with the memory polyline on random histories of partial
//! slip.

use carom_classic::history::ellipse::EllipseHistory;
use carom_classic::history::sphere::SphereHistory;
use carom_drawn::{Draw as _, Splitmix};
use carom_laws::memory::{ScalarMemory, VectorMemory};

#[test]
fn chapter_6_is_the_polyline() {
    let mut random = Splitmix(21);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for _ in 0..3000 {
        let (mut literal, mut memory) = (SphereHistory::new(1.0), ScalarMemory::new());
        memory.advance(1.0, 0.0).unwrap();
        for _ in 0..30 {
            let size = 10_f64.powf(random.between(-2.5, -0.1));
            let x = literal_shift(memory.shift(), size * random.between(-1.0, 1.0));
            let zeta = match random.below(2) {
                0 => memory.zeta(),
                _ => (memory.zeta() + 0.6 * size * random.between(-1.0, 1.0)).clamp(0.3, 2.0),
            };
            let Some(force) = literal.advance(zeta, x) else { break };
            let want = memory.advance(zeta, x).unwrap();
            worst = worst.max((force - want).abs());
            assert!((force - want).abs() < 1e-13, "{force} {want}");
            compared += 1;
        }
    }
    println!("{compared} steps, worst {worst:e}");
    assert!(compared > 20_000);
}

fn literal_shift(x: f64, by: f64) -> f64 {
    0.8 * x + by
}

#[test]
fn chapter_7_is_the_polyline() {
    let mut random = Splitmix(22);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for _ in 0..3000 {
        let (mut literal, mut memory) = (EllipseHistory::new(1.0), VectorMemory::new());
        memory.advance(1.0, [0.0, 0.0]).unwrap();
        for _ in 0..30 {
            let size = 10_f64.powf(random.between(-1.5, -0.1));
            let angle = random.between(0.0, 6.3);
            let old = memory.shift();
            let x = [0.8 * old[0] + size * angle.cos(), 0.8 * old[1] + size * angle.sin()];
            let zeta = match random.below(2) {
                0 => memory.zeta(),
                _ => (memory.zeta() + 0.6 * size * random.between(-1.0, 1.0)).clamp(0.3, 2.0),
            };
            let Some(force) = literal.advance(zeta, x) else { break };
            let want = memory.advance(zeta, x).unwrap();
            let error = (force[0] - want[0]).hypot(force[1] - want[1]);
            worst = worst.max(error);
            // The literal form measures from afar and loses a few digits on small slips.
            assert!(error < 1e-10, "{force:?} {want:?}");
            compared += 1;
        }
    }
    println!("{compared} steps, worst {worst:e}");
    assert!(compared > 20_000);
}
