//! The row that every player prints for one way of doing one piece of work.

/// One measurement.
#[derive(Debug, Clone, Default)]
pub struct Row {
    /// The work, with what it was done on.
    pub work: String,
    /// How it was done.
    pub method: &'static str,
    /// The settings that matter, joined by `;`, with `~` for a blank.
    pub options: &'static str,
    /// The tolerance asked for, where the method has one.
    pub tolerance: Option<f64>,
    /// How many items were done in the time.
    pub items: usize,
    /// CPU seconds for all of them.
    pub seconds: f64,
    /// The worst error over all items, where values were computed; relative unless the work says otherwise. A text,
    /// because that of ten thousand digits is below the range of 64 bits.
    pub error: Option<String>,
    /// Wrong answers and items that were not answered.
    pub wrong: usize,
    /// Steps and evaluations of the right-hand side, where there are such.
    pub counts: Option<(u64, u64)>,
}

/// The tolerances of every method with one: 10^-1.5, 10^-2 … 10^-12.
pub fn tolerances() -> impl Iterator<Item = f64> {
    (3..=24).map(|halves| libm::exp10(-0.5 * f64::from(halves)))
}

/// Three digits of a number.
pub fn scientific(value: f64) -> String {
    format!("{value:.2e}")
}

impl Row {
    /// Prints the row.
    pub fn print(&self) {
        let absent = || "-".to_string();
        let count =
            |part: fn((u64, u64)) -> u64| self.counts.map_or_else(absent, |counts| part(counts).to_string());
        println!(
            "row work={} method={} options={} tolerance={} items={} seconds={:.6e} error={} wrong={} steps={} evaluations={}",
            self.work,
            self.method,
            if self.options.is_empty() { "-" } else { self.options },
            self.tolerance.map_or_else(absent, scientific),
            self.items,
            self.seconds,
            self.error.clone().unwrap_or_else(absent),
            self.wrong,
            count(|counts| counts.0),
            count(|counts| counts.1),
        );
    }
}
