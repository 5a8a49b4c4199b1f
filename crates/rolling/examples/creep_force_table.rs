//! Makes the table of creep forces anew, in an hour on two free cores.
//!
//! `creep_force_table FOLDER` solves all nodes and keeps each contact in the folder, so that it goes on where it was
//! stopped; `creep_force_table drawn COUNT SEED` prints fresh solutions to judge the table by.
//!
//! Each node is solved on grids of 24, 27 and 48 cells across the contact, and extrapolated.

use carom_laws::creep::CreepCoefficients;
use carom_laws::creep::force::nodes;
use carom_rolling::ContinuumForces;
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::io::Error;
use std::path::Path;

const MESHES: [usize; 3] = [24, 27, 48];
const FINE: [usize; 3] = [48, 54, 96];

type Fault = Box<dyn std::error::Error + Send + Sync>;

/// The forces of rigid sliding: the pressure along the velocity at each point.
fn sliding(ratio: f64, poisson: f64, [x, y, phi]: [f64; 3]) -> Result<[f64; 3], Fault> {
    const PARTS: usize = 600;
    let (a, b) = (ratio.sqrt(), 1.0 / ratio.sqrt());
    let [k_x, k_y, k_phi] = nodes::scales(&CreepCoefficients::by_table(ratio, poisson)?, ratio);
    let [along, across, spin] = [x / k_x, y / k_y, phi / k_phi];
    let mut sum = [0.0; 4];
    for place in 0..PARTS * PARTS {
        let middle = |i: usize| 2.0 * (i as f64 + 0.5) / PARTS as f64 - 1.0;
        let (u, v) = (middle(place % PARTS), middle(place / PARTS));
        let pressure = (1.0 - u * u - v * v).max(0.0).sqrt();
        let (px, py) = (a * u, b * v);
        let (vx, vy) = (along + py * spin, across - px * spin);
        let speed = vx.hypot(vy).max(f64::MIN_POSITIVE);
        let (tx, ty) = (pressure * vx / speed, pressure * vy / speed);
        let parts = [tx, ty, py * tx - px * ty, pressure];
        (0..4).for_each(|i| sum[i] += parts[i]);
    }
    Ok([sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]])
}

/// The forces over the weight of one line of sizes.
fn line(
    contact: &mut ContinuumForces,
    [ratio, poisson]: [f64; 2],
    [theta, psi]: [usize; 2],
) -> Result<Vec<f64>, Fault> {
    let [x, y, phi] = nodes::direction(ratio, [theta, psi]);
    let c = CreepCoefficients::by_table(ratio, poisson)?;
    let [_, k_y, k_phi] = nodes::scales(&c, ratio);
    // Kalker's coefficients at size zero.
    let torque = c.c32 / k_y * y + c.c33 / k_phi * phi;
    let mut line = vec![[x, y - c.c23 / k_phi * phi, torque]];
    for size in 1..nodes::COUNTS[3] - 1 {
        let r = nodes::size(size);
        let forces = contact.forces([r * x, r * y, r * phi])?;
        line.push(forces.map(|force| force / nodes::weight(r)));
    }
    line.push(sliding(ratio, poisson, [x, y, phi])?);
    Ok(line.into_iter().flatten().collect())
}

/// The values of one contact: for each direction and size the forces over the weight of the size.
fn values(ratio: f64, poisson: f64) -> Result<Vec<f64>, Fault> {
    let [_, thetas, psis, ..] = nodes::COUNTS;
    let mut contact = ContinuumForces::new(ratio, poisson, MESHES)?;
    // All angles are one direction at the pole.
    let pole = line(&mut contact, [ratio, poisson], [0, 0])?;
    let mut all: Vec<f64> = (0..psis).flat_map(|_| pole.clone()).collect();
    for (theta, psi) in (1..thetas).flat_map(|theta| (0..psis).map(move |psi| (theta, psi))) {
        all.extend(line(&mut contact, [ratio, poisson], [theta, psi])?);
    }
    Ok(all)
}

/// [`values`], from a file of the folder where that is there.
fn kept(folder: &Path, [ratio, poisson]: [usize; 2]) -> Result<Vec<f64>, Fault> {
    let path = folder.join(format!("{ratio}-{poisson}.json"));
    if let Ok(text) = std::fs::read_to_string(&path) {
        return Ok(serde_json::from_str(&text)?);
    }
    let found = values(nodes::ratio(ratio), nodes::poisson(poisson))?;
    std::fs::write(path, serde_json::to_string(&found)?)?;
    eprintln!("a/b = {:.4}, nu = {:.4}", nodes::ratio(ratio), nodes::poisson(poisson));
    Ok(found)
}

/// Draws fresh points and prints them with their forces on finer grids.
fn drawn(count: usize, seed: u64) -> Result<(), Fault> {
    let mut state = seed;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let points: Vec<[f64; 5]> = (0..count)
        .map(|_| {
            let (ratio, poisson) = (10_f64.powf(2.0 * next() - 1.0), 0.5 * next());
            let s = 0.98 * next();
            let (z, turn) = (2.0 * next() - 1.0, std::f64::consts::TAU * next());
            let (r, flat) = (3.0 * s / (1.0 - s), (1.0 - z * z).sqrt());
            [ratio, poisson, r * flat * turn.cos(), r * flat * turn.sin(), r * z]
        })
        .collect();
    let found: Vec<Result<[f64; 3], Fault>> = points
        .par_iter()
        .map(|[ratio, poisson, x, y, phi]| {
            Ok(ContinuumForces::new(*ratio, *poisson, FINE)?.forces([*x, *y, *phi])?)
        })
        .collect();
    for (point, forces) in points.iter().zip(found) {
        let numbers: Vec<String> = point.iter().chain(&forces?).map(f64::to_string).collect();
        println!("{}", numbers.join(","));
    }
    Ok(())
}

/// The coefficients of a spline through the values of a full circle.
fn circle(count: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(count, count);
    for i in 0..count {
        for (step, weight) in [(0, 4.0), (1, 1.0), (count - 1, 1.0)] {
            matrix[(i, (i + step) % count)] += weight / 6.0;
        }
    }
    matrix
}

/// The same between two ends, whose first and last two cells share one polynomial.
fn open(count: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(count + 2, count + 2);
    for i in 0..count {
        (0..3).for_each(|k| matrix[(i, i + k)] = [1.0, 4.0, 1.0][k] / 6.0);
    }
    for (row, first) in [(count, 0), (count + 1, count - 3)] {
        (0..5).for_each(|k| matrix[(row, first + k)] = [1.0, -4.0, 6.0, -4.0, 1.0][k]);
    }
    matrix
}

/// Values over some axes, of which one turns into coefficients at a time.
struct Lattice {
    counts: Vec<usize>,
    values: Vec<f64>,
}

impl Lattice {
    /// Solves with the matrix along an axis; rows beyond the values stand for zeros.
    fn solve(self, axis: usize, matrix: DMatrix<f64>) -> Result<Self, Fault> {
        let Self { mut counts, values } = self;
        let (before, after) =
            (counts[..axis].iter().product(), counts[axis + 1..].iter().product());
        let (given, found) = (counts[axis], matrix.nrows());
        let inverse = matrix.try_inverse().ok_or_else(|| Error::other("a singular spline"))?;
        let mut solved = vec![0.0; found * before * after];
        for (outer, inner) in
            (0..before).flat_map(|o: usize| (0..after).map(move |i: usize| (o, i)))
        {
            for row in 0..found {
                let terms = (0..given)
                    .map(|k| inverse[(row, k)] * values[(outer * given + k) * after + inner]);
                solved[(outer * found + row) * after + inner] = terms.sum();
            }
        }
        counts[axis] = found;
        Ok(Self { counts, values: solved })
    }
}

/// The coefficients of one contact along both angles, as values of the quarter.
fn around(quarter: &[f64]) -> Result<Vec<f64>, Fault> {
    let [_, thetas, psis, sizes, _] = nodes::COUNTS;
    let line = 3 * sizes;
    let (circles, turns) = (4 * (thetas - 1), 2 * (psis - 1));
    let mut values = Vec::with_capacity(circles * turns * line);
    for (theta, psi) in (0..circles).flat_map(|t| (0..turns).map(move |p| (t, p))) {
        let ([row, column], signs) = nodes::reflected(theta as isize, psi as isize);
        let first = (row * psis + column) * line;
        values.extend((0..line).map(|at| signs[at % 3] * quarter[first + at]));
    }
    let all = Lattice { counts: vec![circles, turns, line], values };
    let all = all.solve(0, circle(circles))?.solve(1, circle(turns))?;
    let mut own = Vec::with_capacity(quarter.len());
    for (theta, psi) in (0..thetas).flat_map(|t| (0..psis).map(move |p| (t, p))) {
        let first = (theta * turns + psi) * line;
        own.extend_from_slice(&all.values[first..first + line]);
    }
    Ok(own)
}

fn table(folder: &Path) -> Result<(), Fault> {
    let [ratios, thetas, psis, sizes, poissons] = nodes::COUNTS;
    let parts: Result<Vec<Vec<f64>>, Fault> = (0..ratios * poissons)
        .into_par_iter()
        .map(|part| around(&kept(folder, [part / poissons, part % poissons])?))
        .collect();
    let values = parts?.into_iter().flatten().collect();
    let all = Lattice { counts: vec![ratios, poissons, thetas * psis, sizes, 3], values };
    let all = all.solve(0, open(ratios))?.solve(3, open(sizes))?;
    let [outer, inner, directions, along, _] = all.counts[..] else {
        return Err(Error::other("a lattice of five axes").into());
    };
    // Stored with Poisson's ratio innermost, so that a call reads few stretches of memory.
    let mut bytes = Vec::new();
    for (ratio, direction) in (0..outer).flat_map(|r| (0..directions).map(move |d| (r, d))) {
        for (size, poisson) in (0..along).flat_map(|s| (0..inner).map(move |n| (s, n))) {
            let first = 3 * (((ratio * inner + poisson) * directions + direction) * along + size);
            for value in &all.values[first..first + 3] {
                bytes.extend((*value as f32).to_le_bytes());
            }
        }
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../laws/src/creep/force/stored.bin");
    Ok(std::fs::write(path, bytes)?)
}

fn main() -> Result<(), Fault> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["drawn", count, seed] => drawn(count.parse()?, seed.parse()?),
        [folder] => table(Path::new(folder)),
        _ => Err(Error::other("creep_force_table FOLDER, or drawn COUNT SEED").into()),
    }
}
