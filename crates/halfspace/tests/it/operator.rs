//! The operator: compared with the direct sum, same bits on any number of threads, errors,
//! definiteness.

use carom_drawn::{Draw as _, Xorshift};
use carom_halfspace::operator::{
    Blocks, CoefficientTable, DisplacementField, HalfSpaceOperator, KernelOperator, OperatorError,
    PeriodicOperator, SurfaceOperator, TabulatedKernel, Threads, TractionField,
};
use carom_halfspace::{Coefficients, Grid, Material, MaterialPair, Offset, RectangleInfluence};
use proptest::prelude::*;

fn dissimilar() -> MaterialPair {
    let one = Material::from_shear(1.0, 0.1).unwrap();
    let two = Material::from_shear(3.0, 0.45).unwrap();
    MaterialPair::new(one, two).unwrap()
}

fn similar() -> MaterialPair {
    let one = Material::from_shear(1.0, 0.3).unwrap();
    MaterialPair::new(one, one).unwrap()
}

/// Reproducible values in (-1, 1).
fn noise(count: usize, seed: u64) -> Vec<f64> {
    let mut draw = Xorshift(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    (0..count).map(|_| draw.signed()).collect()
}

struct Fields([Vec<f64>; 3]);

impl Fields {
    fn noise(grid: Grid) -> Self {
        Self([1, 2, 3].map(|seed| noise(grid.cells(), seed)))
    }

    fn zero(grid: Grid) -> Self {
        Self([0; 3].map(|_| vec![0.0; grid.cells()]))
    }

    fn tractions(&self) -> TractionField<'_> {
        TractionField::full(&self.0[0], &self.0[1], &self.0[2])
    }

    fn displacements(&mut self) -> DisplacementField<'_> {
        let [u, v, w] = &mut self.0;
        DisplacementField::full(u, v, w)
    }
}

fn product(operator: &dyn SurfaceOperator, tractions: &Fields) -> Fields {
    let mut result = Fields::zero(operator.grid());
    let mut workspace = operator.workspace();
    operator.apply(tractions.tractions(), result.displacements(), &mut workspace).unwrap();
    result
}

/// (4.13) term by term.
fn direct_sum(operator: &dyn SurfaceOperator, tractions: &Fields) -> Fields {
    let grid = operator.grid();
    let mut result = Fields::zero(grid);
    for j in 0..grid.ny() {
        for k in 0..grid.nx() {
            for m in 0..grid.ny() {
                for n in 0..grid.nx() {
                    let a = operator.coefficients(n as i32 - k as i32, m as i32 - j as i32);
                    for (i, row) in a.rows.iter().enumerate() {
                        for (l, value) in row.iter().enumerate() {
                            result.0[i][grid.index(k, j)] +=
                                value * tractions.0[l][grid.index(n, m)];
                        }
                    }
                }
            }
        }
    }
    result
}

fn worst_difference(one: &Fields, two: &Fields) -> f64 {
    let largest = one.0.iter().flatten().fold(0.0f64, |m, v| m.max(v.abs()));
    let pairs = one.0.iter().flatten().zip(two.0.iter().flatten());
    pairs.fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / largest
}

#[test]
fn product_equals_the_direct_sum() {
    let shapes = [(1, 1), (2, 1), (1, 7), (9, 16), (20, 20), (33, 12), (40, 25)];
    for pair in [similar(), dissimilar(), dissimilar().exchanged()] {
        for (nx, ny) in shapes {
            let grid = Grid::new(nx, ny, 0.3, 0.7).unwrap();
            let operator = HalfSpaceOperator::new(pair, grid).unwrap();
            let tractions = Fields::noise(grid);
            let error = worst_difference(
                &direct_sum(&operator, &tractions),
                &product(&operator, &tractions),
            );
            assert!(error < 1e-14, "{nx} x {ny}: {error:e}");
        }
    }
}

#[test]
fn coefficients_are_those_of_the_rectangle_with_signs() {
    let grid = Grid::new(7, 5, 0.3, 0.7).unwrap();
    let cell = RectangleInfluence::new(dissimilar(), grid.cell());
    for pair in [Blocks::All, Blocks::Normal, Blocks::Tangential] {
        let operator =
            HalfSpaceOperator::with_blocks(dissimilar(), grid, pair, Threads::One).unwrap();
        for rows in -4..5 {
            for columns in -6..7 {
                let offset = Offset { x: 0.3 * f64::from(columns), y: 0.7 * f64::from(rows) };
                let expected = cell.coefficients(offset).unwrap();
                let found = operator.coefficients(columns, rows);
                for (f, e) in found.rows.iter().flatten().zip(expected.rows.iter().flatten()) {
                    assert!((f - e).abs() <= 1e-15 * expected.largest());
                }
            }
        }
        assert_eq!(operator.coefficients(7, 0), Coefficients::default());
        assert_eq!(operator.coefficients(0, -5), Coefficients::default());
    }
}

#[test]
fn parts_of_the_product_are_the_whole() {
    let grid = Grid::new(18, 23, 1.0, 0.5).unwrap();
    let operator = HalfSpaceOperator::new(dissimilar(), grid).unwrap();
    let tractions = Fields::noise(grid);
    let whole = product(&operator, &tractions);
    let [x, y, p] = &tractions.0;
    let mut workspace = operator.workspace();
    let mut tangential = Fields::zero(grid);
    let mut normal = Fields::zero(grid);
    for (field, part) in [
        (TractionField::tangential(x, y), &mut tangential),
        (TractionField::normal(p), &mut normal),
    ] {
        operator.apply(field, part.displacements(), &mut workspace).unwrap();
    }
    for (a, b) in tangential.0.iter_mut().flatten().zip(normal.0.iter().flatten()) {
        *a += b;
    }
    assert!(worst_difference(&whole, &tangential) < 1e-14);
    // A displacement alone, with the same workspace.
    let mut v = vec![1.0; grid.cells()];
    let wanted = DisplacementField { v: Some(&mut v), ..Default::default() };
    operator.apply(tractions.tractions(), wanted, &mut workspace).unwrap();
    assert!(v.iter().zip(&whole.0[1]).all(|(a, b)| (a - b).abs() < 1e-13));
    // No traction at all.
    operator.apply(TractionField::default(), whole_mut(&mut v), &mut workspace).unwrap();
    assert!(v.iter().all(|v| *v == 0.0));
}

fn whole_mut(v: &mut [f64]) -> DisplacementField<'_> {
    DisplacementField { v: Some(v), ..Default::default() }
}

#[test]
fn similar_bodies_do_not_couple() {
    let grid = Grid::new(8, 8, 1.0, 1.0).unwrap();
    let operator = HalfSpaceOperator::new(similar(), grid).unwrap();
    assert!(!operator.is_coupled());
    let mut found = Fields::noise(grid);
    let pressure = noise(grid.cells(), 9);
    let mut workspace = operator.workspace();
    operator
        .apply(TractionField::normal(&pressure), found.displacements(), &mut workspace)
        .unwrap();
    assert!(found.0[0].iter().chain(&found.0[1]).all(|v| *v == 0.0));
    assert_eq!(CoefficientTable::new(similar(), grid).unwrap().size_in_bytes(), 4 * 64 * 8);
    assert_eq!(CoefficientTable::new(dissimilar(), grid).unwrap().size_in_bytes(), 6 * 64 * 8);
}

#[test]
fn threads_do_not_change_a_bit() {
    let grid = Grid::new(61, 47, 1.0, 0.5).unwrap();
    let tractions = Fields::noise(grid);
    let one = HalfSpaceOperator::new(dissimilar(), grid).unwrap();
    let expected = product(&one, &tractions);
    for threads in 1..6 {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let found = pool.install(|| {
            let many =
                HalfSpaceOperator::with_blocks(dissimilar(), grid, Blocks::All, Threads::Pool);
            product(&many.unwrap(), &tractions)
        });
        assert_eq!(expected.0, found.0, "{threads} threads");
    }
}

/// The part of a grid that a small load covers: the same influence, and no part larger than all.
#[test]
fn an_operator_on_fewer_cells_is_part_of_all() {
    let all = Grid::new(24, 18, 0.1, 0.2).unwrap();
    for pair in [similar(), dissimilar()] {
        let operator = HalfSpaceOperator::new(pair, all).unwrap();
        let fewer = operator.on_fewer(7, 10).unwrap().unwrap();
        let part = Fields::noise(fewer.grid());
        let mut load = Fields::zero(all);
        for (own, field) in part.0.iter().zip(&mut load.0) {
            for (row, values) in own.chunks_exact(7).enumerate() {
                field[all.index(9, 5 + row)..][..7].copy_from_slice(values);
            }
        }
        let (got, want) = (product(&*fewer, &part), product(&operator, &load));
        for (got, want) in got.0.iter().zip(&want.0) {
            for (i, got) in got.iter().enumerate() {
                let want = want[all.index(9 + i % 7, 5 + i / 7)];
                assert!((got - want).abs() < 1e-13, "{got} {want}");
            }
        }
        assert_eq!(fewer.coefficients(6, -9), operator.coefficients(6, -9));
        assert_eq!(fewer.coefficients(7, 0), Coefficients::default());
        assert_eq!(operator.on_fewer(24, 18).unwrap().unwrap().grid(), all);
        for [nx, ny] in [[25, 1], [1, 19], [0, 4]] {
            let error = operator.on_fewer(nx, ny).unwrap().err().unwrap();
            assert!(matches!(error, OperatorError::Range(_)), "{error}");
        }
    }
}

/// Rows without tractions above and below those with some, of each field its own.
#[test]
fn loads_on_a_few_rows_are_the_direct_sum() {
    let grid = Grid::new(11, 9, 0.1, 0.2).unwrap();
    let operator = HalfSpaceOperator::new(dissimilar(), grid).unwrap();
    let mut workspace = operator.workspace();
    let mut result = Fields::zero(grid);
    for rows in [[0, 9, 4], [8, 3, 3], [0, 0, 8], [2, 7, 5]] {
        let mut load = Fields::noise(grid);
        for (field, row) in load.0.iter_mut().zip(rows) {
            for (i, value) in field.iter_mut().enumerate() {
                if i / 11 != row {
                    *value = 0.0;
                }
            }
        }
        operator.apply(load.tractions(), result.displacements(), &mut workspace).unwrap();
        assert!(worst_difference(&result, &direct_sum(&operator, &load)) < 1e-13, "{rows:?}");
    }
}

#[test]
fn one_workspace_serves_grids_of_different_size() {
    let mut workspace = carom_halfspace::operator::Workspace::default();
    for (nx, ny) in [(30, 4), (5, 5), (4, 30), (31, 31)] {
        let grid = Grid::new(nx, ny, 1.0, 1.0).unwrap();
        let operator = HalfSpaceOperator::new(dissimilar(), grid).unwrap();
        let tractions = Fields::noise(grid);
        let mut found = Fields::zero(grid);
        operator.apply(tractions.tractions(), found.displacements(), &mut workspace).unwrap();
        assert_eq!(found.0, product(&operator, &tractions).0);
    }
}

#[test]
fn bad_fields_leave_the_result_as_it_was() {
    let grid = Grid::new(6, 5, 1.0, 1.0).unwrap();
    let operator = HalfSpaceOperator::new(dissimilar(), grid).unwrap();
    let mut workspace = operator.workspace();
    let mut w = vec![7.0; 30];
    let mut p = vec![1.0; 30];
    p[17] = f64::NAN;
    let error = operator
        .apply(TractionField::normal(&p), DisplacementField::normal(&mut w), &mut workspace)
        .unwrap_err();
    assert!(matches!(
        error,
        OperatorError::NotFinite { field: "pressure", index: 17, value } if value.is_nan()
    ));
    p[17] = 1.0;
    p[29] = f64::INFINITY;
    let error = operator
        .apply(TractionField::normal(&p), DisplacementField::normal(&mut w), &mut workspace)
        .unwrap_err();
    assert!(matches!(error, OperatorError::NotFinite { index: 29, .. }));
    let error = operator
        .apply(TractionField::normal(&p[..29]), DisplacementField::normal(&mut w), &mut workspace)
        .unwrap_err();
    assert_eq!(error, OperatorError::Length { field: "pressure", found: 29, expected: 30 });
    assert!(w.iter().all(|w| *w == 7.0));
}

#[test]
fn grids_are_checked_before_allocation() {
    assert!(Grid::new(0, 1, 1.0, 1.0).is_err());
    assert!(Grid::new(1, 1, 0.0, 1.0).is_err());
    assert!(Grid::new(1, 1, 1.0, -2.0).is_err());
    assert!(Grid::new(1, 1, f64::NAN, 1.0).is_err());
    let huge = Grid::new(1 << 29, 1 << 29, 1.0, 1.0).unwrap();
    let needed = |error| match error {
        OperatorError::TooLarge { needed, available } => {
            assert!(needed > available);
            needed
        }
        other => panic!("{other}"),
    };
    let operator = needed(HalfSpaceOperator::new(similar(), huge).unwrap_err());
    let table = needed(CoefficientTable::new(similar(), huge).unwrap_err());
    assert_eq!(table, (4 * 8) << 58);
    // Half of each of three rows of complex numbers, of twice the length, and four transforms as large as their tables;
    // all of it again in single precision.
    let (rows, transforms) = (3 * table / 2, table);
    let most = table + (rows + transforms) * 3 / 2;
    assert!(operator > most && operator < most + table);
    let kernel = TabulatedKernel::from_function(huge, |_, _| Coefficients::default());
    assert!(needed(kernel.unwrap_err()) > 72 << 59);
    let text = HalfSpaceOperator::new(similar(), huge).unwrap_err().to_string();
    assert!(text.contains(&operator.to_string()), "{text}");
}

#[test]
fn missing_blocks_are_named() {
    let grid = Grid::new(4, 4, 1.0, 1.0).unwrap();
    let normal =
        HalfSpaceOperator::with_blocks(similar(), grid, Blocks::Normal, Threads::One).unwrap();
    let field = vec![1.0; 16];
    let mut u = vec![0.0; 16];
    let mut v = vec![0.0; 16];
    let error = normal.apply(
        TractionField::tangential(&field, &field),
        DisplacementField::tangential(&mut u, &mut v),
        &mut normal.workspace(),
    );
    let expected = OperatorError::Missing { of: "displacement u", by: "traction x" };
    assert_eq!(error, Err(expected));
}

#[test]
fn user_kernels_reproduce_the_half_space() {
    let grid = Grid::new(11, 6, 0.4, 0.9).unwrap();
    let half_space = HalfSpaceOperator::new(dissimilar(), grid).unwrap();
    let tractions = Fields::noise(grid);
    let expected = product(&half_space, &tractions);
    let function = TabulatedKernel::from_function(grid, |n, m| half_space.coefficients(n, m));
    let mut full = String::from("columns,rows,xx,xy,xz,yx,yy,yz,zx,zy,zz\n");
    let mut quarter = full.clone();
    for m in -5..6 {
        for n in -10..11 {
            let a = half_space.coefficients(n, m).rows;
            let line: Vec<String> = a.iter().flatten().map(|v| format!("{v:e}")).collect();
            let line = format!("{n}, {m}, {}\n", line.join(", "));
            full.push_str(&line);
            if n >= 0 && m >= 0 {
                quarter.push_str(&line);
            }
        }
    }
    for kernel in [
        function,
        TabulatedKernel::from_csv(grid, &full),
        TabulatedKernel::from_csv(grid, &quarter),
    ] {
        let operator = KernelOperator::new(kernel.unwrap(), Threads::One).unwrap();
        assert!(operator.is_coupled());
        assert_eq!(operator.coefficients(-3, 2), half_space.coefficients(-3, 2));
        let error = worst_difference(&expected, &product(&operator, &tractions));
        assert!(error < 1e-14, "{error:e}");
    }
}

#[test]
fn unsymmetric_kernel_equals_its_direct_sum() {
    let grid = Grid::new(5, 8, 1.0, 1.0).unwrap();
    let values = noise(9 * 9 * 15, 4);
    let kernel = TabulatedKernel::from_function(grid, |n, m| {
        let at = ((n + 4) + 9 * (m + 7)) as usize * 9;
        let mut rows = [[0.0; 3]; 3];
        for (k, value) in rows.iter_mut().flatten().enumerate() {
            *value = values[at + k];
        }
        Coefficients { rows }
    });
    let operator = KernelOperator::new(kernel.unwrap(), Threads::One).unwrap();
    let tractions = Fields::noise(grid);
    let error =
        worst_difference(&direct_sum(&operator, &tractions), &product(&operator, &tractions));
    assert!(error < 1e-14, "{error:e}");
}

#[test]
fn bad_tables_are_named() {
    let grid = Grid::new(2, 1, 1.0, 1.0).unwrap();
    let read = |text: &str| TabulatedKernel::from_csv(grid, text).unwrap_err();
    let at = |error| match error {
        OperatorError::Table { line, .. } => line,
        other => panic!("{other}"),
    };
    assert_eq!(at(read("")), 1);
    assert_eq!(at(read("columns,zz\n0,1\n")), 1);
    assert_eq!(at(read("columns,rows,ww\n0,0,1\n")), 1);
    assert_eq!(at(read("columns,rows,zz\n0,0\n")), 2);
    assert_eq!(at(read("columns,rows,zz\n0,0,1\n1,0,x\n")), 3);
    assert_eq!(at(read("columns,rows,zz\n0,0,1\n1,0,nan\n")), 3);
    assert_eq!(at(read("columns,rows,zz\n0,0,1\n0,0,2\n")), 3);
    assert_eq!(at(read("columns,rows,zz\n0.5,0,1\n")), 2);
    assert_eq!(read("columns,rows,zz\n0,0,1\n"), OperatorError::Absent { columns: 1, rows: 0 });
    let infinite = TabulatedKernel::from_function(grid, |n, _| Coefficients {
        rows: [[1.0 / f64::from(n), 0.0, 0.0], [0.0; 3], [0.0; 3]],
    });
    assert_eq!(infinite.unwrap_err(), OperatorError::Kernel { columns: 0, rows: 0 });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn matrix_is_symmetric_and_positive_definite(
        nx in 1..14usize, ny in 1..14usize, log_ratio in -1.5..1.5f64,
        nu1 in 0.0..0.5f64, nu2 in 0.0..0.5f64, log_g in -2.0..2.0f64, seed in 1..1000u64,
    ) {
        // p A p > 0 for every p, and p A q = q A p.
        let one = Material::from_shear(1.0, nu1).unwrap();
        let two = Material::from_shear(10f64.powf(log_g), nu2).unwrap();
        let pair = MaterialPair::new(one, two).unwrap();
        let grid = Grid::new(nx, ny, 1.0, 10f64.powf(log_ratio)).unwrap();
        let operator = HalfSpaceOperator::new(pair, grid).unwrap();
        let p = Fields([1, 2, 3].map(|k| noise(grid.cells(), seed + k)));
        let q = Fields([4, 5, 6].map(|k| noise(grid.cells(), seed + k)));
        let (ap, aq) = (product(&operator, &p), product(&operator, &q));
        let dot = |a: &Fields, b: &Fields| -> f64 {
            a.0.iter().flatten().zip(b.0.iter().flatten()).map(|(a, b)| a * b).sum()
        };
        prop_assert!(dot(&p, &ap) > 0.0);
        let scale = dot(&p, &ap).max(dot(&q, &aq));
        prop_assert!((dot(&p, &aq) - dot(&q, &ap)).abs() < 1e-13 * scale);
    }
}

/// The sum of all waves is the first of the responses.
#[test]
fn the_influence_of_a_cell_of_a_period_is_that_of_its_response() {
    for (nx, ny) in [(2, 2), (2, 8), (12, 6), (30, 16)] {
        let grid = Grid::new(nx, ny, 0.1, 0.15).unwrap();
        let operator = PeriodicOperator::new(similar(), grid, Threads::One).unwrap();
        let [own, other] =
            [operator.normal_influence_of_a_cell(), operator.coefficients(0, 0).rows[2][2]];
        assert!(own > 0.0 && (own / other - 1.0).abs() < 1e-13, "{nx} {ny}: {own} {other}");
    }
}
