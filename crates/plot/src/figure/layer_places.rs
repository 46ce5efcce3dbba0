//! Where the boxes and passing curves of a layered graph stand in their columns.

/// Height of a row with a box; on the narrowest page it still is 24 px.
const BOX_ROW: f64 = 34.0;
/// Height of a row in which curves pass.
const PASSING_ROW: f64 = 12.0;
/// Rounds of ordering; more change nothing that can be seen.
const ROUNDS: usize = 12;

/// A place in a column: a box, or a curve on its way past the column.
pub(super) struct Slot {
    /// The column it stands in.
    pub column: usize,
    /// The box in it, if any.
    pub node: Option<usize>,
    /// The slots of the column before that it is joined to.
    pub before: Vec<usize>,
}

/// The height of each slot's middle, measured from the middle of the picture, and the height of the tallest column.
///
/// Each column in turn is ordered by the mean height of its neighbours on one side, which keeps curves short.
pub(super) fn places(slots: &[Slot]) -> (Vec<f64>, f64) {
    let count = slots.iter().map(|slot| slot.column + 1).max().unwrap_or(0);
    let mut columns: Vec<Vec<usize>> = (0..count)
        .map(|column| (0..slots.len()).filter(|&slot| slots[slot].column == column).collect())
        .collect();
    let mut after: Vec<Vec<usize>> = vec![Vec::new(); slots.len()];
    for (index, slot) in slots.iter().enumerate() {
        slot.before.iter().for_each(|&before| after[before].push(index));
    }
    let mut heights = vec![0.0; slots.len()];
    columns.iter().for_each(|column| stack(slots, column, &mut heights));
    for round in 0..ROUNDS {
        let forward = round % 2 == 0;
        for step in 0..count {
            let column = &mut columns[if forward { step } else { count - 1 - step }];
            let neighbours = |slot: usize| if forward { &slots[slot].before } else { &after[slot] };
            column.sort_by(|&one, &two| {
                mean(neighbours(one), one, &heights).total_cmp(&mean(neighbours(two), two, &heights))
            });
            stack(slots, column, &mut heights);
        }
    }
    let tallest = columns.iter().map(|column| total(slots, column)).fold(0.0, f64::max);
    (heights, tallest)
}

/// The mean height of a slot's neighbours; its own without any.
fn mean(neighbours: &[usize], slot: usize, heights: &[f64]) -> f64 {
    if neighbours.is_empty() {
        return heights[slot];
    }
    neighbours.iter().map(|&other| heights[other]).sum::<f64>() / neighbours.len() as f64
}

/// Height of the row of a slot.
pub(super) fn row(slot: &Slot) -> f64 {
    if slot.node.is_some() { BOX_ROW } else { PASSING_ROW }
}

fn total(slots: &[Slot], column: &[usize]) -> f64 {
    column.iter().map(|&slot| row(&slots[slot])).sum()
}

/// Stacks a column around the middle.
fn stack(slots: &[Slot], column: &[usize], heights: &mut [f64]) {
    let mut top = -total(slots, column) / 2.0;
    for &slot in column {
        heights[slot] = top + row(&slots[slot]) / 2.0;
        top += row(&slots[slot]);
    }
}
