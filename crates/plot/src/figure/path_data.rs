//! Paths as text: relative steps in tenths, each written in as few characters as it can be.

use super::path::Point;
use super::svg::{Svg, tenths, tenths_text};

/// A place on the canvas or a step on it, in tenths.
type Tenths = (i64, i64);

/// Path data of a line.
pub(crate) fn line_data(points: &[Point]) -> String {
    data(points, &short_tenths, false)
}

/// Path data of a closed outline.
pub(crate) fn outline_data(points: &[Point]) -> String {
    data(points, &short_tenths, true)
}

/// Path data of a closed outline in whole tenths, for use inside `scale(.1)`.
pub(crate) fn outline_data_in_tenths(points: &[Point]) -> String {
    data(points, &|tenths| tenths.to_string(), true)
}

/// Path data of a curve that leaves its start and reaches its end level.
pub(crate) fn level_curve_data(from: Point, to: Point) -> String {
    let [start, end] = [from, to].map(in_tenths);
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    let middle = tenths((from.0 + to.0) / 2.0) - start.0;
    let numbers = [middle, 0, middle, dy, dx, dy];
    format!("M{}c{}", joined(&[start.0, start.1], &short_tenths), joined(&numbers, &short_tenths))
}

/// Path data of separate lines that lie or stand: each is drawn from the end to which the pen gets in fewer characters.
pub(crate) fn rules_data(rules: &[(Point, Point)]) -> String {
    let mut data = String::new();
    let mut pen = None;
    for &(one, other) in rules {
        let ends = [one, other].map(in_tenths);
        let ways = [(ends[0], ends[1]), (ends[1], ends[0])];
        let texts = ways.map(|(from, to)| move_to(pen, from) + &rule_to(from, to));
        let way = usize::from(texts[1].len() < texts[0].len());
        data += &texts[way];
        pen = Some(ways[way].1);
    }
    data
}

impl Svg {
    /// Upright and lying lines, all in one path.
    pub fn rules(&mut self, rules: &[(Point, Point)]) {
        let data = rules_data(rules);
        if !data.is_empty() {
            self.leaf("path", &[("d", &data)]);
        }
    }
}

fn move_to(pen: Option<Tenths>, (x, y): Tenths) -> String {
    let absolute = format!("M{}", joined(&[x, y], &short_tenths));
    let relative = pen.map(|pen| format!("m{}", joined(&[x - pen.0, y - pen.1], &short_tenths)));
    relative.filter(|relative| relative.len() < absolute.len()).unwrap_or(absolute)
}

fn rule_to(from: Tenths, to: Tenths) -> String {
    let [absolute, relative] = if from.1 == to.1 {
        [format!("H{}", short_tenths(to.0)), format!("h{}", short_tenths(to.0 - from.0))]
    } else {
        [format!("V{}", short_tenths(to.1)), format!("v{}", short_tenths(to.1 - from.1))]
    };
    if relative.len() < absolute.len() { relative } else { absolute }
}

fn in_tenths((x, y): Point) -> Tenths {
    (tenths(x), tenths(y))
}

/// Tenths without the zero before the point, which paths do not need.
fn short_tenths(tenths: i64) -> String {
    let text = tenths_text(tenths);
    match text.strip_prefix("0.").map(|rest| ("", rest)).or(text.strip_prefix("-0.").map(|rest| ("-", rest)))
    {
        Some((sign, rest)) => format!("{sign}.{rest}"),
        None => text,
    }
}

/// Numbers one after the other: a minus sign separates them as well as a space does.
fn joined(numbers: &[i64], text: &dyn Fn(i64) -> String) -> String {
    let texts = numbers.iter().map(|&number| text(number));
    texts.reduce(|before, text| append(before, &text)).unwrap_or_default()
}

fn append(before: String, text: &str) -> String {
    before + if text.starts_with('-') { "" } else { " " } + text
}

fn data(points: &[Point], text: &dyn Fn(i64) -> String, closed: bool) -> String {
    let mut places: Vec<Tenths> = points.iter().copied().map(in_tenths).collect();
    places.dedup();
    if closed && places.first() == places.last() {
        // The end of the outline draws this step.
        places.pop();
    }
    let Some(&(x, y)) = places.first().filter(|_| places.len() > 1) else { return String::new() };
    let mut data = format!("M{}", joined(&[x, y], text));
    let mut before = ' ';
    for (dx, dy) in steps(&places) {
        let (command, numbers) = match (dx, dy) {
            (dx, 0) => ('h', vec![dx]),
            (0, dy) => ('v', vec![dy]),
            both => ('l', vec![both.0, both.1]),
        };
        let numbers = joined(&numbers, text);
        if command == before {
            data = append(data, &numbers);
        } else {
            data.push(command);
            data += &numbers;
        }
        before = command;
    }
    if closed {
        data.push('z');
    }
    data
}

/// The steps from place to place, those that go on in the same direction as one.
fn steps(places: &[Tenths]) -> Vec<Tenths> {
    let mut steps: Vec<Tenths> = Vec::new();
    for pair in places.windows(2) {
        let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
        match steps.last_mut() {
            Some(last) if last.0 * dy == last.1 * dx && last.0 * dx + last.1 * dy > 0 => {
                *last = (last.0 + dx, last.1 + dy);
            }
            _ => steps.push((dx, dy)),
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn path_data_is_relative_and_short() {
        assert_eq!(line_data(&[(1.0, 2.0), (1.26, 1.0), (1.3, 1.0), (3.0, 4.5)]), "M1 2l.3-1 1.7 3.5");
        assert_eq!(line_data(&[(-1.0, -2.0), (1.0, -2.0), (0.5, -2.0), (0.5, 3.0)]), "M-1-2h2-.5v5");
        assert_eq!(outline_data_in_tenths(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]), "M0 0h10v10z");
        assert_eq!(line_data(&[(1.0, 1.0)]), "");
    }

    #[test]
    fn an_outline_is_the_same_with_and_without_its_first_point_at_the_end() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
        assert_eq!(outline_data(&square), "M0 0h1v1h-1z");
        assert_eq!(outline_data(&square[..4]), "M0 0h1v1h-1z");
        assert_eq!(outline_data(&[(1.0, 1.0), (1.0, 1.0)]), "");
    }

    #[test]
    fn steps_in_one_direction_become_one_and_turns_back_stay() {
        assert_eq!(line_data(&[(0.0, 0.0), (1.0, 2.0), (2.0, 4.0), (1.0, 2.0)]), "M0 0l2 4-1-2");
    }

    #[test]
    fn a_comb_is_drawn_to_and_fro() {
        let tooth = |x: f64, length: f64| ((x, 434.0), (x, 434.0 + length));
        let comb = rules_data(&[tooth(80.0, 6.0), tooth(107.2, 3.5), tooth(123.1, 3.5), tooth(200.0, 6.0)]);
        assert_eq!(comb, "M80 434v6m27.2-6v3.5m15.9 0V434m76.9 0v6");
        assert_eq!(
            rules_data(&[((66.0, 10.0), (302.0, 10.0)), ((66.0, 40.0), (302.0, 40.0))]),
            "M66 10H302m0 30H66"
        );
        assert_eq!(rules_data(&[]), "");
    }

    #[test]
    fn a_level_curve_has_its_middle_half_way() {
        assert_eq!(level_curve_data((70.0, 384.0), (88.4, 350.0)), "M70 384c9.2 0 9.2-34 18.4-34");
    }
}
