//! What overlaps in a drawing, read from its SVG: a reader of the few elements that drawings have.

/// Widths of ASCII letters from the space on in thousandths, DejaVu Sans and DejaVu Sans Bold (tables `hmtx`).
const PLAIN: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636,
    636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295,
    295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838,
    500, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521,
    392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
];
const BOLD: [u16; 95] = [
    348, 456, 521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415, 380, 365, 696, 696, 696, 696, 696,
    696, 696, 696, 696, 696, 400, 400, 838, 838, 838, 580, 1000, 774, 762, 734, 830, 683, 683, 821, 837, 372,
    372, 775, 637, 995, 837, 850, 733, 850, 770, 720, 682, 812, 774, 1103, 771, 724, 725, 457, 365, 457, 838,
    500, 500, 675, 716, 593, 716, 678, 435, 716, 712, 343, 343, 665, 343, 1042, 712, 687, 716, 716, 493, 595,
    478, 712, 652, 924, 645, 652, 582, 712, 365, 712, 838,
];
/// Of the letters: how far they reach above the line they stand on, and below.
const ABOVE: f64 = 0.73;
const BELOW: f64 = 0.22;

type Spot = [f64; 2];

struct Text {
    text: String,
    least: Spot,
    most: Spot,
}

/// A line that is seen, or a filled spot, by the title of its group.
struct Ink {
    of: String,
    points: Vec<Spot>,
    half: f64,
}

/// A sentence for each text that is on another, on a line of a part, or not all in the picture. Lines that lead to names do not count.
pub fn overlaps(svg: &str) -> Vec<String> {
    let (texts, inks, size) = read(svg);
    let outside = |ink: &&Ink| ink.points.iter().any(|at| (0..2).any(|k| at[k] < 0.0 || at[k] > size[k]));
    let mut found: Vec<String> = inks
        .iter()
        .filter(outside)
        .map(|ink| format!("`{}` is drawn outside of the picture", ink.of))
        .collect();
    for (index, text) in texts.iter().enumerate() {
        if (0..2).any(|k| text.least[k] < 0.0 || text.most[k] > size[k]) {
            found.push(format!("`{}` is not all in the picture", text.text));
        }
        for other in &texts[..index] {
            if (0..2).all(|k| text.least[k] < other.most[k] && other.least[k] < text.most[k]) {
                found.push(format!("`{}` is on `{}`", text.text, other.text));
            }
        }
        if let Some(ink) = inks.iter().find(|ink| covers(text, ink)) {
            found.push(format!("`{}` is on what is drawn of `{}`", text.text, ink.of));
        }
    }
    found
}

/// A sentence for each line of groups whose titles begin so that crosses what other groups show.
pub fn crossings(svg: &str, begin: &str) -> Vec<String> {
    let (_, inks, _) = read(svg);
    let mut found = Vec::new();
    for line in inks.iter().filter(|ink| ink.of.starts_with(begin)) {
        // Thin lines lead to the ends of their own.
        let own = format!("to the {}", line.of);
        for other in inks.iter().filter(|other| other.of != line.of && other.of != own) {
            let around = line.half + other.half;
            let touches = |at: Spot| steps(other).any(|to| (at[0] - to[0]).hypot(at[1] - to[1]) < around);
            if are_near(line, other, around) && steps(line).any(touches) {
                found.push(format!("`{}` crosses `{}`", line.of, other.of));
            }
        }
    }
    found
}

/// Whether the boxes around both are so near.
fn are_near(one: &Ink, other: &Ink, around: f64) -> bool {
    let ends = |ink: &Ink, k: usize| {
        let along = ink.points.iter().map(|point| point[k]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)])
    };
    (0..2).all(|k| {
        let ([a, b], [c, d]) = (ends(one, k), ends(other, k));
        a < d + around && c < b + around
    })
}

/// Points along what is seen, half a pixel apart.
fn steps(ink: &Ink) -> impl Iterator<Item = Spot> {
    ink.points.windows(2).flat_map(|ends| {
        let count = ((ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]) / 0.5).ceil().max(1.0);
        (0..=count as usize)
            .map(move |step| [0, 1].map(|k| ends[0][k] + (ends[1][k] - ends[0][k]) * step as f64 / count))
    })
}

/// Between the middles of what two groups show.
pub fn distance(svg: &str, one: &str, other: &str) -> f64 {
    let (_, inks, _) = read(svg);
    let middle = |name: &str| {
        let points: Vec<&Spot> =
            inks.iter().filter(|ink| ink.of == name).flat_map(|ink| &ink.points).collect();
        assert!(!points.is_empty(), "{name} is drawn");
        [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64)
    };
    let (a, b) = (middle(one), middle(other));
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// In small steps along the line.
fn covers(text: &Text, ink: &Ink) -> bool {
    steps(ink).any(|at| (0..2).all(|k| at[k] + ink.half > text.least[k] && at[k] - ink.half < text.most[k]))
}

fn read(svg: &str) -> (Vec<Text>, Vec<Ink>, Spot) {
    let (mut texts, mut inks, mut title, mut size) = (Vec::new(), Vec::new(), String::new(), [0.0; 2]);
    for piece in svg.split('<').skip(1) {
        let (tag, content) = piece.split_once('>').expect("a tag ends");
        let word = tag.split([' ', '/']).next().unwrap_or_default();
        let number = |name: &str| attribute(tag, name).and_then(|text| text.parse::<f64>().ok());
        match word {
            "svg" => size = ["width", "height"].map(|name| number(name).expect(name)),
            "title" => title = content.to_string(),
            "text" => texts.push(text(tag, content, number("font-size").unwrap_or(12.0))),
            "path" | "circle" if attribute(tag, "class") != Some("lead") => {
                let Some(half) = half(tag) else { continue };
                let outlines = if word == "path" {
                    path(attribute(tag, "d").expect("a path"))
                } else {
                    vec![circle(tag)]
                };
                inks.extend(outlines.into_iter().map(|points| Ink { of: title.clone(), points, half }));
            }
            _ => {}
        }
    }
    (texts, inks, size)
}

/// Half the width of what is seen; nothing of paper and tints.
fn half(tag: &str) -> Option<f64> {
    let colour = |name: &str| attribute(tag, name).filter(|it| *it != "none" && !it.starts_with("var("));
    let is_faint = ["opacity", "fill-opacity"].iter().any(|name| attribute(tag, name) == Some("0.07"));
    let width = attribute(tag, "stroke-width").and_then(|it| it.parse::<f64>().ok());
    match (colour("stroke"), colour("fill")) {
        _ if is_faint => None,
        (Some(_), _) => Some(width.unwrap_or(1.0) / 2.0),
        (None, Some(_)) => Some(0.0),
        (None, None) => None,
    }
}

fn text(tag: &str, content: &str, size: f64) -> Text {
    let number = |name: &str| attribute(tag, name).and_then(|it| it.parse::<f64>().ok()).expect(name);
    let widths = if attribute(tag, "font-weight").is_some() { &BOLD } else { &PLAIN };
    let letter = |c: char| widths.get((c as usize).wrapping_sub(32)).copied().unwrap_or(1000);
    let width = content.chars().map(|c| f64::from(letter(c))).sum::<f64>() * size / 1000.0;
    let (x, y) = (number("x"), number("y"));
    assert_eq!(attribute(tag, "text-anchor"), Some("middle"), "{tag}");
    Text {
        text: content.to_string(),
        least: [x - width / 2.0, y - ABOVE * size],
        most: [x + width / 2.0, y + BELOW * size],
    }
}

/// `M…L…Z`, more than once.
fn path(data: &str) -> Vec<Vec<Spot>> {
    let mut outlines: Vec<Vec<Spot>> = Vec::new();
    for part in data.split('M').skip(1) {
        let spot = |text: &str| {
            let mut numbers = text.split(' ').map(|number| number.parse().expect("a number"));
            [0, 1].map(|_| numbers.next().expect("two numbers"))
        };
        let mut points: Vec<Spot> = part.trim_end_matches('Z').split('L').map(spot).collect();
        if part.ends_with('Z') {
            points.push(points[0]);
        }
        outlines.push(points);
    }
    outlines
}

fn circle(tag: &str) -> Vec<Spot> {
    let [x, y, r] =
        ["cx", "cy", "r"].map(|name| attribute(tag, name).and_then(|it| it.parse::<f64>().ok()).expect(name));
    (0..=48)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 48.0)
        .map(|a| [x + r * a.cos(), y + r * a.sin()])
        .collect()
}

fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
}
