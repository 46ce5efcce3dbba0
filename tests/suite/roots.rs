//! `roots`: certified digits, multiplicities, and a radius that covers the printed decimals.

use serde_json::Value;
use slipmode_core::number::parse_decimal;

use crate::harness::Workplace;

/// The roots of a slider with unit a, D_c, σ and V0, so that s = p.
fn roots(eta: &str, kappa: &str, beta: &str, digits: &str) -> Vec<Value> {
    let arguments = [
        "roots", "--json", "-a", "1", "-b", beta, "-d", "1", "-k", kappa, "-m", eta, "-s", "1", "-v", "1",
        "--digits", digits,
    ];
    serde_json::from_str(&Workplace::new().run(arguments).expect_success()).unwrap()
}

#[test]
fn double_and_triple_roots_are_told_with_their_multiplicity() {
    let multiplicities =
        |roots: &[Value]| roots.iter().map(|root| root["multiplicity"].as_u64().unwrap()).collect::<Vec<_>>();
    assert_eq!(multiplicities(&roots("0.125", "3.375", "1", "50")), [3]);
    let double = roots("0.625", "2.875", "9", "50");
    assert_eq!(multiplicities(&double), [1, 2]);
    assert_eq!(double[1]["re"], format!("1.{}", "0".repeat(49)));
    assert_eq!(double[1]["radius"], "0");
    assert_eq!(multiplicities(&roots("0.625", "2.8750000000000000000000000001", "9", "50")), [1, 1, 1]);
}

#[test]
fn more_digits_extend_fewer_digits() {
    let few = roots("0.3", "0.7", "1.9", "40");
    let many = roots("0.3", "0.7", "1.9", "1000");
    for (few, many) in few.iter().zip(&many) {
        for part in ["re", "im"] {
            let (few, many) = (few[part].as_str().unwrap(), many[part].as_str().unwrap());
            assert!(few == "0" && many == "0" || many.starts_with(&few[..few.len() - 1]), "{few} {many}");
            assert!(few == "0" || many.bytes().filter(u8::is_ascii_digit).count() >= 1000);
        }
    }
}

#[test]
fn the_radius_covers_the_rounding_of_the_printed_decimals() {
    let parse = |root: &Value, key: &str| parse_decimal(root[key].as_str().unwrap()).unwrap();
    let exact = roots("0.3", "0.7", "1.9", "200");
    for digits in ["1", "2", "17", "60"] {
        for (rough, exact) in roots("0.3", "0.7", "1.9", digits).iter().zip(&exact) {
            let off = |key| parse(rough, key) - parse(exact, key);
            let distance_squared = off("re").square() + off("im").square();
            let radius_squared = parse(rough, "radius").square();
            assert!(distance_squared <= radius_squared, "{digits}: {rough}");
            // Not wider than half a unit in the last place of each part, and the little that the digits were short of.
            let modulus_squared = parse(exact, "re").square() + parse(exact, "im").square();
            let unit = parse_decimal(&format!("1.1e{}", 1 - digits.parse::<i32>().unwrap())).unwrap();
            assert!(radius_squared <= modulus_squared * unit.square(), "{digits}: {rough}");
        }
    }
}

/// A triple root at -5/2: between two numbers of one digit.
#[test]
fn a_root_between_two_decimals_has_all_digits() {
    for (digits, expected, radius) in [("1", "-2", "0.5"), ("2", "-2.5", "0"), ("4", "-2.500", "0")] {
        let root = &roots("2/13", "125/52", "27/52", digits)[0];
        assert_eq!([&root["re"], &root["multiplicity"]], [&Value::from(expected), &Value::from(3)]);
        let excess =
            parse_decimal(root["radius"].as_str().unwrap()).unwrap() - parse_decimal(radius).unwrap();
        assert!(excess >= 0 && excess < parse_decimal("0.01").unwrap(), "{root}");
    }
}

#[test]
fn the_text_for_people_has_one_line_a_root() {
    let arguments =
        ["roots", "-a", "1", "-b", "9", "-d", "1", "-k", "2.875", "-m", "0.625", "-s", "1", "-v", "1"];
    let text = Workplace::new().run(arguments).expect_success();
    assert_eq!(text.lines().nth(1), Some("1.0000000000000000 1/s  (within 0, multiplicity 2)"));
}
