//! Messages and warnings: the right file, the whole truth about units, short values, no character that acts on a terminal.

use std::fs;

use crate::harness::{HEADER, ROW, SLIDER, Workplace};

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [boundary]\npoints = 3\ndigits = 20\n";

/// A small report with this prose.
fn small_report(prose: &str) -> Workplace {
    let place = Workplace::new();
    place.write(
        "small/report.toml",
        "name = \"small\"\ntitle = \"Small\"\nscenes = [\"s\"]\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n",
    );
    place.write("small/scenes/s.toml", SCENE);
    place.write("small/prose/c.md", prose);
    place.write(
        "small/claims.toml",
        "[[claim]]\nid = \"S1\"\nplace = \"eq 9\"\nwords = \"W\"\nexpected = \"holds\"\n",
    );
    place.write("small/equations.toml", include_str!("../../reports/im-avouac/equations.toml"));
    place
}

/// The slider as a lab book has it, one value at a time, and the words of the warning.
const LAB_BOOK: [(&str, &str, &str); 7] = [
    ("-a", "4", "direct_effect = 4: looks like thousandths"),
    ("-d", "0.01", "critical_slip_distance_m = 0.01: looks like mm"),
    ("-d", "10", "critical_slip_distance_m = 10: looks like um"),
    ("-k", "10", "stiffness_pa_per_m = 10: looks like MPa/mm or MPa/m"),
    ("-m", "5", "mass_per_area_kg_per_m2 = 5: looks like kg"),
    ("-s", "5", "normal_stress_pa = 5: looks like MPa"),
    ("-v", "10", "loading_velocity_m_per_s = 10: looks like um/s"),
];

/// The arguments with the value after an option replaced.
fn with<'a>(arguments: &[&'a str], option: &str, value: &'a str) -> Vec<&'a str> {
    let mut arguments = arguments.to_vec();
    let at = arguments.iter().position(|word| *word == option).unwrap();
    arguments[at + 1] = value;
    arguments
}

#[test]
fn every_command_that_takes_the_slider_warns_of_other_units() {
    let place = Workplace::new();
    let point = [&SLIDER[..], &["-s", "1e5", "-v", "1e-3"]].concat();
    for (option, value, words) in LAB_BOOK {
        let mut commands = Vec::new();
        if !["-s", "-v"].contains(&option) {
            let slider = with(&SLIDER, option, value);
            commands.push([&["boundary", "--points", "3"], &slider[..]].concat());
            commands.push([&["tolerance"], &slider[..]].concat());
            let grid = ["--grid-loading-velocity", "1e-5:1e-1:3", "--grid-normal-stress", "1e3:1e7:3"];
            commands.push([&["classify"], &slider[..], &grid[..]].concat());
        }
        let point = with(&point, option, value);
        for command in ["classify", "roots"] {
            commands.push([&[command], &point[..]].concat());
        }
        for arguments in commands {
            let ended = place.run(arguments.iter().copied());
            assert!(ended.stderr.contains(&format!("warning: {words}")), "{arguments:?}: {}", ended.stderr);
            assert_eq!(ended.code, 0, "{arguments:?}");
        }
        let values: Vec<&str> = point.iter().skip(1).step_by(2).copied().collect();
        place.write("in.csv", format!("{HEADER}\n{ROW}\n{}\n", values.join(",")));
        for command in
            [&["classify", "--points", "in.csv"][..], &["simulate", "--law", "slip", "--points", "in.csv"]]
        {
            let ended = place.run(command.iter().copied());
            let wanted = format!("warning: row 2: {words}");
            assert!(ended.stderr.contains(&wanted), "{command:?}: {}", ended.stderr);
            assert!(ended.stderr.contains("of 2 rows have a warning"), "{}", ended.stderr);
        }
    }
    let silent = [&["classify"], &point[..]].concat();
    place.run(silent.iter().copied()).expect_success();
}

#[test]
fn on_the_transition_the_mode_is_neutral_and_said_what_that_means() {
    let place = Workplace::new();
    // K = (b - a) sigma/D_c (1 + M V0^2/(sigma a D_c)) exactly: 2e7 (1 + 0.25) = 2.5e7.
    let on =
        ["-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "2.5e7", "-m", "1000", "-s", "1e5", "-v", "1e-3"];
    let text = place.run(["classify"].iter().chain(&on).copied()).expect_success();
    assert!(text.contains("slip mode                  neutral  (neither grows nor decays"), "{text}");
    let json = place.run(["classify", "--json"].iter().chain(&on).copied()).expect_success();
    for line in ["\"slip_mode\": \"neutral\"", "\"spectral_class\": \"neutral\"", "\"transition_sign\": 0"] {
        assert!(json.contains(line), "{json}");
    }
    place.write("in.csv", format!("{HEADER}\n0.004,0.006,1e-5,2.5e7,1000,1e5,1e-3\n"));
    let rows = place.run(["classify", "--points", "in.csv"]).expect_success();
    assert!(rows.lines().nth(1).unwrap().contains(",0,-1,neutral,neutral,"), "{rows}");
}

#[test]
fn a_boundary_has_all_the_digits_that_were_requested_in_every_column() {
    let place = Workplace::new();
    let arguments = ["boundary"].iter().chain(&SLIDER).chain(&["--digits", "40", "--points", "5"]);
    let csv = place.run(arguments.copied()).expect_success();
    for row in csv.lines().skip(1) {
        for cell in row.split(',') {
            let mantissa = cell.trim_start_matches('-').split('e').next().unwrap();
            let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
            let significant =
                mantissa.trim_start_matches(['0', '.']).bytes().filter(u8::is_ascii_digit).count();
            let is_word = cell.bytes().next().is_none_or(|byte| byte.is_ascii_alphabetic());
            let is_exact = digits < 20;
            assert!(is_word || is_exact || significant >= 38, "{cell} in {row}");
        }
    }
}

#[test]
fn more_points_than_memory_holds_are_refused_with_the_memory() {
    let place = Workplace::new();
    let many = ["--points", "4294967295", "--max-points", "4294967295"];
    place.run(["boundary"].iter().chain(&SLIDER).chain(&many).copied()).expect_refusal(&[
        "--points = 4294967295: needs about",
        "GB of memory",
        "available",
    ]);
}

#[test]
fn nothing_from_outside_acts_on_the_terminal() {
    let place = Workplace::new();
    let hostile = "\u{1b}[31mred\u{202e}";
    let ledger = |verdict: &str| {
        format!(
            "{{\"report\": \"r\", \"claims\": [{{\"id\": \"S1{}\", \"verdict\": \"{verdict}\", \"strength\": \"exact\"}}]}}",
            "\\u001b[31m\\u202e"
        )
    };
    place.write("a.json", ledger("holds"));
    place.write("b.json", ledger("fails"));
    place.write("bad.json", format!("{{\"{hostile}\": "));
    place.write("s.toml", SCENE.replace("name", &format!("\"{}\"", "\\u001b[31m\\u202e")));
    place.write("in.csv", format!("{HEADER},{hostile}\n{ROW}\n"));
    let name = format!("no-such-{hostile}");
    for arguments in [
        &["diff", "a.json", "b.json"][..],
        &["diff", "a.json", "bad.json"],
        &["diff", "a.json", &name],
        &["run", "s.toml"],
        &["run", &name],
        &["classify", "--points", "in.csv"],
        &["classify", "--points", &name],
        &["classify", "-a", hostile],
        &["simulate", "--law", hostile],
        &["verify", &name],
        &["merge", &name],
        &["new", hostile],
    ] {
        let ended = place.run(arguments.iter().copied());
        assert!(ended.code > 0, "{arguments:?}");
        for text in [&ended.stdout, &ended.stderr] {
            assert!(!text.contains(['\u{1b}', '\u{202e}']), "{arguments:?}: {text:?}");
        }
    }
}

#[test]
fn many_faults_are_counted_and_long_values_shortened() {
    let place = small_report("Words.\n");
    let chapter =
        |index: u32| format!("[[chapter]]\nid = \"c{index}\"\ntitle = \"C\"\nprose = \"c{index}.md\"\n");
    let chapters: String = (0..5_000).map(chapter).collect();
    place.write(
        "small/report.toml",
        format!("name = \"small\"\ntitle = \"Small\"\nscenes = [\"s\"]\n{chapters}"),
    );
    let ended = place.run(["report", "small", "-o", "out"]);
    assert!(ended.code == 2 && ended.stderr.chars().count() < 1_500, "{}", ended.stderr);
    assert!(ended.stderr.contains("\nerror: and at least 49"), "{}", ended.stderr);
    let long = "x".repeat(100_000);
    for arguments in
        [&["simulate", "--law", &long][..], &["verify", "small", "--claim", &long], &["new", &long]]
    {
        let ended = place.run(arguments.iter().copied());
        assert!(ended.code == 2 && ended.stderr.chars().count() < 1_500, "{}", ended.stderr);
    }
}

/// Formulas, names, lists of faults and arguments without bound: one short message with the reason, and exit code 2.
#[test]
fn messages_stay_short_whatever_they_repeat() {
    let given = "[assumptions]\npositive = [\"a\", \"b\", \"x\"]\n";
    let equation =
        |number: usize, text: &str| format!("[[equation]]\nnumber = \"{number}\"\nequation = \"{text}\"\n");
    let equations = |text: &str| format!("{given}{}{}", equation(1, "q = a + b"), equation(2, text));
    let sound = equations("r = a");
    let claim = |formula: &str| {
        format!(
            "[[claim]]\nid = \"C1\"\nplace = \"p\"\nwords = \"w\"\nexpected = \"holds\"\nleaves_out = \"nothing\"\n\
             formula = \"{formula}\"\n"
        )
    };
    let nested = |open: &str, count: usize| format!("{}a{}", open.repeat(count), ")".repeat(count));
    let many_sums: String = (2..60).map(|n| equation(n, &format!("q_{n} = a + b*x^{}", n % 20))).collect();
    let units = format!("{given}{many_sums}[units]\na = \"Pa\"\nb = \"m\"\nx = \"1\"\n");
    let strangers: String = (0..500).map(|n| format!("y_{n} = \"Pa\"\n")).collect();
    let powers: Vec<String> = (0..50).map(|n| format!("a^{n}*b^{}", 50 - n)).collect();
    for (equations, claims, reason) in [
        (sound.clone(), claim(&format!("{} > 0", nested("(", 6_000))), "claim[1].formula = "),
        (sound.clone(), claim(&format!("{} > 0", nested("sqrt(a + ", 350))), "claim[1].formula = "),
        (sound.clone(), claim(&format!("{} > 0", "y".repeat(2_000))), "is no variable"),
        (sound.clone(), claim(&format!("({})^12 > 0", powers.join(" + "))), "is too large"),
        (equations(&format!("r = {}", nested("(", 5_000))), claim("a > 0"), "equation 2: right side '((("),
        (
            equations(&format!("r = {})", "a + ".repeat(2_000))),
            claim("a > 0"),
            "equation 2: right side 'a + a",
        ),
        (units, claim("a > 0"), "error: and at least "),
        (format!("{sound}[units]\n{strangers}"), claim("a > 0"), "error: and at least "),
        (sound.clone(), claim("a > 0").repeat(300), "error: and at least "),
    ] {
        let ended = Workplace::with_report(&equations, &claims, "Words.\n").run(["verify", "r"]);
        let length = ended.stderr.chars().count();
        assert!(length < 1_500, "{length} characters: {}", ended.stderr);
        ended.expect_refusal(&[reason]);
    }
    let long = "x".repeat(90_000);
    let option = format!("--{long}");
    let place = Workplace::new();
    place.write("s.toml", format!("{long} = 1\n{}", "[a]\n".repeat(300)));
    place.write("in.csv", format!("{HEADER},{}\n", &long[..60_000]));
    for arguments in [
        &["classify", option.as_str()][..],
        &[long.as_str()],
        &["classify", "-a", &long],
        &["classify", "--points", &long],
        &["run", "s.toml", "-o", "out"],
        &["run", &long[..200], "-o", "out"],
        &["compare", "--runs", "in.csv"],
        &["solve", "--for", &long],
        &["boundary", "--at-velocity", &long],
    ] {
        let ended = place.run(arguments.iter().copied());
        let length = ended.stderr.chars().count();
        assert!(ended.code == 2 && length > 0 && length < 1_500, "{length} characters: {}", ended.stderr);
    }
}

#[test]
fn headers_values_and_equations_are_named_as_they_stand() {
    let place = small_report("Words.\n");
    place.write("in.csv", format!("{}\n{ROW}\n", HEADER.replace("direct_effect", "direct efect")));
    place.run(["classify", "--points", "in.csv"]).expect_refusal(&[
        "column direct_effect: missing column; did you mean it by `direct efect`? (allowed: direct_effect, a)",
    ]);
    place.run(["simulate", "--law", ""]).expect_refusal(&["--law = \"\": unknown"]);
    place.run(["simulate", "--law", "no law"]).expect_refusal(&["--law = \"no law\": unknown"]);
    let equations = include_str!("../../reports/im-avouac/equations.toml").replacen("note =", "nota =", 1);
    let line = equations.lines().position(|line| line.starts_with("nota")).unwrap() + 1;
    place.write("small/equations.toml", &equations);
    let ended = place.run(["report", "small", "-o", "out"]);
    let start = format!("error: small/equations.toml:{line}: ");
    assert!(ended.code == 2 && ended.stderr.starts_with(&start), "{}", ended.stderr);
    assert_eq!(ended.stderr.lines().count(), 1, "{}", ended.stderr);
}

#[test]
fn a_formula_of_prose_is_named_by_file_and_line_before_anything_is_computed() {
    let place = small_report("Words.\n\nA formula: $\\frac{a}$ here.\n");
    // A claim that would take minutes: the fault is found before it.
    place.run(["report", "small", "-o", "out"]).expect_refusal(&["small/prose/c.md:3: formula: "]);
    assert_eq!(place.names(), ["small"]);
}

#[test]
fn a_name_too_long_for_its_scene_is_refused_before_anything_is_computed() {
    let place = Workplace::new();
    let name = "n".repeat(98);
    place.run(["new", name.as_str()]).expect_refusal(&["NAME = ", "1 to 100 characters"]);
    assert!(place.names().is_empty());
}

#[test]
fn commands_that_messages_and_pages_print_work_for_the_reader() {
    let place = small_report("Words.\n");
    place.run(["report", "small", "-o", "out"]).expect_success();
    let page = place.read("out/ledger.md");
    assert!(page.contains("slipmode verify small --claim S1"), "{page}");
    place.run("verify small --claim S1".split(' ')).expect_success();
    fs::create_dir(place.path("small/published")).unwrap();
    place.write("small/published/ledger.json", "{}");
    let ended = place.run(["verify", "small", "-o", "out"]);
    assert!(ended.code == 1 && !ended.stderr.contains("xtask"), "{}", ended.stderr);
    let advice = ended.stderr.split('`').nth(1).unwrap().replace("NEW", "new");
    place.run(advice.split(' ').skip(1)).expect_success();
    assert!(place.path("new/ledger.json").is_file());
}

#[cfg(unix)]
#[test]
fn links_out_of_a_report_and_pipes_are_refused() {
    use std::os::unix::fs::symlink;
    let fifo = |place: &Workplace, name: &str| {
        let made = std::process::Command::new("mkfifo").arg(place.path(name)).status().unwrap();
        assert!(made.success());
    };
    let place = small_report("Words.\n");
    place.write("secret.md", "secret");
    fs::remove_file(place.path("small/prose/c.md")).unwrap();
    symlink("../../secret.md", place.path("small/prose/c.md")).unwrap();
    for command in [&["report", "small", "-o", "out"][..], &["archive", "small", "-o", "out.zip"]] {
        place
            .run(command.iter().copied())
            .expect_refusal(&["small/prose/c.md", "is a link that leads out of small"]);
    }
    fs::remove_file(place.path("small/prose/c.md")).unwrap();
    place.write("small/prose/inside.md", "Inside.\n");
    symlink("inside.md", place.path("small/prose/c.md")).unwrap();
    place.run(["report", "small", "-o", "out"]).expect_success();
    fs::remove_file(place.path("small/prose/c.md")).unwrap();
    fifo(&place, "small/prose/c.md");
    let refused = "is a pipe or a device (wanted: a regular file)";
    place.run(["report", "small", "-o", "out"]).expect_refusal(&["small/prose/c.md", refused]);
    fifo(&place, "t.csv");
    place.write("runs.csv", format!("{HEADER},trajectory\n{ROW},t.csv\n"));
    place.run(["compare", "--runs", "runs.csv"]).expect_refusal(&["t.csv", refused]);
    fs::create_dir(place.path("blocks")).unwrap();
    fifo(&place, "blocks/block-000000000.csv");
    let ended = place.run(["merge", "blocks"]);
    assert_eq!(ended.code, 2, "{}", ended.stderr);
    fifo(&place, "scene.toml");
    place.run(["run", "scene.toml"]).expect_refusal(&["scene.toml", refused]);
}

#[test]
fn one_thing_is_not_several() {
    let place = Workplace::new();
    place.write("runs.csv", format!("{HEADER},peak_velocity_m_per_s\n{ROW},123\n"));
    let ended = place.run(["compare", "--runs", "runs.csv"]);
    assert!(ended.stdout.contains("\n1 row: ") && ended.stderr.contains("of 1 row, "), "{ended:?}");
    assert!(!format!("{ended:?}").contains("1 rows"), "{ended:?}");
}

#[test]
fn a_message_does_not_combine_what_it_refuses_to_combine() {
    let place = Workplace::new();
    let ended = place.run(["classify", "--json", "--points", "in.csv"]);
    assert_eq!(ended.code, 2);
    assert!(
        ended.stderr.contains("cannot be used with") && !ended.stderr.contains("Usage:"),
        "{}",
        ended.stderr
    );
}
