//! Claims over the rows of a table: what every run does, how many do, how values change between neighbours, and what agrees within
//! the estimated errors. Where a certificate encloses a value, it takes the place of the value with its estimated error.

mod arithmetic;
mod decide;
mod neighbours;
mod numbers;
mod statement;
mod truth;
mod values;

use crate::claims::{Finding, Verdict};
use crate::experiments::certificates::Certificates;
use crate::experiments::{Context, Need, Outcome, TableMaker, table_makers};
use crate::scene::{ClaimEntry, Fault, Faults, OverRows, Problem, filled, nearest};
use slipmode_theory::Equations;

/// The finding on a statement over the rows of a table. A stored certificate that is not proved again decides nothing.
pub(super) fn decide(rows: &OverRows, text: &str, context: &Context) -> Finding {
    let found = maker(&rows.table).and_then(|maker| {
        let none = "No scene of the report computes the table.";
        let table = maker.table(context).ok_or(none)?;
        let certificates = context.outcome.scenes.iter().filter_map(|scene| scene.certificates.as_ref());
        match certificates
            .filter(|_| maker.needs.contains(&Need::Certificates))
            .find_map(Certificates::refusal)
        {
            Some(refusal) => Err(refusal),
            None => Ok((statement::read(text, &rows.numbers, &table.columns)?, table)),
        }
    });
    let found = match found {
        Ok((statement, table)) => decide::decide(text, &statement, &table, context.kind),
        Err(reason) => Finding::not_checked(reason),
    };
    let count = found.numbers.get("count").and_then(|count| count.parse().ok()).unwrap_or(0);
    match rows.extent.as_ref().map(|extent| filled(extent, &found.numbers)) {
        _ if found.verdict != Verdict::Holds => found,
        _ if count < rows.at_least => Finding::not_checked(format!(
            "True, but of {count} only (the claim wants at least {}).",
            rows.at_least
        )),
        Some(Ok(extent)) => found.on(extent),
        Some(Err(name)) => found.remark(format!("The number {{{name}}} is open.")),
        None => found,
    }
}

/// What a table needs computed.
pub(super) fn needs(table: &str) -> &'static [Need] {
    maker(table).map_or(&[], |maker| maker.needs)
}

/// What is wrong with the statements over rows in a file of claims: an unknown table or column, or the grammar.
pub(crate) fn row_faults(file: &str, claims: &[ClaimEntry]) -> Faults {
    let faults = claims.iter().flat_map(|claim| {
        claim.formulas().filter_map(move |formula| {
            let message = check(formula.rows.as_ref()?, &formula.text).err()?;
            let key = format!("claim {}: formula", claim.id);
            let fault = Fault::of(file, key, Problem::Equation(message));
            Some(Fault { value: Some(formula.text.clone()), ..fault })
        })
    });
    faults.collect()
}

/// Reads a statement in the names of the table's columns.
fn check(rows: &OverRows, text: &str) -> Result<(), String> {
    let (equations, outcome) = (Equations::default(), Outcome::default());
    let columns = (maker(&rows.table)?.make)(&Context::new(&equations, &outcome)).map(|table| table.columns);
    // A table that needs a slider to have columns is checked when the claim is decided.
    columns.map_or(Ok(()), |columns| statement::read(text, &rows.numbers, &columns).map(|_| ()))
}

/// The maker of a table that rests on computations.
fn maker(id: &str) -> Result<&'static TableMaker, String> {
    let known = || table_makers().filter(|maker| !maker.needs.is_empty());
    known().find(|maker| maker.id == id).ok_or_else(|| {
        let near = nearest(id, known().map(|maker| maker.id));
        let near = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        format!("there is no table `{id}` of computed values{near}")
    })
}

#[cfg(test)]
mod tests;
