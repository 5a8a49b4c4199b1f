//! The items of the code that the index names.

use super::quoted::{self, Kind};
use super::{Number, read};
use anyhow::Context as _;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// The equations quoted in the comments of `crate/file.rs::Type::function`, or the fault of that
/// name.
pub(super) fn quotes(root: &Path, item: &str) -> anyhow::Result<Result<BTreeSet<Number>, String>> {
    let Some((file, path)) = item.split_once("::") else {
        return Ok(Err(format!("`{item}` names no item")));
    };
    let (folder, below) = file.split_once('/').unwrap_or((file, ""));
    let folder = if folder == "verification" { folder.into() } else { format!("crates/{folder}") };
    let source = Path::new(&folder).join("src").join(below);
    if !root.join(&source).is_file() {
        return Ok(Err(format!("no file {} for `{item}`", source.display())));
    }
    let text = read(&root.join(&source))?;
    let items = items(&text).with_context(|| source.display().to_string())?;
    let Some(places) = items.get(path) else {
        return Ok(Err(format!("no `{path}` in {}", source.display())));
    };
    let quotes = places.iter().flat_map(|place| quoted::in_comments(&text[place.clone()]));
    let equations = quotes.filter(|quote| quote.kind == Kind::Equation);
    Ok(Ok(equations.map(|quote| quote.number).collect()))
}

/// The items of a source, `function`, `Type`, `Type::function`, with their comments and without
/// tests.
fn items(text: &str) -> anyhow::Result<BTreeMap<String, Vec<Range<usize>>>> {
    let mut finder = Finder { owner: None, items: BTreeMap::new() };
    finder.visit_file(&syn::parse_file(text)?);
    Ok(finder.items)
}

struct Finder {
    owner: Option<String>,
    items: BTreeMap<String, Vec<Range<usize>>>,
}

impl Finder {
    fn add(&mut self, ident: &syn::Ident, item: &impl Spanned) {
        let name = match &self.owner {
            Some(owner) => format!("{owner}::{ident}"),
            None => ident.to_string(),
        };
        self.items.entry(name).or_default().push(item.span().byte_range());
    }

    fn within(&mut self, owner: Option<String>, walk: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.owner, owner);
        walk(self);
        self.owner = before;
    }
}

impl<'a> Visit<'a> for Finder {
    fn visit_item_mod(&mut self, module: &'a syn::ItemMod) {
        if module.ident != "tests" {
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
        self.add(&item.ident, item);
        let owner = Some(item.ident.to_string());
        self.within(owner, |finder| visit::visit_item_trait(finder, item));
    }

    fn visit_item_struct(&mut self, item: &'a syn::ItemStruct) {
        self.add(&item.ident, item);
    }

    fn visit_item_enum(&mut self, item: &'a syn::ItemEnum) {
        self.add(&item.ident, item);
    }

    fn visit_item_const(&mut self, item: &'a syn::ItemConst) {
        self.add(&item.ident, item);
    }

    fn visit_item_fn(&mut self, function: &'a syn::ItemFn) {
        self.add(&function.sig.ident, function);
    }

    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.add(&function.sig.ident, function);
    }

    fn visit_impl_item_const(&mut self, item: &'a syn::ImplItemConst) {
        self.add(&item.ident, item);
    }

    fn visit_trait_item_fn(&mut self, function: &'a syn::TraitItemFn) {
        self.add(&function.sig.ident, function);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_are_found_by_type_and_name() {
        let text = "pub struct Law; impl Law { const A: f64 = 1.0; fn go(&self) {} }\n\
                    pub trait Moves { fn go(&self); }\nconst B: f64 = 1.0;\nfn free() {}\n\
                    impl Moves for Law { fn go(&self) {} }\n#[cfg(test)] mod tests { fn hidden() {} }\n";
        let items = items(text).unwrap();
        for name in ["Law", "Law::A", "Law::go", "Moves", "Moves::go", "B", "free"] {
            assert!(items.contains_key(name), "{name}");
        }
        assert_eq!(items.len(), 7, "{items:?}");
    }

    #[test]
    fn what_is_not_there_is_said() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let fault = |item| quotes(&root, item).unwrap().unwrap_err();
        assert!(fault("special/gamma.rs::delta").contains("no `delta`"));
        assert!(fault("special/delta.rs::gamma").contains("no file"));
        assert!(fault("special/gamma.rs").contains("names no item"));
    }

    #[test]
    fn an_item_tells_the_equations_in_its_comments() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let quotes = quotes(&root, "classic/rigid_slip.rs::pole_of").unwrap().unwrap();
        assert_eq!(quotes.into_iter().collect::<Vec<_>>(), [(14, 4)]);
    }
}
