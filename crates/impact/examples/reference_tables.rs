//! Makes the tables of the oblique impact in `reference/` anew, or with `--check` compares their entries.

use std::fmt::Write as _;
use std::io::Error;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use carom_impact::normal;
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::restitution::{DissimilarGroups, DissimilarTable};
use carom_laws::friction::Friction;

type Failure = Box<dyn std::error::Error>;

/// How far an entry may be off: rounding, and what platforms round.
const CLOSE: f64 = 1e-9;

/// kappa of Poisson's ratios from -2/3 to 1/2; those of 1/4 and 0.3 among them.
const KAPPAS: [f64; 27] = [
    0.8,
    0.85,
    0.9,
    0.95,
    1.0,
    1.025,
    1.05,
    1.075,
    1.1,
    1.125,
    1.15,
    1.166_666_666_7,
    1.175,
    1.2,
    1.214_285_714_3,
    1.225,
    1.25,
    1.275,
    1.3,
    1.325,
    1.35,
    1.375,
    1.4,
    1.425,
    1.45,
    1.475,
    1.5,
];
/// lambda besides 0, 0.1, .. 7.
const GRAZING: [f64; 4] = [8.0, 10.0, 15.0, 20.0];

/// A table: the name of its file, what its head says, its columns and its rows.
struct Table {
    name: &'static str,
    head: String,
    columns: &'static [&'static str],
    /// Decimals of each column.
    decimals: &'static [Option<usize>],
    rows: Vec<Vec<f64>>,
}

fn main() -> Result<(), Failure> {
    let checks = std::env::args().nth(1).as_deref() == Some("--check");
    let tables = [alike("solid", 0.4)?, alike("hollow", 2.0 / 3.0)?, dissimilar()?];
    for table in &tables {
        match checks {
            true => table.check()?,
            false => std::fs::write(table.path(), table.text()?)?,
        }
    }
    Ok(())
}

// ---- like spheres ------------------------------------------------------------------------------

const ALIKE: &[&str] =
    &["kappa", "lambda", "R_x", "spin", "force_max", "time_max", "force_min", "time_min"];

const ALIKE_HEAD: &str = "\
Elastic oblique impact of {what} spheres of like materials with Coulomb friction, exact for elastic half-spaces.
A sphere without spin strikes a wall of its own material, or two like spheres strike each other.

kappa      (2 - nu)/(2 (1 - nu)) of Poisson's ratio nu: normal over tangential stiffness of the contact
lambda     v_t/(f v_n): tangential over normal velocity before the impact, over the coefficient of friction f
R_x        -(tangential velocity of the contact point after)/(before): -1 without friction, +1 for full reversal
spin       R omega/v_t after the impact, R the radius (two like spheres: each has half of it, v_t the relative velocity)
force_max  largest tangential force over the largest normal force, times v_n/v_t; times lambda: in units of f F_n,max
time_max   its instant since first contact, over the duration of the impact
force_min  the same of the largest force in the opposite sense, negative; 0 if the force never turns
time_min   its instant; 1 if the force never turns

lambda = 0 is the limit without slip: any v_t with infinite friction, or v_t -> 0. Dissipation, gravity and the time
that waves take are left out. R_x is continuous, with kinks at lambda = kappa, {ratio} and {slides} - kappa.
Sliding throughout from lambda = {slides} - kappa on: R_x = {slides}/lambda - 1, spin = {rolled}/lambda, force_max = 1/lambda.

Inertia m R^2 times {inertia}; moves between contact point and centre by D_xx/D_zz = {ratio}; chi = {ratio}/kappa, psi = lambda/kappa.
Computed by carom: the exact solution, followed from regime to regime (adhesion, partial slip, sliding), no time steps.
Accuracy: R_x and spin to 1e-10, the others to 1e-9.";

fn alike(what: &'static str, inertia: f64) -> Result<Table, Failure> {
    let ratio = 1.0 + 1.0 / inertia;
    let head = ALIKE_HEAD
        .replace("{what}", if what == "solid" { "solid" } else { "hollow (thin-walled)" })
        .replace("{inertia}", if what == "solid" { "2/5" } else { "2/3" })
        .replace("{ratio}", &format!("{ratio}"))
        .replace("{slides}", &format!("{}", 2.0 * ratio))
        .replace("{rolled}", &format!("{}", 2.0 / inertia));
    let lambdas: Vec<f64> = (0..=70).map(|i| f64::from(i) / 10.0).chain(GRAZING).collect();
    let pairs = KAPPAS.iter().flat_map(|&kappa| lambdas.iter().map(move |&lambda| (kappa, lambda)));
    let rows: Result<Vec<_>, Failure> =
        pairs.map(|(kappa, lambda)| impact(inertia, kappa, lambda)).collect();
    let name =
        if what == "solid" { "oblique_impact_solid.csv" } else { "oblique_impact_hollow.csv" };
    const TEN: Option<usize> = Some(10);
    let decimals = &[None, None, TEN, TEN, TEN, TEN, TEN, TEN];
    Ok(Table { name, head, columns: ALIKE, decimals, rows: rows? })
}

fn impact(inertia: f64, kappa: f64, lambda: f64) -> Result<Vec<f64>, Failure> {
    let ratio = 1.0 + 1.0 / inertia;
    let groups = Groups::new(ratio / kappa, lambda / kappa)?;
    let r_x = ObliqueImpact::new(groups)?.restitution();
    // Impulse J: m (1 + R_x) v_t = D J with D = ratio, and inertia m R omega = J.
    let spin = (1.0 + r_x) / (ratio * inertia);
    let [most, least] = ObliqueImpact::force_extremes(groups)?;
    let of = |force: f64| force / kappa;
    let at = |time: f64| time / normal::DURATION;
    Ok(vec![
        kappa,
        lambda,
        r_x,
        spin,
        of(most.force),
        at(most.time),
        of(least.force),
        at(least.time),
    ])
}

// ---- unlike materials --------------------------------------------------------------------------

const UNLIKE: &[&str] = &["kappa", "gamma", "f", "lambda", "R_x", "error_estimate"];

const UNLIKE_HEAD: &str = "\
Elastic oblique impact of solid spheres of unlike materials with Coulomb friction, without spin about the normal.

kappa           normal over tangential stiffness of the pair, without coupling: sum (2 - nu)/G over 2 sum (1 - nu)/G
gamma           coupling: ((1 - 2 nu_1)/G_1 - (1 - 2 nu_2)/G_2) over 2 sum (1 - nu)/G; its sign does not matter
f               coefficient of friction
lambda          v_t/(f v_n): tangential over normal velocity before the impact, over f
R_x             -(tangential velocity of the contact point after)/(before)
error_estimate  how far R_x may be off; no bound: it covered 98 of 100 drawn impacts

By interpolation in carom's table, which a law of rings and sectors filled (16 x 16 rings, 128 steps); corrected
by the exact impact of like bodies where gamma/f is small. Against a grid of 64 cells in 256 steps (lambda > 0.2,
gamma f < 0.1) it is off by less than 2e-3 in the mean and 8e-3 at most. gamma = 0 is in oblique_impact_solid.csv.";

fn dissimilar() -> Result<Table, Failure> {
    let lambdas = (1..=20).map(|i| f64::from(i) * 0.25).chain([5.5, 6.0, 7.0, 8.0]);
    let lambdas: Vec<f64> = lambdas.collect();
    let mut rows = Vec::new();
    for tenth in 10..15 {
        for gamma in [0.05, 0.1, 0.2, 0.3, 0.4, 0.5] {
            let kappa = f64::from(tenth) / 10.0;
            if gamma > 1.5 - kappa + 1e-9 {
                continue;
            }
            for f in [0.05, 0.1, 0.2, 0.3, 0.5] {
                for &lambda in &lambdas {
                    let friction = Friction::new(f)?;
                    let groups = DissimilarGroups::of_spheres(kappa, gamma, friction, lambda)?;
                    let found = DissimilarTable::shared().stored(&groups);
                    let found = found.ok_or("outside of the table")?;
                    rows.push(vec![kappa, gamma, f, lambda, found.r_x, found.error_estimate]);
                }
            }
        }
    }
    Ok(Table {
        name: "oblique_impact_dissimilar.csv",
        head: UNLIKE_HEAD.to_owned(),
        columns: UNLIKE,
        decimals: &[None, None, None, None, Some(5), Some(4)],
        rows,
    })
}

// ---- files -------------------------------------------------------------------------------------

impl Table {
    fn path(&self) -> PathBuf {
        PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../reference")).join(self.name)
    }

    fn text(&self) -> Result<String, Failure> {
        let mut text = String::new();
        for line in self.head.lines() {
            writeln!(text, "{}", format!("# {line}").trim_end())?;
        }
        writeln!(
            text,
            "#\n# Made on {} by `cargo xtask generate --tables` in the sources of carom.",
            today()?
        )?;
        writeln!(text, "# Licence: MIT OR Apache-2.0")?;
        writeln!(text, "{}", self.columns.join(","))?;
        for row in &self.rows {
            let cells = row.iter().zip(self.decimals).map(|(value, decimals)| match decimals {
                // What rounds to zero has no sign.
                Some(digits) => format!("{:.digits$}", value).replace(ZERO, &ZERO[1..]),
                None => format!("{value}"),
            });
            writeln!(text, "{}", cells.collect::<Vec<_>>().join(","))?;
        }
        Ok(text)
    }

    /// Compares the numbers of the file with those of this table.
    fn check(&self) -> Result<(), Failure> {
        let text = std::fs::read_to_string(self.path())?;
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let agrees = lines.next() == Some(self.columns.join(",").as_str());
        let mut largest = 0.0_f64;
        let mut count = 0;
        for (line, row) in lines.by_ref().zip(&self.rows) {
            for ((cell, value), decimals) in line.split(',').zip(row).zip(self.decimals) {
                let rounding = decimals.map_or(0.0, |digits| 0.5 * 0.1_f64.powi(digits as i32));
                largest = largest.max((cell.parse::<f64>()? - value).abs() - rounding);
                count += 1;
            }
        }
        let whole = count == self.rows.len() * self.columns.len() && lines.next().is_none();
        println!("{}: {count} entries, off by {largest:.1e} at most beyond rounding", self.name);
        match agrees && whole && largest <= CLOSE {
            true => Ok(()),
            false => {
                Err(Error::other(format!("{} is not what the library makes", self.name)).into())
            }
        }
    }
}

/// What rounding makes of small negative numbers.
const ZERO: &str = "-0.0000000000";

/// The day of the clock, as 2026-01-31.
fn today() -> Result<String, Failure> {
    let days = SystemTime::now().duration_since(UNIX_EPOCH)?.as_secs() / 86_400;
    // Years begin in March, so that a leap day is the last of its year; 719468 days from 0000-03-01 to 1970-01-01.
    let days = days + 719_468;
    let (era, of_era) = (days / 146_097, days % 146_097);
    let year = (of_era - of_era / 1_460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (month, turn) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    Ok(format!("{:04}-{month:02}-{day:02}", 400 * era + year + turn))
}
