//! Signs that rest on more than positive terms: squares, variables that are not negative, and the two parts of a sum with a root; and
//! the lemmas that files have besides those of the library.

use super::Block;
use super::tactic::Tactics;
use super::term::real;
use crate::conversion::{Converter, norm, split_by_parity};
use crate::squares::{Known, addends};
use crate::{Expression, Function, Generator, Monomial, Polynomial, RationalFunction, Relation};

/// How deep a sum with a root may lie in the parts of another one.
const MOST_DEPTH: usize = 4;

/// What the names of the lemmas begin with that proofs of such signs use.
const ROOT_LEMMA: &str = "root_part";

/// The lemma on growth where the function need not go on left of 0, or where there are other variables.
pub(super) const GROWTH_LEMMA: &str = "growth_right";

/// Where e and the difference of the squares of both parts have a sign, or o and the opposite difference.
const ROOT_LEMMAS: &str = include_str!("root_part.v");

/// What vanishes at 0, is continuous there, and has a positive slope right of 0.
const GROWTH_LEMMAS: &str = include_str!("growth_right.v");

/// The lemmas of which a text uses one. `proofs/check.sh` has their names.
pub(super) fn lemmas_for(text: &str) -> impl Iterator<Item = Block> {
    let all = [(ROOT_LEMMA, ROOT_LEMMAS), (GROWTH_LEMMA, GROWTH_LEMMAS)];
    let used = all.into_iter().filter(|(name, _)| text.contains(name));
    used.map(|(name, text)| Block { name: name.to_owned(), text: text.to_owned() })
}

/// A form of a value, and the tactics that prove its sign.
struct Seen {
    form: Expression,
    proof: String,
}

impl Seen {
    /// The product of two values that are both positive, or both not negative.
    fn times(self, other: Self, is_strict: bool) -> Self {
        let lemma = if is_strict { "Rmult_lt_0_compat" } else { "Rmult_le_pos" };
        self.joined(lemma, other, |one, other| Expression::Product(vec![one, other]))
    }

    /// The sum of a value and one that is not negative.
    fn plus(self, other: Self, is_strict: bool) -> Self {
        let lemma = if is_strict { "Rplus_lt_le_0_compat" } else { "Rplus_le_le_0_compat" };
        self.joined(lemma, other, |one, other| Expression::Sum(vec![one, other]))
    }

    fn over(self, other: Self, is_strict: bool) -> Self {
        let lemma = if is_strict { "Rdiv_lt_0_compat" } else { "Rdiv_le_0_compat" };
        self.joined(lemma, other, Expression::quotient)
    }

    fn joined(self, lemma: &str, other: Self, form: fn(Expression, Expression) -> Expression) -> Self {
        let proof = format!("apply {lemma}; [ {} | {} ]", self.proof, other.proof);
        Self { form: form(self.form, other.form), proof }
    }
}

/// Looks for forms of polynomials, with what a converter knows of the roots in them.
struct Signs<'t> {
    tactics: &'t Tactics<'t>,
    converter: Converter<'t>,
    is_strict: bool,
}

impl Tactics<'_> {
    /// Proves 0 < value or 0 <= value, where products, sums, squares and the parts of sums with a root show it.
    pub(super) fn sign_of_parts(&self, value: &Expression, is_strict: bool) -> Option<String> {
        let function = self.0.rational_function(value).ok()?;
        let converter = Converter::for_sign_of(self.0, &function);
        let below = converter.sign_of(&function.denominator().clone().into())?;
        let above = function.numerator().scale(&rug::Rational::from(below));
        let divisor = function.denominator().scale(&rug::Rational::from(below));
        let signs = Signs { tactics: self, converter, is_strict };
        let above = signs.seen(&above, MOST_DEPTH)?;
        let seen = if divisor.as_constant().is_some_and(|one| one == 1) {
            above
        } else {
            let Signs { tactics, converter, .. } = signs;
            above.over(Signs { tactics, converter, is_strict: true }.seen(&divisor, MOST_DEPTH)?, is_strict)
        };
        self.in_form(value, &seen.form, &seen.proof).ok()
    }
}

impl Signs<'_> {
    fn seen(&self, polynomial: &Polynomial, depth: usize) -> Option<Seen> {
        let depth = depth.checked_sub(1)?;
        let usable: fn(Relation) -> bool = match self.is_strict {
            true => |relation| relation == Relation::Positive,
            false => |relation| relation != Relation::NonZero,
        };
        let (factors, rest) = self.converter.factors(polynomial, usable);
        let rest =
            self.of_terms(&rest).or_else(|| self.of_squares(&rest)).or_else(|| self.of_root(&rest, depth))?;
        factors.into_iter().try_rfold(rest, |rest, factor| {
            let form = self.tactics.expression_of(&factor).ok()?;
            let proof = if self.is_strict { "assumption" } else { "first [ assumption | left; assumption ]" };
            Some(Seen { form, proof: proof.to_owned() }.times(rest, self.is_strict))
        })
    }

    /// A sum of terms of which none is negative.
    fn of_terms(&self, polynomial: &Polynomial) -> Option<Seen> {
        let mut terms: Vec<(&Monomial, &rug::Rational)> = polynomial.terms().collect();
        if self.is_strict {
            let is_positive = |(monomial, _): &(&Monomial, &rug::Rational)| {
                monomial.factors().all(|(name, _)| self.converter.is_positive(name))
            };
            let first = terms.iter().position(is_positive)?;
            terms.swap(0, first);
        }
        let (first, others) = terms.split_first()?;
        let first = self.of_term(first.0, first.1, self.is_strict)?;
        others.iter().try_fold(first, |sum, (monomial, coefficient)| {
            Some(sum.plus(self.of_term(monomial, coefficient, false)?, self.is_strict))
        })
    }

    fn of_term(&self, monomial: &Monomial, coefficient: &rug::Rational, is_strict: bool) -> Option<Seen> {
        let number = Seen { form: Expression::Number(coefficient.clone()), proof: "lra".to_owned() };
        (*coefficient > 0).then_some(())?;
        monomial.factors().try_fold(number, |product, (name, exponent)| {
            Some(product.times(self.of_power(name, *exponent, is_strict)?, is_strict))
        })
    }

    fn of_power(&self, name: &Generator, exponent: u32, is_strict: bool) -> Option<Seen> {
        let own = self.tactics.expression_of(&Polynomial::generator(name)).ok()?;
        let power = |base: Expression, exponent: u32| {
            Some(Expression::Power(Box::new(base), i32::try_from(exponent).ok()?))
        };
        let is_root = name.argument_of(Function::Sqrt).is_some();
        let proof = match is_strict {
            true if is_root => self
                .tactics
                .sign(own.below_root()?, 1)
                .ok()
                .map(|inner| format!("apply sqrt_lt_R0; {inner}"))?,
            true => self.converter.is_positive(name).then(|| "pos".to_owned())?,
            false if is_root => "apply sqrt_pos".to_owned(),
            false if self.converter.is_not_negative(name) => "nonneg".to_owned(),
            false if exponent.is_multiple_of(2) => {
                let form = power(power(own, exponent / 2)?, 2)?;
                return Some(Seen { form, proof: "apply pow2_ge_0".to_owned() });
            }
            false => return None,
        };
        if exponent == 1 {
            return Some(Seen { form: own, proof });
        }
        let lemma = if is_strict { "pow_lt" } else { "pow_le" };
        Some(Seen { form: power(own, exponent)?, proof: format!("apply {lemma}; {proof}") })
    }

    /// A sum of squares, each with a factor that is not negative.
    fn of_squares(&self, polynomial: &Polynomial) -> Option<Seen> {
        let known = Known {
            positive: &|name| self.converter.is_positive(name),
            not_negative: &|name| self.converter.is_not_negative(name),
        };
        let mut parts = addends(polynomial, &known)?;
        let weak = Signs { tactics: self.tactics, converter: self.converter.copy(), is_strict: false };
        let mut seen: Option<Seen> = None;
        if self.is_strict {
            let strict = |(root, terms): &(Polynomial, Polynomial)| {
                (*root == Polynomial::one()).then(|| self.of_terms(terms)).flatten()
            };
            let (at, first) = parts.iter().enumerate().find_map(|(at, part)| Some((at, strict(part)?)))?;
            parts.remove(at);
            seen = Some(first);
        }
        for (root, terms) in &parts {
            let root = self.tactics.expression_of(root).ok()?;
            let square = Expression::Power(Box::new(root), 2);
            let square = Seen { form: square, proof: "apply pow2_ge_0".to_owned() };
            let part = square.times(weak.of_terms(terms)?, false);
            seen = Some(match seen {
                None => part,
                Some(first) => first.plus(part, self.is_strict),
            });
        }
        seen
    }

    /// e + o·√t, where the larger one of both parts has the sign.
    fn of_root(&self, polynomial: &Polynomial, depth: usize) -> Option<Seen> {
        let (name, square) = self.converter.real_root(polynomial)?;
        let root = self.tactics.expression_of(&Polynomial::generator(name)).ok()?;
        let below = root.below_root()?.clone();
        let whole = |part: &RationalFunction| {
            let divisor = part.denominator().as_constant()?.recip();
            Some(part.numerator().scale(&divisor))
        };
        let (even, odd) = split_by_parity(polynomial, name, square);
        let norm = whole(&self.converter.without_squares(&norm(&even, &odd, square))?)?;
        let (even, odd) = (whole(&even)?, whole(&odd)?);
        let found = [(&even, norm.clone(), ""), (&odd, -&norm, "other_")]
            .into_iter()
            .find_map(|(part, norm, which)| Some((self.seen(part, depth)?, self.seen(&norm, depth)?, which)));
        let (part, norm, which) = found?;
        let expression = |one: &Polynomial| self.tactics.expression_of(one).ok();
        let [even, odd] = match which {
            "" => [part.form.clone(), expression(&odd)?],
            _ => [expression(&even)?, part.form.clone()],
        };
        let two = |one: &Expression| Expression::Power(Box::new(one.clone()), 2);
        let other = Expression::Product(vec![two(&odd), below.clone()]);
        let difference = match which {
            "" => [two(&even), other],
            _ => [other, two(&even)],
        };
        let [larger, smaller] = difference;
        let difference = Expression::Sum(vec![larger, Expression::Negation(Box::new(smaller))]);
        let inner = self.tactics.not_negative_by_form(&below).ok()?;
        let norm = self.tactics.in_form(&difference, &norm.form, &norm.proof).ok()?;
        let relation = if self.is_strict { "lt" } else { "le" };
        let [e, o, t] = [&even, &odd, &below].map(real);
        let proof = format!(
            "apply ({ROOT_LEMMA}_{which}{relation} {e} {o} {t}); [ {inner} | {} | {norm} ]",
            part.proof
        );
        Some(Seen { form: Expression::Sum(vec![even, Expression::Product(vec![odd, root])]), proof })
    }
}
