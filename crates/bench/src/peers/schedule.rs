//! The schedule: every player gets the same inputs in turn, several times over, and its fastest run counts.

use std::path::Path;
use std::process::{Command, Stdio};

use super::players::Player;
use super::row::{Row, keep_best};
use crate::process;

/// Writes the inputs and their references, unless they lie there.
///
/// # Errors
/// When our own benchmark cannot be built or fails.
pub fn prepare() -> Result<(), String> {
    let words = "bench --locked -p slipmode-bench --bench peers -- prepare target/peers/inputs";
    process::check(&mut process::cargo(words))
}

/// Asks every player for every work that it does, round after round, and keeps the best rows in the order of the works.
///
/// # Errors
/// When slipmode's own part fails; another player that fails is named and left out.
pub fn run(players: &[Player], works: &[&str], rounds: usize) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    for work in works {
        for round in 0..rounds {
            for player in players.iter().filter(|player| player.does(work) && (round == 0 || !player.is_slow))
            {
                eprintln!("{work}: {} ({} of {rounds})", player.name, round + 1);
                play(player, work, &mut rows)?;
            }
        }
    }
    Ok(rows)
}

fn play(player: &Player, work: &str, rows: &mut Vec<Row>) -> Result<(), String> {
    let mut command = player.command(work);
    let words = words(&command);
    let done = command.stderr(Stdio::inherit()).output();
    match done {
        Ok(done) if done.status.success() => {
            for line in String::from_utf8_lossy(&done.stdout).lines() {
                if let Some(row) = Row::parse(line, &player.program_and_version(), &words) {
                    keep_best(rows, row);
                }
            }
            Ok(())
        }
        _ if player.name == "slipmode" => Err(format!("`{words}` failed")),
        _ => {
            println!("peer {} failed at {work} and is left out there", player.name);
            Ok(())
        }
    }
}

/// What a reader types to have the same row printed.
fn words(command: &Command) -> String {
    let program = Path::new(command.get_program());
    // Cargo is started by its full path, compiled players by one from the root.
    let name =
        if program.is_absolute() { program.file_name().unwrap_or_default() } else { program.as_os_str() };
    let gp_needs = command.get_envs().filter(|(key, _)| key.to_string_lossy().starts_with("PEERS_"));
    let settings = gp_needs
        .filter_map(|(key, value)| Some(format!("{}={}", key.to_string_lossy(), value?.to_string_lossy())));
    let arguments = command.get_args().map(|word| word.to_string_lossy().into_owned());
    settings.chain([name.to_string_lossy().into_owned()]).chain(arguments).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_is_told_without_paths_of_this_machine() {
        let mut command = Command::new("/somewhere/bin/gp");
        command.env("PEERS_WORK", "roots-50-hard").env("OTHER", "1").arg("-q");
        assert_eq!(words(&command), "PEERS_WORK=roots-50-hard gp -q");
    }
}
