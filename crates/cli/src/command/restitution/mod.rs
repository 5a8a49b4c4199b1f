//! `carom restitution`: R_x of spheres by kappa and lambda, of any bodies by chi and psi.

mod plot;
mod tensor;

use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, csv, json, short, table};
use crate::range::Values;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_special::RangeError;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;
use serde::Serialize;
use serde::ser::SerializeMap;
use std::path::PathBuf;
use tensor::{Tensor, TensorRecord};

/// Impacts from which on a bar on standard error, if that is a terminal, shows the progress.
const MANY: usize = 2000;

/// Tangential restitution R_x of solid spheres (--kappa, --lambda) or of any bodies whose normal
/// and tangential motions are uncoupled (--chi, --psi).
///
/// R_x is the tangential velocity of the contact points after the impact over that before,
/// reversed: 1 rebounds elastically, 0 stops, -1 slides on unhindered. Lists give every pair; two
/// ranges can be drawn as a map.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Ratio of stiffness c_z/c_x, (2 - nu)/(2 (1 - nu)): a value, a list 1,1.2 or
    /// start:stop:count.
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    #[arg(requires = "lambda", conflicts_with_all = ["chi", "psi"], required_unless_present = "chi")]
    kappa: Option<Values>,
    /// Tangential over normal velocity, over friction: a value, a list 1,2 or start:stop:count.
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true, requires = "kappa")]
    lambda: Option<Values>,
    /// Ratio of mobility times stiffness D_xx c_x/(D_zz c_z): a value, a list or start:stop:count.
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true, requires = "psi")]
    chi: Option<Values>,
    /// c_x/c_z times tangential over normal velocity, over friction: values as for lambda.
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true, requires = "chi")]
    psi: Option<Values>,
    /// Format of the results.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Draw lines over the second number into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Draw a map over both numbers, colours and contour lines, into this file, as SVG.
    #[arg(long, value_name = "FILE", conflicts_with = "plot")]
    map: Option<PathBuf>,
    /// Give the restitution tensor (3.3) too: `secant` is diag(R_x, R_x, 1), `tangent` is
    /// -dv_after/dv_before. x is the direction of slip.
    #[arg(long, value_enum)]
    tensor: Option<Tensor>,
    /// Tangential over normal velocity before, which the tangent tensor needs.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    #[arg(required_if_eq("tensor", "tangent"))]
    velocity_ratio: Option<f64>,
}

/// The two numbers that span the results: their names, values and meaning.
struct Plane<'a> {
    names: [&'static str; 2],
    symbols: [char; 2],
    title: &'static str,
    values: [&'a [f64]; 2],
    groups: fn(f64, f64) -> Result<Groups, RangeError>,
}

fn list(values: &Option<Values>) -> &[f64] {
    values.as_ref().map_or(&[], |values| &values.0)
}

impl Plane<'_> {
    fn of(arguments: &Arguments) -> Plane<'_> {
        if arguments.kappa.is_some() {
            Plane {
                names: ["kappa", "lambda"],
                symbols: ['κ', 'λ'],
                title: "Tangential restitution of spheres",
                values: [list(&arguments.kappa), list(&arguments.lambda)],
                groups: Groups::of_spheres,
            }
        } else {
            Plane {
                names: ["chi", "psi"],
                symbols: ['χ', 'ψ'],
                title: "Tangential restitution",
                values: [list(&arguments.chi), list(&arguments.psi)],
                groups: Groups::new,
            }
        }
    }

    fn pairs(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let [first, second] = self.values;
        first.iter().flat_map(move |a| second.iter().map(move |b| [*a, *b]))
    }
}

#[derive(Debug)]
struct Row {
    names: [&'static str; 2],
    numbers: [f64; 2],
    restitution: f64,
    regimes: Vec<&'static str>,
    tensor: Option<TensorRecord>,
}

impl Serialize for Row {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, number) in self.names.iter().zip(self.numbers) {
            // JSON has no infinity: frictionless bodies have the word `inf`.
            if number.is_finite() {
                map.serialize_entry(name, &number)?;
            } else {
                map.serialize_entry(name, "inf")?;
            }
        }
        map.serialize_entry("R_x", &self.restitution)?;
        map.serialize_entry("regimes", &self.regimes)?;
        if let Some(tensor) = &self.tensor {
            map.serialize_entry("tensor", tensor)?;
        }
        map.end()
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let plane = Plane::of(arguments);
    if arguments.map.is_some() {
        plot::check(plane.values)?;
    }
    let ratio = arguments.velocity_ratio.map(tensor::velocity_ratio).transpose()?;
    let rows = rows(&plane, arguments.tensor, ratio.unwrap_or_default())?;
    let mut heads = vec![plane.names[0], plane.names[1], "R_x", "regimes"];
    if arguments.tensor.is_some() {
        heads.extend(tensor::HEADS);
    }
    let text = match arguments.format {
        Format::Json => json(&rows)?,
        Format::Csv => csv(&heads, &cells(&rows, |value| value.to_string()))?,
        Format::Table => table(&heads, &cells(&rows, short)),
    };
    let plot = match (&arguments.plot, &arguments.map) {
        (Some(path), _) => Some(PlotFile { path: path.clone(), svg: plot::lines(&rows, &plane)? }),
        (_, Some(path)) => Some(PlotFile { path: path.clone(), svg: plot::map(&rows, &plane)? }),
        _ => None,
    };
    Ok(Answer { text, warnings: Vec::new(), plot })
}

/// All pairs in their order, in parallel.
fn rows(plane: &Plane<'_>, tensor: Option<Tensor>, ratio: f64) -> Result<Vec<Row>, CliError> {
    let inputs = plane
        .pairs()
        .map(|[a, b]| Ok(([a, b], (plane.groups)(a, b)?)))
        .collect::<Result<Vec<_>, RangeError>>()?;
    let bar = progress(inputs.len());
    let rows = inputs
        .into_par_iter()
        .map(|(numbers, groups)| {
            let impact = ObliqueImpact::new(groups)?;
            let regimes = impact.regimes().map(Regime::name).collect();
            let restitution = impact.restitution();
            let tensor = tensor.map(|tensor| tensor.record(groups, ratio)).transpose()?;
            bar.inc(1);
            Ok(Row { names: plane.names, numbers, restitution, regimes, tensor })
        })
        .collect();
    bar.finish_and_clear();
    rows
}

/// A bar for many impacts; it hides where standard error is no terminal.
fn progress(count: usize) -> ProgressBar {
    if count < MANY {
        return ProgressBar::hidden();
    }
    let target = ProgressDrawTarget::stderr_with_hz(10);
    let bar = ProgressBar::with_draw_target(Some(count as u64), target);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} impacts, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

fn cells(rows: &[Row], number: impl Fn(f64) -> String) -> Vec<Vec<String>> {
    let cells = rows.iter().map(|row| {
        let numbers = row.numbers.into_iter().chain([row.restitution]).map(&number);
        let mut cells: Vec<String> = numbers.chain([row.regimes.join(" ")]).collect();
        if let Some(tensor) = &row.tensor {
            cells.extend(tensor.cells(&number));
        }
        cells
    });
    cells.collect()
}
