//! Certificates as theorems in the language of Coq, a proof assistant whose kernel is small and independent of this program.
//!
//! The theorem speaks of the original variables. Each assumption of the domain is a hypothesis. What the domain substitutes
//! is no hypothesis: a lemma shows that the substitution reaches every point of the assumptions. A second lemma shows that
//! the hypotheses hold somewhere. The converter's normal forms are hints only: Coq proves each of them.

mod characteristic;
mod setting;
mod sign;
mod statement;
mod tactic;
mod term;

use std::collections::{BTreeMap, BTreeSet};

use setting::Setting;
use statement::Statement;
use tactic::Tactics;

use super::{Certificate, ConversionError, Domain, Expression, Function, Symbol};

/// Why a certificate has no theorem yet.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Obstacle(String);

impl From<ConversionError> for Obstacle {
    fn from(error: ConversionError) -> Self {
        Self(error.to_string())
    }
}

/// A real expression as Coq reads it.
#[must_use]
pub fn text(expression: &Expression) -> String {
    term::real(expression)
}

/// A named part of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// The name of the lemma or theorem.
    pub name: String,
    /// Its statement and proof.
    pub text: String,
}

/// A certificate as a theorem.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Theorem {
    /// The theorem's name: the certificate's kind and a digest.
    pub name: String,
    /// The variables that the theorem is about, in the order of its arguments.
    pub variables: Vec<String>,
    /// Lemmas on the domain, which several theorems of a file can share.
    pub lemmas: Vec<Block>,
    /// The theorem with its proof.
    pub text: String,
    /// An altered statement, of which Coq has to refuse the same proof.
    pub fault: String,
}

impl Theorem {
    /// The theorem of a certificate.
    ///
    /// # Errors
    /// What stands in the way.
    pub fn of(certificate: &Certificate) -> Result<Self, Obstacle> {
        let point = point_domain(certificate);
        let domain = certificate.domain().unwrap_or(&point);
        let parts = certificate.expressions().into_iter().chain(domain.expressions());
        if let Some(function) = parts.flat_map(Expression::functions).next() {
            return Err(Obstacle(format!(
                "no tactic for the function {function}, of which nothing is known"
            )));
        }
        let statement = Statement::of(certificate, domain)?;
        let complex =
            if statement.is_complex { complex_variables(domain, &statement) } else { BTreeSet::new() };
        let (bound, nonzero) = (statement.bound.clone(), statement.nonzero.clone());
        let setting = Setting { domain, complex, is_complex: statement.is_complex, bound, nonzero };
        let name = format!("{}_{}", certificate.kind(), digest(&certificate.to_string()));
        let terms = statement.terms();
        let (original, substituted) = (setting.original(&terms), setting.substituted(&terms));
        if let Some(bound) = statement.bound.iter().find(|bound| original.mentions(bound)) {
            return Err(Obstacle(format!(
                "an assumption or definition contains {bound}, which the statement binds"
            )));
        }
        let tactics = format!("{}{}", Tactics(domain).facts()?, statement.tactics);
        let shown = |altered: bool, written: bool| {
            statement.text(altered, |part| {
                let part = if written { domain.as_written(part) } else { part.clone() };
                setting.term(&part)
            })
        };
        let binders = substituted.text();
        let mut lemmas = Vec::new();
        let written = shown(false, true);
        let text = if setting.is_plain() {
            format!("Theorem {name}{binders} :\n  {written}.\nProof. {tactics}. Qed.\n")
        } else if domain.conditions().iter().any(|one| one.expression.calls(Function::Abs)) {
            return Err(Obstacle(
                "no tactic for a condition with an absolute value in other variables".into(),
            ));
        } else {
            lemmas.extend(setting.cover()?);
            format!(
                "Lemma {name}_substituted{binders} :\n  {written}.\nProof. {tactics}. Qed.\n\nTheorem {name}{} :\n  {}.\nProof. {}. Qed.\n",
                original.text(),
                shown(false, false),
                setting.transfer(&original, &substituted, &format!("{name}_substituted")),
            )
        };
        lemmas.extend(setting.witness(&original));
        let proofs: String = lemmas.iter().map(|lemma| lemma.text.as_str()).chain([text.as_str()]).collect();
        lemmas.splice(0..0, sign::lemmas_for(&proofs));
        let fault = format!(
            "Lemma fault_{name}{binders} :\n  {}.\nProof. tryif (solve [{tactics}]) then fail 0 \"accepted\" else idtac \"refused {name}\". Abort.\n",
            shown(true, true)
        );
        Ok(Self { name, variables: original.names(), lemmas, text, fault })
    }
}

impl Certificate {
    /// The expressions of the fact, without those of its assumptions.
    fn expressions(&self) -> Vec<&Expression> {
        match self {
            Self::Identity { left, right, .. } => vec![left, right],
            Self::Difference { left, right, values: [a, b], .. } => vec![left, right, a, b],
            Self::Limit { expression, value, .. }
            | Self::Derivative { expression, value, .. }
            | Self::Value { expression, value, .. } => vec![expression, value],
            Self::Sign { expression, .. }
            | Self::Divergence { expression, .. }
            | Self::Growth { expression, .. } => {
                vec![expression]
            }
            Self::Characteristic { system, polynomial, .. } => {
                let slopes = system.slopes.iter().flatten();
                system.rates.iter().chain(&system.steady).chain(slopes).chain([polynomial]).collect()
            }
            Self::Series { relation, coefficients, .. } => {
                [relation].into_iter().chain(coefficients).collect()
            }
            Self::Root { polynomial, between, .. } => {
                [polynomial].into_iter().chain(between.iter().flatten()).collect()
            }
            Self::Connected { image, .. } => image.iter().map(|(_, coordinate)| coordinate).collect(),
        }
    }
}

/// The point of a value or difference as a domain in which the variables are defined.
fn point_domain(certificate: &Certificate) -> Domain {
    match certificate {
        Certificate::Difference { point, .. } | Certificate::Value { point, .. } => {
            point.iter().fold(Domain::default(), |domain, (name, value)| domain.with(name, value.clone()))
        }
        _ => Domain::default(),
    }
}

/// Variables without any assumption, and what is defined by them or by i, are complex where a statement has i.
fn complex_variables(domain: &Domain, statement: &Statement) -> BTreeSet<Symbol> {
    let imaginary = Symbol::from("i");
    let mut calls = BTreeMap::new();
    let written: Vec<Expression> = statement.terms().iter().map(|part| domain.as_written(part)).collect();
    written.iter().for_each(|part| term::outer_calls(part, &mut calls));
    let inner: BTreeSet<Symbol> = calls.values().flat_map(Expression::variables).collect();
    let free = |name: &Symbol| {
        *name != imaginary
            && name.as_str() != "pm"
            && !domain.is_positive(name)
            && domain.is_unbound(name)
            && !inner.contains(name)
    };
    let mut complex: BTreeSet<Symbol> = written.iter().flat_map(Expression::variables).filter(free).collect();
    let defined = domain.substitutions().iter().filter(|(name, value)| {
        let used = value.variables();
        !domain.is_assumed(name) && (used.contains(&imaginary) || !used.is_disjoint(&complex))
    });
    let defined: Vec<Symbol> = defined.map(|(name, _)| name.clone()).collect();
    complex.extend(defined);
    complex
}

/// A short name for a text: FNV-1a in 64 bits.
fn digest(text: &str) -> String {
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests;
