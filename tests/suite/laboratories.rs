//! The report of a laboratory's own slider: about its own range first, and about the paper in one folded chapter at the end.

use std::time::Instant;

use crate::harness::Workplace;

/// Makes the folder of a slider and its report, and gives the report as text; values in SI are printed on standard error.
fn report<'a>(place: &Workplace, name: &'a str, arguments: impl IntoIterator<Item = &'a str>) -> String {
    let made = place.run(["new", name].into_iter().chain(arguments));
    assert_eq!(made.code, 0, "{}", made.stderr);
    place.run(["report", name]).expect_success();
    place.read(&format!("target/report/{name}/ledger.md"))
}

const LABORATORIES: &str = include_str!("../data/laboratories.csv");

/// Wall-clock seconds of a report on a busy machine; on a free one it takes about five seconds of one core.
const MOST_SECONDS: u64 = 60;

/// Name, arguments and the beginning of the answer of each laboratory.
fn laboratories() -> Vec<[String; 3]> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(LABORATORIES.as_bytes());
    let row = |row: csv::StringRecord| std::array::from_fn(|column| row[column].to_owned());
    reader.records().map(|record| row(record.unwrap())).collect()
}

/// Exponents of ten in a text, such as −48 in `6.2e-48`.
fn exponents(text: &str) -> Vec<i32> {
    let digits = |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let is_number = |before: &str| before.ends_with(|c: char| c.is_ascii_digit());
    let exponent = |(before, after): (&str, &str)| {
        let sign = usize::from(after.starts_with(['-', '+']));
        let end = sign + digits(&after[sign..]);
        is_number(before).then(|| after[..end].parse().ok()).flatten()
    };
    text.match_indices('e').filter_map(|(at, _)| exponent((&text[..at], &text[at + 1..]))).collect()
}

#[test]
fn a_laboratory_is_told_first_what_it_does_and_never_a_number_out_of_reach() {
    let place = Workplace::new();
    let all = laboratories();
    assert_eq!(all.len(), 3);
    for [name, arguments, answer] in all {
        let started = Instant::now();
        let text = report(&place, &name, arguments.split(' '));
        assert!(started.elapsed().as_secs() < MOST_SECONDS, "{name}: {:?}", started.elapsed());
        assert!(text.contains(&format!("\n1. {answer}")), "{text}");
        let order = [
            "## Answer",
            "figures/operating-map.svg",
            "| $K$ |",
            "## What to change to leave this slip mode",
            "## Which error bar decides",
            "## Runs at the operating point and around it",
            "## What of the paper holds for this slider",
            "## Verdicts",
            "## Ledger of claims",
        ];
        let places = order.map(|part| text.find(part).unwrap_or_else(|| panic!("{name}: {part}")));
        assert!(places.is_sorted(), "{name}: {places:?}");
        let own = &text[..places[6]];
        assert!(exponents(own).iter().all(|exponent| (-12..=11).contains(exponent)), "{name}: {own}");
        assert!(!own.contains("eq 15") && !own.contains("claim of the paper"), "{name}: {own}");
        // The page has one folded part, in which all claims are.
        let page = place.read(&format!("target/report/{name}/index.html"));
        let fold = page.find("id=\"part-paper\"").unwrap();
        let [tiles, ledger, provenance] = ["id=\"claims-by-verdict\"", "id=\"ledger\"", "id=\"provenance\""]
            .map(|part| page.find(part).unwrap());
        assert!(fold < tiles && tiles < ledger && ledger < provenance, "{name}");
        assert_eq!(page[fold..tiles].matches("<details").count(), 1, "{name}");
    }
}

const LAB: [&str; 14] = [
    "-a",
    "0.009",
    "-b",
    "0.0126",
    "-d",
    "8um",
    "-k",
    "2.5MPa/um",
    "-m",
    "2400",
    "-s",
    "5MPa",
    "-v",
    "10um/s",
];

#[test]
fn maps_and_runs_keep_to_the_operating_range() {
    let place = Workplace::new();
    let ranges = ["--normal-stresses", "[2MPa, 10MPa]", "--loading-velocities", "[1um/s, 1mm/s]"];
    let text = report(&place, "lab", LAB.into_iter().chain(ranges));
    let scene = place.read("lab/scenes/lab.toml");
    for axis in [
        "normal_stress_pa = { from = 630000, to = 3.2e7,",
        "loading_velocity_m_per_s = { from = 3.1e-7, to = 0.0032,",
    ] {
        assert_eq!(scene.matches(axis).count(), 2, "{axis}: {scene}");
    }
    // One run at the point itself, and one at each end of the two ranges.
    assert_eq!(scene.matches("[[trajectories.point]]").count(), 5, "{scene}");
    for value in ["normal_stress_pa = 2e6", "normal_stress_pa = 1e7", "_m_per_s = 1e-6", "_m_per_s = 0.001"] {
        assert!(scene.contains(&format!("{value}\n")), "{value}: {scene}");
    }
    assert!(text.contains("1. At 5 MPa and 10 µm/s, the slip mode is overdamped stable sliding"), "{text}");
    // The transition is at 5.6 GPa: it does not cross this map, and is not in its legend. The boundary does.
    let map = place.read("target/report/lab/figures/operating-map.svg");
    assert!(!map.contains("transition") && map.contains("exact boundary"), "{map}");
    assert!(!text.contains("Which error bar decides"), "no value has an error bar");
}

#[test]
fn a_range_without_its_operating_point_is_refused() {
    let place = Workplace::new();
    let lab = || ["new", "lab"].into_iter().chain(LAB);
    place.run(lab().chain(["--normal-stresses", "[6MPa, 10MPa]"])).expect_refusal(&[
        "--normal-stresses = \"[6MPa, 10MPa]\": needs a range that contains --normal-stress-pa",
    ]);
    place.run(lab().chain(["--loading-velocities", "10um/s"])).expect_refusal(&["--loading-velocities"]);
    place
        .run(["new", "lab", "--loading-velocities", "[1um/s, 1mm/s]"])
        .expect_refusal(&["--loading-velocities", "needs an operating point: --normal-stress-pa"]);
    place.run(["new", "lab", "--paper", "--normal-stresses", "[1, 2]"]).expect_refusal(&["--paper"]);
    assert!(place.names().is_empty());
}

#[test]
fn a_scene_with_an_operating_point_section_needs_the_point() {
    let place = Workplace::new();
    assert_eq!(place.run(["new", "lab"].into_iter().chain(LAB)).code, 0);
    let scene = place.read("lab/scenes/lab.toml");
    let broken = scene
        .replace("normal_stress_pa = \"5MPa\"", "")
        .replace("[operating_point]\n", "[operating_point]\nchanges = 1\n");
    place.write("lab/scenes/lab.toml", broken);
    place.run(["report", "lab"]).expect_refusal(&[
        "operating_point: needs normal_stress_pa and loading_velocity_m_per_s in [parameters]",
        "operating_point.changes: unknown key",
    ]);
}

#[test]
fn sliders_of_every_kind_get_a_report_about_their_operating_point() {
    let place = Workplace::new();
    for (name, arguments, said) in [
        (
            "equal",
            "-a 0.01 -b 0.01 -d 8um -k 2e9 -m 2400 -s 5MPa -v 10um/s",
            "sliding is stable at every normal stress",
        ),
        (
            "straddle",
            "-a 0.010±0.001 -b 0.0105±0.001 -d 8um -k 2e9 -m 2400 -s 5MPa -v 10um/s",
            "a band that has no end",
        ),
        (
            "soft",
            "-a 0.01 -b 0.02 -d 1um -k 1MPa/m -m 5000 -s 20MPa -v 1mm/s",
            "slip at velocities out of reach",
        ),
    ] {
        let text = report(&place, name, arguments.split(' '));
        let own = &text[..text.find("## What of the paper").unwrap()];
        assert!(own.contains(said), "{name}: {own}");
        assert!(exponents(own).iter().all(|exponent| (-12..=11).contains(exponent)), "{name}: {own}");
    }
}
