//! Sweeps as users write them, and the ways to get one wrong.

use super::*;
use crate::scene::document::read_document;
use crate::scene::quantity::read_parameters;
use crate::scene::{Limits, Uncertain};

const SLIDER: &str = "[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";
const AXES: &str = "normal_stress_pa = { from = 1e3, to = 1e6, points = 50 }\n\
    loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 40, spacing = \"linear\" }\n";

fn parse(text: &str) -> Result<SweepSection, Vec<String>> {
    let read = |top: &mut Section<'_>| {
        let parameters = top.optionally("parameters", |entry| entry.table(read_parameters)?);
        top.optionally("sweep", |entry| SweepSection::read(entry, Some(parameters.as_ref())))
    };
    read_document("s.toml", text.as_bytes(), Limits::default(), read)
        .map_err(|faults| faults.iter().map(ToString::to_string).collect())
}

#[test]
fn a_grid_takes_what_it_does_not_state_from_the_parameters() {
    let sweep = parse(&format!("{SLIDER}[sweep]\nwork = \"classify\"\n[sweep.grid]\n{AXES}")).unwrap();
    assert_eq!((sweep.work, sweep.block_points), (SweepWork::Classify, 1 << 18));
    let SweepPoints::Grid(coordinates) = sweep.points else { panic!("a grid") };
    assert_eq!(coordinates[0], Coordinate::Fixed(Uncertain::certain(Rational::from((1, 250)))));
    assert_eq!(coordinates.iter().map(Coordinate::points).product::<u64>(), 2000);
    assert!(matches!(&coordinates[6], Coordinate::Axis { span, .. } if span.spacing == Spacing::Linear));
}

#[test]
fn samples_lists_and_simulations_are_read() {
    let samples = parse(&format!(
        "{SLIDER}[sweep]\nwork = \"simulate\"\nlaws = [\"slip\", \"aging\"]\ntolerance = 1e-6\nblock_points = 10\n\
         [sweep.samples]\ncount = 1000000000\nnormal_stress_pa = 1e5\n\
         loading_velocity_m_per_s = {{ from = 1e-6, to = 1e-1 }}\n"
    ))
    .unwrap();
    assert_eq!(samples.block_points, 10);
    assert!(matches!(samples.points, SweepPoints::Samples { count: 1_000_000_000, .. }));
    let list = parse("[sweep]\nwork = \"boundary\"\n[sweep.list]\nfile = \"points.csv\"\n").unwrap();
    assert_eq!(list.points, SweepPoints::List { file: "points.csv".into() });
}

#[test]
fn all_faults_come_at_once() {
    let messages = parse(
        "[sweep]\nwork = \"simulat\"\nblock_points = 0\n[sweep.grid]\nnormal_stress_pa = { from = 2, to = 1, points = 1 }\n\
         stiffness_pa_per_m = -1\nmas = 3\n",
    )
    .unwrap_err();
    for part in [
        "sweep.work = \"simulat\": unknown; did you mean `simulate`?",
        "sweep.block_points = 0: out of range",
        "sweep.grid.normal_stress_pa: reversed range",
        "sweep.grid.normal_stress_pa.points = 1: out of range",
        "sweep.grid.stiffness_pa_per_m = -1: must be > 0",
        "sweep.grid.direct_effect: missing",
        "sweep.grid.loading_velocity_m_per_s: missing",
        "sweep.grid.mas: unknown key",
    ] {
        assert!(messages.iter().any(|message| message.contains(part)), "{part}\nis not in\n{messages:#?}");
    }
}

#[test]
fn points_have_one_source_and_an_end() {
    let none = parse("[sweep]\nwork = \"classify\"\n").unwrap_err();
    assert!(none[0].contains("exactly one of [sweep.grid], [sweep.samples] and [sweep.list]"), "{none:?}");
    let large = "{ from = 1, to = 2, points = 1000000 }";
    let huge = parse(&format!(
        "{SLIDER}[sweep]\nwork = \"classify\"\n[sweep.grid]\nnormal_stress_pa = {large}\n\
         loading_velocity_m_per_s = {large}\nstiffness_pa_per_m = {large}\n"
    ))
    .unwrap_err();
    assert!(huge[0].contains("at most 1000000000000 points in all"), "{huge:?}");
    let laws = parse(
        "[sweep]\nwork = \"simulate\"\ntolerance = 1e-6\nlaws = [\"slip\", \"aging\"]\n[sweep.list]\nfile = \"p.csv\"\n",
    )
    .unwrap_err();
    assert!(laws[0].contains("one law for a list"), "{laws:?}");
}

#[test]
fn a_summary_says_what_is_kept_of_rows() {
    let text = format!(
        "{SLIDER}[sweep]\nwork = \"asymptote-error\"\n[sweep.grid]\n{AXES}[sweep.summary]\nby = [\"arc\"]\n\
         [[sweep.summary.bins]]\ncolumn = \"normal_stress_pa\"\nfrom = 1e3\nto = 1e6\ncount = 3\n\
         [[sweep.summary.numbers]]\ncolumn = \"asymptote_relative_error\"\nstatistics = [\"least\", \"sum\"]\n"
    );
    let sweep = parse(&text).unwrap();
    assert_eq!((sweep.work, sweep.block_points), (SweepWork::AsymptoteError, 1 << 18));
    let summary = sweep.summary.unwrap();
    assert_eq!((summary.by, summary.bins[0].edges.points), (vec!["arc".to_string()], 4));
    assert_eq!(summary.numbers[0].statistics, [Statistic::Least, Statistic::Sum]);
    for (right, wrong, part) in [
        ("count = 3", "count = 0", "count = 0: out of range"),
        ("count = 3", "count = 9999999", "count = 9999999: out of range"),
        ("\"least\", \"sum\"", "\"least\", \"leest\"", "did you mean `least`?"),
        ("\"least\", \"sum\"", "\"sum\", \"sum\"", "an earlier `sum`"),
        ("to = 1e6\ncount", "to = 1e2\ncount", "reversed range"),
        ("by = ", "buy = ", "sweep.summary.buy: unknown key"),
    ] {
        let messages = parse(&text.replace(right, wrong)).unwrap_err();
        assert!(messages.iter().any(|message| message.contains(part)), "{part}: {messages:#?}");
    }
}
