//! Reading what a file defines besides its equations: conditions, systems, definitions.

mod assumptions;
mod functions;
mod systems;
mod units;

use std::collections::{BTreeMap, BTreeSet};

use assumptions::with_conditions;
pub(super) use assumptions::{assumed, positive};
pub(super) use functions::functions;

use super::definedness;
use super::derivation::{
    Form, NOT_A_NAME, Operation, System, Work, derive, is_name, read_condition, read_name,
};
use super::names::{Defined, Names, circle, defined_by_equations, distinct, in_order};
use super::notation::did_you_mean;
use super::{AssumptionsText, DefinitionText, Equation, EquationFault, FunctionText, SystemText};
use slipmode_algebra::{Condition, Domain, Expression, Proof, Symbol};

/// The most definitions of a file, and the most systems.
const MOST: usize = 200;

/// Names that have a meaning in every file.
const CONSTANTS: [&str; 2] = ["i", "pm"];

/// The rest of a file of equations.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Rest {
    pub assumptions: AssumptionsText,
    pub functions: Vec<FunctionText>,
    pub systems: Vec<SystemText>,
    pub definitions: Vec<DefinitionText>,
    pub units: BTreeMap<String, String>,
}

/// The definitions by name: as text, and read with what they are given for.
type Forms<'r> = BTreeMap<Symbol, (&'r DefinitionText, Form, Vec<Condition>)>;

/// All faults of the definitions so far.
struct Reader<'r> {
    rest: &'r Rest,
    names: Names,
    faults: Vec<EquationFault>,
}

/// The names of a file, and all faults of its definitions.
pub(super) fn names(rest: &Rest, equations: &[Equation], domain: &Domain) -> (Names, Vec<EquationFault>) {
    let names = Names { functions: functions(&rest.functions), ..Names::default() };
    let mut reader = Reader { rest, names, faults: Vec::new() };
    reader.read(equations, domain);
    (reader.names, reader.faults)
}

impl<'r> Reader<'r> {
    fn fault(&mut self, key: &str, message: impl Into<String>) {
        self.faults.push(EquationFault { key: key.to_owned(), message: message.into() });
    }

    fn read(&mut self, equations: &[Equation], domain: &Domain) {
        let rest = self.rest;
        let counts = [rest.functions.len(), rest.systems.len(), rest.definitions.len()];
        for (what, count) in ["function", "system", "definition"].into_iter().zip(counts) {
            if count > MOST {
                return self.fault(what, format!("{count} of them (allowed: at most {MOST})"));
            }
        }
        let forms = self.read_forms();
        let assumptions = rest.assumptions.positive.iter().chain(&rest.assumptions.free);
        let states = rest.systems.iter().flat_map(|system| &system.state);
        let mut assumed: BTreeSet<Symbol> =
            assumptions.chain(states).filter_map(|name| read_name(name)).collect();
        assumed.extend(forms.values().filter_map(|(_, form, _)| form.new_variable()).cloned());
        let (defined, doubled) = defined_by_equations(equations, &assumed);
        for (name, [first, second]) in doubled {
            let message = format!(
                "{name} stands alone on the left of equation {first}, too: a name has one meaning; a variable is listed in `assumptions`"
            );
            self.fault(&format!("equation {second}"), message);
        }
        self.check_names(&assumed, &defined);
        let known = self.keep_names(equations, &assumed, &defined);
        self.check_assumptions(domain);
        self.check_functions(&assumed, &defined, &forms);
        let systems = self.read_systems(&known);
        let mut uses: BTreeMap<Symbol, BTreeSet<Symbol>> =
            defined.iter().map(|(name, one)| (name.clone(), one.uses())).collect();
        for (name, (text, form, given)) in &forms {
            let used = self.used(form, given, systems.get(form.system.as_deref().unwrap_or_default()));
            self.check_form(text, form, &used, &known, &systems);
            uses.insert(name.clone(), used);
        }
        for (name, way) in forms.keys().filter_map(|name| Some((name, circle(name, &uses)?))) {
            let way: Vec<&str> = way.iter().map(Symbol::as_str).collect();
            self.fault(&format!("definition {name}"), format!("is defined by itself: {}", way.join(" -> ")));
        }
        let order = in_order(&uses);
        // What is at fault has no meaning, and neither has what uses it.
        for name in &order {
            let is_known = |used: &Symbol| self.names.has(used) || CONSTANTS.contains(&used.as_str());
            let key = format!("definition {name}");
            if self.faults.iter().any(|fault| fault.key == key) || !uses[name].iter().all(is_known) {
                continue;
            }
            if let Some(one) = defined.get(name) {
                self.define_by_equation(name, one);
            } else if let Some((text, form, given)) = forms.get(name) {
                let system = form.system.as_ref().and_then(|name| systems.get(name));
                if let Err(message) = self.define(text, form, given, system, domain) {
                    self.fault(&key_of(text), message);
                }
            }
        }
        self.check_units(equations, &defined, &forms, &systems, &order);
        self.keep_systems(systems, domain);
    }

    /// Reads the definitions and what they are given for.
    fn read_forms(&mut self) -> Forms<'r> {
        let mut forms = Forms::new();
        for text in &self.rest.definitions {
            let functions = &self.names.functions;
            let given = text.given.iter().map(|one| read_condition(one, functions));
            match (Form::read(&text.is, functions), given.collect::<Result<Vec<_>, _>>()) {
                (Ok(form), Ok(given)) => match read_name(&text.name) {
                    None => self.fault(&key_of(text), NOT_A_NAME),
                    Some(name) => {
                        if forms.insert(name, (text, form, given)).is_some() {
                            self.fault(&key_of(text), "occurs twice");
                        }
                    }
                },
                (Err(message), _) | (_, Err(message)) => self.fault(&key_of(text), message),
            }
        }
        forms
    }

    /// Each definition has a name that has no meaning yet.
    fn check_names(&mut self, assumed: &BTreeSet<Symbol>, defined: &BTreeMap<Symbol, Defined>) {
        for text in &self.rest.definitions {
            let Some(name) = read_name(&text.name) else { continue };
            let by_equation = defined.get(&name).map(|one| format!("equation {}", one.number));
            let is_assumed =
                || assumed.contains(&name).then(|| "an assumption, a state or a derivation".to_owned());
            let word = text.name.as_str();
            if let Some(taken) = by_equation.or_else(is_assumed) {
                self.fault(&key_of(text), format!("the name has a meaning by {taken}"));
            } else if CONSTANTS.contains(&word) || Operation::from_word(word).is_some() {
                self.fault(&key_of(text), NOT_A_NAME);
            }
        }
    }

    /// Keeps which names are variables, and which equations define names. All names that have a meaning.
    fn keep_names(
        &mut self,
        equations: &[Equation],
        assumed: &BTreeSet<Symbol>,
        defined: &BTreeMap<Symbol, Defined>,
    ) -> BTreeSet<Symbol> {
        let rest = self.rest;
        let in_equations = equations.iter().flat_map(|one| &one.left.variables() | &one.right.variables());
        let is_defined = |name: &Symbol| {
            defined.contains_key(name) || rest.definitions.iter().any(|text| text.name == name.as_str())
        };
        self.names.defining = defined.iter().map(|(name, one)| (name.clone(), one.number.clone())).collect();
        self.names.positive = rest.assumptions.positive.iter().filter_map(|name| read_name(name)).collect();
        self.names.variables =
            in_equations.filter(|name| !is_defined(name)).chain(assumed.iter().cloned()).collect();
        (self.names.variables.iter().chain(defined.keys()).cloned())
            .chain(rest.definitions.iter().filter_map(|text| read_name(&text.name)))
            .chain(CONSTANTS.map(Symbol::from))
            .collect()
    }

    /// A name that an equation defines, in variables. The name itself stays as it is on the equation's sides.
    fn define_by_equation(&mut self, name: &Symbol, one: &Defined) {
        let meaning = |used: &Symbol| Some((used.clone(), self.names.meaning(used)?.expression.clone()));
        let meanings = one.uses().iter().filter_map(meaning).collect();
        let resolve = |expression: &Expression| expression.substitute(&meanings);
        let given = one.given.iter();
        let given = given.map(|it| Condition { expression: resolve(&it.expression), relation: it.relation });
        let given = given.collect();
        let uses: Vec<Expression> = one.uses().into_iter().map(Expression::Variable).collect();
        let behind: Vec<&Expression> = uses.iter().chain([&one.expression]).collect();
        let expression = resolve(&one.expression);
        self.names.define(name, expression, &behind, [one.number.clone()], given, None);
    }

    /// The conditions speak of variables, and the free variables are names.
    fn check_assumptions(&mut self, domain: &Domain) {
        let unknown = domain.conditions().iter().flat_map(|one| one.expression.variables());
        let unknown: BTreeSet<Symbol> = unknown.filter(|name| !self.names.variables.contains(name)).collect();
        for name in unknown {
            let near = did_you_mean(name.as_str(), self.names.variables.iter().map(Symbol::as_str));
            self.fault("assumptions.conditions", format!("'{name}' is no variable{near}"));
        }
        let rest = self.rest;
        let is_wrong = |name: &&String| !is_name(name) || rest.assumptions.positive.contains(*name);
        for name in rest.assumptions.free.iter().filter(is_wrong) {
            self.fault("assumptions.free", format!("'{name}' is not a name, or is positive too"));
        }
    }

    /// The names that a definition uses.
    fn used(&self, form: &Form, given: &[Condition], system: Option<&System>) -> BTreeSet<Symbol> {
        let mut used = form.names();
        used.extend(given.iter().flat_map(|one| one.expression.variables()));
        let parts = system.iter().flat_map(|system| system.rates.iter().chain(&system.steady));
        used.extend(parts.flat_map(Expression::variables));
        used
    }

    fn unknown(&self, name: &str, known: &BTreeSet<Symbol>) -> String {
        let near = match did_you_mean(name, known.iter().map(Symbol::as_str)) {
            near if near.is_empty() => {
                "; `positive` and `free` of [assumptions] list the variables".to_owned()
            }
            near => near,
        };
        format!("'{name}' is no variable and no defined name of equations.toml{near}")
    }

    fn check_form(
        &mut self,
        text: &DefinitionText,
        form: &Form,
        used: &BTreeSet<Symbol>,
        known: &BTreeSet<Symbol>,
        systems: &BTreeMap<String, System>,
    ) {
        let others: BTreeSet<Symbol> =
            known.iter().filter(|name| name.as_str() != text.name).cloned().collect();
        let mut messages: Vec<String> = used
            .iter()
            .filter(|name| !known.contains(*name))
            .map(|name| self.unknown(name.as_str(), &others))
            .collect();
        let is_missing = |name: &&String| !self.rest.systems.iter().any(|one| one.name == **name);
        if let Some(name) = form.system.as_ref().filter(is_missing) {
            let near = did_you_mean(name, systems.keys().map(String::as_str));
            messages.push(format!("there is no system '{name}'{near}"));
        }
        let variables = form.variables.iter().chain(form.values.iter().map(|(name, _)| name));
        for name in variables.filter(|name| !self.names.variables.contains(*name)) {
            if !known.contains(name) && !used.contains(name) {
                messages.push(self.unknown(name.as_str(), &others));
            } else if known.contains(name) {
                messages.push(format!("'{name}' has a meaning of its own and is no variable"));
            }
        }
        if !messages.is_empty() {
            self.fault(&key_of(text), messages.join("; "));
        }
    }

    /// Works out a definition whose names all have a meaning.
    fn define(
        &mut self,
        text: &DefinitionText,
        form: &Form,
        given: &[Condition],
        system: Option<&System>,
        domain: &Domain,
    ) -> Result<(), String> {
        if form.system.is_some() && system.is_none() {
            // The system is at fault, which was said.
            return Err("its system is at fault".to_owned());
        }
        let names = &self.names;
        let mut behind: Vec<&Expression> = form.all_expressions().collect();
        behind.extend(system.iter().flat_map(|system| system.rates.iter().chain(&system.steady)));
        behind.extend(given.iter().map(|one| &one.expression));
        let given: Vec<Condition> = given.iter().map(|one| names.resolved_condition(one)).collect();
        let inherited = behind.iter().flat_map(|expression| names.given_of(expression)).cloned();
        let more = distinct(given.iter().cloned().chain(inherited));
        let domain = with_conditions(domain.clone(), &more)?;
        let resolve = |expression: &Expression| names.resolved(expression);
        if let Some(unmet) = definedness::unmet(&form.demands, &domain, &resolve) {
            return Err(unmet);
        }
        let sources: BTreeSet<String> =
            (behind.iter().flat_map(|one| names.equations_of(one)).map(str::to_owned))
                .chain(system.map(|system| format!("system {}", system.name)))
                .collect();
        let sources: Vec<String> = sources.into_iter().collect();
        let resolved = Form {
            expressions: form.expressions.iter().map(resolve).collect(),
            values: form.values.iter().map(|(name, value)| (name.clone(), resolve(value))).collect(),
            ..form.clone()
        };
        let system = system.map(|system| system.map(resolve));
        let proof = Proof::new(
            &format!("definition-{}", text.name.to_lowercase()),
            format!("{} = {}.", text.name, text.is.trim()),
        );
        let mut work = Work { domain, proof, equations: &sources };
        let found = derive(&resolved, system.as_ref(), &mut work)?;
        work.has_value(&found).map_err(|error| format!("has no value under the assumptions: {error}"))?;
        let proof = Some(work.proof).filter(|proof| !proof.steps.is_empty());
        if let Some(name) = read_name(&text.name) {
            self.names.define(&name, found, &behind, sources.clone(), given, proof);
        }
        Ok(())
    }
}

fn key_of(text: &DefinitionText) -> String {
    format!("definition {}", text.name)
}
