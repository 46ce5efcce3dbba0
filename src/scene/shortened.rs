//! Text from outside in messages: shortened in the middle, so that both ends can be recognised; and lists by their first items.

/// The longest message of a command, in characters, all its lines together.
pub const LONGEST_MESSAGE: usize = 1_400;

/// The longest quotation in a message.
const LONGEST_QUOTATION: usize = 120;

/// A text of at most this many characters (40 or more): its beginning and its end, and how many characters are left out between
/// them. What is short enough stays as it is, also what was shortened before.
pub(crate) fn shortened(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_string();
    }
    let mark = |left_out: usize| format!(" …[{left_out} characters]… ");
    // The number of what is left out has no more digits than that of the whole text.
    let kept = most.saturating_sub(mark(count).chars().count());
    let end = kept / 3;
    let beginning: String = text.chars().take(kept - end).collect();
    let ending: String = text.chars().skip(count - end).collect();
    format!("{beginning}{}{ending}", mark(count - kept))
}

/// A message whose quotations, between `` ` `` or `'`, are each [`shortened`], and then the whole.
pub(crate) fn with_short_quotations(message: &str, most: usize) -> String {
    let mut short = String::new();
    let mut rest = message;
    let mut is_after_word = false;
    while let Some(found) = rest.find(['`', '\'']) {
        let (before, quoted) = rest.split_at(found);
        short.push_str(before);
        // An apostrophe within a word opens no quotation.
        is_after_word = before.chars().last().map_or(is_after_word, char::is_alphanumeric);
        let (mark, content) = quoted.split_at(1);
        short.push_str(mark);
        rest = content;
        if let (false, Some(end)) = (is_after_word, content.find(mark)) {
            short.push_str(&shortened(&content[..end], LONGEST_QUOTATION));
            short.push_str(mark);
            rest = &content[end + 1..];
        }
        is_after_word = false;
    }
    short.push_str(rest);
    shortened(&short, most)
}

/// The first lines that fit together into [`LONGEST_MESSAGE`], one of them at least, and what `others` says of the number of the
/// others.
#[must_use]
pub fn first_lines(
    lines: impl IntoIterator<Item = String>,
    others: impl FnOnce(usize) -> String,
) -> Vec<String> {
    let (mut first, mut length, mut more) = (Vec::new(), 0, 0_usize);
    for line in lines {
        let line = with_short_quotations(&line, LONGEST_MESSAGE);
        length += line.chars().count() + 1;
        if first.is_empty() || (more == 0 && length <= LONGEST_MESSAGE) {
            first.push(line);
        } else {
            more += 1;
        }
    }
    if more > 0 {
        first.push(others(more));
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_keeps_both_ends_and_says_how_much_is_missing() {
        assert_eq!(shortened("abc", 40), "abc");
        let long = format!("{}{}", "ä".repeat(50), "z".repeat(50));
        let short = shortened(&long, 40);
        let wanted = format!("{} …[80 characters]… {}", "ä".repeat(14), "z".repeat(6));
        assert_eq!((short.as_str(), short.chars().count()), (wanted.as_str(), 39));
        assert_eq!(shortened(&short, 40), short);
    }

    #[test]
    fn quotations_are_shortened_and_the_reason_between_them_stays() {
        let long = "x + ".repeat(1_000);
        let message = format!("the claim's side '{long}' is not `{long}`, says 'a'");
        let short = with_short_quotations(&message, 1_000);
        assert!(short.starts_with("the claim's side 'x + ") && short.ends_with("`, says 'a'"), "{short}");
        assert!(short.contains("' is not `") && short.chars().count() < 400, "{short}");
        assert_eq!(with_short_quotations("the paper's 'f' and 'g", 100), "the paper's 'f' and 'g");
        assert!(with_short_quotations(&long, 300).chars().count() < 340);
    }

    #[test]
    fn a_list_has_its_first_lines_and_counts_the_others() {
        let line = |line| format!("{line}: {}", "x".repeat(90));
        let others = |more| format!("and {more} more");
        let lines = |count: usize| first_lines((0..count).map(line), others);
        assert_eq!(lines(3).len(), 3);
        let many = lines(1_000);
        assert!(many.iter().map(|line| line.chars().count() + 1).sum::<usize>() < 1_450, "{many:?}");
        assert_eq!(many.last().unwrap(), &format!("and {} more", 1_000 - (many.len() - 1)));
        assert_eq!(first_lines(["y".repeat(9_000)], others).len(), 1);
    }
}
