//! A verdict follows from the equations: alter one, and `verify` exits 1 and names the claims that rest on it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");
const CLAIMS: &str = include_str!("../../reports/im-avouac/claims.toml");

const REPORT: &str = r#"
name = "sabotage"
title = "A small report"
scenes = ["paper"]

[[chapter]]
id = "introduction"
title = "Introduction"
prose = "introduction.md"
"#;

/// The paper's parameters, which is what the proofs need, one search for the onset of oscillation, which is computed for claims N only,
/// and a few cycles of deep stick-slip, which are computed for claims X only.
const SCENE: &str = r#"
name = "paper"
title = "The paper's parameters"

[parameters]
direct_effect = 0.004
evolution_effect = 0.006
critical_slip_distance_m = 10e-6
stiffness_pa_per_m = 10e6
mass_per_area_kg_per_m2 = 1000

[onset]
normal_stress_pa = [1778.28, 562.34]
loading_velocity_m_per_s = [1e-6, 3e-6, 1e-5]
velocity_over_asymptote = [1]
laws = ["slip"]
tolerance = 1e-8
visible = 0.01

[simulations]
loading_velocity_m_per_s = { from = 1e-6, to = 1e-5, points = 3 }
normal_stress_pa = { from = 1e6, to = 1e7, points = 4 }
laws = ["slip", "aging"]
tolerance = 1e-6
"#;

/// A report folder in a scratch place, removed at the end.
struct Report(PathBuf);

impl Report {
    /// All claims of one letter but those that need maps computed.
    fn new(letter: char) -> Self {
        // Several faults may be planted for one letter at the same time.
        static MADE: AtomicUsize = AtomicUsize::new(0);
        let number = MADE.fetch_add(1, Ordering::Relaxed);
        let name = format!("slipmode-sabotage-{}-{letter}{number}", std::process::id());
        let root = std::env::temp_dir().join(name);
        let _ = fs::remove_dir_all(&root);
        for folder in ["scenes", "prose"] {
            fs::create_dir_all(root.join(folder)).unwrap();
        }
        let report = Self(root);
        report.write("report.toml", REPORT);
        report.write("scenes/paper.toml", SCENE);
        report.write("prose/introduction.md", "Nothing is placed here.\n");
        report.write("claims.toml", &claims_of(letter));
        report.write("equations.toml", EQUATIONS);
        report
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).unwrap();
    }

    fn run(&self, command: &str, output: &Path) -> Output {
        Command::new(env!("CARGO_BIN_EXE_slipmode"))
            .args([command, self.0.to_str().unwrap(), "-o", output.to_str().unwrap()])
            .output()
            .unwrap()
    }

    /// Makes the published copy, then checks that `verify` finds no difference.
    fn publish(&self) {
        let output = self.run("report", &self.0.join("published"));
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let output = self.run("verify", &self.0.join("out"));
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

impl Drop for Report {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Z1, Z5, Z7 and Z8 need maps or tolerances, F4 and all claims N but N6 and N11 a grid of simulations on both sides of K = K_c, and X3 to X5 and X8 families of cycles
/// or such a grid: this small report has none of them.
fn claims_of(letter: char) -> String {
    let wanted = |block: &&str| {
        let listed = |ids: &[&str]| ids.iter().any(|id| block.contains(&format!("id = \"{id}\"")));
        let computed = match letter {
            'N' => listed(&["N6", "N11"]),
            'X' => listed(&["X1", "X2"]),
            _ => !listed(&["F4", "Z1", "Z5", "Z7", "Z8"]),
        };
        block.contains(&format!("id = \"{letter}")) && computed
    };
    let blocks: String =
        CLAIMS.split("[[claim]]").filter(wanted).map(|block| format!("[[claim]]{block}")).collect();
    // Its tables have fewer rows than the claims on peaks want.
    blocks.lines().filter(|line| !line.starts_with("at_least = ")).map(|line| format!("{line}\n")).collect()
}

/// Replaces the text of one equation and expects these claims among those whose verdict changes.
fn sabotage(letter: char, equation: &str, altered: &str, named: &[&str]) {
    let report = Report::new(letter);
    report.publish();
    assert_eq!(EQUATIONS.matches(equation).count(), 1, "{equation}");
    report.write("equations.toml", &EQUATIONS.replace(equation, altered));
    let output = report.run("verify", &report.0.join("out"));
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    for id in named {
        assert!(said.contains(&format!("{id}: recorded ")), "{id} is not named: {said}");
    }
}

#[test]
fn an_aging_law_that_heals_with_the_wrong_sign_is_caught() {
    sabotage('F', "theta' = 1 - V*theta/D_c", "theta' = 1 + V*theta/D_c", &["F1", "F2"]);
}

#[test]
fn a_linearisation_with_the_wrong_sign_is_caught() {
    sabotage(
        'L',
        "Delta_theta' = -V_0/D_c*Delta_theta - 1/V_0*Delta_delta'",
        "Delta_theta' = -V_0/D_c*Delta_theta + 1/V_0*Delta_delta'",
        &["L1"],
    );
}

#[test]
fn a_critical_stiffness_without_its_square_is_caught() {
    sabotage(
        'S',
        "K_c = (b - a)*sigma/D_c*(1 + M*V_0^2/(sigma*a*D_c))",
        "K_c = (b - a)*sigma/D_c*(1 + M*V_0/(sigma*a*D_c))",
        &["S1", "S2"],
    );
}

#[test]
fn a_wrong_sign_in_eq_16_is_caught() {
    sabotage(
        'B',
        "sigma = K*D_c/(sqrt(b) + sqrt(a))^2",
        "sigma = K*D_c/(sqrt(b) - sqrt(a))^2",
        &["B2", "B3", "B10"],
    );
}

#[test]
fn a_last_term_of_eq_8_with_a_factor_is_caught_by_the_count_of_turning_points() {
    sabotage(
        'Q',
        "(sigma*D_c))*s^2 + (K/sigma + (a - b)/D_c)*s + K*V_0",
        "(sigma*D_c))*s^2 + (K/sigma + (a - b)/D_c)*s + 2*K*V_0",
        &["Q1", "Q7"],
    );
}

#[test]
fn a_crossing_frequency_with_a_and_b_exchanged_is_caught() {
    sabotage('Q', "s = ±i*sqrt((b - a)/a)*V_0/D_c", "s = ±i*sqrt((b - a)/b)*V_0/D_c", &["Q3"]);
}

#[test]
fn a_criterion_that_contains_the_slip_distance_is_caught() {
    sabotage('Z', "2*V_0*sqrt(M*K)/(a*sigma) = 1", "2*V_0*sqrt(M*K)*D_c/(a*sigma) = 1", &["Z3"]);
}

#[test]
fn an_emergence_velocity_with_b_in_place_of_a_is_caught_by_the_simulated_onset() {
    sabotage('N', "2*V_0*sqrt(M*K)/(a*sigma) = 1", "2*V_0*sqrt(M*K)/(b*sigma) = 1", &["N6"]);
}

#[test]
fn a_critical_damping_stress_with_the_wrong_sign_is_caught_by_the_simulated_onset() {
    sabotage('N', "sigma = K*D_c/(sqrt(b) + sqrt(a))^2", "sigma = K*D_c/(sqrt(b) - sqrt(a))^2", &["N11"]);
}

#[test]
fn a_velocity_of_eq_18_with_b_in_place_of_the_difference_is_caught_by_the_simulated_peaks() {
    let altered = "2*V_0*sqrt(M*K)/(b*sigma) = 1";
    sabotage('X', "2*V_0*sqrt(M*K)/(abs(a - b)*sigma) = 1", altered, &["X1", "X2"]);
}
