//! `carom solve`: the path between two steps, and the position of the cells of a grid.

use crate::common::{case, close, folder, stdout};
use std::collections::BTreeMap;
use std::path::Path;

/// Numbers of an archive of NumPy arrays without compression, with their shapes.
fn arrays(path: &Path) -> BTreeMap<String, (String, Vec<f64>)> {
    let bytes = std::fs::read(path).unwrap();
    let mut rest = &bytes[..];
    let mut arrays = BTreeMap::new();
    while rest.starts_with(b"PK\x03\x04") {
        let size = u32::from_le_bytes(rest[18..22].try_into().unwrap()) as usize;
        let length = u16::from_le_bytes(rest[26..28].try_into().unwrap()) as usize;
        let text = String::from_utf8(rest[30..30 + length].to_vec()).unwrap();
        let data = &rest[30 + length..30 + length + size];
        let head = u16::from_le_bytes(data[8..10].try_into().unwrap()) as usize;
        let words = String::from_utf8(data[10..10 + head].to_vec()).unwrap();
        let shape = words.split_once("'shape': ").unwrap().1.split_once(')').unwrap().0;
        let values = &data[10 + head..];
        let numbers = if words.contains("<f8") {
            values.chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
        } else {
            values.iter().map(|byte| f64::from(*byte)).collect()
        };
        let name = text.strip_suffix(".npy").unwrap().to_owned();
        arrays.insert(name, (shape.replace(['(', ' '], ""), numbers));
        rest = &rest[30 + length + size..];
    }
    arrays
}

fn steps(arguments: &[&str]) -> Vec<serde_json::Value> {
    let arguments = [&["solve"], arguments, &["--format", "json"]].concat();
    serde_json::from_str(&stdout(&arguments)).unwrap()
}

const BALL: &str = r#"
[body_1]
material = { shear_modulus = "1 MPa", poisson = 0.5 }
[body_2]
material = { rigid = true }
[gap]
shape = "paraboloid"
radii = ["20 mm", "15 mm"]
[grid]
cells = [24, 20]
size = ["6 mm", "5 mm"]
[contact]
friction = 0.6
"#;

/// A leg of several parts goes straight from what was to what is given, in each load and each shift.
#[test]
fn loads_and_shifts_go_to_their_ends_in_equal_parts() {
    let names = ["zeta", "xi", "eta", "omega", "F_z", "F_x", "F_y", "M_z"];
    // Three ends: by loads, by loads, by shifts; and by loads again.
    let ends = [
        ("F_z F_x F_y M_z", [3.0, 0.2, -0.1, 0.3e-3], 1),
        ("F_z F_x F_y M_z", [2.6, -0.3, 0.2, 0.1e-3], 4),
        ("zeta xi eta omega", [0.22e-3, 20e-6, -15e-6, 4e-3], 3),
        ("zeta xi eta omega", [0.20e-3, -10e-6, 25e-6, -3e-3], 2),
        ("F_z xi F_y omega", [3.0, 0.0, 0.1, 1e-3], 4),
        ("zeta F_x eta M_z", [0.2e-3, 0.15, 0.0, -0.2e-3], 5),
    ];
    let mut text = BALL.to_owned();
    for (given, values, count) in ends {
        text += "[[step]]\n";
        for (name, value) in given.split(' ').zip(values) {
            text += &format!("{name} = {value}\n");
        }
        text += &format!("count = {count}\n");
    }
    let rows = steps(&[&case("solve_parts.toml", &text)]);
    assert_eq!(rows.len(), 19);
    let at = |row: &serde_json::Value, name: &str| row[name].as_f64().unwrap();
    let mut last = 0;
    let mut begin: BTreeMap<&str, f64> = names.iter().map(|name| (*name, 0.0)).collect();
    for (given, values, count) in ends {
        for part in 1..=count {
            let row = &rows[last + part - 1];
            for (name, end) in given.split(' ').zip(values) {
                let expected = begin[name] + part as f64 / count as f64 * (end - begin[name]);
                let got = at(row, name);
                let scale = end.abs().max(begin[name].abs());
                assert!((got - expected).abs() < 1e-6 * scale, "{name} {part}: {got} {expected}");
            }
        }
        last += count;
        begin = names.iter().map(|name| (*name, at(&rows[last - 1], name))).collect();
    }
}

/// What a step does not name stays as it was given: a load as a load, a shift as a shift.
#[test]
fn what_a_step_does_not_name_stays() {
    let text = format!(
        "{BALL}[[step]]\nF_z = 3\n[[step]]\nF_x = 0.2\nM_z = 2e-4\n[[step]]\neta = 2e-5\n\
         [[step]]\nF_z = 2\ncount = 2\n[[step]]\nzeta = 2e-4\n[[step]]\nF_y = 0.1\n"
    );
    let rows = steps(&[&case("solve_stays.toml", &text)]);
    for row in &rows[1..] {
        close(&row["F_x"], 0.2, 1e-7);
        close(&row["M_z"], 2e-4, 1e-9);
    }
    for row in &rows[2..6] {
        close(&row["eta"], 2e-5, 1e-12);
    }
    for (row, force) in rows.iter().zip([3.0, 3.0, 3.0, 2.5, 2.0]) {
        close(&row["F_z"], force, 1e-6);
    }
    for row in &rows[5..] {
        close(&row["zeta"], 2e-4, 1e-12);
    }
}

/// A flat punch far from the origin, on rubber: tractions are symmetric about its middle, so that the torque
/// about the origin is that of the forces there.
#[test]
fn a_punch_beside_the_origin_stands_where_it_is() {
    let (left, right, lower, upper) = (1e-3, 3e-3, 2.4e-3, 3.4e-3);
    let text = format!(
        r#"
[body_1]
material = {{ shear_modulus = "1 MPa", poisson = 0.5 }}
[body_2]
material = {{ rigid = true }}
[gap]
shape = "polygon"
corners = [[{left}, {lower}], [{right}, {lower}], [{right}, {upper}], [{left}, {upper}]]
[grid]
accuracy = 0.05
[contact]
friction = 0.5
[[step]]
zeta = "50 um"
[[step]]
F_x = 0.03
F_y = -0.02
"#
    );
    let kept = folder();
    let name = case("solve_beside.toml", &text);
    let rows = steps(&[&name, "--keep", kept.to_str().unwrap()]);
    let of = |name: &str| rows[1][name].as_f64().unwrap();
    let [x, y] = [0.5 * (left + right), 0.5 * (lower + upper)];
    let torque = y * 0.03 + x * 0.02;
    close(&rows[1]["F_x"], 0.03, 1e-7);
    close(&rows[1]["M_z"], torque, 1e-3 * torque);
    let kept = arrays(&kept.join("step-000002.npz"));
    let (x_at, y_at) = (&kept["x"].1, &kept["y"].1);
    let shape = format!("{},{},", y_at.len(), x_at.len());
    let cells = &kept["cells"].1;
    let area = (x_at[1] - x_at[0]) * (y_at[1] - y_at[0]);
    let fields = ["pressure", "traction_x", "traction_y"].map(|name| {
        assert_eq!(kept[name].0, shape);
        &kept[name].1
    });
    let [mut force, mut f_x, mut f_y, mut m_x, mut m_y, mut m_z] = [0.0; 6];
    for (i, cell) in cells.iter().enumerate() {
        let (at_x, at_y) = (x_at[i % x_at.len()], y_at[i / x_at.len()]);
        let inside = left < at_x && at_x < right && lower < at_y && at_y < upper;
        assert_eq!(*cell > 0.0, inside, "{at_x} {at_y}");
        let [p, t_x, t_y] = fields.map(|field| area * field[i]);
        force += p;
        f_x += t_x;
        f_y += t_y;
        m_x += p * at_x;
        m_y += p * at_y;
        m_z += at_y * t_x - at_x * t_y;
    }
    for (name, sum) in [("F_z", force), ("F_x", f_x), ("F_y", f_y), ("M_z", m_z)] {
        close(&rows[1][name], sum, 1e-9 * of("F_z"));
    }
    // The grid is not symmetric about the punch: to within a cell.
    let cell = x_at[1] - x_at[0];
    let off = [m_x / force - x, m_y / force - y];
    assert!(off.iter().all(|off| off.abs() < cell), "{off:?}");
}
