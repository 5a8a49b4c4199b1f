//! Tests the report in a headless browser: three widths, the middle one with the dark theme.

use crate::outcome::{Outcome, Part};
use crate::root::root;
use anyhow::{Context as _, bail};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const PROBE: &str = include_str!("probe.js");
/// Widths of a phone, a tablet and a desktop screen, in pixels, and themes. What is cut depends on the width alone, what
/// is pale on the theme alone: not every pair is looked at.
const VIEWS: [(u32, &str); 3] = [(400, "light"), (800, "dark"), (1400, "light")];
/// Height of the frame, in pixels.
const HEIGHT: u32 = 2400;
/// After so many milliseconds the browser gives up.
const TIME_LIMIT: &str = "--timeout=120000";
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// Loads `target/verification/report.html` and saves screenshots in
/// `target/verification/screenshots/`; skipped without a browser.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    let root = root();
    let folder = root.join("target/verification");
    let Some(browser) = browser() else {
        return Ok(Outcome::skipped(Part::Browser, none()));
    };
    let report = folder.join("report.html");
    let text = std::fs::read_to_string(&report)
        .with_context(|| format!("no {}: run `cargo xtask verify` first", report.display()))?;
    let shots = folder.join("screenshots");
    std::fs::create_dir_all(&shots)?;
    let probed = shots.join("probed.html");
    std::fs::write(&probed, with_probe(&text)?)?;
    let mut faults = Vec::new();
    for (width, theme) in VIEWS {
        let name = format!("{width}-{theme}");
        let seen = look(&browser, &shots, width, theme).with_context(|| name.clone())?;
        println!("{name}: {seen}");
        let of_this = seen["faults"].as_array().map_or(&[][..], Vec::as_slice);
        faults.extend(of_this.iter().map(|fault| format!("{name}: {fault}")));
    }
    std::fs::remove_file(probed)?;
    println!("screenshots: {}", shots.display());
    if !faults.is_empty() {
        bail!("{} faults in the report:\n  {}", faults.len(), faults.join("\n  "));
    }
    Ok(Outcome::Passed)
}

/// Why nothing was looked at.
pub(crate) fn none() -> String {
    format!("no browser; looked for {} and $CHROMIUM", BROWSERS.join(", "))
}

/// A browser that can run without a window, if there is one.
pub(crate) fn browser() -> Option<PathBuf> {
    let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let places = std::env::split_paths(&path)
        .flat_map(|folder| BROWSERS.map(|name| folder.join(name)))
        .collect::<Vec<_>>();
    named.into_iter().chain(places).find(|place| place.is_file())
}

/// The report with the test script, which records errors from the start.
fn with_probe(report: &str) -> anyhow::Result<String> {
    let ear = "<head><script>window.faults=[];addEventListener('error',e=>faults.push(e.message||\
               'not loaded: '+(e.target.src||e.target.href)),true);\
               addEventListener('load',()=>{window.opened=Math.round(performance.now())});</script>";
    let (before, after) = report.split_once("<head>").context("a page without a head")?;
    let (body, end) = after.rsplit_once("</body>").context("a page without an end")?;
    Ok(format!("{before}{ear}{body}<script>{PROBE}</script></body>{end}"))
}

/// The findings of the test script in a frame of this width.
fn look(
    browser: &Path,
    folder: &Path,
    width: u32,
    theme: &str,
) -> anyhow::Result<serde_json::Value> {
    let name = format!("{width}-{theme}");
    let frame = folder.join(format!("{name}.html"));
    // A window cannot be narrower than 500 pixels; a frame can. A second frame, whose document stays
    // open, holds back the end of loading, and with it the browser's answer, until the test is done.
    let page = format!(
        "<!DOCTYPE html><body style=\"margin:0\"><pre id=\"seen\" hidden></pre>\
         <iframe id=\"hold\" hidden></iframe><script>hold.contentDocument.open();\
         addEventListener('message',e=>{{seen.textContent=btoa(unescape(encodeURIComponent(\
         e.data)));hold.contentDocument.close()}})</script>\
         <iframe src=\"probed.html?theme={theme}\" width=\"{width}\" \
         height=\"{HEIGHT}\" style=\"border:0\"></iframe>"
    );
    std::fs::write(&frame, page)?;
    let picture = format!("--screenshot={}", folder.join(format!("{name}.png")).display());
    let seen = answer(browser, &frame, width, &[&picture, TIME_LIMIT]);
    std::fs::remove_file(&frame)?;
    seen
}

/// What the script of a page leaves in its element `seen`: JSON in base 64. The page opens without a
/// window, in a browser with these further options.
///
/// # Errors
/// If the browser does not start or the script leaves nothing.
pub(crate) fn answer(
    browser: &Path,
    page: &Path,
    width: u32,
    options: &[&str],
) -> anyhow::Result<serde_json::Value> {
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"])
        .arg(format!("--window-size={},{HEIGHT}", width.max(500)))
        .args(options)
        .args(["--dump-dom", &format!("file://{}", page.display())])
        .stderr(Stdio::null())
        .output()?;
    let dump = output.stdout;
    let text = String::from_utf8_lossy(&dump);
    let seen = text.split("id=\"seen\"").nth(1).and_then(|rest| rest.split(['>', '<']).nth(1));
    let seen = seen.filter(|seen| !seen.is_empty()).context("the test script gave no result")?;
    Ok(serde_json::from_slice(&base64(seen)?)?)
}

/// Decodes base 64.
fn base64(text: &str) -> anyhow::Result<Vec<u8>> {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => Ok(letter - b'A'),
        b'a'..=b'z' => Ok(letter - b'a' + 26),
        b'0'..=b'9' => Ok(letter - b'0' + 52),
        b'+' => Ok(62),
        b'/' => Ok(63),
        _ => bail!("`{}` is not a base 64 digit", char::from(letter)),
    };
    let (mut bytes, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for letter in text.trim_end_matches('=').bytes() {
        bits = bits << 6 | u32::from(value(letter)?);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count & 0xff) as u8);
        }
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_answer_is_read() {
        assert_eq!(base64("eyJhIjoxfQ==").unwrap(), b"{\"a\":1}");
        assert!(base64("a?").is_err());
    }

    #[test]
    fn the_probe_comes_last_and_the_ear_first() {
        let page = with_probe("<html><head><title>t</title></head><body>b</body></html>").unwrap();
        assert!(page.find("window.faults=[]").unwrap() < page.find("<title>").unwrap());
        assert!(page.find("postMessage").unwrap() > page.find(">b<").unwrap());
        assert!(with_probe("<p>").is_err());
    }
}
