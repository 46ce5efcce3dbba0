//! A claim stated as a formula: what the user writes beside the claim's words.
//!
//! ```text
//! statement := formula                                           for all values that the conditions allow
//!            | side '->' side 'as' name '->' ('0' | 'infinity')   a limit, the other variables fixed
//!            | side ('rises' | 'falls') 'with' name               strictly, the other variables fixed
//!            | side ['does not'] 'depend' 'on' name
//! formula   := implied ['iff' implied]
//! implied   := either ['implies' either]
//! either    := both ('or' both)*
//! both      := negated ('and' negated)*
//! negated   := 'not' negated | '[' formula ']' | atom
//! atom      := side ('=' | '!=' | '<' | '>' | '<=' | '>=') side | predicate
//! predicate := ('stable' | 'unstable' | 'all_real') '(' side ',' name ')'
//!            | 'pair_crosses' '(' side ',' name ',' name ',' side ',' side ')'
//! ```
//! A side is an expression of `equations.toml`. A name that stands alone on the left of exactly one equation, such as `K_c`, means
//! the right side of that equation; `left_8`, `right_15` and `residual_8` mean the sides of an equation and their difference.

pub(super) mod grammar;
mod markdown;
mod premises;
mod stated;

use std::collections::BTreeMap;

use slipmode_algebra::{
    Comparison, ConversionError, End, Expression, Extent, Literal, Sign, SignFormula, Symbol, Toward,
    within_budget,
};
use slipmode_core::number::Rational;
use slipmode_theory::Equations;
use slipmode_theory::root_location::{MOST_DEGREE_OF_OTHERS, RootStatement, coefficients};

use crate::scene::claim_motion::ClaimMotion;
use crate::scene::claim_names::Names;
pub(crate) use premises::within_ends;
pub use premises::{Premises, Solved};
pub use stated::{Computed, Premise, StatedClaim, StatedReading};

/// What a side may come to when it is multiplied out: it bounds the work of a decision.
const LARGEST: Extent = Extent { terms: 1000, degree: 64, bits: 4096 };

/// The same of an expression that a lemma on motions differentiates twice and divides.
const LARGEST_OF_MOTION: Extent = Extent { terms: 60, degree: 20, bits: 512 };

/// The most steps of algebra that the reading of one formula takes.
const STEPS: u64 = 1_000_000;

/// The most clauses of a formula, and the most comparisons of a clause.
pub const MOST_CLAUSES: usize = 64;

/// A formula, what its variables range over, and the conditions under which it is claimed, as written and parsed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ClaimFormula {
    /// The formula as written.
    pub text: String,
    /// What it says.
    pub statement: Statement,
    /// Over what it is said.
    pub scope: Scope,
    /// The table over whose rows the text is said; then the statement and the scope are empty.
    pub rows: Option<OverRows>,
    /// The limit within which it holds, and where it does not.
    pub limit: Option<Box<FormulaLimit>>,
}

/// Over which rows a text is said, and what its sentences name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OverRows {
    /// The table.
    pub table: String,
    /// How a number is computed of the rows, by its name.
    pub numbers: BTreeMap<String, String>,
    /// How many rows, neighbours or groups a true statement has to be about; 0 where the claim states no such number.
    pub at_least: u64,
    /// How far a statement that is true goes, in words and numbers.
    pub extent: Option<String>,
}

/// A limit of a formula: the words of the limit, and what is true outside it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormulaLimit {
    /// The limit.
    pub words: String,
    /// What is true outside, in words and as a formula, which is decided too.
    pub outside: (String, ClaimFormula),
}

/// Over what a formula is said, besides the assumptions of `equations.toml`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scope {
    /// The conditions.
    pub given: Vec<FormulaCondition>,
    /// The variables of which there is a value for all values of the others.
    pub there_is: Vec<Symbol>,
    /// Values for them.
    pub witness: Vec<(Symbol, Expression)>,
    /// Variables between two values, both included.
    pub within: Vec<(Symbol, [Rational; 2])>,
    /// The variables for which equations among the conditions are solved: they move along where another one does.
    pub moves: Vec<Symbol>,
    /// Variables with one value.
    pub at: Vec<(Symbol, Rational)>,
}

/// What a formula says, in the names of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Statement {
    /// The formula is true everywhere.
    True(Formula),
    /// The expression goes to this end as the variable goes there.
    Limit(Expression, End, Symbol, Toward),
    /// The expression rises (or falls) strictly with the variable.
    Monotone(Expression, Comparison, Symbol),
    /// Whether the variable changes the expression.
    Depends(Expression, bool, Symbol),
    /// A lemma on the motions of a system.
    Motion(Box<ClaimMotion>),
    /// What is no formula: proofs that go through, claims that hold, what a procedure finds.
    Computed(Box<Computed>),
}

impl Default for Statement {
    fn default() -> Self {
        Self::True(Formula::All(Vec::new()))
    }
}

/// Something that is true or false at a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Formula {
    /// Both sides compare so.
    Compare(Expression, Comparison, Expression),
    /// A statement on the roots of a polynomial in a variable.
    Roots(RootStatement, Expression, Symbol),
    /// A pair of roots crosses the imaginary axis.
    Crossing(Box<Crossing>),
    /// The opposite.
    Not(Box<Formula>),
    /// All of them.
    All(Vec<Formula>),
    /// At least one of them.
    Any(Vec<Formula>),
    /// The second, where the first is true.
    Implies(Box<[Formula; 2]>),
    /// Both or neither.
    Iff(Box<[Formula; 2]>),
}

/// `pair_crosses(polynomial, variable, parameter, critical, frequency)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Crossing {
    /// Whose roots.
    pub polynomial: Expression,
    /// Its variable.
    pub variable: Symbol,
    /// What is changed.
    pub parameter: Symbol,
    /// Its value at which the pair is on the axis.
    pub critical: Expression,
    /// The pair's frequency there.
    pub frequency: Expression,
}

impl Scope {
    /// Refuses a witness that is no value of the other variables, or of a sign that is not allowed.
    fn check_witness(&self, names: &Names, premises: &Premises) -> Result<(), String> {
        self.witness.iter().try_for_each(|(name, value)| {
            let resolved = premises.put_in(&names.resolved(value));
            let mut own = resolved.variables().into_iter().filter(|one| self.there_is.contains(one));
            let sign = premises.domain().sign(&resolved).ok().flatten();
            let witness = format!("the witness {name} = {value}");
            match own.next() {
                Some(own) => Err(format!("{witness} contains {own}, which is in `there_is`")),
                None if premises.positive.contains(name) && sign.is_some_and(|sign| sign <= 0) => {
                    Err(format!("{witness} is not positive, and {name} is assumed to be"))
                }
                None => Ok(()),
            }
        })
    }
}

/// A condition: two sides that compare so.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormulaCondition {
    /// As written.
    pub text: String,
    /// Both sides.
    pub sides: [Expression; 2],
    /// How they compare.
    pub comparison: Comparison,
}

impl FormulaCondition {
    /// Reads a condition: two sides with one comparison between them.
    ///
    /// # Errors
    /// As [`ClaimFormula::read`].
    pub fn read(text: &str, names: &Names) -> Result<Self, String> {
        let (left, comparison, right) = grammar::compared(text, names)?;
        Ok(Self { text: text.trim().to_owned(), sides: [left, right], comparison })
    }

    /// Left minus right, compared with zero.
    #[must_use]
    pub fn literal(&self) -> Literal {
        let [left, right] = self.sides.clone();
        self.comparison.literal(left, right)
    }
}

impl ClaimFormula {
    /// The expressions in it, in its conditions and in its witnesses.
    #[must_use]
    pub fn expressions(&self) -> Vec<&Expression> {
        let conditions = self.scope.given.iter().flat_map(|condition| &condition.sides);
        let witnesses = self.scope.witness.iter().map(|(_, value)| value);
        self.statement.sides().into_iter().chain(conditions).chain(witnesses).collect()
    }

    /// Reads a formula that is said over a scope.
    ///
    /// # Errors
    /// What is wrong with the formula, with its column: its grammar, an unknown name, a side without a value, a statement that is
    /// true by construction.
    pub fn read(text: &str, scope: Scope, equations: &Equations) -> Result<Self, String> {
        let statement = grammar::statement(text, &Names::of(equations))?;
        Self { text: text.trim().to_owned(), statement, scope, ..Self::default() }.checked(equations)
    }

    /// What is said of the motions of a system, over a scope.
    ///
    /// # Errors
    /// As [`ClaimFormula::read`], and for a scope that speaks of what moves.
    pub fn of_motion(motion: ClaimMotion, scope: Scope, equations: &Equations) -> Result<Self, String> {
        if !scope.there_is.is_empty() || !scope.within.is_empty() {
            return Err("`there_is` and `box` are for formulas".into());
        }
        let names = Names::of(equations);
        let rates = names.system(&motion.name).map(|system| &system.rates).into_iter().flatten();
        for (word, side) in motion.expressions().into_iter().chain(rates.map(|rate| ("rate", rate))) {
            let fault = |error| format!("the {word} {side} is too large: {error}");
            let resolved = names.resolved(side);
            // No lemma differentiates a sign.
            let largest = if word == "sign" { LARGEST } else { LARGEST_OF_MOTION };
            resolved.check_extent(largest).map_err(fault)?;
            if let Some(function) = resolved.functions().first() {
                return Err(format!(
                    "the {word} {side} has the function {function}: no lemma on motions is for functions of which nothing is known"
                ));
            }
        }
        let text = motion.words(ToString::to_string);
        Self { text, statement: Statement::Motion(Box::new(motion)), scope, ..Self::default() }
            .checked(equations)
    }

    /// What proofs, other claims or a procedure decide.
    pub(crate) fn of_computed(computed: Computed) -> Self {
        let text = computed.text();
        Self { text, statement: Statement::Computed(Box::new(computed)), ..Self::default() }
    }

    /// The claims that have to hold, in it and outside its limit.
    pub(in crate::scene) fn premises_mut(&mut self) -> impl Iterator<Item = &mut Premise> {
        let of = |statement| match statement {
            &mut Statement::Computed(ref mut computed) => computed.premises.iter_mut(),
            _ => [].iter_mut(),
        };
        let outside = self.limit.as_mut().map(|limit| &mut limit.outside.1.statement);
        std::iter::once(&mut self.statement).chain(outside).flat_map(of)
    }

    /// What decides it, where that is no formula.
    #[must_use]
    pub fn computed(&self) -> Option<&Computed> {
        match &self.statement {
            Statement::Computed(computed) => Some(computed),
            _ => None,
        }
    }

    /// Whether a procedure or the rows of a table decide it.
    pub(crate) fn is_over_results(&self) -> bool {
        self.rows.is_some() || self.computed().is_some_and(|computed| computed.check.is_some())
    }

    /// Whether it compares by `=` only: it states no tolerance.
    pub(in crate::scene) fn is_equation(&self) -> bool {
        let atoms = self.statement.atoms();
        let is_equal = |atom: &&Formula| matches!(atom, Formula::Compare(_, Comparison::Equal, _));
        !atoms.is_empty() && atoms.iter().all(is_equal)
    }

    fn checked(self, equations: &Equations) -> Result<Self, String> {
        within_budget(STEPS, || self.checked_all(equations))
            .unwrap_or_else(|exhausted| Err(exhausted.to_string()))
    }

    fn checked_all(self, equations: &Equations) -> Result<Self, String> {
        let (names, formula) = (Names::of(equations), self);
        let premises = formula.premises(equations)?;
        let mut compared = formula.scope.given.iter().map(|condition| &condition.sides);
        compared.try_for_each(|[left, right]| names.same_units(left, right))?;
        formula.scope.check_witness(&names, &premises)?;
        formula.statement.check_units(&names)?;
        formula.statement.atoms().into_iter().try_for_each(|atom| check_atom(atom, &names, &premises))?;
        if let Some(name) = formula.statement.variable() {
            if !formula.scope.there_is.is_empty() {
                return Err("`there_is` is for comparisons: a limit, `rises`, `falls` and `depends` are said for all values".into());
            }
            if formula.scope.at.iter().any(|(known, _)| known == name) {
                return Err(format!("{name} moves, and `at` gives it a value"));
            }
        }
        match &formula.statement {
            Statement::Limit(_, End::Finite(value), name, _)
                if premises.put_in(&names.resolved(value)).variables().contains(name) =>
            {
                Err(format!("the value '{value}' of the limit contains {name}"))
            }
            Statement::True(said) if said.opaque().clauses(&|_| None, MOST_CLAUSES) == Some(Vec::new()) => {
                Err("true by construction, whatever its comparisons say".into())
            }
            _ => Ok(formula),
        }
    }

    /// The premises, if every side has a value under them that is not too large: as it is written, and as what it uses is.
    ///
    /// # Errors
    /// The first side without one.
    pub fn premises(&self, equations: &Equations) -> Result<Premises, String> {
        let names = Names::of(equations);
        let mut premises = Premises::new(&self.scope, self.statement.variable(), equations)?;
        let conditions = self.scope.given.iter().flat_map(|condition| &condition.sides);
        let conditions = conditions.map(|side| (side, None));
        for (side, own) in self.statement.sides_with_roots().into_iter().chain(conditions) {
            let resolved = own.map_or_else(|| names.resolved(side), |own| names.resolved_but(side, own));
            let resolved = premises.put_in(&resolved);
            resolved.check_extent(LARGEST).map_err(|error| format!("'{side}' is too large: {error}"))?;
            let domain = premises.with_wanted().domain();
            if let Some(missing) = names.missing_condition(side, &domain, |one| premises.put_in(one)) {
                return Err(missing);
            }
            let no_value = |error: String| format!("'{side}' has no value under the conditions: {error}");
            for demand in names.demands_but(side, own) {
                premises.demand(&demand).map_err(no_value)?;
            }
            match premises.with_wanted().domain().rational_function(&resolved) {
                // A logarithm or an open sign may still be decided with a substitution.
                Err(ConversionError::Logarithm(_) | ConversionError::OpenSign(_)) | Ok(_) => {}
                Err(error) => return Err(no_value(error.to_string())),
            }
        }
        Ok(premises)
    }
}

/// Refuses an atom that is true by construction, and a predicate of what is no polynomial.
fn check_atom(atom: &Formula, names: &Names, premises: &Premises) -> Result<(), String> {
    let polynomial = |side: &Expression, variable: &Symbol, most: usize| {
        let resolved = premises.put_in(&names.resolved_but(side, variable));
        let found = premises.domain().rational_function(&resolved).ok();
        let found = found.and_then(|function| coefficients(&function, variable, most));
        let imaginary =
            |one: &Expression| one.variables().iter().any(|name| ["i", "pm"].contains(&name.as_str()));
        match found {
            Some(found) if !found.iter().any(imaginary) => Ok(()),
            _ => Err(format!("'{side}' is no real polynomial of degree 1 to {most} in {variable}")),
        }
    };
    match atom {
        Formula::Compare(left, _, right) if left == right => {
            Err("both sides are the same by construction".into())
        }
        Formula::Roots(said, side, variable) => polynomial(side, variable, said.most_degree()),
        Formula::Crossing(crossing) => {
            polynomial(&crossing.polynomial, &crossing.variable, MOST_DEGREE_OF_OTHERS)
        }
        _ => Ok(()),
    }
}

impl Statement {
    /// What is compared has the same unit, where units are stated.
    fn check_units(&self, names: &Names) -> Result<(), String> {
        self.sides().into_iter().try_for_each(|side| names.same_units(side, side))?;
        if let Self::Limit(left, End::Finite(value), ..) = self {
            names.same_units(left, value)?;
        }
        self.atoms().into_iter().try_for_each(|atom| match atom {
            Formula::Compare(left, _, right) => names.same_units(left, right),
            Formula::Crossing(crossing) => {
                names.same_units(&Expression::variable(&crossing.parameter), &crossing.critical)?;
                names.same_units(&Expression::variable(&crossing.variable), &crossing.frequency)
            }
            _ => Ok(()),
        })
    }

    /// The expressions in it.
    #[must_use]
    pub fn sides(&self) -> Vec<&Expression> {
        self.sides_with_roots().into_iter().map(|(side, _)| side).collect()
    }

    /// The expressions in it, each with the name that stands for its roots.
    fn sides_with_roots(&self) -> Vec<(&Expression, Option<&Symbol>)> {
        match self {
            Self::True(formula) => formula.sides(),
            Self::Limit(side, End::Finite(value), ..) => vec![(side, None), (value, None)],
            Self::Limit(side, End::Infinite(_), ..) => vec![(side, None)],
            Self::Monotone(expression, ..) | Self::Depends(expression, ..) => vec![(expression, None)],
            Self::Motion(motion) => motion.expressions().into_iter().map(|(_, side)| (side, None)).collect(),
            Self::Computed(_) => Vec::new(),
        }
    }

    /// The variable that moves in a limit or a dependence.
    #[must_use]
    pub fn variable(&self) -> Option<&Symbol> {
        match self {
            Self::True(_) | Self::Motion(_) | Self::Computed(_) => None,
            Self::Limit(_, _, variable, _)
            | Self::Monotone(_, _, variable)
            | Self::Depends(_, _, variable) => Some(variable),
        }
    }

    fn atoms(&self) -> Vec<&Formula> {
        match self {
            Self::True(formula) => formula.atoms(),
            _ => Vec::new(),
        }
    }
}

impl Formula {
    /// Reads a formula in the names of something else than equations, such as the columns of a table.
    ///
    /// # Errors
    /// What is wrong with it, with its column.
    pub fn read(text: &str, names: &Names) -> Result<Self, String> {
        match grammar::statement(text, names)? {
            Statement::True(formula) => Ok(formula),
            _ => Err(format!("'{text}' is no condition that is true or false in a row")),
        }
    }

    /// The comparisons and predicates in it.
    pub(crate) fn atoms(&self) -> Vec<&Self> {
        match self {
            Self::Compare(..) | Self::Roots(..) | Self::Crossing(_) => vec![self],
            Self::Not(inner) => inner.atoms(),
            Self::All(parts) | Self::Any(parts) => parts.iter().flat_map(Self::atoms).collect(),
            Self::Implies(both) | Self::Iff(both) => both.iter().flat_map(Self::atoms).collect(),
        }
    }

    /// The formula with its comparisons and predicates as signs.
    pub fn signs(&self, of: &impl Fn(&Self) -> SignFormula) -> SignFormula {
        let all = |parts: &[Self]| parts.iter().map(|part| part.signs(of)).collect();
        let implies =
            |one: &Self, other: &Self| SignFormula::Any(vec![one.signs(of).negated(), other.signs(of)]);
        match self {
            Self::Compare(..) | Self::Roots(..) | Self::Crossing(_) => of(self),
            Self::Not(inner) => inner.signs(of).negated(),
            Self::All(parts) => SignFormula::All(all(parts)),
            Self::Any(parts) => SignFormula::Any(all(parts)),
            Self::Implies(both) => implies(&both[0], &both[1]),
            Self::Iff(both) => {
                SignFormula::All(vec![implies(&both[0], &both[1]), implies(&both[1], &both[0])])
            }
        }
    }

    /// The formula with each comparison as it is written, and each predicate as a parameter of its own.
    fn opaque(&self) -> SignFormula {
        let atoms = self.atoms();
        let number = |atom: &Self| atoms.iter().take_while(|known| **known != atom).count();
        self.signs(&|atom| {
            SignFormula::Literal(match atom {
                Self::Compare(left, comparison, right) => comparison.literal(left.clone(), right.clone()),
                other => {
                    let parameter = Symbol::parameter(u32::try_from(number(other)).unwrap_or(u32::MAX));
                    Literal::new(Expression::Variable(parameter), Sign::Positive)
                }
            })
        })
    }

    fn sides(&self) -> Vec<(&Expression, Option<&Symbol>)> {
        let mut sides: Vec<(&Expression, Option<&Symbol>)> = Vec::new();
        for atom in self.atoms() {
            match atom {
                Self::Compare(left, _, right) => sides.extend([(left, None), (right, None)]),
                Self::Roots(_, polynomial, own) => sides.push((polynomial, Some(own))),
                Self::Crossing(crossing) => sides.extend([
                    (&crossing.polynomial, Some(&crossing.variable)),
                    (&crossing.critical, None),
                    (&crossing.frequency, None),
                ]),
                _ => {}
            }
        }
        sides
    }
}
