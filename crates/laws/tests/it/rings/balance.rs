//! Work equals stored energy plus heat; nothing gains energy.

use super::common::{alike, hertz, law, path, unlike};
use carom_laws::accounted::Accounted;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Dissipative, Energies, Shift};
use carom_laws::rings::RingLaw;

struct Books {
    /// By the mean of the loads at both ends of each step; Hertz's work exactly.
    work: f64,
    heat: f64,
    stored: f64,
    /// The greatest difference of the books on the way.
    off: f64,
}

fn follow<const N: usize>(law: RingLaw<N, 8>, hertz: &Hertz, path: &[Shift]) -> Books {
    let mut law = Accounted::new(law);
    let mut books = Books { work: 0.0, heat: 0.0, stored: 0.0, off: 0.0 };
    let (mut old, mut from) = (law.load(), law.shift());
    for to in path {
        let heat = law.law().dissipation(*to);
        assert!(heat >= 0.0, "a step gains {heat}");
        let new = law.advance(*to).unwrap();
        let normal = |zeta: f64| hertz.normal_energy(zeta.max(0.0));
        let grown = |f_z: f64, zeta: f64| f_z - hertz.force(zeta.max(0.0));
        let mean = |x: f64, y: f64| 0.5 * (x + y);
        books.work += normal(to.zeta) - normal(from.zeta)
            + mean(grown(old.f_z, from.zeta), grown(new.f_z, to.zeta)) * (to.zeta - from.zeta)
            + mean(old.f_x, new.f_x) * (to.xi - from.xi)
            + mean(old.f_y, new.f_y) * (to.eta - from.eta)
            + mean(old.m_z, new.m_z) * (to.omega - from.omega);
        (books.heat, books.stored) = (law.dissipated(), law.stored_energy());
        books.off = books.off.max((books.work - books.heat - books.stored).abs());
        (old, from) = (new, *to);
    }
    books
}

#[test]
fn books_balance_on_turning_paths() {
    for (name, hertz) in
        [("alike", alike(0.3)), ("unlike", unlike()), ("soft", hertz([1.0, 0.3], [0.3, 0.2]))]
    {
        for twist in [0.0, 0.4] {
            let path = path(11, 10, 80, [0.4, twist]);
            let books = follow(law::<6, 8>(&hertz, 0.3, 1e-2), &hertz, &path);
            assert!(
                books.off < 6e-3 * books.heat,
                "{name} {twist}: {} of {}",
                books.off,
                books.heat
            );
            let books = follow(law::<8, 8>(&hertz, 0.3, 1e-4), &hertz, &path);
            assert!(
                books.off < 5e-3 * books.heat,
                "{name} {twist}: {} of {}",
                books.off,
                books.heat
            );
        }
    }
}

#[test]
fn books_balance_over_a_hundred_thousand_random_steps() {
    let hertz = unlike();
    let path = path(12, 1000, 100, [0.4, 0.4]);
    let books = follow(law::<6, 8>(&hertz, 0.3, 1e-2), &hertz, &path);
    assert!(books.off < 6e-3 * books.heat, "{} of {}", books.off, books.heat);
}

#[test]
fn what_is_stored_at_separation_is_heat() {
    let hertz = alike(0.3);
    let mut law = Accounted::new(law::<6, 8>(&hertz, 0.3, 1e-3));
    let at = |zeta: f64, xi: f64| Shift { zeta, xi, ..Shift::default() };
    law.advance(at(1.0, 0.0)).unwrap();
    law.advance(at(1.0, 0.1)).unwrap();
    let (stored, heat) = (law.stored_energy() - hertz.normal_energy(1.0), law.dissipated());
    law.advance(at(-0.1, 0.1)).unwrap();
    assert_eq!(law.stored_energy(), 0.0);
    assert!((law.dissipated() - heat - stored).abs() < 1e-12 * stored);
}
