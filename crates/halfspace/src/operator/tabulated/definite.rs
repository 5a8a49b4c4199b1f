//! Whether every traction does positive work on the displacements that it causes.

use super::KernelOperator;
use crate::operator::{
    Axis, Blocks, DisplacementField, OperatorError, Preconditioner, SurfaceOperator, TractionField,
    Workspace,
};

/// Residual, relative to the load, at which the search ends.
const SOLVED: f64 = 1e-9;
/// Most products of the search.
const MOST: usize = 300;
/// Work relative to that of the first traction, times its share of the load, that counts as round-off.
const ROUND_OFF: f64 = 1e-12;

impl KernelOperator {
    /// Checks that tractions of the given kind do positive work, as on elastic bodies: that the influence matrix is
    /// positive definite.
    ///
    /// Displacements that vary at random from cell to cell are solved for by conjugate gradients. Their search
    /// directions are conjugate, so that a matrix with a negative eigenvalue shows one of negative work before the
    /// residual vanishes; it is then refused. A matrix for which 300 products do not reduce the residual to 1e-9 of
    /// the load is not refused.
    ///
    /// # Errors
    /// [`OperatorError::Zero`] if a displacement is zero under its own traction, [`OperatorError::Indefinite`].
    pub fn check_definite(&self, blocks: Blocks) -> Result<(), OperatorError> {
        let axes: &[Axis] = match blocks {
            Blocks::All => &Axis::ALL,
            Blocks::Normal => &[Axis::Normal],
            Blocks::Tangential => &[Axis::X, Axis::Y],
        };
        let own = self.coefficients(0, 0);
        for axis in axes {
            let value = own.rows[*axis as usize][*axis as usize];
            if value <= 0.0 {
                return Err(OperatorError::Zero { of: axis.displacement_name(), value });
            }
        }
        Search::new(self, axes).run()
    }
}

/// Three fields, one for each axis; those of other axes stay zero.
type Fields = [Vec<f64>; 3];

/// Conjugate gradients with the inverse of a half-space as preconditioner.
struct Search<'a> {
    operator: &'a KernelOperator,
    inverse: std::sync::Arc<dyn Preconditioner>,
    axes: &'a [Axis],
    workspace: Workspace,
    /// What is left of the displacements.
    left: Fields,
    /// The preconditioned residual.
    eased: Fields,
    direction: Fields,
    moved: Fields,
}

impl<'a> Search<'a> {
    fn new(operator: &'a KernelOperator, axes: &'a [Axis]) -> Self {
        let cells = operator.grid().cells();
        let zero = || [(); 3].map(|()| vec![0.0; cells]);
        let mut left = zero();
        let mut random = 0x9e37_79b9_7f4a_7c15_u64;
        for axis in axes {
            left[*axis as usize].fill_with(|| noise(&mut random));
        }
        Self {
            inverse: operator.near_field(),
            workspace: operator.workspace(),
            eased: zero(),
            direction: zero(),
            moved: zero(),
            operator,
            axes,
            left,
        }
    }

    fn run(mut self) -> Result<(), OperatorError> {
        let load = self.dot(&self.left, &self.left);
        let (mut before, mut first) = (0.0, 0.0);
        for step in 0..MOST {
            self.ease();
            let product = self.dot(&self.left, &self.eased);
            let keep = if step == 0 { 0.0 } else { product / before };
            for (direction, eased) in self.direction.iter_mut().zip(&self.eased) {
                let pairs = direction.iter_mut().zip(eased);
                pairs.for_each(|(direction, eased)| *direction = eased + keep * *direction);
            }
            self.apply()?;
            let work = self.dot(&self.direction, &self.moved);
            if step == 0 {
                first = work / product;
            }
            // The work of a traction over that of the fitted half-space, against the first one's.
            let is_positive = work > ROUND_OFF * first.abs() * product;
            if !is_positive {
                let cells = self.operator.grid().cells();
                return Err(OperatorError::Indefinite { work: work / product, cells });
            }
            let length = product / work;
            for (left, moved) in self.left.iter_mut().zip(&self.moved) {
                left.iter_mut().zip(moved).for_each(|(left, moved)| *left -= length * moved);
            }
            before = product;
            if self.dot(&self.left, &self.left) <= SOLVED * SOLVED * load {
                break;
            }
        }
        Ok(())
    }

    fn dot(&self, one: &Fields, other: &Fields) -> f64 {
        let along = |axis: &Axis| {
            let pairs = one[*axis as usize].iter().zip(&other[*axis as usize]);
            pairs.map(|(one, other)| one * other).sum::<f64>()
        };
        self.axes.iter().map(along).sum()
    }

    /// The tractions that cause what is left, on the half-space.
    fn ease(&mut self) {
        let [x, y, normal] = &mut self.eased;
        if self.axes.contains(&Axis::Normal) {
            self.inverse.pressure(&self.left[2], normal, &mut self.workspace);
        }
        if self.axes.contains(&Axis::X) {
            let left = [Some(&self.left[0][..]), Some(&self.left[1][..])];
            self.inverse.traction(left, [Some(x), Some(y)], &mut self.workspace);
        }
    }

    /// The displacements due to the direction.
    fn apply(&mut self) -> Result<(), OperatorError> {
        let held = |axis: Axis| self.axes.contains(&axis);
        let [x, y, normal] = &self.direction;
        let [u, v, w] = &mut self.moved;
        let tractions = TractionField {
            x: held(Axis::X).then_some(x),
            y: held(Axis::Y).then_some(y),
            normal: held(Axis::Normal).then_some(normal),
        };
        let displacements = DisplacementField {
            u: held(Axis::X).then_some(u),
            v: held(Axis::Y).then_some(v),
            w: held(Axis::Normal).then_some(w),
        };
        self.operator.apply(tractions, displacements, &mut self.workspace)
    }
}

/// Uniform in [-1, 1) (xorshift).
fn noise(state: &mut u64) -> f64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}
