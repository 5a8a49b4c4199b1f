//! The periodic half-space beside one that is not: close to a load whose mean is zero they agree.

use carom_halfspace::operator::{
    DisplacementField, HalfSpaceOperator, PeriodicOperator, SurfaceOperator, Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};

fn pair() -> MaterialPair {
    let soft = Material::from_shear(1.0, 0.2).unwrap();
    MaterialPair::new(soft, Material::from_shear(3.0, 0.4).unwrap()).unwrap()
}

/// All three displacements by bumps that have no mean and no first moments along each axis.
fn displacements(operator: &dyn SurfaceOperator) -> [Vec<f64>; 3] {
    let grid = operator.grid();
    let bump = |x: f64, y: f64| {
        let r = x * x + y * y;
        (1.0 - r) * (-r).exp()
    };
    let [x, y, z] = [[1.0, 0.3], [-0.5, 0.8], [0.2, -0.4]].map(|[at, size]| {
        grid.centres().map(|(x, y)| size * bump(x - at, y + at)).collect::<Vec<f64>>()
    });
    let [mut u, mut v, mut w] = [(); 3].map(|()| vec![0.0; grid.cells()]);
    let tractions = TractionField::full(&x, &y, &z);
    let out = DisplacementField::full(&mut u, &mut v, &mut w);
    operator.apply(tractions, out, &mut operator.workspace()).unwrap();
    [u, v, w]
}

#[test]
fn loads_without_mean_displace_as_on_a_wide_half_space() {
    let grid = Grid::new(160, 176, 0.2, 0.2).unwrap();
    let periodic = displacements(&PeriodicOperator::new(pair(), grid, Threads::One).unwrap());
    let wide = displacements(&HalfSpaceOperator::new(pair(), grid).unwrap());
    for (axis, (periodic, wide)) in periodic.iter().zip(&wide).enumerate() {
        let near = |(x, y): (f64, f64)| x.abs() < 4.0 && y.abs() < 4.0;
        let top = wide.iter().fold(0.0_f64, |top, value| top.max(value.abs()));
        let places = grid.centres().zip(periodic.iter().zip(wide)).filter(|(at, _)| near(*at));
        let worst = places.fold(0.0_f64, |worst, (_, (a, b))| worst.max((a - b).abs()));
        assert!(worst < 0.01 * top, "{axis}: {worst} of {top}");
    }
}

#[test]
fn coefficients_are_the_entries_of_the_product() {
    let grid = Grid::new(6, 10, 0.3, 0.2).unwrap();
    let operator = PeriodicOperator::new(pair(), grid, Threads::One).unwrap();
    let (source, receiver) = ([4, 1], [1, 8]);
    let mut unit = vec![0.0; grid.cells()];
    unit[grid.index(source[0], source[1])] = 1.0;
    let zero = vec![0.0; grid.cells()];
    let [mut u, mut v, mut w] = [(); 3].map(|()| zero.clone());
    let tractions = TractionField::full(&zero, &unit, &zero);
    let out = DisplacementField::full(&mut u, &mut v, &mut w);
    operator.apply(tractions, out, &mut operator.workspace()).unwrap();
    let at = grid.index(receiver[0], receiver[1]);
    let offset = [0, 1].map(|k| source[k] as i32 - receiver[k] as i32);
    let rows = operator.coefficients(offset[0], offset[1]).rows;
    for (got, want) in [rows[0][1], rows[1][1], rows[2][1]].into_iter().zip([u[at], v[at], w[at]]) {
        assert!((got - want).abs() < 1e-15);
    }
    assert!(
        PeriodicOperator::new(pair(), Grid::new(5, 4, 1.0, 1.0).unwrap(), Threads::One).is_err()
    );
}
