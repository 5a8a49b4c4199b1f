//! Wrong data and cases: each error names what is wrong and the way out.

use crate::common::{BOTH, alumina, fitted};
use carom_cases::input::CaseFile;
use carom_fit::{Data, FitError, Options, fit};

fn error(case: &CaseFile, text: &str) -> String {
    let data = Data::from_csv(text);
    let found = data.and_then(|data| fitted(case, &data, None));
    let error = found.unwrap_err();
    assert!(error.is_bad_input(), "{error}");
    error.to_string()
}

#[test]
fn wrong_data_are_told() {
    let case = alumina(BOTH);
    for (text, told) in [
        ("", "no line of headings"),
        ("angle,R_x\n", "there is no row"),
        ("angle,R_x\n10,0.3\n", "1 measured values cannot determine 2 unknowns"),
        (
            "angle,R_x\n10,NaN\n20,0.2\n",
            "column `R_x` of the data, row 1: \"NaN\" must be a finite number",
        ),
        ("angle,R_x\n10,inf\n20,0.2\n", "must be a finite number"),
        ("angle;R_x\n10;0,3\n20;0,2\n", "\"0,3\" must be a number with a point: 0.3"),
        ("angle,R_x\n10,0.1\n95,0.2\n", "column `angle` of the data, row 2: 95 must be in [0, 90]"),
        ("angle,R_x\n10,0.1\n,0.2\n", "row 2: a missing number (NaN) must be a finite number"),
        (
            "angle (kg),R_x\n10,0.1\n20,0.2\n",
            "column `angle` of the data: its unit `kg` is none of it; it is in deg",
        ),
        ("angle,R_x (m)\n10,0.1\n20,0.2\n", "its unit `m` is none of a pure number"),
        ("angel,R_x\n10,0.1\n20,0.2\n", "did you mean `angle`?"),
        (
            "angle,body_1_spin\n10,0.1\n20,0.2\n",
            "column `body_1_spin` of the data: not a quantity, did you mean `body_1_spin_",
        ),
        (
            "angle,other\n10,0.1\n20,0.2\n",
            "no column is a measured quantity; the columns are `angle`, `other`",
        ),
        (
            "body_2.velocity.x,R_x\n10,0.1\n20,0.2\n",
            "column `body_2.velocity.x` of the data: `body_2.velocity.x` is missing",
        ),
        ("body_1.colour,R_x\n10,0.1\n20,0.2\n", "no number of the case has this name"),
        (
            "angle,R_x,R_x_sd\n10,0.1,0\n20,0.2,0.1\n",
            "column `R_x_sd` of the data, row 1: 0 must be a standard error",
        ),
        ("angle,R_x,R_x_sd\n10,0.1,\n20,0.2,0.1\n", "row 1: no number must be a standard error"),
        (
            "angle,R_x,body_1_spin_y_sd\n10,0.1,1\n20,0.2,1\n",
            "there is no column `body_1_spin_y` whose errors",
        ),
        ("angle,R_x,R_x\n10,0.1,1\n20,0.2,1\n", "column `R_x` of the data: it stands twice"),
        ("angle,R_x\n10,0.1,3\n", "line 2 has 3 entries, the headings are 2; with decimal commas"),
        ("10,0.3\n20,0.2\n", "has numbers: headings are missing, as in \"angle (deg),R_x\""),
        ("shape = \"sphere\"\n", "the case comes first, then the data"),
        (
            "angle,R_x\n10,0.1\n20,1e300\n30,0.2\n",
            "column `R_x` of the data, row 2: 1e300 must be at most 1e100 in size",
        ),
        ("angle,R_x,R_x_sd\n10,0.1,0.1\n20,0.2,1e-200\n", "row 2: 0.2 must be at most 1e100"),
        (
            "angle,approach.angle,R_x\n10,10,0.1\n20,20,0.2\n",
            "the column `approach.angle` gives `approach.angle`, which another column gives too",
        ),
    ] {
        let found = error(&case, text);
        assert!(found.contains(told), "{text}: {found}");
    }
}

#[test]
fn wrong_cases_are_told() {
    let data = "angle,R_x\n10,0.1\n20,0.2\n30,0.1\n";
    for (contact, told) in [
        ("friction = 0.1", "the case has no unknown"),
        ("friction = { fit = [0.3, 0.1] }", "[low, high] with low < high"),
        ("friction = { fit = [-1, 1] }", "`contact.friction` = -1 is out of range"),
        ("friction = { fit = [0.1] }", "two numbers [low, high]"),
        ("friction = { prior = { mean = 0.1, sd = 0 } }", "must be from 1e-12 to 1e6 times"),
        ("friction = { fit = [0.1, 1], prior = { mean = 0.1, sd = 0.1 } }", "give one of them"),
        (
            "friction = { fit = [0.1, 1] }\nnormal_restitution = [0.8, 0.9]",
            "`contact.normal_restitution` is a sweep",
        ),
        (
            "friction = { fit = [0.3, 0.5] }\nstatic_friction = { fit = [0.1, 0.2] }",
            "at least the coefficient of kinetic friction, `contact.friction` = { fit = [0.3, 0.5] }",
        ),
        (
            "friction = { fit = [0.01, 0.5] }\nstatic_friction = { fit = [0.02, 0.6] }",
            "`contact.friction` from 0.01 to 0.5 and `contact.static_friction` from 0.02 to 0.6 allow values",
        ),
        ("friction = 0.1\nlaw = { fit = [1, 2] }", "`contact.law`"),
        (
            "friction = { fit = [0.1, 1] }\nlaw = \"rings\"\nnormal_over_tangential_stiffness = 1.2",
            "this law has the stiffness of the materials",
        ),
    ] {
        let found = error(&alumina(contact), data);
        assert!(found.contains(told), "{contact}: {found}");
    }
    let scene = CaseFile::from_text(carom_cases::case::CaseKind::Scene.template());
    assert!(error(&scene, data).contains("a case for `carom scene` cannot be fitted"));
    let none = error(&CaseFile::from_text("a = 1\n"), data);
    assert!(none.contains("`body_1` is missing") && !none.contains("cannot be fitted"), "{none}");
}

/// Angles in radians without a unit are fitted as degrees, and warned of.
#[test]
fn unusual_inputs_are_warned_of() {
    let case = alumina(BOTH);
    let warned = |text: &str| {
        let warnings = fitted(&case, &Data::from_csv(text).unwrap(), None).unwrap().warnings;
        warnings.iter().any(|told| {
            told.contains("column `angle` = 0.1 is unusual: it is in degrees")
                && told.contains("(rad)")
        })
    };
    assert!(warned("angle,R_x\n0.1,0.2\n0.3,0.1\n0.5,0.3\n0.7,0.3\n"));
    assert!(!warned("angle (rad),R_x\n0.1,0.2\n0.3,0.1\n0.5,0.3\n0.7,0.3\n"));
}

#[test]
fn bodies_that_do_not_meet_are_told_with_their_row() {
    let case = CaseFile::from_text(alumina(BOTH).text().replace("[approach]", "[approach_of_old]"));
    assert!(matches!(
        fitted(&case, &Data::from_csv("R_x\n1\n2\n3\n").unwrap(), None),
        Err(FitError::Case(_))
    ));
    let own =
        alumina(BOTH).text().replace("density = 4000", "density = 4000\nvelocity = [1, 0, -1]");
    let own = CaseFile::from_text(
        own.replace("[approach]\n         speed = 3.9\n         angle = 45\n", ""),
    );
    let text = "body_1.velocity.z,R_x\n-1,0.1\n2,0.2\n-1,0.1\n";
    let found = error(&own, text);
    assert!(found.contains("row 2 of the data: the bodies do not approach"), "{found}");
}

#[test]
fn an_error_of_several_quantities_needs_a_name() {
    let data = Data::from_csv("angle,R_x,slip_after\n10,0.1,1\n20,0.2,1\n").unwrap();
    let run = |errors: &[carom_fit::GivenError]| {
        let options = Options { errors, ..Options::default() };
        fit(&alumina(BOTH), &data, &options).unwrap_err().to_string()
    };
    assert!(run(&[(None, vec![0.1])]).contains("needs its quantity: R_x, slip_after"));
    assert!(
        run(&[(Some("duration".to_owned()), vec![0.1])]).contains("the data have no such column")
    );
    let named = |unit: &str| (Some(format!("slip_after{unit}")), vec![0.1]);
    assert!(
        run(&[named(" (kg)")]).contains("`slip_after` of the data: its unit `kg` is none of it")
    );
    assert!(run(&[named(""), named(" (mm/s)")]).contains("`slip_after` are given twice: give"));
    let data = Data::from_csv("angle,R_x,R_x_sd\n10,0.1,1\n20,0.2,1\n").unwrap();
    let told = fitted(&alumina(BOTH), &data, Some(0.1)).unwrap_err().to_string();
    assert!(told.contains("`R_x` are given twice, as `sd` and by the column `R_x_sd`"), "{told}");
}

#[test]
fn files_of_other_programs_are_read() {
    // A mark at the beginning, comments, semicolons, blanks, units in brackets.
    let text = "\u{feff}# a comment, with a comma\nangle [deg] ; R_x\n 10 ; 0.3 \n# another\n20;\n";
    let data = Data::from_csv(text).unwrap();
    assert_eq!((data.rows(), data.columns()[0].unit.as_str()), (2, "deg"));
    assert_eq!(data.columns()[1].values[0], 0.3);
    assert!(data.columns()[1].values[1].is_nan());
}
