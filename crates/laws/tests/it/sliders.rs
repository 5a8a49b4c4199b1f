//! The law of sliders compared with reference values of section 7.7 and with the law of chapter 7.

use carom_laws::memory::{Memory, VectorMemory};
use carom_laws::sliders::SliderLaw;

use crate::common::{num, tables};

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

const LOOP: [(f64, [f64; 2]); 8] = [
    (1.0, [0.1, 0.0]),
    (1.2, [0.7, 0.3]),
    (1.2, [-0.4, 0.5]),
    (0.7, [-0.5, -0.2]),
    (0.9, [-0.5, -0.1]),
    (0.5, [0.3, -0.4]),
    (1.4, [0.2, 0.9]),
    (0.3, [0.0, 0.0]),
];

/// Work by the trapezoidal rule over the loads of small steps, heat from traction times slip.
fn balance(count: usize, ratio: f64) -> ([f64; 2], [f64; 2]) {
    let mut law = SliderLaw::new(count, 1.5, ratio).unwrap();
    let (mut work, mut heat) = ([0.0; 2], [0.0; 2]);
    let mut last = (0.0, [0.0; 2]);
    for (zeta, x) in LOOP {
        for part in 1..=40 {
            let mix = |a: f64, b: f64| a + f64::from(part) / 40.0 * (b - a);
            let to = (mix(last.0, zeta), [mix(last.1[0], x[0]), mix(last.1[1], x[1])]);
            let (before, from) = (law.force(), law.shift());
            let lost = law.dissipation(to.0, to.1);
            let after = law.advance(to.0, to.1).unwrap();
            for k in 0..2 {
                assert!(lost[0] + lost[1] > -1e-15);
                heat[k] += lost[k];
                work[k] += 0.5 * (before[k] + after[k]) * (to.1[k] - from[k]);
            }
        }
        last = (zeta, x);
    }
    let stored = law.stored_energy();
    ([0, 1].map(|k| work[k] - stored[k] - heat[k]), heat)
}

#[test]
fn work_is_stored_or_turned_into_heat() {
    for ratio in [1.0, 1.6] {
        let (off, heat) = balance(300, ratio);
        println!("{ratio}: {off:?} of {heat:?}");
        for k in 0..2 {
            assert!(heat[k] > 0.1 && off[k].abs() < 1e-3 * heat[k], "{ratio} {off:?} {heat:?}");
        }
    }
}

/// On a straight path the closed law stores and loses the same, step by step.
#[test]
fn energies_on_a_straight_path_are_those_of_the_closed_law() {
    let mut law = SliderLaw::new(1500, 1.5, 1.0).unwrap();
    let mut memory = Memory::<f64>::new();
    for (zeta, x) in [(1.0, 0.0), (1.0, 0.6), (1.2, 0.1), (0.8, 0.3), (0.8, -1.5), (1.4, -1.3)] {
        let heat = law.dissipation(zeta, [x, 0.0]);
        let want = memory.dissipation(zeta, x);
        assert!((heat[0] - want).abs() < 2e-4 && heat[1] == 0.0, "{zeta} {x}: {heat:?} {want}");
        law.advance(zeta, [x, 0.0]).unwrap();
        memory.advance(zeta, x).unwrap();
        let (own, want) = (law.stored_energy(), memory.stored_energy());
        assert!((own[0] - want).abs() < 2e-4, "{zeta} {x}: {own:?} {want}");
    }
    assert_eq!(law.dissipation(9.0, [0.0; 2]), [0.0; 2]);
}

/// Slip along the traction in the physical plane, in small implicit steps: the stretch u on its
/// circle with `trial - u ~ (c_x u_x, c_y u_y)`.
fn slip_in_small_steps(
    path: &[(f64, [f64; 2])],
    depth: f64,
    c: [f64; 2],
    parts: usize,
) -> [f64; 2] {
    let (mut u, mut last) = ([0.0_f64; 2], (0.0, [0.0; 2]));
    for &(zeta, x) in path {
        for part in 1..=parts {
            let t = part as f64 / parts as f64;
            let at = |a: f64, b: f64| a + t * (b - a);
            let now = (at(last.0, zeta), [at(last.1[0], x[0]), at(last.1[1], x[1])]);
            let limit = now.0 - depth;
            if limit <= 0.0 {
                u = [0.0; 2];
                continue;
            }
            // A ring that touches on the way begins there.
            let share = (limit * parts as f64 / (zeta - last.0)).abs();
            let share = if zeta > last.0 && depth >= last.0 { share.min(1.0) } else { 1.0 };
            let step = [0, 1].map(|k| share * (x[k] - last.1[k]) / parts as f64);
            let trial = [u[0] + step[0], u[1] + step[1]];
            let at = |slip: f64| [0, 1].map(|k| trial[k] / (1.0 + slip * c[k]));
            u = trial;
            if trial[0].hypot(trial[1]) > limit {
                let (mut low, mut high) = (0.0, 1e6);
                for _ in 0..80 {
                    let middle = 0.5 * (low + high);
                    let [x, y] = at(middle);
                    if x.hypot(y) > limit { low = middle } else { high = middle }
                }
                u = at(high);
            }
        }
        last = (zeta, x);
    }
    u
}

#[test]
fn rings_slip_along_their_traction_in_the_physical_plane() {
    for ratio in [0.5, 0.8, 1.0, 1.7] {
        let mut law = SliderLaw::new(12, 1.5, ratio).unwrap();
        for &(zeta, x) in &LOOP {
            law.advance(zeta, x).unwrap();
        }
        let (zeta, x) = LOOP[LOOP.len() - 1];
        for (depth, anchor) in law.springs().filter(|(depth, _)| *depth < zeta) {
            let small = |parts| slip_in_small_steps(&LOOP, depth, [ratio, 1.0], parts);
            let (coarse, fine) = (small(2000), small(4000));
            // First order in the step.
            let want = [0, 1].map(|k| 2.0 * fine[k] - coarse[k]);
            let off = (x[0] - anchor[0] - want[0]).hypot(x[1] - anchor[1] - want[1]);
            let own = (fine[0] - coarse[0]).hypot(fine[1] - coarse[1]);
            assert!(off < 1e-6 + 0.2 * own, "{ratio} {depth}: {off:e}, steps {own:e}");
        }
    }
}
