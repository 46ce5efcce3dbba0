//! What Coq says that each theorem assumes.

/// The axioms of the real numbers in Coq's library, and those of classical logic on which they rest.
const ALLOWED: [&str; 4] = [
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
];

/// The assumptions of each theorem, in the order in which they were asked for.
pub fn listed(output: &str) -> Vec<Vec<String>> {
    let mut lists: Vec<Vec<String>> = Vec::new();
    for line in output.lines() {
        match line {
            "Axioms:" | "Closed under the global context" => lists.push(Vec::new()),
            // The type of an axiom stands on lines that begin with spaces, and may begin on the axiom's own.
            _ if line.starts_with(' ') || line.is_empty() => {}
            _ => {
                let name = line.split([' ', ':']).next().unwrap_or(line);
                lists.last_mut().into_iter().for_each(|list| list.push(name.to_owned()));
            }
        }
    }
    lists
}

/// The assumptions that no theorem may have.
pub fn refused(list: &[String]) -> Vec<&str> {
    list.iter().map(String::as_str).filter(|name| !ALLOWED.contains(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_theorem_has_its_list_and_an_axiom_of_ones_own_is_refused() {
        let output = "Axioms:\nClassicalDedekindReals.sig_forall_dec\n  : forall P : nat -> Prop,\n    True\n\
                      Closed under the global context\nAxioms:\nmine : 1 = 2\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n";
        let lists = listed(output);
        assert_eq!(lists.len(), 3);
        assert_eq!(lists[0], ["ClassicalDedekindReals.sig_forall_dec"]);
        assert!(lists[1].is_empty() && refused(&lists[0]).is_empty());
        assert_eq!(refused(&lists[2]), ["mine"]);
    }
}
