//! What the equations and the units are made of, enclosed over a box of parameters. A point is a box of one point.

use crate::interval::Interval;
use slipmode_core::friction::{EvolutionLaw, Groups, ParameterBox, Parameters};
use slipmode_core::number::Rational;

/// η, κ and β, enclosed, and the law.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants {
    pub inertia: Interval,
    pub stiffness: Interval,
    pub effect_ratio: Interval,
    pub law: EvolutionLaw,
}

impl Constants {
    /// Those of one slider.
    pub fn of(groups: &Groups<Rational>, law: EvolutionLaw) -> Self {
        let [inertia, stiffness, effect_ratio] = groups.map(Interval::of_rational).into();
        Self { inertia, stiffness, effect_ratio, law }
    }

    /// Those of all sliders in a box: each group rises with some values and falls with others, and is extreme at two corners.
    pub fn over(region: &ParameterBox, law: EvolutionLaw) -> Self {
        let [low, high] = [region.lower(), region.upper()];
        let corners = |up: &Parameters<Rational>, down: &Parameters<Rational>| {
            // All three groups fall with a, and η and κ with σ.
            let mut corner = up.clone();
            corner.slider.direct_effect.clone_from(&down.slider.direct_effect);
            corner.point.normal_stress_pa.clone_from(&down.point.normal_stress_pa);
            let others = corner.groups();
            // η falls with D_c, κ rises.
            corner.slider.critical_slip_distance_m.clone_from(&down.slider.critical_slip_distance_m);
            Groups { inertial_parameter: corner.groups().inertial_parameter, ..others }
        };
        let [least, largest] = [corners(&low, &high), corners(&high, &low)];
        let [least, largest] = [least, largest].map(<[Rational; 3]>::from);
        let [inertia, stiffness, effect_ratio] = [0, 1, 2].map(|i| Interval::over([&least[i], &largest[i]]));
        Self { inertia, stiffness, effect_ratio, law }
    }
}

/// Enclosures in SI.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    velocity: Interval,
    time: Interval,
    stress: Interval,
}

impl Units {
    /// V_l, D_c/V_l and aσ over a box.
    pub fn over(region: &ParameterBox) -> Self {
        let [low, high] = [region.lower(), region.upper()];
        let [slowest, fastest] = [&low, &high].map(|slider| slider.point.loading_velocity_m_per_s.clone());
        let [shortest, longest] = [&low, &high].map(|slider| slider.slider.critical_slip_distance_m.clone());
        Self {
            velocity: Interval::over([&slowest, &fastest]),
            time: Interval::over([&(shortest / &fastest), &(longest / &slowest)]),
            stress: Interval::over([&low.direct_stress_pa(), &high.direct_stress_pa()]),
        }
    }

    /// V at ln(V/V_l).
    fn velocity_at(&self, x: Interval) -> Interval {
        x.exp() * self.velocity
    }

    pub fn peak(&self, log_peak: [f64; 2]) -> [f64; 2] {
        outward(log_peak.map(|x| self.velocity_at(Interval::point(x))))
    }

    pub fn duration(&self, duration: Interval) -> [f64; 2] {
        outward([duration * self.time; 2])
    }

    pub fn drop(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        outward([low, high].map(|drop| Interval::point(drop) * self.stress))
    }
}

/// The lower end of the first and the upper end of the second, one number further out: the shortest decimals of these numbers are bounds too.
fn outward([low, high]: [Interval; 2]) -> [f64; 2] {
    [low.lower().next_down(), high.upper().next_up()]
}

#[cfg(test)]
mod tests {
    use rug::Float;

    use super::*;
    use crate::tests::exact::holds;
    use slipmode_core::number::split_mix::SplitMix64;

    const BITS: u32 = 400;

    /// Thirds, which are no 64-bit numbers, and values of a tenth more or less.
    fn slider(parts: [i32; 7]) -> Parameters<Rational> {
        let values = [(4, 300), (6, 300), (1, 30_000), (10_000_000, 3), (1000, 3), (30_000, 1), (1, 3000)];
        Parameters::from(std::array::from_fn(|i| {
            Rational::from(values[i]) * Rational::from((10 + parts[i], 10))
        }))
    }

    /// η, κ and β of each slider in a box, by exact arithmetic, and its V_l e^x, D_c t/V_l and aσζ.
    #[test]
    fn constants_and_units_over_a_box_hold_those_of_each_slider() {
        let mut random = SplitMix64(3);
        let point = ParameterBox::of(slider([0; 7])).unwrap();
        let wide = ParameterBox::new(slider([-1; 7]), slider([1; 7])).unwrap();
        for case in 0..200 {
            let is_wide = case > 0;
            let parts = [0; 7].map(|_| if is_wide { [-1, 0, 1][(3.0 * random.unit()) as usize] } else { 0 });
            let member = slider(parts);
            let groups = member.groups();
            let region = if is_wide { &wide } else { &point };
            for constants in
                [Constants::over(region, EvolutionLaw::Slip), Constants::of(&groups, EvolutionLaw::Slip)]
            {
                assert!(holds(constants.inertia, &groups.inertial_parameter), "{parts:?}");
                assert!(holds(constants.stiffness, &groups.stiffness_group), "{parts:?}");
                assert!(holds(constants.effect_ratio, &groups.effect_ratio), "{parts:?}");
            }
            let units = Units::over(region);
            let x = 20.0 * random.unit() - 10.0;
            let float = |value: &Rational| Float::with_val(BITS, value);
            let velocity = float(&member.point.loading_velocity_m_per_s);
            let peak = Float::with_val(BITS, x).exp() * &velocity;
            let time = float(&member.slider.critical_slip_distance_m) / &velocity;
            let stress = float(&member.direct_stress_pa());
            let inside = |[low, high]: [f64; 2], value: &Float| *value >= low && *value <= high;
            assert!(inside(units.peak([x, x]), &peak), "{parts:?}");
            let [low, high] = [units.peak([x, x + 1.0]), units.peak([x - 1.0, x])];
            assert!(
                low[0] <= peak
                    && peak <= high[1]
                    && low[1] > 2.5 * peak.to_f64()
                    && high[0] < 0.5 * peak.to_f64()
            );
            for end in [-1.0, 1.0] {
                let wide = units.velocity_at(Interval { mid: x, rad: 0.25 });
                let exact = Float::with_val(BITS, x + 0.249 * end).exp() * &velocity;
                assert!(inside([wide.lower(), wide.upper()], &exact), "{parts:?} {wide:?}");
            }
            for rad in [0.0, 0.25] {
                for end in [-1.0, 1.0] {
                    let duration = Interval { mid: 2.0 / 3.0, rad };
                    let passed = Float::with_val(BITS, duration.mid) + end * rad;
                    assert!(inside(units.duration(duration), &(passed * &time)), "{parts:?}");
                }
            }
            let drop = [x.abs(), x.abs() + 1.0];
            let found = units.drop(drop);
            assert!(
                drop.iter().all(|&drop| inside(found, &(Float::with_val(BITS, drop) * &stress))),
                "{parts:?}"
            );
        }
    }
}
