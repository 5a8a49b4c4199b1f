//! CONTACT's published table of creep forces, with carom's own table and FASTSIM beside it.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::creep::force::CreepContact;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_rolling::{Creepage, Fastsim, RollingDrive, SteadyContact, Way};
use carom_solver::{CellState, ContactProblem, Driven, Gap};

use crate::reference;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series, Table, linspace};

const SHEAR_MODULUS: f64 = 82_000.0;
const POISSON: f64 = 0.28;
const FRICTION: f64 = 0.3;
const FORCE: f64 = 82_000.0;
/// Axis ratios a/b of the table, and the semi-axis a of each in mm.
const ELLIPSES: [(f64, f64); 5] = [(0.2, 4.0), (0.5, 6.0), (1.0, 9.0), (2.0, 12.0), (5.0, 20.0)];
const SPINS: [f64; 4] = [0.0, 0.5, 1.0, 2.0];
/// The axis ratio that is drawn.
const DRAWN: usize = 1;
const SOURCE: &str = "CONTACT's table for its own test, 11 × 11 elements, six printed decimals";

/// One contact, on CONTACT's elements and by formulas.
struct Contact {
    hertz: Hertz,
    semi_axes: [f64; 2],
    table: CreepContact,
    /// 11 x 11 elements, 7 of them across the ellipse.
    coarse: SteadyContact,
}

/// F_x and F_y over f F_z, M_z over f F_z sqrt(ab).
type Forces = [f64; 3];

impl Contact {
    fn new((ratio, semi_axis): (f64, f64)) -> Result<Self, Failure> {
        let body = Material::from_shear(SHEAR_MODULUS, POISSON)?;
        let pair = MaterialPair::new(body, body)?;
        let semi_axes = [semi_axis, semi_axis / ratio];
        let ellipse = ContactEllipse::new(semi_axes[0], semi_axes[1])?;
        let hertz = Hertz::from_ellipse_and_force(ellipse, FORCE, pair)?;
        let [dx, dy] = semi_axes.map(|axis| 2.0 * axis / 7.0);
        let gap =
            Gap::from_function(Grid::new(11, 11, dx, dy)?, |x, y| hertz.curvature().gap(x, y))?;
        let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION)?)?;
        let coarse =
            SteadyContact::new(&problem, Way::new(dx)?.with_spin_at(1.0 / 6.0)?)?.within(1e-9)?;
        let table = CreepContact::new(semi_axes, SHEAR_MODULUS, POISSON)?;
        Ok(Self { hertz, semi_axes, table, coarse })
    }

    fn over_the_limit(&self, [f_x, f_y, m_z]: [f64; 3]) -> Forces {
        let limit = FRICTION * FORCE;
        let size = (self.semi_axes[0] * self.semi_axes[1]).sqrt();
        [f_x / limit, f_y / limit, m_z / (limit * size)]
    }

    /// The creepage of a case, of body 2 against body 1: the opposite of CONTACT's but for the spin.
    fn creepage(&self, spin: f64, direction: f64, magnitude: f64) -> Creepage {
        let curvature = self.hertz.curvature();
        let rho = 2.0 / (curvature.gap(1.0, 0.0) + curvature.gap(0.0, 1.0));
        let (sin, cos) = direction.to_radians().sin_cos();
        let unit = magnitude * FRICTION * (self.semi_axes[0] * self.semi_axes[1]).sqrt() / rho;
        Creepage { along: -unit * cos, across: -unit * sin, spin: spin * FRICTION / rho }
    }

    /// On CONTACT's elements, and the share of the contact that slips in percent.
    fn solved(&mut self, creepage: Creepage) -> Result<(Forces, f64), Failure> {
        let drive = RollingDrive::by_creepage(Driven::Load(FORCE), creepage);
        let state = self.coarse.roll(&drive, &mut ())?.state;
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|which| state.count(which) as f64);
        let load = state.load();
        let forces = self.over_the_limit([load.f_x, load.f_y, load.m_z]);
        Ok((forces, 100.0 * slip / (stick + slip)))
    }

    /// By the table: forces, and how far they may be off.
    fn tabulated(&self, creepage: Creepage) -> Result<(Forces, f64), Failure> {
        let Creepage { along, across, spin } = creepage;
        let found = self.table.force(FRICTION, FORCE, [along, across, spin])?;
        let forces = self.over_the_limit([found.f_x, found.f_y, found.m_z]);
        Ok((forces, found.error / (FRICTION * FORCE)))
    }

    fn by_springs(&self, creepage: Creepage) -> Result<[f64; 2], Failure> {
        let fastsim = Fastsim {
            semi_axes: self.semi_axes,
            shear_modulus: SHEAR_MODULUS,
            coefficients: self.table.coefficients(),
            force: FORCE,
            friction: FRICTION,
            mesh: [10, 10],
        };
        let found = fastsim.forces(creepage)?;
        let [f_x, f_y, _] = self.over_the_limit([found.f_x, found.f_y, 0.0]);
        Ok([f_x, f_y])
    }
}

/// A case of CONTACT's table with what carom finds, in carom's signs.
struct Row {
    which: usize,
    spin: f64,
    direction: f64,
    magnitude: f64,
    printed: Forces,
    printed_slip: f64,
    solved: Forces,
    slip: f64,
    tabulated: Forces,
    error: f64,
    springs: [f64; 2],
}

/// The greatest difference of three parts.
fn off(one: Forces, other: Forces) -> f64 {
    (0..3).map(|part| (one[part] - other[part]).abs()).fold(0.0, f64::max)
}

fn compute(contacts: &mut [Contact]) -> Result<Vec<Row>, Failure> {
    let text = include_str!("../../../data/rolling/creep_table.csv");
    let mut computed = Vec::new();
    for [ratio, spin, direction, magnitude, f_x, f_y, m_z, printed_slip] in
        reference::rows::<8>(text)?
    {
        let which = ELLIPSES.iter().position(|ellipse| ellipse.0 == ratio);
        let which = which.ok_or("an axis ratio that the table does not have")?;
        let contact = &mut contacts[which];
        let creepage = contact.creepage(spin, direction, magnitude);
        let (solved, slip) = contact.solved(creepage)?;
        let (tabulated, error) = contact.tabulated(creepage)?;
        let springs = contact.by_springs(creepage)?;
        // M_z of CONTACT has the opposite sign.
        let printed = [f_x, f_y, -m_z];
        computed.push(Row {
            which,
            spin,
            direction,
            magnitude,
            printed,
            printed_slip,
            solved,
            slip,
            tabulated,
            error,
            springs,
        });
    }
    Ok(computed)
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), value| (sum + value, count + 1));
    sum / f64::from(count)
}

fn greatest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

/// How far a row of FASTSIM is off the table of the continuum, in force.
fn springs_off(row: &Row) -> f64 {
    (row.springs[0] - row.tabulated[0]).hypot(row.springs[1] - row.tabulated[1])
}

fn by_ellipse(rows: &[Row]) -> Table {
    let heads = [
        "a/b",
        "cases",
        "solver on CONTACT's elements: worst",
        "CONTACT's 11 × 11 elements off the table: mean",
        "worst",
        "FASTSIM off the table, force: mean",
        "worst",
    ];
    let mut table = Table::new("Differences over f F_z (M_z over f F_z sqrt(ab))", heads);
    for (which, (ratio, _)) in ELLIPSES.iter().enumerate() {
        let own = || rows.iter().filter(move |row| row.which == which);
        table.row([
            *ratio,
            own().count() as f64,
            greatest(own().map(|row| off(row.printed, row.solved))),
            mean(own().map(|row| off(row.printed, row.tabulated))),
            greatest(own().map(|row| off(row.printed, row.tabulated))),
            mean(own().map(springs_off)),
            greatest(own().map(springs_off)),
        ]);
    }
    table
}

/// Forces along the track over magnitude, for each spin.
fn panel(contact: &Contact, rows: &[Row], part: usize) -> Result<Panel, Failure> {
    let direction = if part == 0 { 0.0 } else { 90.0 };
    let label = ["−F_x/(f F_z)", "−F_y/(f F_z)"][part];
    let title = ["Creepage along", "Creepage across"][part];
    let mut panel = Panel::new("creepage, units of f sqrt(ab)/ρ", label).titled(title);
    for (colour, spin) in SPINS.into_iter().enumerate() {
        let mut table = Vec::new();
        let mut springs = Vec::new();
        for magnitude in linspace(0.0, 8.0, 81) {
            let creepage = contact.creepage(spin, direction, magnitude);
            table.push((magnitude, -contact.tabulated(creepage)?.0[part]));
            springs.push((magnitude, -contact.by_springs(creepage)?[part]));
        }
        panel.add(Series::line(format!("spin {spin}"), table).coloured(colour));
        panel.add(Series::dashed("", springs).coloured(colour));
        let printed = rows.iter().filter(|row| {
            row.which == DRAWN
                && row.spin == spin
                && row.direction == direction
                && row.magnitude <= 8.0
        });
        let printed = printed.map(|row| (row.magnitude, -row.printed[part]));
        panel.add(Series::markers("", Marker::Circle, printed).coloured(colour));
    }
    Ok(panel)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.snapshot_digits(5);
    figure.stated("bodies", "alike: G = 82 000 N/mm², ν = 0.28; f = 0.3, F_z = 82 000 N");
    figure.stated("ellipses", "a = 4, 6, 9, 12, 20 mm for a/b = 0.2, 0.5, 1, 2, 5");
    figure.stated("elements", "11 × 11 over 11/7 of the ellipse, so that 7 lie across it");
    figure.assumed("lines", "carom's table; dashed: FASTSIM of 10 × 10; circles: CONTACT");
    let mut contacts = Vec::new();
    for ellipse in ELLIPSES {
        contacts.push(Contact::new(ellipse)?);
    }
    let rows = compute(&mut contacts)?;
    for part in 0..2 {
        figure.panel(panel(&contacts[DRAWN], &rows, part)?);
    }
    figure.table(by_ellipse(&rows));
    figure
        .at_most(
            "the solver on CONTACT's elements: greatest difference of a force",
            greatest(rows.iter().map(|row| off(row.printed, row.solved))),
            6e-7,
        )
        .source(SOURCE);
    let slips = rows.iter().map(|row| (row.slip, row.printed_slip));
    figure.all_close("share of the contact that slips, %", slips, Absolute(0.051)).source(SOURCE);
    figure
        .at_least(
            "CONTACT's 11 × 11 elements are further off the table than the table's own bound, share",
            mean(rows.iter().map(|row| f64::from(off(row.printed, row.tabulated) > row.error))),
            0.5,
        )
        .source("errors of the first order in the width of an element");
    figure
        .at_least(
            "FASTSIM is off the table in the mean by so many times the table's bound",
            mean(rows.iter().map(springs_off)) / mean(rows.iter().map(|row| row.error)),
            1.0,
        )
        .source("the simplified theory is said to be good to some percent");
    Ok(figure)
}
