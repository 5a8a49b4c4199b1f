//! The slip of a step.

use carom_halfspace::Field;

use crate::state::ContactState;

impl ContactState {
    /// The displacement of the surface of body 1 relative to that of body 2 since an earlier state,
    /// beyond the rigid shift and twist (12.2), in all cells. In cells of the contact it is the
    /// slip.
    ///
    /// Both states should have the same grid; otherwise it is zero beyond the cells of the smaller
    /// one.
    #[must_use]
    pub fn slip_since(&self, before: &Self) -> [Field; 2] {
        let grid = self.pressure.grid();
        let mut slip = [Field::uniform(grid, 0.0), Field::uniform(grid, 0.0)];
        let [along_x, along_y] = &mut slip;
        for ((x, y), own) in
            along_x.values_mut().iter_mut().zip(along_y.values_mut()).zip(self.slips_since(before))
        {
            [*x, *y] = own;
        }
        slip
    }

    /// The same, cell by cell.
    pub(super) fn slips_since<'a>(
        &'a self,
        before: &'a Self,
    ) -> impl Iterator<Item = [f64; 2]> + 'a {
        let (now, then) = (self.shift, before.shift);
        let [xi, eta, turn] = [now.xi - then.xi, now.eta - then.eta, now.omega - then.omega];
        let x = self.displacement_x.values().iter().zip(before.displacement_x.values());
        let y = self.displacement_y.values().iter().zip(before.displacement_y.values());
        let cells = x.zip(y).zip(self.pressure.grid().centres());
        cells.map(move |(((u, u_then), (v, v_then)), (x, y))| {
            [u - u_then - (xi + y * turn), v - v_then - (eta - x * turn)]
        })
    }
}
