//! The influence among some cells of a large grid, against the product with all cells.

use carom_drawn::{Draw as _, Xorshift};
use carom_halfspace::operator::{
    DisplacementField, HalfSpaceOperator, OperatorError, PeriodicOperator, SPARSENESS,
    SurfaceOperator, Threads, TractionField, Workspace,
};
use carom_halfspace::{Grid, Material, MaterialPair};

fn pair() -> MaterialPair {
    let body = Material::from_shear(80e3, 0.3).unwrap();
    MaterialPair::new(body, Material::from_shear(50e3, 0.1).unwrap()).unwrap()
}

/// Round spots, some at the border, in ascending order.
fn spots(random: &mut Xorshift, grid: Grid) -> Vec<usize> {
    let mut chosen = vec![false; grid.cells()];
    for _ in 0..1 + random.below(20) {
        let at = [grid.nx(), grid.ny()].map(|count| random.part() * count as f64);
        let radius = 1.0 + 12.0 * random.part() * random.part();
        for (cell, chosen) in chosen.iter_mut().enumerate() {
            let (x, y) = ((cell % grid.nx()) as f64, (cell / grid.nx()) as f64);
            *chosen |= (x - at[0]).hypot(y - at[1]) < radius;
        }
    }
    chosen[grid.cells() - 1] = true;
    (0..grid.cells()).filter(|cell| chosen[*cell]).collect()
}

fn displacements(
    operator: &dyn SurfaceOperator,
    pressure: &[f64],
    workspace: &mut Workspace,
) -> Vec<f64> {
    let mut w = vec![f64::NAN; pressure.len()];
    let (given, found) = (TractionField::normal(pressure), DisplacementField::normal(&mut w));
    operator.apply(given, found, workspace).unwrap();
    w
}

fn operators(threads: Threads) -> [Box<dyn SurfaceOperator>; 5] {
    let free = |nx: usize, ny: usize, dy: f64| {
        let grid = Grid::new(nx, ny, 0.1, dy).unwrap();
        let blocks = carom_halfspace::operator::Blocks::Normal;
        let operator = HalfSpaceOperator::with_blocks(pair(), grid, blocks, threads).unwrap();
        Box::new(operator) as Box<dyn SurfaceOperator>
    };
    let periodic = |nx: usize, ny: usize| {
        let grid = Grid::new(nx, ny, 0.1, 0.12).unwrap();
        let operator = PeriodicOperator::new(pair(), grid, threads).unwrap();
        Box::new(operator) as Box<dyn SurfaceOperator>
    };
    [
        free(256, 256, 0.1),
        free(321, 87, 0.19),
        free(530, 512, 0.08),
        periodic(256, 192),
        periodic(516, 64),
    ]
}

/// Pressures that vary smoothly, at random, from cell to cell, and that of one cell.
fn pressures(kind: usize, count: usize, random: &mut Xorshift) -> Vec<f64> {
    let value = |i: usize, random: &mut Xorshift| match kind {
        0 => 1.0 + (0.01 * i as f64).sin(),
        1 => random.part(),
        2 => random.part() - 0.5,
        3 => 1.0 - 2.0 * (i % 2) as f64,
        _ => f64::from(u8::from(i == count / 3)),
    };
    (0..count).map(|i| 1e150 * value(i, random)).collect()
}

/// One working memory serves all products, whatever was computed with it before.
#[test]
fn chosen_cells_act_on_each_other_as_among_all_cells() {
    let (mut random, mut workspace) = (Xorshift(11), Workspace::default());
    for operator in operators(Threads::One) {
        let grid = operator.grid();
        let own = operator.coefficients(0, 0).rows[2][2];
        for kind in 0..10 {
            let cells = spots(&mut random, grid);
            let some = operator.among(&cells).unwrap();
            assert_eq!(some.grid().cells(), cells.len());
            assert!((some.coefficients(0, 0).rows[2][2] / own - 1.0).abs() < 1e-15);
            let pressure = pressures(kind % 5, cells.len(), &mut random);
            let mut all = vec![0.0; grid.cells()];
            cells.iter().zip(&pressure).for_each(|(cell, p)| all[*cell] = *p);
            let exact = displacements(&*operator, &all, &mut workspace);
            let got = displacements(&*some, &pressure, &mut workspace);
            let greatest = cells.iter().fold(0.0_f64, |most, cell| most.max(exact[*cell].abs()));
            let squares: f64 = pressure.iter().map(|p| (p / 1e150).powi(2)).sum();
            let off = cells.iter().zip(&got).map(|(cell, got)| (got - exact[*cell]).abs());
            let error = off.fold(0.0, f64::max) / (greatest + own * 1e150 * squares.sqrt());
            assert!(error < SPARSENESS, "{grid:?}, kind {kind}: {error:e}");
        }
    }
}

/// Betti: the work of one pressure on the displacement of another is the converse.
#[test]
fn the_influence_is_symmetric_and_the_inverse_positive() {
    let (mut random, mut workspace) = (Xorshift(5), Workspace::default());
    for operator in operators(Threads::One) {
        let cells = spots(&mut random, operator.grid());
        let some = operator.among(&cells).unwrap();
        let [p, q] = [2, 1].map(|kind| pressures(kind, cells.len(), &mut random));
        let work = |p: &[f64], w: &[f64]| p.iter().zip(w).map(|(p, w)| p / 1e150 * w).sum::<f64>();
        let of_p = displacements(&*some, &p, &mut workspace);
        let of_q = displacements(&*some, &q, &mut workspace);
        let (one, other) = (work(&p, &of_q), work(&q, &of_p));
        let scale = (work(&p, &of_p) * work(&q, &of_q)).sqrt();
        assert!((one - other).abs() < 1e-5 * scale, "{one:e} {other:e} {scale:e}");
        let mut pressure = vec![f64::NAN; cells.len()];
        some.inverse().unwrap().pressure(&p, &mut pressure, &mut workspace);
        assert!(work(&pressure, &p) > 0.0);
    }
}

/// Of many cells the inverse is symmetric and positive, and waves of 2 to 200 cells come back as parts of themselves that
/// differ by a small factor: the number of iterations does not grow with the patch.
#[test]
fn the_inverse_of_many_cells_treats_waves_of_all_lengths_alike() {
    let (mut random, mut workspace) = (Xorshift(7), Workspace::default());
    let operators = operators(Threads::One);
    for operator in [&operators[0], &operators[2]] {
        let grid = operator.grid();
        let patch = |cell: &usize| {
            let (x, y) = (cell % grid.nx(), cell / grid.nx());
            (20..220).contains(&x) && (30..230).contains(&y)
        };
        let cells: Vec<usize> = (0..grid.cells()).filter(patch).collect();
        let some = operator.among(&cells).unwrap();
        let inverse = some.inverse().unwrap();
        let mut inverted = |field: &[f64]| {
            let mut found = vec![f64::NAN; cells.len()];
            inverse.pressure(field, &mut found, &mut workspace);
            found
        };
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let [p, q] = [(); 2].map(|()| (0..cells.len()).map(|_| random.part() - 0.5).collect());
        let [p, q]: [Vec<f64>; 2] = [p, q];
        let (of_p, of_q) = (inverted(&p), inverted(&q));
        let scale = (dot(&p, &of_p) * dot(&q, &of_q)).sqrt();
        assert!((dot(&p, &of_q) - dot(&q, &of_p)).abs() < 1e-5 * scale);
        let parts = [2.0, 3.0, 6.0, 15.0, 40.0, 100.0, 200.0].map(|length: f64| {
            let turn = std::f64::consts::TAU / length;
            let wave = |cell: &usize| {
                let (x, y) = (cell % grid.nx() - 20, cell / grid.nx() - 30);
                let fading = (x * (199 - x) * y * (199 - y)) as f64;
                fading * (turn * x as f64).cos() * (0.4 * turn * y as f64).cos()
            };
            let wave: Vec<f64> = cells.iter().map(wave).collect();
            let displaced = displacements(&*some, &wave, &mut Workspace::default());
            dot(&displaced, &inverted(&displaced)) / dot(&displaced, &wave)
        });
        let [least, most] = [f64::min, f64::max].map(|of| parts.into_iter().reduce(of).unwrap());
        assert!(least > 0.0 && most < 4.0 * least, "{parts:?}");
    }
}

#[test]
fn products_have_the_same_bits_on_any_number_of_threads() {
    let on = |threads| {
        let mut random = Xorshift(3);
        operators(threads).map(|operator| {
            let cells = spots(&mut random, operator.grid());
            let pressure = pressures(2, cells.len(), &mut random);
            displacements(&*operator.among(&cells).unwrap(), &pressure, &mut Workspace::default())
        })
    };
    let one = on(Threads::One);
    for threads in [1, 2, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert_eq!(pool.install(|| on(Threads::Pool)), one);
    }
}

#[test]
fn tangential_fields_and_numbers_that_are_none_are_refused() {
    let [operator, ..] = operators(Threads::One);
    let some = operator.among(&[3, 700, 701]).unwrap();
    let (mut workspace, given) = (some.workspace(), [1.0, 2.0, 3.0]);
    let mut w = [f64::NAN; 3];
    let tangential = TractionField::tangential(&given, &given);
    let told = some.apply(tangential, DisplacementField::normal(&mut w), &mut workspace);
    assert!(matches!(told, Err(OperatorError::Missing { .. })), "{told:?}");
    let [mut u, mut v] = [w; 2];
    let found = DisplacementField::full(&mut u, &mut v, &mut w);
    let told = some.apply(TractionField::normal(&given), found, &mut workspace);
    assert!(matches!(told, Err(OperatorError::Missing { .. })), "{told:?}");
    for (given, is_length) in [(&[1.0, 2.0][..], true), (&[1.0, f64::NAN, 0.0], false)] {
        let found = DisplacementField::normal(&mut w);
        let told = some.apply(TractionField::normal(given), found, &mut workspace).unwrap_err();
        assert_eq!(matches!(told, OperatorError::Length { .. }), is_length, "{told:?}");
    }
    assert!(w.iter().all(|w| w.is_nan()));
}

/// Small grids, slender cells and odd periods have no coarser grids to interpolate from.
#[test]
fn where_no_grid_is_coarser_there_is_no_influence_among_some() {
    let free = |n, dy| HalfSpaceOperator::new(pair(), Grid::new(n, n, 1.0, dy).unwrap()).unwrap();
    assert!(free(64, 1.0).among(&[5]).is_some());
    assert!(free(63, 1.0).among(&[5]).is_none());
    assert!(free(64, 2.5).among(&[5]).is_none());
    let periodic = |nx, ny| {
        let grid = Grid::new(nx, ny, 1.0, 1.0).unwrap();
        PeriodicOperator::new(pair(), grid, Threads::One).unwrap().among(&[5]).is_some()
    };
    assert!(periodic(64, 66) && !periodic(62, 64));
}

/// The table of pressures alone takes a shorter way.
#[test]
fn a_table_of_pressures_alone_is_that_of_the_whole() {
    let grid = Grid::new(150, 90, 0.3, 0.7).unwrap();
    let [all, normal] =
        [carom_halfspace::operator::Blocks::All, carom_halfspace::operator::Blocks::Normal].map(
            |blocks| HalfSpaceOperator::with_blocks(pair(), grid, blocks, Threads::One).unwrap(),
        );
    for (i, j) in (0..150).flat_map(|i| (0..90).map(move |j| (i, j))) {
        let [all, normal] = [&all, &normal].map(|one| one.coefficients(i, j).rows[2][2]);
        assert!((all / normal - 1.0).abs() < 1.5e-15, "{i} {j}");
    }
}
