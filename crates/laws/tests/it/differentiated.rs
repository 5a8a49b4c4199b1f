//! Derivatives of the load by friction and stiffness against differences of the law on the same path.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::coulomb::Tolerance;
use carom_laws::differentiated::Differentiated;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Sensitive, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;

/// Friction, c_x and c_z.
type Parameters = [f64; 3];

fn made([f, c_x, c_z]: Parameters) -> (ContactStiffness, Friction) {
    (ContactStiffness::new(c_x, c_x, c_z).unwrap(), Friction::new(f).unwrap())
}

fn force(parameters: Parameters, path: &[Shift]) -> [f64; 2] {
    let (stiffness, friction) = made(parameters);
    let mut law = ShiftLaw::<f64>::new(stiffness, friction);
    let loads = path.iter().map(|&shift| law.advance(shift).unwrap());
    loads.last().map(|load| [load.f_x, load.f_z]).unwrap()
}

/// The difference of fourth order by the logarithm of a parameter.
fn difference(parameters: Parameters, which: usize, path: &[Shift], step: f64) -> [f64; 2] {
    let at = |part: f64| {
        let mut moved = parameters;
        moved[which] *= 1.0 + part * step;
        force(moved, path)
    };
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(at);
    [0, 1].map(|k| (8.0 * (c[k] - b[k]) - (d[k] - a[k])) / (12.0 * step))
}

#[test]
fn derivatives_are_differences_of_the_law_on_drawn_paths() {
    let mut random = Splitmix(7);
    let (mut left_out, mut all) = (0, 0);
    for _ in 0..400 {
        let mut unit = || random.part();
        let parameters = [0.05 + unit(), 0.5 + unit(), 0.5 + unit()];
        let (stiffness, friction) = made(parameters);
        let mut law = Differentiated::new(stiffness, friction).unwrap();
        let mut path: Vec<Shift> = Vec::new();
        for _ in 0..12 {
            // Now and then the bodies part.
            let xi = 1.5 * parameters[0] * (unit() - 0.5);
            path.push(Shift { zeta: 1.1 * unit() - 0.1, xi, ..Shift::default() });
            let load = law.advance(path[path.len() - 1]).unwrap();
            let found = law.sensitivity();
            assert!(!found.is_at_change);
            let found = [found.by_friction, found.by_c_x, found.by_c_z];
            for which in 0..3 {
                all += 1;
                let [wide, narrow] =
                    [2e-4, 1e-4].map(|step| difference(parameters, which, &path, step));
                let size = 1e-3 + load.f_z;
                if (wide[0] - narrow[0]).abs() > 1e-8 * size {
                    left_out += 1; // a front begins or ends within the step
                    continue;
                }
                let own = [found[which].f_x, found[which].f_z].map(|by| by * parameters[which]);
                for (own, wanted) in own.into_iter().zip(narrow) {
                    assert!(
                        (own - wanted).abs() <= 1e-8 * size,
                        "{parameters:?} {path:?}: {own} {wanted}"
                    );
                }
            }
        }
    }
    assert!(50 * left_out < all, "{left_out} of {all}");
}

#[test]
fn without_slip_the_force_is_proportional_to_the_stiffness() {
    let stiffness = ContactStiffness::new(0.8, 0.8, 1.2).unwrap();
    let mut law = Differentiated::new(stiffness, Friction::INFINITE).unwrap();
    for (zeta, xi) in [(1.0, 0.3), (0.6, -0.4), (0.9, 2.0)] {
        let load = law.advance(Shift { zeta, xi, ..Shift::default() }).unwrap();
        let found = law.sensitivity();
        assert_eq!(found.by_c_x.f_x, load.f_x / 0.8);
        assert_eq!(found.by_c_z.f_z, load.f_z / 1.2);
        assert_eq!((found.by_friction.f_x, found.by_c_z.f_x), (0.0, 0.0));
    }
    assert_eq!(Differentiated::new(stiffness, Friction::NONE).unwrap_err().field, "friction");
}

#[test]
fn on_the_limit_of_adhesion_one_side_is_told() {
    let (stiffness, friction) = made([0.25, 1.0, 1.0]);
    let mut law = Differentiated::new(stiffness, friction).unwrap();
    let steps = [(1.0, 0.0), (2.0, 0.25), (2.0, -0.3)].map(|(zeta, xi)| Shift {
        zeta,
        xi,
        ..Shift::default()
    });
    let changes = steps.map(|to| law.advance(to).map(|_| law.sensitivity().is_at_change));
    // What forgets the annuli of the limit forgets the flag.
    assert_eq!(changes, [Ok(false), Ok(true), Ok(false)]);
    // It is the step that counts, not where it begins.
    let mut moved = Differentiated::new(stiffness, friction).unwrap();
    moved.advance(Shift { zeta: 1.0, xi: 0.1, ..Shift::default() }).unwrap();
    moved.advance(Shift { zeta: 2.0, xi: 0.35, ..Shift::default() }).unwrap();
    assert!(moved.sensitivity().is_at_change);
}

/// What stands in for derivatives where shifts turn, and under static friction: one factor of all shifts tells those by all
/// parameters, since forces are f c_z G of c xi/(f c_z).
#[test]
fn parameters_count_by_the_scale_of_shifts_alone() {
    let tolerance = Tolerance::new(1e-4).unwrap();
    let after = |[f_s, f_k, c, c_z]: [f64; 4], scale: f64, path: &[Shift]| {
        let [f_s, f_k] = [f_s, f_k].map(|f| Friction::new(f).unwrap());
        let friction = StaticFriction::new(f_s, f_k).unwrap();
        let stiffness = ContactStiffness::new(c, 0.8 * c, c_z).unwrap();
        let mut law: ShiftLaw<[f64; 2]> =
            ShiftLaw::with_static_friction(TurningLaw::Coulomb, stiffness, friction, tolerance);
        let scaled =
            |shift: &Shift| Shift { xi: scale * shift.xi, eta: scale * shift.eta, ..*shift };
        let loads = path.iter().map(|shift| law.advance(scaled(shift)).unwrap());
        loads.last().map(|load| [load.f_x, load.f_y]).unwrap()
    };
    let mut random = Splitmix(19);
    for i in 0..60 {
        let f_k = 0.2;
        let f_s = if i % 2 == 0 { f_k } else { 0.3 };
        let shift = |random: &mut Splitmix| Shift {
            zeta: 0.2 + random.part(),
            xi: 0.4 * (random.part() - 0.5),
            eta: 0.4 * (random.part() - 0.5),
            ..Shift::default()
        };
        let path: Vec<Shift> = (0..8).map(|_| shift(&mut random)).collect();
        let own = [f_s, f_k, 1.0, 1.2];
        let part = 1.0 + 0.1 * random.part();
        for (changed, scale, factor) in [
            ([part * f_s, part * f_k, 1.0, 1.2], 1.0 / part, part),
            ([f_s, f_k, 1.0, 1.2 * part], 1.0 / part, part),
            ([f_s, f_k, part, 1.2], part, 1.0),
        ] {
            let (found, wanted) = (after(changed, 1.0, &path), after(own, scale, &path));
            for (found, wanted) in found.into_iter().zip(wanted) {
                assert!((found - factor * wanted).abs() < 1e-10, "{i}: {found} {wanted}");
            }
        }
    }
}
