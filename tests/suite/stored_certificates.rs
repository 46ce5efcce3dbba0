//! The stored certificates of the report compared with references of quadruple precision (tests/vectors, heyoka), and references
//! that were shifted.

use slipmode_core::number::Rational;

use crate::hard_cases::{decimal, rows};

const REFERENCES: &str = include_str!("../vectors/stored-certificates.txt");
const CERTIFICATES: [(&str, &str); 2] = [
    ("slip", include_str!("../../reports/im-avouac/vectors/certified-slip.csv")),
    ("aging", include_str!("../../reports/im-avouac/vectors/certified-aging.csv")),
];

/// The value of a reference with a bound of its error, and the stored bounds.
struct Compared {
    value: Rational,
    error: Rational,
    bounds: [Rational; 2],
}

impl Compared {
    fn is_enclosed(&self, relative_shift: &Rational) -> bool {
        let value = &self.value * (Rational::from(1) + relative_shift);
        let [low, high] = &self.bounds;
        let above = Rational::from(&value - &self.error);
        *low <= above && value + &self.error <= *high
    }
}

/// The peak velocity, the period of a cycle and the stress drop of each reference of this law and certificate.
fn compared(law: &str, certificate: &str) -> Vec<Vec<Compared>> {
    let (_, text) = CERTIFICATES.iter().find(|(of, _)| *of == law).unwrap();
    let stored: Vec<_> = rows(text).skip(1).collect();
    let references = rows(REFERENCES).skip(1).filter(|cells| cells[0] == law && cells[2] == certificate);
    let compared = references.map(|cells| {
        let row = &stored[cells[1].parse::<usize>().unwrap() - 1];
        assert_eq!((row[7], row[8]), (law, certificate), "{cells:?}");
        let values = cells[3..6].iter().enumerate().filter(|(_, cell)| !cell.is_empty());
        let of = |(at, cell): (usize, &&str)| {
            let value = decimal(cell);
            let error = &value * decimal(cells[6]);
            Compared { value, error, bounds: [9, 10].map(|column| decimal(row[column + 2 * at])) }
        };
        values.map(of).collect()
    });
    compared.collect()
}

#[test]
fn every_stored_enclosure_contains_its_reference_of_quadruple_precision() {
    for law in ["slip", "aging"] {
        for (certificate, count, values) in [("cycle", 325, 3), ("decay", 116, 2)] {
            let references = compared(law, certificate);
            assert_eq!(references.len(), count, "{law} {certificate}");
            for (at, reference) in references.iter().enumerate() {
                assert_eq!(reference.len(), values);
                for one in reference {
                    let Compared { value, error, bounds } = one;
                    assert!(
                        one.is_enclosed(&Rational::new()),
                        "{law} {certificate} {at}: {value} {bounds:?}"
                    );
                    // A reference that is not ten thousand times as exact as the bounds would decide less.
                    assert!(Rational::from(error * 10_000) < Rational::from(&bounds[1] - &bounds[0]));
                }
            }
        }
    }
}

/// Each value is shifted alone, up and down; a stored enclosure notices what is more than its width.
#[test]
fn a_reference_shifted_by_a_part_of_1e_8_is_noticed() {
    let noticed = |certificate: &str| {
        let all: Vec<_> =
            CERTIFICATES.iter().flat_map(|(law, _)| compared(law, certificate)).flatten().collect();
        let shifts = [decimal("1e-8"), decimal("-1e-8")];
        let refused = |one: &&Compared| shifts.iter().all(|shift| !one.is_enclosed(shift));
        (all.iter().filter(refused).count(), all.len())
    };
    assert_eq!(noticed("cycle"), (1918, 1950));
    assert_eq!(noticed("decay"), (384, 464));
}
