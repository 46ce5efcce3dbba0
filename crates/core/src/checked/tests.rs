//! No input makes a wrong slider or a panic.

use proptest::prelude::*;

use super::{Exact, NumberError, OperatingPoint, Slider};

/// Any pattern of bits as a 64-bit number, often one of the size of a parameter.
fn any_number() -> impl Strategy<Value = f64> {
    let bits = any::<u64>().prop_map(f64::from_bits);
    let sized = (-40.0..40.0_f64).prop_map(libm::exp10);
    let ends = prop::sample::select(vec![1e-300, 1e300, 1e300_f64.next_up(), 1e-300_f64.next_down()]);
    prop_oneof![1 => bits, 1 => ends, 4 => sized]
}

fn is_input(value: f64) -> bool {
    (1e-300..=1e300).contains(&value)
}

proptest! {
    #[test]
    fn a_slider_is_made_of_inputs_only_and_always_answers(values in prop::array::uniform7(any_number())) {
        let [a, b, d, k, m, s, v] = values;
        let (slider, point) = (Slider::new(a, b, d, k, m), OperatingPoint::new(s, v));
        let wrong = |values: &[f64]| values.iter().filter(|value| !is_input(**value)).count();
        prop_assert_eq!(slider.as_ref().map_or_else(|errors| errors.iter().count(), |_| 0), wrong(&values[..5]));
        prop_assert_eq!(point.as_ref().map_or_else(|errors| errors.iter().count(), |_| 0), wrong(&values[5..]));
        if let (Ok(slider), Ok(point)) = (slider, point) {
            let found = slider.classify(&point);
            prop_assert_eq!(found.growth_rate_per_s.is_some_and(|rate| rate < 0.0), found.transition_sign == 1 && found.growth_rate_per_s.is_some());
            let roots = slider.roots(&point, 10);
            prop_assert_eq!(roots.iter().map(|root| root.multiplicity).sum::<u32>(), 3);
            let is_complex = roots.iter().any(|root| !root.imaginary_per_s.is_zero());
            prop_assert_eq!(is_complex, found.boundary_sign == -1);
            let crossings = slider.boundary(10).at_loading_velocity(v);
            prop_assert!(crossings.is_ok_and(|points| points.len() <= 3));
        }
    }

    #[test]
    fn an_exact_number_is_read_back_from_its_text(value in any::<f64>(), parts in any::<(i64, u32)>()) {
        let quotient: Result<Exact, NumberError> = format!("{}/{}", parts.0, parts.1).parse();
        prop_assert_eq!(quotient.is_err(), parts.1 == 0);
        let number = Exact::try_from(value);
        prop_assert_eq!(number.is_err(), !value.is_finite());
        for number in number.into_iter().chain(quotient) {
            prop_assert_eq!(number.to_string().parse::<Exact>(), Ok(number));
        }
    }
}

#[test]
fn every_wrong_value_is_named_with_what_is_allowed() {
    let faults = Slider::new("four", "1/0", f64::INFINITY, "1e301", -1).unwrap_err();
    let said: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        [
            "direct_effect: not a decimal number (write digits such as 0.004 or 1e-5)",
            "evolution_effect: a division by zero",
            "critical_slip_distance_m: inf is not a finite number",
            "stiffness_pa_per_m: out of range (allowed: 1e-300 to 1e300)",
            "mass_per_area_kg_per_m2: -1 is not positive",
        ]
    );
}

#[test]
fn a_tolerance_that_no_run_can_have_is_refused() {
    let slider = Slider::new("0.004", "0.006", "1e-5", "1e7", 1000).unwrap();
    let point = OperatingPoint::new("1e6", "1e-5").unwrap();
    for tolerance in [f64::NAN, 0.0, -1.0, 1.0, f64::INFINITY] {
        assert!(slider.simulate(&point, crate::friction::EvolutionLaw::Slip, tolerance).is_err());
    }
}

#[cfg(feature = "serde")]
#[test]
fn what_is_stored_is_checked_when_it_is_read() {
    let slider = Slider::new("0.004", "1/3", "1e-5", "1e7", 1000).unwrap();
    let text = serde_json::to_string(&slider).unwrap();
    assert_eq!(text, r#"["0.004","1/3","1e-5","1e7","1000"]"#);
    assert_eq!(serde_json::from_str::<Slider>(&text).unwrap(), slider);
    let point = OperatingPoint::new("1e6", "1e-5").unwrap();
    assert_eq!(
        serde_json::from_str::<OperatingPoint>(&serde_json::to_string(&point).unwrap()).unwrap(),
        point
    );
    for (from, to, named) in
        [("0.004", "-4", "direct_effect"), ("0.004", "x", "not a decimal"), (",\"1000\"", "", "five numbers")]
    {
        let error = serde_json::from_str::<Slider>(&text.replacen(from, to, 1)).unwrap_err();
        assert!(error.to_string().contains(named), "{error}");
    }
}
