//! The contact law of a shift: Hertz's normal force and Coulomb's friction with memory.

mod pack;
mod tags;
#[cfg(test)]
mod tests;

use carom_special::RangeError;

use crate::bounds::in_memory;
use crate::coulomb::{CoulombMemory, Tolerance};
use crate::friction::Friction;
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, ImpactLaw, Shift};
use crate::memory::{
    AdhesionMemory, Growing, Lateral, Memory, MemoryRegime as Regime, Nodes, Tangent, Turn,
    VertexStack,
};
use crate::static_friction::StaticFriction;
use crate::static_slip::StaticMemory;
use crate::stiffness::ContactStiffness;
use crate::turning_law::TurningLaw;

/// The contact law for shifts: normal force by Hertz, tangential force by Coulomb friction with
/// memory. `V = [f64; 2]` for two directions, `V = f64` for shifts along x.
///
/// It is exact for uncoupled pairs (epsilon = 0, (5.20)) on straight paths, within the assumptions
/// of Cattaneo and Mindlin. If the direction of the shift changes, each annulus slips by itself
/// ([`crate::coulomb`]), to a given [`Tolerance`]; [`ShiftLaw::with_fixed_direction`] is the law of
/// the thesis, with one direction of traction in a slip annulus. If c_x differs from c_y, slip is
/// parallel to the traction in normalised shifts, not in lengths. The twist Omega is stored but has
/// no effect.
///
/// The friction heat is not summed up by default; [`crate::accounted::Accounted`] does that. It is
/// not negative, except in the law of fixed directions if c_x differs from c_y: a step whose
/// direction changes may then return some heat.
///
/// With a [`crate::memory::Fixed`] stack the law is plain data and `Copy`: with 16 vertices it
/// takes 944 bytes in one direction and 1440 in two.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(1.0, 1.0, 1.2)?;
/// let mut law = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::new(0.3)?);
/// law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
/// let load = law.advance(Shift { zeta: 1.0, xi: 9.0, ..Shift::default() })?;
/// assert!((load.f_x - 0.3 * load.f_z).abs() < 1e-15); // gross sliding
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ShiftLaw<V: Lateral, S: VertexStack<V> = Growing<V>> {
    stiffness: ContactStiffness,
    scale: Scale<V>,
    state: State<V, S>,
    shift: Shift,
}

/// Conversion between physical and normalised quantities, per direction.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scale<V> {
    /// X = shift times this.
    shift: V,
    /// F = Phi times this.
    force: f64,
    /// The friction limit divided by sqrt(zeta) dzeta: f c_z; 1 without a limit.
    limit: f64,
}

/// The offset of its tag is known, so that bytes from outside can be checked before they are used
/// as a law.
#[derive(Debug, Clone, PartialEq)]
#[repr(C, u8)]
enum State<V: Lateral, S: VertexStack<V>> {
    /// No friction: no tangential load.
    Frictionless = tags::FRICTIONLESS,
    /// Coulomb friction with one direction of traction in a slip annulus.
    FixedDirection(Memory<V, S>) = tags::FIXED_DIRECTION,
    /// Coulomb friction in two directions, annulus by annulus.
    Coulomb(CoulombMemory<V, S::Curve>) = tags::COULOMB,
    /// Infinite friction.
    Adhesion(AdhesionMemory<V, S>) = tags::ADHESION,
    /// As `FixedDirection`, with static friction above kinetic friction.
    StaticFixedDirection(StaticMemory<Memory<V, S>>) = tags::STATIC_FIXED_DIRECTION,
    /// As `Coulomb`, with static friction above kinetic friction.
    StaticCoulomb(StaticMemory<CoulombMemory<V, S::Curve>>) = tags::STATIC_COULOMB,
}

/// The one place that tells the memories apart: what `$then` makes of the memory, or `$none` without friction.
macro_rules! with_memory {
    ($state:expr, $memory:ident => $then:expr, else $none:expr) => {
        match $state {
            State::Frictionless => $none,
            State::FixedDirection($memory) => $then,
            State::Coulomb($memory) => $then,
            State::Adhesion($memory) => $then,
            State::StaticFixedDirection($memory) => $then,
            State::StaticCoulomb($memory) => $then,
        }
    };
}
use with_memory;

impl<V: Lateral, S: VertexStack<V> + Copy> Copy for ShiftLaw<V, S> where S::Curve: Copy {}
impl<V: Lateral, S: VertexStack<V> + Copy> Copy for State<V, S> where S::Curve: Copy {}

impl<V: Lateral, S: VertexStack<V>> ShiftLaw<V, S> {
    /// A law in its initial state: bodies at first contact, without shift.
    ///
    /// The tolerance for shifts whose direction changes is [`Tolerance::FINE`]; with a stack of
    /// fixed capacity [`Tolerance::PARTICLES`].
    #[must_use]
    pub fn new(stiffness: ContactStiffness, friction: Friction) -> Self {
        let grows = S::default().capacity() == usize::MAX;
        let tolerance = if grows { Tolerance::FINE } else { Tolerance::PARTICLES };
        Self::with_tolerance(stiffness, friction, tolerance)
    }

    /// A law in its initial state, with a tolerance for shifts whose direction changes.
    #[must_use]
    pub fn with_tolerance(
        stiffness: ContactStiffness,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Self {
        match V::DIMENSION {
            1 => Self::with_fixed_direction(stiffness, friction),
            _ => Self::of(stiffness, friction, || State::Coulomb(CoulombMemory::new(tolerance))),
        }
    }

    /// The chosen law in its initial state; the tolerance is used by [`TurningLaw::Coulomb`].
    #[must_use]
    pub fn chosen(
        law: TurningLaw,
        stiffness: ContactStiffness,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Self {
        match law {
            TurningLaw::Coulomb => Self::with_tolerance(stiffness, friction, tolerance),
            TurningLaw::FixedDirection => Self::with_fixed_direction(stiffness, friction),
        }
    }

    /// The law of [`TurningLaw::FixedDirection`] in its initial state: one direction of traction in
    /// a slip annulus, the law of chapter 7. In one direction it is the same as [`ShiftLaw::new`].
    #[must_use]
    pub fn with_fixed_direction(stiffness: ContactStiffness, friction: Friction) -> Self {
        Self::of(stiffness, friction, || State::FixedDirection(Memory::new()))
    }

    /// The chosen law in its initial state, with static friction f_s as a threshold of full sliding
    /// and kinetic friction f_k beyond it.
    ///
    /// Until all of the contact slides, every annulus sticks or slips with f_s. Where the last one
    /// begins to slip, all tractions drop to f_k/f_s of what they were, and the contact slides with
    /// f_k. As soon as an annulus sticks, the limit is that of f_s again. If f_s = f_k it is [`ShiftLaw::chosen`], to the bit.
    ///
    /// A step of any length is exact as far as the law of one coefficient is. With
    /// [`TurningLaw::Coulomb`] the place where sliding begins has the error of the tolerance.
    ///
    /// ```
    /// use carom_laws::coulomb::Tolerance;
    /// use carom_laws::friction::Friction;
    /// use carom_laws::law::{ContactLaw, Shift};
    /// use carom_laws::shift_law::ShiftLaw;
    /// use carom_laws::static_friction::StaticFriction;
    /// use carom_laws::stiffness::ContactStiffness;
    /// use carom_laws::turning_law::TurningLaw;
    /// let stiffness = ContactStiffness::new(1.0, 1.0, 1.0)?;
    /// let friction = StaticFriction::new(Friction::new(0.3)?, Friction::new(0.2)?)?;
    /// let (law, tolerance) = (TurningLaw::Coulomb, Tolerance::FINE);
    /// let mut law =
    ///     ShiftLaw::<[f64; 2]>::with_static_friction(law, stiffness, friction, tolerance);
    /// let f_z = law.advance(Shift { zeta: 1.0, ..Shift::default() })?.f_z;
    /// law.advance(Shift { zeta: 1.0, xi: 0.25, ..Shift::default() })?;
    /// let turned = law.advance(Shift { zeta: 1.0, xi: 0.25, eta: 0.1, ..Shift::default() })?;
    /// assert!(turned.f_x.hypot(turned.f_y) > 0.2 * f_z);
    /// let sliding = law.advance(Shift { zeta: 1.0, xi: 0.25, eta: 1.0, ..Shift::default() })?;
    /// assert!((sliding.f_x.hypot(sliding.f_y) - 0.2 * f_z).abs() < 1e-3 * f_z);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn with_static_friction(
        law: TurningLaw,
        stiffness: ContactStiffness,
        friction: StaticFriction,
        tolerance: Tolerance,
    ) -> Self {
        if !friction.drops() {
            return Self::chosen(law, stiffness, friction.kinetic(), tolerance);
        }
        let ratio = friction.ratio();
        let rubbing = || match law {
            TurningLaw::Coulomb if V::DIMENSION > 1 => {
                State::StaticCoulomb(StaticMemory::new(CoulombMemory::new(tolerance), ratio))
            }
            _ => State::StaticFixedDirection(StaticMemory::new(Memory::new(), ratio)),
        };
        Self::of(stiffness, friction.threshold(), rubbing)
    }

    fn of(
        stiffness: ContactStiffness,
        friction: Friction,
        rubbing: impl FnOnce() -> State<V, S>,
    ) -> Self {
        let along = V::from_components([stiffness.c_x, stiffness.c_y]);
        let (state, limit) = match friction.coefficient() {
            None => (State::Adhesion(AdhesionMemory::new()), 1.0),
            Some(0.0) => (State::Frictionless, 1.0),
            Some(f) => (rubbing(), f * stiffness.c_z),
        };
        let scale = Scale { shift: along.times(1.0 / limit), force: 2.0 / 3.0 * limit, limit };
        Self { stiffness, scale, state, shift: Shift::default() }
    }

    /// The stiffness coefficients.
    #[must_use]
    pub fn stiffness(&self) -> ContactStiffness {
        self.stiffness
    }

    /// The coefficient of friction; that of static friction if it exceeds that of kinetic friction.
    ///
    /// A law made with it has the same bits: where several coefficients do so, it may be another one
    /// than that of the constructor, in the last bit.
    #[must_use]
    pub fn friction(&self) -> Friction {
        let (limit, c_z) = (self.scale.limit, self.stiffness.c_z);
        match &self.state {
            State::Frictionless => Friction::NONE,
            State::Adhesion(_) => Friction::INFINITE,
            _ => Friction::from_product(limit, c_z),
        }
    }

    /// The friction of a contact that slides as a whole at the present approach; infinite where static friction holds it.
    #[inline]
    pub(crate) fn sliding_force(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        self.kinetic_share() * self.scale.force * (zeta * zeta.sqrt())
    }

    /// kappa f along both axes: the shift over the approach of a contact of which all has slid.
    pub(crate) fn sliding_shift(&self) -> [f64; 2] {
        self.scale.shift.components().map(|scale| self.kinetic_share() / scale)
    }

    /// Kinetic friction over that of the limit of forces; infinite without a limit, and where static friction holds.
    #[inline]
    fn kinetic_share(&self) -> f64 {
        match &self.state {
            State::Adhesion(_) => f64::INFINITY,
            State::Frictionless | State::FixedDirection(_) | State::Coulomb(_) => 1.0,
            State::StaticFixedDirection(memory) if memory.slides() => memory.ratio(),
            State::StaticCoulomb(memory) if memory.slides() => memory.ratio(),
            State::StaticFixedDirection(_) | State::StaticCoulomb(_) => f64::INFINITY,
        }
    }

    /// The Coulomb memory in two directions, if friction is neither zero nor infinite, and static
    /// friction is not above kinetic friction.
    #[must_use]
    pub fn coulomb(&self) -> Option<&CoulombMemory<V, S::Curve>> {
        match &self.state {
            State::Coulomb(memory) => Some(memory),
            _ => None,
        }
    }

    /// The traction in units of the greatest traction limit, at the squared elliptical radius `q =
    /// (x/a)^2 + (y/b)^2` of the present contact; `None` for zero or infinite friction.
    #[must_use]
    pub fn traction(&self, q: f64) -> Option<V> {
        match &self.state {
            State::Frictionless | State::Adhesion(_) => None,
            State::FixedDirection(memory) => Some(memory.traction(q)),
            State::Coulomb(memory) => Some(memory.traction(q)),
            State::StaticFixedDirection(memory) => Some(memory.traction(q)),
            State::StaticCoulomb(memory) => Some(memory.traction(q)),
        }
    }

    /// The memory of one direction, or of chapter 7, if friction is neither zero nor infinite, and
    /// static friction is not above kinetic friction.
    #[must_use]
    pub fn memory(&self) -> Option<&Memory<V, S>> {
        match &self.state {
            State::FixedDirection(memory) => Some(memory),
            _ => None,
        }
    }

    /// The contact state after the last step.
    #[must_use]
    pub fn regime(&self) -> Regime {
        match &self.state {
            _ if self.shift.zeta <= 0.0 => Regime::Separated,
            state => with_memory!(state, memory => memory.regime(), else Regime::Sliding),
        }
    }

    /// `zeta*/zeta = (a*/a)^2`: the relative area of the stick zone.
    #[must_use]
    pub fn stick_depth(&self) -> f64 {
        match &self.state {
            _ if self.shift.zeta <= 0.0 => 0.0,
            state => with_memory!(state, memory => memory.stick_fraction(), else 0.0),
        }
    }

    /// The consistent tangent of the last step: derivatives of (F_x, F_y, F_z) (rows) with respect
    /// to (xi, eta, zeta) (columns). With infinite friction it is that of the next small step, also after a
    /// step in which the contact grew.
    #[must_use]
    pub fn tangent(&self) -> [[f64; 3]; 3] {
        let normal = self.stiffness.c_z * self.shift.zeta.max(0.0).sqrt();
        let none = Tangent { by_shift: [[0.0; 2]; 2], by_approach: [0.0; 2] };
        let tangent = with_memory!(&self.state, memory => memory.tangent(), else none);
        let by = self.scale.shift.components();
        let row = |i: usize| {
            let [x, y] = tangent.by_shift[i];
            [x * by[0], y * by[1], tangent.by_approach[i]].map(|t| t * self.scale.force)
        };
        [row(0), row(1), [0.0, 0.0, normal]]
    }

    /// Normalised shift divided by shift.
    #[inline]
    pub(crate) fn scale_of_shifts(&self) -> V {
        self.scale.shift
    }

    /// Energy divided by normalised energy, per direction.
    fn scale_of_energies(&self) -> V {
        let ContactStiffness { c_x, c_y, .. } = self.stiffness;
        V::from_components([1.0 / c_x, 1.0 / c_y]).times(self.scale.force * self.scale.limit)
    }

    /// (5.27).
    #[inline]
    fn normal_force(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        2.0 / 3.0 * self.stiffness.c_z * (zeta * zeta.sqrt())
    }

    #[inline]
    fn normalised(&self, shift: Shift) -> V {
        V::from_components([shift.xi, shift.eta]).by_component(self.scale.shift)
    }

    /// The normalised shift, if the law allows it.
    #[inline]
    pub(crate) fn reachable(&self, shift: Shift) -> Result<V, RangeError> {
        shift.check_finite()?;
        if V::DIMENSION == 1 && shift.eta != 0.0 {
            return Err(RangeError::new("eta", shift.eta, "0 in a law for one direction"));
        }
        let to = self.normalised(shift);
        let [x, y] = to.components();
        in_memory("shift", x)?;
        in_memory("shift", y)?;
        Ok(to)
    }

    /// Advances to a shift that was checked, `to` in normalised shifts; returns the tangential
    /// force.
    #[inline(always)]
    pub(crate) fn go(&mut self, shift: Shift, to: V) -> [f64; 2] {
        self.shift = shift;
        let phi = with_memory!(&mut self.state, memory => {
            memory.step(shift.zeta, to);
            memory.force()
        }, else V::default());
        phi.times(self.scale.force).components()
    }

    #[inline]
    fn force(&self) -> [f64; 2] {
        let phi = with_memory!(&self.state, memory => memory.force(), else V::default());
        phi.times(self.scale.force).components()
    }
}

impl<V: Lateral, S: VertexStack<V>> ContactLaw for ShiftLaw<V, S> {
    type Error = RangeError;

    #[inline]
    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let to = self.reachable(shift)?;
        let [f_x, f_y] = self.go(shift, to);
        Ok(ContactLoad { f_x, f_y, f_z: self.normal_force(), m_z: 0.0 })
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    #[inline]
    fn load(&self) -> ContactLoad {
        let [f_x, f_y] = self.force();
        ContactLoad { f_x, f_y, f_z: self.normal_force(), m_z: 0.0 }
    }

    fn jumps(&self, to: Shift) -> bool {
        let Ok(x) = self.reachable(to) else { return false };
        match &self.state {
            State::StaticFixedDirection(memory) => memory.jumps(to.zeta, x),
            State::StaticCoulomb(memory) => memory.jumps(to.zeta, x),
            _ => false,
        }
    }

    fn used_friction(&self) -> Option<f64> {
        let slides = match &self.state {
            State::StaticFixedDirection(memory) => memory.slides(),
            State::StaticCoulomb(memory) => memory.slides(),
            _ => return None,
        };
        // The force drops to the limit of kinetic friction where sliding begins.
        let ContactLoad { f_x, f_y, f_z, .. } = self.load();
        let limit = self.friction().get() * f_z;
        Some(if slides { 1.0 } else { libm::hypot(f_x, f_y) / limit.max(f64::MIN_POSITIVE) })
    }

    fn slides_on(&self, rates: Shift) -> Option<bool> {
        let along = self.normalised(rates);
        match &self.state {
            State::StaticFixedDirection(memory) => memory.slides_along(rates.zeta, along),
            State::StaticCoulomb(memory) => memory.slides_along(rates.zeta, along),
            _ => None,
        }
    }
}

impl<V: Lateral, S: VertexStack<V>> Checked for ShiftLaw<V, S> {
    #[inline]
    fn check(&self, to: Shift) -> Result<(), RangeError> {
        self.reachable(to).map(|_| ())
    }
}

impl<V: Lateral, S: VertexStack<V>> Dissipative for ShiftLaw<V, S> {
    fn stored_energy(&self) -> f64 {
        let tangential =
            with_memory!(&self.state, memory => memory.stored_energy(), else V::default());
        let zeta = self.shift.zeta.max(0.0);
        let normal = 4.0 / 15.0 * self.stiffness.c_z * (zeta * zeta * zeta.sqrt());
        normal + tangential.dot(self.scale_of_energies())
    }

    fn dissipation(&self, to: Shift) -> f64 {
        let unit = self.scale_of_energies();
        let Ok(x) = self.reachable(to) else { return 0.0 };
        with_memory!(&self.state, memory => memory.heat(to.zeta, x, unit), else 0.0)
    }

    fn loss(&self, to: Shift) -> f64 {
        let unit = self.scale_of_energies();
        let Ok(x) = self.reachable(to) else { return 0.0 };
        with_memory!(&self.state, memory => memory.lost(to.zeta, x, unit), else 0.0)
    }
}

impl<S: VertexStack<[f64; 2]>> ShiftLaw<[f64; 2], S> {
    /// Rotates the frame in the contact plane: shift and tractions are then given in axes rotated
    /// by `angle` (radians, counterclockwise).
    ///
    /// Keeps the law valid when the contact frame of two rolling bodies rotates, and the contact
    /// ellipse with it. Loads are the same vectors as before; so is the stored energy if c_x = c_y.
    /// Otherwise the ellipse rotates relative to its tractions.
    pub fn turn_frame(&mut self, angle: f64) {
        let [xi, eta] = Turn::by(angle).of([self.shift.xi, self.shift.eta]);
        self.shift = Shift { xi, eta, ..self.shift };
        let to = self.normalised(self.shift);
        with_memory!(&mut self.state, memory => {
            memory.turn_frame(angle);
            memory.translate(to.minus(memory.shift()));
        }, else ());
    }
}

impl<V: Lateral, S: VertexStack<V>> ImpactLaw for ShiftLaw<V, S> {
    // All vertices are examined if any may slip.
    fn rings(&self) -> Option<usize> {
        match &self.state {
            State::Coulomb(memory) => Some(memory.stack().len()),
            State::StaticCoulomb(memory) => Some(memory.stack().len()),
            _ => None,
        }
    }
}
