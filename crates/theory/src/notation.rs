//! Formulas and assumptions that the proofs share.

use slipmode_algebra::{
    Domain, Expression, Polynomial, Proof, RationalFunction, Refutation, Symbol, discriminant, nearest,
};

/// The physical quantities, all positive.
const QUANTITIES: &str = "a b D_c K M sigma V V_0 theta mu_0";

/// A formula written in the program text.
///
/// # Panics
/// When the text is not of the grammar: a slip in the program text, which the test of the module shows.
pub(super) fn formula(text: &str) -> Expression {
    text.parse().unwrap_or_else(|error| panic!("formula {text}: {error}"))
}

/// The part of a message that names the known word nearest to a written one; empty where none is near.
pub(super) fn did_you_mean<'k>(written: &str, known: impl IntoIterator<Item = &'k str>) -> String {
    nearest(written, known).map(|near| format!("; did you mean `{near}`?")).unwrap_or_default()
}

/// All physical quantities are positive, nothing is assumed about a − b.
pub(super) fn any() -> Domain {
    Domain::positive(QUANTITIES)
}

/// An equation in dimensionless groups: the unit of time is D_c/V_0, of length D_c, of stress a·σ.
///
/// For an equation that is homogeneous in units this is the general case; `characteristic::dimensionless` proves it for
/// eq 8, the steps named "in groups" for the others.
pub(super) fn in_groups(expression: &Expression) -> Expression {
    let values = [
        ("a", "1"),
        ("D_c", "1"),
        ("V_0", "1"),
        ("sigma", "1"),
        ("M", "eta"),
        ("K", "kappa"),
        ("b", "beta"),
        ("s", "p"),
    ];
    expression.substitute(&values.map(|(name, value)| (Symbol::from(name), formula(value))).into())
}

/// The coefficients by ascending power; none where the variable occurs in the denominator or inside a function.
pub(super) fn polynomial_coefficients(
    function: &RationalFunction,
    name: &Symbol,
) -> Option<Vec<RationalFunction>> {
    if function.denominator().degree(name) > 0 || function.hides(name).is_some() {
        return None;
    }
    let quotient = |part: Polynomial| RationalFunction::new(part, function.denominator().clone());
    function.numerator().coefficients(name).into_iter().map(quotient).collect()
}

/// The coefficients of a polynomial equation by ascending power of one variable.
///
/// # Errors
/// A refutation that names the equation, when it is no polynomial in that variable of the wanted degree.
pub(super) fn coefficients<const COUNT: usize>(
    proof: &Proof,
    equation: &[&str],
    expression: &Expression,
    variable: &'static str,
) -> Result<[Expression; COUNT], Refutation> {
    let function = rational(proof, equation, expression, &any())?;
    polynomial_coefficients(&function, &variable.into())
        .and_then(|parts| <[RationalFunction; COUNT]>::try_from(parts).ok())
        .map(|parts| parts.each_ref().map(Expression::from))
        .ok_or_else(|| {
            let says = format!("a polynomial of degree {} in {variable}", COUNT - 1);
            proof.refute(&says, equation, expression.to_string())
        })
}

/// The most terms of a coefficient of eq 8 whose discriminant is multiplied out: it has five terms of degree 4 in them.
const MAX_COEFFICIENT_TERMS: usize = 8;

/// The discriminant of eq 8 in one variable, up to the factor that makes it a polynomial.
///
/// # Errors
/// When it is no cubic, or too large.
pub(super) fn discriminant_of_cubic(
    proof: &Proof,
    cited: &[&str],
    expression: &Expression,
    variable: &'static str,
    domain: &Domain,
) -> Result<Polynomial, Refutation> {
    let function = rational(proof, cited, expression, domain)?;
    let name = Symbol::from(variable);
    let cubic = function.numerator();
    let terms = cubic.coefficients(&name).iter().map(Polynomial::term_count).max().unwrap_or(0);
    if cubic.degree(&name) != 3 || function.hides(&name).is_some() || terms > MAX_COEFFICIENT_TERMS {
        let says =
            format!("a cubic in {variable} whose coefficients have at most {MAX_COEFFICIENT_TERMS} terms");
        return Err(proof.refute(&says, cited, expression.to_string()));
    }
    Ok(discriminant(cubic, &name))
}

/// The expression in lowest terms.
///
/// # Errors
/// A refutation that names the equations, when it is no rational function.
pub(super) fn simplified(
    proof: &Proof,
    equations: &[&str],
    expression: &Expression,
    domain: &Domain,
) -> Result<Expression, Refutation> {
    Ok(Expression::from(&rational(proof, equations, expression, domain)?))
}

/// The expression as a rational function.
///
/// # Errors
/// A refutation that names the equations, when it is none.
pub(super) fn rational(
    proof: &Proof,
    equations: &[&str],
    expression: &Expression,
    domain: &Domain,
) -> Result<RationalFunction, Refutation> {
    domain.rational_function(expression).map_err(|error| {
        proof.refute("an expression of the derivation is no rational function", equations, error.to_string())
    })
}

/// The first attempt that succeeds, else the first refusal; none where nothing was attempted.
pub(super) fn first_success<I, T>(
    items: impl IntoIterator<Item = I>,
    mut attempt: impl FnMut(I) -> Result<T, Refutation>,
) -> Result<T, Option<Refutation>> {
    let mut refused = None;
    for item in items {
        match attempt(item) {
            Ok(found) => return Ok(found),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    Err(refused)
}
