//! States of a run at the times 0, T and 2T, and the rate that they show: with the eigenvector of a mode, and without any.

use rug::{Complex, Float};

use crate::experiments::linear_regime::modes::{BITS, Mode};
use slipmode_core::dynamics::{Control, Failure, Integrator, Model, Scalar, State, Stepper};
use slipmode_core::number::Dd;

/// The part of T by which the clock may miss it, in units of the arithmetic's rounding.
const CLOCK: f64 = 64.0;

/// Most steps of one run; a smooth run over two e-foldings needs some tens.
const MOST_STEPS: u64 = 100_000;

/// Three states at equal distances in time.
pub(crate) type Snapshots = [[Float; 3]; 3];

/// A number type whose digits can be handed on to MPFR.
pub(crate) trait Exactly: Scalar {
    /// The number itself.
    fn exactly(&self) -> Float;
}

impl Exactly for f64 {
    fn exactly(&self) -> Float {
        Float::with_val(BITS, *self)
    }
}

impl Exactly for Dd {
    fn exactly(&self) -> Float {
        Float::with_val(BITS, self.hi()) + self.lo()
    }
}

/// Runs to T and 2T.
///
/// # Errors
/// Those of the integrator.
pub(crate) fn snapshots<R: Exactly, M: Stepper<R>>(
    model: &Model<R>,
    method: M,
    start: State<R>,
    local_tolerance: f64,
    time: f64,
) -> Result<Snapshots, Failure> {
    let exactly = |state: &State<R>| state.each_ref().map(Exactly::exactly);
    let first = exactly(&start);
    let control = Control { local_tolerance, most_steps: MOST_STEPS };
    let mut run = Integrator::new(model, method, start, control)?;
    let mut until = |time: f64| -> Result<[Float; 3], Failure> {
        loop {
            let rest = R::from_f64(time) - run.time();
            if rest.to_f64() <= CLOCK * R::UNIT_ROUNDOFF * time {
                return Ok(exactly(run.state()));
            }
            run.advance(Some(&rest))?;
        }
    };
    Ok([first, until(time)?, until(2.0 * time)?])
}

/// ln(w·u(T)/w·u(0))/T: the rate at which the amplitude of a mode changes.
pub(crate) fn projected_rate(mode: &Mode, states: &Snapshots, time: f64) -> Complex {
    let ratio = mode.amplitude(&states[1]) / mode.amplitude(&states[0]);
    // not f64: MPC's own; |pT| ≤ 1, so that the principal branch is the right one.
    ratio.ln() / time
}

/// The rate from the states alone: of the largest component when the mode is real, of the recurrence of a pair otherwise.
pub(crate) fn rate_of_snapshots(states: &Snapshots, real: bool, time: f64) -> Complex {
    let factor = if real { factor_of_largest(states) } else { factor_of_recurrence(states) };
    // not f64: MPC's own.
    factor.ln() / time
}

fn factor_of_largest([first, second, _]: &Snapshots) -> Complex {
    let size = |i: usize| Float::with_val(BITS, first[i].abs_ref());
    let largest = (1..3).fold(0, |best, i| if size(i) > size(best) { i } else { best });
    Complex::with_val(BITS, (Float::with_val(BITS, &second[largest] / &first[largest]), 0))
}

/// The zero z of z² − sz + q in the upper half plane, where u(2T) = s u(T) − q u(0) by least squares.
fn factor_of_recurrence([first, second, third]: &Snapshots) -> Complex {
    let dot = |a: &[Float; 3], b: &[Float; 3]| {
        a.iter().zip(b).fold(Float::new(BITS), |sum, (a, b)| sum + Float::with_val(BITS, a * b))
    };
    let (ff, fs, ss) = (dot(first, first), dot(first, second), dot(second, second));
    let (ft, st) = (dot(first, third), dot(second, third));
    let product = |a: &Float, b: &Float| Float::with_val(BITS, a * b);
    let determinant = product(&ff, &ss) - product(&fs, &fs);
    let half_sum: Float = (product(&ff, &st) - product(&fs, &ft)) / &determinant / 2;
    let product_of_zeros: Float = (product(&fs, &st) - product(&ss, &ft)) / &determinant;
    let quarter = half_sum.clone().square() - product_of_zeros;
    Complex::with_val(BITS, (quarter, 0)).sqrt() + half_sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_recurrence_of_known_zeros_gives_them_back() {
        // u(kT) = Re(a z^k) in each component with z = (3 + 4i)/10.
        let state = |k: i32| {
            let z = num_complex::Complex::new(0.3, 0.4).powi(k);
            [(1.0, 2.0), (-0.5, 0.25), (3.0, -1.0)]
                .map(|(re, im)| Float::with_val(BITS, (z * num_complex::Complex::new(re, im)).re))
        };
        let z = factor_of_recurrence(&[state(0), state(1), state(2)]);
        assert!((z.real().to_f64() - 0.3).abs() < 1e-15 && (z.imag().to_f64() - 0.4).abs() < 1e-15);
    }
}
