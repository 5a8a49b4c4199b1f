//! Figs. 5.2 and 5.4: sections through two bodies that are pressed together and shifted.

use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::shift::CattaneoMindlin;
use std::f64::consts::PI;

const RADIUS: f64 = 1.0;
const APPROACH: f64 = 0.02;

fn spheres(g_1: f64, g_2: f64) -> Result<Hertz, Box<dyn std::error::Error + Send + Sync>> {
    let ball = PrincipalRadii::sphere(RADIUS)?;
    let body =
        |g: f64| if g.is_finite() { Material::from_shear(g, 0.3) } else { Ok(Material::RIGID) };
    let gap = RelativeCurvature::new(ball, ball, 0.0)?;
    Ok(Hertz::new(gap, MaterialPair::new(body(g_1)?, body(g_2)?)?)?)
}

/// The normal displacement of a body's surface under Hertz's pressure on a circle, by the ring
/// integral of Boussinesq's solution: independent of the law inside, and valid outside.
fn displacement(state: &HertzState, compliance: f64, x: f64) -> f64 {
    let a = state.ellipse.semi_axis_a();
    let rho = x.abs() / a;
    // (1 - nu)/(pi G) times the mean of the pressure over chords: Johnson's closed form.
    let scale = compliance * state.peak_pressure * a * PI / 4.0;
    if rho <= 1.0 {
        scale * (1.0 - 0.5 * rho * rho)
    } else {
        let root = (rho * rho - 1.0).sqrt();
        scale / PI * ((2.0 - rho * rho) * (1.0 / rho).asin() + root)
    }
}

pub(super) fn draw_pressed() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("spheres", "R = 1 each, ν = 0.3, ζ = 0.02, G₁ : G₂ = 1 : 1 and 1 : 4");
    let parabola = |x: f64| x * x / (2.0 * RADIUS);
    let mut flat = 0.0_f64;
    let mut contour = Vec::new();
    for (ratio, title) in [(1.0, "G₂ = G₁"), (4.0, "G₂ = 4 G₁")] {
        let hertz = spheres(1.0, ratio)?;
        let state = hertz.at_approach(APPROACH)?;
        let a = state.ellipse.semi_axis_a();
        let xs = linspace(-2.5 * a, 2.5 * a, 401);
        // Heights over the undeformed tangent plane of body 1, whose far points stay at rest.
        let one = |x: f64| parabola(x) + displacement(&state, 0.7, x);
        let two = |x: f64| APPROACH - parabola(x) - displacement(&state, 0.7 / ratio, x);
        let mut panel = Panel::new(Axis::linear("x"), Axis::linear("z")).titled(title);
        panel.add(Series::line("body 1", xs.iter().map(|&x| (x, one(x)))));
        panel.add(Series::line("body 2", xs.iter().map(|&x| (x, two(x)))));
        let apart = |f: &dyn Fn(f64) -> f64| xs.iter().map(|&x| (x, f(x))).collect::<Vec<_>>();
        panel.add(Series::dotted("undeformed", apart(&parabola)));
        panel.add(Series::dotted("", apart(&|x| APPROACH - parabola(x))));
        figure.panel(panel);
        for x in linspace(-a, a, 41) {
            let surface = hertz.contact_surface(APPROACH, parabola(x), parabola(x));
            contour.push((surface, one(x)));
            contour.push((surface, two(x)));
            if ratio == 1.0 {
                flat = flat.max((surface - 0.5 * APPROACH).abs());
            }
        }
    }
    figure.claim(
        Claim::all_close("both surfaces meet on (5.17)", contour, Tolerance::Absolute(1e-15))
            .source("Boussinesq's displacement under Hertz's pressure"),
    );
    figure.claim(
        Claim::at_most("equal bodies meet in a plane", flat, 1e-17).source("text below (5.17)"),
    );
    let rigid = spheres(f64::INFINITY, 1.0)?.contact_surface(APPROACH, 0.003, 0.001);
    figure.claim(
        Claim::close("a rigid body keeps its shape", rigid, 0.003, Tolerance::Absolute(1e-17))
            .source("limit of (5.17)"),
    );
    figure.deviation(
        "(ϑ₁+ϑ₂) z = ϑ₂ z₁ − ϑ₁ z₂ + ϑ₂ ζ",
        "(ϑ₁+ϑ₂) z = ϑ₂ z₁ − ϑ₁ z₂ + ϑ₁ ζ",
        "index in (5.17)",
    );
    Ok(figure)
}

pub(super) fn draw_shifted() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("contact", "two equal spheres, ν = 0, f = 0.3, ζ = 0.02, ξ = 0.6 f ζ");
    let body = Material::from_shear(2.0, 0.0)?;
    let ball = PrincipalRadii::sphere(RADIUS)?;
    let gap = RelativeCurvature::new(ball, ball, 0.0)?;
    let hertz = Hertz::new(gap, MaterialPair::new(body, body)?)?;
    let normal = hertz.at_approach(APPROACH)?;
    let f = 0.3;
    let xi = 0.6 * f * APPROACH;
    let state =
        CattaneoMindlin::new(hertz.stiffness(), Friction::new(f)?).at_shift(APPROACH, xi, 0.0)?;
    let a = normal.ellipse.semi_axis_a();
    let stick = state.stick_radius();
    // For nu = 0 a tangential pressure displaces as a normal one does: u_1 - u_2 is the
    // difference of two Hertz displacements, of the whole circle and of the stick circle.
    let scale = f * normal.peak_pressure * a * PI / 4.0; // 1/G = 1 for the pair
    let single = |rho: f64| {
        if rho <= 1.0 {
            1.0 - 0.5 * rho * rho
        } else {
            let root = (rho * rho - 1.0).sqrt();
            ((2.0 - rho * rho) * (1.0 / rho).asin() + root) / PI
        }
    };
    let relative =
        |x: f64| scale * (single(x.abs() / a) - stick * stick * single(x.abs() / (a * stick)));
    let mut panel = Panel::new(Axis::linear("x/a"), Axis::linear("displacement/ξ"));
    let xs = linspace(-2.0, 2.0, 401);
    panel.add(Series::line("u₁ − u₂", xs.iter().map(|&x| (x, relative(x * a) / xi))));
    let slip = |x: f64| 1.0 - relative(x * a) / xi;
    let inside: Vec<f64> = xs.iter().copied().filter(|x| x.abs() <= 1.0).collect();
    panel.add(Series::dashed("slip", inside.iter().map(|&x| (x, slip(x)))));
    figure.panel(panel);
    let rigid = linspace(-0.99, 0.99, 21).into_iter().map(|t| (relative(t * stick * a), xi));
    figure.claim(
        Claim::all_close("u₁ = u₂ + ξ in the stick area", rigid, Tolerance::Relative(1e-14))
            .source("displacement of the ellipsoidal traction"),
    );
    let ring = linspace(stick + 0.01, 1.0, 20).into_iter().map(slip);
    figure.claim(Claim::increasing("the slip grows towards the edge", ring).source("(6.11)"));
    Ok(figure)
}
