//! `sweep` and `merge`: the same bytes from any number of shards.

use std::fs;
use std::process::{Command, Stdio};

use crate::harness::{HEADER, Workplace};

pub const SCENE: &str = "name = \"classes\"\ntitle = \"Classes\"\n[parameters]\ndirect_effect = 0.004\n\
    evolution_effect = 0.006\ncritical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [sweep]\nwork = \"classify\"\nblock_points = 100\n[sweep.grid]\n\
    normal_stress_pa = { from = 1e3, to = 1e7, points = 37 }\n\
    loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 31 }\n";

/// 37 × 31 points in blocks of 100.
pub const BLOCKS: usize = 12;

pub fn workplace() -> Workplace {
    let place = Workplace::new();
    place.write("s.toml", SCENE);
    place
}

/// A folder with all blocks of the scene.
pub fn swept() -> Workplace {
    let place = workplace();
    assert_eq!(place.run(["sweep", "s.toml", "--out", "blocks"]).expect_success(), "");
    place
}

pub fn block(number: usize) -> String {
    format!("blocks/block-{number:09}.csv")
}

pub fn merged(place: &Workplace, folder: &str) -> String {
    place.run(["merge", folder]).expect_success()
}

#[test]
fn any_number_of_shards_in_any_order_makes_the_same_bytes() {
    let place = swept();
    let whole = merged(&place, "blocks");
    assert_eq!(whole.lines().count(), 37 * 31 + 1);
    for (count, order) in
        [(4, vec![2, 0, 3, 1]), (7, vec![6, 1, 0, 5, 2, 4, 3]), (20, (0..20).rev().collect())]
    {
        let out = format!("of-{count}");
        for index in order {
            let shard = format!("{index}/{count}");
            place
                .run(["sweep", "s.toml", "--shard", &shard, "--out", &out, "--threads", "3"])
                .expect_success();
        }
        assert_eq!(merged(&place, &out), whole, "{count} shards");
        place.run(["merge", &out, "-o", "out.csv"]).expect_success();
        assert_eq!(place.read("out.csv"), whole);
    }
}

#[test]
fn a_row_says_what_classify_says_of_the_same_numbers() {
    let place = swept();
    let whole = merged(&place, "blocks");
    let (columns, rows) = whole.split_once('\n').unwrap();
    assert!(columns.starts_with("normal_stress_pa,loading_velocity_m_per_s,transition_sign,"), "{columns}");
    // Powers of ten are the only coordinates whose decimals are their 64-bit numbers; 1e3, 1e5 and 1e-6 are among them.
    let row = rows.lines().find(|row| row.starts_with("100000,1e-6,") || row.starts_with("100000,0.000001,"));
    let found: Vec<&str> = row.unwrap().split(',').skip(2).collect();
    let points = format!("{HEADER}\n0.004,0.006,1e-5,1e7,1000,1e5,1e-6\n");
    let stated = place.run_with_input(["classify", "--points", "-"], &points).expect_success();
    let stated: Vec<&str> = stated.lines().nth(1).unwrap().split(',').skip(7).collect();
    assert_eq!(found[..4], stated[..4]);
}

#[test]
fn missing_blocks_are_refused_with_the_shards_to_run() {
    let place = swept();
    for number in [3, 7, 8, 9] {
        fs::remove_file(place.path(&block(number))).unwrap();
    }
    let refused = place.run(["merge", "blocks", "-o", "out.csv"]);
    assert_eq!((refused.code, refused.stdout.as_str()), (1, ""));
    assert!(
        refused.stderr.contains("4 of 12 blocks are missing; the shards to run, of 12: 3,7-9"),
        "{}",
        refused.stderr
    );
    assert!(!place.path("out.csv").exists());
    assert_eq!(place.run(["merge", "blocks", "--missing"]).expect_success(), "3,7-9\n");
    let of_five = place.run(["merge", "blocks", "--missing", "--shards", "5"]).expect_success();
    assert_eq!(of_five, "2-4\n");
    for shard in ["2/5", "3/5", "4/5"] {
        place.run(["sweep", "s.toml", "--shard", shard, "--out", "blocks"]).expect_success();
    }
    assert_eq!(place.run(["merge", "blocks", "--missing"]).expect_success(), "");
    assert_eq!(merged(&place, "blocks"), merged(&swept(), "blocks"));
}

#[test]
fn sound_blocks_are_not_computed_again() {
    let place = swept();
    let times = |place: &Workplace| -> Vec<_> {
        (0..BLOCKS).map(|n| fs::metadata(place.path(&block(n))).unwrap().modified().unwrap()).collect()
    };
    let before = times(&place);
    place.run(["sweep", "s.toml", "--out", "blocks"]).expect_success();
    assert_eq!(times(&place), before);
    let names = crate::harness::names_in(&place.path("blocks"));
    assert_eq!(names.len(), BLOCKS, "nothing but blocks: {names:?}");
}

#[test]
fn two_copies_of_a_shard_at_once_do_no_harm() {
    let place = workplace();
    let start = || {
        Command::new(env!("CARGO_BIN_EXE_slipmode"))
            .args(["sweep", "s.toml", "--out", "blocks"])
            .current_dir(place.path(""))
            .stdout(Stdio::null())
            .spawn()
            .unwrap()
    };
    let copies = [start(), start(), start()];
    for mut copy in copies {
        assert!(copy.wait().unwrap().success());
    }
    assert_eq!(merged(&place, "blocks"), merged(&swept(), "blocks"));
    assert_eq!(crate::harness::names_in(&place.path("blocks")).len(), BLOCKS);
}

#[test]
fn samples_are_the_same_from_any_shards_and_lists_are_kept_row_by_row() {
    let place = workplace();
    let head = SCENE.split("[sweep.grid]").next().unwrap();
    let samples = "[sweep.samples]\ncount = 1050\nnormal_stress_pa = { from = 1e3, to = 1e7 }\n\
        loading_velocity_m_per_s = { from = 1e-6, to = 1e-1 }\n";
    place.write("samples.toml", format!("{head}{samples}"));
    place.write("list.toml", format!("{head}[sweep.list]\nfile = \"points.csv\"\n"));
    let rows: String =
        (0..250).map(|i| format!("p{i},0.004,0.006,1e-5,1e7,1000,{}e3,1e-3\n", i + 1)).collect();
    place.write("points.csv", format!("name,{HEADER}\n{rows}bad,0.004,0.006,1e-5,1e7,1000,-1,1e-3\n"));
    for (scene, lines) in [("samples", 1051), ("list", 252)] {
        let (file, one, three) = (format!("{scene}.toml"), format!("{scene}-1"), format!("{scene}-3"));
        place.run(["sweep", &file, "--out", &one]);
        for shard in ["2/3", "0/3", "1/3"] {
            place.run(["sweep", &file, "--shard", shard, "--out", &three]);
        }
        let whole = merged(&place, &one);
        assert_eq!(whole.lines().count(), lines, "{scene}");
        assert_eq!(whole, merged(&place, &three), "{scene}");
    }
    let classified = place.run(["classify", "--points", "points.csv", "--keep-going", "-o", "direct.csv"]);
    assert_eq!(classified.code, 0);
    // `classify --points` also appends what follows from these columns: five before the last one.
    let direct = place.read("direct.csv");
    let columns = direct.lines().next().unwrap().split(',').count();
    let without_derived = |line: &str| {
        let cells = line.splitn(columns, ',').enumerate();
        let kept = cells.filter(|(index, _)| !(columns - 6..columns - 1).contains(index));
        kept.map(|(_, cell)| cell).collect::<Vec<_>>().join(",") + "\n"
    };
    assert_eq!(merged(&place, "list-1"), direct.lines().map(without_derived).collect::<String>());
    place.write("points.csv", format!("name,{HEADER}\n{rows}"));
    place.run(["sweep", "list.toml", "--out", "list-1"]).expect_refusal(&["another scene"]);
}

#[test]
fn boundary_and_simulation_are_swept_too() {
    let place = workplace();
    let head = SCENE.split("[sweep]").next().unwrap();
    let grid = "[sweep.grid]\nnormal_stress_pa = { from = 1e5, to = 3e5, points = 3 }\nloading_velocity_m_per_s = 1e-4\n";
    place.write("b.toml", format!("{head}[sweep]\nwork = \"boundary\"\nblock_points = 2\n{grid}"));
    place.write(
        "n.toml",
        format!("{head}[sweep]\nwork = \"simulate\"\nlaws = [\"slip\", \"aging\"]\ntolerance = 1e-4\nblock_points = 4\n{grid}"),
    );
    place.run(["sweep", "b.toml", "--out", "b"]).expect_success();
    place.run(["sweep", "n.toml", "--out", "n"]).expect_success();
    let boundary = merged(&place, "b");
    let first: Vec<&str> = boundary.lines().nth(1).unwrap().split(',').collect();
    // σ = 495198.8198 Pa on the upper arc at 0.1 mm/s, where eq 15 is off by 0.00050479 (`slipmode boundary --at-velocity`).
    assert_eq!((first[1], first[4], first[6]), ("-1", "upper", "eq15"));
    assert!(first[5].starts_with("495198.81") && first[7].starts_with("0.00050479"), "{first:?}");
    let simulated = merged(&place, "n");
    let laws: Vec<&str> = simulated.lines().map(|line| line.split(',').nth(1).unwrap()).collect();
    assert_eq!(laws, ["law", "slip", "aging", "slip", "aging", "slip", "aging"]);
    assert!(simulated.lines().skip(1).all(|line| line.ends_with(",ok")), "{simulated}");
}

#[test]
fn a_plan_counts_and_the_scripts_name_what_they_run() {
    let place = workplace();
    let plan = place.run(["sweep", "s.toml", "--plan", "--minutes", "5"]).expect_success();
    for part in [
        "points                     1147",
        "blocks                     12  (of 100 points)",
        "shards                     1  ",
    ] {
        assert!(plan.contains(part), "{part:?} is not in\n{plan}");
    }
    assert_eq!(place.names(), ["s.toml"], "a plan writes nothing");
    place.run(["sweep", "s.toml", "--slurm", "--shards", "4", "--out", "it's here"]).expect_success();
    assert_eq!(crate::harness::names_in(&place.path("it's here")), ["array.sh", "merge.sh", "submit.sh"]);
    for name in ["array.sh", "merge.sh", "submit.sh"] {
        let script = place.path("it's here").join(name);
        assert!(Command::new("sh").arg("-n").arg(script).status().unwrap().success(), "{name}");
    }
    // What a task of the array does, without a scheduler.
    for task in ["0", "1", "2", "3"] {
        let mut command = Command::new("sh");
        command.arg(place.path("it's here/array.sh")).env("SLURM_ARRAY_TASK_ID", task);
        assert!(command.status().unwrap().success());
    }
    assert!(Command::new("sh").arg(place.path("it's here/merge.sh")).status().unwrap().success());
    assert_eq!(place.read("it's here/merged.csv"), merged(&swept(), "blocks"));
}
