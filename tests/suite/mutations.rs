//! Valid inputs with a few bytes changed, the same ones every time, compared with what every reader promises.

use slipmode::archive::{Files, ReleaseTime, pack};

use crate::csv_promises;
use crate::mutation::hold;
use crate::promises;

#[test]
fn changed_numbers_are_refused_or_read_as_written() {
    hold(promises::number, &[b"0.004", b"-1.5e-3", b"+.5E2", b"123456789.000001e300", b"7e10000"], 5_000);
}

#[test]
fn changed_scenes_are_refused_or_read_as_written() {
    let scenes = [
        include_str!("../../reports/im-avouac/scenes/potentially-unstable.toml"),
        include_str!("../../reports/im-avouac/scenes/effect-ratio-sweep.toml"),
    ];
    hold(promises::scene, &scenes.map(str::as_bytes), 400);
}

#[test]
fn changed_expressions_are_refused_or_print_as_they_read() {
    let expressions: [&[u8]; 4] = [
        b"(b - a)*sigma/D_c*(1 + M*V_0^2/(sigma*a*D_c))",
        b"-V*theta/D_c*ln(V*theta/D_c)",
        b"a*asinh(V/(2*V_0)*exp((mu_0 + b*ln(V_0*theta/D_c))/a))",
        b"\xc2\xb1i*sqrt((b - a)/a)*V_0/D_c",
    ];
    hold(promises::expression, &expressions, 4_000);
    let another = include_bytes!("../../reports/rice-ruina-1983/equations.toml");
    hold(promises::equations, &[include_bytes!("../../reports/im-avouac/equations.toml"), another], 60);
}

#[test]
fn changed_claims_and_plans_are_refused_or_read_as_written() {
    let files: [&[u8]; 2] = [
        include_bytes!("../../reports/rock-friction/claims.toml"),
        include_bytes!("../../reports/rock-friction/report.toml"),
    ];
    hold(promises::ledger, &files, 400);
}

#[test]
fn changed_measurements_are_refused_or_shown_as_read() {
    let contents = "sources = [\"raw.csv\"]\n[[table]]\nid = \"t\"\ntitle = \"T\"\n\
        columns = [{ name = \"a\", header = \"A\" }, { name = \"b\", header = \"B\", unit = \"s\", number = true }]\n\
        [[chart]]\nid = \"c\"\nlabel = \"Figure 1\"\ntitle = \"C\"\ncaption = \"C\"\ndescription = \"C\"\ndata = [\"t\"]\n\
        x = { title = \"n\", from = 1, to = 1000 }\ny = { title = \"t\", unit = \"s\", from = 1e-3, to = 1e2 }\n\
        series = [{ label = \"s\", points = [[1, 2.5], [10, 50]] }]\nverticals = [{ at = 2, label = \"v\" }]\n";
    hold(promises::measured, &[format!("{contents}\0a,b\nx,1.5e-3\n\"y, z\",\n").as_bytes()], 2_000);
}

#[test]
fn changed_prose_stays_prose() {
    let prose = [
        "# A *heading* {onclick=x}\n\n[a](https://example.org) <b>raw</b> ![i](x.png) `code`\n\n- one\n- two\n",
        "Inline $\\sqrt{K/M}$ and\n\n$$\\frac{a}{b}$$\n\n| a | b |\n| - | -: |\n| 1 | 2 |\n",
        "[j](javascript:x) <script>x</script> <https://example.org> [d](data:x)\n> quoted\n\n```\nfenced\n```\n",
    ];
    hold(promises::prose, &prose.map(str::as_bytes), 150);
}

/// Found by fuzzing: a short text that had a table of proofs made, for longer than a reader may take.
#[test]
fn prose_that_places_proofs_has_no_time_limit() {
    let prose: [&[u8]; 4] = [
        b"[[table:planted-faults]]\n",
        b"with the aging law\n\n [[ table : hopf-coefficient]]\n\nWith the slip law $l_1 < 0$\n",
        b"[[figure:criticality]]\n",
        b"Series of [planted-faults] in prose are words.\n",
    ];
    hold(promises::prose, &prose, 80);
}

#[test]
fn changed_archives_are_refused_or_pack_to_the_same_files() {
    let text: String = (0..200).map(|line| format!("{line},{}\n", line * line)).collect();
    let files = Files::from([
        ("inputs/report.toml".to_string(), b"name = \"r\"\n".to_vec()),
        ("report/tables/t.csv".to_string(), text.into_bytes()),
    ]);
    let packed = pack(&files, ReleaseTime::UNSTATED).unwrap();
    hold(promises::archive, &[&packed], 4_000);
}

#[test]
fn changed_points_are_refused_or_written_as_read() {
    let header = "direct_effect,evolution_effect,critical_slip_distance_m,stiffness_pa_per_m,\
        mass_per_area_kg_per_m2,normal_stress_pa,loading_velocity_m_per_s";
    let plain = format!("{header}\n0.004,0.006,1e-5,1e7,1000,1e5,1e-3\n");
    let named = format!("id,{header}\r\n\"=a,\"\"b\",4e-3,6e-3,1e-5,1e7,1000,1e5,1.5e-3\r\n");
    hold(csv_promises::points, &[plain.as_bytes(), named.as_bytes()], 2_000);
}

#[test]
fn changed_trajectories_are_refused_or_orderly() {
    let rows =
        |with: &str| -> String { (0..12).map(|row| format!("{row}.5,{}e-3{with}\n", 1 + row % 3)).collect() };
    let plain = format!("time_s,velocity_m_per_s\n{}", rows(""));
    let stressed = format!("time_s,velocity_m_per_s,shear_stress_pa\n{}", rows(",-1e4"));
    hold(csv_promises::recording, &[plain.as_bytes(), stressed.as_bytes()], 2_000);
}
