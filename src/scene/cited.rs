//! How texts cite equations: by their roles, with the numbers that the first paper's file of equations gives them.

use std::collections::BTreeMap;
use std::sync::LazyLock;

const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

/// The numbers of the equations by their roles. Each key of this file stands on a line of its own: a reader of TOML took a sixth
/// of the time of a short command.
static NUMBERS: LazyLock<BTreeMap<&str, &str>> = LazyLock::new(|| {
    let mut number = "";
    let role = |line: &'static str| {
        let (key, value) = line.split_once(" = ")?;
        let value = value.trim_matches('"');
        if key == "number" {
            number = value;
        }
        (key == "role").then_some((value, number))
    };
    EQUATIONS.lines().filter_map(role).collect()
});

/// A text in which the words of roles in braces stand for equations: `{inertial-upper}` for eq 18, and
/// `{inertial-upper, inertial-lower}` for eqs 18 and 20. Other braces stay.
#[must_use]
pub fn cited(text: &str) -> String {
    let mut parts = text.split('{');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |found, part| {
        let cited = part.split_once('}').and_then(|(roles, rest)| Some(equations(roles)? + rest));
        found + &cited.unwrap_or_else(|| format!("{{{part}"))
    })
}

/// `eq 15`, `eqs 15 and 16`, or `eqs 15, 16, 18 and 20`; none where a word is no role.
fn equations(roles: &str) -> Option<String> {
    let numbers: Option<Vec<&str>> = roles.split(',').map(|role| NUMBERS.get(role.trim()).copied()).collect();
    Some(match &numbers?[..] {
        [one] => format!("eq {one}"),
        [first @ .., last] => format!("eqs {} and {last}", first.join(", ")),
        [] => String::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_theory::Role;

    #[test]
    fn roles_stand_for_the_numbers_of_the_first_paper() {
        for role in Role::ALL {
            assert!(cited(&format!("{{{}}}", role.as_str())).starts_with("eq "), "{role:?}");
        }
        let file: toml::Table = EQUATIONS.parse().unwrap();
        let equations = file["equation"].as_array().unwrap();
        let word = |equation: &toml::Value, key: &str| Some(equation.get(key)?.as_str()?.to_owned());
        let read = equations.iter().filter_map(|one| Some((word(one, "role")?, word(one, "number")?)));
        let scanned = NUMBERS.iter().map(|(role, number)| ((*role).to_owned(), (*number).to_owned()));
        assert_eq!(scanned.collect::<BTreeMap<_, _>>(), read.collect());
        assert_eq!(cited("A {inertial-upper} b."), "A eq 18 b.");
        assert_eq!(cited("{quasi-static-upper, quasi-static-lower}"), "eqs 15 and 16");
        let all = "{quasi-static-upper, quasi-static-lower, inertial-upper, inertial-lower}";
        assert_eq!(cited(all), "eqs 15, 16, 18 and 20");
        assert_eq!(cited("no role, {none} {\\frac{1}{2}"), "no role, {none} {\\frac{1}{2}");
    }
}
