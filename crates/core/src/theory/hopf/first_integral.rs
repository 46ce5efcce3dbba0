//! Without inertia K = K_c is a centre for either law, so that every Lyapunov coefficient vanishes, and no other K has a
//! cycle.

use super::slider::{by_groups, derive};
use crate::friction::EvolutionLaw;
use crate::theory::Equations;
use crate::theory::notation::{formula, given_positive, in_parameters};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

/// In the limit η → 0 every orbit near steady sliding is closed at K = K_c, and for K ≠ K_c none is, of whatever size.
///
/// By a first integral, and by the criterion of Bendixson and Dulac.
///
/// # Errors
/// When eqs 1-4 give another slider.
pub fn prove(equations: &Equations, law: EvolutionLaw) -> Result<Proof, Refutation> {
    let id = format!("quasi-static-centre-{}-law", law.as_str());
    let proof = Proof::new(
        &id,
        format!(
            "Without inertia, at κ = β − 1 the slider with the {} law has a first integral with a strict extremum at \
             steady sliding: the orbits near it are closed, of every small amplitude. At any other κ no orbit is closed.",
            law.as_str()
        ),
    );
    let (proof, slider) = derive(proof, equations, law)?;
    let used = ["1", law.equation(), "4", "steady-state"];
    let [velocity, evolution, loading] = slider.rates;
    // η → 0 leaves x on the sheet where the force in x' vanishes: ζ = x + β y.
    let sheet = formula("x + beta*y");
    let domain = by_groups();
    let proof = proof.identity(
        "the force on the mass vanishes at ζ = x + β y",
        &used,
        &velocity.with("zeta", &sheet),
        &formula("0"),
        &domain,
    )?;
    let rates =
        [loading - formula("beta") * evolution.clone(), evolution].map(|rate| rate.with("zeta", &sheet));
    let proof = no_cycle(proof, &used, law, &rates)?;
    let (integral, factor) = integral(law);
    let critical = Domain::positive("beta").with("kappa", formula("beta - 1"));
    let along = |function: &Expression| {
        slope(function, "x") * rates[0].clone() + slope(function, "y") * rates[1].clone()
    };
    let proof = match law {
        EvolutionLaw::Aging => proof.identity("H = x + β y − (e^x + β − 1) e^y is constant", &used, &along(&integral), &formula("0"), &critical)?,
        EvolutionLaw::Slip => proof.identity(
            "H = (x + y − 1 + (β − 1)/β e^(−x)) exp(β(x + y) − (β − 1)x) is constant: its rate over the exponential",
            &used,
            &(along(&integral) + integral.clone() * along(&factor)),
            &formula("0"),
            &critical,
        )?,
    };
    extremum(proof, law)
}

/// The rates times e^(y) (aging) or e^(βy) (slip) have a divergence of one sign, so that no orbit can close.
fn no_cycle(
    proof: Proof,
    used: &[&str],
    law: EvolutionLaw,
    rates: &[Expression; 2],
) -> Result<Proof, Refutation> {
    let exponent = match law {
        EvolutionLaw::Aging => formula("1"),
        EvolutionLaw::Slip => formula("beta"),
    };
    let divergence = slope(&rates[0], "x") + slope(&rates[1], "y") + exponent * rates[1].clone();
    let says =
        "divergence of the weighted rates of x and y over the weight, e^y (aging law) or e^(βy) (slip law)";
    let stated = formula("(beta - 1 - kappa)*exp(x)");
    let groups = Domain::positive("beta kappa");
    let below = given_positive(groups.clone(), "beta - 1 - kappa", &[("beta", "3")]);
    let above = given_positive(groups, "kappa - (beta - 1)", &[]);
    proof
        .identity(says, used, &divergence, &stated, &by_groups())?
        .positive(
            "it is positive in the whole plane for κ < β − 1: no closed orbit (Bendixson and Dulac)",
            &[],
            &stated,
            &below,
        )?
        .negative("and negative for κ > β − 1: no closed orbit", &[], &stated, &above)
}

/// H itself (aging), or H without its exponential factor and the factor's exponent (slip).
fn integral(law: EvolutionLaw) -> (Expression, Expression) {
    match law {
        EvolutionLaw::Aging => (formula("x + beta*y - (exp(x) + beta - 1)*exp(y)"), formula("0")),
        EvolutionLaw::Slip => {
            (formula("x + y - 1 + (beta - 1)/(beta*exp(x))"), formula("beta*(x + y) - (beta - 1)*x"))
        }
    }
}

/// The Hessian of H at the origin is definite.
fn extremum(proof: Proof, law: EvolutionLaw) -> Result<Proof, Refutation> {
    let (integral, factor) = integral(law);
    let whole = match law {
        EvolutionLaw::Aging => integral,
        EvolutionLaw::Slip => integral * factor.call(slipmode_algebra::Function::Exp),
    };
    let rest = |expression: Expression| expression.with("x", &formula("0")).with("y", &formula("0"));
    let second = |one: &'static str, other: &'static str| rest(slope(&slope(&whole, one), other));
    let determinant = second("x", "x") * second("y", "y") - second("x", "y").power(2);
    let above = given_positive(Domain::positive("beta"), "beta - 1", &[("beta", "2")]);
    let above = in_parameters(above, &[("beta", "1 + d", "d", "beta - 1")]);
    let used = [law.equation()];
    proof
        .identity("∂H/∂x at steady sliding", &used, &rest(slope(&whole, "x")), &formula("0"), &above)?
        .identity("∂H/∂y at steady sliding", &used, &rest(slope(&whole, "y")), &formula("0"), &above)?
        .positive(
            "determinant of H's second derivatives there: a strict extremum",
            &used,
            &determinant,
            &above,
        )
}

fn slope(expression: &Expression, name: &'static str) -> Expression {
    expression.derivative(&Symbol::from(name))
}
