//! Layout: panels side by side on one picture, or each on its own.

use crate::error::PlotError;
use crate::panel::Panel;
use crate::pdf::pdf_of;
use crate::plot::{Outside, Plot, share_legends};
use crate::raster::png_of;
use crate::svg::{Anchor, Pixel, Svg};
use crate::text::Type;

const HEADING: f64 = 30.0;
/// Space left and right of a panel that it does not need if it stands alone.
const SPARE: [f64; 2] = [8.0, 4.0];

/// Draws the panels as one SVG document, under `title` if it is not empty.
///
/// # Errors
/// [`PlotError`] if there is nothing to draw, a point is not finite, a value on a logarithmic axis
/// is not positive, or limits are not increasing.
pub fn render(title: &str, panels: &[Panel]) -> Result<String, PlotError> {
    laid_out(Svg::default(), title, panels)
}

/// Draws each panel as an SVG of its own, so that a page can put them below each other on a narrow
/// screen; a legend without space between the axes stands below them. Names of clip paths are made from `name`: two pictures on a page need different ones.
///
/// ```
/// use carom_plot::{Panel, Series, render_each};
///
/// let mut panel = Panel::new("x", "y");
/// panel.add(Series::line("rising", [(0.0, 0.0), (1.0, 1.0)]));
/// assert_eq!(render_each("two", &[panel.clone(), panel])?.len(), 2);
/// # Ok::<(), carom_plot::PlotError>(())
/// ```
///
/// # Errors
/// As [`render`].
pub fn render_each(name: &str, panels: &[Panel]) -> Result<Vec<String>, PlotError> {
    let plots = plots(panels)?.into_iter().map(|plot| plot.with_legend(Outside::Below));
    let one = |(i, plot): (usize, Plot<'_>)| {
        let mut svg = Svg::default();
        plot.draw(&mut svg, Pixel { x: -SPARE[0], y: 0.0 }, &clip_name(name, i))?;
        let width = plot.width() - SPARE[0] - SPARE[1];
        Ok(svg.finish(width, plot.height(), &plot.spoken()))
    };
    plots.enumerate().map(one).collect()
}

/// The same as PNG, two pixels for each unit of the SVG; texts are in DejaVu Sans, which comes with
/// this crate.
///
/// # Errors
/// As [`render`], and [`PlotError::Raster`] if the picture is too large for memory.
pub fn render_png(title: &str, panels: &[Panel]) -> Result<Vec<u8>, PlotError> {
    png_of(&laid_out(Svg::with_outlines()?, title, panels)?)
}

/// The same as PDF on one page as large as the picture, a point for each unit of the SVG; texts are outlines
/// of DejaVu Sans.
///
/// ```
/// use carom_plot::{Panel, Series, render_pdf};
///
/// let mut panel = Panel::new("x", "y");
/// panel.add(Series::line("rising", [(0.0, 0.0), (1.0, 1.0)]));
/// assert!(render_pdf("", &[panel])?.starts_with(b"%PDF"));
/// # Ok::<(), carom_plot::PlotError>(())
/// ```
///
/// # Errors
/// As [`render_png`].
pub fn render_pdf(title: &str, panels: &[Panel]) -> Result<Vec<u8>, PlotError> {
    pdf_of(&laid_out(Svg::with_outlines()?, title, panels)?, title)
}

fn plots(panels: &[Panel]) -> Result<Vec<Plot<'_>>, PlotError> {
    let mut plots = panels.iter().map(Plot::new).collect::<Result<Vec<_>, _>>()?;
    share_legends(&mut plots);
    if plots.is_empty() { Err(PlotError::Empty) } else { Ok(plots) }
}

fn laid_out(mut svg: Svg, title: &str, panels: &[Panel]) -> Result<String, PlotError> {
    let plots = plots(panels)?;
    let columns = match plots.len() {
        1 => 1,
        2..=4 => 2,
        _ => 3,
    };
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let width = |column| largest(&mut plots.iter().skip(column).step_by(columns).map(Plot::width));
    let widths: Vec<f64> = (0..columns).map(width).collect();
    let heights: Vec<f64> =
        plots.chunks(columns).map(|row| largest(&mut row.iter().map(Plot::height))).collect();
    let heading = if title.is_empty() { 0.0 } else { HEADING };
    for (i, plot) in plots.iter().enumerate() {
        let (row, column) = (i / columns, i % columns);
        let above: f64 = heights[..row].iter().sum();
        // A last row with fewer plots stands in the middle.
        let missing = (columns * (row + 1)).saturating_sub(plots.len()).min(columns);
        let left: f64 = 0.5 * widths[columns - missing..].iter().sum::<f64>();
        let corner = Pixel { x: left + widths[..column].iter().sum::<f64>(), y: heading + above };
        plot.draw(&mut svg, corner, &clip_name(title, i))?;
    }
    let width: f64 = widths.iter().sum();
    let height = heading + heights.iter().sum::<f64>();
    svg.text(Pixel { x: 0.5 * width, y: 22.0 }, Anchor::Middle, title, Type::TITLE);
    let panels: Vec<String> = plots.iter().map(Plot::spoken).collect();
    let spoken = [title, &panels.join("; ")].join(": ");
    Ok(svg.finish(width, height, spoken.trim_start_matches(": ")))
}

/// A name for a clip path that is unique when several plots are on one HTML page.
fn clip_name(title: &str, index: usize) -> String {
    let sum =
        title.bytes().fold(0u32, |sum, byte| sum.wrapping_mul(31).wrapping_add(u32::from(byte)));
    format!("clip-{sum:x}-{index}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Field;
    use crate::heat::BAR_SPACE;
    use crate::panel::Axis;
    use crate::series::{Arrow, Marker, Point, Series};

    fn panel() -> Panel {
        Panel::new(Axis::linear("x < y"), Axis::linear("y"))
    }

    #[test]
    fn every_style_is_drawn() {
        let mut panel = panel().titled("all").equal_aspect();
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        panel.add(Series::line("R_x", square));
        panel.add(Series::dashed("dashed", square));
        panel.add(Series::area("area", square));
        let arrow = Arrow { tail: Point::new(0.0, 0.0), head: Point::new(1.0, 0.5) };
        panel.add(Series::arrows("arrows", [arrow]));
        let markers = [
            Marker::Dot,
            Marker::Circle,
            Marker::Square,
            Marker::Triangle,
            Marker::Cross,
            Marker::Star,
        ];
        for marker in markers {
            panel.add(Series::markers("marker", marker, square));
        }
        let svg = render("A & B", &[panel]).unwrap();
        assert!(svg.contains("A &amp; B") && svg.contains("x &lt; y"));
        assert!(svg.contains("R<tspan"), "subscript");
        assert_eq!(svg.matches("stroke-dasharray").count(), 2); // curve and legend
        assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count());
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn a_field_is_drawn_with_its_bar_and_contours() {
        let linspace = carom_special::linspace;
        let nodes = linspace(0.0, 1.0, 5);
        let values = nodes.iter().flat_map(|y| nodes.iter().map(move |x| x - y)).collect();
        let field = Field::new("x - y", nodes.clone(), nodes.clone(), values).unwrap();
        let svg = render("", &[panel().over(field)]).unwrap();
        let large = linspace(0.0, 4e6, 25);
        let label = |values| {
            let field = Field::new("p / Pa", nodes.clone(), nodes.clone(), values).unwrap();
            render("", &[panel().over(field)]).unwrap().contains("p / MPa")
        };
        assert!(label(large) && !label(linspace(0.0, 4.0, 25)), "the bar tells its unit");
        // The diagonal, where the value is zero, is the bold line.
        let bold = svg.lines().find(|line| line.contains("stroke-width=\"1.6\"")).unwrap();
        assert!(bold.contains('M') && !svg.contains("NaN"));
        assert!(svg.contains("#08519c") && svg.contains("#a63603"));
        let bare = render("", &[titled()]).unwrap();
        let width = |svg: &str| {
            let text = svg.split("width=\"").nth(1).unwrap().split('"').next().unwrap();
            text.parse::<f64>().unwrap()
        };
        assert_eq!(width(&svg) - width(&bare), BAR_SPACE);
    }

    #[test]
    fn a_sketch_has_names_and_no_numbers() {
        let mut sketch = Panel::new(Axis::bare("aside"), Axis::bare(""));
        sketch.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
        sketch.add(Series::note("e_x", (0.5, 0.5)));
        let svg = render("", &[sketch]).unwrap();
        assert!(svg.contains("e<tspan") && svg.contains(">aside<"));
        assert_eq!(svg.matches("<text").count(), 2, "no tick, no legend");
    }

    fn titled() -> Panel {
        let mut panel = panel();
        panel.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
        panel
    }

    #[test]
    fn each_panel_is_a_picture_with_a_description() {
        let spun = Panel { title: "spun".to_owned(), ..titled() };
        let each = render_each("two", &[titled(), spun]).unwrap();
        assert_eq!(each.len(), 2);
        let names = each.iter().map(|svg| svg.split("id=\"").nth(1).unwrap().split('"').next());
        let names: Vec<_> = names.collect();
        assert!(names[0] != names[1], "{names:?}");
        assert!(each[0].contains("role=\"img\" aria-label=\"y over x &lt; y\""));
        assert!(each[1].contains("aria-label=\"spun: y over x &lt; y\""));
        assert_eq!(render_each("none", &[]), Err(PlotError::Empty));
        // A legend without space between the axes makes the picture higher, not wider.
        let mut dense = titled();
        for i in 0..12 {
            let slope = f64::from(i) / 11.0;
            let line = [(-1.0, 0.0), (0.0, slope), (1.0, 2.0 * slope)];
            dense.add(Series::line(format!("slope {slope:.2}"), line));
        }
        let size = |svg: &str, name: &str| {
            let text = svg.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next();
            text.unwrap().parse::<f64>().unwrap()
        };
        let high = &render_each("dense", &[dense]).unwrap()[0];
        assert_eq!(size(high, "width"), size(&each[0], "width"));
        let last = high.lines().filter(|line| line.contains(">slope ")).map(|line| size(line, "y"));
        let last = last.fold(0.0, f64::max);
        assert!(last > size(&each[0], "height") && last < size(high, "height"), "{last}");
        let whole = render("both", &[titled(), titled()]).unwrap();
        assert!(whole.contains("aria-label=\"both: y over x &lt; y; y over x &lt; y\""));
    }

    #[test]
    fn bad_points_are_named() {
        let mut panel = panel();
        panel.add(Series::line("bad", [(0.0, 0.0), (1.0, f64::NAN)]));
        let error = render("", &[panel]).unwrap_err();
        assert_eq!(error.to_string(), "series `bad`: point 1 is (1, NaN), not finite");
        assert_eq!(render("", &[]), Err(PlotError::Empty));
    }
}
