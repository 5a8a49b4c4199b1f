//! Fig. 3.3: the tangential stress of Cattaneo and Mindlin for several shifts.

use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::shift::{CattaneoMindlin, ShiftState};
use carom_laws::stiffness::ContactStiffness;
use carom_special::quadrature::GaussLegendre;
use carom_special::{AxisRatio, RangeError};

use super::super::sphere_traction;
use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Panel, Relative, Series, linspace};

const FRICTION: f64 = 0.5;
const SHIFTS: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];

/// A contact of c_z = 1 under ζ = 1, whose ellipse has a = 1.
struct Contact {
    law: CattaneoMindlin,
    stiffness: ContactStiffness,
    ellipse: ContactEllipse,
}

impl Contact {
    fn new(ratio: f64, nu: f64) -> Result<Self, RangeError> {
        let stiffness = ContactStiffness::from_axis_ratio(1.0, AxisRatio::new(ratio)?, nu)?;
        let law = CattaneoMindlin::new(stiffness, Friction::new(FRICTION)?);
        Ok(Self { law, stiffness, ellipse: ContactEllipse::new(1.0, 1.0 / ratio)? })
    }

    /// The state whose c_x ξ/(f c_z ζ) is `share`.
    fn at(&self, share: f64) -> Result<ShiftState, RangeError> {
        self.law.at_shift(1.0, share * FRICTION / self.stiffness.c_x, 0.0)
    }

    /// σ_zx/(f σ_z0) at (x, 0).
    fn stress(&self, state: &ShiftState, x: f64) -> f64 {
        let peak = 1.5 * state.normal_force / self.ellipse.area();
        state.traction(&self.ellipse, x, 0.0)[0] / (FRICTION * peak)
    }
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("F_y, η", "0, and y = 0");
    figure.assumed("c_x ξ/(f c_z ζ)", "0.2, 0.4, 0.6, 0.8, 1");
    figure.assumed("axes", "x/a, σ_zx/(f σ_z0)");
    let contact = Contact::new(1.0, 0.3)?;
    let mut panel =
        Panel::new("x/a", "σ_zx / (f σ_z0)").titled("Stress for shifts c_x ξ/(f c_z ζ)");
    for share in SHIFTS {
        let (state, mut xs) = (contact.at(share)?, linspace(-1.0, 1.0, 401));
        xs.extend([-state.stick_radius(), state.stick_radius()]);
        xs.sort_by(f64::total_cmp);
        let curve = xs.into_iter().map(|x| (x, contact.stress(&state, x)));
        panel.add(Series::line(format!("{share}"), curve));
    }
    figure.panel(panel);
    stress_claims(&mut figure, &contact)?;
    force_claims(&mut figure, &contact)?;
    table_claims(&mut figure)?;
    figure.deviation(
        "σ₁ = f σ_z0 divided by the root in (3.11)",
        "σ₁ = f σ_z0 times the root, σ₂ = f σ_z0 (a*/a) times the root",
        "misread product; (5.23) has it right",
    );
    Ok(figure)
}

fn stress_claims(figure: &mut Figure, contact: &Contact) -> Result<(), Failure> {
    let (mut excess, mut ring, mut shape, mut slender) =
        (0.0_f64, Vec::new(), Vec::new(), Vec::new());
    let ellipse = Contact::new(0.2, 0.45)?;
    for share in SHIFTS {
        let (state, other) = (contact.at(share)?, ellipse.at(share)?);
        let stick = (1.0 - share).sqrt();
        for x in linspace(-0.999, 0.999, 101) {
            let (stress, limit) = (contact.stress(&state, x), (1.0 - x * x).sqrt());
            excess = excess.max(stress - limit);
            if x.abs() > stick {
                ring.push((stress, limit));
            }
            let rest = (stick * stick - x * x).max(0.0).sqrt();
            shape.push((stress, limit - rest));
            slender.push((ellipse.stress(&other, x), stress));
        }
    }
    figure.at_most("σ_zx never exceeds f p_z", excess, 1e-15).source("Coulomb");
    figure.all_close("and equals it in the slip ring", ring, Absolute(1e-15)).source("Coulomb");
    figure.all_close("σ₁ - σ₂", shape, Absolute(1e-14)).source("(3.11), corrected");
    figure
        .all_close("the same for a/b = 0.2, ν = 0.45", slender, Absolute(1e-14))
        .source("text below (5.27)");
    Ok(())
}

/// Force and shift recovered from the stress alone.
fn force_claims(figure: &mut Figure, contact: &Contact) -> Result<(), Failure> {
    let rule = GaussLegendre::new(40)?;
    let (mut forces, mut inner) = (Vec::new(), Vec::new());
    for share in [0.2, 0.4, 0.6, 0.8] {
        let state = contact.at(share)?;
        let stick = state.stick_radius();
        // F_x/(f F_z) = 3 ∫ σ/(f σ_z0) r dr on the circle; r = edge sin t smooths each part.
        let part = |low: f64, high: f64| {
            rule.integrate(0.0, 1.0, |t| {
                let rest = 1.0 - t;
                let r = high - (high - low) * rest * rest;
                2.0 * (high - low) * rest * r * contact.stress(&state, r)
            })
        };
        let force = 3.0 * (part(0.0, stick) + part(stick, 1.0));
        forces.push((force, 1.0 - stick * stick * stick));
        inner.push((state.force[0] / (FRICTION * state.normal_force), force));
    }
    figure
        .all_close("∫σ_zx dS = f F_z (1 - (a*/a)³)", forces, Relative(1e-9))
        .source("quadrature of the drawn stress against (3.12)");
    figure
        .all_close("and is the force of the law", inner, Relative(1e-9))
        .source("quadrature of the drawn stress");
    let mut inverse = Vec::new();
    for share in [0.2_f64, 0.4, 0.6, 0.8] {
        let rest = 1.0 - share;
        // F_z = (2/3) c_z ζ^(3/2), and the force of (3.12).
        let force = FRICTION * 2.0 / 3.0 * (1.0 - rest * rest.sqrt());
        let state = contact.law.at_force(1.0, force, 0.0)?;
        let xi = share * FRICTION / contact.stiffness.c_x;
        inverse.extend([(state.shift[0], xi), (state.stick_depth(), rest)]);
    }
    figure
        .all_close("shift and stick area under that force", inverse, Absolute(1e-13))
        .source("(5.28), (5.29): the inverse of (3.12) worked out");
    // c_z = 4 G a/(1 - ν) at ζ = 1, a = 1, and σ_z0 = c_z/π.
    let nu = 0.3;
    let (modulus, peak) = (0.25 * (1.0 - nu), std::f64::consts::FRAC_1_PI);
    let shifts = [0.2_f64, 0.4, 0.6, 0.8].map(|share| {
        let stick = (1.0 - share).sqrt();
        let outer = sphere_traction::along(1.0, 0.0, nu);
        let inner = stick * sphere_traction::along(stick, 0.0, nu);
        let xi = share * FRICTION / contact.stiffness.c_x;
        (FRICTION * peak / modulus * (outer - inner), xi)
    });
    figure
        .all_close("the stress displaces the centre by ξ", shifts, Relative(1e-14))
        .source("displacement (3.17), corrected");
    let state = contact.at(0.6)?;
    let stick = state.stick_radius();
    let steep = (contact.stress(&state, stick) - contact.stress(&state, stick - 1e-8)) / 1e-8;
    // sqrt(2 a* h) over h, and the slope of the limit.
    let expected = (2.0 * stick / 1e-8).sqrt() - stick / (1.0 - stick * stick).sqrt();
    figure
        .close("slope just inside a*, over 1e-8 a", steep, expected, Relative(1e-5))
        .source("vertical: the square root of σ₂ at a*");
    Ok(())
}

fn table_claims(figure: &mut Figure) -> Result<(), Failure> {
    let table = rows::<11>(include_str!("../../../data/laws/cattaneo.csv"))?;
    let mut pairs = Vec::new();
    for [ratio, nu, c_z, f, zeta, xi, eta, stick, f_x, f_y, f_z] in table {
        let stiffness = ContactStiffness::from_axis_ratio(c_z, AxisRatio::new(ratio)?, nu)?;
        let state = CattaneoMindlin::new(stiffness, Friction::new(f)?).at_shift(zeta, xi, eta)?;
        let size = libm::hypot(f_x, f_y).max(1e-15 * f * f_z);
        pairs.extend([
            (state.stick_depth(), stick),
            (state.force[0] / size, f_x / size),
            (state.force[1] / size, f_y / size),
            (state.normal_force / f_z, 1.0),
        ]);
    }
    figure
        .all_close("stick area and forces of 84 shifts", pairs, Absolute(1e-12))
        .source("(5.25)-(5.27) in 25 digits by an independent program");
    Ok(())
}
