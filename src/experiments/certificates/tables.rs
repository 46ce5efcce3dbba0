//! The table of the certificates: how many there are, how wide their bounds are, and how many this run proved again.

use crate::experiments::certificates::{Certificates, Stored};
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_certified::Certificate;
use slipmode_core::friction::EvolutionLaw;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] =
    &[TableMaker { id: "certificates", needs: &[Need::Certificates], make: certificates }];

/// Digits of a relative width.
const DIGITS: usize = 2;

/// The certificates of one law of one scene.
#[derive(Clone, Copy)]
struct OfLaw<'c> {
    scene: &'c str,
    law: EvolutionLaw,
    all: &'c Certificates,
}

impl<'c> OfLaw<'c> {
    fn rows(self) -> impl Iterator<Item = &'c Stored> {
        self.all.rows.iter().filter(move |row| row.law == self.law)
    }

    fn proofs(self, is_cycle: bool) -> impl Iterator<Item = &'c Certificate> {
        let proofs = self.rows().filter_map(|row| row.certificate.as_ref().ok());
        proofs.filter(move |proof| proof.period_s().is_some() == is_cycle)
    }

    fn again(self) -> usize {
        let of_law = |row: usize| self.all.rows[row].law == self.law;
        self.all.again.iter().filter(|again| of_law(again.row) && again.refusal.is_none()).count()
    }

    /// The largest relative width of an enclosure of the cycles.
    fn widest(self, of: fn(&Certificate) -> Option<[f64; 2]>) -> f64 {
        self.proofs(true).filter_map(of).map(|[low, high]| high / low - 1.0).fold(0.0, f64::max)
    }
}

fn certificates(context: &Context) -> Option<Table> {
    let laws = context.outcome.each(|scene| &scene.certificates).flat_map(|(scene, all)| {
        let laws = EvolutionLaw::ALL.into_iter().map(move |law| OfLaw { scene, law, all });
        laws.filter(|of| of.rows().next().is_some())
    });
    table_of("certificates", laws)
        .text("scene", |of| of.scene)
        .text("law", |of| of.law.as_str())
        .number("points", |of| of.rows().count())
        .number("cycles", |of| of.proofs(true).count())
        .number("decays", |of| of.proofs(false).count())
        .number("proved_again", OfLaw::again)
        .digits("peak_width", DIGITS, |of| of.widest(|proof| Some(proof.peak_velocity_m_per_s)))
        .digits("period_width", DIGITS, |of| of.widest(Certificate::period_s))
        .digits("stress_drop_width", DIGITS, |of| of.widest(|proof| Some(proof.stress_drop_pa)))
        .table()
}
