//! `slipmode explore`: one page on which all seven values of a scene can be changed.

use slipmode_core::friction::{OperatingPoint, Slider};
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use slipmode::archive::sha256_hex;
use slipmode::experiments::Scene;
use slipmode::explorer::{Families, Window, explorer, live_map, points};
use slipmode::report::{ExplorerPage, PAGE_BUDGET_BYTES, render_explorer};
use slipmode::scene::{Limits, LogAxis, Quantity};
use slipmode_core::number::{Rational, nearest_f64};

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::input::read_small_file;
use crate::cli::inputs::slider_json;
use crate::cli::new::Ranges;
use crate::cli::options::{Arguments, operating_point};
use crate::cli::output::{MadeFolder, Output, is_stream};
use crate::cli::path_text::{json_path, quoted, shown_path, word_of};

/// Options of `explore`.
#[derive(Debug, Args)]
pub struct Options {
    /// The scene; the page uses its slider, the axes of its map, and its operating point or the points of its trajectories
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// σ of an operating point that the page follows too, Pa or with a unit; needs -v
    #[arg(short = 's', long, value_name = "S", allow_hyphen_values = true)]
    normal_stress_pa: Option<String>,
    /// V0 of this operating point, m/s or with a unit; needs -s
    #[arg(short = 'v', long, value_name = "V", allow_hyphen_values = true)]
    loading_velocity_m_per_s: Option<String>,
    /// The page, or a folder for it (a new one ends in `/`); `-` is standard output [default: NAME.html, with the scene's name]
    #[arg(short, long, value_name = "FILE.html", visible_alias = "out")]
    output: Option<PathBuf>,
    /// One JSON object instead of text: the page, and the points that it follows
    #[arg(long)]
    json: bool,
}

/// Writes the page.
///
/// # Errors
/// When the scene is at fault or has no slider, or the page cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let own = options.point(&mut arguments);
    arguments.refuse_stream("--output", options.output.as_deref().filter(|_| options.json), "the object");
    let own = arguments.finish(own)?;
    let bytes = read_small_file(&options.scene)?;
    let scene = Scene::parse(&options.scene.display().to_string(), &bytes, &Limits::default())?;
    let refused = |why: &str| Failure::place(&options.scene, why);
    let parameters = scene.parameters.as_ref().ok_or_else(|| refused("has no [parameters] to explore"))?;
    let own_point = own.clone().or_else(|| parameters.point());
    let window = window(&scene, &parameters.slider, own_point.as_ref()).map_err(|why| refused(&why))?;
    let (place, _folder) = place(options.output.as_deref(), &scene.name)?;
    let output = Output::create(&place)?;
    let (points, mut marks) = points(&scene, parameters, own.as_ref(), window);
    if parameters.error_bars.is_some() {
        marks += " The bands and the slip modes hold for all values within the scene's error bars, the lines and numbers for the middle values.";
    }
    let followed = points
        .iter()
        .fold(Answer::default(), |followed, point| followed.with(&point.name, point_json(&point.place)));
    let live = live_map(parameters, &points, window, &scene.threshold());
    let families =
        Families::of(&parameters.slider, parameters.error_bars.as_ref(), points, &scene.threshold());
    let file = options.scene.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let word = word_of(file.as_ref());
    let page = ExplorerPage {
        title: &scene.title,
        slider: &parameters.slider,
        marks: &marks,
        command: &format!("slipmode explore {word}{} --output {}.html", options.typed_point(), scene.name),
        scene: &file,
        digest: &sha256_hex(&bytes),
        live: live.as_ref(),
    };
    let html = render_explorer(&explorer(&families, window), &page)
        .map_err(|error| Failure::machine("the page cannot be made", &error))?;
    if html.len() > PAGE_BUDGET_BYTES {
        let bytes = html.len();
        return Err(refused(&format!("its page would have {bytes} bytes (allowed: {PAGE_BUDGET_BYTES})")));
    }
    output.finish(html)?;
    let own = own.as_ref().map(point_json);
    let line = if is_stream(&place) { String::new() } else { format!("{}\n", shown_path(&place)) };
    Answer::to(json!({ "scene": json_path(&options.scene), "operating_point": own }))
        .with("scene_sha256", page.digest)
        .with("slider", slider_json(&parameters.slider))
        .part("points", followed)
        .with("output", json_path(&place))
        .text(&line)
        .print(options.json)
}

/// σ and V0 under their names.
fn point_json(point: &OperatingPoint<Rational>) -> Value {
    let [stress, velocity] = [&point.normal_stress_pa, &point.loading_velocity_m_per_s].map(nearest_f64);
    json!({ Quantity::NormalStress.as_str(): stress, Quantity::LoadingVelocity.as_str(): velocity })
}

/// The file to write: inside a folder that is named, it has the scene's name. A new folder, which ends in a slash, is made.
fn place(output: Option<&Path>, name: &str) -> Result<(PathBuf, Option<MadeFolder>), Failure> {
    let name = format!("{name}.html");
    let Some(place) = output else { return Ok((name.into(), None)) };
    let is_new = place.as_os_str().as_encoded_bytes().ends_with(b"/") && !place.exists();
    let made = is_new.then(|| MadeFolder::at(place)).transpose()?;
    Ok((if place.is_dir() { place.join(name) } else { place.to_path_buf() }, made))
}

impl Options {
    /// The operating point that was given, if any; none when it is at fault.
    fn point(&self, arguments: &mut Arguments) -> Option<Option<OperatingPoint<Rational>>> {
        operating_point(self.normal_stress_pa.as_deref(), self.loading_velocity_m_per_s.as_deref(), arguments)
    }

    /// The operating point as it was typed, for the command that makes the page again.
    fn typed_point(&self) -> String {
        match (&self.normal_stress_pa, &self.loading_velocity_m_per_s) {
            (Some(stress), Some(velocity)) => format!(" -s {} -v {}", quoted(stress), quoted(velocity)),
            _ => String::new(),
        }
    }
}

/// The scene's map, or what `new` would choose for the slider; with room for the operating point.
fn window(
    scene: &Scene,
    slider: &Slider<Rational>,
    own: Option<&OperatingPoint<Rational>>,
) -> Result<Window, String> {
    let axis = |axis: &LogAxis, own: Option<&Rational>| {
        let ends = (nearest_f64(&axis.from), nearest_f64(&axis.to));
        own.map_or(ends, |own| including(ends, own))
    };
    let map = scene.map.as_ref().map(|map| &map.rectangle);
    if let Some(rectangle) = map.or(scene.zones.as_ref().map(|zones| &zones.rectangle)) {
        let velocity = own.map(|own| &own.loading_velocity_m_per_s);
        return Ok(Window {
            velocity: axis(&rectangle.loading_velocity_m_per_s, velocity),
            stress: axis(&rectangle.normal_stress_pa, own.map(|own| &own.normal_stress_pa)),
        });
    }
    let ranges = Ranges::around(slider)?.showing(own);
    Ok(Window { velocity: ranges.velocity.ends(), stress: ranges.stress.ends() })
}

/// The range, longer where a value lies outside.
fn including((low, high): (f64, f64), value: &Rational) -> (f64, f64) {
    let value = nearest_f64(value);
    if (low..=high).contains(&value) { (low, high) } else { (low.min(0.5 * value), high.max(2.0 * value)) }
}
