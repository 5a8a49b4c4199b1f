//! The compliance of a plate under a wave of the pressure.

use std::str::FromStr;

use carom_special::WordError;

use super::shape::Constants;

/// Below this product of wave number and thickness the series of F is used.
const SERIES: f64 = 0.25;
/// Above it F is 1 to the last digit.
pub(super) const FAR: f64 = 20.0;
/// The shear factor of Mindlin's plate.
const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Which theory gives the normal displacement of the loaded face of a plate: the symbol C(k), the
/// displacement due to a wave of the pressure of wave number k and unit amplitude.
///
/// With D = E h^3/(12 (1 - nu^2)) and E* = E/(1 - nu^2):
///
/// | symbol | C(k) |
/// |---|---|
/// | layer | (2/(E* k)) F(k h), F(s) = (sinh s cosh s + s)/(sinh^2 s - s^2) |
/// | sum | 1/(D k^4) + 2/(E* k) |
/// | Kirchhoff | 1/(D k^4) |
/// | Mindlin | 1/(D k^4) + 1/((5/6) G h k^2) |
///
/// The layer is the elastic body itself: bending for long waves, then shear, and the half-space for
/// short ones. The sum lies at most 5.2 % below it (at k h = 1) and 7.6 % above (at k h = 3.2). Under Kirchhoff's plate a smooth
/// punch rests on a line and a flat one on its corners: force and approach converge with the cells,
/// pressures and the number of cells in contact do not. Mindlin's plate is there for comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum PlateSymbol {
    /// The elastic layer with a free lower face.
    #[default]
    Layer,
    /// Kirchhoff's plate and a half-space added.
    Sum,
    /// Kirchhoff's plate.
    Kirchhoff,
    /// Mindlin's plate with the shear factor 5/6.
    Mindlin,
}

impl PlateSymbol {
    /// All symbols, the default first.
    pub const ALL: [Self; 4] = [Self::Layer, Self::Sum, Self::Kirchhoff, Self::Mindlin];
    const NAMES: [&'static str; 4] = {
        let (mut names, mut i) = ([""; 4], 0);
        while i < names.len() {
            names[i] = Self::ALL[i].name();
            i += 1;
        }
        names
    };

    /// Its name in case files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Layer => "layer",
            Self::Sum => "sum",
            Self::Kirchhoff => "kirchhoff",
            Self::Mindlin => "mindlin",
        }
    }
}

/// ```
/// use carom_halfspace::operator::PlateSymbol;
/// assert_eq!("kirchhoff".parse(), Ok(PlateSymbol::Kirchhoff));
/// assert!("reissner".parse::<PlateSymbol>().is_err());
/// ```
impl FromStr for PlateSymbol {
    type Err = WordError;

    /// # Errors
    /// [`WordError`], which lists the allowed words.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let symbol = Self::ALL.into_iter().find(|symbol| symbol.name() == word);
        symbol.ok_or_else(|| WordError::new("theory", word, &Self::NAMES))
    }
}

/// C(k) of one plate under one punch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Symbol {
    kind: PlateSymbol,
    constants: Constants,
}

impl Symbol {
    pub(super) const fn new(kind: PlateSymbol, constants: Constants) -> Self {
        Self { kind, constants }
    }

    /// C(k) of a squared wave number.
    pub(super) fn at(&self, square: f64) -> f64 {
        let Constants { surface, punch, .. } = self.constants;
        let own = match self.kind {
            PlateSymbol::Layer => self.layer(square),
            PlateSymbol::Sum => self.bending(square) + surface / square.sqrt(),
            PlateSymbol::Kirchhoff => self.bending(square),
            PlateSymbol::Mindlin => self.bending(square) + self.shear(square),
        };
        if punch == 0.0 { own } else { own + punch / square.sqrt() }
    }

    /// The factor c if C(k) is c/k to the last digit at this squared wave number and above.
    pub(super) fn far(&self, square: f64) -> Option<f64> {
        let Constants { thickness, surface, punch, .. } = self.constants;
        let far = self.kind == PlateSymbol::Layer && square.sqrt() * thickness >= FAR;
        far.then_some(surface + punch)
    }

    /// 1/(D k^4).
    fn bending(&self, square: f64) -> f64 {
        let Constants { thickness, surface, .. } = self.constants;
        let s_square = square * thickness * thickness;
        6.0 * surface * thickness / (s_square * s_square)
    }

    fn shear(&self, square: f64) -> f64 {
        let Constants { thickness, shear_modulus, .. } = self.constants;
        1.0 / (SHEAR_FACTOR * shear_modulus * thickness * square)
    }

    fn layer(&self, square: f64) -> f64 {
        let Constants { thickness, surface, .. } = self.constants;
        let s = square.sqrt() * thickness;
        if s < SERIES {
            self.bending(square) * series(s * s)
        } else {
            surface * thickness / s * closed(s)
        }
    }
}

/// F(s) s^3/6 for small s, by powers of s^2.
fn series(square: f64) -> f64 {
    let terms = [
        1.0,
        1.0 / 5.0,
        16.0 / 525.0,
        -1.0 / 23_625.0,
        -89.0 / 3_031_875.0,
        2477.0 / 1_773_646_875.0,
    ];
    terms.iter().rev().fold(0.0, |sum, term| sum * square + term)
}

/// F(s) where nothing cancels.
fn closed(s: f64) -> f64 {
    if s >= FAR {
        return 1.0;
    }
    let t = libm::exp(-2.0 * s);
    let rest = 1.0 - t;
    (1.0 - t * t + 4.0 * s * t) / (rest * rest - 4.0 * s * s * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(thickness: f64) -> Symbol {
        let constants = Constants { thickness, surface: 2.0, punch: 0.0, shear_modulus: 0.35 };
        Symbol::new(PlateSymbol::Layer, constants)
    }

    /// F with twenty digits, from the closed form in arithmetic of many digits.
    #[test]
    fn factor_of_the_layer_has_its_reference_values() {
        let known = [
            (0.01, 6000120.0018285711746),
            (0.1, 6012.0182854585570118),
            (0.25, 388.84571014597086018),
            (0.5, 50.491391386696137345),
            (1.0, 7.3824353426180874655),
            (2.0, 1.7090626647249820767),
            (5.0, 1.0055645556014600071),
            (20.0, 1.0000000000000071457),
        ];
        for (s, factor) in known {
            // With h = 1 and 2/E* = 2, F = C k/2.
            let found = 0.5 * layer(1.0).at(s * s) * s;
            assert!((found / factor - 1.0).abs() < 2e-14, "{s}: {found} {factor}");
        }
    }

    #[test]
    fn series_and_closed_form_meet() {
        let (s, below) = (SERIES, 6.0 * series(SERIES * SERIES) / SERIES.powi(3));
        assert!((below / closed(s) - 1.0).abs() < 3e-14);
    }

    /// The loaded face of a thick layer is that of a half-space, of a thin one a plate in bending.
    #[test]
    fn limits_are_half_space_and_plate() {
        assert_eq!(layer(100.0).at(1.0), 2.0);
        let thin = Symbol::new(PlateSymbol::Kirchhoff, layer(1e-3).constants);
        assert!((layer(1e-3).at(1.0) / thin.at(1.0) - 1.0 - 2e-7).abs() < 1e-12);
        // D = E* h^3/12 with E* = 1.
        assert!((thin.at(1.0) / 12e9 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn sum_is_near_the_layer_at_every_wave_number() {
        let sum = Symbol::new(PlateSymbol::Sum, layer(1.0).constants);
        let off = |s: f64| sum.at(s * s) / layer(1.0).at(s * s) - 1.0;
        let all = || (1..400).map(|i| off(0.02 * f64::from(i)));
        let (least, most) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        assert!((least + 0.0519).abs() < 1e-4 && (most - 0.0758).abs() < 1e-4, "{least} {most}");
    }
}
