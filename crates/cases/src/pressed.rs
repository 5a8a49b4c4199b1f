//! Two bodies pressed together, which touch at a point (Hertz) or along a line.

use crate::case::Given;
use carom_halfspace::{Material, MaterialPair, Point, Stress, Traction};
use carom_laws::field::partial_slip_stress;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::line::{LineContact, LineState, line_stress};
use carom_laws::validity::Validity;
use carom_special::RangeError;
use carom_table::{Cell, row};

/// Two bodies that touch at a point or along a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointOrLine {
    /// An elliptical contact.
    Point(Hertz),
    /// Cylinders with parallel axes.
    Line(LineContact),
}

/// The contact under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pressed {
    /// An elliptical contact.
    Point(HertzState),
    /// Cylinders with parallel axes.
    Line(LineState),
}

impl PointOrLine {
    /// The materials of both bodies.
    #[must_use]
    pub const fn materials(&self) -> MaterialPair {
        match self {
            Self::Point(hertz) => hertz.materials(),
            Self::Line(line) => line.materials(),
        }
    }

    /// The quantities that do not depend on the load.
    #[must_use]
    pub fn cells(&self) -> Vec<Cell> {
        match self {
            Self::Point(hertz) => row(Hertz::COLUMNS, Some(hertz)),
            Self::Line(line) => row(LineContact::COLUMNS, Some(line)),
        }
    }

    /// The contact with a given load; of a line the semi-axis along x is the half width.
    ///
    /// # Errors
    /// [`RangeError`] for a value that is not positive, and for the semi-axis along y of a line.
    pub fn at(&self, given: Given, value: f64) -> Result<Pressed, RangeError> {
        match self {
            Self::Point(hertz) => Ok(Pressed::Point(match given {
                Given::Force => hertz.at_force(value)?,
                Given::Approach => hertz.at_approach(value)?,
                Given::SemiAxisA => hertz.at_semi_axis_a(value)?,
                Given::SemiAxisB => hertz.at_semi_axis_b(value)?,
                Given::PeakPressure => hertz.at_peak_pressure(value)?,
            })),
            Self::Line(line) => Ok(Pressed::Line(match given {
                Given::Force => line.at_force(value)?,
                Given::Approach => line.at_approach(value)?,
                Given::SemiAxisA => line.at_half_width(value)?,
                Given::SemiAxisB => {
                    return Err(RangeError::new(
                        "semi_axis_b",
                        value,
                        "absent: a line has a half width, `semi_axis_a`",
                    ));
                }
                Given::PeakPressure => line.at_peak_pressure(value)?,
            })),
        }
    }
}

impl Pressed {
    /// The normal force.
    #[must_use]
    pub const fn force(&self) -> f64 {
        match self {
            Self::Point(state) => state.force,
            Self::Line(state) => state.force,
        }
    }

    /// The approach.
    #[must_use]
    pub const fn approach(&self) -> f64 {
        match self {
            Self::Point(state) => state.approach,
            Self::Line(state) => state.approach,
        }
    }

    /// The greatest pressure.
    #[must_use]
    pub const fn peak_pressure(&self) -> f64 {
        match self {
            Self::Point(state) => state.peak_pressure,
            Self::Line(state) => state.peak_pressure,
        }
    }

    /// The larger semi-axis, or the half width of a line.
    #[must_use]
    pub const fn widest(&self) -> f64 {
        match self {
            Self::Point(state) => state.ellipse.semi_axis_a().max(state.ellipse.semi_axis_b()),
            Self::Line(state) => state.half_width,
        }
    }

    /// The quantities of the contact.
    #[must_use]
    pub fn cells(&self) -> Vec<Cell> {
        match self {
            Self::Point(state) => row(HertzState::COLUMNS, Some(state)),
            Self::Line(state) => row(LineState::COLUMNS, Some(state)),
        }
    }

    /// How far the contact is from the limits of the theory, between bodies of this smallest radius of curvature.
    #[must_use]
    pub fn validity(&self, of: &PointOrLine, smallest_radius: f64) -> Validity {
        let size = [self.widest(), self.approach(), self.peak_pressure()];
        Validity::of_contact(size, of.materials().yield_stress(), smallest_radius)
    }

    /// How much of the width sticks under a tangential force over friction times the normal force: (1 - part)^(1/3) of an
    /// ellipse, the root of 1 - part of a line.
    #[must_use]
    pub fn stick_width(&self, part: f64) -> f64 {
        let rest = (1.0 - part).max(0.0);
        match self {
            Self::Point(_) => libm::cbrt(rest),
            Self::Line(_) => libm::sqrt(rest),
        }
    }

    /// The stress in a body, from inside it.
    ///
    /// # Errors
    /// [`RangeError`] if a value is not finite or a depth is below 0.
    pub fn stress(
        &self,
        body: Material,
        peak: Traction,
        stick_width: f64,
        at: Point,
    ) -> Result<Stress, RangeError> {
        match self {
            Self::Point(state) => partial_slip_stress(state.ellipse, body, peak, stick_width, at),
            Self::Line(state) => {
                line_stress(state.half_width, body, peak, stick_width, [at.x, at.z])
            }
        }
    }
}
