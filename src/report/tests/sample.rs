//! A report with the parts of a real one, for tests and for looking at; its numbers are made up.

use crate::report::*;
use crate::scene::{Source, Verdict};
use slipmode_plot::figure::{Axis, Caption, LineChart, Series};
use slipmode_plot::table::{Cell, Column, Table};

fn claim(id: &str, verdict: Verdict, statement: &str) -> ClaimView {
    ClaimView {
        id: id.into(),
        place: "2.2, fig. 1".into(),
        source: Source::Paper,
        kind_markdown: "universal (“is”)".into(),
        decided_markdown: "The discriminant factors".into(),
        statement_markdown: statement.into(),
        acceptance_markdown: "The identity holds over $\\mathbb{Q}$ for all $\\eta > 0$, $\\kappa > 0$, $\\beta > 0$.".into(),
        verdict,
        verdict_markdown: String::new(),
        strength: "exact".into(),
        readings: Vec::new(),
        evidence: vec![EvidenceView {
            kind: "Proof".into(),
            strength: "exact".into(),
            text_markdown: "The discriminant factors as $\\Delta = (\\sqrt{b}-\\sqrt{a})^2 - K D_c/\\sigma$ up to a positive factor; the remainder is the zero polynomial.".into(),
            numbers: vec![
                FactView { name: "Terms compared".into(), value: "41".into() },
                FactView { name: "Remainder".into(), value: "0".into() },
            ],
            certificate: "variables: eta > 0, kappa > 0, beta > 0\n4*eta*kappa*(beta - 1)^2 - 18*eta*kappa^2 = (kappa - (1 + sqrt(beta))^2) * q\nremainder = 0".into(),
            lines: vec![ProofLineView {
                number: Some(1),
                words_markdown: "both sides".into(),
                fact_markdown: "$4\\,\\eta\\,\\kappa\\,(\\beta - 1)^{2} = 0$".into(),
                conditions_markdown: "$\\eta, \\kappa, \\beta > 0$".into(),
                is_argued: false,
            }],
            theorem: "discriminant".into(),
            certificate_at: String::new(),
        }],
        counter_example_markdown: String::new(),
        not_established_markdown: "Nothing about $M > 0$: there the boundary lies above eq. 16 by the relative amount $\\eta$.".into(),
        remark_markdown: String::new(),
        rests_on: vec!["L3".into()],
        command: format!("slipmode verify reports/im-avouac --claim {id}"),
    }
}

fn ledger() -> Vec<ClaimGroupView> {
    use Verdict::{Fails, Holds, HoldsWithin, NotChecked};
    let mut limited = claim(
        "B5",
        HoldsWithin,
        "Letting $D_c \\to \\infty$ in eq. 8 gives eq. 19, and eq. 20 is an asymptote of the boundary in the stable zone.",
    );
    limited.verdict_markdown =
        "1 % where $\\sigma < 0.013\\,\\sigma_{16}$, 10 % where $\\sigma < 0.14\\,\\sigma_{16}$".into();
    limited.strength = "certified".into();
    let mut failed = claim(
        "S4",
        Fails,
        "The system is unstable whenever $V > V_c$ **or** $\\sigma > \\sigma_c$, and both are asymptotes of $K = K_c$.",
    );
    failed.readings = vec![ReadingView {
        words_markdown: "above $V_c$ **or** above $\\sigma_c$".into(),
        verdict: Fails,
        strength: "exact".into(),
        parts: vec![
            PartView {
                words_markdown: "the slope changes its sign".into(),
                formula_markdown: "$K_{c} > 0$ for all $a < b$".into(),
                verdict: Verdict::HoldsWithin,
                strength: "exact".into(),
                result_markdown: "the limit $V \\to 0$".into(),
                evidence: vec![1],
            },
            PartView {
                words_markdown: "both are asymptotes".into(),
                formula_markdown: String::new(),
                verdict: Fails,
                strength: "exact".into(),
                result_markdown: "at $V = 3/1000$ m/s".into(),
                evidence: Vec::new(),
            },
        ],
    }];
    failed.verdict_markdown = "the first half holds, the caption contradicts eq. 9".into();
    failed.counter_example_markdown =
        "$V = 3/1000$ m/s, $\\sigma = 10^{5}$ Pa: $K - K_c = -1.75\\times 10^{7}$ Pa/m exactly.".into();
    failed.remark_markdown =
        "The text says *above*, the figure shows *below*; eq. 12 decides for the text.".into();
    let open = {
        let mut one = claim(
            "N1",
            NotChecked,
            "Every simulation with $K < K_c$ is unstable, every one with $K > K_c$ is stable.",
        );
        one.strength = String::new();
        one.evidence.clear();
        one.verdict_markdown = "needs simulations, which this scene does not ask for".into();
        one
    };
    let held = |id: &str, text: &str| claim(id, Holds, text);
    vec![
        ClaimGroupView {
            title: "Linearisation (L)".into(),
            claims: vec![
                held("L1", "Eqs 5 and 6 are the linearisation of eqs 1, 2 or 3, and 4."),
                held("L2", "Eqs 5 and 6 combine into one third-order equation in $\\Delta\\theta$."),
                {
                    let mut root = held("L3", "The characteristic equation is the cubic of eq. 8.");
                    root.rests_on.clear();
                    root
                },
            ],
        },
        ClaimGroupView {
            title: "Stability (S)".into(),
            claims: vec![
                held("S1", "A root pair crosses the imaginary axis exactly when $K = K_c$."),
                failed,
            ],
        },
        ClaimGroupView {
            title: "Boundary (B)".into(),
            claims: vec![
                held("B2", "For $M = 0$ the imaginary part vanishes at eqs 15 and 16."),
                held("B3", "$\\sigma_c$ is the geometric mean of eqs 15 and 16."),
                limited,
            ],
        },
        ClaimGroupView { title: "Simulations (N)".into(), claims: vec![open] },
    ]
}

fn corners() -> Table {
    let columns = vec![
        Column::text("corner", "Corner"),
        Column::number("effect_ratio", "β = b/a", ""),
        Column::number("normal_stress_pa", "Normal stress", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity", "m/s"),
        Column::number("relative_error", "Relative error", ""),
        Column::number("condition_number", "Condition", ""),
    ];
    let mut table = Table::new("corners", "Worst error of the asymptotes, at their corners", columns)
        .with_note("The relative error is $\\sigma_\\text{exact}/\\sigma_\\text{asymptote} - 1$; it depends on $\\beta$ alone.");
    for (index, beta) in ["0.001", "0.1", "0.5", "0.999", "1.001", "1.5", "10", "1000"].iter().enumerate() {
        let corner = if index % 2 == 0 { "15 ∩ 18" } else { "16 ∩ 20" };
        table.push(vec![
            Cell::text(corner),
            Cell::number(*beta),
            Cell::number("494897.4"),
            Cell::number("4.949e-3"),
            Cell::number("-0.3719"),
            Cell::number("2.41"),
        ]);
    }
    table
}

fn figure(id: &str, label: &str, caption: &str) -> FigureView {
    let chart = LineChart {
        caption: Caption::new(id, caption, "A straight line."),
        x: Axis::log10("Loading velocity *V*_0", "m/s", 1e-6, 1e-2),
        y: Axis::log10("max Im(*s*)", "1/s", 1e-2, 1e3),
        series: vec![Series::of_theory("eq. 23", vec![(1e-6, 0.1), (1e-2, 1e3)])],
        references: Vec::new(),
    };
    FigureView {
        id: id.into(),
        label: label.into(),
        caption_markdown: caption.into(),
        description: "Map of max Im(s) over loading velocity and normal stress.".into(),
        svg: chart.svg(),
        data: vec!["corners".into()],
    }
}

fn drawings() -> Vec<FigureView> {
    vec![
        figure(
            "fig-1",
            "Figure 1",
            "Largest imaginary part of the roots of eq. 8 for the paper's values. The exact boundary (solid) leaves its asymptotes (dashed) at the corners by up to 37 %; the cusp lies at $V_0 = 1.5964\\times10^{-4}$ m/s.",
        ),
        figure("fig-2", "Figure 2", "Frequency against loading velocity at three normal stresses."),
        figure(
            "fig-7a",
            "Figure 7a",
            "Zones of slip modes for $a < b$, from exact decisions at 240 × 240 points.",
        ),
        figure("error", "Figure 8", "Signed relative error of the asymptotes along their arcs."),
        figure("good-enough", "Figure 9", "Where each asymptote may be used."),
    ]
}

fn equations() -> Vec<EquationView> {
    let equation = |id: &str, caption: &str, latex: &str| EquationView {
        id: id.into(),
        caption_markdown: caption.into(),
        latex: latex.into(),
    };
    vec![
        equation(
            "8",
            "the characteristic cubic",
            r"\frac{M}{\sigma}s^3 + \left(\frac{a}{V_0} + \frac{M V_0}{\sigma D_c}\right)s^2 + \left(\frac{K}{\sigma} + \frac{a-b}{D_c}\right)s + \frac{K V_0}{\sigma D_c} = 0 \tag{8}",
        ),
        equation(
            "9",
            "",
            r"K = K_c = \frac{(b-a)\,\sigma}{D_c}\left[1 + \frac{M V_0^2}{\sigma a D_c}\right]",
        ),
        equation("16", "", r"\sigma = \frac{K D_c}{(\sqrt{b} + \sqrt{a})^2}"),
    ]
}

const CHAPTER: &str = "The slider obeys rate-and-state friction; with $s = p\\,V_0/D_c$ three groups are all there is:
$\\eta = M V_0^2/(\\sigma a D_c)$, $\\kappa = K D_c/(a\\sigma)$ and $\\beta = b/a$.

[[equation:8]]

Stability is lost where the critical stiffness is reached ([S1](#claim-S1), [S4](#claim-S4)):

[[equation:9]]

# The map

Between the quasi-static asymptotes the frequency is low; towards high velocity it reaches $\\omega_n = \\sqrt{K/M}$
and never exceeds it.

[[figure:fig-1]]

[[claim:B5]]

[[figure:fig-2]]

[[figure:fig-7a]]

# How far off the asymptotes are

| Asymptote | Leading error | 1 % where |
| --- | --- | --- |
| eq. 15 | $\\eta$ | $\\eta < 0.01$ |
| eq. 20 | $\\beta/(2\\kappa)$ | $\\kappa > 50\\,\\beta$ |

[[equation:16]]

[[figure:error]]

[[figure:good-enough]]

[[table:corners]]
";

/// The sample report.
pub(crate) fn view() -> ReportView {
    let card =
        |verdict, count: &str, note: &str| CardView { verdict, count: count.into(), note: note.into() };
    let sentence = |text: &str, claims: &[&str], is_list| AnswerView {
        text_markdown: text.into(),
        claims: claims.iter().map(|&id| id.into()).collect(),
        is_list,
    };
    let fact = |name: &str, value: &str| FactView { name: name.into(), value: value.into() };
    ReportView {
        live: None,
        citation: CitationView { program: "slipmode 0".into(), bibtex: "@misc{r}".into(), ..Default::default() },
        title: "When does frictional slip vibrate?".into(),
        subtitle: "The linear theory of Im & Avouac, proved, measured and checked claim by claim".into(),
        summary_markdown: "Every checkable claim of *Linear stability analysis of the condition for vibration during frictional slip* was decided by computation: identities over $\\mathbb{Q}$, certified enclosures of the roots, and the exact boundary $\\max\\operatorname{Im}(s) = 0$ by three routes that share nothing but eq. 8.".into(),
        changes: vec![ChangeView {
            claim: "S4".into(),
            instead_markdown: "Only $V > V_c$ is needed.".into(),
            affects_markdown: "fig 1".into(),
        }],
        cards: vec![
            card(Verdict::Holds, "21", "proved or certified"),
            card(Verdict::HoldsWithin, "7", "with a quantified limit"),
            card(Verdict::Fails, "2", "with a counter-example"),
            card(Verdict::NotChecked, "10", "need simulations"),
        ],
        answer: vec![
            sentence("Of the 40 claims, 21 hold as stated and 2 fail.", &[], false),
            sentence("The asymptotes are off by up to 37 % at their corners, for $\\beta = b/a$ alone.", &["B5"], false),
            sentence("One claim is wrong as stated:", &["S4"], true),
        ],
        chapters: vec![ChapterView { id: "theory".into(), title: "The linear theory".into(), part: Some(crate::scene::Part::CodeVerification), text_markdown: CHAPTER.into() }],
        ledger: ledger(),
        claims_picture: None,
        equations: equations(),
        figures: drawings(),
        tables: vec![corners()],
        provenance: ProvenanceView {
            text_markdown: "The page is made by one command from the files below.".into(),
            command: "cargo xtask verify".into(),
            inputs: vec![
                InputView { path: "report.toml".into(), bytes: "412".into(), sha256: "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08".into() },
                InputView { path: "scenes/figure-1.toml".into(), bytes: "1 204".into(), sha256: "60303ae22b998861bce3b28f33eec1be758a213c86c93c076dbe9f558c11c752".into() },
            ],
        },
        environment: vec![fact("rustc", "1.95.0"), fact("MPFR", "4.2.2"), fact("Wall time", "4.2 s")],
    }
}
