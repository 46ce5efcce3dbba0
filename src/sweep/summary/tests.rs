//! Summaries of rows, and of blocks put together.

use super::*;
use crate::scene::LogAxis;
use crate::sweep::ColumnStatistics;
use proptest::prelude::*;
use slipmode_core::number::Rational;

fn section() -> SummarySection {
    let edges = LogAxis { from: Rational::from(1), to: Rational::from(100), points: 3 };
    SummarySection {
        bins: vec![ColumnBins { column: "x".into(), edges }],
        by: vec!["law".into()],
        numbers: vec![ColumnStatistics { column: "y".into(), statistics: Statistic::ALL.to_vec() }],
    }
}

const COLUMNS: &[u8] = b"x,law,y\n";

fn summed(lines: &str) -> Summary {
    let (mut summary, places) = Summary::of_rows(&section(), COLUMNS).unwrap();
    summary.add_rows(&places, lines.as_bytes()).unwrap();
    summary
}

#[test]
fn rows_are_counted_by_bin_and_word_with_extremes_and_sums() {
    let summary =
        summed("-20,slip,3\n5,slip,1\n1,slip,\n100,\"a,b\",-2\n0.5,slip,inf\n1e3,slip,7\n,slip,8\n");
    assert_eq!(summary.columns(), b"x_bin,law,rows,y_count,y_least,y_greatest,y_sum\n");
    assert_eq!(
        String::from_utf8(summary.lines()).unwrap(),
        ",slip,1,1,8,8,8\n0,slip,1,0,,,\n1,slip,2,1,1,1,1\n2,\"a,b\",1,1,-2,-2,-2\n2,slip,1,1,3,3,3\n3,slip,1,1,7,7,7\n"
    );
    assert_eq!(summary.rows(), 7);
}

#[test]
fn a_column_that_is_not_there_is_named() {
    let error = Summary::of_rows(&section(), b"x,y\n").unwrap_err();
    assert_eq!(
        error.to_string(),
        "sweep.summary names the column `law`, which rows do not have (they have: x, y)"
    );
}

#[test]
fn lines_of_another_form_are_refused() {
    assert_eq!(Summary::of_columns(b"x_bin,rows,y_mean\n", 1), Err(SummaryError::Malformed));
    assert_eq!(Summary::of_columns(b"x_bin,law\n", 2), Err(SummaryError::Malformed));
    let mut summary = Summary::of_columns(b"law,rows,y_count,y_least,y_greatest,y_sum\n", 1).unwrap();
    let bad = ["", ",1,1,1", ",,1,1,1", ",-1,1,1,1", ",1.5,1,1,1", ",3,1,1,1", ",1,1,1,x"];
    for bad in bad.map(|cells| format!("slip,2{cells}\n")).iter().chain(&["slip,-1,0,,,\n".to_string()]) {
        assert_eq!(summary.add_summary(bad.as_bytes()), Err(SummaryError::Malformed), "{bad}");
    }
    assert_eq!(summary.add_summary(b"slip,2,2,-1,1,0\nslip,3,0,,,\n"), Ok(5));
}

proptest! {
    #[test]
    fn blocks_put_together_have_the_counts_and_extremes_of_the_whole(
        rows in prop::collection::vec((0.1f64..1000.0, 0usize..3, -9i32..9), 1..60), cut in 0usize..60,
    ) {
        // Whole numbers: their sums are exact in any order.
        let line = |(x, law, y): &(f64, usize, i32)| format!("{x},law-{law},{y}\n");
        let (first, second) = rows.split_at(cut.min(rows.len()));
        let text = |rows: &[(f64, usize, i32)]| rows.iter().map(line).collect::<String>();
        let whole = summed(&text(&rows));
        let mut parts = Summary::of_columns(&whole.columns(), whole.key_count()).unwrap();
        for part in [first, second] {
            parts.add_summary(&summed(&text(part)).lines()).unwrap();
        }
        prop_assert_eq!(parts.lines(), whole.lines());
        prop_assert_eq!(parts.rows(), rows.len() as u64);
    }
}
