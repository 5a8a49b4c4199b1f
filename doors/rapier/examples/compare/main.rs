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
    panel.add(Series::line("exact impact", ANGLES.map(|degrees| at(degrees, &exact))));
    panel.add(Series::dashed("Rapier", ANGLES.map(|degrees| at(degrees, &alone))));
    let few = ANGLES.step_by(6).map(|degrees| at(degrees, &both));
    panel.add(Series::markers("Rapier with carom", Marker::Dot, few));
}

fn tell(carom: &ElasticImpacts) {
    println!(
        "differences from the exact impact, of velocity and surface speed, over the speed of the ball"
    );
    // Wherever in a step it arrives.
    let gaps: Vec<_> = (0..50).map(|i| 0.01 + 0.02 * f64::from(i)).collect();
    let floor: Vec<_> = Trial::solved(Target::Floor, &gaps).collect();
    let balls: Vec<_> = Trial::solved(Target::Ball([0.48, 0.6, 0.64]), &[1e-3]).collect();
    for (name, hook) in [("Rapier", &() as &dyn PhysicsHooks), ("with carom", carom)] {
        for (target, solved) in [("floor", &floor), ("balls", &balls)] {
            for (kind, is_elastic, above) in [("e = 1", true, 1e-5), ("e < 1", false, 1e-3)] {
                let of_kind = solved.iter().filter(|(trial, _)| trial.is_elastic() == is_elastic);
                let differs = of_kind.map(|(trial, exact)| trial.by_rapier(hook).differs(exact));
                tell_of(&format!("{target}, {kind}, {name}"), &differs.collect::<Vec<_>>(), above);
            }
        }
    }
    println!("| degrees | Rapier | with carom | exact |");
    for degrees in [5.0, 15.0, 30.0, 45.0, 60.0, 75.0] {
        let trial = Trial::plain(degrees, SURFACE[0], SURFACE[1]);
        let all = [trial.by_rapier(&()), trial.by_rapier(carom), trial.exact()];
        let [alone, both, exact] = all.map(|after| trial.r_x(&after));
        println!("| {degrees} | {alone:.4} | {both:.4} | {exact:.4} |");
    }
}

/// The largest and the mean difference, of all and of those that do not exceed a limit.
fn tell_of(name: &str, differences: &[[f64; 2]], above: f64) {
    let others: Vec<_> = differences.iter().copied().filter(|d| d[0].max(d[1]) <= above).collect();
    let many = differences.len() - others.len();
    println!("{name}, {}: {}", differences.len(), summary(differences));
    if many > 0 && !others.is_empty() {
        println!("    without {many} above {above:.0e}: {}", summary(&others));
    }
}

fn summary(differences: &[[f64; 2]]) -> String {
    let of = |part: usize| differences.iter().map(move |d| d[part]);
    let [velocity, spin] = [0, 1].map(|part| {
        let mean = of(part).sum::<f64>() / differences.len() as f64;
        format!("{:.1e}, mean {mean:.1e}", of(part).fold(0.0, f64::max))
    });
    format!("velocity {velocity}; spin {spin}")
}
