//! How a slider slips: `cargo run -p slipmode-core --example classify [σ in Pa] [V0 in m/s]`.

use std::error::Error;

use slipmode_core::{OperatingPoint, Slider};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut argument = |default: &str| arguments.next().unwrap_or_else(|| default.into());
    let slider = Slider::new("0.004", "0.006", "1e-5", "1e7", "1000")?;
    let point = OperatingPoint::new(argument("1e6"), argument("1e-5"))?;
    let found = slider.classify(&point);
    println!("slip mode        {}", found.slip_mode);
    println!("sign of K - K_c  {}", found.transition_sign);
    println!("class of roots   {}", found.spectral_class);
    for root in slider.roots(&point, 15) {
        println!("root (1/s)       {} + i ({})", root.real_per_s, root.imaginary_per_s);
    }
    Ok(())
}
