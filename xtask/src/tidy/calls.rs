//! Finds the items that tests, examples and pages reach.
//!
//! The search is by names, not by types: a test reaches a method that it calls by `.name` or
//! `Type::name`, and everything that this method calls. A function of the same name on another type
//! also counts. The search therefore finds items that nothing calls, but not all of them.

use super::items::items;
use super::{read, rust_files};
use crate::book;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::path::Path;

/// The names used by some code.
#[derive(Debug, Default)]
struct Uses {
    words: BTreeSet<String>,
    methods: BTreeSet<String>,
    /// `Type::name`
    pairs: BTreeSet<String>,
}

impl Uses {
    /// Adds the names in `tokens`, where `Self` is `owner`. The name in a definition is not a use.
    fn add(&mut self, tokens: TokenStream, owner: Option<&str>) {
        let mut before: [String; 3] = Default::default();
        for token in tokens {
            let text = match token {
                TokenTree::Group(group) => {
                    self.add(group.stream(), owner);
                    String::new()
                }
                TokenTree::Ident(ident) => ident.to_string(),
                TokenTree::Punct(punct) => punct.as_char().to_string(),
                TokenTree::Literal(_) => String::new(),
            };
            let is_word = text.starts_with(|c: char| c.is_alphabetic() || c == '_');
            let is_defined = ["fn", "struct", "enum", "trait", "const", "mod"];
            if is_word && !is_defined.contains(&before[2].as_str()) {
                if before[2] == "." {
                    self.methods.insert(text.clone());
                } else if before[1] == ":" && before[2] == ":" {
                    let of: &str =
                        if before[0] == "Self" { owner.unwrap_or("Self") } else { &before[0] };
                    self.pairs.insert(format!("{of}::{text}"));
                }
                self.words.insert(text.clone());
            }
            before.rotate_left(1);
            before[2] = text;
        }
    }

    fn extend(&mut self, other: Self) {
        self.words.extend(other.words);
        self.methods.extend(other.methods);
        self.pairs.extend(other.pairs);
    }

    /// Whether `Type::name` or `name` is used.
    fn has(&self, function: &Function) -> bool {
        let Some((owner, name)) = function.name.split_once("::") else {
            return self.words.contains(&function.name);
        };
        // `<Type as Trait>::name`, and the same with a type parameter.
        let of_any = |of: &str| self.pairs.contains(&format!("{of}::{name}"));
        (function.has_self && self.methods.contains(name))
            || [owner, ">", "T", "L", "S", "M"].into_iter().any(of_any)
    }
}

/// A function that is not a test, and the names in its body.
#[derive(Debug)]
struct Function {
    /// `name` or `Type::name`.
    name: String,
    has_self: bool,
    body: Uses,
}

/// The items that tests, examples and pages reach.
#[derive(Debug)]
pub(super) struct Reached {
    /// `name` and `Type::name`.
    functions: BTreeSet<String>,
    words: BTreeSet<String>,
}

impl Reached {
    /// Reads all crates below `root`.
    pub(super) fn read(root: &Path) -> anyhow::Result<Self> {
        let mut tests = Uses::default();
        let mut functions = Vec::new();
        for path in rust_files(root, &["src"])? {
            let text = read(&root.join(&path))?;
            // All functions of a page are claims or make them.
            let is_page = path.starts_with("verification/src/figures");
            functions.extend(functions_of(&text, is_page, &mut tests)?);
            examples(&text, &["///", "//!"], &mut tests);
        }
        for path in rust_files(root, &["tests", "examples"])? {
            tests.add(tokens(&read(&root.join(path))?), None);
        }
        for path in book::chapters(root)? {
            examples(&read(&path)?, &[""], &mut tests);
        }
        Ok(Self::of(tests, functions))
    }

    /// The functions reached from these uses, directly or through others.
    fn of(mut uses: Uses, mut waiting: Vec<Function>) -> Self {
        let mut functions = BTreeSet::new();
        loop {
            let (now, later): (Vec<_>, Vec<_>) = waiting.into_iter().partition(|f| uses.has(f));
            if now.is_empty() {
                return Self { functions, words: uses.words };
            }
            for function in now {
                functions.insert(function.name);
                uses.extend(function.body);
            }
            waiting = later;
        }
    }

    /// Whether `Type`, `function` or `Type::function` is reached.
    pub(super) fn has(&self, item: &str) -> bool {
        let is_alone = |name: &str| !name.contains("::") && self.words.contains(name);
        // An associated constant.
        let is_constant = |name: &str| {
            let last = name.rsplit("::").next().unwrap_or(name);
            last.chars().all(|c| c.is_uppercase() || c == '_' || c.is_numeric())
                && self.words.contains(last)
        };
        self.functions.contains(item) || is_alone(item) || is_constant(item)
    }
}

/// The functions of a source; adds the names that its tests use.
fn functions_of(text: &str, is_page: bool, tests: &mut Uses) -> anyhow::Result<Vec<Function>> {
    let items = items(text)?;
    for place in items.tests {
        tests.add(tokens(&text[place]), None);
    }
    let mut functions = Vec::new();
    for item in items.of {
        let Some((body, function)) = item.function.and_then(|f| Some((f.body.clone()?, f))) else {
            continue;
        };
        let mut uses = Uses::default();
        uses.add(tokens(&text[body]), item.owner.as_deref());
        if is_page || function.is_test {
            tests.extend(std::mem::take(&mut uses));
        }
        functions.push(Function { name: item.name, has_self: function.has_self, body: uses });
    }
    Ok(functions)
}

/// The tokens of a text; empty if it is not Rust, as in a shortened example.
fn tokens(text: &str) -> TokenStream {
    text.parse().unwrap_or_default()
}

/// Adds the uses in Rust code blocks of documentation, whose lines begin with one of `marks`.
fn examples(text: &str, marks: &[&str], uses: &mut Uses) {
    let mut block: Option<String> = None;
    for line in text.lines() {
        let line = line.trim_start();
        let Some(line) = marks.iter().find_map(|mark| line.strip_prefix(mark)) else {
            block = None;
            continue;
        };
        match (line.trim_start().strip_prefix("```"), &mut block) {
            (Some(_), Some(code)) => {
                uses.add(tokens(code), None);
                block = None;
            }
            (Some(kind), None) => {
                let is_rust =
                    ["", "rust", "no_run"].contains(&kind.split(',').next().unwrap_or(kind));
                block = Some(String::new()).filter(|_| is_rust || marks == ["///", "//!"]);
            }
            (None, Some(code)) => {
                *code += line.trim_start().strip_prefix("# ").unwrap_or(line);
                code.push('\n');
            }
            (None, None) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reached(source: &str, test: &str) -> Reached {
        let mut tests = Uses::default();
        let functions = functions_of(source, false, &mut tests).unwrap();
        tests.add(tokens(test), None);
        Reached::of(tests, functions)
    }

    const SOURCE: &str = "pub struct Law; pub const LIMIT: f64 = 1.0;
        impl Law { pub fn new() -> Self { Self } pub fn force(&self) -> f64 { inner() } \
                   fn heat(&self) -> f64 { LIMIT } }
        fn inner() -> f64 { 1.0 } fn alone() -> f64 { inner() }";

    #[test]
    fn what_a_test_calls_is_reached_and_what_that_calls() {
        let reached = reached(SOURCE, "fn t() { assert!(Law::new().force() > 0.0) }");
        for item in ["Law", "Law::new", "Law::force", "inner"] {
            assert!(reached.has(item), "{item}");
        }
        for item in ["Law::heat", "alone", "LIMIT"] {
            assert!(!reached.has(item), "{item}");
        }
    }

    #[test]
    fn the_definition_of_a_function_does_not_reach_it() {
        assert!(!reached(SOURCE, "fn inner() {}").has("inner"));
    }

    #[test]
    fn examples_of_the_documentation_count() {
        let mut uses = Uses::default();
        let text =
            "/// A law.\n/// ```\n/// # use x;\n/// law.force(1.0);\n/// ```\n/// not.this()\n";
        examples(text, &["///", "//!"], &mut uses);
        assert!(uses.methods.contains("force") && !uses.methods.contains("this"));
    }
}
