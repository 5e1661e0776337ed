//! The spelling of Rust's names and types in C.

use core::fmt::{self, Display, Formatter, Write};

use crate::describe::Interface;

/// Writes `PointRates` as `point_rates`.
pub(super) struct Snake<'a>(pub(super) &'a str);

impl Display for Snake<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (index, letter) in self.0.char_indices() {
            if letter.is_ascii_uppercase() && index > 0 {
                f.write_char('_')?;
            }
            f.write_char(letter.to_ascii_lowercase())?;
        }
        Ok(())
    }
}

/// Writes `PointRates` and `point_rates` as `POINT_RATES`.
pub(super) struct Upper<'a>(pub(super) &'a str);

impl Display for Upper<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut last_is_lower = false;
        for letter in self.0.chars() {
            if letter.is_ascii_uppercase() && last_is_lower {
                f.write_char('_')?;
            }
            f.write_char(letter.to_ascii_uppercase())?;
            last_is_lower = letter.is_ascii_lowercase();
        }
        Ok(())
    }
}

/// Writes a line of a comment so that it does not end the comment.
pub(super) struct Commented<'a>(pub(super) &'a str);

impl Display for Commented<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut parts = self.0.split("*/");
        f.write_str(parts.next().unwrap_or_default())?;
        parts.try_for_each(|part| write!(f, "* /{part}"))
    }
}

/// Writes a name of the listing. A keyword of C or C++ gets an underscore appended, and so does a keyword
/// that already ends with underscores, so that names stay different.
pub(super) struct Field<'a>(pub(super) &'a str);

impl Display for Field<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let name = self.0.trim_start_matches("r#");
        let own = name.trim_end_matches('_');
        let is_kept = KEPT.split(' ').any(|kept| kept == own);
        let mark = if is_kept { "_" } else { "" };
        write!(f, "{name}{mark}")
    }
}

/// Keywords of C23 and C++23 that do not begin with an underscore: Rust allows some as names, and the
/// others after `r#`.
const KEPT: &str = "\
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class co_await \
    co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete do \
    double dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable namespace \
    new noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast requires restrict \
    return short signed sizeof static static_assert static_cast struct switch template this thread_local throw true try \
    typedef typeid typename typeof typeof_unqual union unsigned using virtual void volatile wchar_t while xor";

/// The name of a struct.
struct TypeName<'a> {
    interface: &'a Interface,
    name: &'a str,
}

/// The name of the type to which a pointer points: a number type or a struct.
struct Pointee<'a>(TypeName<'a>);

impl Display for Pointee<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.0.interface.type_of(self.0.name) {
            Ok(plain) => f.write_str(plain.trim_end()),
            Err(_) => self.0.fmt(f),
        }
    }
}

impl Display for TypeName<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { interface, name } = self;
        let mut own = interface.structures.iter().copied().flatten();
        if own.any(|structure| structure.name == *name) {
            write!(f, "{}_{}", interface.prefix, Snake(name))
        } else {
            write!(f, "susp_{}_{}", interface.number, Snake(name))
        }
    }
}

impl Interface {
    /// Returns the name of a struct in C.
    pub fn type_name<'a>(&'a self, name: &'a str) -> impl Display {
        TypeName {
            interface: self,
            name,
        }
    }

    /// Returns the name in C of the type to which a pointer points.
    pub(super) fn pointee<'a>(&'a self, name: &'a str) -> impl Display {
        Pointee(TypeName {
            interface: self,
            name,
        })
    }

    pub(super) fn number_type(&self) -> &'static str {
        if self.number == "f32" {
            "float"
        } else {
            "double"
        }
    }

    /// Returns a type that is not a struct, followed by the blank or the star before a name.
    pub(super) fn type_of(&self, kind: &str) -> Result<&'static str, fmt::Error> {
        Ok(match kind {
            "Number" | "T" if self.number == "f32" => "float ",
            "Number" | "T" => "double ",
            "*const T" if self.number == "f32" => "const float *",
            "*const T" => "const double *",
            "usize" => "size_t ",
            "Char" => "char ",
            "Kind" => "susp_kind ",
            "u32" => "uint32_t ",
            "Status" => "susp_status ",
            "Outputs" => "susp_outputs ",
            "Text" => "const char *",
            _ => return Err(fmt::Error),
        })
    }

    /// Writes a member of a struct.
    pub(super) fn declare(&self, f: &mut Formatter<'_>, kind: &str, name: &str) -> fmt::Result {
        let array = kind
            .strip_prefix('[')
            .and_then(|rest| rest.strip_suffix(']'))
            .and_then(|rest| rest.split_once("; "));
        let of = kind.strip_suffix("<T>");
        match (array, of) {
            (Some((of, count)), _) => writeln!(f, "    {}{name}[{count}];", self.type_of(of)?),
            (_, Some(of)) => writeln!(f, "    {} {name};", self.type_name(of)),
            _ if kind == "*const Mass" => {
                writeln!(f, "    const {} *{name};", self.type_name("Mass"))
            }
            _ => writeln!(f, "    {}{name};", self.type_of(kind)?),
        }
    }
}
