//! The list of mutants, `xtask/mutants.toml`, and the tests known to detect them.

use anyhow::{Context as _, bail, ensure};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Largest number of mutants in the list.
const MAX_MUTANTS: usize = 80;

/// A deliberate fault in the physics.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Mutant {
    /// Crate and function, such as `carom_laws::Hertz::normal_energy`; modules may be omitted.
    pub(super) item: String,
    /// What the fault is.
    pub(super) name: String,
    /// An expression of the function.
    pub(super) find: String,
    /// Its replacement.
    pub(super) replace: String,
    /// Which occurrence of the expression, from 1; required if there are several.
    pub(super) nth: Option<usize>,
    /// Why no test can detect it.
    pub(super) explained: Option<String>,
}

impl Mutant {
    /// Item and name: the key in the list and in the file of killers.
    pub(super) fn key(&self) -> String {
        format!("{}: {}", self.item, self.name)
    }
}

/// The layer of a mutant outside Rust.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layer {
    /// The Python layer, `[[python]]`.
    Python,
    /// The C++ code of the LAMMPS plugin, `[[lammps]]`.
    Lammps,
}

/// A deliberate fault in the Python layer or the LAMMPS plugin.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct LayerMutant {
    pub(super) layer: Layer,
    /// Path below the folder of the sources.
    pub(super) file: String,
    pub(super) name: String,
    /// A text that occurs once in the file.
    pub(super) find: String,
    pub(super) replace: String,
}

impl LayerMutant {
    pub(super) fn key(&self) -> String {
        format!("{}: {}", self.file, self.name)
    }
}

/// The list.
#[derive(Debug)]
pub(super) struct List {
    pub(super) mutants: Vec<Mutant>,
    pub(super) layers: Vec<LayerMutant>,
}

/// Reads the list.
pub(super) fn read(path: &Path) -> anyhow::Result<List> {
    let text =
        std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    parse(&text).with_context(|| path.display().to_string())
}

fn parse(text: &str) -> anyhow::Result<List> {
    let table: toml::Table = text.parse()?;
    let entries = |name: &str| table.get(name).and_then(toml::Value::as_array);
    let mutants = entries("mutant").context("no [[mutant]]")?;
    let mutants = mutants.iter().map(mutant).collect::<anyhow::Result<Vec<_>>>()?;
    let mut layers = Vec::new();
    for (layer, name) in [(Layer::Python, "python"), (Layer::Lammps, "lammps")] {
        let entries = entries(name).into_iter().flatten();
        layers.extend(entries.map(|entry| of_layer(layer, entry)).collect::<Result<Vec<_>, _>>()?);
    }
    let count = mutants.len() + layers.len();
    ensure!(count <= MAX_MUTANTS, "{count} mutants; at most {MAX_MUTANTS}");
    let mut keys = BTreeSet::new();
    for key in mutants.iter().map(Mutant::key).chain(layers.iter().map(LayerMutant::key)) {
        ensure!(!keys.contains(&key), "twice: {key}");
        keys.insert(key);
    }
    Ok(List { mutants, layers })
}

fn of_layer(layer: Layer, entry: &toml::Value) -> anyhow::Result<LayerMutant> {
    let table = entry.as_table().context("a mutant is a table")?;
    known(table, &["file", "name", "find", "replace"])?;
    let needed = |key: &str| {
        let text = table.get(key).and_then(toml::Value::as_str).map(str::to_owned);
        text.with_context(|| format!("no `{key}` in {table}"))
    };
    let (file, name) = (needed("file")?, needed("name")?);
    Ok(LayerMutant { layer, file, name, find: needed("find")?, replace: needed("replace")? })
}

fn known(table: &toml::Table, known: &[&str]) -> anyhow::Result<()> {
    if let Some(key) = table.keys().find(|key| !known.contains(&key.as_str())) {
        bail!("unknown key `{key}`; there are: {}", known.join(", "));
    }
    Ok(())
}

fn mutant(entry: &toml::Value) -> anyhow::Result<Mutant> {
    let table = entry.as_table().context("a mutant is a table")?;
    known(table, &["item", "name", "find", "replace", "nth", "explained"])?;
    let text = |key: &str| table.get(key).and_then(toml::Value::as_str).map(str::to_owned);
    let needed = |key: &str| text(key).with_context(|| format!("no `{key}` in {table}"));
    let nth = table.get("nth").map(|nth| {
        let nth = nth.as_integer().and_then(|nth| usize::try_from(nth).ok());
        nth.filter(|nth| *nth > 0).with_context(|| format!("nth is 1, 2, ...: {table}"))
    });
    Ok(Mutant {
        item: needed("item")?,
        name: needed("name")?,
        find: needed("find")?,
        replace: needed("replace")?,
        nth: nth.transpose()?,
        explained: text("explained"),
    })
}

/// The test known to detect each mutant, by the key of the mutant.
pub(super) type Killers = BTreeMap<String, String>;

/// Reads the killers; empty if the file does not exist.
pub(super) fn read_killers(path: &Path) -> anyhow::Result<Killers> {
    let Ok(text) = std::fs::read_to_string(path) else { return Ok(Killers::new()) };
    let table: toml::Table = text.parse().with_context(|| path.display().to_string())?;
    let entry = |(key, value): (String, toml::Value)| Some((key, value.as_str()?.to_owned()));
    Ok(table.into_iter().filter_map(entry).collect())
}

/// Writes the killers.
pub(super) fn write_killers(path: &Path, killers: &Killers) -> anyhow::Result<()> {
    let mut text = String::from("# Written by `cargo xtask mutants --record`.\n");
    for (key, test) in killers {
        text += &format!("{} = {}\n", quoted(key), quoted(test));
    }
    std::fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_read_and_a_slip_in_it_named() {
        let good = "[[mutant]]\nitem = 'carom_laws::f'\nname = 'n'\nfind = '1'\nreplace = '2'\n";
        let mutants = parse(good).unwrap().mutants;
        assert_eq!(mutants[0].key(), "carom_laws::f: n");
        assert_eq!(mutants[0].nth, None);
        let twice = parse(&good.repeat(2)).unwrap_err();
        assert_eq!(twice.to_string(), "twice: carom_laws::f: n");
        let unknown = parse(&format!("{good}wy = 'x'\n")).unwrap_err();
        assert!(unknown.to_string().starts_with("unknown key `wy`"), "{unknown}");
        assert!(parse(&format!("{good}nth = 0\n")).is_err());
    }

    #[test]
    fn mutants_of_other_layers_are_read() {
        let good = "[[mutant]]\nitem = 'carom_laws::f'\nname = 'n'\nfind = '1'\nreplace = '2'\n\
                    [[python]]\nfile = '_a.py'\nname = 'm'\nfind = '1'\nreplace = '2'\n";
        let list = parse(good).unwrap();
        assert_eq!(list.layers[0].layer, Layer::Python);
        assert_eq!(list.layers[0].key(), "_a.py: m");
        assert!(parse(&good.replace("file", "item")).is_err());
    }
}
