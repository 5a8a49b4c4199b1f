//! Corrections of chapters 3 and 4.

use crate::Failure;
use carom_halfspace::{
    Force, LoadedRectangle, Material, MaterialPair, Offset, Point, PointLoad, Rectangle, Traction,
};
use carom_impact::closed_form::wave_loss_coefficient;
use carom_laws::field::circular_shear;
use carom_special::quadrature::GaussLegendre;
use std::f64::consts::{PI, TAU};

use super::Correction;

const NU: f64 = 0.3;

pub(super) fn corrections() -> Result<Vec<Correction>, Failure> {
    Ok(vec![waves()?, semisphere()?, point_force()?, inside()?, cell()?])
}

fn waves() -> Result<Correction, Failure> {
    Ok(Correction {
        equation: "3.2",
        printed: r"$1.04\,(v_A/\sqrt{E/\rho})^{3/5}$",
        corrected: r"$1.112\,(v_A/\sqrt{E/\rho})^{3/5}$ for $\nu=1/4$",
        check: "coefficient of the energy that waves carry off, ν = 1/4",
        value: wave_loss_coefficient(0.25)?,
        expected: 1.112,
        as_printed: Some(1.04),
        tolerance: 1e-3,
        source: "independent quadrature of the radiation of a half-space",
    })
}

/// Displacement in the middle of a semispherical traction on two equal bodies.
fn semisphere() -> Result<Correction, Failure> {
    let body = Material::from_shear(1.0, NU)?;
    let pair = MaterialPair::new(body, body)?;
    let rule = GaussLegendre::new(24)?;
    // A ring at a time: the displacement falls as 1/r, which dS takes away.
    let load = PointLoad::new(body, Force { x: 1.0, ..Force::default() })?;
    let mut sum = 0.0;
    for radius in rule.on(0.0, 1.0) {
        // r = sin t makes the root smooth.
        let (r, dr) = libm::sincos(0.5 * PI * radius.position);
        let jacobian = 0.5 * PI * dr * dr; // root times cosine
        for turn in rule.on(0.0, TAU) {
            let (y, x) = libm::sincos(turn.position);
            let at = load.displacement(Point::on_surface(r * x, r * y))?;
            sum += radius.weight * turn.weight * jacobian * r * at.u;
        }
    }
    let value = circular_shear(1.0, 1.0, &pair, 0.0, 0.0)[0];
    Ok(Correction {
        equation: "3.17",
        printed: r"$u=\frac{\pi C}{16Ga}[2(2-\nu)(2a^2-\rho^2)+\ldots]$",
        corrected: r"$u=\frac{\pi C}{32Ga}[2(2-\nu)(2a^2-\rho^2)+\ldots]$, $G$ of (4.7)",
        check: "displacement in the middle of the traction, ν = 0.3",
        value,
        expected: 2.0 * sum,
        as_printed: Some(2.0 * value),
        tolerance: 1e-8,
        source: "quadrature of point forces",
    })
}

/// Hooke's law between the displacement and the stress of a point force.
fn point_force() -> Result<Correction, Failure> {
    let body = Material::from_shear(1.0, NU)?;
    let force = Force { x: 0.7, y: -0.4, z: 1.1 };
    let load = PointLoad::new(body, force)?;
    let (at, h) = (Point { x: 0.5, y: 0.8, z: 0.6 }, 1e-3);
    let moved = |dx: f64, dy: f64| load.displacement(Point { x: at.x + dx, y: at.y + dy, z: at.z });
    // Five points: the error is of fourth order.
    let slope =
        |values: [f64; 4]| (8.0 * (values[2] - values[1]) - values[3] + values[0]) / (12.0 * h);
    let mut along_y = [0.0; 4];
    let mut along_x = [0.0; 4];
    for (i, step) in [-2.0, -1.0, 1.0, 2.0].into_iter().enumerate() {
        along_y[i] = moved(0.0, step * h)?.u;
        along_x[i] = moved(step * h, 0.0)?.v;
    }
    Ok(Correction {
        equation: "4.1",
        printed: r"$T=xF_x+yF_y$; $2(1-\nu)F_z/(z+r)$ in $u$; $(1-2\nu)F_y y$ in $v$",
        corrected: r"$T=\frac{xF_x+yF_y}{r}$; $2(1-\nu)F_x/(z+r)$; $(1-2\nu)F_z y$",
        check: "G(∂u/∂y + ∂v/∂x) of an oblique force, at a depth",
        value: slope(along_y) + slope(along_x),
        expected: load.stress(at)?.xy,
        as_printed: None,
        tolerance: 1e-8,
        source: "the stress (4.2), (4.3), which the print has right",
    })
}

/// Normal displacement below a rectangle under pressure.
fn inside() -> Result<Correction, Failure> {
    let body = Material::from_shear(1.0, NU)?;
    let at = Point { x: 0.3, y: 0.4, z: 0.7 };
    let loaded = LoadedRectangle::new(body, Rectangle::new(1.0, 0.6)?)?;
    let value = loaded.displacement(Traction { normal: 1.0, ..Traction::default() }, at)?.w;
    let load = PointLoad::new(body, Force { z: 1.0, ..Force::default() })?;
    let rule = GaussLegendre::new(24)?;
    let (mut sum, mut other) = (0.0, 0.0);
    for across in rule.on(-0.3, 0.3) {
        for along in rule.on(-0.5, 0.5) {
            let from = Point { x: at.x - along.position, y: at.y - across.position, z: at.z };
            let weight = along.weight * across.weight;
            sum += weight * load.displacement(from)?.w;
            // The last term by the potential N of (4.4) with the other sign.
            let r = libm::hypot(libm::hypot(from.x, from.y), from.z);
            other += weight * (2.0 / r) / (4.0 * PI);
        }
    }
    Ok(Correction {
        equation: "4.4",
        printed: r"$4\pi Gw=\ldots-z\,\partial_z^2\psi-\partial_z^2N$",
        corrected: r"$4\pi Gw=\ldots-z\,\partial_z^2\psi+\partial_z^2N$",
        check: "displacement w below a rectangle under pressure",
        value,
        expected: sum,
        as_printed: Some(sum - other),
        tolerance: 1e-12,
        source: "quadrature of point forces (4.1)",
    })
}

/// The normal influence of a cell two widths away, in units of half a width.
fn cell() -> Result<Correction, Failure> {
    let cell = Rectangle::new(2.0, 2.0)?;
    let value = cell.integrals(Offset { x: 4.0, y: 0.0 })?.inverse_distance;
    let k = 2.0;
    let [far, near] = [2.0 * k + 1.0, 2.0 * k - 1.0];
    let [one, two] = [far, near].map(|side: f64| (side * side + 1.0).sqrt());
    let log = |root: f64| libm::log((root + 1.0) / (root - 1.0));
    let formula = |second: f64, last: f64| {
        far * log(one) - second * log(two) + 2.0 * libm::log((far + one) / (near + last))
    };
    Ok(Correction {
        equation: "13.9",
        printed: r"$\ldots-(2k{+}1)\ln\frac{S_2+1}{S_2-1}+2\ln\frac{2k+1+S_1}{2k-1+S_1}$",
        corrected: r"$\ldots-(2k{-}1)\ln\frac{S_2+1}{S_2-1}+2\ln\frac{2k+1+S_1}{2k-1+S_2}$",
        check: "∫dS/r of a cell two widths away, over half a width",
        value,
        expected: formula(near, two),
        as_printed: Some(formula(far, one)),
        tolerance: 1e-13,
        source: "the corrected formula, found by quadrature in twelve digits",
    })
}
