//! Points below the surface: the blocks of the S digit.

use super::fault::Fault;
use super::lines::Lines;
use super::potential::Potential;

/// The most points of a block.
const MOST_POINTS: usize = 1 << 20;
const MOST: i32 = 99_999;
/// The most blocks of a case.
const MOST_BLOCKS: usize = 1000;

/// A block of points: all combinations of some coordinates, in mm; z > 0 is in body 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    columns: Places,
    rows: Places,
    depths: Vec<f64>,
}

/// Coordinates along x or y.
#[derive(Debug, Clone, PartialEq)]
enum Places {
    /// The centres of these cells: first, step, last, from 1.
    Cells([usize; 3]),
    /// The centres of these cells, from 1.
    Listed(Vec<usize>),
    At(Vec<f64>),
}

impl Places {
    fn of(&self, corner: f64, size: f64, count: usize) -> Vec<f64> {
        let centre = |cell: usize| corner + (cell as f64 - 0.5) * size;
        match self {
            Self::Cells([first, step, last]) => {
                (*first..=(*last).min(count)).step_by(*step).map(centre).collect()
            }
            Self::Listed(cells) => {
                cells.iter().filter(|cell| **cell <= count).map(|cell| centre(*cell)).collect()
            }
            Self::At(values) => values.clone(),
        }
    }
}

impl Block {
    /// Reads blocks until a 0 in the place of ISUBS.
    pub(super) fn read_all(lines: &mut Lines<'_>) -> Result<Vec<Self>, Fault> {
        let mut blocks = Vec::new();
        loop {
            let [kind] = lines.numbers(["ISUBS"])?;
            let of_kind = kind.whole([0, 9])?;
            if of_kind == 0 {
                return Ok(blocks);
            }
            if blocks.len() == MOST_BLOCKS {
                return Err(kind.must(format!("0 after {MOST_BLOCKS} blocks")));
            }
            if matches!(of_kind, 4 | 8) {
                return Err(kind.must("0 to 3, 5 to 7 or 9"));
            }
            blocks.push(Self::read(lines, of_kind)?);
        }
    }

    fn read(lines: &mut Lines<'_>, kind: i32) -> Result<Self, Fault> {
        if kind == 9 {
            let [nx, ny, nz] = lines.numbers(["NX", "NY", "NZ"])?;
            let counts = [nx.count(MOST)?, ny.count(MOST)?, nz.count(MOST)?];
            if counts.iter().product::<usize>() > MOST_POINTS {
                return Err(nz.must(format!("such that NX NY NZ is at most {MOST_POINTS}")));
            }
            let [x, y] = [lines.list("x", counts[0])?, lines.list("y", counts[1])?];
            let depths = sorted(lines.list("z", counts[2])?);
            let [columns, rows] = [x, y].map(|values| Places::At(sorted(values)));
            return Ok(Self { columns, rows, depths });
        }
        let [columns, rows] = match kind {
            1 | 5 => [Places::Cells([1, 1, usize::MAX]), Places::Cells([1, 1, usize::MAX])],
            2 | 6 => {
                [chosen(lines, ["IXL", "IXINC", "IXH"])?, chosen(lines, ["IYL", "IYINC", "IYH"])?]
            }
            _ => {
                let [nx, ny] = lines.numbers(["NX", "NY"])?;
                let (nx, ny) = (nx.count(MOST)?, ny.count(MOST)?);
                [listed(lines, "IX", nx)?, listed(lines, "IY", ny)?]
            }
        };
        let depths = if kind < 4 {
            let [nz, zl, dz] = lines.numbers(["NZ", "ZL", "DZ"])?;
            let (count, step) = (nz.count(MOST)?, dz.positive()?);
            (0..count).map(|place| zl.value + place as f64 * step).collect()
        } else {
            let [nz] = lines.numbers(["NZ"])?;
            sorted(lines.list("z", nz.count(MOST)?)?)
        };
        Ok(Self { columns, rows, depths })
    }

    /// The points over an area of cells, x fastest; none if they are too many.
    pub(super) fn points(&self, area: &Potential) -> Option<Vec<[f64; 3]>> {
        let of = |places: &Places, i: usize| places.of(area.corner[i], area.size[i], area.cells[i]);
        let (x, y) = (of(&self.columns, 0), of(&self.rows, 1));
        if x.len() * y.len() * self.depths.len() > MOST_POINTS {
            return None;
        }
        let rows = self.depths.iter().flat_map(|z| y.iter().map(move |y| (*y, *z)));
        Some(rows.flat_map(|(y, z)| x.iter().map(move |x| [*x, y, z])).collect())
    }
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}

fn chosen(lines: &mut Lines<'_>, names: [&'static str; 3]) -> Result<Places, Fault> {
    let [first, step, last] = lines.numbers(names)?;
    let step = step.whole([0, MOST])?.max(1) as usize;
    let (from, to) = (first.count(MOST)?, last.count(MOST)?);
    if to < from {
        return Err(last.must(format!("at least {} = {from}", first.name)));
    }
    Ok(Places::Cells([from, step, to]))
}

fn listed(lines: &mut Lines<'_>, name: &'static str, count: usize) -> Result<Places, Fault> {
    let all = lines.list(name, count)?;
    if let Some(part) = all.iter().find(|cell| cell.fract() != 0.0) {
        return Err(Fault::new(lines.last(), name, part, "whole numbers"));
    }
    // CONTACT leaves out those outside the cells.
    let mut cells: Vec<usize> = all.into_iter().map(|cell| cell.max(0.0) as usize).collect();
    cells.sort_unstable();
    cells.dedup();
    cells.retain(|cell| *cell > 0);
    Ok(Places::Listed(cells))
}
