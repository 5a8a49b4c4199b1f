//! The eight propositions: where each stands, and what can be checked of the first, the second and
//! the seventh, which belong to other chapters.

use crate::{
    Absolute, Axis, Failure, Figure, FigureResult, Panel, Relative, Series, Table, linspace,
};
use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::VectorMemory;
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::lubkin::Lubkin;
use std::f64::consts::PI;

/// Number, subject, page or figures.
const PLACES: [[&str; 3]; 8] = [
    ["1", "a shift in axes turned against those of the contact, with slip", "3.5, below"],
    [
        "2",
        "slip directions where the shift turns",
        "7.13 to 7.15, 14.7 to 14.13, accuracy.turning, below",
    ],
    ["3", "a rigid punch on a simply supported plate", "proposition-3"],
    ["4", "a flange at the end of a tube", "proposition-4"],
    ["5", "expansion bellows with large deformation", "proposition-5"],
    ["6", "the half-space by fast Fourier transforms", "proposition-6"],
    [
        "7",
        "torsion under varying twist and normal force",
        "7.11, 10.1, 10.2, 14.22 to 14.24, below",
    ],
    ["8", "operations of elimination and of fast products", "proposition-8"],
];

/// Shifts at the approach 1, with slip and a turn.
const PATH: [[f64; 2]; 5] = [[0.4, 0.0], [0.4, 0.5], [-0.3, 0.6], [-0.3, -0.2], [0.5, -0.4]];

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [cos * x - sin * y, sin * x + cos * y]
}

/// The force after each shift of a path.
fn forces(path: impl IntoIterator<Item = [f64; 2]>) -> Result<Vec<[f64; 2]>, Failure> {
    let mut memory = CoulombMemory::<[f64; 2]>::new(Tolerance::FINE);
    memory.advance(1.0, [0.0; 2])?;
    path.into_iter().map(|shift| Ok(memory.advance(1.0, shift)?)).collect()
}

/// Proposition 1: the forces of a circle do not depend on the axes, with slip and with memory.
fn axes(figure: &mut Figure) -> Result<(), Failure> {
    let plain = forces(PATH)?;
    for angle in [0.7, 2.3] {
        let found = forces(PATH.map(|shift| turned(shift, angle)))?;
        let expected = plain.iter().map(|force| turned(*force, angle));
        let pairs = found.iter().zip(expected).flat_map(|(a, b)| [(a[0], b[0]), (a[1], b[1])]);
        figure
            .all_close(
                format!("1: forces after a path with slip, axes turned by {angle} rad"),
                pairs,
                Absolute(1e-9),
            )
            .source("turned forces of the path that was not turned");
    }
    Ok(())
}

/// Proposition 2: with one direction of traction in a slip annulus the law is right along a line only.
fn directions(figure: &mut Figure) -> Result<(), Failure> {
    let both = |path: &[[f64; 2]]| -> Result<Vec<(f64, f64)>, Failure> {
        let mut fixed = VectorMemory::new();
        fixed.advance(1.0, [0.0; 2])?;
        let every = forces(path.iter().copied())?;
        let pairs = path.iter().zip(every).map(|(shift, force)| {
            let one = fixed.advance(1.0, *shift)?;
            Ok([(one[0], force[0]), (one[1], force[1])])
        });
        let pairs: Result<Vec<_>, Failure> = pairs.collect();
        Ok(pairs?.concat())
    };
    let line: Vec<_> = [0.6, -0.5, 0.2, -0.7].map(|x| [0.6 * x, 0.8 * x]).to_vec();
    figure
        .all_close(
            "2: along a line one direction in each annulus is exact",
            both(&line)?,
            Absolute(1e-6),
        )
        .source("law in which each annulus slips by itself");
    let square = [[0.5, 0.0], [0.5, 0.5], [0.0, 0.5], [0.0, 0.0]];
    let off = both(&square)?.into_iter().map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    figure
        .at_least("2: around a square it is off, of the friction limit", off, 0.01)
        .source("law in which each annulus slips by itself");
    Ok(())
}

/// Twist of a history of radius 1, (2/pi)(K - E), over that of Lubkin, (3/(4 pi))(K - E).
const TWIST: f64 = 8.0 / 3.0;

/// Proposition 7: Deresiewicz's loop, and histories that leave the same state.
fn torsion(figure: &mut Figure) -> Result<(), Failure> {
    let sliding = 3.0 * PI / 32.0;
    let torque = |twist: f64| -> Result<f64, Failure> {
        Ok(sliding * Lubkin::at_twist(twist)?.torque() / (3.0 * PI / 16.0))
    };
    let greatest = 0.12;
    let mut history = TwistHistory::new();
    history.advance(1.0, 0.0)?;
    history.advance(1.0, TWIST * greatest)?;
    let mut pairs = vec![(history.torque(), torque(greatest)?)];
    let mut path = vec![(greatest, history.torque() / sliding)];
    for back in linspace(0.0, 2.0 * greatest, 25).into_iter().skip(1) {
        history.advance(1.0, TWIST * (greatest - back))?;
        pairs.push((history.torque(), torque(greatest)? - 2.0 * torque(0.5 * back)?));
        path.push((greatest - back, history.torque() / sliding));
    }
    figure
        .all_close("7: torque of a loop at constant force", pairs, Relative(1e-9))
        .source("Deresiewicz: M - M₁ = -2 L((β₁ - β)/2), L by Lubkin");
    let mut panel =
        Panel::new(Axis::linear("G a² β / (f F_z)"), Axis::linear("M_z over that of sliding"))
            .titled("7: half a loop of Deresiewicz");
    panel.add(Series::line("", path));
    figure.panel(panel);
    // A small loop, and growth and loss of force, leave no trace once the twist goes beyond.
    let end = |between: &[[f64; 2]]| -> Result<f64, Failure> {
        let mut history = TwistHistory::new();
        for [radius, twist] in [&[[1.0, 0.0], [1.0, 0.3]][..], between, &[[1.0, 0.9]]].concat() {
            history.advance(radius, twist)?;
        }
        Ok(history.torque())
    };
    let direct = end(&[])?;
    let detours = [end(&[[1.0, 0.1], [1.0, 0.3]])?, end(&[[1.0, 0.5], [1.0, 0.2], [1.0, 0.4]])?];
    figure
        .all_close(
            "7: detours within a twist are forgotten beyond it",
            detours.map(|torque| (torque, direct)),
            Relative(1e-12),
        )
        .source("the history with the fewest of Lubkin's functions");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    let mut table = Table::new("Where each stands", ["proposition", "subject", "page or figure"]);
    for place in PLACES {
        table.row(place);
    }
    figure.table(table);
    axes(&mut figure)?;
    directions(&mut figure)?;
    torsion(&mut figure)?;
    Ok(figure)
}
