//! Errors of the point load and of the coefficients of a rectangle.

use crate::error_table::{ErrorTable, Errors, Reference};
use crate::{Failure, Figure, FigureResult};
use carom_halfspace::{
    Force, LoadedRectangle, Material, MaterialPair, Offset, Point, PointLoad, Rectangle,
    RectangleInfluence, Traction,
};
use carom_special::RangeError;

/// Largest allowed error of the coefficients: 1e-14, in units of eps.
const COEFFICIENTS: f64 = 1e-14 / f64::EPSILON;

type Done = Result<(), Failure>;

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("unit of the errors", "2.2e-16 of the largest value at that point or offset");
    let mut table = ErrorTable::new("Errors of the half-space");
    point_load(&mut table)?;
    integrals(&mut table)?;
    coefficients(&mut table)?;
    interior(&mut table)?;
    table.finish(&mut figure);
    Ok(figure)
}

/// Counts values that belong together, each relative to the largest of them.
fn add(errors: &mut Errors, found: &[f64], expected: &[f64], place: &str) {
    let largest = expected.iter().fold(0.0f64, |m, e| m.max(e.abs()));
    for (f, e) in found.iter().zip(expected) {
        // 1 + the deviation from 1: an error relative to the largest.
        errors.add(1.0 + (f - e) / largest, 1.0, place);
    }
}

fn point_load(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/halfspace/point_load.csv"))?;
    let mut displacement = Errors::of("point load, displacement (4.1)", 1.0);
    let mut stress = Errors::of("point load, stress (4.2), (4.3)", 1.0);
    for row in reference.rows() {
        let body = Material::from_shear(row[6], row[7])?;
        let load = PointLoad::new(body, Force { x: row[3], y: row[4], z: row[5] })?;
        let at = Point { x: row[0], y: row[1], z: row[2] };
        let place = format!("({:.2}, {:.2}, {:.2e})", at.x, at.y, at.z);
        let d = load.displacement(at)?;
        add(&mut displacement, &[d.u, d.v, d.w], &row[8..11], &place);
        let s = load.stress(at)?;
        add(&mut stress, &[s.xx, s.yy, s.zz, s.xy, s.yz, s.zx], &row[11..17], &place);
    }
    table.add(displacement, 8.0);
    table.add(stress, 32.0);
    Ok(())
}

fn integrals(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/halfspace/integrals.csv"))?;
    let mut errors = Errors::of("integrals (4.29), sides to 1e6 : 1, to 4000 cells", 1.0);
    for row in reference.rows() {
        let cell = Rectangle::new(row[0], row[1])?;
        let i = cell.integrals(Offset { x: row[2], y: row[3] })?;
        let found = [i.inverse_distance, i.xx, i.yy, i.xy, i.log_x, i.log_y];
        let place = format!("{:e} by {:e} at ({:e}, {:e})", row[0], row[1], row[2], row[3]);
        add(&mut errors, &found, &row[4..10], &place);
    }
    table.add(errors, COEFFICIENTS);
    Ok(())
}

fn material(shear_modulus: f64, poisson: f64) -> Result<Material, RangeError> {
    if shear_modulus.is_infinite() {
        return Ok(Material::RIGID);
    }
    Material::from_shear(shear_modulus, poisson)
}

fn coefficients(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/halfspace/influence.csv"))?;
    let mut errors = Errors::of("nine coefficients of two bodies (4.14)", 1.0);
    for row in reference.rows() {
        let pair = MaterialPair::new(material(row[4], row[5])?, material(row[6], row[7])?)?;
        let cell = RectangleInfluence::new(pair, Rectangle::new(row[2], row[3])?);
        let offset = Offset { x: row[0] * row[2], y: row[1] * row[3] };
        let found = cell.coefficients(offset)?.rows;
        let place = format!("{} columns, {} rows", row[0], row[1]);
        add(&mut errors, found.as_flattened(), &row[8..17], &place);
    }
    table.add(errors, COEFFICIENTS);
    Ok(())
}

fn interior(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/halfspace/interior.csv"))?;
    let mut errors = Errors::of("stress under a rectangle, sides to 1000 : 1", 1.0);
    let loads = [
        Traction { x: 1.0, ..Traction::default() },
        Traction { y: 1.0, ..Traction::default() },
        Traction { normal: 1.0, ..Traction::default() },
    ];
    for row in reference.rows() {
        let cell = Rectangle::new(row[0], row[1])?;
        let loaded = LoadedRectangle::new(Material::from_shear(1.0, row[5])?, cell)?;
        let at = Point { x: row[2], y: row[3], z: row[4] };
        let place =
            format!("{:e} by {:e} at ({:.3e}, {:.3e}, {:.3e})", row[0], row[1], at.x, at.y, at.z);
        let mut found = Vec::new();
        for load in loads {
            let s = loaded.stress(load, at)?;
            found.extend([s.xx, s.yy, s.zz, s.xy, s.yz, s.zx]);
        }
        // All loads together: on the axis the stress by one of them nearly vanishes.
        add(&mut errors, &found, &row[6..24], &place);
    }
    table.add(errors, COEFFICIENTS);
    Ok(())
}
