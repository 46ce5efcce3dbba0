//! The cycle next to K = K_c by the expansion of Lindstedt and Poincaré, in V and θ themselves, order by order.
//!
//! It shares only eqs 1-4 with the projection: other variables, no eigenvectors, no normal form, real arithmetic.

use super::expansion::{Conditions, solve, taylor_part};
use super::slider::{by_groups, cited, on_transition};
use crate::notation::{formula, simplified};
use crate::{Equations, Role};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};
use slipmode_core::friction::EvolutionLaw;

/// u = V/V_0 − 1 with its first two rates, w = V_0 θ/D_c − 1 with its rate, in the time D_c/V_0.
const MOTION: [&str; 5] = ["u", "u'", "u''", "w", "w'"];

/// The numbers of the equations that a step uses, and what the pair is called.
type Cited<'c> = (&'c [&'c str], &'c [String; 2]);

/// The values of [`MOTION`].
type Motion = [Expression; 5];

/// A pair of equations: eq 4 differentiated in time, and the law.
type Pair = [Expression; 2];

/// What the two are called in a proof.
fn names(equations: &Equations) -> [String; 2] {
    let [motion] = equations.numbers([Role::Motion]);
    [format!("eq {motion} differentiated in time"), "the law".to_owned()]
}

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
    equations: &Equations,
    law: EvolutionLaw,
) -> Result<(Proof, Cycle), Refutation> {
    let used = cited(equations, law);
    let names = names(equations);
    let (proof, [linear, quadratic, cubic]) = taylor_parts(proof, (&used, &names), equations, law)?;

    let first = moving("C", "w_c*C + w_s*S");
    let rest = at(&linear, &first);
    let (proof, domain) = order(proof, (&used, &names), "ε", &rest, &["w_c", "w_s"], on_circle())?;

    let harmonics = |f: &str| format!("{f}_0 + {f}_c*(2*C^2 - 1) + {f}_s*2*S*C");
    let second = moving(&harmonics("f"), &harmonics("g"));
    let rest = plus(&at(&linear, &second), &at(&quadratic, &first));
    let unknowns = ["f_0", "f_c", "f_s", "g_0", "g_c", "g_s"];
    let (proof, domain) = order(proof, (&used, &names), "ε²", &rest, &unknowns, domain)?;

    let harmonics = |f: &str| format!("{f}_c*(4*C^3 - 3*C) + {f}_s*S*(4*C^2 - 1)");
    let third = moving(&harmonics("h"), &format!("{} + l_c*C + l_s*S", harmonics("k")));
    let third = sum(&third, &retimed(&first));
    let softened = linear.clone().map(|part| formula("kappa_2") * part.derivative(&Symbol::from("kappa")));
    let rest = plus(&at(&linear, &third), &at(&softened, &first));
    let rest = plus(&rest, &plus(&mixed(&quadratic, &first, &second), &at(&cubic, &first)));
    let unknowns = ["h_c", "h_s", "k_c", "k_s", "l_c", "l_s", "Omega_2", "kappa_2"];
    let (proof, domain) = order(proof, (&used, &names), "ε³", &rest, &unknowns, domain)?;
    let value = |name: &str| domain.substituted(&formula(name));
    Ok((proof, Cycle { stiffness: value("kappa_2"), frequency: value("Omega_2") }))
}

/// Finds the unknowns for which both equations vanish at this order, and certifies it. The domain gains their values.
fn order(
    mut proof: Proof,
    (used, names): Cited<'_>,
    power: &str,
    vanishing: &Pair,
    unknowns: &[&'static str],
    domain: Domain,
) -> Result<(Proof, Domain), Refutation> {
    let conditions = Conditions { vanishing, identically_in: &["C", "S"], unknowns };
    let domain = solve(&proof, used, &conditions, domain)?;
    for (part, name) in vanishing.iter().zip(names) {
        let says = format!("{name} at order {power}, C = cos τ, S = sin τ");
        proof = proof.identity(&says, used, part, &formula("0"), &domain)?;
    }
    Ok((proof, domain))
}

/// Twice the bilinear form of quadratic forms: what two motions add to each other.
fn mixed(quadratic: &Pair, one: &Motion, other: &Motion) -> Pair {
    let both = at(quadratic, &sum(one, other));
    let (one, other) = (at(quadratic, one), at(quadratic, other));
    [0, 1].map(|n| both[n].clone() - one[n].clone() - other[n].clone())
}

/// K = K_c and a point (C, S) of the unit circle.
fn on_circle() -> Domain {
    on_transition().with_square("S", formula("1 - C^2")).example("S", formula("1"))
}

/// Both equations in X = V/V_0, Y = V_0 θ/D_c and rates per D_c/V_0, as eqs 1, 4 and the law give them.
fn physical(equations: &Equations, law: EvolutionLaw) -> Pair {
    let velocity = formula("delta'");
    let friction = equations.right(Role::Friction).with("V", &velocity);
    let motion = equations.residual(Role::Motion).with("mu", &friction);
    let balance = motion.time_derivative(&["t", "delta", "theta"]);
    let evolution = equations.residual(Role::of_law(law)).with("V", &velocity);
    let values = [
        ("t'", formula("1")),
        ("delta'", formula("V_0*X")),
        ("delta''", formula("V_0^2/D_c*u'")),
        ("delta'''", formula("V_0^3/D_c^2*u''")),
        ("theta", equations.right(Role::SteadyState).with("V", &formula("V_0")) * formula("Y")),
        ("theta'", formula("w'")),
    ];
    let values = values.map(|(name, value)| (Symbol::from(name), value)).into();
    let pair = [balance * formula("D_c/(a*V_0)"), evolution];
    pair.map(|equation| equation.substitute(&values))
}

/// The Taylor parts of degrees 1, 2 and 3 in the variables of [`MOTION`], each with its certificate.
fn taylor_parts(
    mut proof: Proof,
    (used, names): Cited<'_>,
    equations: &Equations,
    law: EvolutionLaw,
) -> Result<(Proof, [Pair; 3]), Refutation> {
    let mut parts = [0; 3].map(|_| [formula("0"), formula("0")]);
    for (side, (equation, name)) in physical(equations, law).iter().zip(names).enumerate() {
        let reduced = simplified(&proof, used, equation, &by_groups())?;
        let says = format!("{name} in X = V/V_0 = 1 + u, Y = V_0 θ/D_c = 1 + w and the groups");
        proof = proof.identity(&says, used, equation, &reduced, &by_groups())?;
        let residual = reduced.with("X", &formula("1 + u")).with("Y", &formula("1 + w"));
        for (degree, pair) in (1..).zip(&mut parts) {
            let derived = taylor_part(&residual, &MOTION, degree);
            pair[side] = simplified(&proof, used, &derived, &by_groups())?;
            let says = format!("degree {degree} of {name}");
            proof = proof.identity(&says, used, &derived, &pair[side], &by_groups())?;
        }
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
    let relative = || formula("Omega_2/omega");
    let twice = formula("2") * relative();
    [formula("0"), relative() * speed, twice * acceleration, formula("0"), relative() * evolution]
}

/// The derivative by τ of an expression in C = cos τ and S = sin τ.
fn turned(expression: &Expression) -> Expression {
    formula("C") * expression.derivative(&Symbol::from("S"))
        - formula("S") * expression.derivative(&Symbol::from("C"))
}

fn at(forms: &Pair, motion: &Motion) -> Pair {
    let values =
        MOTION.iter().zip(motion).map(|(name, value)| (Symbol::from(*name), value.clone())).collect();
    forms.clone().map(|form| form.substitute(&values))
}

fn plus(left: &Pair, right: &Pair) -> Pair {
    [0, 1].map(|n| left[n].clone() + right[n].clone())
}

fn sum(left: &Motion, right: &Motion) -> Motion {
    [0, 1, 2, 3, 4].map(|n| left[n].clone() + right[n].clone())
}
