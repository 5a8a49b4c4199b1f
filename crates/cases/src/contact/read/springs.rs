//! FASTSIM: what its digits need of the others.

use super::super::fault::Fault;
use super::super::potential::Ellipse;
use super::super::springs::Bound;
use super::Reader;
use carom_halfspace::MaterialPair;
use carom_solver::Driven;

impl Reader<'_> {
    /// Checks the digits B, M and L beside those of the other lines.
    pub(super) fn check_springs(&self) -> Result<(), Fault> {
        let is_fastsim = matches!(self.mater(), 2 | 3);
        let before = self.fastsim.map_or(0, |fastsim| fastsim.mater());
        let wrong = |name, value, allowed| Err(self.digit(name, value, allowed));
        match () {
            () if is_fastsim && self.tang() != 3 => {
                wrong("M (MATER)", self.mater(), "0 unless T = 3")
            }
            () if is_fastsim && self.force() != 0 => {
                wrong("F (FORCE)", self.force(), "0 with M = 2 or 3")
            }
            () if is_fastsim && self.exrhs() != 0 => {
                wrong("E (EXRHS)", self.exrhs(), "0 with M = 2 or 3")
            }
            () if self.inflcf() < 2 && self.mater() != before => {
                wrong("C (INFLCF)", self.inflcf(), "2 or 9 where M changes")
            }
            () if !is_fastsim && self.bound() != 0 => {
                wrong("B (BOUND)", self.bound(), "0 with M = 0")
            }
            () if self.frclaw() > 1 && self.varfrc() != 0 => {
                wrong("V (VARFRC)", self.varfrc(), "0 with L = 2, 3 or 4")
            }
            () => Ok(()),
        }
    }

    /// The pressures of FASTSIM, and the ellipse for its springs.
    pub(super) fn pressures(
        &self,
        materials: MaterialPair,
        normal: Driven,
    ) -> Result<(Bound, Option<Ellipse>), Fault> {
        let area = self.area.filter(|area| area.is_hertzian() && self.fastsim.is_some());
        let placed = area.map(|area| area.placed(materials, normal)).transpose()?;
        let ellipse = placed.and_then(|placed| placed.ellipse);
        let bound = match (self.bound(), ellipse) {
            (0, _) => Bound::Solved,
            (2, Some(ellipse)) => Bound::Ellipsoidal(ellipse),
            (_, Some(ellipse)) => Bound::Paraboloidal(ellipse),
            (value, None) => {
                return Err(self.digit("B (BOUND)", value, "0 unless IPOTCN is -3 to -1"));
            }
        };
        Ok((bound, ellipse))
    }
}
