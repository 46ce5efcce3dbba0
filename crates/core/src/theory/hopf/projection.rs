//! The cubic coefficient of the normal form by projection on the critical eigenvectors (Kuznetsov's formula), in x, y, ζ.

use super::expansion::{Conditions, in_basis, solve, taylor_part};
use super::slider::{STATE, Slider, on_transition};
use crate::polynomial::{Domain, Expression, Proof, Refutation, Symbol};
use crate::theory::notation::{formula, simplified};

type Vector = [Expression; 3];

/// The Taylor parts of the slider's rates: linear, quadratic (half of B) and cubic (a sixth of C) forms in x, y, ζ.
struct Forms {
    linear: Vector,
    quadratic: Vector,
    cubic: Vector,
}

/// Derives c_1 of w' = iω w + c_1 w |w|², where x = w + w̄ + … (the eigenvector's x-component is 1).
///
/// # Errors
/// When the pair ±iω is not that of K = K_c.
pub(super) fn coefficient(
    proof: Proof,
    used: &[&str],
    slider: &Slider,
) -> Result<(Proof, Expression), Refutation> {
    let (proof, forms) = forms(proof, used, slider)?;
    let (proof, [q, p], domain) = eigenvectors(proof, used, &forms)?;
    let conjugate = each(|n| q[n].with("i", &formula("-i")));
    let source = polar(&forms.quadratic, &q, &conjugate);
    let mean = Resolvent { name: "h11", rate: "0", source, says: "h_11: 0 = A h_11 + B(q, q̄)" };
    let (proof, h11, domain) = mean.solve(proof, used, &forms, domain)?;
    let source = each(|n| formula("2") * at(&forms.quadratic[n], &q));
    let says = "h_20: 2iω h_20 = A h_20 + B(q, q)";
    let double = Resolvent { name: "h20", rate: "2*i*omega", source, says };
    let (proof, h20, domain) = double.solve(proof, used, &forms, domain)?;
    let cubic = third(&forms.cubic, &q, &conjugate);
    let direct = polar(&forms.quadratic, &q, &h11);
    let harmonic = polar(&forms.quadratic, &conjugate, &h20);
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
fn forms(proof: Proof, used: &[&str], slider: &Slider) -> Result<(Proof, Forms), Refutation> {
    let part = |proof: Proof, degree: i32, name: &str| {
        let derived = each(|n| taylor_part(&slider.rates[n], &STATE, degree));
        simplify(
            proof,
            used,
            &format!("{name} part of the rates of x, y, ζ on K = K_c"),
            &derived,
            &on_transition(),
        )
    };
    let (proof, linear) = part(proof, 1, "linear")?;
    let (proof, quadratic) = part(proof, 2, "quadratic")?;
    let (proof, cubic) = part(proof, 3, "cubic")?;
    Ok((proof, Forms { linear, quadratic, cubic }))
}

/// q and p of the pair ±iω with q_x = 1 and ⟨p, q⟩ = 1, certified; the domain gains the values of p.
///
/// Real denominators keep the arithmetic small.
fn eigenvectors(
    proof: Proof,
    used: &[&str],
    forms: &Forms,
) -> Result<(Proof, [Vector; 2], Domain), Refutation> {
    let q = ["1", "-(1 - i*omega)/(1 + omega^2)", "i*omega*(1 + eta)"].map(formula);
    let adjoint = ["1", "-(1 - i*omega)/eta", "-i/(omega*eta)"].map(formula);
    let length = dot(&adjoint, &q);
    let scaled = each(|n| adjoint[n].clone() / length.clone());
    let says = "p = (1, −(1 − iω)/η, −i/(ωη))/l with l its product with q, so that ⟨p, q⟩ = 1";
    let (proof, values) = simplify(proof, used, says, &scaled, &on_transition())?;
    let (p, domain) = named("p", &values, on_transition());
    let image = each(|n| at(&forms.linear[n], &q));
    let rotated = each(|n| formula("i*omega") * q[n].clone());
    let row = dot(&p, &forms.linear);
    let row = each(|n| row.derivative(&Symbol::new(STATE[n])));
    let turned = each(|n| formula("i*omega") * p[n].clone());
    let proof = proof
        .identity("critical eigenvector: A q = iω q", used, &in_basis(&image), &in_basis(&rotated), &domain)?
        .identity("its adjoint: pᵀA = iω pᵀ", used, &in_basis(&row), &in_basis(&turned), &domain)?;
    Ok((proof, [q, p], domain))
}

/// The names of a vector's components, with their values in the domain: what follows stays short.
fn named(name: &str, values: &Vector, domain: Domain) -> (Vector, Domain) {
    let names = [1, 2, 3].map(|index| format!("{name}_{index}"));
    let pairs = names.iter().zip(values);
    let domain = pairs.fold(domain, |domain, (name, value)| domain.with(name, value.clone()));
    (names.map(|name| formula(&name)), domain)
}

/// The equation (rate − A) h = source.
struct Resolvent<'r> {
    name: &'r str,
    rate: &'r str,
    source: Vector,
    says: &'r str,
}

impl Resolvent<'_> {
    /// Its solution with its certificate; the domain gains the values.
    fn solve(
        &self,
        proof: Proof,
        used: &[&str],
        forms: &Forms,
        domain: Domain,
    ) -> Result<(Proof, Vector, Domain), Refutation> {
        let unknown = ["f_1 + i*g_1", "f_2 + i*g_2", "f_3 + i*g_3"].map(formula);
        let conditions = Conditions {
            vanishing: &self.rest(forms, &unknown),
            identically_in: &["i"],
            unknowns: &["f_1", "g_1", "f_2", "g_2", "f_3", "g_3"],
        };
        let parts = solve(&proof, used, &conditions, on_transition())?;
        let (h, domain) = named(self.name, &each(|n| parts.substituted(&unknown[n])), domain);
        let rest = in_basis(&self.rest(forms, &h));
        Ok((proof.identity(self.says, used, &rest, &formula("0"), &domain)?, h, domain))
    }

    fn rest(&self, forms: &Forms, h: &Vector) -> Vector {
        each(|n| formula(self.rate) * h[n].clone() - at(&forms.linear[n], h) - self.source[n].clone())
    }
}

fn each(part: impl Fn(usize) -> Expression) -> Vector {
    [0, 1, 2].map(part)
}

/// A form at a vector.
fn at(form: &Expression, vector: &Vector) -> Expression {
    form.substitute(
        &STATE.iter().zip(vector).map(|(name, value)| (Symbol::new(name), value.clone())).collect(),
    )
}

/// The bilinear form B(v, w) of the quadratic part B(v, v)/2.
fn polar(quadratic: &Vector, v: &Vector, w: &Vector) -> Vector {
    let sum = each(|n| v[n].clone() + w[n].clone());
    each(|n| at(&quadratic[n], &sum) - at(&quadratic[n], v) - at(&quadratic[n], w))
}

/// The trilinear form C(v, v, w) of the cubic part C(v, v, v)/6: T(v + w) − T(v − w) − 2T(w).
fn third(cubic: &Vector, v: &Vector, w: &Vector) -> Vector {
    let sum = each(|n| v[n].clone() + w[n].clone());
    let difference = each(|n| v[n].clone() - w[n].clone());
    each(|n| at(&cubic[n], &sum) - at(&cubic[n], &difference) - formula("2") * at(&cubic[n], w))
}

fn dot(left: &Vector, right: &Vector) -> Expression {
    left.iter().zip(right).map(|(a, b)| a.clone() * b.clone()).fold(formula("0"), |sum, part| sum + part)
}
