//! Where oscillation begins at one loading velocity, and how far the asymptotes are off:
//! `cargo run -p slipmode-core --example boundary [V0 in m/s]`.

use slipmode_core::{BoundaryCurve, DecimalError, Slider, parse_decimal};

fn main() -> Result<(), DecimalError> {
    let velocity = parse_decimal(&std::env::args().nth(1).unwrap_or_else(|| "1e-5".into()))?;
    let [a, b, d_c, k, m] = ["0.004", "0.006", "1e-5", "1e7", "1000"].map(parse_decimal);
    let slider = Slider::from([a?, b?, d_c?, k?, m?]);
    println!("arc    normal stress (Pa)   nearest asymptote   its relative error");
    for point in BoundaryCurve::new(&slider, 15).at_velocity(&velocity) {
        println!(
            "{:5}  {:<19.12e}  {:18}  {:.3e}",
            point.arc.as_str(),
            point.normal_stress_pa.to_f64(),
            point.asymptote.as_str(),
            point.relative_error.to_f64()
        );
    }
    Ok(())
}
