//! The integration tests of `carom-geometry`: one executable with a module for each subject.

mod frames;
mod inertia;
mod meshes;
mod nearest_points;
mod random;
mod shapes;
mod surfaces;
