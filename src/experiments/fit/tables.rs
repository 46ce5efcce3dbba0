//! Tables of a fit: the values with their intervals, and their correlations.

use super::words::digits;
use crate::experiments::shared::cells::{DigitColumns, Digits};
use crate::experiments::{Context, Need, TableMaker};
use crate::fitting::{Estimate, Fit};
use slipmode_plot::table::{Cell, Table};

const NEEDS: &[Need] = &[Need::Fit];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "fit", needs: NEEDS, make: values },
    TableMaker { id: "fit-correlations", needs: NEEDS, make: correlations },
];

const NOTE: &str = "Best values, standard errors from the curvature of the sum of squares, and 95 % intervals by profile likelihood (converged): each end is held while all other values are fitted again. The last two columns have the interval that the curvature alone gives. An empty end has no bound.";

fn best<'c>(context: &'c Context) -> impl Iterator<Item = &'c Fit> {
    context.outcome.each(|scene| &scene.fit).filter_map(|(_, found)| Some(&found.fits.as_ref().ok()?.best))
}

fn values(context: &Context) -> Option<Table> {
    let end = |estimate: &Estimate, end: Option<f64>| {
        end.map_or_else(Cell::empty, |end| end.cell(digits(estimate)))
    };
    Table::of("fit", "What the record gives", best(context).flat_map(|fit| &fit.estimates))
        .note(NOTE)
        .text("parameter", "Value", |estimate| estimate.parameter.symbol())
        .text("unit", "Unit", |estimate| estimate.parameter.unit())
        .number("best", "Best", "", |estimate| estimate.value.cell(digits(estimate)))
        .digits("standard_error", "Standard error", "", 2, |estimate| estimate.standard_error)
        .number("low", "95 % from", "", |estimate| end(estimate, estimate.ends[0]))
        .number("high", "to", "", |estimate| end(estimate, estimate.ends[1]))
        .number("quadratic_low", "Curvature: from", "", |estimate| {
            end(estimate, Some(estimate.quadratic_ends[0]))
        })
        .number("quadratic_high", "to", "", |estimate| end(estimate, Some(estimate.quadratic_ends[1])))
        .table()
        .into()
}

fn correlations(context: &Context) -> Option<Table> {
    let pairs: Vec<(&Fit, (usize, usize, f64))> =
        best(context).flat_map(|fit| fit.correlations().map(move |pair| (fit, pair))).collect();
    let symbol = |fit: &Fit, index: usize| fit.estimates[index].parameter.symbol();
    Table::of("fit-correlations", "Correlations of the fitted values", pairs.iter())
        .note("Near 1 or −1, the record tells one of the two only if the other one is known.")
        .text("one", "Value", |(fit, (i, ..))| symbol(fit, *i))
        .text("other", "and", |(fit, (_, j, _))| symbol(fit, *j))
        .digits("correlation", "Correlation", "", 3, |(_, (.., correlation))| *correlation)
        .table()
        .into()
}
