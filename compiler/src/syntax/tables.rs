//! `table lift(angle [deg]) [mm] = …, periodic;`: a head as the table is called, what it holds, and how it goes on between.

use super::definition::{ColumnTerm, FileTerm, Label, TableData, TableTerm, WrittenUnit};
use super::parser::{Parsed, Parser};
use super::token::{Cursor, Kind};
use crate::forms::{Interpolation, Outside};
use crate::messages;
use proc_macro2::Delimiter;

const DATA: &str = "`[(x, y), …]`, `file(\"…\")` or `grid(…)`";

impl Parser<'_> {
    /// `name(argument [unit]) [unit] = data, word, …;`
    pub fn table(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the table")?;
        let name = self.own(name);
        let arguments = self.table_arguments(c, &name)?;
        let unit = self.unit(c)?;
        self.punct(c, '=')?;
        let data = self.table_data(c)?;
        let mut table =
            TableTerm { name, arguments, unit, data, kind: None, outside: None, columns: None, read: None };
        while c.eat_punct(',') {
            self.table_word(c, &mut table)?;
        }
        self.semicolon(c)?;
        self.definition.tables.push(table);
        Ok(())
    }

    fn table_arguments(&mut self, c: &mut Cursor, name: &Label) -> Parsed<Vec<(Label, Option<WrittenUnit>)>> {
        if c.inside(Delimiter::Parenthesis).is_none() {
            return self.fail(c.region(), messages::table_without_arguments(&name.text));
        }
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let whole = inside.whole();
        let mut arguments = Vec::new();
        while !inside.is_done() {
            let argument = self.word(&mut inside, "the name of an argument")?;
            let unit = self.unit(&mut inside)?;
            arguments.push((argument, unit));
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        match arguments.len() {
            1 | 2 => Ok(arguments),
            count => self.fail(whole, messages::table_of_arguments(&name.text, count)),
        }
    }

    fn table_data(&mut self, c: &mut Cursor) -> Parsed<TableData> {
        if let Some(mut inside) = c.enter(Delimiter::Bracket) {
            let mut points = Vec::new();
            while !inside.is_done() {
                let mut pair = self.group(&mut inside, Delimiter::Parenthesis)?;
                let x = self.expression(&mut pair)?;
                self.punct(&mut pair, ',')?;
                let y = self.expression(&mut pair)?;
                self.end(&pair, "`)` after two numbers")?;
                points.push([x, y]);
                if !inside.is_done() && !inside.eat_punct(',') {
                    return self.expected(&inside, "`,` or `]`");
                }
            }
            return Ok(TableData::Points(points));
        }
        match c.word() {
            Some("file") => self.table_file(c),
            Some("grid") => self.table_grid(c),
            _ => self.expected(c, DATA),
        }
    }

    /// `file("cam.csv", skip = 2)`
    fn table_file(&mut self, c: &mut Cursor) -> Parsed<TableData> {
        c.advance();
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = inside.region();
        let Some(name) = file_name(&mut inside) else {
            return self.fail(region, messages::table_file_without_name());
        };
        let mut skip = 0;
        if inside.eat_punct(',') {
            if !inside.eat_word("skip") {
                return self.expected(&inside, "`skip`, how many lines stand before those of the table");
            }
            self.punct(&mut inside, '=')?;
            let term = self.expression(&mut inside)?;
            let lines = self.integer(&term)?;
            skip = match usize::try_from(lines) {
                Ok(lines) => lines,
                Err(_) => return self.fail(term.region, messages::negative_skip(lines)),
            };
        }
        self.end(&inside, "`)`")?;
        Ok(TableData::File(FileTerm { name, region, skip }))
    }

    /// `grid((x, …), (y, …), [(z, …), …])`, a row of z for each y.
    fn table_grid(&mut self, c: &mut Cursor) -> Parsed<TableData> {
        c.advance();
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let first = self.table_row(&mut inside)?;
        self.punct(&mut inside, ',')?;
        let second = self.table_row(&mut inside)?;
        self.punct(&mut inside, ',')?;
        let mut listed = self.group(&mut inside, Delimiter::Bracket)?;
        let mut rows = Vec::new();
        while !listed.is_done() {
            let region = listed.region();
            rows.push((self.table_row(&mut listed)?, region));
            if !listed.is_done() && !listed.eat_punct(',') {
                return self.expected(&listed, "`,` or `]`");
            }
        }
        inside.eat_punct(',');
        self.end(&inside, "`)`")?;
        Ok(TableData::Grid { axes: [first, second], rows })
    }

    fn table_row(&mut self, c: &mut Cursor) -> Parsed<Vec<super::definition::Term>> {
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let mut row = Vec::new();
        while !inside.is_done() {
            row.push(self.expression(&mut inside)?);
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        Ok(row)
    }

    /// `periodic`, `outside = hold` or `columns = (1, lift)`.
    fn table_word(&mut self, c: &mut Cursor, table: &mut TableTerm) -> Parsed<()> {
        let word = self.word(c, "how the table goes on, such as `monotone`")?;
        let twice = match word.text.as_str() {
            "outside" => table.outside.map(|(_, first)| first),
            "columns" => table.columns.as_ref().map(|columns| columns[0].region),
            _ => table.kind.map(|(_, first)| first),
        };
        if let Some(first) = twice {
            let (message, note) =
                (messages::table_word_twice(&table.name.text), messages::first_here(&word.text));
            self.diagnostics.conflict(word.region, message, first, note);
            return Err(super::parser::Failed);
        }
        match word.text.as_str() {
            "outside" => {
                self.punct(c, '=')?;
                let how = self.word(c, "`linear` or `hold`")?;
                let known = Outside::ALL.into_iter().find(|known| known.word() == how.text);
                let Some(known) = known else {
                    return self.fail(how.region, messages::unknown_outside(&how.text));
                };
                table.outside = Some((known, how.region));
            }
            "columns" => {
                self.punct(c, '=')?;
                let mut inside = self.group(c, Delimiter::Parenthesis)?;
                let first = self.table_column(&mut inside)?;
                self.punct(&mut inside, ',')?;
                let second = self.table_column(&mut inside)?;
                self.end(&inside, "`)` after two columns")?;
                if !matches!(table.data, TableData::File(_)) {
                    return self.fail(word.region, messages::columns_without_file());
                }
                table.columns = Some([first, second]);
            }
            text => match Interpolation::ALL.into_iter().find(|known| known.word() == text) {
                Some(kind) => table.kind = Some((kind, word.region)),
                None => {
                    let known = Interpolation::ALL.map(Interpolation::word);
                    return self.fail(word.region, messages::unknown_interpolation(text, &known));
                }
            },
        }
        Ok(())
    }

    /// The number of a column from 1, or its name.
    fn table_column(&mut self, c: &mut Cursor) -> Parsed<ColumnTerm> {
        let region = c.region();
        let text = match c.peek().map(|token| &token.kind) {
            Some(Kind::Word(text) | Kind::Number(text)) => text.clone(),
            Some(Kind::Text(text)) => text.trim_matches('"').to_string(),
            _ => return self.expected(c, "the name of a column, or its number"),
        };
        c.advance();
        Ok(ColumnTerm { text, region })
    }
}

/// `"cam.csv"`
pub(super) fn file_name(c: &mut Cursor) -> Option<String> {
    let token = c.advance().filter(|token| matches!(token.kind, Kind::Text(_)))?;
    let text = syn::parse2::<syn::LitStr>(token.original.clone().into()).ok();
    text.map(|text| text.value()).filter(|name| !name.is_empty())
}
