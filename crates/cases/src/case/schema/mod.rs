//! The schema of a kind of case as JSON Schema, draft 4, made from its table of fields. Editors complete and check
//! case files with it.
//!
//! Draft 4 cannot say everything: the range of a number given as a text with its unit is checked as to sign and zero
//! only, and most conditions between the values of several fields are left to `carom check`.

mod choice;
mod json;
mod quantity;
mod shape;

use super::field::{Default, Field, Form, Need, Rows, Schema, Word};
use super::range::Range;
use super::section::SWEEP;
use super::template::{capital, described};
use super::uncertainty::UNCERTAINTY;
use super::unit::Measure;
use choice::Place;
use json::{Json, map, texts};
use quantity::plain;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The version of the language.
const DRAFT: &str = "http://json-schema.org/draft-04/schema#";

impl Schema {
    /// Its schema as JSON Schema, draft 4.
    ///
    /// ```
    /// use carom_cases::case::CaseKind;
    ///
    /// let schema = CaseKind::Hertz.json_schema();
    /// assert!(schema.contains("http://json-schema.org/draft-04/schema#"));
    /// assert!(schema.contains("\"semi_axis_a\""));
    /// ```
    #[must_use]
    pub fn json_schema(&self) -> String {
        let numbers = if self.varied.is_empty() { Numbers::Single } else { Numbers::Varied };
        let maker = Maker { root: self.fields, forms: self.varied, parts: RefCell::default() };
        let head = map([
            ("$schema", DRAFT.into()),
            ("title", format!("A case for carom {}", self.name).into()),
            ("description", self.meaning.into()),
        ]);
        let (table, mut conditions) = maker.table(head, self.fields, &[], numbers);
        let Parts { definitions, of_case } = maker.parts.into_inner();
        conditions.extend(of_case);
        table
            .with_any("allOf", conditions.into())
            .with("definitions", Json::Map(definitions.into_iter().collect()))
            .text()
    }
}

/// What may stand in the place of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Numbers {
    /// One number.
    Single,
    /// One number or a sweep: a list, or a range with a count.
    Several,
    /// One number, a sweep or a distribution.
    Varied,
}

/// Makes the schema of a kind of case.
struct Maker {
    root: &'static [Field],
    /// The forms that may replace a number.
    forms: &'static [Field],
    parts: RefCell<Parts>,
}

/// What is found on the way.
#[derive(Default)]
struct Parts {
    /// Schemas of numbers, by name.
    definitions: BTreeMap<String, Json>,
    /// Conditions that concern several tables.
    of_case: Vec<Json>,
}

impl Maker {
    /// The schema of a table without its conditions, and these.
    fn table(
        &self,
        head: Json,
        fields: &'static [Field],
        path: &[&'static str],
        numbers: Numbers,
    ) -> (Json, Vec<Json>) {
        let schema = |field: &Field| self.field(field, path, numbers);
        let mut properties: Vec<(String, Json)> = Vec::new();
        for field in fields {
            match properties.iter_mut().find(|(name, _)| name == field.name) {
                Some((_, other)) => *other = either(other.clone(), schema(field)),
                None => properties.push((field.name.to_owned(), schema(field))),
            }
        }
        let must = fields.iter().filter(|field| matches!(field.need, Need::Must));
        let must = must.filter(|field| field.shapes.is_empty()).map(|field| field.name);
        let table = head
            .with("type", "object")
            .with("properties", Json::Map(properties))
            .with_any("required", texts(must))
            .with("additionalProperties", false)
            .with_any("dependencies", shape::owners(fields));
        let table = match shape::demands(fields, schema) {
            Some(demands) => table.with("anyOf", demands),
            None => table,
        };
        let place = Place { root: self.root, fields, path: path.to_vec() };
        let choice::Conditions { own, of_case } = place.conditions();
        let known = &mut self.parts.borrow_mut().of_case;
        for condition in of_case {
            if !known.contains(&condition) {
                known.push(condition);
            }
        }
        (table, own)
    }

    /// The schema of a field, with its description and its default.
    fn field(&self, field: &Field, path: &[&'static str], numbers: Numbers) -> Json {
        let head = map([("description", capital(&described(field)).into())]);
        let own = [path, &[field.name]].concat();
        // The sampling of distributions does not vary itself.
        let numbers = if field.name == UNCERTAINTY.name { Numbers::Single } else { numbers };
        let table = |head, fields, numbers| {
            let (table, conditions) = self.table(head, fields, &own, numbers);
            table.with_any("allOf", conditions.into())
        };
        match field.form {
            Form::Table(fields) => table(head, fields, numbers),
            Form::Tables(fields) => {
                let items = table(map([]), fields, Numbers::Single);
                head.with("type", "array").with("minItems", 1_usize).with("items", items)
            }
            _ => defaulted(self.value(head, field.form, numbers), field),
        }
    }

    /// Adds the values that a field without a table takes.
    fn value(&self, head: Json, form: Form, numbers: Numbers) -> Json {
        match form {
            Form::Number(measure) => of(head, self.number(measure, numbers)),
            Form::Numbers(measure) => of(head, self.number(measure, Numbers::Several)),
            Form::Pair(measure) => {
                let one = self.number(measure, Numbers::Single);
                of(
                    head,
                    self.define("Pair", measure, list(plain(measure, &["array"]), one, [2, 2])),
                )
            }
            Form::List(measure) => head
                .with("type", "array")
                .with("minItems", 1_usize)
                .with("items", self.number(measure, Numbers::Single)),
            Form::Vector(parts, measure, _) => {
                list(head.with("type", "array"), self.number(measure, numbers), [parts.len(); 2])
            }
            Form::WordOrVector(words, parts, measure, _) => {
                let vector = map([("type", "array".into())]);
                let vector = list(vector, self.number(measure, numbers), [parts.len(); 2]);
                head.with("anyOf", vec![word(map([]), words), vector])
            }
            Form::Rows(rows) => self.rows(head, rows, numbers),
            Form::Word(words) => word(head, words),
            Form::Text(_) => head.with("type", "string"),
            Form::Switch => head.with("type", "boolean"),
            Form::Table(_) | Form::Tables(_) => head,
        }
    }

    fn rows(&self, head: Json, rows: Rows, numbers: Numbers) -> Json {
        let parts = rows.measures.iter().map(|measure| self.number(*measure, numbers));
        let row = map([("type", "array".into()), ("items", parts.collect::<Vec<_>>().into())])
            .with("minItems", rows.parts.len() - rows.optional)
            .with("additionalItems", false);
        head.with("type", "array").with("minItems", rows.least).with("items", row)
    }

    /// A reference to the schema of these numbers.
    fn number(&self, measure: Measure, numbers: Numbers) -> Json {
        match numbers {
            Numbers::Single => self.define("", measure, plain(measure, &[])),
            Numbers::Several => self.define("Several", measure, self.several(measure, SWEEP)),
            Numbers::Varied => self.define("Varied", measure, self.several(measure, self.forms)),
        }
    }

    /// Names the schema of numbers, and refers to it.
    fn define(&self, before: &str, measure: Measure, schema: Json) -> Json {
        let name = format!("{before}{}", quantity::name(measure));
        let reference = format!("#/definitions/{name}");
        self.parts.borrow_mut().definitions.entry(name).or_insert(schema);
        map([("$ref", reference.into())])
    }

    /// A number, a list of numbers, or a table of the forms that may replace it.
    fn several(&self, measure: Measure, forms: &[Field]) -> Json {
        let one = self.number(measure, Numbers::Single);
        let part = |part: &Field| match part.form {
            Form::Number(own) if own == Range::Finite.pure() => one.clone(),
            _ => self.replacement(part, measure),
        };
        let parts = forms.iter().map(|form| (form.name.to_owned(), part(form))).collect();
        let way = |names: &[&str]| {
            map([("required", texts(names)), ("maxProperties", names.len().into())])
        };
        let mut ways = Vec::new();
        let is_of_sweep = |form: &Field| SWEEP.iter().any(|field| field.name == form.name);
        let has_sweep = forms.iter().any(is_of_sweep);
        if has_sweep {
            ways.push(way(&SWEEP.iter().map(|field| field.name).collect::<Vec<_>>()));
        }
        let kinds = forms.iter().filter(|form| !is_of_sweep(form));
        ways.extend(kinds.map(|kind| way(&[kind.name])));
        let schema = match has_sweep {
            true => {
                plain(measure, &["array", "object"]).with("minItems", 1_usize).with("items", one)
            }
            false => plain(measure, &["object"]),
        };
        schema
            .with("properties", Json::Map(parts))
            .with("additionalProperties", false)
            .with("anyOf", ways)
    }

    /// A part of a table that replaces a number of this measure.
    fn replacement(&self, part: &Field, measure: Measure) -> Json {
        let head = map([("description", capital(part.meaning).into())]);
        let own = Range::Finite.of(measure.dimension);
        let number = self.number(own, Numbers::Single);
        let fields = match part.form {
            Form::Table(fields) => fields,
            Form::Vector(parts, ..) => {
                return list(head.with("type", "array"), number, [parts.len(); 2]);
            }
            form => return self.value(head, form, Numbers::Single),
        };
        let properties = fields.iter().map(|field| (field.name.to_owned(), number.clone()));
        head.with("type", "object")
            .with("properties", Json::Map(properties.collect()))
            .with("required", texts(fields.iter().map(|field| field.name)))
            .with("additionalProperties", false)
    }
}

/// The head, and the schema that a reference names. Draft 4 ignores what stands beside a reference.
fn of(head: Json, reference: Json) -> Json {
    head.with("allOf", vec![reference])
}

/// Adds that a list has this many numbers.
fn list(head: Json, item: Json, [least, most]: [usize; 2]) -> Json {
    head.with("minItems", least).with("maxItems", most).with("items", item)
}

fn word(head: Json, words: &[Word]) -> Json {
    head.with("enum", texts(words.iter().map(|(word, _)| word)))
}

/// Adds the default of a field; JSON has no infinity.
fn defaulted(schema: Json, field: &Field) -> Json {
    let Need::Default(default) = field.need else { return schema };
    let value: Json = match default {
        Default::Number(number) if number.is_infinite() => return schema,
        Default::Number(number) => number.into(),
        Default::List(numbers) => {
            numbers.iter().map(|number| (*number).into()).collect::<Vec<Json>>().into()
        }
        Default::Word(word) => word.into(),
        Default::False => false.into(),
    };
    schema.with("default", value)
}

/// One of two schemas of fields of the same name.
fn either(one: Json, other: Json) -> Json {
    match one {
        one if one == other => one,
        one => map([("anyOf", vec![one, other].into())]),
    }
}
