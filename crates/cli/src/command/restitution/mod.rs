//! `carom restitution`: R_x of spheres by kappa and lambda, of any bodies by chi and psi.

mod bodies;
mod plane;
mod plot;
mod rows;
mod tensor;

use crate::columns;
use crate::error::CliError;
use crate::format::Printing;
use crate::global_options::Messages;
use crate::output::{Answer, Format, Results};
use crate::outputs::Outputs;
use crate::progress::Progress;
use crate::range::Values;
use crate::rows::{BLOCK, Rows, check_count, indented};
use carom_table::row;
use plane::Plane;
use rayon::prelude::*;
use rows::Row;
use std::path::PathBuf;
use tensor::Tensor;

/// Impacts from which on a bar on standard error, if that is a terminal, shows the progress.
const MANY: usize = 2000;

/// Tangential restitution R_x of solid spheres (--kappa, --lambda), of spheres of dissimilar
/// materials (with --gamma and --friction) or of any bodies whose normal and tangential motions are
/// uncoupled (--chi, --psi).
///
/// R_x is the tangential velocity of the contact points after the impact over that before,
/// reversed: 1 rebounds elastically, 0 stops, -1 slides on unhindered. Lists give every pair; two
/// ranges can be drawn as a map.
///
/// Of dissimilar spheres a table answers where it reaches (kappa from 1, lambda to 8, f to 1,
/// |gamma|/f to 12), elsewhere the impact is followed by rings; error_estimate says how far R_x may
/// be off.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
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
    /// Coupling of dissimilar materials by (15.2), of either sign, at most 3/2 - kappa; 0 is alike
    /// materials.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    #[arg(requires = "friction", conflicts_with_all = ["chi", "psi", "tensor"])]
    gamma: Option<f64>,
    /// Coefficient of friction, on which R_x of dissimilar spheres depends besides lambda; inf is
    /// no slip, where lambda is 0.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, requires = "gamma")]
    friction: Option<f64>,
    /// Ratio of mobility D_xx/D_zz of dissimilar spheres: 3.5 solid, 2.5 hollow.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, requires = "gamma")]
    #[arg(default_value_t = 3.5)]
    mobility_ratio: f64,
    /// Restitution e along the normal of a material that loses energy, from 0 to 1; alike bodies
    /// only.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["gamma", "tensor"])]
    normal_restitution: Option<f64>,
    #[command(flatten)]
    printing: Printing,
    /// Draw lines over the second number into this file, as SVG, PNG or PDF by its ending; - is
    /// standard output.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Draw a map over both numbers, colours and contour lines, into this file, as for --plot.
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

/// What the rows hold.
fn help() -> String {
    let spheres = columns::help("A row for each pair, with --kappa and --lambda", rows::OF_SPHERES);
    let dissimilar = columns::help("with --gamma", rows::OF_DISSIMILAR);
    let lossy = columns::help("with --normal-restitution, after the two numbers", rows::OF_LOSSY);
    let any = columns::help("with --chi and --psi", rows::OF_ANY);
    let tensor = columns::help("with --tensor also", rows::OF_TENSOR);
    format!("{spheres}{dissimilar}{any}{lossy}{tensor}")
}

pub(super) fn run(
    arguments: &Arguments,
    messages: &Messages,
    results: &mut Results,
) -> Result<Answer, CliError> {
    let plane = Plane::of(arguments)?;
    arguments.printing.check()?;
    let mut outputs = Outputs::of_command(arguments.format())?;
    let mut to = |option, path: &Option<PathBuf>| {
        let to = |path: &PathBuf| outputs.picture(option, path, arguments.format());
        path.as_ref().map(to).transpose()
    };
    let (lines, map) = (to("plot", &arguments.plot)?, to("map", &arguments.map)?);
    if map.is_some() {
        plot::check(plane.values)?;
    }
    check_count(arguments.format(), plane.count())?;
    plane.check()?;
    let (text, values) = follow(&plane, arguments, map.is_some(), messages, results)?;
    let picture = match (lines, map) {
        (Some(to), _) => Some((to, plot::lines(&plane)?)),
        (_, Some(to)) => Some((to, plot::map(values, &plane)?)),
        _ => None,
    };
    Ok(Answer { text, picture, ..Answer::default() })
}

impl Arguments {
    /// The format of the results; with a picture, none by default.
    fn format(&self) -> Format {
        match self.plot.is_some() || self.map.is_some() {
            true => self.printing.format_beside_picture(),
            false => self.printing.format(),
        }
    }
}

/// Computes and writes all rows in their order, but for what ends them; keeps R_x if it `is_mapped`.
fn follow(
    plane: &Plane<'_>,
    arguments: &Arguments,
    is_mapped: bool,
    messages: &Messages,
    results: &mut Results,
) -> Result<(String, Vec<f64>), CliError> {
    let ratio = arguments.velocity_ratio.map(tensor::velocity_ratio).transpose()?;
    let ratio = ratio.unwrap_or_default();
    let mut values = Vec::with_capacity(if is_mapped { plane.count() } else { 0 });
    if arguments.format() == Format::None && !is_mapped {
        return Ok((String::new(), values));
    }
    let of_tensor = if arguments.tensor.is_some() { rows::OF_TENSOR } else { &[] };
    let columns = [&plane.columns[..], of_tensor].concat();
    let mut printed = Rows::new(arguments.format());
    let count = plane.count();
    let progress = (count >= MANY).then(|| Progress::new(*messages, count, "impacts"));
    for from in (0..plane.count()).step_by(BLOCK) {
        let rows = (from..plane.count().min(from + BLOCK))
            .into_par_iter()
            .map(|place| {
                progress.iter().for_each(|progress| progress.inc(1));
                Row::new(plane.bodies, plane.pair(place), arguments.tensor, ratio)
            })
            .collect::<Result<Vec<_>, _>>()?;
        if is_mapped {
            values.extend(rows.iter().map(|row| row.restitution));
        }
        let cells = |line: &Row| row(&columns, Some(line));
        let json = |line: &Row, depth| indented(&line.record(&plane.columns), depth);
        printed.put(&rows, cells, json, results)?;
        // Nobody reads, nobody looks.
        if results.is_closed() && !is_mapped {
            break;
        }
    }
    Ok((printed.finish()?, values))
}
