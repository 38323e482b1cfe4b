use crate::*;
#[test]
fn scratch() {
    let dir = std::env::var("UIDIR").unwrap_or("motion".into());
    let mut files: Vec<_> = std::fs::read_dir(format!("{}/../tests/ui/{dir}", env!("CARGO_MANIFEST_DIR")))
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    files.sort();
    for file in files.into_iter().filter(|f| f.extension().is_some_and(|e| e == "rs")) {
        let text = std::fs::read_to_string(&file).unwrap();
        let at = text.find("mechanism! {").unwrap() + "mechanism! {".len();
        let end = text.find("\nfn main").unwrap();
        let end = text[..end].rfind('}').unwrap();
        let tokens = TokenStream::from_str(&text[at..end]).unwrap();
        let t = std::time::Instant::now();
        let found = compile(tokens, None);
        println!("{} {:?}", file.file_stem().unwrap().to_string_lossy(), t.elapsed());
        match found {
            Ok(_) => println!("   OK"),
            Err(e) => println!("   {e}"),
        }
    }
}
