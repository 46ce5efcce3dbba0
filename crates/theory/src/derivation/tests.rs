//! Derivations by name: what they give, how it is proved, and what is refused.

use crate::Equations;
use crate::notation::formula;
use slipmode_algebra::{Domain, Expression, Symbol};

/// The quasi-static slider with a general one-state law near steady sliding, and the one with mass.
const FILE: &str = r#"
[assumptions]
positive = ["A", "B", "L", "K", "M", "V", "v", "theta", "omega"]
free = ["x", "mu_0"]
[[system]]
name = "massless"
state = ["v", "theta"]
rates = ["v/A*(K*(V - v) - B/theta*(1 - v*theta/L))", "1 - v*theta/L"]
steady = ["V", "L/V"]
[[system]]
name = "aging"
state = ["x", "v", "theta"]
rates = ["V - v", "(K*x - mu_0 - A*ln(v/V) - B*ln(V*theta/L))/M", "1 - v*theta/L"]
steady = ["mu_0/K", "V", "L/V"]
"#;

/// The file with these definitions.
fn read(definitions: &[(&str, &str)], more: &str) -> Result<Equations, String> {
    let list =
        definitions.iter().map(|(name, is)| format!("[[definition]]\nname = \"{name}\"\nis = \"{is}\"\n"));
    let text = format!("{FILE}{}{more}", list.collect::<String>());
    Equations::read(toml::from_str(&text).expect("TOML with known keys")).map_err(|error| error.to_string())
}

/// What the last definition comes to, against an expression; its proof checks again.
fn gives(definitions: &[(&str, &str)], more: &str, expected: &str) {
    let (name, is) = definitions.last().expect("a definition");
    let equations = read(definitions, more).unwrap_or_else(|error| panic!("{is}: {error}"));
    let found = equations.names().resolved(&formula(name));
    let expected: Expression = expected.parse().expect("in the grammar");
    let given = equations.names().given_of(&formula(name));
    let domain = given.into_iter().fold(Domain::positive("A B L K M V v theta omega"), |domain, one| {
        domain.given(one.expression.clone(), one.relation)
    });
    let same = domain.difference(&found, &expected).unwrap_or_else(|error| panic!("{is}: {error}"));
    assert!(same.is_zero(), "{is} gives {found}");
    for proof in equations.names().proofs_of(&formula(name)) {
        assert_eq!(proof.recheck(), Ok(()), "{is}");
        assert!(proof.is_certified(), "{is}");
    }
}

#[test]
fn the_characteristic_polynomial_of_the_slider_with_mass_gives_its_critical_stiffness() {
    let p = ("P", "characteristic(aging, s)");
    let eq8 = "s^3 + (A/(M*V) + V/L)*s^2 + (K/M + (A - B)/(L*M))*s + K*V/(L*M)";
    gives(&[p], "", eq8);
    gives(&[p, ("c", "coefficient(P, s, 2)")], "", "A/(M*V) + V/L");
    gives(&[p, ("c", "coefficient(P, s, 4)")], "", "0");
    gives(&[p, ("c", "leading(P, s, 3)")], "", "1");
    for power in ["2", "4"] {
        let is = format!("leading(P, s, {power})");
        assert!(read(&[p, ("c", &is)], "").expect_err("another degree").contains("has degree 3 in s"));
    }
    let h = ("H", "hurwitz(P, s, 2)");
    gives(&[p, h], "", "(A/(M*V) + V/L)*(K/M + (A - B)/(L*M)) - K*V/(L*M)");
    gives(&[p, h, ("K_cr", "solve(H, K)")], "", "(B - A)/L*(1 + M*V^2/(A*L))");
    gives(&[("K_0", "limit(K_cr, M, 0)"), p, h, ("K_cr", "solve(H, K)"), ("K_1", "K_0")], "", "(B - A)/L");
    gives(
        &[p, h, ("K_cr", "solve(H, K)"), ("S", "series(K_cr, M, 1)")],
        "",
        "(B - A)/L + M*V^2*(B - A)/(A*L^2)",
    );
    gives(&[("Q", "characteristic(massless, s)")], "", "s^2 + (K*V/A - (B - A)*V/(A*L))*s + K*V^2/(A*L)");
}

#[test]
fn each_derivation_gives_what_its_name_says() {
    gives(&[("J", "linearised(massless, theta, v)")], "", "-1/V");
    gives(&[("J", "linearised(massless, v, theta)")], "", "V^3*B/(A*L^2)");
    gives(
        &[("R", "rate(v*theta, massless)")],
        "",
        "v*theta/A*(K*(V - v) - B/theta*(1 - v*theta/L)) + v*(1 - v*theta/L)",
    );
    gives(&[("D", "discriminant(A*x^2 + B*x + K, x)")], "", "B^2 - 4*A*K");
    gives(
        &[("D", "discriminant(x^3 - A*x^2/L + B*x - 1/K, x)")],
        "",
        "(A*B/L)^2 - 4*B^3 - 4*(A/L)^3/K - 27/K^2 + 18*A*B/(L*K)",
    );
    gives(&[("R", "eliminate(x^2 - A, x - B, x)")], "", "B^2 - A");
    gives(&[("R", "eliminate(x^2/L - A, K*x^2 + x - B, x)")], "", "((K*A*L - B)^2 - A*L)/L^2");
    gives(&[("w", "solve(M*omega^2 - K, omega)")], "", "sqrt(K/M)");
    gives(&[("w", "solve(K/omega^2 - M, omega)")], "", "sqrt(K/M)");
    gives(&[("d", "derivative(A*ln(v/V), v)")], "", "A/v");
    gives(&[("l", "limit(A*K/(B + K), K, infinity)")], "", "A");
    gives(
        &[("S", "series(1/sqrt(1 + V), V, 5)")],
        "",
        "1 - V/2 + 3*V^2/8 - 5*V^3/16 + 35*V^4/128 - 63*V^5/256",
    );
    gives(
        &[("S", "series(sqrt(1 + A*V)/(1 + V), V, 3)")],
        "",
        "1 + (A/2 - 1)*V + (1 - A/2 - A^2/8)*V^2 + (A/2 - 1 + A^2/8 + A^3/16)*V^3",
    );
    gives(&[("e", "exchange(A/(A + 2*B), A, B)")], "", "B/(B + 2*A)");
    gives(&[("t", "at(A*M + K, M = 0, K = A*L)")], "", "A*L");
    // A definition of the sides of an equation, and a name that an equation defines.
    let equation = "[[equation]]\nnumber = \"1\"\nequation = \"Q = A + K_1\"\n[[equation]]\nnumber = \"2\"\nequation = \"K_1 = B*V\"\n";
    gives(&[("d", "derivative(Q, V)")], equation, "B");
    let names = read(&[("d", "2*Q")], equation).expect("sound");
    assert_eq!(names.names().equations_of(&Expression::variable("d")), ["1", "2"]);
}

#[test]
fn a_proof_says_how_a_solution_was_found_and_put_back() {
    let list = [("P", "characteristic(aging, s)"), ("H", "hurwitz(P, s, 2)"), ("K_cr", "solve(H, K)")];
    let equations = read(&list, "").expect("sound");
    let proofs = equations.names().proofs_of(&Expression::variable("K_cr"));
    assert_eq!(
        proofs.iter().map(|proof| proof.id.as_str()).collect::<Vec<_>>(),
        ["definition-p", "definition-h", "definition-k_cr"]
    );
    let text: String = proofs.iter().map(ToString::to_string).collect();
    for part in [
        "the rate of v is zero at the steady state of aging",
        "determinant of s − J",
        "Hurwitz determinant of order 2 in s",
        "put back for K, it gives zero",
    ] {
        assert!(text.contains(part), "{part} is not in:\n{text}");
    }
    assert!(proofs[2].steps.iter().all(|step| step.equations == ["system aging"]), "{text}");
    assert!(equations.names().system("aging").is_some_and(|system| system.state[1] == Symbol::from("v")));
}

#[test]
fn definitions_at_fault_are_refused_all_at_once() {
    let list = [
        ("c1", "c2 + 1"),
        ("c2", "2*c1"),
        ("u", "Kx + 1"),
        ("n", "1/(B - A)"),
        ("l", "ln(B - A)"),
        ("r", "solve(K^3 - M, K)"),
        ("f", "solve(omega^2 + A*omega - B, omega)"),
        ("q", "solve((B - A)*K - M, K)"),
        ("m", "solve(omega^2 + M, omega)"),
        ("y", "characteristic(agin, s)"),
        ("j", "linearised(aging, v, K)"),
        ("d", "discriminant(x^4 + K, x)"),
        ("h", "hurwitz(x^3 + K, x, 4)"),
        ("g", "limit(1/K, K, 0)"),
        ("z", "hurwitz(z_1^3 + K, z_1, 2)"),
        ("k", "at(ln(K), K = -1)"),
        ("K", "1"),
        ("sqrt", "1"),
        ("big", "(A + B + L + K + M + V)^20"),
    ];
    let message = read(&list, "").expect_err("faults");
    for fault in [
        "definition c1: is defined by itself: c1 -> c2 -> c1",
        "definition c2: is defined by itself",
        "definition u: 'Kx' is no variable and no defined name of equations.toml; did you mean",
        "definition n: column 3: 'B - A' may be zero",
        "definition l: column 3: 'B - A' may be zero or negative",
        "definition r: 'K^3 - M' has degree 3 in K (allowed: 1 to 2)",
        "definition f: 'omega^2 + A*omega - B' = 0 may have several solutions",
        "definition q: '-A + B' may be zero",
        "definition m: omega^2 = -M is not found to be positive",
        "definition y: there is no system 'agin'; did you mean `aging`?",
        "definition j: K is no state of aging",
        "definition d: 'x^4 + K' has degree 4 in x (allowed: 2 to 3)",
        "definition h: the order of the Hurwitz determinant is 4 (allowed: 1 to 3)",
        "definition z: 'z_1' is no variable and no defined name of equations.toml; `positive` and `free`",
        "definition g: 1/K has no finite limit in K",
        "definition k: K is positive, and the value -1 in its place may be negative",
        "definition K: the name has a meaning by an assumption",
        "definition sqrt: a name has 1 to 40 characters",
        "definition big: '(A + B + L + K + M + V)^20' is too large",
    ] {
        assert!(message.contains(fault), "{fault} is not in:\n{message}");
    }
}

#[test]
fn a_definition_is_worked_out_for_what_it_is_given_for() {
    let more = "given = [\"A < B\"]\n";
    gives(&[("w", "solve(omega^2 - (B - A)*V^2/(A*L^2), omega)")], more, "sqrt((B - A)*V^2/(A*L^2))");
    let impossible = read(&[("w", "A")], "given = [\"A < B\", \"B < A\"]\n").expect_err("no such point");
    assert!(impossible.contains("definition w: none of 4096 points meets"), "{impossible}");
    let equations = read(&[("u", "2*w"), ("w", "sqrt(B - A)")], more).expect("sound");
    let given = equations.names().given_of(&Expression::variable("u"));
    assert_eq!(given.iter().map(ToString::to_string).collect::<Vec<_>>(), ["B - A > 0"]);
}

#[test]
fn systems_at_fault_are_refused() {
    let system = |rates: &str, steady: &str| {
        let text = format!(
            "[[system]]\nname = \"z\"\nstate = [\"v\", \"theta\"]\nrates = [{rates}]\nsteady = [{steady}]\n"
        );
        read(&[], &text).expect_err("a fault")
    };
    for (rates, steady, fault) in [
        (
            "\"V - v\", \"1 - v*theta/L\"",
            "\"V\", \"2*L/V\"",
            "system z: the rate of theta is not zero at the steady state: -1",
        ),
        ("\"V - v\"", "\"V\", \"L/V\"", "system z: 2 states, 1 rates and 2 steady values"),
        (
            "\"V - v\", \"1 - w*theta/L\"",
            "\"V\", \"L/V\"",
            "system z: rate 2 '1 - w*theta/L': 'w' is no variable",
        ),
        ("\"V - v +\", \"1\"", "\"V\", \"L/V\"", "system z: rate 1 'V - v +', column 8"),
        ("\"V - v\", \"1 - v*theta/L\"", "\"V\", \"L/v\"", "system z: a steady value contains the state v"),
        (
            "\"v*(V + v)\", \"theta\"",
            "\"-V\", \"0\"",
            "system z: the steady value -V of the positive v is not found to be positive",
        ),
        ("\"1/(v - V)\", \"theta\"", "\"V\", \"L\"", "system z: a rate has no value"),
    ] {
        let message = system(rates, steady);
        assert!(message.contains(fault), "{fault} is not in:\n{message}");
    }
}

#[test]
fn a_system_without_a_steady_state_has_rates_and_no_linearisation() {
    let still = "[[system]]\nname = \"still\"\nstate = [\"v\", \"theta\"]\n\
        rates = [\"-v/A*(K*v + B/theta*(1 - v*theta/L))\", \"1 - v*theta/L\"]\n";
    gives(&[("R", "rate(theta, still)")], still, "1 - v*theta/L");
    let refused = read(&[("P", "characteristic(still, s)")], still).expect_err("no steady state");
    assert!(refused.contains("definition P: the system still states no steady state"), "{refused}");
}

#[test]
fn conditions_of_a_file_are_read_in_its_variables() {
    let file = |conditions: &str| {
        let text = format!(
            "[assumptions]\npositive = [\"A\", \"B\"]\nconditions = [{conditions}]\n[[equation]]\nnumber = \"1\"\nequation = \"c = 1/(B - A)\"\n"
        );
        Equations::read(toml::from_str(&text).expect("TOML")).map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(file("\"A < B\""), Ok(()));
    for (conditions, fault) in [
        ("", "equation 1: right side '1/(B - A)', column 3: 'B - A' may be zero"),
        ("\"A = B\"", "assumptions.conditions: a condition has one of"),
        ("\"A < B\", \"C > 0\"", "assumptions.conditions: 'C' is no variable"),
        ("\"A < B\", \"B < A\"", "assumptions.conditions: none of 4096 points meets"),
    ] {
        let message = file(conditions).expect_err(fault);
        assert!(message.contains(fault), "{fault} is not in:\n{message}");
    }
}
