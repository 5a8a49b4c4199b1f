//! `carom restitution`: R_x of spheres by kappa and lambda, of any bodies by chi and psi.

use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, csv, json, short, table};
use crate::range::Values;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_plot::{Axis, Marker, Panel, Series, render};
use carom_special::RangeError;
use rayon::prelude::*;
use serde::Serialize;
use serde::ser::SerializeMap;
use std::path::PathBuf;

/// Tangential restitution R_x of solid spheres (--kappa, --lambda) or of any bodies whose normal
/// and tangential motions are uncoupled (--chi, --psi).
///
/// R_x is the tangential velocity of the contact points after the impact over that before,
/// reversed: 1 rebounds elastically, 0 stops, -1 slides on unhindered. Lists give every pair.
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
    /// Draw the results into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
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
}

impl Serialize for Row {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(4))?;
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
        map.end()
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let plane = Plane::of(arguments);
    let heads = [plane.names[0], plane.names[1], "R_x", "regimes"];
    let inputs = plane.pairs().map(|[a, b]| Ok(([a, b], (plane.groups)(a, b)?)));
    let rows = inputs
        .collect::<Result<Vec<_>, RangeError>>()?
        .into_par_iter()
        .map(|(numbers, groups)| {
            let impact = ObliqueImpact::new(groups)?;
            let regimes = impact.regimes().map(Regime::name).collect();
            Ok(Row { names: plane.names, numbers, restitution: impact.restitution(), regimes })
        })
        .collect::<Result<Vec<Row>, CliError>>()?;
    let text = match arguments.format {
        Format::Json => json(&rows)?,
        Format::Csv => csv(&heads, &cells(&rows, |value| value.to_string()))?,
        Format::Table => table(&heads, &cells(&rows, short)),
    };
    let plot = match &arguments.plot {
        Some(path) => Some(PlotFile { path: path.clone(), svg: plot(&rows, &plane)? }),
        None => None,
    };
    Ok(Answer { text, warnings: Vec::new(), plot })
}

fn cells(rows: &[Row], number: impl Fn(f64) -> String) -> Vec<Vec<String>> {
    let cells = rows.iter().map(|row| {
        let numbers = row.numbers.into_iter().chain([row.restitution]).map(&number);
        numbers.chain([row.regimes.join(" ")]).collect()
    });
    cells.collect()
}

/// R_x against the second number, a line for each first one; against the first if there is one
/// second only.
fn plot(rows: &[Row], plane: &Plane<'_>) -> Result<String, CliError> {
    let [first, second] = plane.values;
    let [symbol, other] = plane.symbols;
    let (label, lines): (_, Vec<Series>) = if second.len() == 1 && first.len() > 1 {
        let points = rows.iter().map(|row| (row.numbers[0], row.restitution));
        (symbol, vec![line(format!("{other} = {}", short(second[0])), points.collect())])
    } else {
        let lines = rows.chunks(second.len().max(1)).map(|rows| {
            let finite = rows.iter().filter(|row| row.numbers[1].is_finite());
            let points = finite.map(|row| (row.numbers[1], row.restitution));
            line(format!("{symbol} = {}", short(rows[0].numbers[0])), points.collect())
        });
        (other, lines.collect())
    };
    let mut panel = Panel::new(Axis::linear(label.to_string()), Axis::linear("R_x"));
    lines.into_iter().for_each(|line| panel.add(line));
    Ok(render(plane.title, &[panel])?)
}

fn line(label: String, points: Vec<(f64, f64)>) -> Series {
    if points.len() > 1 {
        Series::line(label, points)
    } else {
        Series::markers(label, Marker::Dot, points)
    }
}
