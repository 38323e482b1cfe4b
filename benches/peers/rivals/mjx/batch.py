"""MJX on the processor: steps of many members by one compiled program, double precision.

    python batch.py MODEL.xml MEMBERS STEPS STEP

Prints steps of single members a second, and the seconds of compilation. Runs in an environment of its own.
"""

import json
import os
import sys
import time

os.environ.setdefault("JAX_PLATFORMS", "cpu")
os.environ.setdefault("JAX_ENABLE_X64", "1")

import jax  # noqa: E402
import mujoco  # noqa: E402
from mujoco import mjx  # noqa: E402


def main():
    path, members, steps, step = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4])
    loaded = mujoco.MjModel.from_xml_path(path)
    loaded.opt.timestep = step
    model = mjx.put_model(loaded)
    start = mjx.make_data(model)
    batch = jax.vmap(lambda shift: start.replace(qvel=start.qvel + shift))(jax.numpy.linspace(0.0, 1e-3, members))

    def one(_, data):
        after = jax.vmap(mjx.step, in_axes=(None, 0))(model, data)
        # Some of its whole numbers come back longer than they went in.
        return jax.tree.map(lambda old, new: new.astype(old.dtype), data, after)

    @jax.jit
    def run(batch):
        return jax.lax.fori_loop(0, steps, one, batch)

    begin = time.perf_counter()
    jax.block_until_ready(run(batch))
    first = time.perf_counter() - begin
    least = float("inf")
    for _ in range(3):
        begin = time.perf_counter()
        jax.block_until_ready(run(batch))
        least = min(least, time.perf_counter() - begin)
    print(json.dumps({"rate": members * steps / least, "compilation": first - least}))


if __name__ == "__main__":
    main()
