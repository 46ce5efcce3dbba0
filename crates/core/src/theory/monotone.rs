//! In which direction each parameter leads into an area of real roots, and into K < K_c: what a box of parameters contains.
//!
//! With |s| = V0 w each area is {G ≤ 0 at some w} or {G ≥ 0 at some w_1, G ≤ 0 at some w_2 > w_1} for a function G that rises or
//! falls with each parameter at every w.

use super::Equations;
use super::notation::{
    any, cubic, formula, given_positive, in_parameters, simplified, stronger_direct_effect,
    weaker_direct_effect,
};
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

/// The inertia and the spring in G, M V0² w/σ + K/(σ w).
const MACHINE: &str = "M*V_0^2*w/sigma + K/(sigma*w)";

/// Eq 8 in groups at s = ±V0 w, with the groups in parameters.
fn eq_8_at(equations: &Equations, place: &str) -> Expression {
    cubic(equations)
        .with("p", &formula(place))
        .with("eta", &formula("M*V_0^2/(a*sigma*D_c)"))
        .with("kappa", &formula("K*D_c/(a*sigma)"))
        .with("beta", &formula("b/a"))
}

/// Adds the sign of ∂G/∂parameter for parameters in which G rises, and for those in which it falls.
fn directions(
    mut proof: Proof,
    g: &Expression,
    [rises, falls]: [&[&'static str]; 2],
    domain: &Domain,
) -> Result<Proof, Refutation> {
    for (parameters, is_rising) in [(rises, true), (falls, false)] {
        for parameter in parameters {
            let slope = g.derivative(&Symbol::from(*parameter));
            let says = format!("∂G/∂{parameter}");
            proof = if is_rising {
                proof.positive(&says, &[], &slope, domain)?
            } else {
                proof.negative(&says, &[], &slope, domain)?
            };
        }
    }
    Ok(proof)
}

/// The proofs that decide a box of parameters: on the areas, on K < K_c, and on thresholds of the frequency.
///
/// # Errors
/// When an equation is another one than the paper's.
pub fn of_a_box(equations: &Equations) -> Result<Vec<Proof>, Refutation> {
    Ok(vec![
        unstable_real_area(equations)?,
        upper_area(equations)?,
        unstable_side(equations)?,
        lower_area_path(equations)?,
        lower_area_between(equations)?,
        super::monotone_frequency::threshold(equations)?,
    ])
}

/// All roots real, two of them positive: up in σ and b, down in a, D_c, K, M and V0.
///
/// # Errors
/// When eq 8 does not have the form that the area rests on.
pub fn unstable_real_area(equations: &Equations) -> Result<Proof, Refutation> {
    let g = formula(&format!("{MACHINE} + a - b/(D_c*w + 1)"));
    let factor = formula("D_c*w*(D_c*w + 1)/a");
    let domain = any().and_positive("w");
    let proof = Proof::new(
        "unstable-real-area-is-monotone",
        "F is positive at 0 and for large p, so two positive roots (or a double one) exist exactly when G ≤ 0 at some w > 0. \
             Greater σ and b lead into this area, greater a, D_c, K, M and V0 out of it. A box of \
             parameters lies inside exactly when the corner with least σ, b and greatest a, D_c, K, M, V0 does, and meets it \
             exactly when the opposite corner does.",
    )
    .identity(
        "F at p = D_c w is G times what is positive, for w > 0",
        &["8"],
        &eq_8_at(equations, "D_c*w"),
        &(factor * g.clone()),
        &domain,
    )?
    .positive("F(0)", &["8"], &eq_8_at(equations, "0"), &domain)?;
    directions(proof, &g, [&["a", "D_c", "K", "M", "V_0"], &["sigma", "b"]], &domain)
}

/// All roots real, two of them in −1 < p < 0: up in a and σ, down in b, D_c, K, M and V0.
///
/// # Errors
/// When eq 8 does not have the form that the area rests on.
pub fn upper_area(equations: &Equations) -> Result<Proof, Refutation> {
    let g = formula(&format!("{MACHINE} - a + b/(1 - D_c*w)"));
    let factor = formula("D_c*w*(1 - D_c*w)/a");
    let domain = given_positive(any().and_positive("w"), "1 - D_c*w", &[("w", "1/2")]);
    let domain = in_parameters(domain, &[("w", "1/(D_c*(1 + e))", "e", "1/(D_c*w) - 1")]);
    let proof = Proof::new(
        "upper-area-is-monotone",
        "F is positive at −1 and 0, so two roots (or a double one) lie between exactly when G ≤ 0 at some w. Greater a and σ \
             lead into this area, greater b, D_c, K, M and V0 out of it. Two \
             corners decide whether a box of parameters lies inside, and whether it meets the area.",
    )
    .identity(
        "F at p = −D_c w is G times what is positive, for 0 < w < 1/D_c",
        &["8"],
        &eq_8_at(equations, "-D_c*w"),
        &(factor * g.clone()),
        &domain,
    )?
    .positive("F(0)", &["8"], &eq_8_at(equations, "0"), &domain)?
    .positive("F(−1)", &["8"], &eq_8_at(equations, "-1"), &domain)?;
    directions(proof, &g, [&["b", "D_c", "K", "M", "V_0"], &["a", "sigma"]], &domain)
}

/// K < K_c: up in b, M, V0 and σ, down in K, a and D_c, also where a − b changes its sign in the box.
///
/// # Errors
/// When K_c of eq 9 has another form.
pub fn unstable_side(equations: &Equations) -> Result<Proof, Refutation> {
    let margin = formula("K") - equations.right("9");
    let weakening = weaker_direct_effect();
    let mut proof = Proof::new(
        "unstable-side-is-monotone",
        "Greater b, M, V0 and σ lead to K < K_c, greater K, a and D_c away from it. Two corners decide for a box of parameters.",
    )
    .positive("K − K_c where a > b: no K is below K_c, so only points with a < b count", &["9"], &margin, &stronger_direct_effect())?;
    for (parameter, is_rising) in [
        ("K", true),
        ("a", true),
        ("D_c", true),
        ("b", false),
        ("M", false),
        ("V_0", false),
        ("sigma", false),
    ] {
        let slope = margin.derivative(&Symbol::from(parameter));
        let says = format!("∂(K − K_c)/∂{parameter} for a < b");
        proof = if is_rising {
            proof.positive(&says, &["9"], &slope, &weakening)?
        } else {
            proof.negative(&says, &["9"], &slope, &weakening)?
        };
    }
    Ok(proof)
}

/// All roots real and left of −1: G rises with M, K, V0, D_c and falls with σ, a, b; and the order of a path along the edges of
/// a box that meets the area whenever the box does.
///
/// # Errors
/// When eq 8 does not have the form that the area rests on.
pub fn lower_area_path(equations: &Equations) -> Result<Proof, Refutation> {
    let g = formula(&format!("{MACHINE} - a - b/(D_c*w - 1)"));
    let factor = formula("-D_c*w*(D_c*w - 1)/a");
    let domain = given_positive(any().and_positive("w"), "D_c*w - 1", &[("w", "2")]);
    let domain = in_parameters(domain, &[("w", "(1 + e)/D_c", "e", "D_c*w - 1")]);
    let proof = Proof::new(
        "lower-area-by-a-path",
        "A box of parameters meets the area of three real roots left of −1 exactly when a path along its edges does. The path \
             goes from the corner with greatest σ, a, b and least M, K, V0, D_c to the opposite one and changes D_c, b, K, σ, a, \
             M, V0 in this order. For F(−1) is positive, so three roots lie left of −1 exactly when G(w_1) ≥ 0 ≥ G(w_2) for some \
             1/D_c < w_1 < w_2, or a triple one does. Exchange a later parameter of the path for an earlier one at constant \
             G(w_2): G(w_1) does not fall. So from any point of the area the exchanges end on the path, in the area.",
    )
    .identity(
        "F at p = −D_c w is −G times what is positive, for w > 1/D_c",
        &["8"],
        &eq_8_at(equations, "-D_c*w"),
        &(factor * g.clone()),
        &domain,
    )?;
    let proof = directions(proof, &g, [&["M", "K", "V_0", "D_c"], &["sigma", "a", "b"]], &domain)?;
    ratios(proof, &g)
}

/// The ratio of ∂G(w_1) to ∂G(w_2) does not grow from one parameter of the path to the next.
fn ratios(mut proof: Proof, g: &Expression) -> Result<Proof, Refutation> {
    let ends = [("w_1", "(1 + e)/D_c"), ("w_2", "(1 + e + f)/D_c")];
    let domain = ends
        .iter()
        .fold(any().and_positive("e f"), |domain, (name, value)| domain.with(*name, formula(value)));
    let at = |f: &Expression, place: &str| f.with("w", &formula(place));
    let ratio = |parameter: &'static str| {
        let slope = g.derivative(&Symbol::from(parameter));
        at(&slope, "w_1") / at(&slope, "w_2")
    };
    for [earlier, later] in [["D_c", "b"], ["b", "K"], ["K", "sigma"], ["a", "M"], ["M", "V_0"]] {
        let difference = ratio(earlier) - ratio(later);
        let says = format!("the ratio for {earlier} less that for {later}");
        proof = if later == "V_0" {
            proof.identity(&says, &[], &difference, &formula("0"), &domain)?
        } else {
            proof.positive(&says, &[], &difference, &domain)?
        };
    }
    let excess = at(g, "w_1") - at(g, "w_2");
    let stress = ratio("sigma") - formula("1");
    let stress = simplified(&proof, &[], &stress, &domain)?;
    let scale = at(&formula("sigma/(M*V_0^2*w + K/w)"), "w_2");
    let rest = formula("b/(D_c*w_1 - 1) - b/(D_c*w_2 - 1)");
    proof
        .identity(
            "the ratio for sigma less 1, which is that for a: G(w_1) − G(w_2) and a rest, times what is positive",
            &[],
            &stress,
            &(scale * (excess + rest.clone())),
            &domain,
        )?
        .positive("the rest", &[], &rest, &domain)
}

/// All roots real and left of −1: a box of parameters lies inside exactly when its least and its greatest corner do.
///
/// # Errors
/// When G has another form, or the last sign is another one.
pub fn lower_area_between(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "lower-area-between-two-corners",
        "Let w be the smallest root of G at the least corner of a box, where σ, a, b are greatest and M, K, V0, D_c least, and W the \
             largest at the opposite one, both in the area of three real roots left of −1. If w ≤ W, then G(w) ≥ 0 ≥ G(W) at every \
             point of the box, which therefore lies in the area. Otherwise no t = 1/w of the least corner is above some T, and none of \
             the greatest corner below it. At given K/σ, D_c and b, a is largest where the three t are equal; T may be lowered to \
             them. It is smallest, for t ≥ T, where two of them are T. So there are T, T, T at the one and T, T, v at the other corner \
             with neither a nor b greater at the greatest corner. Let D_c grow by the factor D, and τ = T/D_c after it. From a \
             follows a bound on v, from b one on 1 − v. Their sum is below 1 for D > 1, a contradiction; for D = 1 it is 1, \
             the two corners have the same triple root, and w = W.",
    )
    .using(lower_area_path(equations)?);
    let g = formula(&format!("{MACHINE} - a - b/(D_c*w - 1)"))
        .with("w", &formula("1/t"))
        .with("M", &formula("k*sigma*t_1*t_2*t_3/(D_c*V_0^2)"))
        .with("K", &formula("k*sigma"))
        .with("a", &formula("k*((t_1*t_2 + t_1*t_3 + t_2*t_3)/D_c - t_1*t_2*t_3/D_c^2)"))
        .with("b", &formula("k*(D_c - t_1)*(D_c - t_2)*(D_c - t_3)/D_c^2"))
        .with("D_c", &formula("t + e"));
    let roots = formula("-k*(t - t_1)*(t - t_2)*(t - t_3)/(t*e)");
    let of_roots = any().and_positive("e k t t_1 t_2 t_3");
    let of_a = formula("(t_1*t_2 + t_1*t_3 + t_2*t_3)/D_c^2 - t_1*t_2*t_3/D_c^3");
    let of_b = formula("(1 - t_1/D_c)*(1 - t_2/D_c)*(1 - t_3/D_c) - 1 + (t_1 + t_2 + t_3)/D_c");
    let bounds = formula("tau*(3*D - tau*D^2 - 1)/(2 - tau) + (1 - tau*D)^3/(D*(1 - tau)^2) - 1")
        .with("tau", &formula("1/(1 + d + m)"))
        .with("D", &formula("1 + d"));
    proof
        .identity(
            "G in its roots 1/t_1, 1/t_2, 1/t_3, with k = K/σ and D_c = t + e",
            &[],
            &g,
            &roots,
            &of_roots,
        )?
        .identity("a/(k D_c) in b/(k D_c) and the sum of the roots", &[], &of_a, &of_b, &of_roots)?
        .negative(
            "the sum of the bounds on v and 1 − v less 1, for D = 1 + d and τ = 1/(1 + d + m)",
            &[],
            &bounds,
            &any().and_positive("d m"),
        )
}
