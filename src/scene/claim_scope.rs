//! The keys of a claim, a part or a reading's part that state a formula and over what it is said.

use slipmode_algebra::Symbol;
use slipmode_core::number::{DecimalError, Rational, parse_quotient};
use slipmode_theory::Equations;

use crate::scene::Problem;
use crate::scene::claim_computed::{ComputedEntries, Known};
use crate::scene::claim_formula::grammar::{read_side, read_variable};
use crate::scene::claim_formula::{ClaimFormula, FormulaCondition, FormulaLimit, OverRows, Scope};
use crate::scene::claim_motion::ClaimMotion;
use crate::scene::claim_names::Names;
use crate::scene::section::{Entries, Entry, Section};

/// What says over what a formula is said.
const SCOPE: [&str; 11] =
    ["rows", "numbers", "at_least", "limit", "outside", "given", "there_is", "witness", "box", "at", "moves"];

/// The entries that state one formula, or what is said of the motions of a system.
pub(super) struct FormulaEntries<'t> {
    formula: Option<Entry<'t>>,
    motion: Option<Entry<'t>>,
    scope: Entries<'t>,
    computed: ComputedEntries<'t>,
}

impl<'t> FormulaEntries<'t> {
    pub fn of(section: &mut Section<'t>) -> Self {
        let [formula, motion] = ["formula", "motion"].map(|key| section.optional(key));
        let scope = section.entries(&SCOPE);
        Self { formula, motion, scope, computed: ComputedEntries::of(section) }
    }

    /// Whether something is stated.
    pub fn is_stated(&self) -> bool {
        self.formula.is_some() || self.motion.is_some() || self.computed.is_stated()
    }

    /// What says over what the formula is said.
    pub fn scope(&self) -> impl Iterator<Item = &Entry<'t>> {
        self.scope.iter().chain(self.computed.first())
    }

    /// Refuses a scope without a formula beside it.
    pub fn no_scope(&self) -> Option<()> {
        match self.scope().next() {
            None => Some(()),
            Some(entry) => entry.needs("`formula` beside it: each part has its own"),
        }
    }

    /// The formula over its scope, with its limit.
    pub fn read(&self, known: &Known<'_>) -> Option<ClaimFormula> {
        let limit = match (self.scope.get("limit"), self.scope.get("outside")) {
            (None, None) => None,
            (Some(limit), Some(outside)) => {
                let (words, formula) =
                    outside.table(|outside| (outside.text("words", "a text"), Self::of(outside)))?;
                Some(Box::new(FormulaLimit { words: limit.text()?, outside: (words, formula.read(known)?) }))
            }
            (limit, outside) => return limit.or(outside)?.needs("`limit` and `outside` beside each other"),
        };
        Some(ClaimFormula { limit, ..self.read_alone(known)? })
    }

    /// The formula over its scope; all faults of the scope are found first.
    fn read_alone(&self, known: &Known<'_>) -> Option<ClaimFormula> {
        let equations = known.equations;
        let rows = self.scope.get("rows");
        if let Some(first) = self.computed.first().filter(|_| rows.is_none() || !self.computed.is_extent()) {
            let needs = match (&self.formula, &self.motion, rows) {
                (None, None, None) if self.computed.is_stated() => {
                    return Some(ClaimFormula::of_computed(self.computed.read(known)));
                }
                (None, None, None) => "`check`, `proofs` or `premises` beside it",
                _ => "no formula beside it: it has a part of its own",
            };
            return first.needs(needs);
        }
        if let Some(motion) = &self.motion {
            return self.read_motion(motion, equations?);
        }
        let formula = self.formula.as_ref()?;
        let text = formula.text()?;
        let [numbers, at_least] = ["numbers", "at_least"].map(|key| self.scope.get(key));
        if let Some(rows) = rows {
            let of =
                |members: &Entry<'_>| members.members(|name, member| Some((name.to_owned(), member.text()?)));
            let numbers = numbers.and_then(of).into_iter().flatten().collect();
            let at_least = at_least.map_or(Some(0), |least| least.whole(1..=u64::MAX))?;
            let rows = OverRows { table: rows.text()?, numbers, at_least, extent: self.computed.extent() };
            return match SCOPE[5..].iter().find_map(|key| self.scope.get(key)) {
                Some(entry) => entry.needs("no `rows` beside it: write the condition after `where`"),
                None => Some(ClaimFormula {
                    text: text.trim().into(),
                    rows: Some(rows),
                    ..ClaimFormula::default()
                }),
            };
        }
        if let Some(of_rows) = numbers.or(at_least) {
            return of_rows.needs("`rows` beside it: the table that it is about");
        }
        let equations = equations?;
        let scope = self.read_whole_scope(equations)?;
        formula.equation(ClaimFormula::read(&text, scope, equations))
    }

    /// What is said of the motions of a system.
    fn read_motion(&self, motion: &Entry<'_>, equations: &Equations) -> Option<ClaimFormula> {
        if self.formula.is_some() || self.scope.get("rows").is_some() {
            return motion.needs("no `formula` and no `rows` beside it");
        }
        let (scope, said) = (self.read_whole_scope(equations), ClaimMotion::read(motion, equations));
        motion.equation(ClaimFormula::of_motion(said?, scope?, equations))
    }

    /// The scope with the conditions of the file, which hold for every claim; they were read with it.
    fn read_whole_scope(&self, equations: &Equations) -> Option<Scope> {
        let names = Names::of(equations);
        let mut scope = self.read_scope(&names)?;
        let of_file = equations.conditions().iter();
        let of_file = of_file.filter_map(|text| FormulaCondition::read(text, &names).ok());
        scope.given = of_file.chain(scope.given).collect();
        Some(scope)
    }

    fn read_scope(&self, names: &Names) -> Option<Scope> {
        fn all<'e, 't, T>(
            entry: Option<&'e Entry<'t>>,
            read: impl Fn(&'e Entry<'t>) -> Option<Vec<T>>,
        ) -> Option<Vec<T>> {
            entry.map_or(Some(Vec::new()), read)
        }
        let variable = |name: &str, entry: &Entry<'_>| entry.equation(read_variable(name, names));
        let given = all(self.scope.get("given"), |entry| {
            entry.list(|member| member.equation(FormulaCondition::read(&member.text()?, names)))
        });
        let [there_is, moves] = ["there_is", "moves"].map(|key| {
            all(self.scope.get(key), |entry| {
                entry
                    .distinct(|name: &Symbol| format!("`{name}`"), |member| variable(&member.text()?, member))
            })
        });
        let witness = all(self.scope.get("witness"), |entry| {
            entry.members(|name, member| {
                let value = member.equation(read_side(&member.text()?, names));
                let Some(known) = there_is.iter().flatten().find(|known| known.as_str() == name) else {
                    return member.needs(format!("`{name}` in `there_is`"));
                };
                Some((known.clone(), value?))
            })
        });
        let within = all(self.scope.get("box"), |entry| {
            entry.members(|name, member| {
                let name = variable(name, member);
                match <[Rational; 2]>::try_from(member.list(number)?) {
                    Ok([low, high]) if low < high => Some((name?, [low, high])),
                    _ => member.needs("two numbers, the smaller one first"),
                }
            })
        });
        let at = all(self.scope.get("at"), |entry| {
            entry.members(|name, member| {
                let value = (variable(name, member)?, number(member)?);
                let elsewhere =
                    within.iter().flatten().map(|(name, _)| name).chain(there_is.iter().flatten());
                match elsewhere.into_iter().any(|known| known.as_str() == name) {
                    true => member.needs("no `box` and no `there_is` for the same variable"),
                    false => Some(value),
                }
            })
        });
        Some(Scope {
            given: given?,
            there_is: there_is?,
            witness: witness?,
            within: within?,
            moves: moves?,
            at: at?,
        })
    }
}

/// An exact number, written as a decimal or as a quotient of two.
pub(super) fn number(entry: &Entry<'_>) -> Option<Rational> {
    entry.number(|text| {
        parse_quotient(text).map_err(|error| match error {
            DecimalError::DivisionByZero => Problem::Equation(error.to_string()),
            _ => Problem::Equation(format!("'{}' is {error}", text.trim())),
        })
    })
}
