//! Comparison with an independent program on the same discretisation, element by element.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Gap, Method as _};
use serde_json::Value;

fn cases() -> Value {
    serde_json::from_str(include_str!("../data/same_grid.json")).unwrap()
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap()
}

fn material(value: &Value) -> Material {
    Material::from_shear(number(value, "G"), number(value, "nu")).unwrap()
}

fn grid(inputs: &Value) -> Grid {
    let grid = &inputs["grid"];
    let count = |key: &str| grid[key].as_u64().unwrap() as usize;
    Grid::new(count("columns"), count("rows"), number(grid, "dx"), number(grid, "dy")).unwrap()
}

fn follow(case: &str, gap: impl Fn(f64, f64) -> f64) {
    let all = cases();
    let (inputs, steps) = (&all["cases"][case]["inputs"], &all["cases"][case]["steps"]);
    let (grid, f) = (grid(inputs), number(inputs, "friction"));
    let pair = MaterialPair::new(material(&inputs["body1"]), material(&inputs["body2"])).unwrap();
    let gap = Gap::from_function(grid, gap).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(f).unwrap()).unwrap();
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(grid);
    let mut shift = Shift::default();
    for step in steps.as_array().unwrap() {
        shift.zeta = number(step, "approach_given");
        shift.xi += number(step, "dxi");
        shift.eta += number(step, "deta");
        shift.omega += number(step, "dOmega");
        let before = state.clone();
        let drive = Drive::by_shift(shift);
        let went =
            method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ()).unwrap();
        println!("{case} {}: {:?}", step["step"], went);
        let counts = [
            (CellState::Stick, "n_stick"),
            (CellState::Slip, "n_slip"),
            (CellState::Exterior, "n_exterior"),
        ];
        for (kind, key) in counts {
            assert_eq!(state.count(kind) as u64, step[key].as_u64().unwrap(), "{case} {step}");
        }
        let load = state.load();
        let limit = f * load.f_z;
        for (got, key) in [(load.f_x, "Fx"), (load.f_y, "Fy"), (f * load.f_z, "Fz")] {
            let want = number(step, key) * if key == "Fz" { f } else { 1.0 };
            assert!((got - want).abs() < 1e-6 * limit, "{case} {key} {got} {want}");
        }
        assert!((load.m_z + number(step, "Mz")).abs() < 1e-6 * limit, "{case} Mz {}", load.m_z);
        let top = state.pressure.values().iter().copied().fold(0.0, f64::max);
        let moved = |now: &[f64], old: &[f64], cell: usize| now[cell] - old[cell];
        for probe in step["probes"].as_array().unwrap() {
            let cell = probe["element"].as_u64().unwrap() as usize - 1;
            let tractions = [
                (state.traction_x.values()[cell], "px"),
                (state.traction_y.values()[cell], "py"),
                (f * state.pressure.values()[cell], "pn"),
            ];
            for (got, key) in tractions {
                let want = number(probe, key) * if key == "pn" { f } else { 1.0 };
                assert!((got - want).abs() < 5e-6 * f * top, "{case} {probe} {got}");
            }
            let displacements =
                [(state.displacement_x.values(), "ux"), (state.displacement_y.values(), "uy")];
            for (got, key) in displacements {
                assert!((got[cell] - number(probe, key)).abs() < 2e-8, "{case} {probe}");
            }
            // Displacement relative to the rigid step is slip.
            let (x, y) = grid.centres().nth(cell).unwrap();
            let turn = number(step, "dOmega");
            let rigid = [number(step, "dxi") + y * turn, number(step, "deta") - x * turn];
            let u = moved(state.displacement_x.values(), before.displacement_x.values(), cell);
            let v = moved(state.displacement_y.values(), before.displacement_y.values(), cell);
            let slip = (u - rigid[0]).hypot(v - rigid[1]);
            assert!((slip - number(probe, "slip")).abs() < 2e-8, "{case} {probe} {slip}");
        }
    }
}

#[test]
fn a_sphere_shifted_and_shifted_back() {
    follow("c1", |x, y| 0.005 * (x * x + y * y));
}

#[test]
fn a_flat_punch_shifted_and_twisted() {
    follow("c6b", |x, y| if x * x + y * y < 1.0 { 0.0 } else { f64::INFINITY });
}
