//! Coefficients of friction: FRCLAW and VARFRC.

use super::super::falling::Falling;
use super::super::fault::Fault;
use super::Reader;

/// Relative difference of FSTAT and FKIN that counts as none.
const SAME_FRICTION: f64 = 1e-3;
/// What is told where friction falls.
const FROM_REST: &str = "where friction falls fast with slip there are several steady states: this one is reached from rest";

impl Reader<'_> {
    /// Reads the friction that all cells have.
    pub(super) fn uniform_friction(&mut self) -> Result<(), Fault> {
        match (self.frclaw(), self.varfrc()) {
            (0, 0) => {
                self.friction = Some(([self.friction_numbers()?].into(), true));
                self.falling = None;
            }
            (law @ 2..=4, 0) => {
                let falling = Falling::read(&mut self.lines, law)?;
                self.friction = Some(([falling.at(0.0)].into(), true));
                self.falling = Some(falling);
            }
            _ => {}
        }
        Ok(())
    }

    /// Reads the friction of each row of cells.
    pub(super) fn friction_of_rows(&mut self, rows: usize) -> Result<(), Fault> {
        if self.frclaw() != 1 && self.varfrc() == 2 {
            let all: Result<Vec<f64>, _> = (0..rows).map(|_| self.friction_numbers()).collect();
            self.friction = Some((all?.into(), false));
            self.falling = None;
        }
        Ok(())
    }

    fn friction_numbers(&mut self) -> Result<f64, Fault> {
        let [rest, motion] = self.lines.numbers(["FSTAT", "FKIN"])?;
        let value = rest.checked(|value| value >= 1e-4, "at least 1e-4")?;
        let same = |motion: f64| (motion - value).abs() <= SAME_FRICTION * value;
        motion.checked(same, &format!("FSTAT = {value}: CONTACT has one coefficient"))?;
        Ok(value)
    }

    /// The friction of a case by its slip velocity.
    pub(super) fn falling_friction(
        &self,
        notes: &mut Vec<String>,
    ) -> Result<Option<Falling>, Fault> {
        let Some(falling) = self.falling.filter(|_| self.tang() != 0) else { return Ok(None) };
        if self.fastsim.is_none() {
            falling.check_solver(self.line)?;
            if self.tang() != 3 {
                let allowed = "0 or 3 with L = 4: carom has no steps with friction that falls";
                return Err(self.digit("T (TANG)", self.tang(), allowed));
            }
            notes.push(FROM_REST.to_owned());
        }
        Ok(Some(falling))
    }
}
