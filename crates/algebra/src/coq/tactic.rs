//! Proofs of equalities and signs: each call is brought to the form that the converter gives it, and `field` does the rest.

use std::collections::BTreeMap;

use super::Obstacle;
use super::term::{divides, outer_calls, real};
use crate::conversion::Converter;
use crate::{Condition, Domain, Expression, Function, Polynomial, RationalFunction, Relation};

/// Writes tactics for goals in the variables that remain after a domain's substitutions.
pub(super) struct Tactics<'d>(pub &'d Domain);

impl Tactics<'_> {
    /// Proves left = right.
    pub fn equal(&self, left: &Expression, right: &Expression) -> Result<String, Obstacle> {
        if real(left) == real(right) {
            return Ok("reflexivity".to_owned());
        }
        self.equal_after("", &[left, right])
    }

    /// Proves that two sides are equal, after a tactic.
    pub fn equal_after(&self, first: &str, sides: &[&Expression]) -> Result<String, Obstacle> {
        let mut calls = BTreeMap::new();
        sides.iter().for_each(|side| outer_calls(side, &mut calls));
        let mut calls: Vec<(String, Expression)> = calls.into_iter().collect();
        // A call inside another one must not be rewritten before it.
        calls.sort_by_key(|(text, _)| std::cmp::Reverse(text.len()));
        let mut tactics = first.to_owned();
        if first.is_empty() {
            tactics += &self.divisors(sides)?;
        }
        let mut roots = BTreeMap::new();
        let mut field = !first.is_empty() || sides.iter().any(|side| divides(side));
        for (text, call) in &calls {
            let normal = self.normal(call)?;
            if real(&normal) != *text {
                let proof = self.call(call, &normal)?;
                tactics += &format!(
                    "assert (h' : {text} = {}) by ({proof}); rewrite ?h'; clear h'; ",
                    real(&normal)
                );
            }
            roots_in(&normal, &mut roots);
            field |= divides(&normal);
        }
        let mut known: Vec<String> = Vec::new();
        for (index, root) in roots.values().enumerate() {
            let (above, below) = match root {
                Expression::Quotient(above, below) => ((**above).clone(), Some(&**below)),
                whole => (whole.clone(), None),
            };
            let mut proof = self.not_negative_by_form(&above)?;
            let square = match below {
                Some(below) => {
                    let positive = self.sign(below, 1)?;
                    tactics += &format!(
                        "rewrite ?(root_of_quotient {} {} ltac:({proof}) ltac:({positive})); ",
                        real(&above),
                        real(below)
                    );
                    proof = format!("apply Rmult_le_pos; [ {proof} | left; {positive} ]");
                    Expression::Product(vec![above, below.clone()])
                }
                None => above,
            };
            let square = real(&square);
            tactics += &format!(
                "assert (q'{index} : sqrt {square} ^ 2 = {square}) by (apply root_squared; {proof}); "
            );
            known.push(format!("q'{index}"));
        }
        known.extend(self.0.squares().iter().map(|(name, _)| format!("{name}'square")));
        if sides.iter().any(|side| side.variables().iter().any(|name| name.as_str() == "pm")) {
            known.push("pm'square".to_owned());
        }
        let known = if known.is_empty() { String::new() } else { format!(" [{}]", known.join(" ")) };
        field |= !roots.is_empty();
        tactics += &if field { format!("field{known}; divisors") } else { format!("ring{known}") };
        Ok(tactics)
    }

    /// Proves of each divisor that is not zero by a condition that it is not zero.
    fn divisors(&self, sides: &[&Expression]) -> Result<String, Obstacle> {
        let mut divisors = BTreeMap::new();
        sides.iter().for_each(|side| divisors_in(side, &mut divisors));
        let mut tactics = String::new();
        for divisor in divisors.values() {
            let function = self.0.rational_function(divisor)?;
            let (factors, _) = self.nonzero_factors(&function);
            if factors.first().is_some_and(|first| {
                self.expression_of(first).is_ok_and(|first| real(&first) != real(divisor))
            }) {
                // `field` asks for the numerator of a divisor that is itself a quotient.
                let above = self.expression_of(function.numerator())?;
                for value in [divisor, &above].into_iter().take(1 + usize::from(divides(divisor))) {
                    tactics += &format!("assert ({} <> 0) by ({}); ", real(value), self.nonzero(value)?);
                }
            } else if !self.is_plain(&function)
                && let Some(proof) = self.sign_of_parts(divisor, true)
            {
                tactics += &format!("assert ({} <> 0) by (apply Rgt_not_eq; red; {proof}); ", real(divisor));
            }
        }
        Ok(tactics)
    }

    /// Proves that a value is not zero: by the conditions that speak of its factors, and by form.
    pub fn nonzero(&self, value: &Expression) -> Result<String, Obstacle> {
        let function = self.0.rational_function(value)?;
        let (factors, rest) = self.nonzero_factors(&function);
        let rest = RationalFunction::from(rest).checked_div(&function.denominator().clone().into());
        let rest = self.expression(&rest.ok_or_else(|| Obstacle(format!("{value} has no denominator")))?)?;
        let factors =
            factors.iter().map(|factor| self.expression_of(factor)).collect::<Result<Vec<_>, _>>()?;
        let product = Expression::Product(factors.into_iter().chain([rest]).collect());
        let (equal, shown) = (self.equal(&product, value)?, real(value));
        Ok(format!("replace {shown} with {} by ({equal}); divisor", real(&product)))
    }

    fn nonzero_factors(&self, function: &RationalFunction) -> (Vec<Polynomial>, Polynomial) {
        Converter::new(self.0).factors(function.numerator(), |relation| relation != Relation::NonNegative)
    }

    /// What the converter makes of a call.
    fn normal(&self, call: &Expression) -> Result<Expression, Obstacle> {
        self.expression(&self.0.rational_function(call)?)
    }

    /// Proves call = normal.
    fn call(&self, call: &Expression, normal: &Expression) -> Result<String, Obstacle> {
        let Expression::Call(function, argument) = call else { return self.equal(call, normal) };
        if let Expression::Call(same, other) = normal
            && same == function
        {
            return Ok(format!("f_equal; {}", self.equal(argument, other)?));
        }
        match function {
            Function::Sin | Function::Cos => Err(Obstacle(format!("no tactic for {call}"))),
            Function::Exp if !self.0.rational_function(argument)?.is_zero() => {
                Ok("apply ln_inv; [ apply exp_pos | pos | logarithms; first [ ring | field; divisors ] ]"
                    .to_owned())
            }
            Function::Exp | Function::Asinh => {
                let zero = self.equal(argument, &Expression::integer(0))?;
                Ok(format!("replace {} with 0 by (symmetry; {zero}); apply exp_0", real(argument)))
            }
            Function::Ln => {
                let plain = self.normal(argument)?;
                if plain == **argument {
                    return Ok("logarithms; ring".to_owned());
                }
                let proof = self.equal(&plain, argument)?;
                Ok(format!("replace {} with {} by ({proof}); logarithms; ring", real(argument), real(&plain)))
            }
            Function::Sqrt => {
                let square = Expression::Product(vec![normal.clone(), normal.clone()]);
                let equal = self.equal(argument, &square)?;
                Ok(format!("apply root_of_square; [ {} | {equal} ]", self.not_negative(normal)?))
            }
            Function::Abs => {
                let argument_value = self.0.rational_function(argument)?;
                let same = (&argument_value - &self.0.rational_function(normal)?).is_zero();
                let (lemma, value) = match same {
                    true => ("absolute_positive", normal.clone()),
                    false => ("absolute_negative", Expression::Negation(Box::new(normal.clone()))),
                };
                let equal = self.equal(argument, &value)?;
                Ok(format!("apply {lemma}; [ {} | {equal} ]", self.sign(normal, 1)?))
            }
        }
    }

    fn not_negative(&self, value: &Expression) -> Result<String, Obstacle> {
        if value.is_zero() {
            Ok("apply Rle_refl".to_owned())
        } else {
            Ok(format!("left; {}", self.sign(value, 1)?))
        }
    }

    /// Proves 0 < value, or value < 0.
    pub fn sign(&self, value: &Expression, sign: i8) -> Result<String, Obstacle> {
        if sign > 0 && is_difference_of_roots(value) {
            return Ok("pos".to_owned());
        }
        let function = self.0.rational_function(value)?;
        if !self.is_plain(&function) {
            let above = if sign > 0 { value.clone() } else { Expression::Negation(Box::new(value.clone())) };
            let close = if sign > 0 { "" } else { "apply Ropp_lt_cancel; rewrite Ropp_0; " };
            if let Some(proof) = self.sign_of_parts(&above, true) {
                return Ok(format!("{close}{proof}"));
            }
        }
        let form = self.signed_form(&function).ok_or_else(|| {
            Obstacle(format!(
                "the sign of {} rests on more than coefficients of one sign",
                Expression::from(&function)
            ))
        })?;
        let form = if sign > 0 { form } else { Expression::Negation(Box::new(form)) };
        self.in_form(value, &form, if sign > 0 { "one_pos" } else { "negative" })
    }

    /// A proof about an expression from one about another form of it.
    pub(super) fn in_form(
        &self,
        value: &Expression,
        form: &Expression,
        proof: &str,
    ) -> Result<String, Obstacle> {
        if real(value) == real(form) {
            return Ok(proof.to_owned());
        }
        let equal = self.equal(value, form)?;
        Ok(format!("replace {} with {} by (symmetry; {equal}); {proof}", real(value), real(form)))
    }

    /// Proves 0 <= value: by the conditions that speak of its factors where the converter sees them.
    pub(super) fn not_negative_by_form(&self, value: &Expression) -> Result<String, Obstacle> {
        let form = self.not_negative_form(value)?;
        let is_seen = form.is_some() && self.is_plain(&self.0.rational_function(value)?);
        if let Some(proof) = (!is_seen).then(|| self.sign_of_parts(value, false)).flatten() {
            return Ok(proof);
        }
        self.in_form(value, form.as_ref().unwrap_or(value), "nonneg")
    }

    /// The absolute value as a quotient of a form that is not negative by a form that is positive.
    fn not_negative_form(&self, value: &Expression) -> Result<Option<Expression>, Obstacle> {
        let function = self.0.rational_function(value)?;
        let above = self.factored(function.numerator(), |relation| relation != Relation::NonZero);
        let below = self.factored(function.denominator(), |relation| relation == Relation::Positive);
        let zero = function.is_zero().then(|| Expression::integer(0));
        Ok(zero.or_else(|| Some(above? / below?)))
    }

    /// Whether coefficients of one sign show the sign, in the factors of which no condition speaks: all in them is positive.
    fn is_plain(&self, function: &RationalFunction) -> bool {
        let converter = Converter::for_sign_of(self.0, function);
        [function.numerator(), function.denominator()].into_iter().all(|side| {
            let (_, rest) = converter.factors(side, |relation| relation != Relation::NonZero);
            rest.coefficient_sign().is_some()
                && rest.generators().iter().all(|name| {
                    let inner = name.argument_of(Function::Sqrt).map(|inner| self.0.rational_function(inner));
                    converter.is_positive(name)
                        && inner.is_none_or(|inner| inner.is_ok_and(|one| self.is_plain(&one)))
                })
        })
    }

    /// The function's absolute value as a quotient of products of what is positive by its form.
    fn signed_form(&self, function: &RationalFunction) -> Option<Expression> {
        let positive = |relation| relation == Relation::Positive;
        let [above, below] =
            [function.numerator(), function.denominator()].map(|side| self.factored(side, positive));
        Some(above? / below?)
    }

    /// A polynomial's absolute value as a product of factors of which conditions speak, and coefficients of one sign.
    fn factored(&self, polynomial: &Polynomial, used: fn(Relation) -> bool) -> Option<Expression> {
        let (factors, rest) = Converter::new(self.0).factors(polynomial, used);
        let rest = if rest.coefficient_sign()? < 0 { rest.scale(&rug::Rational::from(-1)) } else { rest };
        factors.iter().try_fold(self.expression_of(&rest).ok()?, |product, factor| {
            Some(match self.expression_of(factor).ok()? {
                // The product with it is the absolute value, and its sign stays inside.
                factor @ Expression::Negation(_) => Expression::Product(vec![product, factor]),
                factor => product * factor,
            })
        })
    }

    /// A function as an expression.
    pub fn expression(&self, function: &RationalFunction) -> Result<Expression, Obstacle> {
        self.with_forms(&Expression::from(function))
    }

    /// A polynomial as such an expression.
    pub fn expression_of(&self, polynomial: &Polynomial) -> Result<Expression, Obstacle> {
        self.with_forms(&Expression::from(polynomial))
    }

    /// A quotient below a root has positive forms above and below, where the domain has them.
    fn with_forms(&self, expression: &Expression) -> Result<Expression, Obstacle> {
        match expression {
            Expression::Call(Function::Sqrt, inner) if divides(inner) => {
                let form = self.not_negative_form(inner)?;
                Ok(Expression::Call(Function::Sqrt, form.map_or_else(|| inner.clone(), Box::new)))
            }
            Expression::Call(..) | Expression::Generic(..) => Ok(expression.clone()),
            other => other.try_with_parts(|part| self.with_forms(part)),
        }
    }

    /// Brings each condition to the form in which the converter uses it.
    pub fn facts(&self) -> Result<String, Obstacle> {
        let mut tactics = String::new();
        for (index, condition) in self.0.conditions().iter().enumerate() {
            let fact = self.fact(index + 1, condition)?;
            // A fact that is not needed may be out of reach; what needs it fails without it.
            tactics += &if fact.is_empty() { fact } else { format!("try ({fact}); ") };
        }
        Ok(tactics)
    }

    fn fact(&self, number: usize, condition: &Condition) -> Result<String, Obstacle> {
        let given = self.0.as_written(&condition.expression);
        let before = self.0.with_conditions(number - 1);
        let Some(core) = Converter::new(&before).core_of(condition) else { return Ok(String::new()) };
        let ratio = RationalFunction::from(core.clone()).checked_div(&self.0.rational_function(&given)?);
        let ratio = ratio.ok_or_else(|| Obstacle(format!("{condition} cannot hold")))?;
        let (core, text) = (self.expression_of(&core)?, real(&given));
        if real(&core) == text {
            return Ok(String::new());
        }
        let shown = real(&core);
        Ok(match condition.relation {
            Relation::NonZero => {
                let inverse = RationalFunction::from(1).checked_div(&ratio);
                let inverse = inverse.ok_or_else(|| Obstacle(format!("{condition} cannot hold")))?;
                let product = core * self.expression(&inverse)?;
                let equal = self.equal(&product, &given)?;
                format!(
                    "assert (fact'{number} : {shown} <> 0) by (let z := fresh in intro z; apply given'{number}; \
                     replace {text} with {} by ({equal}); rewrite z; ring)",
                    real(&product)
                )
            }
            relation => {
                let product = Expression::Product(vec![given.clone(), self.expression(&ratio)?]);
                let equal = self.equal(&product, &core)?;
                let (sign, lemma) = match relation {
                    Relation::Positive => ("<", "Rmult_lt_0_compat"),
                    _ => ("<=", "Rmult_le_pos"),
                };
                let factor = Tactics(&before).sign(&self.expression(&ratio)?, 1)?;
                let factor = if relation == Relation::Positive { factor } else { format!("left; {factor}") };
                format!(
                    "assert (fact'{number} : 0 {sign} {shown}) by (replace {shown} with {} by ({equal}); \
                     apply {lemma}; [ assumption | {factor} ])",
                    real(&product)
                )
            }
        })
    }
}

/// What an expression divides by, but for products and powers of it.
fn divisors_in(expression: &Expression, found: &mut BTreeMap<String, Expression>) {
    match expression {
        Expression::Call(..) | Expression::Generic(..) => return,
        Expression::Quotient(_, below) => factors_in(below, found),
        Expression::Power(inner, ..0) => factors_in(inner, found),
        _ => {}
    }
    expression.parts().for_each(|part| divisors_in(part, found));
}

fn factors_in(divisor: &Expression, found: &mut BTreeMap<String, Expression>) {
    match divisor {
        Expression::Product(parts) => parts.iter().for_each(|part| factors_in(part, found)),
        Expression::Quotient(above, _) => factors_in(above, found),
        Expression::Negation(inner) | Expression::Power(inner, _) => factors_in(inner, found),
        Expression::Sum(_) => {
            found.insert(real(divisor), divisor.clone());
        }
        Expression::Number(_) | Expression::Variable(_) | Expression::Call(..) | Expression::Generic(..) => {}
    }
}

fn is_difference_of_roots(value: &Expression) -> bool {
    let Expression::Sum(parts) = value else { return false };
    let [first, Expression::Negation(second)] = &parts[..] else { return false };
    [first, &**second].iter().all(|part| part.below_root().is_some())
}

/// The arguments of the roots that an expression in normal form has.
fn roots_in(normal: &Expression, roots: &mut BTreeMap<String, Expression>) {
    let mut calls = BTreeMap::new();
    outer_calls(normal, &mut calls);
    let below = |(text, call): (String, Expression)| Some((text, call.below_root()?.clone()));
    roots.extend(calls.into_iter().filter_map(below));
}
