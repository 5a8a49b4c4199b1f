//! Tests of `carom-impact` through its public interface: one executable with a module for each subject.

mod bodies;
mod closed_form;
mod collision;
mod collision_solver;
mod columns;
mod coupled;
mod coupled_extremes;
mod encounters;
mod history_known;
mod known_ends;
mod known_values;
mod levers;
mod normal_restitution;
mod normal_spin;
mod oblique;
#[path = "../../../geometry/tests/it/random/mod.rs"]
mod random;
mod reference_tables;
mod reference_values;
mod restitution;
mod restitution_dissimilar;
mod ring_impacts;
mod ring_impacts_known;
mod scene;
mod slip_speed;
mod small_spin;
mod sphere_pairs;
mod spheres;
mod symmetry;
mod systems_of_units;
mod torsional;
mod torsional_collocation;
mod twist;
mod uncertain;
mod units;
mod yields;
