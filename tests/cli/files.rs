//! The places to which results are written.

use std::path::Path;

use super::program::{CORNER, example, folder, run, text};

fn folder_with_input() -> tempfile::TempDir {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    folder
}

fn files_in(folder: &Path) -> usize {
    std::fs::read_dir(folder).expect("a folder").count()
}

#[test]
fn an_unwritable_result_gives_exit_code_1() {
    let folder = folder_with_input();
    std::fs::write(folder.path().join("file"), "").expect("written");
    let arguments = ["motion", "a.toml", "--csv", "file/a.csv"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    assert!(
        message.starts_with("file/a.csv: cannot be written: not a directory"),
        "{message}"
    );
}

#[test]
fn results_do_not_overwrite_the_input() {
    let folder = folder_with_input();
    std::fs::create_dir(folder.path().join("sub")).expect("a folder");
    for name in ["a.toml", "sub/../a.toml"] {
        let output = run(folder.path(), &["motion", "a.toml", "--csv", name]);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(
            message.starts_with(&format!("{name}: this is the file that is read")),
            "{message}"
        );
        let kept = std::fs::read_to_string(folder.path().join("a.toml")).expect("the input");
        assert_eq!(kept, example("attia2003.toml"));
    }
}

/// A file of measurements is an input also of commands that do not read it.
#[test]
fn results_do_not_overwrite_measurements_of_a_target() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    let tune = "\n[tune.moves.ball]\npoints = ['tie_ball']\nalong = 'z'\nby = [-0.01, 0.01]\n\
                [tune.targets.toe]\nof = 'toe'\nover = { bump = [-0.06, 0.06] }\n\
                change = { csv = '../m.csv', columns = ['travel', 'toe'] }\nwithin = 0.05\n\
                [loads.q]\nwheel_centre = { force = [1.0, 2.0, 3.0] }\n";
    std::fs::create_dir(at("sub")).expect("a folder");
    std::fs::write(at("sub/a.toml"), CORNER.to_owned() + tune).expect("written");
    let measured = "travel,toe\n-0.05,0.1\n0.05,-0.1\n";
    std::fs::write(at("m.csv"), measured).expect("written");
    for (command, option) in [
        ("motion", "--csv"),
        ("motion", "--json"),
        ("sweep", "--csv"),
        ("loads", "--csv"),
        ("loads", "--json"),
        ("range", "--csv"),
        ("assemblies", "--csv"),
        ("sensitivities", "--csv"),
        ("tables", "-o"),
        ("bake", "-o"),
        ("draw", "-o"),
        ("sheet", "-o"),
    ] {
        let drive: &[&str] = match command {
            "bake" => &["--drive", "bump=0.28:0.32"],
            "sweep" => &["--drive", "bump=0.28:0.32:3"],
            "tables" => &["--as", "carsim"],
            _ => &[],
        };
        let output = run(
            folder.path(),
            &[&[command, "sub/a.toml", option, "m.csv"], drive].concat(),
        );
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{command}: {message}");
        let expected = "m.csv: this is the file that is read, which --";
        assert!(message.contains(expected), "{command}: {message}");
        let kept = std::fs::read_to_string(at("m.csv")).expect("the measurements");
        assert_eq!(kept, measured, "{command}");
    }
}

/// The rows of a table are not lost under a plot.
#[test]
fn a_table_at_the_path_of_a_plot_is_refused() {
    let folder = folder_with_input();
    std::fs::create_dir(folder.path().join("sub")).expect("a folder");
    for (command, plots, table) in [
        ("motion", ".", "a_height.svg"),
        ("motion", "plots", "plots/a_toe.svg"),
        (
            "motion",
            "plots",
            "sub/../plots/../new/../plots/a_height.svg",
        ),
        ("range", "plots/.", "plots/a_range_theta.svg"),
    ] {
        let arguments = [command, "a.toml", "--plots", plots, "--csv", table];
        let output = run(folder.path(), &arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        let expected = format!("{table}: --plots draws to this file, which --csv names too\n");
        assert_eq!(message, expected);
        assert_eq!(files_in(folder.path()), 2, "nothing was written");
    }
    let apart = [
        "motion",
        "a.toml",
        "--plots",
        "plots",
        "--csv",
        "a_height.svg",
    ];
    let output = run(folder.path(), &apart);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// The second file would replace the first, also if the link leads to a file that does not exist yet.
#[cfg(unix)]
#[test]
fn a_symbolic_link_to_another_result_is_refused() {
    use std::os::unix::fs::symlink;
    let folder = folder_with_input();
    let at = |name: &str| folder.path().join(name);
    for name in ["plots", "runs"] {
        std::fs::create_dir(at(name)).expect("a folder");
    }
    symlink("../runs/both", at("plots/a_height.svg")).expect("a link");
    symlink("plots/a_height.svg", at("link")).expect("a link");
    for (other, expected) in [
        (["--json", "link"], "--csv and --json name the same place"),
        (
            ["--plots", "plots"],
            "runs/both: --plots draws to this file",
        ),
    ] {
        let output = run(
            folder.path(),
            &[&["motion", "a.toml", "--csv", "runs/both"], &other[..]].concat(),
        );
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.starts_with(expected), "{message}");
        assert!(!at("runs/both").exists(), "nothing was written");
    }
}

/// Limits of the shell apply to its children. A block is 512 or 1,024 bytes.
#[cfg(unix)]
#[test]
fn a_file_beyond_the_size_limit_gives_exit_code_1_and_no_file() {
    let folder = folder();
    let fine = "start = 0.0\nstop = 1.9\nstep = 0.001";
    std::fs::write(
        folder.path().join("a.toml"),
        super::program::edited("instants", fine),
    )
    .expect("written");
    let program = format!(
        "ulimit -f 100 && exec '{}' motion a.toml --csv a.csv",
        super::PROGRAM
    );
    let output = std::process::Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", &program])
        .output()
        .expect("a shell");
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(
        message.starts_with("a.csv: cannot be written: "),
        "{message}"
    );
    assert_eq!(files_in(folder.path()), 1, "{message}");
}

#[cfg(unix)]
#[test]
fn a_replaced_result_keeps_its_file_mode() {
    use std::fs::Permissions;
    use std::os::unix::fs::PermissionsExt;
    let folder = folder_with_input();
    let csv = folder.path().join("a.csv");
    for mode in [0o600, 0o664, 0o755] {
        std::fs::write(&csv, "old").expect("written");
        std::fs::set_permissions(&csv, Permissions::from_mode(mode)).expect("a mode");
        let output = run(folder.path(), &["motion", "a.toml", "--csv", "a.csv"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let found = csv.metadata().expect("a table");
        assert!(found.len() > 1000);
        assert_eq!(found.permissions().mode() & 0o777, mode);
    }
    assert_eq!(files_in(folder.path()), 2);
}

/// No user may make files there, not even root.
#[cfg(target_os = "linux")]
#[test]
fn a_write_error_names_the_path_of_the_user() {
    let folder = folder_with_input();
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "/proc/a.csv"]);
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert!(message.starts_with("/proc/a.csv: cannot be written"));
    assert!(!message.contains(".part"), "{message}");
}

/// A link is followed, even to a file that does not exist yet; a cycle of links is refused.
#[cfg(unix)]
#[test]
fn a_result_written_to_a_symbolic_link_keeps_the_link() {
    use std::os::unix::fs::symlink;
    let folder = folder_with_input();
    let at = |name: &str| folder.path().join(name);
    std::fs::create_dir(at("runs")).expect("a folder");
    symlink("runs/first.csv", at("link.csv")).expect("a link");
    symlink("round.csv", at("round.csv")).expect("a link");
    for _ in 0..2 {
        let output = run(folder.path(), &["motion", "a.toml", "--csv", "link.csv"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert!(at("link.csv").is_symlink() && at("runs/first.csv").is_file());
    }
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "round.csv"]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    assert!(at("round.csv").is_symlink());
}
