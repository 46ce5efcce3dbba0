//! Charts that files describe: their numbers are put in here.

use std::sync::LazyLock;

use serde::de::DeserializeOwned;

use slipmode_plot::figure::{Axis, LineChart, Scale};

/// The picture of a command as `pictures.toml` describes it, still without numbers.
pub(crate) fn picture<T: DeserializeOwned + Default>(id: &str) -> T {
    static DESCRIBED: LazyLock<toml::Table> =
        LazyLock::new(|| toml::from_str(include_str!("pictures.toml")).unwrap_or_default());
    DESCRIBED.get(id).and_then(|one| one.clone().try_into().ok()).unwrap_or_default()
}

/// The chart with the points of its series, in their order; an axis without ends takes those of the points.
pub(crate) fn with_points(
    mut chart: LineChart,
    lines: impl IntoIterator<Item = Vec<(f64, f64)>>,
) -> Option<LineChart> {
    chart.series.iter_mut().zip(lines).for_each(|(series, points)| series.points = points);
    let points = || chart.series.iter().flat_map(|series| &series.points);
    let x = over(&chart.x, points().map(|point| point.0))?;
    let y = over(&chart.y, points().map(|point| point.1))?;
    Some(LineChart { x, y, ..chart })
}

/// The axis. One without ends takes those of the values, a linear one with a twentieth of room on either side.
pub(crate) fn over(axis: &Axis, values: impl IntoIterator<Item = f64>) -> Option<Axis> {
    if axis.min < axis.max {
        return Some(axis.clone());
    }
    let (min, max) = extent(values)?;
    let room = match axis.scale {
        Scale::Linear if max > min => 0.05 * (max - min),
        Scale::Linear => 0.5,
        _ => 0.0,
    };
    Some(Axis { min: min - room, max: max + room, ..axis.clone() })
}

/// The least and the largest of some values.
pub(crate) fn extent(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    let wider = |(least, most): (f64, f64), (low, high): (f64, f64)| (least.min(low), most.max(high));
    values.into_iter().filter(|value| value.is_finite()).map(|value| (value, value)).reduce(wider)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_plot::figure::{Panels, ZoneMap};

    #[test]
    fn every_picture_is_described() {
        assert_eq!(picture::<ZoneMap>("boundary").zones.len(), 1);
        assert_eq!(picture::<ZoneMap>("slip-modes").caption.title, "Slip modes");
        assert_eq!(["trajectory", "fit-peaks"].map(|id| picture::<Panels>(id).panels.len()), [3, 2]);
        assert_eq!(picture::<LineChart>("differences").references.len(), 1);
        assert_eq!(picture::<LineChart>("late-cycle").series.len(), 2);
    }

    #[test]
    fn an_axis_without_ends_takes_those_of_the_values() {
        let ends = |axis: Axis| over(&axis, [3.0, f64::NAN, 1.0]).map(|axis| (axis.min, axis.max));
        assert_eq!(ends(Axis::linear("x", "", 0.0, 0.0)), Some((0.9, 3.1)));
        assert_eq!(ends(Axis::log10("x", "", 0.0, 0.0)), Some((1.0, 3.0)));
        assert_eq!(ends(Axis::linear("x", "", 0.0, 2.0)), Some((0.0, 2.0)));
        assert_eq!(over(&Axis::default(), [2.0]).map(|axis| (axis.min, axis.max)), Some((1.5, 2.5)));
        assert_eq!(over(&Axis::default(), [f64::INFINITY]), None);
    }

    #[test]
    fn points_go_to_the_series_in_their_order() {
        let chart = with_points(picture("late-cycle"), [vec![(0.0, 1.0)], vec![(2.0, 1e3)]]).unwrap();
        assert_eq!(chart.series[1].points, [(2.0, 1e3)]);
        assert_eq!((chart.x.min, chart.x.max, chart.y.min, chart.y.max), (-0.1, 2.1, 1.0, 1e3));
    }
}
