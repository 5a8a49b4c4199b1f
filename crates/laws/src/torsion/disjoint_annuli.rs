//! A substep in which several disjoint slip annuli may occur.
//!
//! If [`super::within`] does not decide, the solutions with one slip annulus are tried and checked against the
//! friction law on rings of finite width: tractions within their limits, and slip in their direction. If none
//! satisfies it, the rings themselves are solved for any pattern of slip, and their densities
//! replace those of the stack.

use super::complementarity::RingSolution;
use super::heat::{Meter, RingHeat};
use super::history::{SlipPath, TwistHistory};
use super::mesh::Mesh;
use super::recede::lowest_rate;
use super::rings::{Rings, dot};
use super::segment::{Density, Segment};
use super::sliding::{sliding_torque, sliding_twist};

/// The rings extend at least down to this fraction of the radius outside which slip may continue,
/// but not below [`INNERMOST_RING`] times the contact radius. The torque of the contact inside is below
/// 3e-5 of the sliding torque, and it slips as a whole.
const RING_MARGIN: f64 = 0.8;
const INNERMOST_RING: f64 = 0.0302;

/// Relative excess of a traction over its limit that is accepted in a solution with one slip
/// annulus.
const TRACTION_TOLERANCE: f64 = 1e-4;
/// Slip in the wrong direction, relative to the greatest slip, that is attributed to the width of
/// rings.
const SLIP_TOLERANCE: f64 = 1e-4;

/// Changes of density below this count as zero.
const NEGLIGIBLE_CHANGE: f64 = 1e-11;

/// A solution of a substep with one slip annulus.
enum SingleAnnulus {
    /// Growth, whose path [`TwistHistory::grow`] finds.
    Growth,
    /// A known path.
    Path(SlipPath),
}

impl TwistHistory {
    /// Tries one substep. Returns whether several slip annuli occurred, or `None` if the ring solve
    /// did not converge; the state is then unchanged.
    pub(super) fn try_substep(
        &mut self,
        radius: f64,
        twist: f64,
        meter: &mut impl Meter,
    ) -> Option<bool> {
        let inside = radius.min(self.stick);
        let mut lowest = RING_MARGIN * self.kept(inside).calm_inside(radius.min(self.radius));
        loop {
            let inner = lowest.max(INNERMOST_RING * radius);
            let mesh = Mesh::new(radius, inner, self.unit, self.level);
            let before = Cells::averaged(mesh.edges(), self);
            let (single, path) = self.single_annulus(radius, twist);
            if single.obeys(&mesh, &before) {
                match path {
                    SingleAnnulus::Path(path) => self.metered(path, radius, twist, meter),
                    SingleAnnulus::Growth => self.grow(radius, twist, meter),
                }
                return Some(false);
            }
            let rings = Rings::new(&mesh);
            let turned = twist - before.below[0];
            let solution = rings.turn(&before.densities, turned, &single.slips_on(&mesh))?;
            if solution.slips[solution.slips.len() - 3..].iter().any(|slip| *slip != 0.0)
                && lowest > INNERMOST_RING * radius
            {
                lowest *= 0.4;
                continue;
            }

            let slip = |i| rings.slip(i, &solution.changes, solution.core);
            let slips: Vec<f64> = (0..mesh.len()).map(slip).collect();
            let signs = &solution.slips;
            meter.slides(RingHeat { mesh: &mesh, from: self.radius, signs, slips: &slips });
            self.set_ring_densities(&mesh, &before, &solution, twist);
            return Some(true);
        }
    }

    /// The state after a substep with one slip annulus, whether it satisfies the friction law or not.
    fn single_annulus(&self, radius: f64, twist: f64) -> (Self, SingleAnnulus) {
        let mut moved = self.clone();
        if radius > self.radius {
            moved.grow(radius, twist, &mut super::heat::Unmetered);
            return (moved, SingleAnnulus::Growth);
        }
        let inward = self.slip_sign().filter(|sign| {
            let back = -sign * (twist - self.twist) / (self.radius - radius);
            back <= lowest_rate(back, self.stick / self.radius)
                && self.goes_on_slipping(radius, twist, *sign)
        });
        let path = inward.map_or(SlipPath::FromRim, SlipPath::Inward);
        moved.follow(path, radius, twist);
        (moved, SingleAnnulus::Path(path))
    }

    /// The sign of the slip of each ring in this state.
    fn slips_on(&self, mesh: &Mesh) -> Vec<f64> {
        let sign = self.slip_sign().unwrap_or(0.0);
        mesh.middles().iter().map(|s| if *s > self.stick { sign } else { 0.0 }).collect()
    }

    /// Whether this state, following that of the cells, satisfies the friction law.
    fn obeys(&self, mesh: &Mesh, before: &Cells) -> bool {
        if !self.is_admissible() {
            return false;
        }
        let after = Cells::averaged(mesh.edges(), self);
        after.are_within_friction(mesh)
            && self.slip_sign().is_none_or(|sign| after.slip_forward(mesh, before, sign))
    }

    /// Sets new densities on the rings. In the outer slip annulus the sliding density itself is
    /// used, down to the radius that the twist requires; this radius may lie inside a ring, so that
    /// an annulus narrower than a ring is represented.
    fn set_ring_densities(
        &mut self,
        mesh: &Mesh,
        before: &Cells,
        solution: &RingSolution,
        twist: f64,
    ) {
        let edges = mesh.edges();
        let changed = solution.changes.iter().rposition(|change| change.abs() > NEGLIGIBLE_CHANGE);
        let lowest = changed.map_or(0, |i| i + 1);
        let outer = outer_ring(&solution.slips).min(lowest);
        let old = self.clone();
        let (mut below, mut torque) = (before.below[lowest], old.torque_below(edges[lowest]));
        if lowest == solution.slips.len() && solution.core != 0.0 {
            below += solution.core;
            torque = self.slip_in_core(below, mesh);
        }
        self.truncate(edges[lowest]);
        let mut start = (below, torque);
        let mut ring = |next: &mut Self, i: usize| {
            let (from, to) = (edges[i + 1], edges[i]);
            let density = before.densities[i] + solution.changes[i];
            let demand = demand_of(density.abs(), mesh.sliding()[i], mesh.radius(), to);
            let laid = Density::Stick(density);
            next.push(Segment::new(from, laid, [below, torque], demand));
            below += density * (to - from);
            torque += old.torque_below(to) - old.torque_below(from)
                + solution.changes[i] * moment(to, from);
            (below, torque)
        };
        for i in (outer + 1..lowest).rev() {
            start = ring(self, i);
        }
        self.copy_densities(&old, edges[lowest.min(outer + 1)], start);
        let radius = mesh.radius();
        if outer == 0 {
            return self.follow(SlipPath::FromRim, radius, twist);
        }
        let (sign, edge) = (solution.slips[0], edges[outer]);
        let outside = sign * sliding_twist(edge, radius);
        if sign * (twist - outside - self.twist_below(edge)) > 0.0 || outer == lowest {
            self.cut(radius, twist, sign, edge);
        } else {
            self.truncate(edges[outer + 1]);
            let (_, torque) = ring(self, outer);
            let torque = torque + sign * sliding_torque(edge, radius);
            let density = Density::Slip { sign, radius };
            self.truncate(edge);
            self.push(Segment::new(edge, density, [twist, torque], radius));
            self.set_torque(torque, radius);
            self.stick = edge;
        }
        (self.radius, self.twist) = (radius, twist);
    }

    /// Copies the densities of another state from a radius outwards.
    fn copy_densities(&mut self, old: &Self, from: f64, (twist, torque): (f64, f64)) {
        let (lift, gain) = (twist - old.twist_below(from), torque - old.torque_below(from));
        let first = old.segments.partition_point(|segment| segment.from <= from);
        for (i, segment) in old.segments.iter().enumerate().skip(first.saturating_sub(1)) {
            let start = segment.from.max(from);
            let end = old.segments.get(i + 1).map_or(old.radius, |next| next.from);
            if start >= end {
                continue;
            }
            // A constant density is measured from where it begins, the sliding density from its
            // outer radius.
            let (twist, torque) = match segment.density() {
                Density::Stick(_) => (segment.twist_to(start), segment.torque_to(start)),
                Density::Slip { .. } => (segment.twist, segment.torque),
            };
            let (twist, torque) = (twist + lift, torque + gain);
            self.push(Segment { from: start, twist, torque, ..*segment });
        }
    }

    /// Inside the rings slip extends down to a stick radius that gives the required twist. Returns
    /// the torque of that part.
    fn slip_in_core(&mut self, twist: f64, mesh: &Mesh) -> f64 {
        let (radius, edge) = (mesh.radius(), mesh.edges()[mesh.edges().len() - 1]);
        let sign = 1.0_f64.copysign(twist - self.twist_below(edge));
        self.cut(radius, twist + sign * sliding_twist(edge, radius), sign, edge);
        self.torque_below(edge)
    }
}

/// The number of rings, from the edge inwards, that slip in the same direction.
fn outer_ring(slips: &[f64]) -> usize {
    if slips[0] == 0.0 {
        return 0;
    }
    slips.iter().position(|slip| *slip != slips[0]).unwrap_or(slips.len())
}

/// `int s^3 b ds` of a ring divided by the mean density, for densities that decrease as 1/s.
fn moment(outer: f64, inner: f64) -> f64 {
    let width = outer - inner;
    let cubes = width * (outer * outer + outer * inner + inner * inner) / 3.0;
    cubes * width / libm::log(outer / inner)
}

/// A contact radius at which the sliding density exceeds this density between the edges of a ring,
/// from its value at another radius.
fn demand_of(density: f64, sliding: f64, radius: f64, edge: f64) -> f64 {
    let over = density - sliding;
    if over <= 1e-9 * sliding {
        return radius;
    }
    // dbF/dal >= 1/(2 s), and bF >= (2/pi) al/s.
    (radius + 2.0 * edge * over).min(std::f64::consts::FRAC_PI_2 * density * edge)
}

/// Densities averaged over rings, and the twist of all discs inside their edges.
struct Cells {
    below: Vec<f64>,
    densities: Vec<f64>,
}

impl Cells {
    fn averaged(edges: &[f64], history: &TwistHistory) -> Self {
        let below: Vec<f64> = edges.iter().map(|&s| history.twist_up_to(s)).collect();
        let slope = |(s, t): (&[f64], &[f64])| (t[0] - t[1]) / (s[0] - s[1]);
        let densities = edges.windows(2).zip(below.windows(2)).map(slope).collect();
        Self { below, densities }
    }

    /// The twist inside all rings.
    fn core(&self) -> f64 {
        self.below[self.below.len() - 1]
    }

    /// Whether all tractions are within their limits, those of the sliding densities.
    fn are_within_friction(&self, mesh: &Mesh) -> bool {
        let both = || self.densities.iter().zip(mesh.sliding()).map(|(b, limit)| [*b, *limit]);
        let before = std::iter::once([0.0; 2]).chain(both());
        let jumps: Vec<[f64; 2]> =
            both().zip(before).map(|(b, out)| [b[0] - out[0], b[1] - out[1]]).collect();
        (0..mesh.len()).all(|i| {
            let [traction, limit] = mesh.tractions_of_jumps(i, &jumps);
            traction.abs() <= (1.0 + TRACTION_TOLERANCE) * limit
        })
    }

    /// Whether rings slip in no other direction than this, from densities before.
    fn slip_forward(&self, mesh: &Mesh, before: &Self, sign: f64) -> bool {
        let mut changes: Vec<f64> =
            self.densities.iter().zip(&before.densities).map(|(a, b)| a - b).collect();
        let changed = changes.iter().rposition(|change| *change != 0.0).map_or(0, |i| i + 1);
        changes.truncate(changed);
        let core = self.core() - before.core();
        let mut row = vec![0.0; changed];
        let slip = |i: usize| {
            let row = &mut row[i..];
            mesh.slips(i, row);
            sign * (core + dot(row, &changes[i..]))
        };
        let slips = (0..changed).map(slip).chain(std::iter::once(sign * core));
        let range = |(least, most): (f64, f64), slip: f64| (least.min(slip), most.max(slip.abs()));
        let (least, most) = slips.fold((f64::INFINITY, 0.0_f64), range);
        least >= -SLIP_TOLERANCE * most
    }
}
