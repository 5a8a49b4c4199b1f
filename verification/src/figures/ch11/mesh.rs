//! Fig. 11.1: Kalker's mesh and his form of the equations.

use std::f64::consts::PI;

use super::super::outline::ellipse;
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Panel, Relative, Series};
use carom_halfspace::{Material, MaterialPair, Offset, Rectangle, RectangleInfluence};

/// Δx, Δy: full lengths of the sides.
const SIDES: [f64; 2] = [1.0, 0.75];
const COLUMNS: i32 = 8;
const ROWS: i32 = 6;

/// I1 to I6 of (11.3) at (x, y) = observation minus middle of the rectangle, by the corners of the
/// functions of (11.7).
fn integrals([x, y]: [f64; 2]) -> [f64; 6] {
    let mut sums = [0.0; 6];
    for (side_x, sign_x) in [(0.5, 1.0), (-0.5, -1.0)] {
        for (side_y, sign_y) in [(0.5, 1.0), (-0.5, -1.0)] {
            let (x, y) = (x + side_x * SIDES[0], y + side_y * SIDES[1]);
            let (along, across) = (y * (x / y.abs()).asinh(), x * (y / x.abs()).asinh());
            let log = |x: f64, y: f64| 0.5 * y * x.hypot(y).powi(2).ln() + x * (y / x).atan();
            let corner = [along + across, along, -x.hypot(y), across, log(x, y), log(y, x)];
            for (sum, corner) in sums.iter_mut().zip(corner) {
                *sum += sign_x * sign_y * corner;
            }
        }
    }
    sums
}

/// The matrix of (11.1), rows u, v, w, with K/G = `part` ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2).
fn matrix(bodies: [[f64; 2]; 2], at: [f64; 2], part: f64) -> [[f64; 3]; 3] {
    let [[g1, nu1], [g2, nu2]] = bodies;
    let one = 0.5 * (1.0 / g1 + 1.0 / g2);
    let nu = 0.5 * (nu1 / g1 + nu2 / g2);
    let k = part * ((1.0 - 2.0 * nu1) / g1 - (1.0 - 2.0 * nu2) / g2);
    let [i1, i2, i3, i4, i5, i6] = integrals(at);
    let rows = [
        [(one - nu) * i1 + nu * i2, nu * i3, -k * i5],
        [nu * i3, (one - nu) * i1 + nu * i4, -k * i6],
        [k * i5, k * i6, (one - nu) * i1],
    ];
    rows.map(|row| row.map(|value| value / PI))
}

/// Coefficients of (11.1) beside those of (4.14), over the largest of their matrix.
fn pairs(part: f64) -> Result<Vec<(f64, f64)>, Failure> {
    let bodies = [[1.0, 0.1], [2.5, 0.4]];
    let [one, two] = bodies.map(|[shear, nu]| Material::from_shear(shear, nu));
    let pair = MaterialPair::new(one?, two?)?;
    let influence = RectangleInfluence::new(pair, Rectangle::new(SIDES[0], SIDES[1])?);
    let mut pairs = Vec::new();
    for row in -ROWS..=ROWS {
        for column in -COLUMNS..=COLUMNS {
            let at = [f64::from(column) * SIDES[0], f64::from(row) * SIDES[1]];
            // Offsets of (4.23) are source minus receiver.
            let own = influence.coefficients(Offset { x: -at[0], y: -at[1] })?;
            let his = matrix(bodies, at, part);
            let largest = own.largest();
            let both = his.into_iter().flatten().zip(own.rows.into_iter().flatten());
            pairs.extend(both.map(|(his, own)| (his / largest, own / largest)));
        }
    }
    Ok(pairs)
}

fn mesh() -> Panel {
    let (right, top) = (f64::from(COLUMNS) * SIDES[0], f64::from(ROWS) * SIDES[1]);
    let mut panel = Panel::new(
        Axis::linear("x").between(-0.6, right + 0.6),
        Axis::linear("y").between(-0.6, top + 0.6),
    )
    .titled("Contact area on Kalker's mesh: Δx, Δy are full sides")
    .equal_aspect();
    for column in 0..=COLUMNS {
        let x = f64::from(column) * SIDES[0];
        panel.add(Series::line("", [(x, 0.0), (x, top)]).coloured(6));
    }
    for row in 0..=ROWS {
        let y = f64::from(row) * SIDES[1];
        panel.add(Series::line("", [(0.0, y), (right, y)]).coloured(6));
    }
    let (a, b) = (0.44 * right, 0.42 * top);
    let outline = ellipse([0.5 * right, 0.5 * top], [a, b], 120);
    panel.add(Series::line("contact area", outline).coloured(1));
    let corner = (2.0 * SIDES[0], 2.0 * SIDES[1]);
    let cell = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
        .map(|(x, y)| (corner.0 + x * SIDES[0], corner.1 + y * SIDES[1]));
    panel.add(Series::area("rectangle M about (xₚ, yₚ)", cell).coloured(2));
    panel
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("Δx, Δy", "1, 0.75");
    figure.assumed("G, ν of the claims", "1, 0.1 and 2.5, 0.4");
    figure.panel(mesh());
    figure
        .all_close("(11.1) is (4.14)", pairs(0.25)?, Absolute(1e-13))
        .source("the coefficients (4.29), checked by quadrature; K/G with 1/4");
    let printed = pairs(0.5)?;
    let worst = printed.iter().map(|(his, own)| (his - own).abs()).fold(0.0, f64::max);
    let largest = |(his, own): &(f64, f64)| (his - own).abs() == worst;
    let doubled = printed.iter().find(|pair| largest(pair)).map_or(0.0, |(his, own)| his / own);
    figure
        .close("printed K doubles the coupling", doubled, 2.0, Relative(1e-10))
        .source("(11.2) as printed: K/G = (1/2) (..)");
    let cause = "comparison with (4.14)";
    figure.deviation(
        "(11.2): K/G = ½ ((1−2ν₁)/G₁ − (1−2ν₂)/G₂)",
        "K/G = ¼ (…)",
        format!("{cause}: with ½ the coupling is doubled"),
    );
    figure.deviation(
        "(11.1): rows w, u, v; rigid part added",
        "rows u, v, w; slip and gap are the sum less the rigid part",
        cause,
    );
    figure.deviation(
        "(11.3): I₂, I₃ over |x − x′|, I₄ = ∫(x − x′)/|x − x′|; no I₅, I₆",
        "I₂, I₃, I₄ over |x − x′|³; I₅ = ∫(x − x′)/r², I₆ = ∫(y − y′)/r²",
        "the derivatives (11.7)",
    );
    Ok(figure)
}
