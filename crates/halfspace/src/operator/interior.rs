//! The stress inside a body below a grid of tractions, by convolution at each depth.

use super::length::Sizes;
use super::memory;
use super::plan::Plan;
use super::pool;
use super::product::{Term, Terms};
use super::spectrum::{Parity, Spectrum};
use super::{Axis, OperatorError, Threads, TractionField, Workspace};
use crate::{Grid, LoadedRectangle, Material, Point, Stress};
use carom_special::RangeError;

/// The stress at all points below the cell centres of a grid, at any depths.
///
/// The tractions act on this body, with z pointing into it. For body 2 of a pair the tangential
/// tractions change sign.
///
/// ```
/// use carom_halfspace::operator::{InteriorStress, Threads, TractionField};
/// use carom_halfspace::{Grid, Material};
/// let grid = Grid::new(16, 16, 0.1, 0.1)?;
/// let body = Material::from_young(208e3, 0.3)?;
/// let interior = InteriorStress::new(body, grid, Threads::One)?;
/// let pressure = vec![1.0; 256];
/// let field = interior.at_depth(0.05, TractionField::normal(&pressure))?;
/// assert!(field.stress(grid.index(8, 8)).zz < -0.98);
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
#[derive(Clone)]
pub struct InteriorStress {
    cell: LoadedRectangle,
    grid: Grid,
    plan: Plan,
}

/// The stress below every cell of a grid at one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct StressField {
    /// The depth z.
    pub depth: f64,
    /// sigma_xx of every cell, in the order of the grid.
    pub xx: Vec<f64>,
    /// sigma_yy.
    pub yy: Vec<f64>,
    /// sigma_zz.
    pub zz: Vec<f64>,
    /// sigma_xy.
    pub xy: Vec<f64>,
    /// sigma_yz.
    pub yz: Vec<f64>,
    /// sigma_zx.
    pub zx: Vec<f64>,
}

impl StressField {
    /// The stress below a cell, given by its index.
    ///
    /// # Panics
    /// If the grid has no cell with this index.
    #[must_use]
    pub fn stress(&self, cell: usize) -> Stress {
        Stress {
            xx: self.xx[cell],
            yy: self.yy[cell],
            zz: self.zz[cell],
            xy: self.xy[cell],
            yz: self.yz[cell],
            zx: self.zx[cell],
        }
    }

    /// The stresses below all cells, in the order of the grid.
    pub fn iter(&self) -> impl Iterator<Item = Stress> + '_ {
        (0..self.xx.len()).map(|cell| self.stress(cell))
    }
}

/// The six components in two groups of three, which are transformed together.
const GROUPS: [[Component; 3]; 2] =
    [[Component::Xx, Component::Yy, Component::Zz], [Component::Xy, Component::Yz, Component::Zx]];

#[derive(Debug, Clone, Copy)]
enum Component {
    Xx,
    Yy,
    Zz,
    Xy,
    Yz,
    Zx,
}

impl Component {
    const fn of(self, stress: &Stress) -> f64 {
        match self {
            Self::Xx => stress.xx,
            Self::Yy => stress.yy,
            Self::Zz => stress.zz,
            Self::Xy => stress.xy,
            Self::Yz => stress.yz,
            Self::Zx => stress.zx,
        }
    }

    /// Parities along x and y of this component due to a traction: each index x (y) of the
    /// component and of the traction changes the parity in x (y).
    const fn parity(self, by: Axis) -> [Parity; 2] {
        let odd_x = matches!(self, Self::Xy | Self::Zx) != matches!(by, Axis::X);
        let odd_y = matches!(self, Self::Xy | Self::Yz) != matches!(by, Axis::Y);
        [Parity::odd_if(odd_x), Parity::odd_if(odd_y)]
    }
}

impl InteriorStress {
    /// For a body of `material` under tractions on `grid`.
    ///
    /// # Errors
    /// [`OperatorError`] if the body is rigid, or the grid is too large for memory.
    pub fn new(material: Material, grid: Grid, threads: Threads) -> Result<Self, OperatorError> {
        let cell = LoadedRectangle::new(material, grid.cell())?;
        let sizes = Sizes::of(grid);
        let cells = grid.nx() as u128 * grid.ny() as u128;
        let tables = 8 * cells * (18 + 6) + 9 * sizes.symmetric_spectrum();
        memory::check(tables + sizes.workspace(3, threads))?;
        Ok(Self { cell, grid, plan: Plan::new(grid, threads) })
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The stress at `depth` below the centres of all cells.
    ///
    /// # Errors
    /// [`OperatorError`] for a depth that is not finite and >= 0, and for fields of another size
    /// than the grid or that are not finite.
    pub fn at_depth(
        &self,
        depth: f64,
        tractions: TractionField<'_>,
    ) -> Result<StressField, OperatorError> {
        RangeError::non_negative("depth", depth)?;
        tractions.check(self.grid.cells())?;
        Ok(self.field(depth, tractions, &mut Workspace::default()))
    }

    /// The stress at several depths, in the given order.
    ///
    /// # Errors
    /// As [`InteriorStress::at_depth`].
    pub fn at_depths(
        &self,
        depths: &[f64],
        tractions: TractionField<'_>,
    ) -> Result<Vec<StressField>, OperatorError> {
        for &depth in depths {
            RangeError::non_negative("depth", depth)?;
        }
        tractions.check(self.grid.cells())?;
        let mut workspace = Workspace::default();
        Ok(depths.iter().map(|&depth| self.field(depth, tractions, &mut workspace)).collect())
    }

    fn field(&self, depth: f64, load: TractionField<'_>, workspace: &mut Workspace) -> StressField {
        let zero = || vec![0.0; self.grid.cells()];
        let mut field = StressField {
            depth,
            xx: zero(),
            yy: zero(),
            zz: zero(),
            xy: zero(),
            yz: zero(),
            zx: zero(),
        };
        let given = load.by_axis();
        let axes: Vec<Axis> =
            Axis::ALL.into_iter().filter(|&axis| given[axis as usize].is_some()).collect();
        if axes.is_empty() {
            return field;
        }
        let inputs: Vec<&[f64]> = given.into_iter().flatten().collect();
        let unit = self.unit_stresses(depth);
        let [first, second] = GROUPS;
        let StressField { xx, yy, zz, xy, yz, zx, .. } = &mut field;
        self.group(first, &unit, &axes, &inputs, [xx, yy, zz], workspace);
        self.group(second, &unit, &axes, &inputs, [xy, yz, zx], workspace);
        field
    }

    /// Convolves one group of three components.
    fn group(
        &self,
        components: [Component; 3],
        unit: &[[Stress; 3]],
        axes: &[Axis],
        inputs: &[&[f64]],
        outputs: [&mut [f64]; 3],
        workspace: &mut Workspace,
    ) {
        let mut table = vec![0.0; self.grid.cells()];
        let spectra = components.map(|component| {
            let mut row = [None, None, None];
            for (slot, &axis) in row.iter_mut().zip(axes) {
                for (value, stresses) in table.iter_mut().zip(unit) {
                    *value = component.of(&stresses[axis as usize]);
                }
                *slot = Some(Spectrum::symmetric(
                    &self.plan,
                    |row: usize, values: &mut [f64]| {
                        values.copy_from_slice(&table[row * self.grid.nx()..][..values.len()]);
                    },
                    component.parity(axis),
                ));
            }
            row
        });
        let blocks = spectra.each_ref().map(|row| {
            row.each_ref().map(|slot| slot.as_ref().map(|spectrum| Term { spectrum, sign: 1.0 }))
        });
        let mut outputs = outputs;
        self.plan.product(inputs, &Terms { blocks: &blocks, unit: 1.0 }, &mut outputs, workspace);
    }

    /// The stresses due to unit tractions at the offsets `0..nx` by `0..ny`, source minus receiver.
    fn unit_stresses(&self, depth: f64) -> Vec<[Stress; 3]> {
        let (dx, dy) = (self.grid.dx(), self.grid.dy());
        let mut values = vec![[Stress::default(); 3]; self.grid.cells()];
        let fill = |(iy, row): (usize, &mut [[Stress; 3]])| {
            for (ix, value) in row.iter_mut().enumerate() {
                let at = Point { x: -(ix as f64) * dx, y: -(iy as f64) * dy, z: depth };
                *value = self.cell.unit_stresses(at);
            }
        };
        match self.plan.threads {
            Threads::One => values.chunks_mut(self.grid.nx()).enumerate().for_each(fill),
            Threads::Pool => pool::each_row(&mut values, self.grid.nx(), fill),
        }
        values
    }
}

impl std::fmt::Debug for InteriorStress {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("InteriorStress")
            .field("cell", &self.cell)
            .field("grid", &self.grid)
            .finish_non_exhaustive()
    }
}
