//! Forces over time during one impact: moduli, friction, and the unknown start of the clock.

use crate::common::{close, of};
use crate::coverage::uniform;
use carom_cases::case::{Case as _, ImpactFile};
use carom_cases::impact::course;
use carom_cases::input::CaseFile;
use carom_drawn::Splitmix;
use carom_fit::{Data, Fit, FitError, GivenError, Options, fit};
use carom_impact::uncertain::Distribution;

/// A ball of 10 mm, E = 70 GPa, on a rigid plate, with these numbers.
fn case(modulus: &str, contact: &str, angle: f64, touch: &str) -> CaseFile {
    CaseFile::from_text(format!(
        "body_1 = {{ shape = \"sphere\", radius = 0.01, material = {{ young_modulus = {modulus}, poisson = 0.3 }}, density = 2500 }}
         body_2 = {{ shape = \"plane\", material = {{ rigid = true }}, fixed = true }}
         approach = {{ speed = 1, angle = {angle} }}
         contact = {{ {contact}, law = \"coulomb\" }}
         clock = {{ time = 0, touch = {touch} }}"
    ))
}

const MODULUS: f64 = 70e9;
const TOUCH: f64 = 12e-6;
const UNKNOWN: &str = "{ fit = [1e10, 5e11] }";
const CLOCK: &str = "{ fit = [0, 3e-5] }";

/// Forces K zeta^(3/2) of m zeta'' = -K zeta^(3/2), by steps of Runge and Kutta, at these times since the touch.
fn hertz(times: &[f64]) -> Vec<f64> {
    let mass = 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-6;
    let k = 4.0 / 3.0 * MODULUS / 0.91 * 0.1;
    let rate = |[zeta, speed]: [f64; 2]| [speed, -k * zeta.max(0.0).powf(1.5) / mass];
    let plus = |[a, b]: [f64; 2], step: f64, [c, d]: [f64; 2]| [a + step * c, b + step * d];
    let force = |time: &f64| {
        let step = time.max(0.0) / 4000.0;
        let mut state = [0.0, 1.0];
        for _ in 0..4000 {
            let one = rate(state);
            let two = rate(plus(state, 0.5 * step, one));
            let three = rate(plus(state, 0.5 * step, two));
            let four = rate(plus(state, step, three));
            let sum = |i: usize| (one[i] + 2.0 * (two[i] + three[i]) + four[i]) / 6.0;
            state = plus(state, step, [sum(0), sum(1)]);
        }
        k * state[0].max(0.0).powf(1.5)
    };
    times.iter().map(force).collect()
}

fn readings(count: usize, last: f64) -> Vec<f64> {
    (0..count).map(|i| last * i as f64 / (count - 1) as f64).collect()
}

fn fitted(case: &CaseFile, columns: Vec<(&str, Vec<f64>)>, errors: &[GivenError]) -> Fit {
    let data = Data::new(columns.into_iter().map(|(name, own)| (name.to_owned(), own)).collect());
    let options = Options { errors, curve: 9, ..Options::default() };
    fit(case, &data.unwrap(), &options).unwrap()
}

#[test]
fn a_normal_impact_tells_modulus_and_touch() {
    let clock = readings(61, 9e-5);
    let forces = hertz(&clock.iter().map(|time| time - TOUCH).collect::<Vec<_>>());
    let largest = forces.iter().copied().fold(0.0, f64::max);
    // Before the touch and after separation there is no force.
    assert!(forces[0] == 0.0 && forces[60] == 0.0 && largest > 100.0);
    // The rows need not be in the order of time.
    let turned = |values: Vec<f64>| [&values[20..], &values[..20]].concat();
    let (clock, forces) = (turned(clock), turned(forces));
    let case = case(UNKNOWN, "friction = 0", 0.0, CLOCK);
    let errors = [(None, vec![1.0])];
    let found = fitted(&case, vec![("time", clock), ("F_z", forces)], &errors);
    close(of(&found, "young_modulus").value, MODULUS, 1e-5 * MODULUS);
    close(of(&found, "touch").value, TOUCH, 1e-11);
    assert_eq!(found.curve.unwrap().along.len(), 9);
}

/// The greatest force and the duration of Hertz: zeta^5 = (5 m v^2/4 K)^2, T = 2.9433 zeta/v.
#[test]
fn greatest_force_and_duration_tell_the_modulus() {
    let mass = 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-6;
    let k = 4.0 / 3.0 * MODULUS / 0.91 * 0.1;
    let (mut forces, mut durations) = (Vec::new(), Vec::new());
    let speeds = vec![0.5, 1.0, 2.0];
    for speed in &speeds {
        let zeta: f64 = (1.25 * mass * speed * speed / k).powf(0.4);
        forces.push(k * zeta.powf(1.5));
        durations.push(2.943_275_184 * zeta / speed);
    }
    let case = case(UNKNOWN, "friction = 0", 0.0, "0");
    for (name, values) in [("maximal_force", forces), ("duration", durations)] {
        let found = fitted(&case, vec![("speed", speeds.clone()), (name, values)], &[]);
        close(of(&found, "young_modulus").value, MODULUS, 1e-6 * MODULUS);
    }
}

#[test]
fn scattered_forces_of_an_oblique_impact_tell_friction_stiffness_and_touch() {
    let truth = "friction = 0.2, normal_over_tangential_stiffness = 1.3";
    let text = case("70e9", truth, 30.0, "0");
    let file = ImpactFile::parse(text.text()).unwrap();
    let clock = readings(200, 9e-5);
    let times: Vec<f64> = clock.iter().map(|time| time - TOUCH).collect();
    let points = course(file.nominal(), times.as_slice()).unwrap();
    let unknown =
        "friction = { fit = [0.01, 1] }, normal_over_tangential_stiffness = { fit = [0.8, 1.6] }";
    let open = case(UNKNOWN, unknown, 30.0, CLOCK);
    let (mut draw, mut held) = (Splitmix(7), [0; 4]);
    const SETS: usize = 20;
    for _ in 0..SETS {
        let mut noise = |error: f64| {
            let normal = Distribution::normal(0.0, error).unwrap();
            normal.quantile(uniform(&mut draw)).unwrap()
        };
        let across = points.iter().map(|point| point.force.x + noise(2.0)).collect();
        let along = points.iter().map(|point| point.force.z + noise(4.0)).collect();
        let columns = vec![("time", clock.clone()), ("F_x", across), ("F_z", along)];
        let found = fitted(&open, columns, &[]);
        let truth = [0.2, 1.3, MODULUS, TOUCH];
        let names = ["friction", "stiffness", "young_modulus", "touch"];
        for ((name, truth), held) in names.iter().zip(truth).zip(&mut held) {
            let one = of(&found, name);
            close(one.value, truth, 0.05 * truth);
            let [low, high] = one.interval.unwrap();
            *held += usize::from(low <= truth && truth <= high);
        }
    }
    // 19 of 20 in the mean; 16 or fewer of one unknown in 1.6 % of all draws.
    assert!(held.iter().all(|held| *held >= 16), "{held:?}");
}

#[test]
fn times_and_forces_without_each_other_are_told() {
    let told = |case: &CaseFile, text: &str| {
        let error = Data::from_csv(text).and_then(|data| fit(case, &data, &Options::default()));
        let error: FitError = error.unwrap_err();
        assert!(error.is_bad_input());
        error.to_string()
    };
    let whole = case(UNKNOWN, "friction = 0", 0.0, CLOCK);
    let found = told(&whole, "speed,F_z\n1,100\n2,200\n");
    assert!(
        found.contains("column `F_z` of the data: it is of an instant: the data need"),
        "{found}"
    );
    let bare = CaseFile::from_text(whole.text().replace("clock =", "# clock ="));
    let found = told(&bare, "time,F_z\n1e-5,100\n2e-5,200\n");
    assert!(found.contains("column `time` of the data: `clock.time` is missing"), "{found}");
}
