//! The cycle next to K = K_c by the expansion of Lindstedt and Poincaré, in V and θ themselves, order by order.
//!
//! It shares only eqs 1-4 with the projection: other variables, no eigenvectors, no normal form, real arithmetic.

use std::collections::BTreeMap;

use super::expansion::{Conditions, in_basis, solve, taylor_part};
use super::slider::{by_groups, on_transition};
use crate::polynomial::{Domain, Expression, Proof, Refutation, Symbol};
use crate::theory::PaperEquations;
use crate::theory::linearisation::{Law, evolution, motion};
use crate::theory::notation::{formula, simplified};

/// u = V/V_0 − 1 with its first two rates, w = V_0 θ/D_c − 1 with its rate, in the time D_c/V_0.
const MOTION: [&str; 5] = ["u", "u'", "u''", "w", "w'"];

/// The values of [`MOTION`].
type Motion = [Expression; 5];

/// A pair of equations: eq 4 differentiated in time, and the law.
type Pair = [Expression; 2];

/// What the expansion finds for u = ε cos τ + O(ε²), τ = Ω t, in which cos τ and sin τ do not occur again.
pub(super) struct Cycle {
    /// κ_2 of κ = κ_c + ε² κ_2.
    pub stiffness: Expression,
    /// Ω_2 of Ω = ω + ε² Ω_2.
    pub frequency: Expression,
}

/// Derives κ_2 and Ω_2.
///
/// # Errors
/// When no periodic motion of this form solves the equations to third order.
pub(super) fn cycle(
    proof: Proof,
    equations: &PaperEquations,
    law: Law,
) -> Result<(Proof, Cycle), Refutation> {
    let used = ["1", law.equation(), "4", "steady-state"];
    let (proof, [linear, quadratic, cubic]) = taylor_parts(proof, &used, equations, law)?;

    let first = moving("C", "w_c*C + w_s*S");
    let rest = at(&linear, &first);
    let (proof, values) = order(proof, &used, "ε", &rest, &["w_c", "w_s"])?;
    let first = with(&first, &values);

    let harmonics = |f: &str| format!("{f}_0 + {f}_c*(2*C^2 - 1) + {f}_s*2*S*C");
    let second = moving(&harmonics("f"), &harmonics("g"));
    let rest = plus(&at(&linear, &second), &at(&quadratic, &first));
    let (proof, values) = order(proof, &used, "ε²", &rest, &["f_0", "f_c", "f_s", "g_0", "g_c", "g_s"])?;
    let second = with(&second, &values);

    let harmonics = |f: &str| format!("{f}_c*(4*C^3 - 3*C) + {f}_s*S*(4*C^2 - 1)");
    let third = moving(&harmonics("f"), &format!("{} + w_c*C + w_s*S", harmonics("g")));
    let third = plus_motion(&third, &retimed(&first));
    let softened = linear.clone().map(|part| formula("kappa_2") * part.derivative(&Symbol::new("kappa")));
    let both = plus_motion(&first, &second);
    let cross = plus(&at(&quadratic, &both), &at(&quadratic, &first).map(|part| -part));
    let cross = plus(&cross, &at(&quadratic, &second).map(|part| -part));
    let rest = plus(&plus(&at(&linear, &third), &at(&softened, &first)), &plus(&cross, &at(&cubic, &first)));
    let unknowns = ["f_c", "f_s", "g_c", "g_s", "w_c", "w_s", "Omega_2", "kappa_2"];
    let (proof, values) = order(proof, &used, "ε³", &rest, &unknowns)?;
    let value = |name: &str| formula(name).substitute(&values);
    Ok((proof, Cycle { stiffness: value("kappa_2"), frequency: value("Omega_2") }))
}

/// Finds the unknowns for which both equations vanish at this order, and certifies it.
fn order(
    proof: Proof,
    used: &[&str],
    power: &str,
    vanishing: &Pair,
    unknowns: &[&str],
) -> Result<(Proof, BTreeMap<Symbol, Expression>), Refutation> {
    // On the circle the sine is a root; the conversion names it, and so do the conditions.
    let domain = on_circle();
    let sine = simplified(&proof, used, &formula("S"), &domain)?.to_string();
    let identically_in = ["C", sine.as_str()];
    let values = solve(&proof, used, &Conditions { vanishing, identically_in: &identically_in, unknowns }, &domain)?;
    let solved = vanishing.clone().map(|part| part.substitute(&values));
    let says = format!("eq 4 differentiated in time and the law (by e_1, e_2) at order {power}, C = cos τ, S = sin τ");
    Ok((proof.identity(&says, used, &in_basis(&solved), &formula("0"), &domain)?, values))
}

/// K = K_c and a point (C, S) of the unit circle.
fn on_circle() -> Domain {
    on_transition().with("S", formula("sqrt(1 - C^2)"))
}

/// Both equations in the variables of [`MOTION`] and in η, κ, β.
fn residuals(equations: &PaperEquations, law: Law) -> Pair {
    let balance = motion(equations, &equations.right("1")).time_derivative(&["t", "delta", "theta"]);
    let theta = equations.right("steady-state").with("V", &formula("V_0")) * formula("1 + w");
    let values = [
        ("t'", formula("1")),
        ("delta'", formula("V_0*(1 + u)")),
        ("delta''", formula("V_0^2/D_c*u'")),
        ("delta'''", formula("V_0^3/D_c^2*u''")),
        ("theta", theta),
        ("theta'", formula("w'")),
    ];
    let values = values.map(|(name, value)| (Symbol::new(name), value)).into();
    let pair = [balance * formula("D_c/(a*V_0)"), evolution(equations, law)];
    pair.map(|equation| equation.substitute(&values))
}

/// The Taylor parts of degrees 1, 2 and 3, each with its certificate.
fn taylor_parts(
    mut proof: Proof,
    used: &[&str],
    equations: &PaperEquations,
    law: Law,
) -> Result<(Proof, [Pair; 3]), Refutation> {
    let residuals = residuals(equations, law);
    let mut parts = [0; 3].map(|_| [formula("0"), formula("0")]);
    for (degree, pair) in (1..).zip(&mut parts) {
        let derived = residuals.clone().map(|residual| taylor_part(&residual, &MOTION, degree));
        for (part, value) in pair.iter_mut().zip(&derived) {
            *part = simplified(&proof, used, value, &by_groups())?;
        }
        let says = format!("degree {degree} of eq 4 differentiated in time and of the law, V = V_0 (1 + u), θ = D_c/V_0 (1 + w)");
        proof = proof.identity(&says, used, &in_basis(&derived), &in_basis(pair), &by_groups())?;
    }
    Ok((proof, parts))
}

/// The motion at frequency ω along these u and w.
fn moving(u: &str, w: &str) -> Motion {
    let (u, w) = (formula(u), formula(w));
    let rate = |expression: &Expression| formula("omega") * turned(expression);
    [u.clone(), rate(&u), rate(&rate(&u)), w.clone(), rate(&w)]
}

/// What the frequency's change Ω_2 adds to the rates, for rates that were taken at frequency ω.
fn retimed(motion: &Motion) -> Motion {
    let [_, speed, acceleration, _, evolution] = motion.clone();
    let relative = formula("Omega_2/omega");
    let zero = formula("0");
    [
        zero.clone(),
        relative.clone() * speed,
        formula("2") * relative.clone() * acceleration,
        zero,
        relative * evolution,
    ]
}

/// The derivative by τ of an expression in C = cos τ and S = sin τ.
fn turned(expression: &Expression) -> Expression {
    formula("C") * expression.derivative(&Symbol::new("S")) - formula("S") * expression.derivative(&Symbol::new("C"))
}

fn at(forms: &Pair, motion: &Motion) -> Pair {
    let values = MOTION.iter().zip(motion).map(|(name, value)| (Symbol::new(name), value.clone())).collect();
    forms.clone().map(|form| form.substitute(&values))
}

fn plus(left: &Pair, right: &Pair) -> Pair {
    [0, 1].map(|n| left[n].clone() + right[n].clone())
}

fn plus_motion(left: &Motion, right: &Motion) -> Motion {
    [0, 1, 2, 3, 4].map(|n| left[n].clone() + right[n].clone())
}

fn with(motion: &Motion, values: &BTreeMap<Symbol, Expression>) -> Motion {
    motion.clone().map(|part| part.substitute(values))
}
