//! Contact with Coulomb friction: normal and tangential problems solved in turn.
//!
//! The alternation is that of Panagiotopoulos. Pressures: preconditioned conjugate gradients on the cells in
//! contact. Tractions: Newton's method on the sets of sticking and slipping cells; if the sets do not settle,
//! projected gradients. If the coupling of dissimilar materials is strong or the alternation fails, Newton's method
//! solves for pressures and tractions together, with continuation in the coefficient of friction.
//!
//! Both problems start on coarser grids. The tractions of the last step stay on the finest grid, and the coarser
//! grids solve for their change (full approximation scheme). After a small step of given shifts between uncoupled
//! bodies the last tractions are the start.

mod alternation;
mod anderson;
mod boxed;
mod cone;
mod coupled;
mod coupling;
mod cut;
mod displacements;
mod error;
mod limits;
mod pass;
mod scratch;
mod sliding;
mod step;
mod without_friction;

pub use error::FrictionalError;
pub use scratch::FrictionalScratch;

use carom_special::RangeError;

/// Contact with Coulomb friction, one step of a load history at a time. Pressures are solved at the
/// last tractions, tractions at these pressures, and so on until both converge (Panagiotopoulos);
/// one pass suffices if the materials are not coupled. Pressures are found by preconditioned
/// conjugate gradients on an active set, tractions by Newton's method on the sets of sticking and
/// slipping cells. Both start from coarser grids if no better start is known. Where friction is too
/// great for that between coupled materials, pressures and tractions are found together by Newton's
/// method, with damped steps far from the solution.
///
/// Each of the four motions is prescribed as a shift or as a load. A load that friction cannot hold
/// is an error ([`FrictionalError::Slides`], [`FrictionalError::Turns`]). For dissimilar materials,
/// loads just below that limit are found by iterating on the shifts: all cells slip there, and the
/// shift grows with the inverse square root of the distance to the limit.
///
/// The cost of a step depends on the size of the contact, not of the window: on large grids it is
/// solved on a box around the contact. The box is chosen anew in each step by a solve on coarse
/// cells. If the bodies would overlap outside the box, the step is solved on the whole window.
///
/// Where static friction exceeds kinetic friction, a cell sticks up to `f_s p`. Once it slips its
/// bound is `f_k p`, at once within the step and in later steps for as long as it slips. After a
/// step without slip it is static again. Cells change to kinetic friction until none exceeds its
/// static bound, because each change loads its neighbours. This law has no length scale: the
/// traction at the tip of the slip area is unbounded, and static friction matters less on each
/// finer grid. In Cattaneo's problem with `f_s = 1.5 f_k` the tangential force exceeds that of
/// kinetic friction alone by 0.21, 0.13, 0.056, 0.028 % of the normal force on 16, 32, 64, 128
/// cells along a side: in proportion to the cell width. Results that depend on the difference
/// therefore depend on the grid.
///
/// Infinite friction is exact if the materials are not coupled. If they are, it is the limit of
/// Coulomb's law, computed with the coefficient 1e9. No cell is then in the state
/// [`CellState::Slip`](crate::CellState::Slip). Cells at the edge that would need tension to stick
/// are dragged along: the surfaces touch there at a pressure of 1e-9 of the traction, which opposes
/// their displacement. [`slip_since`](crate::ContactState::slip_since) gives this displacement, and
/// [`crate::dissipated`] its work.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Gap, Method};
/// let grid = Grid::new(48, 48, 0.05, 0.05)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.0)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.4)?)?;
/// let method = Frictional::default();
/// let mut scratch = method.scratch(&problem)?;
/// let mut pressed = ContactState::apart(grid);
/// let mut shifted = pressed.clone();
/// let to = |xi| Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
/// method.step(&problem, &pressed.clone(), &to(0.0), &mut pressed, &mut scratch, &mut ())?;
/// // Cattaneo: at xi = f zeta/2 and nu = 0 the stick area has half the depth, F_x/(f F_z) = 1 - 2^(-3/2).
/// method.step(&problem, &pressed, &to(0.2), &mut shifted, &mut scratch, &mut ())?;
/// let load = shifted.load();
/// assert!((load.f_x / (0.4 * load.f_z) - (1.0 - 0.5_f64.powf(1.5))).abs() < 3e-3);
/// assert!(shifted.count(CellState::Slip) > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frictional {
    tolerance: f64,
    iterations: usize,
    passes: usize,
}

impl Default for Frictional {
    /// Tolerance 1e-9, relative to the greatest displacement and to the greatest friction limit.
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 1000, passes: 300 }
    }
}

impl Frictional {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-13..=0.01).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-13 to 0.01")?;
        Ok(Self { tolerance, ..self })
    }

    /// Limits the iterations of each problem on each grid, and the passes of the alternation.
    ///
    /// # Errors
    /// [`RangeError`] unless both are at least 1.
    pub fn at_most(self, iterations: usize, passes: usize) -> Result<Self, RangeError> {
        RangeError::check("iterations", iterations as f64, iterations > 0, "at least 1")?;
        RangeError::check("passes", passes as f64, passes > 0, "at least 1")?;
        Ok(Self { iterations, passes, ..self })
    }
}
