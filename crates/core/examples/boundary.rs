//! Where oscillation begins at one loading velocity, and how far the asymptotes are off:
//! `cargo run -p slipmode-core --example boundary [V0 in m/s]`.

use std::error::Error;

use slipmode_core::Slider;

fn main() -> Result<(), Box<dyn Error>> {
    let velocity = std::env::args().nth(1).unwrap_or_else(|| "1e-5".into());
    let slider = Slider::new("0.004", "0.006", "1e-5", "1e7", "1000")?;
    println!("arc    normal stress (Pa)   nearest asymptote   its relative error");
    for point in slider.boundary(15).at_loading_velocity(velocity)? {
        println!(
            "{:5}  {:<19}  {:18}  {:.3e}",
            point.arc,
            point.normal_stress_pa,
            point.asymptote,
            point.relative_error.to_f64()
        );
    }
    Ok(())
}
