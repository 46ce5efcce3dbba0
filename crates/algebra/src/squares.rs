//! Polynomials that are nowhere negative because they are sums of squares, and products of these with squares.
//!
//! A square is completed where a term has the wrong sign: c m² + b m t = c (m + b t/(2c))² − b² t²/(4c). What is left has to have terms
//! of the right sign only. Whatever is found is multiplied out again and compared, so that the search decides nothing.

use rug::Rational;

use super::{Generator, Monomial, Polynomial, within_budget};

/// The most terms, and the largest degree, of a polynomial that is tried: others are left undecided.
const MOST_TERMS: usize = 40;
const MOST_DEGREE: u32 = 16;

/// How often a square is completed in one search, and how many squares a sum has at most: numbers double their length with each.
const MOST_TRIED: usize = 60;
const MOST_SQUARES: usize = 8;

/// The most steps of one search.
const STEPS: u64 = 50_000;

/// What is known of the values of generators.
pub(super) struct Known<'k> {
    /// Is it positive?
    pub positive: &'k dyn Fn(&Generator) -> bool,
    /// Is it positive or zero?
    pub not_negative: &'k dyn Fn(&Generator) -> bool,
}

impl Known<'_> {
    /// A term with this monomial and a positive coefficient is not negative.
    fn allows(&self, monomial: &Monomial) -> bool {
        monomial.factors().all(|(name, exponent)| exponent % 2 == 0 || (self.not_negative)(name))
    }

    /// The first and the last term of any such sum, and of its product with a square, are not negative.
    fn allows_ends(&self, polynomial: &Polynomial) -> bool {
        let mut ends = polynomial.terms().take(1).chain(polynomial.terms().next_back());
        !polynomial.is_zero() && ends.all(|(monomial, coefficient)| *coefficient > 0 && self.allows(monomial))
    }

    /// A polynomial that has a term in positive generators, and no term below zero, is positive.
    fn has_positive_term(&self, polynomial: &Polynomial) -> bool {
        polynomial.terms().any(|(monomial, coefficient)| {
            *coefficient > 0 && monomial.factors().all(|(name, _)| (self.positive)(name))
        })
    }
}

/// Whether a polynomial in real generators is positive everywhere (`Some(true)`) or at least nowhere negative (`Some(false)`).
pub(super) fn as_squares(polynomial: &Polynomial, known: &Known<'_>) -> Option<bool> {
    let is_small = polynomial.term_count() <= MOST_TERMS && polynomial.total_degree() <= MOST_DEGREE;
    if !is_small || !known.allows_ends(polynomial) || polynomial.generators().iter().any(is_imaginary) {
        return None;
    }
    let found = within_budget(STEPS, || {
        let (rest, squared) = without_squares(polynomial);
        let is_positive = sum_of_squares(&rest, known).or_else(|| square_and_rest(&rest, known))?;
        Some(is_positive && squared.iter().all(|factor| sum_of_squares(factor, known) == Some(true)))
    });
    found.ok().flatten()
}

/// Whether the imaginary unit is in it.
pub(super) fn is_imaginary(generator: &Generator) -> bool {
    generator.variables().iter().any(|name| name.as_str() == "i")
}

/// polynomial = rest · Π factor², with the factors.
fn without_squares(polynomial: &Polynomial) -> (Polynomial, Vec<Polynomial>) {
    let (mut rest, mut factors) = (polynomial.clone(), Vec::new());
    while let Some((quotient, factor)) = rest.generators().iter().find_map(|name| square_factor(&rest, name))
    {
        rest = quotient;
        factors.push(factor);
    }
    (rest, factors)
}

fn product(factors: &[Polynomial]) -> Polynomial {
    factors.iter().fold(Polynomial::one(), |product, factor| &product * factor)
}

/// A factor that occurs twice, as its derivative shows, and the quotient by its square.
fn square_factor(polynomial: &Polynomial, name: &Generator) -> Option<(Polynomial, Polynomial)> {
    if polynomial.degree(name) < 2 || !may_have_square(polynomial, name) {
        return None;
    }
    let shared = polynomial.gcd(&polynomial.derivative(name));
    let factor = shared.gcd(&polynomial.divide_exact(&shared)?);
    let quotient = polynomial.divide_exact(&factor)?.divide_exact(&factor)?;
    factor.as_constant().is_none().then_some((quotient, factor))
}

/// A polynomial as Σ root²·terms, where no term of the factors is negative.
pub(super) fn addends(polynomial: &Polynomial, known: &Known<'_>) -> Option<Vec<(Polynomial, Polynomial)>> {
    let found = within_budget(STEPS, || {
        let (rest, squared) = without_squares(polynomial);
        let root = product(&squared);
        let mut parts = match squares_and_terms(&rest, known) {
            Some((squares, terms)) => {
                let squares = squares.into_iter().map(|(factor, root)| (root, Polynomial::constant(factor)));
                squares.chain([(Polynomial::one(), terms)]).collect()
            }
            None => rest.generators().iter().find_map(|x| {
                let (factor, square, left) = square_in(&rest, x)?;
                let mut parts = if left.is_zero() { Vec::new() } else { addends(&left, known)? };
                parts.push((square, Polynomial::constant(factor)));
                Some(parts)
            })?,
        };
        parts.iter_mut().for_each(|(own, _)| *own = &*own * &root);
        parts.retain(|(_, terms)| !terms.is_zero());
        Some(parts)
    });
    found.ok().flatten()
}

/// Whether a factor in this generator may occur twice: it does then at any values of the others at which the degree stays.
fn may_have_square(polynomial: &Polynomial, name: &Generator) -> bool {
    let others = polynomial.generators().into_iter().filter(|other| other != name);
    let there = others.zip(2_u32..).fold(polynomial.clone(), |there, (other, value)| {
        there.substitute(&other, &Polynomial::constant(Rational::from(2 * value - 1)))
    });
    there.degree(name) < polynomial.degree(name) || there.gcd(&there.derivative(name)).degree(name) > 0
}

fn sum_of_squares(polynomial: &Polynomial, known: &Known<'_>) -> Option<bool> {
    squares_and_terms(polynomial, known).map(|(_, rest)| known.has_positive_term(&rest))
}

/// The squares with their positive factors, and the terms that are left.
fn squares_and_terms(
    polynomial: &Polynomial,
    known: &Known<'_>,
) -> Option<(Vec<(Rational, Polynomial)>, Polynomial)> {
    if !known.allows_ends(polynomial) {
        return None;
    }
    let mut squares = Vec::new();
    let rest = complete(polynomial.clone(), known, &mut squares, &mut { MOST_TRIED })?;
    let sum = squares
        .iter()
        .fold(rest.clone(), |sum, (coefficient, root)| &sum + &(root * root).scale(coefficient));
    let is_proved = sum == *polynomial
        && squares.iter().all(|(coefficient, _)| *coefficient > 0)
        && rest.terms().all(|(monomial, coefficient)| *coefficient > 0 && known.allows(monomial));
    is_proved.then_some((squares, rest))
}

/// The same of c (q x + r)² + rest with c > 0 in a generator x, where the rest is no longer one of x.
fn square_and_rest(polynomial: &Polynomial, known: &Known<'_>) -> Option<bool> {
    let of = |x: &Generator| {
        let (_, _, rest) = square_in(polynomial, x)?;
        if rest.is_zero() { Some(false) } else { as_squares(&rest, known) }
    };
    polynomial.generators().iter().find_map(of)
}

/// c, q x + r and the rest of such a form.
fn square_in(polynomial: &Polynomial, x: &Generator) -> Option<(Rational, Polynomial, Polynomial)> {
    let [below, middle, leading]: [Polynomial; 3] = polynomial.coefficients(x).try_into().ok()?;
    let (factor, roots) = without_squares(&leading);
    let factor = factor.as_constant().filter(|factor| *factor > 0)?;
    let root = product(&roots);
    let other = middle.divide_exact(&root.scale(&(factor.clone() * 2)))?;
    let square = &(&root * &Polynomial::generator(x)) + &other;
    let rest = &below - &(&other * &other).scale(&factor);
    let is_whole = &(&square * &square).scale(&factor) + &rest == *polynomial;
    is_whole.then_some((factor, square, rest))
}

/// Completes squares until no term is below zero; the squares are added to the list. What is left.
fn complete(
    polynomial: Polynomial,
    known: &Known<'_>,
    squares: &mut Vec<(Rational, Polynomial)>,
    left: &mut usize,
) -> Option<Polynomial> {
    let is_bad =
        |(monomial, coefficient): &(&Monomial, &Rational)| **coefficient < 0 || !known.allows(monomial);
    let Some((bad, _)) = polynomial.terms().rev().find(is_bad) else { return Some(polynomial) };
    if squares.len() >= MOST_SQUARES {
        return None;
    }
    // The square of a term of a square has no higher degree than the whole, in any generator.
    let fits =
        |term: &Monomial| term.factors().all(|(name, exponent)| 2 * exponent <= polynomial.degree(name));
    for (monomial, coefficient) in polynomial.terms().rev().filter(|(_, coefficient)| **coefficient > 0) {
        let Some(root) = monomial.square_root() else { continue };
        let partner = |term: &Monomial| term.divided_by(&root).filter(fits);
        if partner(bad).is_none() {
            continue;
        }
        *left = left.checked_sub(1)?;
        let mut square = Polynomial::term(Rational::from(1), root.clone());
        for (term, factor) in polynomial.terms().filter(is_bad) {
            if let Some(other) = partner(term) {
                square.add_term(&other, &(factor.clone() / (coefficient.clone() * 2)));
            }
        }
        squares.push((coefficient.clone(), square.clone()));
        let rest = &polynomial - &(&square * &square).scale(coefficient);
        if let Some(rest) = complete(rest, known, squares, left) {
            return Some(rest);
        }
        squares.pop();
    }
    None
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Domain, Expression, Symbol};

    /// Factors and terms of which some may be negative or zero.
    const FACTORS: [&str; 8] = ["1", "x", "z", "p^2", "p", "x - y", "(x - y)^2", "x + z"];
    const ADDED: [&str; 9] = ["0", "1", "x*y", "z", "p^2", "q", "p*q", "x*z", "y*q^2"];

    fn decided(text: &str) -> Option<bool> {
        let expression: Expression = text.parse().expect("in the grammar");
        let function = Domain::positive("x y").rational_function(&expression).expect("a polynomial");
        let positive = |name: &Generator| ["x", "y"].contains(&name.as_str());
        as_squares(function.numerator(), &Known { positive: &positive, not_negative: &positive })
    }

    #[test]
    fn sums_and_products_of_squares_are_decided() {
        for text in
            ["(p - 7)^2", "(p^2 - 2)^2", "p^2 + q^2 - 2*p*q", "p^4 + q^4 - 2*p^2*q^2", "(x - y)^2*(x + y)"]
        {
            assert_eq!(decided(text), Some(false), "{text}");
        }
        assert_eq!(decided("p^2 + q^2 + r^2 - p*q - q*r - r*p"), Some(false));
        assert_eq!(decided("(p*(x^2 - y^2) + q*x^2 - r*y^2)^2 + x*y*s^2"), Some(false));
        assert_eq!(decided("(p*(x^2 - y^2) + q*x^2 - r*y^2)^2 + x*y"), Some(true));
        for text in
            ["(p - q)^2 + 1", "p^2*q^2 - p*q + 1", "x^2 - x*y + y^2", "p^2 - 2*p + x + 1", "(p^2 - p + 1)^3"]
        {
            assert_eq!(decided(text), Some(true), "{text}");
        }
    }

    #[test]
    fn what_may_be_negative_is_not() {
        for text in [
            "p^2 - 1",
            "p*q",
            "p^2 + q^2 - 3*p*q",
            "(p - q)^2*(x - y)",
            "p^3",
            "-p^2",
            "(i*p + q)^2",
            "x - y",
        ] {
            assert_eq!(decided(text), None, "{text}");
        }
    }

    /// The names of the random polynomials: x and y are positive, z is not negative.
    const NAMES: [&str; 5] = ["p", "q", "x", "y", "z"];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        /// The same in positive, non-negative and real variables, of products of almost squares.
        #[test]
        fn a_decided_product_is_nowhere_negative(
            squares in prop::collection::vec((1..=3_i32, prop::array::uniform3(-2..=2_i32), 0..NAMES.len()), 1..3),
            factor in 0..FACTORS.len(),
            (added, weight) in (0..ADDED.len(), -2..=2_i32),
            points in prop::collection::vec(prop::array::uniform5(0..=6_i32), 30),
        ) {
            let square = |(weight, [a, b, c], name): &(i32, [i32; 3], usize)| {
                format!("{weight}*(({a})*p + ({b})*{} + ({c}))^2", NAMES[*name])
            };
            let sum = squares.iter().map(square).collect::<Vec<_>>().join(" + ");
            let text = format!("({sum} + ({weight})*{})*({})", ADDED[added], FACTORS[factor]);
            let polynomial = Domain::default().rational_function(&text.parse().expect("in the grammar")).unwrap();
            let positive = |name: &Generator| ["x", "y"].contains(&name.as_str());
            let not_negative = |name: &Generator| ["x", "y", "z"].contains(&name.as_str());
            let found = as_squares(polynomial.numerator(), &Known { positive: &positive, not_negative: &not_negative });
            for [p, q, x, y, z] in points {
                let values = [p - 3, q - 3, x + 1, y + 1, z].map(Rational::from);
                let at = NAMES.map(Symbol::from).into_iter().zip(values).collect();
                let value = polynomial.numerator().evaluate(&at).unwrap();
                prop_assert!(found != Some(true) || value > 0, "{text} at {at:?}");
                prop_assert!(found.is_none() || value >= 0, "{text} at {at:?}");
            }
        }

        /// A polynomial that is decided has the sign at every point that is tried.
        #[test]
        fn a_decided_polynomial_is_nowhere_negative(
            coefficients in prop::collection::vec(-3..=3_i32, 6),
            points in prop::collection::vec((-4..=4_i32, -4..=4_i32), 20),
        ) {
            let names = ["p^2", "p*q", "q^2", "p", "q", "1"];
            let term = |(factor, name): (&i32, &str)| format!("({factor})*{name}");
            let text = coefficients.iter().zip(names).map(term).collect::<Vec<_>>().join(" + ");
            let expression: Expression = text.parse().expect("in the grammar");
            let found = decided(&text);
            for (p, q) in points {
                let value = expression.with("p", &Expression::integer(p)).with("q", &Expression::integer(q));
                let value = Domain::default().rational_function(&value).unwrap().as_constant().unwrap();
                prop_assert!(found != Some(true) || value > 0, "{text} at {p}, {q}");
                prop_assert!(found.is_none() || value >= 0, "{text} at {p}, {q}");
            }
        }
    }
}
