//! What the symbols of loads draw with: arrows, arcs, zigzags, dashpots, spirals.

use super::canvas::{Group, Pen};
use super::shapes::{across, away, ground_line, heading, middle, ring, shifted};
use super::vector::{Point, unit};
use super::view::{Spot, View};

const LINE: f64 = 1.4;

/// A load as it is drawn.
#[derive(Clone, Debug)]
pub struct Effort {
    pub name: String,
    /// What it acts on.
    pub ends: Vec<End>,
    /// Its named arguments in the order of its form, and its law, both with zeros behind.
    pub values: Vec<Point>,
    pub law: Point,
}

/// Where a load acts.
#[derive(Clone, Copy, Debug)]
pub struct End {
    pub at: Point,
    /// Of what turns or travels there; zero where nothing is said of it.
    pub axis: Point,
    pub is_grounded: bool,
}

/// The symbol of a load.
pub struct Symbol<'a> {
    pub effort: &'a Effort,
    pub view: &'a View,
    pub group: Group,
    /// px.
    pub unit: f64,
    /// Where its name goes, and how far away from there; nothing where it is not drawn.
    pub name: Option<(Spot, f64)>,
    /// How far it is drawn beside its ends, px, where others have the same.
    pub aside: f64,
}

impl Symbol<'_> {
    /// An arrow that ends where it acts; one along the view is a point, and one of no length is not there.
    pub fn arrow(&mut self, at: Point, along: Point) {
        let along = unit(along);
        if along == [0.0; 3] {
            return;
        }
        let (at, way, unit) = (self.view.spot(at), self.view.way(along), self.unit);
        let Some(e) = heading([0.0; 2], way) else {
            self.group.circle(at, 1.2 * unit, Pen::SolidLoad);
            self.name = Some((at, 2.0 * unit));
            return;
        };
        let (tail, tip) = (shifted(at, -11.0 * unit, e), shifted(at, -2.0 * unit, e));
        self.group.arrow(tail, tip, Pen::Load(LINE), Pen::SolidLoad);
        self.name = Some((tail, 2.0));
    }

    /// Counter-clockwise about an axis, away from what is below the joint.
    pub fn turn(&mut self, at: Point, about: Point) {
        let about = unit(about);
        if about == [0.0; 3] {
            return;
        }
        let (view, unit) = (self.view, self.unit);
        let start = angle_of_top(view, about);
        let arc = ring(view, at, about, 4.2 * unit, start - 1.9, start + 1.9);
        if let [.., before, end] = arc[..] {
            self.group.path(&arc[..arc.len() - 1], false, Pen::Load(LINE));
            self.group.arrow(before, end, Pen::Load(LINE), Pen::SolidLoad);
        }
        self.name = Some((view.spot(at), 4.4 * unit));
    }

    /// Around an axis.
    pub fn spiral(&mut self, at: Point, about: Point) {
        let (view, unit) = (self.view, self.unit);
        let spiral: Vec<Spot> = (0..40)
            .map(|k| {
                let turn = f64::from(k) / 39.0;
                let radius = (1.8 + 2.0 * turn) * unit;
                ring(view, at, about, radius, 13.0 * turn, 13.0 * turn)[0]
            })
            .collect();
        self.group.path(&spiral, false, Pen::Load(1.1));
        self.name = Some((view.spot(at), 4.0 * unit));
    }

    /// A ring in a ring about the second end, and a line to the first.
    pub fn sleeve(&mut self) {
        let [first, second, ..] = self.effort.ends[..] else { return };
        let [a, b] = [first, second].map(|end| self.view.spot(end.at));
        self.group.line(a, b, Pen::Load(1.1));
        for radius in [1.8, 3.2] {
            self.group.circle(b, radius * self.unit, Pen::Load(1.1));
        }
        self.name = Some((b, 3.8 * self.unit));
    }

    /// From end to end, with eyes between and held where an end is the ground's.
    pub fn line(&mut self) {
        let unit = self.unit;
        let spots: Vec<Spot> = self.effort.ends.iter().map(|end| self.view.spot(end.at)).collect();
        for (spots, ends) in spots.windows(2).zip(self.effort.ends.windows(2)) {
            let (spots, ends) = ([spots[0], spots[1]], [ends[0], ends[1]]);
            held(&mut self.group, ends, spots, unit);
        }
        self.group.path(&spots, false, Pen::Load(1.1));
        let inner = spots.iter().skip(1).take(spots.len().saturating_sub(2));
        inner.for_each(|spot| self.group.circle(*spot, 0.8 * unit, Pen::Load(1.1)));
        if let [a, b, ..] = spots[..] {
            self.name = Some((middle(a, b), 2.0 * unit));
        }
    }

    /// From the first end to the second: a zigzag, a dashpot, or both side by side, held where an end is the ground's.
    pub fn coil(&mut self, is_elastic: bool, is_damped: bool) {
        let [first, second, ..] = self.effort.ends[..] else { return };
        let (group, unit) = (&mut self.group, self.unit);
        let [a, b] = [first, second].map(|end| self.view.spot(end.at));
        held(group, [first, second], [a, b], unit);
        let [a, b] = beside(group, [a, b], self.aside);
        spring(group, a, b, (is_elastic, is_damped), unit);
        self.name = Some((middle(a, b), if is_elastic && is_damped { 3.4 * unit } else { 2.0 * unit }));
    }
}

/// The ends, moved aside across what is between them, with lines that lead there.
fn beside(group: &mut Group, [a, b]: [Spot; 2], aside: f64) -> [Spot; 2] {
    let Some(e) = heading(a, b).filter(|_| aside != 0.0) else { return [a, b] };
    let way = 0.12 * away(a, b);
    [(a, way), (b, -way)].map(|(end, along)| {
        let at = shifted(shifted(end, along, e), aside, [-e[1], e[0]]);
        group.line(end, at, Pen::Load(1.1));
        at
    })
}

/// Lines of the ground across a run, where its ends are the ground's.
fn held(group: &mut Group, [first, second]: [End; 2], [a, b]: [Spot; 2], unit: f64) {
    for (end, from, to) in [(first, b, a), (second, a, b)] {
        if let (true, Some(e)) = (end.is_grounded, heading(from, to)) {
            let across = [-2.6 * unit * e[1], 2.6 * unit * e[0]];
            ground_line(group, shifted(to, -1.0, across), shifted(to, 1.0, across), e, unit);
        }
    }
}

/// In the basis of a ring about an axis, the angle of its highest point in the picture.
pub fn angle_of_top(view: &View, about: Point) -> f64 {
    let [u, v] = across(about).map(|e| view.way(e));
    libm::atan2(-v[1], -u[1])
}

/// A zigzag, a dashpot, or both side by side.
fn spring(group: &mut Group, a: Spot, b: Spot, (elastic, damped): (bool, bool), unit: f64) {
    let Some(e) = heading(a, b) else { return };
    let n = [-e[1], e[0]];
    let size = away(a, b);
    let aside = if elastic && damped { 1.5 * unit } else { 0.0 };
    let at = |share: f64, offset: f64| shifted(shifted(a, share * size, e), offset, n);
    if aside > 0.0 {
        for share in [0.2, 0.8] {
            group.line(at(share, -aside), at(share, aside), Pen::Load(1.1));
        }
        group.line(a, at(0.2, 0.0), Pen::Load(1.1));
        group.line(at(0.8, 0.0), b, Pen::Load(1.1));
    }
    let (from, to) = if aside > 0.0 { (0.2, 0.8) } else { (0.0, 1.0) };
    if elastic {
        let turns = (size / (3.4 * unit)).clamp(4.0, 14.0) as u32;
        let mut path = vec![at(from, -aside)];
        let lead = if aside > 0.0 { 0.04 } else { 0.12 };
        for k in 0..=2 * turns {
            let share = from + lead + (to - from - 2.0 * lead) * f64::from(k) / f64::from(2 * turns);
            let swing = match k {
                0 => 0.0,
                k if k == 2 * turns => 0.0,
                k if k % 2 == 0 => 1.2 * unit,
                _ => -1.2 * unit,
            };
            path.push(at(share, swing - aside));
        }
        path.push(at(to, -aside));
        group.path(&path, false, Pen::Load(1.1));
    }
    if damped {
        let half = 1.1 * unit;
        let (cup, piston) = (from + 0.35 * (to - from), from + 0.55 * (to - from));
        let end = from + 0.75 * (to - from);
        group.line(at(from, aside), at(cup, aside), Pen::Load(1.1));
        let walls =
            [at(end, aside - half), at(cup, aside - half), at(cup, aside + half), at(end, aside + half)];
        group.path(&walls, false, Pen::Load(1.1));
        group.line(at(piston, aside - 0.8 * half), at(piston, aside + 0.8 * half), Pen::Load(1.6));
        group.line(at(piston, aside), at(to, aside), Pen::Load(1.1));
    }
}
