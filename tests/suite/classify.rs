//! `classify` of one point: signs that are never wrong, the same answer as text, as JSON and in every spelling.

use serde_json::Value;

use crate::harness::{SLIDER, Workplace};

/// The JSON object of a point.
fn classify(values: [&str; 7], more: &[&str]) -> Value {
    let options = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"];
    let pairs = options.into_iter().zip(values).flat_map(|(option, value)| [option, value]);
    let arguments = ["classify", "--json"].into_iter().chain(pairs).chain(more.iter().copied());
    serde_json::from_str(&Workplace::new().run(arguments).expect_warnings()).unwrap()
}

/// A point with these groups: every unit is 1, so that η = M, κ = K, β = b.
fn with_groups(eta: &str, kappa: &str, beta: &str) -> Value {
    classify(["1", beta, "1", kappa, eta, "1", "1"], &[])
}

#[test]
fn a_point_on_the_transition_has_sign_zero_and_its_neighbours_have_not() {
    // K_c = (b−a)(σ/D_c)(1+η) = 0.002·49 750/1e-5·(1 + 1/199) = 1e7 exactly, in decimals that binary cannot hold.
    let at = |stiffness: &str| classify(["0.004", "0.006", "1e-5", stiffness, "1000", "49750", "1e-4"], &[]);
    let on = at("1e7");
    assert_eq!((&on["transition_sign"], &on["spectral_class"]), (&0.into(), &"neutral".into()));
    assert_eq!(on["max_real_per_s"], 0.0);
    assert_eq!(on["transition_distance"]["log10_normal_stress"], 0.0);
    let above = at("10000000.0000000000000000000000000000001");
    let below = at("9999999.9999999999999999999999999999999");
    assert_eq!((&above["transition_sign"], &below["transition_sign"]), (&1.into(), &(-1).into()));
    assert!(
        above["max_real_per_s"].as_f64().unwrap() < 0.0 && below["max_real_per_s"].as_f64().unwrap() > 0.0
    );
}

#[test]
fn the_growth_rate_next_to_the_transition_has_the_digits_of_the_root() {
    let stiffness = "42.93364104130763352800000042933641041307633528";
    let near = classify(["1", "1.05704", "1", stiffness, "751.6935666428407", "1", "1"], &[]);
    let growth = near["max_real_per_s"].as_f64().unwrap();
    assert!((growth / -3.585_107_057_402_012_5e-31 - 1.0).abs() < 1e-14, "{growth:e}");
}

#[test]
fn a_point_on_the_boundary_has_sign_zero_and_its_neighbours_have_not() {
    // The cusp at a = b: η = 1/8, κ = 27/8, a triple root −3.
    let cusp = with_groups("0.125", "3.375", "1");
    assert_eq!((&cusp["boundary_sign"], &cusp["max_imaginary_per_s"]), (&0.into(), &0.0.into()));
    assert_eq!(cusp["boundary_distance"]["log10_normal_stress"], 0.0);
    assert_eq!(
        cusp["roots"],
        serde_json::json!([{"re": "-3.0000000000000000", "im": "0", "radius": "0", "multiplicity": 3}])
    );
    // The curve at r = 1, β = 9: η = 5/8, κ = 23/8; along it dκ/dη = −1, so that a step in κ alone leaves it.
    let on = with_groups("0.625", "2.875", "9");
    assert_eq!((&on["boundary_sign"], &on["spectral_class"]), (&0.into(), &"unstable-real".into()));
    let inside = with_groups("0.625", "2.87499999999999999999999999999", "9");
    let outside = with_groups("0.625", "2.87500000000000000000000000001", "9");
    assert_eq!((&inside["boundary_sign"], &outside["boundary_sign"]), (&1.into(), &(-1).into()));
    assert!(outside["max_imaginary_per_s"].as_f64().unwrap() > 0.0);
    assert_eq!(outside["rung"], "exact");
}

#[test]
fn the_threshold_is_an_argument_and_decided_exactly() {
    // Eq 8 is (p + 2)(p² + p + 1/2)/2 at η = κ = 1/2 and b/a = 1/4: the pair is −1/2 ± i/2, and ω_n² = κ/η = 1.
    let at = |threshold: &str| {
        let point = ["1", "0.25", "1", "0.5", "0.5", "1", "1"];
        classify(point, &["--inertial-threshold", threshold])["slip_mode"].clone()
    };
    assert_eq!(at("0.4999999999999999999999999"), "inertial-underdamped-oscillation");
    assert_eq!(at("0.5"), "non-inertial-underdamped-oscillation", "ω/ω_n is 0.5, not above it");
}

#[test]
fn long_and_short_options_and_any_spelling_of_a_number_mean_the_same() {
    let place = Workplace::new();
    let short = place.run(["classify"].iter().chain(&SLIDER).chain(&["-s", "1e5", "-v", "1e-3"]).copied());
    let long = place.run([
        "classify",
        "--direct-effect=0.0040",
        "--evolution-effect=6e-3",
        "--critical-slip-distance-m",
        "+0.00001",
        "--stiffness-pa-per-m=10000000",
        "--mass-per-area-kg-per-m2=1E3",
        "--normal-stress-pa=100000.0",
        "--loading-velocity-m-per-s=.001",
    ]);
    assert_eq!(short.expect_success(), long.expect_success());
}

#[test]
fn values_beyond_64_bit_numbers_are_neither_infinite_nor_zero() {
    let far = classify(["1e299", "1e300", "1e-300", "1e-300", "1e-300", "1e300", "1e300"], &[]);
    let text = far["max_real_per_s"].as_str().expect("a text, where a JSON number would overflow");
    assert!(text.ends_with("e599"), "{text}");
    assert_eq!((&far["transition_sign"], &far["spectral_class"]), (&(-1).into(), &"unstable-real".into()));
}

#[test]
fn the_json_object_has_the_agreed_names() {
    let point = classify(["0.004", "0.006", "1e-5", "1e7", "1000", "1e5", "1e-3"], &[]);
    let names: Vec<_> = point.as_object().unwrap().keys().map(String::as_str).collect();
    for name in [
        "transition_sign",
        "boundary_sign",
        "spectral_class",
        "slip_mode",
        "max_real_per_s",
        "max_imaginary_per_s",
        "rung",
        "critical_stiffness_pa_per_m",
        "groups",
        "roots",
    ] {
        assert!(names.contains(&name), "{name}");
    }
    assert_eq!(point["critical_stiffness_pa_per_m"], 2.5e7);
    assert_eq!(point["groups"]["effect_ratio"], 1.5);
    assert_eq!(point["roots"].as_array().unwrap().len(), 3);
}
