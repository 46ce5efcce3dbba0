//! What the names in formulas mean, read from the equations as they are written: every name is a variable or has a term of its own,
//! and nothing is put in or simplified.
//!
//! A name that stands alone on the left of exactly one equation means the right side. `left_8`, `right_8` and `residual_8` mean the
//! sides of equation 8 and their difference, in which the name that the equation defines stays a variable. A definition means what
//! its derivation says.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::rc::Rc;

use slipmode_algebra::{Comparison, Expression, Function};
use slipmode_core::number::Rational;
use slipmode_theory::{Derivation, Equations, Operation};

/// The imaginary unit, and the sign that stands for ±.
pub(super) const UNIT: &str = "i";
pub(super) const EITHER_SIGN: &str = "pm";

/// An expression as it is written, with its names found.
#[derive(Debug, Clone)]
pub(super) enum Term {
    Number(Rational),
    Variable(usize),
    Defined(usize),
    Sum(Vec<Term>),
    Product(Vec<Term>),
    Quotient(Box<Term>, Box<Term>),
    Negation(Box<Term>),
    Power(Box<Term>, i32),
    Call(Function, Box<Term>),
    /// A function of which nothing is known: a polynomial by its value at 0, which is this variable, and those of its derivatives.
    Polynomial(usize, Box<Term>),
}

/// Two sides that compare so.
#[derive(Debug, Clone)]
pub(super) struct Compared {
    pub left: Term,
    pub comparison: Comparison,
    pub right: Term,
}

/// A derivation, with its arguments as terms.
#[derive(Debug, Clone)]
pub(super) struct Derived {
    pub operation: Operation,
    /// The states, the rates and the steady values of the system that it names.
    pub states: Vec<usize>,
    pub rates: Vec<Term>,
    pub steady: Vec<Term>,
    pub terms: Vec<Term>,
    pub variables: Vec<usize>,
    pub whole: usize,
    pub values: Vec<(usize, Term)>,
    /// What the program found for it, where the gate has no evaluation of its own.
    pub found: Option<Term>,
}

/// What a defined name means.
#[derive(Debug, Clone)]
pub(super) enum Meaning {
    Term(Term),
    Derived(Box<Derived>),
}

/// The names of a file.
#[derive(Debug, Clone, Default)]
pub(super) struct Book {
    names: Vec<String>,
    variables: BTreeMap<String, usize>,
    positive: BTreeSet<usize>,
    meanings: Vec<Meaning>,
    defined: BTreeMap<String, usize>,
    /// The values at 0 of a function and of its derivatives, for each function: variables one after the other.
    coefficients: Vec<Range<usize>>,
    /// How many steps the evaluations of one claim took.
    steps: Cell<u32>,
    /// The variables that defined names reach, as far as somebody asked.
    reaches: RefCell<BTreeMap<usize, Rc<BTreeSet<usize>>>>,
}

/// How many values at 0 a function has: that of itself and those of its derivatives up to one order.
const COEFFICIENTS: usize = 12;

/// The most steps: a claim of a report takes one to three million.
const MOST_STEPS: u32 = 20_000_000;

/// What a name means before its own names are found.
#[derive(Clone)]
enum Draft {
    /// An expression, and the name that stays a variable in it.
    Written(Expression, Option<String>),
    Derived(Derivation),
}

impl Draft {
    fn names(&self, systems: &BTreeMap<String, System>) -> BTreeSet<String> {
        let (expressions, kept): (Vec<&Expression>, _) = match self {
            Self::Written(expression, kept) => (vec![expression], kept.as_ref()),
            Self::Derived(derivation) => {
                let system = derivation.system.as_ref().and_then(|name| systems.get(name)).into_iter();
                let of_system = system.flat_map(|system| system.rates.iter().chain(&system.steady));
                let values = derivation.values.iter().map(|(_, value)| value);
                (derivation.expressions.iter().chain(values).chain(of_system).collect(), None)
            }
        };
        let names = expressions.into_iter().flat_map(Expression::variables);
        names.map(|name| name.as_str().to_owned()).filter(|name| Some(name) != kept).collect()
    }
}

/// A system as it is written.
#[derive(Default)]
struct System {
    states: Vec<String>,
    rates: Vec<Expression>,
    steady: Vec<Expression>,
}

impl Book {
    pub fn of(equations: &Equations) -> Self {
        let functions = equations.names().functions();
        let parsed = |list: &[String]| -> Vec<Expression> {
            list.iter().filter_map(|text| Some(Expression::read_in(text, functions).ok()?.0)).collect()
        };
        let systems: BTreeMap<String, System> = equations
            .systems()
            .iter()
            .map(|text| {
                let (states, rates, steady) = (text.state.clone(), parsed(&text.rates), parsed(&text.steady));
                (text.name.clone(), System { states, rates, steady })
            })
            .collect();
        let derivations: BTreeMap<String, Derivation> = equations
            .definitions()
            .iter()
            .filter_map(|text| Some((text.name.clone(), Derivation::read(&text.is, functions).ok()?)))
            .collect();
        let drafts = drafts(equations, &systems, derivations);
        let mut book = Self::default();
        for name in drafts.keys() {
            book.defined.insert(name.clone(), book.meanings.len());
            book.meanings.push(Meaning::Term(Term::Number(Rational::new())));
        }
        for name in functions {
            let names = (0..COEFFICIENTS).map(|order| at_zero(name.as_str(), order));
            let places: Vec<usize> = names.map(|name| book.variable(&name)).collect();
            book.coefficients.extend(places.first().map(|first| *first..first + COEFFICIENTS));
        }
        for name in equations.positive() {
            let slot = book.variable(name);
            book.positive.insert(slot);
        }
        for (name, draft) in &drafts {
            let meaning = match draft {
                Draft::Written(expression, kept) => Meaning::Term(book.term(expression, kept.as_deref())),
                Draft::Derived(derivation) => book.derived(name, derivation, &systems, equations),
            };
            let place = book.defined[name];
            book.meanings[place] = meaning;
        }
        book
    }

    fn derived(
        &mut self,
        name: &str,
        derivation: &Derivation,
        systems: &BTreeMap<String, System>,
        equations: &Equations,
    ) -> Meaning {
        let Some(operation) = derivation.operation else {
            let written = derivation.expressions.first().cloned();
            return Meaning::Term(self.term(&written.unwrap_or_else(|| Expression::integer(0)), None));
        };
        let none = System::default();
        let system = derivation.system.as_ref().and_then(|name| systems.get(name)).unwrap_or(&none);
        Meaning::Derived(Box::new(Derived {
            operation,
            states: system.states.iter().map(|name| self.variable(name)).collect(),
            rates: system.rates.iter().map(|one| self.term(one, None)).collect(),
            steady: system.steady.iter().map(|one| self.term(one, None)).collect(),
            found: equations.names().derived(name).map(|found| self.plain(found)),
            terms: derivation.expressions.iter().map(|one| self.term(one, None)).collect(),
            variables: derivation.variables.iter().map(|name| self.variable(name.as_str())).collect(),
            whole: derivation.whole,
            values: derivation
                .values
                .iter()
                .map(|(name, value)| (self.variable(name.as_str()), self.term(value, None)))
                .collect(),
        }))
    }

    /// The place of a variable; a new one for a new name.
    pub fn variable(&mut self, name: &str) -> usize {
        if let Some(place) = self.variables.get(name) {
            return *place;
        }
        let place = self.names.len();
        self.names.push(name.to_owned());
        self.variables.insert(name.to_owned(), place);
        place
    }

    /// An expression as a term; one name in it is a variable even where it has a meaning.
    pub fn term(&mut self, expression: &Expression, own: Option<&str>) -> Term {
        self.found(expression, &|name| Some(name) == own)
    }

    /// An expression in variables alone.
    fn plain(&mut self, expression: &Expression) -> Term {
        self.found(expression, &|_| true)
    }

    fn found(&mut self, expression: &Expression, is_variable: &impl Fn(&str) -> bool) -> Term {
        let mut go = |inner: &Expression| self.found(inner, is_variable);
        match expression {
            Expression::Number(value) => Term::Number(value.clone()),
            Expression::Variable(name) => match self.defined.get(name.as_str()) {
                Some(place) if !is_variable(name.as_str()) => Term::Defined(*place),
                _ => Term::Variable(self.variable(name.as_str())),
            },
            Expression::Sum(parts) => Term::Sum(parts.iter().map(go).collect()),
            Expression::Product(parts) => Term::Product(parts.iter().map(go).collect()),
            Expression::Quotient(above, below) => Term::Quotient(Box::new(go(above)), Box::new(go(below))),
            Expression::Negation(inner) => Term::Negation(Box::new(go(inner))),
            Expression::Power(inner, exponent) => Term::Power(Box::new(go(inner)), *exponent),
            Expression::Call(function, inner) => Term::Call(*function, Box::new(go(inner))),
            Expression::Generic(function, inner) => {
                let inner = Box::new(go(inner));
                Term::Polynomial(self.variable(&at_zero(function.as_str(), 0)), inner)
            }
        }
    }

    /// Whether the evaluation may go on; beyond the most steps everything is open.
    pub fn takes_a_step(&self) -> bool {
        self.steps.set(self.steps.get().saturating_add(1));
        self.steps.get() <= MOST_STEPS
    }

    pub fn meaning(&self, place: usize) -> &Meaning {
        &self.meanings[place]
    }

    /// How many variables there are.
    pub fn variable_count(&self) -> usize {
        self.names.len()
    }

    pub fn name(&self, variable: usize) -> &str {
        &self.names[variable]
    }

    /// The place of a variable that is known by now.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.variables.get(name).copied()
    }

    /// The variables that are the values at 0 of a function and of its derivatives, from this one on; none for another variable.
    pub fn coefficients_from(&self, variable: usize) -> Range<usize> {
        let known = self.coefficients.iter().find(|places| places.contains(&variable));
        known.map_or(0..0, |places| variable..places.end)
    }

    /// The order of the derivative of which a variable is the value at 0; none where it is no such value.
    pub fn order(&self, variable: usize) -> Option<usize> {
        let known = self.coefficients.iter().find(|places| places.contains(&variable))?;
        Some(variable - known.start)
    }

    pub fn is_positive(&self, variable: usize) -> bool {
        self.positive.contains(&variable)
    }

    /// The variables that a defined name reaches.
    pub fn reach_of(&self, name: usize) -> Rc<BTreeSet<usize>> {
        let known = self.reaches.borrow().get(&name).cloned();
        known.unwrap_or_else(|| {
            let mut found = BTreeSet::new();
            match &self.meanings[name] {
                Meaning::Term(term) => self.reached(term, &mut found),
                Meaning::Derived(derived) => {
                    let terms = derived.terms.iter().chain(&derived.rates).chain(&derived.steady);
                    let values = derived.values.iter().map(|(_, value)| value);
                    terms.chain(values).chain(&derived.found).for_each(|one| self.reached(one, &mut found));
                    found.extend(&derived.variables);
                }
            }
            let found = Rc::new(found);
            self.reaches.borrow_mut().insert(name, Rc::clone(&found));
            found
        })
    }

    /// The variables that a term reaches, through what its names mean.
    pub fn reached(&self, term: &Term, found: &mut BTreeSet<usize>) {
        match term {
            Term::Number(_) => {}
            Term::Variable(place) => {
                found.insert(*place);
            }
            Term::Defined(name) => found.extend(self.reach_of(*name).iter()),
            Term::Sum(parts) | Term::Product(parts) => {
                parts.iter().for_each(|part| self.reached(part, found));
            }
            Term::Quotient(above, below) => {
                self.reached(above, found);
                self.reached(below, found);
            }
            Term::Negation(inner) | Term::Power(inner, _) | Term::Call(_, inner) => {
                self.reached(inner, found);
            }
            Term::Polynomial(first, inner) => {
                found.extend(self.coefficients_from(*first));
                self.reached(inner, found);
            }
        }
    }
}

/// The name of the value at 0 of a derivative of a function.
fn at_zero(function: &str, order: usize) -> String {
    format!("{function}{}(0)", "'".repeat(order))
}

/// The names with a meaning: those that equations define, the sides of equations, and definitions.
fn drafts(
    equations: &Equations,
    systems: &BTreeMap<String, System>,
    derivations: BTreeMap<String, Derivation>,
) -> BTreeMap<String, Draft> {
    let mut assumed: BTreeSet<&str> =
        equations.positive().iter().chain(equations.free()).map(String::as_str).collect();
    assumed.extend(systems.values().flat_map(|system| &system.states).map(String::as_str));
    let brings_in = derivations.values().filter(|one| one.operation == Some(Operation::Characteristic));
    let brought_in: Vec<String> =
        brings_in.filter_map(|one| Some(one.variables.first()?.as_str().to_owned())).collect();
    assumed.extend(brought_in.iter().map(String::as_str));
    let mut drafts = BTreeMap::new();
    let mut alone: BTreeMap<&str, Vec<&Expression>> = BTreeMap::new();
    for equation in equations.iter() {
        let kept = match &equation.left {
            Expression::Variable(name) if !assumed.contains(name.as_str()) => Some(name.as_str()),
            _ => None,
        };
        if let Some(name) = kept
            && !equation.right.variables().iter().any(|one| one.as_str() == EITHER_SIGN)
        {
            alone.entry(name).or_default().push(&equation.right);
        }
        let difference = Expression::Sum(vec![
            equation.left.clone(),
            Expression::Negation(Box::new(equation.right.clone())),
        ]);
        let own = kept.map(str::to_owned);
        for (side, expression, kept) in [
            ("left", equation.left.clone(), own.clone()),
            ("right", equation.right.clone(), None),
            ("residual", difference, own),
        ] {
            drafts.insert(format!("{side}_{}", equation.word()), Draft::Written(expression, kept));
        }
    }
    for (name, rights) in alone {
        if let [right] = rights[..] {
            drafts.insert(name.to_owned(), Draft::Written(right.clone(), None));
        }
    }
    drafts.extend(derivations.into_iter().map(|(name, one)| (name, Draft::Derived(one))));
    // A name that is defined by means of itself is a variable.
    let uses: BTreeMap<String, BTreeSet<String>> =
        drafts.iter().map(|(name, draft)| (name.clone(), draft.names(systems))).collect();
    drafts.retain(|name, _| !leads_back(name, &uses));
    drafts
}

fn leads_back(start: &str, uses: &BTreeMap<String, BTreeSet<String>>) -> bool {
    let (mut open, mut seen) = (vec![start], BTreeSet::new());
    while let Some(name) = open.pop() {
        for next in uses.get(name).into_iter().flatten() {
            if next == start {
                return true;
            }
            if seen.insert(next.as_str()) {
                open.push(next);
            }
        }
    }
    false
}
