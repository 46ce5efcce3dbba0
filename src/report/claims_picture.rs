//! The picture of which claims rest on which.

use crate::claims::{Ledger, Verdict};
use crate::report::FigureView;
use slipmode_plot::figure::{BoxLook, BoxNode, Caption, LayeredGraph};

/// Verdicts in the order of the legend, with the colours of the picture outside a page.
const LOOKS: [(Verdict, &str, &str); 4] = [
    (Verdict::Holds, "#e6f3e9", "#17692f"),
    (Verdict::HoldsWithin, "#fbf0d9", "#855400"),
    (Verdict::Fails, "#fbe9e7", "#b3261e"),
    (Verdict::NotChecked, "#eceef0", "#57606a"),
];

const TITLE: &str = "Dependencies between claims";
const CAPTION: &str = "Each box is a claim and links to it. If a claim fails, all claims joined to it on the right lose a premise.";

/// The picture; `None` when no claim of the ledger rests on another.
pub(super) fn claims_picture(ledger: &Ledger) -> Option<FigureView> {
    let place = |id: &String| ledger.claims.iter().position(|entry| entry.id == *id);
    let node = |entry: &crate::claims::Entry| {
        let verdict = entry.finding.verdict;
        BoxNode {
            label: format!("{} {}", entry.id, verdict.symbol()),
            name: format!("{} {}: {}", entry.id, verdict.word(), entry.words),
            link: format!("#claim-{}", entry.id),
            look: LOOKS.iter().position(|(look, ..)| *look == verdict).unwrap_or(0),
            rests_on: entry.rests_on.iter().filter_map(place).collect(),
        }
    };
    let nodes: Vec<BoxNode> = ledger.claims.iter().map(node).collect();
    if nodes.iter().all(|node| node.rests_on.is_empty()) {
        return None;
    }
    let look = |(verdict, fill, ink): (Verdict, &str, &str)| BoxLook {
        class: verdict.as_str().into(),
        fill: fill.into(),
        ink: ink.into(),
        words: format!("{} {}", verdict.symbol(), verdict.word()),
    };
    let graph = LayeredGraph {
        caption: Caption::new("claims-picture", TITLE, &description(&nodes)),
        looks: LOOKS.into_iter().map(look).collect(),
        nodes,
        curve_words: "the claim on the right depends on the one on the left".into(),
    };
    Some(FigureView::new(&graph.caption, TITLE, CAPTION, graph.svg()))
}

/// The relations in words, for those who cannot see the picture.
fn description(nodes: &[BoxNode]) -> String {
    let id = |node: &BoxNode| node.label.split(' ').next().unwrap_or_default().to_owned();
    let grounds = |node: &BoxNode| {
        node.rests_on.iter().filter_map(|&on| nodes.get(on)).map(id).collect::<Vec<_>>().join(" and ")
    };
    let resting = nodes.iter().filter(|node| !node.rests_on.is_empty());
    let sentences: Vec<String> = resting.map(|node| format!("{} on {}", id(node), grounds(node))).collect();
    format!("Claims as boxes, each to the right of the claims that it depends on: {}.", sentences.join(", "))
}
