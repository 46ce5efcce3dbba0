//! How η changes along K = K_c with rising velocity: the order in which the kinds of transition follow each other.

use crate::theory::Equations;
use crate::theory::notation::{formula, weaker_direct_effect};
use slipmode_algebra::{Domain, Proof, Refutation, Symbol};

/// Along K = K_c η rises with V_0: where the normal stress is the weight M g and K/M is set, and where K and M are given and σ is set.
///
/// # Errors
/// When eq 9 gives another line, or η is another parameter.
pub fn along_velocity(equations: &Equations) -> Result<Proof, Refutation> {
    let critical = equations.right("9");
    let eta = equations.right("inertial-parameter");
    let weight = formula("M*g");
    let domain = Domain::positive("a b D_c M V_0 g sigma");
    let (velocity, stress) = (Symbol::from("V_0"), Symbol::from("sigma"));
    let per_weight = formula("V_0^2/(g*a*D_c)");
    // On the line dσ/dV_0 = −(∂K_c/∂V_0)/(∂K_c/∂σ).
    let slope = -critical.derivative(&velocity) / critical.derivative(&stress);
    let change = eta.derivative(&velocity) + eta.derivative(&stress) * slope;
    Proof::new(
        "inertial-parameter-along-the-transition",
        "Along K = K_c η rises with V_0, with σ = M g on the axes V_0 and K/M, and with given K and M on the axes V_0 and σ.",
    )
    .identity(
        "K_c/M with σ = M g, by V_0 and η alone",
        &["9"],
        &(critical.with("sigma", &weight) / formula("M")),
        &(formula("(b - a)*g/D_c") * (formula("1") + per_weight.clone())),
        &domain,
    )?
    .identity("η with σ = M g", &["inertial-parameter"], &eta.with("sigma", &weight), &per_weight, &domain)?
    .positive("dη/dV_0 with σ = M g", &[], &per_weight.derivative(&velocity), &domain)?
    .positive(
        "dη/dV_0 along K = K_c with given K and M, a < b",
        &["9", "inertial-parameter"],
        &change,
        &weaker_direct_effect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inertial_parameter_rises_and_an_altered_equation_is_refuted() {
        let equations = crate::theory::equations::tests::paper();
        assert!(along_velocity(&equations).unwrap().is_certified());
        let altered = equations.altered("9", "K_c = (b - a)*sigma/D_c*(1 + M*V_0/(sigma*a*D_c))").unwrap();
        assert!(along_velocity(&altered).is_err());
        let altered = equations.altered("inertial-parameter", "eta = M*V_0^2/(sigma*a*D_c^2)").unwrap();
        assert!(along_velocity(&altered).is_err());
    }
}
