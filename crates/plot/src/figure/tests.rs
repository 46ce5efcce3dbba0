//! All kinds of figures as a whole: names, sizes, hostile words, impossible values.

use super::sample::*;
use super::*;

#[test]
fn a_fine_map_stays_small() {
    let size = heat_map(160).svg().len();
    assert!(size < 150_000, "{size}");
    let size = zone_map(240).svg().len();
    assert!(size < 100_000, "{size}");
}

#[test]
fn every_figure_is_well_named_and_has_no_bad_number() {
    let figures = [
        heat_map(24).svg(),
        frequency_chart().svg(),
        error_chart().svg(),
        frequency_chart().svg_with(Some(&inset())),
        zone_map(24).svg(),
        zone_map(24).svg_beside(&zone_map(24), ["one", "other"], None),
        range_chart().svg(),
    ];
    for svg in figures {
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" role=\"img\""));
        assert!(svg.contains("<title id=") && svg.contains("<desc id="));
        assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{svg}");
        assert!(!svg.contains(" style=") && !svg.contains("<style"), "inline style");
        // A figure refers to paths of its own and to nothing else.
        assert_eq!(svg.matches("href").count(), svg.matches(" href=\"#").count());
    }
}

#[test]
fn hostile_words_stay_words_in_every_place() {
    let hostile = "</text><script>alert(1)</script><a href=\"javascript:x\">";
    let mut map = heat_map(8);
    map.x.title = hostile.into();
    map.colours.title = hostile.into();
    map.zero_label = hostile.into();
    map.colours.contour_label = hostile.into();
    map.lines[0].label = hostile.into();
    map.marks[0].label = hostile.into();
    let mut chart = frequency_chart();
    chart.series[0].label = hostile.into();
    chart.references[0] = Reference::Horizontal { at: 1.0, label: hostile.into() };
    chart.references.push(Reference::Band { from: 1.0, to: 2.0, label: hostile.into() });
    let mut zones = zone_map(8);
    zones.zones[0].label = hostile.into();
    zones.labels[0].lines = vec![hostile.into()];
    let mut ranges = range_chart();
    ranges.rows[0].label = hostile.into();
    ranges.rows[0].detail = hostile.into();
    ranges.levels[0] = hostile.into();
    let mut inset = inset();
    inset.x.title = hostile.into();
    for svg in [
        map.svg(),
        chart.svg_with(Some(&inset)),
        zones.svg(),
        zones.svg_beside(&zones, [hostile; 2], None),
        ranges.svg(),
    ] {
        assert!(!svg.contains("<script") && !svg.contains("<a "), "{svg}");
        assert!(svg.contains("&lt;script&gt;"));
    }
}

#[test]
fn impossible_values_leave_gaps_and_no_nonsense() {
    let mut chart = frequency_chart();
    chart.series[0].points = vec![(f64::NAN, 1.0), (1e-3, -1.0), (0.0, 0.0), (f64::INFINITY, 1.0)];
    chart.references.push(Reference::Vertical { at: f64::NAN, label: "x".into() });
    let mut map = heat_map(8);
    map.values[3] = f64::NAN;
    map.values[4] = f64::INFINITY;
    map.values[5] = -1.0;
    map.zero_areas.clear();
    for svg in [chart.svg(), map.svg()] {
        assert!(!svg.contains("NaN") && !svg.contains("1000000"), "{svg}");
    }
}

#[test]
fn figures_are_written_for_looking_at() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/sample-figures");
    std::fs::create_dir_all(&folder).unwrap();
    let figures = [
        ("fig-1", heat_map(160).svg()),
        ("fig-2", frequency_chart().svg()),
        ("error", error_chart().svg()),
        ("fig-7a", zone_map(240).svg()),
        ("good-enough", range_chart().svg()),
    ];
    for (name, svg) in figures {
        std::fs::write(folder.join(name).with_extension("svg"), svg).unwrap();
    }
}

#[test]
fn points_have_markers_and_no_line() {
    let line_of = |series: Series| {
        let mut chart = frequency_chart();
        (chart.references, chart.series) = (Vec::new(), vec![series]);
        chart.svg()
    };
    let points = vec![(1e-5, 1.0), (1e-4, 10.0)];
    let (joined, alone) =
        (line_of(Series::marked("x", points.clone())), line_of(Series::points("x", points)));
    let circles = |svg: &str| svg.matches("<circle").count();
    assert_eq!(circles(&joined), circles(&alone));
    let lines = |svg: &str| svg.matches("stroke-width=\"2.2\"").count();
    assert_eq!((lines(&joined), lines(&alone)), (2, 0));
}

#[test]
fn contours_divide_the_brightest_colour() {
    let mut map = heat_map(24);
    let contour = |svg: &str| svg.contains("80 and 95 /s") && svg.contains("stroke-width=\"10\"");
    assert!(contour(&map.svg()));
    map.colours.contours.clear();
    map.colours.contour_label.clear();
    assert!(!contour(&map.svg()));
}
