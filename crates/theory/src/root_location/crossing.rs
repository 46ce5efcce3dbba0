//! When a pair of roots ±iω crosses the imaginary axis at one value of a parameter, and no other root is on the axis there.

use super::polynomial;
use crate::notation::formula;
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Sign, SignFormula, Symbol};

/// At `parameter` = `critical` the polynomial with these coefficients has the roots ±i·`frequency`, which is not zero, no other root on
/// the axis, and the real part of the pair has a slope in the parameter that is not zero. The proof is that of the general lemma.
///
/// # Errors
/// Never, unless a step of the lemma is at fault; the tests prove all of them.
pub fn pair_crosses(
    coefficients: &[Expression],
    parameter: &Symbol,
    critical: &Expression,
    frequency: &Expression,
) -> Result<(SignFormula, Proof), Refutation> {
    let zero = || Expression::integer(0);
    let coefficient = |power: usize| coefficients.get(power).cloned().unwrap_or_else(zero);
    let critical_values = |one: &Expression| one.with(parameter, critical);
    let at = |power: usize| critical_values(&coefficient(power));
    let slope = |power: usize| critical_values(&coefficient(power).derivative(parameter));
    let square = frequency.clone().power(2);
    let real_part = at(0) - at(2) * square.clone();
    let imaginary_part = at(1) - at(3) * square.clone();
    let own =
        |names: [&'static str; 4], values: [Expression; 4]| names.map(Symbol::from).into_iter().zip(values);
    let values = own(VALUES, [0, 1, 2, 3].map(at)).chain(own(SLOPES, [0, 1, 2, 3].map(slope)));
    let values = values.chain([("omega".into(), frequency.clone())]).collect();
    let rate = formula(RATE).substitute(&values);
    let mut signs = vec![
        SignFormula::sign(frequency, Sign::NonZero),
        SignFormula::sign(&real_part, Sign::Zero),
        SignFormula::sign(&imaginary_part, Sign::Zero),
        SignFormula::sign(&at(2), Sign::NonZero),
        SignFormula::sign(&rate, Sign::NonZero),
    ];
    // The coefficients of a quadratic above its own are zero.
    signs.retain(|sign| *sign != SignFormula::sign(&zero(), Sign::Zero));
    Ok((SignFormula::All(signs), lemma(coefficients.len() - 1)?))
}

/// The names of the coefficients and of their slopes in the parameter, by ascending power.
const VALUES: [&str; 4] = ["c_0", "c_1", "c_2", "c_3"];
const SLOPES: [&str; 4] = ["d_0", "d_1", "d_2", "d_3"];

/// Re(∂P/∂K · conj ∂P/∂s) at s = iω, where d_k = ∂c_k/∂K: the slope of the pair's real part times −|∂P/∂s|².
const RATE: &str = "(d_0 - d_2*omega^2)*(c_1 - 3*c_3*omega^2) + 2*omega^2*c_2*(d_1 - d_3*omega^2)";

fn lemma(degree: usize) -> Result<Proof, Refutation> {
    let names = |all: [&'static str; 4]| {
        all.into_iter().take(degree + 1).map(Expression::variable).collect::<Vec<_>>()
    };
    let none_above = |one: Expression| match degree {
        3 => one,
        _ => one.with("c_3", &formula("0")).with("d_3", &formula("0")),
    };
    let (at_root, imaginary) = (polynomial(&names(VALUES), "s"), formula("i*omega"));
    let by_parameter = polynomial(&names(SLOPES), "s").with("s", &imaginary);
    let by_root = at_root.derivative(&Symbol::from("s"));
    let conjugate = by_root.with("s", &formula("-i*omega"));
    let rate = none_above(formula(RATE));
    let rest = none_above(formula(
        "i*omega*((d_1 - d_3*omega^2)*(c_1 - 3*c_3*omega^2) - 2*c_2*(d_0 - d_2*omega^2))",
    ));
    let proof = Proof::new(
        &format!("crossing-pair-of-degree-{degree}"),
        "±iω are roots exactly when real and imaginary part of the polynomial vanish there; with c2 ≠ 0 the other root is not on the \
         axis. By implicit differentiation the slope of the pair's real part is −Re(∂P/∂K conj ∂P/∂s)/|∂P/∂s|².",
    );
    let parts = none_above(formula("(c_0 - c_2*omega^2) + i*omega*(c_1 - c_3*omega^2)"));
    let on_pair = |one: Expression| {
        one.with("c_0", &formula("c_2*omega^2")).with("c_1", &none_above(formula("c_3*omega^2")))
    };
    let mut steps = vec![
        ("real and imaginary part at iω", at_root.with("s", &imaginary), parts),
        ("∂P/∂K conj ∂P/∂s at iω", by_parameter * conjugate, rate + rest),
    ];
    if degree == 3 {
        let says = "where both vanish the third root is −c2/c3, or there is none";
        steps.push((says, on_pair(at_root), formula("(s^2 + omega^2)*(c_3*s + c_2)")));
        let says = "and ∂P/∂s at iω is not zero for ω ≠ 0, c2 ≠ 0: its imaginary part is 2 c2 ω";
        let slope = on_pair(by_root).with("s", &imaginary);
        steps.push((says, slope, formula("-2*c_3*omega^2 + i*2*c_2*omega")));
    } else {
        let says = "where both vanish the polynomial is c2 (s² + ω²), with a slope 2 c2 iω that is not zero";
        steps.push((says, on_pair(at_root), formula("c_2*(s^2 + omega^2)")));
    }
    steps.iter().try_fold(proof, |proof, (says, left, right)| {
        proof.identity(says, &[], left, right, &Domain::default())
    })
}
