//! The control digits of CONTACT on their page of the book.

use super::{agrees, sources};
use carom_cases::contact::LINES;
use std::fmt::Write as _;

/// Ends the part of the page that is written by hand.
const MARK: &str = "<!-- Made from the table of digits by `cargo xtask generate`. -->\n";

#[test]
fn the_digits_of_contact_are_those_of_their_table() {
    let path = sources().join("tasks/contact.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let (by_hand, _) = page.split_once(MARK).unwrap();
    let mut text = format!("{by_hand}{MARK}");
    for (digits, which) in LINES.iter().zip(["first", "second", "third"]) {
        let letters: String = digits.iter().map(|digit| digit.letter).collect();
        let _ = write!(text, "\n### The {which} line: {letters}\n\n");
        text += "| digit | value | meaning | carom |\n|---|---|---|---|\n";
        for digit in *digits {
            for (place, choice) in digit.choices.iter().enumerate() {
                let name = format!("{} {}", digit.letter, digit.word);
                let name = if place == 0 { name.as_str() } else { "" };
                let (value, meaning) = (choice.value, choice.meaning);
                let _ = writeln!(text, "| {name} | {value} | {meaning} | {} |", choice.does.word());
            }
        }
    }
    agrees(&path, text.as_bytes());
}
