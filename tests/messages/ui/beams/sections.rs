//! Sections, modes and shapes that are not there.

linkwright::mechanism! {
    planar Beams {
        beam a { section = hexagon(width [mm] = 7); }
        beam b { section = circl(diameter [mm] = 7); }
        beam c { section = rectangle(height [mm] = 7); }
        beam d { section = circle(radius [mm] = 7); }
        beam e { modes = (bending = 13); }
        beam f { modes = (axial = 0, bending = 0); }
        beam g { modes = (torsion = 2); }
        beam h { modes = (bend = 2); }
        beam i { shapes = ritz; }
        beam j { shapes = clampd; }
        beam k { stiffening = yes; }
        beam l { theory = timoshenco; }
        beam m { shapes = free; shapes = clamped; }
        beam o { toothing rim: external(teeth = 20, module [mm] = 2); }
        beam n { line edge = (n.start, n.end); }
    }
}

fn main() {}
