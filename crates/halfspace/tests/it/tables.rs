//! Tables of influence coefficients: formats, Betti's theorem, definiteness, coarser grids.

use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, InflcfUnits, KernelBlock, KernelOperator,
    OperatorError, SurfaceOperator, TabulatedKernel, Threads, TractionField,
};
use carom_halfspace::{Coefficients, Grid, Material, MaterialPair, Offset, PointInfluence};
use std::fmt::Write as _;

/// Shear moduli and Poisson's ratios whose pair couples normal and tangential directions.
fn dissimilar() -> MaterialPair {
    let one = Material::from_shear(2.0, 0.1).unwrap();
    let two = Material::from_shear(3.0, 0.45).unwrap();
    MaterialPair::new(one, two).unwrap()
}

fn half_space(grid: Grid) -> HalfSpaceOperator {
    HalfSpaceOperator::new(dissimilar(), grid).unwrap()
}

fn table_of(operator: &dyn SurfaceOperator) -> TabulatedKernel {
    TabulatedKernel::from_function(operator.grid(), |n, m| operator.coefficients(n, m)).unwrap()
}

/// The half-space in the format of CONTACT, from the influence of point loads far from the source and of cells near
/// it: lengths in millimetres, offsets receiver minus source.
fn inflcf(grid: Grid, more: usize) -> String {
    let (mx, my) = (grid.nx() + more, grid.ny() + more);
    let larger = Grid::new(mx, my, grid.dx(), grid.dy()).unwrap();
    let (own, shear) = (half_space(larger), 2.0 * dissimilar().shear_modulus());
    let [dx, dy] = [grid.dx(), grid.dy()].map(|width| 1e3 * width);
    let mut text = format!(
        "% influence of cells\n 1  2  0 0 0 0 % nmatrix, iaconvex\n 0 312 0 0\n\n 1 0 % symmetry\n {mx} {my} {dx} {dy} 0\n"
    );
    for iy in 1 - my as i32..my as i32 {
        writeln!(text, "% offset is= {iy}\n% ix x  n-displacements").unwrap();
        for ix in 0..mx as i32 {
            let a = own.coefficients(-ix, -iy).rows;
            write!(text, "{ix} {}", f64::from(ix) * dx).unwrap();
            for of in [2, 0, 1] {
                for by in [2, 0, 1] {
                    let number = format!("{:.16e}", 1e3 * shear * a[of][by]);
                    write!(text, " {}", number.replace('e', "D")).unwrap();
                }
            }
            text.push('\n');
        }
    }
    text
}

fn units() -> InflcfUnits {
    InflcfUnits::new(1e-3, 2.0 * dissimilar().shear_modulus()).unwrap()
}

fn assert_same(one: &TabulatedKernel, other: &dyn SurfaceOperator, tolerance: f64) {
    let largest = other.coefficients(0, 0).largest();
    let (nx, ny) = (one.grid().nx() as i32, one.grid().ny() as i32);
    for m in 1 - ny..ny {
        for n in 1 - nx..nx {
            let pairs = one.coefficients(n, m).rows.into_iter().flatten();
            for (got, want) in pairs.zip(other.coefficients(n, m).rows.into_iter().flatten()) {
                assert!((got - want).abs() <= tolerance * largest, "{n} {m}: {got} {want}");
            }
        }
    }
}

#[test]
fn a_file_of_contact_gives_the_half_space_in_si_units() {
    let grid = Grid::new(5, 4, 2e-4, 3e-4).unwrap();
    for more in [0, 3] {
        let kernel = TabulatedKernel::from_inflcf(grid, &inflcf(grid, more), units()).unwrap();
        assert_same(&kernel, &half_space(grid), 1e-14);
    }
}

/// Signs of a file do not follow from our own table: pressure on body 1, z into it, pulls the surface of the body
/// that resists shear less towards the load (4.5a), at receiver minus source > 0 against x.
#[test]
fn signs_of_a_file_are_those_of_point_loads() {
    let grid = Grid::new(8, 8, 1e-3, 1e-3).unwrap();
    let kernel = TabulatedKernel::from_inflcf(grid, &inflcf(grid, 0), units()).unwrap();
    let area = grid.cell_area();
    for (n, m) in [(7, 0), (-6, 3), (2, -7), (0, 7)] {
        let far = PointInfluence::new(dissimilar());
        let want = far.coefficients(Offset { x: f64::from(n) * 1e-3, y: f64::from(m) * 1e-3 });
        let want = want.unwrap().rows.into_iter().flatten();
        for (got, want) in kernel.coefficients(n, m).rows.into_iter().flatten().zip(want) {
            assert!((got - area * want).abs() < 2e-2 * area / (1e-3 * 7.0), "{n} {m}");
        }
    }
    // K > 0: body 1 has the smaller Poisson's ratio and modulus.
    let text = inflcf(grid, 0);
    let line = text.lines().find(|line| line.starts_with("1 1 ")).unwrap();
    let numbers: Vec<f64> =
        line.split_whitespace().map(|word| word.replace('D', "e").parse().unwrap()).collect();
    assert!(numbers[5] < 0.0 && numbers[3] > 0.0, "{line}");
}

#[test]
fn damaged_files_are_refused_by_line() {
    let grid = Grid::new(3, 2, 2e-4, 3e-4).unwrap();
    let good = inflcf(grid, 0);
    let told = |text: &str| match TabulatedKernel::from_inflcf(grid, text, units()).unwrap_err() {
        OperatorError::Table { line, reason } => format!("{line}: {reason}"),
        other => panic!("{other}"),
    };
    let changed = |from: &str, to: &str| told(&good.replacen(from, to, 1));
    for (said, part) in [
        (changed(" 1  2  0", " 7  2  0"), "2: 7 matrices"),
        (changed(" 0 312", " 1 312"), "3: 1 and 312: must be 0 and 312"),
        (changed(" 0 312", " 0 123"), "3: 0 and 123"),
        (changed(" 1 0 %", " 0 0 %"), "5: 0 and 0: must be 1 and 0"),
        (changed("\n 3 2 ", "\n 2 2 "), "6: mx is 2"),
        (changed("\n 3 2 ", "\n 3 2.5 "), "6: my is 2.5"),
        (changed(" 3 2 0.2 ", " 3 2 0.21 "), "6: dx is 0.00021 m"),
        (changed("\n2 ", "\n1 "), "11: it begins with 1, not with 2"),
        (told(""), "1: the file ends before number of matrices"),
        (told(&good[..good.len() - 30]), "numbers, not 11"),
        (told(good.rsplit_once("% offset").unwrap().0), "0 columns and 1 rows"),
    ] {
        assert!(said.contains(part), "{said}");
    }
    let word = good.replacen("D", "x", 1);
    assert!(told(&word).contains("is not a finite number"), "{}", told(&word));
    assert!(InflcfUnits::new(0.0, 1.0).unwrap_err().field == "length");
    assert!(InflcfUnits::new(1.0, f64::NAN).unwrap_err().field == "shear_modulus");
}

fn block(name: &str, size: [usize; 2], value: impl Fn(usize, usize) -> f64) -> KernelBlock {
    let row = |m| (0..size[0]).map(|n| value(n, m)).collect();
    KernelBlock::new(name, &(0..size[1]).map(row).collect::<Vec<Vec<f64>>>()).unwrap()
}

#[test]
fn blocks_of_a_quarter_or_of_all_offsets_give_the_half_space() {
    let grid = Grid::new(5, 4, 0.2, 0.3).unwrap();
    let own = half_space(grid);
    let names = ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"];
    let blocks = |size: [usize; 2], first: [i32; 2]| -> Vec<KernelBlock> {
        let value = |place: usize, n: usize, m: usize| {
            own.coefficients(n as i32 + first[0], m as i32 + first[1]).rows[place / 3][place % 3]
        };
        let one = |(place, name): (usize, &&str)| block(name, size, |n, m| value(place, n, m));
        names.iter().enumerate().map(one).collect()
    };
    for blocks in [blocks([5, 4], [0, 0]), blocks([9, 7], [-4, -3])] {
        let kernel = TabulatedKernel::from_blocks(grid, &blocks).unwrap();
        assert_same(&kernel, &own, 0.0);
    }
}

#[test]
fn wrong_blocks_are_named() {
    let told = |error: OperatorError| error.to_string();
    for (error, want) in [
        (KernelBlock::new("ww", &[vec![1.0]]), "block \"ww\": its name must be one of xx, xy"),
        (KernelBlock::new("zz", &[]), "block \"zz\": it has no number"),
        (KernelBlock::new("zz", &[vec![1.0, 2.0], vec![1.0]]), "row 2 has 1 numbers, row 1 has 2"),
        (KernelBlock::new("zz", &[vec![f64::NAN]]), "row 1, column 1 is NaN"),
    ] {
        let said = told(error.unwrap_err());
        assert!(said.contains(want), "{said}");
    }
    let grid = Grid::new(3, 2, 1.0, 1.0).unwrap();
    let zz = |size| block("zz", size, |_, _| 1.0);
    let xz = |of_zero: f64| block("xz", [3, 2], move |n, _| if n == 0 { of_zero } else { 1.0 });
    for (blocks, want) in [
        (vec![], "block \"zz\": it is missing"),
        (vec![zz([4, 2])], "4 columns and 2 rows: must have 3 and 2, or 5 and 3"),
        (vec![zz([3, 2]), zz([3, 2])], "given twice"),
        (vec![zz([3, 2]), block("xx", [5, 3], |_, _| 1.0)], "block \"xx\": it has 5 columns"),
        (vec![xz(0.5)], "xz is 0.5 at 0 columns and 0 rows: must be 0"),
    ] {
        let said = told(TabulatedKernel::from_blocks(grid, &blocks).unwrap_err());
        assert!(said.contains(want), "{said}");
    }
    assert!(TabulatedKernel::from_blocks(grid, &[xz(0.0)]).is_ok());
    let csv = "columns,rows,yz\n0,0,0\n1,0,2\n2,0,0\n0,1,0\n1,1,0\n2,1,0\n";
    let said = told(TabulatedKernel::from_csv(grid, csv).unwrap_err());
    assert!(said.contains("yz is 2 at 1 columns and 0 rows"), "{said}");
}

#[test]
fn tables_that_break_bettis_theorem_are_refused_and_small_deviations_are_averaged() {
    let grid = Grid::new(6, 5, 0.2, 0.3).unwrap();
    let own = half_space(grid);
    let scale = own.coefficients(0, 0).largest();
    let changed = |i: usize, l: usize, by: f64| {
        TabulatedKernel::from_function(grid, |n, m| {
            let mut value = own.coefficients(n, m);
            if (n, m) == (2, -1) {
                value.rows[i][l] += by * scale;
            }
            value
        })
        .unwrap()
    };
    for (i, l, pair) in [(2, 0, ["zx", "xz"]), (0, 1, ["xy", "yx"]), (1, 1, ["yy", "yy"])] {
        match changed(i, l, 0.01).reciprocal().unwrap_err() {
            OperatorError::NotReciprocal { of, by, columns, rows, value, converse } => {
                // Named from either side.
                let (own, opposite) = ([of, by] == pair, [by, of] == pair);
                assert!(own || opposite, "{of} {by}");
                assert_eq!((columns.abs(), rows.abs()), (2, 1));
                assert!(((value - converse).abs() - 0.01 * scale).abs() < 1e-12);
            }
            other => panic!("{other}"),
        }
        let mean = changed(i, l, 5e-4).reciprocal().unwrap();
        let want = own.coefficients(2, -1).rows[i][l] + 2.5e-4 * scale;
        assert!((mean.coefficients(2, -1).rows[i][l] - want).abs() < 1e-12);
        assert!((mean.coefficients(-2, 1).rows[l][i] - want).abs() < 1e-12);
    }
    assert_same(&table_of(&own).reciprocal().unwrap(), &own, 0.0);
}

/// The smallest eigenvalue of a small dense symmetric matrix is negative exactly if elimination meets a negative
/// pivot (Sylvester).
fn is_definite(operator: &KernelOperator, axes: &[usize]) -> bool {
    let grid = operator.grid();
    let places: Vec<(usize, i32, i32)> = axes
        .iter()
        .flat_map(|axis| {
            (0..grid.cells())
                .map(|i| (*axis, (i % grid.nx()) as i32, (i / grid.nx()) as i32))
                .collect::<Vec<_>>()
        })
        .collect();
    let entry = |(i, x, y): (usize, i32, i32), (l, s, t): (usize, i32, i32)| {
        operator.coefficients(s - x, t - y).rows[i][l]
    };
    let mut matrix: Vec<Vec<f64>> =
        places.iter().map(|to| places.iter().map(|from| entry(*to, *from)).collect()).collect();
    for k in 0..matrix.len() {
        if matrix[k][k] <= 0.0 {
            return false;
        }
        let (pivots, rest) = matrix.split_at_mut(k + 1);
        for row in rest {
            let factor = row[k] / pivots[k][k];
            row.iter_mut().zip(&pivots[k]).for_each(|(own, pivot)| *own -= factor * pivot);
        }
    }
    true
}

#[test]
fn indefinite_tables_are_refused_exactly_as_elimination_finds() {
    let grid = Grid::new(7, 6, 0.2, 0.25).unwrap();
    let own = half_space(grid);
    let (mut refused, mut taken) = (0, 0);
    for k in 0..60 {
        // The own coefficient lowered, or a neighbour raised, by a part that grows: both make the matrix indefinite.
        let part = 0.012 * f64::from(k);
        for (axis, blocks, axes) in [
            (2, Blocks::Normal, &[2][..]),
            (0, Blocks::Tangential, &[0, 1][..]),
            (1, Blocks::All, &[0, 1, 2][..]),
        ] {
            let kernel = TabulatedKernel::from_function(grid, |n, m| {
                let mut value = own.coefficients(n, m);
                if (n, m) == (0, 0) {
                    value.rows[axis][axis] *= 1.0 - part;
                }
                value
            });
            let operator = KernelOperator::new(kernel.unwrap(), Threads::One).unwrap();
            let got = operator.check_definite(blocks);
            assert_eq!(got.is_ok(), is_definite(&operator, axes), "{part} {axis}: {got:?}");
            *if got.is_ok() { &mut taken } else { &mut refused } += 1;
        }
    }
    assert!(refused > 30 && taken > 30, "{refused} {taken}");
}

#[test]
fn tables_without_a_block_that_friction_needs_are_refused() {
    let grid = Grid::new(4, 4, 1.0, 1.0).unwrap();
    let own = half_space(grid);
    let kernel = TabulatedKernel::from_function(grid, |n, m| {
        let zz = own.coefficients(n, m).rows[2][2];
        Coefficients { rows: [[0.0; 3], [0.0; 3], [0.0, 0.0, zz]] }
    });
    let operator = KernelOperator::new(kernel.unwrap(), Threads::One).unwrap();
    operator.check_definite(Blocks::Normal).unwrap();
    for blocks in [Blocks::All, Blocks::Tangential] {
        let error = operator.check_definite(blocks).unwrap_err();
        assert_eq!(error, OperatorError::Zero { of: "displacement u", value: 0.0 });
    }
}

/// Coarse cells move by the mean of their cells under the same traction on all of them.
#[test]
fn coarser_tables_are_means_over_cells() {
    let grid = Grid::new(8, 6, 0.2, 0.3).unwrap();
    let fine = KernelOperator::new(table_of(&half_space(grid)), Threads::One).unwrap();
    let coarse = fine.coarser().unwrap().unwrap();
    let wide = coarse.grid();
    assert_eq!((wide.nx(), wide.ny(), wide.dx(), wide.dy()), (4, 3, 0.4, 0.6));
    let load = |n: usize, m: usize| (1.0 + n as f64).sin() + 0.3 * (m as f64);
    let on_wide: Vec<f64> = (0..12).map(|i| load(i % 4, i / 4)).collect();
    let on_fine: Vec<f64> = (0..48).map(|i| load(i % 8 / 2, i / 8 / 2)).collect();
    let displaced = |operator: &dyn SurfaceOperator, p: &[f64]| {
        let [mut u, mut v, mut w] = [(); 3].map(|()| vec![0.0; p.len()]);
        let fields = DisplacementField::full(&mut u, &mut v, &mut w);
        operator.apply(TractionField::full(p, p, p), fields, &mut operator.workspace()).unwrap();
        [u, v, w]
    };
    let (got, all) = (displaced(&*coarse, &on_wide), displaced(&fine, &on_fine));
    for (got, all) in got.iter().zip(&all) {
        for (i, got) in got.iter().enumerate() {
            let at = 2 * (i % 4) + 16 * (i / 4);
            let mean = 0.25 * (all[at] + all[at + 1] + all[at + 8] + all[at + 9]);
            assert!((got - mean).abs() < 1e-13, "{got} {mean}");
        }
    }
    let same = fine.coarsened_to(wide).unwrap();
    assert_eq!(same.coefficients(2, -1), coarse.coefficients(2, -1));
    let line = Grid::new(8, 1, 0.2, 0.3).unwrap();
    let line = KernelOperator::new(table_of(&half_space(line)), Threads::One).unwrap();
    let kept = line.coarsened_to(Grid::new(2, 1, 0.8, 0.3).unwrap()).unwrap();
    assert_eq!((kept.grid().nx(), kept.grid().dy()), (2, 0.3));
    let other = fine.coarsened_to(Grid::new(8, 6, 0.19, 0.3).unwrap()).unwrap_err();
    assert!(matches!(other, OperatorError::Range(error) if error.field == "dx"));
    let fewer = fine.on_fewer(3, 2).unwrap().unwrap();
    assert_eq!(fewer.coefficients(-2, 1), fine.coefficients(-2, 1));
    assert!(fine.on_fewer(9, 2).unwrap().is_err());
}
