//! All errors of a case at once. The reader of a kind stops at its first error; then every table is gone
//! through with its declared fields, and whatever is unknown, of a wrong value or missing is reported.

use super::{Section, parse};
use crate::case::body::SHAPE;
use crate::case::error::CaseError;
use crate::case::field::{Field, Form, Need, Word};
use crate::case::kind::CaseKind;
use crate::case::unit::Measure;
use toml::Spanned;
use toml::de::DeValue;

/// The errors of a case that its reader rejected with `first`.
pub(in crate::case) fn all(kind: CaseKind, source: &str, first: CaseError) -> CaseError {
    if let CaseError::Syntax { line, column, message } = first {
        let wrong = source.lines().nth(line.saturating_sub(1)).unwrap_or("");
        let message = twice(message, wrong, column) + &number_meant(wrong) + &advice(kind, source);
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

/// What to write instead of a text that is not TOML but perhaps JSON or YAML.
fn advice(kind: CaseKind, source: &str) -> String {
    let first = source.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("");
    let is_yaml =
        first == "---" || first.split_once(':').is_some_and(|(name, _)| !name.contains(['=', '"']));
    match first.starts_with('{') || is_yaml {
        true => format!("; a case is written in TOML, `carom new {}` prints one", kind.name()),
        false => String::new(),
    }
}

/// The parser's message with the name of a field or table that stands in the file twice.
fn twice(message: String, line: &str, column: usize) -> String {
    let is_name = |letter: &char| letter.is_alphanumeric() || "_-.".contains(*letter);
    match message == "duplicate key" {
        true => {
            let name: String = line.chars().skip(column).take_while(is_name).collect();
            format!("`{name}` is given a second time; leave one of the two out")
        }
        false => message,
    }
}

/// What may be meant by a line that is not TOML: numbers as other languages write them, or a text.
fn number_meant(line: &str) -> String {
    let value = line.split('#').next().and_then(|line| line.split_once('=')).map_or("", |(_, v)| v);
    let has_decimal_comma = !value.contains(['[', '{', '"'])
        && value.split_once(',').is_some_and(|(whole, part)| {
            let is_digit = |letter: Option<char>| letter.is_some_and(|l| l.is_ascii_digit());
            is_digit(whole.chars().next_back()) && is_digit(part.chars().next())
        });
    match () {
        () if value.contains('\u{2212}') => {
            "; the minus sign of a number is a hyphen, -".to_owned()
        }
        () if has_decimal_comma => "; a number has a decimal point, as 0.3".to_owned(),
        () if is_bare_text(value) => format!("; write \"{}\"", value.trim()),
        () => String::new(),
    }
}

/// Whether these are words, or a number with a unit, without quotes.
fn is_bare_text(value: &str) -> bool {
    let is_plain = |letter: char| letter.is_alphanumeric() || " ._-+/^%".contains(letter);
    let is_word =
        |word: &str| word.starts_with(char::is_alphabetic) && word.parse::<f64>().is_err();
    value.chars().all(is_plain) && value.split_whitespace().any(is_word)
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
    let fields = kind.fields();
    let path = String::new();
    let top = Section { source, path, line: 0, table: table.get_ref(), fields, varied: None };
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
            unknown.iter().any(|error| matches!(error, CaseError::Unknown { nearest: Some(name), .. } if *name == field.name))
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
    let near = text.and_then(|text| carom_special::nearest(text, &words));
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
        line 2: `body_1.shape` = "spere" is out of range: must be "sphere", "ellipsoid", "cylinder", "capsule", "torus", "box", "plane", "half-space" or "given"; did you mean "sphere"?
          2 | shape = "spere"
            | ^^^^^
        line 3: unknown field `body_1.material.E`, did you mean `young_modulus`? `body_1.material` takes `young_modulus`, `shear_modulus`, `poisson`, `rigid`, `yield_stress`, `hardness`
          3 | material = { E = 2e11, poisson = 0.3 }
            |              ^
        line 4: `body_1.mass` = "3 kilo" is out of range: must be a number, > 0 (inf is allowed), plain in kg or as a text with a unit of kg, t, g, mg, ug
          4 | mass = "3 kilo"
            | ^^^^
        line 5: `body_1.velocity` = [0.5, 0] is out of range: must be three numbers [x, y, z]
          5 | velocity = [0.5, 0]
            | ^^^^^^^^
        line 9: `body_2.fixed` = 1 is out of range: must be true or false
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
    fn an_empty_case_is_of_no_other_kind() {
        for kind in CaseKind::ALL {
            let error = kind.check("# nothing yet\n").unwrap_err();
            assert!(!matches!(error, CaseError::OtherKind { .. }), "{kind:?}: {error}");
        }
    }

    #[test]
    fn numbers_of_other_languages_are_told() {
        let said = |line: &str| {
            let source = format!("[contact]\n{line}\n");
            CaseKind::Impact.check(&source).unwrap_err().shown_in(&source)
        };
        let comma = said("friction = 0,3");
        assert!(comma.contains("line 2: ") && comma.contains("has a decimal point"), "{comma}");
        assert!(comma.ends_with("\n  2 | friction = 0,3\n    |             ^"), "{comma}");
        let minus = said("friction = \u{2212}0.3");
        assert!(minus.contains("is a hyphen, -"), "{minus}");
        let twice = said("friction = 0.1\nfriction = 0.2");
        assert!(twice.contains("`friction` is given a second time"), "{twice}");
        assert!(twice.ends_with("\n  3 | friction = 0.2\n    | ^"), "{twice}");
        let bare = said("radius = 10 mm");
        assert!(bare.contains("; write \"10 mm\""), "{bare}");
        let word = said("law = coulomb # the default");
        assert!(word.contains("; write \"coulomb\""), "{word}");
    }

    #[test]
    fn a_case_of_another_kind_is_recognised() {
        let case = CaseKind::Impact.begin();
        for kind in CaseKind::ALL.into_iter().filter(|kind| *kind != CaseKind::Impact) {
            let error = kind.check(&case).unwrap_err();
            assert_eq!(error, CaseError::OtherKind { kind, likely: CaseKind::Impact });
        }
        let json = CaseKind::Hertz.check("{ \"a\": 1 }").unwrap_err().to_string();
        assert!(
            json.ends_with("a case is written in TOML, `carom new hertz` prints one"),
            "{json}"
        );
    }
}
