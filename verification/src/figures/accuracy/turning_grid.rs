//! The distance of the contact laws from elastic half-spaces on drawn paths that turn.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::coulomb::{SlipTurn, Tolerance};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::rings::{self, RingLaw};
use carom_laws::shift_law::ShiftLaw;
use carom_solver::NumericalLaw;

use crate::{Cell, Failure, Figure, Marker, Panel, Series, Table};

const PATHS: usize = 8;
const STEPS: usize = 150;
/// Cells across the contact of the greatest approach.
const CELLS: [usize; 2] = [32, 64];
const APPROACH: f64 = 0.02;
/// The bins of the angle, in degrees, from its lower end on.
const ANGLES: [f64; 5] = [0.0, 30.0, 90.0, 180.0, 360.0];

type Path = Vec<Shift>;
type Failed = Box<dyn std::error::Error + Send + Sync>;

/// Two bodies of the same material, and friction.
struct Contact {
    hertz: Hertz,
    friction: Friction,
    path: Path,
}

/// The part of a multiple that is beyond a whole number: evenly spread numbers from 0 to 1.
fn drawn(path: usize, number: usize) -> f64 {
    let place = (path * 9 + number + 1) as f64;
    (place * 0.618_033_988_749_894_9).fract()
}

/// Friction .05 to .6, Poisson's ratio 0 to .5; the approach swings, the shifts are sines of drawn frequencies
/// and of amplitudes about f kappa times the approach, so that contacts stick, slip and slide.
fn contact(path: usize) -> Result<Contact, Failure> {
    let draw = |number| drawn(path, number);
    let body = Material::from_shear(2.0, 0.5 * draw(0))?;
    let gap = RelativeCurvature::from_coefficients(0.5, 0.5)?;
    let hertz = Hertz::new(gap, MaterialPair::new(body, body)?)?;
    let f = 0.05 + 0.55 * draw(1);
    let stiffness = hertz.stiffness();
    let unit = f * APPROACH * stiffness.c_z / stiffness.c_x;
    let wave = |t: f64, number| libm::sin(std::f64::consts::TAU * (1.0 + draw(number)) * t);
    let at = |k: usize| {
        let t = k as f64 / STEPS as f64;
        let swing = libm::sin(std::f64::consts::TAU * ((1.0 + draw(2)) * t + draw(3)));
        Shift {
            zeta: APPROACH * (5.0 * t).min(1.0) * (1.0 + 0.4 * swing),
            xi: unit * (0.7 + 0.6 * draw(4)) * wave(t, 5),
            eta: unit * (0.7 + 0.6 * draw(6)) * wave(t, 7),
            omega: 0.0,
        }
    };
    Ok(Contact { hertz, friction: Friction::new(f)?, path: (1..=STEPS).map(at).collect() })
}

impl Contact {
    fn follow<L: ContactLaw>(&self, mut law: L) -> Result<Vec<ContactLoad>, Failure>
    where
        L::Error: std::error::Error + Send + Sync + 'static,
    {
        let step = |&to: &Shift| law.advance(to).map_err(|e| Failure::from(Failed::from(e)));
        self.path.iter().map(step).collect()
    }

    fn on_grid(&self, cells: usize) -> Result<Vec<ContactLoad>, Failure> {
        let law = NumericalLaw::new(self.hertz, self.friction, 1.4 * APPROACH, cells)?;
        self.follow(law.within(1e-6)?.with_slip_ahead())
    }

    /// The differences of two runs over f F_z.
    fn off(&self, a: &[ContactLoad], b: &[ContactLoad]) -> Vec<f64> {
        let off = |(a, b): (&ContactLoad, &ContactLoad)| {
            libm::hypot(a.f_x - b.f_x, a.f_y - b.f_y) / (self.friction.get() * b.f_z)
        };
        a.iter().zip(b).map(off).collect()
    }

    /// By how many degrees slip has turned within an annulus, at each step.
    fn turns(&self) -> Result<Vec<f64>, Failure> {
        let mut turn = SlipTurn::new(self.hertz.stiffness(), self.friction, 1.4 * APPROACH)?;
        let step = |&to: &Shift| turn.advance(to).map(|()| turn.angle().to_degrees());
        Ok(self.path.iter().map(step).collect::<Result<_, _>>()?)
    }
}

/// The errors of a law, step by step, on all paths.
struct Errors {
    name: &'static str,
    at: Vec<f64>,
}

impl Errors {
    fn of(name: &'static str) -> Self {
        Self { name, at: Vec::new() }
    }

    fn mean(&self) -> f64 {
        self.at.iter().sum::<f64>() / self.at.len() as f64
    }

    fn worst(&self) -> f64 {
        self.at.iter().copied().fold(0.0, f64::max)
    }
}

/// The errors of the grid and of three laws, and the angle at each step.
fn errors() -> Result<([Errors; 4], Vec<f64>), Failure> {
    let mut all = ["grid, 32 cells", "coulomb", "fixed-direction", "rings 6 x 8"].map(Errors::of);
    let mut turns = Vec::new();
    for path in 0..PATHS {
        let contact = contact(path)?;
        let (hertz, friction) = (&contact.hertz, contact.friction);
        let stiffness = hertz.stiffness();
        let coulomb =
            ShiftLaw::<[f64; 2]>::with_tolerance(stiffness, friction, Tolerance::new(1e-4)?);
        let fixed = ShiftLaw::<[f64; 2]>::with_fixed_direction(stiffness, friction);
        let rings = RingLaw::<6, 8>::new(hertz, friction, rings::Tolerance::PARTICLES)?;
        let [coarse, fine] = [contact.on_grid(CELLS[0])?, contact.on_grid(CELLS[1])?];
        let runs =
            [coarse, contact.follow(coulomb)?, contact.follow(fixed)?, contact.follow(rings)?];
        for (errors, run) in all.iter_mut().zip(&runs) {
            errors.at.extend(contact.off(run, &fine));
        }
        turns.extend(contact.turns()?);
    }
    Ok((all, turns))
}

/// Panel, tables and claims.
pub(super) fn add(figure: &mut Figure) -> Result<(), Failure> {
    figure.assumed("drawn paths", "8 of 150 steps, like bodies, f .05 to .6, ν 0 to .5");
    let (all, turns) = errors()?;
    let mut table = Table::new(
        "Forces on drawn paths that turn, against the half-space on 64 cells across the contact, over f F_z",
        ["law", "mean error", "largest error"],
    );
    for errors in &all {
        table.row([errors.name.into(), Cell::from(errors.mean()), errors.worst().into()]);
    }
    figure.table(table);
    claims(figure, &all);
    let mut panel = Panel::new(
        "turn of slip within an annulus (degrees)",
        "error / f F_z against the half-space",
    );
    for (i, errors) in all.iter().enumerate().skip(1) {
        let points = turns.iter().copied().zip(errors.at.iter().copied()).step_by(3);
        panel.add(Series::markers(errors.name, Marker::Dot, points).coloured(i - 1));
    }
    figure.panel(panel);
    by_angle(figure, &all[1], &turns);
    Ok(())
}

fn claims(figure: &mut Figure, all: &[Errors; 4]) {
    let source = "the half-space on a grid: another method";
    let bounds = [(6e-4, 0.02), (0.022, 0.21), (0.15, 0.57), (7e-3, 0.022)];
    for (errors, (mean, worst)) in all.iter().zip(bounds) {
        let name = errors.name;
        figure.at_most(format!("drawn paths: {name}, mean"), errors.mean(), mean).source(source);
        figure
            .at_most(format!("drawn paths: {name}, largest"), errors.worst(), worst)
            .source(source);
    }
}

/// The error of Coulomb's law by the angle. It also stays where annuli that had turned stick again.
fn by_angle(figure: &mut Figure, coulomb: &Errors, turns: &[f64]) {
    let mut table = Table::new(
        "Coulomb's law by the largest turn of slip within an annulus since it last stuck",
        ["turn, degrees", "steps", "mean error", "largest error"],
    );
    let mut means = Vec::new();
    for range in ANGLES.windows(2) {
        let steps = turns.iter().zip(&coulomb.at);
        let within = steps.filter(|(turn, _)| (range[0]..range[1]).contains(*turn));
        let errors = Errors { name: "", at: within.map(|(_, error)| *error).collect() };
        table.row([
            Cell::Remark(format!("{} to {}", range[0], range[1])),
            Cell::Remark(errors.at.len().to_string()),
            errors.mean().into(),
            errors.worst().into(),
        ]);
        means.push(errors.mean());
    }
    figure
        .at_least(
            "drawn paths: mean error beyond half a turn, over that below a twelfth",
            means[3] / means[0],
            3.0,
        )
        .source("the half-space on a grid: another method");
    figure.table(table);
}
