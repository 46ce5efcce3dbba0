//! Certificates that literals contradict each other under the premises of a formula.

use std::cell::Cell;
use std::collections::BTreeSet;

use slipmode_algebra::{
    Certificate, Condition, ConversionError, Domain, Expression, Extent, Function, Literal, Monomial,
    Polynomial, Proof, Refutation, Relation, Sign, Symbol,
};
use slipmode_core::number::Rational;

use super::points::Points;
use crate::scene::Premises;

/// A step of a proof: its words and its certificate.
pub(super) type Draft = (String, Certificate);

/// The proof with these steps, each with these words before its own.
pub(super) fn certify_all(
    proof: Proof,
    before: &str,
    equations: &[&str],
    steps: Vec<Draft>,
) -> Result<Proof, Refutation> {
    let add = |proof: Proof, (says, certificate): Draft| {
        proof.certify(&format!("{before}{says}"), equations, certificate)
    };
    steps.into_iter().try_fold(proof, add)
}

/// What an expression may come to in a form of the conditions.
const LARGEST: Extent = Extent { terms: 4000, degree: 200, bits: 1 << 16 };

/// The longest expression that stands in the words of a step; its certificate has it in full.
const LONGEST_WORDS: usize = 60;

/// The longest condition, in characters, that the wider search uses.
const LONGEST_CONDITION: usize = 120;

/// The most parts of a sum that are tried.
const MOST_PARTS: usize = 16;

/// How often a case is divided into two.
const MOST_DIVISIONS: usize = 8;

/// For how many names an equation is solved besides the first.
const OTHER_NAMES: usize = 6;

/// The highest derivative that shows that something grows.
const MOST_ORDER: u32 = 3;

/// Looks for certificates, with a bound on the work.
pub(super) struct Prover<'p> {
    points: &'p Points,
    /// How many expressions were looked at, in the usual search and in the wider ones.
    attempts: [Cell<usize>; 3],
    /// Whether other searches follow where the usual one does not succeed.
    is_wide: bool,
    search: Cell<Search>,
}

/// Where certificates are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Search {
    /// In the forms of [`Domain::forms`].
    Usual,
    /// Among sums with a condition.
    Sums,
    /// In the forms of [`Domain::forms_in_way`].
    Way(u8),
    /// In the usual forms, with equations solved for another one of their names: the first is that of the usual search.
    Names(usize),
}

impl<'p> Prover<'p> {
    /// The most expressions in forms of the conditions of which the sign is looked at, in the usual search and in the wider ones.
    const MOST_OF_EACH: [usize; 3] = [400, 3600, 1600];
    /// The most in the usual one.
    pub const MOST: usize = Self::MOST_OF_EACH[0];

    /// The usual search, or one that goes on in other ways.
    pub fn new(points: &'p Points, is_wide: bool) -> Self {
        Self { points, attempts: Default::default(), is_wide, search: Cell::new(Search::Usual) }
    }

    /// How many expressions were looked at in the usual search.
    pub fn attempts(&self) -> usize {
        self.attempts[0].get()
    }

    /// Notes one more expression that is looked at, if the work allows it.
    fn attempt(&self) -> bool {
        let search = match self.search.get() {
            Search::Usual => 0,
            Search::Sums | Search::Way(_) => 1,
            Search::Names(_) => 2,
        };
        let made = &self.attempts[search];
        made.set(made.get() + 1);
        made.get() <= Self::MOST_OF_EACH[search]
    }

    /// That a clause is true: the negations of its literals contradict each other.
    pub fn clause(&self, premises: &Premises, clause: &[Literal]) -> Option<Vec<Draft>> {
        let negated: Vec<Literal> = clause.iter().map(Literal::negated).collect();
        let search = |search: Search| {
            self.search.set(search);
            self.contradiction(premises, negated.clone(), MOST_DIVISIONS)
        };
        let others = [Search::Sums].into_iter().chain((0..Domain::WAYS).map(Search::Way));
        let others = others.chain((1..=OTHER_NAMES).map(Search::Names));
        let found = search(Search::Usual).or_else(|| others.filter(|_| self.is_wide).find_map(search));
        self.search.set(Search::Usual);
        found
    }

    /// That no point meets the premises and the literals.
    pub fn contradiction(
        &self,
        premises: &Premises,
        literals: Vec<Literal>,
        divisions: usize,
    ) -> Option<Vec<Draft>> {
        let (mut premises, mut steps) = (premises.clone(), Vec::new());
        let Some(literals) = self.solved(&mut premises, literals, &mut steps)? else { return Some(steps) };
        if let Some(found) = self.negated(&premises, &literals) {
            steps.extend(found);
            return Some(steps);
        }
        let all = || literals.iter().chain(&premises.conditions);
        let open = all().find(|literal| matches!(literal.sign, Sign::NonNegative | Sign::NonZero));
        // Two cases: the expression is positive or zero, positive or negative, negative or not.
        let case = |expression: &Expression, sign| Literal::new(expression.clone(), sign);
        let divided = match open {
            Some(Literal { expression, sign: Sign::NonNegative }) => {
                [Sign::Positive, Sign::Zero].map(|sign| case(expression, sign))
            }
            Some(Literal { expression, .. }) => {
                [expression, &-expression.clone()].map(|side| case(side, Sign::Positive))
            }
            None => {
                let assumed = Premises { conditions: all().cloned().collect(), ..premises.clone() }.domain();
                let inner = all().flat_map(|literal| open_absolutes(&literal.expression, &assumed));
                // The sign of a product is known from those of its factors.
                let inner = inner.min_by_key(|inner| inner.to_string().len())?;
                [case(&inner, Sign::NonNegative), case(&-inner, Sign::Positive)]
            }
        };
        let left = divisions.checked_sub(1)?;
        for case in divided {
            let mut premises = premises.clone();
            premises.conditions.retain(|known| Some(known) != open);
            let others =
                literals.iter().filter(|known| Some(*known) != open).cloned().chain([case]).collect();
            steps.extend(self.contradiction(&premises, others, left)?);
        }
        Some(steps)
    }

    /// The literals with every equation solved and put in. None without a proof of a step; an inner none when one is false.
    #[allow(clippy::option_option)]
    fn solved(
        &self,
        premises: &mut Premises,
        literals: Vec<Literal>,
        steps: &mut Vec<Draft>,
    ) -> Option<Option<Vec<Literal>>> {
        let mut rest = literals;
        let other = if let Search::Names(other) = self.search.get() { other } else { 0 };
        loop {
            let equation = rest.iter().enumerate().filter(|(_, literal)| literal.sign == Sign::Zero);
            let found = equation.into_iter().find_map(|(at, literal)| {
                let names = literal.expression.variables().into_iter();
                let mut solved = names.filter_map(|name| premises.solve(&literal.expression, &name));
                let first = solved.next()?;
                Some((at, solved.take(other).last().unwrap_or(first)))
            });
            let Some((at, solved)) = found else { break };
            rest.remove(at);
            let domain = self.domain(premises, &[])?;
            let (name, value) = (Expression::Variable(solved.variable.clone()), solved.value.clone());
            let left = solved.expression.clone() / solved.slope.clone();
            let says =
                format!("{} is zero exactly for {name} = {}", short(&solved.expression), short(&value));
            steps.push((says, self.certified(Certificate::Identity { left, right: name - value, domain })?));
            let replaced = |literal: &Literal| {
                Literal::new(literal.expression.with(&solved.variable, &solved.value), literal.sign)
            };
            rest = rest.iter().map(replaced).collect();
            let assumed = premises.conditions.iter().map(replaced);
            let positive = premises.positive.contains(&solved.variable);
            let own = positive.then(|| Literal::new(solved.value.clone(), Sign::Positive));
            let all: Vec<Literal> = assumed.chain(own).collect();
            let constant =
                all.iter().find_map(|literal| self.impossible(premises, literal, Some(&solved.variable)));
            if let Some(step) = constant {
                steps.push(step);
                return Some(None);
            }
            premises.put(solved).ok()?;
        }
        if let Some(step) = rest.iter().find_map(|literal| self.impossible(premises, literal, None)) {
            steps.push(step);
            return Some(None);
        }
        let constant =
            |literal: &Literal| premises.domain().rational_function(&literal.expression).ok()?.as_constant();
        rest.retain(|literal| constant(literal).is_none());
        Some(Some(rest))
    }

    /// The step that a literal compares a number with zero, and is false.
    fn impossible(&self, premises: &Premises, literal: &Literal, without: Option<&Symbol>) -> Option<Draft> {
        let mut premises = premises.clone();
        if let Some(without) = without {
            premises.positive.remove(without);
            premises.conditions.retain(|condition| !condition.expression.variables().contains(without));
        }
        let value = premises.domain().rational_function(&literal.expression).ok()?.as_constant()?;
        if literal.sign.admits(value.cmp0()) {
            return None;
        }
        let right = Expression::Number(value);
        let says = format!("{} is {right} there: this case does not occur", short(&literal.expression));
        let domain = self.domain(&premises, &[])?;
        let certificate = Certificate::Identity { left: literal.expression.clone(), right, domain };
        Some((says, self.certified(certificate)?))
    }

    /// The negation of one literal from the others and the premises, or that of a premise.
    fn negated(&self, premises: &Premises, literals: &[Literal]) -> Option<Vec<Draft>> {
        let others = |at: usize| [&literals[..at], &literals[at + 1..]].concat();
        let goals = literals
            .iter()
            .enumerate()
            .find_map(|(at, literal)| self.shown_by_some(&literal.negated(), premises, &others(at)));
        goals.or_else(|| {
            premises.conditions.iter().enumerate().find_map(|(at, condition)| {
                let mut premises = premises.clone();
                premises.conditions.remove(at);
                self.shown_by_some(&condition.negated(), &premises, literals)
            })
        })
    }

    /// The goal from the premises and all of the literals, or from as many of them as have an example.
    fn shown_by_some(&self, goal: &Literal, premises: &Premises, literals: &[Literal]) -> Option<Vec<Draft>> {
        if let Search::Way(_) = self.search.get() {
            // Long conditions cost much and help little.
            let short = |all: &[Literal]| all.iter().filter(|one| is_short(one)).cloned().collect::<Vec<_>>();
            let premises = Premises { conditions: short(&premises.conditions), ..premises.clone() };
            let literals = short(literals);
            return self.goal(goal, &self.domain(&premises, &literals)?, &literals);
        }
        if let Some(domain) = self.domain(premises, literals) {
            return self.goal(goal, &domain, literals);
        }
        let alone = self.domain(premises, &[]);
        alone.and_then(|domain| self.goal(goal, &domain, &[])).or_else(|| {
            literals.iter().find_map(|one| {
                let one = std::slice::from_ref(one);
                self.goal(goal, &self.domain(premises, one)?, one)
            })
        })
    }

    /// The premises and literals as a domain with an example; none where no example is found.
    pub fn domain(&self, premises: &Premises, literals: &[Literal]) -> Option<Domain> {
        let mut assumed = premises.clone();
        assumed.conditions.extend(literals.iter().filter(|literal| literal.sign != Sign::Zero).cloned());
        let expressions = || assumed.conditions.iter().map(|literal| &literal.expression);
        let point = self.points.example(&assumed.conditions)?;
        let named: BTreeSet<Symbol> = expressions().flat_map(Expression::variables).collect();
        let functions: BTreeSet<Symbol> = expressions().flat_map(Expression::functions).collect();
        let values = point.into_iter().filter(|(name, _)| match name.function_at_zero() {
            None => named.contains(name),
            Some(function) => functions.contains(&function.undifferentiated()),
        });
        Some(
            values.fold(assumed.domain(), |domain, (name, value)| {
                domain.example(name, Expression::Number(value))
            }),
        )
    }

    /// A condition under the assumptions of a domain.
    pub fn fact(&self, condition: &Condition, domain: &Domain) -> Option<Vec<Draft>> {
        self.goal(&Literal::new(condition.expression.clone(), condition.relation.into()), domain, &[])
    }

    /// A literal under the assumptions of a domain; `from` is named in the words of the steps.
    fn goal(&self, goal: &Literal, domain: &Domain, from: &[Literal]) -> Option<Vec<Draft>> {
        let given: Vec<String> = from.iter().map(words).collect();
        let given = if given.is_empty() { String::new() } else { format!(", where {}", given.join(" and ")) };
        let says = format!("{}{given}", words(goal));
        let mut steps = self.shown(goal, domain, 2)?;
        if let Some((own, _)) = steps.last_mut() {
            *own = says;
        }
        Some(steps)
    }

    fn shown(&self, goal: &Literal, domain: &Domain, depth: usize) -> Option<Vec<Draft>> {
        let Literal { expression, sign } = goal;
        let sides = std::slice::from_ref(expression);
        let forms = match self.search.get() {
            Search::Usual | Search::Names(_) => domain.forms(sides),
            Search::Sums => return self.by_sum(goal, domain),
            Search::Way(way) => domain.forms_in_way(way, sides),
        };
        let opposite = -expression.clone();
        let identity = |left: Expression, right: Expression| {
            forms.iter().find_map(|form| {
                let equal = self.counted(&left, form)
                    && form.difference(&left, &right).is_ok_and(|rest| rest.is_zero());
                let certificate = || Certificate::Identity {
                    left: left.clone(),
                    right: right.clone(),
                    domain: form.clone(),
                };
                equal.then(|| self.certified(certificate())).flatten()
            })
        };
        let positive = |expression: &Expression| {
            forms
                .iter()
                .find_map(|form| self.positive(expression, form))
                .or_else(|| self.by_quotient(expression, domain))
                .or_else(|| self.by_growth(expression, domain))
        };
        let single = |certificate: Certificate| vec![(words(goal), certificate)];
        let zero = Expression::integer(0);
        match sign {
            Sign::Zero => identity(expression.clone(), zero).map(single),
            Sign::Positive => {
                positive(expression).map(single).or_else(|| self.by_squares(goal, domain, depth))
            }
            Sign::NonNegative => {
                let root = expression.clone().call(Function::Sqrt).power(2);
                let direct = positive(expression).or_else(|| identity(root, expression.clone()));
                direct.map(single).or_else(|| self.by_squares(goal, domain, depth))
            }
            Sign::NonZero => {
                let inverse = expression.clone() * expression.clone().power(-1);
                let direct = positive(expression).or_else(|| positive(&opposite));
                direct.or_else(|| identity(inverse, Expression::integer(1))).map(single)
            }
        }
    }

    /// Whether the work allows one more expression, and it is not too large in a form of the conditions.
    fn counted(&self, expression: &Expression, form: &Domain) -> bool {
        let is_small = || form.substituted(expression).check_extent(LARGEST).is_ok();
        self.attempt() && (matches!(self.search.get(), Search::Sums | Search::Way(_)) || is_small())
    }

    fn positive(&self, expression: &Expression, form: &Domain) -> Option<Certificate> {
        let is_positive = self.counted(expression, form) && form.sign(expression) == Ok(Some(1));
        let certificate =
            || Certificate::Sign { expression: expression.clone(), sign: 1, domain: form.clone() };
        is_positive.then(|| self.certified(certificate())).flatten()
    }

    /// The quotient by a condition that is positive has the sign of the expression.
    fn by_quotient(&self, expression: &Expression, domain: &Domain) -> Option<Certificate> {
        let positive =
            domain.conditions().iter().filter(|condition| condition.relation == Relation::Positive);
        let mut quotients = positive.map(|condition| expression.clone() / condition.expression.clone());
        quotients.find_map(|quotient| self.positive(&quotient, domain))
    }

    /// What is zero where a positive variable is zero, and then grows. Only functions need it.
    fn by_growth(&self, expression: &Expression, domain: &Domain) -> Option<Certificate> {
        let function = domain.rational_function(expression).ok()?;
        let grows = |name: &Symbol| domain.is_positive(name) && function.hides(name).is_some();
        let names: Vec<Symbol> = function.variables().into_iter().filter(grows).collect();
        names.into_iter().find_map(|variable| {
            (1..=MOST_ORDER).find_map(|order| {
                let (expression, domain) = (expression.clone(), domain.clone());
                self.attempt().then_some(())?;
                self.certified(Certificate::Growth { expression, variable: variable.clone(), order, domain })
            })
        })
    }

    /// 4A(A x² + B x + C) = (2A x + B)² + 4AC − B², where A and 4AC − B² are positive.
    fn by_squares(&self, goal: &Literal, domain: &Domain, depth: usize) -> Option<Vec<Draft>> {
        let depth = depth.checked_sub(1)?;
        let function = domain.rational_function(&goal.expression).ok()?;
        let squared = |name: &Symbol| function.numerator().degree(name) == 2;
        function.numerator().variables().into_iter().filter(squared).find_map(|name| {
            if function.denominator().degree(&name) > 0 || function.hides(&name).is_some() {
                return None;
            }
            let below = Expression::from(function.denominator());
            let [c, b, a]: [Expression; 3] = function
                .numerator()
                .coefficients(&name)
                .iter()
                .map(|one| Expression::from(one) / below.clone())
                .collect::<Vec<_>>()
                .try_into()
                .ok()?;
            let four = || Expression::integer(4);
            let rest = four() * a.clone() * c - b.clone().power(2);
            let square =
                (Expression::integer(2) * a.clone() * Expression::Variable(name.clone()) + b).power(2);
            let mut steps = self.shown(&Literal::new(a.clone(), Sign::Positive), domain, depth)?;
            steps.extend(self.shown(&Literal::new(rest.clone(), goal.sign), domain, depth)?);
            let (left, right) = (four() * a * goal.expression.clone(), square + rest);
            let certificate = Certificate::Identity { left, right, domain: domain.clone() };
            steps.push((words(goal), self.certified(certificate)?));
            Some(steps)
        })
    }

    /// What is a positive multiple of a condition and something positive; or its product with a condition is.
    fn by_sum(&self, goal: &Literal, domain: &Domain) -> Option<Vec<Draft>> {
        matches!(goal.sign, Sign::Positive | Sign::NonNegative).then_some(())?;
        let positive = || {
            let all = domain.conditions().iter();
            all.filter(|one| one.relation == Relation::Positive).map(|one| one.expression.clone())
        };
        let wholes = positive().map(|condition| goal.expression.clone() * condition);
        [goal.expression.clone()].into_iter().chain(wholes).find_map(|whole| {
            let parts = positive().flat_map(|condition| {
                let factors = factors(&whole, &condition, domain).into_iter();
                factors.map(move |factor| factor * condition.clone())
            });
            parts.take(MOST_PARTS).find_map(|part| {
                let rest = whole.clone() - part.clone();
                let of_rest = self.positive(&rest, domain)?;
                let of_part = self.positive(&part, domain)?;
                let (left, right) = (whole.clone(), part.clone() + rest.clone());
                let sum = Certificate::Identity { left, right, domain: domain.clone() };
                let says = |one: Expression| words(&Literal::new(one, Sign::Positive));
                Some(vec![(says(part), of_part), (says(rest), of_rest), (words(goal), self.certified(sum)?)])
            })
        })
    }

    /// The certificate, if its check succeeds.
    pub fn certified(&self, certificate: Certificate) -> Option<Certificate> {
        let proof = Proof::new("attempt", "").certify("", &[], certificate).ok()?;
        proof.steps.into_iter().next()?.certificate
    }
}

/// Positive factors with which a part has a term of the whole.
fn factors(whole: &Expression, part: &Expression, domain: &Domain) -> Vec<Expression> {
    let [Ok(whole), Ok(part)] = [whole, part].map(|one| domain.rational_function(one)) else {
        return Vec::new();
    };
    // Over one denominator.
    let (above, below) = (whole.numerator() * part.denominator(), part.numerator() * whole.denominator());
    let factor = |(term, number): (&Monomial, &Rational)| {
        below
            .terms()
            .filter_map(move |(other, divisor)| {
                let quotient = Polynomial::term(number.clone() / divisor.clone(), term.divided_by(other)?);
                let factor = Expression::from(&quotient);
                (domain.sign(&factor) == Ok(Some(1))).then_some(factor)
            })
            .collect::<Vec<_>>()
    };
    let mut found: Vec<Expression> = Vec::new();
    for factor in above.terms().flat_map(factor) {
        if !found.contains(&factor) {
            found.push(factor);
        }
    }
    found
}

/// What has an absolute value in an expression although its sign is open.
pub(super) fn open_absolutes(expression: &Expression, domain: &Domain) -> Vec<Expression> {
    let is_open = || matches!(domain.rational_function(expression), Err(ConversionError::OpenSign(_)));
    let own = match expression {
        Expression::Call(Function::Abs, inner) if is_open() => Some((**inner).clone()),
        _ => None,
    };
    own.into_iter().chain(expression.parts().flat_map(|part| open_absolutes(part, domain))).collect()
}

/// Whether the wider search uses a condition.
fn is_short(condition: &Literal) -> bool {
    condition.expression.to_string().len() <= LONGEST_CONDITION
}

/// An expression for the words of a step.
fn short(expression: &Expression) -> String {
    let text = expression.to_string();
    if text.chars().count() > LONGEST_WORDS { "the expression".into() } else { text }
}

/// A literal in words.
fn words(literal: &Literal) -> String {
    format!("{}{}", short(&literal.expression), literal.sign.as_str())
}
