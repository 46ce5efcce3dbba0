//! The processes that a node started: found by their environment, ended with their whole sessions.

use crate::prelude::*;

/// Kills, with SIGKILL, every session that has a process with all these variables. Returns how many processes that were.
///
/// A batch step has a session of its own: its supervisor, the script of the task, and what the script runs.
///
/// # Errors
/// When the processes cannot be listed, or `kill` cannot be started.
pub fn kill(variables: &[String]) -> Result<usize> {
    let names: Vec<String> = entries("/proc".as_ref())?.iter().map(|path| file_name(path)).collect();
    let ids = || names.iter().filter(|name| name.bytes().all(|byte| byte.is_ascii_digit()));
    let own = session("self");
    // A node's work never has our session; killing that would be a mistake of ours.
    let marked = ids().filter(|id| has(id, variables)).filter_map(|id| session(id));
    let sessions: Vec<u32> = marked.filter(|session| Some(*session) != own).collect();
    let is_condemned = |id: &&String| session(id).is_some_and(|session| sessions.contains(&session));
    let condemned: Vec<&String> = ids().filter(is_condemned).collect();
    if !condemned.is_empty() {
        // Some may have ended meanwhile: that is what is wanted.
        program("kill", "-KILL").args(&condemned).stderr(Stdio::null()).code()?;
    }
    Ok(condemned.len())
}

/// Whether a process has all these variables; another user's process keeps its own to itself.
fn has(id: &str, variables: &[String]) -> bool {
    let environment = fs::read(format!("/proc/{id}/environ")).unwrap_or_default();
    let known: Vec<&[u8]> = environment.split(|byte| *byte == 0).collect();
    variables.iter().all(|variable| known.contains(&variable.as_bytes()))
}

/// The session of a process.
fn session(id: &str) -> Option<u32> {
    parse(&fs::read_to_string(format!("/proc/{id}/stat")).ok()?)
}

/// The session in `id (name) state parent group session …`; the name may hold anything.
fn parse(stat: &str) -> Option<u32> {
    stat.rsplit_once(") ")?.1.split(' ').nth(3)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_session_stands_behind_any_name() {
        assert_eq!(parse("42 (a) b) S 1 40 39 0 -1"), Some(39));
        assert_eq!(parse("nonsense"), None);
    }

    #[test]
    fn our_own_session_is_known_and_nothing_is_killed_for_a_variable_that_nobody_has() {
        assert!(session("self").is_some());
        assert_eq!(kill(&["SLURMD_NODENAME=no-such-node-anywhere".to_string()]).unwrap(), 0);
    }
}
