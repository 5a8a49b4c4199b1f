//! Layer 5, motion: a superball thrown at the floor at increasing angles.
//!
//! At steep incidence the contact sticks and stores tangential energy, and the tangential velocity is
//! reversed. At grazing incidence it slides throughout.

use carom::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rubber = Material::from_shear(1e6, 0.5)?;
    let floor = Body::plane(Material::RIGID);
    println!("{:>6} {:>8} {:>12}  regimes", "angle", "R_x", "spin rad/s");
    let mut gripped = 0;
    for degrees in (10..=80).step_by(10) {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let thrown = Motion::new([5.0 * sine, 0.0, -5.0 * cosine], [0.0; 3])?;
        let ball = Body::sphere(0.02, rubber, 0.037)?.moving(thrown);
        let outcome = Collision::new(ball, floor.clone(), Friction::new(0.5)?)?.solve()?;
        let rebound = outcome.rebound().ok_or("the ball flies away from the floor")?;
        let restitution = rebound.r_x.ok_or("the ball falls straight down")?;
        let regimes: Vec<_> = rebound.log.iter().map(|entry| entry.regime.name()).collect();
        let spin = rebound.motions[0].spin.y;
        println!("{degrees:>6} {restitution:>8.4} {spin:>12.2}  {}", regimes.join(" "));
        gripped += usize::from(restitution > 0.0);
        assert!(rebound.energy.after <= rebound.energy.before);
    }
    assert!(gripped > 0);
    Ok(())
}
