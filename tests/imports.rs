//! No files of a crate import each other in a cycle. A re-exported item is imported from the module that declares it. A file
//! may use the declarations of its parent module, of which it is a part.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

const CRATES: [&str; 13] = [
    ".",
    "benches/laboratory",
    "benches/ladder",
    "examples/car",
    "suspension-c",
    "suspension-core",
    "suspension-lanes",
    "suspension-listing",
    "suspension-macros",
    "suspension-mechanism",
    "suspension-motion-file",
    "suspension-runtime",
    "suspension-tables",
];

/// The names of a module from the root of its crate.
type Module = Vec<String>;

/// The declarations and imports of a file.
#[derive(Default)]
struct File {
    /// The paths that are imported, and those that are imported and exported.
    imported: Vec<String>,
    exported: Vec<String>,
    /// The other paths.
    inline: Vec<String>,
}

impl File {
    fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path).expect("a source");
        let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
        let lines = code
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let code = lines.collect::<Vec<_>>().join("\n");
        let mut file = Self::default();
        file.inline.extend(paths(&code));
        for (at, _) in code.match_indices("use ") {
            let before = code[..at].rsplit('\n').next().unwrap_or_default().trim();
            if before.is_empty() || before.starts_with("pub") {
                let tree = code[at + 4..].split(';').next().unwrap_or_default();
                let tree: String = tree.split_whitespace().collect();
                let list = if before.is_empty() {
                    &mut file.imported
                } else {
                    &mut file.exported
                };
                expand("", &tree, list);
            }
        }
        file
    }
}

/// The paths of a tree of imports.
fn expand(before: &str, tree: &str, paths: &mut Vec<String>) {
    let Some((start, rest)) = tree.split_once('{') else {
        paths.push(format!("{before}{tree}"));
        return;
    };
    let (mut depth, mut from) = (0, 0);
    let inside = rest.strip_suffix('}').unwrap_or(rest);
    for (at, letter) in inside.char_indices().chain([(inside.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                expand(&format!("{before}{start}"), &inside[from..at], paths);
                from = at + 1;
            }
            _ => {}
        }
    }
}

/// All words with `::` between them.
fn paths(code: &str) -> impl Iterator<Item = String> {
    let words = code.split(|letter: char| !letter.is_alphanumeric() && !"_:".contains(letter));
    let words = words.map(|word| word.trim_matches(':'));
    words.filter(|word| word.contains("::")).map(str::to_owned)
}

/// The files of a crate.
struct Crate(BTreeMap<Module, File>);

impl Crate {
    fn read(folder: &Path) -> Self {
        let mut files = BTreeMap::new();
        collect(folder, &[], &mut files);
        Self(files)
    }

    /// Returns the module to which a path leads from another, with the remaining name; `None` if it leads to another crate.
    fn led(&self, from: &Module, path: &str) -> Option<(Module, Option<String>)> {
        let mut names = path.split("::").peekable();
        let mut at = match *names.peek()? {
            "crate" => Module::new(),
            "self" | "super" => from.clone(),
            child => {
                let child = [from.as_slice(), &[child.to_owned()]].concat();
                self.0.contains_key(&child).then(|| from.clone())?
            }
        };
        while let Some(name) = names.next_if(|name| ["crate", "self", "super"].contains(name)) {
            if name == "super" {
                at.pop();
            }
        }
        while let Some(name) = names.peek() {
            let child = [at.as_slice(), &[(*name).to_owned()]].concat();
            if !self.0.contains_key(&child) {
                break;
            }
            at = child;
            names.next();
        }
        Some((at, names.next().map(str::to_owned)))
    }

    /// Returns the module that declares the item of a path; `None` for a path to a module itself.
    fn declares(&self, from: &Module, path: &str) -> Option<Module> {
        let (mut at, Some(name)) = self.led(from, path)? else {
            return None;
        };
        // Through re-exports of other modules.
        for _ in 0..4 {
            let exported = self.0.get(&at)?.exported.iter();
            let mut led = exported.filter_map(|path| self.led(&at, path));
            match led.find(|(_, of)| of.as_ref() == Some(&name)) {
                Some((next, _)) if next != at => at = next,
                _ => break,
            }
        }
        Some(at)
    }

    /// Returns the modules from which a module imports, without its parents.
    fn imports(&self, module: &Module) -> BTreeSet<Module> {
        let file = &self.0[module];
        // Imported modules are the beginnings of other paths.
        let modules: BTreeMap<&str, &String> = (file.imported.iter())
            .filter(|path| matches!(self.led(module, path), Some((_, None))))
            .filter_map(|path| Some((path.rsplit("::").next()?, path)))
            .collect();
        let inline = file.inline.iter().map(|path| {
            let (first, rest) = path.split_once("::").unwrap_or((path, ""));
            match modules.get(first) {
                Some(imported) => format!("{imported}::{rest}"),
                None => path.clone(),
            }
        });
        let paths = file.imported.iter().cloned().chain(inline);
        let declares = paths.filter_map(|path| self.declares(module, &path));
        declares
            .filter(|other| !module.starts_with(other))
            .collect()
    }

    /// The modules that import each other, directly or by way of others.
    fn circles(&self) -> Vec<String> {
        let imports: BTreeMap<&Module, BTreeSet<Module>> = self
            .0
            .keys()
            .map(|module| (module, self.imports(module)))
            .collect();
        let reached = |from: &Module| {
            let (mut reached, mut next) = (BTreeSet::new(), vec![from.clone()]);
            while let Some(module) = next.pop() {
                let others = imports[&module].iter();
                next.extend(
                    others
                        .filter(|other| reached.insert((*other).clone()))
                        .cloned(),
                );
            }
            reached
        };
        let reached: BTreeMap<&Module, BTreeSet<Module>> = self
            .0
            .keys()
            .map(|module| (module, reached(module)))
            .collect();
        let arrows = imports.iter().flat_map(|(from, others)| {
            let back = others.iter().filter(|other| reached[other].contains(*from));
            back.map(|other| format!("{} -> {}", from.join("::"), other.join("::")))
        });
        arrows.collect()
    }
}

fn collect(folder: &Path, within: &[String], files: &mut BTreeMap<Module, File>) {
    for entry in std::fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy();
        let module = [within, &[name.to_string()]].concat();
        if path.is_dir() {
            collect(&path, &module, files);
        } else if path.extension().is_some_and(|ending| ending == "rs") && name != "main" {
            let module = if name == "lib" {
                within.to_vec()
            } else {
                module
            };
            files.insert(module, File::read(&path));
        }
    }
}

#[test]
fn no_files_import_each_other_in_a_cycle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut arrows = Vec::new();
    for of in CRATES {
        let files = Crate::read(&root.join(of).join("src"));
        let imports: usize = files
            .0
            .keys()
            .map(|module| files.imports(module).len())
            .sum();
        assert!(files.0.len() == 1 || imports > 0, "{of}: nothing was read");
        arrows.extend(files.circles().iter().map(|arrow| format!("{of}: {arrow}")));
    }
    assert!(arrows.is_empty(), "{arrows:#?}");
}

#[test]
fn an_import_cycle_through_exports_or_paths_in_code_is_found() {
    let file = |imported: &[&str], exported: &[&str], inline: &[&str]| {
        let owned = |list: &[&str]| list.iter().map(|path| (*path).to_owned()).collect();
        File {
            imported: owned(imported),
            exported: owned(exported),
            inline: owned(inline),
        }
    };
    let module = |path: &str| path.split("::").map(str::to_owned).collect::<Module>();
    let with = |inline: &[&str]| {
        Crate(BTreeMap::from([
            (Module::new(), file(&[], &["a::Front"], &[])),
            (
                module("a"),
                file(&["crate::b", "std::fmt"], &["inner::Front"], &["b::back"]),
            ),
            (module("a::inner"), file(&[], &[], inline)),
            (module("b"), file(&["crate::Front"], &[], &[])),
        ]))
    };
    assert_eq!(with(&[]).circles(), Vec::<String>::new());
    let circle = ["a::inner -> b", "b -> a::inner"];
    assert_eq!(with(&["crate::b::back"]).circles(), circle);
}
