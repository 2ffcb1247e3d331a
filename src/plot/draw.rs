use std::{fs, path::Path, slice};

use plotters::{
    backend::{BitMapBackend, SVGBackend},
    coord::Shift,
    drawing::IntoDrawingArea,
    prelude::{DrawingArea, DrawingBackend},
    style::WHITE,
};

use super::{
    Error, Figure,
    canvas::Canvas,
    layout::{Layout, Said},
    page::Page,
};

/// What can be drawn: a [`Figure`], or several as the panels of one, from above to below.
///
/// The same figure gives the same bytes, on every machine with the same arithmetic.
pub trait Draw {
    /// The panels, from above to below.
    fn panels(&self) -> &[Figure];

    /// Draws on any area of [`plotters`], as large as fits.
    ///
    /// # Errors
    /// [`Error::Input`] for a range or data that cannot be shown, [`Error::Backend`] for what the area has against it.
    fn draw_on<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> Result<(), Error> {
        let layouts = layouts(self.panels())?;
        let [wide, tall] = extent(&layouts);
        let (across, up) = area.dim_in_pixel();
        let scale = (f64::from(across) / wide).min(f64::from(up) / tall);
        let mut top = 0.0;
        for (figure, layout) in self.panels().iter().zip(&layouts) {
            let rest = area.clone().margin((top * scale).round() as i32, 0, 0, 0);
            Page { figure, layout, canvas: Canvas::new(&rest, scale) }.draw()?;
            let [_, height] = layout.size;
            top += height;
        }
        Ok(())
    }

    /// The figure as SVG text.
    ///
    /// # Errors
    /// As [`draw_on`](Self::draw_on).
    fn svg(&self) -> Result<String, Error> {
        // Backends draw at whole numbers; in tenths of a pixel the lines are smooth.
        const FINE: u32 = 10;
        let [width, height] = pixels(self.panels())?;
        let mut text = String::new();
        let backend = SVGBackend::with_string(&mut text, (width * FINE, height * FINE));
        let area = backend.into_drawing_area();
        area.fill(&WHITE).map_err(Error::backend)?;
        self.draw_on(&area)?;
        area.present().map_err(Error::backend)?;
        drop(area);
        let fine = format!("width=\"{}\" height=\"{}\"", width * FINE, height * FINE);
        Ok(text.replacen(&fine, &format!("width=\"{width}\" height=\"{height}\""), 1))
    }

    /// The figure as a PNG file with `dpi` dots per inch: 300 for print, 96 for a screen.
    ///
    /// # Errors
    /// As [`draw_on`](Self::draw_on); [`Error::Input`] for a `dpi` of 0, or for more than 50 million dots.
    fn png(&self, dpi: u32) -> Result<Vec<u8>, Error> {
        crate::error::positive("dpi", f64::from(dpi))?;
        let wanted =
            pixels(self.panels())?.map(|size| (f64::from(size) * f64::from(dpi) / 96.0).ceil());
        crate::error::below("dots of the figure", wanted[0] * wanted[1], 5e7)?;
        let [width, height] = wanted.map(|size| size as u32);
        // Every dot is the mean of four, as the backend smoothes edges in one direction only.
        let mut fine = vec![0; 12 * width as usize * height as usize];
        let area =
            BitMapBackend::with_buffer(&mut fine, (2 * width, 2 * height)).into_drawing_area();
        area.fill(&WHITE).map_err(Error::backend)?;
        self.draw_on(&area)?;
        area.present().map_err(Error::backend)?;
        drop(area);
        encoded(&halved(&fine, width as usize), [width, height], dpi).map_err(Error::backend)
    }

    /// Writes the figure into a file, as its extension says: `.svg`, or `.png` with 300 dots per inch.
    ///
    /// # Errors
    /// As [`draw_on`](Self::draw_on), [`Error::Extension`], and [`Error::File`].
    fn save(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let path = path.as_ref();
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
        let bytes = match extension.as_ref().and_then(|extension| extension.to_str()) {
            Some("svg") => self.svg()?.into_bytes(),
            Some("png") => self.png(300)?,
            _ => return Err(Error::Extension(path.into())),
        };
        fs::write(path, bytes).map_err(|source| Error::File { path: path.into(), source })
    }
}

impl Draw for Figure {
    fn panels(&self) -> &[Figure] {
        slice::from_ref(self)
    }
}

impl Draw for [Figure] {
    fn panels(&self) -> &[Figure] {
        self
    }
}

impl<const N: usize> Draw for [Figure; N] {
    fn panels(&self) -> &[Figure] {
        self
    }
}

/// The layouts of panels, with their left axes below each other. What two neighbours have in common is said once.
fn layouts(panels: &[Figure]) -> Result<Vec<Layout>, Error> {
    let keys = |figure: &Figure| -> Vec<String> {
        figure.layers.iter().filter_map(|layer| layer.key().map(str::to_owned)).collect()
    };
    let said = |i: usize, figure: &Figure| {
        let above = i.checked_sub(1).and_then(|i| panels.get(i));
        let below = panels.get(i + 1);
        let [axis, _] = &figure.axes;
        Said {
            legend: above.is_some_and(|above| keys(above) == keys(figure)),
            x_label: below.is_some_and(|below| below.axes[0] == *axis),
        }
    };
    let with = |left: f64| -> Result<Vec<_>, Error> {
        let panels = panels.iter().enumerate();
        panels.map(|(i, figure)| Layout::of(figure, left, said(i, figure))).collect()
    };
    let left = with(0.0)?.iter().fold(0.0_f64, |left, layout| left.max(layout.left));
    with(left)
}

fn extent(layouts: &[Layout]) -> [f64; 2] {
    layouts.iter().fold([1.0, 0.0], |[wide, tall], layout| {
        let [width, height] = layout.size;
        [f64::max(wide, width), tall + height]
    })
}

fn pixels(panels: &[Figure]) -> Result<[u32; 2], Error> {
    if panels.is_empty() {
        return Err(crate::Error::Missing { name: "panels" }.into());
    }
    Ok(extent(&layouts(panels)?).map(|size| size.ceil() as u32))
}

/// The means of 2 × 2 dots, of an image that is twice as wide as `width`.
fn halved(fine: &[u8], width: usize) -> Vec<u8> {
    let mut dots = Vec::with_capacity(fine.len() / 4);
    for rows in fine.chunks_exact(12 * width) {
        let (upper, lower) = rows.split_at(6 * width);
        for quad in upper.chunks_exact(6).zip(lower.chunks_exact(6)) {
            let ([a, b, c, d, e, f], [g, h, i, j, k, l]) = quad else { continue };
            let mean =
                |four: [&u8; 4]| (four.into_iter().map(|dot| u16::from(*dot)).sum::<u16>() + 2) / 4;
            dots.extend([[a, d, g, j], [b, e, h, k], [c, f, i, l]].map(|four| mean(four) as u8));
        }
    }
    dots
}

fn encoded(
    dots: &[u8],
    [width, height]: [u32; 2],
    dpi: u32,
) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // Dots per metre.
    let resolution = (f64::from(dpi) / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: resolution,
        yppu: resolution,
        unit: png::Unit::Meter,
    }));
    encoder.write_header()?.write_image_data(dots)?;
    Ok(file)
}
