//! The encodings of input files.

/// Returns a text in UTF-16 with a byte order mark, as spreadsheet programs save `Unicode text`, in UTF-8; other bytes as they are.
pub(crate) fn in_utf8(bytes: Vec<u8>) -> Vec<u8> {
    let unit = match bytes[..] {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        _ => return bytes,
    };
    let (pairs, []) = bytes.as_chunks() else {
        return bytes;
    };
    let units: Vec<u16> = pairs.iter().skip(1).map(|pair| unit(*pair)).collect();
    String::from_utf16(&units).map_or(bytes, String::into_bytes)
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
            assert_eq!(in_utf8(encoded), text.as_bytes());
        }
    }

    /// A byte or half a character is missing at the end.
    #[test]
    fn other_bytes_stay() {
        for bytes in [
            b"\xff\xfea\0b".as_slice(),
            b"\xff\xfe\x3d\xd8",
            b"\xef\xbb\xbfa",
            b"",
        ] {
            assert_eq!(in_utf8(bytes.to_vec()), bytes);
        }
    }
}
