//! The part of JSON Schema, draft 4, that the schemas of cases use. A keyword that is not among them is a panic, so
//! that no condition is passed over.

use serde_json::Value;

/// The faults of a value, each with its place.
pub(crate) fn faults(schema: &Value, value: &Value) -> Vec<String> {
    let mut found = Vec::new();
    Checked { root: schema, place: String::new() }.check(schema, value, &mut found);
    found
}

struct Checked<'a> {
    root: &'a Value,
    place: String,
}

impl Checked<'_> {
    fn below(&self, name: impl std::fmt::Display) -> Self {
        Checked { root: self.root, place: format!("{}/{name}", self.place) }
    }

    fn is_valid(&self, schema: &Value, value: &Value) -> bool {
        let mut found = Vec::new();
        self.check(schema, value, &mut found);
        found.is_empty()
    }

    fn check(&self, schema: &Value, value: &Value, found: &mut Vec<String>) {
        // What stands beside a reference is ignored.
        if let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
            let referred = self.root.pointer(&reference[1..]).unwrap();
            return self.check(referred, value, found);
        }
        for (keyword, given) in schema.as_object().unwrap() {
            let is_right = match keyword.as_str() {
                "$schema" | "title" | "description" | "default" | "definitions" => true,
                "exclusiveMinimum" | "exclusiveMaximum" => {
                    given.is_boolean() && schema.get(keyword.replace("exclusiveM", "m")).is_some()
                }
                "items" | "properties" | "dependencies" | "allOf" => {
                    self.check_parts(keyword, given, value, found);
                    true
                }
                "anyOf" => list(given).iter().any(|given| self.is_valid(given, value)),
                "not" => !self.is_valid(given, value),
                "enum" => list(given).iter().any(|one| is_equal(one, value)),
                "type" => match given {
                    Value::Array(types) => types.iter().any(|one| is_of(one, value)),
                    one => is_of(one, value),
                },
                "minimum" | "maximum" | "multipleOf" | "pattern" => {
                    is_within(schema, keyword, given, value)
                }
                _ => is_long_enough(schema, keyword, given, value),
            };
            if !is_right {
                found.push(format!("{}: {value}: {keyword}: {given}", self.place));
            }
        }
    }

    fn check_parts(&self, keyword: &str, given: &Value, value: &Value, found: &mut Vec<String>) {
        match (keyword, given, value) {
            ("allOf", _, _) => list(given).iter().for_each(|all| self.check(all, value, found)),
            ("items", Value::Array(schemas), Value::Array(items)) => {
                for (i, (schema, item)) in schemas.iter().zip(items).enumerate() {
                    self.below(i).check(schema, item, found);
                }
            }
            ("items", schema, Value::Array(items)) => {
                for (i, item) in items.iter().enumerate() {
                    self.below(i).check(schema, item, found);
                }
            }
            ("properties", Value::Object(schemas), Value::Object(fields)) => {
                for (name, schema) in schemas {
                    if let Some(field) = fields.get(name) {
                        self.below(name).check(schema, field, found);
                    }
                }
            }
            ("dependencies", Value::Object(schemas), Value::Object(fields)) => {
                for (_, schema) in schemas.iter().filter(|(name, _)| fields.contains_key(*name)) {
                    self.check(schema, value, found);
                }
            }
            _ => {}
        }
    }
}

fn is_within(schema: &Value, keyword: &str, given: &Value, value: &Value) -> bool {
    let is_exclusive = |name: &str| schema.get(name) == Some(&Value::Bool(true));
    if let (Value::String(pattern), Value::String(text)) = (given, value) {
        return regex_lite::Regex::new(pattern).unwrap().is_match(text);
    }
    let (Some(end), Some(number)) = (given.as_f64(), value.as_f64()) else { return true };
    match keyword {
        "minimum" if is_exclusive("exclusiveMinimum") => number > end,
        "minimum" => number >= end,
        "maximum" if is_exclusive("exclusiveMaximum") => number < end,
        "maximum" => number <= end,
        _ => (number / end).fract() == 0.0,
    }
}

fn is_long_enough(schema: &Value, keyword: &str, given: &Value, value: &Value) -> bool {
    let (items, fields) = (value.as_array(), value.as_object());
    let count = given.as_u64().unwrap_or(0) as usize;
    match keyword {
        "minItems" => items.is_none_or(|items| items.len() >= count),
        "maxItems" => items.is_none_or(|items| items.len() <= count),
        "additionalItems" => items.is_none_or(|items| items.len() <= list(&schema["items"]).len()),
        "maxProperties" => fields.is_none_or(|fields| fields.len() <= count),
        "required" => fields.is_none_or(|fields| {
            list(given).iter().all(|name| fields.contains_key(name.as_str().unwrap()))
        }),
        "additionalProperties" => fields.is_none_or(|fields| {
            fields.keys().all(|name| schema["properties"].get(name).is_some())
        }),
        other => panic!("unknown keyword {other}"),
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn is_equal(one: &Value, other: &Value) -> bool {
    one == other || one.as_f64().is_some_and(|number| other.as_f64() == Some(number))
}

fn is_of(name: &Value, value: &Value) -> bool {
    match name.as_str().unwrap() {
        "number" => value.is_number(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        "null" => value.is_null(),
        other => panic!("unknown type {other}"),
    }
}
