//! Displacements row by row against those of all cells.

use std::sync::Mutex;

use carom_drawn::{Draw as _, Xorshift};
use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, OperatorError, PeriodicOperator, Plate,
    PlateOperator, PlateSymbol, SurfaceOperator, Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};

fn grid() -> Grid {
    Grid::new(60, 46, 1.0, 0.5).unwrap()
}

fn operators(threads: Threads, blocks: Blocks) -> [Box<dyn SurfaceOperator>; 4] {
    let [one, two] = [0.1, 0.45].map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    let plate = Plate::new(60.0, 23.0, 1.0).unwrap();
    let under = MaterialPair::new(Material::RIGID, one).unwrap();
    let odd = Grid::new(61, 47, 1.0, 0.5).unwrap();
    [
        Box::new(HalfSpaceOperator::with_blocks(pair, odd, blocks, threads).unwrap()),
        Box::new(HalfSpaceOperator::with_blocks(pair, grid(), blocks, threads).unwrap()),
        Box::new(PeriodicOperator::with_blocks(pair, grid(), blocks, threads).unwrap()),
        Box::new(PlateOperator::new(under, plate, grid(), PlateSymbol::Layer, threads).unwrap()),
    ]
}

fn by_fields(operator: &dyn SurfaceOperator, pressure: &[f64]) -> Result<Vec<f64>, OperatorError> {
    let mut w = vec![0.0; operator.grid().cells()];
    let displacements = DisplacementField::normal(&mut w);
    operator.apply(TractionField::normal(pressure), displacements, &mut operator.workspace())?;
    Ok(w)
}

/// The rows that are wanted, others NaN; those that are given twice fail.
fn by_rows(
    operator: &dyn SurfaceOperator,
    pressure: &[f64],
    wanted: &(dyn Fn(usize) -> bool + Sync),
) -> Result<Vec<f64>, OperatorError> {
    let (nx, mut workspace) = (operator.grid().nx(), operator.workspace());
    let mut rows = operator.pressed(pressure, &mut workspace)?;
    let mut last = Vec::new();
    // They may be read again.
    for _ in 0..2 {
        let found = Mutex::new(vec![f64::NAN; operator.grid().cells()]);
        rows.each(wanted, &|row, displacements| {
            let own = &mut found.lock().unwrap()[row * nx..][..nx];
            assert!(own[0].is_nan());
            own.copy_from_slice(displacements);
        });
        last = found.into_inner().unwrap();
    }
    Ok(last)
}

#[test]
fn rows_are_those_of_the_field_to_the_bit() {
    let mut draw = Xorshift(5);
    for threads in [Threads::One, Threads::Pool] {
        for operator in operators(threads, Blocks::Normal) {
            let (nx, cells) = (operator.grid().nx(), operator.grid().cells());
            let all: Vec<f64> = (0..cells).map(|_| draw.signed()).collect();
            let one_row = |cell: usize| if cell / nx == 9 { all[cell] } else { 0.0 };
            let few: Vec<f64> = (0..cells).map(one_row).collect();
            for pressure in [&all, &few, &vec![0.0; cells]] {
                let field = by_fields(&*operator, pressure).unwrap();
                assert_eq!(by_rows(&*operator, pressure, &|_| true).unwrap(), field);
                let third = by_rows(&*operator, pressure, &|row| row % 3 == 1).unwrap();
                for (cell, value) in third.iter().enumerate() {
                    let is_wanted = cell / nx % 3 == 1;
                    assert!(if is_wanted { *value == field[cell] } else { value.is_nan() });
                }
            }
        }
    }
}

/// Operators of pressures alone store half of what others do where the grid is square.
#[test]
fn pressures_alone_displace_as_beside_tractions() {
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let mut draw = Xorshift(9);
    for (nx, ny, dx, dy) in
        [(32, 32, 0.5, 0.5), (32, 32, 0.5, 0.7), (32, 30, 0.5, 0.5), (2, 2, 1.0, 1.0)]
    {
        let grid = Grid::new(nx, ny, dx, dy).unwrap();
        let pressure: Vec<f64> = (0..grid.cells()).map(|_| draw.signed()).collect();
        let displaced = |operator: &dyn SurfaceOperator| {
            let mut w = vec![0.0; grid.cells()];
            let displacements = DisplacementField::normal(&mut w);
            let tractions = TractionField::normal(&pressure);
            operator.apply(tractions, displacements, &mut operator.workspace()).unwrap();
            w
        };
        let threads = Threads::One;
        let free = [Blocks::Normal, Blocks::All].map(|blocks| {
            displaced(&HalfSpaceOperator::with_blocks(pair, grid, blocks, threads).unwrap())
        });
        let periodic = [Blocks::Normal, Blocks::All].map(|blocks| {
            displaced(&PeriodicOperator::with_blocks(pair, grid, blocks, threads).unwrap())
        });
        for [alone, beside] in [free, periodic] {
            let greatest = beside.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
            let off = alone.iter().zip(&beside).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-14 * greatest, "{nx} {ny} {dx} {dy}: {off}");
        }
    }
}

#[test]
fn what_a_product_refuses_is_refused_row_by_row() {
    let mut broken = vec![0.0; grid().cells()];
    broken[77] = f64::NAN;
    let mut endless = vec![0.0; grid().cells()];
    endless[0] = f64::INFINITY;
    let pressures = [vec![], vec![0.0; 5], broken, endless];
    for operator in operators(Threads::One, Blocks::Normal) {
        for pressure in &pressures {
            let refused = by_fields(&*operator, pressure).unwrap_err().to_string();
            let told = by_rows(&*operator, pressure, &|_| true).unwrap_err();
            assert_eq!(told.to_string(), refused);
        }
    }
    for operator in &operators(Threads::One, Blocks::Tangential)[..2] {
        let pressure = vec![1.0; grid().cells()];
        let refused = by_fields(&**operator, &pressure).unwrap_err();
        assert_eq!(by_rows(&**operator, &pressure, &|_| true).unwrap_err(), refused);
    }
}
