//! The claims of a page as a test: `--list` lists the pages; `--exact ID` fails if a claim of the
//! page fails or the page cannot be computed.

use carom_verification::{Claim, catalogue};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--list") {
        for entry in catalogue().iter().filter(|entry| entry.is_computed()) {
            println!("{}: test", entry.id);
        }
        return;
    }
    let id = arguments.last().expect("a page");
    let entry = catalogue().into_iter().find(|entry| entry.id == *id).expect("a page that is");
    let figure = entry.draw().expect("a page that is done").expect("a figure");
    let failed: Vec<&Claim> = figure.claims.iter().filter(|claim| !claim.passes()).collect();
    assert!(failed.is_empty(), "{failed:?}");
}
