//! An interactive impact: a table of the impact of two solid spheres, and the section of the report
//! whose sliders read it.

mod table;

use serde_json::{Value, json};
use std::fmt::Write as _;

use crate::Failure;
pub(crate) use table::{Instant, Table, exact, lambda_of_sliding, restitution};

/// The drawing of the balls is that of the page of `doors/carom-rebound`.
const SCRIPT: &str =
    concat!(include_str!("../../../doors/carom-rebound/page/draw.js"), include_str!("script.js"));
const BODY: &str = include_str!("body.html");

/// A position of the sliders and the exact result there.
struct Check {
    poisson: f64,
    friction: f64,
    /// Angle of incidence from the normal, in degrees.
    angle: f64,
    /// R omega/v, positive in the direction of motion.
    spin: f64,
}

/// Positions that a browser must compute correctly: one in each regime, the last without slip.
const CHECKS: [Check; 5] = [
    Check { poisson: 0.3, friction: 0.3, angle: 45.0, spin: 0.0 },
    Check { poisson: 0.5, friction: 0.6, angle: 60.0, spin: 0.0 },
    Check { poisson: 0.0, friction: 0.1, angle: 75.0, spin: 0.5 },
    Check { poisson: 0.17, friction: 1.0, angle: 20.0, spin: -1.5 },
    Check { poisson: 0.41, friction: 0.05, angle: 2.0, spin: 0.0 },
];

impl Check {
    /// lambda = |xi'|/(f zeta') at the contact point.
    fn lambda(&self) -> f64 {
        let (sin, cos) = libm::sincos(self.angle.to_radians());
        (sin - self.spin).abs() / (self.friction * cos)
    }

    fn record(&self) -> Result<Value, Failure> {
        let restitution = restitution(self.poisson, self.lambda())?;
        Ok(json!({
            "poisson": self.poisson, "friction": self.friction, "angle": self.angle,
            "spin": self.spin, "restitution": restitution,
        }))
    }
}

/// The section of the report; without a table it gives the reason.
pub(crate) fn section() -> String {
    made().unwrap_or_else(|error| format!("<p class=\"fail\">no table: {error}</p>\n"))
}

fn made() -> Result<String, Failure> {
    let table = Table::new()?;
    let checks: Vec<_> = CHECKS.iter().map(Check::record).collect::<Result<_, _>>()?;
    let mut page = BODY.to_owned();
    let data = json!({
        "poissons": table::POISSONS, "parts": table::PARTS,
        "times": table.times(), "compressions": table.compressions(),
        "numbers": carom_plot::base64(&table.bytes()), "checks": checks,
    });
    let _ = write!(
        page,
        "<script type=\"application/json\" id=\"play-table\">{data}</script>\n\
         <script>\n{SCRIPT}</script>\n"
    );
    Ok(page)
}
