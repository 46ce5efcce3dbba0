//! Numbers from rows by work and method; what has no row is named.

use super::PeerRow;
use super::compare::{ERRORS, cases, fastest};

/// A number that follows from rows.
#[derive(Debug, Clone, PartialEq)]
pub struct DerivedNumber {
    /// The number that a bound is compared with: of several, the least favourable one.
    pub value: f64,
    /// The smallest and the largest of several.
    pub range: Option<(f64, f64)>,
    /// Lines of the file; none where they are all of a work.
    pub lines: Vec<usize>,
}

/// A number; or which row is missing.
pub(crate) type Measured = Result<DerivedNumber, String>;

/// Looks up rows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rows<'r>(pub(crate) &'r [PeerRow]);

/// The error; a row without one counts as without limit, so that nothing is met by it.
pub(crate) fn error(row: &PeerRow) -> f64 {
    row.error_value().unwrap_or(f64::INFINITY)
}

/// The tolerances that ours are expected to meet within a factor of ten.
const TOLERANCES: [f64; 4] = [1e-4, 1e-6, 1e-8, 1e-10];

/// One number for each of several lines; of several, the value is the one that `pick` prefers.
fn found(values: &[(f64, Vec<usize>)], pick: fn(f64, f64) -> f64) -> Measured {
    let numbers = || values.iter().map(|(value, _)| *value);
    let value = numbers().reduce(pick).ok_or("no row of any of its works")?;
    let range = numbers().reduce(f64::min).zip(numbers().reduce(f64::max));
    let lines = values.iter().flat_map(|(_, lines)| lines).copied().collect();
    Ok(DerivedNumber { value, range: range.filter(|_| values.len() > 1), lines })
}

impl<'r> Rows<'r> {
    pub(crate) fn find(&self, work: &str, method: &str) -> Result<&'r PeerRow, String> {
        let found = self.0.iter().find(|row| row.work == work && row.method == method);
        found.ok_or_else(|| format!("no row `{work}, {method}`"))
    }

    /// A quantity of a method on several works, all of which must be there.
    pub(crate) fn of(
        &self,
        works: &[&str],
        method: &str,
        quantity: fn(&PeerRow) -> f64,
        pick: fn(f64, f64) -> f64,
    ) -> Measured {
        let row = |work: &&str| self.find(work, method).map(|row| (quantity(row), vec![row.line]));
        found(&works.iter().map(row).collect::<Result<Vec<_>, _>>()?, pick)
    }

    /// On each of several works the time of a peer's fastest method over ours; the value is the least.
    pub(crate) fn over_ours(&self, works: &[&str], peers: &[&str], ours: &str) -> Measured {
        let ratio = |work: &&str| {
            let mine = self.find(work, ours)?;
            let rows = peers.iter().filter_map(|peer| self.find(work, peer).ok());
            let peer = rows.min_by(|one, other| one.seconds_per_item().total_cmp(&other.seconds_per_item()));
            let peer = peer.ok_or_else(|| format!("no row `{work}, {}`", peers.join(" or ")))?;
            Ok::<_, String>((peer.seconds_per_item() / mine.seconds_per_item(), vec![peer.line, mine.line]))
        };
        found(&works.iter().map(ratio).collect::<Result<Vec<_>, _>>()?, f64::min)
    }

    /// Of one method, its time on the first of two works over that on the second; the value is the largest.
    pub(crate) fn between_works(&self, pairs: &[[&str; 2]], method: &str) -> Measured {
        let ratio = |[over, under]: &[&str; 2]| {
            let (over, under) = (self.find(over, method)?, self.find(under, method)?);
            Ok::<_, String>((over.seconds_per_item() / under.seconds_per_item(), vec![over.line, under.line]))
        };
        found(&pairs.iter().map(ratio).collect::<Result<Vec<_>, _>>()?, f64::max)
    }

    /// On one work the time of a peer's fastest tolerance without a wrong item over our row, at an error of at most this.
    pub(crate) fn over_ours_within(&self, work: &str, error: f64, peer: &str, ours: &str) -> Measured {
        let mine = self.find(work, ours)?;
        let rows: Vec<&PeerRow> = self.0.iter().filter(|row| row.work == work).collect();
        let row = fastest(&rows, error, |row| row.method == peer)
            .ok_or_else(|| format!("no row `{work}, {peer}` without a wrong run"))?;
        let ratio = row.seconds_per_item() / mine.seconds_per_item();
        Ok(DerivedNumber { value: ratio, range: None, lines: vec![row.line, mine.line] })
    }

    /// Over all cases of a kind and all errors, the time of the fastest peer over ours. The value is the least ratio; its two lines
    /// are named. A peer that does not reach an error is no peer there, and an error that none of ours reaches counts as infinitely
    /// slow.
    pub(crate) fn over_ours_at_equal_error(&self, kind: &str, is_peer: fn(&PeerRow) -> bool) -> Measured {
        let mut ratios: Vec<(f64, Vec<usize>)> = Vec::new();
        for (rows, most) in cases(self.0, kind).values().flat_map(|rows| ERRORS.map(|most| (rows, most))) {
            let Some(peer) = fastest(rows, most, is_peer) else { continue };
            let ours = fastest(rows, most, PeerRow::is_ours);
            let ratio = ours.map_or(0.0, |ours| peer.seconds_per_item() / ours.seconds_per_item());
            let lines = [Some(peer), ours].into_iter().flatten().map(|row| row.line).collect();
            ratios.push((ratio, lines));
        }
        let all = found(&ratios, f64::min)
            .map_err(|_| format!("no case of `{kind}` that such a program finishes"))?;
        let least = ratios.into_iter().find(|(ratio, _)| *ratio == all.value);
        Ok(DerivedNumber { lines: least.map(|(_, lines)| lines).unwrap_or_default(), ..all })
    }

    /// Cases and tolerances from 1e-4 to 1e-10 at which no method of ours ended with an error of at most ten tolerances.
    pub(crate) fn unmet(&self, kind: &str) -> Measured {
        let cases = cases(self.0, kind);
        if cases.is_empty() {
            return Err(format!("no row of `{kind}`"));
        }
        let (mut unmet, mut lines) = (0, Vec::new());
        for (rows, tolerance) in cases.values().flat_map(|rows| TOLERANCES.map(|most| (rows, most))) {
            let requested = |row: &&&PeerRow| {
                row.is_ours()
                    && row.tolerance.is_some_and(|requested| (requested / tolerance - 1.0).abs() < 1e-3)
            };
            let ours: Vec<&&PeerRow> = rows.iter().filter(requested).collect();
            if !ours.iter().any(|row| row.wrong == 0 && error(row) <= 10.0 * tolerance) {
                unmet += 1;
                lines.extend(ours.iter().map(|row| row.line));
            }
        }
        Ok(DerivedNumber { value: f64::from(unmet), range: None, lines })
    }
}
