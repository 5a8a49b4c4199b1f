//! How often intervals of 95 % hold the truth, in drawn data of three designs of impacts of alumina on glass: ten angles from
//! 2 to 60 degrees, 24 impacts at drawn angles, and the latter with a normal restitution that is unknown too.

use carom_cases::input::CaseFile;
use carom_drawn::{Draw as _, Splitmix};
use carom_fit::{Data, FitError, Knowledge, Options, fit};
use carom_impact::oblique::Groups;
use carom_impact::restitution::with_yield;
use carom_impact::uncertain::Distribution;
use carom_special::linspace;

type Failure = Box<dyn std::error::Error>;

/// What is drawn.
struct Design {
    name: &'static str,
    angles: fn(&mut Splitmix) -> Vec<f64>,
    /// Standard error of the tangential ratio; that of the restitution is half of it.
    error: f64,
    /// The normal restitution, and whether it is unknown.
    e: f64,
    has_unknown_e: bool,
    /// Whether the standard error is given, or estimated.
    is_given: bool,
}

const FRICTION: f64 = 0.0927;
const RATIO: f64 = 1.11;

const DESIGNS: [Design; 3] = [
    Design {
        name: "ten angles, error .014 given",
        angles: |_| linspace(2.0, 60.0, 10),
        error: 0.014,
        e: 1.0,
        has_unknown_e: false,
        is_given: true,
    },
    Design {
        name: "24 impacts, error .03 estimated",
        angles: |draw| (0..24).map(|_| 2.0 + 58.0 * uniform(draw)).collect(),
        error: 0.03,
        e: 1.0,
        has_unknown_e: false,
        is_given: false,
    },
    Design {
        name: "24 impacts, error .03 given, e unknown",
        angles: |draw| (0..24).map(|_| 2.0 + 58.0 * uniform(draw)).collect(),
        error: 0.03,
        e: 0.9,
        has_unknown_e: true,
        is_given: true,
    },
];

/// From 0 to 1, neither of them.
pub(crate) fn uniform(draw: &mut Splitmix) -> f64 {
    ((draw.bits() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
}

impl Design {
    fn case(&self) -> CaseFile {
        let e = if self.has_unknown_e { "{ fit = [0.5, 1] }" } else { "1" };
        CaseFile::from_text(format!(
            "body_1 = {{ shape = \"sphere\", radius = 2.5e-3, material = {{ young_modulus = 380e9, poisson = 0.23 }}, density = 4000 }}
             body_2 = {{ shape = \"plane\", material = {{ young_modulus = 70e9, poisson = 0.25 }}, fixed = true }}
             approach = {{ speed = 3.9, angle = 45 }}
             [contact]
             friction = {{ fit = [0.01, 0.5] }}
             normal_over_tangential_stiffness = {{ fit = [0.8, 1.5] }}
             normal_restitution = {e}
             loss = \"yield\""
        ))
    }

    fn data(&self, draw: &mut Splitmix) -> Result<Data, Failure> {
        let angles = (self.angles)(draw);
        let error = Distribution::normal(0.0, self.error)?;
        let mut ratios = Vec::new();
        for angle in &angles {
            let lambda = angle.to_radians().tan() / FRICTION;
            let r_x = with_yield(Groups::of_spheres(RATIO, lambda)?, self.e)?;
            ratios.push(1.0 - 2.0 / 7.0 * (1.0 + r_x) + error.quantile(uniform(draw))?);
        }
        let mut columns =
            vec![("angle".to_owned(), angles), ("body_1_tangential_ratio".to_owned(), ratios)];
        if self.has_unknown_e {
            let count = columns[0].1.len();
            let half = Distribution::normal(self.e, 0.5 * self.error)?;
            let measured: Result<Vec<f64>, _> =
                (0..count).map(|_| half.quantile(uniform(draw))).collect();
            columns.push(("normal_restitution".to_owned(), measured?));
        }
        Ok(Data::new(columns)?)
    }

    /// How often each interval holds the truth, by Student's t and by the profile.
    fn coverage(&self, sets: usize) -> Result<Vec<(&'static str, [usize; 3])>, Failure> {
        let (case, mut draw) = (self.case(), Splitmix(sets as u64));
        let ratio = (Some("body_1_tangential_ratio".to_owned()), vec![self.error]);
        let mut errors = vec![ratio];
        if self.has_unknown_e {
            errors.push((Some("normal_restitution".to_owned()), vec![0.5 * self.error]));
        }
        let errors = if self.is_given { errors } else { Vec::new() };
        let mut found: Vec<(&'static str, [usize; 3])> = Vec::new();
        for _ in 0..sets {
            let data = self.data(&mut draw)?;
            let options = Options { errors: &errors, ..Options::default() };
            let fitted =
                fit(&case, &data, &options).map_err(|error: FitError| error.to_string())?;
            for (j, one) in fitted.parameters.iter().enumerate() {
                let truth = match one.parameter {
                    "contact.friction" => FRICTION,
                    "contact.normal_over_tangential_stiffness" => RATIO,
                    _ => self.e,
                };
                if found.len() <= j {
                    found.push((one.parameter, [0; 3]));
                }
                let holds = |ends: Option<[f64; 2]>| {
                    ends.is_some_and(|[low, high]| low <= truth && truth <= high)
                };
                let is_known = one.knowledge == Knowledge::Data || one.profile.is_some();
                let count = &mut found[j].1;
                count[0] += usize::from(holds(one.interval));
                count[1] += usize::from(holds(one.profile));
                count[2] += usize::from(is_known);
            }
        }
        Ok(found)
    }
}

/// Within this of 95 %.
fn check(sets: usize, tolerance: f64) {
    for design in &DESIGNS {
        for (parameter, [by_t, by_profile, known]) in design.coverage(sets).unwrap() {
            assert_eq!(known, sets, "{}: {parameter}", design.name);
            for held in [by_t, by_profile] {
                let share = held as f64 / sets as f64;
                println!("{}: {parameter} {share}", design.name);
                assert!((share - 0.95).abs() <= tolerance, "{}: {parameter} {share}", design.name);
            }
        }
    }
}

#[test]
fn intervals_hold_the_truth() {
    // Three standard deviations of the binomial distribution.
    check(200, 3.0 * (0.95_f64 * 0.05 / 200.0).sqrt());
}

#[test]
#[ignore = "ten seconds"]
fn intervals_hold_the_truth_in_2000_sets() {
    check(2000, 0.02);
}
