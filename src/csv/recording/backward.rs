//! Velocities of a trajectory that are zero or negative: how many, on which rows, and what they probably are.

use crate::scene::{CsvProblem, Fault};
use slipmode_core::number::format::shortest;

/// Runs of rows that a message names.
const MOST_RUNS: usize = 8;

/// The rows of a trajectory whose velocity is not positive.
#[derive(Default)]
pub struct Backward {
    count: usize,
    negative: usize,
    /// The least velocity, m/s.
    least: f64,
    /// First and last row of each run, and perhaps one run more than are named.
    runs: Vec<(u64, u64)>,
    line: Option<usize>,
}

impl Backward {
    /// Notes a velocity (m/s) that is not positive, with its row and line.
    pub fn note(&mut self, velocity: f64, row: u64, line: usize) {
        self.count += 1;
        self.negative += usize::from(velocity < 0.0);
        self.least = self.least.min(velocity);
        self.line.get_or_insert(line);
        let has_room = self.runs.len() <= MOST_RUNS;
        match self.runs.last_mut() {
            Some((_, last)) if *last + 1 == row => *last = row,
            _ if has_room => self.runs.push((row, row)),
            _ => {}
        }
    }

    /// One fault for all these rows, if there are any; `forward` velocities are positive, and V0 is given by its logarithm.
    pub fn fault(&self, file: &str, forward: usize, log_level: f64) -> Option<Fault> {
        let problem = CsvProblem::NotForward {
            count: self.count,
            of: self.count + forward,
            rows: self.rows(),
            least: shortest(self.least),
            reading: self.reading(forward, log_level),
        };
        (self.count > 0).then(|| Fault::of(file, "column velocity_m_per_s", problem).at(self.line))
    }

    fn rows(&self) -> String {
        let run = |&(first, last): &(u64, u64)| match last - first {
            0 => first.to_string(),
            _ => format!("{first}-{last}"),
        };
        let more = if self.runs.len() > MOST_RUNS { ", and more" } else { "" };
        let runs: Vec<String> = self.runs.iter().take(MOST_RUNS).map(run).collect();
        format!("{}{more}", runs.join(", "))
    }

    /// What such velocities probably are, and what to do.
    fn reading(&self, forward: usize, log_level: f64) -> &'static str {
        if self.negative > forward {
            return "most velocities are negative, so the sign convention seems reversed: multiply the column by -1";
        }
        if -self.least <= libm::exp(log_level) {
            return "none exceeds V0 in size, as with the noise or the resolution of a sensor while the slider sticks: \
                    smooth the record, or leave these rows out";
        }
        "the slider moved back faster than V0, which needs another law, such as one regularised at V = 0: \
         compare such a run with a program that has its law, or check the zero of the sensor"
    }
}
