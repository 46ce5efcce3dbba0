//! Numbers from rows by work and method; what has no row is named.

use super::PeerRow;
use super::compare::{ERRORS, cases, fastest};

/// A number with the lines of the file that it follows from; or which row is missing.
pub(crate) type Measured = Result<(f64, Vec<usize>), String>;

/// Looks up rows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rows<'r>(pub(crate) &'r [PeerRow]);

/// The error; a row without one counts as without limit, so that nothing is met by it.
pub(crate) fn error(row: &PeerRow) -> f64 {
    row.error_value().unwrap_or(f64::INFINITY)
}

impl<'r> Rows<'r> {
    pub(crate) fn find(&self, work: &str, method: &str) -> Result<&'r PeerRow, String> {
        let found = self.0.iter().find(|row| row.work == work && row.method == method);
        found.ok_or_else(|| format!("no row `{work}, {method}`"))
    }

    pub(crate) fn works(&self, work: &str) -> Vec<&'r PeerRow> {
        self.0.iter().filter(|row| row.work == work).collect()
    }

    pub(crate) fn of(&self, work: &str, method: &str, quantity: fn(&PeerRow) -> f64) -> Measured {
        self.find(work, method).map(|row| (quantity(row), vec![row.line]))
    }

    /// The worst of a quantity over several rows, all of which must be there.
    pub(crate) fn reduce<'n>(
        &self,
        wanted: impl IntoIterator<Item = (&'n str, &'n str)>,
        quantity: fn(&PeerRow) -> f64,
        pick: fn(f64, f64) -> f64,
    ) -> Measured {
        let rows = wanted.into_iter().map(|(work, method)| self.find(work, method));
        let rows = rows.collect::<Result<Vec<_>, _>>()?;
        let value = rows.iter().map(|row| quantity(row)).reduce(pick).ok_or("no target")?;
        Ok((value, rows.iter().map(|row| row.line).collect()))
    }

    /// The time of one item of the first over that of the second.
    pub(crate) fn ratio(&self, over: (&str, &str), under: (&str, &str)) -> Measured {
        let (over, under) = (self.find(over.0, over.1)?, self.find(under.0, under.1)?);
        Ok((over.seconds_per_item() / under.seconds_per_item(), vec![over.line, under.line]))
    }

    pub(crate) fn least_ratio<'n>(
        &self,
        works: impl IntoIterator<Item = &'n (impl AsRef<str> + ?Sized + 'n)>,
        peer: &str,
        ours: &str,
    ) -> Measured {
        let mut least: Measured = Err("no target".into());
        for work in works {
            let (ratio, lines) = self.ratio((work.as_ref(), peer), (work.as_ref(), ours))?;
            if !least.as_ref().is_ok_and(|(known, _)| *known <= ratio) {
                least = Ok((ratio, lines));
            }
        }
        least
    }

    /// The largest of several ratios, each of a first work and method over a second.
    pub(crate) fn most_ratio<const N: usize>(&self, pairs: [[(String, &str); 2]; N]) -> Measured {
        let mut most: Measured = Err("no target".into());
        for [over, under] in &pairs {
            let (ratio, lines) = self.ratio((&over.0, over.1), (&under.0, under.1))?;
            if !most.as_ref().is_ok_and(|(known, _)| *known >= ratio) {
                most = Ok((ratio, lines));
            }
        }
        most
    }

    /// Over all cases of a kind and all errors, the least of the best peer's time over ours; a peer that does not reach an error is
    /// no peer there, and an error that none of ours reaches counts as infinitely slow.
    pub(crate) fn least_over_peers(&self, kind: &str) -> Measured {
        let mut least: Measured = Err(format!("no case of `{kind}` that a competitor finishes"));
        for (rows, most) in cases(self.0, kind).values().flat_map(|rows| ERRORS.map(|most| (rows, most))) {
            let Some(peer) = fastest(rows, most, |row| !row.is_ours()) else { continue };
            let ours = fastest(rows, most, PeerRow::is_ours);
            let ratio = ours.map_or(0.0, |ours| peer.seconds_per_item() / ours.seconds_per_item());
            if !least.as_ref().is_ok_and(|(known, _)| *known <= ratio) {
                let lines = [Some(peer), ours].into_iter().flatten().map(|row| row.line).collect();
                least = Ok((ratio, lines));
            }
        }
        least
    }

    /// Cases and tolerances from 1e-4 to 1e-10 at which no method of ours ended with an error of at most ten tolerances.
    pub(crate) fn unmet(&self, kind: &str) -> Measured {
        let (mut unmet, mut lines) = (0, Vec::new());
        for (rows, tolerance) in cases(self.0, kind).values().flat_map(|rows| ERRORS.map(|most| (rows, most)))
        {
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
        if cases(self.0, kind).is_empty() {
            Err(format!("no row of `{kind}`"))
        } else {
            Ok((f64::from(unmet), lines))
        }
    }
}
