//! Wrong equations, made by rule: what a slip of the pen or of the mind does to one of the paper's.

use std::collections::{BTreeMap, BTreeSet};

use slipmode_algebra::{Expression, Function, Symbol, unknowns};
use slipmode_core::number::{Ball, Rational};
use slipmode_theory::{Equation, Equations};

/// One altered equation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Alteration {
    /// What was done.
    pub kind: &'static str,
    /// Both sides afterwards.
    pub text: String,
    /// Whether it still says the same, which no check can object to.
    pub says_the_same: bool,
}

/// The pairs of variables that a slip may exchange: some equation has both as terms of one sum, as in b − a or √b − √a, so that
/// they are of one kind.
pub(super) fn alike(equations: &Equations) -> Vec<[Symbol; 2]> {
    let mut found = BTreeSet::new();
    for equation in equations.iter() {
        sums(&equation.left, &mut found);
        sums(&equation.right, &mut found);
    }
    found.into_iter().collect()
}

/// The pairs in the sums of an expression, each in alphabetical order.
fn sums(expression: &Expression, found: &mut BTreeSet<[Symbol; 2]>) {
    if let Expression::Sum(parts) = expression {
        let names: BTreeSet<(String, Symbol)> = parts.iter().filter_map(lone).collect();
        let pairs = names.iter().flat_map(|one| names.range(one..).skip(1).map(move |other| (one, other)));
        let alike = pairs.filter(|(one, other)| one.0 == other.0);
        found.extend(alike.map(|(one, other)| [one.1.clone(), other.1.clone()]));
    }
    expression.parts().for_each(|part| sums(part, found));
}

/// The variable of a term that is one variable, its power or its root, and which of these.
fn lone(term: &Expression) -> Option<(String, Symbol)> {
    let (inner, exponent) = match term {
        Expression::Variable(name) => return Some((String::new(), name.clone())),
        Expression::Negation(inner) => return lone(inner),
        Expression::Power(inner, exponent) => (inner, exponent.to_string()),
        Expression::Call(Function::Sqrt, inner) => (inner, "1/2".to_owned()),
        _ => return None,
    };
    lone(inner).map(|(form, name)| (format!("{form}^{exponent}"), name))
}

/// Every alteration of an equation, each text once: the sign of each term, a factor 2 on each term of a side, each exponent and
/// root, and two variables of one kind exchanged.
pub(super) fn alterations(equation: &Equation, alike: &[[Symbol; 2]]) -> Vec<Alteration> {
    let mut texts = BTreeSet::from([equation.to_string()]);
    let is_name = matches!(equation.left, Expression::Variable(_));
    let left = if is_name { Vec::new() } else { of_side(&equation.left) };
    let with_left = left.into_iter().map(|(kind, left)| (kind, left, equation.right.clone()));
    let right = of_side(&equation.right).into_iter();
    let with_right = right.map(|(kind, right)| (kind, equation.left.clone(), right));
    let with_exchange = alike
        .iter()
        .map(|pair| ("exchange", exchanged(&equation.left, pair), exchanged(&equation.right, pair)));
    let all = with_left.chain(with_right).chain(with_exchange);
    let mut found = Vec::new();
    for (kind, left, right) in all {
        let text = format!("{left} = {right}");
        if texts.insert(text.clone()) {
            let (before, after) = (equation.residual(), left - right);
            // ± stands for both signs, so that turning it changes nothing.
            let turned = after.with("pm", &-Expression::variable("pm"));
            let says_the_same = same_zeros(&before, &after) || same_zeros(&before, &turned);
            found.push(Alteration { kind, text, says_the_same });
        }
    }
    found
}

type Variant = (&'static str, Expression);

fn of_side(side: &Expression) -> Vec<Variant> {
    if side.is_zero() {
        return Vec::new();
    }
    let mut found = within(side);
    let twice = |part: &Expression| Expression::integer(2) * part.clone();
    match side {
        Expression::Sum(parts) => {
            found.extend(one_altered(parts, Expression::Sum, |part| vec![("factor", twice(part))]));
        }
        other => found.extend([("factor", twice(other)), ("sign", -other.clone())]),
    }
    found
}

/// Alterations of one place inside an expression.
fn within(expression: &Expression) -> Vec<Variant> {
    let mut found = Vec::new();
    match expression {
        Expression::Number(_) | Expression::Variable(_) => {}
        Expression::Sum(parts) => {
            found.extend(one_altered(parts, Expression::Sum, |part| vec![("sign", -part.clone())]));
            found.extend(one_altered(parts, Expression::Sum, within));
        }
        Expression::Product(parts) => found.extend(one_altered(parts, Expression::Product, within)),
        Expression::Quotient(above, below) => {
            let quotient = |above: &Expression, below: &Expression| above.clone() / below.clone();
            if matches!(**below, Expression::Variable(_)) {
                found.push(("exponent", quotient(above, &below.clone().power(2))));
            }
            found.extend(within(above).into_iter().map(|(kind, part)| (kind, quotient(&part, below))));
            found.extend(within(below).into_iter().map(|(kind, part)| (kind, quotient(above, &part))));
        }
        Expression::Negation(inner) => {
            found.extend(within(inner).into_iter().map(|(kind, part)| (kind, -part)));
        }
        Expression::Power(inner, exponent) => {
            found.push(("exponent", (**inner).clone().power(exponent + 1)));
            found.extend(within(inner).into_iter().map(|(kind, part)| (kind, part.power(*exponent))));
        }
        Expression::Call(function, inner) => {
            if *function == Function::Sqrt {
                found.push(("exponent", (**inner).clone()));
            }
            found.extend(within(inner).into_iter().map(|(kind, part)| (kind, part.call(*function))));
        }
        Expression::Generic(function, inner) => {
            let of = |part| Expression::Generic(function.clone(), Box::new(part));
            found.extend(within(inner).into_iter().map(|(kind, part)| (kind, of(part))));
        }
    }
    found
}

/// Each part altered in turn.
fn one_altered(
    parts: &[Expression],
    join: fn(Vec<Expression>) -> Expression,
    alter: impl Fn(&Expression) -> Vec<Variant>,
) -> Vec<Variant> {
    let mut found = Vec::new();
    for (at, part) in parts.iter().enumerate() {
        for (kind, altered) in alter(part) {
            let mut parts = parts.to_vec();
            parts[at] = altered;
            found.push((kind, join(parts)));
        }
    }
    found
}

fn exchanged(side: &Expression, [one, other]: &[Symbol; 2]) -> Expression {
    let to = |from: &Symbol, to: &Symbol| (from.clone(), Expression::Variable(to.clone()));
    side.substitute(&BTreeMap::from([to(one, other), to(other, one)]))
}

/// Bits for the comparison of two equations: a chance agreement of different ones to so many is out of the question.
const COMPARED_BITS: u32 = 256;

/// Whether two residuals are the same up to a constant factor, compared at two points; false where they cannot be evaluated.
fn same_zeros(one: &Expression, other: &Expression) -> bool {
    let names = unknowns([one, other]);
    // Ascending numbers, so that a < b, without a common factor that a power could hide.
    let point = |shift: u32| -> BTreeMap<Symbol, Ball> {
        let value = |index: u32| Rational::from((7 + shift + 3 * index, 11 + shift));
        let ball = |index| Ball::from_rational(&value(index), COMPARED_BITS);
        names.iter().zip(0..).map(|(name, index)| (name.clone(), ball(index))).collect()
    };
    let at = |expression: &Expression, shift| expression.enclosed(&point(shift), COMPARED_BITS);
    let values = [at(one, 0), at(other, 0), at(one, 5), at(other, 5)];
    // The root of a negative number has no bounds and would agree with anything.
    let is_number = |ball: &Ball| ball.centre().is_finite() && ball.radius().is_finite();
    if !values.iter().flatten().all(is_number) {
        return false;
    }
    let [Some(one_here), Some(other_here), Some(one_there), Some(other_there)] = values else { return false };
    let difference = one_here * &other_there - one_there * &other_here;
    difference.contains(&Rational::new())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn altered(text: &str) -> Vec<(&'static str, String, bool)> {
        let (left, right) = text.split_once('=').unwrap();
        let side = |text: &str| text.trim().parse::<Expression>().unwrap();
        let equation = Equation {
            number: "1".into(),
            left: side(left),
            right: side(right),
            printed: None,
            note: String::new(),
            given: Vec::new(),
            role: None,
        };
        let parts = |found: Alteration| (found.kind, found.text, found.says_the_same);
        alterations(&equation, &[["a", "b"].map(Symbol::from)]).into_iter().map(parts).collect()
    }

    #[test]
    fn signs_factors_exponents_and_names_are_altered_one_at_a_time() {
        let found = altered("sigma = (b - a)*K^2/D_c");
        for wanted in [
            ("sign", "sigma = (b + a)*K^2/D_c"),
            ("exponent", "sigma = (b - a)*K^3/D_c"),
            ("exponent", "sigma = (b - a)*K^2/D_c^2"),
            ("exchange", "sigma = (a - b)*K^2/D_c"),
        ] {
            let is_there = found.iter().any(|(kind, text, _)| (*kind, text.as_str()) == wanted);
            assert!(is_there, "{wanted:?} is not in {found:#?}");
        }
        assert!(found.iter().any(|(kind, text, _)| *kind == "factor" && text.starts_with("sigma = 2*")));
        assert!(found.iter().all(|(_, _, same)| !same), "{found:#?}");
    }

    #[test]
    fn variables_that_an_equation_adds_or_subtracts_are_of_one_kind() {
        let pairs = |text: &str| {
            let mut found = BTreeSet::new();
            sums(&text.parse().unwrap(), &mut found);
            found.into_iter().map(|[one, other]| format!("{one} {other}")).collect::<Vec<_>>()
        };
        assert_eq!(pairs("K*D/(b - a)*sqrt(M*(V_1 + 2*V_0))"), ["a b"]);
        assert_eq!(pairs("ln((sqrt(b) - sqrt(a))^2 + x^2 - y^2 - z)"), ["a b", "x y"]);
        assert_eq!(pairs("mu + a*ln(V/W) - x^2 + sqrt(y)"), Vec::<String>::new());
    }

    #[test]
    fn what_says_the_same_is_told_from_what_does_not() {
        let found = altered("sigma = K*D_c/(sqrt(b) + sqrt(a))^2");
        let same: Vec<&str> = found.iter().filter(|(_, _, same)| *same).map(|(kind, _, _)| *kind).collect();
        assert_eq!(same, ["exchange"], "{found:#?}");
        assert!(altered("2*V_0 - 1 = 0").iter().all(|(_, _, same)| !same));
        // For a < b these are roots of negative numbers: another statement, not the same in other words.
        let imaginary = altered("V_c = D_c*sqrt(a/(b - a))");
        for wrong in ["V_c = D_c*sqrt(b/(a - b))", "V_c = D_c*sqrt(a/(-b - a))"] {
            let found = imaginary.iter().find(|(_, text, _)| text == wrong);
            assert!(found.is_some_and(|(_, _, same)| !same), "{wrong} in {imaginary:#?}");
        }
    }
}
