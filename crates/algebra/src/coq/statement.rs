//! What a certificate says, as a statement with the tactics that prove it.

use std::collections::{BTreeMap, BTreeSet};

use super::Obstacle;
use super::sign::GROWTH_LEMMA;
use super::tactic::Tactics;
use super::term::{name, outer_calls, real};
use crate::{
    Certificate, Condition, Domain, Expression, Function, Polynomial, RationalFunction, Relation, Series,
    Symbol, Toward,
};

/// A piece of a statement.
#[derive(Clone)]
pub(super) enum Piece {
    Text(String),
    Term(Expression),
}

/// A statement, an alteration of it that is false, and the tactics that prove the statement after the substitutions.
pub(super) struct Statement {
    pieces: Vec<Piece>,
    altered: Vec<Piece>,
    pub tactics: String,
    pub is_complex: bool,
    /// The variables that the statement itself binds.
    pub bound: BTreeSet<Symbol>,
    /// What the statement assumes not to be zero, beyond its domain.
    pub nonzero: Option<Expression>,
}

pub(super) fn text(text: &str) -> Piece {
    Piece::Text(text.to_owned())
}

pub(super) fn term(expression: &Expression) -> Piece {
    Piece::Term(expression.clone())
}

/// What stands below the root, if an expression is the square of one.
fn square_of_root(expression: &Expression) -> Option<&Expression> {
    match expression {
        Expression::Power(root, 2) => root.below_root(),
        _ => None,
    }
}

impl Statement {
    /// A statement over the reals that binds no variable.
    pub(super) fn plain(pieces: Vec<Piece>, altered: Vec<Piece>, tactics: String) -> Self {
        Self { pieces, altered, tactics, is_complex: false, bound: BTreeSet::new(), nonzero: None }
    }

    /// The statement of a certificate, in the domain in which its variables are.
    pub fn of(certificate: &Certificate, domain: &Domain) -> Result<Self, Obstacle> {
        let tactics = Tactics(domain);
        let written = |part: &Expression| domain.as_written(part);
        match certificate {
            Certificate::Identity { left, right, .. } => Self::equality(left, right, domain),
            Certificate::Value { expression, value, .. } => Self::equality(expression, value, domain),
            Certificate::Sign { expression, sign, .. } => {
                let proof = tactics.sign(&written(expression), *sign)?;
                let greater = vec![text("0 < "), term(expression)];
                let less = vec![term(expression), text(" < 0")];
                let (pieces, altered) = if *sign > 0 { (greater, less) } else { (less, greater) };
                Ok(Self::plain(pieces, altered, proof))
            }
            Certificate::Difference { left, right, values: [a, b], .. } => {
                let proofs =
                    [(left, a), (right, b)].map(|(side, value)| tactics.equal(&written(side), value));
                let [first, second] = proofs;
                let all = |a: &Expression| {
                    let sides =
                        [term(left), text(" = "), term(a), text(" /\\ "), term(right), text(" = "), term(b)];
                    let apart = [text(" /\\ "), term(a), text(" <> "), term(b)];
                    sides.into_iter().chain(apart).collect::<Vec<_>>()
                };
                let proof = format!("split; [ {} | split; [ {} | lra ] ]", first?, second?);
                Ok(Self::plain(all(a), all(b), proof))
            }
            Certificate::Limit { expression, variable, toward, value, .. } => {
                Self::limit(expression, (variable, *toward), value, domain)
            }
            Certificate::Divergence { expression, .. } => {
                Err(Obstacle(format!("no tactic for {expression} beyond all bounds")))
            }
            Certificate::Derivative { expression, variable, value, .. } => {
                Self::derivative(expression, variable, value, domain)
            }
            Certificate::Characteristic { system, variable, polynomial, .. } => {
                Self::characteristic(system, variable, polynomial, domain)
            }
            Certificate::Root { polynomial, variable, between, .. } => {
                Self::root(polynomial, variable, between, domain)
            }
            Certificate::Growth { expression, variable, order, .. } => {
                let growth = Self::growth_from(&written(expression), variable, *order, domain)?;
                let pieces = |expression: &Expression| vec![text("0 < "), term(expression)];
                let altered = pieces(&-expression.clone());
                Ok(Self::plain(pieces(expression), altered, growth))
            }
            Certificate::Series { relation, variable, unknown, coefficients, .. } => {
                Self::series(relation, [variable, unknown], coefficients, domain)
            }
            Certificate::Connected { image, .. } => Ok(Self::connected(image)),
        }
    }

    fn equality(left: &Expression, right: &Expression, domain: &Domain) -> Result<Self, Obstacle> {
        let tactics = Tactics(domain);
        let [l, r] = [left, right].map(|side| domain.as_written(side));
        let imaginary = Symbol::from("i");
        let is_complex = [&l, &r].iter().any(|side| side.variables().contains(&imaginary));
        let proof = match square_of_root(&l).filter(|inner| real(inner) == real(&r)) {
            Some(inner) => format!("apply root_squared; {}", tactics.not_negative_by_form(inner)?),
            // Of complex sides the real and the imaginary parts are equal.
            None if is_complex => tactics.equal_after("project; ", &[&l, &r])?,
            None => tactics.equal(&l, &r)?,
        };
        let sides = |left: &Expression, right: &Expression| vec![term(left), text(" = "), term(right)];
        let altered = match altered_side(right, left, domain)? {
            (true, right) => sides(left, &right),
            (false, left) => sides(&left, right),
        };
        Ok(Self { is_complex, ..Self::plain(sides(left, right), altered, proof) })
    }

    fn limit(
        expression: &Expression,
        (symbol, toward): (&Symbol, Toward),
        value: &Expression,
        domain: &Domain,
    ) -> Result<Self, Obstacle> {
        let tactics = Tactics(domain);
        let [inner, limit] = [expression, value].map(|part| domain.as_written(part));
        let function = domain.rational_function(&inner)?;
        let mut sides = [function.numerator(), function.denominator()].map(|side| side.coefficients(symbol));
        let [x, at] = [name(symbol), real(&Expression::Variable(symbol.clone()))];
        let (lemma, point, filter) = match toward {
            Toward::Zero => ("limit_at_zero", Expression::Variable(symbol.clone()), "(at_right 0)"),
            Toward::Infinity => {
                let length = sides[1].len();
                for side in &mut sides {
                    side.resize(length, Polynomial::zero());
                    side.reverse();
                }
                let inverse = Expression::Power(Box::new(Expression::Variable(symbol.clone())), -1);
                ("limit_at_infinity", inverse, "(Rbar_locally p_infty)")
            }
        };
        let coefficients = |side: &[Polynomial]| -> Result<Vec<Expression>, Obstacle> {
            side.iter().map(|coefficient| tactics.expression_of(coefficient)).collect()
        };
        let [above, below] = [coefficients(&sides[0])?, coefficients(&sides[1])?];
        if let Some(moving) = above.iter().chain(&below).find(|one| one.variables().contains(symbol)) {
            return Err(Obstacle(format!("no tactic for a limit with {moving}, which moves with {symbol}")));
        }
        let quotient = Expression::quotient;
        let equal = tactics.equal(&inner, &quotient(horner(&above, &point), horner(&below, &point)))?;
        let first = |list: &[Expression]| list.first().cloned().unwrap_or_else(|| Expression::integer(0));
        let ends = tactics.equal(&limit, &quotient(first(&above), first(&below)))?;
        let start = first(&below);
        let divisor = tactics.nonzero(&start)?;
        let proof = format!(
            "apply ({lemma} (fun {x} : R => {}) {} {}); [ intros {x} {x}'pos; cbn [horner]; {equal} \
             | apply (different _ {}); [ cbn [horner]; ring | {divisor} ] | cbn [horner]; {ends} ]",
            real(&inner),
            list(&above),
            list(&below),
            real(&start),
        );
        let pieces = |value: &Expression| {
            let open = text(&format!("filterlim (fun {at} : R => "));
            vec![open, term(expression), text(&format!(") {filter} (locally ")), term(value), text(")")]
        };
        let altered = pieces(&altered_value(value, expression, domain)?);
        Ok(Self { bound: [symbol.clone()].into(), ..Self::plain(pieces(value), altered, proof) })
    }

    /// The function binds the variable again; outside of it the name is that of the point.
    fn derivative(
        expression: &Expression,
        variable: &Symbol,
        value: &Expression,
        domain: &Domain,
    ) -> Result<Self, Obstacle> {
        let moves =
            |(known, image): &(Symbol, Expression)| known == variable || image.variables().contains(variable);
        if domain.substitutions().iter().any(moves) {
            return Err(Obstacle(format!("a substitution contains {variable}, which moves")));
        }
        if expression.variables().contains(&Symbol::from("i")) {
            return Err(Obstacle("the derivative of an expression that contains i".to_owned()));
        }
        let x = name(variable);
        let pieces = |value: &Expression| {
            let open = text(&format!("is_derive (fun {x} : R => "));
            vec![open, term(expression), text(&format!(") {x} ")), term(value)]
        };
        let altered = pieces(&altered_value(value, expression, domain)?);
        Ok(Self::plain(pieces(value), altered, derivative_of(expression).to_owned()))
    }

    fn root(
        polynomial: &Expression,
        symbol: &Symbol,
        between: &[Option<Expression>; 2],
        domain: &Domain,
    ) -> Result<Self, Obstacle> {
        let x = name(symbol);
        let pieces = |polynomial: &Expression| {
            let mut pieces = vec![text(&format!("exists {x} : R, "))];
            if let Some(low) = &between[0] {
                pieces.extend([term(low), text(&format!(" < {x} /\\ "))]);
            }
            if let Some(high) = &between[1] {
                pieces.extend([text(&format!("{x} < ")), term(high), text(" /\\ ")]);
            }
            pieces.extend([term(polynomial), text(" = 0")]);
            pieces
        };
        let (_, altered) = altered_side(polynomial, polynomial, domain)?;
        let proof = root_proof(polynomial, symbol, between, domain)?;
        let plain = Self::plain(pieces(polynomial), pieces(&altered), proof);
        Ok(Self { bound: [symbol.clone()].into(), ..plain })
    }

    fn series(
        relation: &Expression,
        [small, root]: [&Symbol; 2],
        given: &[Expression],
        domain: &Domain,
    ) -> Result<Self, Obstacle> {
        let [x, y] = [name(small), name(root)];
        let series = Series::expression(given, &Expression::Variable(small.clone()));
        let pieces = |relation: &Expression| {
            let open = format!(
                "exists e'b k'b : R, 0 < e'b /\\ 0 < k'b /\\ forall {x} : R, Rabs {x} < e'b -> exists {y} : R, "
            );
            let close = text(&format!(") <= k'b * Rabs {x} ^ {}", given.len()));
            vec![text(&open), term(relation), text(&format!(" = 0 /\\ Rabs ({y} - ")), term(&series), close]
        };
        let (_, altered) = altered_side(relation, relation, domain)?;
        let (proof, nonzero) = series_proof(relation, [small, root], given, domain)?;
        let bound = [small.clone(), root.clone()].into();
        Ok(Self { bound, nonzero, ..Self::plain(pieces(relation), pieces(&altered), proof) })
    }

    /// Any two points of the set are joined by a curve in it.
    fn connected(image: &[(Symbol, Expression)]) -> Self {
        let parameters: BTreeSet<Symbol> = image.iter().flat_map(|(_, value)| value.variables()).collect();
        let own: Vec<String> = parameters.iter().map(name).collect();
        let others: Vec<String> = own.iter().map(|own| format!("{own}'other")).collect();
        let between: Vec<String> =
            own.iter().zip(&others).map(|(one, other)| format!("(between {one} {other} u')")).collect();
        // A name that stands in a text as it is.
        let exchange = |part: &Expression, names: &[String]| {
            let names = names.iter().map(|name| Expression::Variable(Symbol::read(name)));
            part.replaced(&parameters.iter().cloned().zip(names).collect())
        };
        let positive = |names: &[String], joint: &str| -> String {
            names.iter().map(|name| format!("0 < {name}{joint}")).collect()
        };
        let pieces = |image: &[(Symbol, Expression)]| {
            let both = [own.clone(), others.clone()].concat();
            let coordinates: Vec<String> = image.iter().map(|(coordinate, _)| name(coordinate)).collect();
            let continuous: String =
                coordinates.iter().map(|coordinate| format!("continuous {coordinate} u' /\\ ")).collect();
            let mut pieces = vec![text(&format!(
                "forall {} : R, {}exists {} : R -> R, (forall u' : R, 0 <= u' <= 1 -> {continuous}exists {} : R, {}",
                both.join(" "),
                positive(&both, " -> "),
                coordinates.join(" "),
                own.join(" "),
                positive(&own, " /\\ "),
            ))];
            for (at, names, end) in [("u'", &own, "True) /\\ "), ("0", &own, ""), ("1", &others, "True")] {
                for (coordinate, value) in image {
                    let value = exchange(value, names);
                    pieces.extend([
                        text(&format!("{} {at} = ", name(coordinate))),
                        term(&value),
                        text(" /\\ "),
                    ]);
                }
                pieces.push(text(end));
            }
            pieces
        };
        let curve = |(_, value): &(Symbol, Expression)| {
            format!("exists (fun u' : R => {}); ", real(&exchange(value, &between)))
        };
        let curves: String = image.iter().map(curve).collect();
        let facts =
            between.iter().map(|point| format!("assert (0 < {point}) by (now apply between_positive); "));
        let points = between.iter().map(|point| format!("exists {point}; "));
        let walk: String = facts
            .chain(image.iter().map(|_| "split; [ continuous_by_form | ]; ".to_owned()))
            .chain(points)
            .collect();
        let proof = format!(
            "intros; {curves}split; [ intros u' range'; {walk}repeat split; first [ assumption | reflexivity ] \
             | repeat split; cbn beta; rewrite ?between_start, ?between_end; reflexivity ]"
        );
        let mut altered = image.to_vec();
        altered.iter_mut().take(1).for_each(|(_, value)| *value = -value.clone());
        let bound = own.iter().chain(&others).map(|name| Symbol::read(name)).collect();
        Self { bound, ..Self::plain(pieces(image), pieces(&altered), proof) }
    }

    fn growth_from(
        expression: &Expression,
        variable: &Symbol,
        order: u32,
        domain: &Domain,
    ) -> Result<String, Obstacle> {
        let tactics = Tactics(domain);
        if order == 0 {
            return tactics.sign(expression, 1);
        }
        let x = name(variable);
        let slope = expression.derivative(variable);
        let zero = expression.replaced(&[(variable.clone(), Expression::integer(0))].into());
        let [f, g] = [expression, &slope].map(|part| format!("(fun {x} : R => {})", real(part)));
        let vanishes = tactics.equal(&zero, &Expression::integer(0))?;
        let grows = Self::growth_from(&slope, variable, order - 1, domain)?;
        // A function of one variable that has a derivative everywhere; any other one is looked at from 0 on.
        let (lemma, clear, derivative) = if domain.conditions().is_empty() && is_entire(expression, variable)
        {
            (
                "growth",
                "clear".to_owned(),
                format!("clear; intros {x}; auto_derive; [ repeat split | field ]"),
            )
        } else {
            let clear = format!("clear dependent {x}");
            let at_zero = "auto_derive; repeat split; rewrite ?Rmult_0_r, ?Rmult_0_l, ?Rplus_0_r, ?Rplus_0_l; \
                           first [ exact I | pos | lra | divisor ]";
            let differentiate = derivative_of(expression);
            let derivative = format!(
                "apply (ex_derive_continuous {f}); {at_zero} | {clear}; intros {x} {x}'pos; {differentiate}"
            );
            (GROWTH_LEMMA, clear, derivative)
        };
        Ok(format!(
            "apply ({lemma} {f} {g} {x}); [ {derivative} | {vanishes} | {clear}; intros {x} {x}'pos; {grows} | assumption ]"
        ))
    }

    /// The statement's expressions.
    pub fn terms(&self) -> Vec<&Expression> {
        let terms = self.pieces.iter().filter_map(|piece| match piece {
            Piece::Term(expression) => Some(expression),
            Piece::Text(_) => None,
        });
        terms.collect()
    }

    /// The statement as Coq reads it, its expressions written by `show`.
    pub fn text(&self, altered: bool, show: impl Fn(&Expression) -> String) -> String {
        let pieces = if altered { &self.altered } else { &self.pieces };
        let words = pieces.iter().map(|piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Term(expression) => show(expression),
        });
        let text: String = words.collect();
        if self.is_complex { format!("({text})%C") } else { text }
    }
}

/// The tactic that differentiates. Coq writes differences and quotients inside of calls in its own way.
pub(super) fn derivative_of(expression: &Expression) -> &'static str {
    let mut calls = BTreeMap::new();
    outer_calls(expression, &mut calls);
    let is_written_anew = |text: &String| text.contains(" - ") && text.contains(" / ");
    match calls.keys().any(is_written_anew) {
        true => "first [ derivative | unfold Rminus, Rdiv; derivative ]",
        false => "derivative",
    }
}

/// Whether an expression has only this variable and a derivative at every value of it.
fn is_entire(expression: &Expression, variable: &Symbol) -> bool {
    let is_entire = |part: &Expression| is_entire(part, variable);
    match expression {
        Expression::Number(_) => true,
        Expression::Variable(name) => name == variable,
        Expression::Sum(parts) | Expression::Product(parts) => parts.iter().all(is_entire),
        Expression::Quotient(above, below) => is_entire(above) && below.variables().is_empty(),
        Expression::Negation(inner) | Expression::Call(Function::Exp, inner) => is_entire(inner),
        Expression::Power(inner, exponent) => *exponent >= 0 && is_entire(inner),
        Expression::Call(..) | Expression::Generic(..) => false,
    }
}

/// The tactics that prove a root between two ends, of which one or both may be open.
fn root_proof(
    polynomial: &Expression,
    symbol: &Symbol,
    between: &[Option<Expression>; 2],
    domain: &Domain,
) -> Result<String, Obstacle> {
    let tactics = Tactics(domain);
    let x = name(symbol);
    let inner = domain.as_written(polynomial);
    let function = domain.rational_function(&inner)?;
    let coefficients = function.numerator().coefficients(symbol).into_iter();
    let coefficients = coefficients.map(|one| divided(one, function.denominator()));
    let coefficients: Vec<RationalFunction> = coefficients.collect::<Result<_, _>>()?;
    let expressions = |turned: bool| -> Result<Vec<Expression>, Obstacle> {
        let turn = |(power, value): (usize, &RationalFunction)| {
            let is_turned = turned && power % 2 == 1;
            tactics.expression(&if is_turned { -value.clone() } else { value.clone() })
        };
        coefficients.iter().enumerate().map(turn).collect()
    };
    let [straight, turned] = [expressions(false)?, expressions(true)?];
    let point = Expression::Variable(symbol.clone());
    let same = tactics.equal(&inner, &horner(&straight, &point))?;
    let reflected = horner(&straight, &Expression::Negation(Box::new(point.clone())));
    let mirror = tactics.equal(&reflected, &horner(&turned, &point))?;
    let at = |end: &Expression| inner.replaced(&[(symbol.clone(), domain.as_written(end))].into());
    let leading = |list: &[Expression]| list.last().cloned().unwrap_or_else(|| Expression::integer(0));
    let signs = |one: &Expression, other: &Expression| opposite_signs(one, other, domain);
    let (list, turned_list) = (list(&straight), list(&turned));
    let f = format!("(fun {x} : R => {})", real(&inner));
    let equal = format!("intros {x}; cbn [horner]; {same}");
    Ok(match between {
        [None, Some(high)] => format!(
            "apply (root_below {f} {list} {turned_list} {}); [ {equal} | intros {x}; cbn [horner]; {mirror} | {} ]",
            real(&domain.as_written(high)),
            signs(&at(high), &leading(&turned))?
        ),
        [Some(low), None] => format!(
            "apply (root_above {f} {list} {}); [ {equal} | {} ]",
            real(&domain.as_written(low)),
            signs(&at(low), &leading(&straight))?
        ),
        [Some(low), Some(high)] => {
            let width = Expression::Sum(vec![high.clone(), Expression::Negation(Box::new(low.clone()))]);
            let width = domain.as_written(&width);
            format!(
                "apply (root_inside {f} {list} {} {}); [ {equal} | apply Rminus_gt_0_lt; {} | {} ]",
                real(&domain.as_written(low)),
                real(&domain.as_written(high)),
                tactics.sign(&width, 1)?,
                signs(&at(low), &at(high))?
            )
        }
        [None, None] => format!(
            "apply (root_anywhere {f} {list} {turned_list}); [ {equal} | intros {x}; cbn [horner]; {mirror} | {} ]",
            signs(&leading(&turned), &leading(&straight))?
        ),
    })
}

/// The tactics that prove two values to have opposite signs.
fn opposite_signs(one: &Expression, other: &Expression, domain: &Domain) -> Result<String, Obstacle> {
    let tactics = Tactics(domain);
    let sign = domain.sign(one)?.ok_or_else(|| Obstacle(format!("{one} has no sign")))?;
    let side = if sign > 0 { "left" } else { "right" };
    let proofs = [tactics.sign(one, sign)?, tactics.sign(other, -sign)?];
    Ok(format!("{side}; split; try cbn [last]; [ {} | {} ]", proofs[0], proofs[1]))
}

/// The tactics that prove the branch of a series, and the slope that is assumed not to be zero where the domain does not say so.
fn series_proof(
    relation: &Expression,
    [small, root]: [&Symbol; 2],
    given: &[Expression],
    domain: &Domain,
) -> Result<(String, Option<Expression>), Obstacle> {
    let tactics = Tactics(domain);
    let [x, y] = [name(small), name(root)];
    let order = given.len();
    let inner = domain.as_written(relation);
    let function = domain.rational_function(&inner)?;
    if function.denominator().as_constant().is_none() {
        return Err(Obstacle("the relation of a series is no polynomial".to_owned()));
    }
    let over = |part: Polynomial, below: &Polynomial| tactics.expression(&divided(part, below)?);
    let rows = function.numerator().coefficients(root).into_iter().map(|row| {
        let row = row.coefficients(small).into_iter();
        row.map(|part| over(part, function.denominator())).collect::<Result<Vec<_>, _>>()
    });
    let rows: Vec<Vec<Expression>> = rows.collect::<Result<_, _>>()?;
    let [x_point, y_point] = [small, root].map(|symbol| Expression::Variable(symbol.clone()));
    let sum = domain.as_written(&Series::expression(given, &x_point));
    let at_sum = inner.replaced(&[(root.clone(), sum.clone())].into());
    let residual = domain.rational_function(&at_sum)?;
    let rest = residual.numerator().coefficients(small).into_iter().skip(order);
    let rest: Vec<Expression> =
        rest.map(|part| over(part, residual.denominator())).collect::<Result<_, _>>()?;
    let written: Vec<Expression> = given.iter().map(|value| domain.as_written(value)).collect();
    let start = written.first().cloned().unwrap_or_else(|| Expression::integer(0));
    let slope = over(function.numerator().derivative(root), function.denominator())?;
    let slope = slope.replaced(&[(small.clone(), Expression::integer(0)), (root.clone(), start)].into());
    let slope = tactics.expression(&domain.rational_function(&slope)?)?;
    let by_rows: Vec<Expression> = rows.iter().map(|row| horner(row, &x_point)).collect();
    let power = Expression::Power(Box::new(x_point.clone()), i32::try_from(order).unwrap_or(i32::MAX));
    let remainder = Expression::Product(vec![power, horner(&rest, &x_point)]);
    let proven = domain.proves(&Condition { expression: slope.clone(), relation: Relation::NonZero })?;
    let single = if proven { tactics.nonzero(&slope)? } else { "assumption".to_owned() };
    let lists: Vec<String> = rows.iter().map(|row| list(row)).collect();
    let proof = format!(
        "apply (branch (fun {x} {y} : R => {}) (fun {x} : R => {}) [{}] {} {} {order}); [ lia \
         | intros {x} {y}; unfold both; cbn [map horner]; {} | intros {x}; cbn [horner]; {} \
         | intros {x}; cbn [horner]; {} | apply (different _ {}); [ cbn [map horner slope]; field; divisors | {single} ] ]",
        real(&inner),
        real(&sum),
        lists.join("; "),
        list(&written),
        list(&rest),
        tactics.equal(&inner, &horner(&by_rows, &y_point))?,
        tactics.equal(&sum, &horner(&written, &x_point))?,
        tactics.equal(&at_sum, &remainder)?,
        real(&slope),
    );
    Ok((proof, (!proven).then_some(slope)))
}

/// A polynomial over another one.
fn divided(part: Polynomial, below: &Polynomial) -> Result<RationalFunction, Obstacle> {
    let whole = RationalFunction::from(part).checked_div(&below.clone().into());
    whole.ok_or_else(|| Obstacle("a divisor is zero".to_owned()))
}

/// Another value of the expression: the stated one altered, or 1 more where no alteration of it is another value.
pub(super) fn altered_value(
    value: &Expression,
    expression: &Expression,
    domain: &Domain,
) -> Result<Expression, Obstacle> {
    Ok(match altered_side(value, expression, domain)? {
        (true, altered) => altered,
        (false, _) => value.clone() + Expression::integer(1),
    })
}

/// The first alteration of either side that changes its value: the sign of a term, or a factor 2 on it.
fn altered_side(
    right: &Expression,
    left: &Expression,
    domain: &Domain,
) -> Result<(bool, Expression), Obstacle> {
    for (is_right, side) in [(true, right), (false, left)] {
        for altered in alterations(side) {
            if !domain.difference(side, &altered)?.is_zero() {
                return Ok((is_right, altered));
            }
        }
    }
    // Zero on both sides.
    Ok((true, right.clone() + Expression::integer(1)))
}

fn alterations(side: &Expression) -> Vec<Expression> {
    let twice = |part: &Expression| Expression::integer(2) * part.clone();
    match side {
        Expression::Sum(parts) => {
            let changed = |change: &dyn Fn(&Expression) -> Expression, at: usize| {
                let mut parts = parts.clone();
                parts[at] = change(&parts[at]);
                Expression::Sum(parts)
            };
            let signs = (0..parts.len()).map(|at| changed(&|part| -part.clone(), at));
            signs.chain((0..parts.len()).map(|at| changed(&twice, at))).collect()
        }
        other => vec![-other.clone(), twice(other)],
    }
}

/// c₀ + x·(c₁ + x·(…)).
fn horner(coefficients: &[Expression], point: &Expression) -> Expression {
    let rest = Expression::integer(0);
    coefficients.iter().rev().fold(rest, |rest, value| {
        Expression::Sum(vec![value.clone(), Expression::Product(vec![point.clone(), rest])])
    })
}

fn list(coefficients: &[Expression]) -> String {
    let texts: Vec<String> = coefficients.iter().map(real).collect();
    format!("[{}]", texts.join("; "))
}
