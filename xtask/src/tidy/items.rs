//! Whether an item of the code is there.

use super::read;
use anyhow::Context as _;
use std::collections::BTreeSet;
use std::path::Path;
use syn::visit::{self, Visit};

/// What is wrong with `crate/file.rs::Type::function`; nothing if it is there.
pub(super) fn fault(root: &Path, item: &str) -> anyhow::Result<Option<String>> {
    let Some((file, path)) = item.split_once("::") else {
        return Ok(Some(format!("`{item}` names no item")));
    };
    let (folder, below) = file.split_once('/').unwrap_or((file, ""));
    let folder = if folder == "verification" { folder.into() } else { format!("crates/{folder}") };
    let source = Path::new(&folder).join("src").join(below);
    if !root.join(&source).is_file() {
        return Ok(Some(format!("no file {} for `{item}`", source.display())));
    }
    let names = names(&read(&root.join(&source))?).with_context(|| source.display().to_string())?;
    let is_there = names.contains(path);
    Ok((!is_there).then(|| format!("no `{path}` in {}", source.display())))
}

/// `function`, `Type`, `Type::function`: what stands in a source, its tests left out.
fn names(text: &str) -> anyhow::Result<BTreeSet<String>> {
    let mut finder = Finder { owner: None, names: BTreeSet::new() };
    finder.visit_file(&syn::parse_file(text)?);
    Ok(finder.names)
}

struct Finder {
    owner: Option<String>,
    names: BTreeSet<String>,
}

impl Finder {
    fn add(&mut self, ident: &syn::Ident) {
        let name = match &self.owner {
            Some(owner) => format!("{owner}::{ident}"),
            None => ident.to_string(),
        };
        self.names.insert(name);
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
        self.add(&item.ident);
        let owner = Some(item.ident.to_string());
        self.within(owner, |finder| visit::visit_item_trait(finder, item));
    }

    fn visit_item_struct(&mut self, item: &'a syn::ItemStruct) {
        self.add(&item.ident);
    }

    fn visit_item_enum(&mut self, item: &'a syn::ItemEnum) {
        self.add(&item.ident);
    }

    fn visit_item_const(&mut self, item: &'a syn::ItemConst) {
        self.add(&item.ident);
    }

    fn visit_item_fn(&mut self, function: &'a syn::ItemFn) {
        self.add(&function.sig.ident);
    }

    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.add(&function.sig.ident);
    }

    fn visit_impl_item_const(&mut self, item: &'a syn::ImplItemConst) {
        self.add(&item.ident);
    }

    fn visit_trait_item_fn(&mut self, function: &'a syn::TraitItemFn) {
        self.add(&function.sig.ident);
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
        let names = names(text).unwrap();
        for name in ["Law", "Law::A", "Law::go", "Moves", "Moves::go", "B", "free"] {
            assert!(names.contains(name), "{name}");
        }
        assert_eq!(names.len(), 7, "{names:?}");
    }

    #[test]
    fn what_is_not_there_is_said() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let fault = |item| fault(&root, item).unwrap();
        assert_eq!(fault("special/gamma.rs::gamma"), None);
        assert!(fault("special/gamma.rs::delta").unwrap().contains("no `delta`"));
        assert!(fault("special/delta.rs::gamma").unwrap().contains("no file"));
        assert!(fault("special/gamma.rs").unwrap().contains("names no item"));
    }
}
