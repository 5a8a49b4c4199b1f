//! Paths of approach and shift whose direction turns.

use carom_drawn::{Draw as _, Splitmix};

pub(crate) type Path = Vec<(f64, [f64; 2])>;

/// Kinds of paths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Adhesion,
    Collinear,
    Turning,
    TurningVarying,
    Corners,
    Collision,
    Noise,
    Curls,
    Adversarial,
}

impl Kind {
    pub(crate) const ALL: [Self; 9] = [
        Self::Adhesion,
        Self::Collinear,
        Self::Turning,
        Self::TurningVarying,
        Self::Corners,
        Self::Collision,
        Self::Noise,
        Self::Curls,
        Self::Adversarial,
    ];

    /// A path of this kind in approaches up to 1.3.
    pub(crate) fn path(self, random: &mut Splitmix) -> Path {
        match self {
            Self::Adhesion => adhesion(random),
            Self::Collinear => collinear(random),
            Self::Turning => turning(random, 0.0),
            Self::TurningVarying => turning(random, 0.25),
            Self::Corners => corners(random),
            Self::Collision => collision(random),
            Self::Noise => noise(random),
            Self::Curls => curls(random),
            Self::Adversarial => adversarial(random),
        }
    }
}

fn ahead(x: [f64; 2], length: f64, angle: f64) -> [f64; 2] {
    [x[0] + length * angle.cos(), x[1] + length * angle.sin()]
}

fn adhesion(random: &mut Splitmix) -> Path {
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    let mut angle = random.between(0.0, 6.3);
    (0..60)
        .map(|_| {
            let growth = random.between(0.005, 0.035);
            angle += random.between(-0.5, 0.5);
            x = ahead(x, growth * random.between(0.0, 0.99), angle);
            zeta += growth;
            (zeta, x)
        })
        .collect()
}

fn collinear(random: &mut Splitmix) -> Path {
    let (angle, mut zeta, mut at) = (random.between(0.0, 6.3), 1.0, 0.0);
    (0..60)
        .map(|_| {
            at = 0.7 * at + 0.6 * random.between(-1.0, 1.0);
            zeta = 0.8 * zeta + 0.2 * random.between(0.5, 1.3);
            (zeta, [at * angle.cos(), at * angle.sin()])
        })
        .collect()
}

fn turning(random: &mut Splitmix, swing: f64) -> Path {
    let (mut angle, mut x) = (random.between(0.0, 6.3), [0.0; 2]);
    let (step, phase) = (10_f64.powf(random.between(-1.7, -0.4)), random.between(0.0, 6.3));
    let mut turn = 0.0;
    let mut path = vec![(1.0 + swing * phase.sin(), x)];
    for i in 0..60 {
        turn = 0.7 * turn + random.between(-0.3, 0.3);
        angle += turn;
        x = ahead(x, step * random.between(0.5, 1.5), angle);
        path.push((1.0 + swing * (phase + 0.2 * f64::from(i)).sin(), x));
    }
    path
}

fn corners(random: &mut Splitmix) -> Path {
    let (mut angle, mut x) = (random.between(0.0, 6.3), [0.0; 2]);
    let mut path = vec![(1.0, x)];
    while path.len() < 60 {
        angle += random.between(-3.1, 3.1);
        let step = 10_f64.powf(random.between(-2.0, -0.5));
        for _ in 0..1 + random.below(8) {
            x = ahead(x, step, angle);
            path.push((1.0, x));
        }
    }
    path
}

fn collision(random: &mut Splitmix) -> Path {
    let [a, b, c, d] = [0; 4].map(|_| random.between(-1.5, 1.5));
    let [p, q] = [0; 2].map(|_| random.between(0.0, 6.3));
    let n = 40 + random.below(60);
    (1..n)
        .map(|i| {
            let t = std::f64::consts::PI * i as f64 / n as f64;
            let x = a * (1.3 * t + p).sin() + 0.3 * b * (3.1 * t + q).cos();
            let y = c * (1.1 * t + q).cos() + 0.3 * d * (2.7 * t + p).sin();
            (t.sin(), [x, y])
        })
        .collect()
}

fn noise(random: &mut Splitmix) -> Path {
    let size = 10_f64.powf(random.between(-3.0, -1.5));
    let base = ahead([0.0; 2], random.between(0.0, 0.8), random.between(0.0, 6.3));
    let mut path = vec![(1.0, [0.0; 2]), (1.0, base)];
    for _ in 0..80 {
        let x = ahead(base, size * random.part(), random.between(0.0, 6.3));
        path.push((1.0 + size * random.between(-1.0, 1.0), x));
    }
    path
}

fn curls(random: &mut Splitmix) -> Path {
    let radius = 10_f64.powf(random.between(-2.5, -1.0));
    let drift = ahead([0.0; 2], 0.3 * radius, random.between(0.0, 6.3));
    let step = random.between(0.02, 0.5);
    let mut path = vec![(1.0, [0.0; 2])];
    for i in 0..200 {
        let t = step * f64::from(i);
        let centre = [drift[0] * t, drift[1] * t];
        path.push((1.0, ahead(centre, radius, t)));
    }
    path
}

/// Returns through anchors, reversals, nearly parallel steps, the cone itself, steps of nearly
/// nothing and of ten approaches, unloading, separation.
fn adversarial(random: &mut Splitmix) -> Path {
    let mut path = vec![(0.8, [0.0; 2])];
    let mut angle = 0.0_f64;
    for _ in 0..60 {
        let [(zeta, x), (_, old)] =
            [path[path.len() - 1], path[path.len().saturating_sub(1 + random.below(5))]];
        let size = 10_f64.powf(random.between(-3.0, 0.0));
        let other = 10_f64.powf(random.between(-13.0, -1.0));
        let next = match random.below(14) {
            0 => (zeta, old),
            1 => (zeta, [0.0; 2]),
            2 => {
                let part = [0.5, 1.0, 2.0][random.below(3)];
                (zeta, [0, 1].map(|k| x[k] + part * (old[k] - x[k])))
            }
            3 => {
                angle += other;
                (zeta, ahead(x, size, angle))
            }
            4 => {
                angle += std::f64::consts::PI + other;
                (zeta, ahead(x, size, angle))
            }
            5 => (zeta, ahead(x, other * other, random.between(0.0, 6.3))),
            6 => (zeta, ahead(x, 10.0 * zeta, random.between(0.0, 6.3))),
            7 => (zeta * random.part(), x),
            8 => (zeta + 0.5 * size, ahead(x, 0.5 * size, angle)),
            9 => (zeta - 0.5 * size, ahead(x, 0.5 * size, angle)),
            10 => {
                (zeta + 0.2 * random.between(-1.0, 1.0), ahead(x, size, random.between(0.0, 6.3)))
            }
            11 if random.below(3) == 0 => (-0.1, old),
            _ => {
                angle = random.between(0.0, 6.3);
                (zeta, ahead(x, size, angle))
            }
        };
        let next = (if next.0 < 0.0 { next.0 } else { next.0.clamp(0.05, 1.3) }, next.1);
        // Far from where it began the rounding of the shifts themselves would count.
        path.push((next.0, next.1.map(|x| x.clamp(-30.0, 30.0))));
    }
    path
}

/// Each step of a path in equal parts.
pub(crate) fn divided(path: &Path, parts: usize) -> Path {
    let mut at = path[0];
    let mut fine = vec![at];
    for &to in &path[1..] {
        for i in 1..=parts {
            let t = i as f64 / parts as f64;
            let mix = |a: f64, b: f64| if i == parts { b } else { a + t * (b - a) };
            fine.push((mix(at.0, to.0), [mix(at.1[0], to.1[0]), mix(at.1[1], to.1[1])]));
        }
        at = to;
    }
    fine
}
