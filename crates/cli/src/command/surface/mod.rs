//! `carom surface`: what a height map is.

mod plot;
mod save;

use crate::columns;
use crate::error::CliError;
use crate::format::Printing;
use crate::output::{Answer, Format, json};
use crate::outputs::Outputs;
use carom_cases::Error;
use carom_cases::case::{Dimension, HeightFile};
use carom_cases::heights::{Prepared, read_named};
use carom_cases::input::{MOST_OF_MAP, read};
use carom_surface::{Crop, Level, Measures, Reading, Topography, spectrum, spikes};
use carom_table::row;
use clap::ValueEnum;
pub(in crate::command) use save::Saved;
use std::path::PathBuf;

/// What a height map is: size, roughness, slope, tilt, missing points, spikes.
///
/// FILE is an x3p, sur, sdf or npy file, a PNG in greys, or a text: rows of numbers with any
/// separator, or points x y z. The kind is known by the content. Options have the names of the
/// fields of `[gap]` in a case of `carom solve`, which takes the same files. The picture shows the
/// heights, the points that are missing or far off, the distribution of the heights and the
/// spectrum.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    /// The file.
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Unit of the heights (and of x and y of points) if the file does not state it.
    #[arg(long, value_enum, conflicts_with = "scale")]
    unit: Option<Unit>,
    /// Height of one unit of the file, such as "0.5 nm".
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    scale: Option<f64>,
    /// Height of white over black in a PNG, such as "10 um".
    #[arg(long, value_name = "LENGTH", value_parser = length, conflicts_with = "scale")]
    range: Option<f64>,
    /// Lengths of the whole map along x and y, such as "1 mm, 2 mm", instead of what the file says.
    #[arg(long, value_name = "X,Y", value_parser = length, value_delimiter = ',', num_args = 1)]
    size: Vec<f64>,
    /// Part of the map in points from 0: left, lower, right, upper.
    #[arg(long, value_name = "L,B,R,T", value_delimiter = ',', num_args = 1)]
    crop: Vec<usize>,
    /// Subtract this from the heights, by least squares: mean, plane or quadratic.
    #[arg(long, value_name = "WHAT")]
    level: Option<Level>,
    /// Fill points without a height by a smooth patch of the heights around them.
    #[arg(long, value_enum)]
    missing: Option<Missing>,
    /// The map repeats itself: look at its border, and take its spectrum without a window.
    #[arg(long)]
    periodic: bool,
    /// Save the map, as cut, levelled and filled, in m as .npy or .x3p.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,
    #[command(flatten)]
    printing: Printing,
    /// Draw the map into this file, as SVG, PNG or PDF according to its ending; - is standard
    /// output.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// Units of heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Unit {
    M,
    Mm,
    Um,
    Nm,
}

impl Unit {
    const fn metres(self) -> f64 {
        match self {
            Self::M => 1.0,
            Self::Mm => 1e-3,
            Self::Um => 1e-6,
            Self::Nm => 1e-9,
        }
    }
}

/// What stands for missing points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Missing {
    Fill,
}

fn help() -> String {
    columns::help("Columns", Measures::COLUMNS)
}

/// A positive length with its unit, or in m.
fn length(text: &str) -> Result<f64, String> {
    let plain = || text.trim().parse().ok();
    let read = Dimension::Length.read(text).or_else(plain);
    let fits = |length: &f64| length.is_finite() && *length > 0.0;
    read.filter(fits).ok_or_else(|| "must be a length > 0 such as \"2 mm\" or 0.002".to_owned())
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    arguments.printing.check()?;
    let format = arguments.format();
    let mut outputs = Outputs::of_command(format)?;
    let picture = |path: &PathBuf| outputs.picture("plot", path, format);
    let to = arguments.plot.as_ref().map(picture).transpose()?;
    let saved =
        arguments.save.as_ref().map(|path| Saved::claim(path, "save", &mut outputs)).transpose()?;
    outputs.check_input(&arguments.file)?;
    let prepared = arguments.prepared()?;
    let map = &prepared.topography;
    let (spectrum, far) = (spectrum(map, arguments.periodic), spikes(map));
    let measures = Measures::of(map, spectrum.as_ref(), &far);
    let mut warnings = prepared.notes.clone();
    if !prepared.has_unit && prepared.notes.is_empty() {
        warnings.push(NO_UNIT.to_owned());
    }
    warnings.extend(measures.warnings(arguments.periodic));
    let text = match format {
        Format::Json => json(&columns::Record::new(Measures::COLUMNS, &measures))?,
        Format::Table(page) => {
            page.fold(&headline(&prepared))
                + &columns::upright(page, &row(Measures::COLUMNS, Some(&measures)))
        }
        Format::Csv | Format::Chosen(_) | Format::None => {
            columns::rows(format, Measures::COLUMNS, &[measures])?
        }
    };
    let picture = match to {
        Some(to) => Some((to, plot::draw(map, spectrum.as_ref(), &far)?)),
        None => None,
    };
    let files = match saved {
        Some(saved) => vec![saved.map(map, "heights in m")?],
        None => Vec::new(),
    };
    Ok(Answer { text, warnings, picture, files, ..Answer::default() })
}

const NO_UNIT: &str = "the file does not state the unit of its heights: they are taken as m; --unit m confirms it, um is usual";

/// A line on the kind of file.
fn headline(prepared: &Prepared) -> String {
    let map = &prepared.topography;
    let unit = match (prepared.has_unit, map.spacing()) {
        (true, Some(_)) => "size and unit are known",
        (true, None) => "its size is not stated",
        (false, Some(_)) => "the unit of its heights is not stated",
        (false, None) => "neither size nor unit is stated",
    };
    format!("{}: {} x {} points, {unit}\n", prepared.format.name(), map.columns(), map.rows())
}

impl Arguments {
    fn format(&self) -> Format {
        match self.plot {
            Some(_) => self.printing.format_beside_picture(),
            None => self.printing.format(),
        }
    }

    /// The map, as the options make it.
    fn prepared(&self) -> Result<Prepared, CliError> {
        let refused = |reason: String| Error::input(reason).of_file(&self.file);
        let crop = <[usize; 4]>::try_from(self.crop.clone()).ok().map(Crop);
        if crop.is_none() && !self.crop.is_empty() {
            return Err(Error::input("--crop needs four numbers: left,lower,right,upper").into());
        }
        let fields = HeightFile {
            file: self.file.clone(),
            reading: Reading {
                unit: self.unit.map(Unit::metres),
                range: self.range,
                ..Reading::default()
            },
            scale: self.scale.unwrap_or(1.0),
            crop,
            level: self.level,
            missing: None,
            radius: f64::INFINITY,
        };
        let bytes = read(&self.file, MOST_OF_MAP, "a file")?;
        let mut measured = read_named(&self.file, &bytes, fields.reading).map_err(refused)?;
        measured.topography = self.sized(measured.topography)?;
        let mut prepared =
            Prepared::of(measured, &fields).map_err(|error| refused(error.to_string()))?;
        if self.missing == Some(Missing::Fill) {
            prepared.topography = prepared.topography.filled();
        }
        Ok(prepared)
    }

    /// The map with the size that is given.
    fn sized(&self, map: Topography) -> Result<Topography, CliError> {
        let own = map.spacing();
        let [columns, rows] = [map.columns() as f64, map.rows() as f64];
        let spacing = match self.size[..] {
            [] => own,
            [x] => Some([x / columns; 2]),
            [x, y] => Some([x / columns, y / rows]),
            _ => return Err(Error::input("--size needs one or two lengths: x,y").into()),
        };
        Ok(map.spaced(spacing))
    }
}
