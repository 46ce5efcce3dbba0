//! What a polynomial is a polynomial in: names, parameters of a proof, and functions that keep their argument.
//!
//! A [`Symbol`] is a name that the parser has read, or a parameter, which is a number and which no user can write. It has values of its own.
//! A [`Generator`] is a symbol or a function of something, such as `sqrt(V)`. A function has no values of its own: a point gives values to
//! symbols only, and functions are computed from them. To a function f of which nothing is known a point gives its value at 0 and those of
//! its derivatives, which are symbols too ([`Symbol::at_zero`]): `f(V)` is computed from them as a polynomial.
//!
//! Primes at the end of a name count time derivatives (`theta'` is dθ/dt), so that a differential equation is a polynomial in the names.
//!
//! Text that is computed makes no symbol without the parser:
//!
//! ```compile_fail
//! let name = String::from("sqrt(V)");
//! let symbol = slipmode_algebra::Symbol::from(name);
//! ```
//!
//! ```compile_fail
//! let name = format!("gap_{}", 0);
//! let symbol = slipmode_algebra::Symbol::from(name.as_str());
//! ```

use std::borrow::Borrow;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use crate::{Expression, Function};

/// What the text of a parameter begins with; no name does.
pub(crate) const PARAMETER: char = '#';

/// What the text of a function's value at 0 ends with; no name does.
const AT_ZERO: &str = "(0)";

/// A variable or a function of something. Ordered by its text, which the parser reads back.
#[derive(Debug, Clone)]
pub struct Generator {
    text: Arc<str>,
    /// The function of something; none for a symbol.
    call: Option<Arc<Expression>>,
}

impl Generator {
    /// A function of this argument.
    #[must_use]
    pub fn call(function: Function, argument: Expression) -> Self {
        Self::of(argument.call(function))
    }

    /// A function of this argument of which nothing is known; each prime of the function is a derivative.
    #[must_use]
    pub fn generic(function: &Symbol, argument: Expression) -> Self {
        Self::of(Expression::Generic(function.clone(), Box::new(argument)))
    }

    fn of(call: Expression) -> Self {
        Self { text: Arc::from(call.to_string()), call: Some(Arc::new(call)) }
    }

    /// The text.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// The function with its argument; none for a symbol, and for a function of which nothing is known.
    #[must_use]
    pub fn function(&self) -> Option<(Function, &Expression)> {
        match self.call.as_deref() {
            Some(Expression::Call(function, argument)) => Some((*function, argument)),
            _ => None,
        }
    }

    /// The function of which nothing is known, with its primes, if this is one of something.
    pub(crate) fn generic_function(&self) -> Option<&Symbol> {
        match self.call.as_deref() {
            Some(Expression::Generic(function, _)) => Some(function),
            _ => None,
        }
    }

    /// The argument, if this is the given function of something.
    pub(crate) fn argument_of(&self, function: Function) -> Option<&Expression> {
        self.function().filter(|(own, _)| *own == function).map(|(_, argument)| argument)
    }

    /// The symbol; none for a function.
    #[must_use]
    pub fn symbol(&self) -> Option<Symbol> {
        self.call.is_none().then(|| Symbol(self.clone()))
    }

    /// The symbols in it.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<Symbol> {
        match &self.call {
            None => BTreeSet::from([Symbol(self.clone())]),
            Some(call) => call.variables(),
        }
    }

    /// Whether it is a function of something with this symbol.
    #[must_use]
    pub fn hides(&self, symbol: &Symbol) -> bool {
        self.call.as_ref().is_some_and(|call| call.variables().contains(symbol))
    }
}

impl From<&Generator> for Expression {
    fn from(generator: &Generator) -> Self {
        match &generator.call {
            None => Self::Variable(Symbol(generator.clone())),
            Some(call) => (**call).clone(),
        }
    }
}

impl PartialEq for Generator {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.text, &other.text) || self.text == other.text
    }
}

impl Eq for Generator {}

impl PartialOrd for Generator {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Generator {
    fn cmp(&self, other: &Self) -> Ordering {
        if Arc::ptr_eq(&self.text, &other.text) { Ordering::Equal } else { self.text.cmp(&other.text) }
    }
}

impl Hash for Generator {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.text.hash(state);
    }
}

impl AsRef<Generator> for Generator {
    fn as_ref(&self) -> &Generator {
        self
    }
}

impl fmt::Display for Generator {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

/// A name or a parameter, cheap to clone and ordered alphabetically.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "String", into = "String"))]
pub struct Symbol(Generator);

impl Symbol {
    /// A name that the parser has read.
    pub(crate) fn read(name: &str) -> Self {
        Self(Generator { text: Arc::from(name), call: None })
    }

    /// A parameter of a proof, by its number. No user can write it.
    #[must_use]
    pub fn parameter(number: u32) -> Self {
        Self::read(&format!("{PARAMETER}{number}"))
    }

    /// The parameter with the least number that is above those of all these symbols.
    #[must_use]
    pub fn fresh<'s>(used: impl IntoIterator<Item = &'s Self>) -> Self {
        let next = used.into_iter().filter_map(Self::number).map(|number| number + 1);
        Self::parameter(next.max().unwrap_or_default())
    }

    /// What a point gives of a function, or of a derivative of it: the value at 0. No user can write it as a name.
    #[must_use]
    pub fn at_zero(function: &Self) -> Self {
        Self::read(&format!("{function}{AT_ZERO}"))
    }

    /// The function, with its primes, of which this is the value at 0; none for a name and a parameter.
    #[must_use]
    pub fn function_at_zero(&self) -> Option<Self> {
        self.as_str().strip_suffix(AT_ZERO).map(Self::read)
    }

    /// The number of a parameter; none for a name.
    #[must_use]
    pub fn number(&self) -> Option<u32> {
        self.as_str().strip_prefix(PARAMETER)?.parse().ok()
    }

    /// The whole name, primes included.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0.text
    }

    /// The name without its primes.
    #[must_use]
    pub fn base(&self) -> &str {
        self.as_str().trim_end_matches('\'')
    }

    /// The number of primes: the order of the time derivative, or of the derivative of a function.
    #[must_use]
    pub fn derivative_order(&self) -> usize {
        self.as_str().len() - self.base().len()
    }

    /// The variable of which this is a time derivative, or the function of which it is a derivative: the name without its primes.
    #[must_use]
    pub fn undifferentiated(&self) -> Self {
        Self::read(self.base())
    }

    /// The time derivative of this variable, or the derivative of this function: one more prime.
    #[must_use]
    pub fn time_derivative(&self) -> Self {
        Self::read(&format!("{self}'"))
    }
}

impl From<&Self> for Symbol {
    fn from(symbol: &Self) -> Self {
        symbol.clone()
    }
}

impl From<Symbol> for Generator {
    fn from(symbol: Symbol) -> Self {
        symbol.0
    }
}

impl AsRef<Generator> for Symbol {
    fn as_ref(&self) -> &Generator {
        &self.0
    }
}

impl Borrow<Generator> for Symbol {
    fn borrow(&self) -> &Generator {
        &self.0
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primes_count_time_derivatives() {
        let velocity = Symbol::from("delta").time_derivative();
        assert_eq!(velocity.as_str(), "delta'");
        assert_eq!(velocity.time_derivative().derivative_order(), 2);
        assert_eq!(velocity.base(), "delta");
    }

    #[test]
    fn a_parameter_is_a_number_that_no_user_can_write() {
        let third = Symbol::parameter(3);
        assert_eq!((third.as_str(), third.number()), ("#3", Some(3)));
        assert_eq!(Symbol::fresh([&third, &Symbol::from("x"), &Symbol::parameter(1)]), Symbol::parameter(4));
        assert_eq!(Symbol::fresh([]), Symbol::parameter(0));
        assert!("#3".parse::<Symbol>().is_err() && "#3 + 1".parse::<Expression>().is_err());
    }

    #[test]
    fn a_function_keeps_its_argument() {
        let root = Generator::call(Function::Sqrt, "x*y".parse().expect("in the grammar"));
        assert_eq!((root.as_str(), root.symbol()), ("sqrt(x*y)", None));
        assert_eq!(root.variables(), ["x", "y"].map(Symbol::from).into());
        assert!(root.hides(&Symbol::from("x")) && !root.hides(&Symbol::from("z")));
        let slope = Generator::generic(&Symbol::from("f'"), "x*y".parse().expect("in the grammar"));
        assert_eq!((slope.as_str(), slope.symbol(), slope.function()), ("f'(x*y)", None, None));
        assert!(slope.hides(&Symbol::from("x")) && !slope.hides(&Symbol::from("f'")));
    }

    #[test]
    fn the_value_at_0_of_a_function_is_no_name() {
        let slope = Symbol::at_zero(&Symbol::from("f'"));
        assert_eq!((slope.as_str(), slope.function_at_zero()), ("f'(0)", Some(Symbol::from("f'"))));
        assert_eq!(Symbol::from("f'").function_at_zero(), None);
        assert!("f'(0)".parse::<Symbol>().is_err());
        assert_eq!(Symbol::try_from("f'(0)".to_owned()), Ok(slope));
        assert!(
            Symbol::try_from("f'(1)".to_owned()).is_err() && Symbol::try_from("f(x)".to_owned()).is_err()
        );
    }
}
