//! Creep forces without the error of a mesh: what the table of creep forces is made of and judged by.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::creep::CreepCoefficients;
use carom_laws::creep::force::nodes;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_solver::{ContactProblem, Driven, Gap};

use crate::{Creepage, RollingDrive, RollingError, SteadyContact, Way};

/// Any values: forces over the friction limit depend on the scaled creepage alone.
const FRICTION: f64 = 0.3;
const FORCE: f64 = 1e-3;
/// Accuracy of a solve; the weights of the extrapolation raise it to some 3e-5.
const TOLERANCE: f64 = 1e-5;

/// Creep forces of an elliptical contact of like bodies, solved on three grids and extrapolated to none.
///
/// The error of the forces is of the first order in the width of the cells, with a part that goes up and down as cells
/// enter the ellipse. A line by least squares takes both away where the grids are chosen well: from 24, 27 and 48 cells
/// across the ellipse the forces are within 1e-4 of f F_z in the mean of 40 drawn contacts, and within 7e-4 at worst.
///
/// ```
/// use carom_rolling::ContinuumForces;
/// // At small creepages F_x is nearly x: by Vermeulen and Johnson 1 - (1 - x/3)^3.
/// let mut contact = ContinuumForces::new(1.0, 0.25, [24, 27, 48])?;
/// let [f_x, f_y, _] = contact.forces([0.1, 0.0, 0.0])?;
/// assert!((f_x / 0.1 - 0.97).abs() < 0.01 && f_y.abs() < 1e-4);
/// # Ok::<(), carom_rolling::RollingError>(())
/// ```
#[derive(Clone)]
pub struct ContinuumForces {
    ratio: f64,
    poisson: f64,
    grids: [OneGrid; 3],
}

impl ContinuumForces {
    /// A contact with the axis ratio a/b on grids of so many cells across the ellipse, each way.
    ///
    /// # Errors
    /// [`RollingError::Range`] for a ratio, a Poisson's ratio or a grid that the solver does not take, and for equal grids.
    pub fn new(ratio: f64, poisson: f64, meshes: [usize; 3]) -> Result<Self, RollingError> {
        super::check_ratio(ratio)?;
        let [one, two, three] = meshes;
        let differ = one != two || two != three;
        carom_special::RangeError::check("meshes", one as f64, differ, "three, not all equal")?;
        let new = |mesh| OneGrid::new(ratio, poisson, mesh);
        Ok(Self { ratio, poisson, grids: [new(one)?, new(two)?, new(three)?] })
    }

    /// F_x and F_y over f F_z, M_z over f F_z sqrt(ab), at a creepage scaled as [`nodes::scales`] says.
    ///
    /// # Errors
    /// [`RollingError`] if a solve fails.
    pub fn forces(&mut self, scaled: [f64; 3]) -> Result<[f64; 3], RollingError> {
        // The line through three forces by least squares, at a width of zero.
        let widths = [0, 1, 2].map(|i| self.grids[i].width);
        let mean = widths.iter().sum::<f64>() / 3.0;
        let spread: f64 = widths.iter().map(|width| (width - mean) * (width - mean)).sum();
        let mut sum = [0.0; 3];
        for grid in &mut self.grids {
            let mut found = grid.forces(scaled);
            if found.is_err() {
                // A solve that stalls from a neighbour converges from rest.
                *grid = OneGrid::new(self.ratio, self.poisson, grid.mesh)?;
                found = grid.forces(scaled);
            }
            let weight = 1.0 / 3.0 - mean * (grid.width - mean) / spread;
            let found = found?;
            (0..3).for_each(|part| sum[part] += weight * found[part]);
        }
        Ok(sum)
    }
}

/// A contact of shear modulus 1 and ab = 1 on one grid.
#[derive(Clone)]
struct OneGrid {
    mesh: usize,
    width: f64,
    contact: SteadyContact,
    scales: [f64; 3],
}

impl OneGrid {
    fn new(ratio: f64, poisson: f64, mesh: usize) -> Result<Self, RollingError> {
        let body = Material::from_shear(1.0, poisson)?;
        let pair = MaterialPair::new(body, body)?;
        let (a, b) = (ratio.sqrt(), 1.0 / ratio.sqrt());
        let gap = Hertz::from_ellipse_and_force(ContactEllipse::new(a, b)?, FORCE, pair)?;
        let gap = gap.curvature();
        let cells = mesh.saturating_add(4).next_multiple_of(4);
        let grid = Grid::new(cells, cells, 2.0 * a / mesh as f64, 2.0 * b / mesh as f64)?;
        let gap = Gap::from_function(grid, |x, y| gap.gap(x, y))?;
        let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION)?)?;
        let way = Way::new(grid.dx())?.with_spin_at(0.5)?;
        let contact = SteadyContact::new(&problem, way)?.within(TOLERANCE)?;
        let c = CreepCoefficients::by_table(ratio, poisson)?;
        let scales = nodes::scales(&c, ratio).map(|scale| FRICTION * FORCE / scale);
        Ok(Self { mesh, width: 1.0 / mesh as f64, contact, scales })
    }

    fn forces(&mut self, [x, y, phi]: [f64; 3]) -> Result<[f64; 3], RollingError> {
        let [along, across, spin] = self.scales;
        let creepage = Creepage { along: along * x, across: across * y, spin: spin * phi };
        let drive = RollingDrive::by_creepage(Driven::Load(FORCE), creepage);
        let load = self.contact.roll(&drive, &mut ())?.state.load();
        Ok([load.f_x, load.f_y, load.m_z].map(|load| load / (FRICTION * FORCE)))
    }
}
