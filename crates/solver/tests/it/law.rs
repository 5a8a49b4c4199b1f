//! The numerical contact law: compared with the analytic one, and on windows with one large grid.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Frictional, Gap, Method as _, NumericalLaw,
};
use proptest::prelude::*;

const APPROACH: f64 = 0.01;

fn hertz(poisson: [f64; 2], slender: f64) -> Hertz {
    let [one, two] = poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5 / slender).unwrap(), pair).unwrap()
}

fn law(poisson: [f64; 2], slender: f64, f: f64, cells: usize) -> NumericalLaw {
    NumericalLaw::new(hertz(poisson, slender), Friction::new(f).unwrap(), APPROACH, cells).unwrap()
}

fn shift(zeta: f64, xi: f64, eta: f64) -> Shift {
    Shift { zeta: zeta * APPROACH, xi: xi * APPROACH, eta: eta * APPROACH, omega: 0.0 }
}

/// Pressed and shifted together, shifted further, back, and released; `steps` for each leg.
fn path(steps: usize) -> Vec<Shift> {
    let corners = [(0.0, 0.0), (0.8, 0.1), (1.0, 0.4), (0.9, 0.0), (0.5, -0.1), (0.2, 0.0)];
    let legs = corners.windows(2).flat_map(|leg| {
        let [(z0, x0), (z1, x1)] = [leg[0], leg[1]];
        (1..=steps).map(move |i| {
            let part = i as f64 / steps as f64;
            shift(z0 + part * (z1 - z0), x0 + part * (x1 - x0), 0.0)
        })
    });
    legs.collect()
}

fn follow<L: ContactLaw>(law: &mut L, path: &[Shift]) -> Vec<ContactLoad> {
    path.iter().map(|shift| law.advance(*shift).unwrap()).collect()
}

/// The greatest differences of F_x and F_z from the analytic law at the ends of the legs, relative
/// to the greatest f F_z and F_z.
fn misfit(cells: usize, steps: usize) -> [f64; 2] {
    let (hertz, friction) = (hertz([0.0; 2], 1.0), Friction::new(0.5).unwrap());
    let path = path(steps);
    let mut exact = ShiftLaw::<f64>::new(hertz.stiffness(), friction);
    let exact = follow(&mut exact, &path);
    let found = follow(&mut law([0.0; 2], 1.0, 0.5, cells), &path);
    let greatest = exact.iter().map(|load| load.f_z).fold(0.0, f64::max);
    let ends = exact.iter().zip(&found).skip(steps - 1).step_by(steps);
    ends.fold([0.0; 2], |[x, z], (a, b)| {
        let off_x = (a.f_x - b.f_x).abs() / (0.5 * greatest);
        [f64::max(x, off_x), f64::max(z, (a.f_z - b.f_z).abs() / greatest)]
    })
}

#[test]
fn similar_bodies_tend_to_the_analytic_law() {
    let coarse = misfit(10, 8);
    let fine = misfit(20, 16);
    let finest = misfit(40, 32);
    let text = format!("{coarse:?} {fine:?} {finest:?}");
    assert!(finest[0] < 6e-4 && finest[1] < 3e-4, "{text}");
    assert!(finest[0] < 0.7 * fine[0] && fine[0] < 0.5 * coarse[0], "{text}");
    assert!(finest[1] < 0.35 * fine[1] && fine[1] < 0.35 * coarse[1], "{text}");
}

#[test]
fn windows_that_follow_the_contact_give_what_one_large_grid_gives() {
    for poisson in [[0.3, 0.3], [0.0, 0.5]] {
        let hertz = hertz(poisson, 3.0);
        let mut law = law(poisson, 3.0, 0.2, 18);
        // No shifts while the contact grows: the law divides those among the cells that enter.
        let corners =
            [(0.3, 0.0), (0.6, 0.0), (0.6, 0.05), (0.5, 0.1), (1.0, 0.1), (1.0, 0.2), (0.8, 0.0)];
        let path = corners.into_iter().chain([(0.3, -0.1), (0.6, -0.1), (0.6, 0.2), (0.1, 0.1)]);
        let path = path.map(|(zeta, xi)| {
            let to = shift(zeta, xi, -0.3 * xi);
            Shift { omega: 0.2 * to.xi, ..to }
        });
        // The same cells, 32 of them along both sides.
        let ellipse = hertz.ellipse(APPROACH).unwrap();
        let width = |semi_axis: f64| 2.0 * semi_axis / 18.0;
        let (dx, dy) = (width(ellipse.semi_axis_a()), width(ellipse.semi_axis_b()));
        let grid = carom_halfspace::Grid::new(32, 32, dx, dy).unwrap();
        let gap = Gap::of_curvature(grid, &hertz.curvature());
        let friction = Friction::new(0.2).unwrap();
        let problem = ContactProblem::of_half_spaces(gap, hertz.materials(), friction).unwrap();
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut before = ContactState::apart(grid);
        let mut sizes = std::collections::BTreeSet::new();
        for to in path {
            let load = law.advance(to).unwrap();
            let mut state = before.clone();
            let drive = Drive::by_shift(to);
            method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ()).unwrap();
            before.clone_from(&state);
            let expected = state.load();
            let scale = 1e-7 * expected.f_z;
            assert!((load.f_z - expected.f_z).abs() < scale, "{load:?} {expected:?}");
            assert!((load.f_x - expected.f_x).abs() < scale, "{load:?} {expected:?}");
            assert!((load.f_y - expected.f_y).abs() < scale, "{load:?} {expected:?}");
            assert!((load.m_z - expected.m_z).abs() < scale * ellipse.semi_axis_b());
            let touching = [CellState::Stick, CellState::Slip].map(|cell| state.count(cell));
            assert_eq!([CellState::Stick, CellState::Slip].map(|cell| law.count(cell)), touching);
            sizes.insert(law.state().unwrap().pressure.grid().nx());
        }
        assert!(sizes.len() >= 3, "{sizes:?}");
    }
}

#[test]
fn an_outgrown_grid_gets_wider_cells() {
    let (hertz, mut law) = (hertz([0.0, 0.5], 1.0), law([0.0, 0.5], 1.0, 0.3, 16));
    let mut cells = Vec::new();
    for i in 1..=40 {
        let load = law.advance(shift(2.0 * f64::from(i), 0.1 * f64::from(i), 0.0)).unwrap();
        let exact = hertz.force(2.0 * f64::from(i) * APPROACH);
        // Dissimilar bodies with friction are stiffer by one percent.
        assert!((0.995..1.025).contains(&(load.f_z / exact)), "{i}: {}", load.f_z / exact);
        cells.push(law.state().unwrap().pressure.grid());
    }
    assert!(cells[39].dx() > 3.9 * cells[0].dx());
    assert!(cells.iter().all(|grid| grid.nx() <= 48));
    // In a single step: the same cells.
    let mut at_once = NumericalLaw::new(hertz, Friction::new(0.3).unwrap(), APPROACH, 16).unwrap();
    at_once.advance(shift(80.0, 4.0, 0.0)).unwrap();
    assert_eq!(at_once.state().unwrap().pressure.grid(), cells[39]);
}

#[test]
fn shifts_before_touch_leave_no_trace() {
    let (mut late, mut straight) = (law([0.0, 0.5], 1.0, 0.3, 12), law([0.0, 0.5], 1.0, 0.3, 12));
    late.advance(shift(-1.0, -2.0, 5.0)).unwrap();
    late.advance(shift(-0.5, 0.25, 0.0)).unwrap();
    assert!(late.state().is_none());
    // From (-0.5, 0.25) straight to (0.5, 0.75): first contact at xi = 0.5.
    let load = late.advance(shift(0.5, 0.75, 0.0)).unwrap();
    straight.advance(shift(0.0, 0.5, 0.0)).unwrap();
    let expected = straight.advance(shift(0.5, 0.75, 0.0)).unwrap();
    assert!((load.f_x - expected.f_x).abs() < 1e-12 * load.f_z);
    assert_eq!(late.advance(shift(0.0, 0.75, 0.0)).unwrap(), ContactLoad::default());
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |approach: f64, cells, f| {
        let friction = Friction::new(f).unwrap();
        NumericalLaw::new(hertz([0.0, 0.5], 1.0), friction, approach, cells).unwrap_err().field
    };
    assert_eq!(refused(0.0, 20, 0.1), "approach");
    assert_eq!(refused(f64::NAN, 20, 0.1), "approach");
    assert_eq!(refused(1.0, 3, 0.1), "cells");
    assert_eq!(refused(1.0, 20, f64::INFINITY), "friction");
    let method = Frictional::default();
    for tolerance in [0.0, 1e-14, 0.1, f64::NAN] {
        assert_eq!(method.within(tolerance).unwrap_err().field, "tolerance");
    }
    assert_eq!(method.at_most(0, 1).unwrap_err().field, "iterations");
    assert_eq!(method.at_most(1, 0).unwrap_err().field, "passes");
    let mut law = law([0.0, 0.5], 1.0, 0.3, 12);
    law.advance(shift(1.0, 0.1, 0.0)).unwrap();
    let (load, before) = (law.load(), law.state().unwrap().clone());
    assert!(law.advance(shift(f64::NAN, 0.0, 0.0)).is_err());
    assert!(law.advance(shift(1.0, f64::INFINITY, 0.0)).is_err());
    assert_eq!((law.load(), law.state().unwrap()), (load, &before));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// A step that is tried and discarded does not change a bit of later steps.
    #[test]
    fn trials_leave_no_trace(
        steps in prop::collection::vec((-0.2_f64..1.5, -0.5_f64..0.5, -0.5_f64..0.5), 2..6),
    ) {
        let (mut plain, mut tried) = (law([0.1, 0.4], 2.0, 0.3, 10), law([0.1, 0.4], 2.0, 0.3, 10));
        for (zeta, xi, eta) in steps {
            let to = shift(zeta, xi, eta);
            let mut trial = tried.clone();
            let _ = trial.advance(shift(zeta + 0.4, -xi, 0.0));
            let _ = trial.advance(shift(0.3, 0.0, eta));
            prop_assert_eq!(plain.advance(to).unwrap(), tried.advance(to).unwrap());
        }
        prop_assert_eq!(plain.state(), tried.state());
    }
}
