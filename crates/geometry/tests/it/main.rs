//! The tests of `carom-geometry` that see it as its users do: one executable, a module for each subject.

mod frames;
mod inertia;
mod nearest_points;
mod random;
mod shapes;
mod surfaces;
