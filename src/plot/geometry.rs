//! Polylines: what of them lies in a rectangle, and how they are broken into dashes.

use std::ops::Range;

pub(super) type Point = (f64, f64);

/// The pieces of the polyline inside the rectangle `x` × `y`; points that are not finite break it.
pub(super) fn clipped(points: &[Point], x: &Range<f64>, y: &Range<f64>) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let &[from, to] = pair else { continue };
        let Some((from, to)) = inside(from, to, x, y) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// The part of a segment inside the rectangle (Y.-D. Liang, B. A. Barsky, 1984).
fn inside(from: Point, to: Point, x: &Range<f64>, y: &Range<f64>) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    if !(dx.is_finite() && dy.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let edges = [
        (-dx, from.0 - x.start),
        (dx, x.end - from.0),
        (-dy, from.1 - y.start),
        (dy, y.end - from.1),
    ];
    for (towards, room) in edges {
        if towards < 0.0 {
            enter = enter.max(room / towards);
        } else if towards > 0.0 {
            leave = leave.min(room / towards);
        } else if room < 0.0 {
            return None;
        }
    }
    // The ends themselves are kept to the last bit, so that neighbouring pieces meet.
    let at = |part: f64| (from.0 + part * dx, from.1 + part * dy);
    let start = if enter == 0.0 { from } else { at(enter) };
    let end = if leave == 1.0 { to } else { at(leave) };
    (enter <= leave).then_some((start, end))
}

/// The strokes of a polyline under a `pattern` of lengths, drawn and left out in turn.
pub(super) fn dashes(points: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    let Some(first) = points.first() else { return Vec::new() };
    let mut lengths = pattern.iter().copied().cycle();
    let Some(mut left) = lengths.next() else { return vec![points.to_vec()] };
    let mut strokes = Vec::new();
    let (mut stroke, mut drawn, mut at) = (vec![*first], true, *first);
    for to in points.iter().skip(1) {
        let mut way = (to.0 - at.0).hypot(to.1 - at.1);
        while way > left {
            let part = left / way;
            at = (at.0 + part * (to.0 - at.0), at.1 + part * (to.1 - at.1));
            way -= left;
            if drawn {
                stroke.push(at);
                strokes.push(std::mem::take(&mut stroke));
            } else {
                stroke = vec![at];
            }
            drawn = !drawn;
            left = lengths.next().unwrap_or(f64::INFINITY);
        }
        left -= way;
        at = *to;
        if drawn {
            stroke.push(at);
        }
    }
    if stroke.len() > 1 {
        strokes.push(stroke);
    }
    strokes
}

/// The polyline without the points that lie within `tolerance` of the line through those that are kept (U. Ramer, 1972; D. Douglas,
/// T. Peucker, 1973).
pub(super) fn simplified(points: &[Point], tolerance: f64) -> Vec<Point> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut kept = vec![false; points.len()];
    let mut spans = vec![(0, last)];
    while let Some((from, to)) = spans.pop() {
        let (Some(a), Some(b)) = (points.get(from), points.get(to)) else { continue };
        for end in [from, to] {
            if let Some(kept) = kept.get_mut(end) {
                *kept = true;
            }
        }
        let between = points.iter().enumerate().take(to).skip(from + 1);
        let farthest = between
            .map(|(i, point)| (i, distance(*point, *a, *b)))
            .max_by(|one, other| one.1.total_cmp(&other.1));
        if let Some((i, off)) = farthest
            && off > tolerance
        {
            spans.extend([(from, i), (i, to)]);
        }
    }
    points.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// The distance of a point from the segment between `a` and `b`.
fn distance(point: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let squared = dx * dx + dy * dy;
    let along = (point.0 - a.0) * dx + (point.1 - a.1) * dy;
    let part = if squared > 0.0 { (along / squared).clamp(0.0, 1.0) } else { 0.0 };
    (a.0 + part * dx - point.0).hypot(a.1 + part * dy - point.1)
}
