//! What the project set itself for speed and accuracy, and what the files of times say of it.
//!
//! The bounds stand here as they were set before anything was measured; whether one is met is computed from the rows.

use super::PeerRow;
use super::compare::fastest;
use super::lookup::{Measured, Rows, error};

/// A bound that a measured number has to keep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// At least this much.
    AtLeast(f64),
    /// At most this much.
    AtMost(f64),
}

impl Bound {
    /// Whether a number keeps it.
    #[must_use]
    pub fn is_met(self, value: f64) -> bool {
        match self {
            Self::AtLeast(least) => value >= least,
            Self::AtMost(most) => value <= most,
        }
    }
}

/// One number that was measured, and what was wanted of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Aim {
    /// The work.
    pub work: String,
    /// The quantity.
    pub quantity: &'static str,
    /// By which name `cargo xtask bench --peers` measures it again.
    pub bench: &'static str,
    /// What was measured, with the lines of the file that it follows from; or which row is missing.
    pub measured: Result<(f64, Vec<usize>), String>,
    /// What it has to be.
    pub must: Option<Bound>,
    /// What it was hoped to be.
    pub aim: Option<Bound>,
}

use Bound::{AtLeast, AtMost};

/// The hard families of the classes.
const HARD: [&str; 3] = ["classes-disc", "classes-hopf", "classes-cusp"];

/// Every aim, in the order in which they were set.
#[must_use]
pub fn aims(rows: &[PeerRow]) -> Vec<Aim> {
    let rows = Rows(rows);
    let mut aims = classes(&rows);
    aims.extend(roots(&rows));
    aims.extend(boundary(&rows));
    aims.extend(cycles(&rows));
    aims.extend(sweep(&rows));
    aims
}

fn aim(
    work: &str,
    quantity: &'static str,
    measured: Measured,
    must: Option<Bound>,
    wanted: Option<Bound>,
) -> Aim {
    let known = ["roots", "boundary", "stick-slip", "smooth", "sweep"].into_iter();
    let bench = known.into_iter().find(|name| work.starts_with(name)).unwrap_or("classes");
    let bench = if bench == "stick-slip" { "cycles" } else { bench };
    Aim { work: work.into(), quantity, bench, measured, must, aim: wanted }
}

fn classes(rows: &Rows<'_>) -> Vec<Aim> {
    let (random, grid, ours) = ("classes-random", "classes-grid", "slipmode-signs");
    let all_right = Some(AtMost(0.0));
    let over = |peer| rows.ratio((random, peer), (random, ours));
    let hard = |method, of: fn(&PeerRow) -> f64, pick: fn(f64, f64) -> f64| {
        rows.reduce(HARD.map(|work| (work, method)), of, pick)
    };
    vec![
        aim(random, "wrong signs", rows.of(random, ours, wrong), all_right, all_right),
        aim(random, "points per second", rows.of(random, ours, rate), None, Some(AtLeast(5e7))),
        aim(random, "NumPy's time / ours", over("numpy-eigvals"), Some(AtLeast(20.0)), Some(AtLeast(60.0))),
        aim(
            random,
            "GSL's time / ours",
            over("gsl-complex_solve_cubic"),
            Some(AtLeast(1.0)),
            Some(AtLeast(4.0)),
        ),
        aim(grid, "wrong signs", rows.of(grid, ours, wrong), all_right, all_right),
        aim(grid, "points per second", rows.of(grid, ours, rate), Some(AtLeast(6e7)), Some(AtLeast(1.5e8))),
        aim("hard points", "wrong signs", hard(ours, wrong, f64::max), all_right, all_right),
        aim(
            "hard points",
            "largest error of the roots",
            hard("slipmode-values", error, f64::max),
            Some(AtMost(1e-13)),
            Some(AtMost(1e-14)),
        ),
        aim(
            "hard points",
            "points with roots per second",
            hard("slipmode-values", rate, f64::min),
            Some(AtLeast(3e5)),
            Some(AtLeast(1e6)),
        ),
    ]
}

fn roots(rows: &Rows<'_>) -> Vec<Aim> {
    let ours = "slipmode-certified";
    let mut aims = Vec::new();
    for digits in [50, 100, 1000] {
        let [random, hard] = ["random", "hard"].map(|set| format!("roots-{digits}-{set}"));
        let over = rows.least_ratio([&random, &hard], "flint-complex_roots", ours);
        let work = format!("roots, {digits} digits");
        aims.push(aim(&work, "FLINT's time / ours", over, Some(AtLeast(5.0)), Some(AtLeast(10.0))));
    }
    let slower = rows.most_ratio(
        [50, 100, 1000].map(|digits| ["hard", "random"].map(|set| (format!("roots-{digits}-{set}"), ours))),
    );
    aims.push(aim(
        "roots, 50 to 1000 digits",
        "hard / random cubics, largest ratio",
        slower,
        Some(AtMost(2.0)),
        Some(AtMost(1.5)),
    ));
    let most = ["roots-10000-random", "roots-10000-hard"];
    let over = rows.least_ratio(most, "pari-polroots", ours);
    aims.push(aim("roots, 10000 digits", "PARI's time / ours", over, Some(AtLeast(2.0)), Some(AtLeast(5.0))));
    aims
}

fn boundary(rows: &Rows<'_>) -> Vec<Aim> {
    let work = "boundary-section";
    let over = |ours| rows.ratio((work, "flint-complex_roots"), (work, ours));
    vec![
        aim(
            "boundary at fixed σ, 50 digits",
            "FLINT's time / ours",
            over("slipmode-section"),
            Some(AtLeast(8.0)),
            Some(AtLeast(20.0)),
        ),
        aim(
            "boundary by the curve, 50 digits",
            "FLINT's time / ours",
            over("slipmode-curve"),
            Some(AtLeast(30.0)),
            Some(AtLeast(100.0)),
        ),
    ]
}

fn cycles(rows: &Rows<'_>) -> Vec<Aim> {
    let all = Some(AtMost(0.0));
    let (work, smooth) = ("stick-slip cycles", "smooth regimes");
    let smooth_over = rows.least_over_peers("smooth").map(|(over, lines)| (1.0 / over, lines));
    vec![
        aim(work, "tolerances not met within 10 × by any method of ours", rows.unmet("cycles"), all, all),
        aim(
            work,
            "fastest competitor's time / ours, smallest of all cases and errors",
            rows.least_over_peers("cycles"),
            Some(AtLeast(1.0)),
            Some(AtLeast(3.0)),
        ),
        aim(
            smooth,
            "our time / heyoka's, largest of all cases and errors",
            smooth_over,
            Some(AtMost(3.0)),
            Some(AtMost(1.0)),
        ),
    ]
}

fn sweep(rows: &Rows<'_>) -> Vec<Aim> {
    let (work, ours) = ("sweep", "slipmode-simulate");
    let peer = fastest(&rows.works(work), 1e-2, |row| row.method == "boost-rosenbrock4");
    let over = peer
        .ok_or_else(|| "no row `sweep, boost-rosenbrock4` without a wrong run".to_string())
        .and_then(|peer| {
            let mine = rows.find(work, ours)?;
            Ok((peer.seconds_per_item() / mine.seconds_per_item(), vec![peer.line, mine.line]))
        });
    vec![
        aim(work, "wrong or failed runs", rows.of(work, ours, wrong), Some(AtMost(0.0)), Some(AtMost(0.0))),
        aim(
            work,
            "largest relative error",
            rows.of(work, ours, error),
            Some(AtMost(1e-2)),
            Some(AtMost(1e-2)),
        ),
        aim(work, "runs per second", rows.of(work, ours, rate), Some(AtLeast(800.0)), Some(AtLeast(2400.0))),
        aim(work, "time of boost's rosenbrock4 / ours", over, None, Some(AtLeast(3.0))),
    ]
}

fn rate(row: &PeerRow) -> f64 {
    row.items / row.seconds
}

fn wrong(row: &PeerRow) -> f64 {
    row.wrong as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::times::read_peers;

    const ROWS: &str = "\
work,method,tolerance,items,cpu_s,error,wrong,command
classes-random,slipmode-signs,,1000000,0.01,,0,c
classes-random,numpy-eigvals,,100000,0.05,,0,c
cycles-a,slipmode-x,1e-4,1,1,1e-3,0,c
cycles-a,slipmode-x,1e-6,1,2,1e-6,0,c
cycles-a,slipmode-x,1e-8,1,3,1e-6,0,c
cycles-a,peer,1e-6,1,5,1e-7,0,c
";

    fn found(quantity: &str) -> Aim {
        let rows = read_peers("peers.csv", ROWS).unwrap();
        aims(&rows).into_iter().find(|aim| aim.quantity == quantity).unwrap()
    }

    #[test]
    fn a_ratio_comes_from_two_rows_and_can_be_met_or_not() {
        let aim = found("NumPy's time / ours");
        let (ratio, lines) = aim.measured.unwrap();
        assert!((ratio - 50.0).abs() < 1e-12);
        assert_eq!(lines, [3, 2]);
        assert_eq!(aim.must.map(|must| must.is_met(ratio)), Some(true));
        assert_eq!(aim.aim.map(|aim| aim.is_met(ratio)), Some(false));
    }

    #[test]
    fn what_was_not_measured_is_named() {
        assert_eq!(
            found("GSL's time / ours").measured,
            Err("no row `classes-random, gsl-complex_solve_cubic`".into())
        );
        assert_eq!(found("runs per second").measured, Err("no row `sweep, slipmode-simulate`".into()));
    }

    #[test]
    fn a_tolerance_that_is_not_met_within_ten_times_counts_as_does_one_never_tried() {
        // 1e-4 is met at ten times, 1e-6 at once, 1e-8 missed, 1e-10 not tried.
        let unmet = found("tolerances not met within 10 × by any method of ours").measured.unwrap();
        assert_eq!(unmet, (2.0, vec![6]));
        // At 1e-4 and at 1e-6 the peer takes 5 against 2.
        let over =
            found("fastest competitor's time / ours, smallest of all cases and errors").measured.unwrap();
        assert!((over.0 - 2.5).abs() < 1e-12);
    }
}
