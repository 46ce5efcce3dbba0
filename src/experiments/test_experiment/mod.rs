//! An experiment of the tests: this folder and one line of the registry take it from a scene to a table.

mod run;
mod tables;

use crate::experiments::{Work, experiment};
use crate::scene::AllowedRange;
use run::quasi_static_critical_stiffness;
use slipmode_core::number::Rational;

experiment! {
    /// `[test_experiment]`.
    pub struct TestExperimentSection {
        /// Normal stresses, Pa.
        pub normal_stress_pa: Vec<Rational> = |section, key| {
            section.decimals(key, "a list of normal stresses in Pa", AllowedRange::PHYSICAL)
        },
    }
    requires: CriticalNormalStress,
    outcome: Vec<Rational>,
    tables: [tables::TABLES],
    work: |_| Work::on_a_file(),
    run: |section, earlier, _| Some(quasi_static_critical_stiffness(earlier.slider()?, section)),
}

mod tests {
    use std::cell::RefCell;

    use crate::experiments::{Context, Need, References, Scene, run, table_makers};
    use crate::scene::{Limits, Problem, read_equations};

    const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\n\
        evolution_effect = 0.006\ncritical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\n\
        mass_per_area_kg_per_m2 = 1000\n[test_experiment]\nnormal_stress_pa = [1e5, 2e5]\n";

    fn scene(text: &str) -> Result<Scene, Vec<Problem>> {
        Scene::parse("s.toml", text.as_bytes(), &Limits::default())
            .map_err(|faults| faults.into_iter().map(|fault| fault.problem).collect())
    }

    #[test]
    fn one_folder_and_one_line_lead_from_a_scene_to_a_table() {
        let maker = table_makers().find(|maker| maker.id == "test-experiment").unwrap();
        let needs = maker.needs.iter().copied().collect();
        let items = RefCell::new(Vec::new());
        let progress = |id: &str, _: usize, _: usize| items.borrow_mut().push(id.to_owned());
        let outcome = run(&[scene(SCENE).unwrap()], &needs, &References::default(), &progress);
        assert_eq!(*items.borrow(), ["s/test-experiment"]);
        let equations = include_bytes!("../../../reports/im-avouac/equations.toml");
        let equations = read_equations("equations.toml", equations).unwrap();
        let table = (maker.make)(&Context::new(&equations, &outcome)).unwrap();
        let rows: Vec<String> = table.to_csv().lines().skip(1).map(str::to_owned).collect();
        assert_eq!(rows, ["2e7", "4e7"]);
    }

    #[test]
    fn what_the_section_requires_is_checked_and_what_nothing_requires_is_not_computed() {
        assert!(!Need::TestExperiment.is_stated_by(&scene(SCENE.split("[test").next().unwrap()).unwrap()));
        let stable = SCENE.replace("0.006", "0.004");
        assert_eq!(scene(&stable).unwrap_err(), [Problem::NoCriticalNormalStress]);
        let head = SCENE.split("[parameters]").next().unwrap();
        let alone = format!("{head}[test_experiment]\nnormal_stress_pa = [1e5]\n");
        assert!(matches!(scene(&alone).unwrap_err()[..], [Problem::Needs(_)]));
        let nothing =
            run(&[scene(SCENE).unwrap()], &[Need::Map].into(), &References::default(), &|_, _, _| {});
        assert!(nothing.scenes[0].test_experiment.is_none());
    }
}
