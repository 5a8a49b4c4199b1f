//! Balls on planes of another material: R_x over the angle, with and without coupling, and on a grid.

use carom_halfspace::Material;
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionError, CollisionSolver, Motion, Outcome,
};
use carom_laws::friction::Friction;
use carom_numerical::NumericalImpact;
use rayon::prelude::*;

use crate::{
    Absolute, Cell, Failure, Figure, FigureResult, Marker, Panel, Series, Table, linspace,
};

/// Angles in degrees for the grid.
const ON_GRID: [f64; 3] = [2.5, 7.5, 20.0];
const CELLS: usize = 48;
const STEPS: usize = 256;

/// A ball on a plane.
struct Pair {
    name: &'static str,
    /// Young's modulus in GPa and Poisson's ratio of ball and plane.
    moduli: [[f64; 2]; 2],
    friction: f64,
}

const ALUMINA: [f64; 2] = [380.0, 0.23];
const GLASS: [f64; 2] = [70.0, 0.22];
const STEEL: [f64; 2] = [208.0, 0.3];
const SILICA: [f64; 2] = [72.0, 0.17];
const ALUMINIUM: [f64; 2] = [70.0, 0.34];
const CARBIDE: [f64; 2] = [600.0, 0.22];
const NYLON: [f64; 2] = [2.7, 0.4];
const RESIN: [f64; 2] = [5.0, 0.35];
const SLATE: [f64; 2] = [60.0, 0.2];

const PAIRS: [Pair; 8] = [
    Pair { name: "alumina on glass", moduli: [ALUMINA, GLASS], friction: 0.092 },
    Pair { name: "steel on glass", moduli: [STEEL, GLASS], friction: 0.15 },
    Pair { name: "glass on steel", moduli: [GLASS, STEEL], friction: 0.1 },
    Pair { name: "fused silica on steel", moduli: [SILICA, STEEL], friction: 0.08 },
    Pair { name: "steel on aluminium", moduli: [STEEL, ALUMINIUM], friction: 0.3 },
    Pair { name: "tungsten carbide on steel", moduli: [CARBIDE, STEEL], friction: 0.15 },
    Pair { name: "nylon on steel", moduli: [NYLON, STEEL], friction: 0.25 },
    Pair { name: "resin on slate", moduli: [RESIN, SLATE], friction: 0.2 },
];

impl Pair {
    /// The impact at an angle from the normal, degrees.
    fn collision(&self, angle: f64) -> Result<Collision, CollisionError> {
        let (sin, cos) = libm::sincos(angle.to_radians());
        let material = |[young, poisson]: [f64; 2]| Material::from_young(1e9 * young, poisson);
        let [ball, plane] = self.moduli;
        let ball = Body::sphere(2.5e-3, material(ball)?, 2.6e-4)?
            .moving(Motion::new([sin, 0.0, -cos], [0.0; 3])?);
        Collision::new(ball, Body::plane(material(plane)?), Friction::new(self.friction)?)
    }

    fn lambda(&self, angle: f64) -> f64 {
        libm::tan(angle.to_radians()) / self.friction
    }

    fn by_default(&self, angle: f64) -> Result<f64, Failure> {
        r_x(&AnalyticOrRings.solve(&self.collision(angle)?)?)
    }

    fn exact(&self, angle: f64) -> Result<f64, Failure> {
        r_x(&self.collision(angle)?.solve()?)
    }

    fn on_grid(&self, angle: f64) -> Result<f64, Failure> {
        let collision = self.collision(angle)?;
        r_x(&NumericalImpact::new(&collision).with(CELLS, STEPS)?.solve()?)
    }
}

fn r_x(outcome: &Outcome) -> Result<f64, Failure> {
    Ok(outcome.rebound().and_then(|rebound| rebound.r_x).ok_or("they meet")?)
}

/// R_x of a pair: on the grid by default, by the exact impact and on the grid.
type OnGrid = Vec<[f64; 3]>;

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("pairs", "moduli and coefficients of friction as handbooks have them");
    figure.assumed("grid", format!("{CELLS} cells across the contact, {STEPS} steps"));
    let places: Vec<(usize, f64)> =
        (0..PAIRS.len()).flat_map(|pair| ON_GRID.map(|angle| (pair, angle))).collect();
    let at = |&(i, angle): &(usize, f64)| -> Result<[f64; 3], Failure> {
        let pair = &PAIRS[i];
        Ok([pair.by_default(angle)?, pair.exact(angle)?, pair.on_grid(angle)?])
    };
    let found: OnGrid = places.par_iter().map(at).collect::<Result<_, _>>()?;
    let mut table = Table::new(
        "R_x, coupling neglected and counted",
        ["pair", "f", "angle / degrees", "exact, neglected", "rings", "grid"],
    );
    for ((i, angle), [rings, exact, grid]) in places.iter().zip(&found) {
        let pair = &PAIRS[*i];
        table.row([
            Cell::from(pair.name),
            pair.friction.into(),
            (*angle).into(),
            (*exact).into(),
            (*rings).into(),
            (*grid).into(),
        ]);
    }
    for (pair, found) in PAIRS.iter().zip(found.chunks(ON_GRID.len())) {
        figure.panel(panel(pair, found)?);
    }
    figure.table(table);
    claims(&mut figure, &places, &found)?;
    Ok(figure)
}

fn panel(pair: &Pair, found: &[[f64; 3]]) -> Result<Panel, Failure> {
    let angles = linspace(1.0, 60.0, 60);
    let curve = |model: &(dyn Fn(&Pair, f64) -> Result<f64, Failure> + Sync)| {
        angles.par_iter().map(|angle| Ok((*angle, model(pair, *angle)?))).collect()
    };
    let (exact, rings): (Result<Vec<_>, Failure>, Result<Vec<_>, Failure>) =
        (curve(&Pair::exact), curve(&Pair::by_default));
    let mut panel = Panel::new("angle of incidence / degrees", "R_x").titled(pair.name);
    panel.add(Series::dashed("coupling neglected", exact?));
    panel.add(Series::line("by default: rings", rings?).coloured(1));
    let grid = ON_GRID.into_iter().zip(found.iter().map(|[_, _, grid]| *grid));
    panel.add(Series::markers("grid", Marker::Circle, grid).coloured(1));
    Ok(panel)
}

fn claims(figure: &mut Figure, places: &[(usize, f64)], found: &OnGrid) -> Result<(), Failure> {
    let greatest = |values: Vec<f64>| values.into_iter().fold(0.0, f64::max);
    let off = |of: fn(&[f64; 3]) -> f64| {
        let weighted = places.iter().zip(found).map(|((i, angle), all)| {
            let lambda = PAIRS[*i].lambda(*angle);
            (lambda.min(1.0) * of(all).abs(), of(all).abs(), lambda)
        });
        weighted.collect::<Vec<_>>()
    };
    let rings = off(|[rings, _, grid]| rings - grid);
    let weighted = greatest(rings.iter().map(|(weighted, ..)| *weighted).collect());
    figure
        .at_most("rings against the grid: min(λ, 1) ΔR_x", weighted, 0.005)
        .source("the contact on a grid of 48 cells");
    let plain = greatest(
        rings.iter().filter(|(.., lambda)| *lambda > 0.2).map(|(_, off, _)| *off).collect(),
    );
    figure.at_most("and ΔR_x", plain, 0.01).source("the contact on a grid");
    let exact =
        greatest(off(|[_, exact, grid]| exact - grid).iter().map(|(_, off, _)| *off).collect());
    figure
        .at_least("neglected, coupling is missed by up to", exact, 0.3)
        .source("the contact on a grid");
    let mut over = f64::NEG_INFINITY;
    for ((i, angle), [_, exact, grid]) in places.iter().zip(found) {
        let bound = PAIRS[*i].collision(*angle)?.coupling_bound();
        over = over.max((exact - grid).abs() - bound);
    }
    figure
        .at_most("the bound of what coupling changes is exceeded by", over, 0.003)
        .source("the contact on a grid");
    let flat = PAIRS.iter().map(|pair| -> Result<(f64, f64), Failure> {
        Ok((pair.by_default(80.0)?, 7.0 / pair.lambda(80.0) - 1.0))
    });
    figure
        .all_close(
            "80°: sliding throughout, R_x = 7/λ - 1",
            flat.collect::<Result<Vec<_>, _>>()?,
            Absolute(0.01),
        )
        .source("(9.33); coupling takes a little of the normal impulse");
    Ok(())
}
