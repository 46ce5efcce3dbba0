//! What the slider does far from steady sliding, under both evolution laws:
//! `cargo run -p slipmode-core --example simulate [σ in Pa] [V0 in m/s]`.

use std::error::Error;

use slipmode_core::{EvolutionLaw, OperatingPoint, Slider};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut argument = |default: &str| arguments.next().unwrap_or_else(|| default.into());
    let slider = Slider::new("0.004", "0.006", "1e-5", "1e7", "1000")?;
    let point = OperatingPoint::new(argument("1e6"), argument("1e-5"))?;
    for law in EvolutionLaw::ALL {
        let found = slider.simulate(&point, law, 1e-6)?;
        println!("{law} law: {}, {}", found.behaviour, found.slip_mode);
        println!(
            "  peak velocity  {:.6e} m/s  (estimated relative error {:.0e})",
            found.peak_velocity_m_per_s, found.peak_relative_error
        );
        if let Some((period_s, error)) = found.period_s.zip(found.period_relative_error) {
            println!("  period         {period_s:.6e} s    (estimated relative error {error:.0e})");
        }
    }
    Ok(())
}
