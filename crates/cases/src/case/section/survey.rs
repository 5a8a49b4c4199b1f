//! All errors of a case at once. The reader of a kind stops at its first error; then every table is gone
//! through with its declared fields, and whatever is unknown, of a wrong value or missing is reported.

use super::error::meant as of_others;
use super::{Section, not_toml, parse};
use crate::case::body::SHAPE;
use crate::case::error::CaseError;
use crate::case::field::{Field, Form, Need, Word};
use crate::case::kind::CaseKind;
use crate::case::unit::Measure;
use carom_special::nearest;
use toml::Spanned;
use toml::de::DeValue;

/// The errors of a case that its reader rejected with `first`.
pub(in crate::case) fn all(kind: CaseKind, source: &str, first: CaseError) -> CaseError {
    if let CaseError::Syntax { line, column, message } = first {
        let message = not_toml::told(kind, source, line, column, message);
        return CaseError::Syntax { line, column, message };
    }
    let mut errors = survey(kind, source);
    match errors
        .iter_mut()
        .find(|error| !first.field().is_empty() && error.field() == first.field())
    {
        // The reader's own text, which may say more.
        Some(error) => *error = first,
        None => errors.push(first),
    }
    if let Some(likely) = other_kind(kind, source, errors.len()) {
        return CaseError::OtherKind { kind, likely };
    }
    match errors.len() {
        1 => errors.swap_remove(0),
        _ => CaseError::Several(errors),
    }
}

/// The kind of case of which this text has at most half as many errors.
fn other_kind(kind: CaseKind, source: &str, count: usize) -> Option<CaseKind> {
    let likely = CaseKind::of(source).ok()?;
    let is_known = |name: &str| likely.fields().iter().any(|field| field.name == name);
    let table = parse(source).ok()?;
    // An empty text is like no kind.
    if !table.get_ref().iter().any(|(name, _)| is_known(name.get_ref().as_ref())) {
        return None;
    }
    (likely != kind && 2 * survey(likely, source).len() <= count).then_some(likely)
}

/// The errors that the declared fields tell: unknown fields and wrong values first, then missing fields.
fn survey(kind: CaseKind, source: &str) -> Vec<CaseError> {
    let Ok(table) = parse(source) else { return Vec::new() };
    let top = Section::unread(source, table.get_ref(), kind.fields());
    let mut found = Found { may_vary: !kind.varied().is_empty(), ..Found::default() };
    found.table(&top);
    found.wrong.sort_by_key(|error| error.line());
    found.wrong.append(&mut found.missing);
    found.wrong
}

#[derive(Default)]
struct Found {
    /// Whether a table or a list may replace a number.
    may_vary: bool,
    wrong: Vec<CaseError>,
    missing: Vec<CaseError>,
}

impl Found {
    fn table(&mut self, section: &Section<'_>) {
        let has_shape = section.fields.iter().any(|field| field.name == SHAPE.name);
        let shape = if has_shape { section.word(&SHAPE).ok() } else { None };
        let unknown = section.all_unknown(shape);
        let meant = |field: &Field| {
            unknown.iter().any(|error| matches!(error, CaseError::Unknown { nearest: Some(name), .. } if name == field.name))
        };
        let is_meant = |field: &&Field| field.is_of(shape) && section.means(field);
        for field in section.fields.iter().filter(is_meant) {
            match section.find(&field) {
                Some(value) => self.value(section, field, value),
                // Without a shape it is not known which fields of shapes are necessary.
                None if has_shape && shape.is_none() && !field.shapes.is_empty() => {}
                None if matches!(field.need, Need::Must) && !meant(field) => {
                    self.missing.push(section.missing(field));
                }
                None => {}
            }
        }
        self.wrong.extend(unknown);
    }

    fn value<'a>(&mut self, section: &Section<'a>, field: &Field, value: &'a Spanned<DeValue<'a>>) {
        let error = match (field.form, value.get_ref()) {
            (Form::Table(fields), DeValue::Table(table)) => {
                let (path, line) = (section.full(field.name), section.line_of(value));
                self.table(&Section { path, line, table, fields, ..section.clone() });
                return;
            }
            (Form::Tables(fields), DeValue::Array(items)) => {
                for (i, item) in items.iter().enumerate() {
                    match item.get_ref() {
                        DeValue::Table(table) => {
                            let path = section.full(&format!("{}[{i}]", field.name));
                            let line = section.line_of(item);
                            self.table(&Section { path, line, table, fields, ..section.clone() });
                        }
                        _ => self.wrong.push(section.wrong(field, value)),
                    }
                }
                return;
            }
            (Form::Table(_) | Form::Tables(_), _) => Err(section.wrong(field, value)),
            (Form::Number(measure), _) => self.number(section, field.name, value, measure),
            (Form::Numbers(_), DeValue::Table(_)) | (Form::Rows(_), DeValue::Array(_)) => Ok(()),
            (
                Form::Pair(measure) | Form::Numbers(measure) | Form::List(measure),
                DeValue::Array(_),
            ) => section.list_at(field.name, value, measure).map(|_| ()),
            (Form::Pair(measure) | Form::Numbers(measure), _) => {
                self.number(section, field.name, value, measure)
            }
            (Form::List(_) | Form::Rows(_), _) => Err(section.wrong(field, value)),
            (Form::Vector(parts, measure, _), _) => {
                self.vector(section, field, value, parts, measure)
            }
            (Form::WordOrVector(_, parts, measure, _), DeValue::Array(_)) => {
                self.vector(section, field, value, parts, measure)
            }
            (Form::Word(_) | Form::WordOrVector(..), _) => section.word(field).map(|_| ()),
            (Form::Text(_), DeValue::String(_)) | (Form::Switch, DeValue::Boolean(_)) => Ok(()),
            (Form::Text(_) | Form::Switch, _) => Err(section.wrong(field, value)),
        };
        self.wrong.extend(error.err());
    }

    fn number(
        &self,
        section: &Section<'_>,
        name: &str,
        value: &Spanned<DeValue<'_>>,
        measure: Measure,
    ) -> Result<(), CaseError> {
        let varies = matches!(value.get_ref(), DeValue::Table(_) | DeValue::Array(_));
        if varies && self.may_vary {
            return Ok(());
        }
        section.plain_number(name, value, measure).map(|_| ())
    }

    fn vector(
        &self,
        section: &Section<'_>,
        field: &Field,
        value: &Spanned<DeValue<'_>>,
        parts: &[&str],
        measure: Measure,
    ) -> Result<(), CaseError> {
        let items = match value.get_ref() {
            DeValue::Array(items) if items.iter().count() == parts.len() => items,
            _ => return Err(section.wrong(field, value)),
        };
        items.iter().zip(parts).try_for_each(|(item, part)| {
            self.number(section, &format!("{}.{part}", field.name), item, measure)
        })
    }
}

/// The word that was probably meant by the text, in words; empty if none is similar.
pub(super) fn meant(text: Option<&str>, words: &[Word]) -> String {
    let words: Vec<&'static str> = words.iter().map(|(word, _)| *word).collect();
    let near = text.and_then(|text| of_others(text, &words).or_else(|| nearest(text, &words)));
    near.map_or_else(String::new, |word| format!("; did you mean {word:?}?"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_that_is_right_has_no_errors() {
        for kind in CaseKind::ALL {
            assert_eq!(survey(kind, &kind.begin()), [], "{kind:?}");
        }
    }

    const TYPED: &str = "\
[body_1]
shape = \"spere\"
material = { E = 2e11, poisson = 0.3 }
mass = \"3 kilo\"
velocity = [0.5, 0]

[body_2]
shape = \"plane\"
fixed = 1

[contact]
frition = 0.2
";

    #[test]
    fn every_error_of_a_case_is_told_with_its_place() {
        let error = CaseKind::Impact.check(TYPED).unwrap_err();
        insta::assert_snapshot!(error.shown_in(TYPED), @r#"
        7 errors
        line 2: `body_1.shape` = "spere" is not allowed: must be "sphere", "ellipsoid", "cylinder", "capsule", "torus", "box", "plane", "half-space" or "given"; did you mean "sphere"?
          2 | shape = "spere"
            | ^^^^^
        line 3: unknown field `body_1.material.E`, did you mean `young_modulus`? `body_1.material` takes `young_modulus`, `shear_modulus`, `poisson`, `rigid`, `yield_stress`, `hardness`
          3 | material = { E = 2e11, poisson = 0.3 }
            |              ^
        line 4: `body_1.mass` = "3 kilo" is not allowed: must be a number, > 0 (inf is allowed), plain in kg or as a text with a unit of kg, t, g, mg, ug
          4 | mass = "3 kilo"
            | ^^^^
        line 5: `body_1.velocity` = [0.5, 0] is not allowed: must be three numbers [x, y, z]
          5 | velocity = [0.5, 0]
            | ^^^^^^^^
        line 9: `body_2.fixed` = 1 is not allowed: must be true or false
          9 | fixed = 1
            | ^^^^^
        line 12: unknown field `contact.frition`, did you mean `friction`? `contact` takes `friction`, `static_friction`, `law`, `torsion`, `normal_restitution`, `wave_loss`, `relaxation`, `point`, `point_1`, `point_2`, `search`
          12 | frition = 0.2
             | ^^^^^^^
        line 7: `body_2.material` is missing: must be a table, headed [body_2.material]; material: two elastic constants, or rigid, and the yield stress if it is known
          7 | [body_2]
            |  ^^^^^^
        "#);
    }

    #[test]
    fn what_is_meant_is_told() {
        use CaseKind::{History, Impact, Roll, Solve};
        for (kind, old, new, said) in [
            (Impact, "radius", "diameter", "did you mean `radius`, half of it?"),
            (Impact, "\"sphere\"", "\"ball\"", "; did you mean \"sphere\"?"),
            (Impact, "radius = 0.01", "radius = \"0,01 m\"", "write a point: 0.01 m"),
            (Impact, "[0.25, 0, -0.5]", "[0,25, 0, -0,5]", "; decimals have a point"),
            (Impact, "density", "poisson = 0.3\ndensity", "mean `material = { poisson = .. }`?"),
            (Impact, "density", "mu = 0.3\ndensity", "did you mean `contact.friction`?"),
            (
                Impact,
                "= 0.2",
                "= { mean = 0.2, sd = 0.1 }",
                "did you mean `normal = { mean = .. }`?",
            ),
            (Impact, "= 0.2", "= { uniform = [0.1, 0.2] }", "a table { low = .., high = .. }"),
            (
                Impact,
                "= 0.2",
                "= { start = 0, stop = 1, step = 0.1 }",
                "`count`, the number of values?",
            ),
            (Impact, "= 0.2", "= 0.2\nfriction_static = 0.3", "did you mean `static_friction`?"),
            (
                Impact,
                "= 0.2",
                "= \"f.csv\"",
                "; no file is read here, the values stand in the case",
            ),
            (
                History,
                "[[1e-6, 0, 0], [1e-6, 2e-7, 0], [1e-6, 0, 0]]",
                "\"f.csv\"",
                "named by `history.file`",
            ),
            (Roll, "[0.0005, 0.001, 0.002, 0.004]", "\"0.1 %\"", "; 0.1 % is 0.001"),
            (
                Solve,
                "size = [2.6e-4, 2.6e-4]",
                "size = [260, 260]",
                "`gap.shape` = \"sphere\" is not allowed: must be such that a cell",
            ),
            (
                Solve,
                "cells = [40, 40]",
                "cells.x = 40",
                "= { x = .. } is not allowed: must be two whole",
            ),
        ] {
            let source = kind.begin_short().replacen(old, new, 1);
            let error = kind.check(&source).unwrap_err().to_string();
            assert!(error.contains(said), "{new}: {error}");
        }
    }

    #[test]
    fn an_empty_case_is_of_no_other_kind() {
        for kind in CaseKind::ALL {
            let error = kind.check("# nothing yet\n").unwrap_err();
            assert!(!matches!(error, CaseError::OtherKind { .. }), "{kind:?}: {error}");
        }
    }

    #[test]
    fn a_case_of_another_kind_is_recognised() {
        let case = CaseKind::Impact.begin();
        for kind in CaseKind::ALL.into_iter().filter(|kind| *kind != CaseKind::Impact) {
            let error = kind.check(&case).unwrap_err();
            assert_eq!(error, CaseError::OtherKind { kind, likely: CaseKind::Impact });
        }
    }
}
