//! `slipmode boundary` with error bars: the ranges within which the boundary and the transition, or the line of a given ω/ω_n, lie, as CSV, JSON and a picture.

use slipmode::parallel;

use slipmode::experiments::shared::bands::{BandOf, ranges_at};
use slipmode::scene::{Problem, Quantity};
use slipmode_core::friction::Slider;
use slipmode_core::number::format::{exact_text, round_digits};
use slipmode_core::number::{Rational, Wide, nearest_f64, parse_decimal};
use slipmode_core::stability::inverse::{SolutionRange, Target, Unknown};
use slipmode_core::stability::{PairRatio, ParameterBox, is_allowed_over_box};
use slipmode_plot::table::{Cell, Column, Table};

use crate::cli::answer::Answer;
use crate::cli::boundary::{
    BoundaryOutput, DEFAULT_POINTS, NO_POINT_OF_LINE, Options, answer_to, coordinates, frequency_ratio,
    limit_on_points, picture, refuse_beside_single_points,
};
use crate::cli::failure::Failure;
use crate::cli::inputs::ranges_json;
use crate::cli::new::Ranges;
use crate::cli::options::{Arguments, OVER_BOX};

/// What was requested, valid.
pub struct Request {
    region: ParameterBox,
    at: RangePlaces,
    /// The line of this ω/ω_n; none for the boundary and the transition.
    frequency_ratio: Option<PairRatio>,
}

/// Where the ranges are computed.
enum RangePlaces {
    /// At even velocities of the axes that `new` would choose.
    Even(u32),
    /// At one velocity, and at one normal stress.
    Single([Option<Rational>; 2]),
}

/// A range of one coordinate at a value of the other one.
struct Row {
    line: &'static str,
    unknown: Unknown,
    known: Rational,
    range: SolutionRange,
}

/// Significant digits of even velocities.
const VELOCITY_DIGITS: usize = 6;

impl Request {
    /// Reads the options.
    pub fn read(options: &Options, arguments: &mut Arguments) -> Option<Self> {
        let needs = "values without error bars: the ends of a range have 64 bits";
        arguments.refuse_value("--digits", options.digits.as_deref(), needs);
        let region = options.slider.region(None, arguments);
        let limit = limit_on_points(options, arguments);
        let given = arguments.whole("--points", options.points.as_deref(), 2..=limit);
        let places = coordinates(options, arguments);
        let needs = "values without error bars";
        arguments.refuse_value("--damping-ratio", options.damping_ratio.as_deref(), needs);
        let frequency_ratio = frequency_ratio(options, arguments);
        if frequency_ratio.as_ref().is_some_and(|ratio| !is_allowed_over_box(ratio)) {
            let problem = Problem::OutOfRange { allowed: OVER_BOX.to_string() };
            arguments.fault::<()>("--frequency-ratio", options.frequency_ratio.as_deref(), problem);
        }
        refuse_beside_single_points(options, arguments);
        let points = u32::try_from(given.unwrap_or(DEFAULT_POINTS)).ok()?;
        let is_single = options.has_single_points();
        let at = if is_single { RangePlaces::Single(places) } else { RangePlaces::Even(points) };
        Some(Self { region: region?, at, frequency_ratio: frequency_ratio.map(PairRatio::Frequency) })
    }

    /// What is said where no values within the error bars have the lines.
    pub fn nothing(&self) -> &'static str {
        match self.frequency_ratio {
            Some(_) => NO_POINT_OF_LINE,
            None => "the boundary and the transition have no point there",
        }
    }

    /// The lines that are wanted, by their words.
    fn lines(&self) -> Vec<(&'static str, Target)> {
        match &self.frequency_ratio {
            Some(PairRatio::Frequency(ratio)) => {
                vec![("frequency-ratio", Target::FrequencyRatio(ratio.clone()))]
            }
            _ => BandOf::ALL.map(|of| (of.as_str(), of.target())).to_vec(),
        }
    }

    /// Computes the ranges; in the object, an end without bound is null.
    ///
    /// # Errors
    /// When the boundary lies beyond what axes can show.
    pub fn compute(&self) -> Result<BoundaryOutput<'_>, Failure> {
        let rows = match &self.at {
            RangePlaces::Even(points) => {
                let axes = Ranges::around(&self.middle()).map_err(Failure::Refused)?;
                self.rows(Unknown::NormalStress, &even_velocities(axes.velocity.ends(), *points))
            }
            RangePlaces::Single([velocity, stress]) => {
                let known = [(Unknown::NormalStress, velocity), (Unknown::LoadingVelocity, stress)];
                known.into_iter().flat_map(|(unknown, known)| self.rows(unknown, known.as_slice())).collect()
            }
        };
        let inputs = ranges_json(&self.region, &[Quantity::NormalStress, Quantity::LoadingVelocity]);
        let answer =
            answer_to(inputs, self.frequency_ratio.as_ref()).list("ranges", rows.iter().map(Row::part));
        Ok(BoundaryOutput { answer, table: table(&rows), picture: Box::new(|| self.picture()) })
    }

    /// The ranges of the lines at these values of the coordinate that is not sought.
    fn rows(&self, unknown: Unknown, values: &[Rational]) -> Vec<Row> {
        let lines = self.lines();
        let at = |&((line, target), known): &(&(&'static str, Target), &Rational)| {
            let ranges = ranges_at(&self.region, target, unknown, known);
            let row = |range| Row { line, unknown, known: known.clone(), range };
            ranges.into_iter().map(row).collect::<Vec<_>>()
        };
        let places = lines.iter().flat_map(|line| values.iter().map(move |known| (line, known)));
        parallel::flat_map(&places.collect::<Vec<_>>(), at)
    }

    /// The slider in the middle of the error bars.
    fn middle(&self) -> Slider<Rational> {
        self.region.middle().slider
    }

    fn picture(&self) -> Result<String, Failure> {
        picture(&self.middle(), (Some(&self.region), self.frequency_ratio.as_ref()))
    }
}

impl Row {
    fn part(&self) -> Answer {
        let [known, unknown] = self.keys();
        Answer::default()
            .with("line", self.line)
            .with(known, nearest_f64(&self.known))
            .with(unknown, self.range.enclosure)
            .with("attained", self.range.certain)
    }

    /// The names of the coordinate that is known and of the other one.
    fn keys(&self) -> [&'static str; 2] {
        let [stress, velocity] = [Quantity::NormalStress.as_str(), Quantity::LoadingVelocity.as_str()];
        if self.unknown == Unknown::NormalStress { [velocity, stress] } else { [stress, velocity] }
    }
}

/// Velocities from one end of an axis to the other, even on it to rounding to short decimals.
fn even_velocities((from, to): (f64, f64), points: u32) -> Vec<Rational> {
    let (low, high) = (libm::log10(from), libm::log10(to));
    let at = |index: u32| low + (high - low) * f64::from(index) / f64::from(points.max(2) - 1);
    let decimal = |index: u32| parse_decimal(&round_digits(libm::exp10(at(index)), VELOCITY_DIGITS)).ok();
    (0..points).filter_map(decimal).collect()
}

/// A row for each range; an empty cell has no bound, or no value that is known to occur.
fn table(rows: &[Row]) -> Table {
    let columns = vec![
        Column::text("line", "Line"),
        Column::number("loading_velocity_low_m_per_s", "Least loading velocity V0", "m/s"),
        Column::number("loading_velocity_high_m_per_s", "Greatest loading velocity V0", "m/s"),
        Column::number("normal_stress_low_pa", "Least normal stress σ", "Pa"),
        Column::number("normal_stress_high_pa", "Greatest normal stress σ", "Pa"),
        Column::number("attained_low", "Low value that occurs", "Pa or m/s"),
        Column::number("attained_high", "High value that occurs", "Pa or m/s"),
    ];
    let number =
        |value: f64| Wide::from_f64(value).map_or_else(Cell::empty, |it| Cell::number(it.to_string()));
    let mut table = Table::new("boundary", "Boundary within the error bars", columns);
    for row in rows {
        let known = [(); 2].map(|()| Cell::number(exact_text(&row.known)));
        let range = row.range.enclosure.map(number);
        let [velocity, stress] =
            if row.unknown == Unknown::NormalStress { [known, range] } else { [range, known] };
        let attained =
            row.range.certain.map_or_else(|| [Cell::empty(), Cell::empty()], |ends| ends.map(number));
        let cells = [velocity, stress, attained].into_iter().flatten();
        table.push(std::iter::once(Cell::text(row.line)).chain(cells).collect());
    }
    table
}
