//! Runs DIRT's bench of oblique impact with its contact and with carom's, draws R_x, and prints a table:
//! cargo run --release --example compare [PICTURE.svg]

#[allow(dead_code, reason = "the tests use more of it")]
mod trial;

use carom_plot::{Axis, Marker, Panel, Series, render};
use trial::{Contact, Trial};

const PICTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/book/src/start/dirt.svg");
/// psi of the bench, and lower ones: 2 (1 - nu)/(f (2 - nu)) times tangential over approach velocity.
const BENCH: [f64; 13] =
    [0.05, 0.1, 0.2, 0.284, 0.473, 0.757, 1.135, 1.703, 2.365, 3.311, 4.73, 6.622, 9.459];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| PICTURE.to_owned());
    let exact = (0..=300).map(|i| 0.01 + f64::from(i) / 30.0);
    let mut panel =
        Panel::new("ψ_1 = 2 (1 − ν) v_x/(f (2 − ν) v_z)", Axis::linear("R_x").between(-1.1, 0.6));
    panel.add(Series::line(
        "exact elastic impact",
        exact.map(|psi| (psi, Trial::elastic(psi).exact())),
    ));
    let mut points = [Vec::new(), Vec::new()];
    println!("| psi_1 | DIRT | with carom | exact | DIRT, e = 0.98 |");
    for psi in BENCH {
        let trial = Trial::elastic(psi);
        let [dirts, caroms] =
            [Contact::Dirts, Contact::Caroms].map(|contact| trial.run(contact).r_x());
        let damped = Trial { restitution: 0.98, ..trial }.run(Contact::Dirts).r_x();
        println!("| {psi} | {dirts:.4} | {caroms:.4} | {:.4} | {damped:.4} |", trial.exact());
        points[0].push((psi, dirts));
        points[1].push((psi, caroms));
    }
    let [dirts, caroms] = points;
    panel.add(Series::markers("DIRT", Marker::Circle, dirts).sized(1.5));
    panel.add(Series::markers("DIRT with carom", Marker::Dot, caroms));
    for (approach, step) in [(1.0, 2e-6), (1.0, 1e-6), (1.0, 1e-7), (0.1, 1e-6)] {
        let error = |psi: &f64| {
            let trial = Trial { approach, step, ..Trial::elastic(*psi) };
            (trial.run(Contact::Caroms).r_x() - trial.exact()).abs()
        };
        let largest = BENCH.iter().map(error).fold(0.0, f64::max);
        println!("{approach} m/s, time step {step:e} s: largest error of R_x {largest:.1e}");
    }
    std::fs::write(path, render("", &[panel])?)?;
    Ok(())
}
