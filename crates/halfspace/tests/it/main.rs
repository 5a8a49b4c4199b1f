//! The integration tests of `carom-halfspace`: one executable with a module for each subject.

mod among;
mod ellipsoid;
mod far;
mod interior;
mod interior_field;
mod operator;
mod periodic;
mod plate;
mod point_load;
mod rectangle;
mod rows;
mod tables;
