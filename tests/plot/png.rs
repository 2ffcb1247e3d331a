use brunovsky::plot::{BLUE, Dash, Draw, Figure, Line, Stroke};

fn decoded(file: &[u8]) -> (png::Info<'static>, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut dots = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut dots).unwrap();
    (reader.info().clone(), dots)
}

#[test]
fn a_png_has_the_dots_of_its_size() {
    let line = Line::new("y", [(0.0, 0.0), (1.0, 1.0)]);
    let figure = Figure::over_time("y").line(line.stroke(Stroke::new(BLUE, Dash::Solid)));
    for dpi in [96, 150, 300] {
        let (info, dots) = decoded(&figure.clone().size(320.0, 240.0).unwrap().png(dpi).unwrap());
        assert_eq!((info.width, info.height), (320 * dpi / 96, 240 * dpi / 96));
        let per_metre = (f64::from(dpi) / 0.0254).round() as u32;
        assert_eq!(info.pixel_dims.unwrap().xppu, per_metre);
        assert_eq!(dots[..3], [255, 255, 255]);
        let blue = dots.chunks_exact(3).filter(|dot| *dot == [0, 114, 178]).count();
        assert!(blue > 100, "{blue} blue dots");
    }
}

#[test]
fn letters_are_drawn_without_a_font_of_the_system() {
    // The only black in the figure is that of its letters.
    let drawn = |label: &str| {
        let figure = Figure::new(label, label).line(Line::new("", [(0.0, 0.0), (1.0, 1.0)]));
        let (_, dots) = decoded(&figure.png(300).unwrap());
        dots.chunks_exact(3).filter(|dot| *dot == [0, 0, 0]).count()
    };
    let ticks = drawn("");
    for label in ["ẋ₁ in m/s²", "ė_n", "α·h", "θ̇, ξ, ω, λ, Δ", "−10⁻³ °"] {
        assert!(drawn(label) > ticks + 100, "{label}");
    }
}

#[test]
fn a_figure_too_large_is_refused() {
    let figure = Figure::over_time("y").line(Line::new("", [(0.0, 0.0), (1.0, 1.0)]));
    assert_eq!(figure.png(0).unwrap_err().to_string(), "dpi = 0 must be greater than 0");
    assert!(figure.png(u32::MAX).unwrap_err().to_string().starts_with("dots of the figure = "));
}
