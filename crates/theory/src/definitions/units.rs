//! The units of a file: every equation, system and definition is checked.

use std::collections::{BTreeMap, BTreeSet};

use super::{Forms, Reader};
use crate::Equation;
use crate::derivation::{Form, Operation, System, read_name};
use crate::names::Defined;
use crate::units::{Dimension, Units};
use slipmode_algebra::{Condition, Expression, Symbol};

impl Reader<'_> {
    /// Checks the units of the file, where it has any: those of the variables are stated, the others follow.
    pub(super) fn check_units(
        &mut self,
        equations: &[Equation],
        defined: &BTreeMap<Symbol, Defined>,
        forms: &Forms<'_>,
        systems: &BTreeMap<String, System>,
        order: &[Symbol],
    ) {
        if self.rest.units.is_empty() {
            return;
        }
        let Some(mut units) = self.stated_units() else { return };
        let mut faults: Vec<(String, String)> = Vec::new();
        let conditions = &self.rest.assumptions.conditions;
        for text in conditions {
            let read = crate::derivation::read_condition(text, &self.names.functions);
            if let Some(Err(message)) = read.ok().map(|condition| units.of(&condition.expression)) {
                faults.push(("assumptions.conditions".to_owned(), message));
            }
        }
        let mut of_systems: BTreeSet<&str> = BTreeSet::new();
        for name in order.iter().filter(|name| self.names.has(name)) {
            let (key, found) = if let Some(one) = defined.get(name) {
                let equation = equations.iter().find(|equation| equation.number == one.number);
                let own = units.of(&one.expression);
                let found = match (&one.kept, equation) {
                    // The sides of an equation that defines a name have the unit of that name, which may be known only from the other side.
                    (Some(_), Some(equation)) if own.is_err() => units.of(&equation.right),
                    _ => own,
                };
                (format!("equation {}", one.number), found)
            } else if let Some((text, form, given)) = forms.get(name) {
                let system = form.system.as_ref().and_then(|name| systems.get(name));
                if let Some(system) = system.filter(|system| of_systems.insert(&system.name)) {
                    faults.extend(fault_of_system(system, &units));
                }
                let found =
                    self.names.meaning(name).map_or(Expression::integer(0), |one| one.expression.clone());
                (format!("definition {}", text.name), of_form(form, given, system, &found, &units))
            } else {
                continue;
            };
            let found = found.unwrap_or_else(|message| {
                faults.push((key, message));
                None
            });
            units.0.insert(name.clone(), found);
        }
        for system in systems.values().filter(|system| !of_systems.contains(system.name.as_str())) {
            faults.extend(fault_of_system(system, &units));
        }
        for equation in equations {
            let sides = units.same(&equation.left, &equation.right);
            let given = equation.given.iter().try_for_each(|one| units.of(&one.expression).map(|_| ()));
            let fault = sides.and(given).err();
            faults.extend(fault.map(|message| (format!("equation {}", equation.number), message)));
        }
        self.report_units(equations, faults);
        self.names.units = Some(units);
    }

    /// Reports each fault once, with a hint where the left side of an equation has no unit.
    fn report_units(&mut self, equations: &[Equation], faults: Vec<(String, String)>) {
        let mut said = BTreeSet::new();
        // An equation contains variables only, so that it is shown as the paper has it.
        let is_left = |message: &str| {
            equations.iter().find(|one| message.ends_with(&format!("'{}' has no unit", one.left)))
        };
        for (key, message) in faults.into_iter().filter(|fault| said.insert(fault.clone())) {
            let equation = is_left(&message).filter(|_| key.starts_with("equation"));
            let hint = equation.map_or(String::new(), |one| {
                format!(
                    ": write the right side of equation {} in its place, or use a [[definition]]",
                    one.number
                )
            });
            self.fault(&key, message + &hint);
        }
    }

    /// The units of the variables as stated; none when some are at fault.
    fn stated_units(&mut self) -> Option<Units> {
        let rest = self.rest;
        let mut units = Units::default();
        let before = self.faults.len();
        for (name, text) in &rest.units {
            let is_known = |symbol: &Symbol| {
                self.names.variables.contains(symbol) || self.names.functions.contains(symbol)
            };
            let symbol = read_name(name).filter(is_known);
            match (Dimension::read(text), symbol) {
                (Err(message), _) => self.fault(&format!("units.{name}"), message),
                (Ok(_), None) => {
                    let message = self.unknown(name, &self.names.variables);
                    self.fault(&format!("units.{name}"), message);
                }
                (Ok(unit), Some(symbol)) => {
                    units.0.insert(symbol, Some(unit));
                }
            }
        }
        let constants = ["i", "pm"];
        let is_stated = |name: &&Symbol| {
            constants.contains(&name.base()) || rest.units.keys().any(|known| known == name.base())
        };
        let lacking: BTreeSet<String> = (self.names.variables.iter())
            .chain(&self.names.functions)
            .filter(|name| !is_stated(name))
            .map(|name| name.base().to_owned())
            .collect();
        for name in lacking {
            self.fault(
                &format!("units.{name}"),
                "missing: every variable of the file has a unit, or none has",
            );
        }
        for text in &rest.functions {
            let of = text.of.as_ref().and_then(|of| units.0.get(&read_name(of)?)?.clone());
            units.1.extend(read_name(&text.name).zip(of));
        }
        (self.faults.len() == before).then_some(units)
    }
}

/// What is wrong with the units of a system, and where.
fn fault_of_system(system: &System, units: &Units) -> Option<(String, String)> {
    Some((format!("system {}", system.name), of_system(system, units).err()?))
}

/// Rates have the unit of their state over s, steady values that of the state.
fn of_system(system: &System, units: &Units) -> Result<(), String> {
    for (state, steady) in system.state.iter().zip(&system.steady) {
        units.same(steady, &Expression::Variable(state.clone()))?;
    }
    for (state, rate) in system.state.iter().zip(&system.rates) {
        let state = Expression::Variable(state.clone());
        let wanted = units.of(&state)?.map(|unit| unit.per_second());
        let found = units.of(rate)?;
        if let (Some(found), Some(wanted)) = (&found, &wanted)
            && found != wanted
        {
            return Err(format!("the rate '{rate}' of {state} is {found}, and must be {wanted}"));
        }
    }
    Ok(())
}

/// The unit of a definition.
fn of_form(
    form: &Form,
    given: &[Condition],
    system: Option<&System>,
    found: &Expression,
    units: &Units,
) -> Result<Option<Dimension>, String> {
    let variable = |name: &Symbol| Expression::Variable(name.clone());
    for expression in form.expressions.iter().chain(given.iter().map(|one| &one.expression)) {
        units.of(expression)?;
    }
    form.values.iter().try_for_each(|(name, value)| units.same(&variable(name), value))?;
    let first = form.expressions.first().map_or(Ok(None), |f| units.of(f))?;
    let names: Vec<Expression> = form.variables.iter().map(variable).collect();
    let over = |unit: Option<Dimension>, by: &Expression| {
        Ok(unit.zip(units.of(by)?).map(|(unit, by)| unit.over(&by)))
    };
    match (form.operation, &names[..]) {
        (Some(Operation::Characteristic), [s]) => {
            let rate = Some(Dimension::default().per_second());
            let of_s = units.of(s)?;
            if of_s != rate {
                return Err(format!("'{s}' is {}, and must be s^-1", of_s.unwrap_or_default()));
            }
            let order = system.map_or(0, |system| system.state.len());
            units.of(&s.clone().power(order as i32))
        }
        (Some(Operation::Linearised), [rate, by]) => over(units.of(rate)?.map(|unit| unit.per_second()), by),
        (Some(Operation::Rate), _) => Ok(first.map(|unit| unit.per_second())),
        (Some(Operation::Derivative), [x]) => over(first, x),
        (Some(Operation::Coefficient | Operation::Leading), [s]) => {
            over(first, &s.clone().power(form.whole as i32))
        }
        (Some(Operation::Solve), [x]) => units.of(x),
        (Some(Operation::Exchange), [x, y]) => units.same(x, y).map(|()| first),
        (Some(Operation::Discriminant | Operation::Hurwitz | Operation::Eliminate), _) => units.of(found),
        _ => Ok(first),
    }
}
