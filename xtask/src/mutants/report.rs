//! What became of the mutants, as a table.

use super::list::Mutant;
use super::round::Verdict;
use anyhow::bail;

/// Prints who notices each mutant; fails if one survives that the list does not explain.
pub(super) fn report(judged: &[(&Mutant, Verdict)]) -> anyhow::Result<()> {
    let mut unexplained = 0;
    for (mutant, verdict) in judged {
        let shown = match (verdict.survives(), &mutant.explained) {
            (false, None) => noticed(verdict),
            (false, Some(_)) => format!("{}; the list explains it in vain", noticed(verdict)),
            (true, Some(reason)) => format!("survives: {reason}"),
            (true, None) => {
                unexplained += 1;
                let why = if verdict.is_reached { "" } else { " (no test reaches it)" };
                format!("SURVIVES{why}: {} -> {}", mutant.find, mutant.replace)
            }
        };
        println!("{}\n    {shown}", mutant.key());
    }
    println!("{}", summary(judged));
    if unexplained > 0 {
        bail!("{unexplained} mutants survive and are not explained");
    }
    Ok(())
}

fn noticed(verdict: &Verdict) -> String {
    let both = [&verdict.test, &verdict.page];
    both.into_iter().flatten().map(String::as_str).collect::<Vec<_>>().join(", ")
}

fn summary(judged: &[(&Mutant, Verdict)]) -> String {
    let count = |holds: fn(&Verdict) -> bool| judged.iter().filter(|(_, v)| holds(v)).count();
    format!(
        "{} mutants: {} noticed by tests and claims, {} by tests only, {} by claims only, \
         {} survive",
        judged.len(),
        count(|v| v.test.is_some() && v.page.is_some()),
        count(|v| v.test.is_some() && v.page.is_none()),
        count(|v| v.test.is_none() && v.page.is_some()),
        count(Verdict::survives),
    )
}
