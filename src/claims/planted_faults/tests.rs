//! What the claims of the first paper notice.

use rayon::prelude::*;

use super::*;
use crate::claims::procedures;
use crate::experiments::{Outcome, Scene, SceneOutcome};
use crate::scene::{Limits, read_claims, read_equations};
use slipmode_algebra::Expression;
use slipmode_theory::Equations;

/// The first paper's equations, claims and slider, without anything computed.
fn paper() -> (Equations, Vec<ClaimEntry>, Outcome) {
    let equations = include_str!("../../../reports/im-avouac/equations.toml");
    let equations = read_equations("equations.toml", equations.as_bytes()).unwrap();
    let claims = include_str!("../../../reports/im-avouac/claims.toml");
    let claims = read_claims("claims.toml", claims.as_bytes(), &procedures(), Some(&equations)).unwrap();
    let scene = include_bytes!("../../../reports/im-avouac/scenes/potentially-unstable.toml");
    let scene = Scene::parse("scene.toml", scene, &Limits::default()).unwrap();
    (equations, claims, Outcome { scenes: vec![SceneOutcome::new(scene)] })
}

#[test]
fn wrong_equations_are_noticed_by_the_claims_that_rest_on_them() {
    let (equations, claims, nothing) = paper();
    let found = plant_faults(&Context::new(&equations, &nothing).with_claims(&claims));
    assert_eq!(found.len(), 28);
    for one in &found {
        assert!(one.noticed > 0, "{one:#?}");
        assert_eq!(one.planted, one.noticed + one.survivors.len());
    }
    let numbered = found.iter().filter(|one| one.equation.parse::<u32>().is_ok());
    let sum = |(planted, noticed), one: &PlantedFaults| (planted + one.planted, noticed + one.noticed);
    assert_eq!(numbered.fold((0, 0), sum), (209, 209));
    assert_eq!(found.iter().fold((0, 0), sum), (235, 235));
    let of = |number: &str| found.iter().find(|one| one.equation == number).unwrap();
    let noticed = |number: &str, id: &str| of(number).noticed_by.iter().any(|by| by == id);
    assert!(noticed("9", "S2") && noticed("16", "B3"), "{found:#?}");
    // Eqs 15, 16 and 18 are symmetric in a and b, and the ± of eq 23 has no first sign; eq 13 has no such freedom.
    let harmless: Vec<(&str, usize)> = found
        .iter()
        .filter(|one| one.harmless > 0)
        .map(|one| (one.equation.as_str(), one.harmless))
        .collect();
    assert_eq!(harmless, [("15", 1), ("16", 1), ("18", 1), ("23", 1)]);
}

#[test]
fn a_part_is_decided_by_each_equation_that_its_procedure_or_its_proofs_take() {
    let (equations, claims, nothing) = paper();
    let context = Context::new(&equations, &nothing).ungated();
    let pairs = alike(&equations);
    let decided: Vec<Sound> = (claims.iter().flat_map(Sound::parts_of))
        .filter(|sound| sound.part.computed().is_some())
        .map(|sound| sound.decided(&context))
        .filter(|sound| sound.verdicts[0] != Verdict::NotChecked)
        .collect();
    assert!(decided.len() > 15, "{}", decided.len());
    let is_noticed = |sound: &Sound, number: &str| {
        let equation = equations.equation(number);
        let by_rule = alterations(equation, &pairs).into_iter().filter(|change| !change.says_the_same);
        // No rule breaks the symmetry of eq 18 in a and b. Twice a variable everywhere does.
        let twice = |variable: &Symbol| {
            let doubled = Expression::integer(2) * Expression::variable(variable.clone());
            format!(
                "{} = {}",
                equation.left.with(variable.clone(), &doubled),
                equation.right.with(variable.clone(), &doubled)
            )
        };
        let variables = equation.residual().variables();
        let mut texts = by_rule.map(|change| change.text).chain(variables.iter().map(twice));
        texts.any(|text| {
            let altered = equations.altered(number, &text);
            altered.is_ok_and(|one| sound.notices(&Context::new(&one, &nothing).ungated()))
        })
    };
    let unnoticed = |sound: &Sound| {
        let computed = sound.part.computed().unwrap();
        let of_proofs = computed.proofs.iter().flat_map(|id| computed.stated.reached(id, &equations));
        let listed = of_proofs.chain(computed.equations.iter().map(String::as_str));
        let listed = listed.filter(|number| !is_noticed(sound, number));
        listed.map(|number| format!("{} {number}", sound.claim.id)).collect::<Vec<_>>()
    };
    let unnoticed: Vec<String> = decided.par_iter().flat_map(unnoticed).collect();
    assert_eq!(unnoticed, Vec::<String>::new());
}

#[test]
fn every_claim_that_the_equations_decide_notices_a_fault_of_its_own() {
    let (equations, claims, nothing) = paper();
    let context = Context::new(&equations, &nothing).ungated();
    let pairs = alike(&equations);
    let altered: Vec<_> = equations
        .iter()
        .flat_map(|one| alterations(one, &pairs).into_iter().map(|change| (one.number.as_str(), change)))
        .filter(|(_, change)| !change.says_the_same)
        .filter_map(|(number, change)| Some((number, equations.altered(number, &change.text).ok()?)))
        .collect();
    let decided: Vec<Sound> = claims
        .iter()
        .flat_map(Sound::parts_of)
        .map(|sound| sound.decided(&context))
        .filter(|sound| sound.verdicts[0] != Verdict::NotChecked)
        .collect();
    assert!(decided.len() > 30, "{}", decided.len());
    // A part such as "does not depend on K" may be true of every wrong version; the claim has another part that is not.
    let ids: BTreeSet<&str> = decided.iter().map(|sound| sound.claim.id.as_str()).collect();
    let seeing = decided.par_iter().filter(|sound| {
        let is_named = |(number, _): &&(&str, _)| sound.equations.contains(*number);
        let (likely, other): (Vec<_>, Vec<_>) = altered.iter().partition(is_named);
        let seen = |(_, altered): &&(&str, _)| sound.notices(&Context::new(altered, &nothing).ungated());
        likely.iter().any(seen) || other.iter().any(seen)
    });
    let seeing: BTreeSet<&str> = seeing.map(|sound| sound.claim.id.as_str()).collect();
    assert_eq!(ids.difference(&seeing).collect::<Vec<_>>(), Vec::<&&str>::new());
}

#[test]
fn a_claim_whose_proof_names_the_equation_notices_each_wrong_version() {
    let (equations, claims, nothing) = paper();
    let sound = sound_claims(&Context::new(&equations, &nothing).ungated().with_claims(&claims));
    let versions: Vec<(&str, &str)> =
        WRONG.iter().flat_map(|(number, texts)| texts.iter().map(move |text| (*number, *text))).collect();
    let unseen = versions.into_par_iter().filter(|(number, text)| {
        let altered = equations.altered(number, text).unwrap();
        let altered = Context::new(&altered, &nothing).ungated();
        let mut naming: Vec<&Sound> =
            sound.iter().filter(|sound| sound.equations.contains(*number)).collect();
        naming.sort_by_key(|sound| sound.steps);
        !naming.iter().any(|sound| sound.notices(&altered))
    });
    assert_eq!(unseen.collect::<Vec<_>>(), []);
}

/// Wrong signs and wrong factors of each equation, a negative velocity, and a load point that runs away.
const WRONG: [(&str, &[&str]); 28] = [
    (
        "1",
        &["mu = mu_0 - a*ln(V/V_0) + b*ln(V_0*theta/D_c)", "mu = mu_0 + a*ln(V/V_0) + 2*b*ln(V_0*theta/D_c)"],
    ),
    ("2", &["theta' = 1 + V*theta/D_c", "theta' = 1 - 2*V*theta/D_c"]),
    ("3", &["theta' = V*theta/D_c*ln(V*theta/D_c)", "theta' = -2*V*theta/D_c*ln(V*theta/D_c)"]),
    (
        "4",
        &[
            "M*delta''/sigma = -K*(V_0*t - delta)/sigma - mu",
            "M*delta/sigma = K*(V_0*t - delta)/sigma - mu",
            "M*delta''/sigma = K*(-V_0*t - delta)/sigma - mu",
            "M*delta''/sigma = K*(2*V_0*t - delta)/sigma - mu",
        ],
    ),
    (
        "5",
        &[
            "M*Delta_delta''/sigma + K*Delta_delta/sigma - a*Delta_delta'/V_0 + b*V_0*Delta_theta/D_c = 0",
            "M*Delta_delta''/sigma + K*Delta_delta/sigma + a*Delta_delta'/V_0 + b*Delta_theta/D_c = 0",
        ],
    ),
    (
        "6",
        &[
            "Delta_theta' = V_0/D_c*Delta_theta - 1/V_0*Delta_delta'",
            "Delta_theta' = -V_0/D_c*Delta_theta - 2/V_0*Delta_delta'",
        ],
    ),
    (
        "7",
        &[
            "M/sigma*Delta_theta'' + (a/V_0 + M*V_0/(sigma*D_c))*Delta_theta'' + (K/sigma + (a - b)/D_c)*Delta_theta' \
             + K*V_0/(sigma*D_c)*Delta_theta' = 0",
            "M/sigma*Delta_theta''' + (a/V_0 + M*V_0/(sigma*D_c))*Delta_theta'' + (K/sigma + (b - a)/D_c)*Delta_theta' \
             + K*V_0/(sigma*D_c)*Delta_theta = 0",
        ],
    ),
    (
        "8",
        &[
            "M/sigma*s^3 + (a/V_0 + M*V_0/(sigma*D_c))*s^2 + (K/sigma - (a - b)/D_c)*s + K*V_0/(sigma*D_c) = 0",
            "M/sigma*s^3 + (a/V_0 + 2*M*V_0/(sigma*D_c))*s^2 + (K/sigma + (a - b)/D_c)*s + K*V_0/(sigma*D_c) = 0",
        ],
    ),
    (
        "9",
        &[
            "K_c = (a - b)*sigma/D_c*(1 + M*V_0^2/(sigma*a*D_c))",
            "K_c = (b - a)*sigma/D_c*(1 + M*V_0^2/(sigma*b*D_c))",
        ],
    ),
    ("10", &["K_c_qs = (a - b)*sigma/D_c", "K_c_qs = 2*(b - a)*sigma/D_c"]),
    ("11", &["K_c_dyn = (a - b)/a*M*V_0^2/D_c^2", "K_c_dyn = (b - a)/a*M*V_0^2/D_c"]),
    ("12", &["sigma_c = K*D_c/(a - b)", "sigma_c = 2*K*D_c/(b - a)"]),
    ("13", &["V_c = -D_c*sqrt(a/(b - a))*sqrt(K/M)", "V_c = D_c*sqrt(b/(b - a))*sqrt(K/M)"]),
    (
        "14",
        &[
            "a/V_0*s^2 + (K/sigma - (a - b)/D_c)*s + K*V_0/(sigma*D_c) = 0",
            "a/V_0*s^2 + (K/sigma + (a - b)/D_c)*s + 2*K*V_0/(sigma*D_c) = 0",
        ],
    ),
    ("15", &["sigma = K*D_c/(sqrt(b) + sqrt(a))^2", "sigma = 2*K*D_c/(sqrt(b) - sqrt(a))^2"]),
    ("16", &["sigma = K*D_c/(sqrt(b) - sqrt(a))^2", "sigma = -K*D_c/(sqrt(b) + sqrt(a))^2"]),
    ("17", &["M*s^2 - (a - b)*sigma/V_0*s + K = 0", "M*s^2 + a*sigma/V_0*s + K = 0"]),
    (
        "18",
        &[
            "2*V_0*sqrt(M*K)/(abs(a + b)*sigma) = 1",
            "V_0*sqrt(M*K)/(abs(a - b)*sigma) = 1",
            "-2*V_0*sqrt(M*K)/(abs(a - b)*sigma) = 1",
            "2*V_0*sqrt(M*K)/(abs(a - b)*sigma) = -1",
        ],
    ),
    ("19", &["M*s^2 - a*sigma/V_0*s + K = 0", "M*s^2 + (a - b)*sigma/V_0*s + K = 0"]),
    (
        "20",
        &[
            "2*V_0*sqrt(M*K)/(b*sigma) = 1",
            "V_0*sqrt(M*K)/(a*sigma) = 1",
            "2*V_0*sqrt(M*K)/(a*sigma) = -1",
            "-2*V_0*sqrt(M*K)/(a*sigma) = 1",
        ],
    ),
    ("21", &["M*s^2 - K = 0", "M*s^2 + 2*K = 0"]),
    ("22", &["M*s^3 + M*V_0/D_c*s^2 - K*s + K*V_0/D_c = 0", "M*s^3 + 2*M*V_0/D_c*s^2 + K*s + K*V_0/D_c = 0"]),
    ("23", &["s = ±sqrt((b - a)/a)*V_0/D_c", "s = ±i*sqrt((b - a)/b)*V_0/D_c"]),
    ("steady-state", &["theta_ss = 2*D_c/V", "theta_ss = V/D_c"]),
    ("steady-friction", &["mu_ss = mu_0 + (b - a)*ln(V/V_0)", "mu_ss = mu_0 + 2*(a - b)*ln(V/V_0)"]),
    ("natural-frequency", &["omega_n = sqrt(M/K)", "omega_n = 2*sqrt(K/M)"]),
    ("inertial-parameter", &["eta = -M*V_0^2/(sigma*a*D_c)", "eta = M*V_0^2/(sigma*b*D_c)"]),
    (
        "regularised",
        &[
            "mu = a*asinh(V/V_0*exp((mu_0 + b*ln(V_0*theta/D_c))/a))",
            "mu = a*asinh(V/(2*V_0)*exp((mu_0 - b*ln(V_0*theta/D_c))/a))",
        ],
    ),
];
