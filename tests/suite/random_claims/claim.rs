//! A claim whose truth is known before any prover sees it.

use super::term::{Name, Term};
use super::world::World;

/// What is known of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Truth {
    True,
    False,
    /// It says nothing that can be true or false: a side has no value somewhere, no point meets the conditions, or it is ill-formed.
    Meaningless,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Statement {
    Formula(Formula),
    Limit {
        side: Term,
        value: Term,
        of: Name,
        to: &'static str,
    },
    Unbounded {
        side: Term,
        up: bool,
        of: Name,
        to: &'static str,
    },
    Monotone {
        side: Term,
        rises: bool,
        with: Name,
    },
    Depends {
        side: Term,
        depends: bool,
        on: Name,
    },
    /// A text that the grammar does not know.
    IllFormed(String),
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Formula {
    Compare(Comparison),
    /// `stable`, `unstable` or `all_real`, and the polynomial.
    Roots(&'static str, Term),
    Crossing {
        polynomial: Term,
        parameter: Name,
        critical: Term,
        frequency: Term,
    },
    Not(Box<Formula>),
    And(Vec<Formula>),
    Or(Vec<Formula>),
    Implies(Box<[Formula; 2]>),
    Iff(Box<[Formula; 2]>),
}

/// Two sides, and the sign between them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Comparison {
    pub left: Term,
    pub sign: &'static str,
    pub right: Term,
}

pub fn compare(left: Term, sign: &'static str, right: Term) -> Comparison {
    Comparison { left, sign, right }
}

/// A name that the claim brings into `equations.toml`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Definition {
    /// An equation with the name alone on the left.
    Equation(Term),
    /// An expression as a definition.
    Expression(Term),
    /// A derivation such as `solve(f, x)`.
    Derivation(&'static str, Vec<Argument>),
    /// The characteristic polynomial of a system: states, rates, steady values.
    Characteristic(Vec<Name>, Vec<Term>, Vec<Term>),
    /// One of the others, made for a condition.
    Given(Box<Definition>, Comparison),
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Argument {
    Term(Term),
    Text(String),
    /// `name = value`.
    Value(Name, Term),
}

/// A claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Claim {
    /// What kind of claim it is, for the table of shares.
    pub kind: &'static str,
    pub truth: Truth,
    pub statement: Statement,
    pub given: Vec<Comparison>,
    pub there_is: Vec<Name>,
    pub witness: Vec<(Name, Term)>,
    pub within: Vec<(Name, [Term; 2])>,
    pub at: Vec<(Name, Term)>,
    pub moves: Vec<Name>,
    pub definitions: Vec<Definition>,
}

impl Claim {
    pub fn new(kind: &'static str, truth: Truth, statement: Statement) -> Self {
        Self {
            kind,
            truth,
            statement,
            given: Vec::new(),
            there_is: Vec::new(),
            witness: Vec::new(),
            within: Vec::new(),
            at: Vec::new(),
            moves: Vec::new(),
            definitions: Vec::new(),
        }
    }

    /// A claim that a formula is true.
    pub fn formula(kind: &'static str, truth: bool, formula: Formula) -> Self {
        Self::new(kind, Truth::of(truth), Statement::Formula(formula))
    }

    /// A claim that two sides compare so.
    pub fn compare(kind: &'static str, truth: bool, left: Term, sign: &'static str, right: Term) -> Self {
        Self::formula(kind, truth, Formula::Compare(compare(left, sign, right)))
    }

    pub fn given(mut self, left: Term, sign: &'static str, right: Term) -> Self {
        self.given.push(compare(left, sign, right));
        self
    }

    pub fn there_is(mut self, name: Name) -> Self {
        self.there_is.push(name);
        self
    }

    pub fn witness(mut self, name: Name, value: Term) -> Self {
        self.witness.push((name, value));
        self
    }

    pub fn within(mut self, name: Name, ends: [Term; 2]) -> Self {
        self.within.push((name, ends));
        self
    }

    pub fn at(mut self, name: Name, value: Term) -> Self {
        self.at.push((name, value));
        self
    }

    pub fn moves(mut self, name: Name) -> Self {
        self.moves.push(name);
        self
    }

    /// The claim with one more definition, and its name.
    pub fn define(&mut self, definition: Definition) -> Name {
        self.definitions.push(definition);
        Name::Defined(self.definitions.len() - 1)
    }

    /// The variable that moves in a limit, a rise, a dependence or a crossing.
    pub fn moving(&self) -> Option<Name> {
        match &self.statement {
            Statement::Limit { of, .. } | Statement::Unbounded { of, .. } => Some(*of),
            Statement::Monotone { with, .. } => Some(*with),
            Statement::Depends { on, .. } => Some(*on),
            Statement::Formula(formula) => formula.parameter(),
            Statement::IllFormed(_) => None,
        }
    }

    /// All expressions that the claim states, each of which may be written differently.
    pub fn sides_mut(&mut self) -> Vec<&mut Term> {
        let mut sides = match &mut self.statement {
            Statement::Formula(formula) => formula.sides_mut(),
            Statement::Limit { side, value, .. } => vec![side, value],
            Statement::Unbounded { side, .. }
            | Statement::Monotone { side, .. }
            | Statement::Depends { side, .. } => vec![side],
            Statement::IllFormed(_) => Vec::new(),
        };
        sides.extend(self.given.iter_mut().flat_map(|one| [&mut one.left, &mut one.right]));
        sides
    }

    /// The variables that occur anywhere in it.
    pub fn names(&self) -> Vec<Name> {
        let mut copy = self.clone();
        let mut names: Vec<Name> = copy.sides_mut().into_iter().flat_map(|side| side.names()).collect();
        names.extend(self.definitions.iter().flat_map(Definition::names));
        names.extend(self.there_is.iter().chain(&self.moves).copied().chain(self.moving()));
        names.extend(
            self.witness.iter().flat_map(|(name, value)| std::iter::once(*name).chain(value.names())),
        );
        names.extend(self.within.iter().map(|(name, _)| *name).chain(self.at.iter().map(|(name, _)| *name)));
        names.sort_unstable();
        names.dedup();
        names
    }

    /// A variable of a kind that occurs nowhere in it.
    pub fn unused(&self, kind: fn(usize) -> Name, count: usize) -> Option<Name> {
        let used = self.names();
        (0..count).rev().map(kind).find(|name| !used.contains(name))
    }

    /// The claim as a section of `claims.toml`.
    pub fn toml(&self, number: usize, world: &World) -> String {
        let spell = |name| world.spell(name, number);
        let text = |term: &Term| term.text(&spell);
        let verdict = match self.truth {
            Truth::True => "holds",
            Truth::False => "fails",
            Truth::Meaningless => "not-checked",
        };
        let mut toml = format!(
            "[[claim]]\nid = \"C{number}\"\nplace = \"p\"\nwords = \"A claim on {}.\"\nexpected = \"{verdict}\"\n\
             leaves_out = \"nothing\"\nformula = {:?}\n",
            self.kind,
            self.statement.text(&spell),
        );
        let mut list = |key: &str, members: Vec<String>, brackets: [&str; 2]| {
            if !members.is_empty() {
                toml += &format!("{key} = {}{}{}\n", brackets[0], members.join(", "), brackets[1]);
            }
        };
        let quoted = |names: &[Name]| names.iter().map(|name| format!("{:?}", spell(*name))).collect();
        list("given", self.given.iter().map(|one| format!("{:?}", one.text(&spell))).collect(), ["[", "]"]);
        list("there_is", quoted(&self.there_is), ["[", "]"]);
        list("moves", quoted(&self.moves), ["[", "]"]);
        let value = |(name, value): &(Name, Term)| format!("{} = {:?}", spell(*name), text(value));
        list("witness", self.witness.iter().map(value).collect(), ["{ ", " }"]);
        list("at", self.at.iter().map(value).collect(), ["{ ", " }"]);
        let ends = |(name, [low, high]): &(Name, [Term; 2])| {
            format!("{} = [{:?}, {:?}]", spell(*name), text(low), text(high))
        };
        list("box", self.within.iter().map(ends).collect(), ["{ ", " }"]);
        toml
    }

    /// Its definitions as sections of `equations.toml`.
    pub fn definitions_toml(&self, number: usize, world: &World) -> String {
        let spell = |name| world.spell(name, number);
        let one = |(at, definition): (usize, &Definition)| definition.toml(&spell(Name::Defined(at)), &spell);
        self.definitions.iter().enumerate().map(one).collect()
    }
}

impl Truth {
    pub fn of(truth: bool) -> Self {
        if truth { Self::True } else { Self::False }
    }
}

impl Comparison {
    pub fn text(&self, spell: &dyn Fn(Name) -> String) -> String {
        format!("{} {} {}", self.left.text(spell), self.sign, self.right.text(spell))
    }
}

impl Statement {
    fn text(&self, spell: &dyn Fn(Name) -> String) -> String {
        match self {
            Self::Formula(formula) => formula.text(spell),
            Self::Limit { side, value, of, to } => {
                format!("{} -> {} as {} -> {to}", side.text(spell), value.text(spell), spell(*of))
            }
            Self::Unbounded { side, up, of, to } => {
                let end = if *up { "infinity" } else { "-infinity" };
                format!("{} -> {end} as {} -> {to}", side.text(spell), spell(*of))
            }
            Self::Monotone { side, rises, with } => {
                let word = if *rises { "rises" } else { "falls" };
                format!("{} {word} with {}", side.text(spell), spell(*with))
            }
            Self::Depends { side, depends, on } => {
                let words = if *depends { "depends" } else { "does not depend" };
                format!("{} {words} on {}", side.text(spell), spell(*on))
            }
            Self::IllFormed(text) => text.clone(),
        }
    }
}

impl Formula {
    pub fn negated(self) -> Self {
        Self::Not(Box::new(self))
    }

    pub fn implies(self, other: Self) -> Self {
        Self::Implies(Box::new([self, other]))
    }

    pub fn iff(self, other: Self) -> Self {
        Self::Iff(Box::new([self, other]))
    }

    fn parts_mut(&mut self) -> Vec<&mut Self> {
        match self {
            Self::Compare(_) | Self::Roots(..) | Self::Crossing { .. } => Vec::new(),
            Self::Not(inner) => vec![inner],
            Self::And(parts) | Self::Or(parts) => parts.iter_mut().collect(),
            Self::Implies(both) | Self::Iff(both) => both.iter_mut().collect(),
        }
    }

    fn sides_mut(&mut self) -> Vec<&mut Term> {
        match self {
            Self::Compare(one) => vec![&mut one.left, &mut one.right],
            Self::Roots(_, polynomial) => vec![polynomial],
            Self::Crossing { polynomial, critical, frequency, .. } => vec![polynomial, critical, frequency],
            other => other.parts_mut().into_iter().flat_map(Self::sides_mut).collect(),
        }
    }

    /// The comparisons in it.
    pub fn comparisons_mut(&mut self) -> Vec<&mut Self> {
        if matches!(self, Self::Compare(_)) {
            return vec![self];
        }
        self.parts_mut().into_iter().flat_map(Self::comparisons_mut).collect()
    }

    /// The parameter of a crossing.
    fn parameter(&self) -> Option<Name> {
        match self {
            Self::Crossing { parameter, .. } => Some(*parameter),
            Self::Compare(_) | Self::Roots(..) => None,
            Self::Not(inner) => inner.parameter(),
            Self::And(parts) | Self::Or(parts) => parts.iter().find_map(Self::parameter),
            Self::Implies(both) | Self::Iff(both) => both.iter().find_map(Self::parameter),
        }
    }

    fn text(&self, spell: &dyn Fn(Name) -> String) -> String {
        let joined = |parts: &[Self], word: &str| {
            parts.iter().map(|part| part.grouped(spell)).collect::<Vec<_>>().join(word)
        };
        match self {
            Self::Compare(one) => one.text(spell),
            Self::Roots(word, polynomial) => {
                format!("{word}({}, {})", polynomial.text(spell), spell(Name::Root))
            }
            Self::Crossing { polynomial, parameter, critical, frequency } => format!(
                "pair_crosses({}, {}, {}, {}, {})",
                polynomial.text(spell),
                spell(Name::Root),
                spell(*parameter),
                critical.text(spell),
                frequency.text(spell),
            ),
            Self::Not(inner) => format!("not {}", inner.grouped(spell)),
            Self::And(parts) => joined(parts, " and "),
            Self::Or(parts) => joined(parts, " or "),
            Self::Implies(both) => joined(&both[..], " implies "),
            Self::Iff(both) => joined(&both[..], " iff "),
        }
    }

    fn grouped(&self, spell: &dyn Fn(Name) -> String) -> String {
        match self {
            Self::Compare(_) | Self::Roots(..) | Self::Crossing { .. } => self.text(spell),
            other => format!("[{}]", other.text(spell)),
        }
    }
}

impl Definition {
    fn names(&self) -> Vec<Name> {
        let of_argument = |argument: &Argument| match argument {
            Argument::Term(term) => term.names().into_iter().collect(),
            Argument::Value(name, term) => term.names().into_iter().chain([*name]).collect(),
            Argument::Text(_) => Vec::new(),
        };
        match self {
            Self::Equation(term) | Self::Expression(term) => term.names().into_iter().collect(),
            Self::Derivation(_, arguments) => arguments.iter().flat_map(of_argument).collect(),
            Self::Characteristic(states, rates, steady) => {
                states.iter().copied().chain(rates.iter().chain(steady).flat_map(Term::names)).collect()
            }
            Self::Given(inner, condition) => {
                let sides = [&condition.left, &condition.right].into_iter().flat_map(Term::names);
                inner.names().into_iter().chain(sides).collect()
            }
        }
    }

    fn toml(&self, name: &str, spell: &dyn Fn(Name) -> String) -> String {
        let definition = |is: String| format!("[[definition]]\nname = {name:?}\nis = {is:?}\n");
        match self {
            Self::Equation(term) => {
                format!("[[equation]]\nnumber = {name:?}\nequation = \"{name} = {}\"\n", term.text(spell))
            }
            Self::Expression(term) => definition(term.text(spell)),
            Self::Derivation(word, arguments) => {
                let argument = |one: &Argument| match one {
                    Argument::Term(term) => term.text(spell),
                    Argument::Text(text) => text.clone(),
                    Argument::Value(name, value) => format!("{} = {}", spell(*name), value.text(spell)),
                };
                let arguments: Vec<String> = arguments.iter().map(argument).collect();
                definition(format!("{word}({})", arguments.join(", ")))
            }
            Self::Characteristic(states, rates, steady) => {
                let names: Vec<String> = states.iter().map(|name| spell(*name)).collect();
                let texts = |list: &[Term]| list.iter().map(|one| one.text(spell)).collect::<Vec<_>>();
                let system = format!(
                    "[[system]]\nname = \"of_{name}\"\nstate = {names:?}\nrates = {:?}\nsteady = {:?}\n",
                    texts(rates),
                    texts(steady),
                );
                system + &definition(format!("characteristic(of_{name}, {})", spell(Name::Root)))
            }
            Self::Given(inner, condition) => {
                format!("{}given = [{:?}]\n", inner.toml(name, spell), condition.text(spell))
            }
        }
    }
}
