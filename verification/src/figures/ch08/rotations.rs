//! Fig. 8.1: the three rotations of the contact axes relative to the axes of the body.

use carom_geometry::{Attitude, BodySide, Surface, angle_matrix};
use nalgebra::{Matrix3, Vector3};

use crate::{Absolute, Arrow, Axis, Failure, Figure, FigureResult, Panel, Point, Series, linspace};

const ANGLES: [f64; 3] = [0.45, 0.3, 0.6]; // alpha, beta, gamma

/// The parallel projection of the sketch: x to the lower left, y to the right, z up.
fn projected(v: &Vector3<f64>) -> Point {
    Point::new(v.y - 0.5 * v.x, v.z - 0.35 * v.x)
}

/// The three axes as arrows with their names at the tips.
fn base(panel: &mut Panel, colour: usize, label: &str, columns: &Matrix3<f64>, names: [&str; 3]) {
    let tail = Point::new(0.0, 0.0);
    let heads = [0, 1, 2].map(|i| projected(&columns.column(i).into_owned()));
    let arrows = heads.map(|head| Arrow { tail, head });
    panel.add(Series::arrows(label, arrows).coloured(colour));
    for (name, head) in names.into_iter().zip(heads).filter(|(name, _)| !name.is_empty()) {
        // Beyond the tip; below it for an axis that points down.
        let below = if head.y < 0.0 { 0.16 } else { 0.0 };
        let at = Point::new(1.04 * head.x, 1.02 * head.y - below);
        panel.add(Series::note(name, at).coloured(colour));
    }
}

/// The path of the tips from one basis to the next, about `axis`.
fn arcs(
    panel: &mut Panel,
    from: &Attitude,
    axis: [f64; 3],
    angle: f64,
    moved: [usize; 2],
) -> Result<(), Failure> {
    for column in moved {
        let mut way = Vec::new();
        for share in linspace(0.0, 1.0, 25) {
            let turned = from.matrix() * Attitude::about(axis, share * angle)?.matrix();
            let tip = projected(&(0.55 * turned.column(column)));
            way.push((tip.x, tip.y));
        }
        panel.add(Series::dotted("", way).coloured(6));
    }
    Ok(())
}

/// Elementary rotations about x, y and z, as in textbooks.
fn elementary(axis: usize, angle: f64) -> Matrix3<f64> {
    let (s, c) = (angle.sin(), angle.cos());
    match axis {
        0 => Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c),
        1 => Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c),
        _ => Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0),
    }
}

/// Names of the axes of a stage.
const INHERITED: [[&str; 3]; 2] = [["e_x'", "e_y'", "e_z"], ["e_x''", "e_y'", "e_z''"]];

/// (8.5) as printed: the third row of the first column with a minus.
fn printed([alpha, beta, gamma]: [f64; 3]) -> Matrix3<f64> {
    let mut matrix = angle_matrix(alpha, beta, gamma);
    matrix.m31 -= 2.0 * libm::sin(alpha) * libm::sin(gamma);
    matrix
}

fn off_orthogonal(matrix: &Matrix3<f64>) -> f64 {
    (matrix * matrix.transpose() - Matrix3::identity()).amax()
}

/// Worst deviation of principal curvatures found by quadratic surfaces z = c(a, b) tilted by
/// slopes, against the eigenvalues of II/I from their first and second fundamental forms.
fn worst_curvature() -> Result<f64, Failure> {
    let mut worst: f64 = 0.0;
    for i in 0..200 {
        let wave = |k: f64| libm::sin(k * (f64::from(i) + 0.7));
        let [p, q, r, s, t] = [0.9, 1.7, 2.3, 3.1, 0.4].map(wave);
        let height = move |at: &[f64; 2]| carom_geometry::Height {
            c: p * at[0] + q * at[1],
            c_a: p,
            c_b: q,
            c_aa: r,
            c_bb: s,
            c_ab: t,
        };
        let surface = Surface::explicit_with(1.0, BodySide::Above, height)?;
        let [k_1, k_2] = surface.local(&Vector3::zeros())?.curvatures();
        // Gauss and mean curvature.
        let steep = 1.0 + p * p + q * q;
        let gauss = (r * s - t * t) / (steep * steep);
        let mean = ((1.0 + q * q) * r - 2.0 * p * q * t + (1.0 + p * p) * s)
            / (2.0 * steep * steep.sqrt());
        worst = worst.max((k_1 * k_2 - gauss).abs()).max((0.5 * (k_1 + k_2) - mean).abs());
    }
    Ok(worst)
}

pub(super) fn draw() -> FigureResult {
    let [alpha, beta, gamma] = ANGLES;
    let mut figure = Figure::new();
    figure.assumed("α, β, γ", "0.45, 0.3 and 0.6 rad");
    let titles = ["γ about e_z", "β about e_y'", "α about e_x''"];
    let stages = [
        Attitude::ALIGNED,
        Attitude::from_angles(0.0, 0.0, gamma)?,
        Attitude::from_angles(0.0, beta, gamma)?,
        Attitude::from_angles(alpha, beta, gamma)?,
    ];
    let names =
        [["e_x", "e_y", "e_z"], ["e_x'", "e_y'", ""], ["e_x''", "", "e_z''"], ["", "e_b", "e_c"]];
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let turns = [(z, gamma, [0, 1]), (y, beta, [0, 2]), (x, alpha, [1, 2])];
    for (i, title) in titles.iter().enumerate() {
        let mut panel = Panel::new(
            Axis::bare("parallel projection: e_x to the front, e_y to the right, e_z up")
                .between(-0.9, 1.5),
            Axis::bare("").between(-0.75, 1.2),
        )
        .titled(*title)
        .equal_aspect();
        let stage_names = if i == 0 { names[0] } else { INHERITED[i - 1] };
        base(&mut panel, 0, "before", stages[i].matrix(), stage_names);
        base(&mut panel, 1, "after", stages[i + 1].matrix(), names[i + 1]);
        let (axis, angle, moved) = turns[i];
        arcs(&mut panel, &stages[i], axis, angle, moved)?;
        figure.panel(panel);
    }

    let product = elementary(2, gamma) * elementary(1, beta) * elementary(0, alpha);
    let pi = angle_matrix(alpha, beta, gamma);
    figure
        .at_most("Π of (8.5) is z-y'-x'' in turn", (pi.transpose() - product).amax(), 1e-15)
        .source("product of three textbook matrices");
    let last = stages[3].matrix();
    figure
        .at_most("so is the attitude of these angles", (last - product).amax(), 1e-15)
        .source("product of three textbook matrices");
    let printed = off_orthogonal(&printed(ANGLES));
    figure.at_most("Π Πᵀ = 1", off_orthogonal(&pi), 1e-15).source("Π turns, (8.4)");
    // Row 3 times row 1 of the printed matrix is 2 sin α sin γ cos β cos γ off.
    let off = 2.0 * alpha.sin() * gamma.sin() * beta.cos() * gamma.cos();
    figure
        .close("Π Πᵀ - 1 of (8.5) as printed", printed, off, Absolute(1e-14))
        .source("one wrong sign in the entry (c, x), worked out");
    // Euler's angles z-x-z of the rows (e_b, e_c, e_a).
    let right = std::f64::consts::FRAC_PI_2;
    let euler = elementary(2, gamma + right) * elementary(0, beta + right) * elementary(2, alpha);
    let rows = Matrix3::from_columns(&[pi.row(1), pi.row(2), pi.row(0)].map(|row| row.transpose()));
    figure
        .at_most(
            "Euler's angles (γ + π/2, β + π/2, α) give (e_b, e_c, e_a)",
            (euler - rows).amax(),
            1e-15,
        )
        .source("product of three textbook matrices");
    figure
        .at_most(
            "principal curvatures of 200 surfaces, Gauss and mean curvature",
            worst_curvature()?,
            1e-14,
        )
        .source("first and second fundamental form");
    let egg = Surface::ellipsoid([3.0, 2.0, 1.5])?;
    let local = egg.local(&Vector3::new(1.5, -0.9, -1.109_898_644_021_155_6))?;
    let curvatures = local.curvatures().into_iter();
    figure
        .all_close(
            "k_x, k_y of the ellipsoid 3, 2, 1.5 at (1.5, -0.9)",
            curvatures.zip([0.505_268_948_416_564_9, 0.236_043_885_903_308_9]),
            Absolute(1e-14),
        )
        .source("corrected (8.16) to (8.24)");
    figure.deviation(
        "the first rotation is about e_x; entry (c, x) of (8.5) with -sin α sin γ",
        "about e_z; + sin α sin γ",
        "misprints: only so Π is the product of (8.4) and orthogonal",
    );
    Ok(figure)
}
