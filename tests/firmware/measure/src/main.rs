//! Measures what the solver costs on microcontrollers and compares it with the budgets.
mod archive;
mod compile;
mod reach;
mod run;
mod target;

use archive::Archive;
use reach::Reach;

fn main() -> anyhow::Result<()> {
    let host = run::on_host(); println!("{host:#?}"); if std::env::args().count() > 1 {return Ok(())}
    for target in &target::TARGETS {
        let built = compile::compile(target)?;
        let taken = run::on_board(target, &built.firmware)?;
        let archive = Archive::read(&built.archive)?;
        for (mode, taken) in &taken {
            let root = archive.find(mode)?;
            let reach = Reach::of(&archive, &[root]);
            println!("{} {mode} {:?} {:?} {} {} {}", target.name, taken.instructions, taken.stack, reach.stack(root).map_or_else(|e| format!("{e:#}"), |n| n.to_string()), reach.bytes(), host.get(mode) == Some(&taken.checksum));
        }
    }
    Ok(())
}
