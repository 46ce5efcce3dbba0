//! How a slider slips: `cargo run -p slipmode-core --example classify [σ in Pa] [V0 in m/s]`.

use slipmode_core::{DecimalError, InertialThreshold, Slider, classify, parse_decimal};

fn main() -> Result<(), DecimalError> {
    let mut arguments = std::env::args().skip(1);
    let mut argument = |default: &str| parse_decimal(&arguments.next().unwrap_or_else(|| default.into()));
    let (normal_stress_pa, loading_velocity_m_per_s) = (argument("1e6")?, argument("1e-5")?);

    let slider = Slider {
        direct_effect: parse_decimal("0.004")?,
        evolution_effect: parse_decimal("0.006")?,
        critical_slip_distance_m: parse_decimal("1e-5")?,
        stiffness_pa_per_m: parse_decimal("1e7")?,
        mass_per_area_kg_per_m2: parse_decimal("1000")?,
    };
    let found =
        classify(&slider.at(normal_stress_pa, loading_velocity_m_per_s), &InertialThreshold::default());
    println!("slip mode        {}", found.slip_mode.as_str());
    println!("sign of K - K_c  {}", found.transition_sign);
    println!("class of roots   {}", found.spectral_class.as_str());
    println!("decided in       {}", found.precision_level.as_str());
    Ok(())
}
