//! Non-inertial frequencies: along σ = σ_c (eqs 12 and 23), and how they depend on mass and stiffness (eq 14).

use super::Equations;
use super::notation::{
    any, below, coefficients, crossing, formula, given_positive, in_parameters, weakening,
    weakening_by_square,
};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol, Toward};

/// At σ = σ_c the frequency begins as eq 23 and rises strictly with velocity towards ω_n (claim Q3).
///
/// # Errors
/// When the cubic at σ_c is another one, or the slope has no certified sign.
pub fn at_critical_stress(equations: &Equations) -> Result<Proof, Refutation> {
    let slope = slope_at_critical_stress(&frequency_squared());
    let proof = critical_stress_lemma(
        equations,
        Proof::new(
            "frequency-at-critical-stress",
            "For a < b and σ = σ_c the roots are always a complex pair; its frequency tends to eq \
             23 as V0 → 0, rises strictly with V0, and tends to ω_n as V0 → ∞ without reaching \
             it.",
        ),
    )?
    .positive(
        "ω²/ω_n² rises with v at fixed g (its slope times ∂g/∂u)",
        &[],
        &slope,
        &critical_stress_domain(),
    )?
    .limit(
        "low velocity: eq 8 at σ_c with s = p V0/D_c, times D_c²/(a V0)",
        &["8", "12"],
        &low_velocity(equations),
        ("V_0", Toward::Zero),
        &formula("p^2 + (b - a)/a"),
        &below(),
    )?
    .identity(
        "eq 23 solves that",
        &["23"],
        &formula("p^2 + (b - a)/a").with("p", &(equations.right("23") * formula("D_c/V_0"))),
        &formula("0"),
        &weakening_by_square(),
    )?;
    let fast = equations.residual("8") * formula("sigma*D_c/V_0");
    let natural = formula("pm*i") * equations.right("natural-frequency");
    proof
        .limit(
            "high velocity: eq 8 times σ D_c/V0 tends to eq 21",
            &["8", "21"],
            &fast.with("sigma", &equations.right("12")),
            ("V_0", Toward::Infinity),
            &equations.residual("21"),
            &below(),
        )?
        .identity(
            "whose roots are ±i ω_n",
            &["21", "natural-frequency"],
            &equations.residual("21").with("s", &natural),
            &formula("0"),
            &any(),
        )?
        .positive(
            "1 − ω²/ω_n²: ω_n is not reached at any velocity",
            &[],
            &(formula("1") - frequency_squared()),
            &critical_stress_domain(),
        )
}

/// Without inertia (eq 14) the frequency does not depend on mass; with inertia it does (claim Q4).
///
/// # Errors
/// When eq 14's frequency depends on M, or that of eq 8 at σ_c does not fall with M.
pub fn mass(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "frequency-and-mass",
        "Without inertia (eq 14) the frequency does not depend on M; with inertia it falls strictly \
             with M at σ = σ_c.",
    );
    let square = frequency_squared_of_eq_14(equations, &proof)?;
    let per_velocity = frequency_squared() / formula("v^2");
    let falls = Expression::integer(-1) * slope_at_critical_stress(&per_velocity);
    let proof = proof.identity(
        "ω² of eq 14 with another mass",
        &["14"],
        &square,
        &square.with("M", &formula("M_1")),
        &any(),
    )?;
    critical_stress_lemma(equations, proof)?.positive(
        "(ω D_c/V0)² falls with v = V0/(ω_n D_c) at fixed g, so with M at fixed K, V0, D_c",
        &[],
        &falls,
        &critical_stress_domain(),
    )
}

/// At given normal stress the frequency without inertia depends on stiffness (claim Q4).
///
/// # Errors
/// When eq 14's frequency depends otherwise on K.
pub fn stiffness(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "frequency-and-stiffness",
        "Without inertia (eq 14) and at fixed σ the frequency depends on K: at K = K_c,qs it grows as \
             √K. Eq 23 contains no K only because K was replaced by K_c.",
    );
    let square = frequency_squared_of_eq_14(equations, &proof)?;
    let elasticity = formula("K") * square.derivative(&Symbol::from("K"));
    let critical = equations.right("10");
    let pair = Expression::integer(-1) * equations.right("23").power(2);
    proof
        .identity(
            "ω² of eq 14 at K = K_c,qs against eq 23",
            &["10", "14", "23"],
            &square.with("K", &critical),
            &pair,
            &crossing(),
        )?
        .identity(
            "K dω²/dK there is ω² itself: ω grows as √K",
            &["10", "14"],
            &elasticity.with("K", &critical),
            &square.with("K", &critical),
            &any(),
        )
}

/// At given σ/σ_c the frequency without inertia depends neither on stiffness nor on mass (claim Q4).
///
/// # Errors
/// When eq 14's frequency at σ = r σ_c depends on K or M.
pub fn at_stress_ratio(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "frequency-at-stress-ratio",
        "Without inertia (eq 14) and at fixed r = σ/σ_c the frequency depends neither on K nor on M.",
    );
    let stress = formula("r") * equations.right("12");
    let square = frequency_squared_of_eq_14(equations, &proof)?.with("sigma", &stress);
    let domain = weakening().and_positive("r K_1 M_1");
    proof
        .identity(
            "ω² of eq 14 at σ = r σ_c with another stiffness",
            &["12", "14"],
            &square,
            &square.with("K", &formula("K_1")),
            &domain,
        )?
        .identity(
            "the same with another mass",
            &["12", "14"],
            &square,
            &square.with("M", &formula("M_1")),
            &domain,
        )
}

/// ω² = (4 c2 c0 − c1²)/(4 c2²) of eq 14, without inertia.
///
/// # Errors
/// When eq 14 is not quadratic in s.
pub(super) fn frequency_squared_of_eq_14(
    equations: &Equations,
    proof: &Proof,
) -> Result<Expression, Refutation> {
    let [c0, c1, c2]: [Expression; 3] = coefficients(proof, &["14"], &equations.residual("14"), "s")?;
    Ok((formula("4") * c2.clone() * c0 - c1.power(2)) / (formula("4") * c2.power(2)))
}

/// Eq 8 at σ = σ_c, s = p V0/D_c.
fn low_velocity(equations: &Equations) -> Expression {
    let scaled = equations.residual("8").with("s", &formula("p*V_0/D_c")) * formula("D_c^2/(a*V_0)");
    scaled.with("sigma", &equations.right("12"))
}

/// ω²/ω_n² at σ = σ_c by the real root −u and the velocity v, both in units of ω_n.
fn frequency_squared() -> Expression {
    formula("v/u - v^2/(4*u^4)")
}

/// g = a/(b − a) by u and v.
fn ratio_of_effects() -> Expression {
    formula("u*v - v^2/u^2 - v^2")
}

/// The slope of a quantity in v at fixed g, times ∂g/∂u (which is positive).
fn slope_at_critical_stress(quantity: &Expression) -> Expression {
    let (u, v) = (Symbol::from("u"), Symbol::from("v"));
    let g = ratio_of_effects();
    quantity.derivative(&v) * g.derivative(&u) - quantity.derivative(&u) * g.derivative(&v)
}

/// Every u > 0 and v > 0 with g > 0 is v = u³/(1 + u² + k) for one k > 0.
fn critical_stress_domain() -> Domain {
    let domain = given_positive(Domain::positive("u v"), "u*v - v^2/u^2 - v^2", &[("u", "3")]);
    in_parameters(domain, &[("v", "u^3/(1 + u^2 + k)", "k", "u^3/v - 1 - u^2")])
}

/// At σ = σ_c: the cubic in z = s/ω_n, its factors, and the quantities u, v, g.
fn critical_stress_lemma(equations: &Equations, proof: Proof) -> Result<Proof, Refutation> {
    let at_stress = (equations.residual("8") * formula("sigma")).with("sigma", &equations.right("12"));
    let units = [
        ("K", "M*omega^2", "omega", "sqrt(K/M)"),
        ("V_0", "v*omega*D_c", "v", "V_0/(sqrt(K/M)*D_c)"),
        ("b", "a + a/g", "g", "a/(b - a)"),
    ];
    let units = in_parameters(below(), &units).with("s", formula("omega*z"));
    let cubic = formula("z^3 + (g/v + v)*z^2 + v");
    let factors = formula("(z + u)*(z^2 - v/u^2*z + v/u)");
    let domain = critical_stress_domain();
    let g = ratio_of_effects();
    proof
        .identity(
            "eq 8 at σ = σ_c in z = s/ω_n, v = V0/(ω_n D_c), g = a/(b − a)",
            &["8", "12"],
            &at_stress,
            &(formula("M*omega^3") * cubic.clone()),
            &units,
        )?
        .root(
            "it has a root −u < 0",
            &[],
            (&cubic, "z"),
            [None, Some(&formula("0"))],
            &Domain::positive("g v"),
        )?
        .identity(
            "factors with g = u v − v²/u² − v²",
            &[],
            &cubic,
            &factors,
            &Domain::positive("u v").with("g", g.clone()),
        )?
        .positive("g > 0 exactly for v = u³/(1 + u² + k), k > 0", &[], &g, &domain)?
        .positive("∂g/∂u", &[], &g.derivative(&Symbol::from("u")), &domain)?
        .positive("ω²/ω_n² = v/u − v²/(4u⁴): the pair is complex", &[], &frequency_squared(), &domain)
}
