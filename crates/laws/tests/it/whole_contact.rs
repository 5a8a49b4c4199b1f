//! The whole contact of two grains: law, torsion and resistance to rolling in one step.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::grains::{
    Grain, GrainContact, GrainLoad, GrainRoll, Heats, Meeting, Rolling, RollingResistance,
    WholeContact,
};
use carom_laws::hertz::Hertz;
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::torsion::law::{StoredTwist, TorsionLaw};

const DT: f64 = 1e-6;
const FRICTION: f64 = 0.3;
/// Of two grains of radius 2e-3.
const RELATIVE: f64 = 1e-3;

type Law = ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>;

fn hertz() -> Hertz {
    let glass = Material::from_young(70e9, 0.22).unwrap();
    let half = 0.5 / RELATIVE;
    let gap = RelativeCurvature::from_coefficients(half, half).unwrap();
    Hertz::new(gap, MaterialPair::new(glass, glass).unwrap()).unwrap()
}

fn resistance() -> RollingResistance {
    RollingResistance::new(1e6, 0.1, 0.02).unwrap()
}

#[derive(Clone)]
struct Parts {
    contact: GrainContact<Law>,
    twist: StoredTwist,
    roll: GrainRoll,
}

impl Parts {
    fn apart() -> Self {
        let friction = Friction::new(FRICTION).unwrap();
        let law = Law::new(hertz().stiffness(), friction);
        Self {
            contact: GrainContact::new(law, 0.0).unwrap(),
            twist: StoredTwist::new(&TorsionLaw::new(&hertz(), friction).unwrap()).unwrap(),
            roll: GrainRoll::default(),
        }
    }

    fn with<T>(&mut self, ask: impl FnOnce(&mut WholeContact<'_, Law>) -> T) -> T {
        let resistance = &resistance();
        let rolling = Rolling { resistance, relative_radius: RELATIVE, roll: &mut self.roll };
        ask(&mut WholeContact {
            contact: &mut self.contact,
            twist: Some(&mut self.twist),
            rolling: Some(rolling),
        })
    }

    fn step(&mut self, meeting: &Meeting, heats: Option<&mut Heats>) -> GrainLoad {
        let mut load = GrainLoad::default();
        self.with(|whole| whole.advance(meeting, DT, &mut load, heats)).unwrap();
        load
    }

    fn packed(&mut self) -> Vec<f64> {
        let mut numbers = vec![0.0; 82 + StoredTwist::NUMBERS + GrainRoll::NUMBERS];
        self.with(|whole| whole.pack(&mut numbers)).unwrap();
        numbers
    }
}

/// Two grains pressed by an approach, the upper one of which spins.
fn meeting(zeta: f64, spin: [f64; 3]) -> Meeting {
    let below =
        Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 2e-3, mass: 1.0 };
    let above = Grain { place: [0.0, 0.0, 4e-3 - zeta], spin, ..below };
    Meeting::of_spheres(&above, &below, [0.5; 2]).unwrap()
}

/// Where all slides the torque about the normal is 3 pi/16 f F_z a, that of rolling its limit times R F_z.
#[test]
fn torques_come_to_their_limits() {
    let (mut parts, zeta) = (Parts::apart(), 1e-7);
    let mut load = GrainLoad::default();
    for _ in 0..200 {
        load = parts.step(&meeting(zeta, [0.0, 100.0, 1e6]), None);
    }
    let (pressed, a) = (hertz().force(zeta), (RELATIVE * zeta).sqrt());
    let twist = -3.0 * std::f64::consts::PI / 16.0 * FRICTION * pressed * a;
    assert!((load.torques[0][2] / twist - 1.0).abs() < 1e-9, "{load:?} {twist}");
    // The shift exerts equal torques on both grains, rolling opposite ones; they turn with the grains.
    let [one, two] = load.torques;
    let rolled = 0.5 * f64::hypot(one[0] - two[0], one[1] - two[1]);
    let limit = 0.02 * pressed * RELATIVE;
    assert!((rolled / limit - 1.0).abs() < 1e-9, "{load:?} {limit}");
    assert_eq!(parts.with(|whole| whole.load(&meeting(zeta, [0.0; 3]))), load);
}

/// A step that one of the parts refuses changes none.
#[test]
fn a_step_that_fails_changes_nothing() {
    let mut parts = Parts::apart();
    parts.step(&meeting(1e-7, [1.0, 2.0, 30.0]), None);
    let before = parts.packed();
    // The rolling, the twist and the contact itself.
    let far = Meeting { velocity: [1e300, 0.0, 0.0], ..meeting(2e-7, [1.0; 3]) };
    for wrong in [meeting(2e-7, [1e150, 0.0, 0.0]), meeting(2e-7, [0.0, 0.0, 1e70]), far] {
        let mut load = GrainLoad::default();
        let failed = parts.with(|whole| whole.advance(&wrong, DT, &mut load, None));
        assert!(failed.is_err() && load == GrainLoad::default());
        assert_eq!(parts.packed(), before);
    }
}

/// A contact taken up from its numbers goes on to the same loads, and its heat does not depend on who asks.
#[test]
fn kept_in_numbers_it_goes_on() {
    let mut parts = Parts::apart();
    let at = |step: i32| {
        let t = f64::from(step);
        let spin = [20.0 * (0.3 * t).sin(), 5.0, 3e3 * (0.17 * t).sin() + 1e3 * (0.9 * t).cos()];
        meeting(1e-7 * (1.0 + 0.3 * (0.05 * t).sin()), spin)
    };
    for step in 0..150 {
        let mut again = Parts::apart();
        let numbers = parts.packed();
        if numbers[0] > 0.0 {
            again.with(|whole| whole.unpack(&numbers)).unwrap();
        }
        assert_eq!(again.packed(), numbers);
        let (mut asked, mut heats) = (parts.clone(), Heats::default());
        let loads = [&mut parts, &mut again].map(|parts| parts.step(&at(step), None));
        let size = loads[0].torques[0].iter().map(|part| part.abs()).sum::<f64>();
        for (one, two) in loads[0].torques[0].iter().zip(&loads[1].torques[0]) {
            assert!((one - two).abs() <= 1e-12 * size, "{step}: {loads:?}");
        }
        assert_eq!(asked.step(&at(step), Some(&mut heats)), loads[0], "{step}");
        assert!(heats.rolling >= -1e-18 && heats.friction >= -1e-18, "{step}: {heats:?}");
    }
}
