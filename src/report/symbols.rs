//! Mathematics in plain words: `K_c,qs`, `1e-5`, `V*theta` and `x^2` as they are set in print.

use slipmode_plot::table::escape_html;

/// The words as HTML, everything in them escaped.
///
/// A symbol is one letter, an underscore and an index of ASCII letters and digits, which may hold single commas; or the name of a Greek
/// letter with such an index. Another Latin letter before it, or a second underscore, makes it the name of something in a program, which
/// stays as it is. Numbers with exponents are set with powers of ten; `^`, `*`, `->`, `>=` and minus signs are set as in formulas.
pub(crate) fn set_symbols(words: &str) -> String {
    let mut html = String::with_capacity(words.len());
    let (mut rest, mut before) = (words, None);
    while let Some(first) = rest.chars().next() {
        let found = [number, name, raised, sign].iter().find_map(|rule| rule(before, rest));
        let (set, length) =
            found.unwrap_or_else(|| (escape_html(&rest[..first.len_utf8()]), first.len_utf8()));
        html += &set;
        before = rest[..length].chars().next_back();
        rest = &rest[length..];
    }
    html
}

/// What is set in the place of the first bytes, and their number.
type Set = Option<(String, usize)>;

/// `6.1e-7`; other numbers stay.
fn number(before: Option<char>, rest: &str) -> Set {
    let starts = rest.starts_with(|c: char| c.is_ascii_digit())
        && !before.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '-' | '/'));
    let word = run(rest, |c| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_')).trim_end_matches('.');
    let (mantissa, exponent) = word.split_once('e').filter(|_| starts)?;
    let is_decimal = mantissa.ends_with(|c: char| c.is_ascii_digit())
        && mantissa.split('.').count() <= 2
        && mantissa.chars().all(|c| c.is_ascii_digit() || c == '.');
    if !is_decimal || exponent.parse::<i32>().is_err() {
        return None;
    }
    let ten = format!("10<sup>{}</sup>", exponent.replace('-', "−"));
    Some((if mantissa == "1" { ten } else { format!("{mantissa} × {ten}") }, word.len()))
}

/// The names of the Greek letters that are set, and the letters.
const GREEK: [&str; 2] = [
    "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu rho sigma tau phi omega Delta",
    "αβγδεζηθκλμρστφωΔ",
];

/// The Greek letter of this name.
fn greek(name: &str) -> Option<char> {
    let mut letters = GREEK[0].split(' ').zip(GREEK[1].chars());
    letters.find(|(known, _)| *known == name).map(|(_, letter)| letter)
}

/// A symbol, or a word that stays.
fn name(before: Option<char>, rest: &str) -> Set {
    let first = rest.chars().next().filter(|c| c.is_alphabetic())?;
    if before.is_some_and(|c| c.is_ascii_alphabetic() || c == '_') {
        return None;
    }
    let word = run(rest, |c| c.is_ascii_alphanumeric() || c == '_');
    let letters = run(word, |c| c.is_ascii_alphabetic());
    let in_a_word = before == Some('-')
        || rest[letters.len()..].starts_with('-') && !rest[letters.len()..].starts_with("->");
    let greek = greek(letters).filter(|_| !in_a_word);
    if letters == "Delta" && rest[letters.len()..].starts_with('_') {
        let (set, length) = name(None, &rest[letters.len() + 1..])?;
        return Some((format!("Δ{set}"), letters.len() + 1 + length));
    }
    if letters == "sqrt" && rest[letters.len()..].starts_with('(') {
        return Some(("√".into(), letters.len()));
    }
    let (letter, length) = greek.map_or((first, first.len_utf8()), |letter| (letter, letters.len()));
    let tail = &rest[length..];
    let index = match tail.strip_prefix('_') {
        Some(after) => Some(index_of(after)).filter(|index| !after[index.len()..].starts_with('_')),
        None if !before.is_some_and(char::is_alphanumeric) && is_index_zero(tail) => Some("0"),
        None => None,
    };
    match index.filter(|index| !index.is_empty()) {
        Some(index) => {
            let underscore = usize::from(tail.starts_with('_'));
            Some((format!("{letter}<sub>{index}</sub>"), length + underscore + index.len()))
        }
        None if greek.is_some() => Some((letter.into(), length)),
        None if word.is_empty() => None,
        None => Some((escape_html(word), word.len())),
    }
}

/// Whether the name before this is that of a reference value, such as `V0`.
fn is_index_zero(tail: &str) -> bool {
    // A raised digit is no part of the name.
    let goes_on = |c: char| c.is_alphabetic() || c.is_ascii_digit() || c == '_';
    tail.strip_prefix('0').is_some_and(|after| !after.starts_with(goes_on))
}

/// A power: `^2`, `^(1/3)`, or raised digits with a raised point.
fn raised(before: Option<char>, rest: &str) -> Set {
    const DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻·";
    let run_of_raised = run(rest, |c| DIGITS.contains(c)).trim_end_matches('·');
    if run_of_raised.contains('·') && !run_of_raised.starts_with('·') {
        let plain = |c: char| "0123456789−.".chars().nth(DIGITS.chars().position(|raised| raised == c)?);
        return Some((
            format!("<sup>{}</sup>", run_of_raised.chars().filter_map(plain).collect::<String>()),
            run_of_raised.len(),
        ));
    }
    let exponent =
        rest.strip_prefix('^').filter(|_| before.is_some_and(|c| c.is_alphanumeric() || c == ')'))?;
    let (inner, length) = match exponent.strip_prefix('(') {
        Some(inside) => {
            let end = closing(inside)?;
            (&inside[..end], end + 2)
        }
        None => {
            let minus = usize::from(exponent.starts_with('-'));
            let end = minus
                + run(&exponent[minus..], |c| c.is_alphanumeric() || c == '.').trim_end_matches('.').len();
            (&exponent[..end], end)
        }
    };
    (!inner.is_empty()).then(|| (format!("<sup>{}</sup>", set_symbols(inner)), 1 + length))
}

/// Where the parenthesis that is open at the start closes.
fn closing(inside: &str) -> Option<usize> {
    let mut depth = 1;
    inside.char_indices().find_map(|(at, c)| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        (depth == 0).then_some(at)
    })
}

/// Signs between symbols and before numbers.
fn sign(before: Option<char>, rest: &str) -> Set {
    const SPELLED: [(&str, &str); 5] = [("->", "→"), (">=", "≥"), ("<=", "≤"), ("!=", "≠"), (" - ", " − ")];
    let spelled = SPELLED.iter().find(|(plain, _)| rest.starts_with(plain));
    if let Some((plain, set)) = spelled {
        // The last blank of ` - ` may begin something else.
        return Some(((*set).trim_end().into(), plain.trim_end().len()));
    }
    let mut signs = rest.chars();
    let (first, after) = (signs.next()?, signs.next()?);
    let opens = before.is_none_or(|c| matches!(c, ' ' | '(' | '[' | '|' | '{'));
    let joins = before.is_some_and(|c| c.is_alphanumeric() || matches!(c, ')' | '\''));
    match first {
        '-' if opens && after.is_ascii_digit() => {
            let (set, length) = number(None, &rest[1..]).unwrap_or_default();
            Some((format!("−{set}"), 1 + length))
        }
        '-' if opens && after == '(' => Some(("−".into(), 1)),
        '-' if opens && is_symbol(&rest[1..]) => {
            let (set, length) = name(None, &rest[1..])?;
            Some((format!("−{set}"), 1 + length))
        }
        '*' if joins && (after.is_alphanumeric() || after == '(') => Some(("·".into(), 1)),
        _ => None,
    }
}

/// Whether the text begins with a letter that stands for itself, or the name of a Greek one.
fn is_symbol(text: &str) -> bool {
    let letters = run(text, |c| c.is_ascii_alphabetic());
    letters.len() == 1 || greek(letters).is_some()
}

/// The index that the text begins with: a comma belongs to it when more of the index follows at once.
fn index_of(text: &str) -> &str {
    let bytes = text.as_bytes();
    let is_part = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_alphanumeric);
    let is_inner_comma = |at: usize| at > 0 && bytes.get(at) == Some(&b',') && is_part(at + 1);
    let end = (0..bytes.len()).find(|&at| !is_part(at) && !is_inner_comma(at));
    &text[..end.unwrap_or(bytes.len())]
}

/// The longest beginning that consists of such characters.
fn run(text: &str, belongs: impl Fn(char) -> bool) -> &str {
    &text[..text.find(|c| !belongs(c)).unwrap_or(text.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_go_below_the_line() {
        assert_eq!(set_symbols("K = K_c, or K_c,qs."), "K = K<sub>c</sub>, or K<sub>c,qs</sub>.");
        assert_eq!(set_symbols("M V_0²/(σ a D_c)"), "M V<sub>0</sub>²/(σ a D<sub>c</sub>)");
        assert_eq!(set_symbols("3σ_c/4, σD_c"), "3σ<sub>c</sub>/4, σD<sub>c</sub>");
        assert_eq!(set_symbols("ω_n < |p_measured|"), "ω<sub>n</sub> &lt; |p<sub>measured</sub>|");
        assert_eq!(set_symbols("V0², μ0 and mu_0"), "V<sub>0</sub>², μ<sub>0</sub> and μ<sub>0</sub>");
    }

    #[test]
    fn numbers_powers_and_signs_are_set() {
        for (plain, set) in [
            ("from 1e-6 to 6.1e-7.", "from 10<sup>−6</sup> to 6.1 × 10<sup>−7</sup>."),
            ("2^-52 of O(η^(1/3)) at 10^-5.5", "2<sup>−52</sup> of O(η<sup>1/3</sup>) at 10<sup>−5.5</sup>"),
            ("10⁻⁵·⁵ m/s, σ², x⁻¹·y", "10<sup>−5.5</sup> m/s, σ², x⁻¹·y"),
            ("-6.27e-5", "−6.27 × 10<sup>−5</sup>"),
            ("-eta·ω² = -w + (-V_0), -ish", "−η·ω² = −w + (−V<sub>0</sub>), -ish"),
            ("-0.49 to 0.32, (-1/4), V*theta - D_c/V", "−0.49 to 0.32, (−1/4), V·θ − D<sub>c</sub>/V"),
            ("Delta_theta'*a -> sqrt(K/M) >= 0", "Δθ'·a → √(K/M) ≥ 0".replace('\'', "&#39;").as_str()),
        ] {
            assert_eq!(set_symbols(plain), set);
        }
    }

    #[test]
    fn what_is_no_mathematics_stays() {
        let words = [
            "normal_stress_pa",
            "a_b_c",
            "_x",
            "x_",
            "x__y",
            "2026-11-29",
            "F1 and S10",
            "0x1e5",
            "a beta-test",
            "x^",
            "one-sided",
        ];
        for word in words.into_iter().chain(["1e", "7-12", "e-5", "--json", "3e5a", "alphabet"]) {
            assert_eq!(set_symbols(word), word);
        }
        assert_eq!(set_symbols("K_<b>&"), "K_&lt;b&gt;&amp;");
    }
}
