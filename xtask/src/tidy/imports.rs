//! What a file of a crate imports: the places that its `use` declarations and paths lead to.

/// The way from a crate's source folder, which is the first part, to a module or to a name in it.
pub type Place = Vec<String>;

/// The place of the module in a file of a crate.
pub fn place(path: &str) -> Option<Place> {
    let (folder, module) = path.strip_suffix(".rs")?.split_at(path.find("src/")? + "src/".len());
    let parts = module.split('/').filter(|part| !["lib", "main", "mod"].contains(part));
    Some([folder].into_iter().chain(parts).map(str::to_owned).collect())
}

/// The `use` declarations that stand at the start of a line, and the rest of the code.
pub fn split_uses(code: &str) -> (Vec<&str>, String) {
    let (mut uses, mut rest) = (Vec::new(), String::new());
    for item in code.split(';') {
        let declared = item.rsplit_once("use ").filter(|(before, _)| {
            let line = before.rsplit('\n').next().unwrap_or_default();
            line.is_empty() || line.starts_with("pub")
        });
        uses.extend(declared.map(|(_, tree)| tree));
        rest += &format!("{};", declared.map_or(item, |(before, _)| before));
    }
    (uses, rest)
}

/// Each name that a `use` declaration brings, groups such as `crate::{a::B, c}` included, and the place that it comes from.
pub fn brought(tree: &str, base: &[String]) -> Vec<(String, Place)> {
    let Some((path, group)) = tree.split_once('{') else {
        let (path, alias) = tree.split_once(" as ").unwrap_or((tree, ""));
        let place = follow(base, path);
        let name = if alias.is_empty() { place[place.len() - 1].clone() } else { alias.trim().to_owned() };
        return vec![(name, place)];
    };
    let base = follow(base, path);
    let mut depth = 0;
    let is_end = |c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth < 0 || depth == 0 && c == ','
    };
    group.split(is_end).filter(|one| !one.trim().is_empty()).flat_map(|one| brought(one, &base)).collect()
}

/// Where a path leads from a module, or from the path before a group.
pub fn follow(base: &[String], path: &str) -> Place {
    let mut place = base.to_vec();
    for part in path.split("::").map(str::trim) {
        match part {
            "crate" | "slipmode" => place.truncate(1),
            "super" => place.truncate(place.len().max(2) - 1),
            "self" | "" => {}
            name => place.push(name.to_owned()),
        }
    }
    place
}
