//! Formulas as readers see them: words, and LaTeX between `$`.

use slipmode_algebra::{Comparison, End, Expression, Symbol, Toward};

use super::{ClaimFormula, Formula, FormulaCondition, OverRows, Statement};

impl ClaimFormula {
    /// The formula and over what it is said, in words and LaTeX between `$`.
    #[must_use]
    pub fn markdown(&self) -> String {
        if let Some(OverRows { table, at_least, .. }) = &self.rows {
            let least = if *at_least > 0 { format!(" for at least {at_least}") } else { String::new() };
            return format!("over the rows of the table `{table}`{least}, `{}`", self.text);
        }
        let scope = &self.scope;
        let mut given: Vec<String> = scope.given.iter().map(FormulaCondition::markdown).collect();
        let ends = |(name, [low, high]): &(Symbol, [_; 2])| {
            let [low, high] = [low, high].map(|end: &slipmode_core::number::Rational| number(end));
            format!("${low} \\le {} \\le {high}$", variable(name))
        };
        given.extend(scope.within.iter().map(ends));
        given
            .extend(scope.at.iter().map(|(name, value)| format!("${} = {}$", variable(name), number(value))));
        let given = if given.is_empty() { given.concat() } else { format!(" for all {}", given.join(", ")) };
        let some: Vec<String> = scope.there_is.iter().map(|name| format!("${}$", variable(name))).collect();
        let some =
            if some.is_empty() { some.concat() } else { format!("there is {} with ", some.join(", ")) };
        some + &self.statement.markdown() + &given
    }
}

fn variable(name: &Symbol) -> String {
    Expression::variable(name).latex()
}

fn number(value: &slipmode_core::number::Rational) -> String {
    Expression::Number(value.clone()).latex()
}

impl FormulaCondition {
    fn markdown(&self) -> String {
        let [left, right] = &self.sides;
        compared(left, self.comparison, right)
    }
}

fn compared(left: &Expression, comparison: Comparison, right: &Expression) -> String {
    let sign = match comparison {
        Comparison::Unequal => "\\ne",
        Comparison::AtMost => "\\le",
        Comparison::AtLeast => "\\ge",
        Comparison::Equal | Comparison::Less | Comparison::Greater => comparison.as_str(),
    };
    format!("${} {sign} {}$", left.latex(), right.latex())
}

impl Statement {
    fn markdown(&self) -> String {
        let set = Expression::latex;
        match self {
            Self::True(formula) => formula.markdown(),
            Self::Computed(computed) => computed.text(),
            Self::Motion(motion) => motion.words(|side| format!("${}$", set(side))),
            Self::Limit(left, value, name, toward) => {
                let toward = if *toward == Toward::Zero { "0" } else { "\\infty" };
                let name = variable(name);
                let end = match value {
                    End::Finite(value) => set(value),
                    End::Infinite(1) => "\\infty".to_owned(),
                    End::Infinite(_) => "-\\infty".to_owned(),
                };
                format!("${} \\to {end}$ as ${name} \\to {toward}$", set(left))
            }
            Self::Monotone(expression, comparison, name) => {
                let word = if *comparison == Comparison::Greater { "rises" } else { "falls" };
                format!("${}$ {word} with ${}$", set(expression), variable(name))
            }
            Self::Depends(expression, depends, name) => {
                let words = if *depends { "depends on" } else { "does not depend on" };
                format!("${}$ {words} ${}$", set(expression), variable(name))
            }
        }
    }
}

impl Formula {
    fn markdown(&self) -> String {
        let joined = |parts: &[Self], word: &str| {
            parts.iter().map(Self::grouped).collect::<Vec<_>>().join(&format!(" {word} "))
        };
        match self {
            Self::Compare(left, comparison, right) => compared(left, *comparison, right),
            Self::Roots(statement, polynomial, name) => {
                let words = match statement.as_str() {
                    "all_real" => "all roots are real:".to_owned(),
                    word => word.to_owned(),
                };
                format!("{words} ${} = 0$ in ${}$", polynomial.latex(), variable(name))
            }
            Self::Crossing(crossing) => format!(
                "a pair of roots ${} = \\pm i\\,{}$ of ${} = 0$ crosses the imaginary axis at ${} = {}$",
                variable(&crossing.variable),
                crossing.frequency.latex(),
                crossing.polynomial.latex(),
                variable(&crossing.parameter),
                crossing.critical.latex()
            ),
            Self::Not(inner) => format!("not {}", inner.grouped()),
            Self::All(parts) => joined(parts, "and"),
            Self::Any(parts) => joined(parts, "or"),
            Self::Implies(both) => joined(&both[..], "implies"),
            Self::Iff(both) => joined(&both[..], "if and only if"),
        }
    }

    fn grouped(&self) -> String {
        match self {
            Self::Compare(..) | Self::Not(_) => self.markdown(),
            _ => format!("({})", self.markdown()),
        }
    }
}
