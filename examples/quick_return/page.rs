//! One HTML page that needs nothing from outside: style and script are in it.
//!
//! A page is written from top to bottom; its texts are HTML. Knows nothing of mechanisms.

use crate::tables::Table;
use std::fmt::Write;

const STYLE: &str = include_str!("page.css");

/// A page that is being written.
pub struct Page {
    title: String,
    body: String,
    scripts: Vec<&'static str>,
}

impl Page {
    /// A page with a title and a sentence that says what it is about.
    pub fn new(title: &str, lead: &str) -> Page {
        let body = format!("<h1>{title}</h1>\n<p class=\"lead\">{lead}</p>\n");
        Page { title: title.to_string(), body, scripts: Vec::new() }
    }

    /// A section's heading.
    pub fn heading(&mut self, text: &str) {
        let _ = writeln!(self.body, "<h2>{text}</h2>");
    }

    /// A paragraph.
    pub fn paragraph(&mut self, html: &str) {
        let _ = writeln!(self.body, "<p>{html}</p>");
    }

    /// Numbers that should be seen first, each with what it is.
    pub fn facts(&mut self, facts: &[(String, &str)]) {
        let facts: String = facts
            .iter()
            .map(|(value, what)| format!("<div><b>{value}</b><span>{what}</span></div>"))
            .collect();
        let _ = writeln!(self.body, "<div class=\"facts\">{facts}</div>");
    }

    /// A table.
    pub fn table(&mut self, table: &Table) {
        self.body.push_str(&table.html());
    }

    /// Figures side by side, where there is room.
    pub fn figures(&mut self, figures: &[String]) {
        let _ = writeln!(self.body, "<div class=\"plots\">{}</div>", figures.concat());
    }

    /// Any other element.
    pub fn element(&mut self, html: &str) {
        let _ = writeln!(self.body, "{html}");
    }

    /// A script that elements of the page need; it stands there once, however often it is asked for.
    pub fn script(&mut self, script: &'static str) {
        if !self.scripts.contains(&script) {
            self.scripts.push(script);
        }
    }

    /// The page, with its last words.
    pub fn finish(self, footer: &str) -> String {
        let Page { title, body, scripts } = self;
        let scripts: String = scripts.iter().map(|script| format!("<script>\n{script}</script>\n")).collect();
        format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n{body}\
             <footer>{footer}</footer>\n</main>\n{scripts}</body>\n</html>\n"
        )
    }
}
