//! Numbers of charts against built-in truth.

use super::draw;
use crate::scene::{EquationChart, Limits, read_chart, read_equations};

const EQUATIONS: &str = "[assumptions]\npositive = [\"x\"]\nfree = [\"d\", \"k\", \"s\"]\n\
    [[equation]]\nnumber = \"1\"\nequation = \"h = sqrt(x)\"\ngiven = [\"x > 2\"]\nnote = \"N.\"\n\
    [[definition]]\nname = \"P\"\nis = \"s^2 + d*s + k\"\n";

fn chart(text: &str) -> EquationChart {
    let equations = read_equations("equations.toml", EQUATIONS.as_bytes()).expect("equations");
    let head = "title = \"T\"\ncaption = \"C.\"\ndescription = \"D\"\n";
    let read =
        read_chart("c.toml", (head.to_owned() + text).as_bytes(), &Limits::default(), "c", Some(&equations));
    read.expect("a chart").expect("sound equations")
}

#[test]
fn a_line_has_certain_digits_and_no_value_where_its_equation_is_not_given() {
    let lines = "[x]\nvariable = \"x\"\ntitle = \"X\"\nlinear = true\nfrom = 1\nto = 4\npoints = 4\n\
        [y]\ntitle = \"Y\"\nlinear = true\nfrom = 0\nto = 3\n\
        [[line]]\ncolumn = \"h\"\nlabel = \"H\"\nis = \"h\"\n\
        [[line]]\ncolumn = \"zero\"\nlabel = \"Z\"\nis = \"1/10^40 + sqrt(x)*sqrt(x + 1) - sqrt(x^2 + x)\"\n";
    let (figure, table) = draw(&chart(lines));
    let csv = "x,h,zero\n1,,1.00000000000e-40\n2,,1.00000000000e-40\n3,1.73205080757,1.00000000000e-40\n4,2,1.00000000000e-40\n";
    assert_eq!(table.to_csv().replace("2.00000000000", "2"), csv);
    assert_eq!((figure.id.as_str(), figure.data), ("c", vec!["c".to_owned()]));
}

/// The truth is that of s² + d s + k: both signs of d and k, and d = 0 and k = 0, at which roots lie on the axis.
#[test]
fn a_map_tells_every_mode_of_a_quadratic() {
    let map = "[x]\nvariable = \"d\"\ntitle = \"D\"\nlinear = true\nfrom = -3\nto = 3\npoints = 7\n\
        [y]\nvariable = \"k\"\ntitle = \"K\"\nlinear = true\nfrom = -1\nto = 1\npoints = 3\n\
        [map]\npolynomial = \"P\"\nroots = \"s\"\n";
    let (figure, table) = draw(&chart(map));
    let rows: Vec<String> = table.to_csv().lines().skip(1).map(|row| row.replace('"', "")).collect();
    let wanted = |d: i32, k: i32| match (d, k, d * d - 4 * k) {
        (_, -1, _) => "1,0,2,unstable, without oscillation",
        (0, 0, _) => "0,1,1,no root to the right of the imaginary axis, one on it",
        (_, 0, _) if d > 0 => "0,1,2,no root to the right of the imaginary axis, one on it",
        (_, 0, _) => "1,1,2,unstable, without oscillation",
        (0, _, _) => "0,2,0,no root to the right of the imaginary axis, one on it",
        (_, _, 0) if d > 0 => "0,0,1,stable, without oscillation",
        (_, _, 0) => "1,0,1,unstable, without oscillation",
        (_, _, more) if more > 0 && d > 0 => "0,0,2,stable, without oscillation",
        (_, _, more) if more > 0 => "2,0,2,unstable, without oscillation",
        _ if d > 0 => "0,0,0,stable, oscillates",
        _ => "2,0,0,unstable, oscillates",
    };
    let expected = (-1..=1).flat_map(|k| (-3..=3).map(move |d| format!("{d},{k},{}", wanted(d, k))));
    assert_eq!(rows, expected.collect::<Vec<_>>());
    assert!(
        figure.svg.contains("unstable, oscillates") && figure.svg.contains("stable, without oscillation")
    );
}
