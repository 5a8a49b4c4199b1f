//! The items of the code that the index names.

use super::quoted::{self, Kind};
use super::{Number, read};
use anyhow::Context as _;
use std::collections::BTreeSet;
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
    let mut places = items.of.iter().filter(|item| item.name == path).peekable();
    if places.peek().is_none() {
        return Ok(Err(format!("no `{path}` in {}", source.display())));
    }
    let quotes = places.flat_map(|item| quoted::in_comments(&text[item.place.clone()]));
    let equations = quotes.filter(|quote| quote.kind == Kind::Equation);
    Ok(Ok(equations.map(|quote| quote.number).collect()))
}

/// The items of a source.
pub(super) fn items(text: &str) -> anyhow::Result<Items> {
    let mut items = Items::default();
    items.visit_file(&syn::parse_file(text)?);
    Ok(items)
}

/// The items of a source, with their comments and without those of tests.
#[derive(Debug, Default)]
pub(super) struct Items {
    owner: Option<String>,
    pub(super) of: Vec<Item>,
    /// The modules of tests.
    pub(super) tests: Vec<Range<usize>>,
}

/// An item.
#[derive(Debug)]
pub(super) struct Item {
    /// `function`, `Type` or `Type::function`.
    pub(super) name: String,
    pub(super) owner: Option<String>,
    place: Range<usize>,
    pub(super) function: Option<Function>,
}

/// What only a function has.
#[derive(Debug)]
pub(super) struct Function {
    pub(super) has_self: bool,
    pub(super) is_test: bool,
    /// None of a function that a trait requires.
    pub(super) body: Option<Range<usize>>,
}

impl Items {
    fn add(&mut self, ident: &syn::Ident, item: &impl Spanned, function: Option<Function>) {
        let owner = self.owner.clone();
        let name = match &owner {
            Some(owner) => format!("{owner}::{ident}"),
            None => ident.to_string(),
        };
        self.of.push(Item { name, owner, place: item.span().byte_range(), function });
    }

    fn add_function(
        &mut self,
        item: &impl Spanned,
        attributes: &[syn::Attribute],
        signature: &syn::Signature,
        body: Option<&syn::Block>,
    ) {
        let function = Function {
            has_self: signature.receiver().is_some(),
            is_test: attributes.iter().any(|attribute| attribute.path().is_ident("test")),
            body: body.map(|body| body.span().byte_range()),
        };
        self.add(&signature.ident, item, Some(function));
    }

    fn within(&mut self, owner: Option<String>, walk: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.owner, owner);
        walk(self);
        self.owner = before;
    }
}

impl<'a> Visit<'a> for Items {
    fn visit_item_mod(&mut self, module: &'a syn::ItemMod) {
        if module.ident == "tests" {
            self.tests.push(module.span().byte_range());
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
        self.add(&item.ident, item, None);
        let owner = Some(item.ident.to_string());
        self.within(owner, |finder| visit::visit_item_trait(finder, item));
    }

    fn visit_item_struct(&mut self, item: &'a syn::ItemStruct) {
        self.add(&item.ident, item, None);
    }

    fn visit_item_enum(&mut self, item: &'a syn::ItemEnum) {
        self.add(&item.ident, item, None);
    }

    fn visit_item_const(&mut self, item: &'a syn::ItemConst) {
        self.add(&item.ident, item, None);
    }

    fn visit_item_fn(&mut self, function: &'a syn::ItemFn) {
        self.add_function(function, &function.attrs, &function.sig, Some(&function.block));
    }

    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.add_function(function, &function.attrs, &function.sig, Some(&function.block));
    }

    fn visit_impl_item_const(&mut self, item: &'a syn::ImplItemConst) {
        self.add(&item.ident, item, None);
    }

    fn visit_trait_item_fn(&mut self, function: &'a syn::TraitItemFn) {
        self.add_function(function, &function.attrs, &function.sig, function.default.as_ref());
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
            assert!(items.of.iter().any(|item| item.name == name), "{name}");
        }
        // `Law::go` twice.
        assert_eq!(items.of.len(), 8, "{items:?}");
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
