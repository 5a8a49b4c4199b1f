//! The legend: inside the axes where there is space, otherwise beside them.

use crate::draw;
use crate::panel::Panel;
use crate::series::Style;
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::{Type, text_width};

const LINE: f64 = 18.0;
const SAMPLE: f64 = 26.0;
const PAD: f64 = 8.0;

/// A line of a legend.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry<'a> {
    label: &'a str,
    style: Style,
    size: f64,
    colour: &'static str,
}

/// The series of a panel that carry a label, with their colours.
#[derive(Debug, Default)]
pub(crate) struct Legend<'a> {
    entries: Vec<Entry<'a>>,
}

impl<'a> Legend<'a> {
    /// The legend of `panel`, whose series are drawn in `styles`; a label that occurs again with the
    /// same style is shown once.
    pub(crate) fn of(panel: &'a Panel, styles: &[Style]) -> Self {
        let mut entries: Vec<Entry<'_>> = Vec::new();
        for (index, (series, style)) in panel.series.iter().zip(styles).enumerate() {
            let colour = draw::colour(series, index);
            let entry = Entry { label: &series.label, style: *style, size: series.size, colour };
            let is_note = *style == Style::Note;
            if !entry.label.is_empty() && !is_note && !entries.contains(&entry) {
                entries.push(entry);
            }
        }
        Self { entries }
    }

    /// Leaves out what another legend has.
    pub(crate) fn leave_out(&mut self, other: &Legend<'_>) {
        self.entries.retain(|entry| !other.entries.contains(entry));
    }

    /// The labels.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|entry| entry.label)
    }

    /// Width of the legend in pixels; `None` if it is empty.
    pub(crate) fn width(&self) -> Option<f64> {
        let widths = self.labels().map(|label| text_width(label, Type::LEGEND.size));
        widths.reduce(f64::max).map(|text| text + SAMPLE + 3.0 * PAD)
    }

    fn height(&self) -> f64 {
        self.entries.len() as f64 * LINE + PAD
    }

    /// The first corner of `frame` that contains none of `pixels`.
    pub(crate) fn free_corner(&self, frame: Frame, pixels: &[Pixel]) -> Option<Frame> {
        let (width, height) = (self.width()?, self.height());
        if width > 0.6 * frame.width || height > 0.6 * frame.height {
            return None;
        }
        let (left, top) = (frame.x + PAD, frame.y + PAD);
        let right = frame.x + frame.width - width - PAD;
        let bottom = frame.y + frame.height - height - PAD;
        [(right, top), (left, top), (right, bottom), (left, bottom)]
            .map(|(x, y)| Frame { x, y, width, height })
            .into_iter()
            .find(|corner| {
                let clear = corner.grown(0.5 * PAD);
                !pixels.iter().any(|pixel| clear.holds(*pixel))
            })
    }

    /// Draws it with its upper left corner at that of `frame`.
    pub(crate) fn draw(&self, svg: &mut Svg, frame: Frame) {
        svg.rect(frame, "fill=\"#fff\" fill-opacity=\"0.85\" stroke=\"#ccc\"");
        for (i, Entry { label, style, size, colour }) in self.entries.iter().enumerate() {
            let y = frame.y + 0.5 * PAD + i as f64 * LINE;
            let x = frame.x + PAD;
            draw::sample(svg, *style, *size, colour, Frame { x, y, width: SAMPLE, height: LINE });
            let at = Pixel { x: x + SAMPLE + PAD, y: y + 0.5 * LINE + 4.5 };
            svg.text(at, Anchor::Start, label, Type::LEGEND);
        }
    }

    /// Its frame beside the axes.
    pub(crate) fn beside(&self, frame: Frame) -> Option<Frame> {
        let width = self.width()?;
        Some(Frame { x: frame.x + frame.width + 12.0, y: frame.y, width, height: self.height() })
    }
}
