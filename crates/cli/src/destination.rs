//! Where a picture goes: standard output, or a file whose name says what kind of picture it is.

use crate::outputs::Place;
use std::path::Path;

/// Kind of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Vectors.
    Svg,
    /// Pixels.
    Png,
}

impl Kind {
    /// That of the file `path`.
    ///
    /// # Errors
    /// Which names there are, if its ending is none of them.
    pub(crate) fn of(path: &Path) -> Result<Self, &'static str> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        match () {
            () if ending.eq_ignore_ascii_case("svg") => Ok(Self::Svg),
            () if ending.eq_ignore_ascii_case("png") => Ok(Self::Png),
            () => Err(KINDS),
        }
    }
}

const KINDS: &str = "a picture's name must end in .svg or .png, or be - for SVG on standard output";

/// A place for a picture that may be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Destination {
    /// Standard output, as SVG.
    StandardOutput,
    /// A file.
    File {
        /// Where it is.
        place: Place,
        /// What goes there.
        kind: Kind,
    },
}

impl Destination {
    /// The kind of picture that goes there.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::StandardOutput => Kind::Svg,
            Self::File { kind, .. } => *kind,
        }
    }
}
