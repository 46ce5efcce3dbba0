//! The state of the corners of a box, and of other points of it.

use std::cell::{Cell, OnceCell, RefCell};

use rug::{Complete, Integer};

use crate::friction::{Groups, ParameterBox, Parameters, SlipMode};
use crate::number::{Dd, Rational};
use crate::stability::certain_signs::{BoundedGroups, Signs};
use crate::stability::quick::clearly_in_upper_area;
use crate::stability::slip_mode::{is_upper_area, slip_mode_by};
use crate::stability::{
    InertialThreshold, SpectralClass, boundary_sign, classify_quickly, slip_mode, transition_sign,
};

/// The place of each parameter in an array: the order of [`Parameters::from`].
pub(super) const A: usize = 0;
pub(super) const B: usize = 1;
pub(super) const D: usize = 2;
pub(super) const K: usize = 3;
pub(super) const M: usize = 4;
pub(super) const S: usize = 5;
pub(super) const V: usize = 6;

/// Exact values of a, b, D_c, K, M, σ, V0.
pub(super) type Point = [Rational; 7];

impl ParameterBox {
    /// Whether a parameter has more than one value.
    pub(super) fn is_wide(&self, parameter: usize) -> bool {
        self.lower[parameter] < self.upper[parameter]
    }

    /// The value of a parameter at a corner.
    pub(super) fn end(&self, parameter: usize, corner: Corner) -> &Rational {
        if corner.has(parameter) { &self.upper[parameter] } else { &self.lower[parameter] }
    }

    /// The corner at which the parameters of `high` have their greatest value and the others their least.
    pub(super) fn corner(&self, high: Corner) -> Point {
        std::array::from_fn(|i| self.end(i, high).clone())
    }
}

/// A corner of a box: a bit for each parameter that has its greatest value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Corner(u8);

impl Corner {
    /// The corner at which exactly these parameters have their greatest value.
    pub(super) const fn high(parameters: &[usize]) -> Self {
        let (mut bits, mut i) = (0, 0);
        while i < parameters.len() {
            bits |= 1 << parameters[i];
            i += 1;
        }
        Self(bits)
    }

    /// The corner opposite to this one.
    pub(super) const fn opposite(self) -> Self {
        Self(!self.0 & 0x7f)
    }

    /// The corner with one parameter at its other end.
    pub(super) const fn flipped(self, parameter: usize) -> Self {
        Self(self.0 ^ (1 << parameter))
    }

    /// The corner at which the parameters that are high at `other` are high too.
    pub(super) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The corner at which the parameters that are high at `other` are low.
    pub(super) const fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    const fn has(self, parameter: usize) -> bool {
        self.0 >> parameter & 1 == 1
    }
}

/// What the point test says of a point: all but its frequency.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct State {
    pub(super) transition: i8,
    pub(super) boundary: i8,
    pub(super) class: SpectralClass,
    /// The slip mode where all roots are real; that of a pair needs its frequency ([`Filtered::mode`]).
    pub(super) real_mode: Option<SlipMode>,
}

impl State {
    /// All roots real and positive but one.
    pub(super) fn is_unstable_real(self) -> bool {
        self.class == SpectralClass::UnstableReal
    }

    /// All roots real, in the area of a > b with roots between −1 and 0.
    pub(super) fn is_upper(self) -> bool {
        self.real_mode == Some(SlipMode::OverdampedOscillation)
    }

    /// All roots real and below −1.
    pub(super) fn is_lower(self) -> bool {
        self.real_mode == Some(SlipMode::OverdampedStableSliding)
    }
}

/// The factors that make every parameter of a box an integer and change no group.
pub(super) struct Units([Integer; 7]);

impl Units {
    /// Units of a, b; of length; of stiffness. Those of σ and M V0² follow: a σ ~ K D_c, M V0² ~ K D_c².
    pub(super) fn of(region: &ParameterBox) -> Self {
        let common = |i: usize| region.lower[i].denom().clone().lcm(region.upper[i].denom());
        let effects = common(A).lcm(&common(B));
        let length = &effects * common(S) * common(D);
        let velocity = common(V);
        let mass = common(K).lcm(&common(M));
        let stiffness = &mass * velocity.square_ref().complete();
        let stress = Integer::from(&stiffness * &length) / &effects;
        Self([effects.clone(), effects, length.clone(), stiffness, mass, stress, length * velocity])
    }

    /// A parameter's value in these units; an integer for the ends of the box.
    pub(super) fn integer(&self, parameter: usize, value: &Rational) -> Integer {
        (value.numer() * &self.0[parameter]).complete() / value.denom()
    }
}

/// A box with its ends rounded to double-double, for the filters.
pub(super) struct Filtered<'a> {
    pub(super) region: &'a ParameterBox,
    pub(super) threshold: &'a InertialThreshold,
    lower: [Dd; 7],
    upper: [Dd; 7],
    units: OnceCell<Units>,
    /// How many edges needed polynomials.
    pub(super) edges: Cell<usize>,
    /// The states of corners that were asked for.
    states: RefCell<Vec<(Corner, State)>>,
}

impl<'a> Filtered<'a> {
    pub(super) fn new(region: &'a ParameterBox, threshold: &'a InertialThreshold) -> Self {
        let rounded = |point: &Point| point.each_ref().map(Dd::from_rational);
        let (lower, upper) = (rounded(&region.lower), rounded(&region.upper));
        Self {
            region,
            threshold,
            lower,
            upper,
            units: OnceCell::new(),
            edges: Cell::default(),
            states: RefCell::default(),
        }
    }

    /// Units in which all ends are integers.
    pub(super) fn units(&self) -> &Units {
        self.units.get_or_init(|| Units::of(self.region))
    }

    /// The corner in double-double.
    pub(super) fn rounded(&self, corner: Corner) -> [Dd; 7] {
        std::array::from_fn(|i| if corner.has(i) { self.upper[i] } else { self.lower[i] })
    }

    /// The state of a corner, by the filters if they are certain.
    pub(super) fn at_corner(&self, corner: Corner) -> State {
        let mut states = self.states.borrow_mut();
        if let Some((_, state)) = states.iter().find(|(known, _)| *known == corner) {
            return *state;
        }
        let state = quickly(self.rounded(corner)).unwrap_or_else(|| exactly(&self.region.corner(corner)));
        states.push((corner, state));
        state
    }

    /// The state of any point, by the filters if they are certain.
    pub(super) fn at(&self, point: &Point) -> State {
        quickly(point.each_ref().map(Dd::from_rational)).unwrap_or_else(|| exactly(point))
    }

    /// The slip mode of any point, by the filters if they are certain.
    pub(super) fn mode(&self, point: &Point) -> SlipMode {
        let rounded = Parameters::from(point.each_ref().map(Dd::from_rational));
        let exactly = || {
            let groups: Groups<Rational> = Parameters::from(point.clone()).groups();
            slip_mode(&groups, exactly(point).class, self.threshold)
        };
        classify_quickly(&rounded, self.threshold).map_or_else(exactly, |found| found.slip_mode)
    }

    /// The first point with `wanted` found by halving the segment from a point `inside` a set to one outside of it.
    ///
    /// None after so many halvings that the two ends are one point for every purpose but exactness.
    pub(super) fn between(
        &self,
        [mut inside, mut outside]: [Point; 2],
        is_inside: impl Fn(State) -> bool,
        wanted: impl Fn(&Point, State) -> bool,
    ) -> Option<Point> {
        const HALVINGS: usize = 400;
        for end in [&inside, &outside] {
            if wanted(end, self.at(end)) {
                return Some(end.clone());
            }
        }
        for _ in 0..HALVINGS {
            let middle = middle(&inside, &outside);
            let state = self.at(&middle);
            match state {
                _ if wanted(&middle, state) => return Some(middle),
                _ if is_inside(state) => inside = middle,
                _ => outside = middle,
            }
        }
        None
    }
}

/// The point half-way between two.
pub(super) fn middle(one: &Point, other: &Point) -> Point {
    std::array::from_fn(|i| {
        if one[i] == other[i] { one[i].clone() } else { Rational::from(&one[i] + &other[i]) / 2u32 }
    })
}

fn exactly(point: &Point) -> State {
    let groups: Groups<Rational> = Parameters::from(point.clone()).groups();
    let (transition, boundary) = (transition_sign(&groups), boundary_sign(&groups));
    let class = SpectralClass::from_signs(transition, boundary);
    let real_mode = real_mode(class, || Some(is_upper_area(&groups)));
    State { transition, boundary, class, real_mode }
}

fn quickly(point: [Dd; 7]) -> Option<State> {
    let bounded = BoundedGroups::of_parameters(&Parameters::from(point))?;
    let Signs { transition, boundary, .. } = bounded.signs_below_exact()?;
    let class = SpectralClass::from_signs(transition, boundary);
    let real_mode = real_mode(class, || clearly_in_upper_area(&bounded.groups.map(Dd::hi)));
    let is_decided = class != SpectralClass::StableReal || real_mode.is_some();
    is_decided.then_some(State { transition, boundary, class, real_mode })
}

/// The slip mode of real roots; none for a pair.
fn real_mode(class: SpectralClass, is_upper_area: impl Fn() -> Option<bool>) -> Option<SlipMode> {
    slip_mode_by(class, is_upper_area, || None)
}
