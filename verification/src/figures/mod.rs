//! The figures, chapter by chapter; each file lists its own in `ENTRIES`.

use crate::catalogue::Entry;

mod accuracy;
mod ch03;
mod ch04;
mod ch05;
mod ch06;
mod ch07;
mod ch08;
mod ch09;
mod ch10;
mod ch11;
mod ch12;
mod ch13;
mod ch14;
mod ch15;
mod contact;
mod convergence;
mod errata;
mod measured;
mod mesh;
mod outline;
mod paraboloid;
mod particles;
mod printed;
mod propositions;
mod rebound;
mod rolling;
mod sphere_traction;
mod structure;

/// The chapters in order.
pub(crate) const CHAPTERS: &[&[Entry]] = &[
    ch03::ENTRIES,
    ch04::ENTRIES,
    ch05::ENTRIES,
    ch06::ENTRIES,
    ch07::ENTRIES,
    ch08::ENTRIES,
    ch09::ENTRIES,
    ch10::ENTRIES,
    ch11::ENTRIES,
    ch12::ENTRIES,
    ch13::ENTRIES,
    ch14::ENTRIES,
    ch15::ENTRIES,
    errata::ENTRIES,
    measured::ENTRIES,
    propositions::ENTRIES,
    rebound::ENTRIES,
    particles::ENTRIES,
    convergence::ENTRIES,
    rolling::ENTRIES,
    contact::ENTRIES,
    accuracy::ENTRIES,
];
