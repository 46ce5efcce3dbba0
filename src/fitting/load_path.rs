//! The path of the load point as straight pieces: where its velocity changes, and by how much.

use std::ops::Range;

/// The path of a load point in pieces of constant velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPath {
    /// The sample at which each piece ends; it begins where the one before ends, and the first one at sample 0.
    pub ends: Vec<usize>,
    /// The velocity of each piece, m/s.
    pub velocities_m_per_s: Vec<f64>,
    /// By how much the pieces miss a displacement, m, at most.
    pub resolution_m: f64,
}

/// The most pieces: a record with more has a displacement that is noise, and longer pieces are drawn through it.
const MOST_PIECES: usize = 300;

impl LoadPath {
    /// The samples between two steps of velocity, the first one at the step, and the velocity of the load point there, m/s.
    pub fn strides(&self) -> impl Iterator<Item = (Range<usize>, f64)> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        let velocities = self.velocities_m_per_s.iter().copied();
        starts.zip(&self.ends).map(|(start, end)| start..*end).zip(velocities)
    }

    /// Straight pieces through these displacements (m), as long as they can be without a miss of more than the resolution (m).
    ///
    /// Where that needs more than 300 pieces, the resolution is doubled until it does not.
    pub fn through(times_s: &[f64], displacements_m: &[f64], resolution_m: f64) -> Self {
        let mut resolution_m = resolution_m;
        loop {
            let ends = ends(times_s, displacements_m, resolution_m);
            if ends.len() <= MOST_PIECES {
                let starts = [0].into_iter().chain(ends.iter().copied());
                let velocity = |(start, end): (usize, &usize)| {
                    (displacements_m[*end] - displacements_m[start]) / (times_s[*end] - times_s[start])
                };
                let velocities_m_per_s = starts.zip(&ends).map(velocity).collect();
                return Self { ends, velocities_m_per_s, resolution_m };
            }
            resolution_m *= 2.0;
        }
    }
}

/// The last sample of each piece. A piece goes on while one slope meets all of its samples.
fn ends(times_s: &[f64], displacements_m: &[f64], resolution_m: f64) -> Vec<usize> {
    let last = times_s.len() - 1;
    let mut ends = Vec::new();
    let mut start = 0;
    while start < last {
        let mut slopes = [f64::NEG_INFINITY, f64::INFINITY];
        let mut end = start + 1;
        for sample in start + 1..=last {
            let time = times_s[sample] - times_s[start];
            let way = displacements_m[sample] - displacements_m[start];
            // The chord to the last sample is the piece: it has to meet the samples before.
            let slope = way / time;
            if sample > start + 1 && !(slopes[0]..=slopes[1]).contains(&slope) {
                break;
            }
            let [low, high] = [-1.0, 1.0].map(|side| (way + side * resolution_m) / time);
            slopes = [slopes[0].max(low), slopes[1].min(high)];
            end = sample;
        }
        ends.push(end);
        start = end;
    }
    ends
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_end_where_the_velocity_changes() {
        let times: Vec<f64> = (0..400).map(|i| 0.1 * f64::from(i)).collect();
        let path = |t: f64| if t < 19.95 { 1e-6 * t } else { 1e-6 * 20.0 + 1e-5 * (t - 20.0) };
        let displacements: Vec<f64> = times.iter().map(|t| path(*t)).collect();
        let found = LoadPath::through(&times, &displacements, 1e-18);
        assert_eq!(found.ends, [200, 399]);
        assert!((found.velocities_m_per_s[1] / 1e-5 - 1.0).abs() < 1e-9);
        // Written with a resolution of 0.1 um the pieces are the same, to within a row.
        let rounded: Vec<f64> = displacements.iter().map(|x| (x * 1e7).round() / 1e7).collect();
        let found = LoadPath::through(&times, &rounded, 1e-7);
        assert!(found.ends.len() <= 4, "{found:?}");
    }

    #[test]
    fn a_path_of_noise_is_drawn_with_fewer_pieces() {
        let times: Vec<f64> = (0..2000).map(f64::from).collect();
        let displacements: Vec<f64> = times
            .iter()
            .enumerate()
            .map(|(i, t)| 1e-6 * t + 1e-7 * f64::from(u8::try_from(i * 7919 % 11).unwrap()))
            .collect();
        let found = LoadPath::through(&times, &displacements, 1e-12);
        assert!(found.ends.len() <= MOST_PIECES && found.resolution_m < 4e-6, "{}", found.resolution_m);
    }
}
