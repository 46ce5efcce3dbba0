//! Certificates in writing: as the parser reads them, or as LaTeX between `$` for a page.

use std::fmt;

use super::{Certificate, Condition, Domain, End, Expression, Relation, Series, Symbol, Toward};

/// How formulas are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// As the parser reads them.
    Plain,
    /// LaTeX between `$`.
    Latex,
}

impl Notation {
    pub(crate) fn set(self, expression: &Expression) -> String {
        match self {
            Self::Plain => expression.to_string(),
            Self::Latex => expression.latex(),
        }
    }

    pub(crate) fn name(self, name: &Symbol) -> String {
        match self {
            Self::Plain => name.to_string(),
            Self::Latex => Expression::variable(name).latex(),
        }
    }

    /// One of two spellings.
    fn either(self, plain: &'static str, latex: &'static str) -> &'static str {
        match self {
            Self::Plain => plain,
            Self::Latex => latex,
        }
    }

    /// A whole formula.
    pub(crate) fn formula(self, text: impl fmt::Display) -> String {
        let mark = self.either("", "$");
        format!("{mark}{text}{mark}")
    }

    fn toward(self, variable: &Symbol, toward: Toward) -> String {
        let end = match toward {
            Toward::Zero => "0",
            Toward::Infinity => self.either("infinity", "\\infty"),
        };
        self.formula(format_args!("{} {} {end}", self.name(variable), self.either("->", "\\to")))
    }

    fn end(self, end: &End) -> String {
        match end {
            End::Finite(value) => self.set(value),
            End::Infinite(sign) => {
                format!("{}{}", if *sign > 0 { "" } else { "-" }, self.either("infinity", "\\infty"))
            }
        }
    }

    pub(crate) fn equal<'p>(self, pairs: impl IntoIterator<Item = &'p (Symbol, Expression)>) -> String {
        let equal = |(name, value): &(Symbol, Expression)| {
            self.formula(format_args!("{} = {}", self.name(name), self.set(value)))
        };
        pairs.into_iter().map(equal).collect::<Vec<_>>().join(", ")
    }

    pub(crate) fn condition(self, condition: &Condition) -> String {
        let relation = match condition.relation {
            Relation::Positive => ">",
            Relation::NonNegative => self.either(">=", "\\ge"),
            Relation::NonZero => self.either("!=", "\\ne"),
        };
        self.formula(format_args!("{} {relation} 0", self.set(&condition.expression)))
    }
}

impl Certificate {
    /// The fact, without the conditions under which it is stated.
    #[must_use]
    pub fn fact(&self, notation: Notation) -> String {
        let (set, name) =
            (|expression: &Expression| notation.set(expression), |symbol: &Symbol| notation.name(symbol));
        let formula = |text: fmt::Arguments<'_>| notation.formula(text);
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
                let [expression, value] =
                    [expression, value].map(|side| formula(format_args!("{}", set(side))));
                format!(
                    "{expression} has the derivative {value} in {}",
                    formula(format_args!("{}", name(variable)))
                )
            }
            Self::Characteristic { .. } => self.characteristic(notation),
            Self::Difference { left, right, point, values: [a, b] } => {
                let [left, right, a, b] =
                    [left, right, a, b].map(|side| formula(format_args!("{}", set(side))));
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
                let found = formula(format_args!(
                    "{} = {} + O({}^{exponent})",
                    name(unknown),
                    set(&series),
                    name(variable)
                ));
                format!("{found} solves {}", formula(format_args!("{} = 0", set(relation))))
            }
            Self::Root { polynomial, variable, between, .. } => {
                let ends = [-1, 1].map(End::Infinite);
                let end = |(given, open): (&Option<Expression>, &End)| {
                    formula(format_args!("{}", given.as_ref().map_or_else(|| notation.end(open), set)))
                };
                let ends: Vec<String> = between.iter().zip(&ends).map(end).collect();
                let zero = formula(format_args!("{} = 0", set(polynomial)));
                format!(
                    "{zero} for a {} between {}",
                    formula(format_args!("{}", name(variable))),
                    ends.join(" and ")
                )
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

impl Notation {
    fn limit(self, expression: &Expression, end: &End, (variable, toward): (&Symbol, Toward)) -> String {
        let arrow = self.either("->", "\\to");
        let fact = self.formula(format_args!("{} {arrow} {}", self.set(expression), self.end(end)));
        format!("{fact} as {}", self.toward(variable, toward))
    }
}

impl fmt::Display for Certificate {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.fact(Notation::Plain))?;
        let given = self.domain().map(Domain::to_string).unwrap_or_default();
        if given.is_empty() { Ok(()) } else { write!(formatter, " [{given}]") }
    }
}
