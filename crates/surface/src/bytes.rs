//! Numbers at fixed places of binary files, little-endian.

/// Bytes that are read from their begin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bytes<'a>(pub(crate) &'a [u8]);

macro_rules! numbers {
    ($($name:ident: $kind:ty,)*) => {
        $(pub(crate) fn $name(self, place: usize) -> Option<$kind> {
            let bytes = self.0.get(place..place + size_of::<$kind>())?;
            Some(<$kind>::from_le_bytes(bytes.try_into().ok()?))
        })*
    };
}

impl Bytes<'_> {
    numbers! { u16: u16, i16: i16, u32: u32, i32: i32, f32: f32, f64: f64, }

    /// A text of at most `length` letters, without blanks and zeros around it, in Latin letters.
    pub(crate) fn text(self, place: usize, length: usize) -> Option<String> {
        let bytes = self.0.get(place..place + length)?;
        let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(length);
        Some(latin(&bytes[..end]).trim().to_owned())
    }
}

/// A text in UTF-8, or else in ISO 8859-1.
pub(crate) fn latin(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
    }
}

/// Kinds of numbers of a block of heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Number {
    U8,
    U16,
    U32,
    U64,
    I8,
    I16,
    I32,
    I64,
    F32,
    F64,
}

impl Number {
    /// Number of bytes.
    pub(crate) const fn size(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }

    /// The numbers of a block, little-endian, or big-endian if `is_big`.
    pub(crate) fn block(self, bytes: &[u8], is_big: bool) -> Vec<f64> {
        macro_rules! read {
            ($kind:ty) => {{
                let one = |chunk: &[u8]| {
                    let mut own = [0; size_of::<$kind>()];
                    own.copy_from_slice(chunk);
                    if is_big {
                        <$kind>::from_be_bytes(own) as f64
                    } else {
                        <$kind>::from_le_bytes(own) as f64
                    }
                };
                bytes.chunks_exact(size_of::<$kind>()).map(one).collect()
            }};
        }
        match self {
            Self::U8 => read!(u8),
            Self::U16 => read!(u16),
            Self::U32 => read!(u32),
            Self::U64 => read!(u64),
            Self::I8 => read!(i8),
            Self::I16 => read!(i16),
            Self::I32 => read!(i32),
            Self::I64 => read!(i64),
            Self::F32 => read!(f32),
            Self::F64 => read!(f64),
        }
    }
}

/// Metres of a unit of length as instruments write it; none for another word.
pub(crate) fn metres(unit: &str) -> Option<f64> {
    let unit = unit.trim().trim_matches(|c| "()[]".contains(c)).trim();
    // 0xE6 is the micro sign of an old code page of MS-DOS.
    let micro = |c| if matches!(c, '\u{b5}' | '\u{3bc}' | '\u{e6}') { 'u' } else { c };
    let word: String = unit.chars().map(micro).collect();
    Some(match word.to_ascii_lowercase().as_str() {
        "m" | "meter" | "metre" | "meters" | "metres" => 1.0,
        "km" => 1e3,
        "cm" => 1e-2,
        "mm" | "millimeter" | "millimetre" => 1e-3,
        "um" | "micron" | "microns" | "micrometer" | "micrometre" => 1e-6,
        "nm" | "nanometer" | "nanometre" => 1e-9,
        "a" | "\u{c5}" | "\u{e5}" | "angstrom" => 1e-10,
        "pm" => 1e-12,
        _ => return None,
    })
}
