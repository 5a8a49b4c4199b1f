//! What a case sets, field by field, with the defaults of what it does not set.

use super::error::CaseError;
use super::field::{Field, Form, Need, Schema};
use super::section::{Section, is_meant, parse};
use super::shape::SHAPE;
use carom_table::Column;
use toml::de::{DeTable, DeValue};

impl Schema {
    /// The value of each field of a file of this kind, with the default where the file does not set it.
    ///
    /// # Errors
    /// If the text is not TOML.
    pub fn understood(&self, source: &str) -> Result<Vec<Understood>, CaseError> {
        let table = parse(source)?;
        let section = Section::root(source, table.get_ref(), self.fields)?;
        let mut found = Vec::new();
        tell(&section, "", table.get_ref(), self.fields, &mut found);
        Ok(found)
    }
}

/// The value of one field of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Understood {
    /// Its path.
    pub field: String,
    /// Its value with numbers in the base unit, or its default.
    pub value: String,
    /// The unit.
    pub unit: &'static str,
    /// Whether the file sets it.
    pub is_given: bool,
}

impl Understood {
    /// The columns of the table of fields.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("field", "", "name with its path", |told| told.field.clone().into()),
        Column::new("value", "", "value, with numbers in the base unit", |told| {
            told.value.clone().into()
        }),
        Column::new("unit", "", "base unit", |told| told.unit.into()),
        Column::new("from", "", "whether the file or the default sets it", |told| {
            match told.is_given {
                true => "file".into(),
                false => "default".into(),
            }
        }),
    ];
}

fn tell(
    section: &Section<'_>,
    prefix: &str,
    table: &DeTable<'_>,
    fields: &[Field],
    found: &mut Vec<Understood>,
) {
    let value_of = |field: &Field| {
        table.iter().find(|(name, _)| name.get_ref() == field.name).map(|(_, value)| value)
    };
    let shape = value_of(&SHAPE).and_then(|value| value.get_ref().as_str());
    // Of a plain field and a table of one name, that for which the value is meant.
    let meant = |field: &&Field| field.is_of(shape) && is_meant(fields, field, value_of(field));
    for field in fields.iter().filter(meant) {
        let path = format!("{prefix}{}", field.name);
        let unit = field.measure().map_or("", |measure| measure.dimension.unit());
        let mut told = |value: String, unit, is_given| {
            found.push(Understood { field: path.clone(), value, unit, is_given });
        };
        match (value_of(field), field.form, field.need) {
            (Some(value), Form::Table(fields), _) => {
                if let DeValue::Table(table) = value.get_ref() {
                    tell(section, &format!("{path}."), table, fields, found);
                }
            }
            (Some(value), Form::Tables(fields), _) => {
                let items = value.get_ref().as_array().into_iter().flat_map(|items| items.iter());
                for (i, item) in items.enumerate() {
                    if let DeValue::Table(table) = item.get_ref() {
                        tell(section, &format!("{path}[{i}]."), table, fields, found);
                    }
                }
            }
            (Some(value), ..) => told(section.shown(value, field.measure()), unit, true),
            (None, _, Need::Default(_)) => {
                told(field.default_text().unwrap_or_default(), unit, false);
            }
            (None, _, Need::May(absent)) => told(absent.to_owned(), "", false),
            (None, ..) => {}
        }
    }
}
