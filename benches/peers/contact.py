"""What MuJoCo makes of scenes of contact that have a closed form, for docs/contact-and-friction.md.

    python3 benches/peers/run.py --only mujoco --mechanisms four_bar --quick      sets MuJoCo up
    target/peers/environments/mujoco/bin/python benches/peers/contact.py

Each scene is written as MuJoCo's users would; what is an option of the scene is named in the table. Times of computing are not compared.
"""

import math

import mujoco

G = 9.81
STEPS = (1e-3, 1e-4)


def run(xml, until, start=None):
    """Values of q and v at the times."""
    model = mujoco.MjModel.from_xml_string(f"<mujoco>{xml}</mujoco>")
    data = mujoco.MjData(model)
    if start:
        data.qvel[: len(start)] = start
    found = []
    for time in until:
        while data.time < time - 1e-9:
            mujoco.mj_step(model, data)
        found.append((data.qpos.copy(), data.qvel.copy()))
    return found


def on_a_plane(option, geom, friction, contact=""):
    surface = f'friction="{friction} 0 0" {contact}'
    return (
        f"<option {option}/><worldbody><geom type='plane' size='10 10 .1' {surface}/>"
        f"<body pos='0 0 {geom[1]}'><freejoint/><geom {geom[0]} mass='1' {surface}/></body></worldbody>"
    )


def creep(step, cone, ratio):
    """m/s of a block on a slope of 20° whose friction of 0.5 holds it."""
    slope = math.radians(20)
    gravity = f"{G * math.sin(slope)} 0 {-G * math.cos(slope)}"
    option = f'timestep="{step}" gravity="{gravity}" cone="{cone}" impratio="{ratio}" integrator="implicitfast"'
    box = 'type="box" size=".1 .1 .05"', 0.05
    (first, _), (last, _) = run(on_a_plane(option, box, 0.5), (1, 3))
    return (last[0] - first[0]) / 2


def rolling(step):
    """How far the speed of a ball that has come to roll, from 3 m/s at a friction of 0.2, is from 5/7 of it, relatively."""
    option = f'timestep="{step}" gravity="0 0 {-G}" cone="elliptic"'
    ((_, speed),) = run(on_a_plane(option, ('type="sphere" size=".1"', 0.1), 0.2), (1.5,), [3.0])
    return speed[0] / (15 / 7) - 1


def bouncing(step):
    """m, how far a ball of 1 kg from 0.5 m on 1e4 N/m and 20 N s/m is from where that law has it after 1 s."""
    option = f'timestep="{step}" gravity="0 0 {-G}"'
    law = 'solref="-10000 -20" solimp="0.9999 0.9999 .001"'
    ((place, _),) = run(on_a_plane(option, ('type="sphere" size=".1"', 0.6), 0, law), (1,))
    return place[2] - 0.1 - 0.1400263525336718


def main():
    print(f"MuJoCo {mujoco.__version__}")
    for step in STEPS:
        for cone, ratio in (("pyramidal", 1), ("elliptic", 1), ("elliptic", 10)):
            print(f"{step:g} s, {cone} cone, impratio {ratio}: a held block creeps with {creep(step, cone, ratio):.2e} m/s")
        print(f"{step:g} s: speed of rolling off by {rolling(step):.1e} of it")
        print(f"{step:g} s: height after 1 s off by {bouncing(step):.1e} m")


if __name__ == "__main__":
    main()
