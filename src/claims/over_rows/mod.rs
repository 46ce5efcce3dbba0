//! Claims over the rows of a table: what every run does, how many do, and what agrees within the estimated errors.

mod arithmetic;
mod decide;
mod statement;
mod values;

use crate::claims::Finding;
use crate::experiments::{Context, Need, Outcome, TableMaker, table_makers};
use crate::scene::{ClaimEntry, Fault, Faults, Problem, nearest};
use slipmode_core::theory::Equations;

/// The finding on a statement over the rows of a table.
pub(super) fn decide(table: &str, text: &str, context: &Context) -> Finding {
    let found = maker(table).and_then(|maker| {
        let none = "No scene of the report computes the table.";
        let table = maker.table(context).ok_or(none)?;
        Ok((statement::read(text, &table.columns)?, table))
    });
    match found {
        Ok((statement, table)) => decide::decide(text, &statement, &table),
        Err(reason) => Finding::not_checked(reason),
    }
}

/// What a table needs computed.
pub(super) fn needs(table: &str) -> &'static [Need] {
    maker(table).map_or(&[], |maker| maker.needs)
}

/// What is wrong with the statements over rows in a file of claims: an unknown table or column, or the grammar.
#[must_use]
pub fn row_faults(file: &str, claims: &[ClaimEntry]) -> Faults {
    let stated = |claim: &'_ ClaimEntry| claim.stated.clone().map(|stated| (claim.id.clone(), stated));
    let faults = claims.iter().filter_map(stated).flat_map(|(id, stated)| {
        let of_rows = stated.parts().filter_map(|(_, formula)| {
            let message = check(formula.rows.as_ref()?, &formula.text).err()?;
            Some(Fault {
                file: file.to_owned(),
                line: None,
                key: format!("claim {id}: formula"),
                value: Some(formula.text.clone()),
                problem: Problem::Equation(message),
            })
        });
        of_rows.collect::<Vec<_>>()
    });
    faults.collect()
}

/// Reads a statement in the names of the table's columns.
fn check(table: &str, text: &str) -> Result<(), String> {
    let (equations, outcome) = (Equations::default(), Outcome::default());
    let columns = (maker(table)?.make)(&Context::new(&equations, &outcome)).map(|table| table.columns);
    // A table that needs a slider to have columns is checked when the claim is decided.
    columns.map_or(Ok(()), |columns| statement::read(text, &columns).map(|_| ()))
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
