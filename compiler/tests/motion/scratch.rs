use crate::*;
#[test]
fn scratch() {
    for n in [10usize, 40] {
        for e in ["", "expect { rotates = pin[0]; no_singularity; }"] {
            let source = format!(
                "planar Ladder {{
                const N = {n};
                repeat i in 0..N+1 {{
                    rod upright[i] {{ mass [kg] = 1; length [m] = 1; }}
                    joint pin[i]: revolute(ground(i, 0) [m], upright[i].start);
                }}
                repeat i in 0..N {{
                    rod bar[i] {{ mass [kg] = 1; length [m] = 1; }}
                    joint left[i]:  revolute(upright[i].end, bar[i].start);
                    joint right[i]: revolute(bar[i].end, upright[i+1].end);
                    start {{ bar[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 70; }}
                }}
                start {{ pin[0].angle [deg] = 70; }} {e}
            }}"
            );
            let tokens = TokenStream::from_str(&source).unwrap();
            let t = std::time::Instant::now();
            let c = compile(tokens, None);
            println!("DBG {n} {e} {:?} {:?}", t.elapsed(), c.err().map(|e| e.to_string()));
        }
    }
    for e in [
        "rotates = axle",
        "no_singularity",
        "way.travel in 0..1 [m]",
        "rotates = axle; other.angle in 0..1 [rad]",
    ] {
        let source = format!("planar Rack {{ disk pinion {{ mass [kg] = 1; radius [m] = 0.1; }} body rail {{ mass [kg] = 1; inertia [kg*m^2] = 1; }}
         disk wheel {{ mass [kg] = 1; radius [m] = 0.1; }}
         joint axle: revolute(ground(0, 0.1) [m], pinion.center);
         joint other: revolute(ground(0, 0.3) [m], wheel.center);
         joint way: prismatic(ground(0, 0) [m], rail.center, axis = (1, 0));
         gear g: gear(axle, other, ratio = 2.718);
         rack mesh: rack(axle, way, radius [m] = 0.1); expect {{ {e}; }} }}");
        let tokens = TokenStream::from_str(&source).unwrap();
        let t = std::time::Instant::now();
        let c = compile(tokens, None);
        println!("DBG {e} {:?} {:?}", t.elapsed(), c.err().map(|e| e.to_string()));
    }
}
