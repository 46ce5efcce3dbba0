//! Paths as text: in JSON, in a message, and in a command that a shell is to run.

use std::path::Path;

use slipmode::scene::visible;

/// A path as JSON has it, where what is not UTF-8 is replaced.
pub fn json_path(path: &Path) -> String {
    path.display().to_string()
}

/// A path as messages have it, on one line.
pub fn shown_path(path: &Path) -> String {
    visible(&json_path(path))
}

/// A path as one word of a command, never taken as an option; `-` stays.
pub fn word_of(path: &Path) -> String {
    let text = shown_path(path);
    quoted(&if text.starts_with('-') && text != "-" { format!("./{text}") } else { text })
}

/// A text that the shell takes as it is.
pub fn quoted(text: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/._-".contains(&byte);
    let is_word = !text.is_empty() && text.bytes().all(is_plain);
    if is_word { text.to_string() } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_one_word_whatever_it_holds() {
        for (path, wanted) in [
            ("/a/b-c_d.toml", "/a/b-c_d.toml"),
            ("/a b/$HOME", "'/a b/$HOME'"),
            ("it's", "'it'\\''s'"),
            ("-pp", "./-pp"),
            ("- a", "'./- a'"),
            ("-", "-"),
            ("", "''"),
        ] {
            assert_eq!(word_of(Path::new(path)), wanted);
        }
    }
}
