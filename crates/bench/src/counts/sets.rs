//! The inputs: random sliders as wide as laboratories, faults and theory go, and cubics next to double roots.

use rug::ops::Pow;

use slipmode::sweep::LowDiscrepancy;
use slipmode_core::friction::Parameters;
use slipmode_core::number::Rational;

/// log10 of the ends of a, b/a, D_c in m, K in Pa/m, M in kg/m², σ in Pa and V0 in m/s.
const DECADES: [[f64; 2]; 7] =
    [[-4.0, -1.5], [-1.3, 1.3], [-7.0, -2.0], [4.0, 12.0], [-2.0, 7.0], [2.0, 9.0], [-9.0, 1.0]];

/// Random sliders by number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sliders(LowDiscrepancy);

impl Sliders {
    pub(crate) fn new() -> Self {
        Self(LowDiscrepancy::new(b"speed"))
    }

    /// The slider of this number; its seven values are the 64-bit numbers themselves.
    pub(crate) fn parameters(&self, number: u32) -> Parameters<f64> {
        let value = |quantity: usize| {
            let [low, high] = DECADES[quantity];
            libm::exp10(low + (high - low) * self.0.coordinate(u64::from(number), quantity))
        };
        let direct_effect = value(0);
        Parameters::from([
            direct_effect,
            direct_effect * value(1),
            value(2),
            value(3),
            value(4),
            value(5),
            value(6),
        ])
    }
}

/// A named set of cubics with exact coefficients.
#[derive(Debug)]
pub(crate) struct Set {
    pub(crate) name: &'static str,
    pub(crate) cubics: Vec<[Rational; 4]>,
}

/// The random set and the hard set.
pub(crate) fn sets(count: u32) -> [Set; 2] {
    let sliders = Sliders::new();
    let random = |number| {
        let exact = sliders.parameters(number).map(|value| Rational::from_f64(*value).unwrap_or_default());
        exact.groups().characteristic_cubic()
    };
    [
        Set { name: "random", cubics: (0..count).map(random).collect() },
        Set { name: "hard", cubics: (0..count).map(beside_double_root).collect() },
    ]
}

/// Distances from the double root: 1e-4, 1e-6 … 1e-30 in turn.
const DISTANCES: u32 = 14;

/// (x − r)²·(x − t) whose constant coefficient (κ in eq 8) is moved by a relative ±10^-k.
fn beside_double_root(number: u32) -> [Rational; 4] {
    let double = Rational::from((-3 - i64::from(number % 17), 7));
    let third = Rational::from((-9 - i64::from(number % 23), 4));
    let square = double.clone() * &double;
    let sum = Rational::from(&double * 2_u32) + &third;
    let linear = Rational::from(&double * &third) * 2_u32 + &square;
    let distance =
        Rational::from((1, 100)) / Rational::from(rug::Integer::from(100).pow(number % DISTANCES + 1));
    let factor =
        if number.is_multiple_of(2) { Rational::from(1) + distance } else { Rational::from(1) - distance };
    [-(square * third) * factor, linear, -sum, Rational::from(1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::roots::certified_roots;

    #[test]
    fn hard_cubics_have_two_roots_close_together_and_never_a_double_one() {
        let [random, hard] = sets(28);
        assert_eq!((random.cubics.len(), hard.cubics.len()), (28, 28));
        let mut signs = [0, 0];
        for cubic in &hard.cubics {
            let sign = certified_roots(cubic, 5).discriminant_sign;
            assert_ne!(sign, 0);
            signs[usize::from(sign > 0)] += 1;
        }
        assert!(signs.iter().all(|count| *count > 0), "{signs:?}");
    }
}
