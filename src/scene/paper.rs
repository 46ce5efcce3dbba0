//! `[paper]` of `report.toml`: the authors and the reference of the paper that a report accompanies, for those who certify its archive.

use crate::scene::section::{Entry, keys};

keys! {
    /// What is known of the paper; nothing without the section.
    #[derive(Default)]
    pub struct Paper {
        /// The paper's title; that of the report by default.
        pub title: Option<String> = |section, key| section.optionally(key, Entry::text),
        /// Where it is published or under review: an address, an identifier, or a short text.
        pub reference: Option<String> = |section, key| section.optionally(key, Entry::text),
        /// Its authors, the corresponding one first.
        pub authors: Vec<Author> = |section, _| {
            section.list("author", AUTHORS, |member| member.table(Author::read))
        },
    }
}

const AUTHORS: &str = "[[paper.author]] sections, the corresponding author first";

keys! {
    /// An author of the paper.
    pub struct Author {
        /// The author's name.
        pub name: String = |section, key| section.text(key, "a text"),
        /// The author's ORCID, without an address in front.
        pub orcid: Option<String> = |section, key| section.optionally(key, read_orcid),
    }
}

fn read_orcid(entry: &Entry<'_>) -> Option<String> {
    let orcid = entry.text()?;
    if is_orcid(&orcid) { Some(orcid) } else { entry.needs(ORCID_FORM) }
}

const ORCID_FORM: &str =
    "an ORCID such as `0000-0002-1825-0097`, with its check digit and without an address";

/// Whether a text is an ORCID: 16 digits in groups of four, the last one a check digit by ISO/IEC 7064, MOD 11-2.
#[must_use]
pub fn is_orcid(text: &str) -> bool {
    let groups: Vec<&str> = text.split('-').collect();
    let characters: Vec<char> = groups.concat().chars().collect();
    let Some((check, digits)) = characters.split_last() else { return false };
    let values: Option<Vec<u32>> = digits.iter().map(|digit| digit.to_digit(10)).collect();
    let Some(values) = values else { return false };
    if groups.len() != 4 || groups.iter().any(|group| group.len() != 4) {
        return false;
    }
    let remainder = values.iter().fold(0, |sum, digit| (sum + digit) * 2 % 11);
    let expected = (12 - remainder) % 11;
    if expected == 10 { *check == 'X' } else { check.to_digit(10) == Some(expected) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_orcid_has_four_groups_and_its_check_digit() {
        for good in ["0000-0002-1825-0097", "0000-0001-5109-3700", "0000-0002-1694-233X"] {
            assert!(is_orcid(good), "{good}");
        }
        for bad in [
            "0000-0002-1825-0098",
            "0000-0002-1694-2330",
            "0000000218250097",
            "000-00002-1825-0097",
            "0000-0002-1825-00970",
            "https://orcid.org/0000-0002-1825-0097",
            "0000-0002-1825-009é",
            "----",
            "",
        ] {
            assert!(!is_orcid(bad), "{bad}");
        }
    }
}
