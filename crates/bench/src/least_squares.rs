//! Laws of cost by least squares: a power of the size, or the sum of two powers.

/// The form of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// y = c·x^p; c and p are fitted to the logarithms.
    Power,
    /// y = c·x^q + d·x with this q; c and d are fitted to relative errors.
    Beside(f64),
}

impl Form {
    /// The form of these words: `power`, or `beside` and q.
    #[must_use]
    pub fn read(words: &str) -> Option<Self> {
        match words.split_once(' ') {
            None if words == "power" => Some(Self::Power),
            Some(("beside", power)) => {
                power.parse().ok().filter(|power: &f64| power.is_finite()).map(Self::Beside)
            }
            _ => None,
        }
    }

    /// The words that [`Self::read`] reads.
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Self::Power => "power".into(),
            Self::Beside(exponent) => format!("beside {exponent}"),
        }
    }
}

/// A fitted law: the sum of factor · size^exponent over its terms, in seconds.
#[derive(Debug, Clone, PartialEq)]
pub struct Law {
    /// Factor, s, and exponent of each term.
    pub terms: Vec<(f64, f64)>,
}

impl Law {
    /// The law of this form nearest to the points (size, seconds); none for too few points, or values that are not positive.
    #[must_use]
    pub fn fit(form: Form, points: &[(f64, f64)]) -> Option<Self> {
        if points.iter().any(|(x, y)| *x <= 0.0 || *y <= 0.0) {
            return None;
        }
        let terms = match form {
            Form::Power => vec![power(points)],
            Form::Beside(exponent) => beside(points, exponent),
        };
        let is_finite = |(factor, exponent): &(f64, f64)| factor.is_finite() && exponent.is_finite();
        terms.iter().all(is_finite).then_some(Self { terms })
    }

    /// Seconds at a size.
    #[must_use]
    pub fn at(&self, size: f64) -> f64 {
        self.terms.iter().map(|(factor, exponent)| factor * libm::pow(size, *exponent)).sum()
    }

    /// The largest factor between a value and the law, at least 1.
    #[must_use]
    pub fn worst_residual(&self, points: &[(f64, f64)]) -> f64 {
        points.iter().map(|(x, y)| libm::exp(libm::log(y / self.at(*x)).abs())).fold(1.0, f64::max)
    }

    /// The law as text.
    #[must_use]
    pub fn text(&self) -> String {
        let term = |(factor, exponent): &(f64, f64)| match exponent {
            0.0 => format!("{factor:.3e} s"),
            1.0 => format!("{factor:.3e} s · size"),
            _ => format!("{factor:.3e} s · size^{exponent:.3}"),
        };
        self.terms.iter().map(term).collect::<Vec<_>>().join(" + ")
    }
}

fn power(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (libm::log(*x), libm::log(*y))).collect();
    let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
    let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
    let spread: f64 = logs.iter().map(|(x, _)| (x - mean_x) * (x - mean_x)).sum();
    let shared: f64 = logs.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let exponent = shared / spread;
    (libm::exp(mean_y - exponent * mean_x), exponent)
}

/// Both factors by the normal equations of Σ (c·x^q/y + d·x/y − 1)².
fn beside(points: &[(f64, f64)], exponent: f64) -> Vec<(f64, f64)> {
    let rows: Vec<[f64; 2]> = points.iter().map(|(x, y)| [libm::pow(*x, exponent) / y, x / y]).collect();
    let sum = |of: fn(&[f64; 2]) -> f64| rows.iter().map(of).sum::<f64>();
    let (aa, ab, bb) = (sum(|[a, _]| a * a), sum(|[a, b]| a * b), sum(|[_, b]| b * b));
    let (a, b) = (sum(|[a, _]| *a), sum(|[_, b]| *b));
    let determinant = aa * bb - ab * ab;
    vec![((a * bb - b * ab) / determinant, exponent), ((b * aa - a * ab) / determinant, 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_is_found_and_a_residual_is_stated() {
        let exact = [1.0, 10.0, 100.0].map(|x: f64| (x, 3.0 * x * x.sqrt()));
        let law = Law::fit(Form::Power, &exact).unwrap();
        let (factor, exponent) = law.terms[0];
        assert!((exponent - 1.5).abs() < 1e-12 && (factor - 3.0).abs() < 1e-12);
        assert!(law.worst_residual(&exact) < 1.0 + 1e-12);
        assert!((law.worst_residual(&[(1.0, 1.5)]) - 2.0).abs() < 1e-12);
    }

    #[test]
    fn both_terms_of_a_sum_are_found_and_too_few_points_have_no_law() {
        let exact = [1.0, 100.0, 1e4].map(|x: f64| (x, 5.0 * x.sqrt() + 0.25 * x));
        let law = Law::fit(Form::Beside(0.5), &exact).unwrap();
        assert!((law.terms[0].0 - 5.0).abs() < 1e-9 && (law.at(1e6) - 255_000.0).abs() < 1e-3);
        assert_eq!(law.text(), "5.000e0 s · size^0.500 + 2.500e-1 s · size");
        for points in [&[][..], &[(1.0, 1.0)], &[(2.0, 1.0), (2.0, 3.0)], &[(1.0, 0.0), (2.0, 1.0)]] {
            assert_eq!(Law::fit(Form::Power, points), None);
            assert_eq!(Law::fit(Form::Beside(0.0), points), None);
        }
    }

    #[test]
    fn words_name_a_form() {
        assert_eq!(Form::read("power"), Some(Form::Power));
        assert_eq!(Form::read("beside 0.5"), Some(Form::Beside(0.5)));
        for form in [Form::Power, Form::Beside(0.5)] {
            assert_eq!(Form::read(&form.words()), Some(form));
        }
        assert!(["", "beside", "beside x", "cubic 3"].iter().all(|words| Form::read(words).is_none()));
    }
}
