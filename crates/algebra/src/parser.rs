//! The text grammar of expressions.
//!
//! ```text
//! sum      := product (('+' | '-') product)*
//! product  := signed (('*' | '/') signed)*
//! signed   := ('-' | '+' | '±') signed | power
//! power    := atom ('^' ['-'] digits)?
//! atom     := decimal | name | function '(' sum ')' | '(' sum ')'
//! name     := letter (letter | digit | '_')* '\''*        function := ln | sqrt | abs | exp | asinh | sin | cos
//! ```
//! `±` stands for the variable `pm` with pm² = 1, and `i` for the variable with i² = −1.
//!
//! A file may declare more functions. Each prime at the end of their names is a derivative.
//!
//! Certificates may have parameters, `'#' digits`, where an expression has a name. No user can write them. Every name before a bracket is
//! that of a function there.

use std::collections::BTreeSet;
use std::str::FromStr;

use thiserror::Error;

use super::expression::symbol::PARAMETER;
use super::{Condition, Expression, Function, Relation, Symbol};
use crate::number::parse_decimal;

/// The deepest nesting that is read; more is refused instead of exhausting the stack.
const MAX_DEPTH: usize = 64;

/// The longest text that is read, in characters: of a user, and of a certificate, which the program has written.
const MAX_LENGTH: usize = 4_000;
const MAX_CERTIFIED_LENGTH: usize = 100_000;

/// The largest exponent of a number that is read: its digits are written out.
const MAX_EXPONENT: i32 = 300;

/// The largest exponent that is read.
const MAX_POWER: i32 = 64;

/// The highest derivative of a function that is read of a user.
const MAX_PRIMES: usize = 6;

/// No functions besides those of the grammar.
pub(super) static NO_FUNCTIONS: BTreeSet<Symbol> = BTreeSet::new();

/// Where and why a text is not an expression.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("column {column}: {message}")]
pub struct ParseError {
    /// Counted in characters from 1.
    pub column: usize,
    /// What was expected or found.
    pub message: String,
}

/// What must hold at a place of the text for the expression to have a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Demand {
    /// Where the divisor, base or argument begins, counted in characters from 1.
    pub column: usize,
    /// What must hold of it.
    pub condition: Condition,
}

/// Which names may stand before a bracket, and whether parameters may occur.
#[derive(Clone, Copy)]
enum Names<'f> {
    /// Of a user: the functions that a file declares.
    Declared(&'f BTreeSet<Symbol>),
    /// Of a certificate.
    Any,
}

struct Parser<'f> {
    names: Names<'f>,
    text: Vec<char>,
    position: usize,
    depth: usize,
    demands: Vec<Demand>,
}

impl Expression {
    /// Reads an expression with all that must hold for it to have a value.
    ///
    /// # Errors
    /// When the text is not of the grammar.
    pub fn read(text: &str) -> Result<(Self, Vec<Demand>), ParseError> {
        Self::read_in(text, &NO_FUNCTIONS)
    }

    /// The same with functions of which nothing is known but these names.
    ///
    /// # Errors
    /// As [`Expression::read`].
    pub fn read_in(text: &str, functions: &BTreeSet<Symbol>) -> Result<(Self, Vec<Demand>), ParseError> {
        Self::read_with(text, Names::Declared(functions))
    }

    fn read_with(text: &str, names: Names<'_>) -> Result<(Self, Vec<Demand>), ParseError> {
        let text = text.chars().collect();
        let mut parser = Parser { names, text, position: 0, depth: 0, demands: Vec::new() };
        let longest = match names {
            Names::Any => MAX_CERTIFIED_LENGTH,
            Names::Declared(_) => MAX_LENGTH,
        };
        if parser.text.len() > longest {
            return Err(parser.error(format!("longer than {longest} characters")));
        }
        let expression = parser.sum()?;
        match parser.peek() {
            None => Ok((expression, parser.demands)),
            Some(found) => Err(parser.error(format!("unexpected '{found}'"))),
        }
    }
}

impl FromStr for Expression {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        Ok(Self::read(text)?.0)
    }
}

/// An expression of a certificate.
impl TryFrom<String> for Expression {
    type Error = ParseError;

    fn try_from(text: String) -> Result<Self, ParseError> {
        Ok(Self::read_with(&text, Names::Any)?.0)
    }
}

impl FromStr for Symbol {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        match text.parse()? {
            Expression::Variable(symbol) if symbol.as_str() == text => Ok(symbol),
            _ => Err(ParseError { column: 1, message: "expected one name".to_owned() }),
        }
    }
}

/// A symbol of a certificate.
impl TryFrom<String> for Symbol {
    type Error = ParseError;

    fn try_from(text: String) -> Result<Self, ParseError> {
        match Expression::try_from(text)? {
            Expression::Variable(symbol) => Ok(symbol),
            Expression::Generic(function, argument) if argument.is_zero() => Ok(Self::at_zero(&function)),
            _ => Err(ParseError { column: 1, message: "expected one name".to_owned() }),
        }
    }
}

impl From<Symbol> for String {
    fn from(symbol: Symbol) -> Self {
        symbol.as_str().to_owned()
    }
}

/// A name that the program itself states.
///
/// # Panics
/// When the text is no name.
impl From<&'static str> for Symbol {
    fn from(name: &'static str) -> Self {
        name.parse().unwrap_or_else(|error| panic!("'{name}' is no name: {error}"))
    }
}

impl Parser<'_> {
    fn error(&self, message: impl Into<String>) -> ParseError {
        ParseError { column: self.position + 1, message: message.into() }
    }

    fn peek(&mut self) -> Option<char> {
        while self.text.get(self.position).is_some_and(|c| c.is_whitespace()) {
            self.position += 1;
        }
        self.text.get(self.position).copied()
    }

    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        self.position += usize::from(found);
        found
    }

    fn expect(&mut self, wanted: char) -> Result<(), ParseError> {
        if self.take(wanted) { Ok(()) } else { Err(self.error(format!("expected '{wanted}'"))) }
    }

    fn sum(&mut self) -> Result<Expression, ParseError> {
        let mut sum = self.product()?;
        loop {
            if self.take('+') {
                sum = sum + self.product()?;
            } else if self.take('-') {
                sum = sum - self.product()?;
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<Expression, ParseError> {
        let mut product = self.signed()?;
        loop {
            if self.take('*') {
                product = as_written(product, self.signed()?);
            } else if self.take('/') {
                let below = self.divisor()?;
                // 0/x keeps its divisor: whether it may be zero is decided where the expression is used.
                let is_zero = product.is_zero();
                product = if is_zero { Expression::quotient(product, below) } else { product / below };
            } else {
                return Ok(product);
            }
        }
    }

    fn signed(&mut self) -> Result<Expression, ParseError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.error(format!("nested deeper than {MAX_DEPTH} levels")));
        }
        let value = if self.take('-') {
            -self.signed()?
        } else if self.take('+') {
            self.signed()?
        } else if self.take('±') {
            Expression::Variable(Symbol::read("pm")) * self.signed()?
        } else {
            self.power()?
        };
        self.depth -= 1;
        Ok(value)
    }

    fn divisor(&mut self) -> Result<Expression, ParseError> {
        self.peek();
        let column = self.position + 1;
        let divisor = self.signed()?;
        self.demand(column, &divisor, Relation::NonZero);
        Ok(divisor)
    }

    /// Notes what must hold for the expression read so far to have a value.
    fn demand(&mut self, column: usize, expression: &Expression, relation: Relation) {
        let condition = Condition { expression: expression.clone(), relation };
        self.demands.push(Demand { column, condition });
    }

    fn power(&mut self) -> Result<Expression, ParseError> {
        self.peek();
        let column = self.position + 1;
        let base = self.atom()?;
        if !self.take('^') {
            return Ok(base);
        }
        let negative = self.take('-');
        self.peek();
        let digits = self.take_while(|c| c.is_ascii_digit());
        let exponent = digits.parse::<i32>().ok().filter(|exponent| *exponent <= MAX_POWER);
        let Some(exponent) = exponent else {
            return Err(self.error(format!("expected a whole exponent up to {MAX_POWER}")));
        };
        if negative || exponent == 0 {
            self.demand(column, &base, Relation::NonZero);
        }
        Ok(match exponent {
            0 => Expression::Power(Box::new(base), 0),
            _ => base.power(if negative { -exponent } else { exponent }),
        })
    }

    fn atom(&mut self) -> Result<Expression, ParseError> {
        match self.peek() {
            Some('(') => self.parenthesised(),
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() => self.named(),
            Some(PARAMETER) if matches!(self.names, Names::Any) => self.parameter(),
            Some(found) => Err(self.error(format!("expected a number, a name or '(', found '{found}'"))),
            None => Err(self.error("expected a number, a name or '(', found the end")),
        }
    }

    fn parenthesised(&mut self) -> Result<Expression, ParseError> {
        self.expect('(')?;
        let inner = self.sum()?;
        self.expect(')')?;
        Ok(inner)
    }

    fn number(&mut self) -> Result<Expression, ParseError> {
        let start = self.position;
        let mut digits = self.take_while(|c| c.is_ascii_digit() || c == '.');
        if let ['e' | 'E', '+' | '-', '0'..='9', ..] | ['e' | 'E', '0'..='9', ..] = self.text[self.position..]
        {
            digits.extend(&self.text[self.position..self.position + 2]);
            self.position += 2;
            digits += &self.take_while(|c| c.is_ascii_digit());
        }
        let exponent = digits.split(['e', 'E']).nth(1).map_or(Ok(0), str::parse::<i32>);
        if exponent.map_or(true, |exponent| exponent.abs() > MAX_EXPONENT) {
            let message = format!("'{digits}' is beyond exponents of {MAX_EXPONENT}");
            return Err(ParseError { column: start + 1, message });
        }
        parse_decimal(&digits)
            .map(Expression::Number)
            .map_err(|error| ParseError { column: start + 1, message: format!("'{digits}' is {error}") })
    }

    fn parameter(&mut self) -> Result<Expression, ParseError> {
        self.position += 1;
        let digits = self.take_while(|c| c.is_ascii_digit());
        let number = digits.parse().map_err(|_| self.error("expected the number of a parameter"))?;
        Ok(Expression::Variable(Symbol::parameter(number)))
    }

    fn named(&mut self) -> Result<Expression, ParseError> {
        let start = self.position;
        let mut name = self.take_while(|c| c.is_ascii_alphanumeric() || c == '_');
        name += &self.take_while(|c| c == '\'');
        match Function::from_word(&name) {
            Some(function) => {
                self.peek();
                let column = self.position + 1;
                let argument = self.parenthesised()?;
                match function {
                    Function::Ln => self.demand(column, &argument, Relation::Positive),
                    Function::Sqrt => self.demand(column, &argument, Relation::NonNegative),
                    Function::Abs | Function::Exp | Function::Asinh | Function::Sin | Function::Cos => {}
                }
                Ok(argument.call(function))
            }
            None if self.is_function(&name) => self.generic(&name, start + 1),
            None if self.peek() == Some('(') => {
                Err(self.error(format!("'{name}' is not a function (write * for products)")))
            }
            None => Ok(Expression::Variable(Symbol::read(&name))),
        }
    }

    /// Whether a name is that of a function besides those of the grammar.
    fn is_function(&mut self, name: &str) -> bool {
        match self.names {
            Names::Any => self.peek() == Some('('),
            Names::Declared(functions) => functions.contains(&Symbol::read(name).undifferentiated()),
        }
    }

    /// A function of which nothing is known; its name begins at the column.
    fn generic(&mut self, name: &str, column: usize) -> Result<Expression, ParseError> {
        let function = Symbol::read(name);
        let base = function.base();
        if self.peek() != Some('(') {
            return Err(ParseError { column, message: format!("{base} is a function: write {name}(...)") });
        }
        if matches!(self.names, Names::Declared(_)) && function.derivative_order() > MAX_PRIMES {
            return Err(ParseError { column, message: format!("{base} has at most {MAX_PRIMES} primes") });
        }
        Ok(Expression::Generic(function, Box::new(self.parenthesised()?)))
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> String {
        let start = self.position;
        while self.text.get(self.position).is_some_and(|c| wanted(*c)) {
            self.position += 1;
        }
        self.text[start..self.position].iter().collect()
    }
}

/// left·right; a zero keeps the other factor unless that has a value everywhere.
fn as_written(left: Expression, right: Expression) -> Expression {
    let dropped = if left.is_zero() { &right } else { &left };
    if (left.is_zero() || right.is_zero()) && !dropped.is_total() {
        return Expression::Product(vec![left, right]);
    }
    left * right
}

impl TryFrom<String> for Condition {
    type Error = ParseError;

    fn try_from(text: String) -> Result<Self, ParseError> {
        let parts = Relation::ALL
            .iter()
            .find_map(|&relation| Some((text.strip_suffix(relation.as_str())?, relation)));
        let (expression, relation) = parts.ok_or_else(|| ParseError {
            column: text.chars().count(),
            message: "a condition ends with '> 0', '>= 0' or '!= 0'".to_owned(),
        })?;
        Ok(Self { expression: expression.to_owned().try_into()?, relation })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(text: &str) -> String {
        text.parse::<Expression>().expect_err("malformed").to_string()
    }

    #[test]
    fn faults_name_the_column() {
        assert_eq!(message("a + "), "column 5: expected a number, a name or '(', found the end");
        assert_eq!(message("(a"), "column 3: expected ')'");
        assert_eq!(message("a b"), "column 3: unexpected 'b'");
        assert_eq!(message("f(x)"), "column 2: 'f' is not a function (write * for products)");
        assert_eq!(message("x^y"), "column 3: expected a whole exponent up to 64");
        assert_eq!(message("1e"), "column 2: unexpected 'e'");
        assert_eq!(message("2e3x"), "column 4: unexpected 'x'");
        assert_eq!(message("1e-301"), "column 1: '1e-301' is beyond exponents of 300");
        for (text, plain) in
            [("1e3", "1000"), ("2.5E-3*x", "0.0025*x"), ("1e+2 - 1e-2", "100 - 0.01"), ("1e0", "1")]
        {
            assert_eq!(text.parse::<Expression>(), plain.parse(), "{text}");
        }
        assert!(message("1.2.3").starts_with("column 1: '1.2.3' is not a decimal number"));
    }

    #[test]
    fn declared_functions_are_read_with_their_primes_and_no_others() {
        let functions = ["f", "g_1"].map(Symbol::from).into();
        let read =
            |text: &str| Expression::read_in(text, &functions).map(|(expression, _)| expression.to_string());
        let fault = |text: &str| read(text).expect_err("malformed").to_string();
        for text in ["f(x)", "2*f'(x + 1)", "f''''''(f(x))*g_1(0)", "sqrt(f(x)^2)"] {
            assert_eq!(read(text).as_deref(), Ok(text));
        }
        assert_eq!(fault("x + f"), "column 5: f is a function: write f(...)");
        assert_eq!(fault("f'*x"), "column 1: f is a function: write f'(...)");
        assert_eq!(fault("f'''''''(x)"), "column 1: f has at most 6 primes");
        assert_eq!(fault("h(x)"), "column 2: 'h' is not a function (write * for products)");
        assert_eq!(fault("f(x"), "column 4: expected ')'");
        assert_eq!(fault("f()"), "column 3: expected a number, a name or '(', found ')'");
        // The divisor in the argument counts, the function itself has a value everywhere.
        let (_, demands) = Expression::read_in("f(1/x)", &functions).expect("in the grammar");
        assert_eq!(demands.iter().map(|demand| demand.column).collect::<Vec<_>>(), [5]);
    }

    #[test]
    fn deep_nesting_is_refused() {
        let text = format!("{}x{}", "(".repeat(100), ")".repeat(100));
        assert!(message(&text).contains("nested deeper"));
    }

    #[test]
    fn demands_have_their_columns_and_long_sums_are_not_deep() {
        let (_, demands) =
            Expression::read("x + (y - 1)^-2 + ln(x)*sqrt( y)/(x - y)^2").expect("in the grammar");
        let columns = demands.iter().map(|demand| format!("{} {}", demand.column, demand.condition));
        assert_eq!(
            columns.collect::<Vec<_>>(),
            ["5 y - 1 != 0", "20 x > 0", "28 y >= 0", "33 (x - y)^2 != 0"]
        );
        let sum = vec!["x^2"; 400].join(" + ");
        assert!(sum.parse::<Expression>().is_ok());
        let parameters = Expression::try_from("2*#13 + #2".to_owned()).expect("of a certificate").variables();
        assert_eq!(parameters, [13, 2].map(Symbol::parameter).into());
        assert!("x + 1".parse::<Symbol>().is_err() && "(x)".parse::<Symbol>().is_err());
    }
}
