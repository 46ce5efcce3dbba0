//! The steps that the lemmas share.

use crate::System;
use crate::notation::first_success;
use slipmode_algebra::{
    Certificate, Domain, Expression, Proof, RationalFunction, Refutation, Relation, Symbol,
};

/// A proof that grows, the system it is about, and the forms of the domain in which a step may be certified.
pub(super) struct Steps<'a> {
    pub proof: Proof,
    pub system: &'a System,
    domains: &'a [Domain],
}

impl<'a> Steps<'a> {
    pub fn new(proof: Proof, system: &'a System, domains: &'a [Domain]) -> Self {
        Self { proof, system, domains }
    }

    /// A parameter that neither the system nor a domain has.
    pub fn fresh(&self) -> Symbol {
        let of_domains = self.domains.iter().flat_map(Domain::symbols);
        let of_system = self.system.rates.iter().flat_map(Expression::variables);
        Symbol::fresh(&of_domains.chain(of_system).collect::<Vec<_>>())
    }

    /// Adds a step of plain reasoning.
    pub fn reason(&mut self, says: &str) {
        self.proof = self.proof.clone().reason(says);
    }

    /// Adds the step that both sides are equal.
    pub fn identity(&mut self, says: &str, left: &Expression, right: &Expression) -> Result<(), Refutation> {
        let certificate = |domain| Certificate::Identity { left: left.clone(), right: right.clone(), domain };
        self.certify(says, self.domains.to_vec(), certificate)
    }

    /// Adds the step that an expression has this sign.
    pub fn sign(&mut self, says: &str, expression: &Expression, sign: i8) -> Result<(), Refutation> {
        self.sign_in(says, expression, sign, self.domains.to_vec())
    }

    /// Adds the step that an expression has this sign wherever `region` is positive.
    pub fn sign_where(
        &mut self,
        says: &str,
        region: &Expression,
        expression: &Expression,
        sign: i8,
    ) -> Result<(), Refutation> {
        let domains = self.domains.iter().flat_map(|domain| self.inside(domain, region)).collect();
        self.sign_in(says, expression, sign, domains)
    }

    /// Adds the step that an expression is of one sign, and returns the sign.
    pub fn some_sign(&mut self, says: &str, expression: &Expression) -> Result<i8, Refutation> {
        let refused = match self.sign(&format!("{says} is positive"), expression, 1) {
            Ok(()) => return Ok(1),
            Err(refused) => refused,
        };
        self.sign(&format!("{says} is negative"), expression, -1).map(|()| -1).map_err(|_| refused)
    }

    /// Adds the steps that an expression is a positive constant of the motion's parameters.
    pub fn positive_constant(&mut self, says: &str, expression: &Expression) -> Result<(), Refutation> {
        self.sign(says, expression, 1)?;
        match self.system.state.iter().find(|name| expression.variables().contains(*name)) {
            Some(name) => Err(self.refuse(says, format!("{expression} contains {name}"))),
            None => Ok(()),
        }
    }

    /// The expression as a rational function in the first form of the domain. A logarithm of a state variable would count as a
    /// constant in what follows, and is refused.
    pub fn rational(&self, says: &str, expression: &Expression) -> Result<RationalFunction, Refutation> {
        let Some(domain) = self.domains.first() else {
            return Err(self.refuse(says, "there is no domain".into()));
        };
        let found =
            domain.rational_function(expression).map_err(|error| self.refuse(says, error.to_string()))?;
        match self.system.state.iter().find_map(|name| found.hides(name)) {
            Some(hidden) => Err(self.refuse(says, format!("{hidden} depends on a state variable"))),
            None => Ok(found),
        }
    }

    /// left/right in lowest terms; the divisor may be zero at single points, which the identity that uses it shows.
    pub fn quotient(
        &self,
        says: &str,
        left: &Expression,
        right: &Expression,
    ) -> Result<Expression, Refutation> {
        let quotient = self.rational(says, left)?.checked_div(&self.rational(says, right)?);
        let quotient = quotient.ok_or_else(|| self.refuse(says, format!("{right} is zero everywhere")))?;
        Ok(Expression::from(&quotient))
    }

    /// Shows that the left side is a factor times the right one, and gives the factor.
    pub fn multiple(
        &mut self,
        says: &str,
        left: &Expression,
        right: &Expression,
    ) -> Result<Expression, Refutation> {
        let factor = self.quotient(says, left, right)?;
        self.identity(says, left, &(factor.clone() * right.clone())).map(|()| factor)
    }

    /// The values of the state variables at the steady state.
    pub fn steady(&self, says: &str) -> Result<&'a [Expression], Refutation> {
        let steady = Some(&self.system.steady[..]).filter(|steady| !steady.is_empty());
        steady.ok_or_else(|| self.refuse(says, "the system has no steady state".into()))
    }

    /// The rate of a coordinate: of the logarithm of a positive variable, of a free variable itself.
    pub fn coordinate_rate(&self, index: usize) -> Expression {
        self.system.rates[index].clone() / self.scale(index)
    }

    /// The slope of an expression along a coordinate.
    pub fn slope(&self, expression: &Expression, index: usize) -> Expression {
        self.scale(index) * expression.derivative(&self.system.state[index])
    }

    pub fn is_positive(&self, index: usize) -> bool {
        self.domains.iter().all(|domain| domain.is_positive(&self.system.state[index]))
    }

    pub fn refuse(&self, says: &str, remainder: String) -> Refutation {
        self.proof.refute(says, &[], remainder)
    }

    fn scale(&self, index: usize) -> Expression {
        if self.is_positive(index) { self.system.variable(index) } else { Expression::integer(1) }
    }

    fn sign_in(
        &mut self,
        says: &str,
        expression: &Expression,
        sign: i8,
        domains: Vec<Domain>,
    ) -> Result<(), Refutation> {
        let certificate = |domain| Certificate::Sign { expression: expression.clone(), sign, domain };
        self.certify(says, domains, certificate)
    }

    /// Adds a certified step in the first domain in which it holds.
    fn certify(
        &mut self,
        says: &str,
        domains: Vec<Domain>,
        certificate: impl Fn(Domain) -> Certificate,
    ) -> Result<(), Refutation> {
        let certified =
            first_success(domains, |domain| self.proof.clone().certify(says, &[], certificate(domain)));
        self.proof = certified
            .map_err(|refused| refused.unwrap_or_else(|| self.refuse(says, "there is no domain".into())))?;
        Ok(())
    }

    /// The domain with the condition that an expression is positive: as it is, and with a state variable in which the expression is
    /// linear expressed by a positive gap: α s + γ = gap gives s = (gap − γ)/α, and α s + γ = gap·s gives s = γ/(gap − α).
    /// The gap is a parameter: how far the expression is above zero, or how far the variable is below its bound.
    fn inside(&self, domain: &Domain, region: &Expression) -> Vec<Domain> {
        let given = domain.clone().given(region.clone(), Relation::Positive);
        let parameter = Symbol::fresh(&domain.symbols());
        let gap = Expression::variable(&parameter);
        let substituted = self.system.state.iter().flat_map(|name| {
            let Some(slope) = Self::slope_if_linear(domain, region, name) else { return Vec::new() };
            let rest = region.with(name, &Expression::integer(0));
            let above = (gap.clone() - rest.clone()) / slope.clone();
            let below = rest / (gap.clone() - slope);
            let per_variable = region.clone() / Expression::Variable(name.clone());
            let with = |value: &Expression, of_names: Expression| {
                given.clone().with(name, domain.substituted(value)).parameter(&parameter, of_names)
            };
            vec![with(&above, region.clone()), with(&below, per_variable)]
        });
        std::iter::once(given.clone()).chain(substituted).collect()
    }

    /// The slope of an expression in a variable, if it does not contain the variable and the domain expresses it by no others.
    fn slope_if_linear(domain: &Domain, expression: &Expression, name: &Symbol) -> Option<Expression> {
        let is_free = domain.substitutions().iter().all(|(known, _)| known != name);
        let slope = domain.rational_function(&expression.derivative(name)).ok()?;
        let slope = Expression::from(&slope);
        (is_free && !slope.is_zero() && !slope.variables().contains(name)).then_some(slope)
    }
}
