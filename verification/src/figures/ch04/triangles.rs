//! Fig. 4.2: a rectangle with a corner in the origin, split into two triangles.

use crate::{Figure, FigureResult, Panel, Relative, Series};
use carom_halfspace::{Offset, Rectangle};

/// The rectangle's sides.
const SIDES: [f64; 2] = [1.3, 0.8];

pub(super) fn draw() -> FigureResult {
    let [x, y] = SIDES;
    let mut figure = Figure::new();
    figure.assumed("x₁, y₁", "1.3, 0.8");
    let mut panel = Panel::new("x", "y").equal_aspect();
    panel.add(Series::area("x < y x₁/y₁", [(0.0, 0.0), (x, y), (0.0, y)]));
    panel.add(Series::area("x > y x₁/y₁", [(0.0, 0.0), (x, 0.0), (x, y)]));
    figure.panel(panel);

    let integrals = Rectangle::new(x, y)?.integrals(Offset { x: 0.5 * x, y: 0.5 * y })?;
    let closed = x * libm::atan2(y, x) - y * libm::log(y / libm::hypot(x, y));
    figure.close("∫ -x/(x² + y²) dS", -integrals.log_x, -closed, Relative(1e-15)).source("(4.28)");
    figure
        .close(
            "the same by quadrature",
            -integrals.log_x,
            -1.234_013_625_369_522_2,
            Relative(1e-15),
        )
        .source("quadrature with 30 digits");
    // Over the triangles, in polar coordinates: side times ln(tan(pi/4 + angle/2)).
    let wedge = |side: f64, other: f64| side * libm::asinh(other / side);
    figure
        .close(
            "∫ dS/r over both triangles",
            integrals.inverse_distance,
            wedge(x, y) + wedge(y, x),
            Relative(1e-15),
        )
        .source("∫ x₁/cos φ dφ over each triangle");
    figure.deviation(
        "(4.24), (4.26): ∂/∂y_j ln r on the left",
        "∂/∂x_k ln r",
        "the integrand is (x_k - x')/r²",
    );
    Ok(figure)
}
