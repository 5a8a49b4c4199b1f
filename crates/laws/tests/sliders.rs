//! The incremental law of sliders against reference values of section 7.7 and the closed law.

use carom_laws::memory::VectorMemory;
use carom_laws::sliders::SliderLaw;

mod common;
use common::{num, tables};

#[test]
fn examples_of_chapter_7() {
    for name in ["c7_example_1", "c7_example_2", "c7_example_3", "c7_random20_const"] {
        let case = tables("histories")[name].clone();
        let f = num(&case["f"]);
        let mut law = SliderLaw::new(800, 1.0, 1.0).unwrap();
        let (mut worst, mut closed) = (0.0_f64, 0.0_f64);
        let mut memory = VectorMemory::new();
        let rows = case["history"].as_array().unwrap();
        for (step, want) in rows.iter().zip(case["oracles"]["vector_mdr_Phi"].as_array().unwrap()) {
            let x = [num(&step[1]) / f, num(&step[2]) / f];
            let got = law.advance(num(&step[0]), x).unwrap();
            let error = (got[0] - num(&want[0])).hypot(got[1] - num(&want[1]));
            worst = worst.max(error);
            let other = memory.advance(num(&step[0]), x).unwrap();
            closed = closed.max((got[0] - other[0]).hypot(got[1] - other[1]));
        }
        println!("{name}: {worst:e}, closed law off by {closed}");
        assert!(worst < 2e-4, "{name}: {worst:e}");
    }
}

#[test]
fn straight_paths_agree_with_the_closed_law_whatever_the_stiffness() {
    for ratio in [1.0, 0.6] {
        let mut law = SliderLaw::new(600, 1.5, ratio).unwrap();
        let mut memory = VectorMemory::new();
        for (zeta, x) in [(1.0, 0.0), (1.0, 0.6), (1.2, 0.1), (0.8, 0.3), (0.8, -1.5), (1.4, -1.3)]
        {
            let got = law.advance(zeta, [0.0, x]).unwrap();
            let want = memory.advance(zeta, [0.0, x]).unwrap();
            assert!((got[1] - want[1]).abs() < 2e-4, "{got:?} {want:?}");
            assert!(got[0].abs() < 1e-12);
        }
        assert_eq!(law.advance(2.0, [0.0, 0.0]).unwrap_err().field, "zeta");
    }
}

#[test]
fn ring_at_the_edge_counts_by_the_part_that_touches() {
    // Two rings of width 1/2 at the radii 1/4 and 3/4, both sticking: F = (3/2) X sqrt(zeta).
    for zeta in [0.6_f64, 0.7, 0.99, 1.0] {
        let mut law = SliderLaw::new(2, 1.0, 1.0).unwrap();
        law.advance(zeta, [0.0, 0.0]).unwrap();
        let force = law.advance(zeta, [0.03, 0.0]).unwrap();
        assert!((force[0] - 1.5 * 0.03 * zeta.sqrt()).abs() < 1e-16, "{zeta}: {force:?}");
    }
}
