//! Layer 3, laws: a ball pressed on a plate and shifted to and fro.
//!
//! The force makes a hysteresis loop, whose area is the heat of a cycle (Mindlin and Deresiewicz).

use carom::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rubber = MaterialPair::new(Material::from_shear(1e6, 0.5)?, Material::RIGID)?;
    let sphere = PrincipalRadii::sphere(0.01)?;
    let hertz = Hertz::new(RelativeCurvature::new(sphere, PrincipalRadii::PLANE, 0.0)?, rubber)?;
    let friction = Friction::new(0.8)?;
    let mut law = Accounted::new(ShiftLaw::<f64>::new(hertz.stiffness(), friction));
    let zeta = hertz.at_force(1.0)?.approach;
    let to = |xi: f64| Shift { zeta, xi, ..Shift::default() };

    let amplitude = 0.5 * zeta;
    law.advance(to(0.0))?;
    law.advance(to(amplitude))?;
    law.advance(to(-amplitude))?;
    let first = law.dissipated();
    let steps = 40;
    println!("{:>12} {:>12} {:>12}", "shift um", "force N", "heat uJ");
    for step in 0..=steps {
        let phase = 4.0 * f64::from(step) / f64::from(steps);
        let xi = amplitude * if phase < 2.0 { phase - 1.0 } else { 3.0 - phase };
        let load = law.advance(to(xi))?;
        let heat = law.dissipated() - first;
        println!("{:>12.2} {:>12.4} {:>12.3}", 1e6 * xi, load.f_x, 1e6 * heat);
    }
    let heat = law.dissipated() - first;

    // The area of the loop from the force F at its ends: (36/5) f P x_s (1 - (1 - F/fP)^(5/3) -
    // (5/6) (F/fP) (1 + (1 - F/fP)^(2/3))), with x_s = f P/(c_x sqrt(zeta)).
    let limit = 0.8 * law.load().f_z;
    let part = law.load().f_x.abs() / limit;
    let onset = limit / (hertz.stiffness().c_x * zeta.sqrt());
    let core = 1.0
        - (1.0 - part).powf(5.0 / 3.0)
        - 5.0 / 6.0 * part * (1.0 + (1.0 - part).powf(2.0 / 3.0));
    let expected = 36.0 / 5.0 * limit * onset * core;
    println!("heat of a round: {:.4} uJ, in closed form {:.4} uJ", 1e6 * heat, 1e6 * expected);
    assert!((heat - expected).abs() < 1e-9 * expected);
    Ok(())
}
