//! A limit cycle: Krawczyk's test on the return map of a section, then the multipliers.

use super::crossing::Crossing;
use super::guess::{Guess, guess};
use super::interval::{Interval, generously_up, up};
use super::linear::{Square, apply, multiply, points, worse};
use super::manifold::Manifold;
use super::motion::{Motion, States};
use super::observed::Observed;
use super::set::{COORDINATES, Set};
use super::{Certificate, Constants, MOST_STEPS, Proved, Reason, Units};
use crate::dynamics::{Cycle, Model};

/// Corrections of the point before the proof.
const CORRECTIONS: usize = 4;
/// A correction below this, or below this part of its own width, is the last one.
const SMALL: f64 = 1e-13;
const PART_OF_WIDTH: f64 = 0.3;
/// The radius of the first box over what Krawczyk's operator makes of a point, and the growth of the next ones.
const FIRST: f64 = 1.5;
const GROWTH: f64 = 3.0;
/// How much more a box has than the operator is expected to need.
const SPARE: f64 = 1.3;
const BOXES: usize = 3;
/// The longest steps, as parts of the length aimed at. Where V is largest, the longer ones can lose a set.
const LONGEST: f64 = 1.0;
const SHORT: f64 = 0.5;

/// Certifies the cycle near the one of a simulation.
pub(super) fn certify(
    constants: &Constants,
    model: &Model<f64>,
    cycle: &Cycle<f64>,
    units: &Units,
) -> Result<Certificate, Reason> {
    if cycle.returns_per_cycle != 1 {
        return Err(Reason::SeveralReturns(cycle.returns_per_cycle));
    }
    let (test, crossing, observed) = Test::near(constants, model, cycle)?;
    test.attracting(&crossing, &observed, units)
}

/// Proves the cycle of a stated box again, by one return of the box.
pub(super) fn prove_again(
    constants: &Constants,
    stated: &Proved,
    units: &Units,
) -> Result<Certificate, Reason> {
    long_or_short(|longest| {
        let test = Test::of(stated, longest).ok_or(Reason::NotContained)?;
        let (crossing, observed, value) = test.mapped(constants)?;
        if !test.contains(&value) {
            return Err(Reason::NotContained);
        }
        test.attracting(&crossing, &observed, units)
    })
}

/// With the longest steps, or with short ones where no enclosure of those holds.
fn long_or_short<T>(prove: impl Fn(f64) -> Result<T, Reason>) -> Result<T, Reason> {
    prove(LONGEST).or_else(|reason| match reason {
        Reason::NoEnclosure => prove(SHORT),
        other => Err(other),
    })
}

/// A point of a section near a cycle, and the ends of a box around it.
///
/// A box around the point that holds these ends is followed, so that Krawczyk's test says of all between them that one cycle at most
/// passes there. That one does pass is said only where the operator's values lie between them too.
#[derive(Debug, Clone, Copy)]
pub(super) struct Test {
    found: Guess,
    ends: [[f64; 2]; COORDINATES],
    /// The longest step, as a part of the length aimed at.
    longest: f64,
}

impl Test {
    /// A box that the operator maps into itself, with the return that it was mapped by.
    pub fn near(
        constants: &Constants,
        model: &Model<f64>,
        cycle: &Cycle<f64>,
    ) -> Result<(Self, Crossing, Observed), Reason> {
        let found = guess(constants, model, cycle)?;
        let with_steps = |longest: f64| {
            let mut test = Self { found, ends: [[0.0; 2]; COORDINATES], longest };
            test.correct(constants)?;
            test.grow(constants)
        };
        long_or_short(with_steps)
    }

    /// The box that a certificate states; none of a decay.
    fn of(stated: &Proved, longest: f64) -> Option<Self> {
        let Proved::Cycle { section_log_velocity, state_box, second_box, is_on_slow_manifold, .. } = stated
        else {
            return None;
        };
        let ends = [*state_box, *second_box];
        let found = Guess {
            section: *section_log_velocity,
            point: ends.map(|[low, high]| 0.5 * (low + high)),
            is_on_slow_manifold: *is_on_slow_manifold,
        };
        Some(Self { found, ends, longest })
    }

    /// The point in the coordinates of the section: (y, F), or (y, ψ) with ψ = 0.
    const fn centre(&self) -> [f64; COORDINATES] {
        let [y, force] = self.found.point;
        [y, if self.found.is_on_slow_manifold { 0.0 } else { force }]
    }

    /// States a box that holds all within `radius` of the point.
    fn set_radius(&mut self, radius: [f64; COORDINATES]) {
        let centre = self.centre();
        self.ends = std::array::from_fn(|i| {
            let side = Interval { mid: centre[i], rad: radius[i] };
            [side.lower(), side.upper()]
        });
    }

    /// The radii of a box around the point that holds the stated one.
    fn radius(&self) -> [f64; COORDINATES] {
        let centre = self.centre();
        std::array::from_fn(|i| up((self.ends[i][1] - centre[i]).max(centre[i] - self.ends[i][0])))
    }

    /// Newton's steps, with a box that is a point but for ψ.
    fn correct(&mut self, constants: &Constants) -> Result<(), Reason> {
        let is_tube = |i: usize| self.found.is_on_slow_manifold && i == 1;
        let map = self.map(constants);
        let mut radius = [0.0; COORDINATES];
        for _ in 0..CORRECTIONS {
            let (crossing, _) = map.image(self.found.point, radius)?;
            let value = Krawczyk::of(&crossing, &self.centre(), radius).value;
            let change = value.map(|c| c.mid);
            radius = std::array::from_fn(|i| if is_tube(i) { 2.0 * value[i].magnitude() } else { 0.0 });
            self.found.point =
                std::array::from_fn(|i| self.found.point[i] + if is_tube(i) { 0.0 } else { change[i] });
            let is_small = |i: usize| change[i].abs() < SMALL.max(PART_OF_WIDTH * value[i].rad);
            if (0..COORDINATES).all(is_small) {
                break;
            }
        }
        self.set_radius(radius);
        Ok(())
    }

    /// Larger boxes, until one is mapped into itself.
    fn grow(mut self, constants: &Constants) -> Result<(Self, Crossing, Observed), Reason> {
        let mut scale = FIRST;
        for _ in 0..=BOXES {
            let (crossing, observed, value) = self.mapped(constants)?;
            if self.contains(&value) {
                return Ok((self, crossing, observed));
            }
            let mut radius = value.map(|c| scale * c.magnitude() + f64::MIN_POSITIVE);
            // With the derivative found so far, what each side of the box adds to the others.
            for _ in 0..COORDINATES {
                let next = Krawczyk::of(&crossing, &self.centre(), radius).value;
                radius = std::array::from_fn(|i| radius[i].max(SPARE * next[i].magnitude()));
            }
            self.set_radius(radius);
            scale = GROWTH;
        }
        Err(Reason::NotContained)
    }

    fn map<'c>(&self, constants: &'c Constants) -> ReturnMap<'c> {
        let Guess { section, is_on_slow_manifold: is_slow, .. } = self.found;
        ReturnMap { constants, section, is_slow, longest: self.longest }
    }

    /// The return of the box, and Krawczyk's operator.
    fn mapped(&self, constants: &Constants) -> Result<(Crossing, Observed, [Interval; COORDINATES]), Reason> {
        let radius = self.radius();
        let (crossing, observed) = self.map(constants).image(self.found.point, radius)?;
        let value = Krawczyk::of(&crossing, &self.centre(), radius).value;
        Ok((crossing, observed, value))
    }

    /// Whether all of the operator's values, which count from the point, lie between the stated ends.
    fn contains(&self, value: &[Interval; COORDINATES]) -> bool {
        let centre = self.centre();
        (0..COORDINATES).all(|i| {
            let [low, high] = self.ends[i].map(|end| end - centre[i]);
            low.next_up() < value[i].lower() && value[i].upper() < high.next_down()
        })
    }

    /// Whether the operator of a slider maps the box into itself.
    #[cfg(test)]
    pub fn holds(&self, constants: &Constants) -> bool {
        self.mapped(constants).is_ok_and(|(_, _, value)| self.contains(&value))
    }

    /// The same box, followed with shorter steps.
    #[cfg(test)]
    pub const fn with_short_steps(self) -> Self {
        Self { longest: SHORT, ..self }
    }

    /// The same box elsewhere, and with a part of its radius.
    #[cfg(test)]
    pub fn altered(mut self, by: f64, part: f64) -> Self {
        let radius = self.radius();
        self.found.point[0] += by;
        self.set_radius(radius.map(|radius| part * radius));
        self
    }

    /// The certificate, if the cycle of the box attracts.
    fn attracting(
        &self,
        crossing: &Crossing,
        observed: &Observed,
        units: &Units,
    ) -> Result<Certificate, Reason> {
        let contraction = largest_multiplier(&crossing.derivative);
        if !(contraction < 1.0) {
            return Err(Reason::NotAttracting);
        }
        let [state_box, second_box] = self.ends;
        Ok(Certificate {
            proved: Proved::Cycle {
                section_log_velocity: self.found.section,
                state_box,
                second_box,
                is_on_slow_manifold: self.found.is_on_slow_manifold,
                contraction,
                period_s: units.duration(observed.duration),
            },
            peak_velocity_m_per_s: units.peak(observed.peak()),
            stress_drop_pa: units.drop(observed.stress_drop()),
        })
    }
}

/// The return map of an upward crossing of a section.
struct ReturnMap<'c> {
    constants: &'c Constants,
    section: f64,
    is_slow: bool,
    longest: f64,
}

impl ReturnMap<'_> {
    /// The image of a box around a point.
    fn image(&self, point: [f64; 2], radius: [f64; COORDINATES]) -> Result<(Crossing, Observed), Reason> {
        let mut motion = Motion::new(self.constants, States::Inertial(self.start(point, radius)), MOST_STEPS);
        motion.may_stick = self.is_slow;
        motion.longest = self.longest;
        loop {
            if let Some(crossing) = motion.advance(Some(self.section))? {
                let ends_slow = matches!(motion.states, States::Stuck(..));
                if ends_slow != self.is_slow {
                    return Err(Reason::LeftTheTube);
                }
                return Ok((crossing, motion.observed));
            }
        }
    }

    fn start(&self, [y, force]: [f64; 2], radius: [f64; COORDINATES]) -> Set<3> {
        let (zero, one) = (Interval::ZERO, Interval::ONE);
        let section = radius.map(Interval::symmetric);
        let [x, y] = [self.section, y].map(Interval::point);
        if !self.is_slow {
            return Set::new(section, [x, y, Interval::point(force)], [[zero; 2], [one, zero], [zero, one]]);
        }
        let centre = Manifold::over(self.constants, &[x, y]);
        let whole = Manifold::over(self.constants, &[x, y.widened(radius[0])]);
        let force = centre.inertia * centre.rate;
        let slope = whole.inertia * whole.rate_gradient[1];
        Set::new(section, [x, y, force], [[zero; 2], [one, zero], [slope, whole.inertia]])
    }
}

/// Krawczyk's operator of p − P(p) on a box around zero: C P(0) + (I − C(I − P'))p, where C is near (I − P')⁻¹.
///
/// If it lies inside the box, the return map has one fixed point in the box.
struct Krawczyk {
    value: [Interval; COORDINATES],
}

impl Krawczyk {
    fn of(crossing: &Crossing, centre: &[f64; COORDINATES], radius: [f64; COORDINATES]) -> Self {
        let one = |i: usize, j: usize| if i == j { Interval::ONE } else { Interval::ZERO };
        let slope: Square<COORDINATES> =
            std::array::from_fn(|i| std::array::from_fn(|j| one(i, j) - crossing.derivative[i][j]));
        let inverse = points(&inverse(&slope.map(|row| row.map(|entry| entry.mid))));
        let product = multiply(&inverse, &slope);
        let rest: Square<COORDINATES> =
            std::array::from_fn(|i| std::array::from_fn(|j| one(i, j) - product[i][j]));
        let moved = std::array::from_fn(|i| crossing.centre[i] - Interval::point(centre[i]));
        let newton = apply(&inverse, &moved);
        let of_box = apply(&rest, &radius.map(Interval::symmetric));
        Self { value: std::array::from_fn(|i| newton[i] + of_box[i]) }
    }
}

fn inverse([[a, b], [c, d]]: &Square2) -> Square2 {
    let determinant = a * d - b * c;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

type Square2 = [[f64; COORDINATES]; COORDINATES];

/// A bound of the sizes of both multipliers.
///
/// λ² − Tλ + D = 0 has |λ| ≤ (|T| + √(T² − 4D))/2 for real λ and |λ| = √D for others; the row sums bound both as well.
pub(super) fn largest_multiplier(derivative: &Square<COORDINATES>) -> f64 {
    let [[a, b], [c, d]] = *derivative;
    let trace = a + d;
    let determinant = a * d - b * c;
    let four = Interval::point(4.0);
    let discriminant = trace * trace - four * determinant;
    let rows = super::linear::largest_row(derivative);
    let bound = if discriminant.upper() < 0.0 {
        generously_up(determinant.magnitude().sqrt())
    } else {
        let root = generously_up(discriminant.magnitude().sqrt());
        let real = generously_up(0.5 * (trace.magnitude() + root));
        if discriminant.lower() > 0.0 {
            real
        } else {
            worse(real, generously_up(determinant.magnitude().sqrt()))
        }
    };
    if rows < bound { rows } else { bound }
}

/// Whether one multiplier is real and above 1, so that the cycle repels.
///
/// Then 1 − T + D < 0: λ² − Tλ + D is negative at λ = 1 and positive for large λ.
pub(super) fn repels(derivative: &Square<COORDINATES>) -> bool {
    let [[a, b], [c, d]] = *derivative;
    let one = Interval::ONE;
    ((one - a) * (one - d) - b * c).upper() < 0.0
}

#[cfg(test)]
mod tests {
    use rug::Float;

    use super::super::members::Slider;
    use super::*;
    use crate::friction::EvolutionLaw;
    use crate::number::Rational;
    use crate::number::split_mix::SplitMix64;

    fn around(matrix: Square2, rad: f64) -> Square<COORDINATES> {
        matrix.map(|row| row.map(|mid| Interval { mid, rad }))
    }

    /// Matrices with known eigenvalues: no bound is below the largest size, and a repelling cycle has one real eigenvalue above 1.
    #[test]
    fn multipliers_are_bounded() {
        for (matrix, largest, is_repelling) in [
            ([[0.5, 0.0], [0.0, 0.25]], 0.5, false),
            ([[-0.5, 0.0], [0.0, 0.25]], 0.5, false),
            // Triangular: large row sums, a double eigenvalue, and a small difference.
            ([[0.9, 5.0], [0.0, 0.1]], 0.9, false),
            ([[0.7, 5.0], [0.0, 0.7]], 0.7, false),
            ([[0.0, 4.0], [0.25, 0.0]], 1.0, false),
            // Rotations.
            ([[0.0, -0.81], [1.0, 0.0]], 0.9, false),
            ([[0.6, -0.8], [0.8, 0.6]], 1.0, false),
            ([[1.2, -1.6], [1.6, 1.2]], 2.0, false),
            ([[1.1, 3.0], [0.0, 0.2]], 1.1, true),
            ([[0.5, 1.0], [1.0, 0.5]], 1.5, true),
            ([[-1.5, 0.0], [0.0, 0.5]], 1.5, false),
            ([[2.0, 0.0], [0.0, 3.0]], 3.0, false),
        ] {
            for rad in [0.0, 1e-9] {
                // A corner of the box has a larger eigenvalue.
                let corner = matrix.map(|row| row.map(|mid: f64| mid + rad));
                for derivative in [around(matrix, rad), around(corner, 2.0 * rad)] {
                    let bound = largest_multiplier(&derivative);
                    assert!(bound >= largest * (1.0 - 1e-15) && bound < largest + 1e-3, "{matrix:?} {bound}");
                }
                assert_eq!(repels(&around(matrix, rad)), is_repelling, "{matrix:?}");
            }
        }
        // Both signs are possible.
        for (rad, bound) in [(0.2, 1.0), (0.6, 1.4)] {
            assert!(largest_multiplier(&around([[0.8, 0.0], [0.0, 0.8]], rad)) >= bound);
            assert!(!repels(&around([[0.9 + rad, 0.0], [0.0, 0.5]], rad)));
        }
    }

    /// Maps p → Mp + b on a box: the operator holds the fixed point of each M, and no box without its fixed points is mapped into itself.
    #[test]
    fn krawczyks_operator_holds_the_fixed_points() {
        let found = Guess { section: 0.0, point: [0.0; 2], is_on_slow_manifold: false };
        let mut held = 0;
        for matrix in [[[0.5, 0.2], [-0.3, 0.4]], [[3.0, 0.0], [1.0, -2.0]]] {
            for (at, rad) in [([0.5, -0.5], 0.01), ([0.0, 1.5], 0.1), ([1.5, 0.0], 0.1), ([0.4, 0.2], 0.4)] {
                let constant: [f64; 2] =
                    std::array::from_fn(|i| at[i] - matrix[i][0] * at[0] - matrix[i][1] * at[1]);
                let crossing =
                    Crossing { centre: constant.map(Interval::point), derivative: around(matrix, rad) };
                let value = Krawczyk::of(&crossing, &[0.0; 2], [1.0; 2]).value;
                let is_held = Test { found, ends: [[-1.0, 1.0]; 2], longest: LONGEST }.contains(&value);
                held += usize::from(is_held);
                for corner in 0..16_u32 {
                    let entry = |i: usize, j: usize| {
                        let sign = if corner >> (2 * i + j) & 1 == 0 { 1.0 } else { -1.0 };
                        f64::from(u8::from(i == j)) - matrix[i][j] - sign * rad
                    };
                    let inverse = inverse(&[[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]);
                    let fixed: [f64; 2] =
                        std::array::from_fn(|i| inverse[i][0] * constant[0] + inverse[i][1] * constant[1]);
                    let is_inside = fixed.iter().all(|c| c.abs() < 1.0);
                    assert!(is_inside || !is_held, "{matrix:?} {at:?} {fixed:?}");
                    if is_inside {
                        let holds = |i: usize| value[i].widened(1e-14).may_contain(fixed[i]);
                        assert!(holds(0) && holds(1), "{matrix:?} {at:?} {fixed:?} {value:?}");
                    }
                }
            }
        }
        assert!(held >= 2, "{held}");
    }

    #[test]
    fn the_box_that_is_followed_holds_the_stated_ends_and_values_at_these_are_refused() {
        let mut random = SplitMix64(33);
        let exact = |value: f64| Rational::from_f64(value).unwrap();
        for case in 0..2_000 {
            let point = [0; 2].map(|_| 20.0 * (random.unit() - 0.5));
            // From a tenth of a unit of the centre, where rounding is most of the box, to a wide one.
            let radius = [0; 2].map(|_| 10f64.powf(-17.0 + 17.0 * random.unit()));
            let found = Guess { section: 0.0, point, is_on_slow_manifold: case % 4 == 0 };
            let mut test = Test { found, ends: [[0.0; 2]; COORDINATES], longest: LONGEST };
            test.set_radius(radius);
            let (centre, followed) = (test.centre(), test.radius());
            for (i, [low, high]) in test.ends.into_iter().enumerate() {
                let [centre, wide, asked] = [centre[i], followed[i], radius[i]].map(exact);
                assert!(centre.clone() - wide.clone() <= exact(low) && exact(high) <= centre.clone() + wide);
                assert!(exact(low) <= centre.clone() - asked.clone() && centre + asked <= exact(high));
            }
            let of = |part: f64| followed.map(|radius| Interval::symmetric(part * radius));
            assert!(!test.contains(&of(1.0)) && !test.contains(&of(f64::NAN)));
            let is_rounding = (0..COORDINATES).any(|i| radius[i] < 1e-14);
            assert!(is_rounding || test.contains(&of(0.5)), "{test:?}");
        }
    }

    /// Wide matrices of random intervals: no member has a multiplier beyond the bound, and a member of a matrix that repels has one above 1.
    #[test]
    fn no_member_of_a_wide_matrix_has_a_larger_multiplier() {
        let mut random = SplitMix64(34);
        let mut repelling = 0;
        for case in 0..20_000 {
            let mut number = |size: f64| size * (2.0 * random.unit() - 1.0);
            let far = [1.0, 4.0][case % 2];
            let matrix = [[number(1.5), number(far)], [number(far), number(1.5)]];
            let rad =
                [[0.0; 2]; 2].map(|row| row.map(|_: f64| [0.0, 0.05, 0.6][case % 3] * number(1.0).abs()));
            let entry = |i: usize, j: usize| Interval { mid: matrix[i][j], rad: rad[i][j] };
            let wide = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
            let (bound, is_repelling) = (largest_multiplier(&wide), repels(&wide));
            repelling += usize::from(is_repelling);
            for corner in 0..17_u32 {
                let sign = |k: u32| {
                    if corner == 16 {
                        0.0
                    } else if corner >> k & 1 == 0 {
                        1.0
                    } else {
                        -1.0
                    }
                };
                let [a, b, c, d] = [(0, 0, 0), (0, 1, 1), (1, 0, 2), (1, 1, 3)]
                    .map(|(i, j, k)| matrix[i][j] + sign(k) * rad[i][j]);
                let (half, square) = (0.5 * (a + d), 0.25 * (a - d) * (a - d) + b * c);
                let (size, largest) = if square < 0.0 {
                    ((half * half - square).sqrt(), f64::NEG_INFINITY)
                } else {
                    (half.abs() + square.sqrt(), half + square.sqrt())
                };
                assert!(bound >= size * (1.0 - 1e-12) - 1e-12, "{wide:?} {bound} {size}");
                assert!(!is_repelling || largest > 1.0, "{wide:?} {largest}");
            }
        }
        assert!(repelling > 1000, "{repelling}");
    }

    /// Values beyond one end, at an end, or without an end are refused; the followed box holds stated ends of any kind, exactly.
    #[test]
    fn each_end_of_a_box_counts_alone() {
        let mut random = SplitMix64(35);
        let exact = |value: f64| Rational::from_f64(value).unwrap();
        for case in 0..2000 {
            let ends = [0; 2].map(|_| {
                let [a, b] = [0; 2].map(|_| 4.0 * random.unit() - 2.0);
                [a.min(b), a.max(b)]
            });
            let [state_box, second_box] = ends;
            let stated = Proved::Cycle {
                section_log_velocity: 0.0,
                state_box,
                second_box,
                is_on_slow_manifold: case % 2 == 0,
                contraction: 0.5,
                period_s: [1.0; 2],
            };
            let test = Test::of(&stated, LONGEST).unwrap();
            let (centre, radius) = (test.centre(), test.radius());
            for i in 0..COORDINATES {
                let [low, high] = ends[i].map(exact);
                assert!(
                    exact(centre[i]) - exact(radius[i]) <= low && high <= exact(centre[i]) + exact(radius[i])
                );
            }
            let inside: [Interval; 2] = std::array::from_fn(|i| {
                let [low, high] = ends[i].map(|end| end - centre[i]);
                Interval { mid: 0.5 * (low + high), rad: 0.25 * (high - low) }
            });
            assert!(test.contains(&inside), "{test:?} {inside:?}");
            for i in 0..COORDINATES {
                let [low, high] = ends[i].map(|end| end - centre[i]);
                let (part, nan) = (0.3 * (high - low), f64::NAN);
                for (mid, rad) in [
                    (low, part),
                    (high, part),
                    (low, 0.0),
                    (high, 0.0),
                    (low - part, 0.0),
                    (high + part, 0.0),
                    (nan, 0.0),
                    (0.5 * (low + high), nan),
                ] {
                    let mut value = inside;
                    value[i] = Interval { mid, rad };
                    assert!(!test.contains(&value), "{test:?} {value:?}");
                }
            }
        }
    }

    /// Maps p → P(p) with an uncertain image of the centre, which lies away from zero: the operator holds each fixed point.
    #[test]
    fn krawczyks_operator_counts_from_the_centre() {
        for centre in [[0.0, 0.0], [0.3, -2.0]] {
            for (at, rad) in [([0.1, -0.2], 0.0), ([0.1, -0.2], 0.05), ([0.0, 0.3], 0.2)] {
                let matrix = [[0.5, 0.2], [-0.3, 0.4]];
                // P(centre) = centre + (I − M) at: the fixed point is centre + at.
                let image: [f64; 2] =
                    std::array::from_fn(|i| centre[i] + at[i] - matrix[i][0] * at[0] - matrix[i][1] * at[1]);
                let crossing = Crossing {
                    centre: image.map(|mid| Interval { mid, rad }),
                    derivative: around(matrix, 1e-9),
                };
                let value = Krawczyk::of(&crossing, &centre, [1.0; 2]).value;
                let inverse = inverse(&[[0.5, -0.2], [0.3, 0.6]]);
                for signs in [[0.0, 0.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
                    for i in 0..2 {
                        let moved = rad * (inverse[i][0] * signs[0] + inverse[i][1] * signs[1]);
                        assert!(
                            value[i].widened(1e-14).may_contain(at[i] + moved),
                            "{centre:?} {at:?} {value:?}"
                        );
                        assert!(value[i].rad < 1e-6 + 3.0 * rad, "{value:?}");
                    }
                }
            }
        }
    }

    /// Only a cycle whose multipliers are both below 1 attracts.
    #[test]
    fn a_cycle_with_a_multiplier_of_one_or_more_is_not_said_to_attract() {
        let third = || Rational::from((1, 3));
        let one = || Rational::from(1);
        let slider = crate::friction::Parameters::from([one(), third(), one(), one(), one(), one(), one()]);
        let units = Units::over(&crate::friction::ParameterBox::of(slider).unwrap());
        let found = Guess { section: 0.0, point: [0.0; 2], is_on_slow_manifold: false };
        let test = Test { found, ends: [[-1.0, 1.0]; 2], longest: LONGEST };
        let certify = |largest: f64, rad: f64| {
            let derivative = around([[largest, 0.0], [0.0, 0.25]], rad);
            test.attracting(&Crossing { centre: [Interval::ZERO; 2], derivative }, &Observed::new(), &units)
        };
        for (largest, rad) in [(0.9, 0.0), (-0.9, 0.0), (0.9, 1e-3)] {
            let Proved::Cycle { contraction, .. } = certify(largest, rad).unwrap().proved else {
                panic!("no cycle")
            };
            assert!(contraction >= 0.9 + rad && contraction < 1.0, "{contraction}");
        }
        for (largest, rad) in [(1.0, 0.0), (-1.0, 0.0), (1.2, 0.0), (0.9, 0.2), (f64::NAN, 0.0)] {
            assert_eq!(certify(largest, rad), Err(Reason::NotAttracting), "{largest} {rad}");
        }
    }

    /// The set that a return starts from: (x, y, F) of each point of a wide box, with the derivative, by the equation of F on the slow manifold.
    #[test]
    fn the_start_of_a_return_holds_each_point_of_its_box() {
        for law in EvolutionLaw::ALL {
            let slider = Slider { inertia: 0.02, stiffness: 0.4, effect_ratio: 1.5, law };
            let constants = slider.constants();
            for (section, point, radius) in [
                (-0.5, [0.8, 0.01], [0.05, 0.02]),
                (-1.2, [0.3, 0.02], [0.2, 0.1]),
                (0.0, [0.5, 0.3], [0.0, 0.3]),
            ] {
                for is_slow in [true, false] {
                    let map = ReturnMap { constants: &constants, section, is_slow, longest: LONGEST };
                    let set = map.start(point, radius);
                    let (hull, derivative, at_centre) = (set.hull(), set.derivative(), set.at_centre());
                    let force = |p: [f64; 2]| {
                        if !is_slow {
                            return point[1] + p[1];
                        }
                        let rate =
                            Manifold::over(&constants, &[section, point[0] + p[0]].map(Interval::point)).rate;
                        slider.inertia * libm::exp(section) * (rate.mid + p[1])
                    };
                    for first in [-1.0, -0.3, 0.0, 0.6, 1.0] {
                        for second in [-1.0, 0.0, 0.4, 1.0] {
                            let p = [first * radius[0], second * radius[1]];
                            let state = [section, point[0] + p[0], force(p)];
                            for i in 0..3 {
                                let value = at_centre[i]
                                    + derivative[i][0] * Interval::point(p[0])
                                    + derivative[i][1] * Interval::point(p[1]);
                                let near = |c: Interval| c.widened(1e-14).may_contain(state[i]);
                                assert!(near(hull[i]) && near(value), "{i} {p:?} {state:?} {value:?}");
                            }
                            // ∂F/∂p by differences within the box.
                            if radius[0] > 0.0 && first.abs() < 1.0 {
                                let by = 1e-3 * radius[0];
                                let slope =
                                    (force([p[0] + by, p[1]]) - force([p[0] - by, p[1]])) / (2.0 * by);
                                assert!(
                                    derivative[2][0].widened(1e-9).may_contain(slope),
                                    "{slope} {:?}",
                                    derivative[2][0]
                                );
                            }
                            let slope = (force([p[0], p[1] + 1.0]) - force([p[0], p[1] - 1.0])) / 2.0;
                            assert!(
                                derivative[2][1].widened(1e-9).may_contain(slope),
                                "{slope} {:?}",
                                derivative[2][1]
                            );
                        }
                    }
                    let exact = |x: f64| Float::with_val(400, x);
                    if is_slow {
                        // F of the middle, whose rounding counts.
                        let rate = Manifold::over(&constants, &[section, point[0]].map(Interval::point)).rate;
                        let middle = exact(section).exp() * slider.inertia * rate.mid;
                        assert!((middle - at_centre[2].mid).abs() <= at_centre[2].rad);
                    }
                }
            }
        }
    }

    /// A slider that does not stick has no return to a section of the slow manifold.
    #[test]
    fn a_return_that_ends_off_the_slow_manifold_is_refused_there() {
        for law in EvolutionLaw::ALL {
            let constants = Slider { inertia: 0.5, stiffness: 0.3, effect_ratio: 1.5, law }.constants();
            let image = |is_slow: bool, point: [f64; 2]| {
                ReturnMap { constants: &constants, section: 0.0, is_slow, longest: LONGEST }
                    .image(point, [1e-9; 2])
            };
            assert!(image(false, [0.0, 0.2]).is_ok());
            assert_eq!(image(true, [0.3, 0.0]).map(|_| ()), Err(Reason::LeftTheTube));
        }
    }

    /// The return of a box against single motions: P(p) and its mean derivatives are held, and so is p − C(p − P(p)) of each corner.
    #[test]
    fn the_return_of_a_box_holds_the_returns_of_its_corners() {
        for law in EvolutionLaw::ALL {
            let slider = Slider { inertia: 0.5, stiffness: 0.3, effect_ratio: 1.5, law };
            let constants = slider.constants();
            let found = Guess { section: 0.0, point: [0.0, 0.2], is_on_slow_manifold: false };
            let mut test = Test { found, ends: [[0.0; 2]; COORDINATES], longest: 0.3 };
            let (radius, (crossing, observed, value)) = [1e-4, 3e-5, 1e-5, 3e-6]
                .into_iter()
                .find_map(|size| {
                    let radius = [size, 0.5 * size];
                    test.set_radius(radius);
                    test.mapped(&constants).ok().map(|mapped| (radius, mapped))
                })
                .unwrap();
            let image = |p: [f64; 2]| {
                let member = slider.member([0.0, p[0], 0.2 + p[1]]);
                let end = slider.until(slider.step(member, 1e-3), 0.0, 2e-3);
                assert!(observed.duration.widened(1e-11).may_contain(end.state[3]), "{end:?}");
                let [low, high] = observed.peak();
                assert!(
                    low - 1e-11 <= end.largest[0] && end.largest[0] <= high + 1e-11,
                    "{end:?} {low} {high}"
                );
                [end.state[1], end.state[2]]
            };
            let slope: Square2 = std::array::from_fn(|i| {
                std::array::from_fn(|j| f64::from(u8::from(i == j)) - crossing.derivative[i][j].mid)
            });
            let inverse = inverse(&slope);
            let centre = test.centre();
            let corners = [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]]
                .map(|[a, b]| [a * radius[0], b * radius[1]]);
            let images = corners.map(image);
            for (p, end) in corners.iter().zip(&images) {
                let back: [f64; 2] = std::array::from_fn(|i| centre[i] + p[i] - end[i]);
                for i in 0..2 {
                    let newton = p[i] - inverse[i][0] * back[0] - inverse[i][1] * back[1];
                    assert!(value[i].widened(1e-10).may_contain(newton), "{i} {newton} {value:?}");
                    let at = crossing.centre[i]
                        + crossing.derivative[i][0] * Interval::point(p[0])
                        + crossing.derivative[i][1] * Interval::point(p[1]);
                    assert!(at.widened(1e-11).may_contain(end[i]), "{i} {p:?} {end:?}");
                }
            }
            for (from, to, j) in [(1, 0, 1), (2, 3, 1), (3, 0, 0), (2, 1, 0)] {
                for i in 0..2 {
                    let mean = (images[to][i] - images[from][i]) / (2.0 * radius[j]);
                    assert!(
                        crossing.derivative[i][j].widened(1e-11 / radius[j]).may_contain(mean),
                        "{i} {j} {mean} {:?}",
                        crossing.derivative[i][j]
                    );
                }
            }
        }
    }
}
