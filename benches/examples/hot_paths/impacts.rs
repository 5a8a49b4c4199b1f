//! Impacts: exact, from tables, coupled, torsional.

use carom_impact::Mobility;
use carom_impact::coupled::{CoupledImpact, TurningLaw};
use carom_impact::oblique::Groups;
use carom_impact::restitution::{DissimilarGroups, DissimilarTable, RestitutionTable, of_spheres};
use carom_impact::torsional::{TorsionalGroups, TorsionalImpact};
use carom_laws::friction::Friction;
use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use crate::{HotPath, Work};

pub(crate) const PATHS: &[HotPath] = &[
    ("exact_restitution", exact),
    ("table_restitution", table),
    ("dissimilar_table_restitution", dissimilar_table),
    ("coupled_impact", coupled),
    ("torsional_impact", torsional),
];

const KAPPA: f64 = 1.7 / 1.4;

/// Velocity ratios from grazing stick to sliding throughout.
fn lambdas(count: i32) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| 7.0 * (f64::from(i) + 0.5) / f64::from(count))
}

fn exact() -> Work {
    Box::new(|| lambdas(20).map(|lambda| of_spheres(KAPPA, lambda).expect("in range")).sum())
}

fn table() -> Work {
    let table = RestitutionTable::shared();
    let groups: Vec<_> =
        lambdas(2000).map(|at| Groups::of_spheres(KAPPA, at).expect("in range")).collect();
    Box::new(move || groups.iter().map(|&at| table.restitution(at).expect("in range")).sum())
}

fn dissimilar_table() -> Work {
    let table = DissimilarTable::shared();
    let friction = Friction::new(0.3).expect("positive");
    let of = |lambda| DissimilarGroups::of_spheres(1.2, 0.15, friction, lambda).expect("in range");
    let groups: Vec<_> = lambdas(1000).map(of).collect();
    assert!(groups.iter().all(|groups| table.stored(groups).is_some()), "all in the table");
    Box::new(move || groups.iter().filter_map(|at| table.stored(at)).map(|found| found.r_x).sum())
}

fn coupled() -> Work {
    let mobility = Matrix3::from_diagonal(&Vector3::new(9.461, 6.758, 3.379));
    let mobility = Mobility::from_matrix(mobility).expect("positive definite");
    let stiffness = ContactStiffness::new(39.1e9, 37.3e9, 46.3e9).expect("positive");
    let friction = Friction::new(0.5).expect("positive");
    let impact = CoupledImpact::new(mobility, stiffness, friction, [0.6, 0.4, 2.0].into());
    let impact = impact.expect("approaching").within(1e-4).expect("positive");
    Box::new(move || impact.solve(TurningLaw::Coulomb).expect("separates").impulse.norm())
}

fn torsional() -> Work {
    Box::new(|| {
        let spins = [0.01, 0.3, 1.0, 5.0, 100.0];
        let groups = spins.map(|spin| TorsionalGroups::new(0.0625, spin).expect("in range"));
        let impacts = groups.map(|groups| TorsionalImpact::new(groups).expect("in range"));
        impacts.iter().map(TorsionalImpact::energy_loss).sum()
    })
}
