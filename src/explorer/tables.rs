//! The explorer's numbers as tables in which one parameter changes at a time: what a reader without scripts has.

use crate::explorer::formulas::FORMULAS;
use crate::explorer::{DIGITS, Factors, Families};
use crate::scene::cited;
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_plot::table::{Cell, Column, Table};

/// One table for each of b, K and M.
pub(crate) fn one_at_a_time(families: &Families, values: &[[String; FORMULAS]]) -> Vec<Table> {
    let own = &families.parameters;
    let of = [
        ("varied-b", "Only b changes", "b", "", &own.evolution_effect),
        ("varied-k", "Only K changes", "K", "Pa/m", &own.stiffness_pa_per_m),
        ("varied-m", "Only M changes", "M", "kg/m²", &own.mass_per_area_kg_per_m2),
    ];
    let base = [0, 1, 2].map(|at| families.factors[at].base);
    let table = |(which, (id, title, name, unit, value)): (usize, (&str, &str, &str, &str, _))| {
        let mut table = Table::new(id, title, columns(families, name, unit));
        let factors: &Factors = &families.factors[which];
        for (step, (factor, times)) in factors.texts.iter().zip(&factors.values).enumerate() {
            let mut combination = base;
            combination[which] = step;
            let place = families.place(combination);
            let value: slipmode_core::number::Rational = times.clone() * value;
            let mut row = vec![Cell::number(*factor), Cell::number(rational_to_decimal(&value, DIGITS))];
            row.extend(values[place][..4].iter().map(|text| Cell::number(text.as_str())));
            row.extend(families.states.iter().map(|states| {
                let state = &states[place];
                Cell::text(format!("{}, {}", state.mode(), round_digits(state.imaginary(), DIGITS)))
            }));
            table.push(row);
        }
        table
    };
    of.into_iter().enumerate().map(table).collect()
}

fn columns(families: &Families, name: &str, unit: &str) -> Vec<Column> {
    let mut columns = vec![
        Column::number("factor", "Factor", ""),
        Column::number("value", name, unit),
        Column::number("eq15_pa", &cited("σ of {quasi-static-upper}"), "Pa"),
        Column::number("eq16_pa", &cited("σ of {quasi-static-lower}"), "Pa"),
        Column::number("eq18_m_per_s_per_pa", &cited("V0/σ of {inertial-upper}"), "m/s/Pa"),
        Column::number("eq20_m_per_s_per_pa", &cited("V0/σ of {inertial-lower}"), "m/s/Pa"),
    ];
    columns.extend(families.points.iter().map(|point| {
        Column::text(
            &format!("point_{}", point.name),
            &format!("{}: slip mode, max Im(s) in 1/s", point.name),
        )
    }));
    columns
}
