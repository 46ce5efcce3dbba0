//! The list of hostile inputs, row by row: what each row is, and the test that shows what becomes of it.
//!
//! | row | tests |
//! |---|---|
//! | deep nesting, many dotted keys, many signs | `bad_inputs::toml_that_recurses_or_floods_is_refused_at_once`, `bad_scenes::files_that_are_no_scenes_are_refused` |
//! | files of 10 MB, a string of 50 MB | `bad_inputs::files_beyond_the_cap_are_refused_before_they_are_parsed` |
//! | `1e-400` and what 64-bit numbers cannot hold | `bad_inputs::one_grammar_of_numbers_for_scenes_rows_and_arguments` |
//! | `nan`, `inf`, `0x1p3`, `1@5`, `1,5`, `1/0` | the same, `arguments::values_that_are_no_positive_numbers_are_refused_with_key_value_and_range` |
//! | `1e1000000000`, millions of digits | the same, `bad_points::faulty_cells_are_named_by_row_column_value_and_range` |
//! | zero or negative a, σ, D_c, V | the same |
//! | error bars that are reversed, not smaller than the value, no numbers | `error_bars::faulty_error_bars_are_all_reported_at_once` |
//! | precision 0 and 4 294 967 295 | `bad_inputs::counts_and_digits_of_scenes_state_their_range`, `arguments::counts_and_digits_state_their_range` |
//! | grids of 0, 1, 2^63 − 1 points, ranges from 0 or reversed | `bad_scenes::every_way_to_get_a_scene_wrong_is_named` |
//! | doubled and unknown keys | the same, `bad_inputs::sixty_thousand_unknown_keys_are_told_by_the_first_few` |
//! | byte order mark, CRLF, UTF-16, NUL, U+202E, zero width | `bad_inputs::only_plain_text_is_read` |
//! | names of outputs, equal names | `bad_inputs::names_that_could_leave_their_folder_are_refused`, `reports::doubled_scenes_are_refused_by_file_and_by_name` |
//! | folders that are links, files, read-only or full | `outputs::links_and_devices_are_left_alone`, `outputs::a_folder_replaces_an_earlier_output_and_nothing_else`, `full_disk` |
//! | measured tables and charts: names, axes, cells, links | `bad_inputs::measurements_that_cannot_be_shown_are_refused` |
//! | markup in any text | `bad_inputs::markup_in_titles_and_prose_stays_text`, `report::tests::hostile` |
//! | attributes, scripts, styles, `javascript:` | the same |
//! | Markdown: raw HTML, schemes, heading attributes, remote images | the same, `report::markdown::tests` |
//! | Markdown and formulas nested without end | `bad_inputs::prose_without_end_is_rendered_or_refused_in_time` |
//! | a bar or newline in a Markdown cell | `table::markdown::tests::a_pipe_or_a_newline_in_a_cell_keeps_the_row_whole` |
//! | CSV: unclosed quote, 20 million columns, NUL | `bad_inputs::csv_without_end_is_refused_in_time`, `bad_points::ragged_rows_and_runaway_quotes_are_refused` |
//! | CSV: ragged, missing, doubled, exchanged columns, other units | `bad_points::a_header_is_a_contract`, `bad_inputs::exchanged_columns_are_read_by_name` |
//! | CSV runs: time, V ≤ 0, NaN, one sample, empty | `compare_bad` |
//! | cells that a spreadsheet would run | `bad_points::keep_going_gives_every_row_and_says_which_are_faulty`, `table::csv_text::tests` |
//! | zip: paths, links, bomb, names, checksum, cut, encrypted, 70 000 entries | `bad_archives` |
//! | lemmas on motions: unknown words and systems, missing keys, sizes | `claim_motions::keys_of_a_lemma_that_are_missing_or_wrong_are_refused_where_they_stand` |
//! | equations that divide by zero, or are too large to multiply out | `bad_inputs::equations_without_a_value_or_without_end_are_refused` |
//! | an archive that lies | `archive::a_verdict_is_never_read_from_the_archive`, `archive::an_altered_added_removed_or_renamed_file_is_named` |
//! | an archive altered and sealed again, of this build or another | `tampering::forty_kinds_of_tampering_are_refused_by_name_in_an_archive_of_this_build`, `tampering::forty_kinds_of_tampering_are_refused_by_name_in_an_archive_of_another_build` |
//! | an archive that asks for too much: simulations, digits, points, grids, long numbers, time | `replay_budget` |
//! | a block with a flipped bit in its heading | `sweep_forgeries::a_flipped_bit_in_a_heading_is_damage_of_that_block_and_it_is_computed_again` |
//! | a block with rows, columns or NULs altered and a right digest | `sweep_forgeries::altered_rows_and_columns_with_a_right_digest_are_refused_and_computed_again`, `sweep_forgeries::a_summary_of_other_rows_than_its_points_is_refused` |
//! | `block 0 of 18446744073709551615` | `sweep_forgeries::a_count_of_blocks_that_no_sweep_has_is_refused_at_once` |
//! | a list of points that changes while it is read | `cli::sweep::points::tests::a_list_that_changes_between_two_readings_is_refused` |
//! | an output that is an input, under any of its names | `outputs::an_output_never_overwrites_an_input`, `outputs::a_redirected_input_is_not_overwritten` |
//! | links out of a report; pipes as prose, trajectory, block or scene | `messages::links_out_of_a_report_and_pipes_are_refused` |
//! | points beyond the memory | `messages::more_points_than_memory_holds_are_refused_with_the_memory` |
//! | control characters in ledgers, names, headers and options | `messages::nothing_from_outside_acts_on_the_terminal` |
//! | thousands of faults, values of 100 kB | `messages::many_faults_are_counted_and_long_values_shortened` |
//! | values in the units of a lab book | `messages::every_command_that_takes_the_slider_warns_of_other_units` |
//! | options that exclude each other or do nothing together | `option_pairs::every_option_of_a_pair_acts_or_the_pair_is_refused` |
//! | closed and full streams, full and forbidden places, signals, kills and failures at system calls | `hostile` |

use std::time::{Duration, Instant};

use crate::harness::{Ended, HEADER, ROW, SLIDER, Workplace};

/// The longest that any of these may take, as a test build on a busy machine: the rule itself is two seconds.
const PATIENCE: Duration = Duration::from_secs(20);

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [boundary]\npoints = 3\ndigits = 20\n";

/// Runs the binary and checks that it ended in time and without a panic.
fn in_time<'a>(place: &Workplace, arguments: impl IntoIterator<Item = &'a str>) -> Ended {
    let start = Instant::now();
    let ended = place.run(arguments);
    assert!(start.elapsed() < PATIENCE, "{:?}: {}", start.elapsed(), ended.stderr);
    assert!(!ended.stderr.contains("panicked") && ended.stderr.len() < 20_000, "{}", ended.stderr);
    ended
}

/// Refuses a scene with these words, writing nothing.
fn refuse_scene(content: impl AsRef<[u8]>, parts: &[&str]) {
    let place = Workplace::new();
    place.write("s.toml", content);
    in_time(&place, ["run", "s.toml", "-o", "out"]).expect_refusal(parts);
    assert_eq!(place.names(), ["s.toml"]);
}

#[test]
fn toml_that_recurses_or_floods_is_refused_at_once() {
    let many = 100_000;
    for text in [
        format!("a = {}", "[".repeat(many)),
        format!("a = {}", "{a=".repeat(many)),
        format!("{} = 1", vec!["a"; many].join(".")),
        format!("a = {}", "+".repeat(many)),
    ] {
        refuse_scene(text, &["s.toml:1: not valid TOML"]);
    }
}

#[test]
fn files_beyond_the_cap_are_refused_before_they_are_parsed() {
    refuse_scene("a = 1\n".repeat(1_700_000), &["s.toml: 10200000 bytes (allowed: at most 1048576)"]);
    refuse_scene(
        format!("a = \"{}\"", "x".repeat(50_000_000)),
        &["s.toml: 50000006 bytes (allowed: at most 1048576)"],
    );
}

/// A report that shows measurements of `contents` with these rows.
fn with_measurements(contents: &str, rows: &str) -> Workplace {
    let place = report("R", "[[figure:c]]\n\n[[table:t]]\n");
    place.write("r/report.toml", place.read("r/report.toml") + "[measured]\nfolder = \"m\"\n");
    place.write("r/m/raw.csv", "x\n");
    place.write("r/m/contents.toml", contents);
    place.write("r/m/tables/t.csv", rows);
    place
}

#[test]
fn measurements_that_cannot_be_shown_are_refused() {
    const CONTENTS: &str = "sources = [\"raw.csv\"]\n[[table]]\nid = \"t\"\ntitle = \"T\"\n\
        columns = [{ name = \"a\", header = \"A\" }, { name = \"b\", header = \"B\", unit = \"s\", number = true }]\n\
        [[chart]]\nid = \"c\"\nlabel = \"Figure 1\"\ntitle = \"C\"\ncaption = \"C\"\ndescription = \"C\"\ndata = [\"t\"]\n\
        x = { title = \"n\", from = 1, to = 1000 }\ny = { title = \"t\", from = 1e-3, to = 1e2 }\n\
        series = [{ label = \"s\", points = [[1, 2.5], [10, 50]] }]\n";
    const ROWS: &str = "a,b\nx,1.5\ny,\n";
    in_time(&with_measurements(CONTENTS, ROWS), ["report", "r", "-o", "out"]).expect_success();
    for (from, to, part) in [
        ("\"raw.csv\"", "\"../raw.csv\"", "contents.toml:1: sources[1]"),
        ("id = \"t\"", "id = \"../t\"", "contents.toml:3: table[1].id"),
        ("name = \"b\"", "name = \"a\"", "contents.toml:5: table[1].columns[2].name"),
        ("header = \"B\"", "header = \"\\u202e\"", "character U+202E is not allowed"),
        ("from = 1,", "from = 1e-400,", "contents.toml:13: chart[1].x.from"),
        ("[10, 50]", "[10, 1e400]", "series[1].points[2][2]"),
        ("data = [\"t\"]", "data = [\"other\"]", "there is no table `other`"),
    ] {
        assert!(CONTENTS.contains(from));
        let place = with_measurements(&CONTENTS.replace(from, to), ROWS);
        in_time(&place, ["report", "r", "-o", "out"]).expect_refusal(&[part]);
        assert_eq!(place.names(), ["r"]);
    }
    for (rows, part) in [
        ("a,b\nx,NaN\n", "t.csv:2: b = NaN: out of range (allowed: a number, `inf`, or an empty cell)"),
        ("a,b\nx,<script>\n", "t.csv:2: b = "),
        ("a,b\nx,1,2\n", "t.csv:2: 3 cells"),
        ("b,a\n", "t.csv:1: a: missing column"),
    ] {
        in_time(&with_measurements(CONTENTS, rows), ["report", "r", "-o", "out"]).expect_refusal(&[part]);
    }
}

#[test]
fn one_grammar_of_numbers_for_scenes_rows_and_arguments() {
    let cases = [
        ("1e-400", "out of range"),
        ("1e400", "out of range"),
        ("nan", "not a decimal number"),
        ("inf", "not a decimal number"),
        ("0x1p3", "not a decimal number"),
        ("1@5", "not a decimal number"),
        ("1,5", "not a decimal number"),
        ("_1", "not a decimal number"),
        ("1/0", "a division by zero"),
        ("1e1000000000", "exponent beyond"),
        ("1e-1000000000", "exponent beyond"),
        ("0", "must be > 0"),
        ("-1", "must be > 0"),
    ];
    let long = format!("0.{}", "1".repeat(60_000));
    let place = Workplace::new();
    for (value, problem) in cases.into_iter().chain([(long.as_str(), "more than 10000 digits")]) {
        // Between quotes a number may be anything, so that TOML's own grammar of numbers has no say.
        refuse_scene(SCENE.replace("0.004", &format!("\"{value}\"")), &["direct_effect", problem]);
        place.write("in.csv", format!("{HEADER}\n{}\n", ROW.replacen("0.004", &format!("\"{value}\""), 1)));
        in_time(&place, ["classify", "--points", "in.csv", "-o", "out.csv"])
            .expect_refusal(&["in.csv:2: row 1, column direct_effect", problem]);
        let arguments = SLIDER.iter().map(|&word| if word == "0.004" { value } else { word });
        let point = ["-s", "1e5", "-v", "1e-3"];
        in_time(&place, ["classify"].into_iter().chain(arguments).chain(point))
            .expect_refusal(&["--direct-effect", problem]);
    }
    assert_eq!(place.names(), ["in.csv"]);
}

#[test]
fn counts_and_digits_of_scenes_state_their_range() {
    for value in ["0", "4294967295", "-1", "1.5", "99999999999999999999999"] {
        refuse_scene(
            SCENE.replace("digits = 20", &format!("digits = {value}")),
            &[&format!(
                "boundary.digits = {value}: out of range (allowed: a whole number from 1 to 1000000)"
            )],
        );
    }
    refuse_scene(SCENE.replace("points = 3", "points = 9223372036854775807"), &["limit of 4194304"]);
}

#[test]
fn sixty_thousand_unknown_keys_are_told_by_the_first_few() {
    let keys = |form: &str| (0..60_000).map(|i| form.replace('#', &i.to_string())).collect::<String>();
    refuse_scene(keys("k#=1\n"), &["k0: unknown key"]);
    refuse_scene(keys("[k#]\n"), &["k0: unknown key"]);
}

#[test]
fn only_plain_text_is_read() {
    let place = Workplace::new();
    place.write("s.toml", format!("\u{feff}{}", SCENE.replace('\n', "\r\n")));
    in_time(&place, ["run", "s.toml", "-o", "out"]).expect_success();
    let wide: Vec<u8> = "\u{feff}name".encode_utf16().flat_map(u16::to_le_bytes).collect();
    refuse_scene(wide, &["s.toml:1: UTF-16 text (wanted: UTF-8"]);
    refuse_scene(b"name = \"\xc3\x28\"", &["not UTF-8 text"]);
    for hidden in ['\0', '\u{202e}', '\u{200b}', '\u{2066}'] {
        let code = format!("s.toml:2: character U+{:04X} is not allowed", u32::from(hidden));
        refuse_scene(SCENE.replace("\"S\"", &format!("\"S{hidden}\"")), &[&code]);
    }
}

#[test]
fn names_that_could_leave_their_folder_are_refused() {
    let long = "x".repeat(300);
    for name in ["../../x", "/x", "a\\\\b", "a\\u0000b", "-rf", ".x", "CON", "com1.txt", &long, ""] {
        refuse_scene(SCENE.replace("\"s\"", &format!("\"{name}\"")), &["s.toml:1: name"]);
    }
}

#[test]
fn csv_without_end_is_refused_in_time() {
    let place = Workplace::new();
    let cases = [
        (format!("{HEADER}\n\"{}", "x".repeat(20_000_000)), "row of more than 1048576 bytes"),
        (",".repeat(20_000_000), "more than 1000 cells in a row"),
        (format!("{HEADER}\n{}\n", ROW.replace("1e7", "1\0e7")), "U+0000 is not allowed"),
    ];
    for (text, problem) in cases {
        place.write("in.csv", text);
        in_time(&place, ["classify", "--points", "in.csv", "-o", "out.csv"]).expect_refusal(&[problem]);
        assert_eq!(place.names(), ["in.csv"]);
    }
}

#[test]
fn exchanged_columns_are_read_by_name() {
    let place = Workplace::new();
    let reversed = |line: &str| line.split(',').rev().collect::<Vec<_>>().join(",");
    let answer = |header: &str, row: &str| {
        let text = format!("{header}\n{row}\n");
        let found = place.run_with_input(["classify", "--points", "-"], &text).expect_success();
        let line = found.lines().nth(1).unwrap().to_string();
        line.splitn(8, ',').nth(7).unwrap().to_string()
    };
    assert_eq!(answer(HEADER, ROW), answer(&reversed(HEADER), &reversed(ROW)));
}

const CLAIM: &str = "[[claim]]\nid = \"S1\"\nplace = \"eq 9\"\nwords = \"W\"\nexpected = \"holds\"\n";

/// A report of one scene and one claim with this title and prose.
fn report(title: &str, prose: &str) -> Workplace {
    let place = Workplace::new();
    place.write(
        "r/report.toml",
        format!(
            "name = \"r\"\ntitle = \"{title}\"\nscenes = [\"s\"]\n[[chapter]]\nid = \"c\"\ntitle = \"{title}\"\nprose = \"c.md\"\n"
        ),
    );
    place.write("r/scenes/s.toml", SCENE.replace("\"S\"", &format!("\"{title}\"")));
    place.write("r/prose/c.md", prose);
    place.write("r/claims.toml", CLAIM);
    place.write("r/equations.toml", include_str!("../../reports/im-avouac/equations.toml"));
    place
}

#[test]
fn markup_in_titles_and_prose_stays_text() {
    let hostile = "<img src=x onerror=alert(1)> a|b x onmouseover=y {{ title }} ](javascript:z)";
    // Without a bracket that opens before it, the end of a link is plain text of prose, and stays.
    let words = hostile.replace("](javascript:z)", "");
    let prose = format!(
        "{words}\n\n# h {{onclick=alert(1)}}\n\n<script>alert(1)</script>\n\n[x](javascript:alert(1)) ![r](https://example.org/r.png) \
        [d](data:text/html,x) <svg onload=alert(1)>\n"
    );
    let place = report(hostile, &prose);
    in_time(&place, ["report", "r", "-o", "out"]).expect_success();
    let body = |text: String| text.split("</style>").last().unwrap().to_string();
    let page = body(place.page("out/index.html"));
    for forbidden in ["<img", "<script>alert", "href=\"javascript", "href=\"data:", "<svg onload"] {
        assert!(!page.contains(forbidden), "{forbidden} is in the page");
    }
    for tag in page.split('<').skip(1).filter_map(|part| part.split('>').next()) {
        let outside_quotes: String = tag.split('"').step_by(2).collect();
        for attribute in ["onerror", "onmouseover", "onclick"] {
            assert!(!outside_quotes.contains(attribute), "<{tag}>");
        }
    }
    let markdown = place.read("out/ledger.md");
    for forbidden in ["<img", "<script", "](javascript", "](data:", "![r]"] {
        let bare = markdown.match_indices(forbidden).any(|(at, _)| !markdown[..at].ends_with('\\'));
        assert!(!bare, "{forbidden} is in the Markdown report");
    }
}

#[test]
fn prose_without_end_is_rendered_or_refused_in_time() {
    let fill = |unit: &str| unit.repeat(60_000 / unit.len());
    for prose in [
        format!("{}{}", "<a".repeat(20_000), ">".repeat(20_000)),
        fill("["),
        fill("[a]("),
        format!("{}{}", "![a".repeat(8_000), "](x)".repeat(8_000)),
        fill("*a_"),
        fill("[a]: javascript:x\n"),
    ] {
        let place = report("T", &prose);
        let ended = in_time(&place, ["report", "r", "-o", "out"]);
        assert!(matches!(ended.code, 0 | 2), "{ended:?}");
    }
    for (formula, problem) in [
        (format!("${}x{}$", "\\frac{1}{".repeat(300), "}".repeat(300)), "bytes (allowed: at most 2000)"),
        (format!("${}x{}$", "{".repeat(30_000), "}".repeat(30_000)), "bytes (allowed: at most 2000)"),
        (format!("${}x{}$", "x^{".repeat(200), "}".repeat(200)), "deep (allowed: at most 100)"),
    ] {
        let place = report("T", &formula);
        in_time(&place, ["report", "r", "-o", "out"]).expect_refusal(&["formula", problem]);
        assert_eq!(place.names(), ["r"]);
    }
    let place = report("T", &"x ".repeat(40_000));
    in_time(&place, ["report", "r", "-o", "out"])
        .expect_refusal(&["r/prose/c.md: 80000 bytes (allowed: at most 65536)"]);
}

#[test]
fn equations_without_a_value_or_without_end_are_refused() {
    let place = report("T", "Nothing is placed here.\n");
    let equations = place.read("r/equations.toml");
    let sum = "(a + b + D_c + K + M + sigma + V + V_0 + theta + mu_0)^24";
    let bomb = format!("mu = {sum} - {sum} + mu_0 + a*ln(V/V_0)");
    for (before, after, fault) in [
        ("K_c = (b", "K_c = 0/0 + (b", "equation 9: right side '0/0 + "),
        ("theta' = 1 -", "theta' = 1/0 -", "column 3: '0' is zero"),
        ("theta' = 1 -", "theta' = (V - V)/(V - V) -", "'V - V' is zero"),
        ("omega_n = sqrt(K/M)", "omega_n = sqrt(K/M - 1)", "'K/M - 1' may be negative"),
        ("mu = mu_0 + a*ln(V/V_0)", &bomb, "38567100 terms and degree 24 (allowed: 16 terms, degree 24)"),
    ] {
        assert!(equations.contains(before), "{before}");
        place.write("r/equations.toml", equations.replacen(before, after, 1));
        for command in ["verify", "report"] {
            in_time(&place, [command, "r"]).expect_refusal(&["r/equations.toml", fault]);
        }
    }
}
