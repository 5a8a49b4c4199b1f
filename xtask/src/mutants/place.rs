//! Finds the place of a mutant by its function and expression, so that code may move between files.

use super::list::Mutant;
use crate::files::files_below;
use anyhow::{Context as _, bail, ensure};
use std::ops::Range;
use std::path::{Path, PathBuf};
use syn::spanned::Spanned as _;
use syn::visit::{self, Visit};

/// A source file of a crate.
pub(super) struct Source {
    /// Path below the root of the workspace.
    pub(super) path: PathBuf,
    /// Text of the file.
    pub(super) text: String,
    functions: Vec<Function>,
}

/// A function of a source file.
struct Function {
    /// Path: `carom_laws`, modules, type, name.
    path: Vec<String>,
    is_const: bool,
    /// The byte ranges of its expressions.
    expressions: Vec<Range<usize>>,
}

/// The place of a mutant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    /// Index of the source.
    pub(super) source: usize,
    /// Byte range of the expression.
    pub(super) range: Range<usize>,
}

/// Reads the sources of a crate, `crates/laws` below `root`.
pub(super) fn sources(root: &Path, folder: &str) -> anyhow::Result<Vec<Source>> {
    let name = format!("carom_{}", folder.rsplit('/').next().unwrap_or(folder));
    let start = PathBuf::from(folder).join("src");
    let files = files_below(&root.join(&start), "rs")?;
    files
        .iter()
        .map(|path| source(root, &start, path.strip_prefix(root)?.to_owned(), &name))
        .collect()
}

fn source(root: &Path, start: &Path, path: PathBuf, name: &str) -> anyhow::Result<Source> {
    let text = std::fs::read_to_string(root.join(&path))
        .with_context(|| format!("cannot read {}", path.display()))?;
    let below = path.strip_prefix(start)?.with_extension("");
    let modules = below.iter().filter_map(|part| part.to_str());
    let mut module = vec![name.to_owned()];
    module.extend(modules.filter(|part| !["lib", "mod"].contains(part)).map(str::to_owned));
    let functions = functions(&text, module).with_context(|| path.display().to_string())?;
    Ok(Source { path, text, functions })
}

fn functions(text: &str, module: Vec<String>) -> anyhow::Result<Vec<Function>> {
    let file = syn::parse_file(text)?;
    let mut finder = Finder { text, path: module, functions: Vec::new() };
    finder.visit_file(&file);
    Ok(finder.functions)
}

/// Collects the functions of a file, without those of its tests.
struct Finder<'t> {
    text: &'t str,
    path: Vec<String>,
    functions: Vec<Function>,
}

impl Finder<'_> {
    fn within(&mut self, name: String, walk: impl FnOnce(&mut Self)) {
        self.path.push(name);
        walk(self);
        self.path.pop();
    }

    fn add(&mut self, signature: &syn::Signature, body: &syn::Block) {
        let mut path = self.path.clone();
        path.push(signature.ident.to_string());
        let mut expressions = Expressions(Vec::new());
        expressions.visit_block(body);
        let is_const = signature.constness.is_some();
        self.functions.push(Function { path, is_const, expressions: expressions.0 });
    }

    /// Collects the closures of a constant, such as a table of columns: they run later and can be
    /// switched.
    fn add_closures(&mut self, ident: &syn::Ident, value: &syn::Expr) {
        let mut closures = Closures(Expressions(Vec::new()));
        closures.visit_expr(value);
        let mut path = self.path.clone();
        path.push(ident.to_string());
        self.functions.push(Function { path, is_const: false, expressions: closures.0.0 });
    }
}

impl<'a> Visit<'a> for Finder<'_> {
    fn visit_item_mod(&mut self, module: &'a syn::ItemMod) {
        let is_test = |attribute: &syn::Attribute| {
            attribute.path().is_ident("cfg")
                && attribute.parse_args::<syn::Ident>().is_ok_and(|ident| ident == "test")
        };
        if !module.attrs.iter().any(is_test) {
            self.within(module.ident.to_string(), |finder| visit::visit_item_mod(finder, module));
        }
    }

    fn visit_item_impl(&mut self, item: &'a syn::ItemImpl) {
        let name = match item.self_ty.as_ref() {
            syn::Type::Path(path) => path.path.segments.last().map(|s| s.ident.to_string()),
            _ => None,
        };
        // A type such as `[f64; 2]` has no name except its text.
        let name = name.unwrap_or_else(|| self.text[item.self_ty.span().byte_range()].to_owned());
        self.within(name, |finder| {
            visit::visit_item_impl(finder, item);
        });
    }

    fn visit_item_trait(&mut self, item: &'a syn::ItemTrait) {
        self.within(item.ident.to_string(), |finder| visit::visit_item_trait(finder, item));
    }

    fn visit_item_fn(&mut self, function: &'a syn::ItemFn) {
        self.add(&function.sig, &function.block);
    }

    fn visit_item_const(&mut self, item: &'a syn::ItemConst) {
        self.add_closures(&item.ident, &item.expr);
    }

    fn visit_impl_item_const(&mut self, item: &'a syn::ImplItemConst) {
        self.add_closures(&item.ident, &item.expr);
    }

    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.add(&function.sig, &function.block);
    }

    fn visit_trait_item_fn(&mut self, function: &'a syn::TraitItemFn) {
        if let Some(body) = &function.default {
            self.add(&function.sig, body);
        }
    }
}

/// Collects whole expressions of a body, so that a mutant never cuts one.
struct Expressions(Vec<Range<usize>>);

impl<'a> Visit<'a> for Expressions {
    fn visit_expr(&mut self, expression: &'a syn::Expr) {
        self.0.push(expression.span().byte_range());
        visit::visit_expr(self, expression);
    }
}

/// Collects the expressions in closures only.
struct Closures(Expressions);

impl<'a> Visit<'a> for Closures {
    fn visit_expr_closure(&mut self, closure: &'a syn::ExprClosure) {
        self.0.visit_expr(&closure.body);
    }
}

/// Finds the place of a mutant.
pub(super) fn find(mutant: &Mutant, sources: &[Source]) -> anyhow::Result<Place> {
    let wanted = bare(&mutant.find);
    let mut items = Vec::new();
    let mut places = Vec::new();
    for (index, source) in sources.iter().enumerate() {
        for function in source.functions.iter().filter(|f| is_named(&f.path, &mutant.item)) {
            items.push(function.path.join("::"));
            let mut ranges: Vec<_> = function.expressions.clone();
            ranges.retain(|range| bare(&source.text[range.clone()]) == wanted);
            ranges.sort_by_key(|range| (range.start, range.end));
            ranges.dedup();
            let place = |range| (function.is_const, Place { source: index, range });
            places.extend(ranges.into_iter().map(place));
        }
    }
    ensure!(!items.is_empty(), "no such function");
    let found = places.len();
    let (is_const, place) = match (mutant.nth, found) {
        (_, 0) => bail!("no expression `{}` in {}", mutant.find, items.join(", ")),
        (None, 1) => places.remove(0),
        (None, _) => bail!("`{}` occurs {found} times in {}", mutant.find, items.join(", ")),
        (Some(nth), _) if nth <= found => places.remove(nth - 1),
        (Some(nth), _) => bail!("`{}` occurs {found} times only, not {nth}", mutant.find),
    };
    ensure!(!is_const, "a const function cannot be switched: name a function that uses it");
    Ok(place)
}

/// Whether the path begins with the item's crate and ends with the rest of the item.
fn is_named(path: &[String], item: &str) -> bool {
    let item: Vec<&str> = item.split("::").collect();
    let Some((crate_name, rest)) = item.split_first() else { return false };
    path[0] == *crate_name
        && rest.len() < path.len()
        && path[path.len() - rest.len()..].iter().zip(rest).all(|(one, other)| one == other)
}

/// The text without white space.
fn bare(text: &str) -> String {
    text.split_whitespace().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "impl Law { fn energy(&self) -> f64 { 0.4 * self.force() * 2.0 + 2.0 } }\n\
                        const fn fixed() -> f64 { 2.0 }\n\
                        const COLUMNS: &[Column] = &[new(3.0, |law| law.force())];\n\
                        #[cfg(test)] mod tests { fn energy() { 0.4 } }\n";

    fn place(item: &str, find: &str, nth: Option<usize>) -> anyhow::Result<String> {
        let module = vec!["carom_laws".to_owned(), "law".to_owned()];
        let functions = functions(TEXT, module)?;
        let sources = [Source { path: PathBuf::new(), text: TEXT.to_owned(), functions }];
        let (item, find) = (item.to_owned(), find.to_owned());
        let mutant = Mutant {
            item,
            find,
            nth,
            name: String::new(),
            replace: String::new(),
            explained: None,
        };
        Ok(TEXT[super::find(&mutant, &sources)?.range].to_owned())
    }

    #[test]
    fn an_expression_is_found_by_function_and_text() {
        assert_eq!(
            place("carom_laws::Law::energy", "0.4*self.force()", None).unwrap(),
            "0.4 * self.force()"
        );
        assert_eq!(place("carom_laws::law::Law::energy", "2.0", Some(2)).unwrap(), "2.0");
        assert_eq!(place("carom_laws::COLUMNS", "law.force()", None).unwrap(), "law.force()");
    }

    #[test]
    fn a_place_that_is_none_is_refused() {
        let error = |item, find, nth| place(item, find, nth).unwrap_err().to_string();
        assert_eq!(error("carom_laws::Law::force", "1", None), "no such function");
        assert_eq!(error("carom_impact::Law::energy", "0.4", None), "no such function");
        // A part of a product is not an expression.
        let cut = error("carom_laws::Law::energy", "self.force() * 2.0", None);
        assert!(cut.starts_with("no expression"), "{cut}");
        let twice = error("carom_laws::Law::energy", "2.0", None);
        assert_eq!(twice, "`2.0` occurs 2 times in carom_laws::law::Law::energy");
        assert!(error("carom_laws::Law::energy", "2.0", Some(3)).contains("2 times only"));
        assert!(error("carom_laws::fixed", "2.0", None).starts_with("a const function"));
        assert!(error("carom_laws::COLUMNS", "3.0", None).starts_with("no expression"));
    }
}
