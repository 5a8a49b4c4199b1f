//! The outcome of an impact: motions, impulse, maxima, energy, log, history, warnings.

use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::validity::Validity;
use carom_table::Column;
use nalgebra::Vector3;

use crate::coupled::ImpactMethod;
use crate::motion::Motion;
use crate::oblique::{Event, Regime};
use crate::warning::Warning;

/// The outcome of a collision of two bodies.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// The bodies do not approach each other at the contact point: nothing changes.
    NoImpact {
        /// The motions, unchanged.
        motions: [Motion; 2],
    },
    /// The bodies collide and separate.
    Rebound(Box<Rebound>),
}

impl Outcome {
    /// The motions afterwards, of body 1 and body 2.
    #[must_use]
    pub fn motions(&self) -> [Motion; 2] {
        match self {
            Self::NoImpact { motions } => *motions,
            Self::Rebound(rebound) => rebound.motions,
        }
    }

    /// The rebound, if there was an impact.
    #[must_use]
    pub fn rebound(&self) -> Option<&Rebound> {
        match self {
            Self::NoImpact { .. } => None,
            Self::Rebound(rebound) => Some(rebound),
        }
    }
}

/// An impact from first contact to separation. Contact velocities are of body 2 against body 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Rebound {
    /// Motions afterwards, of body 1 and body 2.
    pub motions: [Motion; 2],
    /// The normal of the contact at the first touch, from body 2 into body 1.
    pub normal: Vector3<f64>,
    /// The impulse that body 2 gave body 1.
    pub impulse: Vector3<f64>,
    /// Relative velocity of the contact points before the impact.
    pub contact_velocity_before: Vector3<f64>,
    /// Relative velocity of the contact points after the impact.
    pub contact_velocity_after: Vector3<f64>,
    /// R_x: -(tangential velocity after)/(before), along the direction before.
    ///
    /// If there was none before, it is the limit for small velocities: (9.46), or -1 without
    /// friction. `None` if that limit depends on their direction, as for an elliptic contact, or if
    /// the normal motion of a [`crate::Collision`] causes a tangential velocity; a tangential
    /// velocity within the round-off of the motions then counts as zero.
    pub r_x: Option<f64>,
    /// Duration from first contact to separation.
    pub duration: f64,
    /// The maximum normal force.
    pub maximal_force: f64,
    /// The maximum approach zeta_max.
    pub maximal_approach: f64,
    /// The maximum contact area, a circle for spheres.
    pub maximal_contact: ContactEllipse,
    /// The pressure in the middle of the contact at the greatest force; 0 where the bodies only graze. It is the greatest of
    /// an elastic contact. A viscous one falls from then on; a Kelvin-Voigt body is pressed harder at the first touch, without
    /// limit.
    pub peak_pressure: f64,
    /// Kinetic energies, and the energies dissipated by friction and lost in the material.
    pub energy: EnergyBudget,
    /// The torsional impact; `None` if the spin about the normal was not changed.
    pub torsion: Option<Torsion>,
    /// The friction that was used; if it depends on the slip speed, that at the first touch; kinetic friction, if
    /// static friction exceeds it.
    pub friction: Friction,
    /// The method of solution.
    pub method: ImpactMethod,
    /// Number of compressions: 2 or more if the bodies were compressed again before separation.
    pub compressions: u32,
    /// Last change of the velocity under refinement over |v_A|, doubled if annuli slip
    /// individually; 0 if the solution is exact. Solvers that choose the analytic law add bounds of what it leaves
    /// out, also over |v_A|.
    pub error_estimate: f64,
    /// By how much R_x may differ in a material that loses as much energy along the normal from another cause; 0 where the
    /// cause is given ([`crate::LossCause`], a relaxation time) or nothing is lost.
    pub model_uncertainty: f64,
    /// The regimes in order, with the times at which they began.
    pub log: Vec<LogEntry>,
    /// How far the largest contact, and the waves that it sends out, are from the limits of the theory.
    pub validity: Validity,
    /// Limits of validity that this outcome reaches.
    pub warnings: Vec<Warning>,
}

impl Torsion {
    /// The columns of the torsional impact.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("spin_ratio", "", "about the normal, after over before", |torsion| {
            torsion.spin_ratio.into()
        }),
        Column::new("torque_impulse", "N m s", "on body 1", |t| t.torque_impulse.into()),
        Column::new("energy_dissipated", "J", "of that by friction", |t| t.dissipated.into()),
        Column::new("error_estimate", "", "of the ratio", |t| t.error_estimate.into()),
    ];
}

impl LogEntry {
    /// The columns of the log.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since first contact", |entry| entry.time.into()),
        Column::new("event", "", "what happened", |entry| {
            match entry.event {
                Event::Touch => "touch",
                Event::SlipStart => "slip starts",
                Event::SlipStop => "slip stops",
                Event::RingClosed => "slip ring closed",
                Event::StickEnd => "stick area gone",
                Event::SlideStop => "sliding stops",
            }
            .into()
        }),
        Column::text("regime", "", "from then on", |entry| entry.regime.name().into()),
    ];
}

/// Kinetic energy of both bodies, translation and rotation, without bodies that the impact cannot
/// move. If such a body moves, as a racket does, it does work on the other: `before` then differs
/// from `after + dissipated + lost`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyBudget {
    /// Before the impact.
    pub before: f64,
    /// After the impact.
    pub after: f64,
    /// Dissipated by slip and released by the receding edge, (9.59).
    pub dissipated: f64,
    /// Lost in the material ([`crate::NormalRestitution`]); 0 for elastic bodies.
    pub lost: f64,
}

/// Whether the torsional impact is computed: friction acts on the spin about the normal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum TorsionMode {
    /// Where it matters, for spheres and planes ([`crate::Collision::twist_bound`]), by solvers that choose
    /// the contact law ([`crate::AnalyticOrRings`]) and by rings. [`crate::Collision::solve`] does not change
    /// the spin.
    #[default]
    Auto,
    /// The spin about the normal is not changed.
    LeftOut,
    /// Always: by rings together with the shift, by the analytic laws as if there were no tangential impact
    /// (chapter 10).
    Included,
}

impl From<Option<bool>> for TorsionMode {
    fn from(told: Option<bool>) -> Self {
        match told {
            None => Self::Auto,
            Some(false) => Self::LeftOut,
            Some(true) => Self::Included,
        }
    }
}

/// The effect of the torsional impact on the spin about the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torsion {
    /// Relative spin about the normal afterwards over that before; 1 if there was none.
    pub spin_ratio: f64,
    /// Impulse of the torque on body 1, about the normal into it.
    pub torque_impulse: f64,
    /// The kinetic energy of the spin dissipated by friction.
    pub dissipated: f64,
    /// Estimated error of the spin ratio: about 1e-12, more if the spin reverses so fast that slip
    /// reverses ([`crate::torsional::TorsionalImpact::error_estimate`]).
    pub error_estimate: f64,
}

/// A regime and the time at which it began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogEntry {
    /// Time since first contact.
    pub time: f64,
    /// The event at its beginning.
    pub event: Event,
    /// The regime from then on.
    pub regime: Regime,
}

/// One instant of an impact, in contact axes; those of two balls turn with the line of centres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryPoint {
    /// Time since first contact.
    pub time: f64,
    /// Shift of body 2 against body 1 since first contact: xi, eta, zeta.
    pub shift: Vector3<f64>,
    /// Its rate.
    pub velocity: Vector3<f64>,
    /// Force on body 1.
    pub force: Vector3<f64>,
    /// Semi-axes a and b of the contact, along x and y.
    pub semi_axes: [f64; 2],
    /// Radius of the stick area, where the method gives it: for spheres and planes.
    pub stick_radius: Option<f64>,
    /// Regime; its sign is that of the traction on body 1 along the initial slip.
    pub regime: Regime,
    /// The z axis of the contact in space. x and y turn with it on the shortest way from the first contact.
    pub normal: Vector3<f64>,
}

impl HistoryPoint {
    /// The columns of the history.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since first contact", |point| point.time.into()),
        Column::new("xi", "m", "shift of body 2 against body 1 along x", |p| p.shift.x.into()),
        Column::new("eta", "m", "the same along y", |point| point.shift.y.into()),
        Column::new("zeta", "m", "approach", |point| point.shift.z.into()),
        Column::vector("v", "m/s", "rate of xi, eta, zeta", |p| {
            <[f64; 3]>::from(p.velocity).into()
        }),
        Column::vector("F", "N", "force on body 1", |point| <[f64; 3]>::from(point.force).into()),
        Column::new("semi_axis_a", "m", "semi-axis of the contact along x", |p| {
            p.semi_axes[0].into()
        }),
        Column::new("semi_axis_b", "m", "semi-axis of the contact along y", |p| {
            p.semi_axes[1].into()
        }),
        Column::new("stick_radius", "m", "radius of the stick area of spheres", |p| {
            p.stick_radius.into()
        }),
        Column::text("regime", "", "sign: traction on body 1 along the first slip", |point| {
            point.regime.name().into()
        }),
        Column::vector("normal", "", "z axis of the contact in space, into body 1", |point| {
            <[f64; 3]>::from(point.normal).into()
        }),
    ];
}
