//! Tables of an operating point: what leaves its slip mode, and what each error bar does.

use super::reach::{digits_of_factor, in_words, range_in_words, reach};
use super::run::{Change, OperatingPointOutcome};
use super::words::{error_bars, mode_list, name, settling};
use crate::experiments::shared::cells::Digits;
use crate::experiments::{Context, Need, TableMaker, table_of};
use crate::scene::unit_of;
use slipmode_plot::table::{Cell, Table};

const NEEDS: &[Need] = &[Need::OperatingPoint];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "changes", needs: NEEDS, make: changes },
    TableMaker { id: "error-bars", needs: NEEDS, make: bars },
];

fn found<'c>(context: &'c Context) -> impl Iterator<Item = &'c OperatingPointOutcome> {
    context.outcome.each(|scene| &scene.operating_point).map(|(_, found)| found)
}

fn changes(context: &Context) -> Option<Table> {
    let rows = || found(context).flat_map(|found| &found.changes);
    let reach = rows().map(|change| range_in_words(change.quantity, reach(change.quantity)));
    let reach = reach.collect::<Vec<_>>().join(", ");
    let of_all = " In the last column no values within the error bars have the present slip mode (exact).";
    let is_uncertain = context.outcome.scenes.iter().any(|scene| error_bars(scene).is_some());
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "none within reach".into());
    let shown = |change: &Change, value: f64| in_words(value, unit_of(change.quantity));
    let table = table_of("changes", rows())
        .fill("reach", &reach)
        .fill("certain", if is_uncertain { of_all } else { "" })
        .text("value", |change| name(change.quantity))
        .text("changes_at", |change| or_none(change.to.map(|(to, _)| shown(change, to))))
        .number("factor", |change| {
            let factor = change.to?.0 / change.now;
            Some(factor.cell(digits_of_factor(factor)))
        })
        .text("slip_mode", |change| change.to.map_or("", |(_, mode)| mode.words()));
    let certain =
        |change: &Change| change.to.map(|_| or_none(change.certain_from.map(|value| shown(change, value))));
    let table = if is_uncertain { table.text("certain_at", certain) } else { table };
    table.table()
}

fn bars(context: &Context) -> Option<Table> {
    table_of("error-bars", found(context).flat_map(|found| &found.bars))
        .text("value", |bar| name(bar.quantity))
        .text("error_bar", |bar| range_in_words(bar.quantity, bar.ends))
        .digits("share_per_cent", 2, |bar| (bar.share > 0.0).then_some(100.0 * bar.share))
        .number("width_decades", |bar| {
            if bar.width_decades.is_finite() { bar.width_decades.cell(2) } else { Cell::text("no end") }
        })
        .text("settled_by", |bar| settling(bar).unwrap_or_default())
        .text("modes_if_exact", |bar| mode_list(&bar.modes_if_exact))
        .table()
}
