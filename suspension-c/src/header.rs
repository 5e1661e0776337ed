//! The text of headers.

use core::fmt::{self, Display, Formatter};

use crate::describe::{Function, Interface, Shape, Structure};
use crate::of;
use crate::status::{self, Status};

mod naming;

use naming::{Commented, Field, Upper};

/// The rules for every function.
const RULES: &str = " * Suspension kinematics for C. This file declares what all linkages share; include the header of a linkage,
 * such as suspension_five_link_f32.h. Generated from the source of the functions: do not edit.
 *
 * Memory    The caller owns every object: on the stack, in static memory, or anywhere else. Nothing is
 *           allocated, and nothing has to be freed. Objects may be copied by assignment or memcpy. Only
 *           listings from text are on the heap: see suspension_listing.h.
 * Opaque    The content of `words` is private. The function that takes the size of an object must have made
 *           the object before another function uses it; otherwise that function returns SUSP_ERROR_OBJECT
 *           (unless the memory happens to begin with the tag of such an object).
 * Threads   There is no state outside the caller's objects. Calls may run at the same time in any
 *           threads or interrupts as long as none writes an object that another one uses.
 * Pointers  May not be NULL, except `failure` and where the documentation says so. Each is checked for NULL
 *           and for its alignment. Arguments may share memory to which only pointers to const point; no
 *           other memory may overlap.
 * Status    SUSP_OK, or the reason for a refusal. A refused call changes nothing but `*failure`, which is
 *           written only then. The functions named `advance` keep their progress. With
 *           SUSP_ERROR_SMALL_PIVOT a model is made nevertheless.
 * Numbers   Any unit of length, the same throughout; angles in rad, times in s. Functions that make models
 *           or solve report NaN and infinities among the numbers on which their results depend. They do not
 *           examine others, for example rates of the drives in a step for SUSP_POSITION, or the inputs from
 *           which `step_between` and `advance` start, which only sub-steps need. Functions that only read,
 *           transform or evaluate may pass NaN on. Axes of wheels: x forward, y left, z up (ISO 8855).
 * Structs   of named points or numbers are also arrays in the order of their members.
";

/// Returns `suspension.h`, which the headers of linkages include.
pub fn common() -> impl Display {
    Common
}

struct Common;

impl Display for Common {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "/*\n{RULES} */\n")?;
        guarded(f, "susp", &["<stddef.h>", "<stdint.h>"], |f| {
            f.write_str(
                "\n/** The result of a function. */\ntypedef int32_t susp_status;\nenum {\n",
            )?;
            for status in Status::ALL {
                let text = status.text().to_str().map_err(|_| fmt::Error)?;
                let kind = if *status == Status::Ok { "" } else { "ERROR_" };
                let (name, number) = (Upper(status.name()), *status as i32);
                writeln!(f, "    /** {text} */\n    SUSP_{kind}{name} = {number},")?;
            }
            f.write_str(
                "};\n\n/** The rates for which a bounded step solves. */\ntypedef int32_t susp_outputs;\n",
            )?;
            f.write_str("enum { SUSP_POSITION = 0, SUSP_VELOCITY = 1, SUSP_ACCELERATION = 2 };\n")?;
            for interface in [&status::INTERFACE, &of::f32::INTERFACE, &of::f64::INTERFACE] {
                body(f, interface)?;
            }
            Ok(())
        })
    }
}

/// The header of a linkage, which includes `suspension.h`.
impl Display for Interface {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        own(f, self, self.prefix, "")
    }
}

/// Returns `suspension_listing.h`, the header of listings from text.
#[cfg(feature = "listings")]
pub fn listing() -> impl Display {
    ListingHeader
}

#[cfg(feature = "listings")]
struct ListingHeader;

#[cfg(feature = "listings")]
impl Display for ListingHeader {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        use crate::listing::{INTERFACE, KINDS};
        own(f, &INTERFACE, "susp_listing", KINDS)
    }
}

/// Writes a header that begins with types of its own.
fn own(f: &mut Formatter<'_>, interface: &Interface, guard: &str, types: &str) -> fmt::Result {
    f.write_str("/*\n")?;
    for line in interface.docs {
        writeln!(f, " *{}", Commented(line))?;
    }
    if !interface.docs.is_empty() {
        f.write_str(" *\n")?;
    }
    f.write_str(" * suspension.h documents the rules for every function.\n */\n")?;
    guarded(f, guard, &["\"suspension.h\""], |f| {
        f.write_str(types)?;
        body(f, interface)
    })
}

fn guarded(
    f: &mut Formatter<'_>,
    prefix: &str,
    includes: &[&str],
    content: impl FnOnce(&mut Formatter<'_>) -> fmt::Result,
) -> fmt::Result {
    let guard = Upper(prefix);
    write!(f, "#ifndef {guard}_H\n#define {guard}_H\n\n")?;
    for include in includes {
        writeln!(f, "#include {include}")?;
    }
    f.write_str("\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n")?;
    content(f)?;
    f.write_str("\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n")
}

fn body(f: &mut Formatter<'_>, interface: &Interface) -> fmt::Result {
    for structure in interface.structures.iter().copied().flatten() {
        f.write_str("\n")?;
        comment(f, "", structure.docs)?;
        self::structure(f, interface, structure)?;
    }
    for function in interface.functions.iter().copied().flatten() {
        f.write_str("\n")?;
        comment(f, "", function.docs)?;
        self::function(f, interface, function)?;
    }
    Ok(())
}

/// Writes lines of documentation, which begin with the blank that follows `///`.
fn comment(f: &mut Formatter<'_>, indent: &str, lines: &[&str]) -> fmt::Result {
    for (index, line) in lines.iter().enumerate() {
        let opening = if index == 0 { "/**" } else { " *" };
        let closing = if index + 1 == lines.len() { " */" } else { "" };
        writeln!(f, "{indent}{opening}{}{closing}", Commented(line))?;
    }
    Ok(())
}

fn structure(f: &mut Formatter<'_>, interface: &Interface, structure: &Structure) -> fmt::Result {
    let name = interface.type_name(structure.name);
    match structure.shape {
        Shape::Opaque { size, align } => {
            let upper = Upper(interface.prefix);
            let kind = Upper(structure.name);
            let (word, bits) = if align == 8 { (8, 64) } else { (4, 32) };
            writeln!(f, "#define {upper}_{kind}_SIZE {size}")?;
            writeln!(f, "#define {upper}_{kind}_ALIGN {align}")?;
            writeln!(
                f,
                "typedef struct {{\n    uint{bits}_t words[{upper}_{kind}_SIZE / {word}];\n}} {name};"
            )
        }
        Shape::Handle => writeln!(f, "typedef struct {name} {name};"),
        Shape::Named { names, vectors } => {
            let number = interface.number_type();
            let (upper, kind) = (Upper(interface.prefix), Upper(structure.name));
            writeln!(f, "#define {upper}_{kind}_COUNT {}", names.len())?;
            f.write_str("typedef struct {\n")?;
            let extent = if vectors { "[3]" } else { "" };
            for name in names {
                writeln!(f, "    {number} {}{extent};", Field(name))?;
            }
            if names.is_empty() {
                writeln!(f, "    {number} nothing{extent};")?;
            }
            writeln!(f, "}} {name};")
        }
        Shape::Rates(of) => {
            let of = interface.type_name(of);
            writeln!(
                f,
                "typedef struct {{\n    {of} value;\n    /** Per second. */\n    {of} rate;\n    \
                 /** Per second squared. */\n    {of} second_rate;\n}} {name};"
            )
        }
        Shape::Fields(fields) => {
            f.write_str("typedef struct {\n")?;
            for (field, kind, docs) in fields {
                comment(f, "    ", docs)?;
                interface.declare(f, kind, field)?;
            }
            writeln!(f, "}} {name};")
        }
    }
}

fn function(f: &mut Formatter<'_>, interface: &Interface, function: &Function) -> fmt::Result {
    let (prefix, name) = (interface.prefix, function.name);
    write!(
        f,
        "{}{prefix}_{name}(",
        interface.type_of(function.returns)?
    )?;
    for (index, [argument, kind, of]) in function.arguments.iter().enumerate() {
        f.write_str(if index == 0 {
            "\n        "
        } else {
            ",\n        "
        })?;
        let of = interface.pointee(of);
        match *kind {
            "In" => write!(f, "const {of} *{argument}")?,
            "InOut" | "Out" | "Destroy" => write!(f, "{of} *{argument}")?,
            "Create" => write!(f, "{of} **{argument}")?,
            kind => write!(f, "{}{argument}", interface.type_of(kind)?)?,
        }
    }
    f.write_str(");\n")
}
