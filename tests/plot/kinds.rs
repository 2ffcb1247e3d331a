use brunovsky::{
    fuzzy::{FuzzyNetwork, Gaussian},
    plot::{BLUE, ColourMap, Dash, Figure, Line, Stroke},
};

use crate::support::{Drawn, Point, close};

const BLUE_HEX: &str = "#0072B2";

#[test]
fn the_spread_is_the_median_and_its_quantiles() {
    // Of 101 runs with the constants 0 to 100, quantile q is 100·q.
    let runs: Vec<_> = (0..=100).map(|run| vec![f64::from(run); 3]).collect();
    let figure = Figure::over_time("y").y_range(0.0..100.0);
    let drawn = Drawn::of(&figure.spread("runs", &[0.0, 1.0, 2.0], &runs, [0.05, 0.9]).unwrap());
    let mut heights: Vec<_> = drawn.lines(BLUE_HEX).iter().map(|line| line[0].1).collect();
    heights.sort_by(f64::total_cmp);
    let expected = [90.0, 50.0, 5.0].map(|y| drawn.place((0.0, y)).1);
    assert_eq!(heights.len(), 3);
    assert!(
        heights.iter().zip(expected).all(|(height, expected)| (height - expected).abs() <= 1.5)
    );
    assert!(drawn.texts().any(|text| text.text == "runs: median, 5 to 90 %"));
}

#[test]
fn quantiles_between_two_runs_are_interpolated() {
    let runs = [vec![0.0, 0.0], vec![8.0, 8.0]];
    let figure = Figure::over_time("y").y_range(0.0..8.0);
    let drawn = Drawn::of(&figure.spread("runs", &[0.0, 1.0], &runs, [0.25, 0.75]).unwrap());
    for y in [2.0, 4.0, 6.0] {
        let place = drawn.place((0.0, y)).1;
        assert!(drawn.lines(BLUE_HEX).iter().any(|line| (line[0].1 - place).abs() <= 1.5));
    }
}

#[test]
fn a_metre_is_as_long_up_as_across() {
    for points in [[(0.0, 0.0), (9.0, 3.0)], [(0.0, 0.0), (0.5, 20.0)], [(-30.0, 1.0), (30.0, 1.1)]]
    {
        let drawn = Drawn::of(&Figure::in_plane().line(Line::new("", points)));
        let origin = drawn.place((0.0, 0.0));
        let across = drawn.place((1.0, 0.0)).0 - origin.0;
        let up = origin.1 - drawn.place((0.0, 1.0)).1;
        assert!((across / up - 1.0).abs() < 0.02, "{across} across, {up} up");
        for point in points {
            let [(left, top), (right, bottom)] = drawn.frame();
            let (x, y) = drawn.place(point);
            assert!(left <= x && x <= right && top <= y && y <= bottom);
        }
    }
}

#[test]
fn a_path_is_marked_where_it_starts_and_ends() {
    let path = Line::new("robot", [(f64::NAN, 0.0), (1.0, 2.0), (3.0, 1.0), (5.0, 2.5)]);
    let drawn = Drawn::of(&Figure::in_plane().path(path.stroke(Stroke::new(BLUE, Dash::Solid))));
    let centres: Vec<_> =
        drawn.all("circle").map(|circle| (circle.number("cx"), circle.number("cy"))).collect();
    for point in [(1.0, 2.0), (5.0, 2.5)] {
        assert!(centres.iter().any(|centre| close(*centre, drawn.place(point))));
    }
    for name in ["start", "end"] {
        assert_eq!(drawn.texts().filter(|text| text.text == name).count(), 1);
    }
}

#[test]
fn arrows_point_along_the_field() {
    let field = |x: f64, y: f64| (-y, 3.0 * x);
    let drawn = Drawn::of(&Figure::phase_plane("x", "y").field(-2.0..2.0, -1.0..1.0, field));
    let [origin, x, y] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|point| drawn.place(point));
    let mut arrows = 0;
    for head in drawn.all("polygon").map(|polygon| polygon.points()) {
        let foot = ((head[1].0 + head[2].0) / 2.0, (head[1].1 + head[2].1) / 2.0);
        let at = |(px, py): Point| {
            ((px - origin.0) / (x.0 - origin.0), (py - origin.1) / (y.1 - origin.1))
        };
        let (tip, foot) = (at(head[0]), at(foot));
        // The middle of the arrow is where the field was asked for: 0.325 of its length behind the foot of the head.
        let middle =
            (foot.0 - (tip.0 - foot.0) * 0.15 / 0.35, foot.1 - (tip.1 - foot.1) * 0.15 / 0.35);
        let (dx, dy) = field(middle.0, middle.1);
        let (ex, ey) = (tip.0 - foot.0, tip.1 - foot.1);
        let sine = (dx * ey - dy * ex) / dx.hypot(dy) / ex.hypot(ey);
        if dx.hypot(dy) > 0.3 {
            assert!(sine.abs() < 0.15 && dx * ex + dy * ey > 0.0, "at {middle:?}: {ex}, {ey}");
            arrows += 1;
        }
    }
    assert!(arrows > 200);
}

#[test]
fn memberships_peak_at_their_centres() {
    let gaussian = |centre, width| Gaussian::new(centre, width).unwrap();
    let before = FuzzyNetwork::new([[gaussian(-1.0, 0.5), gaussian(1.0, 0.5)]]);
    let after = FuzzyNetwork::new([[gaussian(-0.2, 0.01), gaussian(0.5, 1.0)]]);
    let drawn = Drawn::of(&Figure::memberships("e in m", &before, &after, 0).unwrap());
    let line = |width: &str| {
        let lines = drawn
            .all("polyline")
            .filter(|line| line.get("stroke") == BLUE_HEX && line.get("stroke-width") == width);
        lines.flat_map(|line| line.points()).min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    };
    assert!(close(line("16"), drawn.place((-0.2, 1.0))), "the narrow one is not missed");
    assert!((line("11").1 - drawn.place((0.0, 1.0)).1).abs() <= 3.0);
    let refused = Figure::memberships("e", &before, &after, 1).unwrap_err();
    assert_eq!(refused.to_string(), "input = 1 must be less than 1");
}

#[test]
fn shares_are_means_over_the_window() {
    // |u_b| = 1 and |u_n| = 3: three quarters are learned, whatever the signs.
    let samples = (0..200).map(|k| {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        (0.01 * f64::from(k), sign, -3.0 * sign)
    });
    let [_, part] = Figure::shares("m/s²", samples, 0.1).unwrap();
    let drawn = Drawn::of(&part);
    let level = drawn.place((0.0, 75.0)).1;
    let line = drawn.lines(BLUE_HEX).into_iter().flatten();
    let [_, (_, bottom)] = drawn.frame();
    assert!(line.clone().count() >= 2);
    assert!(
        line.clone().all(|point| (point.1 - level).abs() <= 1.5 || (point.1 - bottom).abs() <= 1.5)
    );
    assert!(line.clone().any(|point| (point.1 - level).abs() <= 1.5));
}

#[test]
fn the_map_goes_from_the_first_colour_to_the_last() {
    let (xs, ys) = ([0.0, 1.0, 2.0], [0.0, 10.0]);
    let labels = ["x", "y", "z"];
    let map = Figure::heat_map(labels, &xs, &ys, |x, y| x + y).unwrap();
    for (map, ends) in [
        (
            map.clone(),
            [colorous::CIVIDIS.eval_continuous(0.0), colorous::CIVIDIS.eval_continuous(1.0)],
        ),
        (
            map.colour_map(ColourMap::Viridis),
            [colorous::VIRIDIS.eval_continuous(0.0), colorous::VIRIDIS.eval_continuous(1.0)],
        ),
    ] {
        let drawn = Drawn::of(&map);
        let cells: Vec<_> = drawn.all("rect").collect();
        let painted = |point| {
            // What is painted last is seen.
            let (x, y) = drawn.place(point);
            let cell = cells.iter().rev().find(|cell| {
                let (left, top) = (cell.number("x"), cell.number("y"));
                left <= x
                    && x <= left + cell.number("width")
                    && top <= y
                    && y <= top + cell.number("height")
            });
            cell.unwrap().get("fill").to_owned()
        };
        assert_eq!(painted((0.0, 0.0)), format!("#{:X}", ends[0]));
        assert_eq!(painted((2.0, 10.0)), format!("#{:X}", ends[1]));
    }
}

#[test]
fn cells_without_a_value_are_grey_and_named() {
    let value = |x: f64, _: f64| if x > 1.5 { f64::NAN } else { x };
    let map = Figure::heat_map(["x", "y", "z"], &[0.0, 1.0, 2.0], &[0.0, 1.0], value).unwrap();
    let drawn = Drawn::of(&map.clone().undefined("diverged"));
    assert!(drawn.texts().any(|text| text.text == "diverged"));
    assert!(drawn.all("rect").filter(|cell| cell.get("fill") == "#C8C8C8").count() >= 3);
    let whole = Figure::heat_map(["x", "y", "z"], &[0.0, 1.0], &[0.0, 1.0], |x, y| x + y).unwrap();
    let drawn = Drawn::of(&whole.undefined("diverged"));
    assert!(!drawn.texts().any(|text| text.text == "diverged"));
}
