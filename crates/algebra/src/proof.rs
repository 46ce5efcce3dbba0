//! Proofs as values: what is claimed, over which variables, and the certificates it rests on.

use std::fmt;

use super::check::Failure;
use super::{Certificate, Domain, Expression, Refutation};

/// One step of a proof.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Step {
    /// The step in words.
    pub says: String,
    /// The equations of the paper that enter it.
    pub equations: Vec<String>,
    /// What can be computed again; a step of plain reasoning has none.
    pub certificate: Option<Certificate>,
    /// The statements of the lemmas whose proofs begin with this step.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub begins: Vec<String>,
}

impl Step {
    fn new(says: impl Into<String>, equations: &[&str], certificate: Option<Certificate>) -> Self {
        let equations = equations.iter().map(|&number| number.to_owned()).collect();
        Self { says: says.into(), equations, certificate, begins: Vec::new() }
    }

    /// Whether both say and certify the same.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        (&self.says, &self.equations, &self.certificate)
            == (&other.says, &other.equations, &other.certificate)
    }
}

/// A line of a written proof.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Line<'p> {
    /// The statement of a lemma, whose steps follow.
    Lemma(&'p str),
    /// Steps that are written elsewhere.
    Elsewhere {
        /// The first and the last of them.
        numbers: [usize; 2],
        /// What stands in their place.
        words: String,
    },
    /// A step.
    Step {
        /// Its number from 1.
        number: usize,
        /// The step.
        step: &'p Step,
    },
}

impl Line<'_> {
    /// The numbers of its steps, such as `3` or `3-7`; empty for a lemma's statement.
    #[must_use]
    pub fn numbers(&self) -> String {
        match self {
            Self::Lemma(_) => String::new(),
            Self::Elsewhere { numbers: [first, last], .. } if last > first => format!("{first}-{last}"),
            Self::Elsewhere { numbers: [number, _], .. } | Self::Step { number, .. } => number.to_string(),
        }
    }
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
    /// The theorem that states the whole and that an independent kernel has accepted, by its name.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub theorem: Option<String>,
}

impl Proof {
    /// Whether every step carries a certificate; a step without one is argued in words.
    #[must_use]
    pub fn is_certified(&self) -> bool {
        self.steps.iter().all(|step| step.certificate.is_some())
    }

    /// Whether both prove the same by the same steps, whichever theorem states it.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        (&self.id, &self.statement, &self.steps) == (&other.id, &other.statement, &other.steps)
    }

    /// The beginning of a proof of this statement.
    #[must_use]
    pub fn new(id: &str, statement: impl Into<String>) -> Self {
        Self { id: id.to_owned(), statement: statement.into(), steps: Vec::new(), theorem: None }
    }

    /// Adds a step of plain reasoning, which rests on the steps before it.
    #[must_use]
    pub fn reason(mut self, says: impl Into<String>) -> Self {
        self.steps.push(Step::new(says, &[], None));
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
        let step = Step::new(says, equations, Some(certificate));
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

    /// The refutation of a step that cannot even be written down, for this reason.
    #[must_use]
    pub fn refute(&self, says: &str, equations: &[&str], remainder: impl Into<String>) -> Refutation {
        Refutation {
            id: self.id.clone(),
            equations: equations.iter().map(|&number| number.to_owned()).collect(),
            statement: says.to_owned(),
            remainder: remainder.into(),
            is_false: false,
            counter_example: None,
        }
    }

    /// Adds all steps of another proof, which this one rests on.
    #[must_use]
    pub fn using(mut self, mut lemma: Self) -> Self {
        if let Some(first) = lemma.steps.first_mut() {
            first.begins.insert(0, lemma.statement);
        }
        self.steps.extend(lemma.steps);
        self
    }

    /// The proof line by line. `elsewhere` is asked with the steps from each one on: it says how many of them are written
    /// elsewhere, and what stands in their place, a lemma's statement first.
    #[must_use]
    pub fn lines_without(&self, elsewhere: impl Fn(&[Step]) -> Option<(usize, String)>) -> Vec<Line<'_>> {
        let mut lines = Vec::new();
        let mut at = 0;
        while let Some(step) = self.steps.get(at) {
            let first = at + 1;
            let replaced = elsewhere(&self.steps[at..]);
            let words = replaced.as_ref().map_or("", |(_, words)| words.as_str());
            let stated = step.begins.iter().take_while(|lemma| !words.starts_with(lemma.as_str()));
            lines.extend(stated.map(|lemma| Line::Lemma(lemma)));
            at += replaced.as_ref().map_or(1, |(count, _)| (*count).max(1));
            lines.push(match replaced {
                Some((_, words)) => Line::Elsewhere { numbers: [first, at], words },
                None => Line::Step { number: first, step },
            });
        }
        lines
    }

    /// The same lines as text.
    #[must_use]
    pub fn text_without(&self, elsewhere: impl Fn(&[Step]) -> Option<(usize, String)>) -> String {
        let mut text = format!("{}: {}\n", self.id, self.statement);
        for line in self.lines_without(elsewhere) {
            text += &match &line {
                Line::Lemma(lemma) => format!("  Lemma: {lemma}\n"),
                Line::Elsewhere { words, .. } => format!("  {}. {words}\n", line.numbers()),
                Line::Step { step, .. } => {
                    let mark = if step.certificate.is_some() { "" } else { " [argued]" };
                    format!("  {}. {}{mark}\n", line.numbers(), step.says)
                }
            };
            if let Line::Step { step: Step { certificate: Some(certificate), .. }, .. } = line {
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
        certificate.check().map_err(|Failure { remainder, is_false, counter_example }| {
            let equations = step.equations.clone();
            Refutation { equations, is_false, counter_example, ..self.refute(&step.says, &[], remainder) }
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
    use crate::Toward;

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
    fn both_sides_have_their_values_at_the_printed_point() {
        let (domain, sides) = (Domain::positive("x y"), ["x/y", "(x + 1)/(y + x)"].map(parse));
        let proof = Proof::new("quotients", "Two quotients.");
        let refutation = proof.identity("q", &[], &sides[0], &sides[1], &domain).expect_err("they differ");
        let example = refutation.counter_example.expect("two sides");
        let point = example.point.iter().map(|(name, value)| (name.clone(), value.clone())).collect();
        for (side, value) in sides.iter().zip([example.left, example.right]) {
            let found = Domain::default().rational_function(&side.substitute(&point)).unwrap();
            assert_eq!(found.as_constant().map(Expression::Number), Some(value));
        }
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
    fn values_are_compared_as_numbers() {
        let point = || vec![("x".into(), parse("2"))];
        let certify = |certificate| Proof::new("values", "Two values.").certify("one", &[], certificate);
        let difference = |right: &str, values: [&str; 2]| {
            let [left, right] = ["x", right].map(parse);
            certify(Certificate::Difference { left, right, point: point(), values: values.map(parse) })
        };
        assert!(difference("x + 1", ["2", "3"]).is_ok() && difference("x + 1", ["1 + 1", "6/2"]).is_ok());
        let refutation = difference("x", ["2", "1 + 1"]).expect_err("two is not two");
        assert_eq!(refutation.remainder, "both sides are 2 there");
        assert!(difference("x", ["2", "3"]).is_err());
        let value = |expression: &str, value: &str| {
            let (expression, value) = (parse(expression), parse(value));
            certify(Certificate::Value { expression, point: point(), value })
        };
        assert!(value("x^2", "1 + 3").is_ok());
        // What the point leaves open is no value, and two of them may be equal.
        let refutation = value("x*y", "2*y").expect_err("y has no value");
        assert_eq!(refutation.remainder, "the value 2*y is not a number");
        assert!(difference("y", ["2", "y"]).is_err());
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
        let (variable, toward, value) = ("x".into(), Toward::Zero, parse("0"));
        let limit = Certificate::Limit { expression: pole, variable, toward, value, domain };
        assert!(proof.certify("pole", &[], limit).is_err());
    }

    #[test]
    fn a_lemma_is_named_where_its_proof_begins_and_adds_no_step() {
        let lemma = binomial("x^2 + 2*x*y + y^2").expect("true");
        let whole = Proof::new("whole", "More.").using(Proof::new("part", "A part.").using(lemma.clone()));
        assert!(whole.steps[0].is_same(&lemma.steps[0]) && whole.steps.len() == 1 && whole.is_certified());
        assert!(whole.to_string().contains("Lemma: A part.\n  Lemma: The binomial formula.\n  1. "));
    }

    #[test]
    fn proofs_of_other_names_statements_or_steps_are_not_the_same() {
        let (domain, two) = (Domain::positive("x"), Proof::new("two", "Two signs."));
        let whole = two.positive("p", &[], &parse("x"), &domain).and_then(|one| {
            one.certify("n", &[], Certificate::Sign { expression: parse("-x"), sign: -1, domain })
        });
        let whole = whole.expect("true");
        assert!(whole.is_certified() && !whole.clone().reason("argued").is_certified());
        let others = [
            Proof { id: "other".into(), ..whole.clone() },
            Proof { statement: "Other.".into(), ..whole.clone() },
            whole.clone().reason("argued"),
        ];
        assert!(whole.is_same(&whole.clone()) && others.iter().all(|other| !whole.is_same(other)));
        assert!(!whole.steps[0].is_same(&whole.steps[1]));
        let lines = whole.lines_without(|steps| Some((steps.len(), "elsewhere".to_owned())));
        assert_eq!(lines[0].numbers(), "1-2");
        assert_eq!(whole.lines_without(|_| Some((1, "elsewhere".to_owned())))[1].numbers(), "2");
    }
}
