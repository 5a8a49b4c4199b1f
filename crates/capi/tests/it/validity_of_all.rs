//! Every function of the interface that loads a contact has one that tells how far it is from the limits of the theory.

/// What carries the materials of a contact, and what tells of the theory for it.
const ASKED: [(&str, &str); 3] = [
    ("struct carom_law *", "carom_law_validity"),
    ("struct carom_encounter *", "carom_encounters_validity"),
    // A rebound has the bits of its warnings.
    ("struct carom_rebound *", "carom_warning_text"),
];
/// What belongs to a contact that was made by one of these, or has ratios only, or texts and numbers.
const NEED_NOT: &[&str] = &[
    // For codes that compute approach and shift themselves, and know their bodies.
    "struct carom_pair *",
    "struct carom_validity *",
    "carom_law_of_name",
    "carom_law_name",
    "carom_restitution",
    "carom_creep_coefficients",
    "carom_creep_force",
    "carom_mesh_make",
    "carom_mesh_places",
    "carom_mesh_free",
    "carom_status_text",
    "carom_warning_text",
    "carom_version",
    "carom_abi_version",
];

/// The declarations of the header, each in one line.
fn declared(header: &str) -> Vec<String> {
    let code: String = header
        .split("/*")
        .map(|part| part.split_once("*/").map_or(part, |(_, code)| code))
        .collect();
    let words = |part: &str| part.split_whitespace().collect::<Vec<_>>().join(" ");
    let is_function = |text: &String| text.contains("carom_") && text.ends_with(')');
    code.split(';').map(words).filter(is_function).collect()
}

#[test]
fn whatever_loads_a_contact_can_be_asked_for_its_limits() {
    let header = include_str!("../../include/carom.h");
    let functions = declared(header);
    assert!(functions.len() > 30 && functions.len() <= 40, "{}", functions.len());
    for (_, tells) in ASKED {
        assert!(functions.iter().any(|text| text.contains(&format!("{tells}("))), "{tells}");
    }
    let known = |text: &String| {
        ASKED.iter().map(|(of, _)| of).chain(NEED_NOT).any(|part| text.contains(*part))
    };
    let strange: Vec<_> = functions.iter().filter(|text| !known(text)).collect();
    assert!(strange.is_empty(), "no validity for {strange:#?}");
}
