//! Figs. 6.13 and 6.14: the regime that follows each increment.

use carom_drawn::{Congruential, Draw as _};
use carom_laws::memory::{MemoryRegime, ScalarMemory};
use carom_special::RangeError;
use carom_special::roots::try_bisect;

use super::history::{Place, follow};
use crate::{Absolute, Axis, Claim, Failure, Figure, FigureResult, Panel, Series, linspace};

/// The regime after a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Complete adhesion.
    Adhesion,
    /// The n-th decrease of the stick area, with the sign of the traction in its ring.
    Decrease(usize, i8),
    /// The whole contact slides.
    Sliding,
}

fn kind(memory: &ScalarMemory) -> Kind {
    match (memory.regime(), memory.slip_direction()) {
        (MemoryRegime::Sliding, _) => Kind::Sliding,
        (MemoryRegime::Adhesion, _) => Kind::Adhesion,
        (_, Some(sign)) => Kind::Decrease(memory.decrease(), if sign > 0.0 { 1 } else { -1 }),
        // A receding edge without slip: the present decrease continues.
        (_, None) => Kind::Decrease(memory.decrease(), 0),
    }
}

fn after(memory: &ScalarMemory, zeta: f64, shift: f64) -> Result<Kind, RangeError> {
    let mut memory = memory.clone();
    memory.advance(zeta, shift)?;
    Ok(kind(&memory))
}

/// One bar: the shifts that lead to each regime, at a new approach.
struct Bar {
    memory: ScalarMemory,
    zeta: f64,
    /// Range of the abscissa, which is shift - origin.
    range: (f64, f64),
    origin: f64,
}

impl Bar {
    fn kind(&self, at: f64) -> Result<Kind, RangeError> {
        after(&self.memory, self.zeta, self.origin + at)
    }

    /// The regimes from left to right with the ends of each, located by bisection.
    fn pieces(&self) -> Result<Vec<(Kind, f64, f64)>, RangeError> {
        let places = linspace(self.range.0, self.range.1, 400);
        let mut pieces = Vec::new();
        let mut start = places[0];
        let mut running = self.kind(start)?;
        for pair in places.windows(2) {
            let next = self.kind(pair[1])?;
            if next != running {
                let runs = |at: f64| Ok::<_, RangeError>(self.kind(at)? == running);
                let [low, high] = try_bisect([pair[0], pair[1]], 50, runs)?;
                pieces.push((running, start, low));
                (running, start) = (next, high);
            }
        }
        pieces.push((running, start, self.range.1));
        Ok(pieces)
    }

    /// (a*/a)² after the step.
    fn stick(&self, at: f64) -> Result<f64, RangeError> {
        let mut memory = self.memory.clone();
        memory.advance(self.zeta, self.origin + at)?;
        Ok(memory.stick_depth() / self.zeta)
    }

    /// Draws the regimes as stripes behind the size of the stick area; `name` gives the names of the regimes,
    /// `marks` the names of points on the abscissa.
    fn panel(
        &self,
        title: &str,
        axis: &str,
        name: impl Fn(Kind) -> &'static str,
        marks: &[(&str, f64)],
    ) -> Result<Panel, RangeError> {
        let mut panel = Panel::new(
            axis,
            Axis::linear("stick area over contact area, (a*/a)²").between(0.0, 1.75),
        )
        .titled(title);
        let mut seen: Vec<&'static str> = Vec::new();
        for (kind, low, high) in self.pieces()? {
            let name = name(kind);
            let known = seen.iter().position(|other| *other == name);
            let colour = known.unwrap_or(seen.len());
            if known.is_none() {
                seen.push(name);
            }
            let label = if known.is_none() { name } else { "" };
            let corners = [(low, 0.0), (high, 0.0), (high, 1.0), (low, 1.0), (low, 0.0)];
            panel.add(Series::area(label, corners).coloured(colour));
        }
        let mut curve = Vec::new();
        for (_, low, high) in self.pieces()? {
            // Not quite up to the ends, where the size may jump.
            for part in linspace(1e-6, 1.0 - 1e-6, 41) {
                let at = low + part * (high - low);
                curve.push((at, self.stick(at)?));
            }
        }
        panel.add(Series::line("(a*/a)²", curve).coloured(6));
        for &(mark, at) in marks {
            panel.add(Series::line("", [(at, 1.0), (at, 1.05)]).coloured(6));
            panel.add(Series::note(mark, (at - 0.05, 1.06)).coloured(6));
        }
        Ok(panel)
    }

    /// The size of the stick area beside the expected one, along the whole bar.
    fn stick_claim(
        &self,
        name: &str,
        expected: impl Fn(Kind, f64) -> f64,
    ) -> Result<Claim, RangeError> {
        let mut pairs = Vec::new();
        for (kind, low, high) in self.pieces()? {
            for part in linspace(0.01, 0.99, 25) {
                let shift = low + part * (high - low);
                let depth = expected(kind, self.origin + shift);
                pairs.push((self.stick(shift)?, depth / self.zeta));
            }
        }
        Ok(Claim::all_close(format!("{name}: size of the stick area"), pairs, Absolute(1e-12)))
    }

    /// The inner ends of the pieces, beside those expected.
    fn claim(
        &self,
        name: &str,
        expected: &[(Kind, f64)],
        source: &str,
    ) -> Result<[Claim; 2], RangeError> {
        let pieces = self.pieces()?;
        let ends = pieces.iter().map(|piece| piece.2);
        let pairs: Vec<(f64, f64)> =
            ends.zip(expected.iter().map(|end| end.1)).take(expected.len() - 1).collect();
        let found = pieces.iter().map(|piece| piece.0);
        let matches = found.zip(expected).filter(|(found, expected)| *found == expected.0).count();
        let same = matches == expected.len() && pieces.len() == expected.len();
        Ok([
            Claim::holds(format!("{name}: regimes in this order"), same, matches as f64)
                .source(source),
            Claim::all_close(format!("{name}: borders"), pairs, Absolute(1e-9)).source(source),
        ])
    }
}

/// Fig. 6.13.
pub(super) fn second() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("P₁", "ζ₁ = 1, ξ₁/(f κ) = 0.5; Δζ₂ = 0.1 and -0.1");
    let name = |kind| match kind {
        Kind::Adhesion => "complete adhesion",
        Kind::Decrease(2, _) => "P₁ and second decrease",
        Kind::Decrease(_, -1) => "first decrease, opposite",
        Kind::Decrease(..) => "first decrease goes on",
        Kind::Sliding => "sliding",
    };
    let memory = follow(&[(1.0, 0.0), (1.0, 0.5)])?;
    let end = f64::NAN;
    for (title, step, marks, borders) in [
        (
            "a) Δζ₂ > 0",
            0.1,
            [("A", -0.6), ("P₁", 0.4)],
            vec![
                (Kind::Sliding, -1.1),
                (Kind::Decrease(1, -1), -0.6),
                (Kind::Decrease(2, -1), 0.4),
                (Kind::Adhesion, 0.6),
                (Kind::Decrease(1, 1), 1.1),
                (Kind::Sliding, end),
            ],
        ),
        (
            "b) Δζ₂ < 0",
            -0.1,
            [("A", -0.4), ("P₁", 0.4)],
            vec![
                (Kind::Sliding, -0.9),
                (Kind::Decrease(1, -1), -0.4),
                (Kind::Decrease(2, -1), 0.4),
                (Kind::Decrease(1, 1), 0.9),
                (Kind::Sliding, end),
            ],
        ),
    ] {
        let bar =
            Bar { memory: memory.clone(), zeta: 1.0 + step, range: (-1.29, 1.28), origin: 0.0 };
        figure.panel(bar.panel(title, "ξ₂ / (f κ ζ₁)", name, &marks)?);
        let (zeta, grown) = (1.0 + step, step);
        let depth = |kind, shift: f64| match kind {
            Kind::Sliding => 0.0,
            Kind::Adhesion => zeta,
            Kind::Decrease(2, _) => zeta + 0.5 * (shift - 0.5 - grown),
            Kind::Decrease(..) => zeta - shift.abs(),
        };
        figure.claim(bar.stick_claim(title, depth)?.source("(6.13), (6.29), (6.40)"));
        let source = "(6.44), (6.45), (6.47): A at -ξ₁ - Δζ₂, P₁ at ξ₁ - |Δζ₂|; sliding at ±ζ₂";
        for claim in bar.claim(title, &borders, source)? {
            figure.claim(claim);
        }
    }
    figure.claim(random_second()?.source("(6.43) to (6.47), and the receding edge"));
    figure.deviation(
        "(6.44) and (6.47) for every Δζ₂ < 0",
        "if ζ₂ < ζ₁* the first decrease follows in the sense of ξ₂",
        "gap of the text: the edge recedes behind a₁* and takes the first ring with it",
    );
    figure.deviation("P₁ in 12b) (text after (6.47))", "fig. 6.13b", "slip of the text");
    Ok(figure)
}

/// Number of 5000 random second steps that contradict the conditions of the thesis.
fn random_second() -> Result<Claim, RangeError> {
    let mut sequence = Congruential(613);
    let mut wrong = 0.0;
    for _ in 0..5000 {
        let first = sequence.between(0.05, 0.95);
        let (zeta, shift) = (sequence.between(0.4, 1.6), sequence.between(-1.5, 1.5));
        let (grown, change) = (zeta - 1.0, shift - first);
        let expected = if shift.abs() >= zeta {
            Kind::Sliding
        } else if change.abs() < grown {
            Kind::Adhesion
        } else if zeta < 1.0 - first {
            // The edge recedes inside a_1*: the first slip annulus has left the contact.
            Kind::Decrease(1, if shift > 0.0 { 1 } else { -1 })
        } else if change >= -grown.abs() {
            Kind::Decrease(1, 1)
        } else if shift > -first - grown {
            Kind::Decrease(2, -1)
        } else {
            Kind::Decrease(1, -1)
        };
        let memory = follow(&[(1.0, 0.0), (1.0, first)])?;
        if after(&memory, zeta, shift)? != expected {
            wrong += 1.0;
        }
    }
    Ok(Claim::at_most("of 5000 random steps another regime follows in", wrong, 0.0))
}

/// Fig. 6.14, with N = 3.
pub(super) fn nth() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("N", "3: P₁ = (ζ, ξ/(f κ)) = (1, 0.6)");
    figure.assumed("a)", "P₂ = (1.1, -0.3), Δζ₃ = 0.1");
    figure.assumed("b)", "P₂ = (0.9, -0.1), Δζ₃ = -0.1");
    let name = |kind| match kind {
        Kind::Adhesion => "complete adhesion",
        Kind::Decrease(3, _) => "N-th decrease",
        Kind::Decrease(2, _) => "(N-1)-th goes on",
        Kind::Decrease(..) => "(N-2)-th decrease",
        Kind::Sliding => "sliding",
    };
    let end = f64::NAN;
    for (title, (step, shift), most, mark, borders) in [
        (
            "a) Δζ > 0 in both steps",
            (0.1, -0.3),
            1.68,
            1.1,
            vec![
                (Kind::Decrease(2, -1), -0.1),
                (Kind::Adhesion, 0.1),
                (Kind::Decrease(3, 1), 0.9 + 0.1 + 0.1),
                (Kind::Decrease(1, 1), 1.2 + 0.3),
                (Kind::Sliding, end),
            ],
        ),
        (
            "b) Δζ < 0 in both steps",
            (-0.1, -0.1),
            1.28,
            0.5,
            vec![
                (Kind::Decrease(2, -1), 0.1),
                (Kind::Decrease(3, 1), 0.7 - 0.1 - 0.1),
                (Kind::Decrease(1, 1), 0.8 + 0.1),
                (Kind::Sliding, end),
            ],
        ),
    ] {
        let history: [Place; 3] = [(1.0, 0.0), (1.0, 0.6), (1.0 + step, shift)];
        let bar = Bar {
            memory: follow(&history)?,
            zeta: 1.0 + 2.0 * step,
            range: (-0.29, most),
            origin: shift,
        };
        let marks = [("A", mark), ("P_2", step.abs())];
        figure.panel(bar.panel(title, "Δξ_N / (f κ ζ₁)", name, &marks)?);
        let (second, zeta) = (1.0 + step, 1.0 + 2.0 * step);
        let depth = |kind, to: f64| match kind {
            Kind::Sliding => 0.0,
            Kind::Adhesion => zeta,
            Kind::Decrease(3, _) => 0.5 * (zeta + second - (to - shift)),
            // It continues from P_1 as if there had been no second step.
            Kind::Decrease(2, _) => 0.5 * (zeta + 1.0 + (to - 0.6)),
            Kind::Decrease(..) => zeta - to.abs(),
        };
        figure.claim(bar.stick_claim(title, depth)?.source("(6.13), (6.40), (6.48)"));
        let source = "(6.51): f κ |Δζ_N| and A = |Δξ_N-1| + f κ (Δζ_N-1 + Δζ_N)";
        for claim in bar.claim(title, &borders, source)? {
            figure.claim(claim);
        }
    }
    nth_claims(&mut figure)?;
    figure.deviation(
        "N > 2 for (6.48)",
        "N ≥ 2; with N = 2 the right side of (6.51) is 2|ξ₁| + f κ Δζ₂",
        "(6.39) is the case N = 2",
    );
    figure.deviation(
        "for Δζ_N < 0 and |Δξ_N| < f κ |Δζ_N| the running decrease goes on",
        "unless the edge recedes behind ζ_N*: then P_N-1 is erased",
        "gap of the text; with it the force of the springs is met",
    );
    Ok(figure)
}

/// (6.51) for random steps, and the receding edge, which the thesis omits.
fn nth_claims(figure: &mut Figure) -> Result<(), Failure> {
    let mut sequence = Congruential(614);
    let (mut wrong, mut tried) = (0.0, 0.0);
    while tried < 5000.0 {
        let (second, third) = (sequence.between(0.6, 1.4), sequence.between(0.5, 1.6));
        let history: [Place; 3] =
            [(1.0, 0.0), (1.0, sequence.between(0.2, 0.95)), (second, sequence.between(-0.9, 0.9))];
        let memory = follow(&history)?;
        let shift = sequence.between(-1.5, 1.5);
        let (last, change) = (history[2].1 - history[1].1, shift - history[2].1);
        let (grown_last, grown) = (second - 1.0, third - second);
        if kind(&memory) != Kind::Decrease(2, -1) || change.abs() < -grown || change < grown {
            continue; // not the situation of the figure, which has change > |grown|, or adhesion
        }
        tried += 1.0;
        let expected = if shift.abs() >= third {
            Kind::Sliding
        } else if change < last.abs() + grown_last + grown {
            Kind::Decrease(3, 1)
        } else {
            Kind::Decrease(1, 1)
        };
        if after(&memory, third, shift)? != expected {
            wrong += 1.0;
        }
    }
    figure.at_most("of 5000 random steps another regime follows in", wrong, 0.0).source("(6.51)");
    // The edge recedes inside zeta_2* = 0.95 with a small shift: P_1 is erased.
    let receding: [Place; 4] = [(1.0, 0.0), (1.0, 0.6), (1.0, 0.5), (0.7, 0.48)];
    let memory = follow(&receding)?;
    figure
        .close(
            "slip rings after the edge recedes behind ζ₂*",
            memory.decrease() as f64,
            1.0,
            Absolute(0.0),
        )
        .source("the second ring has left the contact");
    super::history::springs_claim(figure, "receding edge", &receding)?;
    super::history::springs_claim(
        figure,
        "N = 3 and wipe-out",
        &[(1.0, 0.0), (1.0, 0.6), (1.1, -0.3), (1.2, 0.4), (1.2, 0.9)],
    )?;
    super::history::reference_claim(
        figure,
        "N up to 6",
        include_str!("../../../data/laws/history_fifth_decrease.csv"),
    )
}
