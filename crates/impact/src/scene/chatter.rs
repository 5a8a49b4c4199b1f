//! Bounces off two walls in turn, again and again within a fraction of the duration of one: the ball is held between them.

/// Bounces follow each other too fast if less than this part of the shorter contact lies between them.
const SOON: f64 = 0.01;
/// So many of them in succession end a path. A corner without friction gives a few.
const MOST: usize = 32;

/// The last bounce, and how many before it came too fast.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Chatter {
    wall: usize,
    other: usize,
    time: f64,
    duration: f64,
    count: usize,
}

impl Chatter {
    /// Counts a bounce.
    pub(super) fn add(&mut self, wall: usize, time: f64, duration: f64) {
        let is_soon = time - self.time < SOON * duration.min(self.duration);
        let count = if is_soon && wall != self.wall { self.count + 1 } else { 0 };
        *self = Self { wall, other: self.wall, time, duration, count };
    }

    /// The two walls that hold the ball, in order.
    pub(super) fn walls(&self) -> Option<(usize, usize)> {
        (self.count >= MOST).then(|| (self.wall.min(self.other), self.wall.max(self.other)))
    }
}
