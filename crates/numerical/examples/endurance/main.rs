//! Endurance: very many steps of the memories, impacts and drawn contact problems, whose invariants are checked.
//!
//! `cargo run --release -p carom-numerical --example endurance -- coulomb --count 1000000 --seed 1` takes a million
//! steps of Coulomb's memory. The jobs are `line`, `fixed-direction` and `coulomb` (steps), `impacts` and `contacts`.
//! It prints the worst value of each invariant, as `cargo xtask endurance` records it in `benches/endurance.toml`, or
//! stops at the first violation and says by which seed and count it is met again.

mod contacts;
mod draw;
#[path = "../../../solver/tests/it/any_problem/drawn.rs"]
mod drawn;
mod impacts;
mod memory;
mod worst;

use std::process::ExitCode;
use std::time::Instant;

use worst::Worst;

/// What is wrong, and what the worst was before.
type Done = Result<Worst, String>;

/// A job: so many steps or cases from a seed.
type Job = fn(u64, u64) -> Done;

const JOBS: [(&str, Job); 5] = [
    ("line", memory::line),
    ("fixed-direction", memory::fixed_direction),
    ("coulomb", memory::coulomb),
    ("impacts", impacts::run),
    ("contacts", contacts::run),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match chosen(&arguments).and_then(|(job, count, seed)| {
        let start = Instant::now();
        let worst = job(count, seed)?;
        println!("seconds = {:.0}\n{}", start.elapsed().as_secs_f64(), worst.told());
        Ok(())
    }) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The job of the command line, its count and its seed.
fn chosen(arguments: &[String]) -> Result<(Job, u64, u64), String> {
    let names = JOBS.map(|(name, _)| name).join(", ");
    let [name, options @ ..] = arguments else { return Err(format!("the jobs are {names}")) };
    let job = JOBS.iter().find(|(own, _)| own == name);
    let (_, job) = job.ok_or_else(|| format!("no job {name}: they are {names}"))?;
    let (mut count, mut seed) = (100_000, 1);
    for option in options.chunks(2) {
        let [key, number] = option else { return Err(format!("{} needs a number", option[0])) };
        let number = number.parse().map_err(|_| format!("{key} {number}: no whole number"))?;
        match key.as_str() {
            "--count" => count = number,
            "--seed" => seed = number,
            _ => return Err(format!("no option {key}: they are --count and --seed")),
        }
    }
    Ok((*job, count, seed))
}
