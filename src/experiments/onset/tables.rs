//! Tables of the onset of oscillation: velocities of theory and simulations, and the runs of fig 4.

use crate::experiments::onset::{Located, Onset, OnsetOutcome, OtherUnit, SeenOnset};
use crate::experiments::shared::cells::Rounded;
use crate::experiments::{Context, Need, Rows, SceneOutcome, TableMaker, table_of};
use slipmode_core::friction::Slider;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::asymptote::quasi_static_lower_normal_stress_pa;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "onset", needs: &[Need::Onset], make: onset },
    TableMaker { id: "onset-in-stress", needs: &[Need::Onset], make: onset_in_stress },
    TableMaker { id: "onset-swings", needs: &[Need::Onset], make: swings },
    TableMaker { id: "onset-in-other-unit", needs: &[Need::Onset], make: other_unit },
    TableMaker { id: "onset-runs", needs: &[Need::Onset], make: runs },
];

/// A line of constant normal stress with its scene.
type OfScene<'c, T> = (&'c SceneOutcome, &'c T);

/// The lines of one kind, each with its scene.
fn lines<'c, T>(
    context: &'c Context,
    of: fn(&'c OnsetOutcome) -> &'c Vec<T>,
) -> impl Iterator<Item = OfScene<'c, T>> {
    let found = context.outcome.scenes.iter().filter_map(|scene| Some((scene, scene.onset.as_ref()?)));
    found.flat_map(move |(scene, found)| of(found).iter().map(move |line| (scene, line)))
}

fn name(scene: &SceneOutcome) -> &str {
    &scene.scene.name
}

/// Digits of a place in dex: more than its error leaves.
const DEX_DIGITS: usize = 9;

/// Twice the relative error of the leading term that an asymptote leaves out, as log10 of a ratio.
fn twice_in_dex(leading: f64) -> f64 {
    libm::log10(1.0 + 2.0 * leading)
}

/// What the next term of the series of eq 20 allows: its relative size is bσ/(2KD_c).
fn series_allows(scene: &SceneOutcome, line: &Onset) -> Option<f64> {
    let slider = scene.slider().filter(|_| line.asymptote == Asymptote::InertialLower)?.map(nearest_f64);
    let stress = nearest_f64(&line.normal_stress_pa);
    Some(twice_in_dex(slider.evolution_effect * stress / (2.0 * slider.stiffness_stress_pa())))
}

/// Where oscillation begins in the runs of one law, as log10 of a ratio to a reference.
#[derive(Clone, Copy)]
struct Seen<'c> {
    seen: &'c SeenOnset,
    reference: f64,
}

impl Seen<'_> {
    fn dex(&self, found: Option<Located>) -> Option<f64> {
        found.map(|found| libm::log10(found.value / self.reference))
    }
}

/// A place on a line that the runs of one law show.
type OnsetPlace = fn(&SeenOnset) -> Option<Located>;

/// The columns of where oscillation exists and where it is visible.
fn seen_columns<'c, R: Copy>(table: Rows<R>, seen: impl Fn(R) -> Seen<'c>) -> Rows<R> {
    let places: [(&str, OnsetPlace); 3] = [
        ("simulated", |seen| seen.exists),
        ("second_rise", |seen| seen.second_rise),
        ("undershoot", |seen| seen.undershoot),
    ];
    places.into_iter().fold(table, |table, (name, place)| {
        table
            .digits(&format!("{name}_dex"), DEX_DIGITS, |row| {
                let seen = seen(row);
                seen.dex(place(seen.seen))
            })
            .digits(&format!("{name}_error_dex"), 1, |row| place(seen(row).seen).map(|found| found.error_dex))
    })
}

fn onset(context: &Context) -> Option<Table> {
    let rows = lines(context, |found| &found.lines)
        .flat_map(|(scene, line)| line.seen.iter().map(move |seen| (scene, line, seen)));
    let reference = |line: &Onset| line.asymptote_velocity_m_per_s.to_f64();
    let dex = |line: &Onset, velocity: f64| Rounded(libm::log10(velocity / reference(line)));
    let table = table_of("onset", rows)
        .text("scene", |(scene, ..)| name(scene))
        .text("slider", |(scene, ..)| scene.slider_words())
        .text("law", |(.., seen)| seen.law.as_str())
        .digits("normal_stress_pa", 4, |(_, line, _)| &line.normal_stress_pa)
        .text("asymptote", |(_, line, _)| line.asymptote.as_str())
        .named()
        .digits("asymptote_velocity_m_per_s", 6, |(_, line, _)| &line.asymptote_velocity_m_per_s)
        .digits("boundary_velocity_m_per_s", 6, |(_, line, _)| &line.boundary_velocity_m_per_s)
        .digits("boundary_dex", DEX_DIGITS, |(_, line, _)| dex(line, line.boundary_velocity_m_per_s.to_f64()))
        .digits("series_allows_dex", 4, |(scene, line, _)| series_allows(scene, line).map(Rounded))
        .digits("inertial_dex", DEX_DIGITS, |(_, line, _)| line.inertial.map(|found| dex(line, found.value)));
    seen_columns(table, |(_, line, seen)| Seen { seen, reference: reference(line) })
        .digits("peak_excess_at_boundary", 3, |(.., seen)| seen.peak_excess_at_boundary)
        .table()
}

fn onset_in_stress(context: &Context) -> Option<Table> {
    let eq16 = |scene: &SceneOutcome| {
        let slider = scene.slider().map(|slider| slider.map(nearest_f64));
        slider.map_or(f64::NAN, |slider| quasi_static_lower_normal_stress_pa(&slider))
    };
    let rows = lines(context, |found| &found.stress_lines)
        .flat_map(|(scene, line)| line.seen.iter().map(move |seen| (scene, line, seen)));
    let table = table_of("onset-in-stress", rows)
        .text("scene", |(scene, ..)| name(scene))
        .text("slider", |(scene, ..)| scene.slider_words())
        .text("law", |(.., seen)| seen.law.as_str())
        .digits("loading_velocity_m_per_s", 4, |(_, line, _)| &line.loading_velocity_m_per_s)
        .named()
        .digits("eq16_pa", 8, |(scene, ..)| Rounded(eq16(scene)))
        .digits("boundary_pa", 8, |(_, line, _)| &line.boundary_pa)
        .digits("boundary_dex", 6, |(scene, line, _)| {
            Rounded(libm::log10(line.boundary_pa.to_f64() / eq16(scene)))
        })
        .digits("series_allows_dex", 4, |(scene, line, _)| {
            let eta = |slider: &Slider<Rational>| {
                let stress = Rational::from_f64(eq16(scene)).unwrap_or_default();
                let at = slider.at(stress, line.loading_velocity_m_per_s.clone());
                Rounded(twice_in_dex(nearest_f64(&at.groups().inertial_parameter)))
            };
            scene.slider().map(eta)
        });
    seen_columns(table, |(scene, _, seen)| Seen { seen, reference: eq16(scene) }).table()
}

fn swings(context: &Context) -> Option<Table> {
    let runs = lines(context, |found| &found.lines)
        .flat_map(|(scene, line)| line.shown.iter().map(move |run| (scene, line, run)));
    table_of("onset-swings", runs)
        .text("scene", |(scene, ..)| name(scene))
        .text("slider", |(scene, ..)| scene.slider_words())
        .digits("normal_stress_pa", 4, |(_, line, _)| &line.normal_stress_pa)
        .text("asymptote", |(_, line, _)| line.asymptote.as_str())
        .digits("velocity_over_asymptote", 6, |(.., run)| Rounded(run.velocity_over_asymptote))
        .named()
        .text("oscillates", |(.., run)| run.oscillates)
        .text("slip_mode_theory", |(.., run)| run.slip_mode.as_str())
        .digits("swing_overshoot", 6, |(.., run)| Some(run.swing?.0.overshoot))
        .digits("swing_second_rise", 6, |(.., run)| Some(run.swing?.0.second_rise))
        .digits("swing_undershoot", 6, |(.., run)| Some(run.swing?.0.undershoot))
        .digits("swing_error", 1, |(.., run)| Some(run.swing?.1))
        .table()
}

fn other_unit(context: &Context) -> Option<Table> {
    let found = context.outcome.each(|scene| &scene.onset);
    let others = found.flat_map(|(_, found)| &found.other_unit);
    table_of("onset-in-other-unit", others)
        .digits("normal_stress_pa", 4, |other: &OtherUnit| nearest_f64(&other.normal_stress_pa))
        .named()
        .text("has_boundary", |other| other.has_boundary)
        .text("always_unstable", |other| other.always_unstable)
        .text("behaviour", |other| other.behaviour.map(|found| found.as_str()))
        .table()
}

fn runs(context: &Context) -> Option<Table> {
    let runs = lines(context, |found| &found.lines)
        .flat_map(|(scene, line)| line.shown.iter().map(move |run| (scene, line, run)));
    let rows = runs.flat_map(|(scene, line, run)| run.history.iter().map(move |at| (scene, line, run, at)));
    table_of("onset-runs", rows)
        .text("scene", |(scene, ..)| name(scene))
        .digits("normal_stress_pa", 4, |(_, line, ..)| &line.normal_stress_pa)
        .digits("loading_velocity_m_per_s", 4, |(_, _, run, _)| run.loading_velocity_m_per_s)
        .digits("loaded_distance_over_slip_distance", 4, |(.., at)| at.0)
        .digits("velocity_over_loading_velocity", 5, |(.., at)| at.1)
        .table()
}
