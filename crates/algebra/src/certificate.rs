//! What a proof's step rests on, in a form that can be printed and checked again.

use std::fmt;

use super::{Domain, Expression, Linearisation, Symbol};

/// Which way a variable goes in a limit; the others are held fixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Toward {
    /// Down to zero.
    Zero,
    /// Up to infinity.
    Infinity,
}

impl fmt::Display for Toward {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(if *self == Self::Zero { "0" } else { "infinity" })
    }
}

/// A checkable fact over ℚ. Expressions are kept as written, so that the check repeats the whole computation.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "kebab-case"))]
pub enum Certificate {
    /// Both sides are the same rational function.
    Identity {
        /// What was derived.
        left: Expression,
        /// What is claimed.
        right: Expression,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// After the substitutions all coefficients of the expression have this sign, and all variables are positive.
    Sign {
        /// What has the sign.
        expression: Expression,
        /// +1 or −1.
        sign: i8,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// The limit of an expression as one variable goes to zero or infinity.
    Limit {
        /// What has the limit.
        expression: Expression,
        /// The variable that moves; the others are fixed.
        variable: Symbol,
        /// Where it goes.
        toward: Toward,
        /// The limit.
        value: Expression,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// An expression goes beyond all bounds as one variable goes to zero or infinity.
    Divergence {
        /// What grows.
        expression: Expression,
        /// The variable that moves; the others are fixed.
        variable: Symbol,
        /// Where it goes.
        toward: Toward,
        /// +1 up, −1 down.
        sign: i8,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// The derivative of an expression in one variable, at every point and with the others fixed.
    Derivative {
        /// What is differentiated.
        expression: Expression,
        /// The variable.
        variable: Symbol,
        /// The derivative.
        value: Expression,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// The rates of a system vanish at its steady state, its slopes are their derivatives there, and det(variable − J) with the
    /// matrix J of the slopes is the polynomial.
    Characteristic {
        /// The system with its slopes.
        system: Linearisation,
        /// The variable of the polynomial.
        variable: Symbol,
        /// The polynomial.
        polynomial: Expression,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// Both sides have these different values at a rational point.
    Difference {
        /// One side.
        left: Expression,
        /// The other side.
        right: Expression,
        /// Names and values.
        point: Vec<(Symbol, Expression)>,
        /// The value of either side.
        values: [Expression; 2],
    },
    /// The expression has this value at a rational point.
    Value {
        /// What is evaluated.
        expression: Expression,
        /// Names and values.
        point: Vec<(Symbol, Expression)>,
        /// The exact value.
        value: Expression,
    },
    /// unknown = Σ `coefficients[k]`·variable^k solves relation = 0 up to the next order, and is the only such series.
    Series {
        /// What vanishes, in the variable and the unknown.
        relation: Expression,
        /// The small variable.
        variable: Symbol,
        /// The unknown.
        unknown: Symbol,
        /// The coefficients by ascending power.
        coefficients: Vec<Expression>,
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// A polynomial in one variable has opposite signs at two ends, so that it has a root between them.
    Root {
        /// The polynomial.
        polynomial: Expression,
        /// Its variable.
        variable: Symbol,
        /// The lower and the upper end; none for minus and plus infinity.
        between: [Option<Expression>; 2],
        /// Assumptions and substitutions.
        domain: Domain,
    },
    /// All points with these coordinates, for positive values of the variables, are one connected set: the continuous
    /// image of an orthant.
    Connected {
        /// Names and coordinates.
        image: Vec<(Symbol, Expression)>,
        /// The positive variables, without further assumptions.
        domain: Domain,
    },
    /// The expression and its first `order` − 1 derivatives vanish at 0 and the next one is positive, so that the
    /// expression is positive for every positive value of the variable.
    Growth {
        /// What is positive.
        expression: Expression,
        /// The variable.
        variable: Symbol,
        /// The order of the positive derivative.
        order: u32,
        /// Assumptions and substitutions.
        domain: Domain,
    },
}

impl Certificate {
    /// The word for its kind, as a file states it.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Identity { .. } => "identity",
            Self::Sign { .. } => "sign",
            Self::Limit { .. } => "limit",
            Self::Divergence { .. } => "divergence",
            Self::Derivative { .. } => "derivative",
            Self::Characteristic { .. } => "characteristic",
            Self::Difference { .. } => "difference",
            Self::Value { .. } => "value",
            Self::Series { .. } => "series",
            Self::Root { .. } => "root",
            Self::Connected { .. } => "connected",
            Self::Growth { .. } => "growth",
        }
    }

    /// The assumptions, unless the fact is one about numbers.
    #[must_use]
    pub fn domain(&self) -> Option<&Domain> {
        match self {
            Self::Identity { domain, .. }
            | Self::Sign { domain, .. }
            | Self::Limit { domain, .. }
            | Self::Divergence { domain, .. }
            | Self::Derivative { domain, .. }
            | Self::Characteristic { domain, .. }
            | Self::Series { domain, .. }
            | Self::Root { domain, .. }
            | Self::Connected { domain, .. }
            | Self::Growth { domain, .. } => Some(domain),
            Self::Difference { .. } | Self::Value { .. } => None,
        }
    }
}
