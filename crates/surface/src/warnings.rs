//! What is wrong with a height map, in sentences, for a command and for a contact.

use crate::measures::Measures;

/// Rise over root-mean-square height from which a map is told to be tilted.
const TILTED: f64 = 5.0;
/// Rise over root-mean-square height from which the map is a plane but for round-off.
const PLANE: f64 = 1e10;
/// Slope above which bodies are no half-spaces.
const STEEP: f64 = 0.3;
/// Slope that no surface has: the heights are in another unit.
const UNIT: f64 = 5.0;
/// Step over the border, over that of neighbours, from which a map is told not to repeat itself.
const STEP: f64 = 4.0;

impl Measures {
    /// What should be mended before the map is used for a contact, a sentence each; `is_periodic` if it repeats itself.
    #[must_use]
    pub fn warnings(&self, is_periodic: bool) -> Vec<String> {
        let border = if is_periodic { self.border() } else { None };
        [self.hole(), self.spike_told(), self.tilt(), self.steep(), border]
            .into_iter()
            .flatten()
            .collect()
    }

    fn hole(&self) -> Option<String> {
        let [row, column] = self.first_missing?;
        let (count, share) = (self.missing, 100.0 * self.missing_share());
        let are = if count == 1 { "point is" } else { "points are" };
        Some(format!(
            "{count} {are} missing ({share:.2} %), the first in row {row}, column {column}: `missing` = \"fill\" \
             takes the heights around them, \"no contact\" leaves holes"
        ))
    }

    fn spike_told(&self) -> Option<String> {
        let spike = self.spike?;
        let (row, column, height, around) = (spike.row, spike.column, spike.height, spike.around);
        let others = match self.spikes {
            1 => String::new(),
            count => format!(", the farthest of {count} such points"),
        };
        Some(format!(
            "the height in row {row}, column {column} is {height:.4e} m, but {around:.4e} m around it{others}: a point \
             that was not measured? It is missing if the file has nan there"
        ))
    }

    fn tilt(&self) -> Option<String> {
        let times = self.tilt_over_rms();
        (self.spikes == 0 && times > TILTED).then(|| {
            let [x, y] = self.rise;
            let rest = match times < PLANE {
                true => format!("{times:.0} times the rms height without it"),
                false => "and nothing is left without it".to_owned(),
            };
            format!(
                "the map is tilted: its plane rises by {x:.3e} m along x and {y:.3e} m along y, {rest}: `level` = \
                 \"plane\" subtracts it"
            )
        })
    }

    fn steep(&self) -> Option<String> {
        let slope = self.rms_slope.filter(|slope| *slope > STEEP && self.spikes == 0)?;
        let told = match slope > UNIT {
            true => format!(
                "the rms slope is {slope:.3}, which no surface has: are the heights in another unit than m? In um it \
                 would be {:.3e}",
                1e-6 * slope
            ),
            false => format!(
                "the rms slope is {slope:.3}: the theory of half-spaces holds for slopes well below 1, at most {STEEP}"
            ),
        };
        Some(told)
    }

    fn border(&self) -> Option<String> {
        let [x, y] = self.border_step;
        let (axis, step) = if x >= y { ("x", x) } else { ("y", y) };
        (step > STEP).then(|| {
            format!(
                "the map does not repeat itself: along {axis} the step over the border is {step:.1} times that of \
                 neighbours; `level` = \"plane\" helps a tilted map, otherwise leave `periodic` away"
            )
        })
    }
}
