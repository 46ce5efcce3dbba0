//! The rows of `proofs/claims.csv` as they would be now, with what a person reads before one of them is written.

use super::{Claim, Published};
use crate::claims::{PROVED, TIES, Tie, Tied, resolved_claim, sha256_hex, statement};

/// A claim of a published ledger as resolved.
struct Now<'p> {
    report: &'p Published,
    claim: Claim,
    resolved: String,
    digest: String,
}

impl Claim {
    /// The claim as ties see it, with the digest of it as resolved.
    pub(super) fn tied<'c>(&'c self, digest: &'c str) -> Tied<'c> {
        Tied { claim: &self.id, digest, conclusion: self.conclusion.clone() }
    }
}

impl Now<'_> {
    /// The row with the digests of this claim; none when a theorem or an equation is missing.
    fn row(&self, tie: &Tie) -> Option<Tie> {
        let digest = tie.digest_of(&self.claim.tied(&self.digest), &self.report.equations)?;
        Some(Tie { claim_digest: self.digest.clone(), digest, ..tie.clone() })
    }

    /// What a person reads before the row is written: the row, the claim, what was found, and the theorems.
    fn to_read(&self, row: &Tie) -> Result<String, String> {
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        writer.serialize(row).map_err(|error| error.to_string())?;
        let line = writer.into_inner().map_err(|error| error.to_string())?;
        let result =
            serde_json::to_string_pretty(&self.claim.conclusion).map_err(|error| error.to_string())?;
        let statements: Vec<&str> = row.names().filter_map(statement).collect();
        let (line, claim) = (String::from_utf8_lossy(&line), &self.resolved);
        Ok(format!("{line}\n{claim}\n{result}\n\n{}\n", statements.join("\n\n")))
    }
}

/// For each row of `proofs/claims.csv` whose digests are no longer those of a claim of these reports: the number of its line, and what a
/// person reads before it is written. The text begins with the row as it would be.
///
/// # Errors
/// When a text is no ledger.
pub fn ties(reports: &[Published]) -> Result<Vec<(usize, String)>, String> {
    let mut all: Vec<Now<'_>> = Vec::new();
    for report in reports {
        for claim in report.ledger()?.claims {
            let entry = report.claims.iter().find(|entry| entry.id == claim.id);
            let Some(entry) = entry.filter(|_| PROVED.contains(&claim.strength)) else { continue };
            let resolved = resolved_claim(entry, &report.equations);
            let digest = sha256_hex(&resolved);
            all.push(Now { report, claim, resolved, digest });
        }
    }
    let mut found = Vec::new();
    for own in &all {
        let is_row = |(_, tie): &(usize, &Tie)| tie.report == own.report.name && tie.claim == own.claim.id;
        let rows: Vec<(usize, &Tie)> = TIES.iter().enumerate().filter(is_row).collect();
        // The same claim may have another result in another report, where something else was computed.
        let others = all.iter().filter(|one| one.claim.id == own.claim.id && one.digest == own.digest);
        let mut open: Vec<(&Now<'_>, Tie)> = Vec::new();
        for one in std::iter::once(own).chain(others) {
            let row = rows.first().and_then(|(_, tie)| one.row(tie));
            let is_new = |row: &Tie| open.iter().all(|(_, known)| known.digest != row.digest);
            open.extend(row.filter(is_new).map(|row| (one, row)));
        }
        let (known, moved): (Vec<_>, Vec<_>) =
            rows.into_iter().partition(|(_, tie)| open.iter().any(|(_, row)| row.digest == tie.digest));
        open.retain(|(_, row)| known.iter().all(|(_, tie)| tie.digest != row.digest));
        for ((index, tie), (now, _)) in moved.into_iter().zip(open) {
            if let Some(row) = now.row(tie) {
                // The first line has the names of the columns.
                found.push((index + 2, now.to_read(&row)?));
            }
        }
    }
    Ok(found)
}
