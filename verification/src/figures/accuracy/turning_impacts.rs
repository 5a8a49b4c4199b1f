//! Impacts whose slip turns, by Coulomb's law on a curve of anchors, on a line of anchors, and by the law of
//! the thesis.

use carom_impact::Mobility;
use carom_impact::coupled::{CoupledImpact, TurningLaw};
use carom_laws::friction::Friction;
use carom_laws::sliders::SlipLines;
use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use crate::{Axis, Cell, Failure, Figure, Panel, Series, Table};

const IMPACTS: usize = 8;
const ASKED: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
const REFERENCE: f64 = 1e-7;

struct Case {
    impact: CoupledImpact,
    stiffness: ContactStiffness,
    friction: f64,
    velocity: Vector3<f64>,
}

/// Coupled mobilities, frictions from 0.15 to 0.85 and tangential speeds from 0.3 to 2.2 times the normal
/// one, for contacts with c_x = c_y, where both forms of Coulomb's law agree.
fn cases() -> Result<Vec<Case>, Failure> {
    (0..IMPACTS)
        .map(|i| {
            let turn = |n: usize| libm::sin(2.4 * (i * 7 + n) as f64);
            let off = |n: usize| 0.5 * turn(n);
            let lower = Matrix3::new(
                1.6 + 0.2 * turn(0),
                0.0,
                0.0,
                off(1),
                1.6 + 0.2 * turn(2),
                0.0,
                off(3),
                off(4),
                1.0,
            );
            let mobility = Mobility::from_matrix(lower * lower.transpose())?;
            let c = 0.8 + 0.1 * turn(5);
            let stiffness = ContactStiffness::new(c, c, 1.0)?;
            let friction = 0.15 + 0.1 * i as f64;
            let (sin, cos) = libm::sincos(2.0 * i as f64);
            let speed = 0.3 + 1.9 * (i * 3 % IMPACTS) as f64 / (IMPACTS - 1) as f64;
            let before = Vector3::new(speed * cos, speed * sin, 1.0);
            let impact = CoupledImpact::new(mobility, stiffness, Friction::new(friction)?, before)?;
            let mut case = Case { impact, stiffness, friction, velocity: before };
            case.velocity = case.by_line(REFERENCE)?;
            Ok(case)
        })
        .collect()
}

impl Case {
    fn error(&self, velocity: Vector3<f64>) -> f64 {
        (velocity - self.velocity).norm() / self.impact.velocity().norm()
    }

    /// The error of a line of anchors decreases with the cube of the resolution.
    fn by_line(&self, asked: f64) -> Result<Vector3<f64>, Failure> {
        let coarse = SlipLines::new(self.stiffness, self.friction, 0.75)?;
        let law = |n: usize| coarse.refined(n.saturating_pow(3));
        Ok(self.impact.within(asked)?.solve_with(law)?.velocity)
    }

    fn on_line(&self, asked: f64) -> Result<f64, Failure> {
        Ok(self.error(self.by_line(asked)?))
    }

    fn on_curve(&self, asked: f64) -> Result<f64, Failure> {
        Ok(self.error(self.impact.within(asked)?.solve(TurningLaw::Coulomb)?.velocity))
    }

    fn of_chapter_7(&self) -> Result<f64, Failure> {
        let outcome = self.impact.within(1e-4)?.solve(TurningLaw::FixedDirection)?;
        Ok(self.error(outcome.velocity))
    }
}

fn largest(cases: &[Case], error: impl Fn(&Case) -> Result<f64, Failure>) -> Result<f64, Failure> {
    cases.iter().try_fold(0.0_f64, |largest, case| Ok(largest.max(error(case)?)))
}

/// Panel, table and claims.
pub(super) fn add(figure: &mut Figure) -> Result<(), Failure> {
    let cases = cases()?;
    figure.assumed("impacts", "8 coupled mobilities, c_x = c_y, f from 0.15 to 0.85");
    let mut panel =
        Panel::new(Axis::log("asked of the velocity / |v_A|"), Axis::log("largest error / |v_A|"));
    let mut table = Table::new(
        "Velocities after 8 impacts whose slip turns, against a line of anchors to 1e-7",
        ["asked", "line of anchors", "curve of anchors"],
    );
    let (mut lines, mut curves) = (Vec::new(), Vec::new());
    for asked in ASKED {
        let line = largest(&cases, |case| case.on_line(asked))?;
        let curve = largest(&cases, |case| case.on_curve(asked))?;
        table.row([
            Cell::Remark(format!("{asked:.0e}")),
            Cell::Remark(format!("{line:.0e}")),
            Cell::Remark(format!("{curve:.0e}")),
        ]);
        figure
            .at_most(format!("impacts: curve of anchors to {asked:e}"), curve, asked)
            .source("line of anchors to 1e-7, the law of coupled impacts");
        lines.push((asked, line));
        curves.push((asked, curve));
    }
    let old = largest(&cases, Case::of_chapter_7)?;
    figure
        .at_least("impacts: chapter 7 misses by", old, 1e-3)
        .source("line of anchors to 1e-7, the law of coupled impacts");
    panel.add(Series::line("line of anchors", lines));
    panel.add(Series::line("curve of anchors", curves).coloured(1));
    panel.add(Series::dashed("asked", ASKED.map(|asked| (asked, asked))).coloured(3));
    figure.panel(panel);
    figure.table(table);
    Ok(())
}
