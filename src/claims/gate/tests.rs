//! All formulas of the reports pass with the verdicts of the prover, and hardly one with the opposite verdict.

use super::*;
use crate::claims::formula::decide_equations;
use crate::claims::known_ids;
use crate::scene::{read_claims, read_equations};

const REPORTS: [&str; 5] =
    ["im-avouac", "paper-on-paper", "ranjith-rice-1999", "rice-ruina-1983", "rock-friction"];

/// A formula of a report, with the claim's id.
struct Stated {
    id: String,
    formula: ClaimFormula,
    equations: std::sync::Arc<Equations>,
}

fn of_report(report: &str) -> Vec<Stated> {
    let read = |name: &str| {
        std::fs::read(format!("{}/reports/{report}/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
    };
    let equations = std::sync::Arc::new(read_equations("equations.toml", &read("equations.toml")).unwrap());
    let claims = read_claims("claims.toml", &read("claims.toml"), &known_ids(), Some(&equations)).unwrap();
    let of_claim = |claim: crate::scene::ClaimEntry| {
        let parts = claim.stated.iter().flat_map(|stated| stated.parts()).map(|(_, formula)| formula);
        let all = parts.flat_map(ClaimFormula::with_outside).filter(|formula| formula.rows.is_none());
        let stated = |formula: &ClaimFormula| Stated {
            id: format!("{report} {}", claim.id),
            formula: formula.clone(),
            equations: equations.clone(),
        };
        all.map(stated).collect::<Vec<_>>()
    };
    claims.into_iter().flat_map(of_claim).collect()
}

#[test]
fn no_verdict_of_the_reports_is_contradicted() {
    let mut counts = [0_usize; 4];
    for report in REPORTS {
        let start = std::time::Instant::now();
        let mut spent = std::time::Duration::ZERO;
        for Stated { id, formula, equations } in of_report(report) {
            let finding = decide_equations("formula", "", &formula, &equations);
            let before = std::time::Instant::now();
            let outcome = tested(&formula, &finding, &equations);
            spent += before.elapsed();
            eprintln!("{id}: {} {:?} {outcome:?} {:?}", formula.text, finding.verdict, before.elapsed());
            counts[match outcome {
                Outcome::Passed { .. } => 0,
                Outcome::NotEvaluated(_) => 1,
                Outcome::Unconfirmed(_) => 2,
                Outcome::Contradicted(_) => 3,
            }] += 1;
        }
        eprintln!("{report}: {spent:?} of {:?}", start.elapsed());
    }
    eprintln!("{counts:?}");
    assert_eq!(counts[2..], [0, 0]);
}
