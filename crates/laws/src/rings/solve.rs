//! Tractions of a step: within the friction limit, with slip along those that reach it.
//!
//! Minimises `q M q/2 - q c` over discs by operator splitting: the quadratic form and the discs in turn, with
//! one inverse computed beforehand. The multiplier of a disc is the slip.

use super::centre;
use super::pair::{Block, Pair, PressBlock, RimBlock, block_of_way};
use super::symmetry::Symmetry;
use super::transform::Field;

/// Over-relaxation factor.
const RELAX: f64 = 1.6;
/// Number of iterations between updates of the added pressures: they are updated in the first and every
/// fourth.
const PRESS_EACH: usize = 3;
/// Maximum number of iterations; large steps at a tolerance of 1e-4 take 19 in the mean.
const MOST: usize = 400;
/// Least share of the pressures that push: below, the change of the area is no small one.
const LEAST_KEPT: f64 = 0.5;
/// Approximate largest displacement by tractions at their limits, over a^2.
const STICKING: f64 = 1.5;
/// The same, if slip has a first guess: only a guess far off is replaced.
const FAR: f64 = 20.0;
/// After this number of iterations the extrapolated slip is reduced, since some points could oscillate
/// otherwise.
const PATIENCE: usize = 16;
/// The number of iterations more at gamma/f above 1, where slip turns: with fine tolerances steps would be of first order
/// otherwise.
const MORE_PATIENCE: f64 = 24.0;

/// The unknowns: tractions z over the contact radius, and y, the slip over sigma a^2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tractions<const N: usize, const H: usize> {
    pub(super) z: Field<N, H>,
    pub(super) y: Field<N, H>,
    /// The friction limit of z: Hertz's pressure and the pressures that tractions add.
    pub(super) limit: [[f64; N]; H],
    /// The radial and circumferential displacement of the rim over a^2.
    pub(super) rim: [[f64; 2]; H],
    /// The way of the centre over the radius.
    pub(super) way: [f64; 2],
}

/// The fraction of the rim's slip that each ring takes when it enters the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Share<const N: usize> {
    pub(super) of_rim: [f64; N],
    /// The same for the mean circumferential slip, which is also proportional to the radius.
    pub(super) of_twist: [f64; N],
}

/// How entering rings follow the displacement of the rim.
#[derive(Debug, Clone, Copy)]
struct Entering<const N: usize, const H: usize> {
    /// By blocks: the inverse times the fraction of each ring, for each component of a block.
    columns: [[[[f64; N]; 2]; 2]; H],
    /// By blocks, `(1 - Rim columns)^-1`.
    small: [[[f64; 2]; 2]; H],
}

impl<const N: usize, const H: usize> Entering<N, H> {
    /// With the fraction of each ring and one of the inverses of a pair.
    #[inline(never)]
    fn new<S: Symmetry<H>>(inverses: &[Block<N>], rims: &[RimBlock<N>], share: &Share<N>) -> Self {
        let mut out = Self { columns: [[[[0.0; N]; 2]; 2]; H], small: [[[0.0; 2]; 2]; H] };
        for (b, (inverse, rim)) in inverses.iter().zip(rims).enumerate() {
            let mut small = [[0.0; 2]; 2];
            for part in 0..2 {
                let mut sources = [[0.0; N]; 2];
                // The second component of the first block of a whole turn is the twist.
                sources[part] =
                    if (S::whole_block(b), part) == (0, 1) { share.of_twist } else { share.of_rim };
                let column = applied(inverse, &sources);
                let at_rim = seen(rim, &column);
                for out in 0..2 {
                    small[out][part] = f64::from(u8::from(out == part)) - at_rim[out];
                }
                out.columns[b][part] = column;
            }
            let [[p, q], [r, s]] = small;
            let scale = 1.0 / (p * s - q * r);
            out.small[b] = [[s * scale, -q * scale], [-r * scale, p * scale]];
        }
        out
    }
}

/// A block times the tractions of its components.
#[inline(always)]
fn applied<const N: usize>(block: &Block<N>, of: &[[f64; N]; 2]) -> [[f64; N]; 2] {
    let mut out = [[0.0; N]; 2];
    for (columns, part) in block.iter().zip(of) {
        for (column, value) in columns.iter().zip(part) {
            for c in 0..2 {
                for i in 0..N {
                    out[c][i] += column[c][i] * value;
                }
            }
        }
    }
    out
}

#[inline(always)]
fn seen<const N: usize>(rim: &RimBlock<N>, of: &[[f64; N]; 2]) -> [f64; 2] {
    std::array::from_fn(|out| {
        (0..2).map(|part| (0..N).map(|i| rim[out][part][i] * of[part][i]).sum::<f64>()).sum()
    })
}

#[inline(always)]
fn pressed<const N: usize>(press: &PressBlock<N>, of: &[[f64; N]; 2]) -> [f64; N] {
    let mut out = [0.0; N];
    for (columns, part) in press.iter().zip(of) {
        for (column, value) in columns.iter().zip(part) {
            for i in 0..N {
                out[i] += column[i] * value;
            }
        }
    }
    out
}

#[inline(always)]
fn block_of<const N: usize, const H: usize, S: Symmetry<H>>(
    hat: &Field<N, H>,
    block: usize,
) -> [[f64; N]; 2] {
    S::places(block).map(|(k, c)| hat[k][c])
}

// The methods below are not inlined: their code is large, and a call costs nothing beside it.
impl<const N: usize, const H: usize, S: Symmetry<H>> Pair<N, H, S> {
    /// An inverse of the pair times a right-hand side, by harmonics; the spectrum stays in `hat`.
    #[inline(never)]
    fn divided(
        &self,
        inverses: &[Block<N>],
        hat: &mut Field<N, H>,
        entering: Option<&Entering<N, H>>,
    ) -> Field<N, H> {
        S::to_harmonics(&self.waves, hat);
        for (b, inverse) in inverses.iter().enumerate() {
            let places = S::places(b);
            let sources = places.map(|(k, c)| hat[k][c]);
            let mut q = applied(inverse, &sources);
            if let Some(entering) = entering {
                let at_rim = seen(&self.rim[b], &q);
                let by = entering.small[b].map(|row| row[0] * at_rim[0] + row[1] * at_rim[1]);
                for (column, by) in entering.columns[b].iter().zip(by) {
                    for c in 0..2 {
                        for i in 0..N {
                            q[c][i] += column[c][i] * by;
                        }
                    }
                }
            }
            for ((k, c), part) in places.into_iter().zip(q) {
                hat[k][c] = part;
            }
        }
        let mut q = *hat;
        S::to_angles(&self.waves, &mut q);
        q
    }

    /// The limits; without coupling Hertz's pressure.
    fn limits_now(&self, hat: &Field<N, H>) -> [[f64; N]; H] {
        if self.lift == 0.0 { [self.layout.pressure; H] } else { self.limits(hat) }
    }

    /// The limits with the pressures that tractions with this spectrum add.
    #[inline(never)]
    fn limits(&self, hat: &Field<N, H>) -> [[f64; N]; H] {
        let mut added: Field<N, H> = [[[0.0; N]; 2]; H];
        for (b, press) in self.press.iter().enumerate() {
            let [(k, c), (mirror, _)] = S::places(b);
            let p = pressed(press, &block_of::<N, H, S>(hat, b));
            added[k][c] = p;
            if k != mirror {
                added[mirror][c] = if c == 0 { p } else { p.map(|x| -x) };
            }
        }
        S::to_angles(&self.waves, &mut added);
        let pressures =
            added.map(|[p, _]| std::array::from_fn(|i| self.layout.pressure[i] + self.lift * p[i]));
        // Without slip they limit nothing, and what would part keeps its tension.
        if self.slips { self.pushing(pressures) } else { pressures }
    }

    /// Pressures without the tension of places that part, and with the same normal force: the edge recedes there and
    /// advances elsewhere, which changes the energy in the third order of gamma only.
    #[inline(never)]
    fn pushing(&self, mut pressures: [[f64; N]; H]) -> [[f64; N]; H] {
        let (mut all, mut pushing) = (0.0, 0.0);
        for (j, p) in pressures.iter_mut().enumerate() {
            let mut of = [0.0; 2];
            for (p, area) in p.iter_mut().zip(&self.layout.area) {
                of[0] += area * *p;
                *p = p.max(0.0);
                of[1] += area * *p;
            }
            all += S::weight(j) * of[0];
            pushing += S::weight(j) * of[1];
        }
        if all == pushing {
            return pressures;
        }
        let share = (all / pushing).max(LEAST_KEPT);
        pressures.map(|p| p.map(|p| share * p))
    }

    /// The displacement of the rim by tractions with this spectrum.
    #[inline(never)]
    fn at_rim(&self, hat: &Field<N, H>) -> [[f64; 2]; H] {
        let mut out: Field<1, H> = [[[0.0; 1]; 2]; H];
        for (b, rim) in self.rim.iter().enumerate() {
            let u = seen(rim, &block_of::<N, H, S>(hat, b));
            for ((k, c), u) in S::places(b).into_iter().zip(u) {
                out[k][c] = [u];
            }
        }
        S::to_angles(&self.waves, &mut out);
        out.map(|parts| parts.map(|[u]| u))
    }

    /// The way of the centre over the radius by tractions with this spectrum.
    fn way(&self, hat: &Field<N, H>) -> [f64; 2] {
        if self.lift == 0.0 || S::OPPOSITE {
            return [0.0; 2];
        }
        let along = |odd: usize| -> f64 {
            if S::MIRRORED && odd == 1 {
                return 0.0;
            }
            let of = block_of::<N, H, S>(hat, block_of_way::<H, S>(odd));
            let parts = self.way[odd].as_flattened().iter().zip(of.as_flattened());
            self.lift * parts.map(|(way, q)| way * q).sum::<f64>()
        };
        centre::bounded([along(0), along(1)])
    }

    /// Computes what the spectrum of the tractions gives: the displacement of the rim and the way of the centre.
    fn see(&self, now: &mut Tractions<N, H>, hat: &Field<N, H>) {
        (now.rim, now.way) = (self.at_rim(hat), self.way(hat));
    }

    /// If nothing slipped before: the tractions in full adhesion, if they are within their limits.
    fn stuck(&self, c: &Field<N, H>, share: Option<&Share<N>>, now: &mut Tractions<N, H>) -> bool {
        let slipped = now.y.iter().flatten().flatten().any(|&y| y != 0.0);
        if self.slips && slipped {
            return false;
        }
        let mut hat = *c;
        let entering = share.map(|share| Entering::new::<S>(&self.sticking, &self.rim, share));
        let q = self.divided(&self.sticking, &mut hat, entering.as_ref());
        let limit = self.limits_now(&hat);
        let within = |([x, y], limit): (&[[f64; N]; 2], &[f64; N])| {
            (0..N).all(|i| x[i] * x[i] + y[i] * y[i] <= limit[i] * limit[i])
        };
        if self.slips && !q.iter().zip(&limit).all(within) {
            return false;
        }
        (now.z, now.limit) = (q, limit);
        self.see(now, &self.spectrum(&now.z));
        true
    }

    /// Solves `c = M q + sigma y`, starting from the previous tractions; returns the number of iterations.
    /// Slip starts with `ahead`, in the unit of y. Rings that enter the contact take a fraction of the rim's
    /// slip.
    pub(super) fn solve(
        &self,
        c: &Field<N, H>,
        ahead: &Field<N, H>,
        share: Option<&Share<N>>,
        tolerance: f64,
        now: &mut Tractions<N, H>,
    ) -> usize {
        if self.stuck(c, share, now) {
            return 1;
        }
        let entering = share.map(|share| Entering::new::<S>(&self.inverse, &self.rim, share));
        let close = tolerance * self.scale;
        let couples = self.lift != 0.0;
        let patience = PATIENCE + (MORE_PATIENCE * self.spread.min(1.0)) as usize;
        if !couples {
            now.limit = [self.layout.pressure; H];
        }
        let is_first = now.y.iter().flatten().flatten().all(|&y| y == 0.0);
        self.slide(c, if is_first { STICKING } else { FAR }, now);
        let mut part = 1.0;
        let mut count = MOST;
        for iteration in 0..MOST {
            let mut hat = *c;
            let places = now.z.as_flattened().iter().zip(now.y.as_flattened());
            for (hat, (z, y)) in hat.as_flattened_mut().iter_mut().zip(places) {
                for i in 0..N {
                    hat[i] += self.sigma[i] * (z[i] - y[i]);
                }
            }
            let q = self.divided(&self.inverse, &mut hat, entering.as_ref());
            if couples && iteration % PRESS_EACH == 0 {
                now.limit = self.limits(&hat);
            }
            if iteration >= patience {
                part *= 0.75;
            }
            if cut(&q, ahead, part, now) < close * close {
                count = iteration + 1;
                break;
            }
        }
        self.see(now, &self.spectrum(&now.z));
        count
    }

    /// Starts with sliding if the first guess of slip leaves displacements above `most` to the tractions.
    fn slide(&self, c: &Field<N, H>, most: f64, now: &mut Tractions<N, H>) {
        for (j, [x, y]) in c.iter().enumerate() {
            for i in 0..N {
                let left =
                    [x[i] - self.sigma[i] * now.y[j][0][i], y[i] - self.sigma[i] * now.y[j][1][i]];
                if left[0] * left[0] + left[1] * left[1] <= most * most {
                    continue;
                }
                let size = x[i].hypot(y[i]).max(STICKING);
                let [slip, traction] =
                    [(1.0 - STICKING / size) / self.sigma[i], self.layout.pressure[i] / size];
                for (d, c) in [x[i], y[i]].into_iter().enumerate() {
                    (now.y[j][d][i], now.z[j][d][i]) = (slip * c, traction * c);
                }
            }
        }
    }

    /// The harmonics of tractions.
    #[inline(never)]
    fn spectrum(&self, z: &Field<N, H>) -> Field<N, H> {
        let mut hat = *z;
        S::to_harmonics(&self.waves, &mut hat);
        hat
    }

    /// Computes what follows from stored tractions: the displacement of the rim, the way of the centre and the limits.
    pub(super) fn follow(&self, now: &mut Tractions<N, H>) {
        let hat = self.spectrum(&now.z);
        now.limit = self.limits_now(&hat);
        self.see(now, &hat);
    }

    /// The tractions that give these displacements.
    pub(super) fn sticking_to(&self, u: &Field<N, H>) -> Field<N, H> {
        self.divided(&self.sticking, &mut u.clone(), None)
    }
}

/// Cuts tractions to their limits, all rings of an angle at once; returns the square of the largest change.
#[inline(always)]
fn cut<const N: usize, const H: usize>(
    q: &Field<N, H>,
    ahead: &Field<N, H>,
    part: f64,
    now: &mut Tractions<N, H>,
) -> f64 {
    let mut greatest = [0.0_f64; N];
    for j in 0..H {
        let ([zx, zy], [yx, yy]) = (&mut now.z[j], &mut now.y[j]);
        let [qx, qy] = &q[j];
        for i in 0..N {
            let vx = RELAX * qx[i] + (1.0 - RELAX) * zx[i] + yx[i];
            let vy = RELAX * qy[i] + (1.0 - RELAX) * zy[i] + yy[i];
            let ahead = [part * ahead[j][0][i], part * ahead[j][1][i]];
            let [nx, ny] = within_limit([vx, vy], ahead, now.limit[j][i]);
            let moved = (nx - zx[i]) * (nx - zx[i]) + (ny - zy[i]) * (ny - zy[i]);
            let apart = (nx - qx[i]) * (nx - qx[i]) + (ny - qy[i]) * (ny - qy[i]);
            greatest[i] = larger(greatest[i], larger(moved, apart));
            (zx[i], zy[i]) = (nx, ny);
            (yx[i], yy[i]) = (vx - nx, vy - ny);
        }
    }
    greatest.into_iter().fold(0.0, larger)
}

/// The larger of two numbers, neither of which is NaN.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The traction for a trial value v: v itself within the limit. Beyond it the excess is slip: first along the
/// extrapolated slip, then along the traction itself. All cases are computed and one is chosen, without branches.
#[inline(always)]
fn within_limit(v: [f64; 2], ahead: [f64; 2], limit: f64) -> [f64; 2] {
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let choose = |first: bool, a: [f64; 2], b: [f64; 2]| {
        [if first { a[0] } else { b[0] }, if first { a[1] } else { b[1] }]
    };
    let (bound, square, along) = (limit * limit, dot(v, v), dot(v, ahead));
    let beyond = [v[0] - ahead[0], v[1] - ahead[1]];
    let rest = dot(beyond, beyond);
    // Part of the extrapolated slip is enough: |v - part ahead| = limit.
    let under = along * along - dot(ahead, ahead) * (square - bound);
    let part = (square - bound) / (along + larger(under, 0.0).sqrt());
    let in_part = [v[0] - part * ahead[0], v[1] - part * ahead[1]];
    // All of it, and more along the traction.
    let scale = limit / rest.sqrt();
    let in_whole = beyond.map(|x| scale * x);
    let scale = limit / square.sqrt();
    let alone = v.map(|x| scale * x);
    let takes_whole = (along > 0.0) & (dot(in_whole, v) >= bound);
    let takes_part = (along > 0.0) & (rest <= bound);
    let cut = choose(takes_part, in_part, choose(takes_whole, in_whole, alone));
    choose(square > bound, cut, v)
}

impl<const N: usize, const H: usize> Default for Tractions<N, H> {
    fn default() -> Self {
        let none = [[[0.0; N]; 2]; H];
        Self { z: none, y: none, limit: [[0.0; N]; H], rim: [[0.0; 2]; H], way: [0.0; 2] }
    }
}
