//! A case of CONTACT as a case of carom.

use super::case::{Asked, ContactCase, Motion};
use crate::Error;
use carom_solver::Driven;
use std::fmt::Write as _;

/// Metres in a millimetre.
const MILLIMETRE: f64 = 1e-3;
/// Pascals in a newton per square millimetre.
const MEGAPASCAL: f64 = 1e6;
/// How far the middle of the cells may be from the origin, in cells.
const ROUNDING: f64 = 1e-9;

/// The case of this number as TOML for `carom roll` or `carom solve`, in SI units.
///
/// # Errors
/// [`Error`] if the file has no such case, or a case of carom cannot state it.
pub fn toml(cases: &[ContactCase], number: usize) -> Result<String, Error> {
    let case = cases.iter().find(|case| case.number == number).ok_or_else(|| {
        Error::input(format!("the file has no case {number} to solve: it has {}", cases.len()))
    })?;
    written(case).map_err(|what| {
        Error::input(format!("line {}: no case of carom states {what}", case.line))
            .at("case", case.number)
    })
}

fn written(case: &ContactCase) -> Result<String, &'static str> {
    let continues = case.begin != super::case::Begin::Apart;
    let middle = case.area.middle();
    let aside = (0..2).any(|i| middle[i].abs() > ROUNDING * case.area.size[i]);
    let [a, b] = case
        .surface
        .coefficients()
        .filter(|[a, b]| *a > 0.0 && *b > 0.0)
        .ok_or("this undeformed distance (IBASE, IPLAN): only A1 x^2 + B1 y^2 with both > 0")?;
    let rolling = match case.motion {
        Motion::Step(_) => return Err("a single step of rolling (T = 2)"),
        Motion::Steady(rolling) => Some(rolling),
        Motion::None | Motion::Shift => None,
    };
    for (holds, what) in [
        (continues, "a case that continues from another one (P = 0 or 1)"),
        (aside, "cells whose middle is not the origin (XL, YL)"),
        (case.extra.is_some(), "extra rigid slip (E)"),
        (case.friction.len() > 1, "friction of rows (V = 2)"),
        (case.fastsim.is_some(), "FASTSIM (M = 2 or 3)"),
        (case.drive.spin_centre != [0.0; 2], "a spin beside the origin (SPINXO, SPINYO)"),
        (!case.blocks.is_empty(), "points below the surface (S)"),
    ] {
        if holds {
            return Err(what);
        }
    }
    let mut text = format!("# Case {} of an input of CONTACT, in SI units.\n", case.number);
    head(case, [a, b], &mut text);
    match rolling {
        Some(rolling) => {
            let _ = write!(
                text,
                "\n[contact]\nfriction = {}\n\n[rolling]\nspeed = {}\ndirection = {}\nstep = {}\nspin_offset = {}\n",
                friction(case),
                rolling.veloc * MILLIMETRE,
                rolling.chi.to_degrees(),
                rolling.dq * MILLIMETRE,
                rolling.facphi,
            );
            motions(case, ["zeta", "creepage", "creepage_across", "spin"], &mut text)?;
        }
        None => {
            if case.motion == Motion::Shift {
                let _ = write!(text, "\n[contact]\nfriction = {}\n", case.friction[0]);
            }
            text.push_str("\n[[step]]\n");
            motions(case, ["zeta", "xi", "eta", "omega"], &mut text)?;
        }
    }
    Ok(text)
}

/// One coefficient, or that of the slip speed in m/s.
fn friction(case: &ContactCase) -> String {
    let law = case.falling.and_then(|falling| falling.law().ok());
    law.map_or_else(
        || case.friction[0].to_string(),
        |law| {
            let [a, b, c] = law.coefficients();
            format!("{{ a = {a}, b = {b}, c = {} }}", c / MILLIMETRE)
        },
    )
}

/// Bodies, gap and grid.
fn head(case: &ContactCase, [a, b]: [f64; 2], text: &mut String) {
    for (name, body) in [("1", case.materials.body_1()), ("2", case.materials.body_2())] {
        let (modulus, poisson) = (body.shear_modulus() * MEGAPASCAL, body.poisson());
        let _ = write!(
            text,
            "\n[body_{name}]\nmaterial = {{ shear_modulus = {modulus}, poisson = {poisson} }}\n"
        );
    }
    if let Some(name) = &case.influence {
        let _ = write!(text, "\n[bodies.influence]\nfile = {name:?}\n");
    }
    let [x, y] = [a, b].map(|coefficient| 0.5 * MILLIMETRE / coefficient);
    let _ = write!(text, "\n[gap]\nshape = \"paraboloid\"\nradii = [{x}, {y}]\n");
    let ([nx, ny], [dx, dy]) = (case.area.cells, case.area.size);
    let size = [nx as f64 * dx, ny as f64 * dy].map(|side| side * MILLIMETRE);
    let _ = write!(
        text,
        "\n[grid]\ncells = [{nx}, {ny}]\nsize = [{}, {}]\ncut = true\n",
        size[0], size[1]
    );
}

/// The four motions, those of body 2 against body 1.
fn motions(case: &ContactCase, names: [&str; 4], text: &mut String) -> Result<(), &'static str> {
    let is_steady = matches!(case.motion, Motion::Steady(_));
    let length = if is_steady { 1.0 } else { MILLIMETRE };
    let per_length = if is_steady { 1.0 / MILLIMETRE } else { 1.0 };
    let force = match case.drive.normal {
        Driven::Load(force) => {
            let _ = writeln!(text, "F_z = {force}");
            Some(case.scale() * force)
        }
        Driven::Shift(approach) => {
            let _ = writeln!(text, "{} = {}", names[0], approach * MILLIMETRE);
            None
        }
    };
    if case.motion == Motion::None {
        return Ok(());
    }
    for (i, load) in ["F_x", "F_y"].into_iter().enumerate() {
        let _ = match (case.drive.along[i], force) {
            (Asked::Creepage(given), _) => {
                writeln!(text, "{} = {}", names[i + 1], 0.0 - given * length)
            }
            (Asked::Force(part), Some(force)) => writeln!(text, "{load} = {}", part * force),
            (Asked::Force(_), None) => return Err("relative forces at a given approach (N = 0)"),
        };
    }
    let _ = writeln!(text, "{} = {}", names[3], case.drive.spin * per_length);
    Ok(())
}
