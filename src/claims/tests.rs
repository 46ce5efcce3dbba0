//! Each claim of the first paper's report can fail: by a wrong equation, or by an altered result of a computation.

use rayon::prelude::*;

use super::alterations::{alike, alterations};
use super::ledger::finding_on;
use crate::claims::{Verdict, needs, procedures, resolved_claim, sha256_hex};
use crate::experiments::{Context, Need, Outcome, References, Scene, SceneOutcome, run};
use crate::scene::{ClaimEntry, Limits, read_claims, read_equations};
use slipmode_core::dynamics::{Behaviour, Simulation};
use slipmode_core::number::Ball;
use slipmode_theory::Equations;

/// Alters results.
type Alter = fn(&mut Outcome);

/// The claims that computed results decide and that hold, each with results with which it fails.
const ALTERED: [(&str, Alter); 14] = [
    ("F4", |all| {
        let grids = all.scenes[0].simulations.iter_mut().flat_map(|found| &mut found.grids);
        let courses = grids.flat_map(|(_, grid)| &mut grid.values).filter_map(|point| point.course.as_mut());
        courses.for_each(|course| course.from_start.regularisation.value = 1e6);
    }),
    ("Z1", |all| {
        let found = all.scenes[0].tolerance.iter_mut();
        found.for_each(|found| found.corners.lower_worst_log10 = Ball::from(1));
    }),
    ("N1", |all| last_run(all, 0).behaviour = Behaviour::Decaying),
    ("N5", |all| last_run(all, 0).stress_drop_pa = 1e-30),
    ("N6", |all| {
        let lines = all.scenes[0].onset.iter_mut().flat_map(|found| &mut found.lines);
        lines.for_each(|line| line.boundary_velocity_m_per_s = twice(&line.boundary_velocity_m_per_s));
    }),
    ("N9", |all| last_run(all, 1).behaviour = Behaviour::Periodic),
    ("N11", |all| {
        let lines = all.scenes[0].onset.iter_mut().flat_map(|found| &mut found.stress_lines);
        lines.for_each(|line| line.boundary_pa = twice(&line.boundary_pa));
    }),
    ("N14", |all| {
        let lines = all.scenes[0].onset.iter_mut().flat_map(|found| &mut found.lines);
        lines.flat_map(|line| &mut line.shown).for_each(|run| run.oscillates = true);
    }),
    ("N15", |all| {
        let runs = all.scenes[1].trajectories.iter_mut().flatten();
        runs.filter_map(|run| run.course.as_mut().ok()).for_each(|course| course.moments.clear());
    }),
    ("X1", double_stress_drops),
    ("X2", double_stress_drops),
    ("X4", |all| {
        let families = all.scenes[0].near_transition.iter_mut().flat_map(|found| &mut found.families);
        let edges = families.filter_map(|family| family.edge.as_mut().ok()?.as_mut());
        edges.for_each(|edge| edge.excess *= 2.0);
    }),
    ("X5", |all| {
        let found = all.scenes[0].simulations.iter_mut().flat_map(|found| &mut found.strong_vibrations);
        found.for_each(|run| run.profile.least_friction.value *= 2.0);
    }),
    ("X8", |all| {
        let kicks = all.scenes[0].near_transition.iter_mut().flat_map(|found| &mut found.kicks);
        let peaks = kicks.filter_map(|kick| kick.unstable_log_peak.as_mut());
        peaks.for_each(|ends| *ends = ends.map(|end| end + 1e-4));
    }),
];

/// Those that fail with the paper's own values.
const FAILING: [&str; 12] = ["N2", "N3", "N4", "N7", "N8", "N10", "N12", "N13", "N16", "Z5", "Z7", "Z8"];

fn twice(value: &Ball) -> Ball {
    value.clone() * Ball::from(2)
}

/// The last run of each law's grid: that at the highest loading velocity and normal stress.
fn last_run(all: &mut Outcome, scene: usize) -> &mut Simulation {
    let grids = &mut all.scenes[scene].simulations.as_mut().expect("simulations").grids;
    let values = &mut grids.last_mut().expect("a grid").1.values;
    values.last_mut().and_then(|point| point.simulation.as_mut().ok()).expect("a run")
}

fn double_stress_drops(all: &mut Outcome) {
    let grids = all.scenes[0].simulations.iter_mut().flat_map(|found| &mut found.grids);
    let runs =
        grids.flat_map(|(_, grid)| &mut grid.values).filter_map(|point| point.simulation.as_mut().ok());
    runs.for_each(|run| run.stress_drop_pa *= 2.0);
}

fn paper() -> (Equations, Vec<ClaimEntry>, Vec<Scene>) {
    let equations = include_bytes!("../../reports/im-avouac/equations.toml");
    let equations = read_equations("equations.toml", equations).expect("valid");
    let claims = include_bytes!("../../reports/im-avouac/claims.toml");
    let claims = read_claims("claims.toml", claims, &procedures(), Some(&equations)).expect("valid");
    let scenes = [
        include_bytes!("../../reports/im-avouac/scenes/potentially-unstable.toml").as_slice(),
        include_bytes!("../../reports/im-avouac/scenes/intrinsically-stable.toml").as_slice(),
    ];
    let scenes = scenes.map(|bytes| Scene::parse("scene.toml", bytes, &Limits::default()).expect("valid"));
    (equations, claims, scenes.into())
}

#[test]
fn each_claim_on_computed_results_fails_for_some_of_them() {
    let (equations, claims, scenes) = paper();
    let by_id = |id: &str| claims.iter().find(|claim| claim.id == id).expect("listed");
    let listed: Vec<ClaimEntry> =
        ALTERED.iter().map(|(id, _)| *id).chain(FAILING).map(|id| by_id(id).clone()).collect();
    // Without certificates, so that an altered run contradicts none.
    let needed = needs(&listed).into_iter().filter(|need| *need != Need::Certificates).collect();
    let outcome = run(&scenes, &needed, &References::default(), &|_, _, _| {});
    let verdict =
        |id: &str, outcome: &Outcome| finding_on(by_id(id), &Context::new(&equations, outcome)).verdict;
    let found: Vec<_> = FAILING.into_par_iter().map(|id| (id, verdict(id, &outcome))).collect();
    assert_eq!(found, FAILING.map(|id| (id, Verdict::Fails)));
    let found = ALTERED.into_par_iter().map(|(id, alter)| {
        let mut altered = outcome.clone();
        alter(&mut altered);
        (id, verdict(id, &outcome), verdict(id, &altered))
    });
    let found: Vec<_> = found.collect();
    assert_eq!(found, ALTERED.map(|(id, _)| (id, Verdict::Holds, Verdict::Fails)));
}

#[test]
fn each_claim_about_the_equations_fails_for_some_wrong_equation() {
    let (equations, claims, scenes) = paper();
    let nothing = Outcome { scenes: scenes.into_iter().map(SceneOutcome::new).collect() };
    let pairs = alike(&equations);
    let verdict = |claim: &ClaimEntry, equations: &Equations| {
        finding_on(claim, &Context::new(equations, &nothing).ungated()).verdict
    };
    let computed: Vec<&str> = ALTERED.iter().map(|(id, _)| *id).chain(FAILING).collect();
    let by_equations: Vec<&ClaimEntry> =
        claims.iter().filter(|claim| !computed.contains(&claim.id.as_str())).collect();
    assert_eq!(by_equations.len() + computed.len(), claims.len());
    let cannot_fail = by_equations.into_par_iter().filter(|claim| {
        let digest = sha256_hex(&resolved_claim(claim, &equations));
        let wrong = equations.iter().flat_map(|equation| {
            let all = alterations(equation, &pairs).into_iter();
            all.filter_map(|one| equations.altered(&equation.number, &one.text).ok())
        });
        // No point shows that a formula with i fails: a wrong version of S6 is not proved.
        let wanted = if claim.id == "S6" { Verdict::NotChecked } else { Verdict::Fails };
        let fails = |altered: Equations| {
            sha256_hex(&resolved_claim(claim, &altered)) != digest && verdict(claim, &altered) == wanted
        };
        verdict(claim, &equations) != Verdict::Fails && !wrong.into_iter().any(fails)
    });
    let cannot_fail: Vec<&str> = cannot_fail.map(|claim| claim.id.as_str()).collect();
    assert!(cannot_fail.is_empty(), "{cannot_fail:?}");
}
