//! The text of `--help` of each command.

use super::program::{folder, run, text};

#[test]
fn the_help_of_every_command_states_its_exit_codes() {
    let folder = folder();
    let help = run(folder.path(), &["--help"]);
    let (_, behind) = text(&help.stdout)
        .split_once("Commands:\n")
        .expect("commands");
    let (commands, _) = behind.split_once("\n\n").expect("their end");
    let names = commands.lines().filter_map(|line| line.split(' ').nth(2));
    for name in names.filter(|&name| name != "help") {
        let help = run(folder.path(), &[name, "--help"]);
        assert!(text(&help.stdout).contains("\nExit codes"), "{name}");
    }
}
