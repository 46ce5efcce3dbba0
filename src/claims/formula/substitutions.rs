//! Forms of the same conditions in which more expressions are quotients of polynomials with coefficients of one sign.

use std::collections::BTreeSet;

use slipmode_core::polynomial::{Domain, Expression, Function, Relation, Symbol};

/// The domain as it is, and with substitutions that reach every point of its conditions.
///
/// A condition x − r > 0 gives x = r + g with a parameter g > 0, and a variable x under a root x = k² with k > 0. Both under a
/// root, and the difference of two, give squares of sums and sums of squares.
pub(super) fn domains(domain: &Domain, sides: &[Expression]) -> Vec<Domain> {
    let rooted: BTreeSet<Symbol> =
        sides.iter().flat_map(under_roots).flat_map(|inner| inner.variables()).collect();
    let linear: Vec<(Symbol, Expression, Expression)> = domain
        .conditions()
        .iter()
        .filter(|condition| condition.relation == Relation::Positive)
        .filter_map(|condition| solved(domain, &condition.expression))
        .collect();
    let mut found = vec![domain.clone(), with_squares(domain.clone(), &rooted, &[])];
    let shifted = linear.iter().zip(0..).fold(domain.clone(), |domain, ((name, rest, condition), number)| {
        let gap = format!("gap_{number}");
        domain
            .with(name.as_str(), rest.clone() + Expression::variable(&gap))
            .parameter(&gap, condition.clone())
    });
    let taken: Vec<Symbol> = linear
        .iter()
        .flat_map(|(name, rest, _)| rest.variables().into_iter().chain([name.clone()]))
        .collect();
    found.push(shifted.clone());
    found.push(with_squares(shifted, &rooted, &taken));
    for (name, rest, condition) in &linear {
        if let Expression::Variable(smaller) = rest {
            found.extend(squares_of_pair(domain, &rooted, name, smaller, condition));
        }
    }
    found
}

/// x = k² for the variables under roots, but for some.
fn with_squares(domain: Domain, rooted: &BTreeSet<Symbol>, but: &[Symbol]) -> Domain {
    rooted.iter().filter(|name| domain.is_positive(name) && !but.contains(name)).fold(
        domain.clone(),
        |domain, name| {
            let root = format!("root_{name}");
            let square = Expression::variable(&root).power(2);
            let inverse = Expression::Variable(name.clone()).call(Function::Sqrt);
            domain.with(name.as_str(), square).parameter(&root, inverse)
        },
    )
}

/// For larger > smaller: smaller = k², and larger = (k + g)² or k² + g².
fn squares_of_pair(
    domain: &Domain,
    rooted: &BTreeSet<Symbol>,
    larger: &Symbol,
    smaller: &Symbol,
    difference: &Expression,
) -> [Domain; 2] {
    let [root, gap] = ["root_smaller", "gap_of_roots"];
    let [k, g] = [root, gap].map(Expression::variable);
    let square_root = |name: &Symbol| Expression::Variable(name.clone()).call(Function::Sqrt);
    let start = with_squares(domain.clone(), rooted, &[larger.clone(), smaller.clone()])
        .with(smaller.as_str(), k.clone().power(2))
        .parameter(root, square_root(smaller));
    let of_sum = start
        .clone()
        .with(larger.as_str(), (k.clone() + g.clone()).power(2))
        .parameter(gap, square_root(larger) - square_root(smaller));
    let of_squares = start
        .with(larger.as_str(), k.power(2) + g.power(2))
        .parameter(gap, difference.clone().call(Function::Sqrt));
    [of_sum, of_squares]
}

/// A condition c > 0 as x − r > 0: a positive variable x with slope 1, r = x − c, and c.
fn solved(domain: &Domain, condition: &Expression) -> Option<(Symbol, Expression, Expression)> {
    condition.variables().into_iter().filter(|name| domain.is_positive(name)).find_map(|name| {
        let slope = domain.rational_function(&condition.derivative(&name)).ok()?.as_constant()?;
        let rest =
            domain.rational_function(&(Expression::Variable(name.clone()) - condition.clone())).ok()?;
        (slope == 1).then(|| (name, Expression::from(&rest), condition.clone()))
    })
}

/// The arguments of the square roots in an expression.
fn under_roots(expression: &Expression) -> Vec<Expression> {
    let inside = |parts: &[Expression]| parts.iter().flat_map(under_roots).collect::<Vec<_>>();
    match expression {
        Expression::Number(_) | Expression::Variable(_) => Vec::new(),
        Expression::Sum(parts) | Expression::Product(parts) => inside(parts),
        Expression::Quotient(above, below) => [under_roots(above), under_roots(below)].concat(),
        Expression::Negation(inner) | Expression::Power(inner, _) => under_roots(inner),
        Expression::Call(Function::Sqrt, inner) => [vec![(**inner).clone()], under_roots(inner)].concat(),
        Expression::Call(_, inner) => under_roots(inner),
    }
}
