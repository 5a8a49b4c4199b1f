//! The header in the repository is the one generated from the sources.

mod c89;
mod groups;

use std::path::Path;

/// Its first lines. Which declarations follow, and in what order, is in `groups`.
const HEAD: &str = include_str!("head.h");
const OPEN: &str = "#ifdef __cplusplus\nextern \"C\" {\n#endif";
const CLOSE: &str = "#ifdef __cplusplus\n}\n#endif\n\n#endif /* CAROM_H */\n";

/// With `CAROM_GENERATE` set it is written anew.
#[test]
fn header_is_current() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("include/carom.h");
    let made = made(root);
    if std::env::var_os("CAROM_GENERATE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == made, "include/carom.h is not what the sources make: cargo xtask generate");
}

fn made(root: &Path) -> String {
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    let modules = groups::Modules::read(root, &config);
    // It follows the modules itself; grains, walls and heats are those of the layer below.
    let builder = cbindgen::Builder::new().with_config(config).with_src(root.join("src/lib.rs"));
    let builder = groups::BELOW.iter().fold(builder, |builder, below| {
        builder.with_src(root.join("../laws/src/grains").join(below))
    });
    let mut declared = Vec::new();
    builder.generate().unwrap().write(&mut declared);
    let declared = String::from_utf8(declared).unwrap();
    let groups = modules.arrange(&declared);
    c89::from(&format!("{HEAD}{}\n{OPEN}\n{groups}\n{CLOSE}", groups::contents()))
}
