//! The control digits of CONTACT: what each value means and what carom does with it.

use super::fault::Fault;
use Does::{Ignores, Obeys, Refuses};

/// What carom does with a value of a control digit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Does {
    /// It does what the value says.
    Obeys,
    /// It reads what belongs to the value, and has its own way.
    Ignores,
    /// It refuses the file before anything is computed.
    Refuses,
}

impl Does {
    /// In a word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Obeys => "does it",
            Ignores => "own way",
            Refuses => "refused",
        }
    }
}

/// A value of a control digit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// The value.
    pub value: u8,
    /// What CONTACT does.
    pub meaning: &'static str,
    /// What carom does.
    pub does: Does,
}

/// A control digit of module 3.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Digit {
    /// Its letter in the manual and in the lines of an input.
    pub letter: char,
    /// Its word there.
    pub word: &'static str,
    /// Its values.
    pub choices: &'static [Choice],
}

const fn choice(value: u8, meaning: &'static str, does: Does) -> Choice {
    Choice { value, meaning, does }
}

const fn digit(letter: char, word: &'static str, choices: &'static [Choice]) -> Digit {
    Digit { letter, word, choices }
}

const OUTPUT: &[Choice] = &[
    choice(0, "print nothing", Ignores),
    choice(1, "print the results", Ignores),
    choice(2, "print the input too", Ignores),
    choice(3, "print a picture of the contact", Ignores),
    choice(4, "print profiles", Ignores),
    choice(5, "print the contact cell by cell", Ignores),
    choice(6, "print all cells", Ignores),
];
const FLOW: &[Choice] = &[
    choice(0, "no trace", Ignores),
    choice(1, "trace of the iterations", Ignores),
    choice(2, "more of it", Ignores),
    choice(3, "more of it", Ignores),
    choice(4, "more of it", Ignores),
    choice(5, "more of it", Ignores),
    choice(6, "more of it", Ignores),
    choice(7, "more of it", Ignores),
    choice(8, "more of it", Ignores),
    choice(9, "all of it", Ignores),
];

/// All digits, in the order of the three lines of an input.
pub const LINES: [&[Digit]; 3] = [
    &[
        digit(
            'C',
            "CONFIG",
            &[
                choice(0, "no wheel and rail", Obeys),
                choice(1, "a right wheel", Refuses),
                choice(4, "a left roller", Refuses),
                choice(5, "a right roller", Refuses),
            ],
        ),
        digit(
            'P',
            "PVTIME",
            &[
                choice(0, "continue from the tractions of the case before", Obeys),
                choice(1, "continue from its pressures", Obeys),
                choice(2, "begin without tractions", Obeys),
            ],
        ),
        digit(
            'B',
            "BOUND",
            &[
                choice(0, "solve for the pressures", Obeys),
                choice(1, "thin sheet", Refuses),
                choice(2, "pressures of Hertz, ellipsoidal; for FASTSIM", Obeys),
                choice(3, "pressures of Hertz, paraboloidal; for FASTSIM", Obeys),
                choice(4, "pressures of two half ellipses (SDEC)", Refuses),
                choice(5, "approximate pressures (KPEC)", Refuses),
                choice(6, "approximate pressures (ANALYN)", Refuses),
            ],
        ),
        digit(
            'T',
            "TANG",
            &[
                choice(0, "no tangential tractions", Obeys),
                choice(1, "a shift", Obeys),
                choice(2, "a step of rolling", Obeys),
                choice(3, "steady rolling", Obeys),
            ],
        ),
        digit(
            'N',
            "NORM",
            &[choice(0, "approach PEN given", Obeys), choice(1, "normal force FN given", Obeys)],
        ),
        digit(
            'F',
            "FORCE",
            &[
                choice(0, "creepages CKSI and CETA given", Obeys),
                choice(1, "force FX and creepage CETA given", Obeys),
                choice(2, "forces FX and FY given", Obeys),
            ],
        ),
        digit(
            'S',
            "STRESS",
            &[
                choice(0, "no stresses below the surface", Obeys),
                choice(1, "stresses at the points given before", Obeys),
                choice(2, "the same, with other output", Obeys),
                choice(3, "stresses at new points", Obeys),
            ],
        ),
    ],
    &[
        digit(
            'V',
            "VARFRC",
            &[
                choice(0, "the same friction everywhere", Obeys),
                choice(1, "friction along a profile", Refuses),
                choice(2, "friction for each row of cells", Obeys),
            ],
        ),
        digit(
            'L',
            "FRCLAW",
            &[
                choice(0, "Coulomb friction", Obeys),
                choice(1, "friction of the case before", Obeys),
                choice(2, "friction linear in the slip velocity; for FASTSIM", Obeys),
                choice(3, "friction rational in the slip velocity; for FASTSIM", Obeys),
                choice(4, "friction exponential in the slip velocity; in steady rolling", Obeys),
                choice(6, "friction by the surface temperature, with memory", Refuses),
            ],
        ),
        digit(
            'D',
            "DISCNS",
            &[
                choice(0, "cells of the case before", Obeys),
                choice(1, "cells by the numbers of a case before", Obeys),
                choice(2, "new cells", Obeys),
            ],
        ),
        digit(
            'C',
            "INFLCF",
            &[
                choice(0, "influence numbers of the case before", Obeys),
                choice(1, "influence numbers for the materials of a case before", Obeys),
                choice(2, "half-spaces, tractions constant in a cell", Obeys),
                choice(3, "half-spaces, bilinear tractions", Refuses),
                choice(4, "half-spaces, corrected by inclinations (Blanco)", Refuses),
                choice(9, "influence numbers of a file", Obeys),
            ],
        ),
        digit(
            'M',
            "MATER",
            &[
                choice(0, "elastic bodies", Obeys),
                choice(1, "viscoelastic bodies with relaxation", Refuses),
                choice(2, "FASTSIM with one flexibility; in steady rolling", Obeys),
                choice(3, "FASTSIM with three flexibilities; in steady rolling", Obeys),
                choice(4, "elastic bodies with an elastic-plastic interfacial layer", Refuses),
                choice(5, "FASTRIP", Refuses),
            ],
        ),
        digit(
            'Z',
            "RZNORM",
            &[
                choice(0, "undeformed distance of the case before", Obeys),
                choice(1, "undeformed distance by the numbers of a case before", Obeys),
                choice(2, "new undeformed distance", Obeys),
            ],
        ),
        digit(
            'E',
            "EXRHS",
            &[
                choice(0, "no extra rigid slip", Obeys),
                choice(1, "extra rigid slip of the case before", Obeys),
                choice(2, "no spin in the slip along y", Refuses),
                choice(3, "no spin in the slip along x", Refuses),
                choice(9, "extra rigid slip of each cell", Obeys),
            ],
        ),
    ],
    &[
        digit(
            'X',
            "XFLOW",
            &[choice(0, "no debug output", Ignores), choice(1, "debug output", Ignores)],
        ),
        digit(
            'H',
            "HEAT",
            &[
                choice(0, "no temperature", Obeys),
                choice(1, "temperature by the numbers of a case before", Refuses),
                choice(3, "temperature", Refuses),
            ],
        ),
        digit(
            'G',
            "GAUSEI",
            &[
                choice(0, "default solvers", Ignores),
                choice(1, "solvers of the case before", Ignores),
                choice(2, "ConvexGS: keeps DQ and CHI of steady rolling", Ignores),
                choice(3, "SteadyGS", Ignores),
                choice(4, "default solvers, initial slip given", Ignores),
                choice(5, "GDsteady", Ignores),
            ],
        ),
        digit(
            'I',
            "IESTIM",
            &[
                choice(0, "no initial estimate", Ignores),
                choice(1, "the case before, regularized", Ignores),
                choice(2, "its pressures", Ignores),
                choice(3, "the case before", Ignores),
            ],
        ),
        digit(
            'A',
            "MATFIL",
            &[
                choice(0, "no Matlab file", Ignores),
                choice(1, "a Matlab file of the contact", Ignores),
                choice(2, "a Matlab file of all cells", Ignores),
            ],
        ),
        digit('O', "OUTPUT", OUTPUT),
        digit('W', "FLOW", FLOW),
        digit(
            'R',
            "RETURN",
            &[
                choice(0, "solve, then a case without a module number", Obeys),
                choice(1, "solve, then a module number", Obeys),
                choice(2, "only read, then a case without a module number", Obeys),
                choice(3, "only read, then a module number", Obeys),
            ],
        ),
    ],
];

/// The values of the digits of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Digits([u8; 8]);

impl Digits {
    /// Splits a control word of this line of [`LINES`], whose leading zeros may be missing.
    pub(super) fn read(line: usize, number: usize, word: &str) -> Result<Self, Fault> {
        let table = LINES[line];
        let fault = |name: String, value: String, allowed: String| {
            Err(Fault::new(number, name, value, allowed))
        };
        let letters: String = table.iter().map(|digit| digit.letter).collect();
        let plain = !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
        let digits = word.trim_start_matches('0');
        if !plain || digits.len() > table.len() {
            let allowed = format!("one digit for each letter, at most {} digits", table.len());
            return fault(format!("control digits {letters}"), word.to_owned(), allowed);
        }
        let mut values = [0; 8];
        let places = values.iter_mut().skip(table.len() - digits.len());
        places.zip(digits.bytes()).for_each(|(place, byte)| *place = byte - b'0');
        for (digit, value) in table.iter().zip(values) {
            let name = || format!("control digit {} ({})", digit.letter, digit.word);
            let found = digit.choices.iter().find(|choice| choice.value == value);
            match found {
                Some(Choice { does: Refuses, meaning, .. }) => {
                    let value = format!("{value} ({meaning}), which carom does not do,");
                    return fault(name(), value, digit.allowed());
                }
                None => return fault(name(), value.to_string(), digit.allowed()),
                Some(_) => {}
            }
        }
        Ok(Self(values))
    }

    /// The value of the digit at this place of its line, from 0.
    pub(super) const fn at(self, place: usize) -> u8 {
        self.0[place]
    }
}

impl Digit {
    /// The values that are not refused, with their meanings.
    fn allowed(&self) -> String {
        let open = self.choices.iter().filter(|choice| choice.does != Refuses);
        let texts: Vec<_> =
            open.map(|choice| format!("{} ({})", choice.value, choice.meaning)).collect();
        match texts.as_slice() {
            [one] => one.clone(),
            many => format!("one of {}", many.join(", ")),
        }
    }
}
