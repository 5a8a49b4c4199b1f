//! Floor 3 of carom: contact laws with memory (chapters 3, 5, 6, 7, 10.5 and 14.4 of the thesis).
//!
//! Curvatures and materials make a [`hertz::Hertz`] contact; a law turns a history of rigid
//! shifts into loads. The code is unit-free: any consistent set of units will do.
#![forbid(unsafe_code)]

pub mod curvature;
pub mod ellipse;
pub mod field;
pub mod friction;
pub mod hertz;
pub mod history;
pub mod law;
pub mod memory;
pub mod profile;
pub mod rigid_slip;
pub mod shift;
pub mod shift_law;
pub mod sliders;
pub mod stiffness;
pub mod torsion;
