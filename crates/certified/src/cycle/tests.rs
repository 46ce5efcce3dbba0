//! Krawczyk's operator, boxes, multipliers and returns of a cycle, against maps and matrices that are known.

use rug::Float;

use super::super::tests::members::Slider;
use super::*;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;
use slipmode_core::number::split_mix::SplitMix64;

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
                CrossingSet { centre: constant.map(Interval::point), derivative: around(matrix, rad) };
            let value = krawczyk(&crossing, &[0.0; 2], [1.0; 2]);
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
        let rad = [[0.0; 2]; 2].map(|row| row.map(|_: f64| [0.0, 0.05, 0.6][case % 3] * number(1.0).abs()));
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
            let [a, b] = [0; 2].map(|_| (4.0 * random.unit() - 2.0) * (0.5 + random.unit()));
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
            let crossing = CrossingSet {
                centre: image.map(|mid| Interval { mid, rad }),
                derivative: around(matrix, 1e-9),
            };
            let value = krawczyk(&crossing, &centre, [1.0; 2]);
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
    let slider =
        slipmode_core::friction::Parameters::from([one(), third(), one(), one(), one(), one(), one()]);
    let units = Units::over(&slipmode_core::friction::ParameterBox::of(slider).unwrap());
    let found = Guess { section: 0.0, point: [0.0; 2], is_on_slow_manifold: false };
    let test = Test { found, ends: [[-1.0, 1.0]; 2], longest: LONGEST };
    let certify = |largest: f64, rad: f64| {
        let derivative = around([[largest, 0.0], [0.0, 0.25]], rad);
        test.attracting(&CrossingSet { centre: [Interval::ZERO; 2], derivative }, &Observed::new(), &units)
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
        // Of two sliders, which differ in stiffness.
        let both = Constants { stiffness: Interval { mid: 0.4, rad: 0.0625 }, ..slider.constants() };
        let sliders = [0.3375, 0.4625].map(|stiffness| Slider { stiffness, ..slider });
        let members = sliders.map(|slider| (slider.constants(), both)).into_iter();
        for (constants, over) in members.chain([(slider.constants(), slider.constants())]) {
            let (section, point, radius) = (-0.5, [0.8, 0.01], [0.0, 0.02]);
            let from = Guess { section, point, is_on_slow_manifold: true };
            let rate = Manifold::over(&constants, &[section, point[0]].map(Interval::point)).rate.mid;
            let force = slider.inertia * libm::exp(section) * rate;
            let start = from.start(&over, radius);
            assert!(
                start.at_centre()[2].widened(1e-14).may_contain(force),
                "{force} {:?}",
                start.at_centre()
            );
        }
        let constants = slider.constants();
        for (section, point, radius) in [
            (-0.5, [0.8, 0.01], [0.05, 0.02]),
            (-1.2, [0.3, 0.02], [0.2, 0.1]),
            (0.0, [0.5, 0.3], [0.0, 0.3]),
        ] {
            for is_slow in [true, false] {
                let from = Guess { section, point, is_on_slow_manifold: is_slow };
                let set = from.start(&constants, radius);
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
                            let slope = (force([p[0] + by, p[1]]) - force([p[0] - by, p[1]])) / (2.0 * by);
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
            let from = Guess { section: 0.0, point, is_on_slow_manifold: is_slow };
            from.image(&constants, [1e-9; 2], LONGEST)
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
            assert!(low - 1e-11 <= end.largest[0] && end.largest[0] <= high + 1e-11, "{end:?} {low} {high}");
            [end.state[1], end.state[2]]
        };
        let slope: Square2 = std::array::from_fn(|i| {
            std::array::from_fn(|j| f64::from(u8::from(i == j)) - crossing.derivative[i][j].mid)
        });
        let inverse = inverse(&slope);
        let centre = test.centre();
        let corners =
            [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]].map(|[a, b]| [a * radius[0], b * radius[1]]);
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
            for (i, (from, to)) in images[from].iter().zip(images[to]).enumerate() {
                let mean = (to - from) / (2.0 * radius[j]);
                assert!(
                    crossing.derivative[i][j].widened(1e-11 / radius[j]).may_contain(mean),
                    "{i} {j} {mean} {:?}",
                    crossing.derivative[i][j]
                );
            }
        }
    }
}
