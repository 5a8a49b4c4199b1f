//! Plain numbers that are allowed but unusual, probably in another unit.

use super::{Section, number, parse};
use crate::case::body::SHAPE;
use crate::case::field::{Field, Form};
use crate::case::kind::CaseKind;
use carom_special::Readable;
use toml::Spanned;
use toml::de::DeValue;

impl CaseKind {
    /// A sentence for each plain number of a file of this kind that is unusual, in the order of the
    /// fields; empty if the text is not TOML. Numbers with a unit are taken as meant.
    #[must_use]
    pub fn unusual(self, source: &str) -> Vec<String> {
        let Ok(table) = parse(source) else { return Vec::new() };
        let mut found = Vec::new();
        let top = Section::unread(source, table.get_ref(), self.fields());
        look(&top, &mut found);
        found
    }
}

fn look(section: &Section<'_>, found: &mut Vec<String>) {
    let shape = section.find(&&SHAPE).and_then(|value| value.get_ref().as_str());
    for field in section.fields.iter().filter(|field| field.is_of(shape)) {
        let Some(value) = section.find(&field) else { continue };
        match (field.form, value.get_ref()) {
            (Form::Table(fields), DeValue::Table(table)) => {
                let path = section.full(field.name);
                look(&Section { path, table, fields, ..section.clone() }, found);
            }
            (Form::Tables(fields), DeValue::Array(items)) => {
                for (i, item) in items.iter().enumerate() {
                    if let DeValue::Table(table) = item.get_ref() {
                        let path = section.full(&format!("{}[{i}]", field.name));
                        look(&Section { path, table, fields, ..section.clone() }, found);
                    }
                }
            }
            _ => found.extend(told(section, field, value)),
        }
    }
}

/// The first unusual number of a value: the number, one of a list, or an end of a range.
fn told(section: &Section<'_>, field: &Field, value: &Spanned<DeValue<'_>>) -> Option<String> {
    let usual = field.usual?;
    let all: Vec<f64> = match value.get_ref() {
        DeValue::Array(items) => items.iter().filter_map(|item| number(item.get_ref())).collect(),
        DeValue::Table(range) => {
            let ends = range
                .iter()
                .filter(|(name, _)| ["start", "stop"].contains(&name.get_ref().as_ref()));
            ends.filter_map(|(_, end)| number(end.get_ref())).collect()
        }
        plain => number(plain).into_iter().collect(),
    };
    // In a range from small to usual angles the small ones are meant.
    let is_meant = all.iter().any(|value| *value != 0.0 && usual.has(*value));
    let value_of = all.into_iter().find(|value| !usual.has(*value)).filter(|_| !is_meant)?;
    Some(format!(
        "line {}: `{}` = {} is unusual: {}",
        section.line_of(value),
        section.full(field.name),
        Readable(value_of),
        usual.words
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn new_cases_are_usual() {
        for kind in CaseKind::ALL {
            assert_eq!(kind.unusual(&kind.begin()), [""; 0], "{kind:?}");
        }
    }

    #[test]
    fn numbers_in_other_units_are_told_with_their_place() {
        let case = "[body_1]\nshape = \"sphere\"\nradius = 10\ndensity = 7.85\n\
                    material = { young_modulus = 208, poisson = 0.3 }\n\
                    [contact]\nfriction = 20\n[approach]\nspeed = 1\nangle = 0.785\n";
        let told = CaseKind::Impact.unusual(case);
        let fields: Vec<&str> =
            told.iter().map(|line| line.split('`').nth(1).unwrap_or_default()).collect();
        let expected = [
            "body_1.radius",
            "body_1.density",
            "body_1.material.young_modulus",
            "contact.friction",
            "approach.angle",
        ];
        let mut sorted = fields.clone();
        sorted.sort_unstable();
        let mut wanted = expected.to_vec();
        wanted.sort_unstable();
        assert_eq!(sorted, wanted);
        assert!(
            told.iter().any(|line| line.starts_with("line 4: `body_1.density` = 7.85 is unusual"))
        );
    }

    #[test]
    fn units_ranges_zero_and_no_slip_are_taken_as_meant() {
        let with = |line: &str| CaseKind::Impact.unusual(&format!("[approach]\n{line}\n"));
        for meant in [
            "angle = \"0.785 rad\"",
            "angle = 0",
            "angle = [0.5, 1, 2, 5]",
            "angle = { start = 0, stop = 85, count = 18 }",
        ] {
            assert!(with(meant).is_empty(), "{meant}");
        }
        assert_eq!(with("angle = { start = 0, stop = 1.5, count = 9 }").len(), 1);
        let friction = |f: &str| CaseKind::Impact.unusual(&format!("[contact]\nfriction = {f}\n"));
        assert!(friction("inf").is_empty() && friction("0").is_empty());
        assert_eq!(friction("[0.1, 0.2, 30]").len(), 0);
        assert_eq!(friction("30").len(), 1);
    }
}
