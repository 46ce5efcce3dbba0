//! Scenes as users write them: the full one, and the ways to get one wrong.

use super::*;
use crate::experiments::boundary::BoundarySection;
use crate::scene::PlanePoint;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;
use slipmode_core::number::parse_decimal;

const SLIDER: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 10e-6\nstiffness_pa_per_m = 10e6\nmass_per_area_kg_per_m2 = 1000\n";

fn parse(text: &str) -> Result<Scene, Faults> {
    Scene::parse("s.toml", text.as_bytes(), &Limits::default())
}

/// The messages of the faults of the slider's scene with more text appended.
fn messages(more: &str) -> Vec<String> {
    parse(&format!("{SLIDER}{more}")).unwrap_err().iter().map(ToString::to_string).collect()
}

#[test]
fn decimals_are_taken_from_their_text() {
    let scene = parse(SLIDER).unwrap();
    let parameters = scene.parameters.unwrap();
    assert_eq!(parameters.slider.direct_effect, Rational::from((1, 250)));
    assert_eq!(parameters.normal_stress_pa, None);
    let quoted = parse(&SLIDER.replace("0.004", "\"0.00400000000000000000001\"")).unwrap();
    assert_eq!(
        quoted.parameters.unwrap().slider.direct_effect,
        parse_decimal("0.00400000000000000000001").unwrap()
    );
}

#[test]
fn every_section_is_read() {
    let axes = "loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 5 }\n\
        normal_stress_pa = { from = 1e2, to = 1e8, points = 7 }\n";
    let points = "points = [{ loading_velocity_m_per_s = 1e-5, normal_stress_pa = 1e3 }]\n";
    let text = format!(
        "{SLIDER}normal_stress_pa = 1e5\nloading_velocity_m_per_s = 1e-4\n[map]\n{axes}[zones]\n{axes}\
         [inertial_threshold]\nfrequency_ratio = 0.7\n[boundary]\npoints = 400\ndigits = 50\n\
         [frequency]\nnormal_stress_over_critical = [\"1/3\", 1, 3.5]\n\
         loading_velocity_m_per_s = {{ from = 1e-6, to = 1e-1, points = 5 }}\n\
         [effect_ratio_sweep]\neffect_ratio = {{ from = 1e-3, to = 1e3, points = 9 }}\nnear_equal = [1e-3]\n\
         [tolerance]\nrelative = [0.1, 0.01]\n\
         [simulations]\n{axes}laws = [\"slip\", \"aging\"]\ntolerance = 1e-8\n\
         [own_weight]\ngravity_m_per_s2 = 9.81\nloading_velocity_m_per_s = {{ from = 1e-6, to = 1e-1, points = 5 }}\n\
         stiffness_over_mass_per_s2 = {{ from = 1e3, to = 1e6, points = 3 }}\n\
         [linear_regime]\n{points}laws = [\"aging\"]\namplitudes = [1e-3, 1e-9]\n\
         [start_sensitivity]\n{points}laws = [\"slip\"]\ntolerance = 1e-8\n\
         [onset]\nnormal_stress_pa = [1778.28, 562.34]\nvelocity_over_asymptote = [0.5, 5]\n\
         laws = [\"slip\"]\ntolerance = 1e-8\nvisible = 0.01\nother_unit_pa = 1e6\n\
         [near_transition]\ninertial_parameter = [0.01]\nstiffness_over_critical = [1.002]\n\
         edge_inertial_parameter = [0.02]\ntolerance = 1e-6\n\
         kicks = {{ inertial_parameter = 0.02, stiffness_over_critical = [1.003] }}\n\
         [trajectories]\ntolerance = 1e-8\n{POINT}"
    );
    let scene = parse(&text).unwrap();
    assert_eq!(scene.map.unwrap().rectangle.normal_stress_pa.points, 7);
    assert_eq!(scene.inertial_threshold, Some(Rational::from((7, 10))));
    assert_eq!(scene.boundary, Some(BoundarySection { points: 400, digits: 50 }));
    let ratios = [(1, 3), (1, 1), (7, 2)].map(Rational::from);
    assert_eq!(scene.frequency.unwrap().normal_stress_over_critical, ratios);
    let simulations = scene.simulations.unwrap();
    assert_eq!(simulations.laws, [EvolutionLaw::Slip, EvolutionLaw::Aging]);
    assert_eq!(simulations.tolerance, Rational::from((1, 100_000_000)));
    let point = scene.trajectories.unwrap().points.remove(0);
    assert_eq!((point.id.as_str(), point.laws.as_slice()), ("3g", [EvolutionLaw::Aging].as_slice()));
    assert_eq!(point.loading_velocity_m_per_s, Rational::from((3, 10_000)));
    assert_eq!(point.duration_s, Rational::from((2, 5)));
    let linear = scene.linear_regime.unwrap();
    let place = PlanePoint {
        loading_velocity_m_per_s: Rational::from((1, 100_000)),
        normal_stress_pa: Rational::from(1000),
    };
    assert_eq!(linear.points, [place]);
    assert_eq!(linear.amplitudes.len(), 2);
    assert_eq!(scene.own_weight.unwrap().gravity_m_per_s2, Rational::from((981, 100)));
    assert_eq!(scene.start_sensitivity.unwrap().laws, [EvolutionLaw::Slip]);
    let onset = scene.onset.unwrap();
    assert_eq!((onset.normal_stress_pa.len(), onset.velocity_over_asymptote.len()), (2, 2));
    assert_eq!(onset.other_unit_pa, Some(Rational::from(1_000_000)));
    let near = scene.near_transition.unwrap();
    assert_eq!(near.stiffness_over_critical, [Rational::from((501, 500))]);
    assert_eq!(near.kicks.unwrap().stiffness_over_critical, [Rational::from((1003, 1000))]);
    assert!(scene.parameters.unwrap().point().is_some());
}

const POINT: &str = "[[trajectories.point]]\nid = \"3g\"\nnormal_stress_pa = 1e3\n\
    loading_velocity_m_per_s = 3e-4\nlaws = [\"aging\"]\nduration_s = 0.4\n";

#[test]
fn points_of_trajectories_have_names_of_their_own_and_positive_durations() {
    let twice = messages(&format!("[trajectories]\ntolerance = 1e-8\n{POINT}{POINT}"));
    assert!(
        twice[0].contains("trajectories.point[2]") && twice[0].contains("an earlier id `3g`"),
        "{twice:?}"
    );
    let endless = POINT.replace("0.4", "0").replace("3g", "../3g");
    let said = messages(&format!("[trajectories]\ntolerance = 1e-8\n{endless}"));
    assert_eq!(said.len(), 2, "{said:?}");
    assert!(said[1].contains("point[1].duration_s = 0: must be > 0"), "{said:?}");
    let none = messages("[trajectories]\ntolerance = 1e-8\n");
    assert!(none[0].contains("trajectories.point: missing"), "{none:?}");
}

#[test]
fn faults_of_points_and_amplitudes_are_all_named_and_their_product_is_limited() {
    let points = |stress: &str| {
        format!("points = [{{ loading_velocity_m_per_s = 1e-5, normal_stress_pa = {stress} }}]\n")
    };
    let faulty =
        format!("[linear_regime]\n{}laws = [\"slip\"]\namplitudes = [1e-3, 1e-3, 1e-20]\n", points("-1"));
    let said = messages(&faulty);
    assert_eq!(said.len(), 3, "{said:?}");
    assert!(said[0].contains("linear_regime.points[1].normal_stress_pa = -1: must be > 0"), "{said:?}");
    assert!(said[1].contains("the same as an earlier member"), "{said:?}");
    assert!(said[2].contains("1e-15 to 0.1"), "{said:?}");
    let sound = format!("{SLIDER}[linear_regime]\n{}laws = [\"slip\"]\namplitudes = [1e-3]\n", points("1e3"));
    let limits = Limits { max_points: 2 };
    let faults = Scene::parse("s.toml", sound.as_bytes(), &limits).unwrap_err();
    assert!(faults[0].to_string().contains("3 points exceed the limit of 2"), "{faults:?}");
}

#[test]
fn unknown_and_doubled_laws_and_a_tolerance_out_of_reach_are_all_named() {
    let axes = "loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 5 }\n\
        normal_stress_pa = { from = 1e2, to = 1e8, points = 7 }\n";
    let faulty = "laws = [\"slip\", \"ageing\", \"slip\"]\ntolerance = 1e-16\n";
    let faults = parse(&format!("{SLIDER}[simulations]\n{axes}{faulty}")).unwrap_err();
    let said: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(said.len(), 3, "{said:?}");
    assert!(said[0].contains("did you mean `aging`?"), "{said:?}");
    assert!(said[1].contains("an earlier law `slip`"), "{said:?}");
    assert!(said[2].contains("1e-15 to 1e-2"), "{said:?}");
}

#[test]
fn all_faults_are_reported_at_once_in_the_order_of_lines() {
    let text = "name = \"../x\"\ntitle = 3\n[parameters]\ndirect_effect = 0\nevolution_effect = nan\n\
        critical_slip_distance_m = -1e-5\nstiffness_pa_per_m = 1e400\nmass_per_area = 1000\n";
    let faults = parse(text).unwrap_err();
    let lines: Vec<_> = faults.iter().filter_map(|fault| fault.line).collect();
    assert_eq!(lines, [1, 2, 3, 4, 5, 6, 7, 8]);
    let last = faults.last().unwrap().to_string();
    assert!(last.starts_with("s.toml:8: parameters.mass_per_area: unknown key"), "{last}");
}

#[test]
fn an_unknown_key_names_the_nearest_known_one() {
    let found = messages("sigmaa = 3\nnormal_stres_pa = 1e5\n[mapp]\n");
    assert!(found[0].contains("sigmaa: unknown key (allowed: direct_effect, "), "{found:?}");
    assert!(found[1].contains("did you mean `normal_stress_pa`?"), "{found:?}");
    assert!(found[2].contains("mapp: unknown key; did you mean `map`?"), "{found:?}");
}

#[test]
fn ranges_must_ascend_from_a_positive_end() {
    let sweep = |axis: &str| messages(&format!("[effect_ratio_sweep]\neffect_ratio = {axis}\n")).join("\n");
    assert!(sweep("{ from = 2, to = 1, points = 3 }").contains("reversed range"));
    assert!(sweep("{ from = 2, to = 2.0, points = 3 }").contains("empty range"));
    assert!(sweep("{ from = 0, to = 2, points = 3 }").contains("effect_ratio.from = 0: must be > 0"));
    assert!(sweep("{ from = 1, to = 2, points = 1 }").contains("allowed: a whole number, 2 or more"));
    assert!(sweep("{ from = 1, to = 2, points = 2.5 }").contains("allowed: a whole number, 2 or more"));
    assert!(sweep("{ from = 1, to = 2 }").contains("effect_ratio.points: missing"));
    assert!(sweep("[1, 2]").contains("must be a table, not a list"));
}

#[test]
fn a_grid_over_the_limit_names_the_limit_and_the_flag() {
    let axes = |points: u64| {
        format!(
            "[map]\nloading_velocity_m_per_s = {{ from = 1, to = 2, points = {points} }}\n\
             normal_stress_pa = {{ from = 1, to = 2, points = {points} }}\n"
        )
    };
    assert!(parse(&format!("{SLIDER}{}", axes(2048))).is_ok());
    for points in [2049, 9_223_372_036_854_775_807] {
        let found = messages(&axes(points)).join("\n");
        assert!(found.contains("limit of 4194304 (--max-points N raises it)"), "{found}");
    }
    let lifted = Limits { max_points: 1 << 40 };
    assert!(Scene::parse("s", format!("{SLIDER}{}", axes(2049)).as_bytes(), &lifted).is_ok());
}

#[test]
fn fractions_are_read_wherever_numbers_are() {
    let ratios = |list: &str| {
        messages(&format!(
            "[frequency]\nnormal_stress_over_critical = {list}\n\
             loading_velocity_m_per_s = {{ from = 1, to = 2, points = 2 }}\n"
        ))
        .join("\n")
    };
    assert!(ratios("[\"1/0\"]").contains("normal_stress_over_critical[1] = \"1/0\": a division by zero"));
    assert!(ratios("[1, \"1/x\"]").contains("normal_stress_over_critical[2]"));
    assert!(ratios("[]").contains("at least one member"));
    let slider = |a: &str| parse(&SLIDER.replace("0.004", a)).unwrap().parameters.unwrap().slider;
    assert_eq!(slider("\"1/250\"").direct_effect, slider("0.004").direct_effect);
}

#[test]
fn scenes_of_one_name_are_refused_also_when_only_case_differs() {
    let scene = |name: &str| {
        let text = format!("name = \"{name}\"\ntitle = \"T\"\n");
        (format!("{name}.toml"), Scene::parse("s", text.as_bytes(), &Limits::default()).unwrap())
    };
    assert!(check_distinct_scene_names(&[scene("a"), scene("b")]).is_ok());
    assert_eq!(check_distinct_scene_names(&[scene("a"), scene("b"), scene("A")]).unwrap_err().len(), 1);
}

#[test]
fn sections_name_what_they_need() {
    let alone = parse("name = \"s\"\ntitle = \"S\"\n[tolerance]\nrelative = [0.1]\n").unwrap_err();
    assert!(alone[0].to_string().contains("tolerance: needs a [parameters] section"), "{}", alone[0]);
    let stable = SLIDER.replace("0.006", "0.004");
    let text = format!(
        "{stable}[frequency]\nnormal_stress_over_critical = [1]\n\
         loading_velocity_m_per_s = {{ from = 1, to = 2, points = 2 }}\n"
    );
    assert_eq!(parse(&text).unwrap_err()[0].problem, Problem::NoCriticalNormalStress);
}

#[test]
fn hostile_files_end_in_a_fault_with_a_line() {
    let nested = format!("a = {}", "[".repeat(100_000));
    let dotted = format!("{}a = 1", "a.".repeat(100_000));
    let doubled = format!("{SLIDER}direct_effect = 1\n");
    for text in [nested.as_str(), &dotted, &"+".repeat(100_000), &doubled, "a = \"x", "\u{0}"] {
        let faults = parse(text).unwrap_err();
        assert!(faults[0].line.is_some());
    }
    for number in ["0x1p3", "1_000", "0x10", "inf", "1e10001", "true", "\"1,5\"", "1979-05-27"] {
        assert!(parse(&SLIDER.replace("0.004", number)).is_err(), "{number}");
    }
}

proptest::proptest! {
    #[test]
    fn any_text_ends_in_a_scene_or_in_faults(text in "(?s).{0,200}") {
        if let Err(faults) = parse(&text) {
            proptest::prop_assert!(!faults.is_empty());
        }
    }

    #[test]
    fn any_value_of_a_key_ends_in_a_scene_or_in_faults_that_print(value in "[-+0-9a-z.\"'\\[\\]{}=, /]{0,30}") {
        for key in ["direct_effect = 0.004", "title = \"S\""] {
            let name = key.split(' ').next().unwrap_or_default();
            if let Err(faults) = parse(&SLIDER.replace(key, &format!("{name} = {value}"))) {
                proptest::prop_assert!(faults.iter().all(|fault| fault.to_string().starts_with("s.toml:")));
            }
        }
    }

    #[test]
    fn a_decimal_that_is_accepted_is_the_number_that_was_written(
        digits in 1u64..1_000_000_000,
        exponent in -290i32..290,
    ) {
        let text = format!("{digits}e{exponent}");
        let scene = parse(&SLIDER.replace("0.004", &text)).unwrap();
        proptest::prop_assert_eq!(scene.parameters.unwrap().slider.direct_effect, parse_decimal(&text).unwrap());
    }
}
