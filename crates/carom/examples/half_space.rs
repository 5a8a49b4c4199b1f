//! Layer 2, the half-space: where does steel under a loaded patch begin to yield?
//!
//! Below the centre of a square of uniform pressure the largest shear stress is not at the surface
//! but at a depth of about half a side.

use carom::halfspace::{LoadedRectangle, Material, Point, Rectangle, Traction};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let steel = Material::from_young(208e9, 0.3)?;
    let side = 1e-3;
    let square = LoadedRectangle::new(steel, Rectangle::new(side, side)?)?;
    let pressure = Traction { normal: 1e9, ..Traction::default() };
    let shear_at = |depth: f64| {
        let stress = square.stress(pressure, Point { x: 0.0, y: 0.0, z: depth })?;
        Ok::<_, carom::prelude::RangeError>(0.5 * (stress.xx - stress.zz))
    };
    let mut most = (0.0, 0.0);
    println!("{:>10} {:>16}", "depth mm", "shear MPa");
    for step in 0..=30 {
        let depth = 0.05 * side * f64::from(step);
        let shear = shear_at(depth)?;
        if shear > most.1 {
            most = (depth, shear);
        }
        if step % 3 == 0 {
            println!("{:>10.2} {:>16.1}", 1e3 * depth, 1e-6 * shear);
        }
    }
    println!("largest: {:.1} MPa, {:.2} mm deep", 1e-6 * most.1, 1e3 * most.0);
    assert!(most.0 > 0.3 * side && most.0 < 0.5 * side && most.1 > 2.0 * shear_at(0.0)?);
    Ok(())
}
