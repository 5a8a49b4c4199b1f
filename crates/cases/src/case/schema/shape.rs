//! Tables with a field `shape`: which fields belong to which shape.

use super::json::{Json, map, texts};
use crate::case::field::{Field, Form, Need};
use crate::case::shape::SHAPE;

/// The condition that the shape is one of these.
fn is_one_of(words: &[&str]) -> Json {
    map([("properties", map([(SHAPE.name, map([("enum", texts(words))]))]))])
}

/// For each field that some shapes have: the table has one of these shapes.
pub(super) fn owners(fields: &[Field]) -> Json {
    let mut owners: Vec<(&str, Vec<&str>)> = Vec::new();
    for field in fields.iter().filter(|field| !field.shapes.is_empty()) {
        match owners.iter_mut().find(|(name, _)| *name == field.name) {
            Some((_, shapes)) => shapes.extend(field.shapes),
            None => owners.push((field.name, field.shapes.to_vec())),
        }
    }
    let owners = owners.into_iter().map(|(name, shapes)| (name.to_owned(), is_one_of(&shapes)));
    Json::Map(owners.collect())
}

/// For each shape: the fields that it must have, and those of its fields that another shape has in another form.
/// None if no shape has such fields.
pub(super) fn demands(fields: &[Field], schema: impl Fn(&Field) -> Json) -> Option<Json> {
    let shape = fields.iter().find(|field| field.name == SHAPE.name)?;
    let Form::Word(words) = shape.form else { return None };
    let demand = |word: &str| {
        let own = || fields.iter().filter(|field| field.shapes.contains(&word));
        let must = own().filter(|field| matches!(field.need, Need::Must)).map(|field| field.name);
        let several =
            |field: &&Field| fields.iter().filter(|other| other.name == field.name).count() > 1;
        let mut properties = vec![(SHAPE.name.to_owned(), map([("enum", texts([word]))]))];
        properties
            .extend(own().filter(several).map(|field| (field.name.to_owned(), schema(field))));
        map([("properties", Json::Map(properties))]).with_any("required", texts(must))
    };
    let is_shaped = fields.iter().any(|field| !field.shapes.is_empty());
    is_shaped.then(|| Json::List(words.iter().map(|(word, _)| demand(word)).collect()))
}
