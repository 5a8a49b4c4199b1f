//! Finds the items that tests, examples and pages reach.
//!
//! The search is by names, not by types: a test reaches a method that it calls by `.name` or
//! `Type::name`, and everything that this method calls. A function of the same name on another type
//! also counts. The search therefore finds items that nothing calls, but not all of them.

use super::{read, rust_files};
use crate::book;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::path::Path;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

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
        let Some(owner) = &function.owner else { return self.words.contains(&function.name) };
        // `<Type as Trait>::name`, and the same with a type parameter.
        let of_any = |of: &str| self.pairs.contains(&format!("{of}::{}", function.name));
        (function.has_self && self.methods.contains(&function.name))
            || [owner, ">", "T", "L", "S", "M"].into_iter().any(of_any)
    }
}

/// A function that is not a test, and the names in its body.
#[derive(Debug)]
struct Function {
    owner: Option<String>,
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
            let is_page = path.starts_with("verification/src/figures");
            let mut finder = Finder { is_page, ..Finder::new(&text) };
            finder.visit_file(&syn::parse_file(&text)?);
            tests.extend(finder.tests);
            functions.extend(finder.functions);
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
                functions.insert(match &function.owner {
                    Some(owner) => format!("{owner}::{}", function.name),
                    None => function.name,
                });
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

/// Collects functions, and the names used by the tests among them.
struct Finder<'t> {
    text: &'t str,
    owner: Option<String>,
    functions: Vec<Function>,
    tests: Uses,
    /// Whether all functions are pages with claims.
    is_page: bool,
}

impl<'t> Finder<'t> {
    fn new(text: &'t str) -> Self {
        let (functions, tests) = (Vec::new(), Uses::default());
        Self { text, owner: None, functions, tests, is_page: false }
    }

    fn tokens(&self, part: &impl Spanned) -> TokenStream {
        tokens(self.text.get(part.span().byte_range()).unwrap_or_default())
    }

    fn add(&mut self, signature: &syn::Signature, body: &syn::Block, is_test: bool) {
        let mut uses = Uses::default();
        uses.add(self.tokens(body), self.owner.as_deref());
        if self.is_page || is_test {
            self.tests.extend(uses);
            uses = Uses::default();
        }
        self.functions.push(Function {
            owner: self.owner.clone(),
            name: signature.ident.to_string(),
            has_self: signature.receiver().is_some(),
            body: uses,
        });
    }

    fn within(&mut self, owner: Option<String>, walk: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.owner, owner);
        walk(self);
        self.owner = before;
    }
}

impl<'a> Visit<'a> for Finder<'_> {
    fn visit_item_mod(&mut self, module: &'a syn::ItemMod) {
        if module.ident == "tests" {
            let tokens = self.tokens(module);
            self.tests.add(tokens, None);
        } else {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_impl(&mut self, item: &'a syn::ItemImpl) {
        let owner = match item.self_ty.as_ref() {
            syn::Type::Path(path) => path.path.segments.last().map(|s| s.ident.to_string()),
            _ => None,
        };
        self.within(owner, |finder| visit::visit_item_impl(finder, item));
    }

    fn visit_item_trait(&mut self, item: &'a syn::ItemTrait) {
        self.within(Some(item.ident.to_string()), |finder| visit::visit_item_trait(finder, item));
    }

    fn visit_item_fn(&mut self, function: &'a syn::ItemFn) {
        let is_test = function.attrs.iter().any(|attribute| attribute.path().is_ident("test"));
        self.add(&function.sig, &function.block, is_test);
    }

    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.add(&function.sig, &function.block, false);
    }

    fn visit_trait_item_fn(&mut self, function: &'a syn::TraitItemFn) {
        if let Some(body) = &function.default {
            self.add(&function.sig, body, false);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reached(source: &str, test: &str) -> Reached {
        let mut finder = Finder::new(source);
        finder.visit_file(&syn::parse_file(source).unwrap());
        finder.tests.add(tokens(test), None);
        Reached::of(finder.tests, finder.functions)
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
