use std::path::Path;

use brunovsky::{
    Error,
    plot::{self, Draw, Figure, Line},
};

fn line() -> Line {
    Line::new("y", [(0.0, 0.0), (1.0, 1.0)])
}

fn refused(figure: &Figure) -> Error {
    match figure.svg().unwrap_err() {
        plot::Error::Input(error) => error,
        other => panic!("{other}"),
    }
}

#[test]
fn a_figure_without_points_is_refused() {
    let missing = Error::Missing { name: "points of the figure" };
    assert_eq!(refused(&Figure::over_time("y")), missing);
    assert_eq!(refused(&Figure::over_time("y").line(Line::new("y", []))), missing);
    assert_eq!(refused(&Figure::over_time("y").line(Line::new("y", [(f64::NAN, 1.0)]))), missing);
    // All there is lies outside of the range of time.
    assert_eq!(refused(&Figure::over_time("y").line(line()).x_range(5.0..6.0)), missing);
}

#[test]
fn a_range_has_to_be_finite_and_to_go_up() {
    let figure = || Figure::over_time("y").line(line());
    assert!(matches!(refused(&figure().y_range(1.0..1.0)), Error::NotBelow { .. }));
    assert!(matches!(refused(&figure().y_range(2.0..1.0)), Error::NotBelow { .. }));
    assert!(matches!(refused(&figure().x_range(f64::NAN..1.0)), Error::NonFinite { .. }));
    assert!(matches!(refused(&figure().x_range(0.0..f64::INFINITY)), Error::NonFinite { .. }));
    assert!(matches!(refused(&figure().y_range(-f64::MAX..f64::MAX)), Error::NonFinite { .. }));
}

#[test]
fn extreme_numbers_are_drawn_or_refused() {
    for size in [1e-320, 1e-300, 1e300, f64::MAX / 4.0] {
        let line = Line::new("y", [(0.0, -size), (1.0, size)]);
        Figure::over_time("y").line(line).svg().unwrap();
    }
    let line = Line::new("y", [(0.0, -f64::MAX), (1.0, f64::MAX)]);
    assert!(Figure::over_time("y").line(line).svg().is_err());
}

#[test]
fn sizes_have_limits() {
    for (width, height) in [(0.0, 300.0), (300.0, -1.0), (1e9, 300.0), (f64::NAN, 300.0)] {
        assert!(Figure::over_time("y").size(width, height).is_err());
    }
}

#[test]
fn names_need_room() {
    let figure = |width: f64| Figure::over_time("y").line(line()).size(width, 120.0).unwrap();
    assert!(figure(140.0).svg().is_ok());
    assert!(
        refused(&figure(100.0).line(Line::new("y", [(0.0, 1.23456789e4)])))
            .to_string()
            .starts_with("least room")
    );
    assert!(figure(140.0).png(96).is_ok());
}

#[test]
fn the_name_of_the_file_says_what_it_is() {
    let figure = Figure::over_time("y").line(line());
    let refused = figure.save("figure.pdf").unwrap_err();
    assert_eq!(refused.to_string(), "figure.pdf ends in neither .svg nor .png");
    let missing = Path::new("no such folder").join("figure.svg");
    assert!(matches!(figure.save(missing).unwrap_err(), plot::Error::File { .. }));
}

#[test]
fn runs_have_to_fit_together() {
    let figure = || Figure::over_time("y");
    let runs = [vec![0.0, 1.0], vec![0.0]];
    let length = Error::Length { name: "run", expected: 2, found: 1 };
    assert_eq!(figure().spread("", &[0.0, 1.0], &runs, [0.1, 0.9]).unwrap_err(), length);
    let none = Error::Missing { name: "runs" };
    assert_eq!(figure().spread("", &[0.0, 1.0], &[], [0.1, 0.9]).unwrap_err(), none);
    let nan = [vec![0.0, f64::NAN]];
    assert!(figure().spread("", &[0.0, 1.0], &nan, [0.1, 0.9]).is_err());
    for quantiles in [[0.9, 0.1], [-0.1, 0.5], [0.5, 1.1], [0.5, f64::NAN], [0.5, 0.5]] {
        assert!(figure().spread("", &[0.0], &[vec![0.0]], quantiles).is_err(), "{quantiles:?}");
    }
}

#[test]
fn maps_need_a_grid_and_a_value() {
    let map = |xs: &[f64], ys: &[f64], value: f64| {
        Figure::heat_map(["x", "y", "z"], xs, ys, |_, _| value).map(|_| ())
    };
    let grid = [0.0, 1.0];
    assert_eq!(map(&grid, &grid, 1.0), Ok(()));
    assert_eq!(map(&[0.0], &grid, 1.0), Err(Error::Missing { name: "x of the map" }));
    assert!(matches!(map(&grid, &[1.0, 1.0], 1.0), Err(Error::NotBelow { .. })));
    assert!(matches!(map(&grid, &[0.0, f64::NAN], 1.0), Err(Error::NonFiniteEntry { .. })));
    assert_eq!(
        map(&grid, &grid, f64::NAN),
        Err(Error::Missing { name: "finite value of the map" })
    );
    let figure = Figure::heat_map(["x", "y", "z"], &grid, &grid, |x, _| x).unwrap();
    assert!(figure.colour_range(1.0..0.0).is_err());
}

#[test]
fn shares_need_time_to_advance() {
    let samples = [(0.0, 1.0, 1.0), (0.0, 1.0, 1.0)];
    assert!(matches!(Figure::shares("m", samples, 1.0), Err(Error::NotBelow { .. })));
    assert!(matches!(Figure::shares("m", [], 0.0), Err(Error::NotPositive { .. })));
}
