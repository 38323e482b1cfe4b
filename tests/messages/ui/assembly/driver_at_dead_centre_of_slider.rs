linkwright::mechanism! {
    planar Engine {
        rod crank { mass [kg] = 1; length [m] = 0.1; }
        rod link  { mass [kg] = 1; length [m] = 0.4; }
        particle block { mass [kg] = 1; }
        joint main:  revolute(ground(0, 0) [m], crank.start);
        joint big:   revolute(crank.end, link.start);
        joint wrist: revolute(link.end, block.center);
        joint bore:  point_on_line(line(ground(0, 0), ground(1, 0) [m]), block.center);
        drive push: bore.travel = 0.5 [m];
        start { main.angle [deg] ~ 0; big.angle [deg] ~ 0; }
    }
}

fn main() {}
