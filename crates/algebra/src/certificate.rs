//! What a proof's step rests on, in a form that can be printed and checked again.

use std::fmt;

use super::{Domain, End, Expression, Linearisation, Notation, Series, Symbol, Toward};

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

    /// The fact, without the conditions under which it is stated.
    #[must_use]
    pub fn fact(&self, notation: Notation) -> String {
        let (set, name) =
            (|expression: &Expression| notation.set(expression), |symbol: &Symbol| notation.name(symbol));
        let formula = |text: fmt::Arguments<'_>| notation.formula(text);
        let alone = |side: &Expression| formula(format_args!("{}", set(side)));
        let named = |symbol: &Symbol| formula(format_args!("{}", name(symbol)));
        match self {
            Self::Identity { left, right, .. } => formula(format_args!("{} = {}", set(left), set(right))),
            Self::Sign { expression, sign, .. } => {
                formula(format_args!("{} {} 0", set(expression), if *sign > 0 { '>' } else { '<' }))
            }
            Self::Limit { expression, variable, toward, value, .. } => {
                notation.limit(expression, &End::Finite(value.clone()), (variable, *toward))
            }
            Self::Divergence { expression, variable, toward, sign, .. } => {
                notation.limit(expression, &End::Infinite(*sign), (variable, *toward))
            }
            Self::Derivative { expression, variable, value, .. } => {
                let [expression, value, variable] = [alone(expression), alone(value), named(variable)];
                format!("{expression} has the derivative {value} in {variable}")
            }
            Self::Characteristic { .. } => self.characteristic(notation),
            Self::Difference { left, right, point, values: [a, b] } => {
                let [left, right, a, b] = [left, right, a, b].map(alone);
                format!("{left} differs from {right} at {}: {a} against {b}", notation.equal(point))
            }
            Self::Value { expression, point, value } => {
                let fact = formula(format_args!("{} = {}", set(expression), set(value)));
                format!("{fact} at {}", notation.equal(point))
            }
            Self::Series { relation, variable, unknown, coefficients, .. } => {
                let series = Series::expression(coefficients, &Expression::Variable(variable.clone()));
                let exponent = match notation {
                    Notation::Plain => coefficients.len().to_string(),
                    Notation::Latex => format!("{{{}}}", coefficients.len()),
                };
                let (sum, [unknown, small]) = (set(&series), [unknown, variable].map(name));
                let found = formula(format_args!("{unknown} = {sum} + O({small}^{exponent})"));
                format!("{found} solves {}", formula(format_args!("{} = 0", set(relation))))
            }
            Self::Root { polynomial, variable, between, .. } => {
                let ends = [-1, 1].map(End::Infinite);
                let end = |(given, open): (&Option<Expression>, &End)| {
                    formula(format_args!("{}", given.as_ref().map_or_else(|| notation.end(open), set)))
                };
                let ends: Vec<String> = between.iter().zip(&ends).map(end).collect();
                let zero = formula(format_args!("{} = 0", set(polynomial)));
                format!("{zero} for a {} between {}", named(variable), ends.join(" and "))
            }
            Self::Connected { image, .. } => format!("connected: all {}", notation.equal(image)),
            Self::Growth { expression, variable, order, .. } => {
                let positive = formula(format_args!("{} > 0", set(expression)));
                let at = formula(format_args!("{} = 0", name(variable)));
                format!("{positive}, zero of order {order} at {at}")
            }
        }
    }

    /// A characteristic polynomial with its matrix and its system.
    fn characteristic(&self, notation: Notation) -> String {
        let Self::Characteristic { system, variable, polynomial, .. } = self else { return String::new() };
        let set = |value: &Expression| notation.set(value);
        let listed = |values: &[Expression], join: &str| {
            let values = system.state.iter().zip(values);
            let one = |(name, value): (&Symbol, &Expression)| {
                notation.formula(format_args!("{}{join}{}", notation.name(name), set(value)))
            };
            values.map(one).collect::<Vec<_>>().join(", ")
        };
        let rows = system
            .slopes
            .iter()
            .map(|row| format!("[{}]", row.iter().map(set).collect::<Vec<_>>().join(", ")));
        let [det, rates] = [notation.either("det", "\\det"), notation.either("' = ", "' = ")];
        format!(
            "{}, {}, of {} at {}",
            notation.formula(format_args!("{} = {det}({} - J)", set(polynomial), notation.name(variable))),
            notation.formula(format_args!("J = [{}]", rows.collect::<Vec<_>>().join(", "))),
            listed(&system.rates, rates),
            listed(&system.steady, " = "),
        )
    }
}

impl Linearisation {
    /// The certificate that this is the linearisation of the system, and that det(s − J) is this polynomial.
    #[must_use]
    pub fn certificate(self, variable: &Symbol, polynomial: Expression, domain: Domain) -> Certificate {
        Certificate::Characteristic { system: self, variable: variable.clone(), polynomial, domain }
    }
}

impl Notation {
    pub(super) fn end(self, end: &End) -> String {
        match end {
            End::Finite(value) => self.set(value),
            End::Infinite(sign) => {
                format!("{}{}", if *sign > 0 { "" } else { "-" }, self.either("infinity", "\\infty"))
            }
        }
    }

    fn limit(self, expression: &Expression, end: &End, (variable, toward): (&Symbol, Toward)) -> String {
        let arrow = self.either("->", "\\to");
        let toward = match toward {
            Toward::Zero => "0",
            Toward::Infinity => self.either("infinity", "\\infty"),
        };
        let fact = self.formula(format_args!("{} {arrow} {}", self.set(expression), self.end(end)));
        format!("{fact} as {}", self.formula(format_args!("{} {arrow} {toward}", self.name(variable))))
    }
}

impl fmt::Display for Certificate {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.fact(Notation::Plain))?;
        let given = self.domain().map(Domain::to_string).unwrap_or_default();
        if given.is_empty() { Ok(()) } else { write!(formatter, " [{given}]") }
    }
}
