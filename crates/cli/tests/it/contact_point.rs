//! The contact point of an impact: given, found by a search, or missing.

use crate::common::pebble::{CASE, GIVEN, all_close, changed, numbers, refused, solved};

#[test]
fn the_contact_point_may_be_given_in_every_way() {
    let found = solved("found", CASE);
    let ways = [
        CASE.to_owned() + "point = [0, 0, 0]\n",
        CASE.to_owned() + "search = \"touch\"\n",
        changed("position = [0, 0, 0.015]\n", "") + "point_1 = [0, 0, -0.015]\n",
        changed("[0, 0, 0.015]", "[-0.6, -0.4, 2.015]") + "search = \"approach\"\n",
        changed("quaternion = [1, 0, 0, 0]", "angles = [0, 0, 0]"),
        changed("shape = \"plane\"", "shape = \"half-space\"\nnormal = [0, 0, 7]"),
    ];
    for (i, way) in ways.iter().enumerate() {
        let record = solved(&format!("way-{i}"), way);
        all_close(&numbers(&record["contact"]["point"]), &[0.0; 3], 1e-12);
        let of = |record: &serde_json::Value| numbers(&record["body_1_velocity"]);
        all_close(&of(&record), &of(&found), 1e-10);
    }
    // Without a place it lies on the plane, and a search for places asks for them.
    let unplaced = changed("position = [0, 0, 0.015]\n", "");
    let of = |record: &serde_json::Value| numbers(&record["body_1_velocity"]);
    all_close(&of(&solved("unplaced", &unplaced)), &of(&found), 1e-12);
    let searched = refused("searched", &(unplaced + "search = \"touch\"\n"));
    assert!(searched.contains("`body_1.position` is missing"), "{searched}");
    // The same body by its curvatures alone: r = A^2/C, B^2/C at the end of axis c.
    let given = CASE
        .replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", GIVEN)
        .replace("position = [0, 0, 0.015]\n", "");
    let record = solved("given", &given);
    let of = |record: &serde_json::Value| numbers(&record["body_1_velocity"]);
    all_close(&of(&record), &of(&found), 1e-10);
}

#[test]
fn what_makes_no_contact_is_refused_with_its_line() {
    for (name, text, line) in [
        ("apart", changed("0.015]\nvel", "0.016]\nvel"), "line 8: `body_1.position`: the bodies do not touch: gap = 1"),
        ("overlap", changed("0.015]\nvel", "0.01]\nvel"), "line 8: `body_1.position`: the bodies do not touch: gap = -4.99"),
        (
            "passing",
            changed("-2]", "2]").replace("0.015]\nvel", "1]\nvel") + "search = \"approach\"\n",
            "line 19: `contact.search`: the bodies do not touch: gap = 9",
        ),
        (
            "off",
            CASE.to_owned() + "point = [0.01, 0, 0]\n",
            "line 19: `contact.point`: body 1: the point (0.01, 0, -0.015) lies",
        ),
        (
            "own-off",
            changed("position = [0, 0, 0.015]\n", "") + "point_1 = [0, 0, -0.014]\n",
            "line 18: `contact.point_1`: body 1: the point (0, 0, -0.014) lies",
        ),
        (
            "other-side",
            changed("position = [0, 0, 0.015]\n", "") + "point_1 = [0, 0, 0.015]\n",
            "line 16: `contact`: the outward normals are 3.14",
        ),
        (
            "conforming",
            CASE.replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", GIVEN)
                .replace("radii = [0.06,", "radii = [-0.06,")
                .replace("position = [0, 0, 0.015]\n", ""),
            "line 3: `body_1.radii`: the surfaces conform or intersect",
        ),
        (
            "line",
            CASE.replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", GIVEN)
                .replace("radii = [0.06,", "radii = [inf,")
                .replace("position = [0, 0, 0.015]\n", ""),
            "line 3: `body_1.radii`: the surfaces touch along a line",
        ),
        (
            "edge",
            changed("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", "shape = \"box\"\nedges = [0.03, 0.03, 0.03]")
                .replace("shape = \"plane\"", "shape = \"sphere\"\nradius = 0.1\nposition = [-0.08571067811865476, 0, -0.07071067811865476]"),
            "line 2: `body_1.shape`: body 1: the point lies on the edge of a box",
        ),
        (
            "torsion",
            changed("quaternion = [1, 0, 0, 0]", "angles = [10, 20, 30]").replace("0.015]\nvel", "0.1]\nvel")
                + "search = \"approach\"\ntorsion = true\n",
            "line 20: `contact.torsion`: torsion: normal and tangential motion are coupled",
        ),
    ] {
        let message = refused(name, &text);
        assert!(message.starts_with(&format!("error: CASE: {line}")), "{name}: {message}");
    }
    assert!(
        refused("hint", &changed("0.015]\nvel", "0.016]\nvel")).contains("search = \"approach\"")
    );
}
