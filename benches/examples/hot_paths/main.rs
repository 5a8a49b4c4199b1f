//! Hot paths with fixed work, for counts of instructions: `hot_paths` prints their names, `hot_paths NAME`
//! runs one.
//!
//! Only what runs inside [`counted`] counts: tables and operators are made before. `cargo xtask
//! instructions` compares the counts with `benches/instructions.toml`.

mod functions;
mod grids;
mod impacts;
mod laws;

use std::hint::black_box;
use std::process::ExitCode;

/// The work of a path; its result depends on all of it, so that nothing is left out.
type Work = Box<dyn FnMut() -> f64>;

/// A name and what prepares the work.
type HotPath = (&'static str, fn() -> Work);

/// The function whose instructions are counted, with all that it calls.
#[inline(never)]
fn counted(work: &mut dyn FnMut() -> f64) -> f64 {
    black_box(work())
}

fn main() -> ExitCode {
    let all = [functions::PATHS, grids::PATHS, laws::PATHS, impacts::PATHS].concat();
    let Some(name) = std::env::args().nth(1) else {
        all.iter().for_each(|(name, _)| println!("{name}"));
        return ExitCode::SUCCESS;
    };
    let Some((_, prepare)) = all.iter().find(|(own, _)| *own == name) else {
        eprintln!("no path {name}");
        return ExitCode::FAILURE;
    };
    // Idle threads would wait for work, for as long as it takes.
    if let Err(error) = rayon::ThreadPoolBuilder::new().num_threads(1).build_global() {
        eprintln!("{error}");
        return ExitCode::FAILURE;
    }
    let result = counted(&mut *prepare());
    println!("{name}: {result:e}");
    if result.is_finite() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
