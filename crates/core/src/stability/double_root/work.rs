//! What a crossing took: for the tests and sweeps that keep the cost from rising unseen.

/// Counts of the computation of one crossing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Work {
    /// Newton steps in double-double arithmetic.
    pub double_double_steps: u32,
    /// The precision of each interval Newton step, bits.
    pub newton_bits: Vec<u32>,
    /// The precision of the evaluation at the end, bits.
    pub evaluation_bits: u32,
}

/// Bits of a limb.
const LIMB_BITS: u32 = 64;

impl Work {
    /// The sum of squares of the limbs of the Newton steps and the evaluation: their products' cost.
    #[must_use]
    pub fn limb_products(&self) -> u32 {
        let limbs = |bits: &u32| bits.div_ceil(LIMB_BITS).pow(2);
        self.newton_bits.iter().chain([&self.evaluation_bits]).map(limbs).sum()
    }
}
