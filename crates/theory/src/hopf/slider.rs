//! The nonlinear slider in logarithms, derived from eqs 1-4: three variables, three groups.

use super::expansion::in_basis;
use super::projection::Critical;
use crate::notation::{formula, simplified};
use crate::stated_proofs::stated_domain;
use crate::{Equations, Role};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};
use slipmode_core::friction::EvolutionLaw;

/// x = ln(V/V_0), y = ln(V_0 θ/D_c) and ζ = (spring stress/σ − μ_0)/a.
pub(super) const STATE: [&str; 3] = ["x", "y", "zeta"];

/// The rates of x, y and ζ per time D_c/V_0 as functions of the three and of η, κ, β, in the order of [`STATE`].
type Rates = [Expression; 3];

/// The line K = K_c.
pub(super) fn on_transition() -> Domain {
    stated_domain("on the transition")
}

/// The physical quantities by the three groups.
pub(super) fn by_groups() -> Domain {
    stated_domain("by groups")
}

/// The slider on K = K_c with the eigenvectors of its pair ±iω; the x-component is 1.
pub(super) fn critical(rates: Rates) -> Critical<'static> {
    let q = ["1", "-(1 - i*omega)/(1 + omega^2)", "i*omega*(1 + eta)"].map(formula);
    let adjoint = ["1", "-(1 - i*omega)/eta", "-i/(omega*eta)"].map(formula);
    Critical {
        state: STATE,
        rates,
        names: "x, y, ζ on K = K_c",
        frequency: formula("omega"),
        domain: on_transition(),
        eigenvectors: [q, adjoint],
        adjoint_says: "p = (1, −(1 − iω)/η, −i/(ωη))/l with l its product with q, so that ⟨p, q⟩ = 1",
    }
}

/// The numbers of the equations that the nonlinear slider with a law is derived from.
pub(super) fn cited(equations: &Equations, law: EvolutionLaw) -> [&str; 4] {
    equations.numbers([Role::Friction, Role::of_law(law), Role::Motion, Role::SteadyState])
}

/// Derives the slider and shows that it rests at the origin.
///
/// # Errors
/// When eq 4 has no spring or no mass of that form, or steady sliding is no rest.
pub(super) fn derive(
    proof: Proof,
    equations: &Equations,
    law: EvolutionLaw,
) -> Result<(Proof, Rates), Refutation> {
    let derived = physical_rates(equations, law);
    let used = cited(equations, law);
    let [motion] = equations.numbers([Role::Motion]);
    let rates = derived.iter().map(|rate| simplified(&proof, &used, rate, &by_groups()));
    let rates = rates.collect::<Result<Vec<_>, _>>()?;
    let says = format!(
        "x = ln X = ln(V/V_0), y = ln Y = ln(V_0 θ/D_c) and ζ = (spring stress/σ − μ_0)/a: their \
         rates (by e_1, e_2, e_3) per time D_c/V_0 with the {} law",
        law.as_str()
    );
    let proof = proof
        .identity(
            &format!("the spring of eq {motion} at this δ carries μ_0 + a ζ"),
            &[motion],
            &spring(equations).with("delta", &displacement()),
            &formula("mu_0 + a*zeta"),
            &by_groups(),
        )?
        .identity(&says, &used, &in_basis(&derived), &in_basis(&rates), &by_groups())?;
    let rates = [0, 1, 2].map(|index| in_logarithms(&rates[index]));
    let rest = STATE.iter().fold(in_basis(&rates), |sum, name| sum.with(*name, &formula("0")));
    let proof = proof.identity("steady sliding is at rest", &used, &rest, &formula("0"), &by_groups())?;
    Ok((proof, rates))
}

/// The part of eq 4's right side that neither mass nor friction has: the spring stress per normal stress.
fn spring(equations: &Equations) -> Expression {
    -equations.residual(Role::Motion).with("delta''", &formula("0")).with("mu", &formula("0"))
}

/// The slip at which the spring carries μ_0 + a ζ.
fn displacement() -> Expression {
    formula("V_0*t - (mu_0 + a*zeta)*sigma/K")
}

/// The rates in X = V/V_0, Y = V_0 θ/D_c and ζ from eqs 1, 4 and the law.
fn physical_rates(equations: &Equations, law: EvolutionLaw) -> [Expression; 3] {
    let state = |expression: &Expression| {
        let theta = equations.right(Role::SteadyState).with("V", &formula("V_0")) * formula("Y");
        expression.with("theta", &theta).with("V", &formula("V_0*X"))
    };
    let motion = equations.residual(Role::Motion).with("mu", &state(&equations.right(Role::Friction)));
    let mass = motion.derivative(&Symbol::from("delta''"));
    let force = -motion.with("delta''", &formula("0")).with("delta", &displacement());
    // δ'' = V_0 X x'·V_0/D_c with x' per D_c/V_0.
    let velocity = force / (mass * formula("V_0^2/D_c*X"));
    let evolution = state(&(equations.right(Role::of_law(law)) / formula("theta"))) * formula("D_c/V_0");
    let loading = spring(equations).time_derivative(&["t", "delta"]);
    let loading =
        loading.with("t'", &formula("1")).with("delta'", &formula("V_0*X")) * formula("D_c/(V_0*a)");
    [velocity, evolution, loading]
}

/// X = e^x and Y = e^y, with their logarithms.
fn in_logarithms(rate: &Expression) -> Expression {
    rate.with("X", &formula("exp(x)")).with("Y", &formula("exp(y)"))
}

/// ds/dκ of the critical root p = iω on K = K_c from eq 8: by the real part the side, by the imaginary part the pitch.
///
/// # Errors
/// When eq 8 depends otherwise on κ.
pub(super) fn crossing_speed(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let cubic = equations.cubic();
    let [number] = equations.numbers([Role::Characteristic]);
    let slope = |name: &'static str| cubic.derivative(&Symbol::from(name)).with("p", &formula("i*omega"));
    let speed = -slope("kappa") / slope("p");
    proof
        .identity(
            &format!("p = iω solves eq {number} on K = K_c"),
            &[number],
            &cubic.with("p", &formula("i*omega")),
            &formula("0"),
            &on_transition(),
        )?
        .identity(
            "and crosses the axis with dp/dκ",
            &[number],
            &speed,
            &(crossing_real() + formula("i") * crossing_imaginary()),
            &on_transition(),
        )
}

/// Re dp/dκ on K = K_c.
pub(super) fn crossing_real() -> Expression {
    formula("-1/(2*((1 + eta)^2 + eta^2*omega^2))")
}

/// Im dp/dκ on K = K_c.
pub(super) fn crossing_imaginary() -> Expression {
    formula("(1 + eta + eta*omega^2)/(2*omega*((1 + eta)^2 + eta^2*omega^2))")
}
