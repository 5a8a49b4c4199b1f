//! Figs. 5.2 and 5.4: sections through the deformed bodies.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::shift::CattaneoMindlin;

use super::super::sphere_traction;
use crate::{Absolute, Failure, Figure, FigureResult, Panel, Relative, Series, linspace};

const APPROACH: f64 = 0.1;
const RADII: [f64; 2] = [1.0, 1.6];

/// Two spheres pressed together by `APPROACH`.
struct Spheres {
    hertz: Hertz,
    state: HertzState,
    /// Fraction of the deformation that each body takes.
    shares: [f64; 2],
}

impl Spheres {
    fn new(bodies: [Material; 2]) -> Result<Self, Failure> {
        let [one, two] = RADII.map(PrincipalRadii::sphere);
        let materials = MaterialPair::new(bodies[0], bodies[1])?;
        let hertz = Hertz::new(RelativeCurvature::new(one?, two?, 0.0)?, materials)?;
        let [one, two] = bodies.map(|body| (1.0 - body.poisson()) / body.shear_modulus());
        let shares = [one / (one + two), two / (one + two)];
        Ok(Self { hertz, state: hertz.at_approach(APPROACH)?, shares })
    }

    /// z_1 and z_2 of (5.1).
    fn undeformed(x: f64) -> [f64; 2] {
        RADII.map(|radius| 0.5 * x * x / radius)
    }

    /// w_1 and w_2 from the pressure of the Hertz contact.
    fn displacements(&self, x: f64) -> [f64; 2] {
        let materials = self.hertz.materials();
        let compliance = (1.0 - materials.poisson()) / materials.shear_modulus();
        let a = self.state.ellipse.semi_axis_a();
        let sum = self.state.peak_pressure * compliance * sphere_traction::normal(a, x.abs());
        self.shares.map(|share| share * sum)
    }

    /// The surfaces of both bodies after deformation, as in (5.15).
    fn surfaces(&self, x: f64) -> [f64; 2] {
        let ([z_1, z_2], [w_1, w_2]) = (Self::undeformed(x), self.displacements(x));
        [z_1 + w_1, APPROACH - z_2 - w_2]
    }

    fn contact_surface(&self, x: f64) -> f64 {
        let [z_1, z_2] = Self::undeformed(x);
        self.hertz.contact_surface(APPROACH, z_1, z_2)
    }

    fn inside(&self, count: usize) -> Vec<f64> {
        let a = self.state.ellipse.semi_axis_a();
        linspace(-a, a, count)
    }
}

fn pair(shear: [f64; 2], poisson: [f64; 2]) -> Result<Spheres, Failure> {
    let [one, two] = [0, 1].map(|i| Material::from_shear(shear[i], poisson[i]));
    Spheres::new([one?, two?])
}

/// Fig. 5.2.
pub(super) fn contact() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("spheres", "R₁ = 1, R₂ = 1.6, approach ζ = 0.1");
    figure.assumed("materials", "G₁ = 1, ν₁ = 0.3; G₂ = 3, ν₂ = 0.2");
    let spheres = pair([1.0, 3.0], [0.3, 0.2])?;
    let xs = linspace(-0.55, 0.55, 221);
    let mut panel = Panel::new("x", "z (into body 1)").titled("Section y = 0, body 1 above");
    let curve = |f: &dyn Fn(f64) -> f64| xs.iter().map(|&x| (x, f(x))).collect::<Vec<_>>();
    panel.add(Series::line("body 1, z₁ + w₁", curve(&|x| spheres.surfaces(x)[0])));
    panel.add(Series::line("body 2, ζ - z₂ - w₂", curve(&|x| spheres.surfaces(x)[1])));
    panel.add(Series::dashed("undeformed z₁", curve(&|x| Spheres::undeformed(x)[0])).coloured(0));
    panel.add(
        Series::dashed("undeformed ζ - z₂", curve(&|x| APPROACH - Spheres::undeformed(x)[1]))
            .coloured(1),
    );
    let inside = spheres.inside(41);
    let plane = inside.iter().map(|&x| (x, spheres.contact_surface(x)));
    panel.add(Series::dotted("contact surface (5.17)", plane).coloured(3));
    figure.panel(panel);

    let both = inside.iter().flat_map(|&x| {
        let z = spheres.contact_surface(x);
        spheres.surfaces(x).map(|surface| (z, surface))
    });
    figure
        .all_close("(5.17), corrected, is both deformed surfaces", both, Absolute(1e-14))
        .source("w of the semi-ellipsoidal pressure in closed form");
    let between = inside.iter().map(|&x| {
        let ([z_1, z_2], z) = (Spheres::undeformed(x), spheres.contact_surface(x));
        (z - z_1).min(APPROACH - z_2 - z)
    });
    // The distance of the contact surface from z_1 and from ζ - z_2 at the edge, where the gap ζ - z_1 - z_2
    // is ζ/2: it divides that gap in the ratio of the compliances.
    let [one, two] = spheres.shares;
    figure
        .close(
            "it lies between z₁ and ζ - z₂, by at least",
            between.fold(f64::INFINITY, f64::min),
            0.5 * APPROACH * one.min(two),
            Absolute(1e-15),
        )
        .source("(5.17): the gap in the ratio of both compliances");
    let a = spheres.state.ellipse.semi_axis_a();
    let outside = xs.iter().filter(|x| x.abs() > 1.02 * a).map(|&x| {
        let [above, below] = spheres.surfaces(x);
        above - below
    });
    let gap = outside.fold(f64::INFINITY, f64::min);
    figure
        .at_least("the bodies are apart outside the contact, from 1.02 a on", gap, 5e-4)
        .source("text above (5.15)");
    limit_claims(&mut figure)?;
    let [one, two] = spheres.shares;
    let printed = |x: f64| {
        let [z_1, z_2] = Spheres::undeformed(x);
        two * z_1 - one * z_2 + two * APPROACH
    };
    let miss = (printed(0.0) - spheres.contact_surface(0.0)).abs() / APPROACH;
    figure
        .close(
            "(5.17) as printed misses at the centre by, over ζ",
            miss,
            (0.7 - 0.8 / 3.0) / (0.7 + 0.8 / 3.0),
            Absolute(1e-14),
        )
        .source("difference of both compliances (1 - ν)/G over their sum");
    figure.deviation(
        "… + φ₂ ξ as last term of (5.17)",
        "… + φ₁ ζ",
        "misprint: a rigid body 1 must leave z = z₁",
    );
    Ok(figure)
}

fn limit_claims(figure: &mut Figure) -> Result<(), Failure> {
    let hard = Spheres::new([Material::RIGID, Material::from_shear(1.0, 0.3)?])?;
    let pairs =
        hard.inside(21).into_iter().map(|x| (hard.contact_surface(x), Spheres::undeformed(x)[0]));
    figure
        .all_close("z = z₁ for a rigid body 1", pairs, Absolute(1e-16))
        .source("text below (5.17): the contour of the harder body");
    // Two equal spheres: (ζ + z₁ - z₂)/2 with z₁ = z₂.
    let similar = pair([1.0, 1.0], [0.3, 0.3])?;
    let flat = similar.inside(21).into_iter().map(|x| {
        let [z_1, _] = Spheres::undeformed(x);
        (similar.hertz.contact_surface(APPROACH, z_1, z_1), 0.5 * APPROACH)
    });
    figure
        .all_close("the plane z = ζ/2 for equal bodies", flat, Absolute(1e-16))
        .source("text below (5.17)");
    Ok(())
}

/// Fig. 5.4.
pub(super) fn shifted() -> FigureResult {
    let (nu, friction, share) = (0.0, 0.5, 0.7);
    let mut figure = Figure::new();
    figure.stated("ξ₁", "0: the system of body 1");
    figure.assumed("spheres", "R₁ = 1, R₂ = 1.6, approach ζ = 0.1, G₁ = G₂ = 1, ν = 0");
    figure.assumed("shift", "c_x ξ/(f c_z ζ) = 0.7, f = 0.5");
    let spheres = pair([1.0, 1.0], [nu, nu])?;
    let stiffness = spheres.hertz.stiffness();
    let law = CattaneoMindlin::new(stiffness, Friction::new(friction)?);
    let xi = share * friction * stiffness.c_z / stiffness.c_x * APPROACH;
    let state = law.at_shift(APPROACH, xi, 0.0)?;
    let a = spheres.state.ellipse.semi_axis_a();
    let stick = a * state.stick_radius();
    let peak = friction * spheres.state.peak_pressure;
    let modulus = spheres.hertz.materials().shear_modulus();
    // u_1 - u_2 along y = 0 under the stress of Cattaneo.
    let relative = |x: f64| {
        let outer = sphere_traction::along(a, x.abs(), nu);
        let inner = stick / a * sphere_traction::along(stick, x.abs(), nu);
        peak / modulus * (outer - inner)
    };

    let mut panel =
        Panel::new("x", "z (into body 1)").titled("Surface points that lay opposite each other");
    let xs = linspace(-0.4, 0.4, 161);
    panel.add(Series::line(
        "body 1",
        xs.iter().map(|&x| (x + 0.5 * relative(x), spheres.surfaces(x)[0])),
    ));
    panel.add(Series::line(
        "body 2",
        xs.iter().map(|&x| (x - 0.5 * relative(x) + xi, spheres.surfaces(x)[1])),
    ));
    for (i, x) in linspace(-0.36, 0.36, 25).into_iter().enumerate() {
        let [above, below] = spheres.surfaces(x);
        let name = |body: &str| if i == 0 { format!("fibres of {body}") } else { String::new() };
        let tip = x + 0.5 * relative(x);
        panel.add(Series::line(name("body 1"), [(x, above + 0.05), (tip, above)]).coloured(2));
        let tip = x - 0.5 * relative(x) + xi;
        panel.add(Series::line(name("body 2"), [(x + xi, below - 0.05), (tip, below)]).coloured(3));
    }
    let height = 0.5 * APPROACH;
    panel.add(
        Series::line(
            "stick area",
            [(-stick, height), (stick, height)].map(|(x, z)| (x + 0.5 * xi, z)),
        )
        .coloured(4),
    );
    figure.panel(panel);
    let mut slip = Panel::new("x/a", "(u₁ - u₂)/ξ").titled("Relative displacement");
    let wide = linspace(-1.5, 1.5, 301);
    slip.add(Series::line("u₁ - u₂", wide.iter().map(|&s| (s, relative(s * a) / xi))));
    slip.add(Series::dashed("ξ, in the stick area", [(-1.0, 1.0), (1.0, 1.0)]));
    figure.panel(slip);

    let stuck = linspace(0.0, stick, 21).into_iter().map(|x| (relative(x), xi));
    figure
        .all_close("u₁ = u₂ + ξ in the stick area", stuck, Relative(1e-13))
        .source("(5.19) by the displacement (6.6) of two ellipsoids of traction");
    let lag: Vec<f64> = linspace(stick, a, 31).into_iter().map(|x| relative(x) / xi).collect();
    figure.decreasing("the slip grows from its border to the edge", lag).source("(6.11)");
    figure
        .close("(a*/a)² = 1 - c_x ξ/(f c_z ζ)", state.stick_depth(), 1.0 - share, Absolute(1e-15))
        .source("(5.26)");
    let order = linspace(-0.4, 0.4, 81).into_iter().map(|x| x + 0.5 * relative(x));
    figure
        .increasing("no two surface points of body 1 cross", order)
        .source("displacements are continuous and small");
    let curvature = 0.5 / RADII[0] + 0.5 / RADII[1];
    figure
        .close("a² (A + B) = ζ", a * a * 2.0 * curvature, APPROACH, Relative(1e-14))
        .source("(5.14) with β = 1");
    Ok(figure)
}
