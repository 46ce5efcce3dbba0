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
