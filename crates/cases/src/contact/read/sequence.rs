//! What a case takes from the one before it.

use super::super::case::{Begin, Motion};
use super::super::fault::Fault;
use super::super::potential::Potential;
use super::Reader;

impl Reader<'_> {
    /// Checks what a case takes from the one before it.
    pub(super) fn check_sequence(&self) -> Result<(), Fault> {
        let first = self.number == 1;
        let wrong = |name, value, allowed| Err(self.digit(name, value, allowed));
        match () {
            () if self.frclaw() == 1 && self.friction.is_none() => {
                wrong("L (FRCLAW)", 1, "0 in the first case")
            }
            () if self.discns() != 2 && self.area.is_none() => {
                wrong("D (DISCNS)", self.discns(), "2 in the first case")
            }
            () if self.inflcf() < 2 && self.materials.is_none() => {
                wrong("C (INFLCF)", self.inflcf(), "2 or 9 in the first case")
            }
            () if self.inflcf() < 2 && self.is_rolling() && !self.was_rolling => {
                wrong("C (INFLCF)", self.inflcf(), "2 or 9 in the first case that rolls")
            }
            () if self.inflcf() == 0 && !self.is_rolling() && self.was_rolling => {
                wrong("C (INFLCF)", 0, "1, 2 or 9 when shifts follow on rolling")
            }
            () if self.rznorm() == 0 && (first || self.discns() != 0) => {
                wrong("Z (RZNORM)", 0, "1 or 2 with new cells")
            }
            () if self.exrhs() == 1 && self.extra.is_none() && first => {
                wrong("E (EXRHS)", 1, "0 or 9 in the first case")
            }
            () if matches!(self.stress(), 1 | 2) && self.blocks.is_empty() => {
                wrong("S (STRESS)", self.stress(), "0 or 3 before points are given")
            }
            () => Ok(()),
        }
    }

    /// The state a case begins from.
    pub(super) fn begin(
        &self,
        area: Potential,
        motion: Motion,
        notes: &mut Vec<String>,
    ) -> Result<Begin, Fault> {
        let remembers = matches!(motion, Motion::Shift | Motion::Step(_));
        let begin = match self.pvtime() {
            0 => Begin::Tractions,
            1 => Begin::Pressures,
            _ => return Ok(Begin::Apart),
        };
        let Some(before) = self.solved.filter(|_| remembers) else {
            if remembers {
                notes.push("P = 2 in the first case, as CONTACT does".to_owned());
            }
            return Ok(Begin::Apart);
        };
        match area.offset_from(&before) {
            Some(_) => Ok(begin),
            None => {
                let allowed = "2 where the cells do not coincide with those of the case before";
                Err(self.digit("P (PVTIME)", self.pvtime(), allowed))
            }
        }
    }
}
