//! What Coq says that theorems assume.

/// The axioms of the real numbers in Coq's library, and those of classical logic on which they rest.
const ALLOWED: &str = include_str!("../../axioms.txt");

/// The axioms that the theorems of a file assume together, so that each of them assumes no other; none when Coq has not said.
pub fn listed(output: &str) -> Option<Vec<&str>> {
    let mut axioms = None;
    for line in output.lines() {
        match line {
            "Axioms:" | "Closed under the global context" if axioms.is_none() => axioms = Some(Vec::new()),
            // The type of an axiom stands on lines that begin with spaces, and may begin on the axiom's own.
            _ if line.starts_with(' ') || line.is_empty() => {}
            _ => axioms.as_mut()?.push(line.split([' ', ':']).next().unwrap_or(line)),
        }
    }
    axioms
}

/// The assumptions that no theorem may have.
pub fn refused<'a>(axioms: &[&'a str]) -> Vec<&'a str> {
    axioms.iter().copied().filter(|name| !ALLOWED.lines().any(|known| known == *name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axiom_of_ones_own_and_an_output_without_a_list_are_refused() {
        let known = "Axioms:\nClassicalDedekindReals.sig_forall_dec\n  : forall P : nat -> Prop,\n    True\n";
        let own = "mine : 1 = 2\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n";
        assert_eq!(listed(known), Some(vec!["ClassicalDedekindReals.sig_forall_dec"]));
        assert!(refused(&listed(known).unwrap()).is_empty());
        assert_eq!(refused(&listed(&format!("{known}{own}")).unwrap()), ["mine"]);
        assert_eq!(listed("Closed under the global context\n"), Some(Vec::new()));
        assert_eq!(listed(""), None);
        // What two lists say is no list of the first.
        assert!(refused(&listed("Closed under the global context\nAxioms:\n").unwrap()) == ["Axioms"]);
    }
}
