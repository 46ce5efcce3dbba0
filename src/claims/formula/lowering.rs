//! Formulas as signs of expressions: definitions are put in, and predicates become signs of coefficients by general lemmas.

use slipmode_algebra::{Expression, Literal, Proof, Sign, SignFormula, Symbol};
use slipmode_theory::root_location::{self, MOST_DEGREE, coefficients, pair_crosses};

use crate::scene::{Formula, Names, Premises};

/// A formula as signs, with what its predicates rest on.
pub(super) struct Lowered {
    /// The whole formula.
    pub signs: SignFormula,
    /// Its comparisons and predicates.
    pub atoms: Vec<(Formula, SignFormula)>,
    /// The general lemmas.
    pub lemmas: Vec<Proof>,
    /// The polynomials, each in words, as it is written and by its coefficients.
    pub polynomials: Vec<(String, Expression, Expression)>,
}

impl Lowered {
    /// # Errors
    /// Why a predicate has no signs.
    pub fn new(formula: &Formula, names: &Names, premises: &Premises) -> Result<Self, String> {
        let signs = SignFormula::All(Vec::new());
        let mut lowered = Self { signs, atoms: Vec::new(), lemmas: Vec::new(), polynomials: Vec::new() };
        for atom in formula.atoms() {
            let signs = lowered.atom(atom, names, premises)?;
            lowered.atoms.push((atom.clone(), signs));
        }
        let known =
            |atom: &Formula| lowered.atoms.iter().find(|(known, _)| known == atom).map(|(_, signs)| signs);
        lowered.signs = formula.signs(&|atom| known(atom).cloned().unwrap_or(SignFormula::Any(Vec::new())));
        Ok(lowered)
    }

    /// The expressions of which the signs are.
    pub fn expressions(&self) -> Vec<Expression> {
        self.signs.literals().into_iter().map(|literal| literal.expression.clone()).collect()
    }

    fn atom(&mut self, atom: &Formula, names: &Names, premises: &Premises) -> Result<SignFormula, String> {
        let put_in = |side: &Expression| premises.put_in(&names.resolved(side));
        match atom {
            Formula::Compare(left, comparison, right) => {
                Ok(SignFormula::Literal(comparison.literal(put_in(left), put_in(right))))
            }
            Formula::Roots(statement, polynomial, variable) => {
                let found = self.coefficients(polynomial, names, variable, premises)?;
                self.rest_on(statement.lemma(found.len() - 1).map_err(|error| error.to_string())?);
                Ok(statement.signs(&found))
            }
            Formula::Crossing(crossing) => {
                let polynomial = &crossing.polynomial;
                let found = self.coefficients(polynomial, names, &crossing.variable, premises)?;
                let [critical, frequency] = [&crossing.critical, &crossing.frequency].map(put_in);
                let crosses = pair_crosses(&found, &crossing.parameter, &critical, &frequency);
                let (signs, lemma) = crosses.map_err(|error| error.to_string())?;
                self.rest_on(lemma);
                // The critical value has to meet what is assumed of the parameter.
                let parameter = &crossing.parameter;
                let positive = premises.positive.contains(parameter);
                let positive = positive.then(|| Literal::new(critical.clone(), Sign::Positive));
                let of_parameter = |one: &&Literal| one.expression.variables().contains(parameter);
                let there = premises.conditions.iter().filter(of_parameter);
                let there =
                    there.map(|one| Literal::new(one.expression.with(parameter, &critical), one.sign));
                let assumed = there.chain(positive).map(SignFormula::Literal);
                Ok(SignFormula::All(assumed.chain([signs]).collect()))
            }
            _ => Ok(SignFormula::Any(Vec::new())),
        }
    }

    fn rest_on(&mut self, lemma: Proof) {
        if !self.lemmas.contains(&lemma) {
            self.lemmas.push(lemma);
        }
    }

    /// The coefficients of a polynomial, noted with the polynomial.
    fn coefficients(
        &mut self,
        written: &Expression,
        names: &Names,
        variable: &Symbol,
        premises: &Premises,
    ) -> Result<Vec<Expression>, String> {
        let (side, found) = located(written, names, variable, premises)?;
        let right = root_location::polynomial(&found, variable);
        let step = (format!("the coefficients of {written} as a polynomial in {variable}"), side, right);
        if !self.polynomials.contains(&step) {
            self.polynomials.push(step);
        }
        Ok(found)
    }
}

/// A polynomial with definitions and solutions in place, and its coefficients by ascending power.
///
/// # Errors
/// Why it has none.
pub(super) fn located(
    written: &Expression,
    names: &Names,
    variable: &Symbol,
    premises: &Premises,
) -> Result<(Expression, Vec<Expression>), String> {
    let side = premises.put_in(&names.resolved_but(written, variable));
    let function = premises.domain().rational_function(&side);
    let function = function.map_err(|error| format!("{written}: {error}"))?;
    let found = coefficients(&function, variable, MOST_DEGREE)
        .ok_or_else(|| format!("{written} is no polynomial of degree 1 to {MOST_DEGREE} in {variable}"))?;
    Ok((side, found))
}

/// A comparison or predicate as it is written.
pub(super) fn words(atom: &Formula) -> String {
    match atom {
        Formula::Compare(left, comparison, right) => format!("{left} {} {right}", comparison.as_str()),
        Formula::Roots(statement, polynomial, variable) => {
            format!("{}({polynomial}, {variable})", statement.as_str())
        }
        Formula::Crossing(crossing) => format!(
            "pair_crosses({}, {}, {}, {}, {})",
            crossing.polynomial, crossing.variable, crossing.parameter, crossing.critical, crossing.frequency
        ),
        _ => String::new(),
    }
}
