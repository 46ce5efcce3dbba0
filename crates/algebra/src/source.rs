//! The text around expressions, taken apart: calls with arguments, comparisons, and the place of each part.
//!
//! A language built of expressions takes its texts apart here, so that a bracket, a comma and a column mean the same everywhere.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use crate::parser::NO_FUNCTIONS;
use crate::{Demand, Expression, Literal, ParseError, Sign, Symbol};

crate::named! {
    /// How two sides compare.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Comparison {
        /// The left side is not larger.
        AtMost = "<=",
        /// The left side is not smaller.
        AtLeast = ">=",
        /// Not equal.
        Unequal = "!=",
        /// Equal.
        Equal = "=",
        /// The left side is smaller.
        Less = "<",
        /// The left side is larger.
        Greater = ">",
    }
}

impl Comparison {
    /// Whether two numbers in this order compare so.
    #[must_use]
    pub fn holds(self, order: Ordering) -> bool {
        match self {
            Self::AtMost => order.is_le(),
            Self::AtLeast => order.is_ge(),
            Self::Unequal => order.is_ne(),
            Self::Equal => order.is_eq(),
            Self::Less => order.is_lt(),
            Self::Greater => order.is_gt(),
        }
    }

    /// The comparison of two sides as one of their difference with zero.
    #[must_use]
    pub fn literal(self, left: Expression, right: Expression) -> Literal {
        match self {
            Self::Greater => Literal::new(left - right, Sign::Positive),
            Self::AtLeast => Literal::new(left - right, Sign::NonNegative),
            Self::Less => Literal::new(right - left, Sign::Positive),
            Self::AtMost => Literal::new(right - left, Sign::NonNegative),
            Self::Equal => Literal::new(left - right, Sign::Zero),
            Self::Unequal => Literal::new(left - right, Sign::NonZero),
        }
    }
}

/// A text whose parts are read: each fault has its column in the whole text.
///
/// # Examples
/// ```
/// use slipmode_algebra::{Comparison, Source};
///
/// let source = Source::new("solve(a + (b - 1, x) > 2");
/// let [(left, comparison, right)] = Source::comparisons(source.text())[..] else { unreachable!() };
/// assert_eq!((left, comparison, right), ("solve(a + (b - 1, x) ", Comparison::Greater, " 2"));
/// assert_eq!(source.column(right.trim()), 24);
///
/// let source = Source::new("solve(ln(a + b), x)");
/// let (word, arguments) = Source::call(source.text());
/// assert_eq!((word, arguments), ("solve", Some(vec!["ln(a + b)", " x"])));
///
/// let source = Source::new("solve(a +, x)");
/// let (_, arguments) = Source::call(source.text());
/// assert_eq!(source.expression(arguments.unwrap()[0]).unwrap_err().column, 10);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Source<'t> {
    text: &'t str,
    functions: &'t BTreeSet<Symbol>,
}

impl<'t> Source<'t> {
    /// The whole text.
    #[must_use]
    pub fn new(text: &'t str) -> Self {
        Self { text, functions: &NO_FUNCTIONS }
    }

    /// The same text, in which these are functions of which nothing is known.
    #[must_use]
    pub fn with_functions(self, functions: &'t BTreeSet<Symbol>) -> Self {
        Self { functions, ..self }
    }

    /// The text as given.
    #[must_use]
    pub fn text(&self) -> &'t str {
        self.text
    }

    /// The column at which a part of the text begins, counted in characters from 1; past the end for what is no part of it.
    #[must_use]
    pub fn column(&self, part: &str) -> usize {
        let start = (part.as_ptr() as usize).wrapping_sub(self.text.as_ptr() as usize);
        self.text.get(..start).unwrap_or(self.text).chars().count() + 1
    }

    /// The expression that a part of the text is, and what must hold for it to have a value.
    ///
    /// # Errors
    /// As [`Expression::read`], with the column in the whole text.
    pub fn expression(&self, part: &str) -> Result<(Expression, Vec<Demand>), ParseError> {
        let part = part.trim();
        let before = self.column(part) - 1;
        let moved = |demand: Demand| Demand { column: demand.column + before, ..demand };
        match Expression::read_in(part, self.functions) {
            Ok((expression, demands)) => Ok((expression, demands.into_iter().map(moved).collect())),
            Err(error) => Err(ParseError { column: error.column + before, ..error }),
        }
    }

    /// The word before the first bracket of a part; and the texts between the commas, where that bracket is closed at the part's end.
    #[must_use]
    pub fn call(part: &'t str) -> (&'t str, Option<Vec<&'t str>>) {
        let (word, inside) = part.split_once('(').unwrap_or((part, ""));
        (word.trim(), arguments(inside))
    }

    /// Every comparison in a part, with all that stands before it and all that stands after it.
    #[must_use]
    pub fn comparisons(part: &'t str) -> Vec<(&'t str, Comparison, &'t str)> {
        let (mut found, mut from) = (Vec::new(), 0);
        while let Some(next) = part[from..].find(['=', '<', '>', '!']) {
            let at = from + next;
            from = at + 1;
            if let Some(comparison) =
                Comparison::ALL.into_iter().find(|one| part[at..].starts_with(one.as_str()))
            {
                from = at + comparison.as_str().len();
                found.push((&part[..at], comparison, &part[from..]));
            }
        }
        found
    }
}

/// The texts between the commas outside brackets, up to the bracket that ends the call; none where it is not the text's last one.
fn arguments(inside: &str) -> Option<Vec<&str>> {
    let (mut found, mut depth, mut begin) = (Vec::new(), 1_usize, 0);
    for (place, character) in inside.char_indices() {
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 || (depth == 1 && character == ',') {
            found.push(&inside[begin..place]);
            begin = place + 1;
        }
        if depth == 0 {
            return inside[begin..].trim().is_empty().then_some(found);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_ends_with_its_own_bracket() {
        assert_eq!(Source::call("f(a, (b, c)) "), ("f", Some(vec!["a", " (b, c)"])));
        assert_eq!(Source::call("f()"), ("f", Some(vec![""])));
        for open in ["f", "f(a", "f(a) + (b)", "f(a)) + b", "f(a))"] {
            assert_eq!(Source::call(open).1, None, "{open}");
        }
    }

    #[test]
    fn columns_count_characters_in_the_whole_text() {
        let source = Source::new("σ·, a/(b - 1) , c +");
        let parts: Vec<&str> = source.text().split(',').collect();
        let (_, demands) = source.expression(parts[1]).expect("in the grammar");
        assert_eq!(demands[0].column, 7);
        assert_eq!(source.expression(parts[2]).expect_err("it ends").column, 20);
        assert_eq!(source.column("elsewhere"), 20);
        let functions = BTreeSet::from(["f".into()]);
        let source = Source::new("f(x)").with_functions(&functions);
        assert!(source.expression(source.text()).is_ok() && Source::new("f(x)").expression("f(x)").is_err());
    }

    #[test]
    fn comparisons_are_the_longest_marks_in_their_order() {
        let all = |text| {
            let found = Source::comparisons(text);
            found.into_iter().map(|(left, comparison, _)| (left, comparison.as_str())).collect::<Vec<_>>()
        };
        assert_eq!(all("a <= b != c"), [("a ", "<="), ("a <= b ", "!=")]);
        assert_eq!(all("a ! b => c"), [("a ! b ", "="), ("a ! b =", ">")]);
        assert_eq!(all("a"), []);
    }
}
