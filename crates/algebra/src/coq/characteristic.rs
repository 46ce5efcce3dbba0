//! A linearised system as a statement: its rates vanish at the steady state, its slopes are the derivatives of the rates there, and
//! its characteristic polynomial is det(s − J). Coq differentiates the rates by itself.

use super::Obstacle;
use super::statement::{Piece, Statement, altered_value, derivative_of, term, text};
use super::tactic::Tactics;
use super::term::{name, real};
use crate::{Domain, Expression, Linearisation, Symbol};

impl Statement {
    pub(super) fn characteristic(
        system: &Linearisation,
        variable: &Symbol,
        polynomial: &Expression,
        domain: &Domain,
    ) -> Result<Self, Obstacle> {
        let substituted = |(known, image): &(Symbol, Expression)| {
            system.state.iter().any(|state| state == known || image.variables().contains(state))
        };
        if domain.substitutions().iter().any(substituted) {
            return Err(Obstacle("a substitution contains a variable that moves".to_owned()));
        }
        let tactics = Tactics(domain);
        let written = |part: &Expression| domain.as_written(part);
        let zero = Expression::integer(0);
        let (mut pieces, mut proofs): (Vec<Piece>, Vec<String>) = Default::default();
        for rate in &system.rates {
            let rate = system.at_rest(rate);
            proofs.push(tactics.equal(&written(&rate), &zero)?);
            pieces.extend([term(&rate), text(" = 0 /\\ ")]);
        }
        for (rate, by) in system.places() {
            let x = name(&system.state[by]);
            let [raw, slope] = [system.derivative(rate, by), system.slopes[rate][by].clone()];
            pieces.extend([
                text(&format!("is_derive (fun {x} : R => ")),
                term(&system.along(rate, by)),
                text(") "),
            ]);
            pieces.extend([term(&system.steady[by]), text(" "), term(&slope), text(" /\\ ")]);
            let [raw, slope] = [&raw, &slope].map(written);
            let equal = tactics.equal(&raw, &slope)?;
            let derivative = derivative_of(&system.along(rate, by));
            proofs.push(format!("apply (derivative_as _ _ {} _); [ {equal} | {derivative} ]", real(&raw)));
        }
        let determinant = system.determinant(variable);
        proofs.push(tactics.equal(&written(&determinant), &written(polynomial))?);
        let all = |polynomial: &Expression| {
            let last = [term(&determinant), text(" = "), term(polynomial)];
            pieces.iter().cloned().chain(last).collect::<Vec<_>>()
        };
        let altered = altered_value(polynomial, &determinant, domain)?;
        let last = proofs.len() - 1;
        let steps: String = proofs[..last].iter().map(|proof| format!("split; [ {proof} | ]; ")).collect();
        let proof = format!("{steps}{}", proofs[last]);
        let mut statement = Self::plain(all(polynomial), all(&altered), proof);
        statement.bound = system.state.iter().cloned().collect();
        Ok(statement)
    }
}
