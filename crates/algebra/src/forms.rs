//! Forms of the same conditions in which more expressions are quotients of polynomials with coefficients of one sign.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    Condition, Domain, Expression, Function, Generator, Polynomial, RationalFunction, Relation, Symbol,
};

impl Domain {
    /// The domain as it is, and with substitutions that reach every point of its conditions, in which more expressions have a sign.
    /// The sides name the roots that are to become rational.
    ///
    /// A condition h x − r > 0 with h > 0 gives x = r/h + g with a parameter g > 0, one with h < 0 gives x = r/h − g, or r/(h (1 + g)) for
    /// a positive x. A variable x under a root becomes x = k² with k > 0. Two variables under roots, and the difference of two, give
    /// squares of sums and sums of squares.
    ///
    /// Each form passes [`Domain::check`] where the domain does and no positive variable is below an end that may be zero as written.
    #[must_use]
    pub fn forms(&self, sides: &[Expression]) -> Vec<Self> {
        let form = Form::of(self);
        let gaps = [false, true].map(|last| form.with_gaps(Way { last, ..Way::default() }));
        let pairs = form.pairs().into_iter();
        let pairs = pairs.flat_map(|(larger, smaller)| form.squares_of_pair(&larger, &smaller, sides));
        let plain = [form.clone()].into_iter().chain(gaps);
        let plain = plain.flat_map(|form| [form.clone(), form.with_squares(sides)]);
        let mut found: Vec<Self> = Vec::new();
        for form in plain.chain(pairs) {
            let form = form.domain();
            if !found.contains(&form) {
                found.push(form);
            }
        }
        found
    }

    /// The number of ways of [`Domain::forms_in_way`].
    pub const WAYS: u8 = 16;

    /// Such forms in one of several ways: conditions in another order, solved for other names.
    #[must_use]
    pub fn forms_in_way(&self, way: u8, sides: &[Expression]) -> Vec<Self> {
        let form = Form::of(self).with_gaps(Way::of(way));
        let mut forms = vec![form.domain(), form.with_squares(sides).domain()];
        forms.dedup();
        forms
    }

    /// Whether one of the forms proves a condition.
    #[must_use]
    pub fn proves_in_some_form(&self, condition: &Condition) -> Option<Self> {
        let forms = self.forms(std::slice::from_ref(&condition.expression));
        forms.into_iter().find(|form| form.proves(condition) == Ok(true))
    }
}

/// In which order conditions are solved, and for which name.
#[derive(Debug, Clone, Copy, Default)]
struct Way {
    /// Short conditions first, instead of the order in which they stand.
    by_size: bool,
    /// The last name of several, instead of the first.
    last: bool,
    /// A name that has an upper end before those that have a lower one.
    downward: bool,
    /// A positive x below an end becomes end − g as any other one, instead of end/(1 + g).
    as_difference: bool,
}

impl Way {
    fn of(number: u8) -> Self {
        let [last, downward, as_difference, in_order] = [1, 2, 4, 8].map(|bit| number & bit > 0);
        Self { by_size: !in_order, last, downward, as_difference }
    }
}

/// Variables expressed by positive parameters.
#[derive(Clone)]
struct Form<'d> {
    given: &'d Domain,
    /// Values of variables in the names that are left.
    values: BTreeMap<Symbol, Expression>,
    /// The parameters, in the variables.
    parameters: BTreeMap<Symbol, Expression>,
}

impl<'d> Form<'d> {
    fn of(given: &'d Domain) -> Self {
        Self { given, values: BTreeMap::new(), parameters: BTreeMap::new() }
    }

    fn domain(&self) -> Domain {
        let values = self.values.iter();
        let domain =
            values.fold(self.given.clone(), |domain, (name, value)| domain.with(name, value.clone()));
        let parameters = self.parameters.iter();
        parameters.fold(domain, |domain, (name, value)| domain.parameter(name, value.clone()))
    }

    /// A parameter that the domain has not.
    fn fresh(&self) -> Symbol {
        Symbol::fresh(&self.domain().symbols())
    }

    /// Puts a value in a new parameter in the place of a name; `of_names` is the parameter in the names so far.
    fn put(&mut self, name: &Symbol, value: &Expression, parameter: &Symbol, of_names: &Expression) {
        let of_variables = of_names.substitute(&self.parameters);
        for known in self.values.values_mut() {
            *known = known.with(name, value);
        }
        if self.parameters.remove(name).is_none() {
            self.values.insert(name.clone(), value.clone());
        }
        self.parameters.insert(parameter.clone(), of_variables);
    }

    /// Every condition that a name solves used so.
    fn with_gaps(&self, way: Way) -> Self {
        let positive =
            self.given.conditions().iter().filter(|condition| condition.relation == Relation::Positive);
        let mut positive: Vec<&Expression> = positive.map(|condition| &condition.expression).collect();
        if way.by_size {
            positive.sort_by_key(|expression| expression.to_string().len());
        }
        let with_gap = |form: Self, condition| form.with_gap(condition, way).unwrap_or(form);
        positive.into_iter().fold(self.clone(), with_gap)
    }

    /// A condition solved for a name in which it is linear.
    fn with_gap(&self, condition: &Expression, way: Way) -> Option<Self> {
        let domain = self.domain();
        let function = domain.rational_function(condition).ok()?;
        let sign = |polynomial: &Polynomial| domain.sign(&Expression::from(polynomial)).ok().flatten();
        let mut candidates: Vec<(u8, Symbol, Polynomial, Polynomial, i8)> = function
            .numerator()
            .variables()
            .into_iter()
            .filter(|name| function.numerator().degree(name) == 1 && function.hides(name).is_none())
            .filter(|name| !["i", "pm"].contains(&name.as_str()))
            .filter_map(|name| {
                let mut parts = function.numerator().coefficients(&name);
                let (slope, rest) = (parts.pop()?, parts.pop()?);
                let upward = sign(&slope)? * sign(function.denominator())?;
                let rank =
                    u8::from((upward < 0) != way.downward) * 2 + u8::from(slope.as_constant().is_none());
                Some((rank, name, slope, rest, upward))
            })
            .collect();
        if way.last {
            candidates.reverse();
        }
        candidates.sort_by_key(|(rank, ..)| *rank);
        let (_, name, slope, rest, upward) = candidates.into_iter().next()?;
        let end = Expression::from(&RationalFunction::new(-&rest, slope)?);
        let gap = self.fresh();
        let (x, g) = (Expression::Variable(name.clone()), Expression::variable(&gap));
        let (value, of_names) = match upward {
            1 => (end.clone() + g, x - end),
            _ if domain.is_positive(&name) && !way.as_difference => {
                let one = || Expression::integer(1);
                (end.clone() / (one() + g), end / x - one())
            }
            _ => (end.clone() - g, end - x),
        };
        let mut form = self.clone();
        form.put(&name, &value, &gap, &of_names);
        Some(form)
    }

    /// x = k² for the names under roots.
    fn with_squares(&self, sides: &[Expression]) -> Self {
        let domain = self.domain();
        let open = |inner: &Expression| {
            let root = domain.rational_function(&inner.clone().call(Function::Sqrt));
            let is_root = |name: &Generator| name.argument_of(Function::Sqrt).is_some();
            root.map_or(true, |root| root.generators().iter().any(is_root))
        };
        let under = |inner: Expression| {
            Some(inner).filter(open).and_then(|inner| domain.rational_function(&inner).ok())
        };
        let rooted: BTreeSet<Symbol> = sides
            .iter()
            .flat_map(under_roots)
            .filter_map(under)
            .flat_map(|inner| inner.generators())
            .filter_map(|generator| generator.symbol())
            .filter(|name| domain.is_positive(name))
            .collect();
        rooted.into_iter().fold(self.clone(), |mut form, name| {
            let root = form.fresh();
            let square = Expression::variable(&root).power(2);
            form.put(&name, &square, &root, &Expression::Variable(name.clone()).call(Function::Sqrt));
            form
        })
    }

    /// The conditions larger > smaller between two positive variables.
    fn pairs(&self) -> Vec<(Symbol, Symbol)> {
        let conditions =
            self.given.conditions().iter().filter(|condition| condition.relation == Relation::Positive);
        let pair = |expression: &Expression| {
            let function = self.given.rational_function(expression).ok()?;
            let names: Vec<Symbol> = function.numerator().variables().into_iter().collect();
            let [one, other] = &names[..] else { return None };
            let is = |larger: &Symbol, smaller: &Symbol| {
                let difference = Expression::Variable(larger.clone()) - Expression::Variable(smaller.clone());
                self.given.difference(expression, &difference).is_ok_and(|rest| rest.is_zero())
            };
            let found =
                [(one, other), (other, one)].into_iter().find(|(larger, smaller)| is(larger, smaller))?;
            (self.given.is_positive(one) && self.given.is_positive(other))
                .then(|| (found.0.clone(), found.1.clone()))
        };
        conditions.filter_map(|condition| pair(&condition.expression)).collect()
    }

    /// For larger > smaller: smaller = k², and larger = (k + g)² or k² + g².
    fn squares_of_pair(&self, larger: &Symbol, smaller: &Symbol, sides: &[Expression]) -> [Self; 2] {
        let root_of_smaller = self.fresh();
        let gap_of_roots = Symbol::fresh([&root_of_smaller]);
        let [k, g] = [&root_of_smaller, &gap_of_roots].map(Expression::variable);
        let root = |name: &Symbol| Expression::Variable(name.clone()).call(Function::Sqrt);
        let difference = Expression::Variable(larger.clone()) - Expression::Variable(smaller.clone());
        let of_sum = ((k.clone() + g.clone()).power(2), root(larger) - root(smaller));
        let of_squares = (k.clone().power(2) + g.power(2), difference.call(Function::Sqrt));
        [of_sum, of_squares].map(|(value, gap)| {
            let mut form = self.clone();
            form.put(smaller, &k.clone().power(2), &root_of_smaller, &root(smaller));
            form.put(larger, &value, &gap_of_roots, &gap);
            form.with_squares(sides)
        })
    }
}

/// The arguments of the square roots in an expression.
fn under_roots(expression: &Expression) -> Vec<Expression> {
    let own = expression.below_root().cloned();
    own.into_iter().chain(expression.parts().flat_map(under_roots)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ConversionError, DomainError};

    fn parse(text: &str) -> Expression {
        text.parse().expect("in the grammar")
    }

    #[test]
    fn forms_pass_their_check_and_prove_what_their_conditions_say() {
        let positive = |text: &str| Condition { expression: parse(text), relation: Relation::Positive };
        for (given, statement, is_seen) in [
            ("x - y", "x^3 + x - y^3 - y", true),
            ("x - y", "x^3 + x - 2*y^3 - y", false),
            ("1 - x", "1/x^2 + 1 - 2*x^2", true),
            ("y - 2*x*y + 1", "1 + y - x*y", true),
            ("z - x", "z", true),
            ("z - x", "z - 2*x", false),
            ("x - z", "x^2 + 1 - x*z", false),
            ("-1 - z", "z^2 - 1", true),
            ("x - y", "sqrt(x) - sqrt(y)/2", true),
            ("x - y", "sqrt(x) - sqrt(x - y)", true),
            ("x - y", "sqrt(x) + sqrt(y) - sqrt(x - y)", true),
            ("x - y", "sqrt(x)*y - sqrt(y)*x + x*sqrt(x)", true),
        ] {
            let domain = Domain::positive("x y").given(parse(given), Relation::Positive);
            let domain = ["x", "y", "z"].into_iter().fold(domain, |domain, name| match given {
                "x - y" if name == "x" => domain.example(name, parse("2")),
                "1 - x" | "y - 2*x*y + 1" if name == "x" => domain.example(name, parse("1/2")),
                "z - x" if name == "z" => domain.example(name, parse("2")),
                "-1 - z" if name == "z" => domain.example(name, parse("-2")),
                _ => domain,
            });
            assert_eq!(domain.check(), Ok(()), "{given}");
            let sides = [parse(statement)];
            let ways = (0..Domain::WAYS).flat_map(|way| domain.forms_in_way(way, &sides));
            // A positive variable below an end z is z/(1 + g) with g = z/x - 1, and z may be zero as written.
            for form in ways.chain(domain.forms(&sides)) {
                let found = form.check();
                assert!(
                    matches!(found, Ok(()) | Err(DomainError::Conversion(ConversionError::PossibleZero(_)))),
                    "{form:?} {found:?}"
                );
            }
            let proves = domain.proves_in_some_form(&positive(statement));
            assert_eq!(proves.map(|form| form.check()), is_seen.then_some(Ok(())), "{statement} for {given}");
        }
    }
}
