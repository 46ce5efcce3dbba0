//! Options that commands share, and the reading of their values: exact, checked, all faults at once.

use std::ops::RangeInclusive;
use std::path::Path;

use clap::{Arg, ArgGroup, ArgMatches, Args, Command};

use slipmode::scene::{
    AllowedRange, Fault, Faults, Problem, Quantity, Uncertain, all_of, cited, parse_whole, unit_of,
};
use slipmode_core::friction::{OperatingPoint, Parameters, Slider};
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Rational, nearest_f64, parse_quotient};
use slipmode_core::stability::{InertialThreshold, ParameterBox, is_allowed_over_box};

use crate::cli::failure::Failure;
use crate::cli::output::is_stream;
use crate::cli::terminal;
use crate::cli::unit_warnings::unit_warnings;

/// Physical arguments, in SI or with a unit: the first `N` of [`Quantity::ALL`]; decimals are taken exactly as written.
#[derive(Debug, Clone)]
pub struct QuantityOptions<const N: usize>([Option<String>; N]);

/// The five arguments that are the material and the machine.
pub type MaterialOptions = QuantityOptions<5>;
/// All seven arguments.
pub type SliderOptions = QuantityOptions<7>;

/// The group of all of these arguments.
pub const QUANTITIES: &str = "quantities";

const HEADING: &str =
    "Slider (SI, or with a unit: 8um, 2MPa/mm, 12kg/50cm2; decimals are exact: 0.004 is 1/250)";

/// Letter, name, name of the value and meaning of each argument.
const ARGUMENTS: [(char, &str, &str, &str); 7] = [
    ('a', "direct-effect", "A", "a of {friction}"),
    ('b', "evolution-effect", "B", "b of {friction}"),
    ('d', "critical-slip-distance-m", "D", "D_c"),
    ('k', "stiffness-pa-per-m", "K", "K, shear stress per slip"),
    ('m', "mass-per-area-kg-per-m2", "M", "M"),
    ('s', "normal-stress-pa", "S", "σ"),
    ('v', "loading-velocity-m-per-s", "V", "V0"),
];

impl<const N: usize> clap::FromArgMatches for QuantityOptions<N> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let text = |index: usize| matches.get_one::<String>(ARGUMENTS[index].1).cloned();
        Ok(Self(std::array::from_fn(text)))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl<const N: usize> Args for QuantityOptions<N> {
    fn augment_args(command: Command) -> Command {
        let argument = |(short, long, value, meaning)| {
            Arg::new(long)
                .short(short)
                .long(long)
                .value_name(value)
                .help(cited(meaning))
                .allow_hyphen_values(true)
        };
        let given = ARGUMENTS.into_iter().take(N);
        command
            .next_help_heading(HEADING)
            .args(given.clone().map(argument))
            .group(ArgGroup::new(QUANTITIES).multiple(true).args(given.map(|(_, long, ..)| long)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<const N: usize> QuantityOptions<N> {
    /// The text given for a quantity.
    pub fn text(&self, quantity: Quantity) -> Option<&str> {
        self.0.get(quantity as usize)?.as_deref()
    }

    /// Options of which the first ones have these texts, and the others are not given.
    pub fn of<const GIVEN: usize>(texts: [&str; GIVEN]) -> Self {
        Self(std::array::from_fn(|index| texts.get(index).map(|text| text.to_string())))
    }

    /// The same with other texts for the material and the machine.
    pub fn with_material(mut self, texts: [&str; 5]) -> Self {
        self.0.iter_mut().zip(texts).for_each(|(text, given)| *text = Some(given.to_string()));
        self
    }

    /// Whether a value has an error bar.
    pub fn is_uncertain(&self) -> bool {
        let mut given = Quantity::ALL.into_iter().zip(&self.0);
        given.any(|(quantity, text)| text.as_ref().is_some_and(|text| Uncertain::is_wide(quantity, text)))
    }

    /// The five values of the material and the machine; what is missing or faulty is collected in `arguments`.
    pub fn slider(&self, arguments: &mut Arguments) -> Option<Slider<Rational>> {
        let is_of_the_slider = |quantity| Quantity::OF_THE_SLIDER.contains(&quantity);
        let [a, b, d, k, m, ..] = self.values(is_of_the_slider, arguments);
        all_of([a, b, d, k, m]).map(Slider::from)
    }

    /// The values of some quantities, each of which must be given.
    fn values(&self, of: impl Fn(Quantity) -> bool, arguments: &mut Arguments) -> [Option<Rational>; 7] {
        let mut read = |quantity| required(quantity, self.text(quantity), arguments);
        let values = Quantity::ALL.map(|quantity| of(quantity).then(|| read(quantity))?);
        arguments.check_units(&values);
        values
    }

    /// All values within the error bars, and 1 for the unknown and what is no argument; what is missing or faulty is collected in
    /// `arguments`.
    pub fn region(&self, unknown: Option<Quantity>, arguments: &mut Arguments) -> Option<ParameterBox> {
        let is_known = |quantity: Quantity| (quantity as usize) < N && Some(quantity) != unknown;
        let values = Quantity::ALL.map(|quantity| match is_known(quantity) {
            true => uncertain(quantity, self.text(quantity), arguments),
            false => Some(Uncertain::certain(Rational::from(1))),
        });
        let middle = |quantity: Quantity| {
            values[quantity as usize].as_ref().filter(|_| is_known(quantity)).map(Uncertain::middle)
        };
        arguments.check_units(&Quantity::ALL.map(middle));
        Uncertain::region(all_of(values)?)
    }

    /// The same with the middle of each error bar in its place; none where one is at fault.
    pub fn centre(&self, arguments: &mut Arguments) -> Option<Self> {
        let mut centre = self.clone();
        let mut is_sound = true;
        let given = Quantity::ALL.into_iter().zip(&mut centre.0);
        for (quantity, text) in given.filter(|(_, text)| text.as_deref().is_some_and(Uncertain::is_meant)) {
            let ends = uncertain(quantity, text.as_deref(), arguments);
            is_sound &= ends.is_some();
            *text = ends.map(|ends| exact_text(&ends.middle()));
        }
        is_sound.then_some(centre)
    }
}

impl SliderOptions {
    /// All seven values; what is missing or faulty is collected in `arguments`.
    pub fn parameters(&self, arguments: &mut Arguments) -> Option<Parameters<Rational>> {
        all_of(self.values(|_| true, arguments)).map(Parameters::from)
    }

    /// σ and V0, as [`operating_point`].
    pub fn point(&self, arguments: &mut Arguments) -> Option<Option<OperatingPoint<Rational>>> {
        operating_point(self.text(Quantity::NormalStress), self.text(Quantity::LoadingVelocity), arguments)
    }

    /// Notes every quantity that was given although a file's columns give the slider.
    pub fn refuse_beside_points(&self, arguments: &mut Arguments) {
        for quantity in Quantity::ALL {
            let needs = "no --points: the file's columns give the slider";
            arguments.refuse_value(&option_of(quantity), self.text(quantity), needs);
        }
    }
}

/// A value with or without an error bar, which must be given.
fn uncertain(quantity: Quantity, text: Option<&str>, arguments: &mut Arguments) -> Option<Uncertain> {
    let ends = required_as(quantity, text, arguments, |text| Uncertain::of(quantity, text))?;
    let values = [&ends.lower, &ends.upper];
    arguments.note_unit(quantity, text, if ends.is_certain() { &values[..1] } else { &values });
    Some(ends)
}

/// σ and V0, when one of them is given: then the other one must be. None when they are at fault.
pub fn operating_point(
    stress: Option<&str>,
    velocity: Option<&str>,
    arguments: &mut Arguments,
) -> Option<Option<OperatingPoint<Rational>>> {
    if stress.is_none() && velocity.is_none() {
        return Some(None);
    }
    let point = [(Quantity::NormalStress, stress), (Quantity::LoadingVelocity, velocity)];
    all_of(point.map(|(quantity, text)| required(quantity, text, arguments))).map(|point| Some(point.into()))
}

/// Refuses standard output for a file where it has the object of `--json`.
///
/// # Errors
/// When the place is standard output and the object is requested.
pub fn refuse_stream_beside_json(option: &str, place: Option<&Path>, as_json: bool) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    arguments.refuse_stream(option, place.filter(|_| as_json), "the object");
    arguments.finish(Some(()))
}

/// What takes error bars, where a command does not.
const WITHOUT_ERROR_BAR: &str = "a value without an error bar; ranges over error bars come from `classify` (roots, frequency, slip modes), \
    `simulate`, `boundary`, `solve` and `tolerance`";

fn required(quantity: Quantity, text: Option<&str>, arguments: &mut Arguments) -> Option<Rational> {
    let read = |text: &str| Uncertain::of(quantity, text)?.exact(WITHOUT_ERROR_BAR);
    let value = required_as(quantity, text, arguments, read)?;
    arguments.note_unit(quantity, text, &[&value]);
    Some(value)
}

fn required_as<T>(
    quantity: Quantity,
    text: Option<&str>,
    arguments: &mut Arguments,
    parse: impl FnOnce(&str) -> Result<T, Problem>,
) -> Option<T> {
    let missing = || Problem::Missing { allowed: AllowedRange::PHYSICAL.wanted() };
    let read = text.ok_or_else(missing).and_then(parse);
    read.map_err(|problem| arguments.fault::<T>(&option_of(quantity), text, problem)).ok()
}

/// `--normal-stress-pa` for σ, and so on.
pub fn option_of(quantity: Quantity) -> String {
    format!("--{}", quantity.as_str().replace('_', "-"))
}

/// The thresholds that are allowed where values have error bars.
pub const OVER_BOX: &str = "sqrt(1/5) <= value < 1 where values have error bars";

/// `--inertial-threshold`, shared by the commands that name slip modes.
#[derive(Debug, Clone, Args)]
pub struct ThresholdOption {
    /// ω/ω_n above which an oscillation is called inertial, 0 < R < 1 [default: exactly √(1/2)]
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    inertial_threshold: Option<String>,
}

impl ThresholdOption {
    /// The option with this text, or not given.
    pub fn of(text: Option<&str>) -> Self {
        Self { inertial_threshold: text.map(str::to_string) }
    }

    /// The threshold for values with error bars, (ω/ω_n)² ≥ 1/5.
    pub fn threshold_over_box(&self, arguments: &mut Arguments) -> Option<InertialThreshold> {
        let threshold = self.threshold(arguments)?;
        if is_allowed_over_box(&threshold) {
            return Some(threshold);
        }
        let problem = Problem::OutOfRange { allowed: OVER_BOX.to_string() };
        arguments.fault("--inertial-threshold", self.inertial_threshold.as_deref(), problem)
    }

    /// The threshold as an exact square.
    pub fn threshold(&self, arguments: &mut Arguments) -> Option<InertialThreshold> {
        let Some(text) = &self.inertial_threshold else { return Some(InertialThreshold::default()) };
        arguments.number("--inertial-threshold", text, inertial_threshold)
    }
}

/// The threshold of a ratio ω/ω_n: a number, or the square root of one such as `sqrt(1/2)`.
///
/// # Errors
/// When the text is not a number between 0 and 1.
pub fn inertial_threshold(text: &str) -> Result<InertialThreshold, Problem> {
    let range = AllowedRange::OPEN_UNIT;
    let square = text.trim().strip_prefix("sqrt(").and_then(|rest| rest.strip_suffix(')'));
    let threshold = match square.map(parse_quotient) {
        Some(square) => square.ok().and_then(InertialThreshold::from_squared_ratio),
        None => InertialThreshold::from_ratio(&range.parse(text)?),
    };
    threshold.ok_or(Problem::OutOfRange { allowed: range.text() })
}

/// Whether a number was given with a unit: in no other text of a number stands a letter but the e of an exponent.
pub fn has_unit(text: &str) -> bool {
    text.contains(|letter: char| letter.is_alphabetic() && !"eE".contains(letter))
}

/// The faults and warnings of a command line, collected while its values are read.
#[derive(Debug, Default)]
pub struct Arguments {
    faults: Faults,
    warnings: Vec<String>,
    /// What was given with a unit of its own, in SI.
    converted: Vec<String>,
    /// The quantities that were given with a unit of their own.
    with_unit: Vec<Quantity>,
}

impl Arguments {
    /// Notes a fault of an option.
    pub fn fault<T>(&mut self, option: &str, value: Option<&str>, problem: Problem) -> Option<T> {
        let value = value.map(str::to_string);
        self.faults.push(Fault { value, ..Fault::of("command line", option, problem) });
        None
    }

    /// Notes an option that would have no effect, with the value that it was given.
    pub fn refuse_value(&mut self, option: &str, given: Option<&str>, needs: &str) {
        if given.is_some() {
            self.fault::<()>(option, given, Problem::Needs(needs.to_string()));
        }
    }

    /// Notes an option that would have no effect.
    pub fn refuse(&mut self, option: &str, is_given: bool, needs: &str) {
        if is_given {
            self.fault::<()>(option, None, Problem::Needs(needs.to_string()));
        }
    }

    /// Notes an output on standard output, where that has something else.
    pub fn refuse_stream(&mut self, option: &str, place: Option<&Path>, else_there: &str) {
        let stream = place.filter(|place| is_stream(place)).map(|_| "-");
        self.refuse_value(option, stream, &format!("a file: standard output has {else_there}"));
    }

    /// Notes values of [`Quantity::ALL`] that look like another unit's, unless they were given with their unit.
    pub fn check_units(&mut self, values: &[Option<Rational>; 7]) {
        let values = values.each_ref().map(|value| value.as_ref().map(nearest_f64));
        self.warnings.extend(unit_warnings(values, &self.with_unit));
    }

    /// A value read by `parse`.
    pub fn number<T>(
        &mut self,
        option: &str,
        text: &str,
        parse: impl FnOnce(&str) -> Result<T, Problem>,
    ) -> Option<T> {
        parse(text).map_err(|problem| self.fault::<T>(option, Some(text), problem)).ok()
    }

    /// A value in this unit of SI, or with a unit of its own; its value in SI is then printed.
    pub fn measured(&mut self, option: &str, text: &str, in_si: &str) -> Option<Rational> {
        let read = |text: &str| {
            AllowedRange::PHYSICAL.parse_measured(text, in_si).map_err(|problem| match problem {
                _ if Uncertain::is_meant(text) => Problem::ErrorBar("takes no error bar; give one value"),
                problem => problem,
            })
        };
        let value = self.number(option, text, read)?;
        self.note_converted(option, text, &[&value], in_si);
        Some(value)
    }

    /// Notes the value of a quantity, or the ends of its error bar, if it was given with a unit.
    fn note_unit(&mut self, quantity: Quantity, text: Option<&str>, values: &[&Rational]) {
        let Some(text) = text.filter(|text| has_unit(text)) else { return };
        self.note_converted(&option_of(quantity), text, values, unit_of(quantity));
        self.with_unit.push(quantity);
    }

    /// Notes values in SI, if they were given with a unit.
    fn note_converted(&mut self, option: &str, text: &str, values: &[&Rational], in_si: &str) {
        if has_unit(text) {
            let values: Vec<String> = values.iter().map(|value| exact_text(value)).collect();
            self.converted.push(format!("{option} = {text}: {} {in_si}", values.join(" to ")));
        }
    }

    /// A whole number in a range, when given.
    pub fn whole(&mut self, option: &str, text: Option<&str>, range: RangeInclusive<u64>) -> Option<u64> {
        self.number(option, text?, |text| parse_whole(text, &range))
    }

    /// Ends the reading with what was read; prints converted values and warnings when there is no fault.
    ///
    /// # Errors
    /// All the faults, if there are any.
    pub fn finish<T>(self, read: Option<T>) -> Result<T, Failure> {
        let Some(read) = read.filter(|_| self.faults.is_empty()) else {
            return Err(Failure::Input(self.faults));
        };
        self.converted.iter().for_each(|value| terminal::message(&format!("in SI: {value}")));
        self.warnings.iter().for_each(|warning| terminal::message(&format!("warning: {warning}")));
        Ok(read)
    }
}
