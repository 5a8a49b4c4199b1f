//! The case file of `carom scene`: a ball, walls, gravity and limits.

use super::body::{BALL, BodyCase, INERTIA, MASS, POSITION, Velocity};
use super::contact::{
    FRICTION, FRICTION_BY_SPEED, LAW_OF_SCENE, LOSS_OF_WALL, NORMAL_RESTITUTION, RELAXATION,
    RESTITUTION_BY_SPEED, STATIC_FRICTION, TORSION, WAVE_LOSS, impact_friction, normal_restitution,
    torsion_mode,
};
use super::error::CaseError;
use super::field::{Default, Field, Form, Rows, Schema};
use super::material::{self, MATERIAL};
use super::range::Range;
use super::reader::Case;
use super::section::{Section, parse};
use super::unit::{Dimension, Measure};
use carom_impact::scene::{Ball, Limits, Scene, SceneError, Wall, WallMotion};
use carom_numerical::CollisionLaw;
use carom_special::RangeError;

const LENGTH_ABOVE_0: Measure = Range::Positive.of(Dimension::Length);
const NAME: Field = Field::new("name", Form::Text("a text"), "name of the wall in the results")
    .may("its number")
    .such_as("\"floor\"");
const POINT: Field = Field::vector(
    "point",
    Range::Finite.of(Dimension::Length),
    "a point of the wall; of a rectangle its centre",
)
.such_as("[0, 0, 0]");
const NORMAL: Field = Field::vector(
    "normal",
    Range::Finite.pure(),
    "outward normal of the wall (need not be of unit length); a rectangle can be hit from both sides",
)
.such_as("[0, 0, 1]");
const WHOLE_PLANE: &str =
    "the wall is an infinite plane; a rectangle has `along`, `length`, `width`";
const ALONG: Field = Field::vector("along", Range::Finite.pure(), "direction of the length")
    .may(WHOLE_PLANE)
    .such_as("[1, 0, 0]");
const LENGTH: Field =
    Field::number("length", LENGTH_ABOVE_0, "length of a rectangle, along `along`")
        .may(WHOLE_PLANE)
        .such_as("1");
const WIDTH: Field = Field::number("width", LENGTH_ABOVE_0, "width of a rectangle, across `along`")
    .may(WHOLE_PLANE)
    .such_as("0.5");
const ROLLING_RESISTANCE: Field = Field::number(
    "rolling_resistance",
    Range::NonNegative.pure(),
    "mu_r of the torque mu_r R F_z against the spin of a ball that moves on the wall",
)
.default(Default::Number(0.0));
const AMPLITUDE: Field = Field::vector(
    "amplitude",
    Range::Finite.of(Dimension::Length),
    "the greatest displacement, along each axis",
)
.such_as("[0, 0, 0.001]");
const PERIOD: Field =
    Field::number("period", Range::Positive.of(Dimension::Time), "time of one oscillation")
        .such_as("0.02");
const PHASE: Field = Field::number(
    "phase",
    Range::Finite.of(Dimension::Degrees),
    "the displacement is amplitude sin(360 t/period + phase)",
)
.default(Default::Number(0.0));
const OSCILLATION: Field = Field::new(
    "oscillation",
    Form::Table(&[AMPLITUDE, PERIOD, PHASE]),
    "how an infinite wall oscillates about its place",
)
.may("the wall is fixed, or `positions` says how it moves");
const POSITIONS: Field = Field::new(
    "positions",
    Form::Rows(Rows {
        parts: &["time", "x", "y", "z"],
        measures: &[
            Range::Finite.of(Dimension::Time),
            Range::Finite.of(Dimension::Length),
            Range::Finite.of(Dimension::Length),
            Range::Finite.of(Dimension::Length),
        ],
        optional: 0,
        least: 2,
        words: "a list of at least two rows [time, x, y, z]",
    }),
    "displacements of an infinite wall from its place at these times, straight between them",
)
.may("the wall is fixed, or `oscillation` says how it moves")
.such_as("[[0, 0, 0, 0], [1, 0, 0, 0.1]]");
const WALL: Field = Field::new(
    "wall",
    Form::Tables(&[
        NAME,
        POINT,
        NORMAL,
        ALONG,
        LENGTH,
        WIDTH,
        MATERIAL,
        FRICTION,
        FRICTION_BY_SPEED,
        STATIC_FRICTION,
        NORMAL_RESTITUTION,
        RESTITUTION_BY_SPEED,
        LOSS_OF_WALL,
        WAVE_LOSS,
        RELAXATION,
        ROLLING_RESISTANCE,
        OSCILLATION,
        POSITIONS,
    ]),
    "a wall, plane or rectangular",
);
const START: Field =
    Field::vector("start", Range::Finite.of(Dimension::Length), "centre of the ball at the start")
        .or("`ball.position`")
        .such_as("[0, 0, 0.1]");
const GRAVITY: Field = Field::vector(
    "gravity",
    Range::Finite.of(Dimension::Acceleration),
    "acceleration of free fall",
)
.such_as("[0, 0, -9.81]");
const TIME: Field =
    Field::number("time", Range::Positive.of(Dimension::Time), "stops at this time").such_as("2");
const BOUNCES: Field =
    Field::number("bounces", Range::Whole.pure(), "stops after this number of bounces")
        .default(Default::Number(1000.0));
const REBOUND_HEIGHT: Field = Field::number(
    "rebound_height",
    Range::NonNegative.of(Dimension::Length),
    "rebounds below this height count as rest",
)
.default(Default::Number(0.0));
const SETTING: Field = Field::new(
    "scene",
    Form::Table(&[START, GRAVITY, TIME, BOUNCES, REBOUND_HEIGHT, LAW_OF_SCENE, TORSION]),
    "start, gravity, limits and contact law",
)
.begun(&[(&START, "")]);

/// All fields.
const FIELDS: &[Field] = &[BALL, WALL, SETTING];

/// A scene, ready to run.
#[derive(Debug, Clone)]
pub struct SceneCase {
    /// Walls and gravity.
    pub scene: Scene,
    /// The names of the walls, in their order.
    pub names: Vec<String>,
    /// The ball at its start.
    pub ball: Ball,
    /// When the computation stops.
    pub limits: Limits,
    /// The contact law of all impacts.
    pub law: CollisionLaw,
}

impl Case<'_> for SceneCase {
    const SCHEMA: Schema =
        Schema::new("scene", "A ball that flies under gravity and bounces between walls.", FIELDS);

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let setting = case.section(&SETTING)?;
        let ball = read_ball(&case, &setting)?;
        let mut scene = Scene::new(setting.vector(&GRAVITY)?).map_err(at(&setting))?;
        let mut names = Vec::new();
        for (index, wall) in case.sections(&WALL)?.iter().enumerate() {
            names.push(match wall.has(&NAME) {
                true => wall.text(&NAME)?.to_owned(),
                false => format!("wall {}", index + 1),
            });
            scene = scene.with(read_wall(wall)?);
        }
        if let Err(SceneError::Inside { wall, gap }) = scene.check(&ball) {
            let (wall, radius) = (&names[wall], ball.radius());
            let allowed = format!(
                "at least the radius {radius} from every wall: the ball starts inside {wall}, by {:.3e} m",
                -gap
            );
            return Err(match case.has([&BALL, &POSITION]) {
                true => case.unfit([&BALL, &POSITION], allowed),
                false => case.unfit([&SETTING, &START], allowed),
            });
        }
        let law = setting.word(&LAW_OF_SCENE)?.parse().unwrap_or_default();
        let scene = scene.with_torsion_mode(torsion_mode(&setting)?);
        let height = setting.number(&REBOUND_HEIGHT)?;
        let limits = Limits::new(setting.number(&TIME)?, setting.count(&BOUNCES)?)
            .and_then(|limits| limits.at_rest_below(height))
            .map_err(at(&setting))?;
        Ok(Self { scene, names, ball, limits, law })
    }
}

fn read_ball(case: &Section<'_>, setting: &Section<'_>) -> Result<Ball, CaseError> {
    if case.has([&BALL, &POSITION]) && setting.has(&START) {
        return Err(case.conflict([&BALL, &POSITION], [&SETTING, &START], "give one of them"));
    }
    let BodyCase { body, has_position, .. } = BodyCase::read(case, &BALL, Velocity::Own)?;
    let mass = body.inertia().mass();
    if mass.is_infinite() {
        return Err(case.out_of_range(
            [&BALL, &MASS],
            mass,
            "finite: a wall cannot reflect an infinite mass",
        ));
    }
    let body = match has_position {
        true => body,
        false => body.at(setting.vector(&START)?).map_err(at(setting))?,
    };
    Ball::new(body).map_err(|error| {
        let field = if case.has([&BALL, &INERTIA]) { &INERTIA } else { &MASS };
        match error {
            SceneError::Range(error) => {
                case.out_of_range([&BALL, field], error.value, error.allowed)
            }
            _ => case.out_of_range([&BALL, field], mass, "that of a sphere"),
        }
    })
}

fn read_wall(wall: &Section<'_>) -> Result<Wall, CaseError> {
    let (point, normal) = (wall.vector(&POINT)?, wall.vector(&NORMAL)?);
    let plane = Wall::new(point, normal, material::read(wall)?, impact_friction(wall)?)
        .map_err(at(wall))?
        .with_normal_restitution(normal_restitution(wall)?)
        .with_rolling_resistance(wall.number(&ROLLING_RESISTANCE)?)
        .map_err(at(wall))?;
    let motion = read_motion(wall)?;
    if wall.given([&ALONG, &LENGTH, &WIDTH]).is_empty() {
        return match motion {
            Some(motion) => plane.with_motion(motion).map_err(at(wall)),
            None => Ok(plane),
        };
    }
    if motion.is_some() {
        let moves = if wall.has(&OSCILLATION) { &OSCILLATION } else { &POSITIONS };
        return Err(wall.conflict(moves, &LENGTH, "a wall that moves is infinite"));
    }
    // A rectangle has length, width and direction.
    let half = [0.5 * wall.number(&LENGTH)?, 0.5 * wall.number(&WIDTH)?];
    plane.rectangle(wall.vector(&ALONG)?, half).map_err(at(wall))
}

fn read_motion(wall: &Section<'_>) -> Result<Option<WallMotion>, CaseError> {
    if wall.has(&POSITIONS) {
        if wall.has(&OSCILLATION) {
            return Err(wall.conflict(&POSITIONS, &OSCILLATION, "give one of them"));
        }
        let rows: Vec<[f64; 4]> = wall.rows(&POSITIONS)?;
        return WallMotion::positions(&rows).map(Some).map_err(at(wall));
    }
    if !wall.has(&OSCILLATION) {
        return Ok(None);
    }
    let table = wall.section(&OSCILLATION)?;
    let phase = table.number(&PHASE)?.to_radians();
    WallMotion::oscillation(table.vector(&AMPLITUDE)?, table.number(&PERIOD)?, phase)
        .map(Some)
        .map_err(at(&table))
}

/// Reports a value that the library rejects at the field with the same name.
fn at<'a>(section: &'a Section<'_>) -> impl Fn(RangeError) -> CaseError + 'a {
    |error| section.refused(error)
}
