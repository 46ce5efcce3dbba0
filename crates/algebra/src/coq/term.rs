//! Expressions in Coq's language.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Condition, Expression, Function, Relation, Symbol};

/// Names of Coq's language and libraries that generated text uses, and that no variable may hide.
const TAKEN: &str = "C Ci IZR R Rabs RtoC all_left all_real arcsinh as at at_right cos else end exists exp filterlim forall fun horner if in let ln locally one_right sqrt with";

/// The name of a variable; no variable of a certificate has a prime inside its name.
pub(super) fn name(variable: &Symbol) -> String {
    match variable.number() {
        Some(number) => format!("p'{number}"),
        None if TAKEN.split(' ').any(|taken| taken == variable.as_str()) => format!("{variable}'v"),
        None => variable.to_string(),
    }
}

/// The text of a real expression, which binds as tightly as an atom.
pub(super) fn real(expression: &Expression) -> String {
    match expression {
        Expression::Number(value) if value.is_integer() && !value.is_negative() => value.to_string(),
        Expression::Number(value) if value.is_integer() => format!("({value})"),
        Expression::Number(value) => format!("({} / {})", value.numer(), value.denom()),
        Expression::Variable(symbol) => name(symbol),
        Expression::Sum(parts) => sum(parts),
        Expression::Product(parts) => joined(parts, " * ", real),
        Expression::Quotient(above, below) => format!("({} / {})", real(above), real(below)),
        Expression::Negation(inner) => format!("(- {})", real(inner)),
        Expression::Power(inner, exponent) if *exponent < 0 => {
            format!("(/ {} ^ {})", real(inner), exponent.unsigned_abs())
        }
        Expression::Power(inner, exponent) => format!("({} ^ {exponent})", real(inner)),
        Expression::Call(function, inner) => format!("({} {})", function_name(*function), real(inner)),
        Expression::Generic(function, inner) => format!("({function} {})", real(inner)),
    }
}

fn function_name(function: Function) -> &'static str {
    match function {
        Function::Abs => "Rabs",
        Function::Asinh => "arcsinh",
        other => other.as_str(),
    }
}

fn joined(parts: &[Expression], operator: &str, text: impl Fn(&Expression) -> String) -> String {
    let parts: Vec<String> = parts.iter().map(text).collect();
    format!("({})", parts.join(operator))
}

fn sum(parts: &[Expression]) -> String {
    let term = |(index, part): (usize, &Expression)| match part {
        _ if index == 0 => real(part),
        Expression::Negation(inner) => format!(" - {}", real(inner)),
        _ => format!(" + {}", real(part)),
    };
    format!("({})", parts.iter().enumerate().map(term).collect::<String>())
}

/// The text of an expression over the complex numbers. Variables in `complex` are complex, all others real.
pub(super) fn complex(expression: &Expression, free: &BTreeSet<Symbol>) -> String {
    let imaginary = Symbol::from("i");
    let text = |part: &Expression| complex(part, free);
    let variables = expression.variables();
    if !variables.contains(&imaginary) && variables.is_disjoint(free) {
        return format!("(RtoC {})", real(expression));
    }
    match expression {
        Expression::Variable(symbol) if *symbol == imaginary => "Ci".to_owned(),
        // A real term stays whole: its text does not depend on whether a name or its value stands there.
        Expression::Sum(parts) => joined(parts, " + ", text),
        Expression::Product(parts) => joined(parts, " * ", text),
        Expression::Quotient(above, below) => format!("({} / {})", text(above), text(below)),
        Expression::Negation(inner) => format!("(- {})", text(inner)),
        Expression::Power(inner, exponent) => {
            let factors = vec![text(inner); exponent.unsigned_abs() as usize];
            let product =
                if factors.is_empty() { "(RtoC 1)".to_owned() } else { format!("({})", factors.join(" * ")) };
            if *exponent < 0 { format!("(/ {product})") } else { product }
        }
        other => real(other),
    }
}

/// The text of a condition.
pub(super) fn condition(condition: &Condition) -> String {
    let text = real(&condition.expression);
    match condition.relation {
        Relation::Positive => format!("0 < {text}"),
        Relation::NonNegative => format!("0 <= {text}"),
        Relation::NonZero => format!("{text} <> 0"),
    }
}

/// The calls in an expression that lie in no other call.
pub(super) fn outer_calls(expression: &Expression, found: &mut BTreeMap<String, Expression>) {
    if let Expression::Call(..) | Expression::Generic(..) = expression {
        found.insert(real(expression), expression.clone());
    } else {
        expression.parts().for_each(|part| outer_calls(part, found));
    }
}

/// Does it divide, or have a number that is not whole?
pub(super) fn divides(expression: &Expression) -> bool {
    match expression {
        Expression::Number(value) => !value.is_integer(),
        Expression::Call(..) | Expression::Generic(..) => false,
        Expression::Quotient(..) | Expression::Power(_, ..0) => true,
        _ => expression.parts().any(divides),
    }
}
