//! Ties of claims to theorems written by hand: those of the published ledgers, and altered ones.

use super::*;
use crate::scene::read_equations;

fn equations() -> Equations {
    read_equations("equations.toml", include_bytes!("../../../reports/im-avouac/equations.toml")).unwrap()
}

#[test]
fn every_row_is_read_and_every_module_is_in_the_library() {
    let folder = format!("{}/proofs", env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let files: BTreeSet<String> = files.map(|name| name.into_string().unwrap()).collect();
    let modules = files.iter().filter_map(|name| name.strip_suffix(".v"));
    assert!(modules.eq(LIBRARY.iter().map(|(name, _)| *name)));
    for (text, read) in [
        (include_str!("../../../proofs/claims.csv"), TIES.len()),
        (include_str!("../../../proofs/equations.csv"), STATED.len()),
    ] {
        assert_eq!(text.lines().count(), read + 1);
    }
    for name in TIES.iter().flat_map(Tie::names) {
        assert!(statement(name).is_some(), "{name}");
    }
}

#[test]
fn a_statement_stands_with_its_variables_hypotheses_and_definitions() {
    assert_eq!(statement("Slider.S5"), Some("Theorem S5 : b <= a -> stable c3 c2 c1 c0."));
    assert_eq!((statement("Slider.S"), statement("S5"), statement("Other.S5")), (None, None, None));
    let all = definitions("Slider");
    for part in ["Variables a b D", "(a_pos : 0 < a)", "Let K_c := (b - a)", "Definition stable"] {
        assert!(all.iter().any(|one| one.contains(part)), "{part}: {all:?}");
    }
    assert!(!all.iter().any(|one| one.contains("c3_pos")), "{all:?}");
}

#[test]
fn a_tie_ends_when_claim_result_equation_or_theorem_is_another_one_or_is_not_accepted() {
    let known = TIES.iter().find(|tie| tie.claim == "S5").unwrap();
    let equations = equations();
    let altered = equations.altered("9", "K_c = 7*(b - a)*sigma/D_c").unwrap();
    let tied = |digest: &'static str, finding: Finding| Tied {
        claim: "S5",
        digest,
        conclusion: Conclusion::from(&finding),
    };
    let (own, failing) = (Finding::not_checked("a result"), Finding::failing("another one"));
    let sound = tied("00ff", own.clone());
    let digest = known.digest_of(&sound, &equations).unwrap();
    let others = [
        known.digest_of(&tied("00fe", own.clone()), &equations),
        known.digest_of(&tied("00ff", failing.clone()), &equations),
        known.digest_of(&sound, &altered),
        Tie { theorems: "Slider.S1".into(), ..known.clone() }.digest_of(&sound, &equations),
    ];
    assert!(others.iter().flatten().all(|other| *other != digest) && others.iter().all(Option::is_some));
    let missing = Tie { theorems: "Slider.S99".into(), ..known.clone() };
    assert_eq!(missing.digest_of(&sound, &equations), None);
    let ties = [Tie { digest, claim_digest: "00ff".into(), ..known.clone() }];
    let listed = |names: &[&str]| {
        let lines: Vec<String> = names.iter().map(|name| format!("{name} {}", ties[0].digest)).collect();
        let lines: BTreeSet<&str> = lines.iter().map(String::as_str).collect();
        tie_in(&ties, &lines, &sound, &equations).cloned()
    };
    assert_eq!(listed(&["Slider.S5", "NoTransition.S5_critical"]), Some(ties[0].clone()));
    assert_eq!((listed(&["Slider.S5"]), listed(&[])), (None, None));
    let why = |tied: &Tied<'_>, equations| untied_in(&ties, "im-avouac", tied, equations);
    assert_eq!((why(&sound, &equations), untied_in(&ties, "another", &sound, &altered)), (None, None));
    let of_claim = why(&tied("00fe", own), &equations).unwrap();
    assert!(of_claim.starts_with("S5: the theorem is about other equations"), "{of_claim}");
    let of_result = why(&tied("00ff", failing), &equations).unwrap();
    assert!(of_result.contains("another result"), "{of_result}");
}
