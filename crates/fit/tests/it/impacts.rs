//! The table of a fit against impacts that are solved one by one, and unknowns that are no number of the contact.

use crate::common::{alumina, ball, close, fitted, of};
use carom_cases::case::{Case as _, ImpactFile};
use carom_cases::impact::outcome;
use carom_cases::input::CaseFile;
use carom_fit::Data;

/// Outcomes of the case without unknowns, by the command's own way.
fn outcomes(contact: &str, angles: &[f64]) -> Vec<[f64; 3]> {
    let solve = |angle: &f64| {
        let text = alumina(contact).text().replace("angle = 45", &format!("angle = {angle}"));
        let file = ImpactFile::parse(&text).unwrap();
        let outcome = outcome(file.nominal()).unwrap();
        let motion = outcome.motions()[0];
        [motion.velocity.x, motion.velocity.z, motion.spin.y]
    };
    angles.iter().map(solve).collect()
}

#[test]
fn the_table_has_the_motions_of_the_solver() {
    let angles = [2.0, 10.0, 25.0, 60.0];
    for (own, tolerance) in [
        ("friction = 0.1\nnormal_over_tangential_stiffness = 1.2", 1e-7),
        (
            "friction = 0.1\nnormal_over_tangential_stiffness = 1.2\nnormal_restitution = 0.8\nloss = \"yield\"",
            1e-7,
        ),
        ("friction = 0.1\nnormal_over_tangential_stiffness = 1.2\nnormal_restitution = 0.8", 3e-3),
    ] {
        let expected = outcomes(own, &angles);
        let column = |k: usize| expected.iter().map(|one| one[k]).collect::<Vec<f64>>();
        let names = ["body_1_velocity_x", "body_1_velocity_z", "body_1_spin_y"];
        let mut columns = vec![("angle".to_owned(), angles.to_vec())];
        columns.extend(names.iter().enumerate().map(|(k, name)| ((*name).to_owned(), column(k))));
        let unknown = own.replace("friction = 0.1", "friction = { fit = [0.01, 1] }");
        let fit = fitted(&alumina(&unknown), &Data::new(columns).unwrap(), None).unwrap();
        close(of(&fit, "friction").value, 0.1, 0.1 * f64::max(tolerance, 1e-6));
        for point in &fit.points {
            let size = if point.quantity.contains("spin") { 400.0 } else { 4.0 };
            close(point.fitted, point.measured, size * tolerance);
        }
    }
}

/// Friction changes the velocity of a sliding ball by f (1 + e) v_n and its slip by 7/2 of it; with backspin that turns the
/// ball of a steep impact back. So it does on a wall whose normal is +x.
#[test]
fn sliding_balls_with_backspin_rebound_at_the_angles_of_the_formula() {
    let (speed, spin, f, e) = (3.9, 3000.0, 0.1, 0.8);
    let angles = [2.0, 5.0, 40.0_f64];
    let mut columns = [vec![], vec![], vec![]];
    for angle in angles.map(f64::to_radians) {
        let (across, down) = (speed * angle.sin(), speed * angle.cos());
        let change = f * (1.0 + e) * down;
        let after = across - change;
        let slip = across + 2.5e-3 * spin - 3.5 * change;
        let angle_of = |along: f64| along.atan2(e * down).to_degrees();
        let row = [after / across, angle_of(after), angle_of(slip)];
        columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
    }
    assert!(columns[0][0] < 0.0 && columns[0][2] > 0.0);
    let contact = "friction = { fit = [0.01, 0.2] }\nlaw = \"coulomb\"\nnormal_restitution = 0.8\nloss = \"yield\"";
    let text = alumina(contact).text().replace("4000", "4000\nspin = [0, -3000, 0]");
    let names = ["body_1_tangential_ratio", "body_1_rebound_angle", "contact_rebound_angle"];
    for (name, column) in names.into_iter().zip(columns) {
        let data = vec![("angle".to_owned(), angles.to_vec()), (name.to_owned(), column)];
        let data = Data::new(data).unwrap();
        let wall = text.replace("fixed = true", "fixed = true\nangles = [0, 90, 0]");
        for text in [text.clone(), wall] {
            let fit = fitted(&CaseFile::from_text(text), &data, Some(0.01)).unwrap();
            close(of(&fit, "friction").value, f, 1e-7);
            fit.points.iter().for_each(|point| close(point.fitted, point.measured, 1e-5));
        }
    }
}

#[test]
fn an_unknown_of_a_body_is_found_by_reading_the_case_anew() {
    // The duration of an impact is proportional to the radius.
    let text = "angle,duration,duration_sd\n0,1e-5,1e-8\n20,1.01e-5,1e-8\n40,1.05e-5,1e-8\n";
    let case = ball("{ fit = [1e-4, 1e-1] }", "friction = 0.1\nlaw = \"coulomb\"");
    let fit = fitted(&case, &Data::from_csv(text).unwrap(), None).unwrap();
    let radius = of(&fit, "radius").value;
    let of_radius = |radius: f64| {
        let text = ball(&radius.to_string(), "friction = 0.1\nlaw = \"coulomb\"");
        let file = ImpactFile::parse(text.text()).unwrap().nominal().collision.solve().unwrap();
        file.rebound().unwrap().duration
    };
    let duration = of_radius(radius);
    let at_45 = fit.points.iter().map(|point| point.fitted).fold(0.0, f64::max);
    assert!(duration > at_45, "{duration} {at_45}");
    close(of_radius(2.0 * radius) / duration, 2.0, 1e-9);
}

#[test]
fn restitution_over_speed_tells_the_relaxation_of_the_material() {
    // Data of the law itself, at three speeds, for a relaxation time of 2e-8 s.
    let contact = "friction = 0.1\nlaw = \"coulomb\"\nrelaxation = ";
    let at = |speed: f64| {
        let text = alumina(&format!("{contact}2e-8"))
            .text()
            .replace("speed = 3.9", &format!("speed = {speed}"));
        let text = text.replace("angle = 45", "angle = 0");
        let outcome = outcome(ImpactFile::parse(&text).unwrap().nominal()).unwrap();
        outcome.motions()[0].velocity.z / speed
    };
    let rows: Vec<String> =
        [0.3, 1.0, 3.0].map(|speed| format!("{speed},0,{}", at(speed))).to_vec();
    let text = format!("speed,angle,normal_restitution\n{}\n", rows.join("\n"));
    let case = alumina(&format!("{contact}{{ fit = [1e-9, 1e-6] }}"));
    let fit = fitted(&case, &Data::from_csv(&text).unwrap(), Some(0.01)).unwrap();
    close(of(&fit, "relaxation").value, 2e-8, 1e-12);
}
