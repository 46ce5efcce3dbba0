//! Claim N4 is decided by what is found next to K = K_c: without a coexisting cycle the program says otherwise.

use crate::harness::Workplace;

const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

const REPORT: &str = r#"
name = "near"
title = "A small report"
scenes = ["paper"]

[[chapter]]
id = "introduction"
title = "Introduction"
prose = "introduction.md"
"#;

const CLAIM: &str = r#"
[[claim]]
id = "N4"
place = "section 3"
words = "The transition criteria are identical for the aging law."
expected = "holds"
"#;

/// A grid of four points far from the transition, and one place next to it.
fn scene(inertial_parameter: &str) -> String {
    format!(
        "name = \"paper\"\ntitle = \"The paper's parameters\"\n[parameters]\ndirect_effect = 0.004\n\
         evolution_effect = 0.006\ncritical_slip_distance_m = 10e-6\nstiffness_pa_per_m = 10e6\n\
         mass_per_area_kg_per_m2 = 1000\n[simulations]\n\
         loading_velocity_m_per_s = {{ from = 1e-6, to = 1e-5, points = 2 }}\n\
         normal_stress_pa = {{ from = 1e3, to = 1e6, points = 2 }}\nlaws = [\"slip\", \"aging\"]\ntolerance = 1e-8\n\
         [near_transition]\ninertial_parameter = [{inertial_parameter}]\n\
         stiffness_over_critical = [0.99, 1.003]\nedge_inertial_parameter = [{inertial_parameter}]\ntolerance = 1e-6\n"
    )
}

/// The ledger of a report on N4 alone.
fn ledger(inertial_parameter: &str) -> String {
    let place = Workplace::new();
    place.write("near/report.toml", REPORT);
    place.write("near/claims.toml", CLAIM);
    place.write("near/equations.toml", EQUATIONS);
    place.write("near/scenes/paper.toml", scene(inertial_parameter));
    place.write("near/prose/introduction.md", "Nothing is placed here.\n");
    place.run(["report", "near", "-o", "out"]);
    place.read("out/ledger.json")
}

#[test]
fn the_laws_end_alike_where_the_aging_law_is_supercritical() {
    let ledger = ledger("0.5");
    assert!(ledger.contains("\"verdict\": \"holds\""), "{ledger}");
}

#[test]
fn a_cycle_beside_stable_sliding_refutes_the_claim() {
    let ledger = ledger("0.03");
    assert!(ledger.contains("\"verdict\": \"fails\""), "{ledger}");
    let edge = "a stable limit cycle beside stable sliding up to K/K_c = 1.0059.";
    assert!(ledger.contains(edge), "{ledger}");
}
