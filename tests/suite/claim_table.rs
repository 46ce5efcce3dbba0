//! Claims that once got a wrong verdict: a name as text in the place of a value, a fresh name that was a user's, a witness passed over.

use crate::harness::{Ended, Workplace};

/// What the program must say.
#[derive(Debug, Clone, Copy)]
enum Must {
    Hold,
    Fail,
    /// Refuse the claim, with these words in the message.
    Refuse(&'static [&'static str]),
}

use Must::{Fail, Hold, Refuse};

/// A formula, its other keys, and what the program must say.
type Row = (&'static str, &'static str, Must);

/// Decides rows over the same equations.
#[track_caller]
fn check(equations: &str, rows: &[Row]) {
    let wrong = wrong(equations, rows);
    assert!(wrong.is_empty(), "{} of {} rows:\n\n{}", wrong.len(), rows.len(), wrong.join("\n"));
}

/// The rows that are not decided as they must be. Each stands in a folder of its own.
fn wrong(equations: &str, rows: &[Row]) -> Vec<String> {
    let mut wrong = Vec::new();
    for (formula, keys, must) in rows {
        let expected = if matches!(must, Fail) { "fails" } else { "holds" };
        let claim = format!(
            "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"{expected}\"\nleaves_out = \"nothing\"\n\
             formula = {formula:?}\n{keys}\n"
        );
        let ended =
            Workplace::with_report(equations, &claim, "Words.\n").run(["verify", "r", "--claim", "C1"]);
        if !is_as_it_must(&ended, *must) {
            let said = if ended.code == 2 { &ended.stderr } else { &ended.stdout };
            wrong.push(format!("{formula}  {keys}: must {must:?}\n{said}"));
        }
    }
    wrong
}

fn is_as_it_must(ended: &Ended, must: Must) -> bool {
    match must {
        Hold | Fail => ended.code == 0,
        Refuse(words) => ended.code == 2 && words.iter().all(|word| ended.stderr.contains(word)),
    }
}

#[test]
fn a_function_of_a_variable_has_its_own_sign_and_no_values_of_its_own() {
    let equations = r#"
[assumptions]
positive = ["K", "M", "V", "zeta"]
free = ["s"]
[[equation]]
number = "1"
equation = "w = sqrt(K/M)"
[[definition]]
name = "P"
is = "s^2 + 2*zeta*w*s + w^2"
"#;
    check(
        equations,
        &[
            ("stable(P, s)", "", Hold),
            ("stable(s^2 + 2*zeta*w*s + w^2, s)", "", Hold),
            ("stable(s + sqrt(V), s)", "", Hold),
            ("stable(s + exp(V), s)", "", Hold),
            ("stable(s + ln(V), s)", "", Fail),
            ("pair_crosses(s^2 + (V - exp(K))*s + 1, s, V, exp(K), 1)", "", Hold),
            ("pair_crosses(s^2 + (exp(K) - exp(V))*s + 1, s, K, V, 1)", "", Hold),
            // The critical value has to meet what is assumed of K; it need not be above M.
            ("pair_crosses(s^2 + (V - K)*s + M, s, K, V, sqrt(M))", "", Hold),
            ("pair_crosses(s^2 + (V - K)*s + M, s, K, V, sqrt(M))", "given = ['K > M']", Fail),
        ],
    );
}

#[test]
fn a_variable_that_an_equation_ties_to_another_one_moves_with_it() {
    let root = "given = ['om = sqrt(K/M)']\nmoves = ['om']";
    let exponential = "given = ['p = exp(V)']\nmoves = ['p']";
    check(
        "[assumptions]\npositive = [\"K\", \"M\", \"V\", \"om\", \"p\"]\n",
        &[
            ("om does not depend on K", root, Fail),
            ("om depends on K", root, Hold),
            ("om rises with K", root, Hold),
            ("om falls with M", root, Hold),
            ("om rises with M", root, Fail),
            ("p/V falls with V", exponential, Fail),
            ("p rises with V", exponential, Hold),
            ("p does not depend on V", exponential, Fail),
        ],
    );
}

#[test]
fn a_witness_is_put_into_the_argument_of_a_root() {
    check(
        "[assumptions]\npositive = [\"V\", \"a\"]\n",
        &[
            ("unstable(s + 2 - sqrt(V), s)", "there_is = ['V']\nwitness = { V = '9' }", Hold),
            ("unstable(s + 2 - sqrt(V), s)", "there_is = ['V']", Hold),
            ("unstable(s + a - sqrt(V), s)", "there_is = ['V']\nwitness = { V = '(a + 1)^2' }", Hold),
            ("stable(s + a - sqrt(V), s)", "there_is = ['V']\nwitness = { V = 'a^2/4' }", Hold),
        ],
    );
}

/// Two positive variables of the equations, and one name as a positive or as a free variable.
fn beside(name: &str, is_positive: bool) -> String {
    let [positive, free] = if is_positive {
        [format!(", \"{name}\""), String::new()]
    } else {
        [String::new(), format!("\"{name}\"")]
    };
    format!("[assumptions]\npositive = [\"a\", \"b\", \"c\", \"x\"{positive}]\nfree = [{free}]\n")
}

#[test]
fn a_variable_with_the_name_of_a_parameter_of_proofs_is_not_that_parameter() {
    const BELOW: &str = "given = ['a < b']";
    const BOTH: &str = "given = ['a < b', 'b < c']";
    let free: [(&str, &[Row]); 7] = [
        (
            "gap_0",
            &[
                ("not unstable(s^2 + (gap_0 + 20000)*s + b - a, s)", BELOW, Fail),
                ("gap_0 + b - a > 0", BELOW, Fail),
                ("gap_0 = b - a", BELOW, Fail),
            ],
        ),
        ("gap_1", &[("gap_1 + c - b > 0", BOTH, Fail), ("stable(s + gap_1, s)", BOTH, Fail)]),
        ("root_a", &[("sqrt(a) + root_a > 0", "", Fail), ("root_a^2 = a", "", Fail)]),
        ("root_smaller", &[("sqrt(b) + root_smaller > sqrt(a)", BELOW, Fail)]),
        ("gap_of_roots", &[("sqrt(b) + gap_of_roots > sqrt(a)", BELOW, Fail)]),
        ("root_of_polynomial", &[("stable(s + root_of_polynomial, s)", "", Fail)]),
        (
            "other_value",
            &[("x*other_value depends on x", "", Hold), ("x*other_value does not depend on x", "", Fail)],
        ),
    ];
    let positive: [(&str, &[Row]); 8] = [
        (
            "other_value",
            &[
                ("x*other_value depends on x", "", Hold),
                ("x*other_value does not depend on x", "", Fail),
                ("x - other_value depends on x", "", Hold),
                ("x/(x + other_value) does not depend on x", "", Fail),
            ],
        ),
        ("gap_0", &[("gap_0 = b - a", BELOW, Fail), ("gap_0 + b > a", BELOW, Hold)]),
        ("root_a", &[("root_a = sqrt(a)", "", Fail), ("sqrt(a) + root_a > 0", "", Hold)]),
        ("root_b", &[("root_b*sqrt(b) = b", BELOW, Fail)]),
        (
            "root_smaller",
            &[("root_smaller = sqrt(a)", BELOW, Fail), ("sqrt(b) + root_smaller > sqrt(a)", BELOW, Hold)],
        ),
        (
            "gap_of_roots",
            &[("gap_of_roots = sqrt(b) - sqrt(a)", BELOW, Fail), ("gap_of_roots = sqrt(b - a)", BELOW, Fail)],
        ),
        ("root_of_polynomial", &[("stable(s + root_of_polynomial, s)", "", Hold)]),
        (
            "low",
            &[("x + low > low", "box = { x = [1, 2] }", Hold), ("x > low", "box = { x = [1, 2] }", Fail)],
        ),
    ];
    let free = free.iter().flat_map(|(name, rows)| wrong(&beside(name, false), rows));
    let positive = positive.iter().flat_map(|(name, rows)| wrong(&beside(name, true), rows));
    let wrong: Vec<String> = free.chain(positive).collect();
    assert!(wrong.is_empty(), "{} rows:\n\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn a_rise_along_an_equation_asks_which_variable_moves() {
    let refused = Refuse(&["moves"]);
    let [sum, solved] = ["given = ['x + y = a']", "given = ['y = a - x']"];
    let with = |given: &str| -> &'static str { format!("{given}\nmoves = ['y']").leak() };
    check(
        "[assumptions]\npositive = [\"x\", \"y\", \"a\"]\n",
        &[
            ("y falls with x", sum, refused),
            ("y falls with x", solved, refused),
            ("y falls with x", with(sum), Hold),
            ("y falls with x", with(solved), Hold),
            ("y rises with x", with(sum), Fail),
            ("y rises with x", with(solved), Fail),
            // The variable that moves is one that an equation among the conditions contains.
            ("y falls with x", "moves = ['y']", refused),
            ("y falls with x", "given = ['x + y = a']\nmoves = ['z']", Refuse(&["moves", "z"])),
        ],
    );
}

#[test]
fn conditions_on_a_variable_of_there_is_are_part_of_what_it_has_to_meet() {
    let of = |name: &str, given: &str| -> &'static str {
        format!("there_is = ['{name}']\ngiven = [{given}]").leak()
    };
    let witness =
        |keys: &str, witness: &str| -> &'static str { format!("{keys}\nwitness = {{ {witness} }}").leak() };
    let below = of("V", "'V < A - B'");
    let both = of("V", "'V < A - B', 'A > B'");
    check(
        "[assumptions]\npositive = [\"A\", \"B\", \"V\", \"p\", \"q\", \"x\"]\nfree = [\"u\", \"w\"]\n",
        &[
            ("V > 0", below, Fail),
            ("V < A", below, Fail),
            ("V^2 > 0", below, Fail),
            ("V > 0", witness(below, "V = '(A - B)/2'"), Fail),
            ("V > 0", witness(both, "V = '(A - B)/2'"), Hold),
            ("p = 1", of("p", "'p > q'"), Fail),
            ("p = q", of("p", "'p > q'"), Fail),
            ("p = 2*q", witness(of("p", "'p > q'"), "p = '2*q'"), Hold),
            ("stable(s^2 + w*s + 1, s)", of("w", "'w < u'"), Fail),
            ("stable(s^2 + p*s + 1, s)", witness(of("p", "'p < q'"), "p = 'q/2'"), Hold),
            ("unstable(s^2 + p*s + 1, s)", of("p", "'p < q'"), Fail),
            ("w > 0", of("w", "'w < u'"), Fail),
            ("w > 0", witness(of("w", "'w < u'"), "w = 'u/2'"), Fail),
            ("x > 0", witness(of("x", "'x < p'"), "x = 'p/2'"), Hold),
            ("x > 1", witness(of("x", "'x < p'"), "x = 'p/2'"), Fail),
            ("x >= q", of("x", "'x <= p'"), Fail),
        ],
    );
}

#[test]
fn a_witness_that_does_not_do_is_named() {
    let claim = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"fails\"\nleaves_out = \"nothing\"\n\
                 formula = \"x > 0\"\ngiven = [\"x < w\"]\nthere_is = [\"x\"]\nwitness = { x = \"w/2\" }\n";
    let equations = "[assumptions]\npositive = [\"x\"]\nfree = [\"w\"]\n";
    let said = Workplace::with_report(equations, claim, "Words.\n").run(["verify", "r", "--claim", "C1"]);
    assert!(said.code == 0 && (said.stdout + &said.stderr).contains("witness"));
}

#[test]
fn a_side_without_a_value_is_refused_whatever_it_is_multiplied_with() {
    const NO_VALUE: Must = Refuse(&["no value"]);
    check(
        "[assumptions]\npositive = [\"A\", \"B\", \"a\", \"b\"]\nfree = [\"x\"]\n",
        &[
            ("A + 0*ln(B - 2*B) = A", "", NO_VALUE),
            ("0*(1/0) = 0", "", NO_VALUE),
            ("0/(a - a) = 0", "", NO_VALUE),
            ("stable(s + a + 0*ln(-1), s)", "", NO_VALUE),
            ("A > 0 or 0*sqrt(-a) = 1", "", NO_VALUE),
            ("A + 0*x^-1 = A", "", NO_VALUE),
            ("ln(x) - ln(x) = 0", "", NO_VALUE),
            ("A + 0*ln(b - a) = A", "given = ['a <= b']", NO_VALUE),
            ("A > 0", "given = ['A + 0*ln(x) > 0']", NO_VALUE),
            ("A + 0*ln(b - a) = A", "given = ['a < b']", Hold),
        ],
    );
}

#[test]
fn a_claim_on_an_equation_or_definition_without_a_value_is_refused() {
    let claim = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\n\
                 formula = \"mu + a > mu_0\"\n";
    let assumptions = "[assumptions]\npositive = [\"a\", \"b\", \"mu_0\"]\n";
    let equation = "[[equation]]\nnumber = \"1\"\nequation = \"mu = 0*ln(a - b) + mu_0\"\n";
    let definition = "[[definition]]\nname = \"mu\"\nis = \"0*ln(a - b) + mu_0\"\n";
    for text in [equation, definition] {
        Workplace::with_report(&format!("{assumptions}{text}"), claim, "Words.\n")
            .run(["verify", "r"])
            .expect_refusal(&["no value", "a - b"]);
    }
    // With its condition it has one.
    let given = equation.to_owned() + "given = [\"b < a\"]\n";
    let claim = claim.to_owned() + "given = [\"b < a\"]\n";
    Workplace::with_report(&format!("{assumptions}{given}"), &claim, "Words.\n")
        .run(["verify", "r"])
        .expect_success();
}

#[test]
fn a_name_on_the_left_of_two_equations_is_refused() {
    let claim = "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\n\
                 formula = \"a + 1 > a\"\n";
    let two = "[[equation]]\nnumber = \"1\"\nequation = \"Z = 1\"\n[[equation]]\nnumber = \"2\"\nequation = \"Z = 2\"\n";
    let verify = |assumptions: &str| {
        Workplace::with_report(&format!("[assumptions]\n{assumptions}\n{two}"), claim, "Words.\n")
            .run(["verify", "r"])
    };
    verify("positive = [\"a\"]").expect_refusal(&["r/equations.toml", "Z", "1", "2"]);
    // An assumed variable may be solved for twice.
    verify("positive = [\"a\", \"Z\"]").expect_success();
    verify("positive = [\"a\"]\nfree = [\"Z\"]").expect_success();
}

#[test]
fn sides_that_have_a_value_by_a_sum_of_squares_or_a_condition_are_decided() {
    const ABOVE: &str = "given = ['a > b']";
    check(
        "[assumptions]\npositive = [\"a\", \"b\", \"x\"]\nfree = [\"p\", \"q\"]\n",
        &[
            ("(a*x + 1)/((a - b)*x + 1) > 0", ABOVE, Hold),
            ("(a*x + 1)/((a - b)*x + 1) > 1", ABOVE, Hold),
            ("(a*x + 1)/((a - b)*x + 1) < 1", ABOVE, Fail),
            ("(a*x + 1)/((a - b)*x + 1) -> 1 as x -> 0", ABOVE, Hold),
            ("(a*x + 1)/((a - b)*x + 1) -> a/(a - b) as x -> infinity", ABOVE, Hold),
            ("1/(p^2 + 1) > 0", "", Hold),
            ("1/(p^2 + 1) <= 1", "", Hold),
            ("1/(p^2 + 1) < 1", "", Fail),
            ("1/(p^2 + q^2 + 1) > 0", "", Hold),
            ("sqrt(p^2 + 1) >= 1", "", Hold),
            ("sqrt(p^2 + 1) > 1", "", Fail),
        ],
    );
}
