//! The coefficient of both laws, and what becomes of it when an equation is altered.

use super::*;
use crate::theory::equations::tests::paper;

#[test]
fn both_routes_give_the_closed_form_and_the_proof_rechecks_after_a_round_trip() {
    for law in Law::ALL {
        let start = std::time::Instant::now();
        let hopf = coefficient(&paper(), law).unwrap_or_else(|refutation| panic!("{refutation}"));
        eprintln!("{:?}", start.elapsed());
        let text = serde_json::to_string(&hopf.proof).expect("serialisable");
        let read: Proof = serde_json::from_str(&text).expect("readable");
        assert_eq!(read.to_string(), hopf.proof.to_string());
        assert_eq!(read.recheck(), Ok(()));
        eprintln!("{:?} {} {}", start.elapsed(), text.len(), hopf.proof);
    }
}

#[test]
fn quasi_static_sliders_are_centres() {
    for law in Law::ALL {
        let proof = quasi_static_centre(&paper(), law).unwrap_or_else(|refutation| panic!("{refutation}"));
        assert_eq!(proof.recheck(), Ok(()));
    }
}
