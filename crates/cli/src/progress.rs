//! Progress of a computation that takes longer than two seconds: a bar on a terminal, lines in a log.

use crate::global_options::Messages;
use crate::page::width;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal as _;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

/// Refreshes of a bar per second.
const REFRESHES_PER_SECOND: u8 = 5;
/// Characters of the longest bar.
const MOST: usize = 40;
/// Nothing is told of what takes less.
const SILENCE: Duration = Duration::from_secs(2);
/// The longest time between two lines; it grows twofold up to this.
const LONGEST: Duration = Duration::from_secs(64);
/// Stack of the thread that writes the lines: little, for machines with a limit.
const STACK: usize = 128 << 10;

/// Tells how far a computation is, on standard error, until it is dropped.
#[derive(Debug)]
pub(crate) struct Progress {
    known: Arc<Known>,
    bar: ProgressBar,
    log: Option<Log>,
}

/// What is known of the computation.
#[derive(Debug)]
struct Known {
    count: usize,
    what: String,
    start: Instant,
    done: AtomicUsize,
    /// Done before the start.
    found: AtomicUsize,
    now: Mutex<String>,
}

/// The thread that writes lines, and the end of a channel that stops it.
#[derive(Debug)]
struct Log {
    stop: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    /// Progress over this number of `what`; 0 if the number is not known.
    pub(crate) fn new(messages: Messages, count: usize, what: impl Into<String>) -> Self {
        let known = Arc::new(Known {
            count,
            what: what.into(),
            start: Instant::now(),
            done: AtomicUsize::new(0),
            found: AtomicUsize::new(0),
            now: Mutex::default(),
        });
        let is_shown = std::io::stderr().is_terminal();
        let (bar, log) = match (messages.is_quiet(), is_shown) {
            (true, _) => (ProgressBar::hidden(), None),
            (false, true) => (known.bar(), None),
            (false, false) => (ProgressBar::hidden(), Log::new(&known, messages)),
        };
        Self { known, bar, log }
    }

    /// This many were done before the start.
    pub(crate) fn found(&self, count: usize) {
        self.known.found.store(count, Ordering::Relaxed);
        self.known.done.store(count, Ordering::Relaxed);
        self.bar.set_position(count as u64);
        self.bar.reset_eta();
    }

    /// This many more are done.
    pub(crate) fn inc(&self, count: usize) {
        self.known.done.fetch_add(count, Ordering::Relaxed);
        self.bar.inc(count as u64);
    }

    /// What is being computed now.
    pub(crate) fn now(&self, what: &str) {
        what.clone_into(&mut self.known.now.lock().unwrap_or_else(PoisonError::into_inner));
        self.bar.set_message(what.to_owned());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        drop(self.log.take());
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        drop(self.stop.take());
        let ended = self.thread.take().map(JoinHandle::join);
        debug_assert!(!matches!(ended, Some(Err(_))), "the thread of the log panicked");
    }
}

impl Log {
    /// None if the machine gives no thread for it.
    fn new(known: &Arc<Known>, messages: Messages) -> Option<Self> {
        let (stop, stopped) = channel();
        let known = Arc::clone(known);
        let thread = Builder::new().stack_size(STACK).spawn(move || known.tell(messages, &stopped));
        Some(Self { stop: Some(stop), thread: Some(thread.ok()?) })
    }
}

/// Characters of the bar: a third of the line.
fn bar_width() -> usize {
    width(&console::Term::stderr()).map_or(MOST, |width| (width / 3).min(MOST))
}

impl Known {
    fn bar(&self) -> ProgressBar {
        let target = ProgressDrawTarget::stderr_with_hz(REFRESHES_PER_SECOND);
        let what = &self.what;
        let (bar, form) = match self.count {
            0 => (ProgressBar::with_draw_target(None, target), format!("{what}, {{elapsed}}")),
            count => {
                let form = format!(
                    "{{bar:{}}} {{pos}}/{{len}} {what}, {{eta}} left {{wide_msg}}",
                    bar_width()
                );
                (ProgressBar::with_draw_target(Some(count as u64), target), form)
            }
        };
        match ProgressStyle::with_template(&form) {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }

    /// Writes a line after two seconds, and others at growing intervals, until stopped.
    fn tell(&self, messages: Messages, stopped: &Receiver<()>) {
        let mut wait = SILENCE;
        while stopped.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
            messages.progress(&self.line(self.start.elapsed()));
            wait = self.start.elapsed().min(LONGEST);
        }
    }

    fn line(&self, elapsed: Duration) -> String {
        let (done, found) = (self.done.load(Ordering::Relaxed), self.found.load(Ordering::Relaxed));
        let seconds = elapsed.as_secs();
        let now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        let now = if now.is_empty() { String::new() } else { format!(", now {now}") };
        let what = &self.what;
        let Some(left) = self.count.checked_sub(done).filter(|_| self.count > 0) else {
            return format!("{what} for {seconds} s{now}");
        };
        let ahead = match done - found {
            0 => String::new(),
            new => {
                format!(", about {:.0} s left", elapsed.as_secs_f64() * left as f64 / new as f64)
            }
        };
        format!("{done} of {} {what} in {seconds} s{ahead}{now}", self.count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_tells_what_is_done_and_left() {
        let progress = Progress::new(Messages::QUIET, 10, "steps");
        let line = || progress.known.line(Duration::from_secs(8));
        assert_eq!(line(), "0 of 10 steps in 8 s");
        progress.found(2);
        progress.inc(4);
        assert_eq!(line(), "6 of 10 steps in 8 s, about 8 s left");
        progress.now("KOMBI");
        assert_eq!(line(), "6 of 10 steps in 8 s, about 8 s left, now KOMBI");
        let unknown = Progress::new(Messages::QUIET, 0, "rolling");
        assert_eq!(unknown.known.line(Duration::from_secs(2)), "rolling for 2 s");
    }
}
