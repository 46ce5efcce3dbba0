//! Expressions of which it is known by construction where they have a value and which sign they have.

use std::borrow::Borrow;
use std::collections::BTreeSet;
use std::ops::{Add, Div, Mul, Sub};

/// A name in a claim; a [`World`](super::world::World) spells it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Name {
    /// A positive variable.
    Positive(usize),
    /// A variable of either sign.
    Free(usize),
    /// The name that stands for the roots of a polynomial.
    Root,
    /// A name that the claim's own equations define.
    Defined(usize),
    /// The function of which nothing is known.
    Function,
}

/// An expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Term {
    /// A quotient of two whole numbers, the second one positive.
    Number(i64, i64),
    Name(Name),
    Sum(Vec<Term>),
    Product(Vec<Term>),
    Quotient(Box<[Term; 2]>),
    Power(Box<Term>, i32),
    Call(&'static str, Box<Term>),
}

/// A whole number.
pub fn n(value: i64) -> Term {
    Term::Number(value, 1)
}

/// A positive variable.
pub fn p(index: usize) -> Term {
    Term::Name(Name::Positive(index))
}

/// A variable of either sign.
pub fn f(index: usize) -> Term {
    Term::Name(Name::Free(index))
}

/// The variable of a polynomial.
pub fn s() -> Term {
    Term::Name(Name::Root)
}

/// What the function of which nothing is known and its derivatives are called before they are spelled.
const UNKNOWN: [&str; 6] = ["?", "?'", "?''", "?'''", "?''''", "?'''''"];

/// A derivative of the function of which nothing is known.
pub fn unknown(order: usize, argument: &Term) -> Term {
    argument.call(UNKNOWN[order])
}

pub fn sqrt(inner: impl Borrow<Term>) -> Term {
    inner.borrow().call("sqrt")
}

pub fn exp(inner: impl Borrow<Term>) -> Term {
    inner.borrow().call("exp")
}

pub fn ln(inner: impl Borrow<Term>) -> Term {
    inner.borrow().call("ln")
}

pub fn minus(inner: impl Borrow<Term>) -> Term {
    n(-1) * inner.borrow()
}

impl Term {
    pub fn call(&self, function: &'static str) -> Self {
        Self::Call(function, Box::new(self.clone()))
    }

    /// The order of the derivative that it is of the function of which nothing is known.
    pub fn primes(&self) -> usize {
        match self {
            Self::Call(function, _) => function.len() - 1,
            _ => 0,
        }
    }

    pub fn power(&self, exponent: i32) -> Self {
        Self::Power(Box::new(self.clone()), exponent)
    }

    /// The sum, written as one where this already is a sum.
    fn plus(self, other: Self) -> Self {
        match self {
            Self::Sum(mut parts) => {
                parts.push(other);
                Self::Sum(parts)
            }
            first => Self::Sum(vec![first, other]),
        }
    }

    /// The parts from which it is made.
    pub fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Number(..) | Self::Name(_) => Vec::new(),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().collect(),
            Self::Quotient(both) => both.iter().collect(),
            Self::Power(inner, _) | Self::Call(_, inner) => vec![inner],
        }
    }

    fn parts_mut(&mut self) -> Vec<&mut Self> {
        match self {
            Self::Number(..) | Self::Name(_) => Vec::new(),
            Self::Sum(parts) | Self::Product(parts) => parts.iter_mut().collect(),
            Self::Quotient(both) => both.iter_mut().collect(),
            Self::Power(inner, _) | Self::Call(_, inner) => vec![inner],
        }
    }

    /// How many expressions it contains, itself among them.
    pub fn size(&self) -> usize {
        1 + self.parts().into_iter().map(Self::size).sum::<usize>()
    }

    /// The expression at a place below [`Self::size`], in the order of the text; zero is the whole.
    pub fn node_mut(&mut self, place: usize) -> Option<&mut Self> {
        if place == 0 {
            return Some(self);
        }
        let mut rest = place - 1;
        for part in self.parts_mut() {
            let size = part.size();
            if rest < size {
                return part.node_mut(rest);
            }
            rest -= size;
        }
        None
    }

    pub fn names(&self) -> BTreeSet<Name> {
        match self {
            Self::Name(name) => BTreeSet::from([*name]),
            other => other.parts().into_iter().flat_map(Self::names).collect(),
        }
    }

    pub fn contains(&self, name: Name) -> bool {
        self.names().contains(&name)
    }

    /// The expression with another one in the place of a name.
    pub fn with(&self, name: Name, value: &Self) -> Self {
        let mut found = self.clone();
        found.replace(name, value);
        found
    }

    fn replace(&mut self, name: Name, value: &Self) {
        if *self == Self::Name(name) {
            *self = value.clone();
        } else {
            self.parts_mut().into_iter().for_each(|part| part.replace(name, value));
        }
    }

    /// Whether it is seen to be positive for all values of its variables.
    pub fn is_positive(&self) -> bool {
        match self {
            Self::Number(above, _) => *above > 0,
            Self::Name(name) => matches!(name, Name::Positive(_)),
            Self::Sum(parts) => {
                parts.iter().all(Self::is_not_negative) && parts.iter().any(Self::is_positive)
            }
            Self::Product(parts) => parts.iter().all(Self::is_positive),
            Self::Quotient(both) => both.iter().all(Self::is_positive),
            Self::Power(inner, _) => inner.is_positive(),
            Self::Call("exp", inner) => inner.is_total(),
            Self::Call("sqrt" | "abs", inner) => inner.is_positive(),
            Self::Call(..) => false,
        }
    }

    /// Whether it is seen to have a value that is not negative, for all values of its variables.
    pub fn is_not_negative(&self) -> bool {
        match self {
            Self::Number(above, _) => *above >= 0,
            Self::Sum(parts) | Self::Product(parts) => parts.iter().all(Self::is_not_negative),
            Self::Quotient(both) => both[0].is_not_negative() && both[1].is_positive(),
            Self::Power(inner, exponent) if *exponent > 0 && exponent % 2 == 0 => inner.is_total(),
            Self::Power(inner, exponent) if *exponent > 0 => inner.is_not_negative(),
            Self::Call("sqrt", inner) => inner.is_not_negative(),
            Self::Call("abs", inner) => inner.is_total(),
            _ => self.is_positive(),
        }
    }

    /// Whether it is seen to have a value for all values of its variables.
    pub fn is_total(&self) -> bool {
        self.parts().into_iter().all(Self::is_total)
            && match self {
                Self::Quotient(both) => both[1].is_positive(),
                Self::Power(inner, exponent) => *exponent > 0 || inner.is_positive(),
                Self::Call("ln", inner) => inner.is_positive(),
                Self::Call("sqrt", inner) => inner.is_not_negative(),
                _ => true,
            }
    }

    /// The text, with brackets where the grammar needs them.
    pub fn text(&self, spell: &dyn Fn(Name) -> String) -> String {
        self.bound(spell, Binding::Sum)
    }

    fn bound(&self, spell: &dyn Fn(Name) -> String, outside: Binding) -> String {
        let (text, own) = match self {
            Self::Number(above, 1) if *above >= 0 => (above.to_string(), Binding::Atom),
            Self::Number(above, 1) => (above.to_string(), Binding::Sum),
            Self::Number(above, below) => (format!("{above}/{below}"), Binding::Sum),
            Self::Name(name) => (spell(*name), Binding::Atom),
            Self::Sum(parts) => (sum(parts, spell), Binding::Sum),
            Self::Product(parts) => match &parts[..] {
                [Self::Number(-1, 1), rest @ ..] => (format!("-{}", product(rest, spell)), Binding::Sum),
                _ => (product(parts, spell), Binding::Product),
            },
            Self::Quotient(both) => {
                let [above, below] = &**both;
                let (above, below) =
                    (above.bound(spell, Binding::Product), below.bound(spell, Binding::Power));
                (format!("{above}/{below}"), Binding::Product)
            }
            Self::Power(inner, exponent) => {
                (format!("{}^{exponent}", inner.bound(spell, Binding::Atom)), Binding::Power)
            }
            Self::Call(function, inner) => {
                let function = match function.strip_prefix(UNKNOWN[0]) {
                    Some(primes) => spell(Name::Function) + primes,
                    None => (*function).to_owned(),
                };
                (format!("{function}({})", inner.bound(spell, Binding::Sum)), Binding::Atom)
            }
        };
        if own < outside { format!("({text})") } else { text }
    }
}

/// How tightly the parts of a text are bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Atom,
}

fn sum(parts: &[Term], spell: &dyn Fn(Name) -> String) -> String {
    let mut text = String::new();
    for part in parts {
        let negated = match part {
            Term::Product(factors) => match &factors[..] {
                [Term::Number(-1, 1), rest @ ..] => Some(product(rest, spell)),
                _ => None,
            },
            Term::Number(above, 1) if *above < 0 => Some((-above).to_string()),
            _ => None,
        };
        text += &match (negated, text.is_empty()) {
            (Some(negated), true) => format!("-{negated}"),
            (Some(negated), false) => format!(" - {negated}"),
            (None, true) => part.bound(spell, Binding::Product),
            (None, false) => format!(" + {}", part.bound(spell, Binding::Product)),
        };
    }
    text
}

fn product(parts: &[Term], spell: &dyn Fn(Name) -> String) -> String {
    // A quotient that is not the first factor stands in brackets: a*(b/c).
    let factor = |(place, part): (usize, &Term)| {
        part.bound(spell, if place == 0 { Binding::Product } else { Binding::Power })
    };
    parts.iter().enumerate().map(factor).collect::<Vec<_>>().join("*")
}

impl<T: Borrow<Term>> Add<T> for Term {
    type Output = Term;
    fn add(self, other: T) -> Term {
        self.plus(other.borrow().clone())
    }
}

impl<T: Borrow<Term>> Sub<T> for Term {
    type Output = Term;
    fn sub(self, other: T) -> Term {
        self.plus(minus(other.borrow()))
    }
}

impl<T: Borrow<Term>> Mul<T> for Term {
    type Output = Term;
    fn mul(self, other: T) -> Term {
        match self {
            Term::Product(mut parts) => {
                parts.push(other.borrow().clone());
                Term::Product(parts)
            }
            first => Term::Product(vec![first, other.borrow().clone()]),
        }
    }
}

impl<T: Borrow<Term>> Div<T> for Term {
    type Output = Term;
    fn div(self, other: T) -> Term {
        Term::Quotient(Box::new([self, other.borrow().clone()]))
    }
}

impl<T: Borrow<Term>> Add<T> for &Term {
    type Output = Term;
    fn add(self, other: T) -> Term {
        self.clone() + other
    }
}

impl<T: Borrow<Term>> Sub<T> for &Term {
    type Output = Term;
    fn sub(self, other: T) -> Term {
        self.clone() - other
    }
}

impl<T: Borrow<Term>> Mul<T> for &Term {
    type Output = Term;
    fn mul(self, other: T) -> Term {
        self.clone() * other
    }
}

impl<T: Borrow<Term>> Div<T> for &Term {
    type Output = Term;
    fn div(self, other: T) -> Term {
        self.clone() / other
    }
}
