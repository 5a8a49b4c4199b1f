//! The tests of `carom-halfspace` that see it as its users do: one executable, a module for each subject.

mod ellipsoid;
mod far;
mod interior;
mod interior_field;
mod operator;
mod periodic;
mod point_load;
mod rectangle;
