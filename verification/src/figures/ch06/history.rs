//! Common functions of the figures of the chapter: histories, their stresses, and how both are checked.
//!
//! Approaches and shifts are in units of the first approach, `zeta/zeta_1` and
//! `X = xi/(f kappa zeta_1)`; radii in a_1, so that `(a/a_1)^2 = zeta/zeta_1`; stresses in mu a_1,
//! the greatest friction at zeta_1; forces in f F_z1.

use carom_laws::memory::ScalarMemory;
use carom_special::RangeError;
use carom_special::quadrature::{Tolerance as Within, tanh_sinh};

pub(super) use super::springs::Place;
use super::springs::Springs;
use crate::reference::rows;
use crate::{Absolute, Failure, Figure, Panel, Series, linspace};

/// The axes of a stress distribution.
pub(super) fn stress_panel(title: &str) -> Panel {
    Panel::new("ρ/a₁", "σ_zx / (μ a₁)").titled(title)
}

/// The axes of force against shift.
pub(super) fn force_panel(title: &str) -> Panel {
    Panel::new("ξ / (f κ ζ₁)", "F_x / (f F_z1)").titled(title)
}

/// The memory at the end of a history.
pub(super) fn follow(history: &[Place]) -> Result<ScalarMemory, RangeError> {
    let mut memory = ScalarMemory::new();
    for &(zeta, shift) in history {
        memory.advance(zeta, shift)?;
    }
    Ok(memory)
}

/// Shift and force along a straight path, both ends included.
pub(super) fn path(
    memory: &ScalarMemory,
    (zeta, shift): Place,
) -> Result<Vec<(f64, f64)>, RangeError> {
    let (from_zeta, from_shift) = (memory.zeta(), memory.shift());
    linspace(0.0, 1.0, 101)
        .into_iter()
        .map(|part| {
            let here = from_shift + part * (shift - from_shift);
            let force = memory.clone().advance(from_zeta + part * (zeta - from_zeta), here)?;
            Ok((here, force))
        })
        .collect()
}

/// The virgin curve (6.14), (6.31) at an approach, up to sliding.
pub(super) fn virgin(zeta: f64) -> impl Iterator<Item = (f64, f64)> {
    linspace(0.0, zeta, 101).into_iter().map(move |shift| (shift, virgin_force(zeta, shift)))
}

pub(super) fn virgin_force(zeta: f64, shift: f64) -> f64 {
    zeta * zeta.sqrt() - (zeta - shift) * (zeta - shift).sqrt()
}

/// The stress on body 1 at a radius.
pub(super) fn stress(memory: &ScalarMemory, rho: f64) -> f64 {
    let zeta = memory.zeta();
    zeta.sqrt() * memory.traction(rho * rho / zeta)
}

/// The Cattaneo-Mindlin function (6.3) of the radii squared.
pub(super) fn sigma(outer: f64, inner: f64, rho: f64) -> f64 {
    let part = |square: f64| (square - rho * rho).max(0.0).sqrt();
    part(outer) - part(inner)
}

/// A sum of Cattaneo-Mindlin functions: factor, outer and inner radius squared.
pub(super) type Terms<'a> = &'a [(f64, f64, f64)];

pub(super) fn sum(terms: Terms<'_>, rho: f64) -> f64 {
    terms.iter().map(|&(factor, outer, inner)| factor * sigma(outer, inner, rho)).sum()
}

/// A curve of stress against radius, with points at the ends of all terms.
pub(super) fn profile(squares: &[f64], stress: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let most = squares.iter().fold(1.0_f64, |most, square| most.max(*square)).sqrt();
    let mut radii = linspace(0.0, most, 301);
    for square in squares {
        radii.extend([square.sqrt() - 1e-4, square.sqrt() - 1e-3, square.sqrt()]);
    }
    radii.sort_by(f64::total_cmp);
    radii.into_iter().map(|rho| (rho, stress(rho))).collect()
}

/// The ends of all terms, radii squared.
pub(super) fn ends(terms: Terms<'_>) -> Vec<f64> {
    terms.iter().flat_map(|&(_, outer, inner)| [outer, inner]).collect()
}

/// Draws the terms (dashed lines), each with its name, and their sum.
pub(super) fn add_terms(panel: &mut Panel, names: &[&str], terms: Terms<'_>, total: &str) {
    for (name, term) in names.iter().zip(terms) {
        let term = std::slice::from_ref(term);
        panel.add(Series::dashed(*name, profile(&ends(term), |rho| sum(term, rho))));
    }
    panel.add(Series::line(total, profile(&ends(terms), |rho| sum(terms, rho))));
}

/// Claims for a stress distribution: it equals the sum of the thesis, obeys Coulomb's law, and its quadrature
/// gives the force and the shift of the history.
pub(super) fn stress_claims(
    figure: &mut Figure,
    name: &str,
    history: &[Place],
    terms: Terms<'_>,
    equation: &str,
) -> Result<(), Failure> {
    let memory = follow(history)?;
    let (zeta, shift) = (memory.zeta(), memory.shift());
    let edge = zeta.sqrt();
    let radii = linspace(0.0, 0.9999 * edge, 201);
    let pairs = radii.iter().map(|&rho| (stress(&memory, rho), sum(terms, rho)));
    figure.all_close(format!("{name}: the stress"), pairs, Absolute(1e-13)).source(equation);
    let excess = radii.iter().map(|&rho| stress(&memory, rho).abs() - (zeta - rho * rho).sqrt());
    figure
        .at_most(format!("{name}: |σ_zx| - f p_z"), excess.fold(f64::NEG_INFINITY, f64::max), 1e-14)
        .source("Coulomb's law");
    let mut squares: Vec<f64> = ends(terms).into_iter().filter(|&end| end > 0.0).collect();
    squares.extend([0.0, zeta]);
    squares.retain(|&square| square <= zeta);
    squares.sort_by(f64::total_cmp);
    let (mut force, mut displacement) = (0.0, 0.0);
    let within = Within::new(1e-12, 1e-11)?;
    for pair in squares.windows(2).filter(|pair| pair[1] - pair[0] > 1e-12) {
        let (low, high) = (pair[0].sqrt(), pair[1].sqrt());
        force +=
            tanh_sinh(low, high, within, |at| at.position * stress(&memory, at.position))?.value;
        displacement += tanh_sinh(low, high, within, |at| stress(&memory, at.position))?.value;
    }
    figure
        .all_close(
            format!("{name}: force and shift of the centre"),
            [(3.0 * force, memory.force()), (4.0 / std::f64::consts::PI * displacement, shift)],
            Absolute(1e-8),
        )
        .source("∫σ ρ dρ and Cerruti's ∫σ dρ by quadrature of the stress");
    Ok(())
}

/// Rows of a reference history: approach, shift, force, zeta*.
pub(super) fn reference_claim(figure: &mut Figure, name: &str, csv: &str) -> Result<(), Failure> {
    let table = rows::<4>(csv)?;
    let mut memory = ScalarMemory::new();
    let (mut forces, mut depths) = (Vec::new(), Vec::new());
    for [zeta, shift, force, depth] in table {
        forces.push((memory.advance(zeta, shift)?, force));
        depths.push((memory.stick_depth(), depth));
    }
    let source = "40-digit program, two equal spheres, G = 82 000, ν = 0.3, f = 0.25";
    figure.all_close(format!("{name}: forces"), forces, Absolute(1e-10)).source(source);
    figure.all_close(format!("{name}: ζ*"), depths, Absolute(1e-9)).source(source);
    Ok(())
}

/// Claims that forces, stored and dissipated energies at the corners of a history equal those of a bed of
/// springs.
pub(super) fn springs_claim(
    figure: &mut Figure,
    name: &str,
    history: &[Place],
) -> Result<(), Failure> {
    let deepest = history.iter().map(|place| place.0).fold(0.0, f64::max);
    let (mut memory, mut springs) = (ScalarMemory::new(), Springs::new(deepest));
    let (mut pairs, mut energies, mut heat) = (Vec::new(), Vec::new(), 0.0);
    for &place in history {
        heat += memory.dissipation(place.0, place.1);
        pairs.push((memory.advance(place.0, place.1)?, springs.advance(place)));
        energies.push((memory.stored_energy(), springs.energy()));
        energies.push((heat, springs.heat()));
    }
    figure
        .all_close(format!("{name}: forces at the corners"), pairs, Absolute(1e-3))
        .source("2000 independent springs with friction, 1000 steps a side");
    figure
        .all_close(
            format!("{name}: energy stored and turned into heat up to the corners"),
            energies,
            Absolute(1e-3),
        )
        .source("the same springs: half of stiffness times stretch squared, friction times slip");
    Ok(())
}
