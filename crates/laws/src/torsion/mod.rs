//! Torsion about the normal: adhesion, partial slip, load histories and the approximation for
//! ellipses (sections 5.3, 5.4, 7.6 and 10.5).
//!
//! Twists are relative, positive for `u = beta y`, `v = -beta x`. Torques act on body 1, `M_z = int
//! (y t_x - x t_y) dS`, and have the same sign. G and nu are the combined constants (4.7).

pub mod adhesion;
mod advance;
mod check;
mod complementarity;
mod disjoint_annuli;
pub mod ellipse;
mod far;
mod front;
mod grow;
mod heat;
pub mod history;
pub mod law;
pub mod lubkin;
mod mesh;
mod outward;
mod pattern;
mod recede;
mod rings;
mod segment;
mod sliding;
mod steady;
mod within;
