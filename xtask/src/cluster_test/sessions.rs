//! The processes that a node started: found by their environment, ended with their whole sessions.

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

use crate::failure::Failure;
use crate::process;

/// A process as the kernel lists it.
struct Entry {
    id: u32,
    session: u32,
    environment: Vec<String>,
}

/// Kills, with SIGKILL, every session that has a process with all these variables. Returns how many processes that were.
///
/// A batch step has a session of its own: its supervisor, the script of the task, and what the script runs.
///
/// # Errors
/// When `kill` cannot be started.
pub fn kill(variables: &[String]) -> Result<usize, Failure> {
    let entries = entries();
    let sessions: BTreeSet<u32> = entries
        .iter()
        .filter(|entry| variables.iter().all(|variable| entry.environment.contains(variable)))
        .map(|entry| entry.session)
        // A node's work never has our session; killing that would be a mistake of ours.
        .filter(|session| Some(*session) != own_session())
        .collect();
    let condemned: Vec<String> = entries
        .iter()
        .filter(|entry| sessions.contains(&entry.session))
        .map(|entry| entry.id.to_string())
        .collect();
    if !condemned.is_empty() {
        // Some may have ended meanwhile: that is what is wanted.
        process::status(
            Command::new("kill").arg("-KILL").args(&condemned).stderr(std::process::Stdio::null()),
        )?;
    }
    Ok(condemned.len())
}

fn entries() -> Vec<Entry> {
    let Ok(folder) = fs::read_dir("/proc") else { return Vec::new() };
    folder.flatten().filter_map(|entry| read(&entry.file_name().to_string_lossy())).collect()
}

fn own_session() -> Option<u32> {
    read("self").map(|entry| entry.session)
}

fn read(name: &str) -> Option<Entry> {
    if name != "self" && !name.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let stat = fs::read_to_string(format!("/proc/{name}/stat")).ok()?;
    // Other users' processes keep theirs to themselves: they are none of ours.
    let environment = fs::read(format!("/proc/{name}/environ")).ok()?;
    let (id, session) = parse(&stat)?;
    let text = |part: &[u8]| String::from_utf8_lossy(part).into_owned();
    Some(Entry { id, session, environment: environment.split(|byte| *byte == 0).map(text).collect() })
}

/// Process and session of `id (name) state parent group session …`; the name may hold anything.
fn parse(stat: &str) -> Option<(u32, u32)> {
    let id = stat.split(' ').next()?.parse().ok()?;
    let session = stat.rsplit_once(") ")?.1.split(' ').nth(3)?.parse().ok()?;
    Some((id, session))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_session_stands_behind_any_name() {
        assert_eq!(parse("42 (a) b) S 1 40 39 0 -1"), Some((42, 39)));
        assert_eq!(parse("nonsense"), None);
    }

    #[test]
    fn our_own_session_is_known_and_nothing_is_killed_for_a_variable_that_nobody_has() {
        assert!(own_session().is_some());
        assert_eq!(kill(&["SLURMD_NODENAME=no-such-node-anywhere".to_string()]).unwrap(), 0);
    }
}
