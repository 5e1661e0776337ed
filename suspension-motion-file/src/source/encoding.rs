//! The encodings of input files.

use std::string::FromUtf8Error;

/// The characters of Windows-1252 from 0x80 to 0x9f; those of five bytes are controls, which no text has.
const FROM_0X80: &str = "€\u{81}‚ƒ„…†‡ˆ‰Š‹Œ\u{8d}Ž\u{8f}\u{90}‘’“”•–—˜™š›œ\u{9d}žŸ";

/// Returns the text of a file in UTF-8, or in UTF-16 with a byte order mark; that of a table may be in Windows-1252 too.
///
/// # Errors
///
/// Where the bytes are not UTF-8, if they are no text in the other encodings either.
pub(super) fn text(bytes: Vec<u8>, is_table: bool) -> Result<String, FromUtf8Error> {
    if let Some(text) = from_utf_16(&bytes) {
        return Ok(text);
    }
    String::from_utf8(bytes).or_else(|error| {
        let table = is_table.then(|| from_windows_1252(error.as_bytes()));
        table.flatten().ok_or(error)
    })
}

/// Returns a text in UTF-16 with a byte order mark, as spreadsheet programs save `Unicode text`; `None` for other bytes.
fn from_utf_16(bytes: &[u8]) -> Option<String> {
    let unit = match bytes {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        _ => return None,
    };
    let (pairs, []) = bytes.as_chunks() else {
        return None;
    };
    let units: Vec<u16> = pairs.iter().skip(1).map(|pair| unit(*pair)).collect();
    String::from_utf16(&units).ok()
}

/// Returns a text in Windows-1252, as spreadsheet programs save `CSV` in western Europe; `None` for bytes that no text has.
fn from_windows_1252(bytes: &[u8]) -> Option<String> {
    let character = |byte: &u8| match byte {
        0x80..=0x9f => FROM_0X80.chars().nth(usize::from(byte - 0x80)),
        _ => Some(char::from(*byte)),
    };
    let is_of_text = |c: &char| !c.is_control() || c.is_ascii_whitespace();
    let characters = bytes.iter().map(|byte| character(byte).filter(is_of_text));
    characters.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf_16_of_either_order_is_read() {
        let text = "Stra\u{df}e \u{1f697}";
        let units: Vec<u16> = "\u{feff}"
            .encode_utf16()
            .chain(text.encode_utf16())
            .collect();
        for bytes in [u16::to_le_bytes, u16::to_be_bytes] {
            let encoded: Vec<u8> = units.iter().flat_map(|unit| bytes(*unit)).collect();
            assert_eq!(from_utf_16(&encoded).as_deref(), Some(text));
        }
    }

    /// A byte or half a character is missing at the end.
    #[test]
    fn other_bytes_are_not_utf_16() {
        for bytes in [
            b"\xff\xfea\0b".as_slice(),
            b"\xff\xfe\x3d\xd8",
            b"\xef\xbb\xbfa",
            b"",
        ] {
            assert_eq!(from_utf_16(bytes), None);
        }
    }

    #[test]
    fn windows_1252_is_read_and_bytes_of_no_text_are_not() {
        let read = |bytes| from_windows_1252(bytes);
        let text = read(b"L\xe4nge;\x9612,5\r\n\t\x80 \x9f \xb0 \xff");
        assert_eq!(text.as_deref(), Some("Länge;–12,5\r\n\t€ Ÿ ° ÿ"));
        for bytes in [b"\x7fELF\x02\xff".as_slice(), b"a\0\xe4", b"\x81", b"\x9d"] {
            assert_eq!(read(bytes), None, "{bytes:?}");
        }
    }
}
