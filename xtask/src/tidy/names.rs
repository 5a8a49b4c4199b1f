//! The name of a law, a friction or a loss stands as a text in one file of each crate: in its enum, or in the table of a
//! reader. A second place is a second list, which a new member would have to be added to.

use super::{read, rust_files};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The names as they are written in cases, Python, LAMMPS and C.
const NAMES: [&str; 9] = [
    "coulomb",
    "fixed-direction",
    "rings",
    "viscous",
    "maxwell",
    "standard-solid",
    "constant-loss-tangent",
    "yield",
    "numerical",
];

/// The crates in which a name stands in several files.
pub(super) fn faults(root: &Path) -> anyhow::Result<Vec<String>> {
    let mut places: BTreeMap<(PathBuf, &str), Vec<String>> = BTreeMap::new();
    for path in rust_files(root, &["src"])? {
        let mut parts = path.components();
        let crate_of: PathBuf = parts.by_ref().take(2).collect();
        if !crate_of.starts_with("crates")
            || parts.next().is_none_or(|part| part.as_os_str() != "src")
        {
            continue;
        }
        let text = read(&root.join(&path))?;
        for name in NAMES {
            if stands(name, &text) {
                let here = path.display().to_string();
                places.entry((crate_of.clone(), name)).or_default().push(here);
            }
        }
    }
    let several = places.into_iter().filter(|(_, files)| files.len() > 1);
    let told = |((_, name), files): (_, Vec<String>)| {
        let files = files.join(", ");
        format!("{files}: the name {name:?} stands in several files of a crate; take it from one")
    };
    Ok(several.map(told).collect())
}

/// Whether the text stands in code that is neither a comment nor a test of the module.
fn stands(name: &str, source: &str) -> bool {
    let quoted = format!("{name:?}");
    let code = source.lines().take_while(|line| line.trim() != "#[cfg(test)]");
    let code = code.map(|line| line.split("//").next().unwrap_or_default());
    code.into_iter().any(|line| line.contains(&quoted))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_tests_do_not_count() {
        assert!(stands("rings", "Self::Rings => \"rings\","));
        assert!(!stands("rings", "/// assert_eq!(name, \"rings\");"));
        assert!(!stands(
            "rings",
            "fn a() {}\n#[cfg(test)]\nmod tests { const A: &str = \"rings\"; }"
        ));
        assert!(!stands("rings", "\"spring rings\""));
    }
}
