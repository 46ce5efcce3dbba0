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

    /// Checks every certificate again.
    ///
    /// # Errors
    /// The first step that does not hold.
    pub fn recheck(&self) -> Result<(), Refutation> {
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
        writeln!(formatter, "{}: {}", self.id, self.statement)?;
        for (index, step) in self.steps.iter().enumerate() {
            writeln!(formatter, "  {}. {}", index + 1, step.says)?;
            if let Some(certificate) = &step.certificate {
                writeln!(formatter, "     {certificate}")?;
            }
        }
        Ok(())
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
}
