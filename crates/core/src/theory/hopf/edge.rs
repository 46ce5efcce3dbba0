//! What a mass adds to the first integral of the slider without inertia: the ground of the edge of bistability as η → 0.

use super::slider::{by_groups, derive};
use crate::friction::EvolutionLaw;
use crate::theory::Equations;
use crate::theory::notation::formula;
use slipmode_algebra::{Domain, Proof, Refutation};

/// The change of H by a force φ on the mass and by K ≠ K_c, and how Ω = Vθ/D_c moves along the closed orbits, both with the aging law.
///
/// # Errors
/// When eqs 1, 2 and 4 give another slider.
pub fn change_of_integral(equations: &Equations) -> Result<Proof, Refutation> {
    let law = EvolutionLaw::Aging;
    let proof = Proof::new(
        "first-integral-with-inertia",
        "With the aging law and a mass, H = x + β y − (e^x + β − 1) e^y changes only by the force φ = η d(e^x)/dt on the mass and by \
         κ − β + 1.",
    );
    let (proof, slider) = derive(proof, equations, law)?;
    let [acceleration, evolution, loading] = slider.rates;
    let used = ["1", law.equation(), "4", "steady-state"];
    let groups = by_groups();
    let integral = formula("x + beta*y - (exp(x) + beta - 1)*exp(y)");
    let slope = |name: &'static str| integral.derivative(&name.into());
    let without = loading.clone() - formula("beta") * evolution.clone();
    let rate = without.clone() - formula("f");
    let omega = formula("exp(x)*exp(y)");
    let critical = Domain::positive("beta").with("kappa", formula("beta - 1"));
    proof
        .identity(
            "η e^x x' is the force φ = ζ − x − β y",
            &used,
            &(formula("eta*exp(x)") * acceleration),
            &formula("zeta - x - beta*y"),
            &groups,
        )?
        .identity(
            "H' with x' = ζ' − β y' − f, f = φ'",
            &used,
            &(slope("x") * rate + slope("y") * evolution.clone()),
            &((formula("1") - omega.clone()) * formula("(kappa - beta + 1)*(1 - exp(x)) - f")),
            &groups,
        )?
        .identity(
            "Ω' = (β − 1)(Ω − V) without inertia at κ = β − 1, Ω = e^(x + y) and V = e^x",
            &used,
            &(omega.clone() * (without + evolution)),
            &(formula("beta - 1") * (omega - formula("exp(x)"))),
            &critical,
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_change_is_certified_and_another_law_is_refuted() {
        let equations = crate::theory::equations::tests::paper();
        assert!(change_of_integral(&equations).unwrap().is_certified());
        let altered = equations.altered("2", "theta' = 1 - 2*V*theta/D_c").unwrap();
        assert!(change_of_integral(&altered).is_err());
    }
}
