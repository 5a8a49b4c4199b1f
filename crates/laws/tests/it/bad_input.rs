//! Every law returns an error that names an argument which is NaN, and keeps its state. An approach
//! that is not positive is no error: it separates the bodies, in one step.

use std::fmt::Debug;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::memory::{
    AdhesionMemory, Fixed, Growing, Lateral, Memory, ScalarMemory, VectorMemory,
};
use carom_laws::profile::{PowerLaw, RoundedFlat};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::SliderLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::ellipse::EllipseTorsion;
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::law::{ShiftTwistLaw, TorsionConstants, TorsionLaw};
use carom_special::RangeError;

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A law that steps to an approach and a shift along one axis.
trait Steps: Clone + PartialEq + Debug {
    fn step(&mut self, zeta: f64, x: f64) -> Result<f64, RangeError>;
    /// The names of the two.
    fn names() -> [&'static str; 2] {
        ["zeta", "shift"]
    }
}

macro_rules! memories {
    ($($law:ty => $shift:expr),* $(,)?) => {$(
        impl Steps for $law {
            fn step(&mut self, zeta: f64, x: f64) -> Result<f64, RangeError> {
                let shift = $shift;
                self.advance(zeta, shift(x)).map(|force| force.components()[0])
            }
        }
    )*};
}

memories! {
    ScalarMemory => |x| x,
    VectorMemory => |x| [x, 0.0],
    Memory<f64, Fixed<f64, 8>> => |x| x,
    Memory<[f64; 2], Fixed<[f64; 2], 8>> => |x| [x, 0.0],
    Memory<f64, Growing<f64>, PowerLaw> => |x| x,
    Memory<f64, Growing<f64>, RoundedFlat> => |x| x,
    AdhesionMemory<f64> => |x| x,
    AdhesionMemory<[f64; 2]> => |x| [x, 0.0],
    SliderLaw => |x| [x, 0.0],
}

macro_rules! laws {
    ($($law:ty, $name:literal, $load:ident => $shift:expr),* $(,)?) => {$(
        impl Steps for $law {
            fn step(&mut self, zeta: f64, x: f64) -> Result<f64, RangeError> {
                let shift = $shift;
                self.advance(Shift { zeta, ..shift(x) }).map(|load| load.$load)
            }
            fn names() -> [&'static str; 2] {
                ["zeta", $name]
            }
        }
    )*};
}

laws! {
    ShiftLaw<f64>, "xi", f_x => |x| Shift { xi: x, ..Shift::default() },
    ShiftLaw<[f64; 2]>, "eta", f_y => |x| Shift { eta: x, ..Shift::default() },
    TorsionLaw, "omega", m_z => |x| Shift { omega: x, ..Shift::default() },
    ShiftTwistLaw, "omega", m_z => |x| Shift { omega: x, ..Shift::default() },
}

fn check<L: Steps>(fresh: &L) {
    let name = std::any::type_name::<L>();
    let [approach, lateral] = L::names();
    let mut law = fresh.clone();
    law.step(1.0, 0.0).unwrap();
    law.step(1.0, 0.3).unwrap();
    law.step(0.9, 0.1).unwrap();
    let before = law.clone();
    for bad in BAD {
        assert_eq!(law.step(bad, 0.2).unwrap_err().field, approach, "{name}");
        assert_eq!(law.step(0.8, bad).unwrap_err().field, lateral, "{name}");
        assert_eq!(law.step(-0.8, bad).unwrap_err().field, lateral, "{name}");
        assert_eq!(law, before, "{name}: a failed step changed the state");
    }
    // Through a separation in one step, and by way of both touches.
    let mut slow = law.clone();
    assert_eq!(law.step(-0.6, 0.4).unwrap(), 0.0, "{name}");
    let part = 0.9 / 1.5;
    assert_eq!(slow.step(0.0, 0.1 + part * 0.3).unwrap(), 0.0, "{name}");
    assert_eq!(slow.step(-0.6, 0.4).unwrap(), 0.0, "{name}");
    let got = law.step(0.7, -0.1).unwrap();
    slow.step(0.0, 0.4 - 0.6 / 1.3 * 0.5).unwrap();
    let want = slow.step(0.7, -0.1).unwrap();
    assert!((got - want).abs() <= 1e-13 * want.abs() && got < 0.0, "{name}: {got} {want}");
    // Zero, and a long way back, are separations like any other.
    for zeta in [0.0, -0.0, -1e-300, -1e9] {
        let mut law = before.clone();
        assert_eq!(law.step(zeta, 5.0).unwrap(), 0.0, "{name}");
        assert_eq!(law.step(zeta, -5.0).unwrap(), 0.0, "{name}");
    }
}

/// At the bound all is finite; beyond it the value is refused.
fn check_bound<L: Steps>(fresh: &L, greatest: f64) {
    let name = std::any::type_name::<L>();
    let mut law = fresh.clone();
    let size = greatest;
    for (zeta, x) in [
        (size, 0.0),
        (size, 0.5 * size),
        (0.9 * size, 0.38 * size),
        (0.5 * size, -size),
        (1e-300 * size, size),
        (-size, -size),
        (size, size),
        (1.0, -1.0),
    ] {
        let force = law.step(zeta, x).unwrap();
        assert!(force.is_finite(), "{name}: {zeta:e} {x:e} {force}");
    }
    let [approach, lateral] = L::names();
    let before = law.clone();
    assert_eq!(law.step(1.001 * size, 0.0).unwrap_err().field, approach, "{name}");
    assert_eq!(law.step(-1.001 * size, 0.0).unwrap_err().field, approach, "{name}");
    assert_eq!(law.step(1.0, -1.001 * size).unwrap_err().field, lateral, "{name}");
    assert_eq!(law, before, "{name}");
}

#[test]
fn nothing_overflows() {
    check_bound(&ScalarMemory::new(), 1e100);
    check_bound(&VectorMemory::new(), 1e100);
    check_bound(&Memory::<f64, Fixed<f64, 8>>::new(), 1e100);
    check_bound(&AdhesionMemory::<f64>::new(), 1e100);
    check_bound(&SliderLaw::new(50, 1e100, 1.0).unwrap(), 1e100);
    check_bound(&SliderLaw::new(50, 1e100, 0.8).unwrap(), 1e100);
    let stiffness = ContactStiffness::new(1e30, 1e31, 1e60).unwrap();
    for friction in [0.0, 0.3, 1e30, f64::INFINITY] {
        let friction = Friction::new(friction).unwrap();
        check_bound(&ShiftLaw::<f64>::new(stiffness, friction), 1e60);
        check_bound(&ShiftLaw::<[f64; 2]>::new(stiffness, friction), 1e60);
    }
    for friction in [0.0, f64::INFINITY] {
        check_bound(&TorsionLaw::new(&hertz(), Friction::new(friction).unwrap()).unwrap(), 1e60);
    }
    for size in [1e60, 1e-60, 1e-100, 1e-300] {
        let mut history = TwistHistory::new();
        for (radius, twist) in
            [(size, 0.0), (size, 0.5 * size), (0.9 * size, 0.38 * size), (0.5 * size, -size)]
        {
            assert!(history.advance(radius, twist).unwrap().is_finite());
            assert!(history.stored_energy().is_finite() && history.stick_radius() <= radius);
        }
        let before = history.clone();
        assert_eq!(history.advance(2e60, 0.0).unwrap_err().field, "radius");
        assert_eq!(history.advance(1.0, -2e60).unwrap_err().field, "twist");
        assert_eq!(history, before);
    }
}

fn hertz() -> Hertz {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let gap = RelativeCurvature::from_coefficients(0.7, 0.2).unwrap();
    Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap()
}

#[test]
fn memories_refuse_what_is_not_finite_and_separate_in_one_step() {
    check(&ScalarMemory::new());
    check(&VectorMemory::new());
    check(&Memory::<f64, Fixed<f64, 8>>::new());
    check(&Memory::<[f64; 2], Fixed<[f64; 2], 8>>::new());
    check(&Memory::<f64, Growing<f64>, PowerLaw>::with_profile(PowerLaw::CONE));
    check(&Memory::<f64, Growing<f64>, RoundedFlat>::with_profile(RoundedFlat::new(0.5).unwrap()));
    check(&AdhesionMemory::<f64>::new());
    check(&AdhesionMemory::<[f64; 2]>::new());
    check(&SliderLaw::new(50, 1.0, 1.0).unwrap());
    check(&SliderLaw::new(50, 1.0, 0.8).unwrap());
}

#[test]
fn laws_refuse_what_is_not_finite_and_separate_in_one_step() {
    let stiffness = ContactStiffness::new(1.0, 0.9, 1.2).unwrap();
    for friction in [0.3, f64::INFINITY] {
        let friction = Friction::new(friction).unwrap();
        check(&ShiftLaw::<f64>::new(stiffness, friction));
        check(&ShiftLaw::<[f64; 2]>::new(stiffness, friction));
        check(&TorsionLaw::new(&hertz(), friction).unwrap());
        check(&ShiftTwistLaw::new(&hertz(), friction).unwrap());
    }
}

#[test]
fn every_component_is_looked_at() {
    let friction = Friction::new(0.3).unwrap();
    let good = Shift { zeta: 0.01, xi: 1e-3, eta: 1e-3, omega: 1e-3 };
    let mut law = ShiftTwistLaw::new(&hertz(), friction).unwrap();
    law.advance(good).unwrap();
    let before = law.clone();
    for bad in BAD {
        for (shift, field) in [
            (Shift { zeta: bad, ..good }, "zeta"),
            (Shift { xi: bad, ..good }, "xi"),
            (Shift { eta: bad, ..good }, "eta"),
            (Shift { omega: bad, ..good }, "omega"),
        ] {
            assert_eq!(law.advance(shift).unwrap_err().field, field);
            assert_eq!(law, before);
        }
    }
    for bad in [[f64::NAN, 0.0], [0.0, f64::NAN], [f64::INFINITY, 0.0]] {
        let mut memory = VectorMemory::new();
        memory.advance(1.0, [0.1, 0.2]).unwrap();
        let before = memory.clone();
        assert_eq!(memory.advance(1.0, bad).unwrap_err().field, "shift");
        assert_eq!(memory, before);
    }
}

#[test]
fn twists_refuse_what_is_not_finite() {
    let mut history = TwistHistory::new();
    history.advance(1.0, 0.0).unwrap();
    history.advance(1.0, 0.4).unwrap();
    history.advance(0.9, 0.28).unwrap(); // two slip rings
    let before = history.clone();
    for bad in BAD.into_iter().chain([-1.0, -1e-300]) {
        assert_eq!(history.advance(bad, 0.1).unwrap_err().field, "radius");
        assert_eq!(history, before);
    }
    for bad in BAD {
        assert_eq!(history.advance(0.9, bad).unwrap_err().field, "twist");
        assert_eq!(history, before);
        assert_eq!(TwistHistory::with_ring_width(bad).unwrap_err().field, "width");
    }
    assert_eq!([f64::NAN, -1.0].map(|radius| history.dissipation(radius, 0.0)), [0.0; 2]);
    assert_eq!(history.advance(0.0, 3.0).unwrap(), 0.0);

    let mut torsion = EllipseTorsion::new(1.0, 2.0).unwrap();
    torsion.advance(0.3).unwrap();
    torsion.advance(0.1).unwrap();
    let before = torsion.clone();
    for bad in BAD {
        assert_eq!(torsion.advance(bad).unwrap_err().field, "twist");
        assert_eq!(torsion, before);
    }
}

#[test]
fn constructors_name_the_wrong_value() {
    for bad in [-0.1, -1e-300, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(Friction::new(bad).unwrap_err().field, "friction");
    }
    for bad in BAD.into_iter().chain([0.0, -1.0]) {
        assert_eq!(ContactStiffness::new(bad, 1.0, 1.0).unwrap_err().field, "c_x");
        assert_eq!(ContactStiffness::new(1.0, bad, 1.0).unwrap_err().field, "c_y");
        assert_eq!(ContactStiffness::new(1.0, 1.0, bad).unwrap_err().field, "c_z");
        assert_eq!(PowerLaw::of_shape(bad).unwrap_err().field, "shape");
        assert_eq!(RoundedFlat::new(bad).unwrap_err().field, "flat_radius");
        assert_eq!(SliderLaw::new(9, bad, 1.0).unwrap_err().field, "deepest");
        assert_eq!(SliderLaw::new(9, 1.0, bad).unwrap_err().field, "stiffness_ratio");
        assert_eq!(EllipseTorsion::new(1.0, bad).unwrap_err().field, "stiffness");
        if bad != 0.0 {
            assert_eq!(EllipseTorsion::new(bad, 1.0).unwrap_err().field, "sliding_torque");
        }
    }
    assert_eq!(SliderLaw::new(0, 1.0, 1.0).unwrap_err().field, "count");
}

/// The twist is fine, the shift is not: neither law goes on. In the units of slip it is too large
/// for a stiff contact of little friction.
#[test]
fn a_shift_that_is_refused_leaves_the_twist_too() {
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.3).unwrap(), Material::RIGID).unwrap();
    let gap = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
    let hertz = Hertz::new(gap, pair).unwrap();
    let friction = Friction::new(1e-20).unwrap();
    let stiff = ContactStiffness::new(1e30, 1e30, 1.0).unwrap();
    let torsion = TorsionLaw::new(&hertz, Friction::new(0.3).unwrap()).unwrap();
    let mut law = ShiftTwistLaw::of(ShiftLaw::new(stiff, friction), torsion).unwrap();
    law.advance(Shift { zeta: 1.0, xi: 0.1, ..Shift::default() }).unwrap();
    let before = law.clone();
    let to = Shift { zeta: 1.0, xi: 1e55, eta: 0.0, omega: 1e-3 };
    assert!(law.torsion().clone().advance(to).is_ok());
    assert!(law.advance(to).is_err());
    assert_eq!(law, before);
}

/// An infinite sliding torque gave a torque of 0 times infinity.
#[test]
fn a_sliding_torque_that_overflows_is_refused() {
    let of = |c_z: f64, arm: f64, stiffness: f64| {
        let constants = TorsionConstants { c_z, stiffness, arm };
        TorsionLaw::from_constants(constants, Friction::new(0.3).unwrap())
            .map_err(|error| error.field)
    };
    assert!(of(1.2, 0.6, 1.3).is_ok());
    assert_eq!(of(1e150, 1.0, 1.3).unwrap_err(), "c_z");
    assert_eq!(of(1e60, 1e60, 1.3).unwrap_err(), "sliding torque");
    assert_eq!(of(1e-60, 1e-60, 1.3).unwrap_err(), "sliding torque");
    assert_eq!(of(1e-40, 1e-40, 1e30).unwrap_err(), "twist of sliding");
}
