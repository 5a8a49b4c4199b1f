//! Makes the table of creep forces anew, in one to two hours on two free cores.
//!
//! `creep_force_table FOLDER` solves all nodes and keeps each row of directions in the folder, so that it goes on where
//! it was stopped; `creep_force_table drawn COUNT SEED` prints fresh solutions to judge the table by.
//!
//! Each node is solved on grids of 24, 27 and 48 cells across the contact, and extrapolated. Contacts of an axis
//! ratio from 2 to 7 bend most where the pole of the spin leaves them: of them twice as many rows are solved.

use carom_drawn::{Draw as _, Xorshift};
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

/// The values of one row of directions with one angle from the spin: for each angle between both creepages and each size
/// the forces over the weight of the size.
fn row(ratio: f64, poisson: f64, theta: usize) -> Result<Vec<f64>, Fault> {
    let mut contact = ContinuumForces::new(ratio, poisson, MESHES)?;
    let psis = nodes::COUNTS[2];
    if theta == 0 {
        // All angles are one direction at the pole.
        return Ok(line(&mut contact, [ratio, poisson], [0, 0])?.repeat(psis));
    }
    let lines = (0..psis).map(|psi| line(&mut contact, [ratio, poisson], [theta, psi]));
    Ok(lines.collect::<Result<Vec<_>, Fault>>()?.concat())
}

/// [`row`], from a file of the folder where that is there.
fn kept(folder: &Path, [ratio, poisson]: [usize; 2], theta: usize) -> Result<Vec<f64>, Fault> {
    let path = folder.join(format!("{ratio}-{poisson}-{theta}.json"));
    if let Ok(text) = std::fs::read_to_string(&path) {
        return Ok(serde_json::from_str(&text)?);
    }
    let found = row(nodes::ratio(ratio), nodes::poisson(poisson), theta)?;
    std::fs::write(path, serde_json::to_string(&found)?)?;
    Ok(found)
}

/// By how many nodes of the angle from the spin the solved rows of a contact are apart.
fn stride(ratio: usize) -> usize {
    if (2.0..9.0).contains(&nodes::ratio(ratio)) { 1 } else { 2 }
}

/// Draws fresh points and prints them with their forces on finer grids.
fn drawn(count: usize, seed: u64) -> Result<(), Fault> {
    let mut draw = Xorshift(seed);
    let points: Vec<[f64; 5]> = (0..count)
        .map(|_| {
            let (ratio, poisson) = (10_f64.powf(draw.signed()), 0.5 * draw.part());
            let s = 0.98 * draw.part();
            let (z, turn) = (draw.signed(), std::f64::consts::TAU * draw.part());
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

/// The coefficients of one contact along both angles, as rows of the quarter, from the values of rows that are `stride` nodes apart.
fn around(quarter: &[f64], stride: usize) -> Result<Vec<f64>, Fault> {
    let [_, thetas, psis, sizes, _] = nodes::COUNTS;
    let line = 3 * sizes;
    let (circles, turns) = (4 * (thetas - 1) / stride, 2 * (psis - 1));
    let mut values = Vec::with_capacity(circles * turns * line);
    for (theta, psi) in (0..circles).flat_map(|t| (0..turns).map(move |p| (t, p))) {
        let ([row, column], signs) = nodes::reflected((theta * stride) as isize, psi as isize);
        let first = (row / stride * psis + column) * line;
        values.extend((0..line).map(|at| signs[at % 3] * quarter[first + at]));
    }
    let all = Lattice { counts: vec![circles, turns, line], values };
    let all = all.solve(0, circle(circles))?.solve(1, circle(turns))?;
    // A spline over every second node is one over all nodes, too.
    let part = |theta: usize| match (stride, theta % stride) {
        (1, _) => vec![(theta, 1.0)],
        (_, 0) => vec![(theta / 2 + circles - 1, 0.125), (theta / 2, 0.75), (theta / 2 + 1, 0.125)],
        _ => vec![(theta / 2, 0.5), (theta / 2 + 1, 0.5)],
    };
    let mut own = Vec::with_capacity(thetas * psis * line);
    for (theta, psi) in (0..thetas).flat_map(|t| (0..psis).map(move |p| (t, p))) {
        let parts = part(theta);
        let value = |at: usize| {
            let of = |(row, weight): &(usize, f64)| {
                weight * all.values[(row % circles * turns + psi) * line + at]
            };
            parts.iter().map(of).sum::<f64>()
        };
        own.extend((0..line).map(value));
    }
    Ok(own)
}

fn table(folder: &Path) -> Result<(), Fault> {
    let [ratios, thetas, psis, sizes, poissons] = nodes::COUNTS;
    let contacts = (0..ratios).flat_map(|r| (0..poissons).map(move |p| [r, p]));
    let rows: Vec<_> = contacts
        .flat_map(|contact| (0..thetas).step_by(stride(contact[0])).map(move |t| (contact, t)))
        .collect();
    rows.par_iter().try_for_each(|&(contact, theta)| kept(folder, contact, theta).map(|_| ()))?;
    let part = |part: usize| {
        let (contact, stride) = ([part / poissons, part % poissons], stride(part / poissons));
        let rows = (0..thetas).step_by(stride).map(|theta| kept(folder, contact, theta));
        around(&rows.collect::<Result<Vec<_>, Fault>>()?.concat(), stride)
    };
    let parts: Result<Vec<Vec<f64>>, Fault> =
        (0..ratios * poissons).into_par_iter().map(part).collect();
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
                bytes.extend(nodes::stored(*value).ok_or_else(|| Error::other("a large value"))?);
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
