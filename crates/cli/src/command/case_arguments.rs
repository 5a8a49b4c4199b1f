//! Arguments that name a case, or a kind of case.

use crate::destination::Destination;
use crate::error::CliError;
use crate::format::Printing;
use crate::output::{Format, Picture, Shown};
use crate::outputs::Outputs;
use carom_cases::case::CaseKind;
use carom_cases::input::CaseFile;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use std::sync::OnceLock;

/// Parses a kind of case.
pub(super) fn kind() -> impl TypedValueParser<Value = CaseKind> {
    let value = |kind: CaseKind| PossibleValue::new(kind.name).help(kind.meaning);
    PossibleValuesParser::new(CaseKind::ALL.map(value)).try_map(|word| word.parse::<CaseKind>())
}

/// Arguments of every command with a case file.
#[derive(Debug, clap::Args)]
pub(super) struct CaseArguments {
    /// The case file; - is standard input.
    #[arg(value_name = "CASE.toml")]
    pub(super) case: PathBuf,
    #[command(flatten)]
    pub(super) printing: Printing,
    /// Draw the results into this file, as SVG, PNG or PDF according to its ending; - is standard
    /// output.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Show the panels of the picture that say most, or all.
    #[arg(long, value_name = "WHICH", value_enum, default_value_t, hide_possible_values = true)]
    panels: Shown,
    /// The text of the case, once it is read.
    #[arg(skip)]
    pub(super) text: OnceLock<String>,
}

/// A case file and the destination of its picture, if one is requested.
pub(super) struct Given {
    pub(super) case: CaseFile,
    pub(super) plot: Option<Destination>,
}

impl CaseArguments {
    /// The format of the results; with a picture, none by default.
    pub(super) fn format(&self) -> Format {
        match self.plot {
            Some(_) => self.printing.format_beside_picture(),
            None => self.printing.format(),
        }
    }

    /// A picture for the place given with --plot, with the panels asked for.
    pub(super) fn drawn(&self, to: Destination, picture: Picture) -> (Destination, Picture) {
        (to, picture.showing(self.panels))
    }

    /// Reads the case after checking that no output goes to the same file.
    pub(super) fn read(&self) -> Result<Given, CliError> {
        Ok(self.read_beside(|_| Ok(()))?.0)
    }

    /// The same, with other outputs that the command `claims`.
    pub(super) fn read_beside<T>(
        &self,
        claims: impl FnOnce(&mut Outputs) -> Result<T, CliError>,
    ) -> Result<(Given, T), CliError> {
        self.printing.check()?;
        let mut outputs = Outputs::of_command(self.format())?;
        // Checked first, so that no other error is written to a stream that goes to the case file.
        outputs.check_input(&self.case)?;
        let to = |path: &PathBuf| outputs.picture("plot", path, self.format());
        let plot = self.plot.as_ref().map(to).transpose()?;
        let claimed = claims(&mut outputs)?;
        let case = outputs.read_case(&self.case)?;
        self.text.get_or_init(|| case.text().to_owned());
        Ok((Given { case, plot }, claimed))
    }
}
