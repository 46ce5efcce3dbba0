//! Where the relative errors of eqs 15, 16, 18 and 20 are largest on the arcs of the boundary.

use super::Equations;
use super::boundary::curve;
use super::inertial::velocity_ratio;
use super::notation::{formula, given_nonzero, in_groups};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

/// The errors of eqs 16 and 20 are largest at the cusp, those of eqs 15 and 18 at the V0 of their corner (claim Z5).
///
/// # Errors
/// When an equation has another error, or one is not monotonic along its arc.
pub fn prove(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "worst-errors-of-the-asymptotes",
        "Along the boundary κ falls and ηκ rises with η. On the lower boundary eq 16 (error of σ at the same V0, up to the \
             cusp) and eq 20 (error of V0 at the same σ, beyond it) are farthest off at the cusp. On the upper one η rises \
             from 0 without turning: eq 15 (σ at the same V0) up to the V0 of its corner with eq 18, and eq 18 (V0 at the \
             same σ) beyond it, are farthest off at this V0.",
    );
    let proof = along_the_boundary(errors(proof, equations)?, equations)?;
    turns(proof, equations)
}

/// The errors in groups: of κ alone (eqs 15, 16) and of ηκ alone (eqs 18, 20).
fn errors(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let stress = |number: &str| in_groups(&equations.right(number));
    let square = |number: &str| in_groups(&velocity_ratio(equations.equation(number)).power(2));
    let root =
        given_nonzero(Domain::positive("w kappa"), &["w - 1"], &[("w", "2")]).with("beta", formula("w^2"));
    let groups = Domain::positive("eta kappa d");
    let upper = formula("4*eta*kappa/d^2");
    proof
        .identity("σ_15/σ with β = w²", &["15"], &stress("15"), &formula("kappa/(w - 1)^2"), &root)?
        .identity("σ_16/σ", &["16"], &stress("16"), &formula("kappa/(w + 1)^2"), &root)?
        .identity(
            "(V0/V_18)², d = β − 1",
            &["18"],
            &square("18"),
            &upper,
            &groups.clone().with("beta", formula("1 + d")),
        )?
        .identity(
            "the same, d = 1 − β",
            &["18"],
            &square("18"),
            &upper,
            &groups.clone().with("beta", formula("1 - d")),
        )?
        .identity("(V0/V_20)²", &["20"], &square("20"), &formula("4*eta*kappa"), &groups)
}

/// Both monotonic relations between κ, ηκ and η on the boundary, by its double root r and its third root t.
fn along_the_boundary(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let curve = curve(equations)?;
    let [eta, kappa, third] =
        [&curve.inertial_parameter, &curve.stiffness_group, &curve.third_root].map(Expression::from);
    let r = Symbol::from("r");
    let slope = eta.derivative(&r);
    let at_root =
        given_nonzero(Domain::default(), &["r", "r + 1", "(r + 1)^2 - beta"], &[("r", "1"), ("beta", "1")]);
    let falls = formula("-r^2") * slope.clone();
    let rises = eta.clone() * formula("r^2") * (formula("-1") - third.clone()) * slope;
    let left = formula("-1") - third;
    let [lower, above, below] = arcs();
    proof
        .identity("dκ/dr = −r² dη/dr", &["8"], &kappa.derivative(&r), &falls, &at_root)?
        .identity("d(ηκ)/dr = −(1 + t) η r² dη/dr", &["8"], &(eta * kappa).derivative(&r), &rises, &at_root)?
        .positive("−1 − t on the lower boundary, r = −1 − x with x > √β", &["8"], &left, &lower)?
        .positive("−1 − t on the upper one for β > 1, r = e between 0 and √β − 1", &["8"], &left, &above)?
        .positive("−1 − t on it for β < 1, r = −e/(1 + e) between √β − 1 and 0", &["8"], &left, &below)
}

/// The lower boundary and the upper one for β > 1 and β < 1, by positive parameters.
fn arcs() -> [Domain; 3] {
    let arc = |names: &'static str, root: &str, beta: &str| {
        Domain::positive(names).with("r", formula(root)).with("beta", formula(beta))
    };
    [
        arc("x h", "-1 - x", "x^2/(1 + h)"),
        arc("e h", "e", "(1 + e)^2*(1 + h)"),
        arc("e h", "-e/(1 + e)", "1/((1 + e)^2*(1 + h))"),
    ]
}

/// Where η turns: at the cusp x³ = β (3x + 2) of the lower boundary, nowhere on the upper one.
fn turns(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let slope = Expression::from(&curve(equations)?.inertial_parameter).derivative(&Symbol::from("r"));
    let before = Domain::positive("x h")
        .with("r", formula("-1 - x"))
        .with("beta", formula("(x^3/(3*x + 2) + h*x^2)/(1 + h)"));
    let beyond =
        Domain::positive("x h").with("r", formula("-1 - x")).with("beta", formula("x^3/((3*x + 2)*(1 + h))"));
    let [_, above, below] = arcs();
    proof
        .negative("dη/dr for x³/(3x + 2) < β < x²: η rises up to the cusp", &["8"], &slope, &before)?
        .positive("dη/dr for β < x³/(3x + 2): η falls beyond it", &["8"], &slope, &beyond)?
        .negative("dη/dr on the upper boundary for β > 1", &["8"], &slope, &above)?
        .positive("dη/dr on it for β < 1", &["8"], &slope, &below)
}
