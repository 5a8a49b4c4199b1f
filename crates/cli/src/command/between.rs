//! A smooth curve through computed points.

/// Parts of a curve between two points.
const PARTS: usize = 12;

/// A curve through points in ascending order of x that neither overshoots nor bends where the points do not: cubic between
/// them, with the slopes of Steffen (Astron. Astrophys. 239, 1990).
pub(super) fn curve_through(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let parts: Vec<[f64; 2]> =
        points.windows(2).map(|pair| [pair[1].0 - pair[0].0, pair[1].1 - pair[0].1]).collect();
    if points.len() < 3 || parts.iter().any(|[width, _]| *width <= 0.0) {
        return points.to_vec();
    }
    let slopes = slopes(&parts);
    let mut curve = Vec::with_capacity(PARTS * parts.len() + 1);
    for (i, [width, rise]) in parts.iter().enumerate() {
        for part in 0..PARTS {
            let t = part as f64 / PARTS as f64;
            let (one, other) = (slopes[i] * width - rise, rise - slopes[i + 1] * width);
            let bend = t * (1.0 - t) * ((1.0 - t) * one + t * other);
            curve.push((points[i].0 + t * width, points[i].1 + t * rise + bend));
        }
    }
    curve.extend(points.last());
    curve
}

/// The slopes at the points, from the widths and rises between them.
fn slopes(parts: &[[f64; 2]]) -> Vec<f64> {
    let secant = |i: usize| parts[i][1] / parts[i][0];
    let end = |near: usize, next: usize| {
        let share = parts[near][0] / (parts[near][0] + parts[next][0]);
        let slope = secant(near) * (1.0 + share) - secant(next) * share;
        match slope * secant(near) > 0.0 {
            true => slope.clamp(-2.0 * secant(near).abs(), 2.0 * secant(near).abs()),
            false => 0.0,
        }
    };
    let last = parts.len() - 1;
    let inner = (1..parts.len()).map(|i| {
        let [before, after] = [i - 1, i].map(secant);
        let (h, next) = (parts[i - 1][0], parts[i][0]);
        let mean = (before * next + after * h) / (h + next);
        let least = before.abs().min(after.abs()).min(0.5 * mean.abs());
        if before * after > 0.0 { 2.0 * least.copysign(before) } else { 0.0 }
    });
    std::iter::once(end(0, 1)).chain(inner).chain([end(last, last - 1)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_met_between_its_points_and_at_them() {
        let points: Vec<(f64, f64)> =
            (0..8).map(|i| 1.0 + f64::from(i * i)).map(|x| (x, x * x)).collect();
        let curve = curve_through(&points);
        assert_eq!(curve.len(), 7 * PARTS + 1);
        assert!(points.iter().all(|point| curve.contains(point)));
        // Inside, the slope of a parabola is that of Steffen; the ends are of second order as well.
        let off = |(x, y): &(f64, f64)| (y - x * x).abs() / (x * x);
        assert!(curve.iter().map(off).fold(0.0, f64::max) < 1e-12);
    }

    /// Creep forces rise and stay at the limit.
    #[test]
    fn a_curve_goes_no_further_than_its_points() {
        let points =
            [(0.0, 0.0), (1.0, 0.6), (1.5, 0.98), (2.0, 1.0), (4.0, 1.0), (5.0, 0.7), (6.0, 0.9)];
        let curve = curve_through(&points);
        for (x, y) in curve {
            let at = points.iter().rposition(|point| point.0 <= x).unwrap().min(5);
            let [low, high] =
                [points[at].1.min(points[at + 1].1), points[at].1.max(points[at + 1].1)];
            assert!((low..=high).contains(&y), "{x} {y}");
        }
    }

    #[test]
    fn two_points_and_points_above_each_other_are_joined_by_lines() {
        for points in [&[(0.0, 1.0), (1.0, 2.0)][..], &[(0.0, 1.0), (0.0, 2.0), (1.0, 3.0)], &[]] {
            assert_eq!(curve_through(points), points);
        }
    }
}
