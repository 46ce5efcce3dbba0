//! `slipmode verify DIR --planted-faults`: wrong versions of a report's equations, and the claims that notice them.

use slipmode::claims::{PlantedFaults, plant_faults};
use slipmode::experiments::{Context, Needs, run};
use slipmode::report::Folder;

use crate::cli::failure::Failure;
use crate::cli::progress::Progress;
use crate::cli::terminal;

/// Plants faults in the equations of a report and prints what became of them, equation by equation.
///
/// # Errors
/// When the terminal cannot be written.
pub fn verify_planted_faults(folder: &Folder, progress: &Progress) -> Result<(), Failure> {
    let found = progress.items(|progress| {
        let outcome = run(&folder.scenes, &Needs::new(), &folder.references, progress);
        plant_faults(&Context::new(&folder.equations, &outcome).with_claims(&folder.claims))
    });
    let sum = |count: fn(&PlantedFaults) -> usize| found.iter().map(count).sum::<usize>();
    let counts = [sum(|one| one.noticed), sum(|one| one.planted), sum(|one| one.harmless)];
    let lines: String = found.iter().map(account).collect();
    terminal::print(&format!("{lines}{}\n", line("all", counts)))
}

fn account(one: &PlantedFaults) -> String {
    let mut text = line(&one.equation, [one.noticed, one.planted, one.harmless]);
    if !one.noticed_by.is_empty() {
        text += &format!(", first by {}", one.noticed_by.join(", "));
    }
    let survivors =
        one.survivors.iter().map(|lost| format!("  not noticed ({}): {}\n", lost.kind, lost.text));
    text + "\n" + &survivors.collect::<String>()
}

fn line(equation: &str, [noticed, planted, harmless]: [usize; 3]) -> String {
    let same = if harmless == 0 { String::new() } else { format!(" ({harmless} equivalent forms besides)") };
    format!("{equation:<18} {noticed} of {planted} wrong versions noticed{same}")
}
