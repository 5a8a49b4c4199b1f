//! The case file of `carom scene`: a ball, walls, gravity and limits.

use super::body::{BodyCase, Velocity, read_material};
use super::error::CaseError;
use super::range::Range;
use super::section::{Section, parse};
use super::unit::Dimension;
use carom_impact::scene::{Ball, Limits, Scene, SceneError, Wall};
use carom_laws::friction::Friction;
use carom_special::RangeError;

const FIELDS: &[&str] = &["ball", "wall", "scene"];
const SCENE_FIELDS: &[&str] = &["start", "gravity", "time", "bounces", "rebound_height"];
const WALL_FIELDS: &[&str] =
    &["name", "point", "normal", "material", "friction", "along", "length", "width"];

/// A scene, ready to run.
#[derive(Debug, Clone)]
pub struct SceneCase {
    /// Walls and gravity.
    pub scene: Scene,
    /// The names of the walls, in their order.
    pub names: Vec<String>,
    /// The ball at its start.
    pub ball: Ball,
    /// When to stop.
    pub limits: Limits,
}

impl SceneCase {
    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let setting = case.section("scene", SCENE_FIELDS)?;
        let ball = read_ball(&case, &setting)?;
        let gravity = setting.vector("gravity", Range::Finite.of(Dimension::Acceleration))?;
        let mut scene = Scene::new(gravity).map_err(at(&setting))?;
        let mut names = Vec::new();
        for (index, wall) in case.sections("wall", WALL_FIELDS)?.iter().enumerate() {
            names.push(read_name(wall, index)?);
            scene = scene.with(read_wall(wall)?);
        }
        Ok(Self { scene, names, ball, limits: read_limits(&setting)? })
    }
}

fn read_ball(case: &Section<'_>, setting: &Section<'_>) -> Result<Ball, CaseError> {
    if case.has("ball.position") {
        return Err(case.conflict("ball.position", "scene.start", "the ball begins there"));
    }
    let ball = BodyCase::read(case, "ball", Velocity::Own)?.body;
    if ball.placed().surface().radius().is_none() {
        let reason = "the ball of a scene is a sphere: the turning of other bodies in flight is \
                      not followed";
        return Err(case.conflict("ball.shape", "wall", reason));
    }
    if case.has("ball.fixed") && ball.inertia().mass().is_infinite() {
        return Err(case.conflict("ball.fixed", "wall", "the ball of a scene moves"));
    }
    let mass = ball.inertia().mass();
    if mass.is_infinite() {
        return Err(case.out_of_range("ball.mass", mass, "finite: the walls turn it back"));
    }
    let start = setting.vector("start", Range::Finite.of(Dimension::Length))?;
    Ball::new(ball.at(start).map_err(at(setting))?).map_err(|error| {
        let field = if case.has("ball.inertia") { "ball.inertia" } else { "ball.mass" };
        match error {
            SceneError::Range(error) => case.out_of_range(field, error.value, error.allowed),
            _ => case.out_of_range(field, mass, "that of a sphere"),
        }
    })
}

fn read_name(wall: &Section<'_>, index: usize) -> Result<String, CaseError> {
    if wall.has("name") {
        return wall.text("name", "a text").map(str::to_owned);
    }
    Ok(format!("wall {}", index + 1))
}

fn read_wall(wall: &Section<'_>) -> Result<Wall, CaseError> {
    let point = wall.vector("point", Range::Finite.of(Dimension::Length))?;
    let normal = wall.vector("normal", Range::Finite)?;
    let friction = wall.number("friction", Range::NonNegativeOrInfinite)?;
    let friction = Friction::new(friction).map_err(at(wall))?;
    let plane = Wall::new(point, normal, read_material(wall)?, friction).map_err(at(wall))?;
    if !["along", "length", "width"].iter().any(|name| wall.has(name)) {
        return Ok(plane);
    }
    // A rectangle has all three.
    let along = wall.vector("along", Range::Finite)?;
    let half = |name| Ok(0.5 * wall.number(name, Range::Positive.of(Dimension::Length))?);
    plane.rectangle(along, [half("length")?, half("width")?]).map_err(at(wall))
}

fn read_limits(setting: &Section<'_>) -> Result<Limits, CaseError> {
    let time = setting.number("time", Range::Positive.of(Dimension::Time))?;
    let bounces = match setting.has("bounces") {
        true => setting.number("bounces", Range::Whole)? as usize,
        false => 1000,
    };
    let limits = Limits::new(time, bounces).map_err(at(setting))?;
    if !setting.has("rebound_height") {
        return Ok(limits);
    }
    let height = setting.number("rebound_height", Range::NonNegative.of(Dimension::Length))?;
    limits.at_rest_below(height).map_err(at(setting))
}

fn at<'a>(section: &'a Section<'_>) -> impl Fn(RangeError) -> CaseError + 'a {
    |error| section.out_of_range(error.field, error.value, error.allowed)
}
