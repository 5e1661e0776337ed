//! The text of `--help` of each command.

use super::program::{folder, run, text};

/// The name of each command and its help.
fn commands() -> Vec<(String, String)> {
    let folder = folder();
    let help = |words: &[&str]| text(&run(folder.path(), words).stdout).to_owned();
    let all = help(&["--help"]);
    let (_, behind) = all.split_once("Commands:\n").expect("commands");
    let (commands, _) = behind.split_once("\n\n").expect("their end");
    let names = commands.lines().filter_map(|line| line.split(' ').nth(2));
    let names = names.filter(|&name| name != "help");
    names
        .map(|name| (name.to_owned(), help(&[name, "--help"])))
        .collect()
}

#[test]
fn the_help_of_every_command_states_its_exit_codes() {
    for (name, help) in commands() {
        assert!(help.contains("\nExit codes"), "{name}");
    }
}

#[test]
fn every_command_with_out_takes_its_first_letter_too() {
    let with_out = commands()
        .into_iter()
        .filter(|(_, help)| help.contains("--out <PATH>"));
    let with_out: Vec<_> = with_out.collect();
    assert!(with_out.len() > 5);
    for (name, help) in with_out {
        assert!(help.contains("  -o, --out <PATH>"), "{name}");
    }
}
