//! Contour lines of a field.

use crate::field::Field;
use std::collections::HashMap;

/// A line through points in the coordinates of the field.
pub(crate) type Line = Vec<(f64, f64)>;

/// An edge of the triangles, by the numbers of its ends, the smaller one first.
type Edge = (usize, usize);

/// A corner of a triangle: its number, position and value.
#[derive(Clone, Copy)]
struct Corner {
    number: usize,
    x: f64,
    y: f64,
    value: f64,
}

/// The contour lines at `level`: straight across the triangles of each cell, whose centre has the
/// mean value of the corners.
pub(crate) fn contours(field: &Field, level: f64) -> Vec<Line> {
    let mut pieces = Pieces::default();
    let columns = field.x().len();
    for row in 0..field.y().len() - 1 {
        for column in 0..columns - 1 {
            let node = |i: usize, j: usize| Corner {
                number: (row + j) * columns + column + i,
                x: field.x()[column + i],
                y: field.y()[row + j],
                value: field.at(column + i, row + j),
            };
            let corners = [node(0, 0), node(1, 0), node(1, 1), node(0, 1)];
            let above = corners.iter().filter(|corner| corner.value >= level).count();
            if above == 0 || above == 4 {
                continue;
            }
            let mean = |of: fn(&Corner) -> f64| corners.iter().map(of).sum::<f64>() / 4.0;
            let middle = Corner {
                number: field.y().len() * columns + corners[0].number,
                x: mean(|corner| corner.x),
                y: mean(|corner| corner.y),
                value: mean(|corner| corner.value),
            };
            for i in 0..4 {
                pieces.cross([corners[i], corners[(i + 1) % 4], middle], level);
            }
        }
    }
    pieces.joined()
}

/// The point where the level crosses an edge, and its segments: two, or one at the border.
#[derive(Clone, Copy)]
struct Crossing {
    at: (f64, f64),
    pieces: [Option<usize>; 2],
}

/// Segments across triangles, each from one of their edges to another.
#[derive(Default)]
struct Pieces {
    pieces: Vec<[Edge; 2]>,
    crossings: HashMap<Edge, Crossing>,
}

impl Pieces {
    /// Adds the segment across a triangle, if the level crosses it.
    fn cross(&mut self, corners: [Corner; 3], level: f64) {
        let mut ends = [0, 1, 2].into_iter().filter_map(|i| {
            let (one, two) = (corners[i], corners[(i + 1) % 3]);
            if (one.value >= level) == (two.value >= level) {
                return None;
            }
            let part = (level - one.value) / (two.value - one.value);
            let at = (one.x + part * (two.x - one.x), one.y + part * (two.y - one.y));
            Some(((one.number.min(two.number), one.number.max(two.number)), at))
        });
        let (Some(from), Some(to)) = (ends.next(), ends.next()) else {
            return;
        };
        let number = self.pieces.len();
        self.pieces.push([from.0, to.0]);
        for (edge, at) in [from, to] {
            let crossing = self.crossings.entry(edge).or_insert(Crossing { at, pieces: [None; 2] });
            match &mut crossing.pieces {
                [first @ None, _] | [Some(_), first] => *first = Some(number),
            }
        }
    }

    /// The segments joined to lines where they share an edge.
    fn joined(&self) -> Vec<Line> {
        let mut is_used = vec![false; self.pieces.len()];
        let mut lines = Vec::new();
        for first in 0..self.pieces.len() {
            if is_used[first] {
                continue;
            }
            let [from, to] = self.pieces[first];
            let mut line = self.walk(first, from, &mut is_used);
            line.reverse();
            line.extend(self.walk(first, to, &mut is_used));
            lines.push(line);
        }
        lines
    }

    /// The crossings from `edge` of a segment onwards.
    fn walk(&self, piece: usize, edge: Edge, is_used: &mut [bool]) -> Line {
        is_used[piece] = true;
        let mut line = Line::new();
        let mut edge = edge;
        loop {
            let Crossing { at, pieces } = self.crossings[&edge];
            line.push(at);
            let next = pieces.into_iter().flatten().find(|next| !is_used[*next]);
            let Some(next) = next else {
                return line;
            };
            is_used[next] = true;
            let [from, to] = self.pieces[next];
            edge = if from == edge { to } else { from };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone(n: usize) -> Field {
        let nodes = carom_special::linspace(-1.0, 1.0, n);
        let values =
            nodes.iter().flat_map(|y| nodes.iter().map(move |x| libm::hypot(*x, *y))).collect();
        Field::new("r", nodes.clone(), nodes, values).unwrap()
    }

    #[test]
    fn contours_of_a_cone_are_closed_circles() {
        let lines = contours(&cone(81), 0.6);
        let [line] = lines.as_slice() else { panic!("{} lines", lines.len()) };
        let mut length = 0.0;
        for pair in line.windows(2) {
            let [(x_1, y_1), (x_2, y_2)] = [pair[0], pair[1]];
            assert!((libm::hypot(x_1, y_1) - 0.6).abs() < 2e-4);
            length += libm::hypot(x_2 - x_1, y_2 - y_1);
        }
        assert!((length / (1.2 * std::f64::consts::PI) - 1.0).abs() < 2e-3, "{length}");
        assert_eq!(line.first(), line.last());
        assert!(contours(&cone(9), 2.0).is_empty() && contours(&cone(9), -1.0).is_empty());
    }

    #[test]
    fn lines_that_leave_the_field_are_open() {
        let lines = contours(&cone(81), 1.2);
        assert_eq!(lines.len(), 4, "one a corner");
        for line in lines {
            for (x, y) in [line[0], line[line.len() - 1]] {
                assert!(x.abs() == 1.0 || y.abs() == 1.0, "{x} {y}");
            }
        }
    }
}
