//! The polynomials whose signs decide a point, as the parameters run along lines of a box.
//!
//! In units in which all ends are integers. With s = V0·z, eq 8 times D_c σ is A z³ + B z² + C z + E with
//! A = μD_c, B = μ + aD_cσ, C = (a − b)σ + KD_c, E = K and μ = M V0².

use rug::{Complete, Integer};

use super::coefficient::Coefficient;
use super::corners::{A, Corner, D, Filtered, M, S, V};
use super::tensor::Tensor;
use crate::stability::InertialThreshold;

/// The seven parameters as polynomials, and with them all that decides a point.
pub(super) struct Lines<T>([Tensor<T>; 7]);

impl<T: Coefficient> Lines<T> {
    /// All parameters constant, but those listed, which run with an axis from their value at one corner to that at another.
    pub(super) fn between(
        filtered: &Filtered<'_>,
        [start, end]: [Corner; 2],
        running: &[(usize, usize)],
    ) -> Self {
        Self(std::array::from_fn(|i| {
            let from = T::of_parameter(filtered, i, start);
            match running.iter().find(|(parameter, _)| *parameter == i && filtered.region.is_wide(i)) {
                Some((_, axis)) => Tensor::line(*axis, from, &T::of_parameter(filtered, i, end)),
                None => Tensor::constant(from),
            }
        }))
    }

    fn inertia(&self) -> Tensor<T> {
        self.0[M].times(&self.0[V].times(&self.0[V]))
    }

    fn direct_stress_length(&self) -> Tensor<T> {
        self.0[A].times(&self.0[S]).times(&self.0[D])
    }

    /// E, C, B, A.
    fn cubic(&self) -> [Tensor<T>; 4] {
        let [a, b, d, k, _, s, _] = &self.0;
        let inertia = self.inertia();
        let second = inertia.plus(&self.direct_stress_length());
        [k.clone(), a.minus(b).times(s).plus(&k.times(d)), second, inertia.times(d)]
    }

    /// The discriminant of eq 8: negative where a pair is complex.
    pub(super) fn discriminant(&self) -> Tensor<T> {
        discriminant(&self.cubic())
    }

    /// Both are positive where all roots are below −1, and at no other place without a complex pair:
    /// aσD_c − 2μ for η < 1/2, and μ + KD_c² − (a + b)σD_c for κ + η > 1 + β.
    pub(super) fn lower_area(&self) -> [Tensor<T>; 2] {
        let [_, b, d, k, _, s, _] = &self.0;
        let (inertia, direct) = (self.inertia(), self.direct_stress_length());
        let half = direct.minus(&inertia.clone().scaled(&Integer::from(2)));
        let squared = k.times(&d.times(d));
        [half, inertia.plus(&squared).minus(&direct).minus(&b.times(s).times(d))]
    }

    /// K a D_c² − (b − a)(σ a D_c + μ), with the sign of K − K_c.
    pub(super) fn transition(&self) -> Tensor<T> {
        let [a, b, d, k, ..] = &self.0;
        let first = k.times(a).times(&d.times(d));
        first.minus(&b.minus(a).times(&self.direct_stress_length().plus(&self.inertia())))
    }

    /// What is negative where a pair oscillates above the threshold, and positive where none does. It can also be zero
    /// inside, where the real root is the pair's real part and ω twice the threshold's.
    ///
    /// With w the square of the threshold's frequency and S = 3AC − B²: Δ + 4wS² − 32w²A²S + 64w³A⁴; w = T K/μ, times μ.
    pub(super) fn frequency(&self, threshold: &InertialThreshold) -> Tensor<T> {
        let (t, n) = (threshold.squared_ratio().numer(), threshold.squared_ratio().denom());
        let cubic = self.cubic();
        let [k, c, b, _] = &cubic;
        let (inertia, length) = (self.inertia(), &self.0[D]);
        let square = length.times(length);
        let s = inertia.times(length).times(c).scaled(&Integer::from(3)).minus(&b.times(b));
        let power = |t_power: u32, n_power: u32, factor: u32| {
            let power = |base: &Integer, exponent: u32| (0..exponent).fold(Integer::from(1), |p, _| p * base);
            power(t, t_power) * power(n, n_power) * factor
        };
        let k_inertia = k.times(&inertia);
        let first = discriminant(&cubic).times(&inertia).scaled(&power(0, 3, 1));
        let second = k.times(&s.times(&s)).scaled(&power(1, 2, 4));
        let third = k_inertia.times(k).times(&square).times(&s).scaled(&power(2, 1, 32));
        let fourth =
            k_inertia.times(&k_inertia).times(k).times(&square.times(&square)).scaled(&power(3, 0, 64));
        first.plus(&second).minus(&third).plus(&fourth)
    }

    /// What is positive where a pair on the transition oscillates above the threshold, η > T/(1 − T): μ(1 − T) − T σ a D_c.
    pub(super) fn inertial_at_transition(&self, threshold: &InertialThreshold) -> Tensor<T> {
        let (t, n) = (threshold.squared_ratio().numer(), threshold.squared_ratio().denom());
        self.inertia().scaled(&(n - t).complete()).minus(&self.direct_stress_length().scaled(t))
    }

    /// The same by K, where σ has no value of its own but that of the transition: μ(b − a) − T K a D_c².
    pub(super) fn inertial_by_stiffness(&self, threshold: &InertialThreshold) -> Tensor<T> {
        let (t, n) = (threshold.squared_ratio().numer(), threshold.squared_ratio().denom());
        let [a, b, d, k, ..] = &self.0;
        let stiff = k.times(a).times(&d.times(d)).scaled(t);
        self.inertia().times(&b.minus(a)).scaled(n).minus(&stiff)
    }

    /// The same by K and σ, where μ is that of the transition: K D_c(1 − T) − (b − a)σ.
    pub(super) fn inertial_by_stress(&self, threshold: &InertialThreshold) -> Tensor<T> {
        let (t, n) = (threshold.squared_ratio().numer(), threshold.squared_ratio().denom());
        let [a, b, d, k, _, s, _] = &self.0;
        k.times(d).scaled(&(n - t).complete()).minus(&b.minus(a).times(s).scaled(n))
    }
}

/// B²C² − 4AC³ − 4B³E − 27A²E² + 18ABCE.
fn discriminant<T: Coefficient>([e, c, b, a]: &[Tensor<T>; 4]) -> Tensor<T> {
    let (bc, ae) = (b.times(c), a.times(e));
    let by = |factor: i32, tensor: Tensor<T>| tensor.scaled(&Integer::from(factor));
    let mixed = by(18, bc.clone()).minus(&by(27, ae.clone())).times(&ae);
    let cubes = a.times(c).times(&c.times(c)).plus(&b.times(e).times(&b.times(b)));
    bc.times(&bc).plus(&mixed).minus(&by(4, cubes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::ParameterBox;
    use crate::friction::Parameters;
    use crate::number::Rational;
    use crate::roots::Depressed;
    use crate::stability::over_box::coefficient::Rough;
    use crate::stability::over_box::fixtures::any_point;
    use crate::stability::{boundary_sign, transition_sign};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn constants_have_the_signs_of_the_point_test(point in any_point(), ratio in 1i64..1000) {
            let region = ParameterBox { lower: point.clone(), upper: point.clone() };
            let threshold = InertialThreshold::from_squared_ratio(Rational::from((ratio, 1000))).unwrap();
            let filtered = Filtered::new(&region, &threshold);
            let corners = [Corner::high(&[]); 2];
            let (lines, rough) = (Lines::<Integer>::between(&filtered, corners, &[]), Lines::<Rough>::between(&filtered, corners, &[]));
            let sign = |tensor: Tensor<Integer>, rough: Tensor<Rough>| {
                let (exact, rough) = (tensor.at_corner([false; 3]).clone(), *rough.at_corner([false; 3]));
                let mut negated = rough;
                negated.times(&Rough::whole(&Integer::from(-1)));
                assert!(!(negated.is_negative() && exact <= 0 || rough.is_negative() && exact >= 0));
                exact.cmp0() as i8
            };
            let groups = Parameters::from(point).groups();
            let cubic = Depressed::of(&groups.characteristic_cubic()).unwrap();
            prop_assert_eq!(sign(lines.transition(), rough.transition()), transition_sign(&groups));
            prop_assert_eq!(sign(lines.discriminant(), rough.discriminant()), boundary_sign(&groups));
            let inertial = sign(lines.frequency(&threshold), rough.frequency(&threshold)) < 0;
            prop_assert_eq!(inertial, boundary_sign(&groups) < 0 && threshold.exceeded_by(&cubic));
        }
    }
}
