//! Sweeps that ran elsewhere: their scene, their merged summary, and whether the two belong together.

use crate::experiments::Scene;
use crate::experiments::swept::SweptEntry;
use crate::scene::{Fault, Problem};
use crate::sweep::{Coordinate, Summary, SummarySection, SweepPoints, SweepSection, SweepWork};

/// A sweep whose summary is at hand.
#[derive(Debug, Clone)]
pub struct Swept {
    /// What running it took, and on what.
    pub entry: SweptEntry,
    /// The title of its scene.
    pub title: String,
    /// Its points and work.
    pub section: SweepSection,
    /// The summary of all its rows.
    pub summary: Summary,
    /// How many rows it has: points, once for each law.
    pub rows: u64,
}

impl Swept {
    /// What was kept of its rows.
    pub(crate) fn kept(&self) -> Option<&SummarySection> {
        self.section.summary.as_ref()
    }
}

/// Puts a sweep together from its scene (name of the file, digest, content) and its summary (name of the file, text).
///
/// # Errors
/// When the scene is not the one that ran, has no summary of the stated form, or the summary does not count every row once.
pub fn read_swept(
    entry: &SweptEntry,
    (scene_file, digest, scene): (String, String, Scene),
    (file, text): (&str, &str),
) -> Result<Swept, Fault> {
    let fault = |file: &str, key: &str, wanted: String| Fault::of(file, key, Problem::Needs(wanted));
    if digest != entry.scene_sha256 {
        let wanted = format!("to be the scene that ran, of SHA-256 {}, not {digest}", entry.scene_sha256);
        return Err(fault(&scene_file, "scene", wanted));
    }
    let title = scene.title;
    let missing = || fault(&scene_file, "sweep.summary", "a [sweep] with a [sweep.summary]".into());
    let section = scene.sweep.ok_or_else(missing)?;
    let kept = section.summary.as_ref().ok_or_else(missing)?;
    let rows = row_count(&section)
        .ok_or_else(|| fault(&scene_file, "sweep", "points that can be counted: no list".into()))?;
    let (columns, lines) = text.split_once('\n').unwrap_or((text, ""));
    let summed =
        Summary::of_columns(columns.as_bytes(), kept.bins.len() + kept.by.len()).and_then(|mut summary| {
            summary.add_summary(lines.as_bytes())?;
            Ok(summary)
        });
    let summary = summed.map_err(|error| fault(file, "summary", format!("another form: {error}")))?;
    if summary.rows() != rows {
        return Err(fault(file, "rows", format!("the {rows} rows of its scene, not {}", summary.rows())));
    }
    Ok(Swept { entry: entry.clone(), title, section, summary, rows })
}

/// The rows of a sweep that is no list.
fn row_count(section: &SweepSection) -> Option<u64> {
    let points = match &section.points {
        SweepPoints::Grid(coordinates) => coordinates.iter().map(Coordinate::points).product(),
        SweepPoints::Samples { count, .. } => *count,
        SweepPoints::List { .. } => return None,
    };
    let laws = match &section.work {
        SweepWork::Simulate { laws, .. } => laws.len() as u64,
        _ => 1,
    };
    Some(points * laws)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Limits;
    use slipmode_core::number::Rational;

    const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
        critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
        [sweep]\nwork = \"simulate\"\nlaws = [\"slip\", \"aging\"]\ntolerance = 1e-2\n[sweep.grid]\nnormal_stress_pa = 1e5\n\
        loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 3 }\n[sweep.summary]\nby = [\"law\"]\n";

    fn read(scene: &str, digest: &str, text: &str) -> Result<Swept, String> {
        let entry = SweptEntry {
            name: "s".into(),
            scene_sha256: "0".repeat(64),
            version: "0.1.0".into(),
            core_seconds: Rational::from(1),
            peak_memory_mib: Rational::from(1),
            machine: "here".into(),
        };
        let parsed = Scene::parse("s.toml", scene.as_bytes(), &Limits::default()).unwrap();
        read_swept(&entry, ("s.toml".into(), digest.into(), parsed), ("s.csv", text))
            .map_err(|fault| fault.to_string())
    }

    #[test]
    fn a_summary_has_to_be_of_its_scene_and_count_every_row() {
        let zeros = "0".repeat(64);
        let swept = read(SCENE, &zeros, "law,rows\naging,3\nslip,3\n").unwrap();
        assert_eq!((swept.rows, swept.summary.rows()), (6, 6));
        for (scene, digest, text, part) in [
            (SCENE, "1", "law,rows\naging,3\nslip,3\n", "the scene that ran"),
            (SCENE, &zeros, "law,rows\naging,3\nslip,2\n", "the 6 rows of its scene, not 5"),
            (SCENE, &zeros, "law,count\naging,3\n", "another form"),
            (SCENE.split("[sweep.summary]").next().unwrap(), &zeros, "", "[sweep.summary]"),
        ] {
            let message = read(scene, digest, text).unwrap_err();
            assert!(message.contains(part), "{part:?} is not in {message:?}");
        }
    }
}
