//! Random calls of the whole C interface: valid, extreme and meaningless arguments, null and misaligned
//! pointers, and bytes changed anywhere in the caller's data. Each ends with a status.
//!
//! The fuzzer in `fuzz/` chooses the calls by what they reach; what it finds is a test here.
//!
//! `sanitize.sh` runs the long form under the address sanitizer and valgrind; `CAROM_CALLS` sets the number
//! of calls, `CAROM_SEED` the seed.

mod calls;
mod random;
mod world;

use std::collections::BTreeSet;
use std::sync::Mutex;
use std::time::Instant;

use carom_capi::*;

pub(crate) use random::Random;
use world::World;

/// Where the library gave up, in a status that says so.
static PANICS: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

fn asked(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// The data of the caller begin anew after so many calls.
const RENEWED: u64 = 400;
/// A call that takes longer is told, in seconds.
const SLOW: f64 = 1.0;

/// So many calls, of which no function is left out. One that is slow or panics inside is told, with the seed from which
/// few calls lead to it.
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
    let (mut slowest, mut begun) = ((0.0, ""), seed);
    for i in 0..count {
        if i % RENEWED == 0 {
            world.renew();
            if let Random::Seed(now) = world.random {
                begun = now;
            }
        }
        let panicked = world.told[CaromStatus::Internal as usize];
        let start = Instant::now();
        let name = calls::one(&mut world);
        let took = start.elapsed().as_secs_f64();
        if took > slowest.0 {
            slowest = (took, name);
        }
        if took > SLOW || world.told[CaromStatus::Internal as usize] > panicked {
            let calls = i % RENEWED + 1;
            let memories = if world.are_damaged { "garbled" } else { "whole" };
            println!(
                "{name}, {took:.3} s, memories {memories}: by CAROM_SEED={begun} CAROM_CALLS={calls}"
            );
        }
    }
    let (names, told) = (world.called.len(), world.told);
    println!(
        "{count} calls of seed {seed}: {told:?} by status, {names} functions, slowest {slowest:?} s"
    );
    println!("panics inside: {:?}", PANICS.lock());
    assert_eq!(told.iter().sum::<u64>(), count);
    if count < 10_000 {
        return;
    }
    assert!(told[0] > count / 20 && told[4] > count / 100, "too little is valid, or garbled");
    let missing: Vec<_> =
        calls::NAMES.iter().filter(|name| !world.called.contains(*name)).collect();
    assert!(missing.is_empty(), "not called: {missing:?}");
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

/// The calls that these bytes choose.
fn call_by(bytes: &[u8]) {
    let mut world = World::new(0);
    world.begin(bytes);
    calls::all_of_bytes(&mut world);
}

#[test]
fn calls_chosen_by_bytes_end_with_a_status() {
    let mut random = Random::Seed(3);
    for _ in 0..20 {
        let bytes: Vec<u8> = (0..500).flat_map(|_| random.bits().to_le_bytes()).collect();
        call_by(&bytes);
    }
}
