//! The header in the repository is the one generated from the sources.

use std::path::Path;

/// With `CAROM_GENERATE` set it is written anew.
#[test]
fn header_is_current() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    // It follows the modules itself; grains, walls and heats are those of the layer below.
    let laws = root.join("../laws/src/grains");
    let builder = cbindgen::Builder::new()
        .with_config(config)
        .with_src(root.join("src/lib.rs"))
        .with_src(laws.join("meeting.rs"))
        .with_src(laws.join("contact.rs"));
    let mut made = Vec::new();
    builder.generate().unwrap().write(&mut made);
    let made = String::from_utf8(made).unwrap();
    let declared: Vec<_> = made.lines().filter_map(|line| line.split_once('(')).collect();
    let mut functions: Vec<_> = declared
        .iter()
        .filter(|(start, _)| start.contains(" carom_") || start.contains("*carom_"))
        .collect();
    let all = functions.len();
    functions.sort();
    functions.dedup();
    assert!(all > 20 && functions.len() == all, "functions are declared twice");
    let path = root.join("include/carom.h");
    if std::env::var_os("CAROM_GENERATE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        kept == made,
        "include/carom.h is not what the sources make: \
         cargo xtask generate"
    );
}
