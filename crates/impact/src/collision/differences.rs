//! Derivatives of rebounds by differences, where no theory gives them: with a loss, coupling, or torsion.

use nalgebra::SMatrix;

use super::input::{INPUTS, OUTPUTS, Part};
use super::{Collision, CollisionError, CollisionSolver, Input, ReboundDerivatives};
use crate::motion::Motion;
use crate::oblique::Regime;
use crate::outcome::Outcome;

/// A rebound with derivatives by differences, and their errors.
#[derive(Debug, Clone, PartialEq)]
pub struct ReboundDifferences {
    /// The rebound and its derivatives.
    pub derivatives: ReboundDerivatives,
    /// The error of each derivative: how far those by the step and by its half are apart.
    pub errors: SMatrix<f64, OUTPUTS, INPUTS>,
}

impl Collision {
    /// The rebound of spheres or planes with its derivatives by differences of impacts of any solver: with a loss, with
    /// torsion, of dissimilar materials, by rings or on a grid. None for bodies of other shapes.
    ///
    /// Central differences with `step` and with its half, extrapolated; one-sided at the end of a range, such as at
    /// Poisson's ratio 1/2, and where one side of the step has other regimes in its log, which `is_at_change` tells. The step is a part of each input, of speeds one of the speed at the contact. With an error
    /// e of the solver the best is about the cube root of e: 1e-4 where the impact is exact, .02 by rings or with a
    /// viscous loss. The normal, and options of the collision, are kept; friction by the slip speed has the value of
    /// this impact.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::{AnalyticOrRings, Body, Collision, Input, Motion, NormalRestitution};
    /// use carom_laws::friction::Friction;
    /// let steel = Material::from_shear(80e9, 0.3)?;
    /// let ball = Body::sphere(0.01, steel, 0.0329)?.moving(Motion::new([9.0, 0.0, -1.0], [0.0; 3])?);
    /// let collision = Collision::new(ball, Body::plane(steel), Friction::new(0.1)?)?
    ///     .with_normal_restitution(NormalRestitution::new(0.8)?);
    /// let found = collision.differences(&AnalyticOrRings, 0.01)?.ok_or("spheres and planes")?;
    /// // It slides throughout: v_x' = v_x - f (1 + e) |v_z|.
    /// let by = found.derivatives.matrix[(0, Input::Friction.column())];
    /// assert!((by + 1.8).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Of the solver; [`CollisionError::Range`] unless the step is above 0 and at most 0.1.
    pub fn differences<S: CollisionSolver>(
        &self,
        solver: &S,
        step: f64,
    ) -> Result<Option<ReboundDifferences>, S::Error> {
        let holds = step > 0.0 && step <= 0.1;
        let checked = carom_special::RangeError::check("step", step, holds, "above 0, at most 0.1");
        checked.map_err(CollisionError::from)?;
        if (0..2).any(|i| Part::of(self, i).is_none()) {
            return Ok(None);
        }
        let outcome = solver.solve(self)?;
        let (motions, here) = (outcome.motions(), Course::of(&outcome));
        let mut is_at_change = false;
        // The spin of a plane is kept and has no effect.
        let mut matrix = SMatrix::<f64, OUTPUTS, INPUTS>::identity();
        let mut errors = SMatrix::<f64, OUTPUTS, INPUTS>::zeros();
        for input in Input::ALL {
            let Some((value, size)) = self.value(input) else { continue };
            let slope = |step: f64| self.slope(solver, input, value, step * size, &here);
            let (wide, narrow) = (slope(step)?, slope(0.5 * step)?);
            let change = narrow.value - wide.value;
            // The error of a central difference falls with the square of the step, that of a one-sided one with the step.
            let part = match (wide.is_central, narrow.is_central) {
                (true, true) => 1.0 / 3.0,
                (false, false) => 1.0,
                _ => 0.0,
            };
            matrix.set_column(input.column(), &(narrow.value + change * part));
            errors.set_column(input.column(), &change.abs());
            is_at_change |= wide.crosses || narrow.crosses;
        }
        let derivatives = ReboundDerivatives { motions, matrix, is_at_change };
        Ok(Some(ReboundDifferences { derivatives, errors }))
    }

    /// The difference by an input, one-sided where its range ends or the regimes change to one side.
    fn slope<S: CollisionSolver>(
        &self,
        solver: &S,
        input: Input,
        value: f64,
        step: f64,
        here: &Course,
    ) -> Result<Slope, S::Error> {
        let at = |value: f64| -> Result<Option<Course>, S::Error> {
            let Ok(moved) = self.with_input(input, value) else { return Ok(None) };
            solver.solve(&moved).map(|outcome| Some(Course::of(&outcome)))
        };
        let (above, below) = (at(value + step)?, at(value - step)?);
        let changes =
            |side: &Option<Course>| side.as_ref().is_some_and(|side| side.regimes != here.regimes);
        let (above_changes, below_changes) = (changes(&above), changes(&below));
        // Where both sides have other regimes, no side is the better one.
        let one_stays = above_changes != below_changes;
        let counted = |side: Option<Course>, changes: bool| {
            side.filter(|_| !(changes && one_stays)).map(|side| side.row)
        };
        let sides = [counted(above, above_changes), counted(below, below_changes)];
        let count = sides.iter().flatten().count();
        let [above, below] = sides.map(|side| side.unwrap_or(here.row));
        Ok(Slope {
            value: (above - below) / (count.max(1) as f64 * step),
            is_central: count == 2,
            crosses: above_changes || below_changes,
        })
    }
}

type Row = nalgebra::SVector<f64, OUTPUTS>;

/// The motions after an impact, and its regimes in order.
struct Course {
    row: Row,
    regimes: Vec<Regime>,
}

impl Course {
    fn of(outcome: &Outcome) -> Self {
        let log = outcome.rebound().map_or(&[][..], |rebound| &rebound.log);
        let regimes = log.iter().map(|entry| entry.regime).collect();
        Self { row: row(&outcome.motions()), regimes }
    }
}

/// A difference.
struct Slope {
    value: Row,
    is_central: bool,
    /// Whether a side has other regimes.
    crosses: bool,
}

fn row([one, two]: &[Motion; 2]) -> Row {
    let all = [&one.velocity, &one.spin, &two.velocity, &two.spin];
    Row::from_iterator(all.into_iter().flat_map(|vector| vector.iter().copied()))
}
