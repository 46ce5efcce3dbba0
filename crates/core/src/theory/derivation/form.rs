//! The forms of derivations: `coefficient(P, s, 2)`, or an expression.

use std::collections::BTreeSet;

use slipmode_algebra::{Condition, Demand, Expression, ParseError, Symbol, Toward};

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
    Variable,
    Whole,
    End,
    Values,
}

impl Operation {
    /// The form in words, and the kinds of its arguments.
    fn form(self) -> (&'static str, &'static [Kind]) {
        use Kind::{End, Expression, System, Values, Variable, Whole};
        match self {
            Self::Characteristic => ("characteristic(system, s)", &[System, Variable]),
            Self::Linearised => ("linearised(system, rate_state, by_state)", &[System, Variable, Variable]),
            Self::Rate => ("rate(f, system)", &[Expression, System]),
            Self::Coefficient => ("coefficient(P, s, n)", &[Expression, Variable, Whole]),
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
#[derive(Debug, Clone, PartialEq, Eq)]
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
    /// Reads the right side of a definition.
    ///
    /// # Errors
    /// With the column: text outside the grammar, a wrong number of arguments, an argument of a wrong kind.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut form = Self {
            operation: None,
            system: None,
            expressions: Vec::new(),
            variables: Vec::new(),
            whole: 0,
            toward: Toward::Zero,
            values: Vec::new(),
            demands: Vec::new(),
        };
        let called = text.split_once('(').map(|(word, rest)| (word.trim(), rest));
        let called = called.and_then(|(word, rest)| Some((Operation::from_word(word)?, rest)));
        let Some((operation, rest)) = called else {
            form.expression(text, 0)?;
            return Ok(form);
        };
        form.operation = Some(operation);
        let (words, kinds) = operation.form();
        let start = text.len() - rest.len();
        let arguments = arguments(text, start).ok_or_else(|| {
            format!(
                "`{}` has the form `{words}` and stands alone: give it a name of its own",
                operation.as_str()
            )
        })?;
        let wanted = if kinds.contains(&Kind::Values) { arguments.len().max(2) } else { kinds.len() };
        if arguments.len() != wanted {
            return Err(format!("`{words}` has {wanted} arguments, not {}", arguments.len()));
        }
        let kinds = kinds.iter().chain(std::iter::repeat(&kinds[kinds.len() - 1]));
        for ((offset, argument), kind) in arguments.into_iter().zip(kinds) {
            form.argument(argument, offset, *kind)?;
        }
        Ok(form)
    }

    fn argument(&mut self, text: &str, offset: usize, kind: Kind) -> Result<(), String> {
        let trimmed = text.trim();
        let wrong = |wanted: &str| Err(format!("column {}: '{trimmed}' is not {wanted}", offset + 1));
        match kind {
            Kind::Expression => self.expression(text, offset)?,
            Kind::System if is_name(trimmed) => self.system = Some(trimmed.to_owned()),
            Kind::System => return wrong("the name of a system"),
            Kind::Variable => match read_name(trimmed) {
                Some(name) => self.variables.push(name),
                None => return wrong("a variable"),
            },
            Kind::Whole => match trimmed.parse() {
                Ok(whole) if whole <= LARGEST_WHOLE => self.whole = whole,
                _ => return wrong(&format!("a whole number from 0 to {LARGEST_WHOLE}")),
            },
            Kind::End => match trimmed {
                "0" => self.toward = Toward::Zero,
                "infinity" => self.toward = Toward::Infinity,
                _ => return wrong("0 or infinity"),
            },
            Kind::Values => match text.split_once('=') {
                Some((name, value)) => {
                    let Some(symbol) = read_name(name.trim()) else {
                        return wrong("of the form `x = value`");
                    };
                    self.expression(value, offset + name.chars().count() + 1)?;
                    self.values.extend(self.expressions.pop().map(|value| (symbol, value)));
                }
                None => return wrong("of the form `x = value`"),
            },
        }
        Ok(())
    }

    fn expression(&mut self, text: &str, offset: usize) -> Result<(), String> {
        let (expression, demands) = Expression::read(text).map_err(|error| {
            let ParseError { column, message } = error;
            format!("column {}: {message}", column + offset)
        })?;
        self.expressions.push(expression);
        let moved = demands.into_iter().map(|demand| Demand { column: demand.column + offset, ..demand });
        self.demands.extend(moved);
        Ok(())
    }

    /// The names that occur in the expressions.
    pub fn names(&self) -> BTreeSet<Symbol> {
        let values = self.values.iter().map(|(_, value)| value);
        self.expressions.iter().chain(values).flat_map(Expression::variables).collect()
    }

    /// The variable that the derivation brings in.
    pub fn new_variable(&self) -> Option<&Symbol> {
        self.variables.first().filter(|_| self.operation == Some(Operation::Characteristic))
    }
}

/// A name that a file brings in: without primes, and no word of the grammar.
pub(in crate::theory) fn read_name(text: &str) -> Option<Symbol> {
    let is_short = text.len() <= LONGEST_NAME;
    let symbol = is_short.then(|| text.parse::<Symbol>().ok()).flatten();
    symbol.filter(|symbol| symbol.derivative_order() == 0 && !CONNECTIVES.contains(&symbol.as_str()))
}

/// Words between the comparisons of a formula.
const CONNECTIVES: [&str; 5] = ["and", "iff", "implies", "not", "or"];

/// The longest name that a file brings in, in characters.
const LONGEST_NAME: usize = 40;

/// Whether a text is one name.
pub(in crate::theory) fn is_name(text: &str) -> bool {
    read_name(text).is_some()
}

/// The arguments of a call that ends with the text, with their offsets in characters; none when it does not.
fn arguments(text: &str, start: usize) -> Option<Vec<(usize, &str)>> {
    let mut found = Vec::new();
    let (mut depth, mut begin) = (1_usize, start);
    for (place, character) in text.char_indices().filter(|(place, _)| *place >= start) {
        depth = match character {
            '(' => depth + 1,
            ')' => depth.checked_sub(1)?,
            _ => depth,
        };
        if depth == 0 || (depth == 1 && character == ',') {
            found.push((text[..begin].chars().count(), &text[begin..place]));
            begin = place + 1;
        }
        if depth == 0 {
            return text[begin..].trim().is_empty().then_some(found);
        }
    }
    None
}

/// A condition between two sides, such as `A < B`.
///
/// # Errors
/// When there is not one of `<`, `>`, `<=`, `>=` and `!=`, or a side is not of the grammar.
pub(in crate::theory) fn read_condition(text: &str) -> Result<Condition, String> {
    use slipmode_algebra::Relation::{NonNegative, NonZero, Positive};
    let marks = [("<=", NonNegative, true), (">=", NonNegative, false), ("!=", NonZero, false)];
    let marks = marks.into_iter().chain([("<", Positive, true), (">", Positive, false)]);
    let found = marks.into_iter().find_map(|(mark, relation, swapped)| {
        let (left, right) = text.split_once(mark)?;
        Some((if swapped { [right, left] } else { [left, right] }, relation))
    });
    let form = "a condition has one of '<', '>', '<=', '>=' and '!=' between two sides";
    let (sides, relation) = found.ok_or(form)?;
    let side = |text: &str| {
        let read = text.trim().parse::<Expression>();
        read.map_err(|error| format!("'{}', {error}", text.trim()))
    };
    Ok(Condition { expression: side(sides[0])? - side(sides[1])?, relation })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(text: &str) -> String {
        Form::read(text).expect_err(text)
    }

    #[test]
    fn derivations_and_expressions_are_read_with_their_arguments() {
        let form = Form::read("at(a/(b + c), b = 2, c = ln(a))").expect("in the grammar");
        assert_eq!((form.operation, form.values.len()), (Some(Operation::At), 2));
        assert_eq!(form.demands.iter().map(|demand| demand.column).collect::<Vec<_>>(), [6, 28]);
        let form = Form::read(" limit( K*(a + b), a, infinity ) ").expect("in the grammar");
        assert_eq!((form.toward, form.variables[0].as_str()), (Toward::Infinity, "a"));
        assert_eq!(Form::read("(a + b)*c").expect("an expression").operation, None);
    }

    #[test]
    fn a_wrong_form_is_refused_with_its_place() {
        assert_eq!(refusal("coefficient(P, s)"), "`coefficient(P, s, n)` has 3 arguments, not 2");
        assert!(refusal("1 + solve(P, s)").contains("column 10: 'solve' is not a function"));
        assert!(refusal("solve(P, s) + 1").contains("stands alone"));
        assert!(refusal("solve(P, s").contains("stands alone"));
        assert_eq!(refusal("hurwitz(P, s, x)"), "column 14: 'x' is not a whole number from 0 to 12");
        assert!(refusal("solve(P +, s)").starts_with("column 10: expected a number"));
        assert!(refusal("at(P, s)").contains("of the form `x = value`"));
        assert!(read_condition("a = b").is_err() && read_condition("a <= b").is_ok());
    }
}
