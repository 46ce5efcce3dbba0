//! What the name of a column says: that it gives a quantity or the error of one, and in which unit.
//!
//! A name is split into words. One of them, or several, are the quantity; others say "error"; the rest is the unit.

use slipmode_core::number::Rational;

use crate::scene::{read_unit, stem_of_key, unit_for, unit_in_any_case, unit_of_key};

/// Words that say "error" beside any name.
const ERRORS: &str = "± err errs error errors errorbar errbar std stdev stddev stdv sdev stderr sd sem deviation unc uncert uncertainty uncertainties";
/// Words that say "error" beside the name of a quantity only: they have other meanings as well.
const ERRORS_OF_A_QUANTITY: &str = "sigma delta u se pm dev 1sigma tolerance tol";
/// Words for other measures of a spread. slipmode reads none of them.
const OTHER_SPREADS: &str = "e plus minus low high lower upper ci var variance range spread iqr mad";
/// Words of a unit that make an error a share of its value, and how many of them are the whole value.
const SHARES: [(&str, u32); 2] = [("% percent pct", 100), ("relative rel", 1)];
/// Words without a meaning of their own.
const FILLERS: &str = "in of mean standard absolute abs estimated";
/// What may stand before the symbol of a quantity, or behind it, without a separator.
const BEFORE: &str = "sigma delta err error std u d";
const BEHIND: &str = "err error std stdev unc uncertainty";
/// A name with more words gives no quantity.
pub const MOST_WORDS: usize = 16;
/// The words of the longest name of a quantity, `critical_slip_distance`.
const MOST_WORDS_OF_A_QUANTITY: usize = 3;

/// A column that a header has to have.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    /// Its name in SI.
    pub key: &'static str,
    /// Short names, in SI unless a unit stands behind them.
    pub symbols: &'static [&'static str],
    /// Whether it may be missing.
    pub is_optional: bool,
}

/// The unit that a name states.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unit {
    /// None.
    Absent,
    /// One of this size in SI.
    Size(Rational),
    /// A share of the value: this number is the whole value.
    Share(u32),
    /// None that can be used, and why.
    Refused(String),
    /// Words of an error, or of another spread, that are not understood.
    Unclear,
}

/// One way to understand a name as that of a quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reading {
    /// Whether the column has the errors of the quantity, and not its values.
    pub is_error: bool,
    /// Its unit.
    pub unit: Unit,
}

/// The words of a name, with names in place of Greek letters.
pub fn words(name: &str) -> Vec<String> {
    let mut text = name.trim().replace("+/-", "±").replace("+-", "±");
    for unitless in ["[-]", "(-)", "[1]", "(1)"] {
        text = text.replace(unitless, " unitless ");
    }
    let mut spaced = String::new();
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let is_before_digit = characters.peek().is_some_and(char::is_ascii_digit);
        match character {
            'σ' => spaced.push_str("sigma"),
            'Δ' | 'δ' | '∆' => spaced.push_str(" delta "),
            'ₙ' => spaced.push('n'),
            '₀' => spaced.push('0'),
            '±' | '%' => spaced.extend([' ', character, ' ']),
            // The power of a unit, as in `s-1`, or a decimal.
            '-' | '.' if is_before_digit => spaced.push(character),
            '^' | '/' | '*' | '·' | '⁻' | '²' | '³' | '¹' => spaced.push(character),
            character if character.is_alphanumeric() => spaced.push(character),
            _ => spaced.push(' '),
        }
    }
    spaced.split_whitespace().map(str::to_string).collect()
}

/// Every way to understand the words of a name as that of this quantity.
pub fn readings(words: &[String], wanted: &Wanted) -> Vec<Reading> {
    let forms = forms(wanted);
    let words: Vec<String> = words.iter().take(MOST_WORDS + 1).flat_map(|word| split(word, &forms)).collect();
    let mut found = Vec::new();
    if words.len() > MOST_WORDS {
        return found;
    }
    for start in 0..words.len() {
        // `sigma_n` is the normal stress, and not a stress in newtons: the longest name comes first.
        let longest = (start + 1..=words.len().min(start + MOST_WORDS_OF_A_QUANTITY)).rev().find_map(|end| {
            let joined = words[start..end].concat().to_lowercase();
            let (_, is_stem) = forms.iter().find(|(form, _)| *form == joined)?;
            reading(&words, start..end, wanted.key, *is_stem)
        });
        found.extend(longest.filter(|reading| !found.contains(reading)));
    }
    found
}

/// The names of a quantity without separators, and whether each is its name without a unit, not a symbol.
fn forms(wanted: &Wanted) -> Vec<(String, bool)> {
    let plain = |name: &str| name.replace('_', "");
    let symbols = wanted.symbols.iter().map(|symbol| (plain(symbol), false));
    symbols.chain([(plain(stem_of_key(wanted.key)), true)]).collect()
}

/// A word, or the two of a symbol and what is written together with it.
fn split(word: &str, forms: &[(String, bool)]) -> Vec<String> {
    let lower = word.to_lowercase();
    for (form, _) in forms.iter().filter(|(form, _)| lower.len() > form.len()) {
        // `um` is a unit, and `da` no error of a.
        let before = lower.strip_suffix(form.as_str()).filter(|rest| rest.len() > 1 || form.len() > 1);
        let behind = lower.strip_prefix(form.as_str()).unwrap_or_default();
        match before.filter(|rest| is_one_of(BEFORE, rest)) {
            Some("d") => return vec!["delta".into(), form.clone()],
            Some(rest) => return vec![rest.into(), form.clone()],
            None if is_one_of(BEHIND, behind) => return vec![form.clone(), behind.into()],
            // As in `Dc/um`; the unit keeps its case.
            None if behind.starts_with('/') => {
                return vec![form.clone(), word.get(form.len()..).unwrap_or_default().into()];
            }
            None => {}
        }
    }
    vec![word.to_string()]
}

/// What the words around those of a quantity say; none when they say nothing that belongs to it.
fn reading(words: &[String], quantity: std::ops::Range<usize>, key: &str, is_stem: bool) -> Option<Reading> {
    let (mut is_error, mut is_unclear, mut has_unit_before) = (false, false, false);
    let (mut share, mut unit) = (None, Vec::new());
    for (index, word) in words.iter().enumerate().filter(|(index, _)| !quantity.contains(index)) {
        let lower = word.to_lowercase();
        if is_one_of(ERRORS, &lower) || is_one_of(ERRORS_OF_A_QUANTITY, &lower) {
            is_error = true;
        } else if let Some((_, whole)) = SHARES.iter().find(|(words, _)| is_one_of(words, &lower)) {
            share = share.max(Some(*whole));
        } else if !is_one_of(FILLERS, &lower) {
            let plain = plain(word);
            // `s(Dc)` is a standard deviation; a unit stands behind.
            is_unclear |= lower == "s" && index < quantity.start;
            is_unclear |=
                [ERRORS, ERRORS_OF_A_QUANTITY, OTHER_SPREADS].iter().any(|words| is_one_of(words, &plain));
            has_unit_before |= index < quantity.start;
            unit.push(word.as_str());
        }
    }
    let text = unit_text(&unit);
    let is_number = |word: &&str| word.bytes().all(|byte| byte.is_ascii_digit());
    // One letter behind other words is a unit rather than a quantity, as in `depth_low_m`.
    let is_named = quantity.start == 0 || quantity.len() > 1 || words[quantity.start].len() > 1;
    // As in `sigma_v`: of the velocity, or the vertical stress.
    let is_subscript =
        words.len() == 2 && words[0].eq_ignore_ascii_case("sigma") && words[quantity.start].len() == 1;
    let is_readable = !unit.iter().any(is_number) && read_unit(&text).is_ok();
    let in_si = unit_of_key(key);
    let unit = match (share, unit.is_empty()) {
        _ if is_unclear && is_named => Unit::Unclear,
        // A column that only has the name of a quantity in its own, such as `a_sample`, is another one.
        _ if !is_error && (has_unit_before || share.is_some()) => return None,
        (Some(whole), true) => Unit::Share(whole),
        (Some(_), false) => Unit::Refused("a share of the value has no unit".into()),
        (None, true) if is_stem && !is_error && in_si != "1" => Unit::Refused("no unit".into()),
        (None, true) if is_subscript && in_si != "1" => {
            Unit::Refused("no unit, so that it may be a stress as well as an error".into())
        }
        (None, true) => Unit::Absent,
        (None, false) if is_readable || is_stem => {
            unit_for(&text, in_si).map_or_else(Unit::Refused, Unit::Size)
        }
        (None, false) if is_error && is_named => Unit::Unclear,
        (None, false) => return None,
    };
    Some(Reading { is_error: is_error || is_unclear, unit })
}

/// The words of a unit as a unit. A bar before all of them, as in `Dc / um`, is no division.
fn unit_text(words: &[&str]) -> String {
    let mut text = String::new();
    for word in words {
        let word = match *word {
            "per" => "/",
            "unitless" | "dimensionless" => "1",
            word => word,
        };
        let is_factor = !text.is_empty() && !text.ends_with('/') && !word.starts_with('/');
        text.push_str(if is_factor { " " } else { "" });
        text.push_str(word);
    }
    let is_label = words.first().is_some_and(|first| first.starts_with('/'));
    unit_in_any_case(if is_label { text.trim_start_matches('/') } else { &text }.trim())
}

/// Whether a word is one of these.
fn is_one_of(words: &str, word: &str) -> bool {
    words.split(' ').any(|known| known == word)
}

/// A word without the digits around it, as in `2sigma` and `ci95`.
fn plain(word: &str) -> String {
    word.trim_matches(|character: char| character.is_ascii_digit()).to_lowercase()
}

/// The words that are left of a name that says "error", of whatever it may be; none when it does not say so.
pub fn of_what(words: &[String]) -> Option<Vec<String>> {
    let says_error = |(index, word): (usize, &String)| {
        let plain = plain(word);
        is_one_of(ERRORS, &plain)
            || (index > 0 && plain == "sigma")
            || ["error", "uncertainty", "stdev"].iter().any(|end| plain.ends_with(end))
            || ["Err", "Std"].iter().any(|end| word.ends_with(end))
    };
    let others = words.iter().enumerate().filter(|word| !says_error(*word));
    let others: Vec<String> = others.map(|(_, word)| word.to_lowercase()).collect();
    (others.len() < words.len()).then_some(others)
}

/// Whether a column has a name; blanks around it and its case do not matter.
pub fn is_named(column: &str, name: &str) -> bool {
    column.trim().eq_ignore_ascii_case(name)
}
