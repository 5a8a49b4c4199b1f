//! Contacts with known solutions, for tests, benches and figures.
//!
//! All have a contact of radius or half-width 1 in a window of 2.4 with any number of cells; the
//! centre of the contact may lie anywhere relative to the cells.

use std::f64::consts::PI;
use std::sync::Arc;

use carom_halfspace::operator::{PeriodicOperator, Threads};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLoad, Shift};
use carom_laws::torsion::lubkin::Lubkin;
use carom_special::RangeError;

use carom_solver::{ContactProblem, Drive, Gap, ProblemError};

/// Side of the window.
const SIDE: f64 = 2.4;
const FRICTION: f64 = 0.4;

/// The known values of a solution; `None` without a closed form.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Expected {
    /// The loads.
    pub(crate) load: ContactLoad,
    /// The greatest pressure.
    pub(crate) peak: Option<f64>,
    /// The area that sticks.
    pub(crate) stick_area: Option<f64>,
}

/// A contact with a closed-form solution, reached by a few drives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Known {
    /// A sphere pressed on an equal one: Hertz.
    Hertz,
    /// The same shifted to half of the stick radius, nu = 0: Cattaneo and Mindlin.
    CattaneoMindlin,
    /// The same twisted to a stick radius of 0.8: Lubkin.
    Lubkin,
    /// The same twisted without slip: Mindlin.
    MindlinTorsion,
    /// A round flat punch, pressed.
    FlatPunch,
    /// A wavy surface of which half is in contact: Westergaard.
    Westergaard,
}

impl Known {
    /// All of them.
    pub(crate) const ALL: [Self; 6] = [
        Self::Hertz,
        Self::CattaneoMindlin,
        Self::Lubkin,
        Self::MindlinTorsion,
        Self::FlatPunch,
        Self::Westergaard,
    ];

    fn pair(self) -> Result<MaterialPair, RangeError> {
        let poisson = if self == Self::CattaneoMindlin { 0.0 } else { 0.3 };
        let body = Material::from_shear(2.0, poisson)?;
        MaterialPair::new(body, body)
    }

    fn friction(self) -> f64 {
        match self {
            Self::CattaneoMindlin | Self::Lubkin => FRICTION,
            Self::MindlinTorsion => f64::INFINITY,
            Self::Hertz | Self::FlatPunch | Self::Westergaard => 0.0,
        }
    }

    /// The problem on `cells` by `cells` cells (a twelfth along the waves); `offset` is the
    /// position of the centre of the contact, in cells.
    ///
    /// # Errors
    /// As [`ContactProblem::of_half_spaces`].
    pub(crate) fn problem(
        self,
        cells: usize,
        offset: [f64; 2],
    ) -> Result<ContactProblem, ProblemError> {
        let range = |error: RangeError| ProblemError::Operator(error.into());
        let width = SIDE / cells as f64;
        let (pair, friction) = (self.pair().map_err(range)?, self.friction());
        let friction = Friction::new(friction).map_err(range)?;
        let rows = if self == Self::Westergaard { rows_along(cells) } else { cells };
        let grid = Grid::new(cells, rows, width, width).map_err(range)?;
        let height = |x: f64, y: f64| {
            let (x, y) = (x - offset[0] * width, y - offset[1] * width);
            match self {
                Self::FlatPunch if x * x + y * y > 1.0 => f64::INFINITY,
                Self::FlatPunch => 0.0,
                // Curved like x^2/2 at its crests.
                Self::Westergaard => (SIDE / PI * libm::sin(PI * x / SIDE)).powi(2) / 2.0,
                _ => 0.5 * (x * x + y * y),
            }
        };
        let gap = Gap::from_function(grid, height).map_err(range)?;
        if self == Self::Westergaard {
            let operator = PeriodicOperator::new(pair, grid, Threads::One)?;
            return ContactProblem::new(gap, Arc::new(operator), friction);
        }
        ContactProblem::of_half_spaces(gap, pair, friction)
    }

    /// The drives, in order.
    ///
    /// # Errors
    /// None in practice: the values are in range.
    pub(crate) fn drives(self, cells: usize) -> Result<Vec<Drive>, RangeError> {
        let by = |shift: Shift| Drive::by_shift(Shift { zeta: 1.0, ..shift });
        let pressed = by(Shift::default());
        Ok(match self {
            Self::Hertz | Self::FlatPunch => vec![pressed],
            Self::Westergaard => {
                let area = area_of_waves(cells);
                let normal = carom_solver::Driven::Load(0.5 * self.full_pressure()? * area);
                vec![Drive { normal, ..Drive::default() }]
            }
            Self::CattaneoMindlin => {
                vec![pressed, by(Shift { xi: 0.75 * FRICTION, ..Shift::default() })]
            }
            Self::Lubkin => vec![pressed, by(Shift { omega: self.twist()?, ..Shift::default() })],
            Self::MindlinTorsion => vec![pressed, by(Shift { omega: 0.1, ..Shift::default() })],
        })
    }

    fn lubkin() -> Result<Lubkin, RangeError> {
        Lubkin::at_stick_radius(0.8)
    }

    /// The force of Hertz, (8/3) G/(1 - nu) for the radii 1.
    fn force(self) -> Result<f64, RangeError> {
        let pair = self.pair()?;
        Ok(8.0 / 3.0 * pair.shear_modulus() / (1.0 - pair.poisson()))
    }

    fn twist(self) -> Result<f64, RangeError> {
        let limit = FRICTION * self.force()?;
        Ok(Self::lubkin()?.twist() * limit / self.pair()?.shear_modulus())
    }

    /// The mean pressure for full contact of the wave, pi E* A/L.
    fn full_pressure(self) -> Result<f64, RangeError> {
        let pair = self.pair()?;
        let modulus = 2.0 * pair.shear_modulus() / (1.0 - pair.poisson());
        // A (1 - cos) is 2 A sin^2.
        let amplitude = 0.25 * (SIDE / PI) * (SIDE / PI);
        Ok(PI * modulus * amplitude / SIDE)
    }

    /// The expected result of the last drive.
    ///
    /// # Errors
    /// None in practice: the values are in range.
    pub(crate) fn expected(self, cells: usize) -> Result<Expected, RangeError> {
        let (pair, force) = (self.pair()?, self.force()?);
        let hertz = Expected {
            load: ContactLoad { f_z: force, ..ContactLoad::default() },
            peak: Some(1.5 * force / PI),
            stick_area: None,
        };
        let loaded = |load: ContactLoad| ContactLoad { f_z: force, ..load };
        Ok(match self {
            Self::Hertz => hertz,
            Self::CattaneoMindlin => {
                let f_x = FRICTION * force * (1.0 - 0.25_f64.powf(1.5));
                let load = loaded(ContactLoad { f_x, ..ContactLoad::default() });
                Expected { load, stick_area: Some(0.25 * PI), ..hertz }
            }
            Self::Lubkin => {
                let m_z = FRICTION * force * Self::lubkin()?.torque();
                let load = loaded(ContactLoad { m_z, ..ContactLoad::default() });
                Expected { load, stick_area: Some(0.64 * PI), ..hertz }
            }
            Self::MindlinTorsion => {
                let m_z = 16.0 / 3.0 * pair.shear_modulus() * 0.1; // (5.35)
                let load = loaded(ContactLoad { m_z, ..ContactLoad::default() });
                Expected { load, stick_area: Some(PI), ..hertz }
            }
            Self::FlatPunch => {
                let f_z = 4.0 * pair.shear_modulus() / (1.0 - pair.poisson());
                let load = ContactLoad { f_z, ..ContactLoad::default() };
                Expected { load, ..Expected::default() }
            }
            Self::Westergaard => {
                let (full, area) = (self.full_pressure()?, area_of_waves(cells));
                let load = ContactLoad { f_z: 0.5 * full * area, ..ContactLoad::default() };
                Expected { load, peak: Some(2.0 * full * 0.5_f64.sqrt()), stick_area: None }
            }
        })
    }
}

/// The number of cells along the waves, such that half as many cells give half of it.
const fn rows_along(cells: usize) -> usize {
    cells.div_ceil(12)
}

fn area_of_waves(cells: usize) -> f64 {
    SIDE * SIDE * rows_along(cells) as f64 / cells as f64
}
