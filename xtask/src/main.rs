#![forbid(unsafe_code)]
//! Tasks of the workspace: `cargo xtask verify`, `test`, `mutants`, `tidy`, `browse`,
//! `python`, `lammps`, `doors`, `taplo`, `fuzz`, `endurance`, `install-c`, `release`, `book`, `generate`, `ci`,
//! `bench`, `instructions`.
//!
//! It calls cargo, and reads the sources for `mutants` and `tidy`. It has no numerical dependency, so that it
//! builds quickly.

mod bench;
mod book;
mod browse;
mod cargo;
mod changes;
mod ci;
mod deny;
mod doors;
mod endurance;
mod files;
mod flags;
mod fuzz;
mod generate;
mod install_c;
mod instructions;
mod lammps;
mod mutants;
mod outcome;
mod python;
mod release;
mod root;
mod sanitize;
mod sdist;
mod taplo;
mod test;
mod tidy;
mod tools;

use generate::Mode;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1);
    if let Err(error) = root::found() {
        eprintln!("error: {error}");
        return ExitCode::FAILURE;
    }
    // The program carom-verify parses its own options.
    let done = match arguments.next() {
        Some(word) if word == "verify" => cargo::verify(arguments).map(ExitCode::from),
        _ => run(flags::Xtask::from_env_or_exit()),
    };
    match done {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(flags: flags::Xtask) -> anyhow::Result<ExitCode> {
    match flags.subcommand {
        flags::XtaskCmd::Verify(_) => return Ok(ExitCode::from(cargo::verify([])?)),
        flags::XtaskCmd::Test(options) => test::chosen(&options)?,
        flags::XtaskCmd::Mutants(options) => drop(mutants::run(&options)?.accept()?),
        flags::XtaskCmd::Tidy(_) => tidy::run()?,
        flags::XtaskCmd::Browse(_) => drop(browse::run()?.accept()?),
        flags::XtaskCmd::Python(_) => drop(python::run()?.accept()?),
        flags::XtaskCmd::Release(options) => drop(release::run(&options)?.accept()?),
        flags::XtaskCmd::Book(_) => drop(book::run()?.accept()?),
        flags::XtaskCmd::Generate(options) => {
            let mode = if options.check { Mode::Check } else { Mode::Write };
            match options.tables {
                true => generate::tables(mode)?,
                false => drop(generate::run(mode)?.accept()?),
            }
        }
        flags::XtaskCmd::Lammps(options) => {
            lammps::run(lammps::Which::asked(&options))?.accept().map(drop)?;
        }
        flags::XtaskCmd::Doors(doors) => drop(doors::chosen(doors.name.as_deref())?.accept()?),
        flags::XtaskCmd::Fuzz(options) => {
            let seconds = options.seconds.unwrap_or(fuzz::SECONDS);
            fuzz::run(options.target.as_deref(), seconds)?.accept()?;
        }
        flags::XtaskCmd::Endurance(options) => endurance::run(&options)?,
        flags::XtaskCmd::Taplo(_) => drop(taplo::run()?.accept()?),
        flags::XtaskCmd::InstallC(options) => match &options.prefix {
            Some(prefix) => install_c::install(prefix)?,
            None => drop(install_c::check()?.accept()?),
        },
        flags::XtaskCmd::Deny(_) => drop(deny::run()?.accept()?),
        flags::XtaskCmd::Ci(options) => ci::run(options.long)?,
        flags::XtaskCmd::Bench(options) => bench::run(&options)?,
        flags::XtaskCmd::Instructions(options) => drop(instructions::run(&options)?.accept()?),
    }
    Ok(ExitCode::SUCCESS)
}
