//! Fig. 8.1: the three rotations of the contact axes against the body's axes.

use carom_impact::{Attitude, Side, Surface, angle_matrix};
use nalgebra::{Matrix3, Vector3};

use crate::{Arrow, Axis, Claim, Figure, FigureResult, Panel, Point, Series, Tolerance};

const ANGLES: [f64; 3] = [0.45, 0.3, 0.6]; // alpha, beta, gamma

/// The parallel projection of the sketch: x to the lower left, y to the right, z up.
fn projected(v: &Vector3<f64>) -> Point {
    Point::new(v.y - 0.5 * v.x, v.z - 0.35 * v.x)
}

fn base(label: &str, columns: &Matrix3<f64>) -> Series {
    let tail = Point::new(0.0, 0.0);
    let arrows: Vec<Arrow> =
        (0..3).map(|i| Arrow { tail, head: projected(&columns.column(i).into_owned()) }).collect();
    Series::arrows(label, arrows)
}

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
fn worst_curvature() -> Result<f64, Box<dyn std::error::Error + Send + Sync>> {
    let mut worst: f64 = 0.0;
    for i in 0..200 {
        let wave = |k: f64| libm::sin(k * (f64::from(i) + 0.7));
        let [p, q, r, s, t] = [0.9, 1.7, 2.3, 3.1, 0.4].map(wave);
        let height = move |at: &[f64; 2]| carom_impact::Height {
            c: p * at[0] + q * at[1],
            c_a: p,
            c_b: q,
            c_aa: r,
            c_bb: s,
            c_ab: t,
        };
        let surface = Surface::explicit_with(1.0, Side::Above, height)?;
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
    for (i, title) in titles.iter().enumerate() {
        let mut panel =
            Panel::new(Axis::linear("projection"), Axis::linear("")).titled(*title).equal_aspect();
        panel.add(base("before", stages[i].matrix()));
        panel.add(base("after", stages[i + 1].matrix()));
        figure.panel(panel);
    }

    let turn = |axis, angle| Attitude::about(axis, angle).map(|a| *a.matrix());
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let product = turn(z, gamma)? * turn(y, beta)? * turn(x, alpha)?;
    let pi = angle_matrix(alpha, beta, gamma);
    figure.claim(
        Claim::at_most("Π of (8.5) is z-y'-x'' in turn", (pi.transpose() - product).amax(), 1e-15)
            .source("product of quaternion rotations"),
    );
    figure.claim(Claim::at_most("Π Πᵀ = 1", off_orthogonal(&pi), 1e-15));
    figure.claim(Claim::at_least("(8.5) as printed is not", off_orthogonal(&printed(ANGLES)), 0.1));
    let about_x = turn(x, gamma)? * turn(y, beta)? * turn(x, alpha)?;
    figure.claim(Claim::at_least(
        "with the first turn about e_x, as the text says, Π differs",
        (pi.transpose() - about_x).amax(),
        0.1,
    ));
    // Euler's angles z-x-z of the rows (e_b, e_c, e_a).
    let right = std::f64::consts::FRAC_PI_2;
    let euler = turn(z, gamma + right)? * turn(x, beta + right)? * turn(z, alpha)?;
    let rows = Matrix3::from_columns(&[product.column(1), product.column(2), product.column(0)]);
    figure.claim(
        Claim::at_most(
            "Euler's angles (γ + π/2, β + π/2, α) give (e_b, e_c, e_a)",
            (euler - rows).amax(),
            1e-15,
        )
        .source("product of quaternion rotations"),
    );
    figure.claim(
        Claim::at_most(
            "principal curvatures of 200 surfaces, Gauss and mean curvature",
            worst_curvature()?,
            1e-14,
        )
        .source("first and second fundamental form"),
    );
    let egg = Surface::ellipsoid([3.0, 2.0, 1.5])?;
    let local = egg.local(&Vector3::new(1.5, -0.9, -1.109_898_644_021_155_6))?;
    let curvatures = local.curvatures().into_iter();
    figure.claim(
        Claim::all_close(
            "k_x, k_y of the ellipsoid 3, 2, 1.5 at (1.5, -0.9)",
            curvatures.zip([0.505_268_948_416_564_9, 0.236_043_885_903_308_9]),
            Tolerance::Absolute(1e-14),
        )
        .source("corrected (8.16) to (8.24)"),
    );
    figure.deviation(
        "the first rotation is about e_x; entry (c, x) of (8.5) with -sin α sin γ",
        "about e_z; + sin α sin γ",
        "misprints: only so Π is the product of (8.4) and orthogonal",
    );
    Ok(figure)
}
