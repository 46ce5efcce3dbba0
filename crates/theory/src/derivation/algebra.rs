//! Derivations with polynomials: coefficients, discriminants, Hurwitz determinants, elimination, solutions.

use super::system::polynomial;
use super::work::{Work, expression};
use slipmode_algebra::{
    Expression, Function, Polynomial, RationalFunction, Symbol, determinant, discriminant, sylvester,
    written_out,
};

/// The largest degree of a polynomial in its variable.
const MOST_DEGREE: usize = 12;

/// The most terms of a coefficient that goes into a determinant.
const MOST_TERMS: usize = 12;

/// The coefficient of a power; of the highest one where `is_leading`, which has to be this one.
pub(super) fn coefficient(
    f: &Expression,
    x: &Symbol,
    (power, is_leading): (usize, bool),
    work: &mut Work,
) -> Result<Expression, String> {
    let degrees = if is_leading { power..=power } else { 0..=MOST_DEGREE };
    let parts = in_powers(f, x, degrees, work)?;
    Ok(parts.get(power).map_or(Expression::integer(0), expression))
}

/// The coefficients by ascending power, with the step that they are.
fn in_powers(
    f: &Expression,
    x: &Symbol,
    degrees: std::ops::RangeInclusive<usize>,
    work: &mut Work,
) -> Result<Vec<RationalFunction>, String> {
    let parts = work.coefficients(f, x, degrees)?;
    let sum = polynomial(&parts, &Expression::Variable(x.clone()));
    if sum != *f {
        work.identity(&format!("in powers of {x}"), f, &sum)?;
    }
    Ok(parts)
}

/// The discriminant of a polynomial of degree 2 or 3: a resultant, against the formula.
pub(super) fn discriminant_of(f: &Expression, x: &Symbol, work: &mut Work) -> Result<Expression, String> {
    let parts = in_powers(f, x, 2..=3, work)?;
    let (numerators, divisor) = numerators(f, work)?;
    let degree = parts.len() - 1;
    small(&numerators.coefficients(x))?;
    let over = divisor.pow(2 * u32::try_from(degree).unwrap_or(0) - 2);
    let found = RationalFunction::new(discriminant(&numerators, x), over).ok_or("a division by zero")?;
    let formula = match degree {
        2 => "c1^2 - 4*c2*c0",
        _ => "c2^2*c1^2 - 4*c3*c1^3 - 4*c2^3*c0 - 27*c3^2*c0^2 + 18*c3*c2*c1*c0",
    };
    // All names of the formula are replaced, all at once.
    let named = |(name, part): (&&'static str, &RationalFunction)| (Symbol::from(*name), expression(part));
    let formula = super::super::notation::formula(formula);
    let formula = formula.substitute(&["c0", "c1", "c2", "c3"].iter().zip(&parts).map(named).collect());
    let found = expression(&found);
    work.identity(&format!("discriminant in {x}"), &formula, &found)?;
    Ok(found)
}

/// The determinant of the first rows and columns of the Hurwitz matrix: by elimination, and written out.
pub(super) fn hurwitz(
    f: &Expression,
    x: &Symbol,
    order: usize,
    work: &mut Work,
) -> Result<Expression, String> {
    let parts = in_powers(f, x, 1..=6, work)?;
    let degree = parts.len() - 1;
    if order == 0 || order > degree.min(4) {
        return Err(format!(
            "the order of the Hurwitz determinant is {order} (allowed: 1 to {})",
            degree.min(4)
        ));
    }
    // Row i, column j has the coefficient of x^(n − 2j + i), counted from 1.
    let place = |row: usize, column: usize| (degree + row + 1).checked_sub(2 * (column + 1));
    let (numerators, divisor) = numerators(f, work)?;
    let by_power = numerators.coefficients(x);
    small(&by_power)?;
    let pick = |row: usize, column: usize| {
        place(row, column).and_then(|power| by_power.get(power)).cloned().unwrap_or_default()
    };
    let matrix: Vec<Vec<_>> =
        (0..order).map(|row| (0..order).map(|column| pick(row, column)).collect()).collect();
    let over = divisor.pow(u32::try_from(order).unwrap_or(0));
    let found = RationalFunction::new(determinant(&matrix), over).ok_or("a division by zero")?;
    let entry = |row: usize, column: usize| {
        place(row, column).and_then(|power| parts.get(power)).map_or(Expression::integer(0), expression)
    };
    let rows: Vec<Vec<_>> =
        (0..order).map(|row| (0..order).map(|column| entry(row, column)).collect()).collect();
    let found = expression(&found);
    work.identity(&format!("Hurwitz determinant of order {order} in {x}"), &written_out(&rows), &found)?;
    Ok(found)
}

/// The resultant R of P and Q, with R = A·P + B·Q: it is zero wherever both are.
pub(super) fn eliminate(
    p: &Expression,
    q: &Expression,
    x: &Symbol,
    work: &mut Work,
) -> Result<Expression, String> {
    let [left, right] = [p, q].map(|f| work.coefficients(f, x, 1..=4).map(|parts| parts.len() - 1));
    let (left, right) = (left?, right?);
    let size = left + right;
    if size > 6 {
        return Err(format!("the degrees in {x} are {left} and {right} (allowed: a sum of at most 6)"));
    }
    let [(above, below), (upper, lower)] = [numerators(p, work)?, numerators(q, work)?];
    small(&above.coefficients(x))?;
    small(&upper.coefficients(x))?;
    let rows = sylvester(&above, &upper, x);
    // Cramer's rule for the last column: each row times its cofactor there.
    let cofactor = |at: usize| {
        let others = rows.iter().enumerate().filter(|(row, _)| *row != at);
        let minor = determinant(&others.map(|(_, row)| row[..size - 1].to_vec()).collect::<Vec<_>>());
        if (at + size) % 2 == 1 { minor } else { -&minor }
    };
    let powers = |from: usize, count: usize| {
        let power = |shift: usize| Polynomial::variable(x).pow((count - 1 - shift) as u32);
        let term = |shift: usize| &cofactor(from + shift) * &power(shift);
        (0..count).map(term).fold(Polynomial::zero(), |sum, part| &sum + &part)
    };
    let over = &below.pow(right as u32) * &lower.pow(left as u32);
    let scaled = |found: Polynomial| RationalFunction::new(found, over.clone()).ok_or("a division by zero");
    let a = expression(&scaled(&powers(0, right) * &below)?);
    let b = expression(&scaled(&powers(right, left) * &lower)?);
    let found = expression(&scaled(determinant(&rows))?);
    work.identity(
        &format!("what vanishes with both: a sum of multiples of them without {x}"),
        &(a * p.clone() + b * q.clone()),
        &found,
    )?;
    Ok(found)
}

/// The one value at which f = 0: f is linear in x, or x is positive and f is k·(x² − c).
pub(super) fn solve(f: &Expression, x: &Symbol, work: &mut Work) -> Result<Expression, String> {
    let (numerator, divisor) = numerators(f, work)?;
    let cleared = if divisor.degree(x) > 0 { expression(&numerator.into()) } else { f.clone() };
    if cleared != *f {
        let product = f.clone() * expression(&divisor.into());
        work.identity("without its denominator, which is not zero", &product, &cleared)?;
    }
    let parts = in_powers(&cleared, x, 1..=2, work)?;
    let degree = parts.len() - 1;
    let leading = expression(&parts[degree]);
    if degree == 2 && !(parts[1].is_zero() && work.domain.is_positive(x)) {
        return Err(format!(
            "'{f}' = 0 may have several solutions: it must be linear in {x}, or {x} be positive and occur as {x}^2 only"
        ));
    }
    work.not_zero(&format!("the factor of {x}^{degree} is not zero").replace("^1 ", " "), &leading)?;
    let ratio = -(&parts[0] / &parts[degree]);
    let mut solution = expression(&ratio);
    if degree == 2 {
        let says = format!("{x}^2 is positive");
        work.step(|proof, equations, domain| proof.positive(&says, equations, &solution, domain))
            .map_err(|_| format!("{x}^2 = {solution} is not found to be positive under the assumptions"))?;
        solution = solution.call(Function::Sqrt);
    }
    let solution = work.simplified("in lowest terms", &solution)?;
    work.identity(
        &format!("put back for {x}, it gives zero"),
        &f.with(x, &solution),
        &Expression::integer(0),
    )?;
    Ok(solution)
}

/// Numerator and denominator of what is a polynomial in the variable at hand.
fn numerators(f: &Expression, work: &Work) -> Result<(Polynomial, Polynomial), String> {
    let function = work.rational(f)?;
    Ok((function.numerator().clone(), function.denominator().clone()))
}

fn small(parts: &[Polynomial]) -> Result<(), String> {
    let most = parts.iter().map(Polynomial::term_count).max().unwrap_or(0);
    if most > MOST_TERMS {
        return Err(format!("a coefficient has {most} terms (allowed: at most {MOST_TERMS})"));
    }
    Ok(())
}
