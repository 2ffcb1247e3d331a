//! Reads the SVG text of figures.

use std::collections::BTreeMap;

use brunovsky::plot::Draw;

pub type Point = (f64, f64);

/// An element of an SVG file: its name, its attributes, the text after it.
pub struct Element {
    pub name: String,
    attributes: BTreeMap<String, String>,
    pub text: String,
}

impl Element {
    pub fn get(&self, key: &str) -> &str {
        self.attributes.get(key).map_or("", String::as_str)
    }

    pub fn number(&self, key: &str) -> f64 {
        self.get(key).parse().unwrap()
    }

    pub fn points(&self) -> Vec<Point> {
        let pair = |pair: &str| {
            let (x, y) = pair.split_once(',').unwrap();
            (x.parse().unwrap(), y.parse().unwrap())
        };
        self.get("points").split_whitespace().map(pair).collect()
    }
}

/// A drawn figure.
pub struct Drawn {
    elements: Vec<Element>,
}

impl Drawn {
    pub fn of(figure: &(impl Draw + ?Sized)) -> Self {
        let svg = figure.svg().unwrap();
        let elements = svg.split('<').filter(|part| !part.is_empty() && !part.starts_with('/'));
        Self { elements: elements.map(element).collect() }
    }

    pub fn all(&self, name: &str) -> impl Iterator<Item = &Element> {
        self.elements.iter().filter(move |element| element.name == name)
    }

    pub fn texts(&self) -> impl Iterator<Item = &Element> {
        self.all("text")
    }

    /// The lines of one colour, without the samples of the legend above the frame.
    pub fn lines(&self, colour: &str) -> Vec<Vec<Point>> {
        let (_, top) = self.frame()[0];
        self.all("polyline")
            .filter(|line| line.get("stroke") == colour)
            .map(Element::points)
            .filter(|points| points.iter().all(|point| point.1 >= top))
            .collect()
    }

    /// The upper left and the lower right corner of the axes.
    pub fn frame(&self) -> [Point; 2] {
        let mut lines = self.all("polyline").map(Element::points);
        let frame = lines.find(|line| is_frame(line)).unwrap();
        [frame[0], frame[2]]
    }

    /// The ticks below the frame, as value and place.
    pub fn x_ticks(&self) -> Vec<Point> {
        let [_, (_, bottom)] = self.frame();
        let ticks = self.texts().filter(|text| {
            text.get("text-anchor") == "middle"
                && text.get("transform").is_empty()
                && text.number("y") > bottom
        });
        ticks.filter_map(|tick| Some((value(&tick.text)?, tick.number("x")))).collect()
    }

    /// The ticks left of the frame.
    pub fn y_ticks(&self) -> Vec<Point> {
        let [(left, _), _] = self.frame();
        // A label stands lower than its tick by as much as every other.
        let marks = self.all("polyline").map(Element::points).filter(|mark| {
            let &[from, to] = mark.as_slice() else { return false };
            to.0 == left && from.0 < left && from.1 == to.1
        });
        let labels = self
            .texts()
            .filter(|text| text.get("text-anchor") == "end" && text.number("x") < left)
            .filter_map(|text| value(&text.text));
        labels.zip(marks.map(|mark| mark[0].1)).collect()
    }

    /// Where a point of the figure must be, by the ticks alone.
    pub fn place(&self, (x, y): Point) -> Point {
        (along(&self.x_ticks(), x), along(&self.y_ticks(), y))
    }
}

/// Whether a line is a rectangle.
pub fn is_frame(line: &[Point]) -> bool {
    line.len() == 5 && line[0] == line[4]
}

/// The line through the first and the last tick.
fn along(ticks: &[Point], value: f64) -> f64 {
    let (first, last) = (ticks[0], ticks[ticks.len() - 1]);
    first.1 + (value - first.0) / (last.0 - first.0) * (last.1 - first.1)
}

pub fn value(text: &str) -> Option<f64> {
    text.replace('−', "-").parse().ok()
}

/// Places are rounded to a tenth of a pixel, which is the unit of the file, and lines are simplified by less than that.
pub fn close(a: Point, b: Point) -> bool {
    (a.0 - b.0).abs() <= 1.5 && (a.1 - b.1).abs() <= 1.5
}

fn element(part: &str) -> Element {
    let (tag, text) = part.split_once('>').unwrap();
    let tag = tag.trim_end_matches('/');
    let (name, mut rest) = tag.split_once(' ').unwrap_or((tag, ""));
    let mut attributes = BTreeMap::new();
    while let Some((key, after)) = rest.split_once("=\"") {
        let (value, after) = after.split_once('"').unwrap();
        attributes.insert(key.trim().to_owned(), value.to_owned());
        rest = after;
    }
    Element { name: name.to_owned(), attributes, text: text.trim().to_owned() }
}
