//! Tests of fits against published data, closed forms and drawn data.

mod common;
mod contacts;
mod coverage;
mod histories;
mod impacts;
mod known;
mod measured;
mod shifts;
mod wrong;
