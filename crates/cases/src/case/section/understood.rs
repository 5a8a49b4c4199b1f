//! What a case sets, field by field, with the defaults of what it does not set.

use super::{Section, parse};
use crate::case::error::CaseError;
use crate::case::field::{Field, Form, Need, Schema};
use crate::case::shape::SHAPE;
use carom_table::Column;

impl Schema {
    /// The value of each field of a file of this kind, with the default where the file does not set it.
    ///
    /// # Errors
    /// If the text is not TOML.
    pub fn understood(&self, source: &str) -> Result<Vec<Understood>, CaseError> {
        let table = parse(source)?;
        let section = Section::root(source, table.get_ref(), self.fields)?;
        let mut found = Vec::new();
        tell(&section, &mut found);
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
        Column::text("field", "", "name with its path", |told| told.field.clone().into()),
        Column::text("value", "", "value, with numbers in the base unit", |told| {
            told.value.clone().into()
        }),
        Column::text("unit", "", "base unit", |told| told.unit.into()),
        Column::text("from", "", "whether the file or the default sets it", |told| {
            match told.is_given {
                true => "file".into(),
                false => "default".into(),
            }
        }),
    ];
}

fn tell(section: &Section<'_>, found: &mut Vec<Understood>) {
    let shape = section.find(&&SHAPE).and_then(|value| value.get_ref().as_str());
    // Of a plain field and a table of one name, that for which the value is meant.
    let meant = |field: &&Field| field.is_of(shape) && section.means(field);
    for field in section.fields.iter().filter(meant) {
        let value = section.find(&field);
        if let Some(tables) = value.and_then(|value| section.tables(field, value)) {
            tables.iter().for_each(|table| tell(table, found));
            continue;
        }
        let unit = field.measure().map_or("", |measure| measure.dimension.unit());
        let (value, unit) = match (value, field.form, field.need) {
            (Some(_), Form::Table(_) | Form::Tables(_), _) => continue,
            (Some(value), ..) => (section.shown(value, field.measure()), unit),
            (None, _, Need::Default(_)) => (field.default_text().unwrap_or_default(), unit),
            (None, _, Need::May(absent)) => (absent.to_owned(), ""),
            (None, ..) => continue,
        };
        let (field, is_given) = (section.full(field.name), section.has(field));
        found.push(Understood { field, value, unit, is_given });
    }
}
