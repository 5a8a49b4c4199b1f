//! Fields that replace one another, read from the words of their need.

use super::json::{Json, map, texts};
use crate::case::field::{Field, Need};

/// A way to say something: a field, or a switch that is on.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Way {
    /// The names of its tables and its own.
    path: Vec<&'static str>,
    /// Whether it is a switch that must be true.
    is_on: bool,
}

/// The fields of a table, and where the table is.
#[derive(Debug, Clone)]
pub(super) struct Place<'a> {
    /// All fields of the case.
    pub(super) root: &'a [Field],
    /// The fields of the table.
    pub(super) fields: &'a [Field],
    /// The names of the table and of those that hold it.
    pub(super) path: Vec<&'static str>,
}

/// Conditions of a table, and those that concern several tables of the case.
#[derive(Debug, Default)]
pub(super) struct Conditions {
    /// Of the table.
    pub(super) own: Vec<Json>,
    /// Of the whole case.
    pub(super) of_case: Vec<Json>,
}

impl Place<'_> {
    /// What the alternatives of its fields demand: one of them is there, and none beside one that it replaces.
    pub(super) fn conditions(&self) -> Conditions {
        let (mut seen, mut conditions) = (Vec::new(), Conditions::default());
        let mut add = |ways: Vec<Way>, make: fn(&[Json]) -> Json| {
            let depth = if ways.iter().all(|way| self.has(way)) { self.path.len() } else { 0 };
            let there: Vec<Json> = ways.iter().map(|way| way.there(depth)).collect();
            let condition = make(&there);
            if seen.contains(&condition) {
                return;
            }
            seen.push(condition.clone());
            let all = if depth == self.path.len() {
                &mut conditions.own
            } else {
                &mut conditions.of_case
            };
            all.push(condition);
        };
        for field in self.fields {
            let others = self.alternatives(field);
            if others.is_empty() {
                continue;
            }
            let own = self.way(field);
            let mut ways = vec![own.clone()];
            for other in &others {
                let back = self.back(other);
                ways.push(other.clone());
                if other.is_on || back.contains(&own) {
                    let mut pair = vec![own.clone(), other.clone()];
                    pair.sort();
                    add(pair, |pair| map([("not", map([("allOf", pair.to_vec().into())]))]));
                }
                if back.contains(&own) {
                    ways.extend(back);
                }
            }
            ways.sort();
            ways.dedup();
            add(ways, |ways| map([("anyOf", ways.to_vec().into())]));
        }
        conditions
    }

    fn way(&self, field: &Field) -> Way {
        Way { path: [&self.path[..], &[field.name]].concat(), is_on: false }
    }

    /// Whether the way is a field of this table.
    fn has(&self, way: &Way) -> bool {
        way.path.len() == self.path.len() + 1 && way.path.starts_with(&self.path)
    }

    /// The alternatives that the need of a field names between backticks.
    fn alternatives(&self, field: &Field) -> Vec<Way> {
        let Need::Or(words) = field.need else { return Vec::new() };
        let named = words.split('`').skip(1).step_by(2).filter(|name| *name != field.name);
        named.filter_map(|name| self.named(name)).collect()
    }

    /// A field of this table, or one of the case with its path.
    fn named(&self, words: &str) -> Option<Way> {
        let (name, is_on) = match words.strip_suffix(" = true") {
            Some(name) => (name, true),
            None => (words, false),
        };
        if let Some(field) = self.fields.iter().find(|field| field.name == name) {
            return Some(Way { is_on, ..self.way(field) });
        }
        let (mut fields, mut path) = (self.root, Vec::new());
        for name in name.split('.') {
            let field = fields.iter().find(|field| field.name == name)?;
            path.push(field.name);
            fields = field.fields();
        }
        Some(Way { path, is_on })
    }

    /// The alternatives of an alternative.
    fn back(&self, way: &Way) -> Vec<Way> {
        let Some((name, tables)) = way.path.split_last() else { return Vec::new() };
        let mut place = Place { fields: self.root, path: Vec::new(), ..self.clone() };
        for table in tables {
            let Some(held) = place.fields.iter().find(|field| field.name == *table) else {
                return Vec::new();
            };
            place.fields = held.fields();
            place.path.push(*table);
        }
        let found = place.fields.iter().find(|field| field.name == *name);
        found.map_or_else(Vec::new, |field| place.alternatives(field))
    }
}

impl Way {
    /// The condition that it is there, for a table at this depth.
    fn there(&self, depth: usize) -> Json {
        let is_on = || map([("enum", vec![true.into()].into())]);
        let names = self.path[depth..].iter().rev();
        let inner = names.fold(None, |inner: Option<Json>, name| {
            let needed = map([("required", texts([name]))]);
            let inner = inner.or_else(|| self.is_on.then(is_on));
            Some(match inner {
                Some(inner) => needed.with("properties", map([(name, inner)])),
                None => needed,
            })
        });
        inner.unwrap_or_else(|| map([]))
    }
}
