//! The kinds of cases, their fields, and what a file of each kind sets.

use super::error::CaseError;
use super::field::{Entry, Field, Form, Need, entries};
use super::section::{Section, is_meant, parse};
use super::{
    HertzCase, HistoryCase, ImpactFile, RollCase, SceneCase, ShellCase, SolveCase, StressCase,
};
use super::{hertz, history, impact, roll, scene, shell, solve, stress, varied};
use carom_special::{WordError, nearest};
use carom_table::Column;
use std::str::FromStr;
use toml::de::{DeTable, DeValue};

/// A kind of case, named like the command that takes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CaseKind {
    /// An impact of two bodies, a sweep of impacts, or a distribution of impacts.
    Impact,
    /// A contact under normal load.
    Hertz,
    /// A contact under a history of shifts.
    History,
    /// A ball that bounces between walls.
    Scene,
    /// A contact on a grid.
    Solve,
    /// A rolling contact.
    Roll,
    /// The stresses below a contact.
    Stress,
    /// A bellows, or a flange on a tube.
    Shell,
}

impl FromStr for CaseKind {
    type Err = WordError;

    /// # Errors
    /// [`WordError`] with the names of all kinds.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let kind = Self::ALL.into_iter().find(|kind| kind.name() == word);
        kind.ok_or_else(|| WordError::new("kind", word, &Self::NAMES))
    }
}

impl CaseKind {
    /// All kinds.
    pub const ALL: [Self; 8] = [
        Self::Impact,
        Self::Hertz,
        Self::History,
        Self::Scene,
        Self::Solve,
        Self::Roll,
        Self::Stress,
        Self::Shell,
    ];

    const NAMES: [&'static str; Self::ALL.len()] = {
        let mut names = [""; Self::ALL.len()];
        let mut i = 0;
        while i < names.len() {
            names[i] = Self::ALL[i].name();
            i += 1;
        }
        names
    };

    /// The command that takes it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Impact => "impact",
            Self::Hertz => "hertz",
            Self::History => "history",
            Self::Scene => "scene",
            Self::Solve => "solve",
            Self::Roll => "roll",
            Self::Stress => "stress",
            Self::Shell => "shell",
        }
    }

    /// Its description, a sentence.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Impact => "An impact of two bodies of any smooth shape.",
            Self::Hertz => "Two surfaces pressed together.",
            Self::History => "A contact that is pressed, shifted and twisted, step by step.",
            Self::Scene => "A ball that flies under gravity and bounces between walls.",
            Self::Solve => "A contact with friction on a grid, step by step.",
            Self::Roll => "A rolling contact, driven by creepages or by forces.",
            Self::Stress => "Stresses below a contact under normal and tangential load.",
            Self::Shell => {
                "A bellows under pressure and axial load, or a flange under forces around it."
            }
        }
    }

    /// Its fields.
    #[must_use]
    pub const fn fields(self) -> &'static [Field] {
        match self {
            Self::Impact => impact::FIELDS,
            Self::Hertz => hertz::FIELDS,
            Self::History => history::FIELDS,
            Self::Scene => scene::FIELDS,
            Self::Solve => solve::FIELDS,
            Self::Roll => roll::FIELDS,
            Self::Stress => stress::FIELDS,
            Self::Shell => shell::FIELDS,
        }
    }

    /// The forms that may replace any of its numbers, except those of `[uncertainty]`.
    #[must_use]
    pub const fn varied(self) -> &'static [Field] {
        match self {
            Self::Impact => varied::VARIED,
            _ => &[],
        }
    }

    /// Its fields with their paths. The forms that may replace a number come last, under `*`.
    #[must_use]
    pub fn entries(self) -> Vec<Entry> {
        let mut all = entries(self.fields());
        all.extend(
            entries(self.varied())
                .into_iter()
                .map(|entry| Entry { path: format!("*.{}", entry.path), ..entry }),
        );
        all
    }

    /// The kind of a file, guessed from its tables; misspelt names count as well.
    ///
    /// # Errors
    /// If the text is not TOML.
    pub fn of(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let names: Vec<&str> =
            table.get_ref().iter().map(|(name, _)| name.get_ref().as_ref()).collect();
        let fit = |kind: Self| -> i32 {
            let is_there = |field: &&Field| names.contains(&field.name);
            let (there, lacking): (Vec<&Field>, Vec<&Field>) =
                kind.fields().iter().partition(is_there);
            let valid: Vec<&str> = lacking.iter().map(|field| field.name).collect();
            let unknown =
                names.iter().filter(|name| there.iter().all(|field| field.name != **name));
            let like: Vec<_> = unknown.map(|name| nearest(name, &valid)).collect();
            let missed = lacking.iter().filter(|field| {
                matches!(field.need, Need::Must) && !like.contains(&Some(field.name))
            });
            let of_unknown = |like: &Option<_>| if like.is_some() { 1 } else { -1 };
            // Of tables that replace one another one must be there.
            let is_one_of = |field: &&Field| matches!(field.need, Need::Or(_));
            let is_none_there = kind.fields().iter().any(|field| is_one_of(&field))
                && !there.iter().any(is_one_of)
                && !lacking
                    .iter()
                    .any(|field| is_one_of(field) && like.contains(&Some(field.name)));
            2 * (there.len() as i32 - missed.count() as i32 - i32::from(is_none_there))
                + like.iter().map(of_unknown).sum::<i32>()
        };
        // The first of those that fit best.
        let best = Self::ALL.into_iter().rev().max_by_key(|kind| fit(*kind));
        Ok(best.unwrap_or(Self::Impact))
    }

    /// Checks that the file is a valid case of this kind, with all values in their ranges.
    ///
    /// # Errors
    /// As the reader of the kind.
    pub fn check(self, source: &str) -> Result<(), CaseError> {
        match self {
            Self::Impact => ImpactFile::parse(source).map(|_| ()),
            Self::Hertz => HertzCase::parse(source).map(|_| ()),
            Self::History => HistoryCase::parse(source).map(|_| ()),
            Self::Scene => SceneCase::parse(source).map(|_| ()),
            Self::Solve => SolveCase::parse(source).map(|_| ()),
            Self::Roll => RollCase::parse(source).map(|_| ()),
            Self::Stress => StressCase::parse(source).map(|_| ()),
            Self::Shell => ShellCase::parse(source).map(|_| ()),
        }
    }

    /// The value of each field of a file of this kind, with the default where the file does not set it.
    ///
    /// # Errors
    /// If the text is not TOML.
    pub fn understood(self, source: &str) -> Result<Vec<Understood>, CaseError> {
        let table = parse(source)?;
        let section = Section::root(source, table.get_ref(), self.fields())?;
        let mut found = Vec::new();
        tell(&section, "", table.get_ref(), self.fields(), &mut found);
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
    let shape = value_of(&super::body::SHAPE).and_then(|value| value.get_ref().as_str());
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
