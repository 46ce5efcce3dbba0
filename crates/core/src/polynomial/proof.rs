//! Proofs as values: what is claimed, over which variables, and the certificates it rests on.

use std::fmt;

use super::{Certificate, CounterExample, Domain, Expression, Refutation, Toward};

/// One step of a proof.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Step {
    /// The step in words.
    pub says: String,
    /// The equations of the paper that enter it.
    pub equations: Vec<String>,
    /// What can be computed again; a step of plain reasoning (an intermediate value, a count) has none.
    pub certificate: Option<Certificate>,
}

/// A proved statement. It was checked when it was made, and [`Proof::recheck`] checks it again from its certificates.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Proof {
    /// A stable name, such as `characteristic-polynomial`.
    pub id: String,
    /// What is proved, in words.
    pub statement: String,
    /// The steps, in order.
    pub steps: Vec<Step>,
}

impl Proof {
    /// Whether every step carries a certificate; a step without one is argued in words.
    #[must_use]
    pub fn is_certified(&self) -> bool {
        self.steps.iter().all(|step| step.certificate.is_some())
    }

    /// The beginning of a proof of this statement.
    #[must_use]
    pub fn new(id: &str, statement: impl Into<String>) -> Self {
        Self { id: id.to_owned(), statement: statement.into(), steps: Vec::new() }
    }

    /// Adds a step of plain reasoning, which rests on the steps before it.
    #[must_use]
    pub fn reason(mut self, says: impl Into<String>) -> Self {
        self.steps.push(Step { says: says.into(), equations: Vec::new(), certificate: None });
        self
    }

    /// Adds a certified step that compares these equations of the paper, after checking it.
    ///
    /// # Errors
    /// The refutation, when the certificate does not hold.
    pub fn certify(
        mut self,
        says: &str,
        equations: &[&str],
        certificate: Certificate,
    ) -> Result<Self, Refutation> {
        let equations = equations.iter().map(|&number| number.to_owned()).collect();
        let step = Step { says: says.to_owned(), equations, certificate: Some(certificate) };
        self.check(&step)?;
        self.steps.push(step);
        Ok(self)
    }

    /// Adds the step left = right.
    ///
    /// # Errors
    /// When both sides differ.
    pub fn identity(
        self,
        says: &str,
        equations: &[&str],
        left: &Expression,
        right: &Expression,
        domain: &Domain,
    ) -> Result<Self, Refutation> {
        let certificate =
            Certificate::Identity { left: left.clone(), right: right.clone(), domain: domain.clone() };
        self.certify(says, equations, certificate)
    }

    /// Adds the step that an expression is positive everywhere in the domain.
    ///
    /// # Errors
    /// When coefficients of one sign do not show it.
    pub fn positive(
        self,
        says: &str,
        equations: &[&str],
        expression: &Expression,
        domain: &Domain,
    ) -> Result<Self, Refutation> {
        let certificate =
            Certificate::Sign { expression: expression.clone(), sign: 1, domain: domain.clone() };
        self.certify(says, equations, certificate)
    }

    /// Adds the step that an expression tends to a value as `variable` goes `toward` an end.
    ///
    /// # Errors
    /// When the limit is another one, or none.
    pub fn limit(
        self,
        says: &str,
        equations: &[&str],
        expression: &Expression,
        (variable, toward): (&str, Toward),
        value: &Expression,
        domain: &Domain,
    ) -> Result<Self, Refutation> {
        let certificate = Certificate::Limit {
            expression: expression.clone(),
            variable: variable.to_owned(),
            toward,
            value: value.clone(),
            domain: domain.clone(),
        };
        self.certify(says, equations, certificate)
    }

    /// The refutation of a step that cannot even be written down, for this reason.
    #[must_use]
    pub fn refute(&self, says: &str, equations: &[&str], remainder: impl Into<String>) -> Refutation {
        Refutation {
            id: self.id.clone(),
            equations: equations.iter().map(|&number| number.to_owned()).collect(),
            statement: says.to_owned(),
            remainder: remainder.into(),
            counter_example: None,
        }
    }

    /// Adds all steps of another proof, which this one rests on.
    #[must_use]
    pub fn using(mut self, lemma: Self) -> Self {
        self.steps.push(Step { says: lemma.statement, equations: Vec::new(), certificate: None });
        self.steps.extend(lemma.steps);
        self
    }

    /// The proof as text. `elsewhere` is asked with the steps from each one on: it says how many of them are written
    /// elsewhere, and where; they become one line.
    #[must_use]
    pub fn text_without(&self, elsewhere: impl Fn(&[Step]) -> Option<(usize, String)>) -> String {
        let mut text = format!("{}: {}\n", self.id, self.statement);
        let mut at = 0;
        while let Some(step) = self.steps.get(at) {
            let first = at + 1;
            let (numbers, mark) = match elsewhere(&self.steps[at..]) {
                Some((count, place)) if count > 1 => {
                    at += count;
                    (format!("{first}-{at}"), format!(" [{place}]"))
                }
                _ => {
                    at += 1;
                    (first.to_string(), if step.certificate.is_some() { "" } else { " [argued]" }.to_owned())
                }
            };
            text += &format!("  {numbers}. {}{mark}\n", step.says);
            if let Some(certificate) = step.certificate.as_ref().filter(|_| at == first) {
                text += &format!("     {certificate}\n");
            }
        }
        text
    }

    /// Checks every certificate again.
    ///
    /// # Errors
    /// The first step that does not hold; a proof in which no step has a certificate.
    pub fn recheck(&self) -> Result<(), Refutation> {
        if self.steps.iter().all(|step| step.certificate.is_none()) {
            return Err(self.refute(&self.statement, &[], "no step of the proof has a certificate"));
        }
        self.steps.iter().try_for_each(|step| self.check(step))
    }

    fn check(&self, step: &Step) -> Result<(), Refutation> {
        let Some(certificate) = &step.certificate else { return Ok(()) };
        certificate.check().map_err(|failure| {
            let counter_example: Option<Box<CounterExample>> = failure.counter_example;
            Refutation {
                id: self.id.clone(),
                equations: step.equations.clone(),
                statement: step.says.clone(),
                remainder: failure.remainder,
                counter_example,
            }
        })
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text_without(|_| None))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Expression {
        text.parse().expect("in the grammar")
    }

    fn binomial(square: &str) -> Result<Proof, Refutation> {
        let domain = Domain::positive("x y");
        Proof::new("binomial", "The binomial formula.").identity(
            "square of a sum",
            &["0"],
            &parse("(x + y)^2"),
            &parse(square),
            &domain,
        )
    }

    #[test]
    fn false_identity_is_refuted_with_remainder_and_point() {
        let refutation = binomial("x^2 + x*y + y^2").expect_err("the middle term is wrong");
        assert_eq!(refutation.remainder, "x*y");
        let example = refutation.counter_example.clone().expect("two sides");
        assert_ne!(example.left, example.right);
        assert!(refutation.to_string().contains("(equations 0); remainder: x*y; at x = "));
    }

    #[test]
    fn two_constants_that_differ_have_no_place() {
        let domain = Domain::positive("");
        let proof = Proof::new("constants", "One is zero.");
        let refutation = proof.identity("one", &["0"], &parse("1"), &parse("0"), &domain).unwrap_err();
        assert!(refutation.to_string().ends_with("; 1 instead of 0"), "{refutation}");
    }

    #[test]
    fn forged_certificate_fails_the_recheck() {
        let mut proof = binomial("x^2 + 2*x*y + y^2").expect("true");
        assert_eq!(proof.recheck(), Ok(()));
        if let Some(Certificate::Identity { right, .. }) = &mut proof.steps[0].certificate {
            *right = parse("x^2");
        }
        assert!(proof.recheck().is_err());
    }

    #[test]
    fn proof_survives_json() {
        let proof = binomial("x^2 + 2*x*y + y^2").expect("true");
        let text = serde_json::to_string(&proof).expect("serialisable");
        let read: Proof = serde_json::from_str(&text).expect("readable");
        assert_eq!(read.to_string(), proof.to_string());
        assert_eq!(read.recheck(), Ok(()));
    }

    #[test]
    fn undecided_sign_and_infinite_limit_are_refuted() {
        let domain = Domain::positive("x y");
        let proof = Proof::new("sign", "A sign.");
        assert!(proof.clone().positive("difference", &[], &parse("x - y"), &domain).is_err());
        let pole = parse("1/x");
        assert!(proof.limit("pole", &[], &pole, ("x", Toward::Zero), &parse("0"), &domain).is_err());
    }

    /// What the check says of a certificate as a file would state it.
    fn checked(certificate: &str) -> Result<(), String> {
        let step = format!(r#"{{"says": "s", "equations": [], "certificate": {certificate}}}"#);
        let text = format!(r#"{{"id": "forged", "statement": "A forged proof.", "steps": [{step}]}}"#);
        let proof: Proof = serde_json::from_str(&text).expect("readable");
        proof.recheck().map_err(|refutation| refutation.remainder)
    }

    fn sign(expression: &str, domain: &str) -> Result<(), String> {
        checked(&format!(
            r#"{{"kind": "sign", "expression": "{expression}", "sign": 1, "domain": {domain}}}"#
        ))
    }

    fn identity(left: &str, right: &str, domain: &str) -> Result<(), String> {
        checked(&format!(
            r#"{{"kind": "identity", "left": "{left}", "right": "{right}", "domain": {domain}}}"#
        ))
    }

    #[test]
    fn forged_sign_of_a_positive_variable_replaced_by_a_negative_one_is_refused() {
        let forged = r#"{"positive": ["T", "w"], "substitutions": [["T", "-w"]]}"#;
        let error = sign("-T", forged).expect_err("no positive T is −w");
        assert!(error.contains("T = -w proves its image only"), "{error}");
        let with_value =
            r#"{"positive": ["T"], "substitutions": [["T", "-w"]], "parameters": [["w", "-T"]]}"#;
        assert!(sign("-T", with_value).expect_err("−T < 0").contains("w = -T is not positive"));
        let honest = r#"{"positive": [], "given": ["-T > 0"], "substitutions": [["T", "-w"]],
            "parameters": [["w", "-T"]], "example": [["T", "-1"]]}"#;
        assert_eq!(sign("-T", honest), Ok(()));
        assert_eq!(sign("1 - T", honest), Ok(()));
    }

    #[test]
    fn forged_identity_without_its_hypothesis_is_refused() {
        let free = r#"{"positive": ["y"], "substitutions": []}"#;
        for (left, right) in [
            ("x/x", "1"),
            ("(x - x)/(x - x)", "0"),
            ("0/x", "0"),
            ("0*(1/x)", "0"),
            ("x^0", "1"),
            ("0^0", "1"),
            ("(x - y)^-1*(x - y)", "1"),
            ("sqrt(1 - x^2)^2", "1 - x^2"),
            ("ln(x) - ln(x)", "0"),
            ("y + 0/0", "y"),
        ] {
            assert!(identity(left, right, free).is_err(), "{left} = {right}");
        }
        let stated = r#"{"positive": ["y"], "given": ["x != 0", "1 - x^2 >= 0"], "substitutions": [],
            "example": [["x", "1/2"]]}"#;
        assert_eq!(identity("x/x", "1", stated), Ok(()));
        assert_eq!(identity("sqrt(1 - x^2)^2", "1 - x^2", stated), Ok(()));
        assert!(identity("(x - x)/(x - x)", "0", stated).is_err());
        // A substitution does not remove the divisor it makes zero.
        let zero = r#"{"positive": ["y"], "substitutions": [["x", "0"]]}"#;
        assert!(identity("x/(x*y)", "0", zero).is_err());
    }

    #[test]
    fn forged_substitution_that_misses_a_part_of_its_assumption_is_refused() {
        let missing = r#"{"positive": ["a", "b"], "given": ["b - a > 0"],
            "substitutions": [["b", "2*a + g"]], "parameters": [["g", "b - a"]], "example": [["b", "2"]]}"#;
        let error = sign("b - 2*a", missing).expect_err("b = 3a/2 is not reached");
        assert!(error.contains("does not reach every b"), "{error}");
        let unproved = missing.replace(r#"["g", "b - a"]"#, r#"["g", "b - 2*a"]"#);
        assert!(sign("b - 2*a", &unproved).expect_err("b < 2a").contains("g = b - 2*a is not positive"));
        let bare = r#"{"positive": ["a", "b", "g"], "substitutions": [["b", "a + g"]]}"#;
        assert!(sign("b - a", bare).expect_err("b < a is positive too").contains("proves its image only"));
        let covering = missing.replace("2*a + g", "a + g");
        assert_eq!(sign("b - a", &covering), Ok(()));
        let by_roots = r#"{"positive": ["a", "b"], "given": ["b - a > 0"], "example": [["b", "2"]],
            "substitutions": [["a", "p^2"], ["b", "(p + g)^2"]],
            "parameters": [["p", "sqrt(a)"], ["g", "sqrt(b) - sqrt(a)"]]}"#;
        assert_eq!(sign("sqrt(b) - sqrt(a)", by_roots), Ok(()));
    }

    #[test]
    fn forged_hypotheses_that_cannot_hold_are_refused() {
        let contradiction = r#"{"positive": ["a", "b"], "given": ["b - a > 0", "a - b > 0"], "substitutions": [],
            "example": [["b", "2"]]}"#;
        assert!(
            sign("1", contradiction).expect_err("nowhere").contains("a - b > 0 does not hold at the example")
        );
        let ambiguous = r#"{"positive": ["a"], "substitutions": [["x", "y"], ["y", "-x"]]}"#;
        assert!(sign("a", ambiguous).expect_err("circular").contains("stands for two things"));
    }

    #[test]
    fn forged_limit_of_a_function_that_hides_its_variable_is_refused() {
        let limit = |expression: &str, value: &str| {
            checked(&format!(
                r#"{{"kind": "limit", "expression": "{expression}", "variable": "x", "toward": "zero", "value": "{value}",
                "domain": {{"positive": ["x", "y"], "substitutions": []}}}}"#
            ))
        };
        assert_eq!(limit("x*y", "0"), Ok(()));
        assert!(limit("x*exp(1/x)", "0").expect_err("it grows").contains("depends on x"));
    }
}
