//! How wrong the asymptotes are: relative errors of the four asymptotes of the boundary as power series, derived to any order.
//!
//! Two ways that share only the characteristic equation: along the boundary's parametrisation by its double root, and by checking that the
//! series makes its discriminant vanish to the same order (the proof's certificate).

use crate::boundary::{Curve, cubic_discriminant, curve};
use crate::notation::{formula, in_groups, rational};
use crate::stated_proofs::stated_domain;
use crate::{Equation, Equations, Role};
use slipmode_algebra::{
    Certificate, Domain, Expression, Polynomial, Proof, RationalFunction, Refutation, Relation, Series,
    Symbol,
};

/// The equations from which the series are derived.
pub const EQUATIONS: [Role; 5] = [
    Role::Characteristic,
    Role::QuasiStaticUpper,
    Role::QuasiStaticLower,
    Role::InertialUpper,
    Role::InertialLower,
];

/// The relative error (exact boundary)/(asymptote) − 1 of one asymptote as a power series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AsymptoteSeries {
    /// The number of the asymptote's equation.
    pub equation: String,
    /// What is compared: `sigma` at the same V0 (asymptotes at low velocity), `V_0` at the same σ (at high velocity).
    pub quantity: &'static str,
    /// The small variable in words: η or κ at the exact boundary, or 1/κ.
    pub variable: &'static str,
    /// Coefficients by ascending power, the first zero; in w = √β for `sigma`, in β for `V_0`.
    pub coefficients: Vec<Expression>,
    /// That the coefficients solve the discriminant's equation, and no other series does.
    pub proof: Proof,
}

/// The series of the four asymptotes up to the power `order`.
///
/// # Errors
/// When an equation is no asymptote of the boundary.
pub fn derive(equations: &Equations, order: usize) -> Result<Vec<AsymptoteSeries>, Refutation> {
    let curve = curve(equations)?;
    let length = order + 1;
    let [_, levels @ .., upper, lower] = EQUATIONS;
    let levels = levels.into_iter().map(|role| quasi_static(equations, &curve, role, length));
    levels.chain([upper, lower].map(|role| inertial(equations, &curve, role, length))).collect()
}

/// At low velocity: σ_exact/σ_asymptote − 1 in η, at the same V0; β = w².
fn quasi_static(
    equations: &Equations,
    curve: &Curve,
    role: Role,
    length: usize,
) -> Result<AsymptoteSeries, Refutation> {
    let [number] = equations.numbers([role]);
    let proof = series_proof(number, "σ_exact/σ_asymptote − 1 in x = η at the same V0, β = w²");
    let domain = stated_domain("beta by its root");
    // With σ = 1 the right side is σ_asymptote/σ, which is κ/κ_asymptote.
    let ratio = rational(&proof, &[number], &in_groups(&equations.right(role)), &domain)?;
    let slope = ratio.derivative(&Symbol::from("kappa"));
    let level = RationalFunction::from(1)
        .checked_div(&slope)
        .filter(|level| !level.numerator().variables().contains(&Symbol::from("kappa")))
        .ok_or_else(|| {
            proof.refute("σ is proportional to K", &[number], Expression::from(&ratio).to_string())
        })?;
    let [eta, kappa] = [&curve.inertial_parameter, &curve.stiffness_group].map(in_root);
    let error = ["w - 1", "-w - 1"].into_iter().find_map(|start| {
        let start = Domain::default().rational_function(&formula(start)).ok()?;
        let root = inverse_series(&eta, start, length)?;
        let error = along(&kappa, &root)?.reciprocal()?;
        let error = error.times(&Series::constant(level.clone(), length)).plus(&minus_one(length));
        error.coefficients()[0].is_zero().then_some(error)
    });
    let error = error.ok_or_else(|| no_asymptote(&proof, equations, role))?;
    let relation = Expression::from(&cubic_discriminant(equations)?)
        .with("beta", &formula("w^2"))
        .with("eta", &formula("x"))
        .with("kappa", &(Expression::from(&level) / formula("1 + y")));
    finish(proof, equations, role, ("sigma", "eta"), &relation, &error, Domain::default())
}

/// At high velocity: V_exact/V_asymptote − 1 in κ or 1/κ, at the same σ.
fn inertial(
    equations: &Equations,
    curve: &Curve,
    role: Role,
    length: usize,
) -> Result<AsymptoteSeries, Refutation> {
    let [number, cubic] = equations.numbers([role, Role::Characteristic]);
    let small = role == Role::InertialUpper;
    let says = if small { "x = κ" } else { "x = 1/κ" };
    let proof = series_proof(number, &format!("V_exact/V_asymptote − 1 in {says} at the same σ"));
    let square = ratio_squared(&proof, equations, role)?;
    let place = if small { formula("r") } else { formula("1/r") };
    let [eta, kappa] = [&curve.inertial_parameter, &curve.stiffness_group]
        .map(|function| Expression::from(function).with("r", &place));
    let on_curve = stated_domain("points of the boundary")
        .given(eta.clone(), Relation::NonZero)
        .given(kappa.clone(), Relation::NonZero)
        .with("eta", eta)
        .with("kappa", kappa);
    let variable = if small { formula("kappa") } else { formula("1/kappa") };
    let [variable, along_curve] =
        [rational(&proof, &[cubic], &variable, &on_curve)?, rational(&proof, &[number], &square, &on_curve)?];
    let error = inverse_series(&variable, RationalFunction::from(0), length)
        .and_then(|root| along(&along_curve, &root)?.square_root())
        .map(|ratio| ratio.plus(&minus_one(length)))
        .ok_or_else(|| no_asymptote(&proof, equations, role))?;
    let (kappa, inverse) =
        if small { (formula("x"), formula("1/x")) } else { (formula("1/x"), formula("x")) };
    // V²/V_asymptote² is proportional to η κ, so η is (1 + y)² divided by its factor and by κ.
    let factor = square.with("eta", &formula("1")).with("kappa", &formula("1"));
    let relation = Expression::from(&cubic_discriminant(equations)?)
        .with("eta", &(formula("(1 + y)^2") * inverse / factor))
        .with("kappa", &kappa);
    let domain = if small { unequal_effects() } else { Domain::default() };
    let names = ("V_0", if small { "kappa" } else { "1/kappa" });
    finish(proof, equations, role, names, &relation, &error, domain)
}

/// (V0/V_asymptote)² in groups, the same for a < b and a > b.
fn ratio_squared(proof: &Proof, equations: &Equations, role: Role) -> Result<Expression, Refutation> {
    let [number] = equations.numbers([role]);
    // left/right of an equation "ratio = 1" is the ratio of V0 to the velocity at which it holds.
    let Equation { left, right, .. } = equations.with_role(role);
    let ratio = in_groups(&(left.clone() / right.clone()).power(2));
    let positive = "eta kappa d";
    let case = |beta: &str, distance: &str| {
        let square =
            rational(proof, &[number], &ratio, &Domain::positive(positive).with("beta", formula(beta)))?;
        Ok(Expression::from(&square).with("d", &formula(distance)))
    };
    let (below, above) = (case("1 + d", "beta - 1")?, case("1 - d", "1 - beta")?);
    proof.clone().identity("the same for a < b and a > b", &[number], &below, &above, &unequal_effects())?;
    Ok(below)
}

/// β ≠ 1.
fn unequal_effects() -> Domain {
    stated_domain("beta other than 1")
}

fn series_proof(number: &str, what: &str) -> Proof {
    Proof::new(&format!("asymptote-series-{number}"), format!("Relative error of eq {number}: {what}."))
}

fn no_asymptote(proof: &Proof, equations: &Equations, role: Role) -> Refutation {
    proof.refute(
        "the equation is an asymptote of the boundary",
        &equations.numbers([Role::Characteristic, role]),
        "the relative error does not tend to zero",
    )
}

/// A function of r and β in r and w, β = w².
fn in_root(function: &RationalFunction) -> RationalFunction {
    let square = Polynomial::variable("w").pow(2);
    let [upper, lower] = [function.numerator(), function.denominator()]
        .map(|side| side.substitute(&Symbol::from("beta"), &square));
    RationalFunction::new(upper, lower).unwrap_or_else(|| function.clone())
}

/// r as a power series in x = function(r), beginning with `start`.
fn inverse_series(function: &RationalFunction, start: RationalFunction, length: usize) -> Option<Series> {
    let relation = function.numerator() - &(&Polynomial::variable("x") * function.denominator());
    Series::implicit(&relation, &Symbol::from("x"), &Symbol::from("r"), start, length)
}

/// function(r) along a series for r.
fn along(function: &RationalFunction, root: &Series) -> Option<Series> {
    let x = Series::variable(root.coefficients().len());
    let places = [(&Symbol::from("x"), &x), (&Symbol::from("r"), root)];
    let denominator = Series::of_polynomial(function.denominator(), places).reciprocal()?;
    Some(Series::of_polynomial(function.numerator(), places).times(&denominator))
}

fn minus_one(length: usize) -> Series {
    Series::constant(RationalFunction::from(-1), length)
}

fn finish(
    proof: Proof,
    equations: &Equations,
    role: Role,
    (quantity, variable): (&'static str, &'static str),
    relation: &Expression,
    error: &Series,
    domain: Domain,
) -> Result<AsymptoteSeries, Refutation> {
    // The small variable is positive, and so is the ratio 1 + y of exact value and asymptote.
    let positive = stated_domain("error of an asymptote");
    let [cubic, number] = equations.numbers([Role::Characteristic, role]);
    let relation = without_powers(&rational(&proof, &[cubic], relation, &positive)?);
    let coefficients: Vec<Expression> = error.coefficients().iter().map(with_short_denominator).collect();
    let certificate = Certificate::Series {
        relation: Expression::from(&relation),
        variable: "x".into(),
        unknown: "y".into(),
        coefficients: coefficients.clone(),
        domain,
    };
    let proof = proof
        .certify(
            &format!(
                "the error y of \"{}\", derived along the boundary's parametrisation by its double root, makes the \
                 discriminant of eq {cubic} vanish to every power given",
                equations.with_role(role)
            ),
            &[cubic, number],
            certificate,
        )?;
    Ok(AsymptoteSeries { equation: number.to_owned(), quantity, variable, coefficients, proof })
}

/// The coefficient as an expression, a denominator that is a power of β − 1 written as one.
fn with_short_denominator(coefficient: &RationalFunction) -> Expression {
    let whole = Expression::from(coefficient);
    let degree = coefficient.denominator().degree(&Symbol::from("beta"));
    let distance = &Polynomial::variable("beta") - &Polynomial::one();
    // Denominators in lowest terms have leading coefficient 1, so equality is all there is to check.
    if degree == 0 || distance.pow(degree) != *coefficient.denominator() {
        return whole;
    }
    Expression::from(coefficient.numerator()) / formula("beta - 1").power(degree as i32)
}

/// The numerator without powers of x as a factor.
fn without_powers(function: &RationalFunction) -> Polynomial {
    let x = Symbol::from("x");
    let coefficients = function.numerator().coefficients(&x);
    let lowest = coefficients.iter().position(|coefficient| !coefficient.is_zero()).unwrap_or(0);
    let kept = coefficients.into_iter().skip(lowest).rev();
    kept.fold(Polynomial::zero(), |sum, coefficient| &(&sum * &Polynomial::variable("x")) + &coefficient)
}
