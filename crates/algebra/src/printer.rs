//! Text of expressions, in the grammar that the parser reads.

use std::fmt;

use super::Expression;

/// How tightly an expression binds: a part that binds less than its place needs is put in parentheses.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const POWER: u8 = 4;
const ATOM: u8 = 5;

fn binding(expression: &Expression) -> u8 {
    match expression {
        Expression::Number(value) if value.is_negative() => SUM,
        Expression::Number(value) if !value.is_integer() => PRODUCT,
        Expression::Number(_) | Expression::Variable(_) | Expression::Call(..) | Expression::Generic(..) => {
            ATOM
        }
        Expression::Sum(_) | Expression::Negation(_) => SUM,
        Expression::Product(_) | Expression::Quotient(..) => PRODUCT,
        Expression::Power(..) => POWER,
    }
}

fn write_at(part: &Expression, place: u8, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
    if binding(part) < place { write!(formatter, "({part})") } else { write!(formatter, "{part}") }
}

fn write_sum(parts: &[Expression], formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (index, part) in parts.iter().enumerate() {
        if index > 0 && part.is_negated() {
            formatter.write_str(" - ")?;
            write_at(&-part.clone(), PRODUCT, formatter)?;
        } else {
            formatter.write_str(if index > 0 { " + " } else { "" })?;
            write_at(part, if index > 0 { PRODUCT } else { SUM }, formatter)?;
        }
    }
    Ok(())
}

impl fmt::Display for Expression {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => write!(formatter, "{value}"),
            Self::Variable(name) => write!(formatter, "{name}"),
            Self::Sum(parts) => write_sum(parts, formatter),
            Self::Product(parts) => {
                for (index, part) in parts.iter().enumerate() {
                    formatter.write_str(if index > 0 { "*" } else { "" })?;
                    // A quotient as a later factor would read as the division of everything before it.
                    write_at(part, if index > 0 { PRODUCT + 1 } else { PRODUCT }, formatter)?;
                }
                Ok(())
            }
            Self::Quotient(left, right) => {
                write_at(left, PRODUCT, formatter)?;
                formatter.write_str("/")?;
                write_at(right, PRODUCT + 1, formatter)
            }
            Self::Negation(inner) => {
                formatter.write_str("-")?;
                write_at(inner, PRODUCT, formatter)
            }
            Self::Power(inner, exponent) => {
                write_at(inner, ATOM, formatter)?;
                write!(formatter, "^{exponent}")
            }
            Self::Call(function, inner) => write!(formatter, "{}({inner})", function.as_str()),
            Self::Generic(function, inner) => write!(formatter, "{function}({inner})"),
        }
    }
}

impl From<Expression> for String {
    fn from(expression: Expression) -> Self {
        expression.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Domain, Relation};

    fn domain() -> Domain {
        let apart = "b - a".parse().expect("in the grammar");
        Domain::positive("V theta D_c a b c K M sigma V_0 x").given(apart, Relation::NonZero)
    }

    #[test]
    fn text_survives_reading_and_printing() {
        for text in [
            "K*D_c/(sqrt(b) - sqrt(a))^2",
            "-V*theta/D_c*ln(V*theta/D_c)",
            "M*delta''/sigma",
            "(b - a)/a*M*V_0^2/D_c^2",
            "a - (b - c)",
            "x^-2",
            "a/(b*c)",
            "a/(b/c)",
            "(1/2)^2",
            "-(a + b)",
        ] {
            let expression: Expression = text.parse().expect("written in the grammar");
            let printed = expression.to_string();
            let again: Expression = printed.parse().expect("printed in the grammar");
            assert_eq!(printed, again.to_string(), "{text}");
            let difference = domain().difference(&expression, &again);
            assert!(difference.is_ok_and(|value| value.is_zero()), "{text} was printed as {printed}");
        }
    }
}
