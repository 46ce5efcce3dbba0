//! Whether both sides of an equation have a value.
//!
//! An equation in positive a and b, the direct and the evolution effect, may speak of a < b or of a > b only, as eqs 12 and 13 do: it
//! must have a value for all positive quantities of one of the two cases at least. The proofs state which case they are about. Other conditions are written beside it.

use slipmode_algebra::{Condition, Demand, Domain, Expression, Extent, Relation, Symbol};

/// What a side of an equation may come to when it is multiplied out. The largest side of the paper has 8 terms and degree 14.
const LARGEST: Extent = Extent { terms: 16, degree: 24, bits: 4096 };

/// What a file assumes while its equations are read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Assumed<'a> {
    /// The positive variables and the conditions.
    pub domain: &'a Domain,
    /// The functions of which nothing is known.
    pub functions: &'a std::collections::BTreeSet<Symbol>,
    /// The direct and the evolution effect, where the file says which variables they are: an equation may speak of one order of
    /// the two only.
    pub effects: Option<[&'a str; 2]>,
}

/// Reads one side of an equation that is stated for some conditions, besides those of the domain.
///
/// # Errors
/// With the column: text outside the grammar, what has no value, and what is too large.
pub(super) fn read(text: &str, given: &[Condition], assumed: &Assumed<'_>) -> Result<Expression, String> {
    let Assumed { domain, functions, effects } = *assumed;
    let (expression, demands) = Expression::read_in(text, functions).map_err(|error| error.to_string())?;
    expression.check_extent(LARGEST).map_err(|error| format!("column 1: {error}"))?;
    let add = |domain: Domain, one: &Condition| domain.given(one.expression.clone(), one.relation);
    let all = given.iter().fold(domain.clone(), add);
    let named = effects.and_then(|[a, b]| Some([a.parse().ok()?, b.parse().ok()?]));
    let named = named.filter(|names: &[Symbol; 2]| names.iter().all(|name| domain.is_positive(name)));
    let case = |greater: &Symbol, less: &Symbol| {
        let [greater, less] = [greater, less].map(|name| Expression::Variable(name.clone()));
        all.clone().given(greater - less, Relation::Positive)
    };
    let mut cases = vec![all.clone()];
    cases.extend(named.iter().flat_map(|[a, b]| [case(b, a), case(a, b)]));
    let met = |demand: &Demand, case: &Domain| {
        case.proves(&demand.condition) == Ok(true) || case.proves_in_some_form(&demand.condition).is_some()
    };
    if cases.iter().any(|case| demands.iter().all(|demand| met(demand, case))) {
        return Ok(expression);
    }
    let never = demands.iter().find(|demand| !cases.iter().any(|case| met(demand, case)));
    let unmet = never.or_else(|| demands.iter().find(|demand| !met(demand, &all)));
    let tried = named.map_or_else(String::new, |[a, b]| format!(", and {a} < {b} or {a} > {b}"));
    unmet.map_or(Ok(expression), |demand| Err(message(demand, &all, &tried)))
}

/// What of the demands of a definition is not met: it uses names, which are resolved. A logarithm or an absolute value that stays
/// open here may be decided in a claim.
pub(super) fn unmet(
    demands: &[Demand],
    domain: &Domain,
    resolve: &dyn Fn(&Expression) -> Expression,
) -> Option<String> {
    let resolved = demands.iter().map(|Demand { column, condition }| {
        let condition =
            Condition { expression: resolve(&condition.expression), relation: condition.relation };
        Demand { column: *column, condition }
    });
    let mut resolved = resolved.filter(|demand| match domain.proves(&demand.condition) {
        Ok(true) => false,
        Ok(false) => domain.proves_in_some_form(&demand.condition).is_none(),
        Err(error) => !error.is_open() && domain.proves_in_some_form(&demand.condition).is_none(),
    });
    resolved.next().map(|demand| message(&demand, domain, ""))
}

fn message(Demand { column, condition }: &Demand, domain: &Domain, tried: &str) -> String {
    let part = &condition.expression;
    if let Err(error) = domain.proves(condition) {
        return format!("column {column}: {error}");
    }
    let fault = match condition.relation {
        Relation::NonZero
            if domain.difference(part, &Expression::integer(0)).is_ok_and(|value| value.is_zero()) =>
        {
            format!("'{part}' is zero: a division by it, or its power 0, has no value")
        }
        Relation::NonZero => {
            format!("'{part}' may be zero: a division by it, or its power 0, may have no value")
        }
        Relation::NonNegative => format!("'{part}' may be negative: its square root may have no value"),
        Relation::Positive => format!("'{part}' may be zero or negative: its logarithm may have no value"),
    };
    let open: Vec<String> =
        part.variables().iter().filter(|name| !domain.is_positive(name)).map(ToString::to_string).collect();
    let open =
        if open.is_empty() { open.join("") } else { format!("; {} may be of either sign", open.join(", ")) };
    format!("column {column}: {fault} (assumed: {domain}{tried}{open}); `given` may exclude this")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::tests::paper;

    fn refusal(number: &str, text: &str) -> String {
        paper()
            .altered(number, text)
            .map_or_else(|error| error.to_string(), |_| format!("{text} is accepted"))
    }

    #[test]
    fn an_expression_without_a_value_is_refused_with_its_place() {
        for (number, text, fault) in [
            (
                "9",
                "K_c = 0/0 + (b - a)*sigma/D_c",
                "equation 9: right side '0/0 + (b - a)*sigma/D_c', column 3: '0' is zero",
            ),
            ("2", "theta' = 1/0 - V*theta/D_c", "column 3: '0' is zero"),
            ("2", "theta' = 1 - V*theta/D_c*(V - V)/(V - V)", "column 25: 'V - V' is zero"),
            ("2", "theta' = 1 - V*theta/D_c + 0^0", "column 19: '0' is zero"),
            ("2", "theta' = 1 - V*theta/D_c + 0*(K - sigma)^-1", "column 21: 'K - sigma' may be zero"),
            ("1", "mu = mu_0 + a*ln(V/V_0 - 1)", "column 12: 'V/V_0 - 1' may be zero or negative"),
            ("natural-frequency", "omega_n = sqrt(K/M - 1)", "column 5: 'K/M - 1' may be negative"),
            ("natural-frequency", "omega_n = sqrt(-K/M)", "column 5: '-K/M' may be negative"),
            ("8", "M*s^2/s + K = 0", "left side 'M*s^2/s + K', column 7: 's' may be zero"),
            ("12", "sigma_c = K*D_c*sqrt(b - a)*sqrt(a - b)", "may be negative"),
        ] {
            let refusal = refusal(number, text);
            assert!(refusal.contains(fault), "{fault} is not in: {refusal}");
        }
    }

    #[test]
    fn an_equation_may_speak_of_one_sign_of_a_minus_b_only() {
        for (number, text) in [
            ("12", "sigma_c = K*D_c/(a - b)"),
            ("13", "V_c = D_c*sqrt(a/(a - b))*sqrt(K/M)"),
            ("15", "sigma = K*D_c/(sqrt(a) - sqrt(b))^2"),
        ] {
            assert!(paper().altered(number, text).is_ok(), "{text}");
        }
    }

    #[test]
    fn an_equation_that_would_fill_the_memory_is_refused_with_the_bound() {
        let sum = "(a + b + D_c + K + M + sigma + V + V_0 + theta + mu_0)^24";
        let bomb = format!("mu = {sum} - {sum} + mu_0 + a*ln(V/V_0) + b*ln(V_0*theta/D_c)");
        let refusal = refusal("1", &bomb);
        let bound = "multiplied out it may have 38567100 terms and degree 24 (allowed: 16 terms, degree 24)";
        assert!(refusal.contains(&format!("column 1: {bound}")), "{refusal}");
    }

    #[test]
    fn the_equations_of_the_paper_stay_far_below_the_bounds() {
        let narrow = Extent { terms: 8, degree: 14, bits: 100 };
        for equation in paper().iter() {
            for side in [&equation.left, &equation.right] {
                assert_eq!(side.check_extent(narrow), Ok(()), "{equation}");
            }
        }
    }
}
