//! Computes pages in parallel, each in its own process with a time limit. A page that exceeds the
//! limit or whose process fails is reported, and the others continue.

use crate::catalogue::Entry;
use crate::files::Folder;
use crate::page::Page;
use std::fs::File;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// How the processes of pages are started and stopped.
#[derive(Debug)]
pub struct Launch<'a, C> {
    /// The command that computes a page and saves its record in the folder.
    pub command: C,
    /// The folder of the records.
    pub folder: &'a Folder,
    /// Time limit of a page.
    pub limit: Duration,
}

impl<C: Fn(Entry) -> Command + Sync> Launch<'_, C> {
    /// Computes these entries in parallel on all cores, slow ones first, and returns them in the
    /// given order. Entries without a function are omitted. `done` is called after each entry, from
    /// any thread.
    pub fn run(&self, entries: &[Entry], done: impl Fn(Entry) + Sync) -> Vec<(Entry, Page)> {
        let mut order: Vec<usize> =
            (0..entries.len()).filter(|i| entries[*i].is_computed()).collect();
        order.sort_by_key(|i| (!entries[*i].is_slow(), *i));
        let next = AtomicUsize::new(0);
        let work = || {
            let mut pages = Vec::new();
            while let Some(i) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                pages.push((*i, self.page(entries[*i])));
                done(entries[*i]);
            }
            pages
        };
        let threads = std::thread::available_parallelism().map_or(1, usize::from).min(order.len());
        let mut pages: Vec<(usize, Page)> = std::thread::scope(|scope| {
            let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            workers.into_iter().flat_map(|worker| worker.join().unwrap_or_default()).collect()
        });
        pages.sort_by_key(|(i, _)| *i);
        pages.into_iter().map(|(i, page)| (entries[i], page)).collect()
    }

    fn page(&self, entry: Entry) -> Page {
        let start = Instant::now();
        let error = match self.start(entry) {
            Ok(mut child) => match wait(&mut child, start + self.limit) {
                Ok(Some(status)) => match self.folder.load(entry) {
                    Some(page) if status.success() => {
                        let _ = std::fs::remove_file(self.folder.log(entry));
                        return page;
                    }
                    _ => self.broken(entry, status),
                },
                Ok(None) => format!(
                    "stopped: it did not end within {} s (--time-limit)",
                    self.limit.as_secs_f64()
                ),
                Err(error) => format!("cannot wait for its process: {error}"),
            },
            Err(error) => error,
        };
        let page = Page::failed(entry, error, start.elapsed());
        // If saving fails, only the report of the next run lacks the page.
        let _ = self.folder.save(entry, &page);
        page
    }

    fn start(&self, entry: Entry) -> Result<Child, String> {
        self.folder.forget(entry).map_err(|error| error.to_string())?;
        let path = self.folder.log(entry);
        let log = File::create(&path)
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        (self.command)(entry)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(log)
            .spawn()
            .map_err(|error| format!("cannot start its process: {error}"))
    }

    /// The message about a process that left no record.
    fn broken(&self, entry: Entry, status: ExitStatus) -> String {
        let log = std::fs::read(self.folder.log(entry)).unwrap_or_default();
        let log = String::from_utf8_lossy(&log);
        let words = log.trim().lines().rev().take(3).collect::<Vec<_>>();
        let words = words.into_iter().rev().collect::<Vec<_>>().join(" | ");
        format!("its process ended with {status}: {words}")
    }
}

/// Waits until the child ends; stops it at `end` and then returns `None`.
fn wait(child: &mut Child, end: Instant) -> std::io::Result<Option<ExitStatus>> {
    let mut pause = Duration::from_millis(1);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        let left = end.saturating_duration_since(Instant::now());
        if left.is_zero() {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(pause.min(left));
        pause = (2 * pause).min(Duration::from_millis(20));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Figure, FigureResult, Table};

    const ROLE: &str = "CAROM_TEST_PAGE";
    const FOLDER: &str = "CAROM_TEST_FOLDER";

    fn good() -> FigureResult {
        let mut figure = Figure::new();
        figure.table(Table::new("", ["x"]));
        figure.at_most("small", 1.0, 2.0).source("given");
        Ok(figure)
    }

    fn entries() -> [Entry; 4] {
        let [hangs, breaks, good_one] = ["hangs", "breaks", "good"].map(|id| Entry::check(id, ""));
        [hangs.slowly_by(good), breaks.by(good), Entry::check("missing", ""), good_one.by(good)]
    }

    /// Not a test itself: the process of a page, started by the test below.
    #[test]
    fn as_a_page() {
        let Ok(role) = std::env::var(ROLE) else { return };
        let entry = *entries().iter().find(|entry| entry.id == role).unwrap();
        match entry.id {
            "hangs" => std::thread::sleep(Duration::from_secs(1000)),
            "breaks" => {
                eprintln!("no such luck");
                std::process::abort();
            }
            _ => {
                let folder = Folder::new(std::env::var_os(FOLDER).unwrap().into()).unwrap();
                let outcome = crate::run::compute(entry, std::path::Path::new("nowhere"));
                folder.save(entry, &Page::new(&outcome, String::new())).unwrap();
            }
        }
    }

    fn launched(entries: &[Entry], name: &str, limit: Duration) -> Vec<(Entry, Page)> {
        let path = std::env::temp_dir().join(format!("carom-launch-{name}-{}", std::process::id()));
        let folder = Folder::new(path.clone()).unwrap();
        let command = |entry: Entry| {
            let mut command = Command::new(std::env::current_exe().unwrap());
            command.args(["--exact", "launch::tests::as_a_page", "--nocapture"]);
            command.env(ROLE, entry.id).env(FOLDER, &path);
            command
        };
        let count = AtomicUsize::new(0);
        let pages = Launch { command, folder: &folder, limit }.run(entries, |_| {
            count.fetch_add(1, Ordering::Relaxed);
        });
        assert_eq!(count.into_inner(), pages.len());
        for (entry, page) in &pages {
            assert_eq!(folder.load(*entry).as_ref(), Some(page));
        }
        std::fs::remove_dir_all(path).unwrap();
        pages
    }

    #[test]
    fn a_page_that_breaks_its_process_is_named_and_the_others_go_on() {
        let pages = launched(&entries()[1..], "breaks", Duration::from_secs(500));
        let ids: Vec<_> = pages.iter().map(|(entry, _)| entry.id).collect();
        assert_eq!(ids, ["breaks", "good"]);
        let error = pages[0].1.error.clone().unwrap();
        assert!(error.starts_with("its process ended with "), "{error}");
        assert!(error.contains("no such luck"), "{error}");
        assert!(pages[1].1.holds());
    }

    #[test]
    fn a_page_that_hangs_is_stopped_and_named() {
        let start = Instant::now();
        let pages = launched(&entries()[..1], "hangs", Duration::from_millis(300));
        assert!(start.elapsed() < Duration::from_secs(900)); // it would sleep for 1000
        let error = pages[0].1.error.as_deref();
        assert_eq!(error, Some("stopped: it did not end within 0.3 s (--time-limit)"));
    }
}
