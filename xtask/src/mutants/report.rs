//! Prints the results of the mutants.

use super::list::Mutant;
use super::round::Verdict;
use anyhow::bail;

/// Prints which test detects each mutant, and how many are detected by tests and by claims.
pub(super) fn table(judged: &[(&Mutant, Verdict)]) {
    for (mutant, verdict) in judged.iter().filter(|(_, verdict)| !verdict.survives()) {
        let both = [&verdict.test, &verdict.page].into_iter().flatten();
        let shown = both.map(String::as_str).collect::<Vec<_>>().join(", ");
        println!("{}\n    {shown}", mutant.key());
    }
    let count = |holds: fn(&Verdict) -> bool| judged.iter().filter(|(_, v)| holds(v)).count();
    println!(
        "detected by tests and claims: {}, by tests only: {}, by claims only: {}",
        count(|v| v.test.is_some() && v.page.is_some()),
        count(|v| v.test.is_some() && v.page.is_none()),
        count(|v| v.test.is_none() && v.page.is_some()),
    );
}

/// Prints the surviving mutants; fails if one is not explained by the list.
pub(super) fn survivors(judged: &[(&Mutant, Verdict)]) -> anyhow::Result<()> {
    let mut unexplained = 0;
    for (mutant, verdict) in judged {
        match (verdict.survives(), &mutant.explained) {
            (true, Some(reason)) => println!("{}\n    survives: {reason}", mutant.key()),
            (true, None) => {
                unexplained += 1;
                let why = if verdict.is_reached { "" } else { ", nothing reaches it" };
                let Mutant { find, replace, .. } = mutant;
                println!("{}\n    SURVIVES{why}: {find} -> {replace}", mutant.key());
            }
            (false, Some(_)) => {
                println!("{}\n    is detected, but the list explains why not", mutant.key())
            }
            (false, None) => {}
        }
    }
    println!("{} mutants, {unexplained} unexplained survivors", judged.len());
    if unexplained > 0 {
        bail!("{unexplained} mutants survive and are not explained");
    }
    Ok(())
}
