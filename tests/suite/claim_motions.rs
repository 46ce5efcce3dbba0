//! Claims on the motions of a system: lemmas whose hypotheses hold, and altered ones that decide nothing.

use crate::harness::Workplace;

const EQUATIONS: &str = include_str!("../../reports/ranjith-rice-1999/equations.toml");

/// What the slider without inertia conserves at the critical stiffness.
const HILL: &str = "ln(v/V) - v*theta/L - K*V*theta/A + (1 + K*L/A)*ln(theta*V/L)";

/// The verdict on one claim with this condition and these keys of `motion`, and what is said of it.
fn decided(given: &str, keys: &str) -> (String, String) {
    let place = report(given, keys);
    place.run(["verify", "motions"]);
    let ledger: serde_json::Value =
        serde_json::from_str(&place.read("target/report/motions/ledger.json")).unwrap();
    let claim = &ledger["claims"][0];
    (claim["verdict"].as_str().unwrap().into(), claim.to_string())
}

fn report(given: &str, keys: &str) -> Workplace {
    let place = Workplace::new();
    place.run(["new", "--paper", "motions"]).expect_success();
    let claim = "[[claim]]\nid = \"Q1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\n";
    place.write("motions/equations.toml", EQUATIONS);
    place.write("motions/claims.toml", format!("{claim}given = [{given}]\n[claim.motion]\n{keys}"));
    place.write("motions/prose/introduction.md", "[[claim:Q1]]\n");
    place
}

#[test]
fn a_lemma_decides_where_its_hypotheses_hold_and_only_there() {
    let periodic = |hill: &str| format!("lemma = \"periodic\"\nsystem = \"loaded\"\nquantity = \"{hill}\"\n");
    let attraction = format!(
        "lemma = \"attraction\"\nsystem = \"loaded\"\nquantity = \"{HILL}\"\nzero = \"1 - v*theta/L\"\n"
    );
    let (verdict, text) = decided("\"K = K_cr\"", &periodic(HILL));
    assert!(verdict == "holds" && text.contains("\"strength\":\"argued\""), "{text}");
    assert!(text.contains("implicit function theorem"), "{text}");
    assert_eq!(decided("\"K > K_cr\"", &attraction).0, "holds");
    // A wrong quantity leaves a remainder; a stiffness on the wrong side and a wrong sign leave the sign open.
    for (given, keys, says) in [
        (
            "\"K = K_cr\"",
            periodic(&HILL.replace("(1 + K", "(2 + K")),
            "rate of the quantity along the motion",
        ),
        ("\"K > K_cr\"", periodic(HILL), "rate of the quantity along the motion"),
        ("\"K < K_cr\"", attraction.clone(), "towards its extreme value"),
        ("\"K > K_cr\"", attraction.replace("- v*theta/L -", "+ v*theta/L -"), "a factor times a square"),
        ("\"v > V\", \"K > K_cr\"", attraction.clone(), "contains the state variable v"),
    ] {
        let (verdict, text) = decided(given, &keys);
        assert!(verdict == "not-checked" && text.contains(says), "{given} {keys}: {text}");
    }
}

#[test]
fn keys_of_a_lemma_that_are_missing_or_wrong_are_refused_where_they_stand() {
    for (keys, named) in [
        ("lemma = \"periodc\"\nsystem = \"loaded\"\n", "did you mean `periodic`?"),
        ("lemma = \"periodic\"\nsystem = \"loadd\"\nquantity = \"v\"\n", "did you mean `loaded`?"),
        ("lemma = \"periodic\"\nsystem = \"with_mass\"\nquantity = \"v\"\n", "two state variables"),
        ("lemma = \"weak-instability\"\nsystem = \"loaded\"\nfrequency = \"1\"\n", "three state variables"),
        ("lemma = \"attraction\"\nsystem = \"loaded\"\n", "motion.quantity: missing"),
        ("lemma = \"attraction\"\nsystem = \"loaded\"\n", "motion.zero: missing"),
        ("lemma = \"periodic\"\nsystem = \"loaded\"\nquantity = \"q\"\n", "'q' is no"),
        ("lemma = \"periodic\"\nsystem = \"loaded\"\nquantity = \"v\"\nzero = \"v\"\n", "motion.zero"),
        (
            "lemma = \"periodic\"\nsystem = \"loaded\"\nquantity = \"(v + theta)^8*(A + B)^8\"\n",
            "the quantity (v + theta)^8*(A + B)^8 is too large",
        ),
        ("lemma = \"deceleration\"\nsystem = \"at_rest\"\nregion = \"v\"\nvariable = \"K\"\n", "v or theta"),
    ] {
        let place = report("\"K = K_cr\"", keys);
        place.run(["verify", "motions"]).expect_refusal(&[named]);
    }
}
