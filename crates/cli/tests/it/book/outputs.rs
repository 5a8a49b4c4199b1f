//! Outputs of commands that a page shows: a block of text behind a block of commands is what these print.

use super::{agrees, run, shelf, sources};

const SHELL: &str = "```sh\n";
const TEXT: &str = "```text\n";
const END: &str = "\n```\n";

/// The page with the outputs of its commands.
fn shown(page: &str) -> String {
    let folder = shelf();
    let (mut made, mut rest) = (String::new(), page);
    while let Some((before, after)) = rest.split_once(SHELL) {
        let (block, after) = after.split_once(END).unwrap();
        let printed = run(&folder, block, page);
        made += &format!("{before}{SHELL}{block}{END}");
        rest = after;
        let text = rest.strip_prefix('\n').and_then(|rest| rest.strip_prefix(TEXT));
        if let Some(text) = text {
            made += &format!("\n{TEXT}{printed}```\n");
            rest = text.split_once("```\n").unwrap().1;
        }
    }
    made + rest
}

#[test]
fn the_page_on_fits_shows_what_its_commands_print() {
    let path = sources().join("tasks/rebounds.md");
    let page = std::fs::read_to_string(&path).unwrap();
    agrees(&path, shown(&page).as_bytes());
}
