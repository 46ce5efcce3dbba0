//! The cubic coefficient of the normal form of three equations by projection on the critical eigenvectors (Kuznetsov's formula).

use super::expansion::{Conditions, in_basis, solve, taylor_part};
use crate::notation::{formula, simplified};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

pub(crate) type Vector = [Expression; 3];

/// The Taylor parts of the rates: linear, quadratic (half of B) and cubic (a sixth of C) forms in the state.
type Forms = [Vector; 3];

/// Three equations of first order that rest at the origin, with a pair of roots on the imaginary axis.
pub(crate) struct Critical<'c> {
    /// The state variables.
    pub state: [&'static str; 3],
    /// Their rates.
    pub rates: Vector,
    /// The state in words, and where the pair is on the axis.
    pub names: &'c str,
    /// The angular frequency of the pair.
    pub frequency: Expression,
    /// The assumptions.
    pub domain: Domain,
    /// An eigenvector of the pair, and one of the adjoint matrix of any length.
    pub eigenvectors: [Vector; 2],
    /// The second one in words, once its product with the first one is 1.
    pub adjoint_says: &'c str,
}

/// Derives c_1 of w' = iω w + c_1 w |w|², where a state variable is w + w̄ + … if its component of the eigenvector is 1.
///
/// # Errors
/// When ±iω is no pair of roots with these eigenvectors.
pub(crate) fn coefficient(
    proof: Proof,
    used: &[&str],
    critical: &Critical<'_>,
) -> Result<(Proof, Expression), Refutation> {
    let (proof, [linear, quadratic, cubic]) = forms(proof, used, critical)?;
    let (proof, [q, p], domain) = eigenvectors(proof, used, critical, &linear)?;
    let conjugate = each(|n| q[n].with("i", &formula("-i")));
    let (names, rate) = (["h11_1", "h11_2", "h11_3"], formula("0"));
    let (source, says) = (critical.polar(&quadratic, &q, &conjugate), "h_11: 0 = A h_11 + B(q, q̄)");
    let mean = Resolvent { names, rate, source, says, critical, linear: &linear };
    let (proof, h11, domain) = mean.solve(proof, used, domain)?;
    let (names, rate) = (["h20_1", "h20_2", "h20_3"], formula("2*i") * critical.frequency.clone());
    let source = each(|n| formula("2") * critical.at(&quadratic[n], &q));
    let says = "h_20: 2iω h_20 = A h_20 + B(q, q)";
    let double = Resolvent { names, rate, source, says, critical, linear: &linear };
    let (proof, h20, domain) = double.solve(proof, used, domain)?;
    let cubic = critical.third(&cubic, &q, &conjugate);
    let direct = critical.polar(&quadratic, &q, &h11);
    let harmonic = critical.polar(&quadratic, &conjugate, &h20);
    let sum = each(|n| cubic[n].clone() + formula("2") * direct[n].clone() + harmonic[n].clone());
    let (proof, sum) = simplify(proof, used, "C(q, q, q̄) + 2 B(q, h_11) + B(q̄, h_20)", &sum, &domain)?;
    let value = dot(&p, &sum) / formula("2");
    let stated = simplified(&proof, used, &value, &domain)?;
    let says = "c_1 = ⟨p, C(q, q, q̄) + 2 B(q, h_11) + B(q̄, h_20)⟩/2";
    Ok((proof.identity(says, used, &value, &stated, &domain)?, stated))
}

/// A vector in lowest terms, with its certificate.
fn simplify(
    proof: Proof,
    used: &[&str],
    says: &str,
    vector: &Vector,
    domain: &Domain,
) -> Result<(Proof, Vector), Refutation> {
    let mut stated = each(|_| formula("0"));
    for (part, value) in stated.iter_mut().zip(vector) {
        *part = simplified(&proof, used, value, domain)?;
    }
    Ok((proof.identity(says, used, &in_basis(vector), &in_basis(&stated), domain)?, stated))
}

/// The Taylor parts, each with its certificate.
fn forms(proof: Proof, used: &[&str], critical: &Critical<'_>) -> Result<(Proof, Forms), Refutation> {
    let part = |proof: Proof, degree: i32, name: &str| {
        let derived = each(|n| taylor_part(&critical.rates[n], &critical.state, degree));
        let says = format!("{name} part of the rates of {}", critical.names);
        simplify(proof, used, &says, &derived, &critical.domain)
    };
    let (proof, linear) = part(proof, 1, "linear")?;
    let (proof, quadratic) = part(proof, 2, "quadratic")?;
    let (proof, cubic) = part(proof, 3, "cubic")?;
    Ok((proof, [linear, quadratic, cubic]))
}

/// q, and p with ⟨p, q⟩ = 1, certified; the domain gains the values of p.
///
/// Real denominators keep the arithmetic small.
fn eigenvectors(
    proof: Proof,
    used: &[&str],
    critical: &Critical<'_>,
    linear: &Vector,
) -> Result<(Proof, [Vector; 2], Domain), Refutation> {
    let [q, adjoint] = &critical.eigenvectors;
    let length = dot(adjoint, q);
    let scaled = each(|n| adjoint[n].clone() / length.clone());
    let (proof, values) = simplify(proof, used, critical.adjoint_says, &scaled, &critical.domain)?;
    let (p, domain) = named(["p_1", "p_2", "p_3"], &values, critical.domain.clone());
    let rate = || formula("i") * critical.frequency.clone();
    let image = each(|n| critical.at(&linear[n], q));
    let rotated = each(|n| rate() * q[n].clone());
    let row = dot(&p, linear);
    let row = each(|n| row.derivative(&Symbol::from(critical.state[n])));
    let turned = each(|n| rate() * p[n].clone());
    let proof = proof
        .identity("critical eigenvector: A q = iω q", used, &in_basis(&image), &in_basis(&rotated), &domain)?
        .identity("its adjoint: pᵀA = iω pᵀ", used, &in_basis(&row), &in_basis(&turned), &domain)?;
    Ok((proof, [q.clone(), p], domain))
}

/// The names of a vector's components, with their values in the domain: what follows stays short.
fn named(names: [&'static str; 3], values: &Vector, domain: Domain) -> (Vector, Domain) {
    let pairs = names.into_iter().zip(values);
    let domain = pairs.fold(domain, |domain, (name, value)| domain.with(name, value.clone()));
    (names.map(Expression::variable), domain)
}

/// The equation (rate − A) h = source.
struct Resolvent<'r> {
    names: [&'static str; 3],
    rate: Expression,
    source: Vector,
    says: &'r str,
    critical: &'r Critical<'r>,
    linear: &'r Vector,
}

impl Resolvent<'_> {
    /// Its solution with its certificate; the domain gains the values.
    fn solve(
        &self,
        proof: Proof,
        used: &[&str],
        domain: Domain,
    ) -> Result<(Proof, Vector, Domain), Refutation> {
        let unknown = ["f_1 + i*g_1", "f_2 + i*g_2", "f_3 + i*g_3"].map(formula);
        let conditions = Conditions {
            vanishing: &self.rest(&unknown),
            identically_in: &["i"],
            unknowns: &["f_1", "g_1", "f_2", "g_2", "f_3", "g_3"],
        };
        let parts = solve(&proof, used, &conditions, self.critical.domain.clone())?;
        let (h, domain) = named(self.names, &each(|n| parts.substituted(&unknown[n])), domain);
        let rest = in_basis(&self.rest(&h));
        Ok((proof.identity(self.says, used, &rest, &formula("0"), &domain)?, h, domain))
    }

    fn rest(&self, h: &Vector) -> Vector {
        let image = |n: usize| self.critical.at(&self.linear[n], h);
        each(|n| self.rate.clone() * h[n].clone() - image(n) - self.source[n].clone())
    }
}

fn each(part: impl Fn(usize) -> Expression) -> Vector {
    [0, 1, 2].map(part)
}

impl Critical<'_> {
    /// A form at a vector.
    fn at(&self, form: &Expression, vector: &Vector) -> Expression {
        let values = self.state.iter().zip(vector).map(|(name, value)| (Symbol::from(*name), value.clone()));
        form.substitute(&values.collect())
    }

    /// The bilinear form B(v, w) of the quadratic part B(v, v)/2.
    fn polar(&self, quadratic: &Vector, v: &Vector, w: &Vector) -> Vector {
        let sum = each(|n| v[n].clone() + w[n].clone());
        let at = |n: usize, vector| self.at(&quadratic[n], vector);
        each(|n| at(n, &sum) - at(n, v) - at(n, w))
    }

    /// The trilinear form C(v, v, w) of the cubic part C(v, v, v)/6: T(v + w) − T(v − w) − 2T(w).
    fn third(&self, cubic: &Vector, v: &Vector, w: &Vector) -> Vector {
        let sum = each(|n| v[n].clone() + w[n].clone());
        let difference = each(|n| v[n].clone() - w[n].clone());
        let at = |n: usize, vector| self.at(&cubic[n], vector);
        each(|n| at(n, &sum) - at(n, &difference) - formula("2") * at(n, w))
    }
}

fn dot(left: &Vector, right: &Vector) -> Expression {
    left.iter().zip(right).map(|(a, b)| a.clone() * b.clone()).fold(formula("0"), |sum, part| sum + part)
}
