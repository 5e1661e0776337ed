//! A table in several groups, read by the reader of the library that wrote it.

use std::io;

use parquet::file::metadata::KeyValue;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use suspension_parquet::{GROUP, Table};

#[test]
fn parquet_rows_of_several_groups_are_read_as_written() {
    const ROWS: usize = GROUP + 3;
    let missing = |row: usize| row % 7 == 3;
    let value = |row: usize| {
        let root = (row as f64).sqrt();
        let root = if missing(row) { f64::NAN } else { root };
        [row as f64, root, f64::NAN]
    };
    let columns = ["bump_m", "camber_rad", "caster_rad"];
    let mut table = Table::create(Vec::new(), columns, [("length", "m")]).expect("a table");
    for row in 0..ROWS {
        table.row(&value(row)).expect("a row");
    }
    let bytes = table.finish().expect("the whole");
    let reader = SerializedFileReader::new(bytes::Bytes::from(bytes)).expect("Parquet");
    let metadata = reader.metadata().file_metadata();
    let about = metadata.key_value_metadata().expect("what it is about");
    assert!(about.contains(&KeyValue::new("length".to_owned(), "m".to_owned())));
    let names = metadata
        .schema_descr()
        .columns()
        .iter()
        .map(|column| column.name().to_owned());
    assert_eq!(names.collect::<Vec<_>>(), columns);
    let rows = reader.get_row_iter(None).expect("rows");
    let mut count = 0;
    for (number, row) in rows.enumerate() {
        let row = row.expect("a row");
        let [first, second, _] = value(number);
        assert_eq!(row.get_double(0).expect("a number"), first);
        match row.get_double(1) {
            Ok(found) => assert_eq!(found, second),
            Err(_) => assert!(missing(number), "row {number}"),
        }
        assert!(row.get_double(2).is_err(), "row {number}");
        count += 1;
    }
    assert_eq!(count, ROWS);
}

#[test]
fn parquet_has_no_group_without_rows() {
    for count in [0, GROUP, 2 * GROUP] {
        let mut table = Table::create(Vec::new(), ["bump_m"], []).expect("a table");
        for row in 0..count {
            table.row(&[row as f64]).expect("a row");
        }
        let bytes = table.finish().expect("the whole");
        let reader = SerializedFileReader::new(bytes::Bytes::from(bytes)).expect("Parquet");
        let metadata = reader.metadata();
        assert_eq!(metadata.file_metadata().num_rows(), count as i64);
        let groups = metadata.row_groups().iter();
        let rows: Vec<i64> = groups.map(|group| group.num_rows()).collect();
        assert_eq!(rows, vec![GROUP as i64; count / GROUP]);
        assert_eq!(reader.get_row_iter(None).expect("rows").count(), count);
    }
}

/// A writer whose reader has gone.
struct Closed;

impl io::Write for Closed {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// For example `suspension sweep corner.toml --parquet - | head`.
#[test]
fn a_failure_of_the_writer_is_its_own_error() {
    let table = Table::create(Closed, ["bump_m"], []);
    let error = table.and_then(Table::finish).err().expect("an error");
    assert_eq!(error.kind(), io::ErrorKind::BrokenPipe);
    assert_eq!(
        error.to_string(),
        io::Error::from(io::ErrorKind::BrokenPipe).to_string()
    );
}
