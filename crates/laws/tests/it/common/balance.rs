//! Work of a law on a straight step, by Gauss quadrature between the events of the step, and paths that
//! provoke errors.
//!
//! The work is found from the loads alone: copies of the law go part of the way. The events
//! are those of the friction cone and the polyline: the cone meets or leaves a vertex, the edge
//! passes one, comes nearest to a segment's line, touches or separates.

use carom_drawn::{Draw as _, Splitmix};

/// Gauss's nodes and weights on (0, 1), sixteen points, half of them.
const GAUSS: [(f64, f64); 8] = [
    (0.005_299_532_504_175_031, 0.013_576_229_705_877_047),
    (0.027_712_488_463_383_71, 0.031_126_761_969_323_945),
    (0.067_184_398_806_084_13, 0.047_579_255_841_246_39),
    (0.122_297_795_822_498_5, 0.062_314_485_627_766_936),
    (0.191_061_877_798_678_1, 0.074_797_994_408_288_37),
    (0.270_991_611_171_386_3, 0.084_578_259_697_501_27),
    (0.359_198_224_610_370_54, 0.091_301_707_522_461_8),
    (0.452_493_745_081_181_26, 0.094_725_305_227_534_25),
];

/// A place: approach and shift.
pub(crate) type Place = (f64, [f64; 2]);

/// What the balance asks of a law.
pub(crate) trait Energetic {
    /// The number of directions of the shift.
    fn dimension(&self) -> usize;
    fn place(&self) -> Place;
    fn go(&mut self, to: Place) -> [f64; 2];
    /// The force after a step that a copy takes.
    fn force(&self, to: Place) -> [f64; 2];
    fn stored(&self) -> [f64; 2];
    fn heat(&self, to: Place) -> [f64; 2];
    /// The greatest force at an approach, or one of its size.
    fn limit(&self, zeta: f64) -> f64;
    /// Depths and anchors of the vertices, and the slopes above them.
    fn vertices(&self) -> Vec<(f64, [f64; 2], [f64; 2])>;
    /// How often the state changed beside a step.
    fn merges(&self) -> u32;
    /// Steps of the approach below this are none.
    fn least_growth(&self) -> f64 {
        1e-9
    }
}

pub(crate) fn between(from: Place, to: Place, t: f64) -> Place {
    let mix = |a: f64, b: f64| a + t * (b - a);
    (mix(from.0, to.0), [0, 1].map(|i| mix(from.1[i], to.1[i])))
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The parameters at which something happens on a step.
fn events(law: &dyn Energetic, to: Place) -> Vec<f64> {
    let from = law.place();
    let (dz, dx) = (to.0 - from.0, [0, 1].map(|i| to.1[i] - from.1[i]));
    let mut events = vec![0.0, 1.0, -from.0 / dz];
    let mut vertices = law.vertices();
    vertices.push((from.0, from.1, [0.0; 2]));
    if from.0 < 0.0 && to.0 > 0.0 {
        vertices.push((0.0, between(from, to, -from.0 / dz).1, [0.0; 2]));
    }
    for (depth, anchor, slope) in vertices {
        events.push((depth - from.0) / dz);
        let (arm, height) = ([0, 1].map(|i| from.1[i] - anchor[i]), from.0 - depth);
        let curve = dot(dx, dx) - dz * dz;
        let half = dot(arm, dx) - height * dz;
        let rest = dot(arm, arm) - height * height;
        let root = (half * half - curve * rest).max(0.0).sqrt();
        let far = -half - root.copysign(half);
        events.extend([far / curve, rest / far]);
        let distance = [0, 1].map(|i| arm[i] - slope[i] * height);
        let drift = [0, 1].map(|i| dx[i] - slope[i] * dz);
        events.push(-dot(distance, drift) / dot(drift, drift));
    }
    events.retain(|t| (0.0..=1.0).contains(t));
    events.sort_by(f64::total_cmp);
    events.dedup();
    events
}

/// The work of the tangential force on a straight step, per direction.
pub(crate) fn work(law: &dyn Energetic, to: Place) -> [f64; 2] {
    let from = law.place();
    let dx = [0, 1].map(|i| to.1[i] - from.1[i]);
    let force = |t: f64| law.force(between(from, to, t));
    let mut mean = [0.0; 2];
    let events = events(law, to);
    let parts: Vec<_> =
        events.windows(2).map(|pair| panel(&force, pair[0], pair[1], [0.0, 1.0])).collect();
    let scale = parts.iter().map(|part| part[0].abs() + part[1].abs()).sum::<f64>();
    for (pair, whole) in events.windows(2).zip(parts) {
        let part = halve(&force, pair[0], pair[1], [0.0, 1.0], whole, scale, 12);
        mean = [0, 1].map(|i| mean[i] + part[i]);
    }
    [mean[0] * dx[0], mean[1] * dx[1]]
}

fn halve(
    force: &impl Fn(f64) -> [f64; 2],
    from: f64,
    to: f64,
    [low, high]: [f64; 2],
    whole: [f64; 2],
    scale: f64,
    depth: usize,
) -> [f64; 2] {
    let middle = 0.5 * (low + high);
    let one = panel(force, from, to, [low, middle]);
    let two = panel(force, from, to, [middle, high]);
    let sum = [one[0] + two[0], one[1] + two[1]];
    let error = (sum[0] - whole[0]).abs().max((sum[1] - whole[1]).abs());
    if depth == 0 || error <= 2e-15 * scale {
        return sum;
    }
    let one = halve(force, from, to, [low, middle], one, scale, depth - 1);
    let two = halve(force, from, to, [middle, high], two, scale, depth - 1);
    [one[0] + two[0], one[1] + two[1]]
}

/// Gauss on a part of a panel, after a substitution that smooths roots at the panel's ends.
fn panel(force: &impl Fn(f64) -> [f64; 2], from: f64, to: f64, [low, high]: [f64; 2]) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (node, weight) in GAUSS {
        for node in [node, 1.0 - node] {
            let v = low + (high - low) * node;
            let got = force(from + (to - from) * (v * v * (3.0 - 2.0 * v)));
            let weight = weight * (high - low) * (to - from) * 6.0 * v * (1.0 - v);
            sum = [0, 1].map(|i| sum[i] + weight * got[i]);
        }
    }
    sum
}

/// One step of a balance: work less growth of the stored energy less heat, and the largest of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balance {
    /// Of the direction that is worse, and of their sum.
    pub(crate) error: f64,
    pub(crate) total: f64,
    pub(crate) largest: f64,
    pub(crate) heat: f64,
    /// What the rounding of the shifts themselves does to the work.
    pub(crate) rounding: f64,
}

/// Takes a step and balances it, each direction by itself.
pub(crate) fn step(law: &mut dyn Energetic, to: Place) -> Balance {
    let (work, before, heat) = (work(law, to), law.stored(), law.heat(to));
    let from = law.place();
    law.go(to);
    let coordinates = [from.0, to.0, from.1[0], from.1[1], to.1[0], to.1[1]];
    let reach = coordinates.iter().fold(0.0, |reach: f64, x| reach.max(x.abs()));
    let limit = law.limit(from.0.max(to.0).max(0.0));
    let after = law.stored();
    let mut balance = Balance {
        error: 0.0,
        total: 0.0,
        largest: 0.0,
        heat: heat[0] + heat[1],
        rounding: f64::EPSILON * reach * limit,
    };
    for i in 0..2 {
        let error = work[i] - (after[i] - before[i]) - heat[i];
        balance.error = balance.error.max(error.abs());
        balance.total += error;
        for term in [work[i], before[i], after[i], heat[i]] {
            balance.largest = balance.largest.max(term.abs());
        }
    }
    balance.total = balance.total.abs();
    balance
}

/// Places to go next: anywhere, along a segment's line or one of the cone's, to and through
/// vertices, back to where it was before, apart and together again.
pub(crate) struct Wanderer {
    pub(crate) random: Splitmix,
    visited: Vec<Place>,
}

impl Wanderer {
    pub(crate) fn new(seed: u64) -> Self {
        Self { random: Splitmix(seed), visited: Vec::new() }
    }

    pub(crate) fn next(&mut self, law: &dyn Energetic) -> Place {
        let to = self.choose(law);
        // Where forces and energies of earlier shifts do not drown those of this one.
        let to = (to.0.clamp(-1.0, 2.0), to.1.map(|x| x.clamp(-3.0, 3.0)));
        if self.visited.len() == 12 {
            self.visited.remove(0);
        }
        self.visited.push(to);
        to
    }

    fn choose(&mut self, law: &dyn Energetic) -> Place {
        let (zeta, x) = law.place();
        let random = &mut self.random;
        let vertices = law.vertices();
        let size = 10_f64.powf(random.between(-3.0, 0.0));
        let along =
            |slope: [f64; 2], by: f64| (zeta + by, [x[0] + slope[0] * by, x[1] + slope[1] * by]);
        match random.below(10) {
            0 | 1 if !vertices.is_empty() => {
                // Down, rarely up, the direction of a segment, and a segment's line if on it.
                let (depth, _, slope) =
                    vertices[vertices.len() - 1 - random.below(vertices.len().min(3))];
                let by = match random.below(3) {
                    0 => depth - zeta,
                    1 => -size,
                    _ => size * random.between(-1.0, 0.3),
                };
                along(slope, by)
            }
            2 => {
                let angle = random.below(8) as f64 * std::f64::consts::FRAC_PI_4;
                let slope = [[1.0, 0.0], [-1.0, 0.0], [angle.cos(), angle.sin()]][random.below(3)];
                along(slope, -size)
            }
            3 if !vertices.is_empty() => {
                let (depth, anchor, _) = vertices[random.below(vertices.len())];
                let through = [1.0, 0.5, 1.7][random.below(3)];
                between((zeta, x), (depth, anchor), through)
            }
            4 | 5 if !self.visited.is_empty() => {
                let back = self.visited[random.below(self.visited.len())];
                if random.below(2) == 0 { back } else { (zeta, back.1) }
            }
            6 => {
                let grid = |random: &mut Splitmix| random.below(15) as f64 * 0.1 - 0.7;
                (random.below(20) as f64 * 0.1, [grid(random), grid(random)])
            }
            _ => super::next(random, zeta, x),
        }
    }
}
