//! `classify --distribution`: shares of slip modes among random points within the error bars.

use clap::Args;
use slipmode::scene::of_word;
use slipmode_core::stability::{Distribution, InertialThreshold, ParameterBox, SampledShare, sampled_shares};

use crate::cli::answer::Answer;
use crate::cli::options::Arguments;

/// The number of random points unless it is given.
const DEFAULT_SAMPLES: u64 = 10_000;
/// The largest number of random points.
const MOST_SAMPLES: u64 = 100_000_000;

/// Options of the shares.
#[derive(Debug, Args)]
#[command(next_help_heading = "Shares of slip modes (values with error bars)")]
pub struct SampleOptions {
    /// How values are distributed: normal (the error is one standard deviation) or uniform (within the error bars)
    ///
    /// Shares come from random points, the same in every run, and have a sampling error. They do not change what is certain.
    #[arg(long, value_name = "WORD", allow_hyphen_values = true)]
    distribution: Option<String>,
    /// Random points, 100 to 100 000 000 [default: 10000]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    samples: Option<String>,
}

/// How random points are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    distribution: Distribution,
    samples: u32,
}

impl SampleOptions {
    /// Reads both; none without `--distribution`.
    pub fn read(&self, arguments: &mut Arguments) -> Option<Sample> {
        let Some(word) = &self.distribution else {
            arguments.refuse_value("--samples", self.samples.as_deref(), "--distribution");
            return None;
        };
        let read = |word: &str| of_word(word, &Distribution::ALL, Distribution::as_str);
        let distribution = arguments.number("--distribution", word, read);
        let samples = arguments.whole("--samples", self.samples.as_deref(), 100..=MOST_SAMPLES);
        let samples = u32::try_from(samples.unwrap_or(DEFAULT_SAMPLES)).ok()?;
        Some(Sample { distribution: distribution?, samples })
    }

    /// Notes both where no value has an error bar.
    pub fn refuse(&self, arguments: &mut Arguments) {
        let needs = "values with error bars, such as 0.009±0.001";
        arguments.refuse_value("--distribution", self.distribution.as_deref(), needs);
        arguments.refuse_value("--samples", self.samples.as_deref(), needs);
    }
}

impl Sample {
    /// Draws the points, and states the distribution, their number, and the shares of all modes; each mode that was found has a line.
    pub fn answer(self, region: &ParameterBox, threshold: &InertialThreshold) -> Answer {
        let Self { distribution, samples } = self;
        let word = distribution.as_str();
        let share = |found: &SampledShare| {
            let part = Answer::default()
                .with("mode", found.mode.as_str())
                .with("share", found.share)
                .with("sampling_error", found.sampling_error);
            if found.share <= 0.0 {
                return part;
            }
            let (share, error) = (100.0 * found.share, 100.0 * found.sampling_error);
            let note = format!("({share:.2} % ± {error:.2} % of {samples} random points, {word})");
            part.named("sampled share", found.mode.as_str()).note(&note)
        };
        let shares = sampled_shares(region, threshold, distribution, samples);
        Answer::default()
            .with("distribution", word)
            .with("samples", samples)
            .list("shares", shares.iter().map(share))
    }
}
