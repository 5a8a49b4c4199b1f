//! The start of the iterations of a step.

use carom_laws::hertz::HertzState;

use crate::state::ContactState;

/// Cuts the tractions to the friction limit under the Hertz pressure after the step. Where a contact shrinks to
/// a small part in a step, the last tractions would else keep the bodies apart.
pub(super) fn cut(from: &mut ContactState, hertz: &HertzState, friction: f64) {
    let grid = from.pressure.grid();
    let (t_x, t_y) = (from.traction_x.values_mut(), from.traction_y.values_mut());
    for ((x, y), (t_x, t_y)) in grid.centres().zip(t_x.iter_mut().zip(t_y)) {
        let (size, limit) = (t_x.hypot(*t_y), friction * hertz.pressure(x, y));
        if size > limit {
            *t_x *= limit / size;
            *t_y *= limit / size;
        }
    }
}
