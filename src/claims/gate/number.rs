//! Numbers of the gate: an exact rational as long as every step is rational, a ball with outward rounding after that; or, where it looks
//! first, intervals of 64-bit numbers alone.

use std::cmp::Ordering;

use rug::{Float, float::Round};
use slipmode_algebra::Function;
use slipmode_algebra::number::Interval;
use slipmode_core::number::{Ball, Field, Rational, Real};

/// Why a term has no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Trouble {
    /// It has none at this point, for certain: a division by zero, the logarithm or the root of a negative number.
    NoValue,
    /// The enclosures are too wide to say, or the gate has no way to evaluate it.
    Open,
}

/// A number or why there is none.
pub(super) type Tried<T> = Result<T, Trouble>;

/// Whether all are true: one that is false decides, whatever the others are.
pub(super) fn all(parts: impl Iterator<Item = Tried<bool>>) -> Tried<bool> {
    let mut found = Ok(true);
    for part in parts {
        match (part, found) {
            (Ok(false), _) => return Ok(false),
            (Err(Trouble::NoValue), _) => found = Err(Trouble::NoValue),
            (Err(Trouble::Open), Ok(_)) => found = Err(Trouble::Open),
            _ => {}
        }
    }
    found
}

/// A real number.
#[derive(Debug, Clone)]
pub(super) enum Number {
    Exact(Rational),
    /// The root of a positive rational that is no square, or its negative: a square of it is exact again.
    Root {
        square: Rational,
        negative: bool,
        bits: u32,
    },
    Within(Ball),
    Near(Interval),
}

#[derive(Clone, Copy)]
enum Operation {
    Plus,
    Minus,
    Times,
    Over,
}

impl Operation {
    fn of<N: Field>(self, left: N, right: &N) -> N {
        match self {
            Self::Plus => left + right,
            Self::Minus => left - right,
            Self::Times => left * right,
            Self::Over => left / right,
        }
    }
}

impl Number {
    pub fn whole(value: i32) -> Self {
        Self::Exact(Rational::from(value))
    }

    /// A rational, or the interval that holds it where only intervals are asked for.
    pub fn of_rational(value: &Rational, is_near: bool) -> Self {
        if is_near { Self::Near(Interval::enclosing(value)) } else { Self::Exact(value.clone()) }
    }

    /// An enclosure of this precision.
    pub fn ball(&self, bits: u32) -> Ball {
        match self {
            Self::Exact(value) => Ball::from_rational(value, bits),
            Self::Root { square, negative, .. } => {
                let root = Ball::from_rational(square, bits).sqrt();
                if *negative { -root } else { root }
            }
            Self::Within(ball) => ball.clone(),
            Self::Near(interval) => {
                let middle = interval.middle();
                let radius = (interval.high - middle).max(middle - interval.low).next_up();
                Ball::new(
                    Float::with_val(f64::MANTISSA_DIGITS, middle),
                    Float::with_val(f64::MANTISSA_DIGITS, radius),
                )
            }
        }
    }

    /// An interval that holds it.
    pub fn interval(&self) -> Interval {
        match self {
            Self::Exact(value) => Interval::enclosing(value),
            Self::Near(interval) => *interval,
            Self::Root { .. } | Self::Within(_) => {
                let ball = self.ball(64);
                let (low, high) =
                    (ball.lower().to_f64_round(Round::Down), ball.upper().to_f64_round(Round::Up));
                if low.is_nan() || high.is_nan() { Interval::LINE } else { Interval { low, high } }
            }
        }
    }

    /// ±√square, exact where the square is one of a rational.
    fn root(square: Rational, negative: bool, bits: u32) -> Self {
        if square.numer().is_perfect_square() && square.denom().is_perfect_square() {
            let (above, below) = square.into_numer_denom();
            let root = Rational::from((above.sqrt(), below.sqrt()));
            return Self::Exact(if negative { -root } else { root });
        }
        Self::Root { square, negative, bits }
    }

    /// Its square and whether it is negative, where it is a rational or the root of one; and the precision of the root.
    fn square(&self) -> Option<(Rational, bool, u32)> {
        match self {
            Self::Exact(value) => Some((Rational::from(value.square_ref()), value.is_negative(), 0)),
            Self::Root { square, negative, bits } => Some((square.clone(), *negative, *bits)),
            Self::Within(_) | Self::Near(_) => None,
        }
    }

    /// The precision of an enclosure of it.
    fn bits(&self) -> u32 {
        match self {
            Self::Exact(_) | Self::Near(_) => 0,
            Self::Root { bits, .. } => *bits,
            Self::Within(ball) => ball.precision_bits(),
        }
    }

    pub fn is_exactly_zero(&self) -> bool {
        match self {
            Self::Exact(value) => value.is_zero(),
            Self::Near(interval) => interval.sign() == Some(Ordering::Equal),
            Self::Root { .. } | Self::Within(_) => false,
        }
    }

    /// How it compares with zero; none where the ball leaves it open.
    pub fn sign(&self) -> Option<Ordering> {
        match self {
            Self::Exact(value) => Some(value.cmp0()),
            Self::Root { negative, .. } => Some(if *negative { Ordering::Less } else { Ordering::Greater }),
            Self::Within(ball) => ball.sign(),
            Self::Near(interval) => interval.sign(),
        }
    }

    fn of(ball: Ball) -> Tried<Self> {
        if ball.is_bounded() { Ok(Self::Within(ball)) } else { Err(Trouble::Open) }
    }

    fn near(interval: Interval) -> Tried<Self> {
        if interval.is_finite() { Ok(Self::Near(interval)) } else { Err(Trouble::Open) }
    }

    /// An operation on two exact numbers, on two intervals if one is one, or else on two balls of the precision that one of them has.
    fn joined(&self, other: &Self, operation: Operation) -> Tried<Self> {
        if let (Self::Exact(left), Self::Exact(right)) = (self, other) {
            return Ok(Self::Exact(operation.of(left.clone(), right)));
        }
        if matches!((self, other), (Self::Near(_), _) | (_, Self::Near(_))) {
            return Self::near(operation.of(self.interval(), &other.interval()));
        }
        let bits = self.bits().max(other.bits());
        Self::of(operation.of(self.ball(bits), &other.ball(bits)))
    }

    /// A product or quotient of a root with a root or a rational, from the one of the squares.
    fn of_squares(&self, other: &Self, join: impl Fn(Rational, Rational) -> Rational) -> Option<Self> {
        if !matches!(self, Self::Root { .. }) && !matches!(other, Self::Root { .. }) {
            return None;
        }
        let ((left, one, bits), (right, two, other_bits)) = (self.square()?, other.square()?);
        Some(Self::root(join(left, right), one != two, bits.max(other_bits)))
    }

    pub fn plus(&self, other: &Self) -> Tried<Self> {
        if self.is_exactly_zero() {
            return Ok(other.clone());
        }
        self.joined(other, Operation::Plus)
    }

    pub fn minus(&self, other: &Self) -> Tried<Self> {
        if let (Self::Root { square, negative, .. }, Self::Root { square: right, negative: sign, .. }) =
            (self, other)
            && (square, negative) == (right, sign)
        {
            return Ok(Self::whole(0));
        }
        self.joined(other, Operation::Minus)
    }

    pub fn times(&self, other: &Self) -> Tried<Self> {
        if self.is_exactly_zero() || other.is_exactly_zero() {
            return Ok(Self::whole(0));
        }
        if let Some(product) = self.of_squares(other, |left, right| left * right) {
            return Ok(product);
        }
        self.joined(other, Operation::Times)
    }

    pub fn over(&self, other: &Self) -> Tried<Self> {
        match other.sign() {
            None => Err(Trouble::Open),
            Some(Ordering::Equal) => Err(Trouble::NoValue),
            Some(_) if self.is_exactly_zero() => Ok(Self::whole(0)),
            Some(_) => match self.of_squares(other, |left, right| left / right) {
                Some(quotient) => Ok(quotient),
                None => self.joined(other, Operation::Over),
            },
        }
    }

    pub fn negated(&self) -> Self {
        match self {
            Self::Exact(value) => Self::Exact(Rational::from(-value)),
            Self::Root { square, negative, bits } => {
                Self::Root { square: square.clone(), negative: !negative, bits: *bits }
            }
            Self::Within(ball) => Self::Within(-ball.clone()),
            Self::Near(interval) => Self::Near(-*interval),
        }
    }

    /// A function of it: exact where the value is seen to be rational.
    pub fn call(&self, function: Function, bits: u32) -> Tried<Self> {
        let sign = self.sign();
        let is_algebraic = matches!(function, Function::Abs | Function::Sqrt);
        match function {
            _ if matches!(self, Self::Near(_)) && (sign.is_none() || !is_algebraic) => Err(Trouble::Open),
            Function::Abs => match sign {
                Some(Ordering::Less) => Ok(self.negated()),
                Some(_) => Ok(self.clone()),
                None => Self::of(self.ball(bits).square().sqrt()),
            },
            Function::Sqrt => match (self, sign) {
                (_, Some(Ordering::Less)) => Err(Trouble::NoValue),
                (_, None) => Err(Trouble::Open),
                (_, Some(Ordering::Equal)) => Ok(Self::whole(0)),
                (Self::Near(interval), _) => Self::near(interval.square_root()),
                (Self::Exact(value), _) => Ok(Self::root(value.clone(), false, bits)),
                _ => Self::of(self.ball(bits).sqrt()),
            },
            Function::Ln => match (self, sign) {
                (_, Some(Ordering::Less | Ordering::Equal)) => Err(Trouble::NoValue),
                (_, None) => Err(Trouble::Open),
                (Self::Exact(value), _) if *value == 1 => Ok(Self::whole(0)),
                _ => Self::of(self.ball(bits).ln()),
            },
            Function::Exp | Function::Cos if self.is_exactly_zero() => Ok(Self::whole(1)),
            Function::Asinh | Function::Sin if self.is_exactly_zero() => Ok(Self::whole(0)),
            Function::Exp => Self::of(self.ball(bits).exp()),
            Function::Asinh => Self::of(self.ball(bits).asinh()),
            Function::Sin => Self::of(self.ball(bits).sin()),
            Function::Cos => Self::of(self.ball(bits).cos()),
        }
    }

    /// In words: the rational, or the digits of the middle of the ball.
    pub fn text(&self) -> String {
        match self {
            Self::Exact(value) => value.to_string(),
            _ => self.ball(64).centre().to_string_radix(10, Some(12)),
        }
    }
}
