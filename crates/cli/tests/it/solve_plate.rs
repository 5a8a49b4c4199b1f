//! `carom solve` on a plate.

use crate::common::{carom, case, close, example, json, refusal};

/// A rigid sphere on a square plate of side and stiffness E* = 1, a tenth as thick.
fn sphere(plate: &str, grid: &str, step: &str) -> String {
    format!(
        "[body_1]\nmaterial = {{ rigid = true }}\n\
         [body_2]\nmaterial = {{ young_modulus = 0.91, poisson = 0.3 }}\n\
         [bodies]\nplate = {{ {plate} }}\n\
         [gap]\nshape = \"paraboloid\"\nradii = [1, 1]\n\
         [grid]\n{grid}\n[contact]\nfriction = 0\n[[step]]\n{step}\n"
    )
}

const PLATE: &str = "a = 1, b = 1, thickness = 0.1";

fn grid(cells: usize) -> String {
    format!("cells = [{cells}, {cells}]\nsize = [1, 1]")
}

fn solved(name: &str, text: &str, more: &[&str]) -> serde_json::Value {
    json(&[&["solve", &case(name, text)], more].concat())[0].clone()
}

/// Values of an independent program with a dense matrix.
#[test]
fn forces_are_those_of_an_independent_solution() {
    for (theory, cells, force) in [
        ("layer", 24, 1.995_014_292_0e-4),
        ("layer", 48, 1.992_266_529_8e-4),
        ("kirchhoff", 24, 2.173_990_385_3e-4),
    ] {
        let plate = format!("{PLATE}, theory = \"{theory}\"");
        let text = sphere(&plate, &grid(cells), "zeta = 0.03");
        close(&solved("plate.toml", &text, &[])["F_z"], force, 1e-9 * force);
        let text = sphere(&plate, &grid(cells), &format!("F_z = {force}"));
        close(&solved("plate_by_force.toml", &text, &[])["zeta"], 0.03, 1e-9);
    }
}

#[test]
fn estimated_errors_hold_where_the_cells_are_nested() {
    let found = solved("plate_48.toml", &sphere(PLATE, &grid(48), "zeta = 0.03"), &[]);
    // On 96 x 96 cells.
    let (force, error) = (1.990_149_022e-4, found["F_z_error"].as_f64().unwrap());
    assert!(error < 0.02 * force, "{error}");
    close(&found["F_z"], force, 2.0 * error);
    let text = case("plate_50.toml", &sphere(PLATE, &grid(50), "zeta = 0.03"));
    let output = carom(&["solve", &text, "--format", "csv"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("`grid.cells` must be divisible by 4"), "{said}");
}

#[test]
fn an_accuracy_chooses_the_cells_of_the_plate() {
    let text = sphere(PLATE, "accuracy = 1e-2", "zeta = 0.03");
    let found = solved("plate_to_accuracy.toml", &text, &[]);
    close(&found["F_z"], 1.99e-4, 2e-6);
    assert!(found["F_z_error"].as_f64().unwrap() < 2e-6);
}

#[test]
fn what_a_plate_cannot_be_is_refused_by_name() {
    let step = "zeta = 0.03";
    let with = |from: &str, to: &str| sphere(PLATE, &grid(24), step).replace(from, to);
    for (text, parts) in [
        (
            with("thickness = 0.1", "thickness = 1e-7"),
            vec!["`bodies.plate.thickness` = 1e-7", "1e-6 of the longer side"],
        ),
        (with("size = [1, 1]", "size = [1, 0.9]"), vec!["`grid.size` = 0.9", "[1, 1]", "covers"]),
        (with("a = 1,", "a = -1,"), vec!["`bodies.plate.a` = -1", "> 0"]),
        (
            with("size = [1, 1]", "size = [1, 1]\nperiodic = true"),
            vec!["`grid.periodic`", "`bodies.plate`", "period"],
        ),
        (with("size = [1, 1]", "size = [1, 1]\ncut = true"), vec!["`grid.cut`", "`bodies.plate`"]),
        (
            with("friction = 0", "friction = 0.3"),
            vec!["`contact.friction` = 0.3", "must be 0 beside `bodies.plate`"],
        ),
        (
            with("friction = 0", "friction = 0\nstatic_friction = 0.4"),
            vec!["`contact.static_friction` = 0.4", "must be 0"],
        ),
        (
            with("friction = 0", "friction = 0\nmethod = \"kombi\""),
            vec!["`contact.method`", "`bodies.plate`"],
        ),
        (
            with("{ young_modulus = 0.91, poisson = 0.3 }", "{ rigid = true }").replacen(
                "{ rigid = true }",
                "{ young_modulus = 1, poisson = 0.3 }",
                1,
            ),
            vec!["`bodies.plate`", "`body_2.material`", "elastic"],
        ),
        (
            with("thickness = 0.1", "thickness = 0.1, theory = \"reissner\""),
            vec!["`bodies.plate.theory`", "\"layer\"", "\"mindlin\""],
        ),
        (with("zeta = 0.03", "zeta = 0.4"), vec!["step 1", "left border", "held"]),
        (
            with("zeta = 0.03", "zeta = 0.03\nF_x = 1e-5"),
            vec!["step 1", "F_x", "0 without friction"],
        ),
    ] {
        let said = refusal(&["solve", &case("plate_bad.toml", &text)]);
        for part in parts {
            assert!(said.contains(part), "{said} lacks {part}");
        }
    }
    for request in [&["solve", "--depths", "5"][..], &["compare"]] {
        let name = example("solve_plate.toml");
        let said = refusal(&[&request[..1], &[name.as_str()], &request[1..]].concat());
        assert!(said.contains("bodies.plate"), "{said}");
    }
}

/// The warning names the first step in which the plate is bent by more than half its thickness, also if a later
/// one unloads it.
#[test]
fn a_plate_that_is_bent_too_far_is_warned_about() {
    let said = |steps: &str| {
        let text = case("plate_bent.toml", &sphere(PLATE, &grid(24), steps));
        let output = carom(&["solve", &text]);
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let bent = said("zeta = 0.04\n[[step]]\nzeta = 0.06\n[[step]]\nzeta = 0.01");
    assert!(
        bent.contains("step 2: the displacement 0.0") && bent.contains("exceeds 0.05"),
        "{bent}"
    );
    assert!(!said("zeta = 0.04").contains("displacement"));
}

/// Under small loads Hertz, under large ones the force on the middle of Navier's plate beside it.
#[test]
fn the_pane_of_the_example_lies_between_hertz_and_bending() {
    let steps = json(&["solve", &example("solve_plate.toml")]);
    let modulus = 1.0 / ((1.0 - 0.3 * 0.3) / 208e9 + (1.0 - 0.22 * 0.22) / 70e9);
    let stiffness = 70e9 * 8e-9 / (12.0 * (1.0 - 0.22 * 0.22));
    for step in steps.as_array().unwrap() {
        let (force, zeta) = (step["F_z"].as_f64().unwrap(), step["zeta"].as_f64().unwrap());
        let hertz = (0.75 * force / modulus / f64::sqrt(0.05)).powf(2.0 / 3.0);
        let bending = 0.01160 * force * 0.02 * 0.02 / stiffness;
        assert!(
            zeta > bending.max(hertz) && (zeta / (hertz + bending) - 1.0).abs() < 0.05,
            "{step}"
        );
    }
}
