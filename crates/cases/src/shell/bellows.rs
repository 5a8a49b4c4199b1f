//! A bellows under pressure and axial load, load by load.

use crate::Error;
use crate::case::BellowsCase;
use carom_shells::bellows::{
    Axial, Bellows, BellowsError, BellowsLoad, BellowsState, LimitKind, LinearResponse, PathEnd,
    WallPoint,
};
use carom_table::Column;

/// A bellows under each of its loads.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowedBellows {
    /// The bellows.
    pub bellows: Bellows,
    /// Number of corrugations.
    pub corrugations: usize,
    /// Spring rate and effective area under small loads.
    pub response: Response,
    /// The state under each load.
    pub rows: Vec<BellowsRow>,
    /// All states on the way, of one corrugation, in order, for pictures.
    pub course: Vec<BellowsState>,
}

/// How the path to a load ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadEnd {
    /// The load is reached.
    Reached,
    /// No neighbouring state carries more: the state is that of the greatest force.
    ForceLimit,
    /// The state is that of the greatest elongation before a jump.
    DilatationLimit,
}

impl LoadEnd {
    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Reached => "reached",
            Self::ForceLimit => "limit of the force",
            Self::DilatationLimit => "limit of the dilatation",
        }
    }
}

/// The bellows under one load. Forces, lengths and energies are those of all corrugations.
#[derive(Debug, Clone, PartialEq)]
pub struct BellowsRow {
    /// The state of one corrugation.
    pub state: BellowsState,
    /// Whether the load is reached.
    pub end: LoadEnd,
    load: BellowsLoad,
    corrugations: f64,
}

/// Spring rate and effective area of all corrugations under small loads.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// Of one corrugation.
    pub linear: LinearResponse,
    corrugations: f64,
    pitch: f64,
}

/// The columns of [`Response`].
pub const RESPONSE_COLUMNS: &[Column<Response>] = &[
    Column::new("length", "m", "at rest", |of| (of.corrugations * of.pitch).into()),
    Column::new("spring_rate", "N/m", "force over small dilatation, without pressure", |of| {
        (of.linear.spring_rate / of.corrugations).into()
    }),
    Column::new("effective_area", "m2", "thrust over pressure at fixed ends", |of| {
        of.linear.effective_area.into()
    }),
];

/// The columns of a place between crest and root. The stress of the outer face is membrane + bending, that of
/// the inner face membrane - bending.
pub const WALL_COLUMNS: &[Column<WallPoint>] = &[
    Column::new("parameter", "", "xi, from 0 at the crest to pi at the root", |at| {
        at.parameter.into()
    }),
    Column::new("radius", "m", "distance from the axis", |at| at.radius.into()),
    Column::new("height", "m", "above the crest", |at| at.height.into()),
    Column::new("radial_displacement", "m", "growth u of the radius", |at| {
        at.radial_displacement.into()
    }),
    Column::new("rotation", "rad", "growth beta of the angle of the meridian", |at| {
        at.rotation.into()
    }),
    Column::new("meridional_membrane", "Pa", "stress N_s/t", |at| at.meridional_membrane.into()),
    Column::new("meridional_bending", "Pa", "stress 6 M_s/t^2", |at| at.meridional_bending.into()),
    Column::new("hoop_membrane", "Pa", "stress N_t/t", |at| at.hoop_membrane.into()),
    Column::new("hoop_bending", "Pa", "stress 6 M_t/t^2", |at| at.hoop_bending.into()),
];

impl BellowsRow {
    /// The columns of a row.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("pressure", "Pa", "inside", |row| row.state.pressure().into()),
        Column::new("dilatation", "m", "growth of the length", |row| row.dilatation().into()),
        Column::new(
            "force",
            "N",
            "tension of closed ends beside the pressure on them; the thrust on anchors is -force",
            |row| row.state.force().into(),
        ),
        Column::new("spring_rate", "N/m", "dF/dDelta in this state, at fixed pressure", |row| {
            (row.state.stiffness() / row.corrugations).into()
        }),
        Column::new("stored_energy", "J", "in the wall", |row| {
            (row.state.stored_energy() * row.corrugations).into()
        }),
        Column::new("volume", "m3", "enclosed", |row| {
            (row.state.volume() * row.corrugations).into()
        }),
        Column::new(
            "least_gap",
            "m",
            "least distance of neighbouring folds along the axis",
            |row| row.state.least_gap().into(),
        ),
        Column::new("maximal_rotation", "rad", "of the meridian", |row| {
            row.state.greatest_rotation().into()
        }),
        Column::new("maximal_meridional_stress", "Pa", "greatest, on either face", |row| {
            row.greatest(|[along, _]| along.abs()).into()
        }),
        Column::new("maximal_hoop_stress", "Pa", "greatest, on either face", |row| {
            row.greatest(|[_, hoop]| hoop.abs()).into()
        }),
        Column::new("maximal_equivalent_stress", "Pa", "after von Mises, on either face", |row| {
            row.maximal_equivalent_stress().into()
        }),
        Column::text("end", "", "whether the load is reached, or a limit before it", |row| {
            row.end.name().into()
        }),
        Column::count("iterations", "", "steps of Newton's method at the end", |row| {
            (row.state.convergence().iterations as u64).into()
        }),
        Column::new("residual", "", "of the equations, in units E = t = 1", |row| {
            row.state.convergence().residual.into()
        }),
        Column::new("truncation", "", "last coefficients over the greatest", |row| {
            row.state.convergence().truncation.into()
        }),
    ];

    /// Growth of the length of all corrugations.
    #[must_use]
    pub fn dilatation(&self) -> f64 {
        self.corrugations
            * match (self.load.axial(), self.end) {
                (Axial::Dilatation(given), LoadEnd::Reached) => given,
                _ => self.state.dilatation(),
            }
    }

    fn maximal_equivalent_stress(&self) -> f64 {
        self.greatest(|[along, hoop]| (along * along - along * hoop + hoop * hoop).sqrt())
    }

    /// The greatest of a function of the stresses along the meridian and around it, on both faces.
    fn greatest(&self, of: impl Fn([f64; 2]) -> f64) -> f64 {
        let faces = |at: &WallPoint| {
            [1.0, -1.0].map(|side| {
                [
                    at.meridional_membrane + side * at.meridional_bending,
                    at.hoop_membrane + side * at.hoop_bending,
                ]
            })
        };
        self.state.profile().iter().flat_map(faces).map(of).fold(0.0, f64::max)
    }
}

/// Equivalent stress over Young's modulus above which strains are not small.
const LARGE_STRAIN: f64 = 0.02;
/// Share of the last coefficients above which the harmonics are too few.
const TRUNCATED: f64 = 1e-3;

impl FollowedBellows {
    pub(super) fn warnings(&self) -> Vec<String> {
        let (wall, all) = (self.bellows.wall(), self.rows.len());
        let touching = |row: &&BellowsRow| {
            !self.bellows.meridian().is_closed() && row.state.least_gap() < wall.thickness()
        };
        let strained = |row: &&BellowsRow| {
            row.maximal_equivalent_stress() > LARGE_STRAIN * wall.young_modulus()
        };
        let truncated = |row: &&BellowsRow| row.state.convergence().truncation > TRUNCATED;
        let count = |is: &dyn Fn(&&BellowsRow) -> bool| self.rows.iter().filter(is).count();
        let limited = |row: &&BellowsRow| row.end != LoadEnd::Reached;
        let kinds: [(usize, &str); 4] = [
            (
                count(&limited),
                "a limit point comes before the load, and the state there is given: under more load \
                 the bellows jumps",
            ),
            (count(&touching), "neighbouring folds touch, and their contact is not followed"),
            (
                count(&strained),
                "the stress exceeds 2 % of Young's modulus: strains are no longer small",
            ),
            (
                count(&truncated),
                "the last harmonics still have more than 0.001 of the greatest one: \
                 `bellows.harmonics` should be larger",
            ),
        ];
        let told = kinds.into_iter().filter(|(count, _)| *count > 0);
        told.map(|(count, words)| match all {
            1 => words.to_owned(),
            _ => format!("{words} ({count} of {all} loads)"),
        })
        .collect()
    }
}

/// Number of states on the way to all loads together, at least.
const COURSE: usize = 32;

pub(super) fn followed(case: &BellowsCase) -> Result<FollowedBellows, Error> {
    let corrugations = case.corrugations as f64;
    let linear = case.bellows.linear_response()?;
    let response = Response { linear, corrugations, pitch: case.bellows.meridian().pitch() };
    let steps = COURSE.div_ceil(case.loads.len()).min(COURSE / 2);
    let mut walk = Walk { bellows: &case.bellows, at: None, course: Vec::new() };
    let mut rows = Vec::new();
    for (i, load) in case.loads.iter().enumerate() {
        let (state, end) =
            walk.to(*load, steps).map_err(|source| Error::from(source).at("load", i + 1))?;
        rows.push(BellowsRow { state, end, load: *load, corrugations });
    }
    let (bellows, course) = (case.bellows.clone(), walk.course);
    Ok(FollowedBellows { bellows, corrugations: case.corrugations, response, rows, course })
}

/// Goes from load to load.
struct Walk<'a> {
    bellows: &'a Bellows,
    /// The last load that was reached, and its state.
    at: Option<(BellowsLoad, BellowsState)>,
    course: Vec<BellowsState>,
}

impl Walk<'_> {
    /// Under another pressure, and without axial load, the way begins anew.
    fn to(
        &mut self,
        load: BellowsLoad,
        steps: usize,
    ) -> Result<(BellowsState, LoadEnd), BellowsError> {
        let here = self
            .at
            .take()
            .filter(|(last, _)| last.pressure() == load.pressure() && load.axial().value() != 0.0);
        let (last, start) = match here {
            Some(here) => here,
            None => {
                let axial = match load.axial() {
                    Axial::Force(_) => Axial::Force(0.0),
                    Axial::Dilatation(_) => Axial::Dilatation(0.0),
                };
                let unloaded = BellowsLoad::new(load.pressure(), axial)?;
                let state = self.bellows.solve(unloaded)?;
                self.course.push(state.clone());
                (unloaded, state)
            }
        };
        if last == load {
            self.at = Some((load, start.clone()));
            return Ok((start, LoadEnd::Reached));
        }
        let path = self.bellows.follow(&start, load, steps)?;
        let reached = path.states.last().cloned().unwrap_or(start);
        self.course.extend(path.states.into_iter().skip(1));
        match path.end {
            PathEnd::Reached => {
                self.at = Some((load, reached.clone()));
                Ok((reached, LoadEnd::Reached))
            }
            PathEnd::LimitPoint { kind, state } => {
                // The way to the next load begins before the limit.
                let axial = match load.axial() {
                    Axial::Force(_) => Axial::Force(reached.force()),
                    Axial::Dilatation(_) => Axial::Dilatation(reached.dilatation()),
                };
                self.at = Some((BellowsLoad::new(load.pressure(), axial)?, reached));
                self.course.push((*state).clone());
                let end = match kind {
                    LimitKind::Force => LoadEnd::ForceLimit,
                    LimitKind::Dilatation => LoadEnd::DilatationLimit,
                };
                Ok((*state, end))
            }
        }
    }
}
