//! Proofs as a file states them.

use std::collections::BTreeMap;

/// The proofs of one file.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ProofsText {
    /// Names for expressions and derivations, which all proofs of the folder may use.
    #[serde(rename = "let")]
    pub names: BTreeMap<String, String>,
    /// Assumptions by name.
    pub domain: Vec<DomainText>,
    /// Steps that several proofs have.
    pub block: Vec<ProofText>,
    /// The proofs.
    pub proof: Vec<ProofText>,
}

/// What is assumed of variables.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DomainText {
    /// Its name; empty where a step states it.
    pub name: String,
    /// The domain to which it adds; empty for none.
    pub of: String,
    /// Variables that are positive.
    pub positive: Vec<String>,
    /// Conditions such as `b - a > 0`.
    pub given: Vec<String>,
    /// `eta = 1/x`: a variable in others. `a = alpha^2 where alpha = sqrt(a)`: by a positive parameter, which has this value.
    pub with: Vec<String>,
    /// `b = 2`: values at which all assumptions hold.
    pub example: Vec<String>,
}

/// One proof, or a block of steps.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ProofText {
    /// Its stable name.
    pub id: String,
    /// What is proved, in words; `{name}` stands for a named expression. A block has none.
    pub says: String,
    /// The domain of its steps.
    pub over: String,
    /// Names for expressions and derivations of its own.
    #[serde(rename = "let")]
    pub names: BTreeMap<String, String>,
    /// The steps in order.
    pub step: Vec<StepText>,
}

/// One step: what it says, and one of the kinds of steps.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct StepText {
    /// The step in words.
    pub says: String,
    /// Its domain, where that is not the proof's; `none` without assumptions.
    pub over: String,
    /// What is assumed besides.
    #[serde(rename = "where")]
    pub besides: DomainText,
    /// `left = right`.
    pub identity: Option<String>,
    /// An expression that is positive.
    pub positive: Option<String>,
    /// An expression that is negative.
    pub negative: Option<String>,
    /// A polynomial that has a root.
    pub root: Option<RootText>,
    /// A limit.
    pub limit: Option<LimitText>,
    /// An expression that vanishes at 0 and then grows.
    pub growth: Option<GrowthText>,
    /// Coordinates, `eta = ...`, that make the image of all positive values of the variables one connected set.
    pub connected: Option<Vec<String>>,
    /// The expression has this value at a point: `expression = value`, with the point in `at`.
    pub value: Option<ValueText>,
    /// Two sides have different values at a point.
    pub difference: Option<DifferenceText>,
    /// A step argued in words: `says` has them.
    pub argued: bool,
    /// The steps of a block, by its name.
    pub block: Option<String>,
    /// The proof of a lemma, by its name.
    pub lemma: Option<String>,
}

/// A polynomial with a root.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RootText {
    /// The polynomial.
    pub of: String,
    /// Its variable.
    #[serde(rename = "in")]
    pub variable: String,
    /// What the root is above; none for minus infinity.
    pub above: Option<String>,
    /// What the root is below; none for infinity.
    pub below: Option<String>,
}

/// A limit.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LimitText {
    /// What has the limit.
    pub of: String,
    /// The variable that moves.
    #[serde(rename = "in")]
    pub variable: String,
    /// `0` or `infinity`.
    pub to: String,
    /// The limit.
    pub is: String,
}

/// A growth.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GrowthText {
    /// What grows.
    pub of: String,
    /// The variable in which it does.
    #[serde(rename = "in")]
    pub variable: String,
    /// The order to which it vanishes at 0.
    pub order: u32,
}

/// A value at a point.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ValueText {
    /// What is evaluated.
    pub of: String,
    /// The point, `eta = 5/4`.
    pub at: Vec<String>,
    /// The value.
    pub is: String,
}

/// Two sides with different values at a point.
#[derive(Debug, Clone, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DifferenceText {
    /// One side.
    pub left: String,
    /// The other side.
    pub right: String,
    /// The point, `eta = 5/4`.
    pub at: Vec<String>,
    /// The values of both, in this order.
    pub are: [String; 2],
}
