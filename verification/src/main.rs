#![forbid(unsafe_code)]
//! `carom-verify`: computes tables and figures of the thesis and checks their claims.

use carom_verification::files::{Folder, WriteError};
use carom_verification::launch::Launch;
use carom_verification::page::Page;
use carom_verification::report::Report;
use carom_verification::selection::{Filter, Selection, Slow};
use carom_verification::snapshot::{self, Policy};
use carom_verification::tally::Tally;
use carom_verification::{Entry, catalogue, ci, run, section, terminal};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::process::{Command, ExitCode};
use std::time::Duration;

#[path = "../../xtask/src/root.rs"]
mod root;

use root::root;

mod flags {
    xflags::xflags! {
        /// Computes the tables and figures of the thesis and checks their claims. Writes SVG, CSV
        /// and an HTML report to target/verification/. Pages that are not computed stay in the
        /// report with their date.
        cmd carom-verify {
            /// Only this figure or table, such as 5.3 or table-13.1; repeatable.
            repeated --figure id: String
            /// Only this chapter; repeatable.
            repeated --chapter number: String
            /// Of these, only those with this text or regular expression in name or title.
            optional --filter pattern: String
            /// Skip slow figures.
            optional --quick
            /// Update the snapshots that differ, for pages whose claims all hold, and list the
            /// changes.
            optional --update
            /// List all tables and figures as done, partial or missing, and stop.
            optional --list
            /// Output format: table (default) or json.
            optional --format format: String
            /// Also print failures as annotations of source lines, `::error file=...`; always if
            /// GITHUB_ACTIONS is set.
            optional --annotate
            /// Stop a page after this number of seconds (default 600).
            optional --time-limit seconds: f64
            /// Compute this page only and save its record in target/verification/pages/. A run
            /// starts this for each of its pages.
            optional --alone id: String
        }
    }
}

/// Output format.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Table,
    Json,
}

/// Results of a run.
struct Found {
    pages: Vec<(Entry, Page)>,
    orphans: Vec<PathBuf>,
}

/// An error of the command line or of the system.
enum Failure {
    Usage(String),
    Machine(String),
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        Self::Machine(error.to_string())
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Machine(error.to_string())
    }
}

fn main() -> ExitCode {
    let flags = flags::CaromVerify::from_env_or_exit();
    let end = match &flags.alone {
        Some(id) => alone(id).map(|()| ExitCode::SUCCESS),
        None if flags.list => {
            print!("{}", terminal::list(&catalogue()));
            Ok(ExitCode::SUCCESS)
        }
        None => verify(&flags),
    };
    match end {
        Ok(code) => code,
        Err(Failure::Usage(error)) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
        Err(Failure::Machine(error)) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Computes one page in this process and saves its record.
fn alone(id: &str) -> Result<(), Failure> {
    root::found()?;
    let catalogue = catalogue();
    let entry = catalogue.iter().find(|entry| entry.id == id);
    let entry = *entry.ok_or_else(|| Failure::Usage(format!("no page `{id}`")))?;
    std::panic::set_hook(Box::new(|_| {})); // a panic is reported with its page
    let outcome = run::compute(entry, &snapshots());
    let section = outcome.result.as_ref().map_or_else(|_| String::new(), section::html);
    let folder = Folder::new(output())?;
    folder.draw(&outcome)?;
    folder.save(entry, &Page::new(&outcome, section))?;
    Ok(())
}

fn verify(flags: &flags::CaromVerify) -> Result<ExitCode, Failure> {
    root::found()?;
    let format = format(flags.format.as_deref())?;
    let catalogue = catalogue();
    let entries = selected(flags, &catalogue)?;
    let folder = Folder::new(output())?;
    let mut pages = compute(&entries, &folder, limit(flags.time_limit)?)?;
    let policy = if flags.update { Policy::Update } else { Policy::Check };
    let rewritten =
        if policy == Policy::Update { rewrite(&mut pages, &folder)? } else { String::new() };
    let ids = catalogue.iter().filter(|entry| entry.is_computed()).map(|entry| entry.id);
    let found = Found { orphans: snapshot::orphans(&snapshots(), ids)?, pages };
    let is_fresh = |entry: &Entry| found.pages.iter().any(|(fresh, _)| fresh.id == entry.id);
    let all = with_earlier(&catalogue, &found.pages, &folder);
    let workspace = root();
    let report = Report { catalogue: &catalogue, pages: &all, workspace: &workspace };
    let report = folder.report(&report.html(is_fresh))?;
    let tally = Tally::of(&catalogue, &found.pages);
    match format {
        Format::Table => print_table(&found, &rewritten, &tally, entries.len() == catalogue.len()),
        Format::Json => println!("{:#}", ci::json(&tally, &found.pages, &found.orphans)),
    }
    annotate(flags, &found, format);
    eprintln!("report: {}", report.display());
    let passes = found.orphans.is_empty() && found.pages.iter().all(|(_, page)| page.passes());
    Ok(if passes { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn format(asked: Option<&str>) -> Result<Format, Failure> {
    match asked {
        None | Some("table") => Ok(Format::Table),
        Some("json") => Ok(Format::Json),
        Some(other) => Err(Failure::Usage(format!("--format is `{other}`: table or json"))),
    }
}

fn limit(asked: Option<f64>) -> Result<Duration, Failure> {
    let seconds = asked.unwrap_or(600.0);
    let limit = Duration::try_from_secs_f64(seconds).ok().filter(|limit| !limit.is_zero());
    limit.filter(|limit| limit.as_secs() <= 1_000_000).ok_or_else(|| {
        Failure::Usage(format!("--time-limit is {seconds}: more than 0, at most 1e6 seconds"))
    })
}

fn selected(flags: &flags::CaromVerify, catalogue: &[Entry]) -> Result<Vec<Entry>, Failure> {
    let filter = flags.filter.as_deref().map(Filter::new).transpose();
    let filter = filter.map_err(|error| Failure::Usage(format!("--filter: {error}")))?;
    let selection = Selection {
        ids: flags.figure.clone(),
        chapters: flags.chapter.clone(),
        filter,
        slow: if flags.quick { Slow::Skip } else { Slow::Keep },
    };
    let entries = selection.of(catalogue).map_err(|error| Failure::Usage(error.to_string()))?;
    if !entries.iter().any(Entry::is_computed) {
        let count = entries.len();
        return Err(Failure::Machine(format!(
            "none of the {count} selected pages can be computed yet"
        )));
    }
    Ok(entries)
}

/// Computes the pages, each in its own process.
fn compute(
    entries: &[Entry],
    folder: &Folder,
    limit: Duration,
) -> Result<Vec<(Entry, Page)>, Failure> {
    let count = entries.iter().filter(|entry| entry.is_computed()).count();
    let bar = ProgressBar::new(count as u64);
    let template = "{bar:40} {pos}/{len} {msg} [{elapsed}]";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    let program = std::env::current_exe()?;
    let command = |entry: Entry| {
        let mut command = Command::new(&program);
        command.args(["--alone", entry.id]);
        command
    };
    let pages = Launch { command, folder, limit }.run(entries, |entry| {
        bar.set_message(entry.name());
        bar.inc(1);
    });
    bar.finish_and_clear();
    Ok(pages)
}

/// Updates the snapshots that differ where every claim holds; returns the result of each.
fn rewrite(pages: &mut [(Entry, Page)], folder: &Folder) -> Result<String, Failure> {
    let mut messages = String::new();
    for (entry, page) in pages {
        let (Some(before), Some(text)) = (page.snapshot.clone(), page.text.take()) else {
            continue;
        };
        if !page.holds() {
            messages += &format!("{}: snapshot left as it is, a claim fails\n", entry.name());
            continue;
        }
        snapshot::accept(&snapshots(), entry.id, &text)?;
        messages += &terminal::rewritten(entry, &before);
        page.snapshot = Some(snapshot::Comparison::Written);
        folder.save(*entry, page)?;
    }
    Ok(messages)
}

/// These pages and those of earlier runs, in the order of the catalogue.
fn with_earlier(
    catalogue: &[Entry],
    pages: &[(Entry, Page)],
    folder: &Folder,
) -> Vec<(Entry, Page)> {
    let page = |entry: Entry| {
        let fresh = pages.iter().find(|(fresh, _)| fresh.id == entry.id);
        let page = fresh.map(|(_, page)| page.clone()).or_else(|| folder.load(entry))?;
        Some((entry, page))
    };
    catalogue.iter().filter(|entry| entry.is_computed()).filter_map(|entry| page(*entry)).collect()
}

fn print_table(found: &Found, rewritten: &str, tally: &Tally, is_all: bool) {
    println!("{}", terminal::table(&found.pages));
    print!("{rewritten}{}", terminal::failures(&found.pages));
    for path in &found.orphans {
        println!("{} belongs to no page: delete it", path.display());
    }
    if is_all {
        println!("{tally}");
    } else {
        let passed = found.pages.iter().filter(|(_, page)| page.passes()).count();
        let count = found.pages.len();
        let (claims, total) = (tally.claims, tally.claims_total);
        println!("{passed} of the {count} selected pages pass; {claims} of {total} claims hold");
    }
}

fn annotate(flags: &flags::CaromVerify, found: &Found, format: Format) {
    let is_github = std::env::var_os("GITHUB_ACTIONS").is_some_and(|value| !value.is_empty());
    if !(flags.annotate || is_github) {
        return;
    }
    let text = ci::annotations(&found.pages, &found.orphans);
    match format {
        Format::Table => print!("{text}"),
        Format::Json => eprint!("{text}"), // so that standard output stays JSON
    }
}

fn snapshots() -> PathBuf {
    root().join("verification").join("snapshots")
}

fn output() -> PathBuf {
    root().join("target").join("verification")
}
