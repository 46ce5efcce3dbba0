//! The names of the variables of one folder, chosen to be mistaken for names of the program's own.

use super::term::Name;
use crate::random::Random;

/// How many positive variables a folder has.
pub const POSITIVE: usize = 6;

/// How many variables of either sign a folder has.
pub const FREE: usize = 4;

/// The longest name of a variable.
const LONGEST: usize = 40;

/// How a folder spells its variables.
#[derive(Debug, Clone)]
pub struct World {
    positive: Vec<String>,
    free: Vec<String>,
    function: String,
    root: String,
    /// What the names of definitions begin with.
    prefix: &'static str,
}

/// Names that proofs use for what they introduce.
const OF_PROOFS: [&str; 40] = [
    "gap_0",
    "gap_1",
    "gap_of_roots",
    "gap_of_region",
    "root_a",
    "root_b",
    "root_x",
    "root_smaller",
    "root_of_polynomial",
    "other_value",
    "low",
    "high",
    "least",
    "most",
    "c_0",
    "c_1",
    "c_2",
    "c_3",
    "d_0",
    "d_1",
    "x_1",
    "x_2",
    "x_3",
    "sqrt_x",
    "ln_x",
    "exp_x",
    "e",
    "i1",
    "pm_1",
    "t",
    "h",
    "h_s",
    "omega",
    "given",
    "given1",
    "fact1",
    "square",
    "value",
    "eta",
    "single",
];

/// Words of Coq.
const OF_COQ: [&str; 24] = [
    "fun",
    "forall",
    "exists",
    "end",
    "R",
    "C",
    "Ci",
    "IZR",
    "Rabs",
    "Type",
    "Set",
    "Prop",
    "let",
    "fix",
    "match",
    "return",
    "Definition",
    "Theorem",
    "Qed",
    "intros",
    "ring",
    "field",
    "lra",
    "nat",
];

/// Words of the grammar, Greek names, names that differ in case only, and plain ones.
const OTHERS: [&str; 48] = [
    "as",
    "at",
    "with",
    "on",
    "rises",
    "falls",
    "depends",
    "infinity",
    "stable",
    "unstable",
    "left",
    "right",
    "residual",
    "solve",
    "limit",
    "rate",
    "coefficient",
    "theta",
    "Theta",
    "sigma",
    "mu",
    "alpha",
    "beta",
    "pi",
    "lambda",
    "a",
    "b",
    "A",
    "B",
    "k",
    "K",
    "v",
    "V",
    "V_c",
    "K_c",
    "D_c",
    "x",
    "X",
    "y",
    "s",
    "S",
    "not",
    "and",
    "or",
    "implies",
    "all_real",
    "pair_crosses",
    "iff",
];

/// Names of variables that no function may have: before a bracket they are derivations or predicates.
const IN_DEFINITIONS: [&str; 8] =
    ["stable", "unstable", "all_real", "pair_crosses", "solve", "limit", "rate", "coefficient"];

/// Names for the roots of a polynomial.
const ROOTS: [&str; 6] = ["s", "s", "lambda", "root_of_polynomial", "z", "c_0"];

/// All names that a folder may use.
pub fn pool() -> impl Iterator<Item = &'static str> {
    OF_PROOFS.into_iter().chain(OF_COQ).chain(OTHERS)
}

impl World {
    /// Names drawn from those that the program accepts, half of them from those of proofs.
    pub fn drawn(random: &mut Random, accepted: &[&str]) -> Self {
        let root = *random.pick(&ROOTS);
        let mut names: Vec<String> = Vec::new();
        while names.len() < POSITIVE + FREE + 1 {
            let name = match random.below(6) {
                0..=2 => (*random.pick(&OF_PROOFS)).to_owned(),
                // A proof puts root_x in the place of sqrt(x).
                3 if !names.is_empty() => format!("root_{}", random.pick(&names)),
                _ => (*random.pick(accepted)).to_owned(),
            };
            let is_known = *name == *root || names.contains(&name) || name.len() > LONGEST;
            if !is_known && (accepted.contains(&name.as_str()) || name.starts_with("root_")) {
                names.push(name);
            }
        }
        random.shuffle(&mut names);
        let function = names.pop().filter(|name| !IN_DEFINITIONS.iter().any(|word| name.ends_with(word)));
        let function = function.unwrap_or_else(|| "f".repeat(LONGEST - 2));
        let free = names.split_off(POSITIVE);
        let prefix = random.pick(&["W", "gap_", "root_", "c_", "left_"]);
        Self { positive: names, free, function, root: root.to_owned(), prefix }
    }

    /// Names that mean nothing to anybody.
    pub fn plain() -> Self {
        let numbered = |letter: &str, count| (0..count).map(|index| format!("{letter}{index}")).collect();
        let [function, root] = ["f", "s"].map(str::to_owned);
        Self { positive: numbered("p", POSITIVE), free: numbered("f", FREE), function, root, prefix: "W" }
    }

    /// A name in a claim of this number.
    pub fn spell(&self, name: Name, claim: usize) -> String {
        match name {
            Name::Positive(index) => self.positive[index].clone(),
            Name::Free(index) => self.free[index].clone(),
            Name::Function => self.function.clone(),
            Name::Root => self.root.clone(),
            Name::Defined(index) => format!("{}{claim}_{index}", self.prefix),
        }
    }

    /// The assumptions of `equations.toml`.
    pub fn toml(&self) -> String {
        format!(
            "[assumptions]\npositive = {:?}\nfree = {:?}\n[[function]]\nname = {:?}\n",
            self.positive, self.free, self.function
        )
    }
}
