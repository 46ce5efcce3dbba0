//! CPU time of this process. Wall-clock time would include the work of other programs.

use std::hint::black_box;

use rustix::time::{ClockId, clock_gettime};

/// CPU seconds of this process so far, over all its threads.
pub fn cpu_seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// The CPU seconds of the fastest of several runs, and what the last one made.
pub fn best_of<T>(repetitions: usize, mut work: impl FnMut() -> T) -> (f64, T) {
    let mut best = f64::INFINITY;
    let mut last = None;
    for _ in 0..repetitions.max(1) {
        let start = cpu_seconds();
        let made = black_box(work());
        best = best.min(cpu_seconds() - start);
        last = Some(made);
    }
    (best, last.unwrap())
}
