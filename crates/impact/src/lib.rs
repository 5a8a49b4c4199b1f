//! Floor 5 of carom: impact of elastic bodies with friction (chapters 8, 9, 10 and 15).
#![forbid(unsafe_code)]

pub mod normal;
pub mod oblique;
