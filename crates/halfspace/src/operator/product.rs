//! The product of a block matrix of spectra with the given fields, for the requested results.

use super::plan::Plan;
use super::precision::Real;
use super::spectrum::Spectrum;
use super::{Axis, DisplacementField, OperatorError, TractionField, Workspace};

/// One entry of the block matrix of spectra: `sign` times the spectrum.
#[derive(Clone, Copy)]
pub(crate) struct Term<'a, T = f64> {
    pub(crate) spectrum: &'a Spectrum<T>,
    pub(crate) sign: T,
}

/// The block matrix: `blocks[output][input]`; `None` means zero.
pub(crate) type Matrix<'a, T> = [[Option<Term<'a, T>>; 3]; 3];

/// The terms of a product: `unit` times a block matrix.
#[derive(Clone, Copy)]
pub(crate) struct Terms<'a, T = f64> {
    pub(crate) blocks: &'a Matrix<'a, T>,
    pub(crate) unit: f64,
}

/// Checks the fields and computes the product, `unit` times the terms.
pub(crate) fn apply<'s, T: Real>(
    plan: &Plan<T>,
    (term, unit): (impl Fn(Axis, Axis) -> Result<Option<Term<'s, T>>, OperatorError>, f64),
    tractions: TractionField<'_>,
    displacements: DisplacementField<'_>,
    workspace: &mut Workspace,
) -> Result<(), OperatorError> {
    let cells = plan.sizes.nx * plan.sizes.ny;
    tractions.check(cells)?;
    displacements.check(cells)?;

    let mut inputs: [&[f64]; 3] = [&[]; 3];
    let mut sources = [Axis::X; 3];
    let mut given = 0;
    for (axis, values) in Axis::ALL.into_iter().zip(tractions.by_axis()) {
        if let Some(values) = values {
            (inputs[given], sources[given]) = (values, axis);
            given += 1;
        }
    }
    let mut blocks: Matrix<'_, T> = [[None; 3]; 3];
    let mut outputs: [&mut [f64]; 3] = [&mut [], &mut [], &mut []];
    let mut wanted = 0;
    for (receiver, field) in displacements.by_axis().into_iter().enumerate() {
        let Some(field) = field else { continue };
        for input in 0..given {
            blocks[wanted][input] = term(Axis::ALL[receiver], sources[input])?;
        }
        outputs[wanted] = field;
        wanted += 1;
    }
    // Nothing below this line can fail.
    let terms = Terms { blocks: &blocks, unit };
    reduced(plan, &inputs[..given], &terms, &mut outputs[..wanted], workspace);
    Ok(())
}

/// The product without inputs that are zero and without outputs that no other input affects: if one
/// tangential traction is zero everywhere, a shift along the other axis costs half.
pub(crate) fn reduced<T: Real>(
    plan: &Plan<T>,
    inputs: &[&[f64]],
    terms: &Terms<'_, T>,
    outputs: &mut [&mut [f64]],
    workspace: &mut Workspace,
) {
    let mut fields: [&[f64]; 3] = [&[]; 3];
    let mut columns = [0; 3];
    let mut given = 0;
    for (column, &values) in inputs.iter().enumerate() {
        // NaN does not count as zero.
        if values.iter().any(|&value| value != 0.0) {
            (fields[given], columns[given]) = (values, column);
            given += 1;
        }
    }
    let mut reached: [&mut [f64]; 3] = [&mut [], &mut [], &mut []];
    let mut used: Matrix<'_, T> = [[None; 3]; 3];
    let mut count = 0;
    for (row, field) in outputs.iter_mut().enumerate() {
        let of_row: [_; 3] =
            std::array::from_fn(
                |at| if at < given { terms.blocks[row][columns[at]] } else { None },
            );
        if of_row.iter().all(Option::is_none) {
            field.fill(0.0);
        } else {
            (reached[count], used[count]) = (field, of_row);
            count += 1;
        }
    }
    if count > 0 {
        let used = Terms { blocks: &used, unit: terms.unit };
        plan.product(&fields[..given], &used, &mut reached[..count], workspace);
    }
}

#[cfg(test)]
mod tests {
    use super::super::length::Sizes;
    use super::super::workspace::Space;
    use super::*;
    use crate::operator::{
        HalfSpaceOperator, PeriodicOperator, Preconditioner, ROUGHNESS, SurfaceOperator, Threads,
    };
    use crate::{Grid, Material, MaterialPair};
    use Axis::{Normal, X, Y};

    type Fields = [Vec<f64>; 3];
    /// Fields transformed there, and fields transformed back.
    type Counts = (usize, usize);

    const SIMILAR: [f64; 2] = [0.3, 0.3];
    const NO_CONTRACTION: [f64; 2] = [0.0, 0.0];
    const DISSIMILAR: [f64; 2] = [0.1, 0.45];

    fn grid() -> Grid {
        Grid::new(12, 10, 0.1, 0.2).unwrap()
    }

    fn pair(poisson: [f64; 2]) -> MaterialPair {
        let [one, two] = poisson.map(|nu| Material::from_shear(1.5, nu).unwrap());
        MaterialPair::new(one, two).unwrap()
    }

    /// Tractions along the loaded axes, `others` times tractions along the others.
    fn loads(loaded: &[Axis], others: f64) -> Fields {
        Axis::ALL.map(|axis| {
            let part = if loaded.contains(&axis) { 1.0 } else { others };
            let value = |i: usize| part * ((1.7 * i as f64 + axis as u8 as f64).sin() + 0.01);
            (0..grid().cells()).map(value).collect()
        })
    }

    /// The numbers of fields for which a fresh workspace has room after a product; results have the room of what is given.
    fn counts<T: Real>(space: &Space<T>, sizes: Sizes) -> Counts {
        let there = space.lanes.first().map_or(0, |lane| lane.blocks.len());
        let field = sizes.columns().next_multiple_of(T::BLOCK) * sizes.ny;
        let most = space.tiles.first().map_or(0, |tile| tile.len() / field);
        (there / (T::BLOCK * sizes.py), most)
    }

    /// All displacements, and how many fields were transformed.
    fn displaced(operator: &dyn SurfaceOperator, sizes: Sizes, load: &Fields) -> (Fields, Counts) {
        // Results that are left out are written nevertheless.
        let mut fields = [(); 3].map(|()| vec![f64::NAN; grid().cells()]);
        let [u, v, w] = &mut fields;
        let displacements = DisplacementField::full(u, v, w);
        let mut workspace = Workspace::default();
        let tractions = TractionField::full(&load[0], &load[1], &load[2]);
        operator.apply(tractions, displacements, &mut workspace).unwrap();
        (fields, counts(&workspace.double, sizes))
    }

    /// Only the loaded fields are transformed there, only the reached ones back; what comes is the
    /// mean of two products in which no field vanishes.
    fn check(
        product: impl Fn(&Fields) -> (Fields, Counts),
        loaded: &[Axis],
        reached: &[Axis],
        tolerance: f64,
    ) {
        let (got, counts) = product(&loads(loaded, 0.0));
        let there = if reached.is_empty() { 0 } else { loaded.len() };
        assert_eq!(counts, (there, reached.len()), "{loaded:?} reach {reached:?}");
        let (one, _) = product(&loads(loaded, 1.0));
        let (other, _) = product(&loads(loaded, -1.0));
        for axis in Axis::ALL {
            let field = axis as usize;
            let vanishes = got[field].iter().all(|value| *value == 0.0);
            assert_eq!(vanishes, !reached.contains(&axis), "{loaded:?} reach {axis:?}");
            let most = one[field].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            for (i, got) in got[field].iter().enumerate() {
                let want = 0.5 * (one[field][i] + other[field][i]);
                assert!(
                    (got - want).abs() <= tolerance * most,
                    "{loaded:?}, {axis:?}: {got} {want}"
                );
            }
        }
    }

    /// The loaded components of each drive, and the displacements that they cause: a normal force,
    /// a shift along x, both, and a shift in any direction.
    fn drives(poisson: [f64; 2], expected: [(&[Axis], &[Axis]); 5]) {
        let half_space = HalfSpaceOperator::new(pair(poisson), grid()).unwrap();
        let periodic = PeriodicOperator::new(pair(poisson), grid(), Threads::One).unwrap();
        for (loaded, reached) in expected {
            let of_half_space = |load: &Fields| displaced(&half_space, Sizes::of(grid()), load);
            let of_period = |load: &Fields| displaced(&periodic, Sizes::of_period(grid()), load);
            check(of_half_space, loaded, reached, 1e-14);
            check(of_period, loaded, reached, 1e-14);
        }
    }

    #[test]
    fn without_lateral_contraction_each_component_stands_by_itself() {
        drives(
            NO_CONTRACTION,
            [
                (&[], &[]),
                (&[X], &[X]),
                (&[Y], &[Y]),
                (&[X, Y], &[X, Y]),
                // The difference of equal bodies: pressures displace nothing along the surface.
                (&[X, Normal], &[X, Normal]),
            ],
        );
    }

    #[test]
    fn similar_bodies_leave_out_what_pressures_do_along_the_surface() {
        drives(
            SIMILAR,
            [
                (&[], &[]),
                (&[Normal], &[Normal]),
                (&[X], &[X, Y]),
                (&[X, Y], &[X, Y]),
                (&[Y, Normal], &[X, Y, Normal]),
            ],
        );
    }

    #[test]
    fn dissimilar_bodies_leave_out_vanishing_tractions_alone() {
        drives(
            DISSIMILAR,
            [
                (&[], &[]),
                (&[Normal], &[X, Y, Normal]),
                (&[X], &[X, Y, Normal]),
                (&[X, Y], &[X, Y, Normal]),
                (&[X, Y, Normal], &[X, Y, Normal]),
            ],
        );
    }

    #[test]
    fn the_inverse_on_a_torus_leaves_out_the_same() {
        let sizes = Sizes::of_torus(grid());
        for poisson in [NO_CONTRACTION, SIMILAR] {
            let operator = HalfSpaceOperator::new(pair(poisson), grid()).unwrap();
            let inverted = |inverse: &dyn Preconditioner, load: &Fields| {
                let mut workspace = Workspace::default();
                let mut fields = [(); 3].map(|()| vec![f64::NAN; grid().cells()]);
                let [x, y, normal] = &mut fields;
                normal.fill(0.0);
                let displacement = [Some(&load[0][..]), Some(&load[1][..])];
                inverse.traction(displacement, [Some(x), Some(y)], &mut workspace);
                (fields, workspace)
            };
            let (inverse, rough) = (operator.inverse().unwrap(), operator.rough_inverse().unwrap());
            let exact = |load: &Fields| {
                let (fields, workspace) = inverted(&*inverse, load);
                (fields, counts(&workspace.double, sizes))
            };
            let single = |load: &Fields| {
                let (fields, workspace) = inverted(&*rough, load);
                (fields, counts(&workspace.single, sizes))
            };
            let alone = poisson == NO_CONTRACTION;
            let cases: [(&[Axis], &[Axis]); 4] = [
                (&[], &[]),
                (&[X], if alone { &[X] } else { &[X, Y] }),
                (&[Y], if alone { &[Y] } else { &[X, Y] }),
                (&[X, Y], &[X, Y]),
            ];
            for (loaded, reached) in cases {
                check(exact, loaded, reached, 1e-14);
                check(single, loaded, reached, 1e-6);
            }
        }
    }

    /// Error of a rough product, over what [`ROUGHNESS`] is a part of.
    fn roughness(operator: &HalfSpaceOperator, load: &Fields) -> f64 {
        let tractions = TractionField::full(&load[0], &load[1], &load[2]);
        let zero = || load.each_ref().map(|field| vec![0.0; field.len()]);
        let ([mut exact, mut rough], mut workspace) = ([zero(), zero()], Workspace::default());
        let [u, v, w] = &mut exact;
        let into = DisplacementField::full(u, v, w);
        operator.apply(tractions, into, &mut workspace).unwrap();
        let [u, v, w] = &mut rough;
        let into = DisplacementField::full(u, v, w);
        operator.apply_roughly(tractions, into, &mut workspace).unwrap();
        let most = exact.iter().flatten().fold(0.0_f64, |most, u| most.max(u.abs()));
        let pairs = exact.iter().flatten().zip(rough.iter().flatten());
        let off = pairs.fold(0.0_f64, |off, (one, other)| off.max((one - other).abs()));
        // Scaled, as squares of great tractions overflow.
        let greatest = load.iter().flatten().fold(0.0_f64, |most, t| most.max(t.abs()));
        let squares: f64 = load.iter().flatten().map(|t| (t / greatest).powi(2)).sum();
        let own = operator.coefficients(0, 0).rows;
        let own = (own[0][0] + own[1][1] + own[2][2]) / 3.0;
        off / (most + own * greatest * squares.sqrt())
    }

    /// Smooth tractions, those that change sign from cell to cell in any way, and one alone.
    fn tractions(nx: usize, cells: usize, kind: usize) -> Fields {
        let sign = |even: bool| if even { 1.0 } else { -1.0 };
        [0.0, 1.0, 2.0].map(|phase: f64| {
            let value = |i: usize| {
                let (x, y) = (i % nx, i / nx);
                match kind {
                    0 => 1.0 + (1.7 * i as f64 + phase).sin(),
                    1 => sign(x % 2 == 0),
                    2 => sign(y % 2 == 0),
                    3 => sign((x + y) % 2 == 0),
                    4 => sign((x / 2 + y) % 2 == 0),
                    5 => 1e-7 + sign(x % 2 == 0),
                    _ => f64::from(u8::from(i == cells / 3)),
                }
            };
            (0..cells).map(value).collect()
        })
    }

    /// Rough products have their stated error, also where displacements are small beside tractions, and where values are
    /// far from one.
    #[test]
    fn rough_products_have_their_stated_error() {
        for (nx, ny, times) in [(12, 9, 1.0), (64, 61, 1e200), (96, 96, 1e-200), (256, 256, 1.0)] {
            let grid = Grid::new(nx, ny, 0.1, 0.2).unwrap();
            for poisson in [NO_CONTRACTION, SIMILAR, DISSIMILAR] {
                let operator = HalfSpaceOperator::new(pair(poisson), grid).unwrap();
                for kind in 0..7 {
                    let load = tractions(nx, nx * ny, kind).map(|field| {
                        field.into_iter().map(|value| times * value).collect::<Vec<_>>()
                    });
                    let error = roughness(&operator, &load);
                    // The rest is left for fields that no one has looked at.
                    assert!(error > 0.0 && error < ROUGHNESS / 4.0, "{nx} {kind}: {error:e}");
                }
            }
        }
    }

    /// Numbers are measured by the greatest of any sign.
    #[test]
    fn rough_products_of_reversed_tractions_are_reversed() {
        let grid = Grid::new(12, 9, 0.1, 0.2).unwrap();
        let operator = HalfSpaceOperator::new(pair(DISSIMILAR), grid).unwrap();
        let load = tractions(12, grid.cells(), 0);
        let reversed = load.each_ref().map(|field| field.iter().map(|value| -value).collect());
        assert!(reversed.iter().flatten().all(|value: &f64| *value <= 0.0));
        assert_eq!(roughness(&operator, &reversed), roughness(&operator, &load));
    }
}
