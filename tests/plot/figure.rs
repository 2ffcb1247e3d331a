use brunovsky::plot::{BLUE, Dash, Draw, Figure, Line, Stroke};

use crate::support::{Drawn, close, is_frame};

const BLUE_HEX: &str = "#0072B2";

fn solid(points: impl IntoIterator<Item = (f64, f64)>) -> Line {
    Line::new("y", points).stroke(Stroke::new(BLUE, Dash::Solid))
}

#[test]
fn points_lie_where_the_ticks_say() {
    let points = [(0.0, 3.0), (1.0, -2.0), (4.5, 7.25), (10.0, 0.0)];
    let drawn = Drawn::of(&Figure::over_time("y in m").line(solid(points)));
    let lines = drawn.lines(BLUE_HEX);
    assert_eq!(lines.len(), 1);
    for (drawn_at, point) in lines[0].iter().zip(points) {
        assert!(close(*drawn_at, drawn.place(point)), "{drawn_at:?} is not {point:?}");
    }
}

#[test]
fn a_line_ends_where_it_leaves_the_range() {
    let figure = Figure::over_time("y").y_range(0.0..1.0).line(solid([(0.0, -3.0), (4.0, 5.0)]));
    let drawn = Drawn::of(&figure);
    // It is at 0 after 1.5 s and at 1 after 2 s.
    let lines = drawn.lines(BLUE_HEX);
    assert_eq!(lines.len(), 1);
    assert!(close(lines[0][0], drawn.place((1.5, 0.0))));
    assert!(close(lines[0][1], drawn.place((2.0, 1.0))));
}

#[test]
fn a_number_that_is_none_makes_a_gap() {
    let points = [
        (0.0, 0.0),
        (1.0, 1.0),
        (2.0, f64::NAN),
        (3.0, 1.0),
        (4.0, f64::INFINITY),
        (5.0, 0.0),
        (6.0, 1.0),
    ];
    let drawn = Drawn::of(&Figure::over_time("y").line(solid(points)));
    // Between gaps a single point is no line.
    let lines = drawn.lines(BLUE_HEX);
    assert_eq!(lines.len(), 2);
    assert!(close(lines[0][1], drawn.place((1.0, 1.0))));
    assert!(close(lines[1][0], drawn.place((5.0, 0.0))));
}

#[test]
fn dashes_cover_their_share_of_a_line() {
    let share = |dash| {
        let line = Line::new("y", [(0.0, 0.0), (3.0, 1.0)]).stroke(Stroke::new(BLUE, dash));
        let drawn = Drawn::of(&Figure::over_time("y").line(line));
        let length = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).hypot(a.1 - b.1);
        let dashes = drawn.lines(BLUE_HEX);
        let drawn_length: f64 = dashes.iter().map(|dash| length(dash[0], dash[1])).sum();
        drawn_length / length(drawn.place((0.0, 0.0)), drawn.place((3.0, 1.0)))
    };
    assert!((share(Dash::Solid) - 1.0).abs() < 0.01);
    for (dash, on, off) in
        [(Dash::Dashed, 6.0, 3.5), (Dash::DashDot, 9.8, 6.0), (Dash::Dotted, 1.8, 2.4)]
    {
        let expected = on / (on + off);
        assert!((share(dash) - expected).abs() < 0.03, "{dash:?}: {}", share(dash));
    }
}

#[test]
fn neighbouring_lines_differ_in_colour_and_in_dashes() {
    let figure = (0..6).fold(Figure::over_time("y"), |figure, i| {
        figure.line(Line::new(format!("y{i}"), [(0.0, f64::from(i)), (1.0, f64::from(i))]))
    });
    let drawn = Drawn::of(&figure);
    let [(_, top), _] = drawn.frame();
    let samples: Vec<_> = drawn
        .all("polyline")
        .filter(|line| line.points().iter().all(|point| point.1 < top))
        .map(|line| (line.get("stroke").to_owned(), line.points()))
        .collect();
    let mut colours: Vec<_> = samples.iter().map(|(colour, _)| colour.clone()).collect();
    colours.dedup();
    assert_eq!(colours.len(), 6);
    colours.sort();
    colours.dedup();
    assert_eq!(colours.len(), 6);
    // Of the first dashes, no two neighbours are equally long.
    let first = |colour: &String| {
        let (_, dash) = samples.iter().find(|(own, _)| own == colour).unwrap();
        dash[1].0 - dash[0].0
    };
    let order: Vec<_> = samples.iter().map(|(colour, _)| colour).collect();
    for pair in order.windows(2).filter(|pair| pair[0] != pair[1]) {
        assert!((first(pair[0]) - first(pair[1])).abs() > 10.0);
    }
}

#[test]
fn names_stand_above_the_axes_and_within_the_figure() {
    let names = [
        "feedback linearization",
        "closed-loop error learning",
        "a third with a long name",
        "four",
    ];
    let figure = names.iter().fold(Figure::over_time("y"), |figure, name| {
        figure.line(Line::new(*name, [(0.0, 0.0), (1.0, 1.0)]))
    });
    let drawn = Drawn::of(&figure.size(330.0, 240.0).unwrap());
    let [(_, top), (right, _)] = drawn.frame();
    let mut places = Vec::new();
    for name in names {
        let text = drawn.texts().find(|text| text.text == name).unwrap();
        assert!(text.number("y") < top);
        // Letters of this font are half as wide as their size at the least, over a word.
        let end = text.number("x") + name.len() as f64 * 0.5 * text.number("font-size");
        assert!(end < right + 1.5, "{name} ends at {end}, the axes at {right}");
        places.push((text.number("y"), text.number("x"), end));
    }
    for pair in places.windows(2) {
        let same_row = pair[0].0 == pair[1].0;
        assert!(if same_row { pair[1].1 > pair[0].2 } else { pair[1].0 > pair[0].0 });
    }
}

#[test]
fn events_are_named_at_their_time() {
    let figure = Figure::over_time("y").line(solid([(0.0, 0.0), (8.0, 1.0)])).event(5.0, "load");
    let drawn = Drawn::of(&figure);
    let name = drawn.texts().find(|text| text.text == "load").unwrap();
    assert!((name.number("x") - drawn.place((5.0, 0.0)).0).abs() <= 1.5);
}

#[test]
fn panels_have_their_axes_below_each_other_and_say_once_what_they_share() {
    let panel = |scale: f64| {
        Figure::over_time("y").line(solid([(0.0, 0.0), (1.0, scale)])).event(0.5, "load")
    };
    let drawn = Drawn::of(&[panel(1.0), panel(2000.0)]);
    let frames: Vec<_> =
        drawn.all("polyline").map(|line| line.points()).filter(|line| is_frame(line)).collect();
    assert_eq!(frames.len(), 2);
    assert_eq!(frames[0][0].0, frames[1][0].0);
    assert!(frames[1][0].1 > frames[0][2].1);
    assert_eq!(drawn.texts().filter(|text| text.text == "time t in s").count(), 1);
    assert_eq!(
        drawn.texts().filter(|text| text.text == "y" && text.get("transform").is_empty()).count(),
        1
    );
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let figure = || {
        let wave = |phase: f64| {
            (0..1000).map(move |k| (f64::from(k), (0.01 * f64::from(k) + phase).sin()))
        };
        Figure::over_time("y").line(Line::new("a", wave(0.0))).line(Line::new("b", wave(1.0)))
    };
    let elsewhere =
        std::thread::spawn(move || (figure().svg().unwrap(), figure().png(100).unwrap()));
    assert_eq!((figure().svg().unwrap(), figure().png(100).unwrap()), elsewhere.join().unwrap());
}
