//! Displacement history of cells that come into contact during a step.

use std::f64::consts::FRAC_2_PI;

use carom_laws::ellipse::ContactEllipse;
use carom_laws::law::Shift;

use crate::state::ContactState;

/// Corrects the last displacements of the cells outside the contact for the part of the rigid shift
/// from `from` to `to` that takes place before they enter. One step then gives nearly the same
/// result as many. It assumes that the contact grows in proportion to the approach, up to the Hertz
/// `ellipse` at the end of the step.
///
/// While a cell lies outside a sticking contact, its surface follows only (2/pi) asin(a/r) of the
/// rigid shift (exact for a circle and nu = 0). For a contact that grows from first contact under a
/// shift in proportion to its approach the correction is exact: the displacements are xi (1 -
/// r^2/(2 a^2)), like those due to the approach.
pub(super) fn anticipate(
    state: &mut ContactState,
    from: &Shift,
    to: &Shift,
    ellipse: &ContactEllipse,
) {
    let growth = to.zeta - from.zeta;
    let [xi, eta, turn] = [to.xi - from.xi, to.eta - from.eta, to.omega - from.omega];
    if growth <= 0.0 || (xi == 0.0 && eta == 0.0 && turn == 0.0) {
        return;
    }
    let grid = state.pressure.grid();
    let (u, v) = (state.displacement_x.values_mut(), state.displacement_y.values_mut());
    for (i, (x, y)) in grid.centres().enumerate() {
        if state.pressure.values()[i] > 0.0 {
            continue;
        }
        // The approach at which the cell enters the contact.
        let entry = to.zeta * ellipse.radius_squared(x, y).min(1.0);
        let missed =
            if entry > from.zeta { entry / growth * left_behind(from.zeta / entry) } else { 0.0 };
        u[i] -= missed * (xi + y * turn); // (12.2)
        v[i] -= missed * (eta - x * turn);
    }
}

/// The integral of 1 - (2/pi) asin(sqrt(y)) from y to 1.
fn left_behind(y: f64) -> f64 {
    let root = y.sqrt();
    let inner = (y - 0.5) * libm::asin(root) + 0.5 * root * (1.0 - y).sqrt();
    (1.0 - y) - (0.5 - FRAC_2_PI * inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn it_is_the_integral() {
        assert_relative_eq!(left_behind(0.0), 0.5, epsilon = 1e-15);
        assert!(left_behind(1.0).abs() < 1e-15);
        let slope = |y: f64| (left_behind(y + 1e-5) - left_behind(y - 1e-5)) / 2e-5;
        for y in [0.1_f64, 0.5, 0.9] {
            assert_relative_eq!(slope(y), FRAC_2_PI * y.sqrt().asin() - 1.0, epsilon = 1e-8);
        }
    }
}
