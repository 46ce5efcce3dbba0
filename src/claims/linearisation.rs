//! Claims L: the linearisation, the third-order equation and the cubic.

use crate::claims::{Check, Context, Finding};
use crate::theory::{characteristic, linearisation, third_order};

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "L1",
        criterion: "Differentiating eqs 1, 2 or 3, and 4 at steady state gives eqs 5 and 6 term by term, for both laws.",
        not_established: "How large a disturbance may be before the linearisation misleads.",
        needs: &[],
        rests_on: &["F1"],
        decide: l1,
    },
    Check {
        id: "L2",
        criterion: "Eliminating Δδ from eqs 5 and 6 gives eq 7.",
        not_established: "Whether the dots missing in the text at hand are missing in the typeset paper.",
        needs: &[],
        rests_on: &["L1"],
        decide: l2,
    },
    Check {
        id: "L3",
        criterion: "The characteristic polynomial of eqs 5 and 6 is the left side of eq 8.",
        not_established: "Anything about solutions that are not of the form exp(st).",
        needs: &[],
        rests_on: &["L1", "L2"],
        decide: l3,
    },
];

fn l1(context: &Context) -> Finding {
    Finding::from_proofs([linearisation::prove(context.equations)])
}

fn l2(context: &Context) -> Finding {
    let finding = Finding::from_proofs([third_order::prove(context.equations)]);
    let orders = third_order::orders(context.equations);
    match third_order::refute_printed(context.equations) {
        Some(_) => finding.remark(format!(
            "The derivatives of Δθ have the orders {}. The text at hand shows {}, which does not follow from eqs 5 and 6; dots \
             may have been lost between the typeset page and the text.",
            join(&orders.derived),
            orders.printed.as_deref().map_or_else(String::new, join),
        )),
        None => finding,
    }
}

fn join(orders: &[usize]) -> String {
    orders.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}

fn l3(context: &Context) -> Finding {
    Finding::from_proofs([
        characteristic::prove(context.equations),
        characteristic::dimensionless(context.equations),
    ])
}
