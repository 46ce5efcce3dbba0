//! The figure of a fit of peak velocities: the peaks with both laws, and their residuals.

use crate::experiments::described::{extent, over, picture};
use crate::fitting::{PeakFits, PeakRow};
use slipmode_plot::figure::{Axis, Panels, Series};

/// The peaks over the load velocity with the fitted laws and, for the better law, the ends of its interval from the noise.
pub(crate) fn peak_picture(rows: &[PeakRow], fits: &PeakFits) -> String {
    let loads = || rows.iter().map(|row| row.load_m_per_s);
    let (first, last) = extent(loads()).unwrap_or((1e-6, 1.0));
    let is_one_stress = rows.iter().all(|row| row.stress == 1.0);
    let over_load = |values: &mut dyn Iterator<Item = f64>| {
        let mut points: Vec<(f64, f64)> = loads().zip(values).collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        points
    };
    // Under several normal stresses neighbours along the axis are not on one curve.
    let curve = |label: String, values: &[f64]| {
        let points = over_load(&mut values.iter().copied());
        if is_one_stress { Series::line(label, points) } else { Series::points(label, points) }
    };
    let measured = |values: &mut dyn Iterator<Item = f64>| Series::points("measured", over_load(values));
    let mut series = vec![measured(&mut rows.iter().map(|row| row.peak_m_per_s))];
    for (index, fit) in fits.laws.iter().enumerate() {
        series.push(curve(format!("{} law", fit.law.as_str()), &fit.peaks_m_per_s));
        let ends = fit.band_m_per_s.iter().zip(["lower", "upper"]).filter(|_| index == 0);
        series.extend(ends.filter(|(end, _)| !end.is_empty()).map(|(end, side)| Series {
            theory: true,
            ..curve(format!("{} law, {side} end of the interval", fit.law.as_str()), end)
        }));
    }
    let best = fits.laws.first().map_or(&[][..], |fit| &fit.peaks_m_per_s);
    let residuals: Vec<f64> =
        rows.iter().zip(best).map(|(row, peak)| 100.0 * (row.peak_m_per_s / peak - 1.0)).collect();
    let values = series.iter().flat_map(|series| &series.points).map(|point| point.1);
    let heights: Vec<f64> = values.collect();
    let below = residuals.iter().copied().chain([0.0]).collect();
    let residuals = vec![measured(&mut residuals.into_iter())];
    let mut panels: Panels = picture("fit-peaks");
    for (panel, (values, series)) in panels.panels.iter_mut().zip([(heights, series), (below, residuals)]) {
        (panel.x.min, panel.x.max) = (first / 1.2, last * 1.2);
        panel.y = over(&panel.y, values).unwrap_or_else(|| Axis { max: 1.0, ..panel.y.clone() });
        panel.series = series;
    }
    panels.svg()
}
