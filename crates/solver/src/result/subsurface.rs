//! Stresses and displacements below the contact.

use carom_halfspace::{Displacement, LoadedRectangle, Material, Point, Stress, Traction};
use carom_special::RangeError;

use crate::state::ContactState;

/// One of the bodies below its contact: stress and displacement at any point, summed over all cells
/// in contact.
///
/// All quantities are in the common axes: body 1 is where z > 0, body 2 where z < 0; tension is
/// positive. For many points below the centres of all cells
/// [`carom_halfspace::operator::InteriorStress`] is faster.
///
/// ```
/// use carom_halfspace::{Grid, Material, Point};
/// use carom_solver::{ContactState, Subsurface};
/// let steel = Material::from_young(208e3, 0.3)?;
/// let mut state = ContactState::apart(Grid::new(20, 20, 0.1, 0.1)?);
/// state.pressure.values_mut().fill(1.0);
/// let below = Subsurface::of_body_2(&state, steel)?;
/// let stress = below.stress(Point { x: 0.0, y: 0.0, z: -0.01 })?;
/// assert!((stress.zz + 1.0).abs() < 1e-3);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Subsurface {
    cell: LoadedRectangle,
    /// The sign of z inside the body: 1 for body 1, -1 for body 2.
    inward: f64,
    /// Loaded cells: centre, and tractions on this body.
    loads: Vec<(f64, f64, Traction)>,
}

impl Subsurface {
    /// Below the surface of body 1, which has this material.
    ///
    /// # Errors
    /// [`RangeError`] for a rigid body.
    pub fn of_body_1(state: &ContactState, material: Material) -> Result<Self, RangeError> {
        Self::new(state, material, 1.0)
    }

    /// Below the surface of body 2, which has this material.
    ///
    /// # Errors
    /// [`RangeError`] for a rigid body.
    pub fn of_body_2(state: &ContactState, material: Material) -> Result<Self, RangeError> {
        Self::new(state, material, -1.0)
    }

    fn new(state: &ContactState, material: Material, inward: f64) -> Result<Self, RangeError> {
        let grid = state.pressure.grid();
        let cell = LoadedRectangle::new(material, grid.cell())?;
        let tractions = state.traction_x.values().iter().zip(state.traction_y.values());
        let loads = grid.centres().zip(tractions.zip(state.pressure.values()));
        let loads = loads.filter(|(_, (_, p))| **p > 0.0).map(|((at_x, at_y), ((x, y), p))| {
            // The tractions on body 2 are opposite to those on body 1; its own z axis is mirrored.
            (at_x, at_y, Traction { x: inward * x, y: inward * y, normal: *p })
        });
        Ok(Self { cell, inward, loads: loads.collect() })
    }

    /// The stress at a point.
    ///
    /// # Errors
    /// [`RangeError`] for a point outside the body, and for a point at which the stress is
    /// infinite: on the surface at the edges of cells.
    pub fn stress(&self, at: Point) -> Result<Stress, RangeError> {
        self.check_inside(at)?;
        let mut sum = Stress::default();
        for (x, y, load) in &self.loads {
            let part = self.cell.stress(*load, self.seen_from(*x, *y, at));
            sum = sum + part.map_err(|error| self.in_space(error))?;
        }
        Ok(Stress { yz: self.inward * sum.yz, zx: self.inward * sum.zx, ..sum })
    }

    /// The displacement of this body at a point.
    ///
    /// # Errors
    /// [`RangeError`] for a point outside the body.
    pub fn displacement(&self, at: Point) -> Result<Displacement, RangeError> {
        self.check_inside(at)?;
        let mut sum = Displacement::default();
        for (x, y, load) in &self.loads {
            let part = self.cell.displacement(*load, self.seen_from(*x, *y, at));
            sum = sum + part.map_err(|error| self.in_space(error))?;
        }
        Ok(Displacement { w: self.inward * sum.w, ..sum })
    }

    /// The stresses at these depths below the surface point (x, y).
    ///
    /// # Errors
    /// As [`Subsurface::stress`].
    pub fn along_normal(
        &self,
        x: f64,
        y: f64,
        depths: impl IntoIterator<Item = f64>,
    ) -> Result<Vec<Stress>, RangeError> {
        depths
            .into_iter()
            .map(|depth| self.stress(Point { x, y, z: self.inward * depth }))
            .collect()
    }

    fn check_inside(&self, at: Point) -> Result<(), RangeError> {
        let allowed = if self.inward > 0.0 { ">= 0 in body 1" } else { "<= 0 in body 2" };
        RangeError::check("z", at.z, self.inward * at.z >= 0.0, allowed).map(|_| ())
    }

    /// An error in the body's own axes, converted to the common axes.
    fn in_space(&self, error: RangeError) -> RangeError {
        let sign = if error.field == "z" { self.inward } else { 1.0 };
        RangeError { value: sign * error.value, ..error }
    }

    /// The point in the body's own axes, relative to the centre of a cell.
    fn seen_from(&self, x: f64, y: f64, at: Point) -> Point {
        Point { x: at.x - x, y: at.y - y, z: self.inward * at.z }
    }
}
