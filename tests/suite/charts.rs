//! Charts of what the equations of a report say: the example of docs/charts.md, and what is refused.

use crate::harness::Workplace;

const GUIDE: &str = include_str!("../../docs/charts.md");

const EQUATIONS: &str = "[assumptions]\npositive = [\"d\", \"k\", \"m\"]\nfree = [\"s\"]\n\
    [[equation]]\nnumber = \"1\"\nequation = \"omega = sqrt(k/m)\"\nnote = \"N.\"\n\
    [[definition]]\nname = \"P\"\nis = \"m*s^2 + d*s + k\"\n";

const CLAIM: &str = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"It is stable.\"\nexpected = \"holds\"\n\
    leaves_out = \"nothing\"\nformula = \"stable(P, s)\"\n";

/// The report of the example.
fn oscillator(prose: &str) -> Workplace {
    let place = Workplace::with_report(EQUATIONS, CLAIM, prose);
    let plan = place.read("r/report.toml").replacen("scenes = [\"a\"]", "charts = [\"oscillator\"]", 1);
    place.write("r/report.toml", plan);
    let (_, chart) = GUIDE.split_once("This is `charts/oscillator.toml`:\n\n```toml\n").expect("the chart");
    place.write("r/charts/oscillator.toml", chart.split_once("```").expect("its end").0);
    place
}

#[test]
fn the_example_is_drawn_and_its_table_is_that_of_the_quadratic() {
    let place = oscillator("[[figure:oscillator]]\n");
    place.run(["report", "r", "-o", "out"]).expect_success();
    let table = place.read("out/tables/oscillator.csv");
    let mut rows = table.lines();
    assert_eq!(rows.next(), Some("d,k,roots_right,roots_on_axis,real_roots,mode,critical_spring"));
    let mut counted = 0;
    for row in rows {
        let cells: Vec<&str> = row.rsplitn(2, ',').collect();
        let critical: f64 = cells[0].parse().unwrap();
        let cells: Vec<&str> = cells[1].splitn(6, ',').collect();
        let [d, k]: [f64; 2] = [0, 1].map(|index| cells[index].parse().unwrap());
        assert!((critical / (d * d / 4.0) - 1.0).abs() < 1e-9, "{row}");
        // Points on the line d^2 = 4k itself are left to exact arithmetic.
        let oscillates = d * d < 4.0 * k * (1.0 - 1e-9);
        let overdamped = d * d > 4.0 * k * (1.0 + 1e-9);
        assert_eq!(&cells[2..4], ["0", "0"], "{row}");
        assert!(oscillates != cells[5].contains("without") || !overdamped && !oscillates, "{row}");
        counted += usize::from(oscillates || overdamped);
    }
    assert!(counted > 3600, "{counted}");
    let svg = place.read("out/figures/oscillator.svg");
    assert!(svg.contains("critical damping") && svg.contains("stable, oscillates"), "{svg:.400}");
    let page = place.read("out/index.html");
    assert!(page.contains("A mass of 1 kg on a spring with a damper."));
    // The same bytes again from the archive.
    place.run(["archive", "r", "-o", "r.tar.gz"]).expect_success();
    place.run(["replay", "r.tar.gz"]).expect_success();
}

#[test]
fn a_chart_that_no_chapter_places_is_read_and_not_drawn() {
    let place = oscillator("Words.\n");
    place.run(["report", "r", "-o", "out"]).expect_success();
    assert!(!place.path("out/figures/oscillator.svg").exists());
    place.write("r/charts/oscillator.toml", "title = 1\n");
    place.run(["report", "r", "-o", "again"]).expect_refusal(&[
        "r/charts/oscillator.toml:1: title = 1: must be a text",
        "r/charts/oscillator.toml:1: x: missing",
    ]);
    assert!(!place.path("again").exists());
}

#[test]
fn names_of_charts_are_their_own() {
    let place = oscillator("[[figure:zones]]\n");
    let plan = place.read("r/report.toml").replacen("\"oscillator\"", "\"zones\", \"zones\", \"gone\"", 1);
    place.write("r/report.toml", &plan);
    place
        .run(["report", "r", "-o", "out"])
        .expect_refusal(&["charts[2] = \"zones\": the same as an earlier `zones`"]);
    place.write("r/charts/zones.toml", place.read("r/charts/oscillator.toml"));
    place.write("r/report.toml", plan.replacen("\"zones\", \"zones\", \"gone\"", "\"zones\"", 1));
    place
        .run(["report", "r", "-o", "out"])
        .expect_refusal(&["report.toml: `zones` is a chart of equations and also computed or measured"]);
}
