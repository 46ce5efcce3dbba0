//! What exchanging a and b leaves unchanged.

use super::Equations;
use super::non_inertial::frequency_squared_of_eq_14;
use super::notation::{
    SQUARE_MASS, SQUARE_STIFFNESS, any, below, discriminant_of_cubic, formula, in_parameters, strengthening,
    weakening,
};
use slipmode_algebra::{Certificate, Expression, Proof, Refutation, Relation, Symbol};

/// What becomes of one equation when a and b are exchanged.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exchange {
    /// The number of the equation.
    pub equation: &'static str,
    /// Is it the same equation afterwards?
    pub invariant: bool,
    /// Does it contain b at all? An equation without b cannot change with the sign of a − b at fixed a.
    pub contains_b: bool,
    /// The factor by which the normal stress (eqs 15, 16) or velocity (18, 20) that solves it changes, in a and b.
    pub factor: Expression,
    /// The proof of all that.
    pub proof: Proof,
}

/// Decides for eqs 15, 16, 18 and 20 whether exchanging a and b leaves them unchanged (claims B6 and B8).
///
/// # Errors
/// When an equation has no definite factor under the exchange.
pub fn asymptotes(equations: &Equations) -> Result<Vec<Exchange>, Refutation> {
    ["15", "16", "18", "20"].into_iter().map(|number| exchange(equations, number)).collect()
}

fn exchange(equations: &Equations, number: &'static str) -> Result<Exchange, Refutation> {
    let equation = equations.equation(number);
    // Each of the four says "ratio = 1" with a ratio proportional to V0 or inversely proportional to σ.
    let ratio = equation.left.clone() / equation.right.clone();
    let exchanged = exchanged(&ratio);
    let invariant = weakening().difference(&ratio, &exchanged).is_ok_and(|difference| difference.is_zero());
    let contains_b = ratio.variables().contains(&Symbol::from("b"));
    let factor = if invariant { formula("1") } else { formula("b/a") };
    let proof = Proof::new(
        &format!("exchange-of-a-and-b-in-eq-{number}"),
        match invariant {
            true => format!("Exchanging a and b leaves eq {number} unchanged."),
            false => {
                format!("Exchanging a and b changes eq {number}: its solution is multiplied by {factor}.")
            }
        },
    );
    let scaled = exchanged * factor.clone();
    let mut proof = proof
        .identity(
            "for a < b, the equation's ratio against that after the exchange",
            &[number],
            &ratio,
            &scaled,
            &weakening(),
        )?
        .identity("the same for a > b", &[number], &ratio, &scaled, &strengthening())?;
    if !invariant {
        let excess = factor.clone() - formula("1");
        proof = proof
            .positive("the factor is greater than 1 for a < b", &[number], &excess, &weakening())?
            .negative("and less than 1 for a > b", &[number], &excess, &strengthening())?;
    }
    Ok(Exchange { equation: number, invariant, contains_b, factor, proof })
}

/// No a' > b' gives the lines of eqs 15, 16, 18 and 20 that a < b has: eqs 16 and 20 exclude each other (claim B6).
///
/// # Errors
/// When eq 20 or 16 depends otherwise on a and b.
pub fn no_other_choice(equations: &Equations) -> Result<Proof, Refutation> {
    let ratio =
        |number: &str| equations.equation(number).left.clone() / equations.equation(number).right.clone();
    let (inertial, weakest) = (ratio("20"), equations.right("16"));
    let other = inertial.with("a", &formula("a_1"));
    let squares = in_parameters(any().and_positive("a_1"), &[SQUARE_STIFFNESS, SQUARE_MASS]);
    let ordered = below().and_positive("b_1").given(formula("a - b_1"), Relation::Positive);
    let ordered = in_parameters(
        ordered.example("b_1", formula("1/2")),
        &[
            ("b_1", "delta^2", "delta", "sqrt(b_1)"),
            ("a", "(delta + epsilon)^2", "epsilon", "sqrt(a) - sqrt(b_1)"),
            ("b", "(delta + epsilon + gamma)^2", "gamma", "sqrt(b) - sqrt(a)"),
        ],
    );
    let mirrored = ratio("18").with("b", &formula("2*a - b"));
    Proof::new(
        "no-other-choice-of-a-and-b",
        "No pair a' > b' keeps eqs 16 and 20 of a pair a < b, so none keeps all four. Eq 20 stays for a' = a only; \
             then eq 16 lies higher for every b' < a. Eqs 18 and 20 alone stay for b' = 2a − b.",
    )
    .identity("eq 20 with a' for a: V0 is multiplied by a'/a", &["20"], &inertial, &(other * formula("a_1/a")), &squares)?
    .positive(
        "eq 16 with b' < a in place of b > a, less eq 16",
        &["16"],
        &(weakest.with("b", &formula("b_1")) - weakest),
        &ordered,
    )?
    .identity("eq 18 with b' = 2a − b", &["18"], &mirrored, &ratio("18"), &weakening())
}

/// The frequency maps for (a, b) and for (b, a) differ (claim B7).
///
/// Without inertia every frequency is multiplied by a/b, so that only the contour Im = 0 stays; with inertia that one
/// moves too.
///
/// # Errors
/// When eq 8 or 14 behaves otherwise.
pub fn frequency_contours(equations: &Equations) -> Result<Proof, Refutation> {
    let proof = Proof::new(
        "frequency-contours-under-exchange",
        "Exchanging a and b changes the frequency contours. Without inertia each angular \
             frequency is multiplied by a/b, so only the contour of frequency zero stays; with \
             inertia that one moves as well. Both maps tend to ω_n at high velocity.",
    );
    let square = frequency_squared_of_eq_14(equations, &proof)?;
    let other = exchanged(&square);
    let cubic = equations.residual("8") * formula("sigma");
    let point = boundary_point();
    let (before, after) = (discriminant_at(&cubic, &point)?, discriminant_at(&exchanged(&cubic), &point)?);
    let values = [before.1.clone(), after.1.clone()];
    let certificate = Certificate::Difference { left: before.0, right: after.0, point, values };
    proof
        .identity(
            "ω² of eq 14 times a², before and after the exchange",
            &["14"],
            &(square * formula("a^2")),
            &(other * formula("b^2")),
            &any(),
        )?
        .certify(
            "discriminant of eq 8 (times σ) at a point of the boundary, before and after the \
             exchange",
            &["8"],
            certificate,
        )
}

/// a and b exchanged, both at once.
fn exchanged(expression: &Expression) -> Expression {
    expression.substitute(&[(Symbol::from("a"), formula("b")), (Symbol::from("b"), formula("a"))].into())
}

/// A rational point with a = 0.004, b = 0.006, D_c = 10 µm, K = 10 MPa/m, M = 1000 kg/m² on the boundary: its double root
/// is r = −3 D_c/V0, so that κ = 69/16 and η = 5/48; σ follows from κ and V0² from η.
fn boundary_point() -> Vec<(Symbol, Expression)> {
    let values =
        [("a", "1/250"), ("b", "3/500"), ("D_c", "1/100000"), ("K", "10000000"), ("sigma", "400000/69")];
    let mut point: Vec<_> = values.map(|(name, value)| (Symbol::from(name), formula(value))).into();
    // V0² = η σ a D_c/M is rational, V0 is not: the discriminant in s·V0 needs V0² only, so M V0² is given as a mass at V0 = 1.
    point.push(("M".into(), formula("5/48*400000/69*1/250*1/100000")));
    point.push(("V_0".into(), formula("1")));
    point
}

/// The discriminant in s with its exact value at a point.
fn discriminant_at(
    cubic: &Expression,
    point: &[(Symbol, Expression)],
) -> Result<(Expression, Expression), Refutation> {
    let proof = Proof::new("frequency-contours-under-exchange", "");
    let cubic = cubic.clone() * formula("V_0*D_c");
    let expression = Expression::from(&discriminant_of_cubic(&proof, &cubic, "s", &any())?);
    let values = point.iter().cloned().collect();
    let value = super::notation::simplified(&proof, &["8"], &expression.substitute(&values), &any())?;
    Ok((expression, value))
}
