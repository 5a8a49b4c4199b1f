//! The periodic half-space compared with the infinite one: they agree close to a load of zero mean.

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

/// A coarser period has an even number of cells too, along both axes.
#[test]
fn a_period_is_coarser_where_both_counts_allow_it() {
    for ([nx, ny], is) in [([8, 4], true), ([8, 6], false), ([6, 8], false)] {
        let grid = Grid::new(nx, ny, 0.3, 0.2).unwrap();
        let operator = PeriodicOperator::new(pair(), grid, Threads::One).unwrap();
        let coarser = operator.coarser().map(|coarser| coarser.unwrap().grid());
        assert_eq!(coarser, is.then(|| grid.coarser().unwrap()), "{nx} {ny}");
    }
}

/// Every entry for every offset, in a grid without symmetry: the product with a load in one cell.
#[test]
fn all_coefficients_are_the_entries_of_the_product() {
    let grid = Grid::new(6, 4, 0.3, 0.2).unwrap();
    let operator = PeriodicOperator::new(pair(), grid, Threads::One).unwrap();
    let mut workspace = operator.workspace();
    let cells = (0..4_i32).flat_map(|j| (0..6_i32).map(move |i| [i, j]));
    for by in 0..3 {
        for source in cells.clone() {
            let mut loads = [(); 3].map(|()| vec![0.0; grid.cells()]);
            loads[by][grid.index(source[0] as usize, source[1] as usize)] = 1.0;
            let [mut u, mut v, mut w] = [(); 3].map(|()| vec![0.0; grid.cells()]);
            let tractions = TractionField::full(&loads[0], &loads[1], &loads[2]);
            let out = DisplacementField::full(&mut u, &mut v, &mut w);
            operator.apply(tractions, out, &mut workspace).unwrap();
            for receiver in cells.clone() {
                let at = grid.index(receiver[0] as usize, receiver[1] as usize);
                let offset = [source[0] - receiver[0], source[1] - receiver[1]];
                let rows = operator.coefficients(offset[0], offset[1]).rows;
                for (of, product) in [u[at], v[at], w[at]].into_iter().enumerate() {
                    let entry = rows[of][by];
                    assert!((entry - product).abs() < 1e-15, "{offset:?} {of} {by}");
                }
            }
        }
    }
}

/// A traction that is one wave displaces by one wave, whose size is the symbol of the half-space:
/// along the traction `(1/G)(1 - nu q_x^2/q^2)/q`, normal `(1/G)(1 - nu)/q`, and the coupled ones a
/// quarter of a wave behind, `epsilon q_x/q^2`.
#[test]
fn each_wave_of_the_grid_has_its_symbol() {
    let grid = Grid::new(6, 10, 0.3, 0.2).unwrap();
    let pair = pair();
    let (nu, g, epsilon) = (pair.poisson(), pair.shear_modulus(), pair.epsilon());
    assert!(epsilon.abs() > 0.01 && nu > 0.1);
    let operator = PeriodicOperator::new(pair, grid, Threads::One).unwrap();
    let mut workspace = operator.workspace();
    let turn = std::f64::consts::TAU;
    for (k, l, phase) in (0..6).flat_map(|k| (0..10).map(move |l| (k, l, 0.1 + f64::from(k + l)))) {
        if (k, l) == (0, 0) {
            continue;
        }
        // The wave numbers from -n/2 to n/2; those of half the cells have no sign.
        let number = |k: i32, n: i32| f64::from(if 2 * k > n { k - n } else { k });
        let signed = |k: i32, n: i32| if 2 * k == n { 0.0 } else { number(k, n) };
        let q = [turn * number(k, 6) / 1.8, turn * number(l, 10) / 2.0];
        let odd = [turn * signed(k, 6) / 1.8, turn * signed(l, 10) / 2.0];
        let square = q[0] * q[0] + q[1] * q[1];
        let size = square.sqrt();
        let cells = (0..10).flat_map(|j| (0..6).map(move |i| (f64::from(i), f64::from(j))));
        let angles: Vec<f64> = cells
            .map(|(i, j)| turn * (f64::from(k) * i / 6.0 + f64::from(l) * j / 10.0) + phase)
            .collect();
        let wave: Vec<f64> = angles.iter().map(|angle| angle.cos()).collect();
        let zero = vec![0.0; grid.cells()];
        for by in 0..3 {
            let load = |axis: usize| if axis == by { &wave } else { &zero };
            let [mut u, mut v, mut w] = [(); 3].map(|()| zero.clone());
            let tractions = TractionField::full(load(0), load(1), load(2));
            let out = DisplacementField::full(&mut u, &mut v, &mut w);
            operator.apply(tractions, out, &mut workspace).unwrap();
            let across = -nu * odd[0] * odd[1] / square;
            let even = |of: usize| match (of, by) {
                (2, 2) => 1.0 - nu,
                (2, _) | (_, 2) => 0.0,
                (0, 0) | (1, 1) => 1.0 - nu * q[of] * q[of] / square,
                _ => across,
            };
            let coupled = |of: usize| match (of, by) {
                (2, 2) => 0.0,
                (2, _) => epsilon * odd[by] / square,
                (_, 2) => -epsilon * odd[of] / square,
                _ => 0.0,
            };
            for (of, values) in [&u, &v, &w].into_iter().enumerate() {
                // Half of such a wave is another one: its sine vanishes in all cells.
                for (value, angle) in values.iter().zip(&angles) {
                    let expected = even(of) / (g * size) * angle.cos() + coupled(of) * angle.sin();
                    assert!(
                        (value - expected).abs() < 1e-14,
                        "{k} {l}, {of} by {by}: {value:e} {expected:e}"
                    );
                }
            }
        }
    }
}
