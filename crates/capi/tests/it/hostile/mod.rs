//! Random calls of the whole C interface: valid, extreme and meaningless arguments, null and misaligned
//! pointers, and bytes changed anywhere in the caller's data. Each ends with a status.
//!
//! `sanitize.sh` runs the long form under the address sanitizer and valgrind; `CAROM_CALLS` sets the number
//! of calls, `CAROM_SEED` the seed.

mod calls;
mod world;

use std::collections::BTreeSet;
use std::sync::Mutex;
use std::time::Instant;

use world::World;

/// Where the library gave up, in a status that says so.
static PANICS: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

fn asked(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// So many calls, of which no function is left out.
fn call(count: u64, seed: u64) {
    std::panic::set_hook(Box::new(|about| {
        // A panic inside is caught at the border; one of the test is not.
        let at = about.location().map(ToString::to_string).unwrap_or_default();
        if at.contains("hostile") {
            eprintln!("{about}");
        }
        if let Ok(mut panics) = PANICS.lock() {
            panics.insert(at);
        }
    }));
    let mut world = World::new(seed);
    let mut slowest = (0.0, "");
    for i in 0..count {
        if i % 400 == 0 {
            world.renew();
        }
        let start = Instant::now();
        let name = calls::one(&mut world);
        let took = start.elapsed().as_secs_f64();
        if took > slowest.0 {
            slowest = (took, name);
        }
    }
    let (names, told) = (world.called.len(), world.told);
    println!(
        "{count} calls of seed {seed}: {told:?} by status, {names} functions, slowest {slowest:?} s"
    );
    println!("panics inside: {:?}", PANICS.lock());
    assert_eq!(told.iter().sum::<u64>(), count);
    assert!(told[0] > count / 20 && told[4] > count / 100, "too little is valid, or garbled");
    let missing: Vec<_> =
        calls::NAMES.iter().filter(|name| !world.called.contains(*name)).collect();
    assert!(count < 10_000 || missing.is_empty(), "not called: {missing:?}");
}

#[test]
fn twenty_thousand_random_calls_end_with_a_status() {
    call(20_000, 1);
}

#[test]
#[ignore = "takes minutes"]
fn a_million_random_calls_end_with_a_status() {
    call(asked("CAROM_CALLS", 1_000_000), asked("CAROM_SEED", 2));
}
