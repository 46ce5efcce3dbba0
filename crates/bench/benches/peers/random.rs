//! The random set: parameters as wide as laboratories, faults and theory go, uniform in the logarithm, from a fixed seed.

use slipmode_bench::split_mix::SplitMix64;
use slipmode_core::friction::Parameters;

/// Random sliders and numbers.
pub struct Random(SplitMix64);

impl Random {
    /// From a seed.
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64(seed))
    }

    /// Uniform in the logarithm between two powers of ten.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        libm::exp10(self.0.between(low, high))
    }

    /// A multiple of 1/64 in [low, high).
    pub fn sixty_fourths(&mut self, low: f64, high: f64) -> f64 {
        (64.0 * self.0.between(low, high)).floor() / 64.0
    }

    /// One slider: V0 1e-9…10, σ 1e2…1e9, a 1e-4…3e-2, b/a 0.05…20, D_c 1e-7…1e-2, K 1e4…1e12, M 1e-2…1e7.
    pub fn parameters(&mut self) -> Parameters<f64> {
        let direct_effect = self.decades(-4.0, libm::log10(3e-2));
        Parameters::from([
            direct_effect,
            direct_effect * self.decades(libm::log10(0.05), libm::log10(20.0)),
            self.decades(-7.0, -2.0),
            self.decades(4.0, 12.0),
            self.decades(-2.0, 7.0),
            self.decades(2.0, 9.0),
            self.decades(-9.0, 1.0),
        ])
    }
}
