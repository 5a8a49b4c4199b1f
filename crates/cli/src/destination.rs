//! Destination of a picture: standard output, or a file whose name gives the format.

use crate::place::Place;
use std::path::Path;

/// Format of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Vector graphics.
    Svg,
    /// Raster graphics.
    Png,
    /// Vector graphics on a page, as papers want it.
    Pdf,
}

impl Kind {
    /// The format of the file `path`, by its ending.
    ///
    /// # Errors
    /// The allowed names, if its ending is none of them.
    pub(crate) fn of(path: &Path) -> Result<Self, &'static str> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        match () {
            () if ending.eq_ignore_ascii_case("svg") => Ok(Self::Svg),
            () if ending.eq_ignore_ascii_case("png") => Ok(Self::Png),
            () if ending.eq_ignore_ascii_case("pdf") => Ok(Self::Pdf),
            () => Err(KINDS),
        }
    }
}

const KINDS: &str =
    "a picture's name must end in .svg, .png or .pdf, or be - for SVG on standard output";

/// A destination of a picture, checked to be writable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Destination {
    /// Standard output, as SVG.
    StandardOutput,
    /// A file.
    File {
        /// Its place.
        place: Place,
        /// Its format.
        kind: Kind,
    },
}

impl Destination {
    /// The format of the picture.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::StandardOutput => Kind::Svg,
            Self::File { kind, .. } => *kind,
        }
    }
}
