//! The answer of a report in a few sentences, made of verdicts and outcomes: nothing in it is typed in.

use crate::claims::{DecidedFor, Entry, Ledger, Verdict};
use crate::experiments::Outcome;
use crate::experiments::fit::fit_words;
use crate::experiments::operating_point::{
    operating_point_words, range_words, what_decides_words, what_leaves_words,
};
use crate::experiments::simulations::range_of_velocities;
use crate::experiments::tolerance::accuracy_of_asymptotes;
use crate::experiments::trajectories::own_run_words;
use crate::report::AnswerView;
use crate::report::claim_text::plain;
use crate::report::parts::{Words, words_of_source};
use crate::scene::{InAnswer, Question, Source, Subject};

/// What the report finds, the question of the report first.
pub(super) fn answer(question: Question, ledger: &Ledger, outcome: &Outcome) -> Vec<AnswerView> {
    let paper: Vec<&Entry> = ledger.of(Source::Paper).collect();
    let sentence =
        |words: fn(&Outcome) -> Option<String>| words(outcome).map(|text| AnswerView::new(text, []));
    let point = sentence(operating_point_words);
    if question == Question::OperatingPoint && point.is_some() {
        let own =
            [range_words, what_leaves_words, what_decides_words, own_run_words, fit_words].map(sentence);
        return [point].into_iter().chain(own).chain([counts(&paper)]).flatten().collect();
    }
    let others = Source::ALL.into_iter().filter(|source| *source != Source::Paper);
    let others: Vec<_> =
        others.map(|source| of_source(source, &ledger.of(source).collect::<Vec<_>>())).collect();
    let entering = |answer: InAnswer| paper.iter().copied().filter(move |one| one.in_answer == Some(answer));
    // Without subjects there is no sentence on what is right about them.
    if ledger.subjects().is_empty() {
        return [counts(&paper), wrong(ledger, &paper)].into_iter().chain(others).flatten().collect();
    }
    let worst = entering(InAnswer::Formulas).map(|entry| &entry.id);
    let formulas = accuracy_of_asymptotes(outcome).map(|text| AnswerView::new(text, worst));
    let validity = sentence(range_of_velocities);
    let claims = [counts(&paper), right(ledger, &paper)];
    let error_bars = error_bars_words(ledger).map(|text| AnswerView::new(text, []));
    let rest = [
        error_bars,
        wrong(ledger, &paper),
        simulations(&entering(InAnswer::Simulations).collect::<Vec<_>>()),
    ]
    .into_iter()
    .chain(others);
    let ordered: Vec<Option<AnswerView>> = match question {
        Question::Claims | Question::OperatingPoint => {
            claims.into_iter().chain([formulas]).chain(rest).collect()
        }
        Question::Formulas => [point, formulas, validity].into_iter().chain(claims).chain(rest).collect(),
    };
    ordered.into_iter().flatten().collect()
}

/// What holds within the error bars and what for the middle values alone; `None` when no scene has error bars.
fn error_bars_words(ledger: &Ledger) -> Option<String> {
    let decided = |of: DecidedFor| ledger.claims.iter().filter(|it| it.error_bars == Some(of)).count();
    let [all, middle] = [DecidedFor::AllValues, DecidedFor::MiddleValues].map(decided);
    (all + middle > 0).then(|| {
        format!(
            "Some values have error bars. The bands on the maps, what is said of all values within the error bars, and {all} of {} verdicts, which are proved, hold for all of these values; every other number, run and verdict holds for the middle values. The ledger states it of each claim.",
            all + middle
        )
    })
}

fn with<'e>(claims: &'e [&'e Entry], verdict: Verdict) -> impl Iterator<Item = &'e &'e Entry> {
    claims.iter().filter(move |entry| entry.finding.verdict == verdict)
}

/// A number of claims with a verb that agrees with it.
fn counted(claims: &[&Entry], verdict: Verdict, [one, several]: [&str; 2]) -> String {
    let count = with(claims, verdict).count();
    format!("{count} {}", if count == 1 { one } else { several })
}

fn counts(claims: &[&Entry]) -> Option<AnswerView> {
    let held = counted(claims, Verdict::Holds, ["holds as stated", "hold as stated"]);
    let limited = counted(claims, Verdict::HoldsWithin, ["holds within a limit", "hold within a limit"]);
    let failed = counted(claims, Verdict::Fails, ["fails", "fail"]);
    let open = match with(claims, Verdict::NotChecked).count() {
        0 => String::new(),
        count => format!("; {count} could not be checked here"),
    };
    let of = match claims.len() {
        0 => return None,
        1 => "the one claim of the paper in this report".to_owned(),
        count => format!("the {count} claims of the paper in this report"),
    };
    Some(AnswerView::new(format!("Of {of}, {held}, {limited}, and {failed}{open}."), []))
}

/// The subjects on which nothing is wrong.
fn right(ledger: &Ledger, claims: &[&Entry]) -> Option<AnswerView> {
    let verdicts = |subject: &Subject| {
        let about = claims.iter().filter(|entry| entry.subject.as_ref() == Some(subject));
        about.map(|entry| entry.finding.verdict).collect::<Vec<_>>()
    };
    let subjects = |fits: &dyn Fn(&[Verdict]) -> bool| {
        let fitting = ledger.subjects().into_iter().filter(|subject| fits(&verdicts(subject)));
        listed(&fitting.map(|subject| subject.words.as_str()).collect::<Vec<_>>())
    };
    let held = |all: &[Verdict]| !all.is_empty() && all.iter().all(|it| *it == Verdict::Holds);
    let right = |all: &[Verdict]| {
        all.contains(&Verdict::HoldsWithin)
            && all.iter().all(|it| matches!(it, Verdict::Holds | Verdict::HoldsWithin))
    };
    let text = match (subjects(&held), subjects(&right)) {
        (None, None) => return None,
        (Some(whole), None) => format!("Right: all claims about {whole} hold as stated."),
        (None, Some(limited)) => format!("Right within stated limits: the claims about {limited}."),
        (Some(whole), Some(limited)) => {
            format!(
                "Right: all claims about {whole} hold as stated, and those about {limited} at least within a limit."
            )
        }
    };
    Some(AnswerView::new(text, []))
}

/// `one`, `one and two`, `one, two and three`.
fn listed(words: &[&str]) -> Option<String> {
    let (last, before) = words.split_last()?;
    Some(if before.is_empty() { (*last).into() } else { format!("{} and {last}", before.join(", ")) })
}

/// The claims that fail: those for which the report has a replacement stand with it, the others below in their own words.
fn wrong(ledger: &Ledger, claims: &[&Entry]) -> Option<AnswerView> {
    let failed: Vec<&Entry> = with(claims, Verdict::Fails).copied().collect();
    let fewer = ledger.findings(Verdict::Fails);
    let findings =
        format!(" They are {fewer} findings: some repeat another one or share its counter-example.");
    let findings = if fewer < failed.len() { findings } else { String::new() };
    let has_change = |entry: &&Entry| entry.sentence.change.is_some();
    let text = match failed.len() {
        0 => return None,
        1 => "One claim is wrong as stated, with a counter-example".to_owned(),
        count => format!("Wrong as stated are {count} claims, each with a counter-example"),
    };
    if failed.iter().any(has_change) {
        let ids = failed.iter().filter(|entry| !has_change(entry)).map(|entry| &entry.id);
        let text = format!("{text}: [what would be true instead](#sentences-to-change).{findings}");
        return Some(AnswerView::new(text, ids));
    }
    Some(AnswerView {
        is_list: true,
        ..AnswerView::new(format!("{text}:{findings}"), failed.iter().map(|entry| &entry.id))
    })
}

/// What simulations of the full equations say of stability, slip modes and the other law.
fn simulations(claims: &[&Entry]) -> Option<AnswerView> {
    let decided = claims.iter().filter_map(|entry| Some((&entry.id, said(entry)?)));
    let (ids, said): (Vec<&String>, Vec<String>) = decided.unzip();
    (!ids.is_empty()).then(|| AnswerView::new(format!("In simulations: {}.", said.join("; ")), ids))
}

/// Sentences that are not the paper's, in their own words: counted apart from its claims.
fn of_source(source: Source, claims: &[&Entry]) -> Option<AnswerView> {
    let found = [
        counted(claims, Verdict::Holds, ["holds", "hold"]),
        counted(claims, Verdict::HoldsWithin, ["holds within a limit", "hold within a limit"]),
        counted(claims, Verdict::Fails, ["fails", "fail"]),
    ];
    let found: Vec<&str> = found.iter().map(String::as_str).filter(|part| !part.starts_with("0 ")).collect();
    let Words { lead, names: [one, several], .. } = words_of_source(source)?;
    let of = if claims.len() == 1 { one } else { several };
    let text = format!("{lead}, {} {of}: {}.", claims.len(), listed(&found)?);
    Some(AnswerView { is_list: true, ..AnswerView::new(text, claims.iter().map(|entry| &entry.id)) })
}

/// The words of a claim with what was found, up to the first semicolon of its limit; `None` for what was not checked.
fn said(entry: &Entry) -> Option<String> {
    let words = plain(entry.words.trim_end_matches('.'));
    let first = |found: &Option<String>| {
        let found = found.as_deref().unwrap_or_default();
        plain(found.split(';').next().unwrap_or_default().trim_end_matches('.'))
    };
    match entry.finding.verdict {
        Verdict::Holds if entry.finding.limit.is_none() => Some(format!("“{words}” holds")),
        Verdict::Holds => Some(format!("“{words}” holds for {}", first(&entry.finding.limit))),
        Verdict::HoldsWithin => Some(format!("“{words}” holds within {}", first(&entry.finding.limit))),
        Verdict::Fails => Some(format!("“{words}” fails: {}", first(&entry.finding.counter_example))),
        Verdict::NotChecked => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::{Evidence, Finding};
    use crate::report::changes::decided_by;
    use crate::scene::Sentence;

    fn entry(id: &str, finding: Finding) -> Entry {
        Entry {
            id: id.into(),
            place: String::new(),
            words: format!("Words of {id}."),
            criterion: String::new(),
            digest: String::new(),
            sentence: Sentence {
                source: if id.starts_with('R') { Source::Result } else { Source::Paper },
                ..Sentence::default()
            },
            expected: finding.verdict,
            finding,
            not_established: String::new(),
            error_bars: None,
            untied: None,
            subject: subject(id),
            in_answer: ["E1", "E2", "E4"].contains(&id).then_some(InAnswer::Simulations),
            rests_on: Vec::new(),
            stated: None,
        }
    }

    #[test]
    fn what_decides_is_the_first_clause_of_the_verdicts_own_words() {
        let decided = |finding: Finding| decided_by(&entry("A3", finding));
        assert_eq!(decided(Finding::failing("at V = 1.5: 2. More.")), "at V = 1.5: 2");
        assert_eq!(decided(Finding::not_checked("no runs")), "no runs");
        assert_eq!(decided(held()), "q: v");
    }

    fn subject(id: &str) -> Option<Subject> {
        let all = [
            ("A", "the linearisation"),
            ("C", "the stability transition"),
            ("D", "the boundary of oscillation"),
            ("E", "numerical runs"),
        ];
        let place = all.iter().position(|(letter, _)| id.starts_with(letter))?;
        let (letter, words) = all[place];
        Some(Subject { place, letter: letter.into(), title: letter.into(), words: words.into() })
    }

    fn held() -> Finding {
        Finding::from_evidence(Evidence::Sample { quantity: "q".into(), value: "v".into(), points: 1 })
    }

    fn sentences(claims: Vec<Entry>) -> Vec<AnswerView> {
        let ledger = Ledger { report: "r".into(), claims, operating_points: Vec::new() };
        answer(Question::Claims, &ledger, &Outcome::default())
    }

    #[test]
    fn claims_without_a_subject_are_counted() {
        let found = sentences(vec![entry("G1", held()), entry("H2", held())]);
        assert_eq!(found.len(), 1);
        assert!(
            found[0]
                .text_markdown
                .starts_with("Of the 2 claims of the paper in this report, 2 hold as stated")
        );
    }

    #[test]
    fn every_sentence_follows_from_verdicts() {
        let limit = Some("a first limit; a second one".to_owned());
        let limited = Finding { verdict: Verdict::HoldsWithin, limit, ..held() };
        let found = sentences(vec![
            entry("A1", held()),
            entry("C1", held()),
            entry("C3", limited.clone()),
            entry("D6", Finding::failing("a point")),
            entry("E1", held()),
            entry("E2", limited),
            entry("E3", Finding::not_checked("no runs")),
            entry("R1", held()),
        ]);
        let texts: Vec<&str> = found.iter().map(|sentence| sentence.text_markdown.as_str()).collect();
        assert_eq!(
            texts,
            [
                "Of the 7 claims of the paper in this report, 3 hold as stated, 2 hold within a limit, and 1 fails; 1 could not be checked here.",
                "Right: all claims about the linearisation hold as stated, and those about the stability transition at least within a limit.",
                "One claim is wrong as stated, with a counter-example:",
                "In simulations: “Words of E1” holds; “Words of E2” holds within a first limit.",
                "New here, 1 result of our own: 1 holds.",
            ]
        );
        assert!(found[2].is_list && found[2].claims == ["D6"]);
        assert_eq!(found[3].claims, ["E1", "E2"]);
    }

    #[test]
    fn a_verdict_that_changes_changes_the_answer() {
        let of = |finding: Finding| sentences(vec![entry("A3", finding)]);
        assert!(of(held())[1].text_markdown.contains("all claims about the linearisation hold"));
        let failed = of(Finding::failing("a point"));
        assert!(failed[0].text_markdown.contains("0 hold as stated") && failed[1].claims == ["A3"]);
    }

    #[test]
    fn a_report_without_claims_has_no_answer() {
        assert!(sentences(Vec::new()).is_empty());
        assert_eq!(sentences(vec![entry("A3", Finding::not_checked("no scene"))]).len(), 1);
    }
}
