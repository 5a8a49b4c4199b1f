//! Checks the form of the scripts in `findings/`, which `findings/README.md` states.

use std::path::Path;

use anyhow::Context as _;

/// How the lines behind the first one begin.
const HEAD: [&str; 5] =
    ["# Finding: ", "# Package: ", "# Expected: ", "# Seen: ", "# Touches carom: "];
const MOST_LINES: usize = 90;

/// What is wrong with the scripts and with their table.
pub(super) fn faults(root: &Path) -> anyhow::Result<Vec<String>> {
    let folder = root.join("findings");
    let table = super::read(&folder.join("README.md"))?;
    let mut faults = Vec::new();
    for entry in folder.read_dir().context("findings")? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if name == "README.md" {
            continue;
        }
        let text = super::read(&folder.join(&name))?;
        let all = of_script(&name, &text, &table);
        faults.extend(all.into_iter().map(|fault| format!("findings/{name}: {fault}")));
    }
    Ok(faults)
}

fn of_script(name: &str, text: &str, table: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let mut ask = |holds: bool, fault: &str| {
        if !holds {
            faults.push(fault.to_owned());
        }
    };
    let is_kebab =
        |stem: &str| stem.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
    ask(name.strip_suffix(".sh").is_some_and(is_kebab), "its name is not in kebab case with .sh");
    ask(text.starts_with("#!/usr/bin/env bash\n"), "its first line is not `#!/usr/bin/env bash`");
    for (line, head) in HEAD.iter().enumerate() {
        let found = text.lines().nth(line + 1).unwrap_or_default();
        let holds = found.strip_prefix(head).is_some_and(|rest| !rest.trim().is_empty());
        ask(holds, &format!("line {} does not begin with `{head}`", line + 2));
    }
    let package = text.lines().nth(2).unwrap_or_default();
    ask(package.contains(|c: char| c.is_ascii_digit()), "no version of a package is named");
    ask(text.contains("\nset -euo pipefail\n"), "`set -euo pipefail` is missing");
    ask(text.contains("mktemp -d"), "it uses no temporary folder");
    ask(!text.contains("://"), "it names a host");
    ask(text.lines().count() <= MOST_LINES, "it has more than 90 lines");
    ask(table.contains(&format!("(./{name})")), "the table of findings/README.md does not have it");
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_script_without_its_head_version_or_row_is_named() {
        let whole = "#!/usr/bin/env bash\n# Finding: f.\n# Package: p 1.0 (PyPI)\n# Expected: e.\n# Seen: s.\n\
                     # Touches carom: t.\nset -euo pipefail\nfolder=$(mktemp -d)\n";
        let table = "| [a-b](./a-b.sh) |";
        assert_eq!(of_script("a-b.sh", whole, table), Vec::<String>::new());
        for (name, from, to, fault) in [
            ("A_b.sh", "", "", "kebab"),
            ("a-b.sh", "# Seen: s.", "# Seen:", "line 5"),
            ("a-b.sh", "p 1.0 (PyPI)", "p (PyPI)", "version"),
            ("a-b.sh", "mktemp -d", "pwd", "temporary"),
            ("a-b.sh", "# Expected: e.", "# Expected: https://host.", "host"),
            ("c.sh", "", "", "table"),
        ] {
            let faults = of_script(name, &whole.replacen(from, to, 1), table);
            assert!(faults.iter().any(|told| told.contains(fault)), "{fault}: {faults:?}");
        }
    }
}
