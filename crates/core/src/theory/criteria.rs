//! Criteria for vibration: η > 1 against eq 20, and what each of them depends on.

use super::boundary::cubic_discriminant;
use super::notation::{any, discriminant_of_cubic, formula, in_groups};
use super::sufficient_inertia::sharp_bound;
use super::{Equations, transition};
use crate::polynomial::{Certificate, Domain, Expression, Proof, Refutation, Symbol};

/// η > 1 as a criterion of underdamped oscillation: where it is sufficient, and that it is not necessary (claim Z2).
///
/// # Errors
/// When eq 8 has another discriminant.
pub fn inertial_parameter(equations: &Equations) -> Result<Proof, Refutation> {
    let margin = formula("kappa") - in_groups(&equations.right("9"));
    let oscillates_without = [("beta", "3/2"), ("eta", "1/10"), ("kappa", "1")];
    let real_though_above = [("beta", "1/2"), ("eta", "2"), ("kappa", "1/50")];
    let real_unstable = [("beta", "3/2"), ("eta", "2"), ("kappa", "1/100")];
    let proof = Proof::new(
        "inertial-parameter-criterion",
        "In the stable zone of a < b all roots are real for some κ exactly for η ≤ η_c: η > η_c is sufficient for a \
             complex pair, and no smaller bound is. η_c is the root of (1 − 2η)³ = 27βη², which is \
             1/(2 + 6√β cos(arccos(1/√β)/3)) for β = b/a > 1. It is less than 1/8 and tends to 1/8 as b/a → 1, so η ≥ 1/8 is \
             sufficient for all a < b. η > 1 is not sufficient in the upper real area, which exists at every η for a ≠ b.",
    )
    .using(transition::stability(equations)?);
    let proof = sharp_bound(proof, equations)?;
    let proof = at_point(
        proof,
        "K − K_c (in units of aσ/D_c) at a stable point with η = 1/10",
        &margin,
        &oscillates_without,
    )?;
    let discriminant = Expression::from(&cubic_discriminant(equations)?);
    let proof = at_point(
        proof,
        "discriminant there: negative, a complex pair without η > 1",
        &discriminant,
        &oscillates_without,
    )?;
    let proof = at_point(
        proof,
        "discriminant for a > b at η = 2: positive, all roots real",
        &discriminant,
        &real_though_above,
    )?;
    at_point(
        proof,
        "discriminant for a < b at η = 2: positive, all roots real (and K < K_c)",
        &discriminant,
        &real_unstable,
    )
}

/// Adds the exact value of an expression at a rational point, whose sign the step's words name.
fn at_point(
    proof: Proof,
    says: &str,
    expression: &Expression,
    point: &[(&str, &str)],
) -> Result<Proof, Refutation> {
    let negative = says.contains("negative");
    let point: Vec<_> = point.iter().map(|(name, value)| ((*name).to_owned(), formula(value))).collect();
    let values = point.iter().map(|(name, value)| (Symbol::new(name), value.clone())).collect();
    let value =
        super::notation::rational(&proof, &["8"], &expression.substitute(&values), &Domain::default())?;
    let sign = if negative { -1 } else { 1 };
    if value.coefficient_sign() != Some(sign) {
        return Err(proof.refute(says, &["8", "9"], format!("the value is {}", Expression::from(&value))));
    }
    let certificate =
        Certificate::Value { expression: expression.clone(), point, value: Expression::from(&value) };
    proof.certify(says, &["8", "9"], certificate)
}

/// The exact boundary depends on each of a, b and D_c (claim Z4): changing one alone leaves it.
///
/// # Errors
/// When the discriminant stays zero.
pub fn all_parameters(equations: &Equations) -> Result<Proof, Refutation> {
    // In units σ = K = V0 = 1 the mass is what remains of inertia; the point has η = 5/48, κ = 69/16, β = 3/2.
    let point = [
        ("a", "1"),
        ("b", "3/2"),
        ("D_c", "69/16"),
        ("M", "345/768"),
        ("K", "1"),
        ("sigma", "1"),
        ("V_0", "1"),
    ];
    let cubic = equations.residual("8") * formula("sigma*V_0*D_c");
    let start = Proof::new("vibration-depends-on-all", "");
    let discriminant = Expression::from(&discriminant_of_cubic(&start, &cubic, "s", &any())?);
    let changes = [("a", "11/10"), ("b", "8/5"), ("D_c", "5")];
    let proof = Proof::new(
        "vibration-depends-on-all",
        "The exact boundary depends on each of a, b and D_c: at a point of it, changing any \
             one of them alone leaves the boundary. Its asymptote eq 20 contains a only.",
    );
    let at = |name: &str, value: &str| -> Vec<(String, Expression)> {
        let pick = |known: &str, kept: &str| if known == name { formula(value) } else { formula(kept) };
        point.iter().map(|(known, kept)| ((*known).to_owned(), pick(known, kept))).collect()
    };
    let on_boundary =
        Certificate::Value { expression: discriminant.clone(), point: at("a", "1"), value: formula("0") };
    let proof = proof.certify("discriminant of eq 8 at the point", &["8"], on_boundary)?;
    changes.into_iter().try_fold(proof, |proof, (name, value)| {
        let values = at(name, value).into_iter().map(|(name, value)| (Symbol::new(&name), value)).collect();
        let changed = super::notation::simplified(
            &proof,
            &["8"],
            &discriminant.substitute(&values),
            &Domain::default(),
        )?;
        if changed.is_zero() {
            return Err(proof.refute(
                &format!("the boundary depends on {name}"),
                &["8"],
                "the discriminant stays zero",
            ));
        }
        let certificate =
            Certificate::Value { expression: discriminant.clone(), point: at(name, value), value: changed };
        proof.certify(&format!("not zero with {name} = {value}"), &["8"], certificate)
    })
}
