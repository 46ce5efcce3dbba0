//! The stability transition K = K_c: eqs 9-13 and 23.

use super::Equations;
use super::notation::{
    any, coefficients, crossing, formula, rational, stronger_direct_effect, weakening_by_square,
    weaker_direct_effect,
};
use super::root_location::positive_coefficients;
use crate::polynomial::{Expression, Proof, Refutation, Relation, Symbol, Toward};

/// The system is stable exactly when K > K_c of eq 9, and a pair is imaginary exactly when K = K_c (claim S1).
///
/// # Errors
/// When eq 9 is not where eq 8's Hurwitz determinant vanishes.
pub fn stability(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "stability-transition",
        "All roots of eq 8 have negative real parts exactly when K > K_c (eq 9), two have \
             positive real parts exactly when K < K_c, and a pair is imaginary exactly when K = \
             K_c.",
    );
    let [c0, c1, c2, c3] = coefficients(&proof, &["8"], &equations.residual("8"), "s")?;
    let hurwitz = c2.clone() * c1 - c3.clone() * c0.clone();
    let margin = formula("a/(V_0*sigma)") * (formula("K") - equations.right("9"));
    let critical = critical_stiffness(&proof, &hurwitz)?;
    positive_coefficients(proof)?
        .positive("the cubic coefficient of eq 8", &["8"], &c3, &any())?
        .positive("the quadratic coefficient of eq 8", &["8"], &c2, &any())?
        .positive("the constant coefficient of eq 8", &["8"], &c0, &any())?
        .identity(
            "the stiffness at which c2 c1 − c3 c0 vanishes",
            &["8", "9"],
            &critical,
            &equations.right("9"),
            &any(),
        )?
        .identity("c2 c1 − c3 c0 is a positive factor times K − K_c", &["8", "9"], &hurwitz, &margin, &any())
}

/// The stiffness at which the Hurwitz determinant, linear in K, vanishes.
fn critical_stiffness(proof: &Proof, hurwitz: &Expression) -> Result<Expression, Refutation> {
    let function = rational(proof, &["8"], hurwitz, &any())?;
    let slope = function.derivative(&Symbol::new("K"));
    let rest = rational(proof, &["8"], &hurwitz.with("K", &formula("0")), &any())?;
    (-rest)
        .checked_div(&slope)
        .map(|critical| Expression::from(&critical))
        .ok_or_else(|| proof.refute("the Hurwitz determinant depends on K", &["8"], hurwitz.to_string()))
}

/// K_c is the sum of eqs 10 and 11; the first depends on σ alone, the second on M·V0² alone (claim S2).
///
/// # Errors
/// When a part is another one or depends on more.
pub fn parts(equations: &Equations) -> Result<Proof, Refutation> {
    let (total, quasi_static, dynamic) = (equations.right("9"), equations.right("10"), equations.right("11"));
    let with_others = any().and_positive("M_1 V_1 sigma_1 E");
    let other_machine = quasi_static.with("M", &formula("M_1")).with("V_0", &formula("V_1"));
    let other_stress = dynamic.with("sigma", &formula("sigma_1"));
    let energy = dynamic.with("M", &formula("E/V_0^2"));
    let other_velocity = dynamic.with("M", &formula("E/V_1^2")).with("V_0", &formula("V_1"));
    Proof::new(
        "critical-stiffness-parts",
        "K_c = K_c,qs + K_c,dyn. At given a, b and D_c the first depends on σ only, the \
             second on M V0² only (the kinetic energy per area is half of that).",
    )
    .identity("K_c at M = 0", &["9", "10"], &total.with("M", &formula("0")), &quasi_static, &any())?
    .identity("the rest of K_c", &["9", "10", "11"], &(total - quasi_static.clone()), &dynamic, &any())?
    .identity("K_c,qs with another mass and velocity", &["10"], &quasi_static, &other_machine, &with_others)?
    .identity("K_c,dyn with another normal stress", &["11"], &dynamic, &other_stress, &with_others)?
    .identity(
        "K_c,dyn at the same M V0² = E with another velocity",
        &["11"],
        &energy,
        &other_velocity,
        &with_others,
    )
}

/// For a < b a higher velocity raises K_c without limit, so that every system becomes unstable (claim S3).
///
/// # Errors
/// When K_c does not grow.
pub fn velocity_destabilises(equations: &Equations) -> Result<Proof, Refutation> {
    let critical = equations.right("9");
    let slope = critical.derivative(&Symbol::new("V_0"));
    let inverse = formula("1") / critical;
    let falls = Expression::integer(-1) * slope.clone();
    Proof::new(
        "velocity-destabilises",
        "For a < b, K_c grows with V0 beyond every K: each system is unstable from some \
             velocity on (for σ ≥ σ_c at every velocity). For a > b, K_c falls with V0 and stays \
             negative: there the statement has no content.",
    )
    .positive("K_c grows with V0 for a < b", &["9"], &slope, &weaker_direct_effect())?
    .limit(
        "1/K_c as V0 → ∞",
        &["9"],
        &inverse,
        ("V_0", Toward::Infinity),
        &formula("0"),
        &weaker_direct_effect(),
    )?
    .positive("K_c falls with V0 for a > b", &["9"], &falls, &stronger_direct_effect())
}

/// σ_c and V_c are the asymptotes of K = K_c, and each alone is sufficient for instability (claim S4).
///
/// # Errors
/// When K_c/K is not σ/σ_c + (V0/V_c)².
pub fn critical_stress_and_velocity(equations: &Equations) -> Result<Proof, Refutation> {
    let domain = weakening_by_square();
    let (stress, velocity) = (equations.right("12"), equations.right("13"));
    let shares = formula("sigma") / stress.clone() + (formula("V_0") / velocity.clone()).power(2);
    let transition = stress.clone() * (formula("1") - (formula("V_0") / velocity.clone()).power(2));
    let square = velocity.clone().power(2) * (formula("1") - formula("sigma") / stress.clone());
    let slower = formula("1") - (formula("V_0") / velocity.clone()).power(2);
    let below_critical = domain.clone().given(slower, Relation::Positive).example("V_0", formula("1/2"));
    let nearby = formula("9/10 + (9/10)^2 - 1");
    let used = ["9", "12", "13"];
    Proof::new(
        "critical-stress-and-velocity",
        "For a < b, K_c/K = σ/σ_c + (V0/V_c)². So K < K_c whenever σ > σ_c or V0 > V_c; on K \
             = K_c, σ → σ_c as V0 → 0 and V0 → V_c as σ → 0. The condition is sufficient, not \
             necessary.",
    )
    .identity("K_c/K", &used, &(equations.right("9") / formula("K")), &shares, &domain)?
    .positive("σ_c is positive", &["12"], &stress, &domain)?
    .positive("V_c is positive", &["13"], &velocity, &domain)?
    .identity(
        "σ on K = K_c, for V0 < V_c",
        &used,
        &equations.right("9").with("sigma", &transition),
        &formula("K"),
        &below_critical,
    )?
    .limit("σ on K = K_c as V0 → 0", &used, &transition, ("V_0", Toward::Zero), &stress, &domain)?
    .limit("V0² on K = K_c as σ → 0", &used, &square, ("sigma", Toward::Zero), &velocity.power(2), &domain)?
    .positive("K_c/K − 1 at σ = 9/10 σ_c and V0 = 9/10 V_c: unstable below both", &[], &nearby, &domain)
}

/// For a ≥ b there is no transition: K_c ≤ 0 and every K > 0 is stable (claim S5).
///
/// # Errors
/// When K_c can be positive.
pub fn intrinsically_stable(equations: &Equations) -> Result<Proof, Refutation> {
    let critical = equations.right("9");
    let proof = Proof::new(
        "intrinsically-stable",
        "For a ≥ b, K_c ≤ 0 < K at every normal stress and velocity: no transition, and all \
             roots have negative real parts.",
    )
    .using(stability(equations)?);
    proof.positive("−K_c for a > b", &["9"], &(-critical.clone()), &stronger_direct_effect())?.identity(
        "K_c for a = b",
        &["9"],
        &critical.with("b", &formula("a")),
        &formula("0"),
        &any(),
    )
}

/// On K = K_c the crossing pair is eq 23 and the third root is real and negative (claim S6).
///
/// # Errors
/// When eq 8 does not factor so, or eq 23 is no root.
pub fn crossing_frequency(equations: &Equations) -> Result<Proof, Refutation> {
    let on_transition = equations.residual("8").with("K", &equations.right("9"));
    let factors = formula("(s^2 + (b - a)/a*V_0^2/D_c^2)*(M*s/sigma + a/V_0 + M*V_0/(sigma*D_c))");
    let at_crossing = on_transition.with("s", &equations.right("23"));
    let third = formula("a*sigma/(M*V_0) + V_0/D_c");
    Proof::new(
        "crossing-frequency",
        "On K = K_c (a < b) eq 8 is the product of s² + (b−a)/a (V0/D_c)² and a linear \
             factor; the crossing pair is ±i√((b−a)/a) V0/D_c, the third root −aσ/(M V0) − V0/D_c \
             is negative.",
    )
    .identity("eq 8 on K = K_c", &["8", "9"], &on_transition, &factors, &any())?
    .identity(
        "eq 23 is a root there, with either sign",
        &["8", "9", "23"],
        &at_crossing,
        &formula("0"),
        &crossing(),
    )?
    .positive("minus the third root", &[], &third, &any())
}
