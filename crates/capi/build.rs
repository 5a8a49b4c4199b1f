//! Tells the crate which compiler builds it, for the marks of what is kept in the caller's bytes.

use std::env::var_os;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let rustc = var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let about =
        Command::new(rustc).arg("-vV").output().expect("the compiler that builds this runs");
    assert!(about.status.success(), "the compiler does not say its version");
    let about = String::from_utf8_lossy(&about.stdout);
    let target = std::env::var("TARGET").unwrap_or_default();
    println!(
        "cargo::rustc-env=CAROM_COMPILER={} {target}",
        about.lines().collect::<Vec<_>>().join(" ")
    );
}
