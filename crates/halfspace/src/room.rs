//! The memory that a process may still allocate.
//!
//! A computation that knows how much memory it needs checks here before it allocates: too large a
//! grid is then an error instead of the end of the process.

/// The value returned if the system gives no information, in bytes: more than any machine has.
const UNKNOWN: u128 = 1 << 40;

/// The number of bytes that this process can allocate now: the smallest of
///
/// - the memory that the system can give without swapping (`MemAvailable` of `/proc/meminfo`),
/// - the limit of its address space (`ulimit -v`) minus what it has mapped,
/// - the limit of its data (`ulimit -d`) minus its data.
///
/// The value holds for the moment. On systems without this information (other than Linux) it is
/// 2^40.
///
/// ```
/// use carom_halfspace::room;
/// assert!(room::available() > 1 << 20);
/// ```
#[must_use]
pub fn available() -> u128 {
    let read = |path| std::fs::read_to_string(path).unwrap_or_default();
    let [memory, limits, status] =
        ["/proc/meminfo", "/proc/self/limits", "/proc/self/status"].map(read);
    least(&memory, &limits, &status)
}

/// The memory available according to `/proc/meminfo`, `/proc/self/limits`, `/proc/self/status`.
fn least(memory: &str, limits: &str, status: &str) -> u128 {
    let under = |limit: &str, used: &str| {
        let limit = number(limits, limit)?;
        Some(limit.saturating_sub(kilobytes(status, used).unwrap_or(0)))
    };
    let rooms = [
        kilobytes(memory, "MemAvailable:"),
        under("Max address space", "VmSize:"),
        under("Max data size", "VmData:"),
    ];
    rooms.into_iter().flatten().min().unwrap_or(UNKNOWN)
}

/// The value in bytes of the line that begins with `name` and is given in kilobytes.
fn kilobytes(text: &str, name: &str) -> Option<u128> {
    Some(1024 * number(text, name)?)
}

/// The first number on the line that begins with `name`; `None` if there is a word instead, such as
/// `unlimited`.
fn number(text: &str, name: &str) -> Option<u128> {
    let rest = text.lines().find_map(|line| line.strip_prefix(name))?;
    rest.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEMORY: &str = "MemTotal:  24000 kB\nMemFree:  3 kB\nMemAvailable:    9000 kB\n";
    const STATUS: &str = "Name:\tx\nVmPeak:\t 7000 kB\nVmSize:\t    1000 kB\nVmData:\t 400 kB\n";

    fn limits(space: &str, data: &str) -> String {
        format!(
            "Limit                     Soft Limit           Hard Limit           Units\n\
             Max data size             {data}            unlimited            bytes\n\
             Max address space         {space}            unlimited            bytes\n"
        )
    }

    #[test]
    fn the_smallest_room_counts() {
        let free = limits("unlimited", "unlimited");
        assert_eq!(least(MEMORY, &free, STATUS), 9000 * 1024);
        assert_eq!(least(MEMORY, &limits("5120000", "unlimited"), STATUS), 4000 * 1024);
        assert_eq!(least(MEMORY, &limits("5120000", "1024000"), STATUS), 600 * 1024);
        assert_eq!(least(MEMORY, &limits("1000", "unlimited"), STATUS), 0);
        assert_eq!(least("", "", ""), UNKNOWN);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_limit_of_the_process_is_asked() {
        // A limit that a shell sets holds for this test's own program, run again in it.
        if std::env::var_os("ROOM_IS_LIMITED").is_some() {
            let room = available();
            assert!(room < 1 << 30, "{room}");
            return;
        }
        let own = std::env::current_exe().unwrap();
        let name = "room::tests::the_limit_of_the_process_is_asked";
        let status = std::process::Command::new("sh")
            .args(["-c", "ulimit -v 1048576 && exec \"$0\" --exact \"$1\""])
            .arg(own)
            .arg(name)
            .env("ROOM_IS_LIMITED", "1")
            .status()
            .unwrap();
        assert!(status.success());
    }
}
