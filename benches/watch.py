"""How long `linkwright watch` takes from an edit of a four-bar to the answer that its page shows it by.

    cargo build --release -p linkwright-cli
    python3 benches/watch.py
"""

import pathlib
import re
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else ROOT / "target/release/linkwright"
EDITS = 31


def ask(port, query):
    """The answer to the page's question, and when it was all there."""
    with socket.create_connection(("127.0.0.1", port)) as stream:
        stream.sendall(f"GET /state{query} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
        pieces = []
        while piece := stream.recv(1 << 20):
            pieces.append(piece)
    return b"".join(pieces).decode(), time.perf_counter()


def edit(port, file, text, answer, wait):
    """Seconds from the change of the file to the answer, and the answer."""
    stamp = re.search(r'"stamp":"([^"]*)"', answer)[1]
    found = []
    asking = threading.Thread(target=lambda: found.extend(ask(port, f"?after={stamp}")))
    asking.start()
    # Until the question waits; at another point between two looks at the file each time.
    time.sleep(wait)
    begin = time.perf_counter()
    file.write_text(text)
    asking.join()
    answer, end = found
    assert '"motion"' in answer and '"messages":[]' in answer, answer[:2000]
    return end - begin, answer


def main():
    text = (ROOT / "docs/mechanisms/crank_rocker.mech").read_text()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "four_bar.mech"
        file.write_text(text)
        command = [PROGRAM, "watch", "--port", "0", file]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as program:
            try:
                port = int(re.search(r":(\d+)/", program.stdout.readline())[1])
                answer, _ = ask(port, "")
                times = []
                for count in range(1, EDITS + 1):
                    edited = text.replace("[g] = 2000", f"[g] = {2000 + count}")
                    took, answer = edit(port, file, edited, answer, 0.15 + 0.0007 * count)
                    times.append(1e3 * took)
            finally:
                program.kill()
    print(f"{EDITS} edits: median {statistics.median(times):.0f} ms, {min(times):.0f} to {max(times):.0f} ms, {len(answer) // 1000} kB")


main()
