//! Drives the car, compares details, and times a scene of sixteen cars.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use suspension_car::car::CORNERS;
use suspension_car::compare;
use suspension_car::detail::Detail;
use suspension_car::drive::{self, TICK, microseconds};
use suspension_car::plot;
use suspension_car::record::{self, Row};
use suspension_car::scene;

const USAGE: &str = "\
usage: suspension-car                drives ten seconds: a table, out/car.csv, out/car.svg
       suspension-car --minutes 10   drives on, and tells how a tick's time is spent
       suspension-car detail         each detail's time against its error: a table, out/car_detail.svg
       suspension-car scene          sixteen cars at mixed detail";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let done = match *words {
        [] => show(),
        ["--minutes", minutes] => match minutes.parse() {
            Ok(minutes) if minutes > 0.0 && f64::is_finite(minutes) => long(minutes),
            _ => Err(format!("--minutes takes a positive number, not {minutes}").into()),
        },
        ["detail"] => compare::run(Path::new("out/car_detail.svg")),
        ["scene"] => scene::run(),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Ten seconds, shown.
fn show() -> Result<(), Box<dyn Error>> {
    let mut car = drive::start(Detail::Exact)?;
    let mut rows = Vec::new();
    drive::drive(&mut car, 10.0, TICK, |time, car, controls| {
        rows.push(Row::of(time, car, controls));
    })?;
    println!("time   x       y      speed  roll   yaw rate  load in N, travel in mm");
    println!(
        "s      m       m      m/s    deg    deg/s     {}",
        CORNERS.join("   ")
    );
    for row in rows.iter().step_by(500) {
        let [x, y, _] = row.position;
        let [roll, yaw_rate] = [row.angles[0], row.yaw_rate].map(f64::to_degrees);
        print!(
            "{:<5.1} {x:6.1} {y:7.2} {:7.2} {roll:6.2} {yaw_rate:8.2}  ",
            row.time, row.speed
        );
        for (load, travel) in row.load.iter().zip(row.travel) {
            print!("{load:7.0} {:5.1}", 1e3 * travel);
        }
        println!();
    }
    std::fs::create_dir_all("out")?;
    record::write(&rows, Path::new("out/car.csv"))?;
    let title = "A step of steering, then bumps, at 20 m/s";
    plot::draw(title, &record::panels(&rows), Path::new("out/car.svg"))?;
    println!("wrote out/car.csv and out/car.svg");
    Ok(())
}

/// Minutes, timed.
fn long(minutes: f64) -> Result<(), Box<dyn Error>> {
    println!("a tick's median time in µs, {minutes} minutes at 1 kHz");
    println!("                 kinematics  tyres, road  motion  sum    s in all");
    for detail in Detail::ALL {
        let mut car = drive::start(detail)?;
        let began = Instant::now();
        let parts = drive::drive(&mut car, 60.0 * minutes, TICK, |_, _, _| {})?;
        let [kinematics, tyres, motion, sum] =
            [parts.kinematics, parts.tyres, parts.motion, parts.sum()].map(microseconds);
        println!(
            "{:<16} {kinematics:<10.2}  {tyres:<11.2}  {motion:<6.2}  {sum:<5.2}  {:.1}",
            detail.name(),
            began.elapsed().as_secs_f64()
        );
    }
    println!("no refusal");
    Ok(())
}
