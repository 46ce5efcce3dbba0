//! Reports: views of strings, templates, Markdown.
