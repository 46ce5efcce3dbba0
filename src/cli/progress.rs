//! Progress bars: on a terminal's standard error only.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Whether and how progress is shown.
#[derive(Debug, Clone, Copy)]
pub struct Progress {
    shown: bool,
}

impl Progress {
    /// Shown on a terminal, unless `quiet`.
    pub fn new(quiet: bool) -> Self {
        Self { shown: !quiet && std::io::stderr().is_terminal() }
    }

    /// A bar over a known number of bytes, or a spinner when it is unknown.
    pub fn bytes(self, total: Option<u64>) -> ProgressBar {
        match total {
            Some(total) => self.bar(ProgressBar::new(total), "{bar:40} {bytes}/{total_bytes} {eta}"),
            None => self.bar(ProgressBar::no_length(), "{spinner} {bytes} {bytes_per_sec}"),
        }
    }

    /// A bar over a known number of steps.
    pub fn count(self, total: u64) -> ProgressBar {
        self.bar(ProgressBar::new(total), "{bar:40} {pos}/{len} blocks {eta}")
    }

    /// A bar over a known number of points.
    pub fn points(self, total: u64) -> ProgressBar {
        self.bar(ProgressBar::new(total), "{bar:40} {human_pos}/{human_len} points {eta}")
    }

    /// A bar over the estimated work of a plan, fed by the work itself.
    pub fn items<T>(self, work: impl FnOnce(slipmode::experiments::Progress) -> T) -> T {
        let bar =
            self.bar(ProgressBar::no_length(), "{bar:40} {percent:>3} % {elapsed}, about {eta} left, {msg}");
        let result = work(&|item: &str, before: usize, all: usize| {
            bar.set_length(all as u64);
            bar.set_position(before as u64);
            bar.set_message(item.to_string());
        });
        bar.finish_and_clear();
        result
    }

    /// A spinner next to work of unknown length.
    pub fn spinner<T>(self, message: &'static str, work: impl FnOnce() -> T) -> T {
        let bar = self.bar(ProgressBar::no_length(), "{spinner} {msg} {elapsed}");
        bar.set_message(message);
        bar.enable_steady_tick(std::time::Duration::from_millis(100));
        let result = work();
        bar.finish_and_clear();
        result
    }

    fn bar(self, bar: ProgressBar, template: &str) -> ProgressBar {
        let target = if self.shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        bar.set_draw_target(target);
        match ProgressStyle::with_template(template) {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }
}
