//! Figs. 6.1 to 6.3: the Cattaneo-Mindlin function and the first shift.

use std::f64::consts::{PI, TAU};

use carom_halfspace::{Material, MaterialPair};
use carom_laws::accounted::Accounted;
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::{memory_displacement, normal_displacement};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Energies as _, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_special::quadrature::{Tolerance as Within, tanh_sinh};

use super::super::outline::ellipse;
use super::history::{
    add_terms, follow, force_panel, profile, reference_claim, sigma, springs_claim, stress,
    stress_claims, stress_panel, virgin,
};
use crate::{Absolute, Failure, Figure, FigureResult, Panel, Relative, Series, linspace};

fn circle(radius: f64) -> Vec<(f64, f64)> {
    ellipse([0.0; 2], [radius; 2], 144)
}

/// Fig. 6.1.
pub(super) fn regions() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("a_k/a_i", "0.6");
    let (outer, inner) = (1.0, 0.36);
    let mut map =
        Panel::new("x/a_i", "y/a_i").titled("Stick circle A_k and slip ring S_i").equal_aspect();
    map.add(Series::area("S_i", circle(1.0)).coloured(0));
    map.add(Series::area("A_k", circle(0.6)).coloured(2));
    map.add(Series::line("edge of A_i", circle(1.0)).coloured(0));
    map.add(Series::line("edge of A_k", circle(0.6)).coloured(2));
    figure.panel(map);
    let mut panel = Panel::new("ρ/a_i", "σ_CM / (μ a_i)").titled("Function σ_CM(a_i, a_k)");
    panel.add(Series::line("σ_CM", profile(&[outer, inner], |rho| sigma(outer, inner, rho))));
    panel.add(Series::dashed("f p_z", profile(&[outer], |rho| sigma(outer, 0.0, rho))));
    figure.panel(panel);

    let memory = follow(&[(1.0, 0.0), (1.0, 1.0 - inner)])?;
    let radii = linspace(0.0, 0.999, 101);
    let pairs = radii.iter().map(|&rho| (stress(&memory, rho), sigma(outer, inner, rho)));
    figure.all_close("σ_CM is the stress after a shift", pairs, Absolute(1e-14)).source("(6.3)");
    let within = Within::relative(1e-12)?;
    let mut force = 0.0;
    for (low, high) in [(0.0, 0.6), (0.6, 1.0)] {
        force += TAU
            * tanh_sinh(low, high, within, |at| at.position * stress(&memory, at.position))?.value;
    }
    figure
        .close("force", force, TAU / 3.0 * (1.0 - 0.216), Relative(1e-9))
        .source("(6.5): (2πμ/3)(a_i³ - a_k³)");
    rigid_claims(&mut figure, inner)?;
    figure.deviation(
        "regions A_p, A_k; force integrated over A_k",
        "A_i, A_k; over A_i",
        "misprint in (6.5)",
    );
    Ok(figure)
}

/// Fig. 6.2.
pub(super) fn stress_after_shift() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ξ₁/(f κ ζ₁)", "0.5: ζ₁*/ζ₁ = 0.5, a₁*/a₁ = 0.7071");
    let history = [(1.0, 0.0), (1.0, 0.5)];
    let terms = [(1.0, 1.0, 0.5)];
    let mut panel = stress_panel("After the first shift (6.10)");
    add_terms(&mut panel, &[], &terms, "σ_zx1 = σ_CM(a₁, a₁*)");
    panel.add(Series::dashed("f p_z", profile(&[1.0], |rho| sigma(1.0, 0.0, rho))));
    figure.panel(panel);
    stress_claims(&mut figure, "X = 0.5", &history, &terms, "(6.10)")?;

    let memory = follow(&history)?;
    let stick = memory.stick_radius();
    figure.close("a₁*/a₁", stick, 0.5_f64.sqrt(), Absolute(1e-15)).source("(6.13)");
    let slope = |rho: f64| (stress(&memory, rho) - stress(&memory, rho - 1e-7)) / 1e-7;
    // At the distance h inside the kink sqrt(2 a* h) is lost; outside the slope is that of f p_z.
    let (inside, h) = ((2.0 * stick / 1e-7).sqrt(), 1e-7);
    let outside = -stick / (1.0 - stick * stick).sqrt();
    figure
        .all_close(
            "slopes over 1e-7 a₁ just inside and outside the break, over those expected",
            [(slope(stick) / (inside + outside), 1.0), (slope(stick + 2.0 * h) / outside, 1.0)],
            Absolute(1e-4),
        )
        .source("square root of σ_CM at a₁*");
    slip_claims(&mut figure)?;
    figure.deviation(
        "(6.11) without μ; v of (6.6) for ρ > a without ν",
        "s = μ π(2 - ν)/(8G) […]; v = ν/(8G) […] sin 2θ",
        "misprints",
    );
    figure.deviation(
        "the terms in cos 2θ and sin 2θ are smaller than 5 % of the stick displacement",
        "up to 4.7 % for ν = 0.3 but 8.9 % for ν = 0.5",
        "true for ν ≤ 0.314 only",
    );
    Ok(figure)
}

/// Displacement (u, v) of the circle a = 1 after a first shift that leaves the stick radius
/// `stick`, for f p_z = 1 in its middle and G = 1.
fn displacement(stick: f64, x: f64, y: f64, nu: f64) -> Result<[f64; 2], Failure> {
    let memory = follow(&[(1.0, 0.0), (1.0, 1.0 - stick * stick)])?;
    let pair = MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)?;
    Ok(memory_displacement(&memory, 1.0, 1.0, &pair, [x, y]))
}

/// The stick circle moves as a rigid body, by the shift of the history.
fn rigid_claims(figure: &mut Figure, inner: f64) -> Result<(), Failure> {
    let (nu, friction) = (0.3, 0.4);
    let pair = MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)?;
    let state = Hertz::from_ellipse(ContactEllipse::circle(1.0)?, 1.0, pair)?.at_approach(1.0)?;
    let mut stuck = Vec::new();
    // f κ (ζ_i - ζ_k) with κ = (2 - ν)/(2 (1 - ν)).
    let shift = friction * 1.7 / 1.4 * (1.0 - inner);
    for rho in linspace(0.0, 0.6, 13) {
        for angle in [0.0, 0.7, 2.0] {
            let (x, y) = (rho * libm::cos(angle), rho * libm::sin(angle));
            let [u, v] = displacement(0.6, x, y, nu)?;
            let peak = friction * state.peak_pressure;
            stuck.extend([(peak * u, shift), (peak * v, 0.0)]);
        }
    }
    figure
        .all_close("A_k is displaced as a rigid body, by f κ (ζ_i - ζ_k)", stuck, Absolute(1e-14))
        .source("(6.5), (6.13); f = 0.4, ζ_i = 1, ν = 0.3");
    // a² = R ζ: R = 1 for a = ζ = 1.
    let mut pressed = Vec::new();
    for rho in linspace(0.0, 1.0, 11) {
        pressed.push((normal_displacement(&state, &pair, 0.0, rho)?, 1.0 - 0.5 * rho * rho));
    }
    figure
        .all_close("Hertz's pressure displaces it by ζ - ρ²/(2R)", pressed, Absolute(1e-14))
        .source("shape of the gap between sphere and plane");
    Ok(())
}

fn slip_claims(figure: &mut Figure) -> Result<(), Failure> {
    // While the stick circle shrinks, the annulus slips at the rate ds = a* arccos(a*/ρ) da*, summed from the
    // instant at which its edge passed ρ.
    let stick = 0.5_f64.sqrt();
    let middle = displacement(stick, 0.0, 0.0, 0.0)?[0];
    let mut slips = Vec::new();
    let mut slip = Vec::new();
    for rho in linspace(stick + 1e-3, 1.0, 21) {
        let found = displacement(stick, rho, 0.0, 0.0)?[0] - middle;
        let within = Within::new(1e-14, 1e-12)?;
        let lag = tanh_sinh(stick, rho, within, |at| {
            at.position * libm::acos((at.position / rho).min(1.0))
        })?;
        slips.push((found, -lag.value));
        slip.push(found);
    }
    figure
        .all_close("slip of the ring", slips, Absolute(1e-11))
        .source("(6.11), corrected, as the sum of its rates a* arccos(a*/ρ) da*, ν = 0");
    figure.decreasing("the slip is negative and grows to the edge", slip).source("(6.11)");
    for (nu, expected) in [(0.3, 0.047_34), (0.5, 0.089_42)] {
        let mut most = 0.0_f64;
        for stick in linspace(0.01, 0.99, 99) {
            let whole = displacement(stick, 0.0, 0.0, nu)?[0];
            for rho in linspace(stick, 1.0, 201) {
                let along = displacement(stick, rho, 0.0, nu)?[0];
                let across = displacement(stick, 0.0, rho, nu)?[0];
                most = most.max(0.5 * (along - across).abs() / whole);
            }
        }
        figure
            .close(
                format!("ν = {nu}: largest term in cos 2θ over the stick displacement"),
                most,
                expected,
                Absolute(2e-5),
            )
            .source("independent program; the text says below 5 %");
    }
    Ok(())
}

/// Fig. 6.3.
pub(super) fn virgin_curve() -> FigureResult {
    let mut figure = Figure::new();
    figure.derived("axes", "ξ/(f κ ζ₁), F_x/(f F_z1)");
    let start = follow(&[(1.0, 0.0)])?;
    let mut curve = super::history::path(&start, (1.0, 1.0))?;
    curve.push((1.25, start.clone().advance(1.0, 1.25)?));
    let mut panel = force_panel("First loading (6.14)");
    panel.add(Series::line("F_x", curve.iter().copied()));
    panel.add(Series::dashed("initial slope 3/2", [(0.0, 0.0), (2.0 / 3.0, 1.0)]));
    figure.panel(panel);

    let pairs = curve.iter().take(101).zip(virgin(1.0)).map(|(here, there)| (here.1, there.1));
    figure
        .all_close("F_x = f F_z [1 - (1 - X)^(3/2)]", pairs, Absolute(1e-15))
        .source("(6.14), corrected");
    let slopes = [0.1, 0.3, 0.5, 0.7, 0.9].map(|shift: f64| {
        let force = |shift| follow(&[(1.0, 0.0), (1.0, shift)]).map(|memory| memory.force());
        let step = 1e-5;
        let slope = force(shift + step)
            .and_then(|above| force(shift - step).map(|below| (above - below) / (2.0 * step)));
        (slope.unwrap_or(f64::NAN), 1.5 * (1.0 - shift).sqrt())
    });
    figure
        .all_close("slope (3/2) sqrt(1 - X) = (3/2) a*/a", slopes, Absolute(1e-8))
        .source("(6.15)");
    let last = &curve[99..];
    figure
        .close("horizontal at (1, 1): 1 - F at 0.99", 1.0 - last[0].1, 1e-3, Absolute(1e-12))
        .source("(6.14): 0.01^(3/2)");
    figure.close("constant in sliding", last[2].1, 1.0, Absolute(1e-15)).source("Coulomb's law");
    springs_claim(
        &mut figure,
        "first loading",
        &[(1.0, 0.0), (1.0, 0.25), (1.0, 0.5), (1.0, 0.9)],
    )?;
    reference_claim(
        &mut figure,
        "first loading and more",
        include_str!("../../../data/laws/history_growing.csv"),
    )?;
    sphere_claims(&mut figure)?;
    energy_claims(&mut figure)?;
    figure.deviation(
        "ξ, ζ of one sphere, but G of one sphere in (6.4) and of the pair in (4.7)",
        "relative shift 2ξ and approach 2ζ go with the combined G",
        "mixed conventions of chapters 5 and 6",
    );
    Ok(figure)
}

/// The energies of a first loading, in physical units: c_x = 0.9, c_z = 1.3, f = 0.25, ζ = 0.8.
fn energy_claims(figure: &mut Figure) -> Result<(), Failure> {
    let (c_x, c_z, f, zeta) = (0.9, 1.3, 0.25, 0.8_f64);
    let stiffness = ContactStiffness::new(c_x, c_x, c_z)?;
    let (mut work, mut heat, mut tangents) = (Vec::new(), Vec::new(), Vec::new());
    for share in [0.2_f64, 0.5, 0.9, 1.0] {
        let mut law = Accounted::new(ShiftLaw::<f64>::new(stiffness, Friction::new(f)?));
        law.advance(Shift { zeta, ..Shift::default() })?;
        // ∫ (2/3) c_z sqrt(ζ) ζ dζ.
        let pressed = 4.0 / 15.0 * c_z * libm::pow(zeta, 2.5);
        let end = f * c_z * zeta / c_x;
        law.advance(Shift { zeta, xi: share * end, ..Shift::default() })?;
        let force = 2.0 / 3.0 * f * c_z * zeta * zeta.sqrt();
        // ∫ [1 - (1 - X)^(3/2)] dX, and twice it minus the force times the shift: friction is constant, so
        // that the heat is twice the difference of the work and the energy of a spring with the last force.
        let rest = 1.0 - share;
        let done = share - 0.4 * (1.0 - rest * rest * rest.sqrt());
        let lost = 2.0 * done - share * (1.0 - rest * rest.sqrt());
        let scale = force * end;
        work.push(((law.stored_energy() + law.dissipated() - pressed) / scale, done));
        heat.push((law.dissipated() / scale, lost));
        if share < 1.0 {
            let (stick, tangent) = ((rest * zeta).sqrt(), law.law().tangent());
            tangents.extend([
                (tangent[0][0], c_x * stick),
                (tangent[0][2], f * c_z * (zeta.sqrt() - stick)),
                (tangent[2][2], c_z * zeta.sqrt()),
                (law.law().stick_depth(), rest),
            ]);
        }
    }
    figure
        .all_close(
            "work of the shift, stored and lost, over f F_z ξ at sliding",
            work,
            Absolute(1e-11),
        )
        .source("∫F_x dξ of (6.14); compression stored (2/5) F_z ζ");
    figure
        .all_close("dF_x/dξ, dF_x/dζ, dF_z/dζ and (a*/a)²", tangents, Absolute(1e-13))
        .source("derivatives of (2/3) f c_z [ζ^(3/2) - (ζ - c_x ξ/(f c_z))^(3/2)]");
    figure
        .all_close("and turned into heat", heat, Absolute(1e-11))
        .source("2 ∫F_x dξ - F_x ξ: elastic energy is half of traction times displacement");
    Ok(())
}

/// Two spheres in their own units: shifts of the pair are twice those of one sphere.
fn sphere_claims(figure: &mut Figure) -> Result<(), Failure> {
    let (radius, modulus, nu, zeta, xi) = (0.05, 82_000.0, 0.3, 0.01, 0.001_517_857_142_86);
    let body = Material::from_shear(modulus, nu)?;
    let sphere = PrincipalRadii::sphere(radius)?;
    let hertz =
        Hertz::new(RelativeCurvature::new(sphere, sphere, 0.0)?, MaterialPair::new(body, body)?)?;
    let mut law = ShiftLaw::<f64>::new(hertz.stiffness(), Friction::new(0.25)?);
    let pressed = law.advance(Shift { zeta: 2.0 * zeta, ..Shift::default() })?;
    let a = (radius * zeta).sqrt();
    let little = Shift { zeta: 2.0 * zeta, xi: 2e-9, ..Shift::default() };
    let slope = law.clone().advance(little)?.f_x / 1e-9;
    let loaded = law.advance(Shift { zeta: 2.0 * zeta, xi: 2.0 * xi, ..Shift::default() })?;
    figure
        .close(
            "initial slope of two spheres",
            slope,
            8.0 * modulus * a / (2.0 - nu),
            Relative(1e-6),
        )
        .source("(6.15): 8Ga/(2 - ν) for ξ of one sphere");
    figure
        .all_close(
            "F_z and F_x of two spheres",
            [(pressed.f_z, 69.850_504_439_993_43), (loaded.f_x, 11.288_655_440_163_24)],
            Relative(1e-11),
        )
        .source("40-digit program, R = 0.05, G = 82 000, ν = 0.3, f = 0.25, ζ = 0.01");
    let mu = 4.0 * 0.25 * modulus / (PI * radius * (1.0 - nu));
    figure
        .close(
            "f F_z = (2πμ/3) a³",
            0.25 * pressed.f_z,
            TAU * mu / 3.0 * (a * a * a),
            Relative(1e-13),
        )
        .source("(6.4), (6.5)");
    Ok(())
}
