//! The forms of derivations: `coefficient(P, s, 2)`, or an expression.

use std::collections::BTreeSet;

use slipmode_algebra::{Comparison, Condition, Demand, Expression, Source, Symbol, Toward};

slipmode_algebra::named! {
    /// What can be derived by name.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Operation {
        /// det(s − J) of a system at its steady state.
        Characteristic = "characteristic",
        /// The slope of one state's rate in another state, at the steady state.
        Linearised = "linearised",
        /// The rate of change of an expression along the motions of a system.
        Rate = "rate",
        /// The factor of a power.
        Coefficient = "coefficient",
        /// The factor of the highest power, which has to be this one.
        Leading = "leading",
        /// The discriminant of a polynomial.
        Discriminant = "discriminant",
        /// A leading principal minor of the Hurwitz matrix.
        Hurwitz = "hurwitz",
        /// The resultant of two polynomials.
        Eliminate = "eliminate",
        /// The one value of a variable at which an expression is zero.
        Solve = "solve",
        /// A derivative.
        Derivative = "derivative",
        /// A limit.
        Limit = "limit",
        /// The first terms of a power series.
        Series = "series",
        /// Two symbols exchanged.
        Exchange = "exchange",
        /// Values put in.
        At = "at",
    }
}

/// What kind of thing an argument is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    System,
    Expression,
    /// A variable, a time derivative such as `theta'` too.
    Variable,
    /// A variable that the derivation brings in.
    New,
    Whole,
    End,
    Values,
}

impl Operation {
    /// The form in words, and the kinds of its arguments.
    fn form(self) -> (&'static str, &'static [Kind]) {
        use Kind::{End, Expression, New, System, Values, Variable, Whole};
        match self {
            Self::Characteristic => ("characteristic(system, s)", &[System, New]),
            Self::Linearised => ("linearised(system, rate_state, by_state)", &[System, Variable, Variable]),
            Self::Rate => ("rate(f, system)", &[Expression, System]),
            Self::Coefficient => ("coefficient(P, s, n)", &[Expression, Variable, Whole]),
            Self::Leading => ("leading(P, s, n)", &[Expression, Variable, Whole]),
            Self::Discriminant => ("discriminant(P, s)", &[Expression, Variable]),
            Self::Hurwitz => ("hurwitz(P, s, n)", &[Expression, Variable, Whole]),
            Self::Eliminate => ("eliminate(P, Q, x)", &[Expression, Expression, Variable]),
            Self::Solve => ("solve(f, x)", &[Expression, Variable]),
            Self::Derivative => ("derivative(f, x)", &[Expression, Variable]),
            Self::Limit => ("limit(f, x, 0) or limit(f, x, infinity)", &[Expression, Variable, End]),
            Self::Series => ("series(f, x, n)", &[Expression, Variable, Whole]),
            Self::Exchange => ("exchange(f, x, y)", &[Expression, Variable, Variable]),
            Self::At => ("at(f, x = value, ...)", &[Expression, Values]),
        }
    }
}

/// The right side of a definition, parsed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Form {
    /// What is derived; none for a bare expression.
    pub operation: Option<Operation>,
    /// The name of the system, if one is an argument.
    pub system: Option<String>,
    /// The expressions among the arguments.
    pub expressions: Vec<Expression>,
    /// The variables among the arguments.
    pub variables: Vec<Symbol>,
    /// The whole number among the arguments.
    pub whole: usize,
    /// Where a limit goes.
    pub toward: Toward,
    /// The values that are put in.
    pub values: Vec<(Symbol, Expression)>,
    /// What must hold for the arguments to have values.
    pub demands: Vec<Demand>,
}

/// The largest whole argument: an order or a power.
const LARGEST_WHOLE: usize = 12;

impl Form {
    /// Reads the right side of a definition, in which these are functions of which nothing is known.
    ///
    /// # Errors
    /// With the column: text outside the grammar, a wrong number of arguments, an argument of a wrong kind.
    pub fn read(text: &str, functions: &BTreeSet<Symbol>) -> Result<Self, String> {
        let mut form = Self::default();
        let source = Source::new(text).with_functions(functions);
        let (word, arguments) = Source::call(text);
        let Some(operation) = Operation::from_word(word) else {
            form.expression(source, text)?;
            return Ok(form);
        };
        form.operation = Some(operation);
        let (words, kinds) = operation.form();
        let arguments = arguments.ok_or_else(|| {
            format!("`{word}` has the form `{words}` and stands alone: give it a name of its own")
        })?;
        let wanted = if kinds.contains(&Kind::Values) { arguments.len().max(2) } else { kinds.len() };
        if arguments.len() != wanted {
            return Err(format!("`{words}` has {wanted} arguments, not {}", arguments.len()));
        }
        let kinds = kinds.iter().chain(std::iter::repeat(&kinds[kinds.len() - 1]));
        for (argument, kind) in arguments.into_iter().zip(kinds) {
            form.argument(source, argument.trim(), *kind)?;
        }
        Ok(form)
    }

    fn argument(&mut self, source: Source<'_>, text: &str, kind: Kind) -> Result<(), String> {
        let wrong = |wanted: &str| Err(format!("column {}: '{text}' is not {wanted}", source.column(text)));
        match kind {
            Kind::Expression => self.expression(source, text)?,
            Kind::System if is_name(text) => self.system = Some(text.to_owned()),
            Kind::System => return wrong("the name of a system"),
            Kind::Variable | Kind::New => {
                let read = if kind == Kind::New { read_name(text) } else { read_variable(text) };
                let Some(name) = read else { return wrong("a variable") };
                self.variables.push(name);
            }
            Kind::Whole => match text.parse() {
                Ok(whole) if whole <= LARGEST_WHOLE => self.whole = whole,
                _ => return wrong(&format!("a whole number from 0 to {LARGEST_WHOLE}")),
            },
            Kind::End => match Toward::from_word(text) {
                Some(toward) => self.toward = toward,
                None => return wrong("0 or infinity"),
            },
            Kind::Values => {
                let equal = match Source::comparisons(text)[..] {
                    [(name, Comparison::Equal, value)] => read_variable(name.trim()).zip(Some(value)),
                    _ => None,
                };
                let Some((symbol, value)) = equal else { return wrong("of the form `x = value`") };
                self.expression(source, value)?;
                self.values.extend(self.expressions.pop().map(|value| (symbol, value)));
            }
        }
        Ok(())
    }

    fn expression(&mut self, source: Source<'_>, part: &str) -> Result<(), String> {
        let (expression, demands) = source.expression(part).map_err(|error| error.to_string())?;
        self.expressions.push(expression);
        self.demands.extend(demands);
        Ok(())
    }

    /// The names that occur in the expressions.
    pub fn names(&self) -> BTreeSet<Symbol> {
        self.all_expressions().flat_map(Expression::variables).collect()
    }

    /// The expressions among the arguments, those that are put in too.
    pub fn all_expressions(&self) -> impl Iterator<Item = &Expression> {
        self.expressions.iter().chain(self.values.iter().map(|(_, value)| value))
    }

    /// The variable that the derivation brings in.
    pub fn new_variable(&self) -> Option<&Symbol> {
        self.variables.first().filter(|_| self.operation == Some(Operation::Characteristic))
    }
}

/// A name that a file brings in: without primes, and no word of the grammar.
pub(crate) fn read_name(text: &str) -> Option<Symbol> {
    read_variable(text).filter(|symbol| symbol.derivative_order() == 0)
}

/// The same, or a time derivative.
fn read_variable(text: &str) -> Option<Symbol> {
    let is_short = text.len() <= LONGEST_NAME;
    let symbol = is_short.then(|| text.parse::<Symbol>().ok()).flatten();
    symbol.filter(|symbol| !WORDS.contains(&symbol.as_str()))
}

/// Words between the comparisons of a formula, and the end of a limit.
const WORDS: [&str; 6] = ["and", "iff", "implies", "infinity", "not", "or"];

/// The longest name that a file brings in, in characters.
const LONGEST_NAME: usize = 40;

/// What is said of a text that is no name.
pub(crate) const NOT_A_NAME: &str = "a name has 1 to 40 characters: a letter, then letters, digits and _; it is no word of the grammar such as 'sqrt', 'and' and 'infinity'";

/// Whether a text is one name.
pub(crate) fn is_name(text: &str) -> bool {
    read_name(text).is_some()
}

/// A condition between two sides, such as `A < B`.
///
/// # Errors
/// When there is not one of `<`, `>`, `<=`, `>=` and `!=`, or a side is not of the grammar.
pub(crate) fn read_condition(text: &str, functions: &BTreeSet<Symbol>) -> Result<Condition, String> {
    let form = "a condition has one of '<', '>', '<=', '>=' and '!=' between two sides";
    let source = Source::new(text).with_functions(functions);
    let [(left, comparison, right)] = Source::comparisons(text)[..] else { return Err(form.into()) };
    let side = |part: &str| {
        let read = source.expression(part).map_err(|error| format!("'{text}', {error}"))?;
        Ok::<_, String>(read.0)
    };
    let literal = comparison.literal(side(left)?, side(right)?);
    Ok(Condition { relation: literal.sign.relation().ok_or(form)?, expression: literal.expression })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(text: &str) -> String {
        Form::read(text, &BTreeSet::new()).expect_err(text)
    }

    #[test]
    fn derivations_and_expressions_are_read_with_their_arguments() {
        let read = |text: &str| Form::read(text, &BTreeSet::new());
        let form = read("at(a/(b + c), b = 2, c = ln(a))").expect("in the grammar");
        assert_eq!((form.operation, form.values.len()), (Some(Operation::At), 2));
        assert_eq!(form.demands.iter().map(|demand| demand.column).collect::<Vec<_>>(), [6, 28]);
        let form = read(" limit( K*(a + b), a, infinity ) ").expect("in the grammar");
        assert_eq!((form.toward, form.variables[0].as_str()), (Toward::Infinity, "a"));
        assert_eq!(read("(a + b)*c").expect("an expression").operation, None);
        let form = read("at(a*x'', x'' = 0)").expect("in the grammar");
        assert_eq!(form.values[0].0.derivative_order(), 2);
        assert!(read("derivative(a*x', x')").is_ok());
    }

    #[test]
    fn a_wrong_form_is_refused_with_its_place() {
        assert_eq!(refusal("coefficient(P, s)"), "`coefficient(P, s, n)` has 3 arguments, not 2");
        assert!(refusal("1 + solve(P, s)").contains("column 10: 'solve' is not a function"));
        assert!(refusal("solve(P, s) + 1").contains("stands alone"));
        assert!(refusal("solve(P, s").contains("stands alone"));
        assert_eq!(refusal("hurwitz(P, s, x)"), "column 15: 'x' is not a whole number from 0 to 12");
        assert!(refusal("solve(P +, s)").starts_with("column 10: expected a number"));
        assert!(refusal("characteristic(slider, s')").contains("is not a variable"));
        assert!(refusal("at(P, s)").contains("of the form `x = value`"));
        let condition = |text: &str| read_condition(text, &BTreeSet::new());
        assert!(condition("a = b").is_err() && condition("a <= b").is_ok());
    }
}
