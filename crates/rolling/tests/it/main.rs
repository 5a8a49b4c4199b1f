//! The integration tests of `carom-rolling`: one executable.

mod creep_force_table;
mod creep_table;
mod drawn;
mod images;
mod nested;
mod oracle;
mod rolling;
mod slip_speed;
mod springs;
