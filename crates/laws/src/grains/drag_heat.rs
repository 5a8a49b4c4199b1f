//! The heat of the damping of the normal motion.

use carom_special::RangeError;

/// What the heat of damping needs of the steps before.
///
/// A leapfrog knows forces at the ends of steps and speeds in their middle. The product of a speed with the mean of the
/// two forces about it is the work that the step does on the discrete motion. But the smooth motion on which its places
/// lie has another energy: books by this mean lose a part of the order dt^2 of the heat in each impact. With the speed at
/// a place by the four nearest half steps, `(7 (v_+ + v_-) - (v_++ + v_--))/12`, they are of the order dt^4. Products of a
/// force and a speed are counted once both are known, and so that the last force always has counted half.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub(super) struct DragHeat {
    /// The damping force at the beginning of the last step.
    pub(super) drag: f64,
    /// The speed of approach in the last step.
    pub(super) speed: f64,
}

impl DragHeat {
    /// The heat of a step of duration `dt` with the speed of approach `speed` and these damping forces at its
    /// beginning and end. Before the first step of a contact the speed was the same.
    pub(super) fn step(
        &mut self,
        [old, new]: [f64; 2],
        speed: f64,
        dt: f64,
        is_first: bool,
    ) -> f64 {
        let before = if is_first { speed } else { self.speed };
        let twelfths = speed * (7.0 * new + 6.0 * old - self.drag) + before * (self.drag - new);
        *self = Self { drag: old, speed };
        twelfths * (dt / 12.0)
    }
}

/// Checks the heat of a step, which overflows at speeds beyond all range.
pub(super) fn check_heat(heat: f64) -> Result<(), RangeError> {
    RangeError::finite("heat", heat).map(|_| ())
}
