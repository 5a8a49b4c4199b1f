//! The second axis and the twist: a turned problem has the turned solution.

use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_solver::{ContactState, Estimates, MeshOrder, NumericalLaw};

fn law(cells: usize) -> NumericalLaw {
    let body = |poisson| Material::from_shear(1.0, poisson).unwrap();
    let pair = MaterialPair::new(body(0.3), body(0.3)).unwrap();
    let hertz = Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap();
    let law = NumericalLaw::new(hertz, Friction::new(0.4).unwrap(), 1.0, cells).unwrap();
    law.within(1e-9).unwrap()
}

/// A contact that grows while it twists has tractions around its middle: t_y along x is -t_x along y.
#[test]
fn tractions_of_a_growing_twisted_contact_go_around() {
    let mut law = law(16);
    for (zeta, omega) in [(0.3, 0.0), (0.6, 0.2), (1.0, 0.5)] {
        law.advance(Shift { zeta, omega, ..Shift::default() }).unwrap();
    }
    let state = law.state().unwrap();
    let grid = state.pressure.grid();
    let peak = state.pressure.values().iter().copied().fold(0.0, f64::max);
    let mut largest = 0.0_f64;
    for row in 0..grid.ny() {
        for column in 0..grid.nx() {
            let along = state.traction_y.values()[grid.index(column, row)];
            let turned = state.traction_x.values()[grid.index(row, column)];
            assert!((along + turned).abs() < 1e-6 * peak, "{column} {row}: {along} {turned}");
            largest = largest.max(along.abs());
        }
    }
    assert!(largest > 0.05 * peak, "{largest} {peak}");
}

/// Of a step that closes the gap only the part in contact counts, of each motion.
#[test]
fn only_the_part_of_a_step_in_contact_counts() {
    for motion in [[0.3, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3], [0.2, -0.1, 0.2]] {
        let at = |zeta: f64, part: f64| {
            let [xi, eta, omega] = motion.map(|way| part * way);
            Shift { zeta, xi, eta, omega }
        };
        let [mut one, mut two] = [law(8), law(8)];
        one.advance(at(-3.0, 0.0)).unwrap();
        let got = one.advance(at(1.0, 1.0)).unwrap();
        two.advance(at(0.0, 0.75)).unwrap();
        let want = two.advance(at(1.0, 1.0)).unwrap();
        let off = (got.f_x - want.f_x).hypot(got.f_y - want.f_y) + (got.m_z - want.m_z).abs();
        assert!(off < 1e-9 * want.f_z, "{motion:?}: {got:?} {want:?}");
        assert!(want.f_x.hypot(want.f_y) + want.m_z.abs() > 1e-2 * want.f_z, "{want:?}");
    }
}

/// A paraboloid of pressure has its peak between the centres of cells, along either axis.
#[test]
fn the_peak_between_cells_is_found_along_both_axes() {
    let grid = Grid::new(9, 7, 0.2, 0.3).unwrap();
    for (x_0, y_0) in [(0.0, 0.0), (0.07, 0.0), (0.0, 0.11), (-0.06, 0.13), (0.09, -0.14)] {
        let mut state = ContactState::apart(grid);
        let pressure =
            |x: f64, y: f64| (3.0 - (x - x_0).powi(2) - 0.5 * (y - y_0).powi(2)).max(0.0);
        state.pressure = Field::from_function(grid, pressure);
        assert!(
            (state.peak_pressure() - 3.0).abs() < 1e-14,
            "{x_0} {y_0}: {}",
            state.peak_pressure()
        );
    }
}

/// States on three grids of oblong cells, the same with x and y exchanged if asked: a cap, and a block whose pressure is greatest at the
/// two edges across y.
fn on_three_grids(is_cap: bool, is_exchanged: bool) -> Estimates {
    let states = [(24, 0.0), (12, 0.003), (6, 0.012)].map(|(cells, more)| {
        let pressure = |x: f64, y: f64| match is_cap {
            true => (1.0 + more - x * x - 0.3 * y * y).max(0.0),
            false if x.abs() < 0.8 && y.abs() < 0.8 => 1.0 + more + 0.1 * y * y - 0.2 * x * x,
            false => 0.0,
        };
        let counts = if is_exchanged { [cells * 3 / 2, cells] } else { [cells, cells * 3 / 2] };
        let [dx, dy] = counts.map(|count| 2.4 / count as f64);
        let mut state = ContactState::apart(Grid::new(counts[0], counts[1], dx, dy).unwrap());
        state.pressure = Field::from_function(state.pressure.grid(), |x, y| {
            if is_exchanged { pressure(y, x) } else { pressure(x, y) }
        });
        state.shift.zeta = 1.0 + more;
        state
    });
    Estimates::of(states.each_ref(), MeshOrder::Second)
}

#[test]
fn bars_of_exchanged_axes_are_the_same() {
    for is_cap in [true, false] {
        let [one, two] = [false, true].map(|is_exchanged| on_three_grids(is_cap, is_exchanged));
        let bars =
            |all: &Estimates| [all.f_z, all.zeta, all.peak, all.contact_area].map(|of| of.error);
        for (one, two) in bars(&one).iter().zip(bars(&two)) {
            assert!(*one > 0.0 && (one - two).abs() <= 1e-9 * one, "{is_cap}: {one} {two}");
        }
    }
}

/// Shifted and turned states on three grids, in units of length, stress and displacement.
fn in_units([length, stress, moved]: [f64; 3]) -> Estimates {
    let states = [(24, 0.0), (12, 0.003), (6, 0.012)].map(|(cells, more)| {
        let width = length * 2.4 / cells as f64;
        let grid = Grid::new(cells, cells, width, width).unwrap();
        let field = |value: &dyn Fn(f64, f64, f64) -> f64| {
            Field::from_function(grid, |x, y| {
                let (x, y) = (x / length, y / length);
                stress * value(x, y, (1.0 + more - x * x - 0.3 * y * y).max(0.0))
            })
        };
        let mut state = ContactState::apart(grid);
        state.pressure = field(&|_, _, p| p);
        state.traction_x = field(&|x, y, p| p * (0.2 + more + 0.1 * y - 0.05 * x * x));
        state.traction_y = field(&|x, y, p| p * (0.1 - more - 0.15 * x + 0.02 * y));
        state.shift = Shift {
            zeta: moved * (1.0 + more),
            xi: moved * (0.3 - 0.5 * more),
            eta: moved * (0.2 + 0.3 * more),
            omega: moved / length * (0.4 + 2.0 * more),
        };
        state
    });
    Estimates::of(states.each_ref(), MeshOrder::Second)
}

#[test]
fn errors_have_the_units_of_their_values() {
    let [length, stress, moved] = [3.0, 7.0, 0.01];
    let (one, other) = (in_units([1.0; 3]), in_units([length, stress, moved]));
    let (force, area) = (stress * length * length, length * length);
    for (name, one, other, unit) in [
        ("F_x", one.f_x, other.f_x, force),
        ("F_y", one.f_y, other.f_y, force),
        ("F_z", one.f_z, other.f_z, force),
        ("M_z", one.m_z, other.m_z, force * length),
        ("zeta", one.zeta, other.zeta, moved),
        ("xi", one.xi, other.xi, moved),
        ("eta", one.eta, other.eta, moved),
        ("omega", one.omega, other.omega, moved / length),
        ("peak", one.peak, other.peak, stress),
        ("contact area", one.contact_area, other.contact_area, area),
    ] {
        assert!(one.error > 0.0, "{name}");
        for (one, other) in [(one.value, other.value), (one.error, other.error)] {
            assert!((other / unit - one).abs() <= 1e-9 * one.abs(), "{name}: {one} {other}");
        }
    }
}
