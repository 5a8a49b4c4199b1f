//! The constants of the contacts of grains and walls, and what particle codes hand over and get back.

use carom_halfspace::MaterialPair;
use carom_impact::closed_form::radiation_coefficient;
use carom_impact::normal::NormalImpact;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::damping::HertzDamping;
use carom_laws::grains::{
    Apart, Grain, GrainContact, GrainLoad, GrainRings, Meeting, Surface, Wall, compliance_shares,
};
use carom_laws::hertz::Hertz;
use carom_laws::rings::Rings;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::Stack;
use crate::pair::{CAROM_LAW_RINGS, CaromMaterial, CaromPair, materials};
use crate::pointers::{read, write};
use crate::state::finite;

/// The contact of two grains with shift.
pub(crate) type Contact = GrainContact<Stack>;

/// The constants of all contacts of two materials: plain data, made by `carom_grains_of` and not to be
/// changed otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromGrains {
    /// The constants of a contact of relative radius 1.
    pub unit: CaromPair,
    /// The viscous relaxation time of the materials, s.
    pub relaxation: f64,
    /// The ratio alpha of the damping of a given restitution (`carom_grains_restitution`); 0 for none.
    pub restitution_ratio: f64,
    /// Of friction by the slip speed v (`carom_grains_slip_friction`), f = a + b exp(-c v) with a in
    /// `unit.friction`: b; 0 for a constant coefficient.
    pub slip_friction_b: f64,
    /// Of friction by the slip speed: c, s/m.
    pub slip_friction_c: f64,
    /// The displacement of body 1 at the contact over the approach.
    pub share_1: f64,
    /// The displacement of body 2 at the contact over the approach.
    pub share_2: f64,
    /// How strongly material 1 radiates elastic waves: the energy of a pulse over the root of the density,
    /// the square of the greatest force and one over the time, (m^2/N)^1.5; 0 for a rigid body.
    pub radiation_1: f64,
    /// The same of material 2.
    pub radiation_2: f64,
}

/// The load that body 2 exerts on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromGrainLoad {
    /// The force on body 1, N; the force on body 2 is opposite.
    pub force: [f64; 3],
    /// The torque on body 1 about its centre, N m.
    pub torque_1: [f64; 3],
    /// The torque on body 2 about its centre, N m; zero for a wall.
    pub torque_2: [f64; 3],
}

impl CaromGrainLoad {
    /// The load, unless positions or motions beyond all range have made a part of it infinite or no number.
    pub(crate) fn checked(self) -> Result<Self, RangeError> {
        for part in [self.force, self.torque_1, self.torque_2].into_iter().flatten() {
            RangeError::finite("load", part)?;
        }
        Ok(self)
    }
}

const _: () = assert!(size_of::<CaromGrainLoad>() == size_of::<GrainLoad>());

impl CaromGrainLoad {
    /// The place of the load that a contact writes.
    #[inline(always)]
    pub(crate) fn as_load(&mut self) -> &mut GrainLoad {
        // SAFETY: both are nine numbers in C's order: a force, the torque on body 1 and that on body 2.
        unsafe { &mut *(&raw mut *self).cast() }
    }
}

impl From<GrainLoad> for CaromGrainLoad {
    #[inline]
    fn from(GrainLoad { force, torques: [torque_1, torque_2] }: GrainLoad) -> Self {
        Self { force, torque_1, torque_2 }
    }
}

impl CaromGrains {
    /// A new contact of a given relative radius, not yet loaded.
    pub(crate) fn contact(&self, relative_radius: f64) -> Result<Contact, Failure> {
        let contact = GrainContact::new(self.pair(relative_radius).law()?, self.relaxation)?;
        Ok(contact.with_restitution(HertzDamping::of_ratio(self.restitution_ratio)?)?)
    }

    /// Whether friction depends on the slip speed at the first touch.
    #[inline(always)]
    pub(crate) fn has_slip_friction(&self) -> bool {
        self.slip_friction_b != 0.0
    }

    /// A new contact of bodies that first touch at a slip speed.
    fn contact_at(&self, relative_radius: f64, slip_speed: f64) -> Result<Contact, Failure> {
        if !self.has_slip_friction() {
            return self.contact(relative_radius);
        }
        let (a, b, c) = (self.unit.friction, self.slip_friction_b, self.slip_friction_c);
        let friction = SlipSpeedFriction::new(a, b, c)?.at(slip_speed)?;
        self.with_friction(friction.get()).contact(relative_radius)
    }

    /// The same constants with a constant coefficient of friction.
    pub(crate) fn with_friction(&self, friction: f64) -> Self {
        let unit = CaromPair { friction, ..self.unit };
        Self { unit, slip_friction_b: 0.0, slip_friction_c: 0.0, ..*self }
    }

    /// Whether the normal motion is not damped.
    pub(crate) fn is_elastic(&self) -> bool {
        self.relaxation == 0.0 && self.restitution_ratio == 0.0
    }

    /// A new contact with the law of rings.
    pub(crate) fn ring_contact(&self, rings: &Rings<'_>) -> Result<GrainRings, Failure> {
        let damping = HertzDamping::of_ratio(self.restitution_ratio)?;
        Ok(GrainRings::new(rings, self.relaxation)?.with_restitution(damping)?)
    }

    /// Checks the masses of two bodies if a restitution needs them.
    #[inline(always)]
    pub(crate) fn check_masses(&self, meeting: &Meeting) -> Result<(), RangeError> {
        if self.restitution_ratio > 0.0 { meeting.check_masses() } else { Ok(()) }
    }

    /// The constants of a contact of a given relative radius, which is a^2/zeta.
    pub(crate) fn pair(&self, relative_radius: f64) -> CaromPair {
        let by = relative_radius.sqrt();
        let unit = self.unit;
        CaromPair {
            c_x: by * unit.c_x,
            c_y: by * unit.c_y,
            c_z: by * unit.c_z,
            a_squared: relative_radius * unit.a_squared,
            b_squared: relative_radius * unit.b_squared,
            torsion_stiffness: relative_radius * by * unit.torsion_stiffness,
            torsion_arm: by * unit.torsion_arm,
            ..unit
        }
    }
}

impl CaromGrains {
    /// The elastic impact of two grains without damping, by radii, masses and the velocity of approach.
    pub(crate) fn impact(
        &self,
        [radius_1, radius_2]: [f64; 2],
        [mass_1, mass_2]: [f64; 2],
        velocity: f64,
    ) -> Result<NormalImpact, Failure> {
        let c_z = relative_radius(radius_1, radius_2)?.sqrt() * self.unit.c_z;
        RangeError::check("mass_1", mass_1, mass_1 > 0.0, "> 0")?;
        RangeError::check("mass_2", mass_2, mass_2 > 0.0, "> 0")?;
        let mobility = 1.0 / mass_1 + 1.0 / mass_2;
        RangeError::check("mass_2", mass_2, mobility > 0.0, "finite if `mass_1` is not")?;
        RangeError::positive("velocity", velocity)?;
        Ok(NormalImpact::new(mobility, c_z, velocity)?)
    }
}

/// The relative radius of two spheres, of a sphere and a wall if one radius is infinite.
#[inline]
pub(crate) fn relative_radius(one: f64, two: f64) -> Result<f64, Failure> {
    RangeError::positive("radius_1", one)?;
    RangeError::check("radius_2", two, two > 0.0, "> 0")?;
    Ok(1.0 / (1.0 / one + 1.0 / two))
}

/// Two bodies that may touch.
pub(crate) trait Bodies: Copy {
    /// What is known of bodies that can meet.
    type Apart: Copy;

    /// Checks that they can meet.
    fn apart(self) -> Result<Self::Apart, RangeError>;

    /// Their relative position and motion at the contact.
    fn meeting(self, apart: Self::Apart, grains: &CaromGrains) -> Meeting;

    fn radii(self) -> [f64; 2];

    /// Their contact, not yet loaded, where they first touch.
    #[cold]
    #[inline(never)]
    fn fresh(self, apart: Self::Apart, grains: &CaromGrains) -> Result<Contact, Failure> {
        let [one, two] = self.radii();
        grains.contact_at(relative_radius(one, two)?, self.meeting(apart, grains).slip_speed())
    }
}

impl Bodies for [&Grain; 2] {
    type Apart = Apart;

    #[inline(always)]
    fn apart(self) -> Result<Apart, RangeError> {
        let [one, two] = self;
        Apart::of(one, two)
    }

    #[inline(always)]
    fn meeting(self, apart: Apart, grains: &CaromGrains) -> Meeting {
        Meeting::of_apart(self, &apart, [grains.share_1, grains.share_2])
    }

    fn radii(self) -> [f64; 2] {
        self.map(|grain| grain.radius)
    }
}

impl Bodies for (&Grain, &Wall) {
    type Apart = ();

    #[inline(always)]
    fn apart(self) -> Result<(), RangeError> {
        unit_normal(self.1.normal)
    }

    #[inline(always)]
    fn meeting(self, (): (), grains: &CaromGrains) -> Meeting {
        let (grain, wall) = self;
        Meeting::on_wall(grain, wall, grains.share_1)
    }

    fn radii(self) -> [f64; 2] {
        [self.0.radius, f64::INFINITY]
    }
}

impl Bodies for (&Grain, &Surface) {
    type Apart = ();

    #[inline]
    fn apart(self) -> Result<(), RangeError> {
        let wall = self.1;
        unit_normal(wall.normal)?;
        let [square, along] = [wall.axis, wall.normal].map(|v| dot(wall.axis, v));
        let (length, holds) = (square.sqrt(), square == 0.0 || (square - 1.0).abs() < 1e-9);
        RangeError::check("axis", length, holds, "of length 0 or 1")?;
        RangeError::check("axis", along, along.abs() < 1e-9, "across the normal").map(|_| ())
    }

    #[inline]
    fn meeting(self, (): (), grains: &CaromGrains) -> Meeting {
        let (grain, wall) = self;
        Meeting::on_surface(grain, wall, grains.share_1)
    }

    fn radii(self) -> [f64; 2] {
        [self.0.radius, f64::INFINITY]
    }
}

#[inline(always)]
fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

#[inline(always)]
fn unit_normal(normal: [f64; 3]) -> Result<(), RangeError> {
    let square = dot(normal, normal);
    RangeError::check("normal", square.sqrt(), (square - 1.0).abs() < 1e-9, "of length 1")
        .map(|_| ())
}

/// The constants of the contacts of grains of two materials, of any radii, or of grains of material 1 and a
/// wall of material 2.
///
/// `relaxation` is the viscous relaxation time A of the pair, s; 0 for none. Every stress then has a viscous companion, A
/// times its rate. The normal force is K (zeta^(3/2) + (3/2) A sqrt(zeta) zeta'), K = (2/3) c_z, while the approach zeta
/// grows, and K (zeta + A zeta')^(3/2), or 0, while it falls; friction is damped alike. `law` and `tolerance` are as in `carom_pair_of_spheres`;
/// friction must be finite.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_of(
    material_1: *const CaromMaterial,
    material_2: *const CaromMaterial,
    friction: f64,
    law: u32,
    tolerance: f64,
    relaxation: f64,
    grains: *mut CaromGrains,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let materials = materials(material_1, material_2)?;
        let gap = RelativeCurvature::from_coefficients(0.5, 0.5)?;
        *write(grains, "grains")? =
            constants(materials, gap, friction, law, tolerance, relaxation)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Damps contacts such that two grains part with `restitution` times the speed with which they met, at any speed: from
/// 0.01 to 1, which means none. The force is alpha sqrt(m K) zeta^(1/4) dzeta/dt beside that of Hertz, K zeta^(3/2),
/// m the reduced mass; the sum never pulls. Friction is damped as in a viscous material; friction, torsion and resistance
/// to rolling leave the restitution as it is.
///
/// With 50 steps in an impact the restitution is met to 2e-4. Masses of grains are read then, and must be > 0; that of
/// one of both bodies must be finite. Constants with a relaxation time are refused: both would count the same loss.
/// Contacts that have begun keep theirs.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_restitution(
    grains: *mut CaromGrains,
    restitution: f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let grains = write(grains, "grains")?;
        grains.unit.check_version()?;
        let damping = HertzDamping::of_restitution(restitution)?;
        grains.restitution_ratio = damping.beside_relaxation(grains.relaxation)?.ratio();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The constants of the contacts of grains of material 1 with a curved wall of material 2, as `carom_grains_of`
/// makes those with a flat one: for grains of one radius R. The wall, where it is nearest, has the curvature
/// `curvature_x` along the axis x of the contact, `curvature_y` across it, 1/m; above 0 where it is convex, as a
/// shaft, below 0 where it is hollow, as a drum: then above -1/R. In calls that ask for the radius of the wall it
/// is infinite, as that of a flat one. CAROM_LAW_RINGS needs two equal curvatures.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_on_curved_wall(
    material_1: *const CaromMaterial,
    material_2: *const CaromMaterial,
    radius: f64,
    curvature_x: f64,
    curvature_y: f64,
    friction: f64,
    law: u32,
    tolerance: f64,
    relaxation: f64,
    grains: *mut CaromGrains,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let materials = materials(material_1, material_2)?;
        let gap = gap_at_wall(radius, [curvature_x, curvature_y], law)?;
        *write(grains, "grains")? =
            constants(materials, gap, friction, law, tolerance, relaxation)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The gap of a grain of radius 1 at a wall with as much smaller radii.
fn gap_at_wall(radius: f64, curvatures: [f64; 2], law: u32) -> Result<RelativeCurvature, Failure> {
    RangeError::positive("radius", radius)?;
    let [x, y] = curvatures;
    for (field, curvature) in [("curvature_x", x), ("curvature_y", y)] {
        RangeError::check(field, curvature, curvature * radius > -1.0, "above -1 over the radius")?;
    }
    RangeError::check(
        "curvature_y",
        y,
        law != CAROM_LAW_RINGS || x == y,
        "curvature_x for law rings",
    )?;
    Ok(RelativeCurvature::from_coefficients(0.5 * (1.0 + x * radius), 0.5 * (1.0 + y * radius))?)
}

/// The duration of an elastic impact of two grains without damping, s: whoever steps it chooses the time step
/// from this. The second is a wall if its radius is infinite; a mass may be infinite, not both. `velocity` is
/// that of approach, above 0.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_impact_time(
    grains: *const CaromGrains,
    radius_1: f64,
    radius_2: f64,
    mass_1: f64,
    mass_2: f64,
    velocity: f64,
    time: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (grains, place) = (read(grains, "grains")?, write(time, "time")?);
        grains.unit.check_version()?;
        *place = grains.impact([radius_1, radius_2], [mass_1, mass_2], velocity)?.duration();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

fn constants(
    materials: MaterialPair,
    gap: RelativeCurvature,
    friction: f64,
    law: u32,
    tolerance: f64,
    relaxation: f64,
) -> Result<CaromGrains, Failure> {
    let unit = CaromPair::of_hertz(&Hertz::new(gap, materials)?, friction, law, tolerance)?;
    finite(&unit)?;
    let [share_1, share_2] = compliance_shares(&materials);
    let [radiation_1, radiation_2] =
        [radiation_coefficient(materials.body_1())?, radiation_coefficient(materials.body_2())?];
    let grains = CaromGrains {
        unit,
        relaxation,
        restitution_ratio: 0.0,
        slip_friction_b: 0.0,
        slip_friction_c: 0.0,
        share_1,
        share_2,
        radiation_1,
        radiation_2,
    };
    match law {
        CAROM_LAW_RINGS => RangeError::non_negative("relaxation", relaxation).map(|_| ())?,
        _ => grains.contact(1.0).map(|_| ())?,
    }
    Ok(grains)
}
