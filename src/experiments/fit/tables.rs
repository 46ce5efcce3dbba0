//! Tables of a fit: the values with their intervals, and their correlations.

use super::words::digits;
use crate::experiments::shared::cells::Digits;
use crate::experiments::{Context, Need, TableMaker, table_of};
use crate::fitting::Fit;
use slipmode_plot::table::Table;

const NEEDS: &[Need] = &[Need::Fit];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "fit", needs: NEEDS, make: values },
    TableMaker { id: "fit-correlations", needs: NEEDS, make: correlations },
];

fn best<'c>(context: &'c Context) -> impl Iterator<Item = &'c Fit> {
    context.outcome.each(|scene| &scene.fit).filter_map(|(_, found)| Some(&found.fits.as_ref().ok()?.best))
}

fn values(context: &Context) -> Option<Table> {
    table_of("fit", best(context).flat_map(|fit| &fit.estimates))
        .text("parameter", |estimate| estimate.parameter.symbol())
        .text("unit", |estimate| estimate.parameter.unit())
        .number("best", |estimate| estimate.value.cell(digits(estimate)))
        .digits("standard_error", 2, |estimate| estimate.standard_error)
        .number("low", |estimate| estimate.ends[0].cell(digits(estimate)))
        .number("high", |estimate| estimate.ends[1].cell(digits(estimate)))
        .number("quadratic_low", |estimate| estimate.quadratic_ends[0].cell(digits(estimate)))
        .number("quadratic_high", |estimate| estimate.quadratic_ends[1].cell(digits(estimate)))
        .table()
}

fn correlations(context: &Context) -> Option<Table> {
    let pairs: Vec<(&Fit, (usize, usize, f64))> =
        best(context).flat_map(|fit| fit.correlations().map(move |pair| (fit, pair))).collect();
    let symbol = |fit: &Fit, index: usize| fit.estimates[index].parameter.symbol();
    table_of("fit-correlations", pairs.iter())
        .text("one", |(fit, (i, ..))| symbol(fit, *i))
        .text("other", |(fit, (_, j, _))| symbol(fit, *j))
        .digits("correlation", 3, |(_, (.., correlation))| *correlation)
        .table()
}
