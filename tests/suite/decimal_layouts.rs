//! The same numbers in several layouts: the same answers of `classify --points`, and none by the slow reader.

use slipmode::scene::Quantity;
use slipmode_core::friction::Parameters;
use slipmode_core::number::parse_decimal_to_dd;
use slipmode_core::stability::InertialThreshold;
use slipmode_core::stability::batch::classify_points;

use crate::harness::Workplace;

const ROWS: usize = 300;

/// Steps of an additive sequence for each of the seven quantities: the fractional parts of square roots.
const STEPS: [f64; 7] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0];

/// log10 of the ends of a, b, D_c, K, M, σ and V0.
const DECADES: [[f64; 2]; 7] =
    [[-4.0, -1.5], [-4.0, -1.5], [-7.0, -2.0], [4.0, 12.0], [-2.0, 7.0], [2.0, 9.0], [-9.0, 1.0]];

fn rows() -> Vec<[f64; 7]> {
    let value = |index: usize, quantity: usize| {
        let [low, high] = DECADES[quantity];
        let share = (STEPS[quantity].sqrt() * (index + 1) as f64).fract();
        libm::exp10(low + (high - low) * share)
    };
    (0..ROWS).map(|index| std::array::from_fn(|quantity| value(index, quantity))).collect()
}

/// With an exponent; as Python prints small numbers when asked for decimals; and with digits that no 64-bit number needs.
const LAYOUTS: [fn(f64) -> String; 3] =
    [|value| format!("{value:e}"), |value| format!("{value}"), |value| format!("000{value}{}", zeros(value))];

fn zeros(value: f64) -> String {
    let text = value.to_string();
    if text.contains('.') { "0".repeat(15) } else { format!(".{}", "0".repeat(15)) }
}

/// The appended cells of every row.
fn appended(write: fn(f64) -> String) -> Vec<String> {
    let lines = rows().iter().map(|row| row.map(write).join(",") + "\n").collect::<String>();
    let place = Workplace::new();
    place.write("points.csv", &(Quantity::ALL.map(Quantity::as_str).join(",") + "\n" + &lines));
    let text = place.run(["classify", "--points", "points.csv"]).expect_warnings();
    text.lines().map(|line| line.splitn(8, ',').last().unwrap_or_default().to_string()).collect()
}

#[test]
fn leading_and_trailing_zeros_change_no_answer() {
    let [exponent, plain, long] = LAYOUTS.map(appended);
    assert_eq!(exponent.len(), ROWS + 1);
    assert_eq!(exponent, plain);
    assert_eq!(exponent, long);
}

#[test]
fn no_layout_leaves_the_fast_reader_or_needs_rationals() {
    for write in LAYOUTS {
        let read = |row: &[f64; 7]| {
            let cells = row.map(|value| parse_decimal_to_dd(&write(value)));
            Parameters::from(cells.map(|cell| cell.unwrap_or_else(|| panic!("{row:?}: {}", write(row[0])))))
        };
        let points: Vec<_> = rows().iter().map(read).collect();
        let found = classify_points(&points, &InertialThreshold::default());
        assert_eq!(found.iter().flatten().count(), ROWS);
    }
}
