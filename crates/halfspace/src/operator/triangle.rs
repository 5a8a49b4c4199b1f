//! Symmetric matrices of which one triangle is stored.

/// The side of a tile: its rows are lines of the cache.
const TILE: usize = 16;

/// A symmetric matrix, stored as the square tiles on and below its diagonal, each by columns.
#[derive(Debug, Clone)]
pub(crate) struct Triangle<T> {
    side: usize,
    tiles: Vec<T>,
}

impl<T: Copy + Default> Triangle<T> {
    /// From the columns of all values, of which those above the diagonal do not count.
    pub(crate) fn of(side: usize, columns: &[T]) -> Self {
        let count = side.div_ceil(TILE);
        let mut triangle = Self { side, tiles: vec![T::default(); tile(0, count) * TILE * TILE] };
        for (column, values) in columns.chunks_exact(side).enumerate() {
            for (row, value) in values.iter().enumerate().skip(column) {
                let at = place(column, row);
                triangle.tiles[at] = *value;
                // Tiles on the diagonal hold both triangles.
                if column / TILE == row / TILE {
                    triangle.tiles[place(row, column)] = *value;
                }
            }
        }
        triangle
    }

    pub(crate) const fn side(&self) -> usize {
        self.side
    }

    pub(crate) fn at(&self, column: usize, row: usize) -> T {
        let [column, row] = [column.min(row), column.max(row)];
        self.tiles[place(column, row)]
    }

    /// Writes one column, which is also a row.
    pub(crate) fn column(&self, column: usize, values: &mut [T]) {
        let (own, within) = (column / TILE, column % TILE);
        for (other, values) in values[..self.side].chunks_mut(TILE).enumerate() {
            if other < own {
                let tile = &self.tiles[tile(other, own) * TILE * TILE..][..TILE * TILE];
                for (value, row) in values.iter_mut().zip(tile.chunks_exact(TILE)) {
                    *value = row[within];
                }
            } else {
                let start = (tile(own, other) * TILE + within) * TILE;
                values.copy_from_slice(&self.tiles[start..][..values.len()]);
            }
        }
    }

    /// The stored values, some of them twice, and zeros.
    pub(crate) fn stored(&self) -> &[T] {
        &self.tiles
    }

    /// The same of each value.
    pub(crate) fn map<U>(&self, change: impl Fn(T) -> U) -> Triangle<U> {
        Triangle { side: self.side, tiles: self.tiles.iter().copied().map(change).collect() }
    }
}

/// The number of the tile in this column and row of tiles, not above the diagonal.
const fn tile(column: usize, row: usize) -> usize {
    row * (row + 1) / 2 + column
}

/// The place of a value whose tile is not above the diagonal.
const fn place(column: usize, row: usize) -> usize {
    (tile(column / TILE, row / TILE) * TILE + column % TILE) * TILE + row % TILE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_those_of_the_matrix() {
        for side in [1, 5, 16, 17, 33, 50] {
            let value = |one: usize, other: usize| (one * other + 7 * (one + other)) as f64;
            let all: Vec<f64> = (0..side * side).map(|at| value(at / side, at % side)).collect();
            let triangle = Triangle::of(side, &all);
            let mut column = vec![f64::NAN; side + 3];
            for (number, values) in all.chunks_exact(side).enumerate() {
                triangle.column(number, &mut column);
                assert_eq!(&column[..side], values);
                assert!((0..side).all(|row| triangle.at(number, row) == values[row]));
            }
            assert!(triangle.stored().len() <= (side + 2 * TILE) * (side + TILE) / 2);
        }
    }
}
