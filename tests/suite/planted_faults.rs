//! Wrong versions of a report's own equations, and formulas beside the words of its claims.

use crate::claim_formulas::{claim, report};
use crate::harness::Workplace;

#[test]
fn faults_in_any_equation_are_noticed_by_the_formulas_that_rest_on_it() {
    let claims = claim(1, "sqrt(right_15*right_16) = sigma_c", "given = ['a < b']", "holds")
        + &claim(2, "omega_n*eta = sqrt(K*M)*V_0^2/(sigma*a*D_c)", "", "holds");
    let place = report(&claims);
    let said = place.run(["verify", "r", "--planted-faults"]).expect_success();
    let line = |equation: &str| said.lines().find(|line| line.starts_with(equation)).unwrap();
    for (equation, by) in [("12 ", "C1"), ("15 ", "C1"), ("natural-frequency ", "C2"), ("inertial", "C2")] {
        assert!(line(equation).ends_with(&format!("first by {by}")), "{said}");
        let counts = line(equation).split_whitespace().nth(1).zip(line(equation).split_whitespace().nth(3));
        assert!(counts.is_some_and(|(noticed, planted)| noticed == planted && noticed != "0"), "{said}");
    }
    // No claim speaks of eq 9: its wrong versions are listed.
    assert!(line("9 ").contains(" 0 of 9 "), "{said}");
    assert!(
        said.contains("  not noticed (exchange): K_c = (a - b)*sigma/D_c*(1 + M*V_0^2/(sigma*b*D_c))"),
        "{said}"
    );

    place.write("r/prose/c.md", "[[table:planted-faults]]\n");
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    let table = place.read("out/tables/planted-faults.csv");
    assert!(table.lines().any(|row| row.starts_with("15,1,7,7,100.0,C1,")), "{table}");
    assert!(table.lines().any(|row| row.starts_with("9,0,9,0,0.0,,")), "{table}");
}

#[test]
fn formulas_and_their_conditions_stand_typeset_beside_the_words() {
    let part = |words: &str, formula: &str| {
        format!("[[claim.part]]\nwords = \"{words}\"\nformula = \"{formula}\"\ngiven = [\"a < b\"]\n")
    };
    let claims = claim(1, "K_c > K_c_qs", "given = ['a < b', 'K != M']", "holds")
        + "[[claim]]\nid = \"C2\"\nplace = \"p\"\nwords = \"Both.\"\nexpected = \"holds\"\nleaves_out = \"a = b\"\n"
        + &part("it rises", "K_c rises with M")
        + &part("it tends", "K_c -> K_c_qs as M -> 0");
    let place = report(&claims);
    place.run(["report", "r", "-o", "out"]).expect_warnings();
    let text = place.read("out/ledger.md");
    for wanted in [
        "- **Holds if:** $K_{c} > K_{c,qs}$ for all $a < b$, $K \\ne M$",
        "  - it rises ($K_{c}$ rises with $M$ for all $a < b$): ",
        "  - it tends ($K_{c} \\to K_{c,qs}$ as $M \\to 0$ for all $a < b$): ",
        "- **Not established:** a = b",
    ] {
        assert!(text.contains(wanted), "{wanted} is not in:\n{text}");
    }
    let page = place.page("out/index.html");
    let holds_if = page.split("<dt>Holds if</dt>").nth(1).unwrap();
    assert!(
        holds_if.starts_with("<dd><math><msub><mi>K</mi><mi>c</mi></msub><mo>&gt;</mo>"),
        "{holds_if:.300}"
    );
}

#[test]
fn every_wrong_version_of_the_equations_of_three_reports_on_other_papers_is_noticed() {
    let reports = concat!(env!("CARGO_MANIFEST_DIR"), "/reports");
    for (name, count) in [("rice-ruina-1983", 79), ("ranjith-rice-1999", 82), ("ziegler-1952", 83)] {
        let report = format!("{reports}/{name}");
        let said = Workplace::new().run(["verify", &report, "--planted-faults"]).expect_warnings();
        assert!(said.contains(&format!(" {count} of {count} wrong versions noticed")), "{said}");
        assert!(!said.contains("not noticed"), "{said}");
    }
}

#[test]
fn the_wrong_versions_on_mode_coupling_are_noticed_but_for_two_with_the_same_values() {
    let report = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/hoffmann-et-al-2002");
    let said = Workplace::new().run(["verify", report, "--planted-faults"]).expect_success();
    assert!(said.contains(" 90 of 92 wrong versions noticed"), "{said}");
    let missed: Vec<&str> = said.lines().filter(|line| line.contains("not noticed")).collect();
    assert_eq!(missed.len(), 2, "{said}");
    assert!(missed.iter().all(|line| line.contains("sqrt((k_y + k_x")), "{said}");
}
