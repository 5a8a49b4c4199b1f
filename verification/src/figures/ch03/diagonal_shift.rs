//! Fig. 3.5: the tangential force for a diagonal shift of a slender contact.

use super::super::mesh::{APPROACH, Mesh, Step};
use carom_laws::accounted::Accounted;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Energies as _, Shift};
use carom_laws::shift::{CattaneoMindlin, turned_stiffness};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::{SliderLaw, SlipLines};
use carom_laws::stiffness::ContactStiffness;
use carom_special::roots::bisect;
use carom_special::{AxisRatio, RangeError};

use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, linspace};

const RATIO: f64 = 20.0;
const POISSON: f64 = 0.5;
const STEPS: usize = 300;
/// Values of ξ/ζ.
const END: f64 = 3.0;

/// ξ/ζ with F_x and F_y over f F_z.
type Curve = Vec<(f64, [f64; 2])>;

fn stiffness() -> Result<ContactStiffness, RangeError> {
    ContactStiffness::from_axis_ratio(1.0, AxisRatio::new(RATIO)?, POISSON)
}

/// Pressed to ζ = 1, then shifted with ξ = η; f = 1.
fn follow<L: ContactLaw<Error = RangeError>>(mut law: L) -> Result<Curve, RangeError> {
    law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
    let mut curve = vec![(0.0, [0.0; 2])];
    for x in linspace(0.0, END, STEPS + 1).into_iter().skip(1) {
        let load = law.advance(Shift { zeta: 1.0, xi: x, eta: x, omega: 0.0 })?;
        curve.push((x, [load.f_x / load.f_z, load.f_y / load.f_z]));
    }
    Ok(curve)
}

fn angle([x, y]: [f64; 2]) -> f64 {
    libm::atan2(y, x).to_degrees()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ξ, η", "equal");
    figure.stated("a/b, ν", "20, 0.5");
    figure.assumed("f", "1");
    figure.assumed("axes", "F_x, F_y and the angle of the force against ξ/ζ");
    let (stiffness, friction) = (stiffness()?, Friction::new(1.0)?);
    let thesis = follow(ShiftLaw::<[f64; 2]>::with_fixed_direction(stiffness, friction))?;
    let coulomb = follow(SlipLines::new(stiffness, 1.0, 1e-6)?)?;
    let run = numerical()?;
    panels(&mut figure, &thesis, &coulomb, &run);
    numerical_claims(&mut figure, &run);
    let complete = 1.0 / libm::hypot(stiffness.c_x, stiffness.c_y);
    partial_slip_claims(&mut figure, &stiffness, &thesis, complete)?;
    sliding_claims(&mut figure, &stiffness, &thesis, &coulomb, complete);
    energy_claim(&mut figure, &stiffness)?;
    Ok(figure)
}

/// Steps of xi = eta over zeta on a mesh.
const STEP: f64 = 0.1;

/// Pressed in one step, shifted to 2 zeta in twenty.
fn numerical() -> Result<Vec<Step>, Failure> {
    let mesh = Mesh { poisson: [0.5; 2], ..Mesh::of([20.0, 1.0], [80, 20]) };
    let at = |part: f64| Shift { zeta: APPROACH, xi: part, eta: part, omega: 0.0 };
    let steps: Vec<Shift> = (0..=20).map(|i| at(f64::from(i) * STEP * APPROACH)).collect();
    mesh.follow(&steps)
}

fn numerical_claims(figure: &mut Figure, run: &[Step]) {
    let source = "an independent half-space program on the same mesh";
    let turned = |i: usize| angle([run[i].load.f_x, run[i].load.f_y]);
    figure
        .all_close(
            "numerical direction of the force in steps 2, 11, 12 and 21, in degrees",
            [(1, 55.21), (10, 53.26), (11, 52.52), (20, 47.99)].map(|(i, a)| (turned(i), a)),
            Absolute(0.02),
        )
        .source(source);
    let theory = turned(1);
    let away = (1..=10).map(|i| (turned(i) / theory - 1.0).abs()).fold(0.0, f64::max);
    figure
        .at_most("while an area sticks the direction turns by less than", away, 0.05)
        .source("the thesis, below the figure: less than 5 %");
    figure
        .all_close(
            "parts that stick at ξ = ζ and 1.1 ζ",
            [(run[10].stick(), 0.0062), (run[11].stick(), 0.0)],
            Absolute(1e-3),
        )
        .source(source);
}

fn panels(figure: &mut Figure, thesis: &Curve, coulomb: &Curve, run: &[Step]) {
    let mut forces = Panel::new("ξ/ζ", "F / (f F_z)").titled("Force");
    let mut angles = Panel::new("ξ/ζ", "angle of the force / °").titled("Direction");
    for (name, curve) in [("Cattaneo", thesis), ("Coulomb", coulomb)] {
        let part = |i: usize| curve.iter().map(move |(x, force)| (*x, force[i]));
        forces.add(Series::line(format!("F_x, {name}"), part(0)));
        forces.add(Series::line(format!("F_y, {name}"), part(1)));
        let turned = curve.iter().skip(1).map(|(x, force)| (*x, angle(*force)));
        angles.add(Series::line(name, turned));
    }
    let marked = |i: usize, of: &dyn Fn(&Step) -> f64| (STEP * i as f64, of(&run[i]));
    let along = (0..run.len()).map(|i| marked(i, &|step| step.load.f_x / step.load.f_z));
    forces.add(Series::markers("F_x, numerical", Marker::Circle, along));
    let across = (0..run.len()).map(|i| marked(i, &|step| step.load.f_y / step.load.f_z));
    forces.add(Series::markers("F_y, numerical", Marker::Square, across));
    let turned = (1..run.len()).map(|i| marked(i, &|step| angle([step.load.f_x, step.load.f_y])));
    angles.add(Series::markers("numerical", Marker::Circle, turned));
    figure.panel(forces);
    figure.panel(angles);
}

fn partial_slip_claims(
    figure: &mut Figure,
    stiffness: &ContactStiffness,
    thesis: &Curve,
    complete: f64,
) -> Result<(), Failure> {
    let ratios =
        [(stiffness.c_x / stiffness.c_z, 0.564_102), (stiffness.c_y / stiffness.c_z, 0.814_816)];
    figure
        .all_close("c_x/c_z and c_y/c_z", ratios, Absolute(5e-7))
        .source("(5.25) by an independent program");
    figure
        .close("ξ = η at complete sliding over f ζ", complete, 1.009_05, Absolute(5e-6))
        .source("1/|(c_x, c_y)| c_z by an independent program");
    let law = CattaneoMindlin::new(*stiffness, Friction::new(1.0)?);
    let (mut closed, mut ratio) = (Vec::new(), Vec::new());
    for (x, force) in thesis.iter().skip(1).filter(|(x, _)| *x < complete) {
        let state = law.at_shift(1.0, *x, *x)?;
        closed.extend((0..2).map(|i| (force[i], state.force[i] / state.normal_force)));
        ratio.push((force[0] / force[1], 0.692_306));
    }
    figure
        .all_close("the law is Cattaneo's in partial slip", closed, Absolute(1e-14))
        .source("closed form (5.26)");
    figure
        .all_close("F_x/F_y in partial slip", ratio, Absolute(5e-7))
        .source("c_x/c_y by an independent program; 55.305° to x");
    Ok(())
}

/// Energies of both laws at ξ = η = 1.5 ζ beside the work.
fn energy_claim(figure: &mut Figure, stiffness: &ContactStiffness) -> Result<(), Failure> {
    let mut pairs = Vec::new();
    let mut add = |stored: f64, lost: f64, expected: [f64; 2]| {
        pairs.extend([(stored, expected[0]), (lost, expected[1])]);
    };
    // Straight in the direction of the normalised shift: Cattaneo's law, with k = f c_z ζ and
    // C e = k p at sliding; then sliding at the constant force f F_z p.
    let size = libm::hypot(stiffness.c_x, stiffness.c_y);
    let (onset, end) = (stiffness.c_z / size, 1.5);
    let direction = [stiffness.c_x / size, stiffness.c_y / size];
    let force = 2.0 / 3.0 * stiffness.c_z;
    let along = force * onset * (direction[0] + direction[1]);
    // Up to the onset the work is 3/5 of force times shift, 1/5 of it lost.
    let slid = force * (end - onset) * (direction[0] + direction[1]);
    let pressed = 4.0 / 15.0 * stiffness.c_z;
    let mut law = Accounted::new(ShiftLaw::<[f64; 2]>::new(*stiffness, Friction::new(1.0)?));
    for shift in [0.0, 0.5 * onset, onset, end] {
        law.advance(Shift { zeta: 1.0, xi: shift, eta: shift, omega: 0.0 })?;
    }
    add(law.stored_energy(), law.dissipated(), [pressed + 0.4 * along, 0.2 * along + slid]);
    // Annuli with one stiffness, along x: the same law, to 1.5 times the shift of complete sliding.
    let mut rings = SliderLaw::new(500, 1.0, 1.0)?;
    let onset = 0.3 * 1.2 / 0.8;
    rings.advance(1.0, [0.0; 2])?;
    let mut lost = 0.0;
    for step in 1..=300 {
        let shift = [1.5 * f64::from(step) / 300.0, 0.0];
        lost += rings.dissipation(1.0, shift)[0];
        rings.advance(1.0, shift)?;
    }
    let force = 2.0 / 3.0 * 0.3 * 1.2;
    let even = ContactStiffness::new(0.8, 0.8, 1.2)?;
    let mut line = SlipLines::new(even, 0.3, 1e-6)?;
    line.advance(Shift { zeta: 1.0, ..Shift::default() })?;
    let limit = line.advance(Shift { zeta: 1.0, xi: 1.5 * onset, ..Shift::default() })?.f_x / force;
    // The product of normalised force and shift.
    let unit = force * onset;
    let (stored, lost) = (4.0 / 15.0 * 1.2 + unit * rings.stored_energy()[0], unit * lost);
    let expected =
        [4.0 / 15.0 * 1.2 + 0.4 * force * onset, 0.2 * force * onset + 0.5 * force * onset];
    figure
        .all_close(
            "rings of one stiffness: energy stored and lost, over those of Cattaneo",
            [(stored / expected[0], 1.0), (lost / expected[1], 1.0)],
            Absolute(2e-3),
        )
        .source("∫F dξ of (5.28) and the work of sliding");
    figure.close("and F_x/(f F_z) in sliding", limit, 1.0, Absolute(1e-12)).source("Coulomb");
    let turned = turned_stiffness(stiffness, 0.7);
    let (sin, cos) = (0.7_f64.sin(), 0.7_f64.cos());
    let axes = [[cos, sin], [-sin, cos]];
    let mut entries = Vec::new();
    for i in 0..2 {
        for j in 0..2 {
            let sum =
                stiffness.c_x * axes[i][0] * axes[j][0] + stiffness.c_y * axes[i][1] * axes[j][1];
            entries.push((turned[i][j], sum));
        }
    }
    figure
        .all_close("stiffness in axes turned by 0.7 rad", entries, Absolute(1e-15))
        .source("proposition 1: a tensor of second order");
    figure
        .all_close("energy stored and lost at ξ = η = 1.5 ζ by Cattaneo", pairs, Relative(1e-9))
        .source("∫F dξ of (5.28): 2/5 of force times shift stored at sliding, 1/5 lost before");
    Ok(())
}

fn sliding_claims(
    figure: &mut Figure,
    stiffness: &ContactStiffness,
    thesis: &Curve,
    coulomb: &Curve,
    complete: f64,
) {
    let bounds = |curve: &Curve| {
        let ratios = curve.iter().skip(1).map(|(_, force)| force[0] / force[1]);
        ratios.fold([f64::INFINITY, 0.0], |[low, high], r| [r.min(low), r.max(high)])
    };
    for (name, curve) in [("Cattaneo", thesis), ("Coulomb", coulomb)] {
        let [low, high] = bounds(curve);
        figure.at_least(format!("F_x/F_y, {name}, from below"), low, 0.5).source("(3.18)");
        figure.at_most(format!("F_x/F_y, {name}, from above"), high, 1.0).source("(3.18)");
    }
    let size = |force: &[f64; 2]| libm::hypot(force[0], force[1]);
    let most = coulomb.iter().map(|(_, force)| size(force)).fold(0.0, f64::max);
    figure.at_most("|F_t|/(f F_z)", most, 1.0 + 1e-14).source("Coulomb");
    let slides = coulomb.iter().filter(|(x, _)| *x > 2.0 * complete);
    let sizes = slides.map(|(_, force)| (size(force), 1.0));
    figure
        .all_close("|F_t|/(f F_z) far in sliding", sizes, Absolute(5e-4))
        .source("Coulomb, where the rings have turned alike");
    let turning = coulomb.iter().filter(|(x, _)| *x > 0.05).map(|(_, force)| angle(*force));
    figure
        .decreasing("Coulomb's force turns towards the slip", turning)
        .source("slip along the traction: 45° in rigid sliding");
    figure
        .all_close(
            "F_x and F_y of Coulomb's rings over f F_z at ten shifts",
            dragged_rings(stiffness, coulomb),
            Absolute(1e-3),
        )
        .source("500 rings dragged by steps of ζ/2000, each along its own traction");
}

/// F_x, F_y of the law at every 30th point beside those of rings dragged in small steps.
fn dragged_rings(stiffness: &ContactStiffness, coulomb: &Curve) -> Vec<(f64, f64)> {
    const RINGS: usize = 500;
    const STEPS: usize = 20; // between two points of the curve
    let c = [stiffness.c_x, stiffness.c_y];
    let radii: Vec<f64> = (0..RINGS).map(|i| (i as f64 + 0.5) / RINGS as f64).collect();
    let mut anchors = vec![[0.0; 2]; RINGS];
    let (mut pairs, mut last) = (Vec::new(), 0.0);
    for (number, (x, force)) in coulomb.iter().enumerate().skip(1) {
        for step in 1..=STEPS {
            let shift = last + (x - last) * step as f64 / STEPS as f64;
            for (anchor, r) in anchors.iter_mut().zip(&radii) {
                *anchor = dragged(*anchor, shift, c, stiffness.c_z * (1.0 - r * r));
            }
        }
        last = *x;
        if number % 30 == 0 {
            for i in 0..2 {
                let sum: f64 = anchors.iter().map(|anchor| c[i] * (x - anchor[i])).sum();
                // F_z = (2/3) c_z at the approach 1.
                let whole = sum / RINGS as f64 / (2.0 / 3.0 * stiffness.c_z);
                pairs.push((force[i], whole));
            }
        }
    }
    pairs
}

/// The anchor of an annulus after a small step of the shift (x, x): it slips by λ t until the traction t = C
/// (x - W) is at its limit again.
fn dragged(anchor: [f64; 2], shift: f64, c: [f64; 2], limit: f64) -> [f64; 2] {
    let [trial_x, trial_y] = [c[0] * (shift - anchor[0]), c[1] * (shift - anchor[1])];
    let at = |slip: f64| [trial_x / (1.0 + slip * c[0]), trial_y / (1.0 + slip * c[1])];
    let is_beyond = |[x, y]: [f64; 2]| x * x + y * y > limit * limit;
    if !is_beyond([trial_x, trial_y]) {
        return anchor;
    }
    let mut enough = 1.0;
    while is_beyond(at(enough)) && enough < 1e9 {
        enough *= 2.0;
    }
    let [_, slip] = bisect([0.0, enough], 40, |slip| is_beyond(at(slip)));
    let [x, y] = at(slip);
    [shift - x / c[0], shift - y / c[1]]
}
