//! Invariants of the memory law on random histories, and an independent oracle of springs.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::memory::{Fixed, Growing, Lateral, Memory, Nodes as _, ScalarMemory, VectorMemory};
use carom_laws::profile::{Hertzian, NormalProfile, PowerLaw, RoundedFlat};

use crate::common::next;

/// A million steps where code is optimised.
const STEPS: usize = if cfg!(debug_assertions) { 100_000 } else { 1_000_000 };

/// Springs that touch one after the other, each with its own slider: the exact law in one
/// direction, without any stack.
struct Springs {
    zeta: f64,
    x: f64,
    depths: Vec<f64>,
    anchors: Vec<f64>,
}

impl Springs {
    fn new(n: usize, deepest: f64) -> Self {
        let depths = (0..n).map(|i| (i as f64 + 0.5) / n as f64 * deepest).collect();
        Self { zeta: 0.0, x: 0.0, depths, anchors: vec![0.0; n] }
    }

    fn advance(&mut self, zeta: f64, x: f64) {
        for (depth, anchor) in self.depths.iter().zip(&mut self.anchors) {
            if *depth >= zeta {
                continue;
            }
            if *depth >= self.zeta {
                *anchor = self.x + (x - self.x) * (depth - self.zeta) / (zeta - self.zeta);
            }
            let limit = zeta - depth;
            *anchor = anchor.clamp(x - limit, x + limit);
        }
        (self.zeta, self.x) = (zeta, x);
    }
}

fn length<V: Lateral>(v: V) -> f64 {
    v.length()
}

#[test]
fn anchors_are_those_of_single_springs() {
    let mut random = Splitmix(1);
    let (mut memory, mut springs) = (ScalarMemory::new(), Springs::new(40, 2.0));
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    for _ in 0..STEPS / 10 {
        (zeta, x) = next(&mut random, zeta, x);
        memory.advance(zeta, x[0]).unwrap();
        springs.advance(zeta, x[0]);
        for (depth, anchor) in springs.depths.iter().zip(&springs.anchors) {
            if *depth < zeta {
                let error = (memory.anchor(*depth) - anchor).abs();
                assert!(error < 3e-14, "{error:e} at {depth} of {zeta}");
            }
        }
    }
}

#[test]
fn knife_edges_on_a_grid_are_no_trap() {
    // Steps of tenths meet closed loops, equal rings and edges exactly or by round-off.
    let mut random = Splitmix(11);
    let (mut memory, mut springs) = (ScalarMemory::new(), Springs::new(40, 2.0));
    let mut vector = VectorMemory::new();
    for _ in 0..STEPS {
        let zeta = random.below(20) as f64 * 0.1;
        let x = random.below(15) as f64 * 0.1 - 0.7;
        let force = memory.advance(zeta, x).unwrap();
        let pair = vector.advance(zeta, [0.0, x]).unwrap();
        springs.advance(zeta, x);
        assert!((pair[1] - force).abs() < 1e-14 && pair[0].abs() < 1e-14);
        for (depth, anchor) in springs.depths.iter().zip(&springs.anchors) {
            if *depth < zeta {
                assert!((memory.anchor(*depth) - anchor).abs() < 1e-14);
            }
        }
    }
}

/// The force of the springs for any profile: slopes of the anchor between fine springs.
fn profile_oracle<P: NormalProfile>(profile: P) {
    let n = 4000;
    let mut random = Splitmix(5);
    let (mut memory, mut springs) =
        (Memory::<f64, Growing<f64>, P>::with_profile(profile), Springs::new(n, 2.0));
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    for _ in 0..200 {
        (zeta, x) = next(&mut random, zeta, x);
        memory.advance(zeta, x[0]).unwrap();
        springs.advance(zeta, x[0]);
        if zeta < 0.2 {
            continue;
        }
        // Each spring carries F'' ds times its stretch, those of the flat end at depth zero.
        let h = 2.0 / n as f64;
        let mut force = profile.stiffness(0.0) * (x[0] - memory.anchor(0.0));
        for (depth, anchor) in springs.depths.iter().zip(&springs.anchors) {
            if *depth < zeta {
                let to = (depth + 0.5 * h).min(zeta);
                let weight = profile.stiffness(to) - profile.stiffness(depth - 0.5 * h);
                force += weight * (x[0] - anchor);
            }
        }
        let error = (force - memory.force()).abs();
        assert!(error < 2e-4 * profile.force(zeta), "{error:e} at {zeta}");
    }
}

#[test]
fn any_axisymmetric_profile() {
    profile_oracle(Hertzian);
    profile_oracle(PowerLaw::CONE);
    profile_oracle(PowerLaw::of_shape(4.0).unwrap());
    profile_oracle(RoundedFlat::new(0.6).unwrap());
}

fn bounds<V: Lateral>(steps: usize) {
    let mut random = Splitmix(2);
    let mut memory = Memory::<V>::new();
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    for step in 0..steps {
        (zeta, x) = next(&mut random, zeta, x);
        let to = V::from_components(x);
        let heat = memory.dissipation(zeta, to).components();
        assert!(heat[0] + heat[1] >= 0.0, "heat {heat:?}");
        memory.advance(zeta, to).unwrap();
        let limit = memory.normal_force() * (1.0 + 1e-14);
        assert!(length(memory.force()) <= limit);
        if step % 7 == 0 && zeta > 0.0 {
            for q in [0.0_f64, 0.3, 0.7, 0.95, 0.999] {
                let bound = (1.0 - q).sqrt() * (1.0 + 1e-12);
                assert!(length(memory.traction(q)) <= bound, "at {q}");
            }
            let mut last = 0.0;
            for segment in memory.segments() {
                assert!(length(segment.slope) <= 1.0 + 4e-16);
                assert!(segment.from == last && segment.to > segment.from);
                last = segment.to;
            }
            assert_eq!(last, zeta);
        }
    }
}

#[test]
fn friction_bounds_force_traction_and_slopes_and_heat_is_positive() {
    bounds::<f64>(STEPS / 10);
    bounds::<[f64; 2]>(STEPS / 10);
}

#[test]
#[ignore = "takes half a minute"]
fn friction_bounds_force_traction_and_slopes_over_a_million_steps() {
    bounds::<f64>(STEPS);
    bounds::<[f64; 2]>(STEPS);
}

fn subdivision<V: Lateral>(tolerance: f64) {
    let mut random = Splitmix(3);
    let (mut whole, mut parts) = (Memory::<V>::new(), Memory::<V>::new());
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    let mut worst = 0.0_f64;
    for _ in 0..STEPS / 20 {
        let (zeta_0, x_0) = (zeta, x);
        (zeta, x) = next(&mut random, zeta, x);
        whole.advance(zeta, V::from_components(x)).unwrap();
        let n = 1 + random.below(12);
        for i in 1..n {
            let t = i as f64 / n as f64;
            let part = [0, 1].map(|k| x_0[k] + t * (x[k] - x_0[k]));
            parts.advance(zeta_0 + t * (zeta - zeta_0), V::from_components(part)).unwrap();
        }
        parts.advance(zeta, V::from_components(x)).unwrap();
        let error = length(whole.force().minus(parts.force()));
        worst = worst.max(error / zeta.max(1e-3).powf(1.5));
        // Where a subdivision meets a vertex by round-off the two may differ in form, not in force.
        assert!(error <= tolerance * zeta.max(1e-3).powf(1.5), "{error:e} at {zeta}");
    }
    println!("subdivision, {} direction(s): {worst:e}", V::DIMENSION);
}

#[test]
fn one_step_is_any_number_of_its_parts() {
    subdivision::<f64>(1e-12);
    subdivision::<[f64; 2]>(1e-11);
}

#[test]
fn symmetries() {
    let mut random = Splitmix(4);
    let mut base = VectorMemory::new();
    let (mut mirrored, mut turned, mut moved) = (base.clone(), base.clone(), base.clone());
    let mut scaled = base.clone();
    let (s, c) = 1.1_f64.sin_cos();
    let turn = |x: [f64; 2]| [c * x[0] - s * x[1], s * x[0] + c * x[1]];
    let by = [0.25, -0.5];
    moved.translate(by);
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    for _ in 0..STEPS / 20 {
        (zeta, x) = next(&mut random, zeta, x);
        let force = base.advance(zeta, x).unwrap();
        let scale = zeta.max(1e-3).powf(1.5);
        let near = |got: [f64; 2], want: [f64; 2]| {
            assert!(length(got.minus(want)) < 1e-11 * scale, "{got:?} {want:?}");
        };
        near(mirrored.advance(zeta, [x[0], -x[1]]).unwrap(), [force[0], -force[1]]);
        near(turned.advance(zeta, turn(x)).unwrap(), turn(force));
        near(moved.advance(zeta, x.plus(by)).unwrap(), force);
        let big = scaled.advance(4.0 * zeta, x.times(4.0)).unwrap();
        assert_eq!(big, force.times(8.0)); // powers of two are exact
    }
    // Carrying the state into a turned frame is the same as having lived in it.
    base.turn_frame(-1.1);
    assert!(length(base.force().minus(turned.force())) < 1e-12);
    let ahead = turned.shift().plus([0.3, 0.1]);
    let one = base.advance(zeta.max(0.1), ahead).unwrap();
    let two = turned.advance(zeta.max(0.1), ahead).unwrap();
    assert!(length(one.minus(two)) < 1e-11);
}

#[test]
fn collinear_is_scalar() {
    let mut random = Splitmix(6);
    let (mut one, mut two) = (ScalarMemory::new(), VectorMemory::new());
    let (s, c) = 0.7_f64.sin_cos();
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    let (mut worst, mut farthest) = (0.0_f64, 0.0_f64);
    for _ in 0..STEPS {
        (zeta, x) = next(&mut random, zeta, x);
        let phi = one.advance(zeta, x[0]).unwrap();
        let pair = two.advance(zeta, [c * x[0], s * x[0]]).unwrap();
        // The friction limit, or what round-off of the shifts themselves makes of it.
        farthest = if zeta > 0.0 { x[0].abs().max(farthest) } else { x[0].abs() };
        let scale = zeta.max(1e-3).sqrt() * zeta.max(farthest).max(1e-3);
        let error = length(pair.minus([c * phi, s * phi])) / scale;
        worst = worst.max(error);
    }
    println!("collinear: {worst:e}");
    assert!(worst < 1e-14, "{worst:e}");
}

#[test]
fn return_point_memory() {
    let mut random = Splitmix(7);
    let mut memory = VectorMemory::new();
    let (mut zeta, mut x) = (1.0, [0.0; 2]);
    for _ in 0..STEPS / 100 {
        (zeta, x) = next(&mut random, zeta, x);
        zeta = zeta.max(0.2);
        memory.advance(zeta, x).unwrap();
        let before = memory.clone();
        // A minor loop at constant approach, out and back along a straight line.
        let out = [random.between(-0.02, 0.02), random.between(-0.02, 0.02)];
        memory.advance(zeta, x.plus(out)).unwrap();
        memory.advance(zeta, x).unwrap();
        let in_line = before.slip_direction().is_some_and(|m| m.dot(out) < 0.0);
        if in_line {
            // Turning back closes the loop if it undid the last ring from its own side.
            let error = length(memory.force().minus(before.force()));
            let collinear = before
                .slip_direction()
                .is_some_and(|m| (m[0] * out[1] - m[1] * out[0]).abs() < 1e-9 * length(out));
            assert!(!collinear || error < 1e-12);
        }
        memory = before;
    }
    // In one direction, with the tangent of the outer loop.
    let mut outer = ScalarMemory::new();
    for (zeta, x) in [(1.0, 0.0), (1.0, 0.7), (1.0, -0.1), (1.0, 0.3)] {
        outer.advance(zeta, x).unwrap();
    }
    let mut inner = outer.clone();
    for x in [0.1, 0.2, 0.15, 0.2, 0.1, 0.3] {
        inner.advance(1.0, x).unwrap();
    }
    let error = (inner.force() - outer.force()).abs();
    assert!(error < 4e-15, "{error:e}");
    let (one, two) = (inner.advance(1.0, 0.35).unwrap(), outer.advance(1.0, 0.35).unwrap());
    assert!((one - two).abs() < 4e-15);
    assert!((inner.tangent().by_shift[0][0] - outer.tangent().by_shift[0][0]).abs() < 4e-15);
    // Nothing depends on a second direction.
    let tangent = inner.tangent();
    assert_eq!((tangent.by_shift[0][1], tangent.by_shift[1]), (0.0, [0.0; 2]));
    assert_eq!(tangent.by_approach[1], 0.0);
}

/// `1 - (1-t)^(5/3) - (5t/6) [1 + (1-t)^(2/3)]`, summed as a series where it cancels.
fn mindlin_deresiewicz(t: f64) -> f64 {
    if t > 0.5 {
        let u = 1.0 - t;
        return 1.0 - u.powf(5.0 / 3.0) - 5.0 * t / 6.0 * (1.0 + u.powf(2.0 / 3.0));
    }
    // Coefficients of (1-t)^(5/3) and (1-t)^(2/3), of which the powers below the third cancel.
    let (mut five, mut two, mut power, mut sum) = (1.0, 1.0, 1.0, 0.0);
    for k in 1..200 {
        let n = f64::from(k);
        let two_before = two;
        five *= (n - 1.0 - 5.0 / 3.0) / n;
        two *= (n - 1.0 - 2.0 / 3.0) / n;
        power *= t;
        if k >= 3 {
            sum -= power * (five + 5.0 / 6.0 * two_before);
        }
    }
    sum
}

#[test]
fn closed_loop_dissipates_what_mindlin_and_deresiewicz_found() {
    for t in [0.01_f64, 0.1, 0.5, 0.9, 0.999] {
        // T*/(f F_z) = t is reached at X = 1 - (1 - t)^(2/3).
        let x = 1.0 - (1.0 - t).powf(2.0 / 3.0);
        let mut memory = ScalarMemory::new();
        memory.advance(1.0, 0.0).unwrap();
        memory.advance(1.0, x).unwrap();
        let mut heat = 0.0;
        let parts = 7;
        for (from, to) in [(x, -x), (-x, x)] {
            for i in 1..=parts {
                let at = from + (to - from) * f64::from(i) / f64::from(parts);
                heat += memory.dissipation(1.0, at);
                memory.advance(1.0, at).unwrap();
            }
        }
        // (9/10) {...} over 3/16 in these units.
        let error = (heat / (4.8 * mindlin_deresiewicz(t)) - 1.0).abs();
        assert!(error < 1e-10, "t = {t}: {error:e}");
    }
}

#[test]
fn long_periodic_history_keeps_its_size_and_its_digits() {
    let period = 1000;
    let at = |i: usize| {
        let t = std::f64::consts::TAU * (i % period) as f64 / period as f64;
        (1.0 + 0.3 * (2.0 * t).sin(), [0.6 * t.sin() + 0.1 * (7.0 * t).cos(), 0.4 * t.cos()])
    };
    let mut old = VectorMemory::new();
    let mut largest = 0;
    for i in 0..STEPS {
        let (zeta, x) = at(i);
        old.advance(zeta, x).unwrap();
        if i > 2 * period {
            largest = largest.max(old.stack().len());
        }
    }
    let mut fresh = VectorMemory::new();
    let phase = STEPS % period;
    for i in 0..3 * period + phase {
        let (zeta, x) = at(i);
        fresh.advance(zeta, x).unwrap();
    }
    assert!(length(old.force().minus(fresh.force())) < 1e-12);
    assert!(largest < 2 * period, "{largest} vertices");
}

fn capacity<const N: usize>(worst_allowed: f64, rms_allowed: f64) {
    let mut random = Splitmix(8);
    let (mut exact, mut small) =
        (VectorMemory::new(), Memory::<[f64; 2], Fixed<[f64; 2], N>>::new());
    let (mut worst, mut squares) = (0.0_f64, 0.0);
    let mut phase = [0.0; 3];
    for i in 0..STEPS / 10 {
        // A growing and shrinking contact shaken by three incommensurate motions.
        let t = 0.05 * i as f64;
        if i % 500 == 0 {
            phase = [0; 3].map(|_| random.between(0.0, 6.3));
        }
        let zeta = 1.0 + 0.6 * (0.71 * t + phase[0]).sin();
        let x = [
            0.3 * (1.3 * t + phase[1]).sin() + 0.15 * (3.1 * t).cos(),
            0.3 * (1.7 * t + phase[2]).cos() + 0.15 * (2.3 * t).sin(),
        ];
        let want = exact.advance(zeta, x).unwrap();
        let got = small.advance(zeta, x).unwrap();
        let error = length(got.minus(want));
        worst = worst.max(error);
        squares += error * error;
        assert!(length(got) <= small.normal_force() * (1.0 + 1e-14));
        assert!(small.stack().len() <= N);
        assert!(small.segments().all(|s| length(s.force_slope) <= 1.0 + 1e-14));
    }
    let rms = (squares / (STEPS / 10) as f64).sqrt();
    println!("capacity {N}: worst {worst:e}, rms {rms:e}, merges {}", small.merges());
    assert!(small.merges() > 0);
    assert!(worst < worst_allowed && rms < rms_allowed);
}

#[test]
fn fixed_capacity_stays_near_the_exact_memory() {
    capacity::<8>(4e-2, 3e-3);
    capacity::<16>(2e-2, 5e-4);
    capacity::<32>(5e-3, 5e-5);
}

/// A pull almost against the traction turns it late: tan(phi/2) falls by exp(-path/zeta), here from 2e160 to 2.
#[test]
fn a_traction_that_is_pulled_back_turns_in_the_end() {
    for ahead in [[1.0, 0.0], [0.0, -1.0]] {
        let across = [-ahead[1], ahead[0]];
        let before = across.times(1e-160).minus(ahead);
        let path = ahead.times(160.0 * std::f64::consts::LN_10);
        let turned = <[f64; 2]>::dragged(before, path, 1.0, 1.0);
        let off = turned.minus(ahead.times(-0.6).plus(across.times(0.8)));
        assert!(off.length() < 1e-12, "{turned:?}");
    }
}
