//! Neighbours on the grid that the rows of a table form.

use std::collections::BTreeMap;

use slipmode_plot::table::Table;

/// The pairs of rows that are next to each other along all of these columns at once, the one with the smaller values first, in each
/// group of rows with the same cells in other columns.
///
/// # Errors
/// Why the rows form no grid.
pub(super) fn neighbours(
    table: &Table,
    along: &[String],
    groups: &[String],
) -> Result<Vec<[usize; 2]>, String> {
    let places = |names: &[String]| -> Vec<usize> {
        names.iter().filter_map(|name| table.columns.iter().position(|column| column.name == *name)).collect()
    };
    let (along, groups) = (places(along), places(groups));
    let mut grids: BTreeMap<Vec<&str>, Vec<(usize, Vec<f64>)>> = BTreeMap::new();
    for (at, cells) in table.rows.iter().enumerate() {
        let key = groups.iter().map(|&column| cells[column].text.as_str()).collect();
        let place = along.iter().map(|&column| cells[column].text.parse().ok()).collect::<Option<Vec<f64>>>();
        let place = place.ok_or_else(|| format!("Row {} has no place among its neighbours.", at + 1))?;
        grids.entry(key).or_default().push((at, place));
    }
    let mut found = Vec::new();
    for rows in grids.values() {
        let grid = indices(rows)?;
        let next = |place: &Vec<usize>| place.iter().map(|index| index + 1).collect::<Vec<_>>();
        found.extend(grid.iter().filter_map(|(place, &from)| Some([from, *grid.get(&next(place))?])));
    }
    found.sort_unstable();
    Ok(found)
}

/// The rows of a grid by their indices along each axis.
fn indices(rows: &[(usize, Vec<f64>)]) -> Result<BTreeMap<Vec<usize>, usize>, String> {
    let axis = |which: usize| {
        let mut values: Vec<f64> = rows.iter().map(|(_, place)| place[which]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let axes: Vec<Vec<f64>> = (0..rows.first().map_or(0, |(_, place)| place.len())).map(axis).collect();
    let index = |(axis, value): (&Vec<f64>, &f64)| axis.partition_point(|other| other < value);
    let mut grid = BTreeMap::new();
    for (at, place) in rows {
        if let Some(other) = grid.insert(axes.iter().zip(place).map(index).collect(), *at) {
            let [one, other] = [other + 1, at + 1];
            return Err(format!("Rows {one} and {other} have one place: name more columns after `at each`."));
        }
    }
    Ok(grid)
}
