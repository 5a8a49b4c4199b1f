//! The table as bytes: little-endian, coefficients as integers in units of the largest of their
//! leaf, which costs less than 1e-9.

use super::atlas::{Atlas, Curve};
use super::{Leaf, Node, ORDER, RestitutionTable};

/// Made by `cargo run --release -p carom-impact --example restitution_table`.
static STORED: &[u8] = include_bytes!("stored.bin");

/// Coefficients of a leaf beside the constant one.
const REST: usize = ORDER * ORDER - 1;

impl RestitutionTable {
    /// The stored table.
    pub(super) fn stored() -> Option<Self> {
        Self::from_bytes(STORED)
    }

    /// The table as bytes.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let Atlas { stick: Curve(stick), slide: Curve(slide), far } = &self.atlas;
        for value in stick.iter().chain(slide).chain([far]) {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend((self.nodes.len() as u32).to_le_bytes());
        bytes.extend((self.leaves.len() as u32).to_le_bytes());
        for node in &self.nodes {
            bytes.extend(node.to_word().to_le_bytes());
        }
        for Leaf(rows) in &self.leaves {
            let constant = rows[0][0];
            let rest = || rows.iter().flatten().skip(1);
            let largest = rest().fold(f64::MIN_POSITIVE, |largest, c| largest.max(c.abs()));
            let unit = largest / f64::from(i32::MAX);
            bytes.extend(constant.to_le_bytes());
            bytes.extend(unit.to_le_bytes());
            for coefficient in rest() {
                bytes.extend(((coefficient / unit).round() as i32).to_le_bytes());
            }
        }
        bytes
    }

    fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut reader = Reader(bytes);
        let mut curve = || -> Option<Curve> {
            let mut coefficients = [0.0; ORDER];
            for coefficient in &mut coefficients {
                *coefficient = reader.number()?;
            }
            Some(Curve(coefficients))
        };
        let (stick, slide) = (curve()?, curve()?);
        let atlas = Atlas { stick, slide, far: reader.number()? };
        let [nodes, leaves] = [reader.word()?, reader.word()?];
        let nodes: Option<Vec<_>> = (0..nodes).map(|_| reader.word().map(Node::of_word)).collect();
        let leaves: Option<Vec<_>> = (0..leaves).map(|_| reader.leaf()).collect();
        Some(Self { atlas, nodes: nodes?, leaves: leaves? })
    }
}

impl Node {
    fn to_word(self) -> u32 {
        match self {
            Self::Exact => 0,
            Self::Leaf(index) => 4 * index + 1,
            Self::AcrossChi(first) => 4 * first + 2,
            Self::AcrossPsi(first) => 4 * first + 3,
        }
    }

    fn of_word(word: u32) -> Self {
        match (word % 4, word / 4) {
            (1, index) => Self::Leaf(index),
            (2, first) => Self::AcrossChi(first),
            (3, first) => Self::AcrossPsi(first),
            _ => Self::Exact,
        }
    }
}

struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    fn number(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    fn word(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn leaf(&mut self) -> Option<Leaf> {
        let mut rows = [[0.0; ORDER]; ORDER];
        rows[0][0] = self.number()?;
        let unit = self.number()?;
        for i in 1..=REST {
            let value = self.take().map(i32::from_le_bytes)?;
            rows[i / ORDER][i % ORDER] = unit * f64::from(value);
        }
        Some(Leaf(rows))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stored_table_is_whole_and_its_curves_are_those_of_the_impact() {
        let table = RestitutionTable::stored().unwrap();
        assert!(STORED.len() < 300_000);
        assert_eq!(table.to_bytes(), STORED);
        let atlas = Atlas::new();
        assert_eq!((atlas.stick.0, atlas.slide.0), (table.atlas.stick.0, table.atlas.slide.0));
        for node in &table.nodes {
            let (Node::Leaf(index) | Node::AcrossChi(index) | Node::AcrossPsi(index)) = *node
            else {
                continue;
            };
            let leaf = matches!(node, Node::Leaf(_));
            assert!(
                (index as usize) < if leaf { table.leaves.len() } else { table.nodes.len() - 1 }
            );
        }
    }

    #[test]
    #[ignore = "builds the table: ten seconds"]
    fn the_stored_table_is_what_is_built() {
        assert_eq!(RestitutionTable::build().to_bytes(), STORED);
    }
}
