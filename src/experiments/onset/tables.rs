//! Tables of the onset of oscillation: velocities of theory and simulations, and the runs of fig 4.

use crate::experiments::onset::{Located, Onset, OtherUnit, SeenOnset, StressOnset};
use crate::experiments::shared::cells::{DigitColumns, Rounded};
use crate::experiments::{Context, Need, SceneOutcome, TableMaker};
use slipmode_core::friction::Slider;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::asymptote::quasi_static_lower_normal_stress_pa;
use slipmode_plot::table::{Table, TableRows};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "onset", needs: &[Need::Onset], make: onset },
    TableMaker { id: "onset-in-stress", needs: &[Need::Onset], make: onset_in_stress },
    TableMaker { id: "onset-swings", needs: &[Need::Onset], make: swings },
    TableMaker { id: "onset-in-other-unit", needs: &[Need::Onset], make: other_unit },
    TableMaker { id: "onset-runs", needs: &[Need::Onset], make: runs },
];

/// A line of constant normal stress with its scene.
type OfScene<'c, T> = (&'c SceneOutcome, &'c T);

fn lines<'c>(context: &'c Context) -> impl Iterator<Item = OfScene<'c, Onset>> {
    let scenes = context.outcome.scenes.iter();
    scenes.flat_map(|scene| {
        scene.onset.iter().flat_map(move |found| found.lines.iter().map(move |line| (scene, line)))
    })
}

fn stress_lines<'c>(context: &'c Context) -> impl Iterator<Item = OfScene<'c, StressOnset>> {
    let scenes = context.outcome.scenes.iter();
    scenes.flat_map(|scene| {
        scene.onset.iter().flat_map(move |found| found.stress_lines.iter().map(move |line| (scene, line)))
    })
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
fn seen_columns<'c, R: Copy>(table: TableRows<R>, seen: impl Fn(R) -> Seen<'c>) -> TableRows<R> {
    let places: [(&str, &str, OnsetPlace); 3] = [
        ("simulated", "Oscillation in simulations", |seen| seen.exists),
        ("second_rise", "Second rise visible", |seen| seen.second_rise),
        ("undershoot", "Undershoot visible", |seen| seen.undershoot),
    ];
    places.into_iter().fold(table, |table, (name, header, place)| {
        table
            .digits(&format!("{name}_dex"), header, "dex", DEX_DIGITS, |row| {
                let seen = seen(row);
                seen.dex(place(seen.seen))
            })
            .digits(&format!("{name}_error_dex"), "Its error", "dex", 1, |row| {
                place(seen(row).seen).map(|found| found.error_dex)
            })
    })
}

fn onset(context: &Context) -> Option<Table> {
    let note = "Velocities in dex are log10 of the ratio to that of the asymptote ({inertial-lower}; {inertial-upper} on the upper arc). The exact boundary is enclosed and the threshold is decided exactly. Simulated oscillation begins where the squared frequency of small deviations extrapolates to zero. Oscillation is visible if V, after its first peak above V_l in the run from V_l/10, rises again, or falls below V_l, by the scene's visible fraction of V_l. The series of {inertial-lower} allows twice its leading relative error bσ/(2KD_c).";
    let rows = lines(context).flat_map(|(scene, line)| line.seen.iter().map(move |seen| (scene, line, seen)));
    let reference = |line: &Onset| line.asymptote_velocity_m_per_s.to_f64();
    let dex = |line: &Onset, velocity: f64| Rounded(libm::log10(velocity / reference(line)));
    let table = Table::of("onset", "Onset of oscillation at given normal stress", rows)
        .note(note)
        .text("scene", "Scene", |(scene, ..)| name(scene))
        .text("slider", "Slider", |(scene, ..)| scene.slider_words())
        .text("law", "Law", |(.., seen)| seen.law.as_str())
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |(_, line, _)| &line.normal_stress_pa)
        .text("asymptote", "Asymptote", |(_, line, _)| line.asymptote.as_str())
        .named()
        .digits("asymptote_velocity_m_per_s", "Velocity of the asymptote", "m/s", 6, |(_, line, _)| {
            &line.asymptote_velocity_m_per_s
        })
        .digits("boundary_velocity_m_per_s", "Velocity of the exact boundary", "m/s", 6, |(_, line, _)| {
            &line.boundary_velocity_m_per_s
        })
        .digits("boundary_dex", "Exact boundary", "dex", DEX_DIGITS, |(_, line, _)| {
            dex(line, line.boundary_velocity_m_per_s.to_f64())
        })
        .digits(
            "series_allows_dex",
            "Allowed by the series of the asymptote",
            "dex",
            4,
            |(scene, line, _)| series_allows(scene, line).map(Rounded),
        )
        .digits("inertial_dex", "Inertial by the threshold", "dex", DEX_DIGITS, |(_, line, _)| {
            line.inertial.map(|found| dex(line, found.value))
        });
    seen_columns(table, |(_, line, seen)| Seen { seen, reference: reference(line) })
        .digits("peak_excess_at_boundary", "V_peak/V_l − 1 at the boundary", "", 3, |(.., seen)| {
            seen.peak_excess_at_boundary
        })
        .table()
        .into()
}

fn onset_in_stress(context: &Context) -> Option<Table> {
    let note = "The same on lines of constant velocity; dex are log10 of the normal stress over that of {quasi-static-lower}, whose series allows twice its leading relative error η.";
    let eq16 = |scene: &SceneOutcome| {
        scene
            .slider()
            .map_or(f64::NAN, |slider| quasi_static_lower_normal_stress_pa(&slider.map(nearest_f64)))
    };
    let rows =
        stress_lines(context).flat_map(|(scene, line)| line.seen.iter().map(move |seen| (scene, line, seen)));
    let table = Table::of("onset-in-stress", "Onset of oscillation at given loading velocity", rows)
        .note(note)
        .text("scene", "Scene", |(scene, ..)| name(scene))
        .text("slider", "Slider", |(scene, ..)| scene.slider_words())
        .text("law", "Law", |(.., seen)| seen.law.as_str())
        .digits("loading_velocity_m_per_s", "Loading velocity V_l", "m/s", 4, |(_, line, _)| {
            &line.loading_velocity_m_per_s
        })
        .named()
        .digits("eq16_pa", "σ of {quasi-static-lower}", "Pa", 8, |(scene, ..)| Rounded(eq16(scene)))
        .digits("boundary_pa", "σ of the exact boundary", "Pa", 8, |(_, line, _)| &line.boundary_pa)
        .digits("boundary_dex", "Exact boundary", "dex", 6, |(scene, line, _)| {
            Rounded(libm::log10(line.boundary_pa.to_f64() / eq16(scene)))
        })
        .digits(
            "series_allows_dex",
            "Allowed by the series of {quasi-static-lower}",
            "dex",
            4,
            |(scene, line, _)| {
                let eta = |slider: &Slider<Rational>| {
                    let stress = Rational::from_f64(eq16(scene)).unwrap_or_default();
                    let at = slider.at(stress, line.loading_velocity_m_per_s.clone());
                    Rounded(twice_in_dex(nearest_f64(&at.groups().inertial_parameter)))
                };
                scene.slider().map(eta)
            },
        );
    seen_columns(table, |(scene, _, seen)| Seen { seen, reference: eq16(scene) }).table().into()
}

fn swings(context: &Context) -> Option<Table> {
    let note = "Runs from V_l/10 on either side of the onset, with the first law of the scene. Swings are in V_l; 0 stands for what does not happen. Whether a complex pair exists is decided exactly.";
    let runs = lines(context).flat_map(|(scene, line)| line.shown.iter().map(move |run| (scene, line, run)));
    Table::of("onset-swings", "What is seen of the runs on either side of the onset", runs)
        .note(note)
        .text("scene", "Scene", |(scene, ..)| name(scene))
        .text("slider", "Slider", |(scene, ..)| scene.slider_words())
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |(_, line, _)| &line.normal_stress_pa)
        .text("asymptote", "Asymptote", |(_, line, _)| line.asymptote.as_str())
        .digits("velocity_over_asymptote", "V_l over the asymptote", "", 6, |(.., run)| {
            Rounded(run.velocity_over_asymptote)
        })
        .named()
        .text("oscillates", "Complex pair", |(.., run)| if run.oscillates { "yes" } else { "no" })
        .text("slip_mode_theory", "Slip mode, theory", |(.., run)| run.slip_mode.as_str())
        .digits("swing_overshoot", "First peak above V_l", "", 6, |(.., run)| Some(run.swing?.0.overshoot))
        .digits("swing_second_rise", "Second rise", "", 6, |(.., run)| Some(run.swing?.0.second_rise))
        .digits("swing_undershoot", "Undershoot", "", 6, |(.., run)| Some(run.swing?.0.undershoot))
        .digits("swing_error", "Error of a swing", "", 1, |(.., run)| Some(run.swing?.1))
        .table()
        .into()
}

fn other_unit(context: &Context) -> Option<Table> {
    let found = context.outcome.each(|scene| &scene.onset);
    let others = found.flat_map(|(_, found)| &found.other_unit);
    let word = |is: bool| if is { "yes" } else { "no" };
    Table::of("onset-in-other-unit", "The normal stresses of the onset, read in another unit", others)
        .note("What a run does at the velocity of {inertial-lower}.")
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |other: &OtherUnit| {
            nearest_f64(&other.normal_stress_pa)
        })
        .named()
        .text("has_boundary", "Boundary in the stable zone", |other| word(other.has_boundary))
        .text("always_unstable", "Unstable at every velocity", |other| word(other.always_unstable))
        .text("behaviour", "Long-term behaviour", |other| other.behaviour.map(|found| found.as_str()))
        .table()
        .into()
}

fn runs(context: &Context) -> Option<Table> {
    let note = "Samples of the runs of fig 4, equally spaced in time.";
    let runs = lines(context).flat_map(|(scene, line)| line.shown.iter().map(move |run| (scene, line, run)));
    let rows = runs.flat_map(|(scene, line, run)| run.history.iter().map(move |at| (scene, line, run, at)));
    Table::of("onset-runs", "Runs on either side of the onset", rows)
        .note(note)
        .text("scene", "Scene", |(scene, ..)| name(scene))
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |(_, line, ..)| &line.normal_stress_pa)
        .digits("loading_velocity_m_per_s", "Loading velocity V_l", "m/s", 4, |(_, _, run, _)| {
            run.loading_velocity_m_per_s
        })
        .digits("loaded_distance_over_slip_distance", "V_l t/D_c", "", 4, |(.., at)| at.0)
        .digits("velocity_over_loading_velocity", "V/V_l", "", 5, |(.., at)| at.1)
        .table()
        .into()
}
