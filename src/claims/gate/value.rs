//! Values of terms: numbers, and series in quantities that a derivation brings in.
//!
//! A derivative is taken with x + ε in the place of x and ε² = 0. The coefficients of a polynomial are found with a free quantity in
//! the place of its variable. The imaginary unit is a quantity with i² = −1. Each has a mark of its own, so that they can be nested.

use std::cmp::Ordering;

use slipmode_algebra::Function;

use super::number::{Number, Tried, Trouble};

/// How powers of a quantity are reduced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Its square is −1.
    Imaginary,
    /// All powers stay.
    Free,
    /// Its square is zero.
    Small,
}

/// A quantity. One with a later number was brought in later; terms contain earlier ones only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Mark {
    pub number: u32,
    pub kind: Kind,
}

/// The imaginary unit, before all others.
pub(super) const IMAGINARY: Mark = Mark { number: 0, kind: Kind::Imaginary };

/// A number, or Σ terms[k]·quantity^k.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Number(Number),
    Series(Mark, Vec<Value>),
}

impl From<Number> for Value {
    fn from(number: Number) -> Self {
        Self::Number(number)
    }
}

impl Value {
    pub fn whole(value: i32) -> Self {
        Self::Number(Number::whole(value))
    }

    /// A start plus the quantity.
    pub fn with_quantity(start: Self, mark: Mark) -> Self {
        Self::Series(mark, vec![start, Self::whole(1)])
    }

    pub fn number(self) -> Tried<Number> {
        match self {
            Self::Number(number) => Ok(number),
            Self::Series(..) => Err(Trouble::Open),
        }
    }

    /// The factor of a power of a quantity that no later one accompanies.
    pub fn coefficient(&self, mark: Mark, power: usize) -> Self {
        self.coefficients(mark).get(power).cloned().unwrap_or_else(|| Self::whole(0))
    }

    /// The factors of the powers of a quantity that no later one accompanies, those that are exactly zero at the end left out.
    pub fn coefficients(&self, mark: Mark) -> Vec<Self> {
        let mut list = match self {
            Self::Series(own, terms) if *own == mark => terms.clone(),
            other => vec![other.clone()],
        };
        while list.last().is_some_and(Self::is_exactly_zero) {
            list.pop();
        }
        list
    }

    pub fn is_exactly_zero(&self) -> bool {
        match self {
            Self::Number(number) => number.is_exactly_zero(),
            Self::Series(_, terms) => terms.iter().all(Self::is_exactly_zero),
        }
    }

    /// The latest of the two quantities, and the terms of both in it; none for two numbers.
    fn aligned<'v>(&'v self, other: &'v Self) -> Option<(Mark, &'v [Self], &'v [Self])> {
        use std::slice::from_ref as alone;
        match (self, other) {
            (Self::Number(_), Self::Number(_)) => None,
            (Self::Series(mark, terms), Self::Number(_)) => Some((*mark, terms, alone(other))),
            (Self::Number(_), Self::Series(mark, terms)) => Some((*mark, alone(self), terms)),
            (Self::Series(left, terms), Self::Series(right, others)) => {
                Some(match left.number.cmp(&right.number) {
                    Ordering::Equal => (*left, terms, others),
                    Ordering::Greater => (*left, terms, alone(other)),
                    Ordering::Less => (*right, alone(self), others),
                })
            }
        }
    }

    /// The series of these terms with its powers reduced.
    fn reduced(mark: Mark, mut terms: Vec<Self>) -> Tried<Self> {
        match mark.kind {
            Kind::Free => {}
            Kind::Small => terms.truncate(2),
            Kind::Imaginary => {
                while terms.len() > 2 {
                    let place = terms.len() - 3;
                    if let Some(last) = terms.pop() {
                        terms[place] = terms[place].minus(&last)?;
                    }
                }
            }
        }
        Ok(Self::Series(mark, terms))
    }

    fn by_term(
        &self,
        other: &Self,
        numbers: impl Fn(&Number, &Number) -> Tried<Number>,
        values: impl Fn(&Self, &Self) -> Tried<Self>,
    ) -> Tried<Self> {
        if let (Self::Number(left), Self::Number(right)) = (self, other) {
            return numbers(left, right).map(Self::Number);
        }
        let Some((mark, left, right)) = self.aligned(other) else { return Err(Trouble::Open) };
        let zero = Self::whole(0);
        let pair = |at: usize| values(left.get(at).unwrap_or(&zero), right.get(at).unwrap_or(&zero));
        Ok(Self::Series(mark, (0..left.len().max(right.len())).map(pair).collect::<Tried<_>>()?))
    }

    pub fn plus(&self, other: &Self) -> Tried<Self> {
        self.by_term(other, Number::plus, Self::plus)
    }

    pub fn minus(&self, other: &Self) -> Tried<Self> {
        self.by_term(other, Number::minus, Self::minus)
    }

    pub fn negated(&self) -> Self {
        match self {
            Self::Number(number) => Self::Number(number.negated()),
            Self::Series(mark, terms) => Self::Series(*mark, terms.iter().map(Self::negated).collect()),
        }
    }

    pub fn times(&self, other: &Self) -> Tried<Self> {
        if let (Self::Number(left), Self::Number(right)) = (self, other) {
            return left.times(right).map(Self::Number);
        }
        let Some((mark, left, right)) = self.aligned(other) else { return Err(Trouble::Open) };
        let mut terms = vec![Self::whole(0); left.len() + right.len() - 1];
        for (at, one) in left.iter().enumerate() {
            for (by, two) in right.iter().enumerate().filter(|_| !one.is_exactly_zero()) {
                terms[at + by] = terms[at + by].plus(&one.times(two)?)?;
            }
        }
        Self::reduced(mark, terms)
    }

    pub fn over(&self, other: &Self) -> Tried<Self> {
        if let (Self::Number(left), Self::Number(right)) = (self, other) {
            return left.over(right).map(Self::Number);
        }
        let Some((mark, left, _)) = self.aligned(other) else { return Err(Trouble::Open) };
        let below = other.coefficients(mark);
        let by = |divisor: &Self| -> Tried<Self> {
            let terms = left.iter().map(|term| term.over(divisor)).collect::<Tried<_>>()?;
            Ok(Self::Series(mark, terms))
        };
        match (&below[..], mark.kind) {
            ([], _) => Err(Trouble::NoValue),
            ([divisor], _) => by(divisor),
            (_, Kind::Free) => Err(Trouble::Open),
            // (x + yε)/(u + vε) = (x + yε)(u − vε)/u², and with i in the place of ε the divisor is u² + v².
            ([real, other], kind) => {
                let conjugate = Self::Series(mark, vec![real.clone(), other.negated()]);
                let mut square = real.times(real)?;
                if kind == Kind::Imaginary {
                    square = square.plus(&other.times(other)?)?;
                }
                let above = self.times(&conjugate)?;
                above.coefficients(mark).iter().map(|term| term.over(&square)).collect::<Tried<_>>().map(
                    |terms: Vec<_>| if terms.is_empty() { Self::whole(0) } else { Self::Series(mark, terms) },
                )
            }
            _ => Err(Trouble::Open),
        }
    }

    pub fn power(&self, exponent: i32) -> Tried<Self> {
        if exponent <= 0 && self.is_exactly_zero() {
            return Err(Trouble::NoValue);
        }
        let mut product = Self::whole(1);
        let mut square = self.clone();
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest % 2 == 1 {
                product = product.times(&square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = square.times(&square)?;
            }
        }
        if exponent < 0 { Self::whole(1).over(&product) } else { Ok(product) }
    }

    /// A function of it: f(x + yε) = f(x) + f′(x) yε. A function that hides a free quantity is no polynomial in it.
    pub fn call(&self, function: Function, bits: u32) -> Tried<Self> {
        let (mark, terms) = match self {
            Self::Number(number) => return number.call(function, bits).map(Self::Number),
            Self::Series(mark, _) => (*mark, self.coefficients(*mark)),
        };
        match (&terms[..], mark.kind) {
            ([], _) => Self::whole(0).call(function, bits),
            ([alone], _) => alone.call(function, bits),
            ([start, slope], Kind::Small) => {
                let there = start.call(function, bits)?;
                let by = match function {
                    Function::Ln => slope.over(start)?,
                    Function::Exp => slope.times(&there)?,
                    Function::Sqrt => slope.over(&there.plus(&there)?)?,
                    Function::Abs => slope.times(&there.over(start)?)?,
                    Function::Asinh => {
                        let square = start.times(start)?.plus(&Self::whole(1))?;
                        slope.over(&square.call(Function::Sqrt, bits)?)?
                    }
                    Function::Sin => slope.times(&start.call(Function::Cos, bits)?)?,
                    Function::Cos => slope.times(&start.call(Function::Sin, bits)?)?.negated(),
                };
                Ok(Self::Series(mark, vec![there, by]))
            }
            _ => Err(Trouble::Open),
        }
    }
}
