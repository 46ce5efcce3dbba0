//! `slipmode new`: a report folder for one's own slider, commented, checked by reading it back, with verdicts computed; or one for the
//! claims of another paper.

mod claims;
mod files;
mod paper;
mod ranges;
mod scene;

use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use std::path::{Path, PathBuf};

use clap::Args;
use slipmode::scene::{Limits, Problem, Quantity, Sliders, Uncertain, all_of, check_name};

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::folder::{Source, read_report_from};
use crate::cli::inputs::given_json;
use crate::cli::options::{Arguments, QUANTITIES, SliderOptions, option_of};
use crate::cli::output::OutputFolder;
use crate::cli::path_text::{json_path, word_of};
use crate::cli::progress::Progress;
use crate::cli::simulate::range::{Factors, outside};
use crate::cli::tree::{Files, listing};

use files::folder_files;
pub use ranges::Ranges;
use ranges::{OwnRange, USUAL, usual};
use scene::{Own, Typed};

pub use scene::Fitted;

/// Options of `new`.
#[derive(Debug, Args)]
pub struct Options {
    /// The report's name: A-Z a-z 0-9 . _ -
    #[arg(value_name = "NAME", allow_hyphen_values = true)]
    name: String,
    #[command(flatten)]
    slider: SliderOptions,
    /// The normal stresses of your experiments, such as [2MPa, 10MPa] [default: half a decade around --normal-stress-pa]
    #[arg(long, value_name = "[LOW, HIGH]", allow_hyphen_values = true, conflicts_with = "paper")]
    normal_stresses: Option<String>,
    /// The loading velocities of your experiments, such as [1um/s, 1mm/s] [default: a decade around --loading-velocity-m-per-s]
    #[arg(long, value_name = "[LOW, HIGH]", allow_hyphen_values = true, conflicts_with = "paper")]
    loading_velocities: Option<String>,
    /// A folder for the claims of another paper instead: its equations and its claims, with one example of each
    #[arg(long, conflicts_with = QUANTITIES)]
    paper: bool,
    /// The folder to write; it must not exist [default: NAME]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// One JSON object instead of text: the slider, the files and the command to run next
    #[arg(long)]
    json: bool,
}

/// The paper's slider, in the order of the command line: what a folder starts from when no values are given.
const PAPER: [&str; 5] = ["0.004", "0.006", "10e-6", "10e6", "1000"];

/// Writes the folder.
///
/// # Errors
/// When the arguments are at fault, the place is taken, or the slider's corners lie beyond what a scene can hold.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    if options.paper {
        let mut arguments = Arguments::default();
        check_report_name(&options.name, &mut arguments);
        arguments.finish(Some(()))?;
        let (place, written) = free_place(options)?;
        return options.write(written, &paper::files(&options.name), "verify", &place, Answer::default());
    }
    let (typed, parameters) = read(options)?;
    let (place, output) = free_place(options)?;
    let files = drafted(&typed, &parameters, &place, *progress)?;
    let keys = ["normal_stresses_pa", "loading_velocities_m_per_s"];
    let ranges = typed.own.iter().flat_map(|own| keys.into_iter().zip(&own.ranges));
    let inputs = ranges.fold(given_json(&typed.slider), |inputs, (key, [low, _, high])| {
        inputs.with(key, [low, high].map(nearest_f64))
    });
    options.write(output, &files, "report", &place, inputs)
}

/// A folder for a slider whose values were fitted, to be written at a place where nothing is.
///
/// # Errors
/// When the place is taken or has no name for a report, or the slider's corners lie beyond what a scene can hold.
pub fn write_fitted(
    place: &Path,
    slider: &SliderOptions,
    fitted: Fitted,
    progress: Progress,
) -> Result<(), Failure> {
    let options = Options {
        name: place.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        slider: slider.clone(),
        normal_stresses: None,
        loading_velocities: None,
        paper: false,
        output: Some(place.to_path_buf()),
        json: false,
    };
    let (typed, parameters) = read(&options)?;
    let (place, output) = free_place(&options)?;
    let typed = Typed { fitted: Some(fitted), ..typed };
    output.commit(&drafted(&typed, &parameters, &place, progress)?)
}

/// Failed simulations that another grid may avoid: those next to the boundary are few.
const FEW_GAPS: usize = 4;

/// How far below and above the tested ranges of η, κ and b/a an operating range may lie. A simulation far outside takes minutes.
const FARTHEST: Factors = [[1e10, 1e4], [1e10, 100.0], [1e10, 100.0]];

/// The files of a folder with their verdicts, on a grid of simulations that has no gaps where such a grid is found.
fn drafted(
    typed: &Typed,
    parameters: &Slider<Rational>,
    place: &Path,
    progress: Progress,
) -> Result<Files, Failure> {
    let effects = effects_of(parameters);
    let corners = Ranges::around(parameters).map_err(Failure::Refused)?;
    let mut ranges = typed.own.as_ref().map_or(corners, |own| Ranges::of_laboratory(&own.ranges));
    let (mut files, mut gaps) = complete(typed, effects, &ranges, place, progress)?;
    while (1..=FEW_GAPS).contains(&gaps) && ranges.coarsen() {
        (files, gaps) = complete(typed, effects, &ranges, place, progress)?;
    }
    Ok(files)
}

/// Where the folder is to be, and the folder under writing; nothing may be there.
fn free_place(options: &Options) -> Result<(PathBuf, OutputFolder), Failure> {
    let place = options.output.clone().unwrap_or_else(|| PathBuf::from(&options.name));
    if place.symlink_metadata().is_ok() {
        return Err(Failure::place(&place, "already exists; choose another folder"));
    }
    let output = OutputFolder::create(&place, &[])?;
    Ok((place, output))
}

impl Options {
    /// Writes the files, lists them, and names the command to run next.
    fn write(
        &self,
        output: OutputFolder,
        files: &Files,
        next: &str,
        place: &Path,
        inputs: Answer,
    ) -> Result<(), Failure> {
        output.commit(files)?;
        let next = format!("slipmode {next} {}", word_of(place));
        Answer::to(inputs.with("name", &self.name).with("paper", self.paper).json())
            .with("output", json_path(place))
            .with("files", files.keys().collect::<Vec<_>>())
            .text(&format!("{}next: {next}\n", listing(files, place)))
            .with("next", &next)
            .print(self.json)
    }
}

/// The scene's file is called NAME.toml.
fn check_report_name(name: &str, arguments: &mut Arguments) {
    if let Err(error) = check_name(name).and(check_name(&format!("{name}.toml"))) {
        arguments.fault::<()>("NAME", Some(name), Problem::BadName(error));
    }
}

/// Which of the two effects is larger: what exists depends on it.
fn effects_of(parameters: &Slider<Rational>) -> Sliders {
    match parameters.direct_effect.cmp(&parameters.evolution_effect) {
        std::cmp::Ordering::Less => Sliders::Weakening,
        std::cmp::Ordering::Equal => Sliders::Neutral,
        std::cmp::Ordering::Greater => Sliders::Strengthening,
    }
}

/// The name and the numbers as typed, and the slider as exact values.
fn read(options: &Options) -> Result<(Typed, Slider<Rational>), Failure> {
    let mut arguments = Arguments::default();
    check_report_name(&options.name, &mut arguments);
    let Some(centre) = options.slider.centre(&mut arguments) else { return arguments.finish(None) };
    let given = Quantity::OF_THE_SLIDER.map(|quantity| centre.text(quantity));
    let is_example = given.iter().all(Option::is_none);
    let or_example = |slider: SliderOptions| if is_example { slider.with_material(PAPER) } else { slider };
    let (centre, slider) = (or_example(centre), or_example(options.slider.clone()));
    let parameters = centre.slider(&mut arguments);
    let ranges = centre.point(&mut arguments).and_then(|point| own_ranges(options, point, &mut arguments));
    let parameters = arguments.finish(parameters)?;
    let own = ranges.map(|ranges| Own { slider: parameters.clone(), ranges });
    own.as_ref().and_then(far_outside).map_or(Ok(()), |far| Err(Failure::Refused(far)))?;
    let typed = Typed { name: options.name.clone(), slider, is_example, own, fitted: None };
    Ok((typed, parameters))
}

/// The group of an operating range that is too far from the tested ones.
fn far_outside(Own { slider, ranges: [stresses, velocities] }: &Own) -> Option<String> {
    let places = stresses.iter().flat_map(|stress| velocities.iter().map(move |velocity| (stress, velocity)));
    let at = |(stress, velocity): (&Rational, &Rational)| slider.at(stress.clone(), velocity.clone());
    places.map(at).find_map(|point| outside(&point, FARTHEST, "range of reports").next())
}

/// The operating range around an operating point; none without one, and when an option is at fault.
fn own_ranges(
    options: &Options,
    point: Option<OperatingPoint<Rational>>,
    arguments: &mut Arguments,
) -> Option<[OwnRange; 2]> {
    let given = [
        ("--normal-stresses", &options.normal_stresses, Quantity::NormalStress),
        ("--loading-velocities", &options.loading_velocities, Quantity::LoadingVelocity),
    ];
    let Some(OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }) = point else {
        let needs = "an operating point: --normal-stress-pa and --loading-velocity-m-per-s";
        given.iter().for_each(|(option, text, _)| arguments.refuse_value(option, text.as_deref(), needs));
        return None;
    };
    let mut range = |index: usize, at: &Rational| {
        let (option, text, quantity) = given[index];
        let Some(text) = text else { return Some(usual(at, USUAL[index])) };
        let ends = arguments.number(option, text, |text| Uncertain::of(quantity, text))?;
        if ends.lower < ends.upper && (&ends.lower..=&ends.upper).contains(&at) {
            return Some([ends.lower, at.clone(), ends.upper]);
        }
        let needs = Problem::Needs(format!("a range that contains {}", option_of(quantity)));
        arguments.fault(option, Some(text), needs)
    };
    all_of([range(0, &normal_stress_pa), range(1, &loading_velocity_m_per_s)])
}

/// The files with the verdicts that they have: the folder is read back as `report` will read it, and decided. The second
/// value is the number of simulations without a result: claims on all of them are then left out.
fn complete(
    typed: &Typed,
    effects: Sliders,
    ranges: &Ranges,
    place: &Path,
    progress: Progress,
) -> Result<(Files, usize), Failure> {
    let mut files = folder_files(typed, effects, ranges);
    files.insert("claims.toml".into(), claims::undecided(&claims::candidates(effects)?));
    let bytes = files.iter().map(|(name, text)| (name.clone(), text.clone().into_bytes())).collect();
    let source = Source::Archive(place.to_path_buf(), bytes);
    let (folder, _) = read_report_from(source, Limits::default())?;
    let decided = claims::decide(&folder, progress)?;
    for text in files.values_mut() {
        *text = decided.without_those_left_out(text);
    }
    files.insert("claims.toml".into(), decided.text(&typed.name));
    Ok((files, decided.gaps))
}
