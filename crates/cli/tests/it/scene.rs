//! `carom scene` as a user meets it.

use crate::common::{carom, case, example, fresh, json, refusal};

fn report(case: &str, more: &[&str]) -> serde_json::Value {
    json(&[&["scene", case], more].concat())
}

#[test]
fn the_ball_comes_back_from_under_the_book() {
    let report = report(&example("scene_book.toml"), &["--points", "11"]);
    let bounces = report["bounces"].as_array().unwrap();
    assert_eq!(bounces.len(), 3);
    for (bounce, expected) in bounces.iter().zip([0.54829, -0.05171, -0.17442]) {
        let v = bounce["velocity"][0].as_f64().unwrap();
        assert!((v - expected).abs() < 1e-5, "{v} is not {expected}");
    }
    assert_eq!(bounces[1]["wall"], "book");
    assert_eq!(report["path"].as_array().unwrap().len(), 44);
    assert_eq!(report["ending"], "the time is over");
}

#[test]
fn a_ball_that_falls_away_from_all_walls_is_told() {
    let book = std::fs::read_to_string(example("scene_book.toml")).unwrap();
    let path = fresh("away.toml");
    let [wall, scene] = ["[[wall]]\nname = \"book\"", "[scene]"].map(|at| book.find(at).unwrap());
    let rises = book[scene..].replace("gravity = [0, 0, 0]", "gravity = [0, 0, 9.81]");
    let away = format!("{}{rises}", &book[..wall]);
    std::fs::write(&path, away).unwrap();
    let ending = report(path.to_str().unwrap(), &[])["ending"].to_string();
    assert!(ending.contains("gravity points away from every wall"), "{ending}");
}

#[test]
fn a_superball_hops_to_and_fro_and_loses_energy() {
    let report = report(&example("scene_superball.toml"), &[]);
    let bounces = report["bounces"].as_array().unwrap();
    assert!(bounces.len() >= 4);
    for bounce in bounces {
        let number = |name: &str| bounce[name].as_f64().unwrap();
        let balance = number("energy_before") - number("energy_after");
        assert!(number("energy_dissipated") >= 0.0);
        assert!((balance - number("energy_dissipated")).abs() < 1e-12 * number("energy_before"));
    }
}

#[test]
fn a_golf_ball_comes_to_rest_and_its_energy_is_booked() {
    let golf = std::fs::read_to_string(example("scene_golf_ball.toml")).unwrap();
    // Without coupling the material alone takes a part of the normal velocity. Coupling turns a little of it into
    // heat of slip, and makes the contact stiffer, so that the viscous material takes more: less is left.
    let neglected = golf.replace("[scene]", "[scene]\nlaw = \"coulomb\"");
    it_comes_to_rest(&golf, "rings", 2e-3);
    it_comes_to_rest(&neglected, "uncoupled", 1e-12);
}

fn it_comes_to_rest(case: &str, method: &str, coupling: f64) {
    let path = fresh("golf.toml");
    std::fs::write(&path, case).unwrap();
    let report = report(path.to_str().unwrap(), &[]);
    let bounces = report["bounces"].as_array().unwrap();
    assert!(bounces.len() > 8);
    // It no longer rises, and rolls on.
    assert_eq!(report["ending"], "the time is over");
    let events = report["events"].as_array().unwrap();
    let [.., rolls, _] = &events[..] else { panic!("{events:?}") };
    assert_eq!((&rolls["event"], &rolls["wall"]), (&"rolls".into(), &"floor".into()));
    for bounce in bounces {
        let number = |name: &str| bounce[name].as_f64().unwrap();
        let normal = |name: &str| bounce[name][2].as_f64().unwrap();
        assert_eq!(bounce["method"], method);
        let warns = bounce["warnings"].to_string().contains("dissimilar materials");
        assert_eq!(warns, method == "uncoupled");
        if bounce["wall"] == "floor" {
            // Straight between 0.8 at 1 m/s and 0.74 at 5 m/s.
            let speed = -normal("velocity_before");
            let e = 0.8 - 0.06 * (speed - 1.0).clamp(0.0, 4.0) / 4.0;
            let taken = e - normal("velocity") / speed;
            assert!(taken > -1e-12 && taken < coupling, "{taken}");
        }
        let taken = number("energy_dissipated") + number("energy_lost");
        let balance = number("energy_before") - number("energy_after") - taken;
        assert!(number("energy_lost") > 0.0);
        assert!(balance.abs() < 1e-12 * number("energy_before"));
    }
}

#[test]
fn bad_scenes_end_with_code_2_and_write_nothing() {
    let book = std::fs::read_to_string(example("scene_book.toml")).unwrap();
    for (old, new, expected) in [
        (
            "start = [-0.06, 0, 0.09]",
            "start = [-0.06, 0, 0.02]",
            "`scene.start` = [-0.06, 0, 0.02] is not allowed: must be at least the radius 0.022 from \
             every wall: the ball starts inside table, by 2.000e-3 m",
        ),
        ("gravity = [0, 0, 0]", "gravity = [0, 0, nan]", "`scene.gravity.z` = NaN is out of range"),
        ("gravity = ", "gravty = ", "did you mean `gravity`?"),
        ("friction = 0.3", "friction = -1", "`wall[0].friction` = -1 is out of range"),
        (
            "friction = 0.3",
            "friction = 0.3\nnormal_restitution = 1.2",
            "`wall[0].normal_restitution` = 1.2 is out of range",
        ),
        ("along = [1, 0, 0]", "along = [0, 0, 2]", "`wall[1].along`"),
        ("width = 0.17", "", "`wall[1].width` is missing"),
        ("normal = [0, 0, 1]", "normal = [0, 0, 0]", "`wall[0].normal` = 0 is out of range"),
        ("length = 0.24", "length = 0", "line 27: `wall[1].length` = 0 is out of range"),
        ("time = 0.28", "time = inf", "`scene.time` = inf is out of range"),
        ("bounces = 10", "bounces = 0.5", "a whole number from 1"),
        ("young_modulus = 20e6, poisson = 0.5", "rigid = true", "wall 0: shear_modulus = inf"),
        ("density = 1000", "mass = inf", "`ball.mass` = inf is out of range"),
        ("density = 1000", "fixed = true", "unknown field `ball.fixed`"),
        ("density = 1000", "mass = 1\nposition = [0, 0, 1]", "excludes `scene.start`: give one"),
        ("start = [-0.06, 0, 0.09]", "", "`scene.start` is missing"),
        (
            "shape = \"sphere\"\nradius = 0.022",
            "shape = \"ellipsoid\"\nsemi_axes = [1, 1, 1]",
            "`ball.shape` = \"ellipsoid\" is not allowed: must be \"sphere\" (a scene computes",
        ),
        (
            "density = 1000",
            "mass = 1\ninertia = [1, 1, 2]",
            "`ball.inertia` = 2 is out of range: must be the same about all axes of a ball",
        ),
    ] {
        assert!(book.contains(old), "{old}");
        let case = fresh("bad-scene.toml");
        std::fs::write(&case, book.replacen(old, new, 1)).unwrap();
        let plot = fresh("bad-scene.svg");
        let (case, drawn) = (case.to_str().unwrap(), plot.to_str().unwrap());
        let stderr = refusal(&["scene", case, "--plot", drawn]);
        assert!(stderr.contains(expected), "{stderr}");
        assert!(!plot.exists());
    }
}

/// A steel ball that first touches a wall gently and then falls on the floor: bounces are counted from 1.
#[test]
fn a_warning_names_the_bounce_that_it_concerns() {
    const TEXT: &str = "\
[ball]
shape = \"sphere\"
radius = \"5 mm\"
density = 7850
material = { young_modulus = \"208 GPa\", poisson = 0.3, yield_stress = \"300 MPa\" }
velocity = [\"0.1 mm/s\", 0, 0]
[[wall]]
point = [\"5.00001 mm\", 0, 0]
normal = [-1, 0, 0]
material = { rigid = true }
friction = 0.1
[[wall]]
point = [0, 0, 0]
normal = [0, 0, 1]
material = { rigid = true }
friction = 0.1
[scene]
start = [0, 0, 2]
gravity = [0, 0, -9.81]
time = 1
";
    let output = carom(&["scene", &case("named-bounce.toml", TEXT)]);
    let told = String::from_utf8(output.stderr).unwrap();
    let (yields, waves) = told.split_once("elastic waves").unwrap();
    for one in [yields, waves] {
        assert!(one.contains("(1 of 2 bounces concerned, the worst at bounce 2)"), "{told}");
    }
}

#[test]
fn a_place_has_three_columns() {
    let table = ["--events", "--format", "csv", "--columns", "position"];
    let output = carom(&[&["scene", &example("scene_superball.toml")][..], &table].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("position_x,position_y,position_z\n"), "{text}");
}
