//! One step of an enclosure: Taylor series of the centre and of the whole set, with a remainder over a box that holds the motion.
//!
//! For t in [0, h] the motion lies in Σ_{k<n} t^k f_k(hull) + t^n f_n(B) if this set lies inside B (Nedialkov, Jackson & Pryce, *An effective high-order
//! interval method for validating existence and uniqueness of the solution of an IVP for an ODE*, 2001). The derivatives by
//! the initial state obey an equation of the same kind and are enclosed with the state.

use crate::interval::{Interval, generously_up, worse};
use crate::lanes::Lanes;
use crate::linear::{Square, apply};
use crate::set::Set;
use slipmode_core::number::dispatch::{Kernel, run_on_widest_unit};

/// The order n of the remainder.
pub(super) const ORDER: usize = 22;

/// Terms of order n aimed at: of the state, over its size, and of the derivatives by the initial state.
const AIM: f64 = 2e-17;
const AIM_OF_SLOPE: f64 = 1e-12;

/// The largest remainder of a step that is taken.
const LARGEST: f64 = 3e-16;
const LARGEST_OF_SLOPE: f64 = 1e-10;

/// How much larger the term of order n may be over the box than before, and how many boxes are tried.
const MARGIN: f64 = 4.0;
const TRIALS: usize = 3;

/// The lanes of a state with its derivatives: as many as fill a vector unit.
const LANES: usize = 4;

/// The Taylor coefficients 0 … n of N components and of the elapsed time, which is the last of C = N + 1 components.
pub(super) type Series<const M: usize, const C: usize> = [[Lanes<M>; C]; ORDER + 1];

/// Equations of motion of N components.
pub(super) trait System<const N: usize, const C: usize>: Sized {
    /// All coefficients of a solution, from those of order zero: `#[inline(always)]`, so that it is compiled for each vector unit.
    fn expand<const M: usize>(&self, series: &mut Series<M, C>);

    /// The coefficients of the solution through a state; those of order zero are the state.
    fn series<const M: usize>(&self, start: &[Lanes<M>; N]) -> Series<M, C> {
        let mut series = [[Lanes::ZERO; C]; ORDER + 1];
        series[0][..N].copy_from_slice(start);
        run_on_widest_unit(Recursion { system: self, series: &mut series });
        series
    }
}

/// The recursion of the coefficients.
struct Recursion<'a, S, const N: usize, const C: usize, const M: usize> {
    system: &'a S,
    series: &'a mut Series<M, C>,
}

impl<S: System<N, C>, const N: usize, const C: usize, const M: usize> Kernel for Recursion<'_, S, N, C, M> {
    #[inline(always)]
    fn run(self) {
        self.system.expand(self.series);
    }
}

/// The series at a set: over its hull with derivatives, and at its centre.
pub(super) struct Expansion<const N: usize, const C: usize> {
    hull: Series<LANES, C>,
    pub centre: Series<1, C>,
}

/// What one step encloses.
pub(super) struct Step<const N: usize, const C: usize> {
    /// The states of the whole step.
    pub during: [Interval; N],
    /// The image of the centre.
    pub image: [Interval; N],
    /// The derivative by the initial state, at the end.
    pub slope: Square<N>,
    /// The largest sum of sizes in a row of the derivative, during the step.
    pub largest_slope: f64,
    /// Time that passes, from any point of the set.
    pub duration: Interval,
}

impl<const N: usize, const C: usize> Expansion<N, C> {
    pub fn new(system: &impl System<N, C>, set: &Set<N>) -> Self {
        let hull = set.hull();
        let unit: [Lanes<LANES>; N] = std::array::from_fn(|i| {
            Lanes::new(std::array::from_fn(|l| match l {
                0 => hull[i],
                _ if l == i + 1 => Interval::ONE,
                _ => Interval::ZERO,
            }))
        });
        let centre = set.centre.map(|c| Lanes::new([Interval::point(c)]));
        Self { hull: system.series(&unit), centre: system.series(&centre) }
    }

    /// The length at which the terms of order n are as small as aimed at.
    pub fn length(&self) -> f64 {
        let of_order = |order: usize| {
            let mut least = f64::INFINITY;
            for component in 0..N {
                let term = &self.hull[order][component];
                let size = 1.0 + self.hull[0][component].mid[0].abs();
                let slopes = (1..C).fold(0.0, |largest, l| worse(largest, term.mid[l].abs()));
                for (term, aim) in [(term.mid[0].abs(), AIM * size), (slopes, AIM_OF_SLOPE)] {
                    if term > 0.0 {
                        least = least.min(aim / term);
                    }
                }
            }
            libm::pow(least, 1.0 / order as f64)
        };
        of_order(ORDER - 1).min(of_order(ORDER))
    }

    /// The step of length h, if a box is found that holds it; `disturbance` bounds what moves the state beside the equations.
    pub fn step(
        &self,
        system: &impl System<N, C>,
        set: &Set<N>,
        h: f64,
        disturbance: f64,
    ) -> Option<Step<N, C>> {
        self.step_within(system, set, h, disturbance, [LARGEST, LARGEST_OF_SLOPE])
    }

    /// The same with other limits of the remainder: of the state, and of the derivatives.
    fn step_within(
        &self,
        system: &impl System<N, C>,
        set: &Set<N>,
        h: f64,
        disturbance: f64,
        [largest, largest_of_slope]: [f64; 2],
    ) -> Option<Step<N, C>> {
        let length = Interval::point(h);
        let power = (0..ORDER).fold(Interval::ONE, |power, _| power * length);
        let range: [Interval; N] = std::array::from_fn(|i| self.range(i, h).widened(disturbance));
        let spread: Square<N> = std::array::from_fn(|i| self.spread(i, h));
        let widen =
            |range: Interval, by: f64| range.widened(by + 1e-13 * range.magnitude() + f64::MIN_POSITIVE);
        let mut terms = self.hull[ORDER].map(|term| term.scaled(power));
        for _ in 0..TRIALS {
            let margins = margins::<N, C>(&terms);
            let during: [Interval; N] = std::array::from_fn(|i| widen(range[i], margins[0]));
            let slopes: Square<N> =
                std::array::from_fn(|i| std::array::from_fn(|j| widen(spread[i][j], margins[1])));
            let start: [Lanes<LANES>; N] = std::array::from_fn(|i| {
                Lanes::new(std::array::from_fn(|l| match l {
                    0 => during[i],
                    _ if l <= N => slopes[i][l - 1],
                    _ => Interval::ZERO,
                }))
            });
            terms = system.series(&start)[ORDER].map(|term| term.scaled(power));
            let holds = |i: usize, l: usize, range: Interval, inside: Interval| {
                range.widened(terms[i].lane(l).magnitude()).is_inside(inside)
            };
            let all = (0..N).all(|i| {
                holds(i, 0, range[i], during[i])
                    && (0..N).all(|j| holds(i, j + 1, spread[i][j], slopes[i][j]))
            });
            let is_small = (0..N).all(|i| {
                terms[i].lane(0).magnitude() < largest * (1.0 + during[i].magnitude())
                    && (1..C).all(|l| terms[i].lane(l).magnitude() < largest_of_slope)
            });
            if !is_small {
                // A larger box has larger terms.
                return None;
            }
            if all && terms[N].lane(0).is_bounded() {
                return Some(self.enclosed(set, length, &during, &slopes, &terms));
            }
        }
        None
    }

    /// The image of the set under a step that its box holds; `last` is the remainder.
    fn enclosed(
        &self,
        set: &Set<N>,
        length: Interval,
        during: &[Interval; N],
        slopes: &Square<N>,
        last: &[Lanes<LANES>; C],
    ) -> Step<N, C> {
        let at_centre = |i: usize| value(&self.centre, i, length).lane(0) + last[i].lane(0);
        let slope_of = |i: usize| -> [Interval; N] {
            let end = value(&self.hull, i, length) + last[i];
            std::array::from_fn(|j| end.lane(j + 1))
        };
        let of_hull = apply(&[slope_of(N)], &set.offsets())[0];
        Step {
            during: *during,
            image: std::array::from_fn(at_centre),
            slope: std::array::from_fn(slope_of),
            largest_slope: crate::linear::largest_row(slopes),
            duration: at_centre(N) + of_hull,
        }
    }

    /// Encloses a component of the hull's series, without its last term, over [0, h].
    fn range(&self, component: usize, h: f64) -> Interval {
        const PIECES: usize = 4;
        let part = |i: usize| h * i as f64 / PIECES as f64;
        let lengths: Lanes<PIECES> =
            Lanes::new(std::array::from_fn(|i| Interval::between(part(i), part(i + 1))));
        let terms = self.hull[..ORDER].iter().rev().map(|term| Lanes::all(term[component].lane(0)));
        let pieces = terms.fold(Lanes::ZERO, |sum, term| sum.times(&lengths) + term);
        (1..PIECES).fold(pieces.lane(0), |hull, i| hull.hull(pieces.lane(i)))
    }

    /// The same for its derivatives, from the sizes of their terms.
    fn spread(&self, component: usize, h: f64) -> [Interval; N] {
        let (mut power, mut sums) = (1.0, [0.0; LANES]);
        for term in &self.hull[1..ORDER] {
            power *= h;
            for (l, sum) in sums.iter_mut().enumerate() {
                *sum += power * term[component].lane(l).magnitude();
            }
        }
        let start = &self.hull[0][component];
        std::array::from_fn(|j| start.lane(j + 1).widened(generously_up(sums[j + 1])))
    }

    /// The length at which a function of the length changes its sign within the step; none where it does not.
    pub fn crossing(&self, h: f64, at: impl Fn(f64) -> f64) -> Option<f64> {
        let (mut low, mut high) = (0.0, h);
        let rises = at(h) > 0.0;
        if (at(0.0) > 0.0) == rises {
            return None;
        }
        while let middle = 0.5 * (low + high)
            && middle > low
            && middle < high
        {
            if (at(middle) > 0.0) == rises { high = middle } else { low = middle }
        }
        Some(if at(low).abs() < at(high).abs() && low > 0.0 { low } else { high })
    }

    /// ln(V/V_l), the first component, of the centre.
    pub fn velocity_at(&self, length: f64) -> f64 {
        let terms = self.centre[1..ORDER].iter().rev();
        self.centre[0][0].mid[0] + terms.fold(0.0, |sum, term| (sum + term[0].mid[0]) * length)
    }

    /// Its derivative.
    pub fn acceleration_at(&self, length: f64) -> f64 {
        let terms = self.centre[..ORDER].iter().enumerate().skip(1).rev();
        terms.fold(0.0, |sum, (k, term)| sum * length + k as f64 * term[0].mid[0])
    }
}

/// How far the box exceeds the range: of the state, and of the derivatives.
fn margins<const N: usize, const C: usize>(terms: &[Lanes<LANES>; C]) -> [f64; 2] {
    let largest = |lanes: std::ops::Range<usize>| {
        let sizes = terms[..N].iter().flat_map(|term| lanes.clone().map(|l| term.lane(l).magnitude()));
        MARGIN * sizes.fold(0.0, worse)
    };
    [largest(0..1), largest(1..C)]
}

/// A component of a series without its last term.
fn value<const M: usize, const C: usize>(
    series: &Series<M, C>,
    component: usize,
    length: Interval,
) -> Lanes<M> {
    let terms = series[..ORDER].iter().rev();
    terms.fold(Lanes::ZERO, |sum, term| sum.scaled(length) + term[component])
}

#[cfg(test)]
mod tests {
    use crate::Constants;
    use crate::inertial::Inertial;
    use crate::linear::multiply;
    use crate::set::COORDINATES;
    use rug::Float;

    use super::*;
    use crate::lanes::{Factor, product};
    use slipmode_core::friction::EvolutionLaw;
    use slipmode_core::number::split_mix::SplitMix64;

    fn is_disjoint<const N: usize>(a: &[Interval; N], b: &[Interval; N]) -> bool {
        a.iter().zip(b).any(|(a, b)| a.upper() < b.lower() || b.upper() < a.lower())
    }

    /// How many of three faults in the longest step that its box holds are noticed by 64 steps of a part of its length, whose remainders are
    /// smaller by 64^22: no remainder of the state, none of the derivative, and the term of order n at the start in place of that over the box.
    fn noticed<const N: usize, const C: usize>(system: &impl System<N, C>, state: [f64; N]) -> usize {
        const PARTS: u8 = 64;
        const NO_LIMITS: [f64; 2] = [f64::INFINITY; 2];
        let no_slope = [[Interval::ZERO; COORDINATES]; N];
        let start = Set::new([Interval::ZERO; COORDINATES], state.map(Interval::point), no_slope);
        let lengths = (0..200).map(|i| 1e3 * libm::pow(0.9, f64::from(i)));
        let longest = |h: f64| {
            let expansion = Expansion::new(system, &start);
            Some((h, expansion.step_within(system, &start, h, 0.0, NO_LIMITS)?))
        };
        let (h, step) = lengths.filter_map(longest).next().unwrap();
        let (mut set, mut slope) = (start.clone(), None);
        for _ in 0..PARTS {
            let expansion = Expansion::new(system, &set);
            let part = expansion.step(system, &set, h / f64::from(PARTS), 0.0).unwrap();
            set = set.mapped(part.image, &part.slope, &no_slope);
            slope = Some(slope.map_or(part.slope, |before| multiply(&part.slope, &before)));
        }
        let (reference, slope) = (set.hull(), slope.unwrap());
        let excludes_slope =
            |found: &Square<N>| found.iter().zip(&slope).any(|(found, slope)| is_disjoint(found, slope));
        assert!(!is_disjoint(&step.image, &reference) && !excludes_slope(&step.slope));
        let expansion = Expansion::new(system, &start);
        let with = |last: &[Lanes<LANES>; C]| {
            expansion.enclosed(&start, Interval::point(h), &step.during, &step.slope, last)
        };
        let without = with(&[Lanes::ZERO; C]);
        let power = (0..ORDER).fold(Interval::ONE, |power, _| power * Interval::point(h));
        let of_start = with(&expansion.hull[ORDER].map(|term| term.scaled(power)));
        let faults = [
            is_disjoint(&without.image, &reference),
            excludes_slope(&without.slope),
            is_disjoint(&of_start.image, &reference),
        ];
        faults.into_iter().filter(|&is_noticed| is_noticed).count()
    }

    #[test]
    fn a_step_with_a_wrong_remainder_misses_the_motion() {
        let mut found = 0;
        for law in EvolutionLaw::ALL {
            let slider = |inertia: f64| Constants {
                inertia: Interval::point(inertia),
                stiffness: Interval::point(0.3),
                effect_ratio: Interval::point(1.5),
                law,
            };
            found += noticed(&Inertial(&slider(0.5)), [1e-3, 2e-3, 1e-4]);
            found += noticed(&Inertial(&slider(0.5)), [-2e-3, 1e-3, 3e-3]);
        }
        assert_eq!(found, 12);
    }

    /// x' = λx, with the clock t' = x.
    struct Growth(f64);

    impl System<1, 2> for Growth {
        fn expand<const M: usize>(&self, out: &mut Series<M, 2>) {
            for k in 0..ORDER {
                let part = Interval::point((k + 1) as f64).reciprocal();
                let x = out[k][0].scaled(part);
                out[k + 1] = [x.scaled(Interval::point(self.0)), x];
            }
        }
    }

    /// The same without derivatives by the initial state: only the state's own check can refuse.
    struct StateAlone(f64);

    impl System<1, 2> for StateAlone {
        fn expand<const M: usize>(&self, out: &mut Series<M, 2>) {
            let of_state = |lanes: Lanes<M>| {
                Lanes::new(std::array::from_fn(|l| if l == 0 { lanes.lane(0) } else { Interval::ZERO }))
            };
            Growth(self.0).expand(out);
            out[1..].iter_mut().for_each(|terms| *terms = terms.map(of_state));
        }
    }

    /// The derivatives alone: the state rests, and only the check of the derivatives can refuse.
    struct DerivativesAlone(f64);

    impl System<1, 2> for DerivativesAlone {
        fn expand<const M: usize>(&self, out: &mut Series<M, 2>) {
            let of_derivatives = |lanes: Lanes<M>| {
                Lanes::new(std::array::from_fn(|l| if l == 0 { Interval::ZERO } else { lanes.lane(l) }))
            };
            Growth(self.0).expand(out);
            out[1..].iter_mut().for_each(|terms| *terms = terms.map(of_derivatives));
        }
    }

    /// x' = x², whose solution x/(1 − xt) ends at t = 1/x, with the clock t' = 1.
    struct Riccati;

    impl System<1, 2> for Riccati {
        fn expand<const M: usize>(&self, out: &mut Series<M, 2>) {
            let mut factors = [Factor::<M>::ZERO; ORDER + 1];
            for k in 0..ORDER {
                let part = Interval::point((k + 1) as f64).reciprocal();
                factors[k] = out[k][0].into();
                let clock = if k == 0 { Lanes::ZERO.plus(Interval::ONE) } else { Lanes::ZERO };
                out[k + 1] = [product(&factors, &factors, k).scaled(part), clock];
            }
        }
    }

    /// A step of any length is refused, or holds the solution: of x' = x² from points and boxes, also beyond its end, where there is none.
    #[test]
    fn no_step_reaches_beyond_the_end_of_a_solution() {
        let mut taken = 0;
        for [from, to] in
            [[1.0, 1.0], [0.5, 1.0], [-0.2, 0.2], [-1.0, 0.25], [-1.0, -1.0], [0.0, 0.0], [-0.5, 0.5]]
        {
            let set = Set::new(
                [Interval::ZERO; COORDINATES],
                [Interval::between(from, to)],
                [[Interval::ONE, Interval::ZERO]],
            );
            let expansion = Expansion::new(&Riccati, &set);
            for h in (1..200).map(|i| 0.02 * f64::from(i)).chain([10.0, 100.0, 1e4, 1e8]) {
                let Some(step) = expansion.step_within(&Riccati, &set, h, 0.0, [f64::INFINITY; 2]) else {
                    continue;
                };
                taken += 1;
                for part in 0..=4 {
                    let start = from + (to - from) * f64::from(part) / 4.0;
                    assert!(start * h < 1.0, "{from} {to} {h}: there is no solution");
                    for time in [0.0, 0.3 * h, 0.8 * h, h] {
                        let at = |h: f64| start / (1.0 - start * h);
                        let slope = 1.0 / ((1.0 - start * time) * (1.0 - start * time));
                        assert!(
                            step.during[0].widened(1e-14).may_contain(at(time)),
                            "{from} {to} {h} {time}"
                        );
                        assert!(
                            step.largest_slope >= slope * (1.0 - 1e-14),
                            "{from} {to} {h} {time} {slope} {}",
                            step.largest_slope
                        );
                    }
                    let slope = 1.0 / ((1.0 - start * h) * (1.0 - start * h));
                    assert!(step.slope[0][0].widened(1e-14 * slope).may_contain(slope), "{from} {to} {h}");
                    assert!(step.duration.may_contain(h));
                }
                let centre = set.centre[0];
                assert!(
                    step.image[0].widened(1e-14).may_contain(centre / (1.0 - centre * h)),
                    "{from} {to} {h}"
                );
            }
        }
        assert!(taken > 100, "{taken}");
    }

    /// Steps so long that e^{λh} is far beyond the powers of the remainder: the state's check alone, and that of the derivatives alone.
    #[test]
    fn a_step_that_its_box_does_not_hold_is_refused() {
        for z in (0..140).map(|i| 5.0 * f64::from(i + 1)) {
            let point = |x: f64| {
                Set::new(
                    [Interval::ZERO; COORDINATES],
                    [Interval::point(x)],
                    [[Interval::ONE, Interval::ZERO]],
                )
            };
            let limits = [f64::INFINITY; 2];
            let growth = libm::exp(z);
            let state = point(1.0);
            if let Some(step) =
                Expansion::new(&StateAlone(1.0), &state).step_within(&StateAlone(1.0), &state, z, 0.0, limits)
            {
                assert!(
                    step.during[0].upper() >= growth && step.image[0].upper() >= growth * (1.0 - 1e-12),
                    "{z} {:?}",
                    step.during
                );
            }
            if let Some(step) = Expansion::new(&DerivativesAlone(1.0), &state).step_within(
                &DerivativesAlone(1.0),
                &state,
                z,
                0.0,
                limits,
            ) {
                assert!(
                    step.largest_slope >= growth && step.slope[0][0].upper() >= growth * (1.0 - 1e-12),
                    "{z} {:?}",
                    step.slope
                );
            }
        }
    }

    /// A short step rounds a few times only, and all of it is enclosed: e^{1/1024} to 400 bits.
    #[test]
    fn the_rounding_of_a_step_is_enclosed() {
        let mut random = SplitMix64(4);
        for _ in 0..200 {
            let x = 0.5 + random.unit();
            let set = Set::new(
                [Interval::ZERO; COORDINATES],
                [Interval::point(x)],
                [[Interval::ONE, Interval::ZERO]],
            );
            let step =
                Expansion::new(&Growth(1.0), &set).step(&Growth(1.0), &set, 1.0 / 1024.0, 0.0).unwrap();
            let exact = Float::with_val(400, 1.0 / 1024.0).exp() * x;
            assert!((exact - step.image[0].mid).abs() <= step.image[0].rad && step.image[0].rad < 1e-14);
        }
    }

    /// Steps of all lengths from points and boxes: each that is taken holds x₀e^{λt}, its derivative and the time x₀(e^{λh} − 1)/λ.
    #[test]
    fn each_step_of_a_linear_system_holds_the_solution() {
        let mut taken = 0;
        for (rate, [from, to], by_p) in
            [(1.0, [1.0, 1.0], 0.0), (1.0, [0.5, 1.5], 0.0), (-1.0, [1.0, 1.2], 0.3), (2.0, [0.0, 0.0], 0.0)]
        {
            let state = Interval::between(from + by_p, to - by_p);
            let section = [Interval::symmetric(by_p), Interval::ZERO];
            let set = Set::new(section, [state], [[Interval::ONE, Interval::ZERO]]);
            let expansion = Expansion::new(&Growth(rate), &set);
            for (h, disturbance) in (0..60).map(|i| (0.5 * f64::from(i + 1), 0.01 * f64::from(i % 3))) {
                let limits = [f64::INFINITY; 2];
                let Some(step) = expansion.step_within(&Growth(rate), &set, h, disturbance, limits) else {
                    continue;
                };
                taken += 1;
                let holds = |c: Interval, value: f64| {
                    let error = 1e-14 * value.abs();
                    c.lower() <= value + error && value - error <= c.upper()
                };
                let growth = libm::exp(rate * h);
                for start in [from, to, 0.5 * (from + to)] {
                    for part in 0..=8 {
                        let x = start * libm::exp(rate * h * f64::from(part) / 8.0);
                        assert!([x - disturbance, x + disturbance].iter().all(|&x| holds(step.during[0], x)));
                    }
                    assert!(holds(step.duration, start * libm::expm1(rate * h) / rate), "{rate} {h} {start}");
                }
                let centre = set.centre[0];
                assert!(holds(step.image[0], centre * growth) && holds(step.slope[0][0], growth));
                assert!(step.largest_slope >= growth.max(1.0) * (1.0 - 1e-14), "{rate} {h}");
            }
        }
        assert!(taken > 20, "{taken}");
    }
}
