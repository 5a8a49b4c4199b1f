//! Torsion about the normal: adhesion, partial slip, histories and the elliptical approximation
//! (sections 5.3, 5.4, 7.6 and 10.5).
//!
//! Twists are relative, positive when `u = beta y`, `v = -beta x`; torques are those on body 1,
//! `M_z = int (y t_x - x t_y) dS`, of the same sign. G and nu are combined (4.7).

pub mod adhesion;
mod apart;
mod check;
mod complementarity;
pub mod ellipse;
mod front;
mod grow;
mod heat;
pub mod history;
pub mod law;
pub mod lubkin;
mod pack;
mod recede;
mod rings;
mod segment;
mod shift_twist;
mod sliding;
