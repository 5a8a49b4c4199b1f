//! Comments and lists as every C compiler accepts them, with `-std=c89 -pedantic` too.

/// The text with its `//` comments as `/* */`, and no comma after the last value of an enumeration.
pub(super) fn from(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut made = String::new();
    for (i, line) in lines.iter().enumerate() {
        let next = lines.get(i + 1).copied().unwrap_or_default();
        let before = i.checked_sub(1).map_or("", |before| lines[before]);
        match comment(line) {
            Some((indent, words)) => {
                assert!(!words.contains("*/") && !words.contains("/*"), "{line}");
                let start = if comment(before).is_some() { " *" } else { "/*" };
                let end = if comment(next).is_some() { "" } else { " */" };
                made.push_str(&format!("{indent}{start}{words}{end}"));
            }
            None => match line.split_once(" // ") {
                Some((code, words)) => made.push_str(&format!("{} /* {words} */", code.trim_end())),
                None if next == "};" => made.push_str(line.strip_suffix(',').unwrap_or(line)),
                None => made.push_str(line),
            },
        }
        made.push('\n');
    }
    made
}

/// The indentation and the words of a line that is a comment.
fn comment(line: &str) -> Option<(&str, &str)> {
    let words = line.trim_start().strip_prefix("//")?;
    Some((&line[..line.len() - line.trim_start().len()], words))
}

#[test]
fn comments_are_of_c89() {
    let text = "// One\n// two.\nenum a\n#if X\n  : int\n#endif // X\n{\n  // b.\n  B,\n};\n";
    let made =
        "/* One\n * two. */\nenum a\n#if X\n  : int\n#endif /* X */\n{\n  /* b. */\n  B\n};\n";
    assert_eq!(from(text), made);
}
