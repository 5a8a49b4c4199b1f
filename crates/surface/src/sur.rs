//! Surfaces of Digital Surf, `.sur`: a head of 512 bytes and whole numbers, plain or compressed.

use crate::bytes::{Bytes, Number, metres};
use crate::error::SurfaceError;
use crate::format::{Format, Measured, Reading};
use crate::topography::Topography;
use std::io::Read as _;

const NAME: &str = "sur";
/// Length of the head.
const HEAD: usize = 512;
/// The word at the begin of a compressed file.
const COMPRESSED: &[u8] = b"DSCOMPRESSED";
/// Kinds of contents that begin with a surface: a surface, with colours, with intensity, with both.
const SURFACES: &[i16] = &[2, 11, 13, 16];
/// The kind that other programs write for a surface, though it means a profile.
const PROFILE: i16 = 1;

pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Measured, SurfaceError> {
    let short = || SurfaceError::damaged(NAME, "it ends within its head");
    let head = Head::of(Bytes(bytes)).ok_or_else(short)?;
    head.check()?;
    let points = reading.check(head.columns as usize, head.rows as usize)?;
    let number = if head.bits == 16 { Number::I16 } else { Number::I32 };
    let begin = HEAD + usize::from(head.comment) + usize::from(head.private);
    let rest = bytes.get(begin..).ok_or_else(short)?;
    let length = points * number.size();
    let block = match bytes.starts_with(COMPRESSED) {
        true => inflated(rest, length)?,
        false => rest.get(..length).map(<[u8]>::to_vec).ok_or_else(|| {
            let reason = format!("it ends within its heights, of which there are {points}");
            SurfaceError::damaged(NAME, reason)
        })?,
    };
    head.measured(number.block(&block, false))
}

/// What matters in the head of a file.
struct Head {
    order: i16,
    objects: i16,
    kind: i16,
    is_flagged: bool,
    bits: i16,
    least: i32,
    columns: i32,
    rows: i32,
    steps: [f32; 3],
    units: [String; 3],
    inverted: i16,
    comment: u16,
    private: u16,
    offset: f32,
}

impl Head {
    /// The head; none if the file is shorter.
    fn of(bytes: Bytes<'_>) -> Option<Self> {
        bytes.0.get(..HEAD)?;
        Some(Self {
            order: bytes.i16(12)?,
            objects: bytes.i16(14)?,
            kind: bytes.i16(18)?,
            is_flagged: bytes.i16(86)? == 1,
            bits: bytes.i16(98)?,
            least: bytes.i32(100)?,
            columns: bytes.i32(108)?,
            rows: bytes.i32(112)?,
            steps: [bytes.f32(120)?, bytes.f32(124)?, bytes.f32(128)?],
            units: [bytes.text(180, 16)?, bytes.text(196, 16)?, bytes.text(212, 16)?],
            inverted: bytes.i16(290)?,
            comment: bytes.u16(334)?,
            private: bytes.u16(336)?,
            offset: bytes.f32(474)?,
        })
    }

    fn check(&self) -> Result<(), SurfaceError> {
        let damaged = |reason: String| Err(SurfaceError::damaged(NAME, reason));
        let unfit = |reason: String| Err(SurfaceError::unsupported(NAME, reason));
        match self {
            Self { order, .. } if *order != 0 => {
                unfit(format!("has byte order {order}: must be 0, that of PCs"))
            }
            Self { kind, rows, .. }
                if !(SURFACES.contains(kind) || *kind == PROFILE && *rows > 1) =>
            {
                unfit(format!("holds content of kind {kind}: must be a surface (2)"))
            }
            Self { kind: 2, objects, .. } if *objects > 1 => unfit(format!(
                "holds {objects} surfaces: must hold one; save the layer of the heights alone"
            )),
            Self { bits, .. } if ![16, 32].contains(bits) => {
                damaged(format!("it has {bits} bits per point: must be 16 or 32"))
            }
            Self { columns, rows, .. } if *columns <= 0 || *rows <= 0 => {
                damaged(format!("it has {columns} x {rows} points"))
            }
            Self { steps, .. } if !steps.iter().all(|step| step.is_finite() && *step > 0.0) => {
                damaged(format!("its steps are {steps:?}: must be finite and > 0"))
            }
            _ => Ok(()),
        }
    }

    /// The heights of whole numbers.
    fn measured(&self, mut heights: Vec<f64>) -> Result<Measured, SurfaceError> {
        let [x, y, z] =
            [0, 1, 2].map(|i| metres(&self.units[i]).map(|unit| f64::from(self.steps[i]) * unit));
        let (Some(x), Some(y), Some(z)) = (x, y, z) else {
            let reason = format!("has units {:?}: must be lengths, such as mm and um", self.units);
            return Err(SurfaceError::unsupported(NAME, reason));
        };
        // Both readers in wide use negate such heights; the offset is in the unit of the heights.
        let sign = if self.inverted > 0 { -1.0 } else { 1.0 };
        let offset = if self.offset.is_finite() {
            f64::from(self.offset) * z / f64::from(self.steps[2])
        } else {
            0.0
        };
        let missing = f64::from(self.least) - 2.0;
        for height in &mut heights {
            let is_missing = self.is_flagged && *height == missing;
            *height = if is_missing { f64::NAN } else { sign * (*height * z + offset) };
        }
        let columns = self.columns as usize;
        match self.inverted {
            2 => heights.chunks_exact_mut(columns).for_each(<[f64]>::reverse),
            3 => heights = heights.chunks_exact(columns).rev().flatten().copied().collect(),
            _ => {}
        }
        let mut notes = Vec::new();
        if self.inverted > 0 {
            notes.push(
                "the file says that its heights are inverted; they were turned back".to_owned(),
            );
        }
        Ok(Measured {
            topography: Topography::new(columns, heights)?.spaced(Some([x, y])),
            format: Format::Sur,
            has_unit: true,
            notes,
        })
    }
}

/// The streams of a compressed file: their number, raw and packed length of each, then the streams.
fn inflated(bytes: &[u8], length: usize) -> Result<Vec<u8>, SurfaceError> {
    let broken = || SurfaceError::damaged(NAME, "its compressed heights are not whole");
    let word = |place| Bytes(bytes).u32(place).ok_or_else(broken);
    let count = word(0)? as usize;
    let mut begin =
        count.checked_mul(8).and_then(|heads| heads.checked_add(4)).ok_or_else(broken)?;
    let mut all = Vec::new();
    for stream in 0..count {
        let end = begin.checked_add(word(8 + 8 * stream)? as usize).ok_or_else(broken)?;
        let packed = bytes.get(begin..end).ok_or_else(broken)?;
        let room = (length + 1).saturating_sub(all.len()) as u64;
        flate2::read::ZlibDecoder::new(packed)
            .take(room)
            .read_to_end(&mut all)
            .map_err(|_| broken())?;
        begin = end;
    }
    if all.len() == length { Ok(all) } else { Err(broken()) }
}
