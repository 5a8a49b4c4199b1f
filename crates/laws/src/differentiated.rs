//! The contact law in one direction with the derivatives of its load by friction and stiffness.
//!
//! The law depends on friction f and stiffness by the scales of [`crate::memory`] alone: `F = (2/3) f c_z Phi` of the
//! path of `X = c_x xi/(f c_z)` over zeta. A factor of all X changes Phi by `Phi' = (3/2) int (X - W'(t^2)) dt`, where
//! W' is how the zero-traction shift W of an annulus answers to the factor. An annulus that adheres keeps the X at
//! which it came into contact, `W' = W`; one that slips keeps its distance from the X at which it slipped last, `W' =
//! X` of then. Both last until it slips again, so that one number for each slip segment of the polyline suffices, and
//! Phi' is closed. It is continuous where memory is wiped out and where sliding begins; it jumps only for annuli that
//! form just on the limit of adhesion, |dX| = d zeta.

use carom_special::RangeError;

use crate::friction::Friction;
use crate::law::{ContactLaw, ContactLoad, LoadSensitivity, Sensitive, Shift};
use crate::memory::{Growing, Memory, MemoryRegime, Nodes, Vertex};
use crate::shift_law::ShiftLaw;
use crate::stiffness::ContactStiffness;

/// Slopes of the path closer to that of the cone than this are on it.
const ON_CONE: f64 = 1e-12;

/// [`ShiftLaw`] for shifts along x, with the derivatives of its load.
///
/// ```
/// use carom_laws::differentiated::Differentiated;
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLaw, Sensitive, Shift};
/// use carom_laws::stiffness::ContactStiffness;
/// let mut law = Differentiated::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?)?;
/// law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
/// law.advance(Shift { zeta: 1.0, xi: 0.1, ..Shift::default() })?;
/// // Cattaneo and Mindlin: F = f F_z (1 - s^(3/2)), s = 1 - c_x xi/(f c_z zeta).
/// let (found, s) = (law.sensitivity(), 1.0 - 0.1_f64 / (0.3 * 1.2));
/// assert!((found.by_c_x.f_x - 0.1 * s.sqrt()).abs() < 1e-14);
/// assert!((found.by_friction.f_x - 0.8 * (1.0 - s.powf(1.5) - 1.5 * s.sqrt() * (1.0 - s))).abs() < 1e-14);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Differentiated {
    law: ShiftLaw<f64>,
    /// One for each segment of the polyline.
    origins: Vec<Origin>,
}

/// How a segment of the polyline came to be.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Origin {
    vertex: Vertex<f64>,
    /// The normalised shift at which it slipped last; none if it adheres.
    slipped_at: Option<f64>,
    is_at_change: bool,
}

impl Differentiated {
    /// The law in its initial state: bodies at first contact, without shift.
    ///
    /// # Errors
    /// [`RangeError`] unless friction is above 0: without friction no derivative by it exists. It may be infinite.
    pub fn new(stiffness: ContactStiffness, friction: Friction) -> Result<Self, RangeError> {
        let f = friction.get();
        RangeError::check("friction", f, f > 0.0, "> 0 for derivatives by it")?;
        Ok(Self { law: ShiftLaw::new(stiffness, friction), origins: Vec::new() })
    }

    /// The law itself.
    #[must_use]
    pub const fn law(&self) -> &ShiftLaw<f64> {
        &self.law
    }

    /// Notes how the topmost segment came to be, the only one that a step changes or adds.
    fn note(&mut self, is_at_change: bool) {
        let Some(memory) = self.law.memory() else { return };
        let stack = memory.stack();
        self.origins.truncate(stack.len());
        let Some(top) = stack.len().checked_sub(1) else { return };
        let vertex = *stack.get(top);
        if self.origins.get(top).is_some_and(|origin| origin.vertex == vertex) {
            return;
        }
        self.origins.truncate(top);
        let adheres = memory.regime() == MemoryRegime::Adhesion;
        let slipped_at = (!adheres).then(|| memory.shift());
        self.origins.push(Origin { vertex, slipped_at, is_at_change });
    }
}

/// Whether a step grows along the cone of friction.
fn is_on_cone(memory: &Memory<f64, Growing<f64>>, zeta: f64, shift: f64) -> bool {
    let (growth, along) = (zeta - memory.zeta(), (shift - memory.shift()).abs());
    growth > 0.0 && (along - growth).abs() <= ON_CONE * growth
}

impl Origin {
    /// The part of Phi' of the annuli from this segment's lower end to the depth `end`, at the normalised shift `x`.
    fn part(&self, end: f64, x: f64) -> f64 {
        let Vertex { depth, anchor, slope, .. } = self.vertex;
        let (low, high) = (depth.sqrt(), end.sqrt());
        let width = high - low;
        let cubes = (high * end - low * depth) / 3.0;
        match self.slipped_at {
            Some(then) => 1.5 * (x - then) * width,
            None => 1.5 * ((x - anchor + slope * depth) * width - slope * cubes),
        }
    }
}

impl ContactLaw for Differentiated {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let to = self.law.reachable(shift)?;
        let is_at_change =
            self.law.memory().is_some_and(|memory| is_on_cone(memory, shift.zeta, to));
        let load = self.law.advance(shift)?;
        self.note(is_at_change);
        Ok(load)
    }

    fn shift(&self) -> Shift {
        self.law.shift()
    }

    fn load(&self) -> ContactLoad {
        self.law.load()
    }
}

impl Sensitive for Differentiated {
    fn sensitivity(&self) -> LoadSensitivity {
        let (stiffness, load) = (self.law.stiffness(), self.law.load());
        let tangential = |f_x: f64| ContactLoad { f_x, ..ContactLoad::default() };
        let normal = load.f_z / stiffness.c_z;
        let (Some(memory), Some(friction)) = (self.law.memory(), self.law.friction().coefficient())
        else {
            // Without slip the force is proportional to c_x.
            let by_c_z = ContactLoad { f_z: normal, ..ContactLoad::default() };
            let by_c_x = tangential(load.f_x / stiffness.c_x);
            return LoadSensitivity { by_c_x, by_c_z, ..LoadSensitivity::default() };
        };
        let (x, unit) = (memory.shift(), 2.0 / 3.0 * friction * stiffness.c_z);
        let ends = self.origins.iter().skip(1).map(|above| above.vertex.depth);
        let ends = ends.chain([memory.zeta()]);
        let parts = self.origins.iter().zip(ends).map(|(origin, end)| origin.part(end, x));
        let by_shifts = unit * parts.sum::<f64>();
        LoadSensitivity {
            by_friction: tangential((load.f_x - by_shifts) / friction),
            by_c_x: tangential(by_shifts / stiffness.c_x),
            by_c_z: ContactLoad {
                f_z: normal,
                ..tangential((load.f_x - by_shifts) / stiffness.c_z)
            },
            is_at_change: self.origins.iter().any(|origin| origin.is_at_change),
        }
    }
}
