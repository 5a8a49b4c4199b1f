//! Draws how a ball leaves a floor by Rapier alone and with carom, and prints by how much both differ from the exact
//! impact: cargo run --release --example compare [PICTURE.svg]

mod trial;

use carom_plot::{Axis, Marker, Panel, Series, render};
use carom_rapier::ElasticImpacts;
use rapier3d::prelude::PhysicsHooks;
use trial::{After, POISSON, RADII, SPEED, Target, Trial};

const PICTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/book/src/start/rapier.svg");
/// Coefficients of friction and restitution of the picture.
const SURFACE: [f64; 2] = [0.3, 0.8];
/// Degrees from the normal.
const ANGLES: std::ops::RangeInclusive<u32> = 1..=85;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| PICTURE.to_owned());
    let carom = ElasticImpacts::new(POISSON)?;
    std::fs::write(path, render("", &[restitution(&carom), spin(&carom)])?)?;
    tell(&carom);
    Ok(())
}

/// R_x over the angle.
fn restitution(carom: &ElasticImpacts) -> Panel {
    let y = Axis::linear("R_x").between(-1.0, 0.6);
    let mut panel = Panel::new("angle before / degrees from the normal", y);
    add(&mut panel, carom, |trial, after| trial.r_x(after));
    panel
}

/// The spin that the ball gets, over v/R.
fn spin(carom: &ElasticImpacts) -> Panel {
    let mut panel = Panel::new("angle before / degrees from the normal", "spin after, R ω/v");
    add(&mut panel, carom, |_, after| RADII[0] * after.spins[0].length() / SPEED);
    panel
}

fn add(panel: &mut Panel, carom: &ElasticImpacts, value: impl Fn(&Trial, &After) -> f64) {
    let at = |degrees: u32, after: &dyn Fn(&Trial) -> After| {
        let trial = Trial::plain(f64::from(degrees), SURFACE[0], SURFACE[1]);
        (trial.degrees, value(&trial, &after(&trial)))
    };
    let exact = |trial: &Trial| trial.exact();
    let alone = |trial: &Trial| trial.by_rapier(&());
    let both = |trial: &Trial| trial.by_rapier(carom);
    panel.add(Series::line("exact elastic impact", ANGLES.map(|degrees| at(degrees, &exact))));
    panel.add(Series::dashed("Rapier", ANGLES.map(|degrees| at(degrees, &alone))));
    let few = ANGLES.step_by(6).map(|degrees| at(degrees, &both));
    panel.add(Series::markers("Rapier with carom", Marker::Dot, few));
}

fn tell(carom: &ElasticImpacts) {
    println!(
        "differences from the exact impact, of velocity and surface speed, over the speed of the ball"
    );
    for (name, hook) in [("Rapier", &() as &dyn PhysicsHooks), ("with carom", carom)] {
        // Wherever in a step it arrives.
        let gaps = (0..50).map(|i| 0.01 + 0.02 * f64::from(i));
        let floor = gaps.flat_map(|gap| Trial::all(Target::Floor, gap));
        tell_of(&format!("floor, {name}"), floor, hook);
        let balls = Trial::all(Target::Ball([0.48, 0.6, 0.64]), 1e-3);
        tell_of(&format!("balls, {name}"), balls, hook);
    }
    println!("| degrees | Rapier | with carom | exact |");
    for degrees in [5.0, 15.0, 30.0, 45.0, 60.0, 75.0] {
        let trial = Trial::plain(degrees, SURFACE[0], SURFACE[1]);
        let all = [trial.by_rapier(&()), trial.by_rapier(carom), trial.exact()];
        let [alone, both, exact] = all.map(|after| trial.r_x(&after));
        println!("| {degrees} | {alone:.4} | {both:.4} | {exact:.4} |");
    }
}

/// The largest and the mean difference, and how many exceed 1e-5.
fn tell_of(name: &str, trials: impl Iterator<Item = Trial>, hooks: &dyn PhysicsHooks) {
    let differences: Vec<_> =
        trials.map(|trial| trial.by_rapier(hooks).differs(&trial.exact())).collect();
    let (count, of) = (differences.len(), |part: usize| differences.iter().map(move |d| d[part]));
    let largest = [0, 1].map(|part| of(part).fold(0.0, f64::max));
    let mean = [0, 1].map(|part| of(part).sum::<f64>() / count as f64);
    let many = differences.iter().filter(|d| d[0].max(d[1]) > 1e-5).count();
    println!(
        "{name}: largest {:.1e}, {:.1e}; mean {:.1e}, {:.1e}; {many} of {count} above 1e-5",
        largest[0], largest[1], mean[0], mean[1]
    );
}
