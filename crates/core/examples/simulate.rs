//! What the slider does far from steady sliding, under both evolution laws:
//! `cargo run -p slipmode-core --example simulate [σ in Pa] [V0 in m/s]`.

use std::error::Error;

use slipmode_core::{EvolutionLaw, SimulationOptions, Slider, parse_decimal, simulate};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut argument = |default: &str| parse_decimal(&arguments.next().unwrap_or_else(|| default.into()));
    let [a, b, d_c, k, m] = ["0.004", "0.006", "1e-5", "1e7", "1000"].map(parse_decimal);
    let parameters = Slider::from([a?, b?, d_c?, k?, m?]).at(argument("1e6")?, argument("1e-5")?);
    for law in EvolutionLaw::ALL {
        let found = simulate(&parameters, law, &SimulationOptions::at(1e-6))?;
        println!("{} law: {}, {}", law.as_str(), found.behaviour.as_str(), found.slip_mode.as_str());
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
