//! The nodes of a body as pictures show them: lines between nodes that lie next to each other, bent as the nodes turn, so many times as much
//! as lets them be seen.
//!
//! The lines are the shortest tree of the nodes (Prim, *Bell System Technical Journal* 36, 1957), so that a boom is one line and a frame its
//! bars. Along a line the displacement u is linear, and across it the cubic that moves and turns with the nodes at both ends; in a file whose
//! nodes never turn it is linear, too.
//!
//! Of u = c + r, shown is c + s r: c is the displacement of the form a + A x nearest to that of the nodes that joints hold, plus what these
//! differ from it, which goes with the inverse square of the distance (Shepard, 1968). So joints stay where they are whatever s is.

use crate::drawing::vector::{Point, along, cross, difference, dot, length, sum};
use crate::modal::{Node, Reduced, eigen};

/// Bodies with more nodes are shown by those that something stands on.
const MOST_NODES: usize = 200;
/// Places along a line, and in all.
const PLACES: usize = 8;
const ALL_PLACES: usize = 240;
/// How far beside a node what turns with it is put, of the extent.
const BESIDE: f64 = 0.1;
/// Of the extent: nodes nearer than this are at one place.
const SAME: f64 = 1e-9;
/// Of the largest extent squared: nodes extend along a line or plane if less is across it.
const FLAT: f64 = 1e-12;

/// A node that a joint holds.
#[derive(Clone, Copy, Debug)]
pub struct Gripped {
    pub node: usize,
    /// Whether its direction is held, too.
    pub turns_with: bool,
}

/// Lines between nodes.
#[derive(Clone, Debug)]
pub struct Net {
    /// How many stations each line has; the first line has the first of them.
    pub lines: Vec<usize>,
    stations: Vec<Station>,
    /// The station of each node.
    nodes: Vec<usize>,
    extent: f64,
}

/// A place that is drawn.
#[derive(Clone, Debug)]
struct Station {
    at: Point,
    /// c and r of each mode.
    held: Vec<Point>,
    away: Vec<Point>,
}

impl Net {
    /// None for a single node, or for too many.
    pub fn new(reduced: &Reduced, gripped: &[Gripped]) -> Option<Self> {
        let nodes = &reduced.nodes;
        let start = end(nodes)?;
        let apart = nodes.iter().map(|node| length(difference(node.at, nodes[start].at)));
        let extent = apart.fold(0.0, f64::max);
        if nodes.len() > MOST_NODES || extent == 0.0 {
            return None;
        }
        let edges = tree(nodes, start);
        let places = (ALL_PLACES / edges.len()).clamp(1, PLACES);
        let turns = nodes.iter().flat_map(|node| &node.turns).any(|turn| *turn != [0.0; 3]);
        let rest: Vec<Rest> =
            (0..reduced.modes()).map(|mode| Rest::new(nodes, gripped, mode, extent)).collect();
        let mut net = Net { lines: Vec::new(), stations: Vec::new(), nodes: vec![0; nodes.len()], extent };
        for (first, second) in edges {
            let ends = [first, second].map(|index| &nodes[index]);
            for k in 0..=places {
                let share = k as f64 / places as f64;
                let at = along(ends[0].at, share, difference(ends[1].at, ends[0].at));
                let moved = (0..reduced.modes()).map(|mode| between(ends, mode, share, turns));
                let held: Vec<Point> = rest.iter().map(|rest| rest.at(at)).collect();
                let away = moved.zip(&held).map(|(moved, held)| difference(moved, *held)).collect();
                net.stations.push(Station { at, held, away });
            }
            net.nodes[second] = net.stations.len() - 1;
            net.nodes[first] = net.stations.len() - 1 - places;
            net.lines.push(places + 1);
        }
        Some(net)
    }

    /// How many stations there are.
    pub fn count(&self) -> usize {
        self.stations.len()
    }

    /// The station of the node at a place.
    pub fn station(&self, at: Point) -> Option<usize> {
        let is_at =
            |station: &usize| length(difference(self.stations[*station].at, at)) <= SAME * self.extent;
        self.nodes.iter().copied().find(is_at)
    }

    /// Where a station is while nothing deforms, in the axes of the frame, from its origin.
    pub fn place(&self, station: usize) -> Point {
        self.stations[station].at
    }

    /// How far each mode moves what is shown of a station, with what is beyond the joints so many times as large.
    pub fn factors(&self, station: usize, times: f64) -> Vec<Point> {
        let Station { held, away, .. } = &self.stations[station];
        held.iter().zip(away).map(|(held, away)| along(*held, times, *away)).collect()
    }

    /// The largest displacement that is magnified, of the extent.
    pub fn deflection(&self, modes: &[f64]) -> f64 {
        let away = |station: &Station| {
            length(
                station.away.iter().zip(modes).fold([0.0; 3], |sum, (away, mode)| along(sum, *mode, *away)),
            )
        };
        self.stations.iter().map(away).fold(0.0, f64::max) / self.extent
    }
}

/// c of one mode.
struct Rest {
    /// a about the middle, and A row after row.
    middle: Point,
    mean: Point,
    matrix: [Point; 3],
    /// What held nodes differ by.
    rest: Vec<(Point, Point)>,
}

impl Rest {
    fn new(nodes: &[Node], gripped: &[Gripped], mode: usize, extent: f64) -> Self {
        let mut pairs: Vec<(Point, Point)> = Vec::new();
        let held = gripped.iter().map(|it| (&nodes[it.node], it.turns_with));
        for (node, turns_with) in held.clone() {
            pairs.push((node.at, node.shifts[mode]));
            if turns_with {
                for axis in 0..3 {
                    let mut aside = [0.0; 3];
                    aside[axis] = BESIDE * extent;
                    let moved = sum(node.shifts[mode], cross(node.turns[mode], aside));
                    pairs.push((sum(node.at, aside), moved));
                }
            }
        }
        let [middle, mean] = [mean(pairs.iter().map(|pair| pair.0)), mean(pairs.iter().map(|pair| pair.1))];
        let product = |of: fn(&(Point, Point)) -> Point, origin: Point| {
            let entry = |i: usize, k: usize| -> f64 {
                pairs.iter().map(|pair| difference(of(pair), origin)[i] * difference(pair.0, middle)[k]).sum()
            };
            (0..3).map(|i| (0..3).map(|k| entry(i, k)).collect::<Vec<f64>>()).collect::<Vec<_>>()
        };
        let (values, vectors) = eigen(&product(|pair| pair.0, middle));
        let moved = product(|pair| pair.1, mean);
        let inverse = |k: usize, l: usize| -> f64 {
            let kept = (0..3).filter(|m| values[*m] > FLAT * extent * extent);
            kept.map(|m| vectors[k][m] * vectors[l][m] / values[m]).sum()
        };
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|l| (0..3).map(|k| moved[i][k] * inverse(k, l)).sum()));
        let mut fitted = Rest { middle, mean, matrix, rest: Vec::new() };
        let mut rest: Vec<(Point, Point)> = Vec::new();
        for (node, _) in held {
            if rest.iter().all(|(at, _)| length(difference(*at, node.at)) > SAME * extent) {
                rest.push((node.at, difference(node.shifts[mode], fitted.at(node.at))));
            }
        }
        fitted.rest = rest;
        fitted
    }

    fn at(&self, place: Point) -> Point {
        let from = difference(place, self.middle);
        let fitted =
            [0, 1, 2].map(|i| self.mean[i] + (0..3).map(|k| self.matrix[i][k] * from[k]).sum::<f64>());
        let (mut total, mut weights) = ([0.0; 3], 0.0);
        for (at, rest) in &self.rest {
            let distance = length(difference(place, *at));
            if distance == 0.0 {
                return sum(fitted, *rest);
            }
            let weight = 1.0 / (distance * distance);
            total = along(total, weight, *rest);
            weights += weight;
        }
        if weights > 0.0 { along(fitted, 1.0 / weights, total) } else { fitted }
    }
}

/// How a mode moves a place of the line between two nodes, at a share of it.
fn between(ends: [&Node; 2], mode: usize, share: f64, turns: bool) -> Point {
    let [from, to] = ends.map(|node| node.shifts[mode]);
    let linear = along(from, share, difference(to, from));
    let way = difference(ends[1].at, ends[0].at);
    let size = length(way);
    if !turns || size == 0.0 {
        return linear;
    }
    let way_unit = way.map(|it| it / size);
    let across = |vector: Point| along(vector, -dot(vector, way_unit), way_unit);
    // What the nodes turn beyond the line between them; a turn's part about the line does nothing.
    let chord = across(difference(to, from));
    let [first, second] = ends.map(|node| difference(cross(node.turns[mode], way), chord));
    let rest = 1.0 - share;
    along(along(linear, share * rest * rest, first), -share * share * rest, second)
}

/// The node that is farthest from the first.
fn end(nodes: &[Node]) -> Option<usize> {
    let away = |node: usize| length(difference(nodes[node].at, nodes[0].at));
    (0..nodes.len()).max_by(|a, b| away(*a).total_cmp(&away(*b)))
}

/// Which nodes are joined: the shortest tree, each line from what was reached before; from an end of the body, so that a row is walked along.
fn tree(nodes: &[Node], start: usize) -> Vec<(usize, usize)> {
    let away = |a: usize, b: usize| length(difference(nodes[a].at, nodes[b].at));
    let mut nearest: Vec<usize> = vec![start; nodes.len()];
    let mut open: Vec<usize> = (0..nodes.len()).filter(|k| *k != start).collect();
    let mut edges = Vec::new();
    while let Some(next) = (0..open.len()).min_by(|a, b| {
        let of = |k: &usize| away(open[*k], nearest[open[*k]]);
        of(a).total_cmp(&of(b))
    }) {
        let node = open.remove(next);
        edges.push((nearest[node], node));
        for other in &open {
            if away(*other, node) < away(*other, nearest[*other]) {
                nearest[*other] = node;
            }
        }
    }
    edges
}

fn mean(points: impl Iterator<Item = Point>) -> Point {
    let (mut total, mut count) = ([0.0; 3], 0.0_f64);
    for point in points {
        total = sum(total, point);
        count += 1.0;
    }
    total.map(|it| it / count.max(1.0))
}
