//! The line against the roots of eq 8, which share no formula with it.

use super::*;
use crate::number::parse_decimal;
use crate::number::split_mix::SplitMix64;
use crate::roots::certified_roots;
use crate::stability::fixtures::{paper, with_effects};

const DIGITS: u32 = 30;

/// 10 000 points, and 100 000 where slow tests are wanted.
fn points() -> usize {
    if std::env::var_os("SLIPMODE_SLOW").is_some() { 100_000 } else { 10_000 }
}

fn decimal(value: f64) -> Rational {
    Rational::from_f64(value).unwrap()
}

/// b/a = 1 in one of eight cases, else up to two decades to either side.
fn slider(random: &mut SplitMix64) -> Slider<Rational> {
    let ratio = if random.unit() < 0.125 { 1.0 } else { libm::exp10(4.0 * random.unit() - 2.0) };
    with_effects(decimal(0.01), decimal(0.01) * decimal(ratio))
}

fn threshold(random: &mut SplitMix64) -> InertialThreshold {
    InertialThreshold::from_ratio(&decimal(0.001 + 0.998 * random.unit())).unwrap()
}

/// A damping ratio in one of two cases, else ω/ω_n.
fn ratio(random: &mut SplitMix64) -> PairRatio {
    if random.unit() < 0.5 {
        return PairRatio::Frequency(threshold(random));
    }
    PairRatio::Damping(DampingRatio::new(decimal(1.998 * random.unit() - 0.999)).unwrap())
}

/// ω/ω_n and Re(s) of the pair of eq 8, or none.
fn pair(slider: &Slider<Rational>, [stress, velocity]: [&Rational; 2], digits: u32) -> Option<[Ball; 2]> {
    let cubic = slider.at(stress.clone(), velocity.clone()).characteristic_cubic_per_s();
    let found = certified_roots(&cubic, digits);
    let bits = bits_for_digits(digits);
    let natural = Ball::from_rational(&slider.natural_angular_frequency_squared_per_s2(), bits).sqrt();
    let root = found.roots.last().filter(|_| found.discriminant_sign < 0)?;
    Some([root.im_ball() / natural, root.re_ball()])
}

#[test]
fn at_points_of_the_line_the_roots_of_eq_8_have_its_ratio_and_its_real_part() {
    let mut random = SplitMix64(39);
    let mut seen = [0; 3];
    for _ in 0..points() / 20 {
        let (slider, ratio) = (slider(&mut random), ratio(&mut random));
        let line = PairLine::new(&slider, &ratio, 2 * DIGITS);
        for point in line.sample(19, 1e-4) {
            let [stress, velocity] = [&point.normal_stress_pa, &point.loading_velocity_m_per_s]
                .map(|ball| ball.centre().to_rational().unwrap());
            let [found, real] = pair(&slider, [&stress, &velocity], DIGITS).unwrap();
            let natural = slider.natural_angular_frequency_squared_per_s2();
            let (found, expected) = match &ratio {
                PairRatio::Frequency(threshold) => {
                    (found, Ball::from_rational(threshold.squared_ratio(), 200).sqrt())
                }
                PairRatio::Damping(ratio) => {
                    let modulus = found.square() * Ball::from_rational(&natural, 200) + real.square();
                    (-real.clone() / modulus.sqrt(), Ball::from_rational(ratio.value(), 200))
                }
            };
            let error = (found / expected - Ball::from(1)).to_f64();
            assert!(error.abs() < 1e-25, "{slider:?} {point:?} {error}");
            let rate = Ball::from_rational(&(velocity / &slider.critical_slip_distance_m), 200);
            let scale = rate.clone() * (Ball::from(1) + &point.real_part.square());
            let error = ((real - rate * &point.real_part) / scale).to_f64();
            assert!(error.abs() < 1e-20, "{slider:?} {point:?} {error}");
            let sign = point.real_part.sign().map_or(0, |sign| -(sign as i8));
            assert_eq!(sign, point.transition_sign);
            seen[(sign + 1) as usize] += 1;
        }
    }
    assert!(seen[0].min(seen[2]) > points() / 100 && seen[1] > points() / 200, "{seen:?}");
}

/// Low normal stress makes the pair nearly ±iω_n; each crossing of the line changes the side.
#[test]
fn the_side_of_the_line_is_that_of_the_exact_frequency_at_random_points() {
    let mut random = SplitMix64(3907);
    let (mut above, mut counts) = (0, [0; 4]);
    for _ in 0..points() / 50 {
        let (slider, threshold) = (slider(&mut random), threshold(&mut random));
        let ratio = Ball::from_rational(threshold.squared_ratio(), 200).sqrt();
        let line = PairLine::new(&slider, &PairRatio::Frequency(threshold.clone()), DIGITS);
        let velocity = decimal(libm::exp10(8.0 * random.unit() - 5.0));
        let crossings = line.on_section(&Section::AtVelocity(velocity.clone())).unwrap();
        counts[crossings.len()] += 1;
        for _ in 0..50 {
            let stress = decimal(libm::exp10(10.0 * random.unit()));
            let sought = Ball::from_rational(&stress, 200);
            let below = crossings
                .iter()
                .filter(|point| (point.normal_stress_pa.clone() - &sought).sign() == Some(Ordering::Less));
            let is_above = below.count() % 2 == 0;
            let found = pair(&slider, [&stress, &velocity], DIGITS);
            let expected = found.is_some_and(|[found, _]| (found - &ratio).sign() == Some(Ordering::Greater));
            assert_eq!(is_above, expected, "{slider:?} {threshold:?} {velocity} {stress} {crossings:?}");
            above += usize::from(is_above);
        }
    }
    assert!(above > points() / 5 && points() - above > points() / 5, "{above}");
    assert!(counts[1] > 0 && counts[3] > 0 && counts[0] + counts[2] == 0, "{counts:?}");
}

#[test]
fn points_at_given_velocity_and_normal_stress_are_points_of_the_sampled_line() {
    let mut random = SplitMix64(5);
    for _ in 0..40 {
        let (slider, ratio) = (slider(&mut random), ratio(&mut random));
        let line = PairLine::new(&slider, &ratio, DIGITS);
        for point in line.sample(5, 1e-3) {
            let [stress, velocity] = [&point.normal_stress_pa, &point.loading_velocity_m_per_s]
                .map(|ball| ball.centre().to_rational().unwrap());
            for section in [Section::AtVelocity(velocity.clone()), Section::AtNormalStress(stress.clone())] {
                let found = line.on_section(&section).unwrap();
                let is_near = |one: &Ball, other: &Ball| (one.to_f64() / other.to_f64() - 1.0).abs() < 1e-12;
                let near = found.iter().filter(|other| {
                    is_near(&other.normal_stress_pa, &point.normal_stress_pa)
                        && is_near(&other.loading_velocity_m_per_s, &point.loading_velocity_m_per_s)
                });
                assert_eq!(near.count(), 1, "{slider:?} {ratio:?} {section:?}");
            }
        }
    }
}

#[test]
fn asymptotes_are_off_by_the_leading_terms() {
    // exact/asymptote − 1: β/(2(1−T)κ) at eq 20 and −2β(1−2T)κ/(β−1)² at eq 18; at T = 1/2 the latter is of second order.
    for (b, squared) in [(6, (1, 3)), (2, (1, 3)), (6, (3, 4)), (6, (1, 2))] {
        let slider = with_effects(Rational::from((4, 1000)), Rational::from((b, 1000)));
        let threshold = InertialThreshold::from_squared_ratio(Rational::from(squared)).unwrap();
        let [beta, ratio] = [f64::from(b) / 4.0, f64::from(squared.0) / f64::from(squared.1)];
        let points = PairLine::new(&slider, &PairRatio::Frequency(threshold), DIGITS).sample(2, 1e-6);
        let [first, last] = [points.first().unwrap(), points.last().unwrap()];
        let kappa = |point: &PairLinePoint| point.groups.stiffness_group.to_f64();
        assert_eq!([first.asymptote, last.asymptote], [Asymptote::InertialLower, Asymptote::InertialUpper]);
        let expected = beta / (2.0 * (1.0 - ratio) * kappa(first));
        assert!((first.relative_error.to_f64() / expected - 1.0).abs() < 1e-4);
        let expected = -2.0 * beta * (1.0 - 2.0 * ratio) * kappa(last) / (beta - 1.0).powi(2);
        assert!((last.relative_error.to_f64() - expected).abs() < 1e-10, "{b} {squared:?}");
    }
}

#[test]
fn the_line_crosses_the_transition_at_v_c_times_the_ratio_and_sigma_c_times_the_rest() {
    let slider = paper();
    let threshold = InertialThreshold::from_ratio(&parse_decimal("0.6").unwrap()).unwrap();
    let threshold = PairRatio::Frequency(threshold);
    let crossing = PairLine::new(&slider, &threshold, DIGITS).transition().unwrap();
    let velocity = Ball::from_rational(&slider.critical_velocity_squared(), 200).sqrt().to_f64();
    assert!((crossing.loading_velocity_m_per_s.to_f64() / (0.6 * velocity) - 1.0).abs() < 1e-14);
    assert!((crossing.normal_stress_pa.to_f64() / (0.64 * 50e3) - 1.0).abs() < 1e-14);
    assert!(PairLine::new(&with_effects(1.into(), 1.into()), &threshold, DIGITS).transition().is_none());
}

#[test]
fn the_line_of_a_damping_ratio_ends_at_its_asymptotes_and_has_as_many_curves_as_its_roots_say() {
    let number = |text: &str| parse_decimal(text).unwrap();
    let asymptotes = |[a, b]: [&str; 2], ratio: &str| {
        let slider = with_effects(number(a), number(b));
        let ratio = PairRatio::Damping(DampingRatio::new(number(ratio)).unwrap());
        let points = PairLine::new(&slider, &ratio, DIGITS).sample(2, 1e-6);
        assert!(points.iter().all(|point| point.relative_error.to_f64().abs() < 1e-5), "{points:?}");
        points.iter().map(|point| point.asymptote.as_str()).collect::<Vec<_>>()
    };
    let (weak, strong) = (["0.006", "0.004"], ["0.004", "0.006"]);
    assert_eq!(asymptotes(strong, "0.05"), ["eq20", "eq16"]);
    assert_eq!(asymptotes(strong, "-0.05"), ["eq15", "eq18"]);
    // ζ² < 1 − b/a = 1/3, and above.
    assert_eq!(asymptotes(weak, "0.5"), ["eq20", "eq18"]);
    assert_eq!(asymptotes(weak, "0.6"), ["eq20", "eq16", "eq15", "eq18"]);
    assert_eq!(asymptotes(["0.004", "0.004"], "0.05"), ["eq20", "eq16"]);
    assert!(asymptotes(weak, "-0.05").is_empty() && asymptotes(["0.004", "0.004"], "-0.05").is_empty());
    assert!(["0", "1", "-1", "1.5"].iter().all(|ratio| DampingRatio::new(number(ratio)).is_none()));
}

#[test]
fn close_to_one_the_limits_of_the_line_of_a_damping_ratio_are_eqs_15_and_16() {
    let slider = paper().map(|value| value.to_f64());
    for (ratio, asymptote) in
        [("0.9999999999", Asymptote::QuasiStaticLower), ("-0.9999999999", Asymptote::QuasiStaticUpper)]
    {
        let ratio = PairRatio::Damping(DampingRatio::new(parse_decimal(ratio).unwrap()).unwrap());
        let points = PairLine::new(&paper(), &ratio, DIGITS).sample(2, 1e-3);
        let point = points.iter().find(|point| point.asymptote == asymptote).unwrap();
        let expected = asymptote.value(&slider, &1e-3);
        assert!((point.asymptote_value.to_f64() / expected - 1.0).abs() < 1e-8, "{expected} {point:?}");
    }
}
