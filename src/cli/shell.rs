//! `slipmode completions` and `slipmode man`: what a shell and `man` want to know of the commands.

use clap::{Args, Command};
use clap_complete::Shell;

use crate::cli::failure::Failure;
use crate::cli::terminal;

/// Options of `completions`.
#[derive(Debug, Args)]
pub struct CompletionsOptions {
    /// The shell that is to complete commands and options
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Options of `man`.
#[derive(Debug, Args)]
pub struct ManOptions {
    /// The command whose page is printed [default: the page of slipmode itself]
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

/// Prints a completion script.
///
/// # Errors
/// When it cannot be written.
pub fn completions(options: &CompletionsOptions, mut commands: Command) -> Result<(), Failure> {
    let name = commands.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut commands, name, &mut script);
    terminal::print(&String::from_utf8_lossy(&script))
}

/// Prints a manual page.
///
/// # Errors
/// When there is no such command, or the page cannot be written.
pub fn man(options: &ManOptions, mut commands: Command) -> Result<(), Failure> {
    commands.build();
    let page_of = match &options.command {
        None => commands,
        Some(name) => {
            let names: Vec<&str> = commands.get_subcommands().map(Command::get_name).collect();
            let unknown = format!("COMMAND = {name}: is no command (allowed: {})", names.join(", "));
            commands.find_subcommand(name).cloned().ok_or(Failure::Refused(unknown))?
        }
    };
    let mut page = Vec::new();
    clap_mangen::Man::new(page_of).render(&mut page)?;
    terminal::print(&String::from_utf8_lossy(&page))
}
