//! Ratios of CPU time: at equal work, or at equal measured error where methods have tolerances.

use std::collections::{BTreeMap, BTreeSet};

use super::PeerRow;

/// One method on one piece of work without tolerances.
#[derive(Debug, Clone, PartialEq)]
pub struct PeerGroup<'r> {
    /// Its row.
    pub row: &'r PeerRow,
    /// Its time over that of our fastest method; none when there is none of ours.
    pub over_ours: Option<f64>,
}

/// One method at one error over all cases of a kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Reached<'r> {
    /// The kind, one of `KINDS`.
    pub kind: &'r str,
    /// The error to be met.
    pub error: f64,
    /// The method.
    pub method: &'r str,
    /// How many cases there are.
    pub cases: usize,
    /// The row of the fastest tolerance that met the error, for each case where one did.
    pub rows: Vec<&'r PeerRow>,
    /// For each of these rows its time over that of our fastest method on the same case.
    pub over_ours: Vec<f64>,
}

impl Reached<'_> {
    /// The geometric mean of the ratios; none without one.
    #[must_use]
    pub fn mean_over_ours(&self) -> Option<f64> {
        let logs: f64 = self.over_ours.iter().map(|ratio| libm::log(*ratio)).sum();
        (!self.over_ours.is_empty()).then(|| libm::exp(logs / self.over_ours.len() as f64))
    }

    /// The least and the largest ratio.
    #[must_use]
    pub fn range_over_ours(&self) -> Option<(f64, f64)> {
        let ratios = || self.over_ours.iter().copied();
        Some((ratios().reduce(f64::min)?, ratios().reduce(f64::max)?))
    }

    /// A text of the first row: all rows of a method have the same; empty without a row.
    pub(crate) fn of_first(&self, text: impl Fn(&PeerRow) -> &String) -> &str {
        self.rows.first().map_or("", |row| text(row))
    }

    /// In how many cases it is faster than our fastest method.
    #[must_use]
    pub fn faster_cases(&self) -> usize {
        self.over_ours.iter().filter(|ratio| **ratio < 1.0).count()
    }
}

/// The errors at which methods with tolerances are compared.
pub(crate) const ERRORS: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10];

/// The works whose methods have tolerances, one or more cases each.
pub(crate) const KINDS: [&str; 3] = ["cycles", "smooth", "throughput"];

/// What a work is a case of, when its methods have tolerances.
fn kind(work: &str) -> Option<&'static str> {
    KINDS.into_iter().find(|kind| work.strip_prefix(kind).is_some_and(|rest| rest.starts_with('-')))
}

/// Microseconds of one item.
#[must_use]
pub fn micro(row: &PeerRow) -> f64 {
    1e6 * row.seconds_per_item()
}

/// Every row of the works without tolerances, in the order of the file.
#[must_use]
pub fn work_groups(rows: &[PeerRow]) -> Vec<PeerGroup<'_>> {
    let fastest = |work: &str| {
        let ours = rows.iter().filter(|row| row.work == work && row.is_ours());
        ours.map(PeerRow::seconds_per_item).reduce(f64::min)
    };
    rows.iter()
        .filter(|row| kind(&row.work).is_none())
        .map(|row| PeerGroup {
            row,
            over_ours: fastest(&row.work).map(|fastest| row.seconds_per_item() / fastest),
        })
        .collect()
}

/// The fastest row of a method on a case that met the error.
pub(crate) fn fastest<'r>(
    rows: &[&'r PeerRow],
    error: f64,
    wanted: impl Fn(&PeerRow) -> bool,
) -> Option<&'r PeerRow> {
    let meets = |row: &&&PeerRow| {
        wanted(row) && row.wrong == 0 && row.error_value().is_some_and(|found| found <= error)
    };
    rows.iter()
        .filter(meets)
        .copied()
        .min_by(|one, other| one.seconds_per_item().total_cmp(&other.seconds_per_item()))
}

/// The cases of a kind, in the order of their names, each with its rows.
pub(crate) fn cases<'r>(rows: &'r [PeerRow], wanted: &str) -> BTreeMap<&'r str, Vec<&'r PeerRow>> {
    let mut cases: BTreeMap<&str, Vec<&PeerRow>> = BTreeMap::new();
    for row in rows.iter().filter(|row| kind(&row.work) == Some(wanted)) {
        cases.entry(&row.work).or_default().push(row);
    }
    cases
}

/// Every method with tolerances at every error, over all cases of its kind.
#[must_use]
pub fn cycle_groups(rows: &[PeerRow]) -> Vec<Reached<'_>> {
    let mut found = Vec::new();
    for kind in KINDS {
        let cases = cases(rows, kind);
        let methods: BTreeSet<&str> = cases.values().flatten().map(|row| row.method.as_str()).collect();
        for error in ERRORS {
            found.extend(methods.iter().map(|method| reached(kind, error, method, &cases)));
        }
    }
    found
}

fn reached<'r>(
    kind: &'static str,
    error: f64,
    method: &'r str,
    cases: &BTreeMap<&'r str, Vec<&'r PeerRow>>,
) -> Reached<'r> {
    let mut reached =
        Reached { kind, error, method, cases: cases.len(), rows: Vec::new(), over_ours: Vec::new() };
    for rows in cases.values() {
        let Some(row) = fastest(rows, error, |row| row.method == method) else { continue };
        reached.rows.push(row);
        let ours = fastest(rows, error, PeerRow::is_ours);
        reached.over_ours.extend(ours.map(|ours| row.seconds_per_item() / ours.seconds_per_item()));
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::times::read_peers;

    fn rows(lines: &str) -> Vec<PeerRow> {
        let header = "work,method,tolerance,items,cpu_s,error,wrong,program,options,command\n";
        read_peers("peers.csv", &format!("{header}{lines}")).unwrap()
    }

    #[test]
    fn a_tolerance_counts_by_the_error_it_gave() {
        let rows = rows(
            "cycles-a,slipmode-x,1e-3,1,1.0,1e-5,0,p,o,c\ncycles-a,slipmode-x,1e-9,1,4.0,1e-11,0,p,o,c\n\
             cycles-a,peer,1e-9,1,10.0,5e-5,0,p,o,c\ncycles-b,peer,1e-9,1,1.0,,1,p,o,c\n",
        );
        let groups = cycle_groups(&rows);
        let peer = |error: f64| groups.iter().find(|g| g.method == "peer" && g.error == error).unwrap();
        assert_eq!((peer(1e-4).over_ours.clone(), peer(1e-4).cases), (vec![10.0], 2));
        assert_eq!(peer(1e-4).faster_cases(), 0);
        let ours = groups.iter().find(|g| g.method == "slipmode-x" && g.error == 1e-4).unwrap();
        assert_eq!((ours.range_over_ours(), ours.faster_cases()), (Some((1.0, 1.0)), 0));
        assert!(peer(1e-6).rows.is_empty() && peer(1e-6).mean_over_ours().is_none());
    }

    #[test]
    fn without_tolerances_every_row_is_over_our_fastest_and_a_work_without_ours_has_no_ratio() {
        let rows = rows(
            "roots,slipmode-a,,1,2.0,,0,p,o,c\nroots,slipmode-b,,1,1.0,,0,p,o,c\nroots,peer,,1,3.0,,0,p,o,c\nother,peer,,1,3.0,,0,p,o,c\n",
        );
        let ratios: Vec<_> = work_groups(&rows).iter().map(|group| group.over_ours).collect();
        assert_eq!(ratios, [Some(2.0), Some(1.0), Some(3.0), None]);
    }
}
