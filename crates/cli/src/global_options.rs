//! Global options of all commands: threads, colours, quiet.

use crate::page::{fold, width};
use clap::ColorChoice;
use clap::builder::styling::{AnsiColor, Style};
use std::ffi::{OsStr, OsString};
use std::io::{IsTerminal as _, Write as _};

/// Options of every command.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub struct GlobalOptions {
    /// Print errors only: no warnings and no progress on standard error.
    #[arg(long, short, global = true)]
    quiet: bool,
    /// End with exit code 3 if there is a warning; results are written all the same.
    #[arg(long, global = true)]
    strict: bool,
    /// Colours of help and messages; auto: on a terminal, unless NO_COLOR is set.
    #[arg(long, value_name = "WHEN", value_enum, default_value_t, global = true)]
    color: ColorChoice,
    /// Number of threads; by default the number of cores. Results do not depend on it.
    #[arg(long, value_name = "COUNT", global = true)]
    #[arg(allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl GlobalOptions {
    /// The message writer for these options.
    #[must_use]
    pub fn messages(&self) -> Messages {
        Messages {
            is_quiet: self.quiet,
            is_coloured: is_coloured(self.color, std::io::stderr().is_terminal()),
        }
    }

    /// Whether a warning ends the command with [`STRICT`].
    #[must_use]
    pub const fn is_strict(&self) -> bool {
        self.strict
    }

    /// The number of threads; `None` for the number of cores.
    #[must_use]
    pub fn threads(&self) -> Option<usize> {
        self.threads.map(usize::from)
    }
}

/// The exit code of a command with `--strict` that warns.
pub const STRICT: u8 = 3;

/// The colour option among the arguments, before they are parsed: help and errors of the parser are
/// coloured too.
pub fn asked_colour(arguments: impl IntoIterator<Item = OsString>) -> ColorChoice {
    let mut choice = ColorChoice::Auto;
    let mut arguments = arguments.into_iter().skip(1);
    while let Some(argument) = arguments.next() {
        let word = match argument.to_str() {
            Some("--") => break,
            Some("--color") => arguments.next(),
            Some(argument) => argument.strip_prefix("--color=").map(OsString::from),
            None => None,
        };
        let word = word.as_deref().and_then(OsStr::to_str);
        choice = word.and_then(|word| word.parse().ok()).unwrap_or(choice);
    }
    choice
}

/// Whether letters are coloured, on a terminal or elsewhere.
#[must_use]
pub fn is_coloured(choice: ColorChoice, is_terminal: bool) -> bool {
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    match choice {
        ColorChoice::Always => true,
        ColorChoice::Never => false,
        ColorChoice::Auto => {
            let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
            is_terminal && !is_set("NO_COLOR") && !is_dumb
        }
    }
}

/// Writes messages to standard error. Failures to write are ignored.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Messages {
    is_quiet: bool,
    is_coloured: bool,
}

impl Messages {
    /// Writes errors only.
    pub const QUIET: Self = Self { is_quiet: true, is_coloured: false };

    /// Writes the error that ended the command.
    pub fn error(&self, line: &str) {
        self.tell(AnsiColor::Red, "error", line);
    }

    /// Writes a warning about the results, unless quiet.
    pub fn warning(&self, line: &str) {
        if !self.is_quiet {
            self.tell(AnsiColor::Yellow, "warning", line);
        }
    }

    fn tell(self, colour: AnsiColor, kind: &str, line: &str) {
        let style = if self.is_coloured { colour.on_default().bold() } else { Style::new() };
        let folded = fold(&format!("{kind}: {line}"), width(&console::Term::stderr()));
        let text = folded.strip_prefix(kind).and_then(|text| text.strip_prefix(':'));
        let text = text.unwrap_or(&folded);
        let _ = writeln!(std::io::stderr(), "{style}{kind}:{style:#}{text}");
    }

    /// Writes how far a computation is, unless quiet.
    pub(crate) fn progress(&self, line: &str) {
        if !self.is_quiet {
            self.tell(AnsiColor::Cyan, "progress", line);
        }
    }

    /// Whether only errors are written.
    pub(crate) const fn is_quiet(self) -> bool {
        self.is_quiet
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_seen_before_the_arguments_are_parsed() {
        let asked = |line: &str| asked_colour(line.split(' ').map(OsString::from));
        assert_eq!(asked("carom impact --color never"), ColorChoice::Never);
        assert_eq!(asked("carom --color=always impact --nonsense"), ColorChoice::Always);
        assert_eq!(asked("carom impact -- --color=always"), ColorChoice::Auto);
        assert_eq!(asked("carom --color mauve"), ColorChoice::Auto);
        assert_eq!(asked("carom --color"), ColorChoice::Auto);
    }
}
