//! Pictures of a bellows and of a flange.

mod bellows;
mod flange;

pub(super) use bellows::draw as bellows;
pub(super) use flange::draw as flange;

/// A displacement this small beside the shape is drawn larger.
const SMALL: f64 = 0.02;
/// The share of the shape that it then has.
const ENLARGED: f64 = 0.1;

/// The factor by which displacements are drawn, with one significant digit, and its words for a title.
fn exaggeration(greatest: f64, size: f64) -> (f64, String) {
    if greatest <= 0.0 || greatest >= SMALL * size {
        return (1.0, String::new());
    }
    let wanted = ENLARGED * size / greatest;
    let power = 10f64.powf(libm::floor(libm::log10(wanted)));
    let factor = libm::floor(wanted / power) * power;
    (factor, format!(", displacements × {factor}"))
}
