//! What a user of the library writes: `.ci/package` builds it outside of the repository, with the default features and without.

use std::error::Error;

use slipmode_core::{EvolutionLaw, Exact, OperatingPoint, Slider, SlipMode};

fn main() -> Result<(), Box<dyn Error>> {
    let slider = Slider::new("0.004", 0.006, Exact::try_from("1/100000")?, 10_000_000, 1000)?;
    let point = OperatingPoint::new("1e6", 1e-5)?;

    let found = slider.classify(&point);
    println!("{}, sign of K - K_c {}", found.slip_mode, found.transition_sign);
    assert_eq!(found.slip_mode, "stick-slip".parse::<SlipMode>()?);

    for root in slider.roots(&point, 20) {
        println!("root {} + i ({}) 1/s", root.real_per_s, root.imaginary_per_s);
    }
    let crossings = slider.boundary(15).at_normal_stress("1e6")?;
    for crossing in &crossings {
        println!("{} arc at V0 = {} m/s", crossing.arc, crossing.loading_velocity_m_per_s);
    }
    assert_eq!(crossings.len(), 1);
    let run = slider.simulate(&point, EvolutionLaw::Slip, 1e-4)?;
    println!("{}: peak {:.4e} m/s", run.behaviour, run.peak_velocity_m_per_s);

    for wrong in [f64::NAN, -9e6, 0.0, f64::INFINITY] {
        assert!(OperatingPoint::new(wrong, 1).is_err());
    }
    println!("{}", Slider::new("four", 0, 1, 1, f64::MAX).unwrap_err());
    Ok(())
}
