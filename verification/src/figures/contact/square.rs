//! CONTACT's example of stresses below a square patch under pressure and traction.

use carom_halfspace::{Displacement, Grid, Material, Point, Stress};
use carom_solver::{ContactState, Subsurface};

use super::super::printed::{SOURCE, all_digits, off_cell};
use crate::reference::{reader, rows};
use crate::{Cell, Failure, Figure, FigureResult, Marker, Panel, Series, Table, linspace};

/// Where the middle of the square is.
const MIDDLE: [f64; 2] = [1e-4, 2e-4];
/// Traction along x in the second case; the pressure is 1.
const TRACTION: f64 = 0.999;
/// x and y of the first block of points, and those of the second.
const AXIS: f64 = 1e-5;
const ACROSS: [f64; 21] = [
    -5.0, -3.0, -2.0, -1.0, -0.8, -0.6, -0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8,
    1.0, 2.0, 3.0, 5.0,
];
/// z of both.
const DEPTHS: [f64; 15] =
    [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25, 1.667, 2.5, 5.0];

/// Depth to which the stresses are drawn.
const SHOWN: f64 = 1.7;

/// One of the two cases.
struct Square(Subsurface);

impl Square {
    fn new(traction: f64) -> Result<Self, Failure> {
        let mut state = ContactState::apart(Grid::new(1, 1, 1.0, 1.0)?);
        state.pressure.values_mut().fill(1.0);
        state.traction_x.values_mut().fill(traction);
        Ok(Self(Subsurface::of_body_1(&state, Material::from_shear(1.0, 0.28)?)?))
    }

    fn at([x, y, z]: [f64; 3]) -> Point {
        Point { x: x - MIDDLE[0], y: y - MIDDLE[1], z }
    }

    fn stress(&self, at: [f64; 3]) -> Result<Stress, Failure> {
        Ok(self.0.stress(Self::at(at))?)
    }

    fn displacement(&self, at: [f64; 3]) -> Result<Displacement, Failure> {
        Ok(self.0.displacement(Self::at(at))?)
    }
}

/// The quantities of which the example prints the extremes. Of a stress in a direction and of the
/// mean it is the greatest magnitude that counts.
fn quantity(stress: &Stress, name: &str) -> Result<f64, Failure> {
    Ok(match name {
        "mean" => stress.mean(),
        "von_mises" => stress.von_mises(),
        "tresca" => 2.0 * stress.maximum_shear(),
        "sigma_1" => stress.principal().maximum,
        "sigma_3" => stress.principal().minimum,
        "xx" => stress.xx,
        "yy" => stress.yy,
        "zz" => stress.zz,
        _ => return Err(format!("{name} is not a stress").into()),
    })
}

/// A printed extreme.
struct Extreme {
    case: usize,
    block: usize,
    name: String,
    printed: f64,
    at: [f64; 3],
    /// There, and the extreme of the block.
    own: [f64; 2],
}

fn points(block: usize) -> Vec<[f64; 3]> {
    let across: &[f64] = if block == 1 { &[AXIS] } else { &ACROSS };
    let plane = |z: f64| across.iter().flat_map(move |y| across.iter().map(move |x| [*x, *y, z]));
    DEPTHS.into_iter().flat_map(plane).collect()
}

/// How a name orders values: least, greatest, or greatest in magnitude.
fn rank(name: &str, value: f64) -> f64 {
    match name {
        "sigma_3" => -value,
        "von_mises" | "tresca" | "sigma_1" => value,
        _ => value.abs(),
    }
}

fn extremes(cases: &[Square; 2]) -> Result<Vec<Extreme>, Failure> {
    let mut reader = reader(include_str!("../../../data/solver/square_extremes.csv"));
    let mut extremes = Vec::new();
    for record in reader.records() {
        let record = record?;
        let [case, block, printed, x, y, z] =
            [0, 1, 3, 4, 5, 6].map(|column| record[column].parse::<f64>());
        let (name, case, block) = (record[2].to_owned(), case? as usize, block? as usize);
        let (at, square) = ([x?, y?, z?], &cases[case - 1]);
        let there = quantity(&square.stress(at)?, &name)?;
        let mut most = there;
        for point in points(block) {
            let value = quantity(&square.stress(point)?, &name)?;
            if rank(&name, value) > rank(&name, most) {
                most = value;
            }
        }
        extremes.push(Extreme { case, block, name, printed: printed?, at, own: [there, most] });
    }
    Ok(extremes)
}

/// Three decimals are printed.
fn off(own: f64, printed: f64) -> f64 {
    (own - printed).abs() / 1e-3
}

fn table(extremes: &[Extreme]) -> Table {
    let heads =
        ["", "of CONTACT", "of carom there", "extreme of carom", "off, units of the 3rd decimal"];
    let mut table = Table::new("Extremes of the stresses", heads);
    for one in extremes {
        let [x, y, z] = one.at;
        let words =
            format!("case {}, block {}: {} at ({x}, {y}, {z})", one.case, one.block, one.name);
        let [there, most] = one.own;
        let off = Cell::Remark(format!("{:.2}", off(most, one.printed)));
        table.row(vec![words.into(), one.printed.into(), there.into(), most.into(), off]);
    }
    table
}

/// What is printed of a point below the middle, in this order.
const NAMES: [&str; 8] = ["u", "w", "mean stress", "von Mises", "σ_xx", "σ_zx", "σ_yy", "σ_zz"];

struct Depth {
    z: f64,
    printed: [f64; 8],
    own: [f64; 8],
}

impl Square {
    fn below_the_middle(&self, z: f64) -> Result<[f64; 8], Failure> {
        let at = [AXIS, AXIS, z];
        let (stress, moved) = (self.stress(at)?, self.displacement(at)?);
        let Stress { xx, yy, zz, zx, .. } = stress;
        Ok([moved.u, moved.w, stress.mean(), stress.von_mises(), xx, zx, yy, zz])
    }
}

fn depths(square: &Square) -> Result<Vec<Depth>, Failure> {
    let table: Vec<[f64; 12]> = rows(include_str!("../../../data/solver/square_depths.csv"))?;
    let compute = |row: [f64; 12]| -> Result<Depth, Failure> {
        let [z, u, _, w, mean, von_mises, xx, _, zx, yy, _, zz] = row;
        let printed = [u, w, mean, von_mises, xx, zx, yy, zz];
        Ok(Depth { z, printed, own: square.below_the_middle(z)? })
    };
    table.into_iter().map(compute).collect()
}

fn panels(cases: &[Square; 2], depths: &[Depth]) -> Result<[Panel; 2], Failure> {
    let mut profile = Panel::new("z", "stress").titled("Below the middle, with traction");
    let near = linspace(0.0, SHOWN, 61);
    let own: Result<Vec<_>, _> = near.iter().map(|z| cases[1].below_the_middle(*z)).collect();
    let own = own?;
    for (colour, which) in [3, 4, 5, 7].into_iter().enumerate() {
        let curve = near.iter().zip(&own).map(|(z, own)| (*z, own[which]));
        profile.add(Series::line(NAMES[which], curve).coloured(colour));
        let label = if colour == 0 { "CONTACT" } else { "" };
        let printed = depths.iter().filter(|depth| depth.z <= SHOWN);
        let printed = printed.map(|depth| (depth.z, depth.printed[which]));
        profile.add(Series::markers(label, Marker::Circle, printed).coloured(4));
    }
    // No point lies on the surface at an edge, where the stress is infinite.
    let (x, z) = (linspace(-1.25, 1.25, 61), linspace(0.02, 1.5, 38));
    let mut values = Vec::new();
    for depth in &z {
        for x in &x {
            values.push(cases[1].stress([*x, AXIS, *depth])?.von_mises());
        }
    }
    let field = carom_plot::Field::new("von Mises", x, z, values)?;
    let plane = Panel::new("x", "z").titled("Plane y = 0, with traction").over(field);
    Ok([profile, plane])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("body", "G = 1, ν = 0.28");
    figure.stated("square", "1 × 1, its middle at (0.0001, 0.0002)");
    figure.stated("load", "pressure 1; in case 2 also traction 0.999 along x");
    figure.stated("points", "block 1: 15 depths at x = y = 1e-5; block 2: 21 × 21 at each of them");
    figure.stated("Tresca", "σ₁ − σ₃");
    let cases = [Square::new(0.0)?, Square::new(TRACTION)?];
    let (extremes, depths) = (extremes(&cases)?, depths(&cases[1])?);
    for panel in panels(&cases, &depths)? {
        figure.panel(panel);
    }
    figure.table(table(&extremes));
    let mut beside = Table::new(
        "Below the middle, with traction",
        ["z", "", "of CONTACT", "of carom", "off, units of the 4th digit"],
    );
    for depth in &depths {
        for (which, name) in NAMES.into_iter().enumerate() {
            let (printed, own) = (depth.printed[which], depth.own[which]);
            beside.row(vec![
                depth.z.into(),
                name.into(),
                printed.into(),
                own.into(),
                off_cell(own, printed),
            ]);
        }
    }
    figure.table(beside);
    for (which, place) in ["where printed", "of the block"].into_iter().enumerate() {
        let worst = extremes.iter().map(|one| off(one.own[which], one.printed)).reduce(f64::max);
        let statement =
            format!("extremes {place}: worst difference, in units of the third decimal");
        figure.at_most(statement, worst.unwrap_or(f64::NAN), 0.5).source(SOURCE);
    }
    for (which, name) in NAMES.into_iter().enumerate() {
        let pairs = depths.iter().map(|depth| (depth.own[which], depth.printed[which]));
        all_digits(&mut figure, &format!("below the middle: {name}"), pairs).source(SOURCE);
    }
    Ok(figure)
}
