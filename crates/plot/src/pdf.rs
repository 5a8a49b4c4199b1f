//! A drawing as PDF: its paths, clip paths and pixel images on one page.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Finish as _, Name, Pdf, Rect, Ref, TextStr};
use resvg::tiny_skia::{PathSegment, Pixmap, Point};
use resvg::usvg::{
    self, FillRule, Group, Image, ImageKind, LineCap, LineJoin, Node, Paint, Path, Transform,
};

use crate::error::PlotError;
use crate::raster::raster;

const CATALOG: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
const INFORMATION: Ref = Ref::new(5);
/// Number of the first object of an image or of an opacity.
const FIRST: i32 = 6;

/// A drawing as PDF; `svg` must not have texts.
pub(crate) fn pdf_of(svg: &str, title: &str) -> Result<Vec<u8>, PlotError> {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).map_err(raster)?;
    Page::of(&tree)?.finish([tree.size().width(), tree.size().height()], title)
}

/// The page under construction.
struct Page {
    content: Content,
    images: Vec<Pixmap>,
    opacities: Vec<Opacity>,
}

#[derive(PartialEq, Clone, Copy)]
struct Opacity {
    fill: f32,
    stroke: f32,
}

impl Page {
    fn of(tree: &usvg::Tree) -> Result<Self, PlotError> {
        let (images, opacities) = (Vec::new(), Vec::new());
        let mut page = Self { content: Content::new(), images, opacities };
        // From the upper left corner downwards to the lower left corner upwards.
        page.content.transform([1.0, 0.0, 0.0, -1.0, 0.0, tree.size().height()]);
        page.group(tree.root())?;
        Ok(page)
    }

    fn group(&mut self, group: &Group) -> Result<(), PlotError> {
        for node in group.children() {
            self.content.save_state();
            match node {
                Node::Group(inner) => {
                    if let Some(clip) = inner.clip_path() {
                        let within = inner.abs_transform().pre_concat(clip.transform());
                        self.clip(clip.root(), within);
                    }
                    self.group(inner)?;
                }
                Node::Path(path) => self.path(path),
                Node::Image(image) => self.image(image)?,
                Node::Text(_) => return Err(raster("a text is no outline")),
            }
            self.content.restore_state();
        }
        Ok(())
    }

    fn clip(&mut self, shapes: &Group, within: Transform) {
        for node in shapes.children() {
            if let Node::Path(path) = node {
                self.trace(path, within);
            }
        }
        self.content.clip_nonzero().end_path();
    }

    fn path(&mut self, path: &Path) {
        let color = |paint: &Paint| match paint {
            Paint::Color(color) => {
                [color.red, color.green, color.blue].map(|part| f32::from(part) / 255.0)
            }
            _ => [0.0; 3],
        };
        let opacity = Opacity {
            fill: path.fill().map_or(1.0, |fill| fill.opacity().get()),
            stroke: path.stroke().map_or(1.0, |stroke| stroke.opacity().get()),
        };
        self.opacity(opacity);
        self.content.transform(of(path.abs_transform()));
        if let Some(fill) = path.fill() {
            let [red, green, blue] = color(fill.paint());
            self.content.set_fill_rgb(red, green, blue);
            self.trace(path, Transform::identity());
            match fill.rule() {
                FillRule::NonZero => self.content.fill_nonzero(),
                FillRule::EvenOdd => self.content.fill_even_odd(),
            };
        }
        if let Some(stroke) = path.stroke() {
            let [red, green, blue] = color(stroke.paint());
            self.content.set_stroke_rgb(red, green, blue);
            self.content.set_line_width(stroke.width().get());
            self.content.set_line_cap(match stroke.linecap() {
                LineCap::Butt => LineCapStyle::ButtCap,
                LineCap::Round => LineCapStyle::RoundCap,
                LineCap::Square => LineCapStyle::ProjectingSquareCap,
            });
            self.content.set_line_join(match stroke.linejoin() {
                LineJoin::Miter | LineJoin::MiterClip => LineJoinStyle::MiterJoin,
                LineJoin::Round => LineJoinStyle::RoundJoin,
                LineJoin::Bevel => LineJoinStyle::BevelJoin,
            });
            if let Some(dashes) = stroke.dasharray() {
                self.content.set_dash_pattern(dashes.iter().copied(), stroke.dashoffset());
            }
            self.trace(path, Transform::identity());
            self.content.stroke();
        }
    }

    /// Adds the outline of a path to the current path.
    fn trace(&mut self, path: &Path, within: Transform) {
        let at = |mut point: Point| {
            within.map_point(&mut point);
            point
        };
        let mut from = Point::zero();
        for segment in path.data().segments() {
            match segment {
                PathSegment::MoveTo(to) => {
                    from = to;
                    let to = at(to);
                    self.content.move_to(to.x, to.y);
                }
                PathSegment::LineTo(to) => {
                    from = to;
                    let to = at(to);
                    self.content.line_to(to.x, to.y);
                }
                PathSegment::QuadTo(control, to) => {
                    // The cubic curve that is this parabola.
                    let toward = |end: Point| {
                        let third = |end: f32, control: f32| end + 2.0 / 3.0 * (control - end);
                        at(Point::from_xy(third(end.x, control.x), third(end.y, control.y)))
                    };
                    let (first, second, end) = (toward(from), toward(to), at(to));
                    self.content.cubic_to(first.x, first.y, second.x, second.y, end.x, end.y);
                    from = to;
                }
                PathSegment::CubicTo(first, second, to) => {
                    from = to;
                    let (first, second, to) = (at(first), at(second), at(to));
                    self.content.cubic_to(first.x, first.y, second.x, second.y, to.x, to.y);
                }
                PathSegment::Close => {
                    self.content.close_path();
                }
            }
        }
    }

    fn image(&mut self, image: &Image) -> Result<(), PlotError> {
        let ImageKind::PNG(bytes) = image.kind() else {
            return Err(raster("an image inside the picture is no PNG"));
        };
        let pixels = Pixmap::decode_png(bytes).map_err(raster)?;
        let size = image.size();
        self.content.transform(of(image.abs_transform()));
        // An image fills the unit square, upright.
        self.content.transform([size.width(), 0.0, 0.0, -size.height(), 0.0, size.height()]);
        let name = format!("I{}", self.images.len());
        self.content.x_object(Name(name.as_bytes()));
        self.images.push(pixels);
        Ok(())
    }

    fn opacity(&mut self, opacity: Opacity) {
        if opacity == (Opacity { fill: 1.0, stroke: 1.0 }) {
            return;
        }
        let known = self.opacities.iter().position(|known| *known == opacity);
        let number = known.unwrap_or_else(|| {
            self.opacities.push(opacity);
            self.opacities.len() - 1
        });
        self.content.set_parameters(Name(format!("O{number}").as_bytes()));
    }

    fn finish(self, [width, height]: [f32; 2], title: &str) -> Result<Vec<u8>, PlotError> {
        let mut pdf = Pdf::new();
        pdf.catalog(CATALOG).pages(PAGES);
        pdf.pages(PAGES).kids([PAGE]).count(1);
        pdf.document_info(INFORMATION).title(TextStr(title)).creator(TextStr("carom"));
        let mut page = pdf.page(PAGE);
        page.parent(PAGES).contents(CONTENT).media_box(Rect::new(0.0, 0.0, width, height));
        let mut resources = page.resources();
        let mut next = FIRST;
        let mut number = || {
            next += 1;
            Ref::new(next - 1)
        };
        let images: Vec<[Ref; 2]> = self.images.iter().map(|_| [number(), number()]).collect();
        let opacities: Vec<Ref> = self.opacities.iter().map(|_| number()).collect();
        let mut named = resources.x_objects();
        for (i, [colors, _]) in images.iter().enumerate() {
            named.pair(Name(format!("I{i}").as_bytes()), *colors);
        }
        named.finish();
        let mut named = resources.ext_g_states();
        for (i, state) in opacities.iter().enumerate() {
            named.pair(Name(format!("O{i}").as_bytes()), *state);
        }
        named.finish();
        resources.finish();
        page.finish();
        for (opacity, state) in self.opacities.iter().zip(opacities) {
            let mut state = pdf.ext_graphics(state);
            state.non_stroking_alpha(opacity.fill).stroking_alpha(opacity.stroke);
        }
        for (pixels, [colors, mask]) in self.images.iter().zip(images) {
            put_image(&mut pdf, pixels, [colors, mask])?;
        }
        let content = packed(&self.content.finish())?;
        pdf.stream(CONTENT, &content).filter(Filter::FlateDecode);
        Ok(pdf.finish())
    }
}

/// The colours of an image, and how opaque each pixel is.
fn put_image(pdf: &mut Pdf, pixels: &Pixmap, [colors, mask]: [Ref; 2]) -> Result<(), PlotError> {
    let length = |length: u32| i32::try_from(length).map_err(raster);
    let (width, height) = (length(pixels.width())?, length(pixels.height())?);
    let straight = || pixels.pixels().iter().map(|pixel| pixel.demultiply());
    let parts = straight().flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]);
    let packed_colors = packed(&parts.collect::<Vec<u8>>())?;
    let mut image = pdf.image_xobject(colors, &packed_colors);
    image.filter(Filter::FlateDecode);
    image.width(width).height(height);
    image.color_space().device_rgb();
    image.bits_per_component(8).s_mask(mask);
    image.finish();
    let packed_mask = packed(&straight().map(|pixel| pixel.alpha()).collect::<Vec<u8>>())?;
    let mut image = pdf.image_xobject(mask, &packed_mask);
    image.filter(Filter::FlateDecode);
    image.width(width).height(height);
    image.color_space().device_gray();
    image.bits_per_component(8);
    Ok(())
}

fn packed(bytes: &[u8]) -> Result<Vec<u8>, PlotError> {
    let mut packer = ZlibEncoder::new(Vec::new(), Compression::default());
    packer.write_all(bytes).map_err(raster)?;
    packer.finish().map_err(raster)
}

/// A transform in the order of PDF.
fn of(transform: Transform) -> [f32; 6] {
    let Transform { sx, ky, kx, sy, tx, ty } = transform;
    [sx, ky, kx, sy, tx, ty]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The commands of the page, one a line.
    fn commands(body: &str) -> Vec<String> {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\">{body}</svg>"
        );
        let tree = usvg::Tree::from_str(&svg, &usvg::Options::default()).unwrap();
        let content = Page::of(&tree).unwrap().content.finish();
        String::from_utf8(content.to_vec()).unwrap().lines().map(str::to_owned).collect()
    }

    fn has(commands: &[String], expected: &[&str]) {
        let mut rest = commands.iter();
        for line in expected {
            assert!(rest.any(|command| command == line), "{line} in {commands:?}");
        }
    }

    #[test]
    fn heights_count_from_the_foot_of_the_page() {
        let line = "<path d=\"M10 40 L90 5\" fill=\"none\" stroke=\"#ff0000\" \
                    stroke-width=\"2\" stroke-dasharray=\"4 3\"/>";
        has(
            &commands(line),
            &["1 0 0 -1 0 50 cm", "1 0 0 RG", "2 w", "[4 3] 0 d", "10 40 m", "90 5 l", "S"],
        );
    }

    #[test]
    fn parabolas_areas_and_opacity_are_kept() {
        let area = "<path d=\"M0 0 Q30 0 30 30 Z\" fill=\"#00ff00\" fill-opacity=\"0.5\"/>";
        // Its control points lie two thirds on the way from the ends to that of the parabola.
        has(&commands(area), &["/O0 gs", "0 1 0 rg", "0 0 m", "20 0 30 10 30 30 c", "h", "f"]);
    }

    #[test]
    fn what_is_clipped_or_moved_stays_so() {
        let body = "<clipPath id=\"c\"><rect x=\"5\" y=\"6\" width=\"7\" height=\"8\"/></clipPath>\
                    <g clip-path=\"url(#c)\"><path transform=\"translate(3 4)\" d=\"M0 0 L9 9\" \
                    stroke=\"#000000\"/></g>";
        has(&commands(body), &["5 6 m", "12 6 l", "W", "n", "1 0 0 1 3 4 cm", "0 0 m", "9 9 l"]);
    }

    /// The place on the page of a point of the unit square that an image fills.
    fn place(commands: &[String], [x, y]: [f64; 2]) -> [f64; 2] {
        let until = commands.iter().position(|command| command == "/I0 Do").unwrap();
        let transforms = commands[..until].iter().filter_map(|line| line.strip_suffix(" cm"));
        let numbers =
            |line: &str| line.split(' ').map(|part| part.parse().unwrap()).collect::<Vec<f64>>();
        let all: Vec<Vec<f64>> = transforms.map(numbers).collect();
        all.iter()
            .rev()
            .fold([x, y], |[x, y], m| [m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]])
    }

    #[test]
    fn images_stand_upright_in_their_place() {
        let palette = [[255, 0, 0], [0, 0, 255]];
        let png = crate::raster::indexed_png(2, &[0, 1, 1, 0], &palette, false).unwrap();
        let body = format!(
            "<image x=\"10\" y=\"20\" width=\"30\" height=\"15\" preserveAspectRatio=\"none\" \
             href=\"data:image/png;base64,{}\"/>",
            crate::raster::base64(&png)
        );
        let commands = commands(&body);
        for (corner, expected) in [([0.0, 1.0], [10.0, 30.0]), ([1.0, 0.0], [40.0, 15.0])] {
            let found = place(&commands, corner);
            let off = [found[0] - expected[0], found[1] - expected[1]];
            assert!(off.iter().all(|off| off.abs() < 1e-4), "{corner:?}: {found:?}");
        }
    }
}
