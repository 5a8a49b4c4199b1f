//! The regimes of a coupled impact in order.

use nalgebra::Vector3;

use super::{Sample, Stage};
use crate::oblique::Event;
use crate::outcome::LogEntry;

/// Records each change of stage.
#[derive(Debug, Default)]
pub(crate) struct Log {
    pub(crate) entries: Vec<LogEntry>,
    stage: Option<(Stage, bool)>,
}

impl Log {
    pub(crate) fn see(&mut self, sample: &Sample, initial: &Vector3<f64>) {
        if sample.shift.z <= 0.0 {
            return;
        }
        let forward = sample.force.x * initial.x + sample.force.y * initial.y >= 0.0;
        // The sign matters if an annulus slips.
        let forward = forward || sample.stage == Stage::Adhesion;
        let now = (sample.stage, forward);
        let event = match self.stage {
            None => Event::Touch,
            Some(before) if before == now => return,
            Some((Stage::Slide, _)) if now.0 == Stage::Slide => return,
            Some((before, _)) => Stage::event(before, now.0),
        };
        let time = if self.stage.is_none() { 0.0 } else { sample.time };
        self.entries.push(LogEntry { time, event, regime: now.0.regime(now.1) });
        self.stage = Some(now);
    }
}
