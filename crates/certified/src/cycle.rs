//! A limit cycle: Krawczyk's test on the return map of a section, then the multipliers.

use crate::guess::{Guess, guess};
use crate::interval::{Interval, generously_up, up, worse};
use crate::linear::{Square, apply, multiply, points, unit};
use crate::manifold::Manifold;
use crate::motion::{CrossingSet, Motion, States};
use crate::observed::Observed;
use crate::set::{COORDINATES, Set};
use crate::{Certificate, Constants, MOST_STEPS, Proved, Reason, Units};
use slipmode_core::dynamics::{Cycle, Model};

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
    ) -> Result<(Self, CrossingSet, Observed), Reason> {
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
        let mut radius = [0.0; COORDINATES];
        for _ in 0..CORRECTIONS {
            let (crossing, _) = self.found.image(constants, radius, self.longest)?;
            let value = krawczyk(&crossing, &self.centre(), radius);
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
    fn grow(mut self, constants: &Constants) -> Result<(Self, CrossingSet, Observed), Reason> {
        let mut scale = FIRST;
        for _ in 0..=BOXES {
            let (crossing, observed, value) = self.mapped(constants)?;
            if self.contains(&value) {
                return Ok((self, crossing, observed));
            }
            let mut radius = value.map(|c| scale * c.magnitude() + f64::MIN_POSITIVE);
            // With the derivative found so far, what each side of the box adds to the others.
            for _ in 0..COORDINATES {
                let next = krawczyk(&crossing, &self.centre(), radius);
                radius = std::array::from_fn(|i| radius[i].max(SPARE * next[i].magnitude()));
            }
            self.set_radius(radius);
            scale = GROWTH;
        }
        Err(Reason::NotContained)
    }

    /// The return of the box, and Krawczyk's operator.
    fn mapped(
        &self,
        constants: &Constants,
    ) -> Result<(CrossingSet, Observed, [Interval; COORDINATES]), Reason> {
        let radius = self.radius();
        let (crossing, observed) = self.found.image(constants, radius, self.longest)?;
        let value = krawczyk(&crossing, &self.centre(), radius);
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
        crossing: &CrossingSet,
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
impl Guess {
    /// The image of a box around the point.
    fn image(
        &self,
        constants: &Constants,
        radius: [f64; COORDINATES],
        longest: f64,
    ) -> Result<(CrossingSet, Observed), Reason> {
        let mut motion = Motion::new(constants, States::Inertial(self.start(constants, radius)), MOST_STEPS);
        motion.may_stick = self.is_on_slow_manifold;
        motion.longest = longest;
        loop {
            if let Some(crossing) = motion.advance(Some(self.section))? {
                let ends_slow = matches!(motion.states, States::Stuck(..));
                if ends_slow != self.is_on_slow_manifold {
                    return Err(Reason::LeftTheTube);
                }
                return Ok((crossing, motion.observed));
            }
        }
    }

    fn start(&self, constants: &Constants, radius: [f64; COORDINATES]) -> Set<3> {
        let (zero, one) = (Interval::ZERO, Interval::ONE);
        let section = radius.map(Interval::symmetric);
        let [x, y, force] = [self.section, self.point[0], self.point[1]].map(Interval::point);
        if !self.is_on_slow_manifold {
            return Set::new(section, [x, y, force], [[zero; 2], [one, zero], [zero, one]]);
        }
        let centre = Manifold::over(constants, &[x, y]);
        let whole = Manifold::over(constants, &[x, y.widened(radius[0])]);
        let force = centre.inertia * centre.rate;
        let slope = whole.inertia * whole.rate_gradient[1];
        Set::new(section, [x, y, force], [[zero; 2], [one, zero], [slope, whole.inertia]])
    }
}

/// Krawczyk's operator of p − P(p) on a box around zero: C P(0) + (I − C(I − P'))p, where C is near (I − P')⁻¹.
///
/// If it lies inside the box, the return map has one fixed point in the box.
fn krawczyk(
    crossing: &CrossingSet,
    centre: &[f64; COORDINATES],
    radius: [f64; COORDINATES],
) -> [Interval; COORDINATES] {
    let less = |from: Square<COORDINATES>, other: &Square<COORDINATES>| -> Square<COORDINATES> {
        std::array::from_fn(|i| std::array::from_fn(|j| from[i][j] - other[i][j]))
    };
    let slope = less(unit(), &crossing.derivative);
    let inverse = points(&inverse(&slope.map(|row| row.map(|entry| entry.mid))));
    let rest = less(unit(), &multiply(&inverse, &slope));
    let moved = std::array::from_fn(|i| crossing.centre[i] - Interval::point(centre[i]));
    let newton = apply(&inverse, &moved);
    let of_box = apply(&rest, &radius.map(Interval::symmetric));
    std::array::from_fn(|i| newton[i] + of_box[i])
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
    let rows = crate::linear::largest_row(derivative);
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
mod tests;
