//! What the project set itself for speed and accuracy, and what the files of times say of it.
//!
//! The bounds stand here as they were set before anything was measured; whether one is met is computed from the rows.

use super::PeerRow;
use super::lookup::{DerivedNumber, Measured, Rows, error};

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
    /// What was measured; or which row is missing.
    pub measured: Result<DerivedNumber, String>,
    /// What it has to be.
    pub must: Option<Bound>,
    /// What it was hoped to be.
    pub aim: Option<Bound>,
}

use Bound::{AtLeast, AtMost};

/// Points next to a limit, by the work that a user asks for.
const HARD_SIGNS: [&str; 3] = ["signs-disc", "signs-hopf", "signs-cusp"];
const HARD_EXTREMES: [&str; 3] = ["extremes-disc", "extremes-hopf", "extremes-cusp"];
const HARD_CUBICS: [&str; 3] = ["cubic-disc", "cubic-hopf", "cubic-cusp"];

/// The program that shows what boost's method costs on arrays; nobody ships it.
const STATIC: &str = "static-rosenbrock4";

/// Every aim, in the order of the works.
#[must_use]
pub fn aims(rows: &[PeerRow]) -> Vec<Aim> {
    let rows = Rows(rows);
    let mut aims = signs(&rows);
    aims.extend(extremes(&rows));
    aims.extend(cubics(&rows));
    aims.extend(roots(&rows));
    aims.extend(boundary(&rows));
    aims.extend(cycles(&rows));
    aims.extend(smooth(&rows));
    aims.extend(sweep(&rows));
    aims
}

/// A quantity of a work, and how the benchmark calls the work.
fn aim(
    [work, bench]: [&'static str; 2],
    quantity: &'static str,
    measured: Measured,
    must: Option<Bound>,
    wanted: Option<Bound>,
) -> Aim {
    Aim { work: work.into(), quantity, bench, measured, must, aim: wanted }
}

const ALL_RIGHT: Option<Bound> = Some(AtMost(0.0));

fn signs(rows: &Rows<'_>) -> Vec<Aim> {
    let [random, grid] = [["signs, random points", "signs"], ["signs, grid", "signs"]];
    let (hard, ours) = (["signs, points next to a limit", "signs"], "slipmode-signs");
    let wrong_of = |works: &[&str]| rows.of(works, ours, wrong, f64::max);
    let rate_of = |works: &[&str]| rows.of(works, ours, rate, f64::min);
    let over = |works: &[&str], peer| rows.over_ours(works, &[peer], ours);
    let (numpy, gsl) = ("numpy-eigvals", "gsl-complex_solve_cubic");
    let at_least = |least| Some(AtLeast(least));
    vec![
        aim(random, "wrong signs", wrong_of(&["signs-random"]), ALL_RIGHT, ALL_RIGHT),
        aim(random, "points per second", rate_of(&["signs-random"]), None, at_least(5e7)),
        aim(random, "NumPy's time / ours", over(&["signs-random"], numpy), at_least(20.0), at_least(60.0)),
        aim(random, "GSL's time / ours", over(&["signs-random"], gsl), at_least(1.0), at_least(4.0)),
        aim(grid, "wrong signs", wrong_of(&["signs-grid"]), ALL_RIGHT, ALL_RIGHT),
        aim(grid, "points per second", rate_of(&["signs-grid"]), at_least(6e7), at_least(1.5e8)),
        aim(hard, "wrong signs", wrong_of(&HARD_SIGNS), ALL_RIGHT, ALL_RIGHT),
        aim(hard, "points per second", rate_of(&HARD_SIGNS), None, at_least(1e6)),
        aim(
            hard,
            "NumPy's time / ours (NumPy has wrong signs)",
            over(&HARD_SIGNS, numpy),
            None,
            at_least(1.0),
        ),
        aim(hard, "GSL's time / ours (GSL has wrong signs)", over(&HARD_SIGNS, gsl), None, at_least(1.0)),
    ]
}

fn extremes(rows: &Rows<'_>) -> Vec<Aim> {
    let random = ["signs, max Re(s) and max Im(s), random points", "extremes"];
    let hard = ["signs, max Re(s) and max Im(s), points next to a limit", "extremes"];
    let ours = "slipmode-extremes";
    let over = |works: &[&str]| rows.over_ours(works, &["gsl-complex_solve_cubic", "numpy-eigvals"], ours);
    let (must, wanted) = (Some(AtLeast(3e5)), Some(AtLeast(1e6)));
    vec![
        aim(random, "points per second", rows.of(&["extremes-random"], ours, rate, f64::min), must, wanted),
        aim(
            random,
            "time of the faster of NumPy and GSL / ours",
            over(&["extremes-random"]),
            None,
            Some(AtLeast(1.0)),
        ),
        aim(hard, "wrong signs", rows.of(&HARD_EXTREMES, ours, wrong, f64::max), ALL_RIGHT, ALL_RIGHT),
        aim(
            hard,
            "largest error",
            rows.of(&HARD_EXTREMES, ours, error, f64::max),
            Some(AtMost(1e-13)),
            Some(AtMost(1e-14)),
        ),
        aim(hard, "points per second", rows.of(&HARD_EXTREMES, ours, rate, f64::min), must, wanted),
        aim(
            hard,
            "time of the faster of NumPy and GSL / ours (both have wrong signs)",
            over(&HARD_EXTREMES),
            None,
            Some(AtLeast(1.0)),
        ),
    ]
}

fn cubics(rows: &Rows<'_>) -> Vec<Aim> {
    let random = ["three roots in 64 bits, random points", "cubic"];
    let hard = ["three roots in 64 bits, points next to a limit", "cubic"];
    let ours = "slipmode-three-roots";
    let everywhere = [&["cubic-random"][..], &HARD_CUBICS].concat();
    let all = ["three roots in 64 bits, all points", "cubic"];
    vec![
        aim(all, "wrong kinds of roots", rows.of(&everywhere, ours, wrong, f64::max), ALL_RIGHT, ALL_RIGHT),
        aim(
            all,
            "largest error, relative to the root's modulus",
            rows.of(&everywhere, ours, error, f64::max),
            Some(AtMost(1.2e-16)),
            None,
        ),
        aim(
            random,
            "points per second",
            rows.of(&["cubic-random"], ours, rate, f64::min),
            Some(AtLeast(5e6)),
            None,
        ),
        aim(hard, "points per second", rows.of(&HARD_CUBICS, ours, rate, f64::min), Some(AtLeast(1e6)), None),
    ]
}

/// FLINT from C and from Python: the two have different versions.
const FLINT: [&str; 2] = ["flint-complex_roots", "python-flint-complex_roots"];

fn roots(rows: &Rows<'_>) -> Vec<Aim> {
    let ours = "slipmode-certified";
    let sizes = [
        ("roots, 50 digits", ["roots-50-random", "roots-50-hard"]),
        ("roots, 100 digits", ["roots-100-random", "roots-100-hard"]),
        ("roots, 1000 digits", ["roots-1000-random", "roots-1000-hard"]),
        ("roots, 10000 digits", ["roots-10000-random", "roots-10000-hard"]),
    ];
    let mut aims: Vec<Aim> = sizes
        .iter()
        .map(|(work, sets)| {
            let over = rows.over_ours(sets, &FLINT, ours);
            aim([work, "roots"], "FLINT's time / ours", over, Some(AtLeast(5.0)), Some(AtLeast(10.0)))
        })
        .collect();
    let everywhere: Vec<&str> = sizes.iter().flat_map(|(_, sets)| *sets).collect();
    let all = ["roots, 50 to 10000 digits", "roots"];
    let pari = rows.over_ours(&everywhere, &["pari-polroots"], ours);
    let mpsolve = rows.over_ours(&everywhere, &["mpsolve-secular", "mpsolve-standard"], ours);
    aims.push(aim(all, "PARI's time / ours", pari, Some(AtLeast(2.0)), Some(AtLeast(5.0))));
    aims.push(aim(all, "MPSolve's time / ours", mpsolve, None, Some(AtLeast(1.0))));
    let pairs: Vec<[&str; 2]> = sizes[..3].iter().map(|(_, [random, hard])| [*hard, *random]).collect();
    aims.push(aim(
        ["roots, 50 to 1000 digits", "roots"],
        "hard / random cubics, our time",
        rows.between_works(&pairs, ours),
        Some(AtMost(2.0)),
        Some(AtMost(1.5)),
    ));
    aims
}

fn boundary(rows: &Rows<'_>) -> Vec<Aim> {
    let at_stress = |work, bench, must: Option<f64>, wanted: Option<f64>| {
        let over = rows.over_ours(&[bench], &FLINT, "slipmode-section");
        aim([work, bench], "FLINT's time / ours", over, must.map(AtLeast), wanted.map(AtLeast))
    };
    let curve = rows.over_ours(&["boundary-50"], &FLINT, "slipmode-curve");
    vec![
        at_stress("boundary at fixed σ, 20 digits", "boundary-20", None, Some(1.0)),
        at_stress("boundary at fixed σ, 50 digits", "boundary-50", Some(8.0), Some(20.0)),
        at_stress("boundary at fixed σ, 200 digits", "boundary-200", Some(5.0), None),
        aim(
            ["points anywhere on the boundary, 50 digits", "boundary-50"],
            "time of FLINT at fixed σ / ours",
            curve,
            Some(AtLeast(30.0)),
            Some(AtLeast(100.0)),
        ),
    ]
}

fn is_shipped(row: &PeerRow) -> bool {
    !row.is_ours() && row.method != STATIC
}

fn cycles(rows: &Rows<'_>) -> Vec<Aim> {
    let work = ["stick-slip cycles", "cycles"];
    let over = |is_peer| rows.over_ours_at_equal_error("cycles", is_peer);
    let unmet = rows.unmet("cycles");
    let at_least = |least| Some(AtLeast(least));
    vec![
        aim(work, "tolerances not met within 10 × by any method of ours", unmet, ALL_RIGHT, ALL_RIGHT),
        aim(work, "time of the fastest program / ours", over(is_shipped), at_least(1.0), at_least(3.0)),
        aim(work, "boost's time / ours", over(|row| row.method == "boost-rosenbrock4"), None, at_least(1.0)),
        aim(work, "CVODE's time / ours", over(|row| row.method == "cvode-bdf"), None, at_least(1.0)),
        aim(
            work,
            "time of boost's method on arrays of three numbers / ours",
            over(|row| row.method == STATIC),
            None,
            at_least(1.0),
        ),
    ]
}

fn smooth(rows: &Rows<'_>) -> Vec<Aim> {
    let over = |kind| rows.over_ours_at_equal_error(kind, is_shipped);
    vec![
        aim(
            ["smooth regimes, one run", "smooth"],
            "heyoka's time / ours",
            over("smooth"),
            Some(AtLeast(1.0 / 3.0)),
            Some(AtLeast(1.0)),
        ),
        aim(
            ["smooth regimes, sets of runs", "throughput"],
            "heyoka's time in lanes or not / ours",
            over("throughput"),
            None,
            Some(AtLeast(1.0)),
        ),
    ]
}

/// The largest relative error of a run of the sweep that counts as right.
const SWEEP_ERROR: f64 = 1e-2;

fn sweep(rows: &Rows<'_>) -> Vec<Aim> {
    let (work, ours) = (["sweep", "sweep"], "slipmode-simulate");
    let of = |quantity, pick| rows.of(&["sweep"], ours, quantity, pick);
    let over = |peer| rows.over_ours_within("sweep", SWEEP_ERROR, peer, ours);
    let right = Some(AtMost(SWEEP_ERROR));
    let at_least = |least| Some(AtLeast(least));
    vec![
        aim(work, "wrong or failed runs", of(wrong, f64::max), ALL_RIGHT, ALL_RIGHT),
        aim(work, "largest relative error", of(error, f64::max), right, right),
        aim(work, "runs per second", of(rate, f64::min), at_least(800.0), at_least(2400.0)),
        aim(work, "boost's time / ours", over("boost-rosenbrock4"), None, at_least(3.0)),
        aim(work, "time of boost's method on arrays / ours", over(STATIC), None, at_least(1.0)),
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
work,method,tolerance,items,cpu_s,error,wrong,program,options,command
signs-random,slipmode-signs,,1000000,0.01,,0,p,,c
signs-random,numpy-eigvals,,100000,0.05,,0,p,,c
cycles-a,slipmode-x,1e-4,1,1,1e-3,0,p,,c
cycles-a,slipmode-x,1e-6,1,2,1e-6,0,p,,c
cycles-a,slipmode-x,1e-8,1,3,1e-6,0,p,,c
cycles-a,peer,1e-6,1,5,1e-7,0,p,,c
cycles-a,static-rosenbrock4,1e-6,1,1.5,1e-6,0,p,,c
roots-50-random,slipmode-certified,,1,1,,0,p,,c
roots-50-random,flint-complex_roots,,1,9,,0,p,,c
roots-50-random,python-flint-complex_roots,,1,7,,0,p,,c
roots-50-hard,slipmode-certified,,1,1,,0,p,,c
roots-50-hard,flint-complex_roots,,1,12,,0,p,,c
";

    fn found(work: &str, quantity: &str) -> Aim {
        let rows = read_peers("peers.csv", ROWS).unwrap();
        aims(&rows).into_iter().find(|aim| aim.work == work && aim.quantity == quantity).unwrap()
    }

    #[test]
    fn a_ratio_comes_from_two_rows_and_can_be_met_or_not() {
        let aim = found("signs, random points", "NumPy's time / ours");
        let found = aim.measured.unwrap();
        assert!((found.value - 50.0).abs() < 1e-12);
        assert_eq!((found.range, found.lines), (None, vec![3, 2]));
        assert_eq!(aim.must.map(|must| must.is_met(found.value)), Some(true));
        assert_eq!(aim.aim.map(|aim| aim.is_met(found.value)), Some(false));
    }

    #[test]
    fn a_ratio_over_a_set_is_its_range_and_each_time_the_faster_of_a_peers_programs_counts() {
        let found = found("roots, 50 digits", "FLINT's time / ours").measured.unwrap();
        assert_eq!((found.value, found.range), (7.0, Some((7.0, 12.0))));
        assert_eq!(found.lines, [11, 9, 13, 12]);
    }

    #[test]
    fn what_was_not_measured_is_named() {
        assert_eq!(
            found("signs, random points", "GSL's time / ours").measured,
            Err("no row `signs-random, gsl-complex_solve_cubic`".into())
        );
        assert_eq!(
            found("sweep", "runs per second").measured,
            Err("no row `sweep, slipmode-simulate`".into())
        );
    }

    #[test]
    fn a_tolerance_that_is_not_met_within_ten_times_counts_as_does_one_never_tried() {
        // 1e-4 is met at ten times, 1e-6 at once, 1e-8 missed, 1e-10 not tried.
        let unmet = found("stick-slip cycles", "tolerances not met within 10 × by any method of ours");
        let unmet = unmet.measured.unwrap();
        assert_eq!((unmet.value, unmet.lines), (2.0, vec![6]));
    }

    #[test]
    fn the_static_method_is_compared_by_itself_and_is_no_shipped_program() {
        // At 1e-3 the peer takes 5 and ours 1, from 1e-4 to 1e-6 ours takes 2, and the static method 1.5.
        let shipped = found("stick-slip cycles", "time of the fastest program / ours").measured.unwrap();
        assert_eq!((shipped.value, shipped.range), (2.5, Some((2.5, 5.0))));
        let of = found("stick-slip cycles", "time of boost's method on arrays of three numbers / ours");
        let arrays = of.measured.unwrap();
        assert_eq!((arrays.value, arrays.range), (0.75, Some((0.75, 1.5))));
        assert_eq!(arrays.lines, [8, 5]);
    }
}
