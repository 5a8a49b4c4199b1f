//! The loop of the book that shows what a law without memory misses.

use carom_laws::accounted::Accounted;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, Energies as _, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;

const PAGE: &str = include_str!("../../../../docs/book/src/others.md");

const FRICTION: f64 = 0.3;
const C_X: f64 = 2.5;
const C_Z: f64 = 3.0;

/// Step, s, and the forces with and without memory of the rows of the table.
fn printed() -> Vec<(String, [f64; 3])> {
    let lines = PAGE.lines().skip_while(|line| !line.starts_with("| step | $s$ |")).skip(2);
    let row = |line: &str| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        (cells[0].to_owned(), [1, 2, 3].map(|i| cells[i].parse().unwrap()))
    };
    lines.take_while(|line| line.starts_with('|')).map(row).collect()
}

/// A contact pressed to zeta = 1, where it slides from xi = f c_z/c_x on.
fn pressed() -> Accounted<ShiftLaw<f64>> {
    let stiffness = ContactStiffness::new(C_X, C_X, C_Z).unwrap();
    let mut law = Accounted::new(ShiftLaw::new(stiffness, Friction::new(FRICTION).unwrap()));
    law.advance(at(0.0)).unwrap();
    law
}

fn at(s: f64) -> Shift {
    Shift { zeta: 1.0, xi: s * FRICTION * C_Z / C_X, ..Shift::default() }
}

/// F/(f N) at s.
fn force(law: &mut Accounted<ShiftLaw<f64>>, s: f64) -> f64 {
    law.advance(at(s)).unwrap().f_x / (FRICTION * 2.0 / 3.0 * C_Z)
}

/// Mindlin's curve of the first loading, and Mindlin and Deresiewicz's of returning.
fn first(s: f64) -> f64 {
    1.0 - (1.0 - s).powf(1.5)
}

#[test]
fn the_table_of_the_book_is_what_the_law_gives() {
    let rows = printed();
    assert_eq!(rows.len(), 6);
    let mut law = pressed();
    let most = first(0.8);
    let back = most - 2.0 * first(0.4);
    for (step, [s, with, without]) in rows {
        let found = force(&mut law, s);
        let closed = match step.as_str() {
            "load" => first(s),
            "unload" => most - 2.0 * first(0.5 * (0.8 - s)),
            _ => back + 2.0 * first(0.5 * s),
        };
        assert!((found - with).abs() < 5e-5, "{step} {s}: {found}");
        assert!((found - closed).abs() < 1e-12, "{step} {s}: {found} {closed}");
        assert!((first(s) - without).abs() < 5e-5, "{step} {s}: {}", first(s));
    }
}

/// The heat of the loop: by the law, as the area within it, and as the page prints it.
#[test]
fn the_heat_of_the_loop_is_its_area() {
    let mut law = pressed();
    let unit = FRICTION * FRICTION * (2.0 / 3.0 * C_Z) * C_Z / C_X;
    for s in [0.8, 0.0] {
        force(&mut law, s);
    }
    let before = law.dissipated();
    for s in [0.8, 0.0] {
        force(&mut law, s);
    }
    let heat = (law.dissipated() - before) / unit;
    // Simpson's rule over both branches.
    let upper = |s: f64| first(0.8) - 2.0 * first(0.4) + 2.0 * first(0.5 * s);
    let lower = |s: f64| first(0.8) - 2.0 * first(0.5 * (0.8 - s));
    let area: f64 = (0..=400)
        .map(|i| {
            let s = 0.002 * f64::from(i);
            let weight = if i % 400 == 0 { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
            weight * (upper(s) - lower(s)) * 0.002 / 3.0
        })
        .sum();
    assert!((heat - area).abs() < 1e-7, "{heat} {area}");
    let (_, rest) = PAGE.split_once("friction takes ").unwrap();
    let told: f64 = rest.split_whitespace().next().unwrap().parse().unwrap();
    assert!((heat - told).abs() < 5e-5, "{heat}");
}
