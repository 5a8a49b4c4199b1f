//! What is wrong in an input of CONTACT.

/// A number in an input of CONTACT that is missing, wrong, or stands for what carom does not do.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {name} is {value} must be {allowed}")]
pub struct Fault {
    /// The line of the file, from 1.
    pub line: usize,
    /// The name of the number in CONTACT's manual.
    pub name: String,
    /// What the file gives.
    pub value: String,
    /// What is allowed.
    pub allowed: String,
}

impl Fault {
    pub(super) fn new(
        line: usize,
        name: impl Into<String>,
        value: impl ToString,
        allowed: impl Into<String>,
    ) -> Self {
        let mut value = value.to_string();
        if !value.ends_with(',') {
            value.push(',');
        }
        Self { line, name: name.into(), value, allowed: allowed.into() }
    }
}
