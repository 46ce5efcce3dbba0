//! The cubic coefficient of the normal form by projection on the critical eigenvectors (Kuznetsov's formula), in x, y, ζ.

use super::expansion::{Conditions, fraction, in_basis, solve, taylor_part};
use super::slider::{STATE, Slider, on_transition};
use crate::polynomial::{Expression, Proof, Refutation, Symbol};
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
    let (proof, q, p) = eigenvectors(proof, used, &forms)?;
    let conjugate = each(|n| q[n].with("i", &formula("-i")));
    let source = polar(&forms.quadratic, &q, &conjugate);
    let (proof, h11) = resolvent(proof, used, &forms, "0", &source, "h_11: 0 = A h_11 + B(q, q̄)")?;
    let source = each(|n| formula("2") * at(&forms.quadratic[n], &q));
    let (proof, h20) = resolvent(proof, used, &forms, "2*i*omega", &source, "h_20: 2iω h_20 = A h_20 + B(q, q)")?;
    let cubic = third(&forms.cubic, &q, &conjugate);
    let direct = polar(&forms.quadratic, &q, &h11);
    let harmonic = polar(&forms.quadratic, &conjugate, &h20);
    let sum = each(|n| cubic[n].clone() + formula("2") * direct[n].clone() + harmonic[n].clone());
    let says = "C(q, q, q̄) + 2 B(q, h_11) + B(q̄, h_20)";
    let (proof, sum) = simplify(proof, used, says, &sum)?;
    let value = dot(&p, &sum) / formula("2");
    let stated = simplified(&proof, used, &value, &on_transition())?;
    let says = "c_1 = ⟨p, C(q, q, q̄) + 2 B(q, h_11) + B(q̄, h_20)⟩/2";
    Ok((proof.identity(says, used, &value, &stated, &on_transition())?, stated))
}

/// A vector in lowest terms, with its certificate.
fn simplify(proof: Proof, used: &[&str], says: &str, vector: &Vector) -> Result<(Proof, Vector), Refutation> {
    let mut stated = each(|_| formula("0"));
    for (part, value) in stated.iter_mut().zip(vector) {
        *part = simplified(&proof, used, value, &on_transition())?;
    }
    Ok((proof.identity(says, used, &in_basis(vector), &in_basis(&stated), &on_transition())?, stated))
}

/// The Taylor parts, each with its certificate.
fn forms(proof: Proof, used: &[&str], slider: &Slider) -> Result<(Proof, Forms), Refutation> {
    let part = |proof: Proof, degree: i32, name: &str| {
        let derived = each(|n| taylor_part(&slider.rates[n], &STATE, degree));
        simplify(proof, used, &format!("{name} part of the rates of x, y, ζ on K = K_c"), &derived)
    };
    let (proof, linear) = part(proof, 1, "linear")?;
    let (proof, quadratic) = part(proof, 2, "quadratic")?;
    let (proof, cubic) = part(proof, 3, "cubic")?;
    Ok((proof, Forms { linear, quadratic, cubic }))
}

/// q and p of the pair ±iω with q_x = 1 and ⟨p, q⟩ = 1, certified. Real denominators keep the arithmetic small.
fn eigenvectors(proof: Proof, used: &[&str], forms: &Forms) -> Result<(Proof, Vector, Vector), Refutation> {
    let q = ["1", "-(1 - i*omega)/(1 + omega^2)", "i*omega*(1 + eta)"].map(formula);
    let adjoint = ["1", "-(1 - i*omega)/eta", "-i/(omega*eta)"].map(formula);
    let length = dot(&adjoint, &q);
    let (proof, p) = simplify(proof, used, "p = (1, −(1 − iω)/η, −i/(ωη)) over its product with q", &each(|n| adjoint[n].clone() / length.clone()))?;
    let image = each(|n| at(&forms.linear[n], &q));
    let rotated = each(|n| formula("i*omega") * q[n].clone());
    let row = dot(&p, &forms.linear);
    let row = each(|n| row.derivative(&Symbol::new(STATE[n])));
    let turned = each(|n| formula("i*omega") * p[n].clone());
    let proof = proof
        .identity("critical eigenvector: A q = iω q", used, &in_basis(&image), &in_basis(&rotated), &on_transition())?
        .identity("its adjoint: pᵀA = iω pᵀ", used, &in_basis(&row), &in_basis(&turned), &on_transition())?;
    Ok((proof, q, p))
}

/// The solution h of (rate − A) h = source, with its certificate.
fn resolvent(
    proof: Proof,
    used: &[&str],
    forms: &Forms,
    rate: &str,
    source: &Vector,
    says: &str,
) -> Result<(Proof, Vector), Refutation> {
    let unknown = ["f_1 + i*g_1", "f_2 + i*g_2", "f_3 + i*g_3"].map(formula);
    let equation = |h: &Vector, n: usize| formula(rate) * h[n].clone() - at(&forms.linear[n], h) - source[n].clone();
    let conditions = Conditions {
        vanishing: &each(|n| equation(&unknown, n)),
        identically_in: &["i"],
        unknowns: &["f_1", "g_1", "f_2", "g_2", "f_3", "g_3"],
    };
    let values = solve(&proof, used, &conditions, &on_transition())?;
    let h = each(|n| unknown[n].substitute(&values));
    let left = each(|n| equation(&h, n));
    Ok((proof.identity(says, used, &in_basis(&left), &formula("0"), &on_transition())?, h))
}

fn each(part: impl Fn(usize) -> Expression) -> Vector {
    [0, 1, 2].map(part)
}

/// A form at a vector.
fn at(form: &Expression, vector: &Vector) -> Expression {
    form.substitute(&STATE.iter().zip(vector).map(|(name, value)| (Symbol::new(name), value.clone())).collect())
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
    each(|n| at(&cubic[n], &sum) - at(&cubic[n], &difference) - fraction(2, 1) * at(&cubic[n], w))
}

fn dot(left: &Vector, right: &Vector) -> Expression {
    left.iter().zip(right).map(|(a, b)| a.clone() * b.clone()).fold(formula("0"), |sum, part| sum + part)
}
