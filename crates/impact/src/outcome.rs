//! What an impact leaves behind: motions, impulse, extremes, energy, log, history, warnings.

use carom_laws::ellipse::ContactEllipse;
use carom_table::Column;
use nalgebra::Vector3;

use crate::body::Motion;
use crate::coupled::ImpactMethod;
use crate::oblique::{Event, Regime};
use crate::outcome_columns::{Columns, Ended};

/// The outcome of two bodies meeting.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// They do not approach each other at the contact point: nothing happens.
    NoImpact {
        /// The motions, unchanged.
        motions: [Motion; 2],
    },
    /// They collide and part.
    Rebound(Box<Rebound>),
}

impl Outcome {
    /// All that an impact leaves, whoever shows it: the names of these columns are those of the Python
    /// record and of the C struct too.
    pub const COLUMNS: &'static [Column<Self>] = Columns::<Self>::COLUMNS;

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

impl Ended for Outcome {
    fn motions(&self) -> [Motion; 2] {
        self.motions()
    }

    fn rebound(&self) -> Option<&Rebound> {
        self.rebound()
    }
}

impl Rebound {
    /// The columns of [`Outcome::COLUMNS`].
    pub const COLUMNS: &'static [Column<Self>] = Columns::<Self>::COLUMNS;
}

impl Ended for Rebound {
    fn motions(&self) -> [Motion; 2] {
        self.motions
    }

    fn rebound(&self) -> Option<&Rebound> {
        Some(self)
    }
}

/// An impact from touch to separation. Velocities of the contact are of body 2 against body 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Rebound {
    /// Motions afterwards, of body 1 and body 2.
    pub motions: [Motion; 2],
    /// The impulse that body 2 gave body 1.
    pub impulse: Vector3<f64>,
    /// Relative velocity of the contact points before.
    pub contact_velocity_before: Vector3<f64>,
    /// Relative velocity of the contact points after.
    pub contact_velocity_after: Vector3<f64>,
    /// R_x: tangential velocity after, along that before, over it, reversed in sign.
    ///
    /// Where there was none before it is the limit for vanishing ones: (9.46), or -1 without
    /// friction. None if that limit depends on their direction, as of an elliptic contact, or if
    /// the normal motion of a [`crate::Collision`] itself brings about a tangential velocity; a
    /// tangential velocity within rounding of the motions counts as none there.
    pub r_x: Option<f64>,
    /// Duration from touch to separation.
    pub duration: f64,
    /// The greatest normal force.
    pub maximal_force: f64,
    /// The greatest approach zeta_max.
    pub maximal_approach: f64,
    /// The greatest contact area, a circle for spheres.
    pub maximal_contact: ContactEllipse,
    /// Kinetic energies, and what friction and material took.
    pub energy: EnergyBudget,
    /// The torsional impact; none where the spin about the normal was left alone.
    pub torsion: Option<Torsion>,
    /// How it was followed.
    pub method: ImpactMethod,
    /// How often the approach grew: 2 or more if the bodies were pressed together again.
    pub compressions: u32,
    /// Last change of the velocity under refinement over |v_A|, twice that where rings slip each by
    /// itself; 0 where the solution is exact.
    pub error_estimate: f64,
    /// The regimes in order with the times they began.
    pub log: Vec<LogEntry>,
    /// What limits the validity of this outcome.
    pub warnings: Vec<Warning>,
}

impl Torsion {
    /// What it did.
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
    /// What happened when.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since touch", |entry| entry.time.into()),
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
        Column::new("regime", "", "from then on", |entry| entry.regime.name().into()),
    ];
}

/// Kinetic energy of both bodies (translation and rotation), bodies held fast left out. One of them that
/// moves, as a racket does, works on the other: `before` is then not `after + dissipated + lost`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyBudget {
    /// Before the impact.
    pub before: f64,
    /// After the impact.
    pub after: f64,
    /// Turned into heat by slip and released by the receding edge, (9.59).
    pub dissipated: f64,
    /// Lost in the bodies' material, as [`crate::NormalRestitution`] has it; 0 of elastic ones.
    pub lost: f64,
}

/// Whether friction acts on the spin about the normal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum TorsionMode {
    /// Where it matters, of spheres and planes ([`crate::Collision::twist_bound`]), by those who choose the contact
    /// law ([`crate::AnalyticOrRings`]) and by rings. [`crate::Collision::solve`] leaves the spin alone.
    #[default]
    Auto,
    /// The spin about the normal is left alone.
    LeftOut,
    /// Always: by rings together with the shift, by the analytic laws as if there were no tangential impact (chapter
    /// 10).
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

/// What the torsional impact did to the spin about the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torsion {
    /// Relative spin about the normal afterwards over that before; 1 if there was none.
    pub spin_ratio: f64,
    /// Impulse of the torque on body 1, about the normal into it.
    pub torque_impulse: f64,
    /// The kinetic energy that friction took of the spin.
    pub dissipated: f64,
    /// How far the spin ratio may be off: about 1e-12, more where the spin turns back so fast that
    /// slip reverses ([`crate::torsional::TorsionalImpact::error_estimate`]).
    pub error_estimate: f64,
}

/// A regime and when it began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogEntry {
    /// Time since touch.
    pub time: f64,
    /// What happened.
    pub event: Event,
    /// The regime from then on.
    pub regime: Regime,
}

/// One instant of an impact, in contact axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryPoint {
    /// Time since touch.
    pub time: f64,
    /// Shift of body 2 against body 1 since touch: xi, eta, zeta.
    pub shift: Vector3<f64>,
    /// Its rate.
    pub velocity: Vector3<f64>,
    /// Force on body 1.
    pub force: Vector3<f64>,
    /// Semi-axes a and b of the contact, along x and y.
    pub semi_axes: [f64; 2],
    /// Radius of the stick area, where the method knows it: of spheres and planes.
    pub stick_radius: Option<f64>,
    /// Regime; its sign is that of the traction on body 1 along the initial slip.
    pub regime: Regime,
}

impl HistoryPoint {
    /// Its columns.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since touch", |point| point.time.into()),
        Column::new("xi", "m", "shift of body 2 against body 1 along x", |p| p.shift.x.into()),
        Column::new("eta", "m", "the same along y", |point| point.shift.y.into()),
        Column::new("zeta", "m", "approach", |point| point.shift.z.into()),
        Column::vector("v", "m/s", "rate of xi, eta, zeta", |p| {
            <[f64; 3]>::from(p.velocity).into()
        }),
        Column::vector("F", "N", "force on body 1", |point| <[f64; 3]>::from(point.force).into()),
        Column::new("semi_axis_a", "m", "of the contact along x", |p| p.semi_axes[0].into()),
        Column::new("semi_axis_b", "m", "of the contact along y", |p| p.semi_axes[1].into()),
        Column::new("stick_radius", "m", "of the stick area of spheres", |p| p.stick_radius.into()),
        Column::new("regime", "", "sign: traction on body 1 along the first slip", |point| {
            point.regime.name().into()
        }),
    ];
}

/// A limit of validity that an outcome touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Warning {
    /// The materials couple normal and tangential displacements (epsilon of (5.20) is not zero),
    /// which the analytic law neglects. Below f/gamma of about 1 it matters (section 15.2).
    Coupling {
        /// gamma of (15.2).
        gamma: f64,
        /// f/|gamma|.
        friction_over_gamma: f64,
    },
    /// The contact is not small against the bodies: Hertz's theory asks for a/R below 0.1.
    LargeContact {
        /// Maximal contact radius, of an ellipse the larger semi-axis, over the smallest radius of
        /// curvature.
        ratio: f64,
    },
    /// Elastic waves would carry away more than 1 % of the normal energy, (3.2), and nothing is taken off
    /// for them.
    WaveLoss {
        /// The share, estimated for the body's material throughout.
        share: f64,
    },
    /// Torsion is left out and would take more than 1 % of the relative spin about the normal.
    SpinLeftAlone {
        /// About that share, from above.
        share: f64,
    },
    /// The outcome did not settle to the tolerance asked for and was accepted all the same
    /// ([`crate::coupled::CoupledImpact::accepting_unsettled`]).
    NotSettled {
        /// How far the velocity may be off, over that before.
        error_estimate: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// The contact point was searched for from many starts on a body that need not be convex
    /// ([`carom_geometry::Certainty::Sampled`]): the bodies may touch elsewhere too.
    PointSampled,
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Coupling { gamma, friction_over_gamma } => {
                let verdict = if *friction_over_gamma < 1.0 { "matters" } else { "is small" };
                write!(
                    f,
                    "dissimilar materials: gamma = {gamma:.4}, f/|gamma| = {friction_over_gamma:.3}; \
                     the coupling of normal and tangential displacements is neglected and {verdict}"
                )
            }
            Self::WaveLoss { share } => {
                let percent = 100.0 * share;
                write!(f, "elastic waves carry away about {percent:.2} % of the normal energy")
            }
            Self::SpinLeftAlone { share } => {
                let percent = 100.0 * share;
                write!(
                    f,
                    "torsion is left out: it would take up to {percent:.2} % of the relative spin \
                     about the normal"
                )
            }
            Self::NotSettled { error_estimate, tolerance } => {
                write!(
                    f,
                    "not settled: the velocity may be off by {error_estimate:.1e} of that before, \
                     not {tolerance:.1e} as asked"
                )
            }
            Self::PointSampled => f.write_str(
                "the contact point is the nearest that searches from many starts found; a body that \
                 is not convex may touch elsewhere too",
            ),
            Self::LargeContact { ratio } => {
                write!(f, "large contact: a/R = {ratio:.3} exceeds 0.1, beyond Hertz's theory")
            }
        }
    }
}
