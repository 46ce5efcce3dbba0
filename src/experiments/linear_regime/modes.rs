//! The modes of the linearised slider, and what its quadratic terms do to a start along one of them.
//!
//! About steady sliding x' = (ζ − x − βy)/η, y' = −x − y, ζ' = −κx with either law. To a root p of eq 8 belong the right
//! eigenvector v = (1, −1/(1+p), −κ/p) and the left eigenvector w = (ηp(1+p), −βp, 1+p); w·u of a state u is the amplitude of
//! its mode and nothing else. Neither p = 0 nor p = −1 is a root, because F(0) = κ and F(−1) = β.

use rug::{Complex, Float};

use slipmode_core::dynamics::{Scalar, State};
use slipmode_core::friction::{EvolutionLaw, Groups};
use slipmode_core::number::{Dd, Rational};
use slipmode_core::roots::CertifiedRoot;

/// Bits of the linear algebra: far below the rounding of double-double.
pub(crate) const BITS: u32 = 160;

/// Digits of the roots, for the same reason.
pub(crate) const ROOT_DIGITS: u32 = 40;

slipmode_algebra::named! {
    /// Which of the two real directions of a mode a run starts along; a real root has only the first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Direction {
        /// The real part of the right eigenvector.
        RealPart = "real",
        /// Its imaginary part.
        ImaginaryPart = "imaginary",
    }
}

/// One root with its eigenvectors.
#[derive(Debug, Clone)]
pub(crate) struct Mode {
    pub(crate) rate: Complex,
    right: [Complex; 3],
    left: [Complex; 3],
    groups: Groups<Float>,
}

fn complex(value: impl Into<f64>) -> Complex {
    Complex::with_val(BITS, (value.into(), 0))
}

fn times(a: &Complex, b: &Complex) -> Complex {
    Complex::with_val(BITS, a * b)
}

/// (e^{λT} − 1)/λ.
fn response(rate: &Complex, time: f64) -> Complex {
    // not f64: MPC's own, correctly rounded; |λT| is of order 1 or the 160 bits have digits to spare.
    (Complex::with_val(BITS, rate * time).exp() - 1) / rate
}

impl Mode {
    pub(crate) fn of(root: &CertifiedRoot, groups: &Groups<Rational>) -> Self {
        let rate = Complex::with_val(BITS, (&root.re, &root.im));
        Self::with_rate(rate, groups)
    }

    /// The vectors that would belong to a rate; they are eigenvectors exactly when the rate is a root of eq 8.
    pub(crate) fn with_rate(p: Complex, groups: &Groups<Rational>) -> Self {
        let groups = groups.map(|group| Float::with_val(BITS, group));
        let next = Complex::with_val(BITS, &p + 1);
        let right = [complex(1), -(complex(1) / &next), -(complex(1) * &groups.stiffness_group / &p)];
        let left = [times(&p, &next) * &groups.inertial_parameter, -(p.clone() * &groups.effect_ratio), next];
        Self { rate: p, right, left, groups }
    }

    pub(crate) fn is_real(&self) -> bool {
        self.rate.imag().is_zero()
    }

    /// The modulus of the root.
    pub(crate) fn modulus(&self) -> f64 {
        Float::with_val(BITS, self.rate.abs_ref()).to_f64()
    }

    fn direction(&self, direction: Direction) -> [Float; 3] {
        let part = match direction {
            Direction::RealPart => Complex::real,
            Direction::ImaginaryPart => Complex::imag,
        };
        self.right.each_ref().map(|component| Float::with_val(BITS, part(component)))
    }

    /// The factor that gives a direction the wanted largest component.
    fn scale(&self, direction: Direction, size: f64) -> Float {
        let largest = self.direction(direction).into_iter().fold(Float::new(BITS), |l, c| l.max(&c.abs()));
        Float::with_val(BITS, size) / largest
    }

    /// The state whose largest component is `size`, along a direction of the mode.
    pub(crate) fn start(&self, direction: Direction, size: f64) -> State<Dd> {
        let scale = self.scale(direction, size);
        self.direction(direction).map(|component| Dd::from_float(&(component * &scale)))
    }

    /// w·u.
    pub(crate) fn amplitude(&self, state: &[Float; 3]) -> Complex {
        dot(&self.left, &state.each_ref().map(|component| Complex::with_val(BITS, component)))
    }

    /// (p_measured − p) to first order in the size of the start, from the quadratic terms of the equations: exact second-order
    /// perturbation theory for the projection on w after `time`.
    pub(crate) fn first_order_shift(
        &self,
        law: EvolutionLaw,
        direction: Direction,
        size: f64,
        time: f64,
    ) -> Complex {
        let scale = self.scale(direction, size);
        let normal = dot(&self.left, &self.right);
        let forced =
            |u: &[Complex; 3], v: &[Complex; 3]| dot(&self.left, &self.quadratic(law, u, v)) / &normal;
        let own = forced(&self.right, &self.right);
        if self.is_real() {
            return own * scale * response(&self.rate, time) / time;
        }
        // The start is z v + z̄ v̄ with z = scale/2 for the real and −i·scale/2 for the imaginary part.
        let conjugate = self.right.clone().map(|component| component.conj());
        let z = match direction {
            Direction::RealPart => complex(0.5) * &scale,
            Direction::ImaginaryPart => Complex::with_val(BITS, (0, -0.5)) * &scale,
        };
        let (z_bar, rate_bar) = (z.clone().conj(), self.rate.clone().conj());
        let third = Complex::with_val(BITS, 2 * &rate_bar) - &self.rate;
        let sum = own * times(&z, &z) * response(&self.rate, time)
            + 2 * forced(&self.right, &conjugate) * times(&z, &z_bar) * response(&rate_bar, time)
            + forced(&conjugate, &conjugate) * times(&z_bar, &z_bar) * response(&third, time);
        sum / z / time
    }

    /// The symmetric bilinear form whose value at (u, u) is the quadratic part of the equations.
    fn quadratic(&self, law: EvolutionLaw, u: &[Complex; 3], v: &[Complex; 3]) -> [Complex; 3] {
        let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } = &self.groups;
        let unbalanced = |u: &[Complex; 3]| Complex::with_val(BITS, &u[2] - &u[0]) - u[1].clone() * beta;
        let velocities = times(&u[0], &v[0]);
        let mixed = |i: usize, j: usize| -> Complex { times(&u[i], &v[j]) + times(&v[i], &u[j]) };
        let velocity: Complex = times(&u[0], &unbalanced(v)) + times(&v[0], &unbalanced(u));
        let state = match law {
            EvolutionLaw::Slip => -velocities.clone() - mixed(0, 1) / 2,
            EvolutionLaw::Aging => (times(&u[1], &v[1]) - &velocities) / 2,
        };
        [-(velocity / eta) / 2, state, -(velocities * kappa) / 2]
    }
}

fn dot(a: &[Complex; 3], b: &[Complex; 3]) -> Complex {
    a.iter().zip(b).fold(complex(0), |sum, (a, b)| sum + times(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::dynamics::Model;
    use slipmode_core::number::nearest_f64;
    use slipmode_core::roots::certified_roots;

    fn groups() -> Groups<Rational> {
        Groups {
            inertial_parameter: Rational::from((7, 10)),
            stiffness_group: Rational::from((2, 5)),
            effect_ratio: Rational::from((3, 2)),
        }
    }

    fn modes() -> Vec<Mode> {
        let roots = certified_roots(&groups().characteristic_cubic(), ROOT_DIGITS).roots;
        roots.iter().map(|root| Mode::of(root, &groups())).collect()
    }

    #[test]
    fn the_vectors_are_eigenvectors_of_the_models_own_jacobian() {
        let model = Model::new(groups().map(nearest_f64), EvolutionLaw::Slip);
        let arrow = model.jacobian(&[0.0; 3]);
        for mode in modes() {
            for part in [Complex::real, Complex::imag] {
                let v = mode.right.each_ref().map(|c| part(c).to_f64());
                let product = [
                    arrow.xx * v[0] + arrow.xy * v[1] + arrow.xz * v[2],
                    arrow.yx * v[0] + arrow.yy * v[1],
                    arrow.zx * v[0],
                ];
                for (found, component) in product.into_iter().zip(&mode.right) {
                    let expected = part(&times(&mode.rate, component)).to_f64();
                    assert!((found - expected).abs() < 1e-14, "{found} {expected}");
                }
            }
        }
    }

    #[test]
    fn a_left_vector_sees_its_own_mode_only() {
        let modes = modes();
        for (i, own) in modes.iter().enumerate() {
            for (j, other) in modes.iter().enumerate() {
                let product = Float::with_val(BITS, dot(&own.left, &other.right).abs_ref()).to_f64();
                assert_eq!(product < 1e-38, i != j, "{i} {j} {product:e}");
            }
        }
    }

    #[test]
    fn the_quadratic_form_is_the_second_derivative_of_the_rate() {
        let u: State<f64> = [0.3, -0.7, 0.4];
        for law in EvolutionLaw::ALL {
            let model = Model::new(groups().map(nearest_f64), law);
            // Central second difference of step 1e-3: an error of 1e-6 times the fourth derivative.
            let at = |step: f64| model.rate(&u.map(|component| component * step));
            let (low, high) = (at(-1e-3), at(1e-3));
            let mode = &modes()[0];
            let state = u.map(complex);
            let form = mode.quadratic(law, &state, &state);
            for i in 0..3 {
                let difference = (low[i] + high[i]) / 2e-6;
                assert!((form[i].real().to_f64() - difference).abs() < 1e-5, "{law:?} {i}: {difference}");
            }
        }
    }
}
