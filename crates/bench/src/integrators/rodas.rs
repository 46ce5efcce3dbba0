//! Rodas5P: a Rosenbrock method of order 5 with an embedded one of order 4, stiffly accurate and L-stable.
//!
//! Steinebach, *Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia
//! Differential Equations package*, BIT 63:27 (2023); the constants are published to double precision, so that this method
//! is of no use beyond it. One factorisation and eight stages a step, no iteration: the method for loose tolerances.

use slipmode_core::dynamics::{Factors, Model, Scalar, State, Stepper, Trial, Weight};

const STAGES: usize = 8;

/// γ, the diagonal of the method.
const GAMMA: f64 = 0.211_937_563_194_290_14;

/// Weights of earlier stages in a stage's argument; the last two stages add the stage before with weight 1.
#[rustfmt::skip]
const ARGUMENT: [[f64; 5]; 6] = [
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0, 0.0, 0.0, 0.0, 0.0],
    [2.849394379747939, 0.45842242204463923, 0.0, 0.0, 0.0],
    [-6.954028509809101, 2.489845061869568, -10.358996098473584, 0.0, 0.0],
    [2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641, 0.0],
    [-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946],
];

/// Weights of earlier stages in a stage's right-hand side, over the step.
#[rustfmt::skip]
const COUPLING: [[f64; 7]; STAGES] = [
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-14.155112264123755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-17.97296035885952, -2.859693295451294, 0.0, 0.0, 0.0, 0.0, 0.0],
    [147.12150275711716, -1.41221402718213, 71.68940251302358, 0.0, 0.0, 0.0, 0.0],
    [165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306, 0.0, 0.0, 0.0],
    [24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471, 0.0, 0.0],
    [30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783, -19.097331116725623, -28.087943162872662, 0.0],
    [37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047, -40.06618937091002, -54.66780262877968, -9.48861652309627],
];

/// Dense output of order 4: weights of the stages in the three vectors of its polynomial.
#[rustfmt::skip]
const DENSE: [[f64; STAGES]; 3] = [
    [25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204, 0.524948541321073, 1.1241088310450404, 0.4272876194431874, -0.17202221070155493],
    [-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796, 20.176138334709044, 15.98066361424651, -6.789040303419874, -6.710236069923372],
    [11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643, -52.072871366152654, -59.78993625266729, -0.15582684282751913, 4.883087185713722],
];

/// The method and the polynomial of its last step.
#[derive(Debug, Clone)]
pub struct Rodas5P<R> {
    polynomial: [State<R>; 4],
    evaluations: u64,
}

impl<R: Scalar> Rodas5P<R> {
    /// The method.
    #[must_use]
    pub fn new() -> Self {
        Self { polynomial: std::array::from_fn(|_| zero()), evaluations: 0 }
    }

    /// y(θ) = y0 (1−θ) + θ (y1 + (1−θ)(k1 + θ (k2 + θ k3))), by powers of θ.
    fn set_polynomial(&mut self, increment: &State<R>, stages: &[State<R>]) {
        let k: [State<R>; 3] = std::array::from_fn(|row| combine(&DENSE[row], stages));
        for c in 0..3 {
            let (k1, k2, k3) = (k[0][c].clone(), k[1][c].clone(), k[2][c].clone());
            self.polynomial[0][c] = increment[c].clone() + &k1;
            self.polynomial[1][c] = k2.clone() - k1;
            self.polynomial[2][c] = k3.clone() - k2;
            self.polynomial[3][c] = -k3;
        }
    }
}

impl<R: Scalar> Default for Rodas5P<R> {
    fn default() -> Self {
        Self::new()
    }
}

fn zero<R: Scalar>() -> State<R> {
    std::array::from_fn(|_| R::from(0))
}

fn combine<R: Scalar>(weights: &[f64], stages: &[State<R>]) -> State<R> {
    std::array::from_fn(|c| {
        let terms = weights.iter().zip(stages);
        terms.fold(R::from(0), |sum, (&w, k)| sum + R::from_f64(w) * &k[c])
    })
}

impl<R: Scalar> Stepper<R> for Rodas5P<R> {
    const ERROR_EXPONENT: u32 = 5;

    fn attempt(&mut self, model: &Model<R>, from: &State<R>, h: &R, weight: Weight) -> Option<Trial<R>> {
        // (1/γ − hJ) k_i = h f(argument) + Σ c_ij k_j.
        let jacobian = model.jacobian(from).map(|entry| entry.clone() * h);
        let factors = Factors::new(&R::from_f64(1.0 / GAMMA), &jacobian);
        let mut stages: [State<R>; STAGES] = std::array::from_fn(|_| zero());
        let mut increment = zero();
        for i in 0..STAGES {
            increment = match i {
                0..6 => combine(&ARGUMENT[i], &stages[..i.min(5)]),
                _ => std::array::from_fn(|c| increment[c].clone() + &stages[i - 1][c]),
            };
            let state = std::array::from_fn(|c| from[c].clone() + &increment[c]);
            let rate = model.rate(&state);
            let coupled = combine(&COUPLING[i], &stages[..i]);
            let right: State<R> = std::array::from_fn(|c| rate[c].clone() * h + &coupled[c]);
            stages[i] = factors.solve(&jacobian, right);
        }
        self.evaluations += STAGES as u64;
        increment = std::array::from_fn(|c| increment[c].clone() + &stages[STAGES - 1][c]);
        self.set_polynomial(&increment, &stages);
        // The last stage is the difference between the two methods.
        let largest = stages[STAGES - 1].iter().fold(0.0f64, |largest, e| largest.max(e.to_f64().abs()));
        let to: State<R> = std::array::from_fn(|c| from[c].clone() + &increment[c]);
        let finite = to.iter().all(Scalar::is_finite) && largest.is_finite();
        finite.then(|| Trial { to, error: largest / weight.absolute })
    }

    fn polynomial(&self) -> &[State<R>] {
        &self.polynomial
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::dynamics::{Radau, increment};
    use slipmode_core::friction::{EvolutionLaw, Groups};

    fn defect(h: f64) -> (f64, f64) {
        let groups = Groups { inertial_parameter: 3.0, stiffness_group: 2.0, effect_ratio: 1.5 };
        let model = Model::new(groups, EvolutionLaw::Aging);
        let weight = Weight { absolute: 1e-14, noise: 1e-16 };
        let from = [0.3, -0.2, 0.1];
        let mut method = Rodas5P::new();
        let trial = method.attempt(&model, &from, &h, weight).unwrap();
        let exact = Radau::<f64, 7>::new().attempt(&model, &from, &h, weight).unwrap().to;
        let middle = Radau::<f64, 7>::new().attempt(&model, &from, &(0.5 * h), weight).unwrap().to;
        let dense = increment(method.polynomial(), &0.5);
        (f64::abs(trial.to[0] - exact[0]), f64::abs(from[0] + dense[0] - middle[0]))
    }

    #[test]
    fn a_step_has_order_five_and_its_polynomial_order_four() {
        // Halving the step divides the local error by 2^6 and that of the polynomial by 2^5, to leading order.
        let (coarse, fine) = (defect(0.2), defect(0.1));
        let (step, dense) = (libm::log2(coarse.0 / fine.0), libm::log2(coarse.1 / fine.1));
        assert!((5.3..6.7).contains(&step), "{step}");
        assert!((4.3..6.0).contains(&dense), "{dense}");
    }
}
