//! Lines such as `[[figure:fig-1]]` that place a block in the prose of a chapter.

slipmode_algebra::named! {
    /// What a placing line places.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(crate) enum BlockKind {
        /// A figure with its caption.
        Figure = "figure",
        /// A table with its note.
        Table = "table",
        /// A numbered equation.
        Equation = "equation",
        /// A claim's verdict in one line, with a link to the ledger.
        Claim = "claim",
    }
}

/// A stretch of prose or a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Piece {
    /// Markdown between blocks.
    Prose(String),
    /// A block and its id.
    Block(BlockKind, String),
    /// A placing line that names no known kind of block.
    Unknown(String),
}

/// Cuts prose at its placing lines; those inside fenced code are left alone.
pub(crate) fn pieces(prose: &str) -> Vec<Piece> {
    let mut found = Vec::new();
    let mut text = String::new();
    let mut fence: Option<&str> = None;
    for line in prose.lines() {
        let start = line.trim_start();
        match fence {
            Some(mark) if start.starts_with(mark) => fence = None,
            Some(_) => {}
            None => fence = ["```", "~~~"].into_iter().find(|mark| start.starts_with(mark)),
        }
        match placing_line(line).filter(|_| fence.is_none()) {
            Some(piece) => {
                flush(&mut text, &mut found);
                found.push(piece);
            }
            None => {
                text += line;
                text.push('\n');
            }
        }
    }
    flush(&mut text, &mut found);
    found
}

fn flush(text: &mut String, found: &mut Vec<Piece>) {
    if !text.trim().is_empty() {
        found.push(Piece::Prose(std::mem::take(text)));
    }
    text.clear();
}

fn placing_line(line: &str) -> Option<Piece> {
    let inside = line.trim().strip_prefix("[[")?.strip_suffix("]]")?;
    let (kind, id) = inside.split_once(':').unwrap_or((inside, ""));
    let kind = BlockKind::from_word(kind.trim()).filter(|_| !id.contains("]]"));
    Some(match kind {
        Some(kind) => Piece::Block(kind, id.trim().into()),
        None => Piece::Unknown(line.trim().into()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_stand_between_the_prose_around_them() {
        let found = pieces("Before.\n\n[[figure:fig-1]]\n[[equation: 16]]\nAfter.\n");
        assert_eq!(found.len(), 4);
        assert_eq!(found[0], Piece::Prose("Before.\n\n".into()));
        assert_eq!(found[1], Piece::Block(BlockKind::Figure, "fig-1".into()));
        assert_eq!(found[3], Piece::Prose("After.\n".into()));
    }

    #[test]
    fn code_and_running_text_place_nothing() {
        let prose = "Write `[[figure:x]]` on a line.\n\n```\n[[figure:x]]\n```\n";
        assert_eq!(pieces(prose), [Piece::Prose(prose.into())]);
    }

    #[test]
    fn an_unknown_kind_is_reported_as_written() {
        for line in ["[[figur:x]]", "[[claim:A1]] [[claim:A2]]"] {
            assert_eq!(pieces(line), [Piece::Unknown(line.into())]);
        }
    }
}
