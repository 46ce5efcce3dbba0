//! Licence expressions such as `(MIT OR Apache-2.0) AND Unicode-3.0`, decided against a list of allowed licences.

/// Whether an expression can be satisfied with licences that `allowed` accepts.
///
/// `OR` and the older `/` ask for one side, `AND` for both; a `WITH` exception belongs to the name before it.
/// An empty or malformed expression is not satisfied.
pub fn is_satisfied(expression: &str, allowed: &dyn Fn(&str) -> bool) -> bool {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let tokens: Vec<&str> = spaced.split_whitespace().collect();
    let mut reader = Reader { tokens: &tokens, allowed };
    reader.any_of() == Some(true) && reader.tokens.is_empty()
}

struct Reader<'a> {
    tokens: &'a [&'a str],
    allowed: &'a dyn Fn(&str) -> bool,
}

impl<'a> Reader<'a> {
    fn any_of(&mut self) -> Option<bool> {
        let mut satisfied = self.all_of()?;
        while self.take("OR") {
            satisfied |= self.all_of()?;
        }
        Some(satisfied)
    }

    fn all_of(&mut self) -> Option<bool> {
        let mut satisfied = self.single()?;
        while self.take("AND") {
            satisfied &= self.single()?;
        }
        Some(satisfied)
    }

    fn single(&mut self) -> Option<bool> {
        if self.take("(") {
            let inner = self.any_of()?;
            return self.take(")").then_some(inner);
        }
        let name = self.next().filter(|token| !matches!(*token, ")" | "OR" | "AND" | "WITH"))?;
        let full = if self.take("WITH") { format!("{name} WITH {}", self.next()?) } else { name.to_string() };
        Some((self.allowed)(&full))
    }

    fn next(&mut self) -> Option<&'a str> {
        let (first, rest) = self.tokens.split_first()?;
        self.tokens = rest;
        Some(first)
    }

    fn take(&mut self, token: &str) -> bool {
        let matches = self.tokens.first() == Some(&token);
        if matches {
            self.tokens = &self.tokens[1..];
        }
        matches
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn permissive(licence: &str) -> bool {
        matches!(licence, "MIT" | "Unicode-3.0" | "Apache-2.0 WITH LLVM-exception")
    }

    #[test]
    fn one_side_of_or_and_both_sides_of_and_are_needed() {
        for good in [
            "MIT",
            "GPL-3.0 OR MIT",
            "GPL-3.0/MIT",
            "(MIT OR GPL-3.0) AND Unicode-3.0",
            "Apache-2.0 WITH LLVM-exception OR GPL-3.0",
        ] {
            assert!(is_satisfied(good, &permissive), "{good}");
        }
        for bad in ["GPL-3.0", "MIT AND GPL-3.0", "(GPL-3.0 OR MIT) AND GPL-3.0", "Apache-2.0"] {
            assert!(!is_satisfied(bad, &permissive), "{bad}");
        }
    }

    #[test]
    fn what_is_not_an_expression_is_not_satisfied() {
        for bad in ["", "MIT OR", "(MIT", "MIT)", "MIT MIT", "OR MIT", "MIT WITH"] {
            assert!(!is_satisfied(bad, &permissive), "{bad:?}");
        }
    }
}
