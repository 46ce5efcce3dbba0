//! Autonomous systems of first order: their steady state, and what follows from it.

use super::work::Work;
use slipmode_algebra::{Expression, Linearisation, RationalFunction, Symbol};

/// An autonomous system of ordinary differential equations of first order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct System {
    /// Its name.
    pub name: String,
    /// The variables that move.
    pub state: Vec<Symbol>,
    /// Their rates.
    pub rates: Vec<Expression>,
    /// Their values at which all rates are zero; empty where none are stated.
    pub steady: Vec<Expression>,
}

/// The most states: a determinant of so many rows is written out in its certificate.
pub(crate) const MOST_STATES: usize = 6;

impl System {
    /// The system with its rates and steady values changed.
    #[must_use]
    pub fn map(&self, change: impl Fn(&Expression) -> Expression) -> Self {
        let all = |list: &[Expression]| list.iter().map(&change).collect();
        Self { rates: all(&self.rates), steady: all(&self.steady), ..self.clone() }
    }

    /// A state variable as an expression.
    pub(crate) fn variable(&self, index: usize) -> Expression {
        Expression::variable(&self.state[index])
    }

    /// An expression at the steady state.
    #[must_use]
    pub fn at_rest(&self, expression: &Expression) -> Expression {
        expression.substitute(&self.state.iter().cloned().zip(self.steady.iter().cloned()).collect())
    }

    /// The rate of change of an expression along the motions.
    #[must_use]
    pub fn rate_of(&self, expression: &Expression) -> Expression {
        let term = |(name, rate): (&Symbol, &Expression)| expression.derivative(name) * rate.clone();
        self.state.iter().zip(&self.rates).map(term).fold(Expression::integer(0), |sum, part| sum + part)
    }

    /// Proves that the rates are zero at the steady state, and that its values are positive where their variables are.
    ///
    /// # Errors
    /// What is not so.
    pub(crate) fn rest(&self, work: &mut Work) -> Result<(), String> {
        for ((name, rate), value) in self.state.iter().zip(&self.rates).zip(&self.steady) {
            work.rational(value).map_err(|error| format!("the steady value of {name}: {error}"))?;
            if work.domain.is_positive(name) && work.domain.sign(value) != Ok(Some(1)) {
                return Err(format!(
                    "the steady value {value} of the positive {name} is not found to be positive"
                ));
            }
            let says = format!("the rate of {name} is zero at the steady state of {}", self.name);
            work.identity(&says, &self.at_rest(rate), &Expression::integer(0)).map_err(|remainder| {
                format!("the rate of {name} is not zero at the steady state: {remainder}")
            })?;
        }
        Ok(())
    }

    /// The rate of change of an expression along the motions, with its derivatives as steps.
    pub(super) fn rate(&self, expression: &Expression, work: &mut Work) -> Result<Expression, String> {
        for name in &self.state {
            work.derivative("it", expression, name)?;
        }
        work.simplified(&format!("its rate along the motions of {}", self.name), &self.rate_of(expression))
    }

    /// The slope of one rate in one state at the steady state, with the step that it is the derivative.
    pub(super) fn slope(&self, rate: usize, by: usize, work: &mut Work) -> Result<Expression, String> {
        work.derivative(&format!("the rate of {}", self.state[rate]), &self.rates[rate], &self.state[by])?;
        self.entry(rate, by, work)
    }

    /// The slope of one rate in one state at the steady state, in lowest terms.
    fn entry(&self, rate: usize, by: usize, work: &mut Work) -> Result<Expression, String> {
        if self.steady.is_empty() {
            return Err(format!("the system {} states no steady state", self.name));
        }
        let raw = self.at_rest(&self.rates[rate].derivative(&self.state[by]));
        let [rate, by] = [rate, by].map(|index| &self.state[index]);
        work.simplified(
            &format!("slope of the rate of {rate} in {by} at the steady state of {}", self.name),
            &raw,
        )
    }

    /// det(s − J) with the matrix J of all slopes: by traces of powers of J, with the certificate of rates, slopes and determinant.
    pub(super) fn characteristic(&self, variable: &Symbol, work: &mut Work) -> Result<Expression, String> {
        let size = self.state.len();
        let mut slopes = Vec::new();
        for rate in 0..size {
            slopes.push((0..size).map(|by| self.entry(rate, by, work)).collect::<Result<Vec<_>, _>>()?);
        }
        let matrix = slopes
            .iter()
            .map(|row| row.iter().map(|slope| work.rational(slope)).collect::<Result<Vec<_>, _>>())
            .collect::<Result<Vec<_>, _>>()?;
        let polynomial = polynomial(&by_traces(&matrix), &Expression::Variable(variable.clone()));
        let says =
            format!("determinant of {variable} − J with the slopes J of {} at its steady state", self.name);
        let (state, rates, steady) = (self.state.clone(), self.rates.clone(), self.steady.clone());
        let system = Linearisation { state, rates, steady, slopes };
        let certificate = system.certificate(variable, polynomial.clone(), work.domain.clone());
        work.step(|proof, equations, _| proof.certify(&says, equations, certificate))?;
        Ok(polynomial)
    }
}

/// The coefficients of det(s − J) by ascending power (Faddeev and LeVerrier).
fn by_traces(matrix: &[Vec<RationalFunction>]) -> Vec<RationalFunction> {
    let size = matrix.len();
    let zero = || vec![vec![RationalFunction::from(0); size]; size];
    let mut coefficients = vec![RationalFunction::from(1)];
    let mut power = zero();
    for step in 1..=size {
        // M_k = J·M_(k−1) + c_(k−1)·1, c_k = −tr(J·M_k)/k.
        for (index, row) in power.iter_mut().enumerate() {
            row[index] = &row[index] + &coefficients[step - 1];
        }
        let mut next = zero();
        for (row, column) in (0..size).flat_map(|row| (0..size).map(move |column| (row, column))) {
            let products = (0..size).map(|inner| &matrix[row][inner] * &power[inner][column]);
            next[row][column] = products.fold(RationalFunction::from(0), |sum, product| sum + product);
        }
        let trace = (0..size).fold(RationalFunction::from(0), |sum, index| sum + &next[index][index]);
        let count = RationalFunction::from(i32::try_from(step).unwrap_or(i32::MAX));
        coefficients.push(-(trace / count));
        power = next;
    }
    coefficients.reverse();
    coefficients
}

/// Σ coefficients[k]·x^k.
pub(super) fn polynomial(coefficients: &[RationalFunction], x: &Expression) -> Expression {
    let term = |(power, coefficient): (usize, &RationalFunction)| {
        super::work::expression(coefficient) * x.clone().power(power as i32)
    };
    coefficients.iter().enumerate().rev().map(term).fold(Expression::integer(0), |sum, part| sum + part)
}
