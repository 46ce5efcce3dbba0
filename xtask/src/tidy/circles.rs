//! No circle: files of one crate that import each other, directly or through others, are refused.
//!
//! A file may import the modules that it stands in: what these share with the files inside them is left out.

use super::imports::{Place, brought, follow, place, split_uses};
use super::source::Source;
use crate::prelude::*;

/// For each module its file, and the place of each name that it imports.
type Modules<'a> = BTreeMap<Place, (&'a str, BTreeMap<String, Place>)>;

/// For each file those that it imports, each with one of the names that it takes.
type Arrows<'a> = BTreeMap<&'a str, BTreeMap<&'a str, String>>;

/// Complains about circles until the files that no complaint names are in none.
pub fn check(sources: &[Source], found: &mut Vec<String>) {
    let mut arrows = arrows(sources);
    while let Some(circle) = circle(&mut arrows) {
        let next = circle.iter().cycle().skip(1);
        let ties = circle.iter().zip(next).map(|(from, to)| format!(" -> {to} (`{}`)", arrows[from][to]));
        found.push(format!("{0}: a circle of imports: {0}{1}", circle[0], ties.collect::<String>()));
        arrows.retain(|file, _| !circle.contains(file));
    }
}

/// One circle. Files from which no import leads into one are removed.
fn circle<'a>(arrows: &mut Arrows<'a>) -> Option<Vec<&'a str>> {
    loop {
        let left: BTreeSet<&str> = arrows.keys().copied().collect();
        arrows.values_mut().for_each(|imported| imported.retain(|file, _| left.contains(file)));
        arrows.retain(|_, imported| !imported.is_empty());
        if arrows.len() == left.len() {
            break;
        }
    }
    // Every file that is left imports another of them: the walk comes back to itself.
    let (mut walk, mut next) = (Vec::new(), *arrows.keys().next()?);
    while !walk.contains(&next) {
        walk.push(next);
        next = arrows[next].keys().next()?;
    }
    Some(walk.split_off(walk.iter().position(|file| *file == next)?))
}

fn arrows<'a>(sources: &'a [Source]) -> Arrows<'a> {
    let (mut modules, mut paths) = (Modules::new(), Vec::new());
    for source in sources {
        let Some(place) = place(&source.path) else { continue };
        let lines = source.lines().filter(|(number, ..)| !source.is_test_line(*number));
        let code: String = lines.map(|(_, code, _)| format!("{code}\n")).collect();
        let (uses, rest) = split_uses(&code);
        let imported: BTreeMap<_, _> = uses.iter().flat_map(|tree| brought(tree, &place)).collect();
        let is_end = |c: char| !c.is_alphanumeric() && c != '_' && c != ':';
        let inline: BTreeSet<&str> = rest.split(is_end).filter(|path| path.contains("::")).collect();
        let inline = inline.into_iter().map(|path| follow(&place, path));
        paths.extend(imported.values().cloned().chain(inline).map(|path| (place.clone(), path)));
        modules.insert(place, (source.path.as_str(), imported));
    }
    let mut arrows = Arrows::new();
    for (from, path) in paths {
        let Some((to, name)) = resolve(&modules, &path) else { continue };
        if !from.starts_with(to) {
            arrows.entry(modules[&from].0).or_default().insert(modules[to].0, name);
        }
    }
    arrows
}

/// The module that holds what a path names, and the name. A module that imports the name hands on to where it comes from.
fn resolve<'m>(modules: &'m Modules, path: &[String]) -> Option<(&'m Place, String)> {
    let length = (1..=path.len()).rev().find(|length| modules.contains_key(&path[..*length]))?;
    let (module, (_, imported)) = modules.get_key_value(&path[..length])?;
    let Some(name) = path.get(length) else { return Some((module, path[length - 1].clone())) };
    match imported.get(name).filter(|from| !path.starts_with(from)) {
        Some(from) => resolve(modules, &[from, &path[length + 1..]].concat()),
        None => Some((module, name.clone())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The complaints about the files of a crate.
    fn complaints(files: &[[&str; 2]]) -> Vec<String> {
        let sources = files.iter().map(|[path, text]| Source::new(&format!("src/{path}"), *text));
        let mut found = Vec::new();
        check(&sources.collect::<Vec<_>>(), &mut found);
        found
    }

    #[test]
    fn imports_one_way_pass_and_a_module_hands_on_what_it_imports() {
        let parent = ["a/mod.rs", "mod b;\nmod c;\npub struct E;\npub use b::{self, B};\npub use c::C as D;"];
        let child = ["a/b.rs", "use super::{D, E};\n#[cfg(test)]\nmod tests { use crate::a::B; }"];
        assert_eq!(complaints(&[parent, child, ["a/c.rs", "use std::fmt;"]]), [""; 0]);
    }

    #[test]
    fn circles_are_refused_with_the_names_that_tie_them() {
        let through_paths =
            [["a.rs", "fn f() { crate::b::g() }"], ["b.rs", "use crate::{a::{F, G as H}, c};"]];
        let tied = "src/a.rs: a circle of imports: src/a.rs -> src/b.rs (`g`) -> src/a.rs (`G`)";
        assert_eq!(complaints(&through_paths), [tied]);
        let handed_on = [
            ["a/mod.rs", "mod b;\nmod c;\npub use b::B;"],
            ["a/b.rs", "use super::c::C;"],
            ["a/c.rs", "use crate::a::B;"],
        ];
        assert_eq!(complaints(&handed_on).len(), 1);
    }
}
