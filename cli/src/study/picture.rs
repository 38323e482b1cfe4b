//! Pictures as files: SVG as it was drawn, or PNG where the name of the file says so.

use super::format::Format;
use super::{Failure, write};
use std::path::Path;

/// Writes a picture to standard output as SVG, or to a file as what its name says.
pub fn write_picture(out: Option<&Path>, svg: &str) -> Result<(), Failure> {
    match Format::of(out) {
        Format::Png => write(out, png(svg).map_err(|why| Failure::Usage(format!("--out: no PNG: {why}")))?),
        Format::Text | Format::Arrow => write(out, svg),
    }
}

/// A picture in pixels, twice as many as it has units, so that lines stay fine on a dense screen and on paper.
#[cfg(feature = "png")]
fn png(svg: &str) -> Result<Vec<u8>, String> {
    use resvg::tiny_skia::{Color, Pixmap, Transform};
    use resvg::usvg::{Options, Tree};
    const DENSITY: f32 = 2.0;
    let mut options = Options::default();
    let fonts = options.fontdb_mut();
    fonts.load_system_fonts();
    let font =
        sans_serif(fonts).ok_or("this system has no fonts, so that names would be left out; write SVG")?;
    fonts.set_sans_serif_family(font);
    let tree = Tree::from_str(&without_variables(svg), &options).map_err(|error| error.to_string())?;
    let size = tree.size().to_int_size().scale_by(DENSITY);
    let pixels = size.and_then(|size| Pixmap::new(size.width(), size.height()));
    let mut pixels = pixels.ok_or("the picture is too large")?;
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(DENSITY, DENSITY), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| error.to_string())
}

/// The family for all that is written: the first of these that is there, else any whose letters differ in width.
#[cfg(feature = "png")]
fn sans_serif(fonts: &resvg::usvg::fontdb::Database) -> Option<String> {
    const KNOWN: [&str; 5] = ["Arial", "Helvetica", "Liberation Sans", "DejaVu Sans", "Noto Sans"];
    let families = || fonts.faces().flat_map(|face| face.families.iter().map(move |(name, _)| (name, face)));
    let known =
        KNOWN.iter().find(|known| families().any(|(name, _)| name == *known)).map(ToString::to_string);
    let any = || families().min_by_key(|(_, face)| face.monospaced).map(|(name, _)| name.clone());
    known.or_else(any)
}

/// The colours of a picture in the place of the names that its style gives them, those of light surroundings: what renders it does not
/// know such names.
#[cfg(feature = "png")]
fn without_variables(svg: &str) -> String {
    let Some((_, rest)) = svg.split_once("<style>svg{--") else { return svg.to_string() };
    let colours = rest.split_once('}').map_or("", |(colours, _)| colours);
    let colours = colours.split(";--").filter_map(|colour| colour.split_once(':'));
    colours.fold(svg.to_string(), |text, (name, colour)| text.replace(&format!("var(--{name})"), colour))
}

/// There is nothing to make it, which has been said before.
#[cfg(not(feature = "png"))]
fn png(_: &str) -> Result<Vec<u8>, String> {
    Err("this program has been built without it".to_string())
}
