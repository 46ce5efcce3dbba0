//! The picture of which claims rest on which.

use crate::claims::Ledger;
use crate::report::{FigureView, Standing};
use slipmode_plot::figure::{BoxLook, BoxNode, Caption, LayeredGraph};

/// Standings in the order of the legend, with the colours of the picture outside a page.
const LOOKS: [(Standing, &str, &str); 4] = [
    (Standing::Holds, "#e6f3e9", "#17692f"),
    (Standing::HoldsWithin, "#fbf0d9", "#855400"),
    (Standing::Fails, "#fbe9e7", "#b3261e"),
    (Standing::NotChecked, "#eceef0", "#57606a"),
];

const TITLE: &str = "Dependencies between claims";

/// The picture; `None` when no claim of the ledger rests on another.
pub(super) fn claims_picture(ledger: &Ledger, standing: &dyn Fn(usize) -> Standing) -> Option<FigureView> {
    let place = |id: &&str| ledger.claims.iter().position(|entry| entry.id == *id);
    let node = |(index, entry): (usize, &crate::claims::Entry)| {
        let standing = standing(index);
        BoxNode {
            label: format!("{} {}", entry.id, standing.symbol()),
            name: format!("{} {}: {}", entry.id, standing.word(), entry.words),
            link: format!("#claim-{}", entry.id),
            look: LOOKS.iter().position(|(look, ..)| *look == standing).unwrap_or(0),
            rests_on: entry.rests_on.iter().filter_map(place).collect(),
        }
    };
    let nodes: Vec<BoxNode> = ledger.claims.iter().enumerate().map(node).collect();
    if nodes.iter().all(|node| node.rests_on.is_empty()) {
        return None;
    }
    let look = |(standing, fill, ink): (Standing, &str, &str)| BoxLook {
        class: standing.class().into(),
        fill: fill.into(),
        ink: ink.into(),
        words: format!("{} {}", standing.symbol(), standing.word()),
    };
    let description = description(&nodes);
    let graph = LayeredGraph {
        caption: Caption::new("claims-picture", TITLE, &description),
        looks: LOOKS.into_iter().map(look).collect(),
        nodes,
        curve_words: "the claim on the right depends on the one on the left".into(),
    };
    Some(FigureView {
        id: "claims-picture".into(),
        label: TITLE.into(),
        caption_markdown: "Each box is a claim and links to it. If a claim fails, all claims joined to it on the right lose a premise.".into(),
        description,
        svg: graph.svg(),
        data: Vec::new(),
    })
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
