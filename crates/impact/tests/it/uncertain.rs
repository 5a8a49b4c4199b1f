//! Uncertain inputs: closed forms, first-order propagation, threads, and what is out of range.

use approx::assert_relative_eq;
use carom_halfspace::Material;
use carom_impact::uncertain::{Distribution, Quantity, Sampling, Study, UncertainError};
use carom_impact::{AnalyticOrRings, Body, Collision, CollisionError, CollisionSolver, Motion};
use carom_laws::friction::Friction;

/// A solid sphere against a rigid plane: lambda = tan(angle)/f for nu of the pair.
fn collision(friction: f64, tangential: f64, radius: f64) -> Result<Collision, CollisionError> {
    let material = Material::from_young(1e9, 0.5)?;
    let ball = Body::sphere(radius, material, 1.0)?
        .moving(Motion::new([tangential, 0.0, -1.0], [0.0; 3])?);
    Collision::new(ball, Body::plane(Material::RIGID), Friction::new(friction)?)
}

fn study(sampling: Sampling, input: Distribution, tangential: f64) -> Study {
    sampling.run(&[input], |values| collision(values[0], tangential, 0.01)).unwrap()
}

fn restitution(friction: f64, tangential: f64) -> f64 {
    let outcome = collision(friction, tangential, 0.01).unwrap().solve().unwrap();
    outcome.rebound().unwrap().r_x.unwrap()
}

#[test]
fn sliding_with_uniform_friction_has_a_closed_form() {
    // Sliding throughout: R_x = -1 + 7 f/tan(angle), linear in f, so uniform as f is.
    let sampling = Sampling::new(40_000, 11).unwrap();
    let study = study(sampling, Distribution::uniform(0.05, 0.15).unwrap(), 1.0);
    let summary = study.summary(Quantity::Restitution).unwrap();
    let (low, high) = (-1.0 + 7.0 * 0.05, -1.0 + 7.0 * 0.15);
    let deviation = (high - low) / 12f64.sqrt();
    // Four standard errors: of the mean, and of the deviation of a uniform distribution.
    let error = deviation / 200.0;
    assert!((summary.mean() - 0.5 * (low + high)).abs() < 4.0 * error);
    assert!((summary.deviation() - deviation).abs() < 4.0 * 0.45 * error);
    assert_relative_eq!(summary.standard_error(), error, max_relative = 0.02);
    for part in [0.05, 0.25, 0.5, 0.75, 0.95] {
        let spread = (high - low) * (part * (1.0f64 - part)).sqrt() / 200.0;
        let expected = low + part * (high - low);
        assert!((summary.quantile(part).unwrap() - expected).abs() < 4.0 * spread);
    }
    assert!(summary.sorted().iter().all(|r| *r >= low - 1e-12 && *r <= high + 1e-12));
    for bin in summary.histogram(10).unwrap() {
        assert!((bin.count as f64 - 4000.0).abs() < 4.0 * 60.0, "{bin:?}");
    }
}

#[test]
fn small_scatter_propagates_to_first_order() {
    // Partial slip: no closed form, so the derivative by central difference.
    for (friction, tangential) in [(0.3, 0.9), (0.3, 0.3), (0.2, 1.0)] {
        let deviation = 1e-4 * friction;
        let step = 1e-4 * friction;
        let slope = (restitution(friction + step, tangential)
            - restitution(friction - step, tangential))
            / (2.0 * step);
        let sampling = Sampling::new(20_000, 3).unwrap();
        let normal = Distribution::normal(friction, deviation).unwrap();
        let study = study(sampling, normal, tangential);
        let (input, output) = (&study.inputs()[0], study.summary(Quantity::Restitution).unwrap());
        // Against the drawn inputs themselves: no sampling error is left.
        let expected = slope.abs() * input.deviation();
        assert_relative_eq!(output.deviation(), expected, max_relative = 2e-3);
        let shift = slope * (input.mean() - friction);
        let mean = restitution(friction, tangential) + shift;
        assert!((output.mean() - mean).abs() < 1e-2 * expected);
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let inputs = [
            Distribution::log_normal(0.2, 0.05).unwrap(),
            Distribution::triangular(0.3, 0.5, 1.0).unwrap(),
        ];
        let sampling = Sampling::new(3000, 5).unwrap();
        pool.install(|| sampling.run(&inputs, |v| collision(v[0], v[1], 0.01))).unwrap()
    };
    let one = run(1);
    assert_eq!(one, run(2));
    assert_eq!(one, run(7));
    // More samples begin with the same ones; another seed gives others.
    let friction = Distribution::uniform(0.1, 0.2).unwrap();
    let means = [5, 6].map(|seed| {
        let sampling = Sampling::new(100, seed).unwrap();
        study(sampling, friction, 1.0).summary(Quantity::Restitution).unwrap().mean()
    });
    assert_ne!(means[0], means[1]);
}

#[test]
fn samples_out_of_range_are_counted() {
    let friction = Distribution::normal(0.1, 0.1).unwrap();
    let radius = Distribution::normal(0.01, 0.005).unwrap();
    let sampling = Sampling::new(20_000, 1).unwrap();
    let study = sampling.run(&[friction, radius], |v| collision(v[0], 1.0, v[1])).unwrap();
    let counted = |field: &str| {
        study.out_of_range().iter().find(|seen| seen.first.field == field).unwrap().count
    };
    // P(f < 0) = 15.87 %, P(R < 0) = 2.275 %; R is looked at first.
    assert!((counted("radius") as f64 - 455.0).abs() < 4.0 * 21.1);
    assert!((counted("friction") as f64 - 0.15866 * 19545.0).abs() < 4.0 * 51.1);
    let rest: usize = study.out_of_range().iter().map(|seen| seen.count).sum();
    assert_eq!(study.summary(Quantity::Speed(0)).unwrap().count() + rest, study.samples());
    assert_eq!(study.no_impact(), 0);
    assert!(study.out_of_range().iter().all(|seen| seen.first.value < 0.0));
}

#[test]
fn studies_without_an_impact_are_refused() {
    let sampling = Sampling::new(10, 1).unwrap();
    let negative = Distribution::uniform(-2.0, -1.0).unwrap();
    let error = sampling.run(&[negative], |v| collision(v[0], 1.0, 0.01)).unwrap_err();
    let UncertainError::NothingLeft { samples: 10, out_of_range: 10, first: Some(first) } = error
    else {
        panic!("{error}")
    };
    assert_eq!(first.field, "friction");
    assert!(error.to_string().contains("friction = -1."), "{error}");
    let rigid = |v: &[f64]| {
        let still = Body::plane(Material::from_young(v[0], 0.3)?);
        let ball = Body::sphere(0.01, Material::RIGID, f64::INFINITY)?;
        Collision::new(ball, still, Friction::NONE)
    };
    let modulus = Distribution::uniform(1e9, 2e9).unwrap();
    let error = sampling.run(&[modulus], rigid).unwrap_err();
    let source = CollisionError::BothHeldFast;
    assert_eq!(error, UncertainError::Collision { sample: 0, source });
    assert_eq!(Sampling::new(1, 0).unwrap_err().field, "samples");
    assert!(Sampling::new(1_000_001, 0).is_err());
}

#[test]
fn every_quantity_has_a_name_of_its_own() {
    let mut names: Vec<&str> = Quantity::ALL.iter().map(|quantity| quantity.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Quantity::ALL.len());
    let sampling = Sampling::new(50, 1).unwrap();
    let study = study(sampling, Distribution::uniform(0.05, 0.06).unwrap(), 1.0);
    // A plane held fast stays; the ball leaves at its normal speed, less tilted than it came.
    assert_eq!(study.summary(Quantity::Speed(1)).unwrap().mean(), 0.0);
    assert_eq!(study.summary(Quantity::Angle(1)).unwrap().mean(), 0.0);
    assert_relative_eq!(
        study.summary(Quantity::Velocity(0, 2)).unwrap().mean(),
        1.0,
        epsilon = 1e-14
    );
    let angle = study.summary(Quantity::Angle(0)).unwrap();
    assert!(angle.quantile(0.0).unwrap() > 30.0 && angle.quantile(1.0).unwrap() < 45.0);
}

/// What the study says of each input is what the collisions were made of.
#[test]
fn the_summary_of_each_input_is_that_of_the_values_used() {
    let inputs = [
        Distribution::uniform(0.1, 0.3).unwrap(),
        Distribution::normal(0.7, 0.05).unwrap(),
        Distribution::log_normal(0.01, 0.2).unwrap(),
        Distribution::triangular(0.2, 0.25, 0.4).unwrap(),
    ];
    let used = std::sync::Mutex::new(Vec::new());
    let sampling = Sampling::new(500, 9).unwrap();
    let study = sampling
        .run(&inputs, |v| {
            used.lock().unwrap().push(v.to_vec());
            collision(v[0] + v[3], v[1], v[2])
        })
        .unwrap();
    let used = used.into_inner().unwrap();
    assert_eq!((used.len(), study.inputs().len()), (500, 4));
    for (index, summary) in study.inputs().iter().enumerate() {
        let mut values: Vec<f64> = used.iter().map(|values| values[index]).collect();
        values.sort_by(f64::total_cmp);
        assert_eq!(summary.sorted(), values, "input {index}");
        let mean = values.iter().sum::<f64>() / 500.0;
        assert_relative_eq!(summary.mean(), mean, max_relative = 1e-12);
        // Linear between the two values beside it: the place of part p is p (n - 1).
        let quantile = values[124] + 0.75 * (values[125] - values[124]);
        assert_relative_eq!(summary.quantile(0.25).unwrap(), quantile, max_relative = 1e-12);
    }
}

/// Two balls that turn and meet obliquely, so that no component of a motion afterwards vanishes.
fn turning_pair(friction: f64) -> Result<Collision, CollisionError> {
    let ball = |poisson, velocity, spin| {
        let material = Material::from_young(70e9, poisson)?;
        let body = Body::sphere(0.01, material, 0.02)?;
        Ok::<_, CollisionError>(body.moving(Motion::new(velocity, spin)?))
    };
    let one = ball(0.2, [0.3, -0.2, -1.0], [5.0, -7.0, 2.0])?;
    let two = ball(0.3, [-0.1, 0.15, 0.4], [-3.0, 4.0, 6.0])?;
    Collision::along(one, two, [0.3, -0.2, 1.0], Friction::new(friction)?)
}

#[test]
fn each_quantity_is_that_of_the_rebound_that_its_name_says() {
    let outcome = AnalyticOrRings.solve(&turning_pair(0.2).unwrap()).unwrap();
    let rebound = outcome.rebound().unwrap();
    let narrow = Distribution::uniform(0.2, 0.2 * (1.0 + 1e-9)).unwrap();
    let study = Sampling::new(4, 1).unwrap().run(&[narrow], |f| turning_pair(f[0])).unwrap();
    let normal = [0.3, -0.2, 1.0].map(|part| part / 1.13_f64.sqrt());
    for quantity in Quantity::ALL {
        let got = study.summary(quantity).unwrap().mean();
        let name = quantity.name();
        let want = match name.split_at(name.len().min(7)) {
            ("R_x", "") => rebound.r_x.unwrap(),
            (body @ ("body_1_" | "body_2_"), of) => {
                let motion = &rebound.motions[usize::from(body == "body_2_")];
                let away = if body == "body_1_" { 1.0 } else { -1.0 };
                let along: f64 = (0..3).map(|i| away * normal[i] * motion.velocity[i]).sum();
                let axis = |letter: &str| "xyz".find(letter).unwrap();
                match of.split_once('_') {
                    Some(("velocity", letter)) => motion.velocity[axis(letter)],
                    Some(("spin", letter)) => motion.spin[axis(letter)],
                    _ if of == "speed" => motion.velocity.norm(),
                    _ => (along / motion.velocity.norm()).acos().to_degrees(),
                }
            }
            _ if name == "duration" => rebound.duration,
            _ if name == "maximal_force" => rebound.maximal_force,
            _ if name == "peak_pressure" => rebound.peak_pressure,
            _ => rebound.energy.dissipated,
        };
        assert!(want != 0.0, "{name}");
        assert_relative_eq!(got, want, max_relative = 1e-7);
    }
}
