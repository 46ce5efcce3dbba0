//! What an archive of unknown origin may ask of the machine that replays it, and what its scenes ask for.

use crate::experiments::{Scene, Work};

/// The most that a replay may take. The defaults are about ten times what the largest published report takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Estimated work of all scenes together, in seconds of one core.
    pub core_seconds: f64,
    /// Memory, estimated and measured, in MiB.
    pub memory_mib: f64,
    /// Measured time, in seconds.
    pub seconds: f64,
    /// Digits of one number in an input file.
    pub input_digits: f64,
    /// Certified digits of one result.
    pub result_digits: f64,
}

impl Default for Budget {
    fn default() -> Self {
        Self {
            core_seconds: 900.0,
            memory_mib: 2048.0,
            seconds: 3600.0,
            input_digits: 1000.0,
            result_digits: 20_000.0,
        }
    }
}

/// What one section of a scene asks for.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// The scene's file and the section, `scenes/a.toml: boundary`.
    pub place: String,
    /// What it asks for.
    pub work: Work,
}

/// What the scenes ask for, each with the name of its file.
pub fn requests<'s>(scenes: impl IntoIterator<Item = (&'s String, &'s Scene)>) -> Vec<Request> {
    let of = |(file, scene): (&String, &Scene)| {
        let request = |(section, work)| Request { place: format!("scenes/{file}.toml: {section}"), work };
        scene.work().into_iter().map(request).collect::<Vec<_>>()
    };
    scenes.into_iter().flat_map(of).collect()
}

impl Budget {
    /// All limits times a factor.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self {
            core_seconds: self.core_seconds * factor,
            memory_mib: self.memory_mib * factor,
            seconds: self.seconds * factor,
            input_digits: self.input_digits * factor,
            result_digits: self.result_digits * factor,
        }
    }

    /// The limits in words.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { core_seconds, memory_mib, seconds, input_digits, result_digits } = self;
        format!(
            "{core_seconds} s of estimated work on one core, {memory_mib} MiB of memory, {seconds} s of time, \
             {input_digits} digits of a number in an input, {result_digits} digits of a result"
        )
    }

    /// Why these requests go beyond the budget, one line for each limit.
    #[must_use]
    pub fn faults(&self, requests: &[Request]) -> Vec<String> {
        let work = sum_fault(requests, |work| work.core_seconds, self.core_seconds, "s of work on one core");
        let memory = sum_fault(requests, |work| work.memory_mib, self.memory_mib, "MiB of memory");
        let long = requests.iter().find(|request| request.work.digits > self.result_digits);
        let digits = long.map(|Request { place, work }| {
            format!("{place}: {} (budget: {} digits of a result)", work.what, self.result_digits)
        });
        [work, memory, digits].into_iter().flatten().collect()
    }

    /// The first number of a text with more digits than the budget has.
    pub(crate) fn digits_fault(&self, path: &str, text: &str) -> Option<String> {
        let longest = |line: &str| -> usize {
            let runs = line.split(|c: char| !c.is_ascii_digit() && c != '.' && c != '_');
            runs.map(|run| run.bytes().filter(u8::is_ascii_digit).count()).max().unwrap_or(0)
        };
        let (line, digits) =
            (1..).zip(text.lines().map(longest)).find(|(_, count)| *count as f64 > self.input_digits)?;
        Some(format!("{path}:{line}: a number of {digits} digits (budget: {})", self.input_digits))
    }
}

/// The fault of an amount whose sum over all requests is more than allowed.
fn sum_fault(requests: &[Request], amount: impl Fn(&Work) -> f64, most: f64, unit: &str) -> Option<String> {
    let amount = |request: &Request| amount(&request.work);
    let total: f64 = requests.iter().map(amount).sum();
    let largest = requests.iter().max_by(|one, other| amount(one).total_cmp(&amount(other)))?;
    let Request { place, work: Work { what, .. } } = largest;
    let [share, all] = [amount(largest), total].map(libm::ceil);
    (total > most)
        .then(|| format!("{place}: {what} take about {share} {unit}, all sections {all} (budget: {most})"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Limits;

    fn faults(sections: &str) -> Vec<String> {
        let slider = "name = \"a\"\ntitle = \"A\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
            critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";
        let text = format!("{slider}{sections}");
        let scene = Scene::parse("a.toml", text.as_bytes(), &Limits::default()).unwrap();
        Budget::default().faults(&requests([(&"a".to_string(), &scene)]))
    }

    const AXES: &str = "loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 1000 }\n\
        normal_stress_pa = { from = 1e2, to = 1e8, points = 1000 }\n";

    #[test]
    fn the_fault_names_the_section_that_asks_for_most() {
        assert!(faults(&format!("[map]\n{AXES}")).is_empty());
        for (section, words) in [
            (
                format!("[map]\n{AXES}[simulations]\n{AXES}laws = [\"slip\", \"aging\"]\ntolerance = 1e-15\n"),
                "scenes/a.toml: simulations: 2000000 simulations at tolerance 1e-15",
            ),
            ("[boundary]\npoints = 2\ndigits = 1000000\n".into(), "boundary: 4 points of 1000000 digits (budget: 20000 digits of a result)"),
            ("[boundary]\npoints = 4000000\ndigits = 20\n".into(), "boundary: 8000000 points of 20 digits"),
            (
                "[start_sensitivity]\npoints = [{ loading_velocity_m_per_s = 1, normal_stress_pa = 1 }]\n\
                 laws = [\"slip\"]\ntolerance = 1e-15\n[effect_ratio_sweep]\neffect_ratio = { from = 1, to = 2, points = 1000000 }\n"
                    .into(),
                "effect_ratio_sweep: 1000000 points",
            ),
        ] {
            let found = faults(&section);
            assert!(found.first().is_some_and(|fault| fault.contains(words)), "{words}: {found:?}");
        }
    }

    #[test]
    fn the_largest_published_report_takes_a_tenth_of_the_budget() {
        let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/im-avouac/scenes");
        let parse = |entry: std::io::Result<std::fs::DirEntry>| {
            let bytes = std::fs::read(entry.unwrap().path()).unwrap();
            Scene::parse("a.toml", &bytes, &Limits::default()).unwrap()
        };
        let scenes: Vec<Scene> = std::fs::read_dir(scenes).unwrap().map(parse).collect();
        let requests = requests(scenes.iter().map(|scene| (&scene.name, scene)));
        let faults = Budget::default().times(0.1).faults(&requests);
        // The chapter on speed asks for results of 10 000 digits, half of the budget.
        assert!(faults.iter().all(|fault| fault.contains("digits of a result")), "{faults:?}");
        assert!(Budget::default().times(0.5).faults(&requests).is_empty());
    }

    #[test]
    fn the_budget_counts_digits_and_grows_by_its_factor() {
        let budget = Budget::default();
        let text = format!("a = 1\nb = 0.{}\n", "1".repeat(5000));
        assert_eq!(
            budget.digits_fault("a.toml", &text).unwrap(),
            "a.toml:2: a number of 5001 digits (budget: 1000)"
        );
        assert_eq!(budget.times(10.0).digits_fault("a.toml", &text), None);
        assert!(budget.text().starts_with("900 s of estimated work"));
    }
}
