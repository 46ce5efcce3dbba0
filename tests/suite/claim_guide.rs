//! The worked example of docs/claims.md: its files are decided as it says, and its suggestions come true.

use crate::harness::Workplace;

const GUIDE: &str = include_str!("../../docs/claims.md");

/// The block of TOML behind the words that name a file.
fn block(file: &str) -> &'static str {
    let (_, after) = GUIDE.split_once(&format!("This is `mine/{file}`:\n\n```toml\n")).expect(file);
    after.split_once("```").expect("the end of the block").0
}

#[test]
fn the_worked_example_is_decided_as_the_guide_says() {
    let place = Workplace::new();
    let listed = place.run(["new", "--paper", "mine"]).expect_success();
    assert!(GUIDE.contains(&listed), "the guide prints: {listed}");
    place.run(["verify", "mine"]).expect_success();
    let (equations, claims) = (block("equations.toml"), block("claims.toml"));
    place.write("mine/equations.toml", equations);
    place.write("mine/claims.toml", claims);
    let decided = place.run(["verify", "mine", "--claim", "C1"]).expect_warnings();
    assert!(decided.contains("holds, exact"), "{decided}");
    // Each step of the proof, with its certificate.
    assert!(decided.contains("\n  1. ") && decided.contains("= det(s - J), J = "), "{decided}");
    // What the faults show to be missing from the claim, and with it.
    let planted = || place.run(["verify", "mine", "--planted-faults"]).stdout;
    assert!(planted().contains("21 of 24 wrong versions noticed"), "{}", planted());
    let (_, missing) = GUIDE.split_once("This part says it:\n\n```toml\n").expect("the part");
    place.write("mine/claims.toml", format!("{claims}\n{}", missing.split_once("```").expect("its end").0));
    assert!(planted().contains("24 of 24 wrong versions noticed"), "{}", planted());
    // Without its condition the second part fails, and the counter-example has B <= A.
    let open =
        claims.replacen("formula = \"K_c > K_cr\"\ngiven = [\"B > A\"]", "formula = \"K_c > K_cr\"", 1);
    assert_ne!(open, claims);
    place.write("mine/claims.toml", open);
    let ended = place.run(["verify", "mine", "--claim", "C1"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stdout.contains("left minus right is 0"), "{}", ended.stdout);
}
