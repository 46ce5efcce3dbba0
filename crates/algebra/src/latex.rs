//! LaTeX of expressions, for display as MathML.

use super::{Expression, Function, Symbol};

const GREEK: [&str; 20] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu",
    "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "omega",
];

impl Expression {
    /// LaTeX in mathematics mode.
    #[must_use]
    pub fn latex(&self) -> String {
        match self {
            Self::Number(value) if value.is_integer() => value.to_string(),
            Self::Number(value) if value.is_negative() => {
                format!("-{}", Self::Number(value.clone().abs()).latex())
            }
            Self::Number(value) => format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom()),
            Self::Variable(name) => symbol(name),
            Self::Sum(parts) => sum(parts),
            Self::Product(parts) => product(parts),
            Self::Quotient(left, right) => format!("\\frac{{{}}}{{{}}}", left.latex(), right.latex()),
            Self::Negation(inner) => format!("-{}", factor(inner)),
            Self::Power(inner, exponent) => format!("{}^{{{exponent}}}", base(inner)),
            Self::Call(function, inner) => call(*function, &inner.latex()),
            Self::Generic(function, inner) => generic(function, &inner.latex()),
        }
    }
}

fn sum(parts: &[Expression]) -> String {
    parts.iter().enumerate().fold(String::new(), |text, (index, part)| match index {
        0 => part.latex(),
        _ if part.is_negated() => text + " - " + &factor(&-part.clone()),
        _ => text + " + " + &part.latex(),
    })
}

fn product(parts: &[Expression]) -> String {
    let mut text = String::new();
    for (index, part) in parts.iter().enumerate() {
        let number = matches!(part, Expression::Number(_));
        text += match (index, number) {
            (0, _) => "",
            (_, true) => " \\cdot ",
            _ if text.ends_with("\\pm ") => "",
            _ => "\\,",
        };
        text += &factor(part);
    }
    text
}

/// A part of a product: sums in parentheses.
fn factor(part: &Expression) -> String {
    match part {
        Expression::Sum(_) | Expression::Negation(_) => parenthesised(part),
        Expression::Number(value) if value.is_negative() => parenthesised(part),
        _ => part.latex(),
    }
}

/// What is raised to a power: anything but a name or a natural number in parentheses.
fn base(part: &Expression) -> String {
    match part {
        Expression::Variable(name)
            if name.derivative_order() == 0 && !name.as_str().starts_with("Delta_") =>
        {
            symbol(name)
        }
        Expression::Number(value) if value.is_integer() && !value.is_negative() => value.to_string(),
        _ => parenthesised(part),
    }
}

fn parenthesised(part: &Expression) -> String {
    format!("\\left({}\\right)", part.latex())
}

fn call(function: Function, argument: &str) -> String {
    match function {
        Function::Sqrt => format!("\\sqrt{{{argument}}}"),
        Function::Abs => format!("\\left|{argument}\\right|"),
        Function::Asinh => format!("\\operatorname{{asinh}}\\left({argument}\\right)"),
        Function::Ln | Function::Exp | Function::Sin | Function::Cos => {
            format!("\\{function}\\left({argument}\\right)")
        }
    }
}

/// Primes at a function are derivatives in its argument, and no time derivatives: they are no dots.
fn generic(function: &Symbol, argument: &str) -> String {
    let primes = "'".repeat(function.derivative_order());
    format!("{}{primes}\\left({argument}\\right)", symbol(&function.undifferentiated()))
}

fn symbol(name: &Symbol) -> String {
    if let Some(number) = name.number() {
        return format!("\\#_{{{number}}}");
    }
    let base = name.base();
    if base == "pm" {
        return "\\pm ".to_owned();
    }
    let (difference, plain) = match base.strip_prefix("Delta_") {
        Some(rest) => ("\\Delta ", rest),
        None => ("", base),
    };
    let (letter, index) = plain.split_once('_').unwrap_or((plain, ""));
    let letter = if GREEK.contains(&letter) { format!("\\{letter}") } else { letter.to_owned() };
    let dotted = match name.derivative_order() {
        0 => letter,
        1 => format!("\\dot{{{letter}}}"),
        2 => format!("\\ddot{{{letter}}}"),
        3 => format!("\\dddot{{{letter}}}"),
        order => format!("{letter}^{{({order})}}"),
    };
    let index = if index.is_empty() { String::new() } else { format!("_{{{}}}", index.replace('_', ",")) };
    format!("{difference}{dotted}{index}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn latex(text: &str) -> String {
        text.parse::<Expression>().expect("in the grammar").latex()
    }

    #[test]
    fn the_papers_notation_comes_out() {
        assert_eq!(
            latex("K*D_c/(sqrt(b) - sqrt(a))^2"),
            r"\frac{K\,D_{c}}{\left(\sqrt{b} - \sqrt{a}\right)^{2}}"
        );
        assert_eq!(latex("M*Delta_delta''/sigma"), r"\frac{M\,\Delta \ddot{\delta}}{\sigma}");
        assert_eq!(latex("K_c_qs"), "K_{c,qs}");
        assert_eq!(latex("± i*abs(x - 1)"), r"\pm i\,\left|x - 1\right|");
    }

    #[test]
    fn every_construct_of_the_grammar_becomes_mathml() {
        let converter = math_core::LatexToMathML::default();
        for text in [
            "-3/4*x^2 + 1/2",
            "sqrt(abs(a - b))*ln(x)/exp(-x)",
            "a*asinh(V/(2*V_0))",
            "Delta_theta''' + Delta_theta'' + Delta_theta' + K_c_qs",
            "±i*sqrt((b - a)/a)*V_0/D_c",
            "(x + 1)*(2*x - 3)^-2",
        ] {
            let converted = converter.convert_with_local_state(&latex(text), math_core::MathDisplay::Inline);
            assert!(converted.is_ok(), "{text}: {}", latex(text));
        }
    }

    #[test]
    fn functions_of_a_file_carry_primes() {
        let latex = |text: &str| Expression::try_from(text.to_owned()).expect("of a certificate").latex();
        assert_eq!(latex("f''(V)^2/M"), r"\frac{\left(f''\left(V\right)\right)^{2}}{M}");
        assert_eq!(latex("tau_s'(v/2)"), r"\tau_{s}'\left(\frac{v}{2}\right)");
        for text in ["f(x)*tau_s''''''(f'(0))", "-f'(x)^-2"] {
            let latex = latex(text);
            let converted = math_core::LatexToMathML::default()
                .convert_with_local_state(&latex, math_core::MathDisplay::Inline);
            assert!(converted.is_ok(), "{text}: {latex}");
        }
    }

    #[test]
    fn derivatives_carry_dots() {
        assert_eq!(latex("Delta_theta'''"), r"\Delta \dddot{\theta}");
    }
}
